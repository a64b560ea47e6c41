// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TWINS_PLAIN_CHANNEL_HPP
#define VERIFICATION_TWINS_PLAIN_CHANNEL_HPP

#include "verification/twins/plain/record.hpp"

namespace counterpoint::twins::plain
{

/// A channel as docs/requirements/channel.sdoc says it, sentence by sentence, plain and slow. Each sentence is a Point,
/// so that one of them can be broken. Written from that text and the contract.
class PlainChannel final : public counterpoint::Channel
{
  public:
    explicit PlainChannel(Side side) noexcept
    {
        common_.side = side;
    }
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
    [[nodiscard]] GuardView LookAtGuard(const CycleInput& input) const noexcept;
    [[nodiscard]] bool IsAnotherBehind(SlotIndex slot, std::uint32_t identifier) const noexcept;
    void Enter(Record& record) noexcept;
    void Leave(Record& record) noexcept;
    void CycleOne(SlotIndex slot, const CycleInput& input, bool is_late, bool was_operational) noexcept;
    void Tell(SlotIndex slot, CycleOutcome& outcome) noexcept;

    Common common_{};
    Record records_[kMaxSrdoCount]{};
};

} // namespace counterpoint::twins::plain

#endif
