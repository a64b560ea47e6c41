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

[[nodiscard]] std::uint32_t SumOf(const Column<std::uint32_t>& column, std::size_t count) noexcept
{
    std::uint32_t sum = 0U;
    for (std::size_t index = 0U; index < count; ++index)
    {
        sum += column[index];
    }
    return sum;
}

} // namespace

GuardView Channel::ViewGuard(const CycleInput& input) const noexcept
{
    const std::uint32_t declared = x_storage.device[kConfigurationValidAt];
    const std::uint32_t turned = (input.challenge << 8U) | (input.challenge >> 24U);
    if (input.guard_token != (turned ^ (declared * 0x01010101U)))
    {
        return GuardView::kStale;
    }
    return (declared == kConfigurationValidValue) ? GuardView::kConfigured : GuardView::kUnconfigured;
}

/// Takes the time since the last call from the budgets of all pairs, whether they run or not; returns the slots that
/// have nothing left. The first loop is without a decision, so that a compiler can do several slots at once.
SrdoMask Channel::SpendPairs() noexcept
{
    const std::uint32_t elapsed = x_elapsed_us;
    const Column<std::uint32_t> left = x_storage.pair_left;
    const Column<std::uint32_t> limit = x_storage.pair_limit;
    const std::size_t count = x_count;
    std::uint32_t any = 0U;
    for (std::size_t slot = 0U; slot < count; ++slot)
    {
        left[slot] -= elapsed;
        any |= static_cast<std::uint32_t>(left[slot] > limit[slot]);
    }
    SrdoMask spent = 0U;
    for (std::size_t slot = 0U; (any != 0U) && (slot < count); ++slot)
    {
        spent |= static_cast<SrdoMask>(left[slot] > limit[slot]) << slot;
    }
    return spent;
}

/// Takes it from the windows of signals and from the acknowledge edges and closes those that are over. A corrupted mark
/// must not lead to a slot that does not exist.
void Channel::SpendWindows() noexcept
{
    Marks& marks = *x_storage.marks;
    for (SrdoMask rest = marks.window_open & x_present; rest != 0U;)
    {
        const SlotIndex slot = TakeLowest(rest);
        x_storage.window_left[slot] -= x_elapsed_us;
        if (x_storage.window_left[slot] > SctUs(x_storage, slot))
        {
            marks.window_open &= ~BitOf(slot);
        }
    }
    for (SrdoMask rest = marks.acknowledged.on & x_present; rest != 0U;)
    {
        const SlotIndex slot = TakeLowest(rest);
        x_storage.edge_left[slot] -= x_elapsed_us;
        if (x_storage.edge_left[slot] > x_config->acknowledge_window_us)
        {
            Withdraw(marks.acknowledged, BitOf(slot));
        }
    }
}

void Channel::EnterSlot(SlotIndex slot, SrdoState state) noexcept
{
    const std::uint32_t first_us = kFirstTransmissionStepUs * x_config->node_id;
    // Identifiers were checked by Validate; the remainder keeps a corrupted one within the table.
    const std::uint32_t offset = NormalIdentifier(x_storage, slot) - kFirstSrdoIdentifier;
    x_storage.slot_of[offset % kSrdoIdentifierCount] = slot;
    x_storage.slot_of[(offset + 1U) % kSrdoIdentifierCount] = slot;
    x_storage.state[slot] = Code(state);
    x_storage.stage[slot] = Stage::kIdle;
    x_storage.ordinal[slot] = 0U;
    x_storage.sent[slot] = 0U;
    x_storage.pair_limit[slot] = kNothingRuns;
    // This call takes away the time before it from all phases, from this one as well.
    const std::uint32_t phase_us = (state == SrdoState::kProducer) ? first_us : SctUs(x_storage, slot);
    x_storage.phase_left[slot] = phase_us + x_elapsed_us;
}

void Channel::Enter() noexcept
{
    Marks& marks = *x_storage.marks;
    x_active = x_present;
    Withdraw(marks.held, x_present);
    Withdraw(marks.acknowledged, x_present);
    marks.unheard = x_present;
    marks.pending = 0U;
    marks.started = 0U;
    marks.requested = 0U;
    marks.refresh_due = 0U;
    marks.standing = 0U;
    const SrdoMask usable = Granted(marks.valid) & marks.resolved;
    for (SlotIndex slot = 0U; slot < x_count; ++slot)
    {
        const bool is_usable = (usable & BitOf(slot)) != 0U;
        if (is_usable && (x_storage.direction[slot] == kDirectionConsumer))
        {
            EnterSlot(slot, SrdoState::kWaiting);
        }
        if (is_usable && (x_storage.direction[slot] == kDirectionProducer))
        {
            EnterSlot(slot, SrdoState::kProducer);
        }
    }
}

/// Returns the consumers that were active. [SRS-CONS-019, SRS-PROD-011]
SrdoMask Channel::Leave() noexcept
{
    const SrdoMask left = x_storage.marks->consumers & x_present;
    FaultEach(left, SrdoCause::kNotOperational);
    for (SlotIndex slot = 0U; slot < x_count; ++slot)
    {
        x_storage.state[slot] = Code(SrdoState::kOff);
        x_storage.stage[slot] = Stage::kIdle;
        x_storage.sent[slot] = 0U;
        x_storage.pair_limit[slot] = kNothingRuns;
    }
    x_storage.marks->consumers = 0U;
    x_active = 0U;
    ClearLookUp();
    return left;
}

SrdoMask Channel::SettleActivity(bool operational) noexcept
{
    const bool is_active = x_active != 0U;
    if (operational && (!is_active))
    {
        Enter();
    }
    if ((!operational) && is_active)
    {
        return Leave();
    }
    return 0U;
}

/// Consumers that complain about no first pair. [SRS-CONS-022]
SrdoMask Channel::MissFirstPairs(const Census& census) noexcept
{
    Marks& marks = *x_storage.marks;
    SrdoMask missed = 0U;
    marks.unheard &= census.waiting & ~marks.fresh;
    for (SrdoMask rest = marks.unheard; rest != 0U;)
    {
        const SlotIndex slot = TakeLowest(rest);
        x_storage.phase_left[slot] -= x_elapsed_us;
        if (x_storage.phase_left[slot] > SctUs(x_storage, slot))
        {
            x_storage.causes[slot] |= kWaitingBit;
            missed |= BitOf(slot);
        }
    }
    marks.unheard &= ~missed;
    return missed;
}

/// [SRS-CONS-021]
void Channel::Signal(SrdoMask slots) noexcept
{
    Marks& marks = *x_storage.marks;
    marks.signalled = 0U;
    for (SrdoMask rest = slots; rest != 0U;)
    {
        const SlotIndex slot = TakeLowest(rest);
        if ((marks.window_open & BitOf(slot)) == 0U)
        {
            x_storage.window_left[slot] = SctUs(x_storage, slot);
            x_storage.told[slot] = 0U;
        }
        const std::uint32_t news = x_storage.causes[slot] & ~x_storage.told[slot];
        x_storage.signals[slot] = news;
        x_storage.told[slot] |= news;
        x_storage.causes[slot] = 0U;
        marks.signalled |= static_cast<SrdoMask>(news != 0U) << slot;
    }
    marks.window_open |= slots;
}

CycleOutcome Channel::OnCycle(const CycleInput& input) noexcept
{
    Marks& marks = *x_storage.marks;
    x_elapsed_us = input.now.us - x_last_us;
    const bool is_late = x_elapsed_us > x_late_us;
    const SrdoMask edges = input.acknowledge & ~x_levels;
    x_last_us = input.now.us;
    x_late_us = x_config->cycle_us + x_config->cycle_tolerance_us;
    x_levels = input.acknowledge;
    ++x_cycle;
    const SrdoMask spent = SpendPairs();
    SpendWindows();
    CycleOutcome outcome{};
    outcome.guard = ViewGuard(input);
    const bool is_configured = outcome.guard == GuardView::kConfigured;
    const SrdoMask left = SettleActivity(is_configured && (input.nmt == NmtState::kOperational));
    Census census = SoundCensus();
    const SrdoMask consumers = census.waiting | census.faulted | census.released;
    marks.consumers = consumers;
    ExamineConsumers(input, spent, is_late, census);
    outcome.due = AdvanceProducers(census.producers, spent);
    Acknowledge(edges, census);
    const SrdoMask missed = MissFirstPairs(census);
    Release(census);
    outcome.released = census.released;
    outcome.faulted = census.faulted;
    outcome.waiting = census.waiting;
    outcome.new_fault = marks.reporting & (consumers | left);
    outcome.fresh = marks.fresh & Granted(marks.held) & consumers;
    Signal((marks.reporting | missed) & x_present);
    outcome.signalled = marks.signalled;
    outcome.cycle = x_cycle;
    outcome.ordinal_sum = SumOf(x_storage.ordinal, x_count);
    outcome.sct_checked = CountOf(consumers);
    outcome.is_tx = CountOf(census.producers);
    outcome.not_operational = static_cast<std::uint8_t>(x_active == 0U);
    outcome.is_invalid = static_cast<std::uint8_t>(CountOf(x_active) - (outcome.sct_checked + outcome.is_tx));
    marks.fresh = 0U;
    marks.reporting = 0U;
    x_gfc = 0U;
    return outcome;
}

} // namespace counterpoint::channel_b
