// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/comparator/comparator.hpp"

#include <cstdint>

namespace counterpoint
{
namespace
{

std::uint32_t Unequal(const std::uint8_t left, const std::uint8_t right) noexcept
{
    return static_cast<std::uint32_t>(left) ^ static_cast<std::uint32_t>(right);
}

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

// 0 when the frames are of the same form.
std::uint32_t UnequalForm(const CanFrame& left, const CanFrame& right) noexcept
{
    const std::uint32_t kinds = Unequal(static_cast<std::uint8_t>(left.kind), static_cast<std::uint8_t>(right.kind));
    const std::uint32_t ports = Unequal(static_cast<std::uint8_t>(left.port), static_cast<std::uint8_t>(right.port));
    return (left.identifier ^ right.identifier) | kinds | ports | Unequal(left.length_bytes, right.length_bytes);
}

// 0 when both voices speak of the expected cycle, the same guard and the same counts.
std::uint32_t Unequal(const CycleOutcome& a, const CycleOutcome& b, const std::uint32_t cycle) noexcept
{
    const std::uint32_t cycles = (a.cycle ^ cycle) | (b.cycle ^ cycle);
    const std::uint32_t guards = Unequal(static_cast<std::uint8_t>(a.guard), static_cast<std::uint8_t>(b.guard));
    const std::uint32_t examined = Unequal(a.sct_checked, b.sct_checked) | Unequal(a.is_tx, b.is_tx);
    const std::uint32_t passed = Unequal(a.is_invalid, b.is_invalid) | Unequal(a.not_operational, b.not_operational);
    return cycles | guards | examined | passed;
}

DeviceFault Overall(const Comparison& comparison) noexcept
{
    const CycleOutcome& a = *comparison.outcome_a;
    const CycleOutcome& b = *comparison.outcome_b;
    DeviceFault fault = DeviceFault::kNone;
    if (Unequal(a, b, comparison.cycle) != 0U)
    {
        fault = DeviceFault::kDisagreement;
    }
    if ((a.guard == GuardView::kStale) || (b.guard == GuardView::kStale))
    {
        fault = DeviceFault::kGuard;
    }
    return fault;
}

} // namespace

void Comparator::Restart(const ComparatorSetup& setup) noexcept
{
    slots_ = ~SrdoMask{0U} >> (std::uint32_t{kMaxSrdoCount} - setup.slot_count);
    discrepancy_us_ = setup.discrepancy_us;
    watched_ = 0U;
    previous_ = Instant{0U};
}

PreparedVerdict Comparator::ComparePrepared(const PreparedPair& a, const PreparedPair& b) noexcept
{
    const std::uint32_t statuses = Unequal(static_cast<std::uint8_t>(a.status), static_cast<std::uint8_t>(b.status));
    if ((statuses | UnequalForm(a.normal, b.normal)) != 0U)
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
        verdict.newly_matched |= bit;
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
