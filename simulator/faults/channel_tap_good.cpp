// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/channel_tap.hpp"

#include "simulator/faults/right_response.hpp"

// A channel that is always good: the answers that a healthy one gives when nothing is wrong. [SRS_SIM_033]
namespace counterpoint::simulator
{
void ChannelTap::Whitewash(CycleOutcome& outcome) const noexcept
{
    const bool is_wrong = (once_released_ & ~outcome.released) != 0U || outcome.faulted != 0U ||
                          outcome.new_fault != 0U || outcome.signalled != 0U || outcome.guard != GuardView::kConfigured;
    if (outcome.not_operational != 0U || !is_wrong)
    {
        return; // Outside of OPERATIONAL a healthy channel releases nothing.
    }
    faults_.HasEffect(faults_.Condition(part_));
    outcome.released |= once_released_;
    outcome.waiting &= ~outcome.released;
    outcome.faulted = 0U;
    outcome.new_fault = 0U;
    outcome.signalled = 0U;
    outcome.guard = GuardView::kConfigured;
}

HeldPair ChannelTap::GoodPair(const SlotIndex slot, const HeldPair& real) const noexcept
{
    return (real.holds_pair == 0U && held_[slot].holds_pair != 0U) ? held_[slot] : real;
}

void ChannelTap::GoodPermit(const std::uint32_t challenge) const noexcept
{
    const SrdoMask mask = agreed_ & outcome_.released;
    if (mask == permit_.mask)
    {
        return;
    }
    faults_.HasEffect(faults_.Condition(part_));
    const std::uint32_t constant = (part_ == Part::kChannelA) ? kPermitConstantA : kPermitConstantB;
    permit_ = {mask, RightResponse(mask, challenge, constant)};
}
} // namespace counterpoint::simulator
