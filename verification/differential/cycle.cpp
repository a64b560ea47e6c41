// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The cycle with what the kernel hands in, then Commit and the permits.
#include "verification/differential/differential.hpp"

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

void Differential::ChooseInputs() noexcept
{
    static constexpr NmtState kOthers[] = {NmtState::kInvalid, NmtState::kInitialising, NmtState::kPreOperational,
                                           NmtState::kStopped};
    if (nmt_ == NmtState::kOperational)
    {
        nmt_ = random_.Chance(35U) ? kOthers[random_.Below(4U)] : nmt_;
    }
    else if (random_.Chance(600U))
    {
        nmt_ = NmtState::kOperational;
    }
    if (random_.Chance(250U))
    {
        acknowledge_ = random_.Chance(700U) ? ~acknowledge_ : random_.Mask();
    }
    request_ |= random_.Chance(60U) ? random_.Mask() : 0U;
    stand_ |= random_.Chance(60U) ? random_.Mask() : 0U;
    queue_ = random_.Chance(20U) ? static_cast<QueueState>(random_.Below(3U)) : QueueState::kIntact;
    token_flip_ = random_.Chance(12U) ? (random_.Chance(500U) ? (1U << random_.Below(32U)) : random_.Next()) : 0U;
    const std::uint32_t cycle_us = device_.config_a.cycle_us;
    const std::uint32_t tolerance_us = device_.config_a.cycle_tolerance_us;
    const std::uint32_t kind = random_.Below(100U);
    std::uint32_t next_us = now_us_ + cycle_us;
    if (kind < 6U)
    {
        next_us += tolerance_us + random_.Below(2U);
    }
    else if (kind < 20U)
    {
        GoNear(AnySlot());
        next_us = clock_us_;
    }
    else if (kind < 50U)
    {
        next_us = clock_us_ + random_.Below(200U);
    }
    // A call is never before a frame that it has seen.
    clock_us_ = ((next_us - clock_us_) < 0x80000000U) ? next_us : clock_us_;
}

void Differential::CycleStep() noexcept
{
    ChooseInputs();
    challenge_ = (challenge_ * 1664525U) + 1013904223U;
    challenge_ = (challenge_ == 0U) ? 1U : challenge_;
    now_us_ = clock_us_;
    const std::uint32_t token = RotatedLeft(challenge_, 8U) ^ (configuration_valid_ * 0x01010101U) ^ token_flip_;
    const CycleInput input{Instant{now_us_}, challenge_, token, acknowledge_, request_, stand_, nmt_, queue_};
    Step("Masks of OnCycle: request, stand", kNoSlot, request_, stand_, 0U);
    Step("OnCycle: now, acknowledge, NMT << 16 | queue << 8 | token wrong", kNoSlot, now_us_, acknowledge_,
         (static_cast<std::uint64_t>(nmt_) << 16U) | (static_cast<std::uint64_t>(queue_) << 8U) |
             ((token_flip_ != 0U) ? 1U : 0U));
    const CycleOutcome a = a_.OnCycle(input);
    const CycleOutcome b = b_.OnCycle(input);
    request_ = 0U;
    stand_ = 0U;
    CompareOutcomes(a, b);
    CompareAllSlots();
    reached_.AddGuard(a.guard);
    reached_.Add(Item::kAcceptedPair, BitsIn(a.fresh));
    for (SlotIndex slot = 0U; slot < device_.config_a.srdo_count; ++slot)
    {
        NoteRecovery(slot, a_.View(slot));
        if (((a.fresh >> slot) & 1U) != 0U)
        {
            NoteAccepted(slot);
        }
        if (a.not_operational == 1U)
        {
            transmissions_[slot] = Transmission{};
        }
    }
    CommitStep(a);
    Serve(a.due);
}

void Differential::CommitStep(const CycleOutcome& outcome) noexcept
{
    if (random_.Chance(50U))
    {
        return;
    }
    Agreement agreement{outcome.released, outcome.released};
    if (random_.Chance(150U))
    {
        agreement.agreed &= random_.Mask();
    }
    if (random_.Chance(150U))
    {
        agreement.matched &= random_.Mask();
    }
    if (random_.Chance(30U))
    {
        agreement = Agreement{random_.Mask(), random_.Mask()};
    }
    Step("Commit: agreed, matched", kNoSlot, agreement.agreed, agreement.matched, 0U);
    a_.Commit(agreement);
    b_.Commit(agreement);
    for (SlotIndex slot = 0U; slot < device_.config_a.srdo_count; ++slot)
    {
        CompareObjects(slot);
    }
    AnswerStep();
}

void Differential::AnswerStep() noexcept
{
    Step("Answer: challenge", kNoSlot, challenge_, 0U, 0U);
    const Permit a = a_.Answer(challenge_);
    const Permit b = b_.Answer(challenge_);
    Same("mask of the permit", kNoSlot, a.mask, b.mask);
    Same("response of A", kNoSlot, a.response, ResponseOf(challenge_, a.mask, kPermitConstantA));
    Same("response of B", kNoSlot, ResponseOf(challenge_, b.mask, kPermitConstantB), b.response);
    reached_.Add(Item::kCommittedPair, BitsIn(a.mask));
}

} // namespace counterpoint::differential
