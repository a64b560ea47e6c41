// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

/// Mappings: what their entries name, and whether they may. [SRS-CFG-026 to 028, 030, 032, 033]
namespace counterpoint::channel_b
{

namespace
{

/// Lengths of the data types that stand for an object nobody wants; the index is the row.
constexpr std::uint8_t kDummyBits[kLastDummyIndex + 1U] = {0U, 1U, 8U, 16U, 32U, 8U, 16U, 32U}; // MISRA D-001

/// The object that the entry names: index and sub-index.
[[nodiscard]] std::uint32_t KeyOf(const MappableObject& object) noexcept
{
    return (static_cast<std::uint32_t>(object.index) << 8U) | static_cast<std::uint32_t>(object.sub);
}

/// Whether the entry has the form of a dummy: no length goes with index 0.
[[nodiscard]] [[gnu::noinline]] bool IsDummy(std::uint32_t entry) noexcept
{
    const std::uint32_t index = entry >> 16U;
    const std::uint32_t bits = kDummyBits[(index <= kLastDummyIndex) ? index : 0U]; // MISRA D-002
    return (bits != 0U) && ((entry & 0xFFFFU) == bits);
}

/// What is wrong with an entry beside the other ones, whatever object it names; 0 if nothing.
[[nodiscard]] std::uint32_t FlawsOf(const Mapping& mapping, std::uint32_t index, std::uint32_t granule) noexcept
{
    const std::uint32_t entry = mapping.entries[index];
    const std::uint32_t partner = mapping.entries[index ^ 1U];
    const bool is_dummy = IsDummy(entry);
    std::uint32_t flaws = ((entry ^ partner) & 0xFFU) | (entry & 0xFFU & granule);
    flaws |= static_cast<std::uint32_t>(is_dummy != IsDummy(partner));
    for (std::uint32_t before = 0U; before < index; ++before)
    {
        const bool is_named = (mapping.entries[before] >> 8U) == (entry >> 8U);
        flaws |= static_cast<std::uint32_t>(is_named && (!is_dummy));
    }
    return flaws;
}

} // namespace

Mapping Channel::MappingOf(SlotIndex slot) const noexcept
{
    const StaticMap& map = Column<const SrdoSetup>{x_config->srdos}[slot].map;
    if (map.entries != nullptr)
    {
        return Mapping{{map.entries}, map.count, (map.count < kLargestMapping) ? map.count : kLargestMapping, kStatic};
    }
    const std::uint32_t first = FirstEntryOf(x_storage, slot);
    const Row& row = x_storage.rows[slot];
    return Mapping{{&x_storage.entries[first]}, row.image[kMapCountAt], StoredCount(row, x_map_entries), first};
}

std::uint16_t Channel::Find(std::uint32_t entry) const noexcept
{
    const Column<const MappableObject> objects{x_config->objects};
    const std::uint32_t key = entry >> 8U;
    std::uint16_t low = 0U;
    std::uint16_t high = x_config->object_count;
    while (low < high) // Halves at each turn: at most 11 for 1024 objects.
    {
        const std::uint16_t middle = static_cast<std::uint16_t>(low + ((high - low) / 2));
        if (KeyOf(objects[middle]) < key)
        {
            low = static_cast<std::uint16_t>(middle + 1);
        }
        else
        {
            high = middle;
        }
    }
    return low;
}

/// Fills the table of a dynamic mapping. What an entry behind the last one leads to is no object.
void Channel::Resolve(const Mapping& mapping, bool is_consumer) const noexcept
{
    const bool may_be_dummy = is_consumer && (x_config->dummies == DummyMapping::kAllowed);
    const std::uint32_t count = mapping.count;
    for (std::uint32_t index = 0U; index < x_map_entries; ++index)
    {
        std::uint16_t place = kNoPlace;
        if (index < count)
        {
            const std::uint32_t entry = mapping.entries[index];
            place = (may_be_dummy && IsDummy(entry)) ? kDummyPlace : Find(entry);
        }
        x_storage.table[mapping.first + index] = place;
    }
}

/// Whether the objects of a static mapping lie one behind the other from the registered fields on; each entry leads to
/// its object.
bool Channel::AreFieldsRight(SlotIndex slot, const Mapping& mapping) const noexcept
{
    const Column<const MappableObject> objects{x_config->objects};
    const StaticFields& fields = x_storage.rows[slot].fields;
    const std::uint8_t* next[2U] = {fields.normal, fields.inverse}; // MISRA D-001
    bool is_right = true;
    for (std::uint32_t index = 0U; index < mapping.count; ++index)
    {
        const MappableObject& object = objects[Find(mapping.entries[index])];
        if (object.place != next[index & 1U]) // MISRA D-002
        {
            is_right = false;
        }
        next[index & 1U] = &Column<const std::uint8_t>{object.place}[object.length_bits / 8U]; // MISRA D-002
    }
    return is_right;
}

/// Whether each entry leads to the object that it names, of its length, that fits the direction; those of a static
/// mapping in its fields.
bool Channel::IsTableRight(SlotIndex slot, const Mapping& mapping) const noexcept
{
    const Column<const MappableObject> objects{x_config->objects};
    const std::uint32_t object_count = x_config->object_count;
    const bool is_sent = x_storage.direction[slot] == kDirectionProducer;
    const std::uint32_t access = static_cast<std::uint32_t>(is_sent ? MapAccess::kProducer : MapAccess::kConsumer);
    std::uint32_t flaws = 0U;
    for (std::uint32_t index = 0U; index < mapping.count; ++index)
    {
        const std::uint32_t entry = mapping.entries[index];
        const std::uint32_t place = IsStatic(mapping) ? Find(entry) : x_storage.table[mapping.first + index];
        if (place < object_count)
        {
            const MappableObject& object = objects[place];
            const std::uint32_t named = (KeyOf(object) << 8U) | static_cast<std::uint32_t>(object.length_bits);
            flaws |= (named ^ entry) | (static_cast<std::uint32_t>(object.access) ^ access);
        }
        else
        {
            flaws |= static_cast<std::uint32_t>(!IsDummy(entry)) | (place ^ kDummyPlace);
        }
    }
    if (flaws != 0U)
    {
        return false;
    }
    return (!IsStatic(mapping)) || AreFieldsRight(slot, mapping);
}

/// The table that it writes counts only after a Validate without fault.
ConfigFault Channel::CheckMapping(SlotIndex slot, const Mapping& mapping) noexcept
{
    const std::uint32_t count = mapping.count;
    if ((count == 0U) || (count != mapping.declared) || ((count & 1U) != 0U))
    {
        return ConfigFault::kMapping;
    }
    const std::uint32_t device_granule = static_cast<std::uint32_t>(x_config->granularity_bits) - 1U;
    const std::uint32_t granule = IsStatic(mapping) ? (device_granule | 7U) : device_granule;
    std::uint32_t flaws = 0U;
    std::uint32_t bits = 0U;
    for (std::uint32_t index = 0U; index < count; ++index)
    {
        flaws |= FlawsOf(mapping, index, granule);
        bits += mapping.entries[index] & 0xFFU;
    }
    if (!IsStatic(mapping))
    {
        Resolve(mapping, x_storage.direction[slot] == kDirectionConsumer);
    }
    if ((flaws != 0U) || (!IsTableRight(slot, mapping)))
    {
        return ConfigFault::kMapping;
    }
    bits /= 2U; // Each normal entry is as long as its inverse entry.
    if (bits > kMaxPayloadBits)
    {
        return ConfigFault::kLengthExceeded;
    }
    Row& row = x_storage.rows[slot];
    const std::uint32_t length_bytes = (bits + 7U) / 8U;
    row.length_bytes = static_cast<std::uint8_t>(length_bytes & 0xFFU);
    row.mask = LowBits(length_bytes * 8U);
    row.spare = row.mask & ~LowBits(bits);
    return ConfigFault::kNone;
}

} // namespace counterpoint::channel_b
