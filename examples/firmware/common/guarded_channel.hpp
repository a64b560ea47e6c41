// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_FIRMWARE_COMMON_GUARDED_CHANNEL_HPP
#define EXAMPLES_FIRMWARE_COMMON_GUARDED_CHANNEL_HPP

#include "hal/api/memory_protection.hpp"
#include "safety_core/contract/channel.hpp"

namespace counterpoint::firmware
{

/// A channel that runs with its own memory writable, the other channel's and the core's read-only, and gives the memory
/// back to the core when it is done. [SRS_FW_006]
class GuardedChannel final : public Channel
{
  public:
    GuardedChannel(Channel& channel, hal::MemoryProtection& protection, const hal::MemoryOwner owner) noexcept
        : channel_{channel}, protection_{protection}, owner_{owner}
    {
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
    Channel& channel_;
    hal::MemoryProtection& protection_;
    hal::MemoryOwner owner_;
};

} // namespace counterpoint::firmware

#endif
