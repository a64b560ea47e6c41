// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/signature.hpp"
#include "channel_a/slots.hpp"
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
constexpr std::uint32_t kPairMask = 1U; ///< Of a position from 0: even the normal, odd the inverse object.
constexpr std::uint32_t kByteMask = 0xFFU;
constexpr std::uint32_t kAllBits = 0xFFFFFFFFU;
constexpr std::uint32_t kOffsetMask = kMaxPayloadBits - 1U;
constexpr std::uint32_t kWordCount = 2U; ///< Objects of four bytes in a frame.
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
        PutWord(object.place, static_cast<std::uint32_t>(rest));
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

// Any lengths, from the first object on: once more what was read before.
[[gnu::noinline]] bool ReadBytes(const DeviceConfig& config, Record& record) noexcept
{
    const std::uint32_t count = MapCount(record);
    std::uint64_t data = 0U;
    std::uint32_t offset_bits = 0U;
    std::uint32_t wrong = 0U;
    for (std::uint32_t position = 0U; position < count; position += 2U)
    {
        const MappableObject& normal = ObjectAt(config, record, position);
        const MappableObject& inverse = ObjectAt(config, record, position | kPairMask);
        const std::uint32_t length_bytes = std::uint32_t{normal.length_bits} >> kBitsToBytes;
        if (normal.length_bits != inverse.length_bits)
        {
            return false;
        }
        for (std::uint32_t place = 0U; place < length_bytes; ++place)
        {
            const std::uint32_t byte = normal.place[place]; // MISRA D-002
            data |= std::uint64_t{byte} << (offset_bits & kOffsetMask);
            offset_bits += kBitsPerByte;
            wrong |= byte ^ inverse.place[place] ^ kByteMask; // MISRA D-002
        }
    }
    record.held = OctetsOf(data);
    return wrong == 0U;
}

// Normal objects into `held`. False if a bit is not inverted, or an object is not there or not as long as its partner.
// Objects of four bytes are the usual ones and go without a call.
[[gnu::noinline]] bool ReadObjects(const DeviceConfig& config, Record& record) noexcept
{
    const std::uint32_t count = MapCount(record);
    std::uint32_t words[kWordCount]{}; // MISRA D-001
    for (std::uint32_t position = 0U; position < count; position += 2U)
    {
        const std::uint32_t normal_place = record.objects[position];
        const std::uint32_t inverse_place = record.objects[position | kPairMask];
        if ((normal_place >= config.object_count) || (inverse_place >= config.object_count))
        {
            return false;
        }
        const MappableObject& normal = config.objects[normal_place];   // MISRA D-002
        const MappableObject& inverse = config.objects[inverse_place]; // MISRA D-002
        if ((normal.length_bits != kWordBits) || (inverse.length_bits != kWordBits))
        {
            return ReadBytes(config, record);
        }
        const std::uint32_t word = WordAt(normal.place);
        if ((word ^ WordAt(inverse.place)) != kAllBits)
        {
            return false;
        }
        words[(position / 2U) % kWordCount] = word;
    }
    PutWord(&record.held.at[0], words[0]);
    PutWord(&record.held.at[kBytesPerWord], words[1]);
    return true;
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

PreparedPair Channel::Prepare(const SlotIndex slot) noexcept
{
    PreparedPair pair{};
    pair.status = PrepareStatus::kNotProducer;
    Record& record = At(voice_, slot);
    if (record.mode != Mode::kIdle)
    {
        return pair;
    }
    const SrdoMask bit = BitOf(slot);
    voice_.refreshed &= ~bit;
    voice_.requested &= ~bit;
    if (!ReadObjects(*voice_.config, record))
    {
        pair.status = PrepareStatus::kNotInverse;
        Report(voice_, slot, SrdoCause::kNotInverse);
        return pair;
    }
    SetMode(record, Mode::kNormalAwaited);
    voice_.flying |= bit;
    record.sent_since = voice_.now;
    if (voice_.may_send && (record.form != ProducerForm::kProviderCalled))
    {
        record.since = voice_.now;
    }
    pair.normal.identifier = record.values[kCobIdPlace];
    pair.normal.kind = FrameKind::kData;
    pair.normal.port = voice_.ports[0];
    pair.normal.length_bytes = record.length_bytes;
    for (std::uint32_t place = 0U; place < kMaxPayloadBytes; ++place)
    {
        pair.normal.data[place] = record.held.at[place];
    }
    pair.status = PrepareStatus::kReady;
    return pair;
}

} // namespace counterpoint::channel_a
