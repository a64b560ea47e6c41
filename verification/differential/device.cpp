// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/differential/device.hpp"

#include "verification/differential/flaws.hpp"

namespace counterpoint::differential
{

namespace
{
constexpr std::uint16_t kNormalIndex = 0x2000U;
constexpr std::uint16_t kInverseIndex = 0x3000U;
constexpr std::uint8_t kManySlots = 32U;

constexpr std::uint32_t kManyObjects = 1000U;

std::uint32_t EntryOf(std::uint16_t index, SlotIndex slot, std::uint8_t sub, std::uint8_t bits) noexcept
{
    return (static_cast<std::uint32_t>(index + slot) << 16U) | (static_cast<std::uint32_t>(sub) << 8U) | bits;
}

/// A data type of this length that may stand for an object; 0 if there is none.
std::uint8_t DummyOf(Random& random, std::uint32_t bits) noexcept
{
    const bool is_other = random.Chance(500U);
    switch (bits)
    {
    case 1U:
        return 1U;
    case 8U:
        return is_other ? std::uint8_t{2U} : std::uint8_t{5U};
    case 16U:
        return is_other ? std::uint8_t{3U} : std::uint8_t{6U};
    case 32U:
        return is_other ? std::uint8_t{4U} : std::uint8_t{7U};
    default:
        return 0U;
    }
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

Payload Memory::Read(SlotIndex slot, const SlotPlan& plan, bool is_inverse) const noexcept
{
    Payload value{0U, 0U};
    std::uint32_t from = (kSlotBytes * slot) + (is_inverse ? kInverseAt : 0U);
    std::uint32_t to = 0U;
    for (std::uint32_t pair = 0U; pair < plan.pairs; ++pair)
    {
        for (std::uint32_t bit = 0U; bit < plan.lengths[pair]; ++bit)
        {
            const std::uint32_t one = (static_cast<std::uint32_t>(bytes[from + (bit / 8U)]) >> (bit % 8U)) & 1U;
            std::uint32_t& half = (to < 32U) ? value.low : value.high;
            half |= one << (to % 32U);
            ++to;
        }
        from += BytesOf(plan.lengths[pair]);
    }
    return value;
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
        Spoil(random, *this, slot);
        FixMapping(slot);
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
    static constexpr std::uint8_t kGranularities[] = {1U, 1U, 1U, 8U, 8U, 8U, 16U, 32U, 64U};
    static constexpr std::uint8_t kEntries[] = {16U, 16U, 16U, 128U, 8U};
    static constexpr std::uint32_t kWindows[] = {0U, 500U, 3000U, 20000U, 100000U};
    config_a.cycle_us = kCycles[random.Below(8U)];
    config_a.cycle_tolerance_us = random.Chance(300U) ? config_a.cycle_us : random.Below(config_a.cycle_us);
    config_a.granularity_bits = kGranularities[random.Below(9U)];
    config_a.map_entries = kEntries[random.Below(5U)];
    config_a.dummies = random.Chance(350U) ? DummyMapping::kAllowed : DummyMapping::kRefused;
    if (random.Chance(20U))
    {
        config_a.dummies = static_cast<DummyMapping>(random.Below(256U));
    }
    config_a.gaps = random.Chance(500U) ? NumberGaps::kSearched : NumberGaps::kRefused;
    config_a.gfc = random.Chance(500U) ? GfcUse::kPresent : GfcUse::kRemoved;
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

/// Static or not; a static mapping has whole bytes and no dummies.
void Device::MakeKind(Random& random, SlotPlan& plan) noexcept
{
    plan.is_static = random.Chance(150U);
    const bool is_consumer = plan.direction == kDirectionConsumer;
    plan.has_dummies =
        is_consumer && (!plan.is_static) && (config_a.dummies == DummyMapping::kAllowed) && random.Chance(500U);
}

/// Now and then as many entries as there is room for, else a few.
std::uint32_t Device::MostPairs(Random& random, const SlotPlan& plan) const noexcept
{
    const std::uint32_t room = plan.is_static ? kMostPairs : (config_a.map_entries / 2U);
    const std::uint32_t share = kManyObjects / (2U * static_cast<std::uint32_t>(count_));
    const std::uint32_t most = (room < share) ? room : share;
    const std::uint32_t usual = (count_ > kManySlots) ? 4U : 8U;
    const bool is_big = (config_a.granularity_bits == 1U) && random.Chance(60U);
    return (is_big || (most < usual)) ? most : usual;
}

void Device::AddPair(Random& random, SlotPlan& plan, std::uint32_t bits) noexcept
{
    plan.lengths[plan.pairs] = static_cast<std::uint8_t>(bits);
    plan.dummies[plan.pairs] = (plan.has_dummies && random.Chance(300U)) ? DummyOf(random, bits) : std::uint8_t{0U};
    plan.bits = static_cast<std::uint8_t>(plan.bits + bits);
    ++plan.pairs;
}

void Device::MakeLengths(Random& random, SlotPlan& plan) noexcept
{
    static constexpr std::uint8_t kBitLengths[] = {1U, 1U, 1U,  2U,  3U,  5U,  7U,  8U,
                                                   8U, 9U, 12U, 16U, 31U, 32U, 33U, 63U};
    const bool is_fine = (config_a.granularity_bits == 1U) && (!plan.is_static);
    const std::uint32_t unit = is_fine ? 1U : ((config_a.granularity_bits < 8U) ? 8U : config_a.granularity_bits);
    const std::uint32_t most = (plan.flaw == Flaw::kLengthExceeded) ? 128U : kMaxPayloadBits;
    const std::uint32_t most_pairs = MostPairs(random, plan);
    const bool is_full = (plan.flaw == Flaw::kLengthExceeded) || (most_pairs > 8U);
    const std::uint32_t wanted = is_full ? most_pairs : random.Between(1U, most_pairs);
    plan.pairs = 0U;
    plan.bits = 0U;
    while ((plan.pairs < wanted) && ((plan.bits + unit) <= most))
    {
        const std::uint32_t room = (most - plan.bits) / unit;
        const std::uint32_t room_of_object = kMaxPayloadBits / unit;
        std::uint32_t units = random.Between(1U, (room < room_of_object) ? room : room_of_object);
        units = random.Chance(500U) ? 1U : units;
        if (is_fine)
        {
            const std::uint32_t bits = kBitLengths[random.Below(16U)];
            units = ((most_pairs > 8U) || (bits > room)) ? 1U : bits;
        }
        AddPair(random, plan, units * unit);
    }
}

void Device::MakeEntries(SlotIndex slot) noexcept
{
    SlotPlan& plan = plans[slot];
    plan.map_count = static_cast<std::uint8_t>(2U * plan.pairs);
    for (std::uint8_t pair = 0U; pair < plan.pairs; ++pair)
    {
        const std::uint8_t sub = static_cast<std::uint8_t>(pair + 1U);
        plan.entries[2U * pair] = EntryOf(kNormalIndex, slot, sub, plan.lengths[pair]);
        plan.entries[(2U * pair) + 1U] = EntryOf(kInverseIndex, slot, sub, plan.lengths[pair]);
        if (plan.dummies[pair] != 0U)
        {
            plan.entries[2U * pair] = EntryOf(plan.dummies[pair], 0U, 0U, plan.lengths[pair]);
            plan.entries[(2U * pair) + 1U] = plan.entries[2U * pair];
        }
    }
    for (std::uint32_t entry = plan.map_count; entry < kMostEntries; ++entry)
    {
        plan.entries[entry] = 0U;
    }
}

/// With the entries as they are after all flaws.
void Device::FixMapping(SlotIndex slot) noexcept
{
    const SlotPlan& plan = plans[slot];
    setups[slot].map = plan.is_static ? StaticMap{plan.entries, plan.map_count} : StaticMap{nullptr, 0U};
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
    MakeKind(random, plan);
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
    setup.detection = random.Chance(330U) ? SrvtDetection::kLate : SrvtDetection::kEarly;
    if (random.Chance(10U))
    {
        setup.detection = static_cast<SrvtDetection>(random.Below(256U));
    }
    const std::uint32_t bits = plans[slot].bits;
    const std::uint32_t low = (bits >= 32U) ? 0xFFFFFFFFU : ((1U << bits) - 1U);
    const std::uint32_t high = (bits >= 64U) ? 0xFFFFFFFFU : ((bits <= 32U) ? 0U : ((1U << (bits - 32U)) - 1U));
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
            if (plan.dummies[pair] == 0U)
            {
                memory.objects[object_count_] =
                    MappableObject{static_cast<std::uint16_t>(first_index + slot), static_cast<std::uint8_t>(pair + 1U),
                                   plan.lengths[pair], access, &memory.bytes[at]};
                at += BytesOf(plan.lengths[pair]);
                ++object_count_;
            }
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

} // namespace counterpoint::differential
