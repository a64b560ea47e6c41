// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/comparator/comparator.hpp"

#include <cstdint>

namespace counterpoint
{
namespace
{

std::uint32_t Unequal(const Payload& left, const Payload& right) noexcept
{
    return (left.low ^ right.low) | (left.high ^ right.high);
}

// Four bytes as one word, on every processor the same.
std::uint32_t WordAt(const std::uint8_t* const bytes) noexcept
{
    return static_cast<std::uint32_t>(bytes[0U]) | (static_cast<std::uint32_t>(bytes[1U]) << 8U) | // MISRA D-002
           (static_cast<std::uint32_t>(bytes[2U]) << 16U) |
           (static_cast<std::uint32_t>(bytes[3U]) << 24U); // MISRA D-002
}

// 0 when the frames have the same data.
std::uint32_t UnequalData(const CanFrame& left, const CanFrame& right) noexcept
{
    return (WordAt(&left.data[0]) ^ WordAt(&right.data[0])) | (WordAt(&left.data[4]) ^ WordAt(&right.data[4]));
}

bool IsSameForm(const CanFrame& left, const CanFrame& right) noexcept
{
    return (left.identifier == right.identifier) && (left.kind == right.kind) && (left.port == right.port) &&
           (left.length_bytes == right.length_bytes);
}

bool AreSameCounts(const CycleOutcome& a, const CycleOutcome& b) noexcept
{
    return (a.sct_checked == b.sct_checked) && (a.is_tx == b.is_tx) && (a.is_invalid == b.is_invalid) &&
           (a.not_operational == b.not_operational);
}

// What both voices must say alike in every cycle.
DeviceFault Overall(const Comparison& comparison) noexcept
{
    const CycleOutcome& a = *comparison.outcome_a;
    const CycleOutcome& b = *comparison.outcome_b;
    if ((a.guard == GuardView::kStale) || (b.guard == GuardView::kStale))
    {
        return DeviceFault::kGuard;
    }
    const std::uint32_t cycles = (a.cycle ^ comparison.cycle) | (b.cycle ^ comparison.cycle);
    const bool is_equal = (cycles == 0U) && (a.guard == b.guard) && AreSameCounts(a, b);
    return is_equal ? DeviceFault::kNone : DeviceFault::kDisagreement;
}

} // namespace

void Comparator::Restart(const ComparatorSetup& setup) noexcept
{
    slots_ = ~SrdoMask{0U} >> (std::uint32_t{kMaxSrdoCount} - setup.slot_count);
    discrepancy_us_ = setup.discrepancy_us;
    watched_ = 0U;
    fresh_ = 0U;
    previous_ = Instant{0U};
}

PreparedVerdict Comparator::ComparePrepared(const PreparedPair& a, const PreparedPair& b) noexcept
{
    if ((a.status != b.status) || (!IsSameForm(a.normal, b.normal)))
    {
        return PreparedVerdict::kDisagreement;
    }
    return (UnequalData(a.normal, b.normal) != 0U) ? PreparedVerdict::kNotInverse : PreparedVerdict::kEqual;
}

Verdict Comparator::Compare(const Comparison& comparison) noexcept
{
    const CycleOutcome& a = *comparison.outcome_a;
    const CycleOutcome& b = *comparison.outcome_b;
    Verdict verdict{};
    verdict.echo = comparison.challenge;
    verdict.slot = kNoSlot;
    verdict.fault = Overall(comparison);
    if (verdict.fault != DeviceFault::kNone)
    {
        return verdict;
    }

    verdict.demote = (a.faulted ^ b.faulted) | (a.new_fault ^ b.new_fault);
    const SrdoMask faults = a.faulted | b.faulted | a.new_fault | b.new_fault;
    verdict.agreement.agreed = a.released & b.released & ~faults;
    verdict.start = a.due & b.due;

    one_sided_ = (a.released ^ b.released) | (a.due ^ b.due);
    known_ = watched_;
    watched_ |= a.fresh | b.fresh | one_sided_;
    if (a.ordinal_sum != b.ordinal_sum)
    {
        watched_ = slots_;
    }
    watched_ &= slots_ & ~verdict.demote;
    fresh_ = (fresh_ | a.fresh | b.fresh) & watched_;
    for (SrdoMask to_look = watched_; to_look != 0U; to_look &= to_look - 1U)
    {
        Look(comparison, SlotSet{to_look & (0U - to_look)}, verdict);
    }
    verdict.agreement.matched = ~watched_;
    previous_ = comparison.now;
    return verdict;
}

// t      k-1           k       a difference seen at k arose after comparison k-1: the time counts from there, so that
//         |....x........|       discrepancy time and one cycle cover it from its first effect.
// Nothing is held of a producer: its pair was compared before it left, and a confirmation at the very limit may count
// in one channel alone.
void Comparator::Look(const Comparison& comparison, const SlotSet only, Verdict& verdict) noexcept
{
    const SrdoMask bit = only.mask;
    const SlotIndex slot = LowestOf(only);
    if ((known_ & bit) == 0U)
    {
        since_[slot] = previous_; // MISRA D-002
    }
    const HeldPair a = comparison.channel_a->Held(slot);
    const HeldPair b = comparison.channel_b->Held(slot);
    const std::uint32_t data = Unequal(a.data, b.data);
    const bool is_one_pair = ((a.ordinal ^ b.ordinal) | (a.holds_pair ^ b.holds_pair)) == 0U;
    const std::uint32_t elapsed_us = comparison.now.us - since_[slot].us; // MISRA D-002
    DeviceFault fault = DeviceFault::kNone;
    if (is_one_pair && (data != 0U))
    {
        fault = DeviceFault::kDisagreement;
    }
    else if (is_one_pair && ((one_sided_ & bit) == 0U))
    {
        watched_ ^= bit;
        verdict.newly_matched |= bit & fresh_;
    }
    else if (elapsed_us > discrepancy_us_)
    {
        const SrdoMask one_sided_due = comparison.outcome_a->due ^ comparison.outcome_b->due;
        if (is_one_pair && ((one_sided_due & bit) == 0U))
        {
            verdict.demote |= bit; // Nothing but the release differs.
        }
        else
        {
            fault = DeviceFault::kUnmatched;
        }
    }
    else
    {
        // The channels have time left to agree.
    }
    if (fault != DeviceFault::kNone)
    {
        verdict.fault = fault;
        verdict.slot = slot;
    }
}

} // namespace counterpoint
