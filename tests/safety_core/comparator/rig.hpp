// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_SAFETY_CORE_COMPARATOR_RIG_HPP
#define TESTS_SAFETY_CORE_COMPARATOR_RIG_HPP

#include "safety_core/comparator/comparator.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>

namespace counterpoint
{

/// A voice whose outcome and held pairs a test writes down; the comparator sees nothing else of a channel.
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
    HeldPair Held(SlotIndex slot) const noexcept override
    {
        if (on_held)
        {
            on_held();
        }
        return held[slot];
    }
    SrdoView View(SlotIndex) const noexcept override
    {
        return SrdoView{};
    }
    ChannelRoom Room() const noexcept override
    {
        return ChannelRoom{};
    }
    void SetFields(SlotIndex, const StaticFields&) noexcept override
    {
    }
    DeviceDigest Digest(SlotIndex, DeviceDigest before) const noexcept override
    {
        return before;
    }
    void Demote(SlotIndex) noexcept override
    {
    }
    [[nodiscard]] SrdoMask Commit(const Agreement&, SrdoMask) noexcept override
    {
        return 0U;
    }
    Permit Answer(std::uint32_t) const noexcept override
    {
        return Permit{};
    }
    PreparedPair Prepare(SlotIndex) noexcept override
    {
        return PreparedPair{};
    }
    Confirmation OnConfirm(const CanFrame&, Instant) noexcept override
    {
        return Confirmation{kNoSlot, ConfirmStep::kNone};
    }
    CanFrame InverseFrame(SlotIndex) const noexcept override
    {
        return CanFrame{};
    }
    void OnTransmitFault(SlotIndex, const TransmitFault&) noexcept override
    {
    }

    CycleOutcome outcome{};
    HeldPair held[kMaxSrdoCount]{};
    std::function<void()> on_held{};
};

// Four slots; slot 2 is a consumer that holds pair 9; discrepancy time 5000 us, window 20000 us.
class Comparing : public ::testing::Test
{
  protected:
    Comparing()
    {
        comparator.Restart(ComparatorSetup{5000U, 20000U, 4U});
        for (SpokenChannel* const channel : {&a, &b})
        {
            channel->outcome.cycle = 17U;
            channel->outcome.guard = GuardView::kConfigured;
            channel->outcome.sct_checked = 3U;
            channel->outcome.is_tx = 1U;
            channel->outcome.released = 4U;
            channel->outcome.ordinal_sum = 9U;
            channel->held[2].ordinal = 9U;
            channel->held[2].holds_pair = 1U;
            channel->held[2].data = Payload{0x11223344U, 0x55667788U};
        }
    }

    Verdict CompareAt(const std::uint32_t now_us)
    {
        return comparator.Compare(
            Comparison{&a.outcome, &b.outcome, &a, &b, Instant{now_us}, 17U, 0xABCDU, HeldPair{}});
    }

    Comparator comparator{};
    SpokenChannel a{};
    SpokenChannel b{};
};

} // namespace counterpoint

#endif
