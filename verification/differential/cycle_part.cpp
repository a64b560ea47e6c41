// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/differential/cycle_part.hpp"

namespace counterpoint::differential
{

namespace
{
std::uint32_t RotatedLeft(std::uint32_t word, std::uint32_t bits) noexcept
{
    return (word << bits) | (word >> (32U - bits));
}

/// [SRS_REL_010], written down once more.
std::uint32_t ResponseOf(std::uint32_t challenge, SrdoMask mask, std::uint32_t constant) noexcept
{
    const std::uint32_t low = static_cast<std::uint32_t>(mask & 0xFFFFFFFFU);
    const std::uint32_t high = static_cast<std::uint32_t>(mask >> 32U);
    return ((challenge + low) ^ RotatedLeft(high, 16U)) * constant;
}

std::uint32_t BitsIn(SrdoMask mask) noexcept
{
    std::uint32_t bits = 0U;
    for (SrdoMask rest = mask; rest != 0U; rest &= rest - 1U)
    {
        ++bits;
    }
    return bits;
}
} // namespace

void CyclePart::Begin() noexcept
{
    for (SlotIndex slot = 0U; slot < kMaxSrdoCount; ++slot)
    {
        producer_.GiveUp(slot);
        states_[slot] = SrdoState::kOff;
        causes_[slot] = SrdoCause::kNone;
    }
    acknowledge_ = 0U;
    queue_ = QueueState::kIntact;
    token_flip_ = 0U;
    challenge_ = scene_.random.Next() | 1U;
}

void CyclePart::ChooseInputs() noexcept
{
    static constexpr NmtState kOthers[] = {NmtState::kInvalid, NmtState::kInitialising, NmtState::kPreOperational,
                                           NmtState::kStopped};
    if (scene_.nmt == NmtState::kOperational)
    {
        scene_.nmt = scene_.random.Chance(35U) ? kOthers[scene_.random.Below(4U)] : scene_.nmt;
    }
    else if (scene_.random.Chance(600U))
    {
        scene_.nmt = NmtState::kOperational;
    }
    if (scene_.random.Chance(250U))
    {
        acknowledge_ = scene_.random.Chance(700U) ? ~acknowledge_ : scene_.random.Mask();
    }
    scene_.request |= scene_.random.Chance(60U) ? scene_.random.Mask() : 0U;
    scene_.stand |= scene_.random.Chance(60U) ? scene_.random.Mask() : 0U;
    queue_ = scene_.random.Chance(20U) ? static_cast<QueueState>(scene_.random.Below(3U)) : QueueState::kIntact;
    token_flip_ = scene_.random.Chance(12U)
                      ? (scene_.random.Chance(500U) ? (1U << scene_.random.Below(32U)) : scene_.random.Next())
                      : 0U;
    const std::uint32_t cycle_us = scene_.device.config_a.cycle_us;
    const std::uint32_t tolerance_us = scene_.device.config_a.cycle_tolerance_us;
    const std::uint32_t kind = scene_.random.Below(100U);
    std::uint32_t next_us = scene_.now_us + cycle_us;
    if (kind < 6U)
    {
        next_us += tolerance_us + scene_.random.Below(2U);
    }
    else if (kind < 20U)
    {
        scene_.GoNear(scene_.AnySlot());
        next_us = scene_.clock_us;
    }
    else if (kind < 50U)
    {
        next_us = scene_.clock_us + scene_.random.Below(200U);
    }
    // A call is never before a frame that it has seen.
    scene_.clock_us = ((next_us - scene_.clock_us) < 0x80000000U) ? next_us : scene_.clock_us;
}

/// What kind of SRDO took a pair, for the counts.
void CyclePart::NoteAccepted(SlotIndex slot) noexcept
{
    const SlotPlan& plan = scene_.device.plans[slot];
    bool has_dummy = false;
    for (std::uint32_t pair = 0U; pair < plan.pairs; ++pair)
    {
        has_dummy = has_dummy || (plan.dummies[pair] != 0U);
    }
    scene_.reached.Add(Item::kAcceptedBits, ((plan.bits % 8U) != 0U) ? 1U : 0U);
    scene_.reached.Add(Item::kAcceptedDummies, has_dummy ? 1U : 0U);
    scene_.reached.Add(Item::kAcceptedStatic, plan.is_static ? 1U : 0U);
    scene_.reached.Add(Item::kAcceptedManyEntries, (plan.pairs > 8U) ? 1U : 0U);
}

/// What happened to a slot in this OnCycle, for the counts.
void CyclePart::NoteRecovery(SlotIndex slot, const SrdoView& view) noexcept
{
    if ((view.state == SrdoState::kReleased) && (states_[slot] == SrdoState::kFaulted))
    {
        const bool is_automatic = scene_.device.setups[slot].policy == ReleasePolicy::kAutomatic;
        scene_.reached.Add(is_automatic ? Item::kAutomaticRecovery : Item::kInterlockRecovery);
    }
    if ((view.first_cause == SrdoCause::kNone) && (causes_[slot] != SrdoCause::kNone))
    {
        scene_.reached.Add(Item::kAcknowledgedCause);
    }
    scene_.reached.AddSignals(view.signals, view.state == SrdoState::kProducer);
    const bool is_late = scene_.device.setups[slot].detection == SrvtDetection::kLate;
    if (is_late && (view.state != SrdoState::kProducer))
    {
        scene_.reached.Add(Item::kLateSrvt, (view.signals >> static_cast<std::uint8_t>(SrdoCause::kSrvt)) & 1U);
        scene_.reached.Add(Item::kLateSct, (view.signals >> static_cast<std::uint8_t>(SrdoCause::kSct)) & 1U);
        scene_.reached.Add(Item::kLateReleased, (view.state == SrdoState::kReleased) ? 1U : 0U);
    }
    states_[slot] = view.state;
    causes_[slot] = view.first_cause;
}

void CyclePart::Step() noexcept
{
    ChooseInputs();
    challenge_ = (challenge_ * 1664525U) + 1013904223U;
    challenge_ = (challenge_ == 0U) ? 1U : challenge_;
    scene_.now_us = scene_.clock_us;
    const std::uint32_t token = RotatedLeft(challenge_, 8U) ^ (scene_.configuration_valid * 0x01010101U) ^ token_flip_;
    const CycleInput input{Instant{scene_.now_us}, challenge_,   token,      acknowledge_,
                           scene_.request,         scene_.stand, scene_.nmt, queue_};
    compare_.Step("Masks of OnCycle: request, stand", kNoSlot, scene_.request, scene_.stand, 0U);
    compare_.Step("OnCycle: now, acknowledge, NMT << 16 | queue << 8 | token wrong", kNoSlot, scene_.now_us,
                  acknowledge_,
                  (static_cast<std::uint64_t>(scene_.nmt) << 16U) | (static_cast<std::uint64_t>(queue_) << 8U) |
                      ((token_flip_ != 0U) ? 1U : 0U));
    const CycleOutcome a = scene_.a.OnCycle(input);
    const CycleOutcome b = scene_.b.OnCycle(input);
    scene_.request = 0U;
    scene_.stand = 0U;
    compare_.Outcomes(a, b);
    compare_.AllSlots();
    scene_.reached.AddGuard(a.guard);
    scene_.reached.Add(Item::kAcceptedPair, BitsIn(a.fresh));
    for (SlotIndex slot = 0U; slot < scene_.device.config_a.srdo_count; ++slot)
    {
        NoteRecovery(slot, scene_.a.View(slot));
        if (((a.fresh >> slot) & 1U) != 0U)
        {
            NoteAccepted(slot);
        }
        if (a.not_operational == 1U)
        {
            producer_.GiveUp(slot);
        }
    }
    Commit(a);
    scene_.reached.Add(Item::kRefreshWaits, BitsIn(a.refresh));
    scene_.reached.Add(Item::kRefreshInFlight, BitsIn(a.refresh & ~a.due));
    producer_.Serve(a.due, a.refresh);
}

void CyclePart::Commit(const CycleOutcome& outcome) noexcept
{
    if (scene_.random.Chance(50U))
    {
        return;
    }
    Agreement agreement{outcome.released, outcome.released};
    if (scene_.random.Chance(150U))
    {
        agreement.agreed &= scene_.random.Mask();
    }
    if (scene_.random.Chance(150U))
    {
        agreement.matched &= scene_.random.Mask();
    }
    if (scene_.random.Chance(30U))
    {
        agreement = Agreement{scene_.random.Mask(), scene_.random.Mask()};
    }
    compare_.Step("Commit: agreed, matched", kNoSlot, agreement.agreed, agreement.matched, 0U);
    const SrdoMask examine = scene_.random.Mask();
    const SrdoMask found_a = scene_.a.Commit(agreement, examine);
    const SrdoMask found_b = scene_.b.Commit(agreement, examine);
    compare_.Same("slots not as they were written", kNoSlot, found_a, found_b);
    for (SlotIndex slot = 0U; slot < scene_.device.config_a.srdo_count; ++slot)
    {
        compare_.Objects(slot);
    }
    Answer();
}

void CyclePart::Answer() noexcept
{
    compare_.Step("Answer: challenge", kNoSlot, challenge_, 0U, 0U);
    const Permit a = scene_.a.Answer(challenge_);
    const Permit b = scene_.b.Answer(challenge_);
    compare_.Same("mask of the permit", kNoSlot, a.mask, b.mask);
    compare_.Same("response of A", kNoSlot, a.response, ResponseOf(challenge_, a.mask, kPermitConstantA));
    compare_.Same("response of B", kNoSlot, ResponseOf(challenge_, b.mask, kPermitConstantB), b.response);
    scene_.reached.Add(Item::kCommittedPair, BitsIn(a.mask));
}

} // namespace counterpoint::differential
