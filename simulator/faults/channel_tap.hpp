// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_FAULTS_CHANNEL_TAP_HPP
#define SIMULATOR_FAULTS_CHANNEL_TAP_HPP

#include "simulator/faults/part_faults.hpp"

#include "safety_core/contract/channel.hpp"

#include <array>

namespace counterpoint::simulator
{
/// Is told what a channel answers in each cycle.
class ChannelWitness
{
  public:
    virtual ~ChannelWitness() = default;
    /// @brief `channel` is the real channel, to be asked for details.
    virtual void OnOutcome(Part part, const Channel& channel, const CycleOutcome& outcome) = 0;
    /// @brief Whether the frame belongs to a consumer of this node. Only then it has an effect that a channel does not
    /// get it.
    [[nodiscard]] virtual bool Concerns(const CanFrame& frame) const = 0;
};

/// Stands between the kernel and a shipped channel. It passes every call on, and makes the faults of calls: skipped,
/// doubled, hung, frozen, not called, always good. Channel and kernel know nothing of it. [SRS_SIM_021, SRS_SIM_025]
class ChannelTap final : public Channel
{
  public:
    /// @brief All outlive the tap; `witness` may be null.
    ChannelTap(Channel& real, Part part, PartFaults& faults, ChannelWitness* witness) noexcept;

    void Restart(const DeviceConfig& config) noexcept override;
    void Store(const ConfigItem& item) noexcept override;
    [[nodiscard]] ConfigItem Load(const ConfigAddress& address) const noexcept override;
    [[nodiscard]] ChannelRoom Room() const noexcept override;
    void SetFields(SlotIndex slot, const StaticFields& fields) noexcept override;
    [[nodiscard]] DeviceDigest Digest(SlotIndex slot, DeviceDigest before) const noexcept override;
    [[nodiscard]] CheckResult Validate(SlotIndex slot) noexcept override;
    [[nodiscard]] CheckResult Recheck(SlotIndex slot) noexcept override;
    void OnFrame(const CanFrame& frame, Instant stamp) noexcept override;
    [[nodiscard]] CycleOutcome OnCycle(const CycleInput& input) noexcept override;
    [[nodiscard]] HeldPair Held(SlotIndex slot) const noexcept override;
    [[nodiscard]] SrdoView View(SlotIndex slot) const noexcept override;
    void Demote(SlotIndex slot) noexcept override;
    [[nodiscard]] SrdoMask Commit(const Agreement& agreement, SrdoMask examine) noexcept override;
    [[nodiscard]] Permit Answer(std::uint32_t challenge) const noexcept override;
    [[nodiscard]] PreparedPair Prepare(SlotIndex slot) noexcept override;
    [[nodiscard]] Confirmation OnConfirm(const CanFrame& frame, Instant stamp) noexcept override;
    [[nodiscard]] CanFrame InverseFrame(SlotIndex slot) const noexcept override;
    void OnTransmitFault(SlotIndex slot, const TransmitFault& fault) noexcept override;

  private:
    /// @brief Whether the channel does not run at all: frozen. A channel that hangs does not return from here.
    [[nodiscard]] bool IsStill() const noexcept;
    /// @brief Whether no call reaches the channel; zeros are found instead of its answers.
    [[nodiscard]] bool IsMute() const noexcept;
    template <typename Answered> [[nodiscard]] Answered Told(const Answered& last) const noexcept
    {
        return IsMute() ? Answered{} : last;
    }
    /// @brief The answer of the channel if it runs, else its last one, or zeros.
    template <typename Answered, typename Real>
    [[nodiscard]] Answered Asked(Answered& last, const Real& real) const noexcept
    {
        if (!IsStill())
        {
            last = real();
        }
        return Told(last);
    }
    /// @brief Whether the channel is always good: it works, but says that nothing is wrong. [SRS_SIM_033]
    [[nodiscard]] bool IsGood() const noexcept;
    void Whitewash(CycleOutcome& outcome) const noexcept;
    [[nodiscard]] HeldPair GoodPair(SlotIndex slot, const HeldPair& real) const noexcept;
    void GoodPermit(std::uint32_t challenge) const noexcept;
    /// @brief How often a call that can be skipped or doubled is to be made.
    [[nodiscard]] std::uint32_t Calls(ChannelCall call, bool matters) noexcept;
    [[nodiscard]] CycleOutcome Fresh(const CycleInput& input) noexcept;

    Channel& real_;
    Part part_;
    PartFaults& faults_;
    ChannelWitness* witness_;
    // The last answers: what a frozen channel goes on saying.
    CycleOutcome outcome_{};
    SrdoMask once_released_{0U}; ///< What an always good channel goes on releasing.
    SrdoMask agreed_{0U};
    std::uint8_t slot_count_{0U};
    PreparedPair prepared_{};
    CheckResult check_{};
    SrdoMask found_{0U};
    mutable Permit permit_{};
    mutable DeviceDigest digest_{};
    mutable std::array<HeldPair, kMaxSrdoCount> held_{};
    mutable std::array<SrdoView, kMaxSrdoCount> views_{};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_FAULTS_CHANNEL_TAP_HPP
