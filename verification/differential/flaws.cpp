// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/differential/flaws.hpp"

namespace counterpoint::differential
{
namespace
{

void SpoilIdentifier(Random& random, SlotPlan& plan) noexcept
{
    switch (random.Below(6U))
    {
    case 0U:
        plan.cob_id_1 += 1U;
        plan.cob_id_2 += 1U;
        break;
    case 1U:
        plan.cob_id_2 = random.Chance(500U) ? (plan.cob_id_1 - 1U) : random.Between(0x100U, 0x181U);
        break;
    case 2U:
        plan.cob_id_1 = random.Chance(500U) ? 0xFFU : 0x181U;
        plan.cob_id_2 = plan.cob_id_1 + 1U;
        break;
    case 3U:
        plan.cob_id_1 |= 1U << random.Between(9U, 31U);
        plan.cob_id_2 = plan.cob_id_1 + 1U;
        break;
    case 4U:
        plan.cob_id_2 |= 1U << random.Between(9U, 31U);
        break;
    default:
        plan.cob_id_1 = random.Next();
        plan.cob_id_2 = random.Next();
        break;
    }
}

void SpoilTiming(Random& random, SlotPlan& plan, std::uint32_t cycle_us) noexcept
{
    if (plan.direction == kDirectionProducer)
    {
        const std::uint32_t cycle_ms = cycle_us / kMicrosecondsPerMillisecond;
        plan.sct_ms = static_cast<std::uint16_t>(random.Below(cycle_ms + 1U));
    }
    else if (random.Chance(500U))
    {
        plan.srvt_ms = 0U;
    }
    else
    {
        plan.sct_ms = static_cast<std::uint16_t>(plan.srvt_ms - random.Below(2U));
    }
}

void SpoilEntry(Random& random, Device& device, SlotIndex slot) noexcept
{
    SlotPlan& plan = device.plans[slot];
    const std::uint32_t at = random.Chance(500U) ? random.Below(plan.map_count) : (plan.map_count - 1U);
    const SlotIndex other = static_cast<SlotIndex>(random.Below(device.config_a.srdo_count));
    switch (random.Below(7U))
    {
    case 0U:
        plan.entries[at] ^= 1U << random.Below(32U);
        break;
    case 1U:
        plan.entries[at] = plan.entries[random.Below(plan.map_count)];
        break;
    case 2U:
        plan.entries[at] = device.plans[other].entries[random.Below(2U)];
        break;
    case 3U:
        plan.entries[at] = (static_cast<std::uint32_t>(Device::kUnmappableIndex) << 16U) | 8U;
        break;
    case 4U:
        plan.entries[at] = random.Next();
        break;
    case 5U:
        plan.entries[at] += random.Chance(500U) ? 8U : 1U;
        break;
    default:
    {
        const std::uint32_t swapped = plan.entries[at];
        plan.entries[at] = plan.entries[0];
        plan.entries[0] = swapped;
        break;
    }
    }
}

/// Of a consumer and of a producer, in a device with dummies or without: half a pair, another sub-index, length or
/// type.
void SpoilDummy(Random& random, SlotPlan& plan) noexcept
{
    static constexpr std::uint32_t kOthers[] = {0x00050008U, 0x00010001U, 0x00040020U, 0x00020008U, 0x00050108U,
                                                0x00080008U, 0x00030008U, 0x00000008U, 0x00060010U, 0x00070020U};
    const std::uint32_t at = random.Below(plan.map_count);
    plan.entries[at] = kOthers[random.Below(10U)];
    if (random.Chance(400U))
    {
        plan.entries[at ^ 1U] = plan.entries[at];
    }
}

/// Whole, so that it breaks no other rule: a lower slot that shares is sound, and the higher one is to be refused.
void SpoilShared(Random& random, Device& device, SlotIndex slot) noexcept
{
    SlotPlan& plan = device.plans[slot];
    const SlotPlan& other = device.plans[random.Below(device.config_a.srdo_count)];
    for (std::uint32_t i = 0U; i < kMostEntries; ++i)
    {
        plan.entries[i] = other.entries[i];
    }
    for (std::uint32_t i = 0U; i < kMostPairs; ++i)
    {
        plan.lengths[i] = other.lengths[i];
        plan.dummies[i] = other.dummies[i];
    }
    plan.map_count = other.map_count;
    plan.pairs = other.pairs;
    plan.bits = other.bits;
}

} // namespace

void Spoil(Random& random, Device& device, SlotIndex slot) noexcept
{
    SlotPlan& plan = device.plans[slot];
    switch (plan.flaw)
    {
    case Flaw::kDirection:
        plan.direction = static_cast<std::uint8_t>(random.Between(3U, 255U));
        break;
    case Flaw::kTransmissionType:
        plan.transmission_type = static_cast<std::uint8_t>(random.Chance(500U) ? 255U : random.Below(254U));
        break;
    case Flaw::kIdentifier:
        SpoilIdentifier(random, plan);
        break;
    case Flaw::kIdentifierInUse:
    {
        const SlotPlan& other = device.plans[random.Below(device.config_a.srdo_count)];
        plan.cob_id_1 = other.cob_id_1;
        plan.cob_id_2 = other.cob_id_2;
        break;
    }
    case Flaw::kTiming:
        SpoilTiming(random, plan, device.config_a.cycle_us);
        break;
    case Flaw::kMapCount:
        plan.map_count =
            static_cast<std::uint8_t>(random.Chance(500U) ? random.Below(plan.map_count + 3U) : random.Below(256U));
        break;
    case Flaw::kEntry:
        SpoilEntry(random, device, slot);
        break;
    case Flaw::kDummy:
        SpoilDummy(random, plan);
        break;
    case Flaw::kShared:
        SpoilShared(random, device, slot);
        break;
    case Flaw::kFields: // What StoreSlot registers.
    case Flaw::kLengthExceeded:
    case Flaw::kSignature:
    case Flaw::kNeverValidated:
    case Flaw::kNone:
        break;
    }
}

} // namespace counterpoint::differential
