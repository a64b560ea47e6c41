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

HeldPair Turned(const HeldPair& held, const HeldPair& turned) noexcept
{
    return HeldPair{Payload{held.data.low ^ turned.data.low, held.data.high ^ turned.data.high},
                    held.ordinal ^ turned.ordinal, held.holds_pair ^ turned.holds_pair};
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
    // An edge may lie anywhere in the window; without one, what one channel sees a little later has its time as well.
    const bool is_window_longer = setup.acknowledge_window_us > setup.discrepancy_us;
    slots_ = FirstSlots(setup.slot_count);
    pairs_.Restart(setup.discrepancy_us);
    releases_.Restart(is_window_longer ? setup.acknowledge_window_us : setup.discrepancy_us);
    agreed_ = 0U;
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
    const SrdoMask agreed_before = agreed_;
    agreed_ = 0U;
    if ((agreed_before & ~slots_) != 0U) // What was agreed exists: a mask of slots that changes is not waited out.
    {
        verdict.fault = DeviceFault::kComparator;
    }
    if (verdict.fault != DeviceFault::kNone)
    {
        return verdict;
    }

    // What only one channel calls faulted, without a new fault, and what was not agreed: one of them has released it by
    // its acknowledge, and waits for the other one.
    const SrdoMask faulted_in_one = a.faulted ^ b.faulted;
    const SrdoMask faults = a.faulted | b.faulted | a.new_fault | b.new_fault;
    const SrdoMask apart = (a.released ^ b.released) | faulted_in_one;
    // A release that was agreed and that one of them no longer knows is no skew of acknowledges. [SRS_CMP_250]
    verdict.demote = ((a.new_fault ^ b.new_fault) | (apart & agreed_before)) & slots_;
    agreed_ = a.released & b.released & ~faults & slots_;
    verdict.agreement.agreed = agreed_;
    verdict.start = a.due & b.due & slots_;

    const SrdoMask to_compare = slots_ & ~verdict.demote;
    const SrdoMask fresh = a.fresh | b.fresh;
    const SrdoMask known = pairs_.Renew();
    // A second release counts within the window only.
    const SrdoMask pending = (apart | (releases_.Renew() & agreed_)) & to_compare;
    releases_.Open(apart & to_compare);
    const SrdoMask due_in_one = a.due ^ b.due;
    SrdoMask to_look = known | pending | fresh;
    if (a.ordinal_sum != b.ordinal_sum)
    {
        to_look = slots_;
    }
    // A producer has no pair to demote: a channel that calls it faulted in every cycle hides nothing. [SRS_CMP_008]
    to_look = (to_look & to_compare) | (due_in_one & slots_);
    fresh_ = (fresh_ | fresh) & to_look;
    for (; to_look != 0U; to_look &= to_look - 1U)
    {
        const SlotSet lowest{to_look & (0U - to_look)};
        Look(comparison, lowest, (pending & lowest.mask) != 0U, verdict);
    }
    verdict.agreement.matched = Matched();
    previous_ = comparison.now;
    return verdict;
}

// t      k-1           k       a pair that differs at k came after comparison k-1: the time counts from there, so that
//         |....x........|       discrepancy time and one cycle cover it from its first effect. An acknowledge of one
//                               channel alone opens nothing: its time counts from k.
// Nothing is held of a producer: its pair was compared before it left, and a confirmation at the very limit may count
// in one channel alone.
void Comparator::Look(const Comparison& comparison, const SlotSet only, const bool is_pending,
                      Verdict& verdict) noexcept
{
    const SrdoMask bit = only.mask;
    const SlotIndex slot = LowestOf(only);
    const HeldPair a = comparison.channel_a->Held(slot);
    const HeldPair b = Turned(comparison.channel_b->Held(slot), comparison.turned);
    const SrdoMask due_in_one = (comparison.outcome_a->due ^ comparison.outcome_b->due) & bit;
    const std::uint32_t pairs = (a.ordinal ^ b.ordinal) | (a.holds_pair ^ b.holds_pair);
    const std::uint32_t data = Unequal(a.data, b.data);
    if ((pairs | data | due_in_one) != 0U)
    {
        pairs_.Open(bit);
    }
    if ((pairs_.Slots() & bit) != 0U) // Also a bit that is set without a difference: it keeps back every pair.
    {
        const bool is_over = pairs_.IsOver(only, previous_, comparison.now);
        if ((pairs == 0U) && (data != 0U))
        {
            verdict.fault = DeviceFault::kDisagreement;
            verdict.slot = slot;
        }
        else if (is_over)
        {
            verdict.fault = DeviceFault::kUnmatched;
            verdict.slot = slot;
        }
        else
        {
            // The channels have time left to agree.
        }
    }
    const bool is_late = is_pending ? releases_.IsOver(only, comparison.now, comparison.now) : false;
    if (is_late)
    {
        verdict.demote |= bit;
        agreed_ &= ~bit; // A release of one channel alone behind it is a new difference.
        verdict.agreement.agreed = agreed_;
        releases_.Close(bit);
        fresh_ &= ~bit;
    }
    if (((pairs_.Slots() | releases_.Slots()) & bit) == 0U)
    {
        verdict.newly_matched |= bit & fresh_;
        fresh_ &= ~bit;
    }
}

} // namespace counterpoint
