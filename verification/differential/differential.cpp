// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/differential/differential.hpp"

namespace counterpoint::differential
{

namespace
{
constexpr std::uint32_t kLeastSteps = 24U;
constexpr std::uint32_t kMostSteps = 48U;
} // namespace

Differential::Differential(Channel& a, Channel& b, Observer& observer) noexcept : a_{a}, b_{b}, observer_{observer}
{
}

bool Differential::RunSequence(std::uint32_t seed, std::uint32_t number) noexcept
{
    seed_ = seed;
    sequence_ = number;
    step_ = 0U;
    differs_ = false;
    random_.Start(seed, number);
    StartSequence();
    Configure();
    const std::uint32_t rounds = random_.Between(kLeastSteps, kMostSteps);
    for (std::uint32_t round = 0U; (round < rounds) && (!differs_); ++round)
    {
        const std::uint32_t kind = random_.Below(1000U);
        if (kind < 430U)
        {
            CycleStep();
        }
        else if (kind < 830U)
        {
            ConsumerStep();
        }
        else if (kind < 950U)
        {
            ProducerStep();
        }
        else if (kind < 970U)
        {
            RecheckBoth(AnySlot());
        }
        else
        {
            Reconfigure();
        }
    }
    DigestBoth();
    ++sequences_;
    steps_ += step_;
    failures_ += differs_ ? 1U : 0U;
    return !differs_;
}

void Differential::StartSequence() noexcept
{
    device_.Make(random_);
    for (SlotIndex slot = 0U; slot < kMaxSrdoCount; ++slot)
    {
        transmissions_[slot] = Transmission{};
        states_[slot] = SrdoState::kOff;
        causes_[slot] = SrdoCause::kNone;
    }
    acknowledge_ = 0U;
    request_ = 0U;
    stand_ = 0U;
    configured_ = 0U;
    configuration_valid_ = 0U;
    nmt_ = NmtState::kPreOperational;
    queue_ = QueueState::kIntact;
    token_flip_ = 0U;
    has_odd_mapping_ = false;
    challenge_ = random_.Next() | 1U;
    // One sequence in four runs across the wrap of the counter.
    clock_us_ = random_.Chance(250U) ? (0U - random_.Below(60000U)) : random_.Next();
    now_us_ = clock_us_;
    for (std::uint32_t& stamp : last_us_)
    {
        stamp = clock_us_;
    }
    Step("Restart: SRDOs, node-ID, cycle", kNoSlot, device_.config_a.srdo_count, device_.config_a.node_id,
         device_.config_a.cycle_us);
    a_.Restart(device_.config_a);
    b_.Restart(device_.config_b);
    CompareAllSlots();
}

SlotIndex Differential::AnySlot() noexcept
{
    return static_cast<SlotIndex>(random_.Below(device_.config_a.srdo_count));
}

void Differential::Step(const char* name, SlotIndex slot, std::uint64_t x, std::uint64_t y, std::uint64_t z) noexcept
{
    ++step_;
    if (is_told_)
    {
        observer_.OnStep(StepRecord{name, step_, slot, x, y, z});
    }
}

void Differential::Same(const char* field, SlotIndex slot, std::uint64_t a, std::uint64_t b) noexcept
{
    hash_.AddMask(a);
    if ((a != b) && (!differs_))
    {
        differs_ = true;
        observer_.OnDifference(Difference{field, a, b, seed_, sequence_, step_, slot});
    }
}

void Differential::CompareView(SlotIndex slot) noexcept
{
    const SrdoView a = a_.View(slot);
    const SrdoView b = b_.View(slot);
    Same("state", slot, static_cast<std::uint64_t>(a.state), static_cast<std::uint64_t>(b.state));
    Same("first_cause", slot, static_cast<std::uint64_t>(a.first_cause), static_cast<std::uint64_t>(b.first_cause));
    Same("ordinal", slot, a.ordinal, b.ordinal);
    Same("holds_pair", slot, a.holds_pair, b.holds_pair);
    Same("signals", slot, a.signals, b.signals);
    Same("error_count", slot, a.error_count, b.error_count);
    Same("data, bytes 0 to 3", slot, a.data.low, b.data.low);
    Same("data, bytes 4 to 7", slot, a.data.high, b.data.high);
    reached_.AddState(a.state);
    if ((a.first_cause == SrdoCause::kDemoted) && (a.state == SrdoState::kFaulted))
    {
        reached_.Add(Item::kCauseDemoted);
    }
}

void Differential::CompareHeld(SlotIndex slot) noexcept
{
    const HeldPair a = a_.Held(slot);
    const HeldPair b = b_.Held(slot);
    Same("held data, bytes 0 to 3", slot, a.data.low, b.data.low);
    Same("held data, bytes 4 to 7", slot, a.data.high, b.data.high);
    Same("held ordinal", slot, a.ordinal, b.ordinal);
    Same("holds_pair of Held", slot, a.holds_pair, b.holds_pair);
    reached_.Add(Item::kHeldPair, (a.holds_pair == 1U) ? 1U : 0U);
}

void Differential::CompareSlot(SlotIndex slot) noexcept
{
    CompareView(slot);
    CompareHeld(slot);
}

/// Every byte, those behind the length too.
void Differential::SameFrame(SlotIndex slot, const CanFrame& a, const CanFrame& b) noexcept
{
    Same("identifier of the frame", slot, a.identifier, b.identifier);
    Same("kind of the frame", slot, static_cast<std::uint64_t>(a.kind), static_cast<std::uint64_t>(b.kind));
    Same("controller of the frame", slot, static_cast<std::uint64_t>(a.port), static_cast<std::uint64_t>(b.port));
    Same("length of the frame", slot, a.length_bytes, b.length_bytes);
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        Same("data of the frame", slot, a.data[i], b.data[i]);
    }
}

void Differential::CompareAllSlots() noexcept
{
    for (SlotIndex slot = 0U; slot < device_.config_a.srdo_count; ++slot)
    {
        CompareSlot(slot);
    }
}

/// A's normal objects and B's inverse objects are complements; each leaves the other's alone.
void Differential::CompareObjects(SlotIndex slot) noexcept
{
    const std::uint8_t* const a = &device_.memory_a.bytes[Memory::kSlotBytes * slot];
    const std::uint8_t* const b = &device_.memory_b.bytes[Memory::kSlotBytes * slot];
    const SlotPlan& plan = device_.plans[slot];
    if ((plan.direction == kDirectionProducer) || has_odd_mapping_)
    {
        return; // The application's: equal in both memories from the start.
    }
    std::uint32_t at = 0U;
    for (std::uint32_t pair = 0U; pair < plan.pairs; ++pair)
    {
        if (plan.dummies[pair] == 0U)
        {
            ComparePair(slot, at, plan.lengths[pair]);
            at += BytesOf(plan.lengths[pair]);
        }
    }
    for (; at < Memory::kInverseAt; ++at)
    {
        Same("byte behind the objects in A's memory", slot, a[at], Memory::kFill);
        Same("byte behind the objects in B's memory", slot, Memory::kFill, b[Memory::kInverseAt + at]);
    }
}

/// One object of each side. Bits above the length are 0 once they have been written.
void Differential::ComparePair(SlotIndex slot, std::uint32_t at, std::uint32_t bits) noexcept
{
    const std::uint8_t* const a = &device_.memory_a.bytes[(Memory::kSlotBytes * slot) + at];
    const std::uint8_t* const b = &device_.memory_b.bytes[(Memory::kSlotBytes * slot) + at];
    const bool is_written = (configured_ & (SrdoMask{1U} << slot)) != 0U;
    const std::uint32_t bytes = BytesOf(bits);
    for (std::uint32_t i = 0U; i < bytes; ++i)
    {
        const std::uint32_t mask = ((i + 1U) == bytes) ? LastByteMask(bits) : 0xFFU;
        const std::uint32_t inverse = b[Memory::kInverseAt + i];
        Same("object of A, complement of B's", slot, a[i], is_written ? (mask ^ inverse) : inverse);
        Same("inverse object in A's memory", slot, a[Memory::kInverseAt + i], Memory::kFill);
        Same("normal object in B's memory", slot, Memory::kFill, b[i]);
    }
}

void Differential::CompareOutcomes(const CycleOutcome& a, const CycleOutcome& b) noexcept
{
    Same("released", kNoSlot, a.released, b.released);
    Same("faulted", kNoSlot, a.faulted, b.faulted);
    Same("waiting", kNoSlot, a.waiting, b.waiting);
    Same("new_fault", kNoSlot, a.new_fault, b.new_fault);
    Same("fresh", kNoSlot, a.fresh, b.fresh);
    Same("due", kNoSlot, a.due, b.due);
    Same("signalled", kNoSlot, a.signalled, b.signalled);
    Same("cycle", kNoSlot, a.cycle, b.cycle);
    Same("ordinal_sum", kNoSlot, a.ordinal_sum, b.ordinal_sum);
    Same("guard", kNoSlot, static_cast<std::uint64_t>(a.guard), static_cast<std::uint64_t>(b.guard));
    Same("sct_checked", kNoSlot, a.sct_checked, b.sct_checked);
    Same("is_tx", kNoSlot, a.is_tx, b.is_tx);
    Same("is_invalid", kNoSlot, a.is_invalid, b.is_invalid);
    Same("not_operational", kNoSlot, a.not_operational, b.not_operational);
}

/// What happened to a slot in this OnCycle, for the counts.
void Differential::NoteRecovery(SlotIndex slot, const SrdoView& view) noexcept
{
    if ((view.state == SrdoState::kReleased) && (states_[slot] == SrdoState::kFaulted))
    {
        const bool is_automatic = device_.setups[slot].policy == ReleasePolicy::kAutomatic;
        reached_.Add(is_automatic ? Item::kAutomaticRecovery : Item::kInterlockRecovery);
    }
    if ((view.first_cause == SrdoCause::kNone) && (causes_[slot] != SrdoCause::kNone))
    {
        reached_.Add(Item::kAcknowledgedCause);
    }
    reached_.AddSignals(view.signals, view.state == SrdoState::kProducer);
    const bool is_late = device_.setups[slot].detection == SrvtDetection::kLate;
    if (is_late && (view.state != SrdoState::kProducer))
    {
        reached_.Add(Item::kLateSrvt, (view.signals >> static_cast<std::uint8_t>(SrdoCause::kSrvt)) & 1U);
        reached_.Add(Item::kLateSct, (view.signals >> static_cast<std::uint8_t>(SrdoCause::kSct)) & 1U);
        reached_.Add(Item::kLateReleased, (view.state == SrdoState::kReleased) ? 1U : 0U);
    }
    states_[slot] = view.state;
    causes_[slot] = view.first_cause;
}

DifferentialResult RunDifferential(Differential& run, std::uint32_t seed, std::uint32_t first, std::uint32_t count,
                                   std::uint32_t most_failures) noexcept
{
    for (std::uint32_t i = 0U; (i < count) && (run.Result().failures < most_failures); ++i)
    {
        static_cast<void>(run.RunSequence(seed, first + i));
    }
    return run.Result();
}

} // namespace counterpoint::differential
