// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/differential/comparison.hpp"

namespace counterpoint::differential
{

void Comparison::Begin(std::uint32_t seed, std::uint32_t sequence) noexcept
{
    seed_ = seed;
    sequence_ = sequence;
    step_ = 0U;
    differs_ = false;
}

void Comparison::Step(const char* name, SlotIndex slot, std::uint64_t x, std::uint64_t y, std::uint64_t z) noexcept
{
    ++step_;
    if (is_told_)
    {
        observer_.OnStep(StepRecord{name, step_, slot, x, y, z});
    }
}

void Comparison::Same(const char* field, SlotIndex slot, std::uint64_t a, std::uint64_t b) noexcept
{
    hash_.AddMask(a);
    if ((a != b) && (!differs_) && (!is_ignored_))
    {
        differs_ = true;
        observer_.OnDifference(Difference{field, a, b, seed_, sequence_, step_, slot});
    }
}

void Comparison::View(SlotIndex slot) noexcept
{
    const SrdoView a = scene_.a.View(slot);
    const SrdoView b = scene_.b.View(slot);
    Same("state", slot, static_cast<std::uint64_t>(a.state), static_cast<std::uint64_t>(b.state));
    Same("first_cause", slot, static_cast<std::uint64_t>(a.first_cause), static_cast<std::uint64_t>(b.first_cause));
    Same("ordinal", slot, a.ordinal, b.ordinal);
    Same("holds_pair", slot, a.holds_pair, b.holds_pair);
    Same("signals", slot, a.signals, b.signals);
    Same("error_count", slot, a.error_count, b.error_count);
    Same("data, bytes 0 to 3", slot, a.data.low, b.data.low);
    Same("data, bytes 4 to 7", slot, a.data.high, b.data.high);
    scene_.reached.AddState(a.state);
    if ((a.first_cause == SrdoCause::kDemoted) && (a.state == SrdoState::kFaulted))
    {
        scene_.reached.Add(Item::kCauseDemoted);
    }
}

void Comparison::Held(SlotIndex slot) noexcept
{
    const HeldPair a = scene_.a.Held(slot);
    const HeldPair b = scene_.b.Held(slot);
    Same("held data, bytes 0 to 3", slot, a.data.low, b.data.low);
    Same("held data, bytes 4 to 7", slot, a.data.high, b.data.high);
    Same("held ordinal", slot, a.ordinal, b.ordinal);
    Same("holds_pair of Held", slot, a.holds_pair, b.holds_pair);
    scene_.reached.Add(Item::kHeldPair, (a.holds_pair == 1U) ? 1U : 0U);
}

void Comparison::Slot(SlotIndex slot) noexcept
{
    View(slot);
    Held(slot);
}

/// Every byte, those behind the length too.
void Comparison::Frames(SlotIndex slot, const CanFrame& a, const CanFrame& b) noexcept
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

void Comparison::AllSlots() noexcept
{
    for (SlotIndex slot = 0U; slot < scene_.device.config_a.srdo_count; ++slot)
    {
        Slot(slot);
    }
}

/// A's normal objects and B's inverse objects are complements; each leaves the other's alone.
void Comparison::Objects(SlotIndex slot) noexcept
{
    const std::uint8_t* const a = &scene_.device.memory_a.bytes[Memory::kSlotBytes * slot];
    const std::uint8_t* const b = &scene_.device.memory_b.bytes[Memory::kSlotBytes * slot];
    const SlotPlan& plan = scene_.device.plans[slot];
    if ((plan.direction == kDirectionProducer) || scene_.has_odd_mapping)
    {
        return; // The application's: equal in both memories from the start.
    }
    std::uint32_t at = 0U;
    for (std::uint32_t pair = 0U; pair < plan.pairs; ++pair)
    {
        if (plan.dummies[pair] == 0U)
        {
            Pair(slot, at, plan.lengths[pair]);
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
void Comparison::Pair(SlotIndex slot, std::uint32_t at, std::uint32_t bits) noexcept
{
    const std::uint8_t* const a = &scene_.device.memory_a.bytes[(Memory::kSlotBytes * slot) + at];
    const std::uint8_t* const b = &scene_.device.memory_b.bytes[(Memory::kSlotBytes * slot) + at];
    const bool is_written = (scene_.configured & (SrdoMask{1U} << slot)) != 0U;
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

void Comparison::Outcomes(const CycleOutcome& a, const CycleOutcome& b) noexcept
{
    Same("released", kNoSlot, a.released, b.released);
    Same("faulted", kNoSlot, a.faulted, b.faulted);
    Same("waiting", kNoSlot, a.waiting, b.waiting);
    Same("new_fault", kNoSlot, a.new_fault, b.new_fault);
    Same("fresh", kNoSlot, a.fresh, b.fresh);
    Same("due", kNoSlot, a.due, b.due);
    Same("refresh", kNoSlot, a.refresh, b.refresh);
    Same("signalled", kNoSlot, a.signalled, b.signalled);
    Same("cycle", kNoSlot, a.cycle, b.cycle);
    Same("ordinal_sum", kNoSlot, a.ordinal_sum, b.ordinal_sum);
    Same("guard", kNoSlot, static_cast<std::uint64_t>(a.guard), static_cast<std::uint64_t>(b.guard));
    Same("sct_checked", kNoSlot, a.sct_checked, b.sct_checked);
    Same("is_tx", kNoSlot, a.is_tx, b.is_tx);
    Same("is_invalid", kNoSlot, a.is_invalid, b.is_invalid);
    Same("not_operational", kNoSlot, a.not_operational, b.not_operational);
}

} // namespace counterpoint::differential
