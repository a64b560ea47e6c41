// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/differential/device.hpp"

namespace counterpoint::differential
{

namespace
{
constexpr std::uint16_t kNormalIndex = 0x2000U;
constexpr std::uint16_t kInverseIndex = 0x3000U;
constexpr std::uint16_t kUnmappableIndex = 0x4000U;
constexpr std::uint8_t kManySlots = 32U;

std::uint32_t EntryOf(std::uint16_t index, SlotIndex slot, std::uint8_t sub, std::uint8_t bytes) noexcept
{
    return (static_cast<std::uint32_t>(index + slot) << 16U) | (static_cast<std::uint32_t>(sub) << 8U) |
           (8U * static_cast<std::uint32_t>(bytes));
}

/// One or two SRDOs as a rule, sometimes some, now and then all.
std::uint8_t CountOfSlots(Random& random) noexcept
{
    const std::uint32_t kind = random.Below(100U);
    if (kind < 40U)
    {
        return 1U;
    }
    if (kind < 65U)
    {
        return 2U;
    }
    if (kind < 93U)
    {
        return static_cast<std::uint8_t>(random.Between(3U, 8U));
    }
    return (kind < 98U) ? static_cast<std::uint8_t>(random.Between(9U, 63U)) : kMaxSrdoCount;
}
} // namespace

void Memory::Fill() noexcept
{
    for (std::uint8_t& byte : bytes)
    {
        byte = kFill;
    }
}

void Device::Make(Random& random) noexcept
{
    count_ = CountOfSlots(random);
    config_a = DeviceConfig{};
    config_a.srdos = setups;
    config_a.srdo_count = count_;
    MakeTimes(random);
    const std::uint32_t first_pair = random.Below(kMaxSrdoCount);
    std::uint32_t number = 0U;
    for (SlotIndex slot = 0U; slot < count_; ++slot)
    {
        MakeSlot(random, slot, (first_pair + (5U * slot)) % kMaxSrdoCount);
        MakeSetup(random, slot, number);
    }
    for (SlotIndex slot = 0U; slot < count_; ++slot)
    {
        Spoil(random, slot);
    }
    config_b = config_a;
    MakeObjects(memory_a);
    MakeObjects(memory_b);
    config_a.objects = memory_a.objects;
    config_b.objects = memory_b.objects;
    config_a.object_count = object_count_;
    config_b.object_count = object_count_;
    gfc_parameter = random.Chance(700U) ? 1U : 0U;
}

void Device::MakeTimes(Random& random) noexcept
{
    static constexpr std::uint32_t kCycles[] = {500U, 1000U, 2000U, 2500U, 10000U, 20000U, 100000U, 1000000U};
    static constexpr std::uint8_t kGranularities[] = {8U, 8U, 8U, 16U, 32U, 64U};
    static constexpr std::uint32_t kWindows[] = {0U, 500U, 3000U, 20000U, 100000U};
    config_a.cycle_us = kCycles[random.Below(8U)];
    config_a.cycle_tolerance_us = random.Chance(300U) ? config_a.cycle_us : random.Below(config_a.cycle_us);
    config_a.granularity_bits = kGranularities[random.Below(6U)];
    config_a.acknowledge_window_us = kWindows[random.Below(5U)];
    config_a.node_id =
        static_cast<std::uint8_t>(random.Chance(800U) ? random.Between(1U, 6U) : random.Between(1U, 127U));
    config_a.normal_port = CanPortId::kFirst;
    config_a.inverse_port = random.Chance(250U) ? CanPortId::kSecond : CanPortId::kFirst;
    config_a.discrepancy_us = 10000U;
    config_a.diagnostic_interval_us = 1000000U;
    config_a.test_interval_us = 1000000U;
    config_a.clock_tolerance_us = 1000U;
    config_a.clock_interval_us = 1000000U;
    config_a.output_time_us = 1000U;
}

void Device::MakeLengths(Random& random, SlotPlan& plan) noexcept
{
    const std::uint32_t unit = config_a.granularity_bits / 8U;
    const std::uint32_t most = (plan.flaw == Flaw::kLengthExceeded) ? 16U : 8U;
    const std::uint32_t most_pairs = (count_ > kManySlots) ? 4U : 8U;
    const std::uint32_t wanted = (plan.flaw == Flaw::kLengthExceeded) ? most_pairs : random.Between(1U, most_pairs);
    plan.pairs = 0U;
    plan.bytes = 0U;
    while ((plan.pairs < wanted) && ((plan.bytes + unit) <= most))
    {
        const std::uint32_t room = (most - plan.bytes) / unit;
        const std::uint32_t room_of_object = (8U / unit);
        std::uint32_t units = random.Between(1U, (room < room_of_object) ? room : room_of_object);
        units = random.Chance(500U) ? 1U : units;
        const std::uint8_t bytes = static_cast<std::uint8_t>(units * unit);
        plan.lengths[plan.pairs] = bytes;
        plan.bytes = static_cast<std::uint8_t>(plan.bytes + bytes);
        ++plan.pairs;
    }
}

void Device::MakeEntries(SlotIndex slot) noexcept
{
    SlotPlan& plan = plans[slot];
    plan.map_count = static_cast<std::uint8_t>(2U * plan.pairs);
    for (std::uint32_t& entry : plan.entries)
    {
        entry = 0U;
    }
    for (std::uint8_t pair = 0U; pair < plan.pairs; ++pair)
    {
        const std::uint8_t sub = static_cast<std::uint8_t>(pair + 1U);
        plan.entries[2U * pair] = EntryOf(kNormalIndex, slot, sub, plan.lengths[pair]);
        plan.entries[(2U * pair) + 1U] = EntryOf(kInverseIndex, slot, sub, plan.lengths[pair]);
    }
}

void Device::MakeSlot(Random& random, SlotIndex slot, std::uint32_t pair_of_identifiers) noexcept
{
    static constexpr std::uint16_t kScts[] = {2U, 3U, 5U, 10U, 20U, 50U};
    SlotPlan& plan = plans[slot];
    const std::uint32_t kind = random.Below(100U);
    plan.direction = (kind < 62U) ? kDirectionConsumer : ((kind < 93U) ? kDirectionProducer : kDirectionOff);
    plan.flaw =
        random.Chance(120U) ? static_cast<Flaw>(random.Below(static_cast<std::uint32_t>(Flaw::kNone))) : Flaw::kNone;
    plan.sct_ms = random.Chance(20U) ? std::uint16_t{65535U} : kScts[random.Below(6U)];
    plan.srvt_ms = static_cast<std::uint8_t>((plan.sct_ms > 255U) ? 255U : random.Between(1U, plan.sct_ms - 1U));
    if (plan.direction == kDirectionProducer)
    {
        const std::uint32_t least = (config_a.cycle_us + 999U) / kMicrosecondsPerMillisecond;
        plan.sct_ms = static_cast<std::uint16_t>(random.Chance(20U) ? 65535U : (least + random.Below(12U)));
        plan.srvt_ms = static_cast<std::uint8_t>(random.Below(8U));
    }
    plan.transmission_type = kTransmissionTypeAsynchronous;
    plan.cob_id_1 = kFirstSrdoIdentifier + (2U * pair_of_identifiers);
    plan.cob_id_2 = plan.cob_id_1 + 1U;
    MakeLengths(random, plan);
    MakeEntries(slot);
}

void Device::MakeSetup(Random& random, SlotIndex slot, std::uint32_t& number) noexcept
{
    const std::uint32_t room = (kMaxSrdoCount - number) - (count_ - slot);
    number += 1U + (random.Chance(300U) ? random.Below(room + 1U) : 0U);
    SrdoSetup& setup = setups[slot];
    setup.number = static_cast<std::uint8_t>(number);
    setup.policy = random.Chance(550U) ? ReleasePolicy::kAutomatic : ReleasePolicy::kInterlock;
    if (random.Chance(30U))
    {
        setup.policy = static_cast<ReleasePolicy>(random.Between(1U, 0x59U));
    }
    setup.form = random.Chance(500U) ? ProducerForm::kProviderCalled : ProducerForm::kApplicationSends;
    const std::uint32_t bytes = plans[slot].bytes;
    const std::uint32_t low = (bytes >= 4U) ? 0xFFFFFFFFU : ((1U << (8U * bytes)) - 1U);
    const std::uint32_t high = (bytes >= 8U) ? 0xFFFFFFFFU : ((bytes <= 4U) ? 0U : ((1U << (8U * (bytes - 4U))) - 1U));
    setup.safe_value = Payload{random.Next() & low, random.Next() & high};
}

void Device::AddObjects(Memory& memory, std::uint16_t first_index, std::uint32_t offset) noexcept
{
    for (SlotIndex slot = 0U; slot < count_; ++slot)
    {
        const SlotPlan& plan = plans[slot];
        // The access is that of a sound direction, so that Flaw::kDirection stays the only flaw of its SRDO.
        const MapAccess access = (plan.direction == kDirectionProducer) ? MapAccess::kProducer : MapAccess::kConsumer;
        std::uint32_t at = (Memory::kSlotBytes * slot) + offset;
        for (std::uint8_t pair = 0U; pair < plan.pairs; ++pair)
        {
            memory.objects[object_count_] =
                MappableObject{static_cast<std::uint16_t>(first_index + slot), static_cast<std::uint8_t>(pair + 1U),
                               static_cast<std::uint8_t>(8U * plan.lengths[pair]), access, &memory.bytes[at]};
            at += plan.lengths[pair];
            ++object_count_;
        }
    }
}

void Device::MakeObjects(Memory& memory) noexcept
{
    memory.Fill();
    object_count_ = 0U;
    AddObjects(memory, kNormalIndex, 0U);
    AddObjects(memory, kInverseIndex, Memory::kInverseAt);
    if (object_count_ < 1024U)
    {
        memory.objects[object_count_] = MappableObject{kUnmappableIndex, 0U, 8U, MapAccess::kNone, memory.spare};
        ++object_count_;
    }
}

// ---- flaws

void Device::Spoil(Random& random, SlotIndex slot) noexcept
{
    SlotPlan& plan = plans[slot];
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
        const SlotPlan& other = plans[random.Below(count_)];
        plan.cob_id_1 = other.cob_id_1;
        plan.cob_id_2 = other.cob_id_2;
        break;
    }
    case Flaw::kTiming:
        SpoilTiming(random, plan);
        break;
    case Flaw::kMapCount:
        plan.map_count = static_cast<std::uint8_t>(random.Chance(500U) ? random.Below(18U) : random.Below(256U));
        break;
    case Flaw::kEntry:
        SpoilEntry(random, slot);
        break;
    case Flaw::kLengthExceeded:
    case Flaw::kSignature:
    case Flaw::kNeverValidated:
    case Flaw::kNone:
        break;
    }
}

void Device::SpoilIdentifier(Random& random, SlotPlan& plan) noexcept
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

void Device::SpoilTiming(Random& random, SlotPlan& plan) noexcept
{
    if (plan.direction == kDirectionProducer)
    {
        const std::uint32_t cycle_ms = config_a.cycle_us / kMicrosecondsPerMillisecond;
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

void Device::SpoilEntry(Random& random, SlotIndex slot) noexcept
{
    SlotPlan& plan = plans[slot];
    const std::uint32_t at = random.Below(plan.map_count);
    const SlotIndex other = static_cast<SlotIndex>(random.Below(count_));
    switch (random.Below(7U))
    {
    case 0U:
        plan.entries[at] ^= 1U << random.Below(32U);
        break;
    case 1U:
        plan.entries[at] = plan.entries[random.Below(plan.map_count)];
        break;
    case 2U:
        plan.entries[at] = plans[other].entries[random.Below(2U)];
        break;
    case 3U:
        plan.entries[at] = (static_cast<std::uint32_t>(kUnmappableIndex) << 16U) | 8U;
        break;
    case 4U:
        plan.entries[at] = random.Next();
        break;
    case 5U:
        plan.entries[at] += 8U;
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

} // namespace counterpoint::differential
