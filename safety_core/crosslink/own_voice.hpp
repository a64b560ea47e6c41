// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CROSSLINK_OWN_VOICE_HPP
#define SAFETY_CORE_CROSSLINK_OWN_VOICE_HPP

#include "safety_core/contract/channel.hpp"
#include "safety_core/crosslink/own_sending.hpp"
#include "safety_core/crosslink/pair_moments.hpp"

#include <cstdint>

namespace counterpoint
{

/// What the peer has not been told yet.
struct News
{
    SrdoMask changed; ///< Consumers with a new pair or a discard.
    SrdoMask faults;  ///< New faults.
};

/// Stands between kernel and the one real channel of a CPU: passes every call on, and notes what the peer has to be
/// told. [SRS_TWO_001]
class OwnVoice final : public Channel
{
  public:
    OwnVoice(Channel& channel, PeerRole role) noexcept;

    // As Channel says, by the real channel; what the peer has to be told is noted on the way.
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

    /// @brief What the channel sends, in step with the other CPU.
    [[nodiscard]] OwnSending& Sending() noexcept
    {
        return sending_;
    }
    /// @brief When the held pairs were on the bus, and when consumers discarded theirs, by the own clock.
    [[nodiscard]] const PairMoments& Moments() const noexcept
    {
        return moments_;
    }
    /// @brief What the channel said in the last OnCycle.
    [[nodiscard]] Statement Said() const noexcept;
    /// @brief The device that Restart was given; all 0 before.
    [[nodiscard]] const DeviceConfig& Config() const noexcept
    {
        return *config_;
    }
    /// @brief Consumers that are active, as of the last OnCycle: each is released, faulted or waiting.
    [[nodiscard]] SrdoMask Consumers() const noexcept
    {
        return outcome_.released | outcome_.faulted | outcome_.waiting;
    }
    /// @brief What the message tells of the channel as a whole.
    void Tell(LinkMessage& message) const noexcept;
    /// @brief News since the last call.
    [[nodiscard]] News TakeNews() noexcept;
    /// @brief Device digest as the last whole sweep found it, which takes a cycle for each SRDO; 0 before the first.
    [[nodiscard]] DeviceDigest LastDigest() const noexcept
    {
        return digest_;
    }

  private:
    /// @brief One slot a cycle: its part of the digest, and the age of its last discard.
    void Sweep(Instant now) noexcept;
    /// @brief What the channel said in this cycle, as far as the peer has to be told of it; then one step of the sweep.
    void NoteOutcome(const CycleOutcome& outcome, Instant now) noexcept;

    Channel& channel_;
    const DeviceConfig* config_;
    OwnSending sending_;
    CycleOutcome outcome_{};
    News news_{0U, 0U};
    Instant now_{0U};
    SlotCheck check_{kNoSlot, {ConfigFault::kInvalid, 0U}};
    DeviceDigest digest_{0U};  ///< Of the last whole sweep.
    DeviceDigest running_{0U}; ///< Of the slots below swept_.
    SlotIndex swept_{0U};
    PairMoments moments_{};
};

} // namespace counterpoint

#endif
