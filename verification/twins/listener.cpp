// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/twins/listener.hpp"

#include <cstring>

namespace counterpoint::twins
{

using differential::Memory;

namespace
{
/// Modulo 2^32, of an odd number: what takes the party's constant out of a permit.
constexpr std::uint32_t Reciprocal(std::uint32_t odd) noexcept
{
    std::uint32_t found = odd;
    for (std::uint32_t step = 0U; step < 5U; ++step)
    {
        found *= 2U - (odd * found);
    }
    return found;
}
static_assert((Reciprocal(kPermitConstantA) * kPermitConstantA) == 1U, "a reciprocal");
} // namespace

First::First(Channel& subject, Side side, Answers& answers, Trace& trace) noexcept
    : Voice{subject}, side_{side}, answers_{answers}, trace_{trace}
{
}

Memory& First::Objects() const noexcept
{
    return (side_ == Side::kNormal) ? device_->memory_a : device_->memory_b;
}

void First::MarkBits(SlotIndex slot) noexcept
{
    const differential::SlotPlan& plan = device_->plans[slot];
    std::uint32_t at = Memory::kSlotBytes * slot;
    for (std::uint32_t pair = 0U; pair < plan.pairs; ++pair)
    {
        const std::uint32_t bytes = (plan.dummies[pair] == 0U) ? differential::BytesOf(plan.lengths[pair]) : 0U;
        for (std::uint32_t i = 0U; i < bytes; ++i)
        {
            const std::uint8_t mask =
                ((i + 1U) == bytes) ? differential::LastByteMask(plan.lengths[pair]) : std::uint8_t{0xFFU};
            inverted_[at] = mask;
            inverted_[at + Memory::kInverseAt] = mask;
            ++at;
        }
    }
}

/// What a subject of the inverse side finds in its objects is the complement of what one of the normal side finds.
void First::Restart(const DeviceConfig& config) noexcept
{
    std::memset(inverted_, 0, sizeof(inverted_));
    if (side_ == Side::kInverse)
    {
        for (SlotIndex slot = 0U; slot < device_->config_a.srdo_count; ++slot)
        {
            MarkBits(slot);
        }
        for (std::uint32_t at = 0U; at < kBytes; ++at)
        {
            Objects().bytes[at] = static_cast<std::uint8_t>(Objects().bytes[at] ^ inverted_[at]);
        }
    }
    Subject().Restart((side_ == Side::kNormal) ? config : device_->config_b);
}

ConfigItem First::Load(const ConfigAddress& address) const noexcept
{
    const ConfigItem item = Subject().Load(address);
    trace_.Add((static_cast<std::uint64_t>(item.address.slot) << 48U) |
               (static_cast<std::uint64_t>(item.address.field) << 40U) |
               (static_cast<std::uint64_t>(item.address.sub) << 32U) | item.value);
    return item;
}

void First::SetFields(SlotIndex slot, const StaticFields& fields) noexcept
{
    if (side_ == Side::kNormal)
    {
        Subject().SetFields(slot, fields);
    }
}

DeviceDigest First::Digest(SlotIndex slot, DeviceDigest before) const noexcept
{
    const DeviceDigest digest = Subject().Digest(slot, before);
    trace_.Add(digest.value);
    return digest;
}

CheckResult First::Validate(SlotIndex slot) noexcept
{
    LookBefore();
    answers_.checked = Subject().Validate(slot);
    LookAfter();
    trace_.Add(answers_.checked);
    return answers_.checked;
}

CheckResult First::Recheck(SlotIndex slot) noexcept
{
    answers_.checked = Subject().Recheck(slot);
    trace_.Add(answers_.checked);
    return answers_.checked;
}

CycleOutcome First::OnCycle(const CycleInput& input) noexcept
{
    LookBefore();
    answers_.outcome = Subject().OnCycle(input);
    LookAfter();
    trace_.Add(answers_.outcome);
    return answers_.outcome;
}

HeldPair First::Held(SlotIndex slot) const noexcept
{
    const HeldPair held = Subject().Held(slot);
    trace_.Add(held);
    return held;
}

SrdoView First::View(SlotIndex slot) const noexcept
{
    const SrdoView view = Subject().View(slot);
    trace_.Add(view);
    return view;
}

SrdoMask First::Commit(const Agreement& agreement, SrdoMask examine) noexcept
{
    LookBefore();
    answers_.found = Subject().Commit(agreement, examine);
    trace_.Add(answers_.found);
    LookAfter();
    return answers_.found;
}

Permit First::Answer(std::uint32_t challenge) const noexcept
{
    const Permit permit = Subject().Answer(challenge);
    trace_.Add(permit.mask);
    trace_.Add(permit.response * Reciprocal((side_ == Side::kNormal) ? kPermitConstantA : kPermitConstantB));
    return permit;
}

/// The run spoils an object of one side now and then. Alone there is one side, and both kinds of subjects read the
/// same.
PreparedPair First::Prepare(SlotIndex slot) noexcept
{
    std::uint8_t* const first = &Objects().bytes[Memory::kSlotBytes * slot];
    for (std::uint32_t i = 0U; (side_ == Side::kInverse) && (i < Memory::kInverseAt); ++i)
    {
        first[Memory::kInverseAt + i] =
            static_cast<std::uint8_t>(first[i] ^ inverted_[(Memory::kSlotBytes * slot) + i]);
    }
    LookBefore();
    answers_.prepared = Subject().Prepare(slot);
    LookAfter();
    trace_.Add(static_cast<std::uint64_t>(answers_.prepared.status));
    trace_.Add(answers_.prepared.normal);
    return answers_.prepared;
}

Confirmation First::OnConfirm(const CanFrame& frame, Instant stamp) noexcept
{
    answers_.confirmation = Subject().OnConfirm(frame, stamp);
    trace_.Add((static_cast<std::uint64_t>(answers_.confirmation.step) << 8U) | answers_.confirmation.slot);
    return answers_.confirmation;
}

CanFrame First::InverseFrame(SlotIndex slot) const noexcept
{
    const CanFrame frame = Subject().InverseFrame(slot);
    trace_.Add(frame);
    return frame;
}

void First::LookBefore() noexcept
{
    std::memcpy(before_, Objects().bytes, Memory::kSlotBytes * device_->config_a.srdo_count);
}

/// Each byte that was written: where, the subject's own side first, and what.
void First::LookAfter() noexcept
{
    const std::uint8_t* const now = Objects().bytes;
    const std::uint32_t bytes = Memory::kSlotBytes * device_->config_a.srdo_count;
    const std::uint32_t own = (side_ == Side::kNormal) ? 0U : Memory::kInverseAt;
    if (std::memcmp(before_, now, bytes) == 0)
    {
        return;
    }
    for (std::uint32_t place = 0U; place < bytes; ++place)
    {
        const std::uint32_t at = place ^ own;
        if (before_[at] != now[at])
        {
            trace_.Add((static_cast<std::uint64_t>(place) << 8U) | static_cast<std::uint64_t>(now[at] ^ inverted_[at]));
        }
    }
    trace_.Add(bytes);
}

void Second::Restart(const DeviceConfig& /*config*/) noexcept
{
}

void Second::Store(const ConfigItem& /*item*/) noexcept
{
}

void Second::SetFields(SlotIndex slot, const StaticFields& fields) noexcept
{
    if (side_ == Side::kInverse)
    {
        Subject().SetFields(slot, fields);
    }
}

CheckResult Second::Validate(SlotIndex /*slot*/) noexcept
{
    return answers_.checked;
}

CheckResult Second::Recheck(SlotIndex /*slot*/) noexcept
{
    return answers_.checked;
}

void Second::OnFrame(const CanFrame& /*frame*/, Instant /*stamp*/) noexcept
{
}

CycleOutcome Second::OnCycle(const CycleInput& /*input*/) noexcept
{
    return answers_.outcome;
}

void Second::Demote(SlotIndex /*slot*/) noexcept
{
}

SrdoMask Second::Commit(const Agreement& /*agreement*/, SrdoMask /*examine*/) noexcept
{
    return answers_.found;
}

PreparedPair Second::Prepare(SlotIndex /*slot*/) noexcept
{
    return answers_.prepared;
}

Confirmation Second::OnConfirm(const CanFrame& /*frame*/, Instant /*stamp*/) noexcept
{
    return answers_.confirmation;
}

void Second::OnTransmitFault(SlotIndex /*slot*/, const TransmitFault& /*fault*/) noexcept
{
}

} // namespace counterpoint::twins
