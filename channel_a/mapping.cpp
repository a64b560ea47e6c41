// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/slots.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

// From entries of a mapping to objects, and data to and from them, bit by bit. Entries and places are read from memory
// that may be corrupted: a place is compared with the number of objects at every use, an object is accessed by its own
// length.
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
constexpr std::uint32_t kOffsetMask = kMaxPayloadBits - 1U;
constexpr std::uint32_t kRestOfByte = 7U;
constexpr std::uint32_t kByteMask = 0xFFU;
constexpr std::uint32_t kPairMask = 1U; ///< Of a position from 0: even the normal, odd the inverse object.
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

std::uint32_t LengthAt(const Mapping& mapping, const std::uint32_t position) noexcept
{
    return mapping.entries[position] & kLengthBits; // MISRA D-002
}

// Bits of all normal entries.
std::uint32_t TotalLength(const Mapping& mapping) noexcept
{
    std::uint32_t total = 0U;
    for (std::uint32_t position = 0U; position < mapping.count; position += 2U)
    {
        total += LengthAt(mapping, position);
    }
    return total;
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

// An object without a single bit where the place leads to none.
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

// [SRS-CFG-033]
bool IsDummy(const DeviceConfig& config, const Record& record, const std::uint32_t entry) noexcept
{
    const std::uint32_t type = (entry >> kIndexShift) - 1U; // Index 0 becomes greater than every type.
    if ((config.dummies != DummyMapping::kAllowed) || (record.direction != kDirectionConsumer))
    {
        return false;
    }
    return (type < kLastDummyIndex) && ((entry & kSubAndLength) == kDummyBits[type]);
}

// Length of the granularity and of the partner, and no object twice.
bool FitsOthers(const DeviceConfig& config, const Mapping& mapping, const std::uint32_t position) noexcept
{
    const std::uint32_t own_bits = ObjectAt(config, mapping, position).length_bits;
    const std::uint32_t partner_bits = ObjectAt(config, mapping, position & ~kPairMask).length_bits;
    const std::uint32_t length_bits = LengthAt(mapping, position);
    const std::uint32_t rest = length_bits & (config.granularity_bits - 1U);
    std::uint32_t twice = 0U;
    for (std::uint32_t before = 0U; before < position; ++before)
    {
        if (mapping.entries[before] == mapping.entries[position]) // MISRA D-002
        {
            twice = own_bits; // Of a dummy 0: it may be named twice.
        }
    }
    return (length_bits == LengthAt(mapping, position & ~kPairMask)) && (own_bits == partner_bits) &&
           ((rest | twice) == 0U);
}

// The objects of a static mapping lie one behind the other in the two fields. [SRS-CFG-032]
bool FitsFields(const DeviceConfig& config, const Record& record, const Mapping& mapping) noexcept
{
    const std::uint8_t* next[2] = {record.fields.normal, record.fields.inverse}; // MISRA D-001
    bool fits = true;
    for (std::uint32_t position = 0U; position < mapping.count; ++position)
    {
        const MappableObject& object = ObjectAt(config, mapping, position);
        const std::uint32_t length_bits = object.length_bits;
        if ((object.place != next[position & kPairMask]) || ((length_bits & kRestOfByte) != 0U))
        {
            fits = false;
        }
        next[position & kPairMask] = object.place + (length_bits >> kBitsToBytes); // MISRA D-002
    }
    return fits;
}

// What Validate and Recheck have in common: each entry leads to the object that it names, for this direction, a dummy
// entry to none.
bool FitsDictionary(const DeviceConfig& config, const Record& record, const Mapping& mapping) noexcept
{
    const MapAccess wanted = (record.direction == kDirectionConsumer) ? MapAccess::kConsumer : MapAccess::kProducer;
    bool fits = true;
    for (std::uint32_t position = 0U; position < mapping.count; ++position)
    {
        const MappableObject& object = ObjectAt(config, mapping, position);
        const std::uint32_t entry = mapping.entries[position]; // MISRA D-002
        if ((EntryOf(object) == entry) && (object.access == wanted))
        {
            continue;
        }
        if ((object.length_bits != 0U) || (mapping.places == nullptr) || !IsDummy(config, record, entry))
        {
            fits = false;
        }
    }
    return fits && ((mapping.places != nullptr) || FitsFields(config, record, mapping));
}

// Any length, from the last byte to the first.
std::uint64_t BitsOf(const MappableObject& object) noexcept
{
    std::uint32_t mask = kByteMask >> ((0U - object.length_bits) & kRestOfByte);
    std::uint64_t value = 0U;
    for (std::uint32_t byte = (object.length_bits + kRestOfByte) >> kBitsToBytes; byte != 0U; --byte)
    {
        value = (value << kBitsPerByte) | (object.place[byte - 1U] & mask); // MISRA D-002
        mask = kByteMask;
    }
    return value;
}

void PutObject(const MappableObject& object, const std::uint64_t data) noexcept
{
    std::uint64_t rest = data;
    std::uint32_t byte = 0U;
    for (std::uint32_t left = object.length_bits; left != 0U; left -= (left < kBitsPerByte) ? left : kBitsPerByte)
    {
        const std::uint32_t unused = (left < kBitsPerByte) ? (kBitsPerByte - left) : 0U;
        object.place[byte] = static_cast<std::uint8_t>(rest & (kByteMask >> unused)); // MISRA D-002
        rest >>= kBitsPerByte;
        ++byte;
    }
}

// What the normal objects hold, each read once.
[[gnu::noinline]] std::uint64_t ReadObjects(const Voice& voice, const std::uint32_t slot) noexcept
{
    const Mapping mapping = MappingOf(voice, slot);
    std::uint64_t data = 0U;
    std::uint32_t offset_bits = 0U;
    for (std::uint32_t position = 0U; position < mapping.count; position += 2U)
    {
        const MappableObject& object = ObjectAt(*voice.config, mapping, position);
        data |= BitsOf(object) << (offset_bits & kOffsetMask);
        offset_bits += LengthAt(mapping, position);
    }
    return data;
}

[[gnu::noinline]] void WriteBits(const Voice& voice, const std::uint32_t slot, const Octets& data) noexcept
{
    const Mapping mapping = MappingOf(voice, slot);
    const std::uint64_t bits = Bits(data);
    std::uint32_t offset_bits = 0U;
    for (std::uint32_t position = 0U; position < mapping.count; position += 2U)
    {
        PutObject(ObjectAt(*voice.config, mapping, position), bits >> (offset_bits & kOffsetMask));
        offset_bits += LengthAt(mapping, position);
    }
}

// Two objects of four bytes each.
struct Words
{
    std::uint8_t* low; ///< Null: the data are of other objects.
    std::uint8_t* high;
};

// The usual mapping goes without a loop.
inline Words WordsOf(const Voice& voice, const std::uint32_t slot) noexcept
{
    const DeviceConfig& config = *voice.config;
    const std::uint16_t* const places = voice.storage.places + (slot * voice.storage.map_entries); // MISRA D-002
    const std::uint32_t first = places[0];                                                         // MISRA D-002
    const std::uint32_t second = places[kSecondWord];                                              // MISRA D-002
    if ((first >= config.object_count) || (second >= config.object_count) ||
        (At(voice, slot).length_bytes != kMaxPayloadBytes))
    {
        return Words{nullptr, nullptr};
    }
    const MappableObject& low = config.objects[first];   // MISRA D-002
    const MappableObject& high = config.objects[second]; // MISRA D-002
    if ((low.length_bits != kBitsPerWord) || (high.length_bits != kBitsPerWord))
    {
        return Words{nullptr, nullptr};
    }
    return Words{low.place, high.place};
}

// What is read is what is sent, once it is confirmed.
[[gnu::noinline]] PreparedPair Send(Voice& voice, const std::uint32_t slot, const std::uint64_t data) noexcept
{
    Record& record = At(voice, slot);
    const SrdoMask bit = BitOf(slot);
    voice.refreshed &= ~bit;
    voice.requested &= ~bit;
    voice.flying |= bit;
    PutBits(record.held, data);
    SetMode(record, Mode::kNormalAwaited);
    record.frame_since = voice.now;
    if (voice.may_send && (record.form != ProducerForm::kProviderCalled))
    {
        record.since = voice.now;
    }
    PreparedPair pair{};
    pair.normal.identifier = record.values[kCobIdPlace];
    pair.normal.kind = FrameKind::kData;
    pair.normal.port = voice.ports[0];
    pair.normal.length_bytes = record.length_bytes;
    for (std::uint32_t place = 0U; place < kMaxPayloadBytes; ++place)
    {
        pair.normal.data[place] = record.held.at[place];
    }
    pair.status = PrepareStatus::kReady;
    return pair;
}

} // namespace

Mapping MappingOf(const Voice& voice, const std::uint32_t slot) noexcept
{
    const StaticMap& map = voice.config->srdos[slot].map; // MISRA D-002
    if (map.entries != nullptr)
    {
        return Mapping{map.entries, nullptr, Lesser(map.count, kMaxMapEntries), map.count, kMaxMapEntries};
    }
    const std::uint32_t first = slot * voice.storage.map_entries;
    const std::uint32_t stored = At(voice, slot).values[kMapCountPlace];
    const std::uint32_t limit = voice.config->map_entries;
    return Mapping{voice.storage.entries + first, voice.storage.places + first, // MISRA D-002
                   Lesser(stored, limit), stored, limit};
}

// SRS-CFG-026 to 028.
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
        if (!FitsOthers(config, mapping, position))
        {
            is_good = false;
        }
    }
    if (!is_good || !FitsDictionary(config, record, mapping))
    {
        return ConfigFault::kMapping;
    }
    const std::uint32_t total = TotalLength(mapping);
    if (total > kMaxPayloadBits)
    {
        return ConfigFault::kLengthExceeded;
    }
    SetLength(record, static_cast<std::uint8_t>((total + kRestOfByte) >> kBitsToBytes));
    record.spare_bits = static_cast<std::uint8_t>((kMaxPayloadBits - total) & kRestOfByte);
    return ConfigFault::kNone;
}

// [SRS-CFG-030]
bool HoldsTable(const DeviceConfig& config, const Record& record, const Mapping& mapping) noexcept
{
    return (record.mapping == kMarked) &&
           ((TotalLength(mapping) + record.spare_bits) == (std::uint32_t{record.length_bytes} * kBitsPerByte)) &&
           FitsDictionary(config, record, mapping);
}

void WriteObjects(const Voice& voice, const std::uint32_t slot, const Octets& data) noexcept
{
    const Words words = WordsOf(voice, slot);
    if (words.low == nullptr)
    {
        WriteBits(voice, slot, data);
        return;
    }
    PutWord(words.low, WordAt(&data.at[0]));
    PutWord(words.high, WordAt(&data.at[kBytesPerWord]));
}

PreparedPair Channel::Prepare(const SlotIndex slot) noexcept
{
    if (At(voice_, slot).mode != Mode::kIdle)
    {
        PreparedPair none{};
        none.status = PrepareStatus::kNotProducer;
        return none;
    }
    const Words words = WordsOf(voice_, slot);
    if (words.low == nullptr)
    {
        return Send(voice_, slot, ReadObjects(voice_, slot));
    }
    return Send(voice_, slot, std::uint64_t{WordAt(words.low)} | (std::uint64_t{WordAt(words.high)} << kBitsPerWord));
}

} // namespace counterpoint::channel_a
