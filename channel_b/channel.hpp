// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_CHANNEL_HPP
#define CHANNEL_B_CHANNEL_HPP

#include "channel_b/acknowledge.hpp"
#include "channel_b/consumer.hpp"
#include "channel_b/faults.hpp"
#include "channel_b/limits.hpp"
#include "channel_b/mapping.hpp"
#include "channel_b/producer.hpp"
#include "channel_b/settings.hpp"
#include "channel_b/storage.hpp"
#include "safety_core/contract/channel.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

/// Channel B: owner of the inverse objects and sender of the inverse frame. It hands every call to the part that it
/// concerns, and knows itself what is common to all slots: time, OPERATIONAL, and which identifier leads to which slot.
/// DESIGN.md tells how it differs by design.
class Channel final : public counterpoint::Channel
{
  public:
    /// @brief The arrays outlive the channel. Restart is the first call.
    explicit Channel(const Storage& storage) noexcept;

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
    [[nodiscard]] std::uint16_t SignatureOf(SlotIndex slot) const noexcept;
    /// A slot counts as valid if no rule is broken.
    [[nodiscard]] CheckResult Conclude(SlotIndex slot, ConfigFault fault, std::uint16_t signature) noexcept
    {
        x_admission.valid[slot] = (fault == ConfigFault::kNone) ? Mark::kGood : Mark::kUnset;
        return CheckResult{fault, signature};
    }

    [[nodiscard]] bool IsRunning() const noexcept
    {
        return x_activity == Mark::kRunning;
    }

    void Enter() noexcept;
    void Admit(SlotIndex slot) noexcept;
    /// Slot to which the identifier leads; whoever asks compares it with the number of slots.
    [[nodiscard]] SlotIndex LookUp(std::uint32_t identifier) const noexcept
    {
        const std::uint32_t offset = identifier - kFirstSrdoIdentifier;
        return (offset < kSrdoIdentifierCount) ? x_admission.slot_of[offset] : kNoSlot;
    }

    AdmissionColumns x_admission;
    ChannelRoom x_room;
    Settings x_settings;
    Mappings x_mappings;
    Faults x_faults;
    Limits x_limits;
    Consumers x_consumers;
    Producers x_producers;
    Acknowledge x_acknowledge;
    std::uint32_t x_last_us{0U};   ///< The `now` of the last OnCycle: every budget and every stamp is relative to it.
                                   ///< [SRS_TIME_002]
    std::uint32_t x_total_us{0U};  ///< All elapsed times since Restart, one after the other: x_last_us again.
    std::uint32_t x_cycle{0U};     ///< Calls of OnCycle.
    Mark x_activity{Mark::kUnset}; ///< kRunning while SRDOs are active.
    bool x_was_called{false};      ///< OnCycle, since Restart.
    bool x_has_gfc{false};         ///< A global fail-safe command came since the last OnCycle.
};

} // namespace counterpoint::channel_b

#endif
