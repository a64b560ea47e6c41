// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

constexpr HalfMask kAll = 0xFFFFFFFFU;
/// A budget of SRVT above has gone below zero; at the second one it has long run out, whatever instants a frame may
/// have.
constexpr std::uint32_t kLongestLeft = 0x7FFFFFFFU;
constexpr std::uint32_t kLongOver = 0x80040000U;

/// A released consumer that holds a pair, has no cause and no news: all there is to do is to take the time.
constexpr std::uint32_t kQuiet =
    FourBytes(static_cast<std::uint32_t>(Standing::kReleased), kHeld, Code(SrdoCause::kNone), 0U);

/// With no other news than these.
[[nodiscard]] inline bool IsQuiet(const Row& row, std::uint32_t news) noexcept
{
    const std::uint32_t marks =
        FourBytes(static_cast<std::uint32_t>(row.standing), row.held, row.first_cause, row.news);
    return (marks == (kQuiet | (news << 24U))) && (row.left <= row.limit);
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

/// It ceases to be active. [SRS_CONS_019, SRS_PROD_011]
void Leave(Row& row) noexcept
{
    if (IsConsumer(row))
    {
        Fault(row, SrdoCause::kNotOperational);
    }
    Ground(row, Stage::kOff);
    row.standing = Standing::kOff;
    row.ordinal = 0U;
}

/// [SRS_CONS_021]
[[nodiscard]] std::uint32_t Signal(Row& row) noexcept
{
    const std::uint32_t causes = row.causes;
    if (causes == 0U)
    {
        return 0U;
    }
    if (!HasNews(row, kWindowOpen))
    {
        SetNews(row, kWindowOpen);
        row.window_us = 0U;
        row.told = 0U;
    }
    row.signals = causes & ~row.told;
    row.told |= causes;
    row.causes = 0U;
    ClearNews(row, kReported);
    return row.signals;
}

} // namespace

/// Whether it becomes active, and as what. A window of signals stays open.
void Channel::Enter(SlotIndex slot, Row& row) noexcept
{
    const std::uint32_t direction = ByteAt(row, kDirectionAt);
    Ground(row, Stage::kOff);
    row.standing = Standing::kOff;
    row.held = kUnset;
    row.edge = kUnset;
    row.ordinal = 0U;
    row.srvt_limit = kNothingRuns;
    row.news = static_cast<std::uint8_t>(row.news & kWindowOpen);
    row.phase_left = kFirstTransmissionStepUs * x_config->node_id;
    if ((row.valid != kGood) || (row.resolved != kGood))
    {
        return;
    }
    if (direction == kDirectionProducer)
    {
        row.standing = Standing::kProducer;
        row.stage = Stage::kIdle;
    }
    else if (direction == kDirectionConsumer)
    {
        row.standing = Standing::kWaiting;
        SetNews(row, kUnheard);
    }
    else
    {
        return;
    }
    // Identifiers were checked by Validate; the remainder keeps a corrupted one within the table.
    const std::uint32_t offset = WordAt(row, kCobId1At) - kFirstSrdoIdentifier;
    x_storage.slot_of[offset % kSrdoIdentifierCount] = slot;
    x_storage.slot_of[(offset + 1U) % kSrdoIdentifierCount] = slot;
}

/// What runs beside the budget of the pair, whether it counts or not.
void Channel::Age(Row& row) const noexcept
{
    row.signals = 0U;
    row.window_us += x_elapsed_us;
    if (row.window_us > SctUs(row))
    {
        ClearNews(row, kWindowOpen);
    }
    row.phase_left -= x_elapsed_us;
    // Once and for all it has run out when it has. [SRS_TIME_009]
    row.srvt_left = (row.srvt_left > kLongestLeft) ? kLongOver : (row.srvt_left - x_elapsed_us);
}

void Channel::Serve(SlotIndex slot, Row& row, Half& half) noexcept
{
    Age(row);
    if ((x_alarms & kEntering) != 0U)
    {
        Enter(slot, row);
    }
    if ((x_alarms & kLeaving) != 0U)
    {
        half.new_fault |= IsConsumer(row) ? half.bit : 0U;
        Leave(row);
    }
    if (IsConsumer(row))
    {
        ServeConsumer(row, half);
    }
    if (row.standing == Standing::kProducer)
    {
        ServeProducer(row, half);
    }
    if (Signal(row) != 0U)
    {
        half.signalled |= half.bit;
    }
}

/// Takes the time from the budgets of all pairs of one half. A slot where that is all there is to do is released as it
/// was; the others are busy.
void Channel::Spend(SlotIndex first, Half& half) const noexcept
{
    const std::uint32_t above = x_count - first;
    const std::uint32_t count = (above < kSlotsInHalf) ? above : kSlotsInHalf; // At least one.
    const HalfMask beyond = HalfMask{2U} << (count - 1U);
    const std::uint32_t elapsed_us = x_elapsed_us;
    std::uint32_t ordinal_sum = 0U;
    std::size_t slot = first;
    half.consumers = count;
    for (HalfMask bit = 1U; bit != beyond; bit <<= 1U)
    {
        Row& row = x_storage.rows[slot];
        row.left -= elapsed_us;
        if (IsQuiet(row, 0U))
        {
            ordinal_sum += row.ordinal;
        }
        else
        {
            half.busy |= bit;
        }
        ++slot;
    }
    if ((x_alarms | half.edges) != 0U)
    {
        half.busy = beyond - 1U;
        ordinal_sum = 0U;
    }
    half.ordinal_sum = ordinal_sum;
    half.released = (beyond - 1U) & ~half.busy;
}

void Channel::ServeHalf(SlotIndex first, Half& half) noexcept
{
    Spend(first, half);
    const bool is_calm = (x_alarms | half.edges) == 0U;
    for (HalfMask rest = half.busy; rest != 0U; rest = WithoutLowest(rest))
    {
        const SlotIndex slot = static_cast<SlotIndex>(first + LowestOf(rest));
        Row& row = x_storage.rows[slot];
        half.bit = BitOf(slot);
        if (is_calm && IsQuiet(row, kFresh))
        {
            half.ordinal_sum += row.ordinal;
            half.released |= half.bit;
            half.fresh |= half.bit;
            row.news = 0U;
        }
        else
        {
            half.consumers -= 1U;
            Serve(slot, row, half);
        }
    }
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
    x_active_us += x_elapsed_us;
    x_alarms |= (x_elapsed_us > x_late_us) ? kLate : 0U;
    x_alarms |= (input.queue != QueueState::kIntact) ? kOverflowed : 0U;
    x_alarms |= x_running & ~running & kLeaving;
    if ((running & ~x_running) != 0U)
    {
        x_alarms |= kEntering;
        x_active_us = 0U;
        for (std::uint8_t offset = 0U; offset < kLookUpBytes; ++offset)
        {
            x_storage.slot_of[offset] = kNoSlot;
        }
    }
    x_late_us = x_config->cycle_us + x_config->cycle_tolerance_us;
    x_running = running;
    for (SlotIndex first = 0U; first < x_count; first = static_cast<SlotIndex>(first + kSlotsInHalf))
    {
        const std::size_t index = first / kSlotsInHalf;
        Half& half = halves[index];
        const HalfMask levels = PartOf(input.acknowledge, index);
        half.edges = levels & ~x_levels[index];
        half.requests = PartOf(input.request, index);
        half.stand = PartOf(input.stand, index);
        x_levels[index] = levels;
        ServeHalf(first, half);
        x_released[index] = half.released;
    }
    x_alarms = 0U;
    const Half& low = halves[0U];
    const Half& high = halves[1U];
    outcome.released = Join(low.released, high.released);
    outcome.faulted = Join(low.faulted, high.faulted);
    outcome.waiting = Join(low.waiting, high.waiting);
    outcome.new_fault = Join(low.new_fault, high.new_fault);
    outcome.fresh = Join(low.fresh, high.fresh);
    outcome.due = Join(low.due, high.due);
    outcome.signalled = Join(low.signalled, high.signalled);
    outcome.cycle = ++x_cycle;
    outcome.ordinal_sum = low.ordinal_sum + high.ordinal_sum;
    outcome.sct_checked = static_cast<std::uint8_t>(low.consumers + high.consumers);
    outcome.is_tx = static_cast<std::uint8_t>(low.producers + high.producers);
    outcome.is_invalid = static_cast<std::uint8_t>((x_count & running) - (outcome.sct_checked + outcome.is_tx));
    outcome.not_operational = static_cast<std::uint8_t>(running == 0U);
    return outcome;
}

} // namespace counterpoint::channel_b
