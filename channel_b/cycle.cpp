// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

constexpr std::uint32_t kWaitingBit = std::uint32_t{1U} << static_cast<std::uint32_t>(SrdoCause::kWaitingPastSct);

constexpr HalfMask kAll = 0xFFFFFFFFU;

[[nodiscard]] std::uint32_t SumOf(const Column<std::uint32_t>& column, std::size_t count) noexcept
{
    std::uint32_t sum = 0U;
    for (std::size_t index = 0U; index < count; ++index)
    {
        sum += column[index];
    }
    return sum;
}

[[nodiscard]] HalfMask FindSpent(const Storage& storage, SlotIndex first, SlotIndex end) noexcept
{
    HalfMask spent = 0U;
    for (SlotIndex slot = first; slot < end; ++slot)
    {
        if (storage.pair_left[slot] > storage.pair_limit[slot])
        {
            spent |= BitOf(slot);
        }
    }
    return spent;
}

[[nodiscard]] GuardView ViewGuard(const CycleInput& input, std::uint32_t declared) noexcept
{
    const std::uint32_t turned = (input.challenge << 8U) | (input.challenge >> 24U);
    if (input.guard_token != (turned ^ (declared * 0x01010101U)))
    {
        return GuardView::kStale;
    }
    return (declared == kConfigurationValidValue) ? GuardView::kConfigured : GuardView::kUnconfigured;
}

} // namespace

/// Takes the time since the last call from the budgets of all pairs, whether they run or not; returns all bits if one
/// has nothing left, else none. The loop is without a decision, so that a compiler can do several slots at once.
inline HalfMask Channel::SpendPairs() noexcept
{
    const std::uint32_t elapsed = x_elapsed_us;
    const Column<std::uint32_t> left = x_storage.pair_left;
    const Column<std::uint32_t> limit = x_storage.pair_limit;
    const std::size_t count = x_count;
    std::uint32_t any = 0U;
    for (std::size_t slot = 0U; slot < count; ++slot)
    {
        const std::uint32_t left_us = left[slot] - elapsed;
        any |= 0U - static_cast<std::uint32_t>(left_us > limit[slot]);
        left[slot] = left_us;
    }
    return any;
}

/// The same for the phases; returns some bits if one is over, else none.
inline HalfMask Channel::SpendPhases() noexcept
{
    const std::uint32_t elapsed = x_elapsed_us;
    const Column<std::uint32_t> phase = x_storage.phase_left;
    const std::size_t count = x_count;
    std::uint32_t any = 0U;
    for (std::size_t slot = 0U; slot < count; ++slot)
    {
        const std::uint32_t left_us = phase[slot] - elapsed;
        any |= left_us - 1U;
        phase[slot] = left_us;
    }
    return any & ~kLongestPhase;
}

/// Whether a phase may run in some slot: a device of consumers without an acknowledge edge has none.
inline HalfMask Channel::FindPhases() const noexcept
{
    const Marks& low = x_storage.marks[0U];
    const Marks& high = x_storage.marks[1U];
    const HalfMask others = (x_present[0U] & ~low.consumers) | (x_present[1U] & ~high.consumers); // MISRA D-002
    return others | low.acknowledged.on | high.acknowledged.on;
}

/// With late detection: SRVT of the normal frames that wait goes on, and has once and for all run out when it has.
/// [SRS-TIME-009]
inline void Channel::AgePending(const Half& half) noexcept
{
    const Marks& marks = *half.marks;
    for (HalfMask rest = marks.pending & marks.late & half.present; rest != 0U; rest = WithoutLowest(rest))
    {
        Row& row = x_storage.rows[LowestOf(rest, half.first)];
        row.srvt_left = (row.srvt_left > kLongestLeft) ? kLongOver : (row.srvt_left - x_elapsed_us);
    }
}

/// Closes the windows of signals and forgets the acknowledge edges that are over. A corrupted mark must not lead to a
/// slot that does not exist.
void Channel::CloseWindows(const Half& half) noexcept
{
    Marks& marks = *half.marks;
    for (HalfMask rest = marks.window_open & half.present; rest != 0U; rest = WithoutLowest(rest))
    {
        const SlotIndex slot = LowestOf(rest, half.first);
        Row& row = x_storage.rows[slot];
        row.window_left -= x_elapsed_us;
        if (row.window_left > SctUs(row))
        {
            marks.window_open &= ~BitOf(slot);
        }
    }
    for (HalfMask rest = marks.acknowledged.on & half.present; rest != 0U; rest = WithoutLowest(rest))
    {
        const SlotIndex slot = LowestOf(rest, half.first);
        if (x_storage.phase_left[slot] > x_config->acknowledge_window_us)
        {
            Withdraw(marks.acknowledged, BitOf(slot));
        }
    }
}

/// Consumers that complain about no first pair. [SRS-CONS-022]
inline HalfMask Channel::MissFirstPairs(const Half& half) noexcept
{
    Marks& marks = *half.marks;
    HalfMask missed = 0U;
    marks.unheard &= marks.consumers & ~(marks.faulted | marks.released.on | marks.fresh);
    for (HalfMask rest = marks.unheard; rest != 0U; rest = WithoutLowest(rest))
    {
        const SlotIndex slot = LowestOf(rest, half.first);
        Row& row = x_storage.rows[slot];
        if (x_active_us > SctUs(row))
        {
            row.causes |= kWaitingBit;
            missed |= BitOf(slot);
        }
    }
    marks.unheard &= ~missed;
    return missed;
}

/// [SRS-CONS-021]
inline void Channel::Signal(Half& half, HalfMask slots) noexcept
{
    Marks& marks = *half.marks;
    for (HalfMask rest = slots; rest != 0U; rest = WithoutLowest(rest))
    {
        const SlotIndex slot = LowestOf(rest, half.first);
        Row& row = x_storage.rows[slot];
        if ((marks.window_open & BitOf(slot)) == 0U)
        {
            row.window_left = SctUs(row);
            row.told = 0U;
        }
        const std::uint32_t news = row.causes & ~row.told;
        row.signals = news;
        row.told |= news;
        row.causes = 0U;
        if (news != 0U)
        {
            half.signalled |= BitOf(slot);
        }
    }
    marks.window_open |= slots;
    marks.signalled = half.signalled;
}

/// What seldom happens is looked for first.
[[gnu::always_inline]] inline void Channel::CycleHalf(const CycleInput& input, const Call& call, Half& half) noexcept
{
    Marks& marks = *half.marks;
    HalfMask left = 0U;
    if (call.spent != 0U)
    {
        half.spent = FindSpent(x_storage, half.first, EndOf(half.first, x_count));
    }
    if (((marks.window_open | marks.acknowledged.on) & half.present) != 0U)
    {
        CloseWindows(half);
    }
    AgePending(half);
    if (call.entering != 0U)
    {
        Enter(half);
    }
    if (call.leaving != 0U)
    {
        left = Leave(half);
    }
    ExamineMarks(half);
    if ((marks.consumers & (marks.reporting | half.spent | call.alarmed)) != 0U)
    {
        ExamineConsumers(call, half);
    }
    if ((marks.producers | call.ended) != 0U)
    {
        half.due = AdvanceProducers(input, call, half);
    }
    if (half.edges != 0U)
    {
        Acknowledge(half);
    }
    const HalfMask missed = MissFirstPairs(half);
    if (((marks.consumers & ~marks.released.on) | marks.acknowledged.on) != 0U)
    {
        Release(half);
    }
    half.new_fault = marks.reporting & (marks.consumers | left);
    half.fresh = marks.fresh & Granted(marks.held) & marks.consumers;
    Signal(half, (marks.reporting | missed) & half.present);
    marks.fresh = 0U;
    marks.reporting = 0U;
}

CycleOutcome Channel::OnCycle(const CycleInput& input) noexcept
{
    CycleOutcome outcome{};
    Half halves[kHalves] = {}; // MISRA D-001
    outcome.guard = ViewGuard(input, x_storage.device[kConfigurationValidAt]);
    const bool is_configured = outcome.guard == GuardView::kConfigured;
    const HalfMask running = (is_configured && (input.nmt == NmtState::kOperational)) ? kAll : 0U;
    x_elapsed_us = input.now.us - x_last_us;
    x_last_us = input.now.us;
    const HalfMask late = (x_elapsed_us > x_late_us) ? kAll : 0U;
    const HalfMask overflowed = (input.queue != QueueState::kIntact) ? kAll : 0U;
    const HalfMask alarmed = late | overflowed | x_gfc;
    const HalfMask ended = (FindPhases() != 0U) ? SpendPhases() : 0U;
    const Call call{late, overflowed, alarmed, running & ~x_running, x_running & ~running, SpendPairs(), ended};
    x_late_us = x_config->cycle_us + x_config->cycle_tolerance_us;
    x_running = running;
    x_active_us = (x_active_us + x_elapsed_us) & ~call.entering;
    if (call.leaving != 0U)
    {
        ClearLookUp();
    }
    for (SlotIndex first = 0U; first < x_count; first = static_cast<SlotIndex>(first + kSlotsInHalf))
    {
        const std::size_t at = first / kSlotsInHalf;
        const HalfMask levels = PartOf(input.acknowledge, first);
        halves[at].marks = &x_storage.marks[at];
        halves[at].first = first;
        halves[at].present = x_present[at];
        halves[at].edges = levels & ~x_levels[at];
        x_levels[at] = levels;
        CycleHalf(input, call, halves[at]);
    }
    const Half& low = halves[0U];
    const Half& high = halves[1U];
    const Marks& low_marks = x_storage.marks[0U];
    const Marks& high_marks = x_storage.marks[1U];
    const SrdoMask consumers = Join(low_marks.consumers, high_marks.consumers);
    outcome.released = consumers & Join(Granted(low_marks.released), Granted(high_marks.released));
    outcome.faulted = consumers & Join(low_marks.faulted, high_marks.faulted);
    outcome.waiting = consumers & ~(outcome.released | outcome.faulted);
    outcome.new_fault = Join(low.new_fault, high.new_fault);
    outcome.fresh = Join(low.fresh, high.fresh);
    outcome.due = Join(low.due, high.due);
    outcome.signalled = Join(low.signalled, high.signalled);
    outcome.sct_checked = CountOf(low_marks.consumers, high_marks.consumers);
    outcome.is_tx = CountOf(low_marks.producers, high_marks.producers);
    outcome.cycle = ++x_cycle;
    outcome.ordinal_sum = SumOf(x_storage.ordinal, x_count);
    outcome.not_operational = static_cast<std::uint8_t>(running == 0U);
    outcome.is_invalid = static_cast<std::uint8_t>((x_count & running) - (outcome.sct_checked + outcome.is_tx));
    x_gfc = 0U;
    return outcome;
}

} // namespace counterpoint::channel_b
