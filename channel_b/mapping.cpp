// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

/// Mappings: what their entries name, and whether they may. [SRS_CFG_026, SRS_CFG_027, SRS_CFG_028, SRS_CFG_030,
/// SRS_CFG_032, SRS_CFG_033]
namespace counterpoint::channel_b
{

namespace
{

/// Lengths of the data types that stand for an object nobody wants; the index is the row.
constexpr std::uint8_t kDummyBits[kLastDummyIndex + 1U] = {0U, 1U, 8U, 16U, 32U, 8U, 16U, 32U}; // MISRA D-001

/// Of a mapping of two normal and two inverse objects.
constexpr std::uint8_t kEntriesOfTwo = 4U;

/// The entry that names the object.
[[nodiscard]] std::uint32_t EntryOf(const MappableObject& object) noexcept
{
    return (static_cast<std::uint32_t>(object.index) << 16U) | (static_cast<std::uint32_t>(object.sub) << 8U) |
           static_cast<std::uint32_t>(object.length_bits);
}

/// Whether the entry has the form of a dummy: no length goes with index 0.
[[nodiscard]] bool IsDummy(std::uint32_t entry) noexcept
{
    const std::uint32_t index = entry >> 16U;
    const std::uint32_t bits = kDummyBits[(index <= kLastDummyIndex) ? index : 0U]; // MISRA D-002
    return (bits != 0U) && ((entry & 0xFFFFU) == bits);
}

} // namespace

Channel::Mapping Channel::MappingOf(SlotIndex slot) const noexcept
{
    const StaticMap& map = Column<const SrdoSetup>{x_config->srdos}[slot].map;
    if (map.entries != nullptr)
    {
        return Mapping{
            {map.entries}, {nullptr}, map.count, (map.count < kLargestMapping) ? map.count : kLargestMapping};
    }
    const std::uint32_t first = FirstEntryOf(x_storage, slot);
    const Row& row = x_storage.rows[slot];
    return Mapping{{&x_storage.entries[first]},
                   {&x_storage.table[first]},
                   row.image[kMapCountAt],
                   StoredCount(row, x_map_entries)};
}

/// The first object that is not before the one that the entry names.
std::uint32_t Channel::Find(std::uint32_t entry) const noexcept
{
    std::uint32_t low = 0U;
    std::uint32_t high = static_cast<std::uint32_t>(x_object_count);
    while (low < high) // Halves at each turn: at most 11 for 1024 objects.
    {
        const std::uint32_t middle = (low + high) / 2U;
        if ((EntryOf(x_objects[middle]) >> 8U) < (entry >> 8U))
        {
            low = middle + 1U;
        }
        else
        {
            high = middle;
        }
    }
    return low;
}

/// Fills the table of a dynamic mapping. What an entry behind the last one leads to is no object.
void Channel::Resolve(const Mapping& mapping, bool may_be_dummy) const noexcept
{
    for (std::uint32_t index = 0U; index < x_map_entries; ++index)
    {
        std::uint32_t place = kNoPlace;
        if (index < mapping.count)
        {
            const std::uint32_t entry = mapping.entries[index];
            place = (may_be_dummy && IsDummy(entry)) ? kDummyPlace : Find(entry);
        }
        mapping.table[index] = static_cast<std::uint16_t>(place);
    }
}

/// Two objects of four bytes fill a frame: most often found are the shortest to reach.
std::uint32_t Channel::WordsOf(const Mapping& mapping) noexcept
{
    if (IsStatic(mapping) || (mapping.count != kEntriesOfTwo))
    {
        return kNoWords;
    }
    return std::uint32_t{mapping.table[1U]} | (std::uint32_t{mapping.table[3U]} << 16U);
}

/// Whether each entry leads to the object that it names, of its length, that fits the direction; the objects of a
/// static mapping one behind the other from the registered fields on.
bool Channel::IsTableRight(SlotIndex slot, const Mapping& mapping) const noexcept
{
    const bool is_sent = x_storage.rows[slot].image[kDirectionAt] == kDirectionProducer;
    const std::uint32_t access = static_cast<std::uint32_t>(is_sent ? MapAccess::kProducer : MapAccess::kConsumer);
    const std::uint8_t* next[2U] = {x_storage.fields[slot].normal, x_storage.fields[slot].inverse}; // MISRA D-001
    std::uint32_t flaws = 0U;
    for (std::uint32_t index = 0U; index < mapping.count; ++index)
    {
        const std::uint32_t entry = mapping.entries[index];
        const bool is_static = IsStatic(mapping);
        const std::uint32_t place = is_static ? Find(entry) : mapping.table[index];
        if (place >= x_object_count)
        {
            flaws |= static_cast<std::uint32_t>(!IsDummy(entry)) | (place ^ kDummyPlace);
            continue;
        }
        const MappableObject& object = x_objects[place];
        flaws |= (EntryOf(object) ^ entry) | (static_cast<std::uint32_t>(object.access) ^ access);
        if (is_static)
        {
            flaws |= static_cast<std::uint32_t>(object.place != next[index & 1U]);                 // MISRA D-002
            next[index & 1U] = &Column<const std::uint8_t>{object.place}[object.length_bits / 8U]; // MISRA D-002
        }
    }
    flaws |= x_storage.rows[slot].words ^ WordsOf(mapping);
    return flaws == 0U;
}

/// The table that it writes counts only after a Validate without fault.
ConfigFault Channel::CheckMapping(SlotIndex slot, const Mapping& mapping) const noexcept
{
    Row& row = x_storage.rows[slot];
    const std::uint32_t count = mapping.count;
    const bool is_static = IsStatic(mapping);
    std::uint32_t flaws = (count ^ mapping.declared) | (count & 1U) | static_cast<std::uint32_t>(count == 0U);
    std::uint32_t bits = 0U;
    std::uint32_t granule = static_cast<std::uint32_t>(x_config->granularity_bits) - 1U;
    granule |= is_static ? 7U : 0U;
    for (std::uint32_t index = 0U; index < (count & 0xFEU); ++index)
    {
        const std::uint32_t entry = mapping.entries[index];
        const std::uint32_t partner = mapping.entries[index ^ 1U];
        const bool is_dummy = IsDummy(entry);
        flaws |= ((entry ^ partner) & 0xFFU) | (entry & 0xFFU & granule);
        flaws |= static_cast<std::uint32_t>(is_dummy != IsDummy(partner));
        for (std::uint32_t before = 0U; before < index; ++before)
        {
            const bool is_named = (mapping.entries[before] >> 8U) == (entry >> 8U);
            flaws |= static_cast<std::uint32_t>(is_named && (!is_dummy));
        }
        bits += entry & 0xFFU;
    }
    if (!is_static)
    {
        const bool is_consumer = row.image[kDirectionAt] == kDirectionConsumer;
        Resolve(mapping, is_consumer && (x_config->dummies == DummyMapping::kAllowed));
    }
    row.words = WordsOf(mapping);
    if ((flaws != 0U) || (!IsTableRight(slot, mapping)))
    {
        return ConfigFault::kMapping;
    }
    bits /= 2U; // Each normal entry is as long as its inverse entry.
    if (bits > kMaxPayloadBits)
    {
        return ConfigFault::kLengthExceeded;
    }
    const std::uint32_t length_bytes = (bits + 7U) / 8U;
    row.length_bits = static_cast<std::uint8_t>(bits);
    row.awaited.length_bytes = static_cast<std::uint8_t>(length_bytes);
    row.mask = LowBits(length_bytes * 8U);
    row.spare = row.mask & ~LowBits(bits);
    return ConfigFault::kNone;
}

} // namespace counterpoint::channel_b
