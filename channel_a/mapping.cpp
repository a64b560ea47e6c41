// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

// From entries of a mapping to objects.
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kKeyShift = 8U; ///< Of a map entry: index and sub above the length.
constexpr std::uint32_t kSubShift = 8U;
constexpr std::uint32_t kIndexShift = 16U;
constexpr std::uint32_t kLengthBits = 0xFFU;
constexpr std::uint32_t kSubAndLength = 0xFFFFU;
constexpr std::uint32_t kBitsToBytes = 3U;
constexpr std::uint32_t kRestOfByte = 7U;
constexpr std::uint32_t kShiftMask = kMaxPayloadBits - 1U;
constexpr std::uint32_t kPairMask = 1U; ///< Of a position from 0: even the normal, odd the inverse object.
constexpr std::uint32_t kBad = 0xFFFFFFFFU;
constexpr MappableObject kNothing{0U, 0U, 0U, MapAccess::kNone, nullptr};

/// Bits of the data types 0001h to 0007h.
constexpr std::uint8_t kDummyBits[kLastDummyIndex] = {1U, 8U, 16U, 32U, 8U, 16U, 32U}; // MISRA D-001

std::uint32_t Lesser(const std::uint32_t one, const std::uint32_t other) noexcept
{
    return (one < other) ? one : other;
}

// The map entry that names this object.
std::uint32_t EntryOf(const MappableObject& object) noexcept
{
    return (std::uint32_t{object.index} << kIndexShift) | (std::uint32_t{object.sub} << kSubShift) |
           std::uint32_t{object.length_bits};
}

// The objects are in ascending order of index and sub.
std::uint32_t FindObject(const DeviceConfig& config, const std::uint32_t entry) noexcept
{
    const std::uint32_t key = entry >> kKeyShift;
    std::uint32_t low = 0U;
    std::uint32_t high = config.object_count;
    std::uint32_t found = kNoObject;
    while (low < high)
    {
        const std::uint32_t middle = (low + high) >> 1U;
        const std::uint32_t seen = EntryOf(config.objects[middle]) >> kKeyShift; // MISRA D-002
        if (seen == key)
        {
            found = middle;
        }
        low = (seen < key) ? (middle + 1U) : low;
        high = (seen < key) ? high : middle;
    }
    return found;
}

// [SRS_CFG_033]
bool IsDummy(const DeviceConfig& config, const Record& record, const std::uint32_t entry) noexcept
{
    const std::uint32_t type = (entry >> kIndexShift) - 1U; // Index 0 becomes greater than every type.
    if ((config.dummies != DummyMapping::kAllowed) || (record.direction != kDirectionConsumer))
    {
        return false;
    }
    return (type < kLastDummyIndex) && ((entry & kSubAndLength) == kDummyBits[type]);
}

// What only Validate asks: length of the granularity and of the partner, and no object twice.
bool FitsOthers(const DeviceConfig& config, const Mapping& mapping, const std::uint32_t position) noexcept
{
    const std::uint32_t entry = mapping.entries[position];                // MISRA D-002
    const std::uint32_t partner = mapping.entries[position & ~kPairMask]; // MISRA D-002
    const std::uint32_t own_bits = ObjectAt(config, mapping, position).length_bits;
    const std::uint32_t partner_bits = ObjectAt(config, mapping, position & ~kPairMask).length_bits;
    const std::uint32_t rest = entry & (config.granularity_bits - 1U);
    std::uint32_t twice = 0U;
    for (std::uint32_t before = 0U; before < position; ++before)
    {
        if (mapping.entries[before] == entry) // MISRA D-002
        {
            twice = own_bits; // Of a dummy 0: it may be named twice.
        }
    }
    return (((entry ^ partner) & kLengthBits) == 0U) && (own_bits == partner_bits) && ((rest | twice) == 0U);
}

// What Validate and Recheck have in common: each entry leads to the object that it names, for this direction, a dummy
// entry to none; the objects of a static mapping lie one behind the other in the two fields [SRS_CFG_032]. Bits of all
// normal entries; kBad where one does not fit.
std::uint32_t Measured(const DeviceConfig& config, const Record& record, const Mapping& mapping) noexcept
{
    const MapAccess wanted = (record.direction == kDirectionConsumer) ? MapAccess::kConsumer : MapAccess::kProducer;
    const bool is_static = mapping.places == nullptr;
    const std::uint8_t* next[2] = {record.fields.normal, record.fields.inverse}; // MISRA D-001
    std::uint32_t total = 0U;
    bool fits = true;
    for (std::uint32_t position = 0U; position < mapping.count; ++position)
    {
        const MappableObject& object = ObjectAt(config, mapping, position);
        const std::uint32_t entry = mapping.entries[position]; // MISRA D-002
        if ((EntryOf(object) != entry) || (object.access != wanted))
        {
            fits = fits && (object.length_bits == 0U) && !is_static && IsDummy(config, record, entry);
        }
        if (is_static)
        {
            const std::uint8_t*& field = next[position & kPairMask];
            fits = fits && (object.place == field) && ((object.length_bits & kRestOfByte) == 0U);
            field = object.place + (object.length_bits >> kBitsToBytes); // MISRA D-002
        }
        if ((position & kPairMask) == 0U)
        {
            total += entry & kLengthBits;
        }
    }
    return fits ? total : kBad;
}

std::uint64_t MappedOf(const std::uint32_t length_bytes) noexcept
{
    return ~std::uint64_t{0U} >> ((kMaxPayloadBits - (length_bytes * kBitsPerByte)) & kShiftMask);
}

} // namespace

const MappableObject& ObjectAt(const DeviceConfig& config, const Mapping& mapping,
                               const std::uint32_t position) noexcept
{
    std::uint32_t place = 0U;
    if (mapping.places != nullptr)
    {
        place = mapping.places[position]; // MISRA D-002
    }
    else
    {
        place = FindObject(config, mapping.entries[position]); // MISRA D-002
    }
    return (place < config.object_count) ? config.objects[place] : kNothing; // MISRA D-002
}

Mapping MappingOf(const Voice& voice, const std::size_t slot) noexcept
{
    const StaticMap& map = voice.config->srdos[slot].map; // MISRA D-002
    if (map.entries != nullptr)
    {
        return Mapping{map.entries, nullptr, Lesser(map.count, kMaxMapEntries), map.count, kMaxMapEntries};
    }
    const std::size_t first = slot * voice.storage.row;
    const std::uint32_t stored = voice.storage.entries[first]; // MISRA D-002
    const std::uint32_t limit = voice.config->map_entries;
    return Mapping{voice.storage.entries + first + kFirstEntry,
                   voice.storage.places + first + kFirstEntry, // MISRA D-002
                   Lesser(stored, limit), stored, limit};
}

// SRS_CFG_026, SRS_CFG_027, SRS_CFG_028.
ConfigFault Resolve(const DeviceConfig& config, Record& record, const Mapping& mapping) noexcept
{
    const std::uint32_t count = mapping.stored_count;
    if ((count == 0U) || ((count & kPairMask) != 0U) || (count > mapping.limit))
    {
        return ConfigFault::kMapping;
    }
    bool is_good = true;
    for (std::uint32_t position = 0U; position < count; ++position)
    {
        if (mapping.places != nullptr)
        {
            mapping.places[position] =
                static_cast<std::uint16_t>(FindObject(config, mapping.entries[position])); // MISRA D-002
        }
        is_good = FitsOthers(config, mapping, position) && is_good;
    }
    const std::uint32_t total = Measured(config, record, mapping);
    if (!is_good || (total == kBad))
    {
        return ConfigFault::kMapping;
    }
    if (total > kMaxPayloadBits)
    {
        return ConfigFault::kLengthExceeded;
    }
    SetLength(record, static_cast<std::uint8_t>((total + kRestOfByte) >> kBitsToBytes));
    record.total_bits = static_cast<std::uint8_t>(total);
    record.mapped = MappedOf(record.length_bytes);
    return ConfigFault::kNone;
}

// [SRS_CFG_030]
bool HoldsTable(const DeviceConfig& config, const Record& record, const Mapping& mapping) noexcept
{
    const std::uint32_t total = Measured(config, record, mapping);
    return (record.mapping == kMarked) && (total == record.total_bits) &&
           (((total + kRestOfByte) >> kBitsToBytes) == record.length_bytes) &&
           (record.mapped == MappedOf(record.length_bytes));
}

} // namespace counterpoint::channel_a
