// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/simulator/channel_tap.hpp"

// A channel that is always good: the answers that a healthy one gives when nothing is wrong. [SRS-SIM-033]
namespace counterpoint::simulator
{
namespace
{
constexpr std::uint32_t kWordBits = 32U;
constexpr std::uint32_t kRotation = 16U;

// The rule of SRS-REL-010, written down once more: a healthy channel would have found the same number.
std::uint32_t ResponseOf(const SrdoMask mask, const std::uint32_t challenge, const std::uint32_t constant) noexcept
{
    const auto low = static_cast<std::uint32_t>(mask);
    const auto high = static_cast<std::uint32_t>(mask >> kWordBits);
    const std::uint32_t rotated = (high << kRotation) | (high >> (kWordBits - kRotation));
    return ((challenge + low) ^ rotated) * constant;
}
} // namespace

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
    permit_ = {mask, ResponseOf(mask, challenge, constant)};
}
} // namespace counterpoint::simulator
