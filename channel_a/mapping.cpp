// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/signature.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

// From entries of a mapping to objects, and data to and from them. Record::objects is read from memory that may be
// corrupted: every use of a place compares it with the number of objects.
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kKeyShift = 8U; ///< Of a map entry: index and sub above the length.
constexpr std::uint32_t kSubShift = 8U;
constexpr std::uint32_t kIndexShift = 16U;
constexpr std::uint32_t kLengthBits = 0xFFU;
constexpr std::uint32_t kBitsToBytes = 3U;
constexpr std::uint32_t kWordBits = 32U;
constexpr std::uint32_t kOffsetMask = kMaxPayloadBits - 1U;
constexpr std::uint32_t kPairMask = 1U; ///< Of a position from 0: even the normal, odd the inverse object.
constexpr std::uint16_t kNoObject = 0xFFFFU;
constexpr MappableObject kNothing{0U, 0U, 0U, MapAccess::kNone, nullptr};

// The map entry that names this object.
std::uint32_t EntryOf(const MappableObject& object) noexcept
{
    return (std::uint32_t{object.index} << kIndexShift) | (std::uint32_t{object.sub} << kSubShift) |
           std::uint32_t{object.length_bits};
}

std::uint32_t LengthAt(const Record& record, const std::uint32_t position) noexcept
{
    return record.values[kMapEntryPlace + position] & kLengthBits;
}

// Bits of all normal entries.
std::uint32_t TotalLength(const Record& record) noexcept
{
    const std::uint32_t count = MapCount(record);
    std::uint32_t total = 0U;
    for (std::uint32_t position = 0U; position < count; position += 2U)
    {
        total += LengthAt(record, position);
    }
    return total;
}

// Writes the lowest bytes into the object; returns the others.
std::uint64_t Written(const MappableObject& object, std::uint64_t rest) noexcept
{
    if (object.length_bits == kWordBits) // The usual one, in one go.
    {
        std::uint8_t* const place = object.place;
        place[0] = static_cast<std::uint8_t>(rest);        // MISRA D-002
        place[1] = static_cast<std::uint8_t>(rest >> 8U);  // MISRA D-002
        place[2] = static_cast<std::uint8_t>(rest >> 16U); // MISRA D-002
        place[3] = static_cast<std::uint8_t>(rest >> 24U); // MISRA D-002
        return rest >> kWordBits;
    }
    const std::uint32_t length_bytes = std::uint32_t{object.length_bits} >> kBitsToBytes;
    for (std::uint32_t byte = 0U; byte < length_bytes; ++byte)
    {
        object.place[byte] = static_cast<std::uint8_t>(rest); // MISRA D-002
        rest >>= kBitsPerByte;
    }
    return rest;
}

struct Reading
{
    std::uint64_t normal;
    std::uint32_t offset_bits;
    std::uint32_t difference; ///< Bits that are not inverted, or lengths that differ.
};

void Add(Reading& reading, const std::uint32_t normal, const std::uint32_t inverse, const std::uint32_t bits) noexcept
{
    const std::uint32_t wrong = ~(normal ^ inverse);
    reading.difference |= wrong << (kWordBits - bits);
    reading.normal |= std::uint64_t{normal} << (reading.offset_bits & kOffsetMask);
    reading.offset_bits += bits;
}

void Read(const MappableObject& normal, const MappableObject& inverse, Reading& reading) noexcept
{
    reading.difference |= std::uint32_t{normal.length_bits} ^ std::uint32_t{inverse.length_bits};
    const std::uint32_t shorter_bits = std::uint32_t{normal.length_bits} & std::uint32_t{inverse.length_bits};
    if (shorter_bits == kWordBits) // The usual one, in one go.
    {
        Add(reading, WordAt(normal.place), WordAt(inverse.place), kWordBits);
        return;
    }
    const std::uint32_t length_bytes = shorter_bits >> kBitsToBytes;
    for (std::uint32_t byte = 0U; byte < length_bytes; ++byte)
    {
        Add(reading, normal.place[byte], inverse.place[byte], kBitsPerByte); // MISRA D-002
    }
}

// The objects are in ascending order of index and sub.
std::uint16_t FindObject(const DeviceConfig& config, const std::uint32_t entry) noexcept
{
    const std::uint32_t key = entry >> kKeyShift;
    std::uint32_t low = 0U;
    std::uint32_t high = config.object_count;
    std::uint16_t found = kNoObject;
    while (low < high)
    {
        const std::uint32_t middle = (low + high) >> 1U;
        const std::uint32_t seen = EntryOf(config.objects[middle]) >> kKeyShift; // MISRA D-002
        if (seen == key)
        {
            found = static_cast<std::uint16_t>(middle);
        }
        low = (seen < key) ? (middle + 1U) : low;
        high = (seen < key) ? high : middle;
    }
    return found;
}

// An object without a single bit where the place leads to none.
const MappableObject& ObjectAt(const DeviceConfig& config, const Record& record, const std::uint32_t position) noexcept
{
    const std::uint32_t place = record.objects[position];
    return (place < config.object_count) ? config.objects[place] : kNothing; // MISRA D-002
}

// The object at this position is the one that the entry names, for this direction.
bool FitsEntry(const DeviceConfig& config, const Record& record, const std::uint32_t position) noexcept
{
    const MappableObject& object = ObjectAt(config, record, position);
    const MapAccess wanted = (record.direction == kDirectionConsumer) ? MapAccess::kConsumer : MapAccess::kProducer;
    return (EntryOf(object) == record.values[kMapEntryPlace + position]) && (object.access == wanted);
}

// Length of the granularity and of the partner, and no object twice.
bool FitsOthers(const DeviceConfig& config, const Record& record, const std::uint32_t position) noexcept
{
    const std::uint32_t length_bits = LengthAt(record, position);
    const std::uint32_t normal_bits = LengthAt(record, position & ~kPairMask);
    const std::uint32_t rest = length_bits & (config.granularity_bits - 1U);
    bool is_first = true;
    for (std::uint32_t before = 0U; before < position; ++before)
    {
        if (record.objects[before] == record.objects[position])
        {
            is_first = false;
        }
    }
    return (rest == 0U) && (length_bits == normal_bits) && is_first;
}

} // namespace

// SRS-CFG-026 to 028.
ConfigFault Resolve(const DeviceConfig& config, Record& record) noexcept
{
    const std::uint32_t count = record.values[kMapCountPlace];
    if ((count == 0U) || ((count & kPairMask) != 0U) || (count > kMaxMapEntries))
    {
        return ConfigFault::kMapping;
    }
    for (std::uint16_t& place : record.objects)
    {
        place = kNoObject;
    }
    bool is_good = true;
    for (std::uint32_t position = 0U; position < count; ++position)
    {
        record.objects[position] = FindObject(config, record.values[kMapEntryPlace + position]);
        if (!FitsEntry(config, record, position) || !FitsOthers(config, record, position))
        {
            is_good = false;
        }
    }
    if (!is_good)
    {
        return ConfigFault::kMapping;
    }
    const std::uint32_t total = TotalLength(record);
    if (total > kMaxPayloadBits)
    {
        return ConfigFault::kLengthExceeded;
    }
    SetLength(record, static_cast<std::uint8_t>(total >> kBitsToBytes));
    return ConfigFault::kNone;
}

// [SRS-CFG-030]
bool HoldsTable(const DeviceConfig& config, const Record& record) noexcept
{
    const std::uint32_t count = MapCount(record);
    bool holds =
        (record.mapping == kMarked) && (TotalLength(record) == (std::uint32_t{record.length_bytes} << kBitsToBytes));
    for (std::uint32_t position = 0U; position < count; ++position)
    {
        if (!FitsEntry(config, record, position))
        {
            holds = false;
        }
    }
    return holds;
}

void WriteObjects(const DeviceConfig& config, const Record& record, const Octets& data) noexcept
{
    const std::uint32_t count = MapCount(record);
    std::uint64_t rest = Bits(data);
    for (std::uint32_t position = 0U; position < count; position += 2U)
    {
        rest = Written(ObjectAt(config, record, position), rest);
    }
}

bool ReadObjects(const DeviceConfig& config, Record& record) noexcept
{
    const std::uint32_t count = MapCount(record);
    Reading reading{0U, 0U, 0U};
    for (std::uint32_t position = 0U; position < count; position += 2U)
    {
        Read(ObjectAt(config, record, position), ObjectAt(config, record, position | kPairMask), reading);
    }
    record.held = OctetsOf(reading.normal);
    return reading.difference == 0U;
}

} // namespace counterpoint::channel_a
