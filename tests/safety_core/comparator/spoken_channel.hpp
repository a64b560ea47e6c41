// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_SAFETY_CORE_COMPARATOR_SPOKEN_CHANNEL_HPP
#define TESTS_SAFETY_CORE_COMPARATOR_SPOKEN_CHANNEL_HPP

#include "safety_core/contract/channel.hpp"

#include <cstdint>

namespace counterpoint
{

/// A voice whose outcome and views a test writes down; the comparator sees nothing else of a channel.
class SpokenChannel final : public Channel
{
  public:
    void Restart(const DeviceConfig&) noexcept override
    {
    }
    void Store(const ConfigItem&) noexcept override
    {
    }
    ConfigItem Load(const ConfigAddress& address) const noexcept override
    {
        return ConfigItem{address, 0U};
    }
    CheckResult Validate(SlotIndex) noexcept override
    {
        return CheckResult{};
    }
    CheckResult Recheck(SlotIndex) noexcept override
    {
        return CheckResult{};
    }
    void OnFrame(const CanFrame&, Instant) noexcept override
    {
    }
    CycleOutcome OnCycle(const CycleInput&) noexcept override
    {
        return outcome;
    }
    SrdoView View(SlotIndex slot) const noexcept override
    {
        return views[slot];
    }
    void Demote(SlotIndex) noexcept override
    {
    }
    void Commit(const Agreement&) noexcept override
    {
    }
    Permit Answer(std::uint32_t) const noexcept override
    {
        return Permit{};
    }
    void Request(SlotIndex) noexcept override
    {
    }
    void Hold(SlotIndex) noexcept override
    {
    }
    PreparedPair Prepare(SlotIndex) noexcept override
    {
        return PreparedPair{};
    }
    void Launch(SlotIndex) noexcept override
    {
    }
    CanFrame NextFrame(SlotIndex) noexcept override
    {
        return CanFrame{};
    }
    SlotIndex OnConfirm(const CanFrame&, Instant) noexcept override
    {
        return kNoSlot;
    }
    void OnTransmitFault(SlotIndex, SrdoCause) noexcept override
    {
    }

    CycleOutcome outcome{};
    SrdoView views[kMaxSrdoCount]{};
};

} // namespace counterpoint

#endif
