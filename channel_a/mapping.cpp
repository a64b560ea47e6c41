// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/mapping.hpp"

namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kKeyShift = 8U; ///< Of a map entry: index and sub above the length.
constexpr std::uint32_t kSubShift = 8U;
constexpr std::uint32_t kIndexShift = 16U;
constexpr std::uint32_t kLengthBits = 0xFFU;
constexpr std::uint32_t kSubAndLength = 0xFFFFU;

/// Bits of the data types 0001h to 0007h.
constexpr std::uint8_t kDummyBits[kLastDummyIndex] = {1U, 8U, 16U, 32U, 8U, 16U, 32U}; // MISRA D-001

// Bytes of a frame of so many bits.
std::uint8_t LengthOf(const std::uint32_t total_bits) noexcept
{
    return static_cast<std::uint8_t>((total_bits + (kBitsPerByte - 1U)) / kBitsPerByte);
}

// The bits of its last byte that are not mapped.
std::uint8_t SpareOf(const std::uint32_t total_bits) noexcept
{
    const std::uint32_t rest = total_bits % kBitsPerByte;
    const std::uint32_t spare = (rest == 0U) ? 0U : ((kByteMask << rest) & kByteMask);
    return static_cast<std::uint8_t>(spare);
}

Bytes MappedOf(const std::uint32_t length_bytes) noexcept
{
    Bytes mapped{};
    for (std::size_t place = 0U; place < kMaxPayloadBytes; ++place)
    {
        mapped.at[place] = (place < length_bytes) ? static_cast<std::uint8_t>(kByteMask) : std::uint8_t{0U};
    }
    return mapped;
}

bool AreSame(const Bytes& one, const Bytes& other) noexcept
{
    return (WordOf(one, 0U) == WordOf(other, 0U)) && (WordOf(one, kBytesPerWord) == WordOf(other, kBytesPerWord));
}

std::uint32_t NormalEntry(const std::uint32_t* const entries, const std::uint32_t pair) noexcept
{
    return entries[kEntriesPerStep * pair]; // MISRA D-002
}

std::uint32_t InverseEntry(const std::uint32_t* const entries, const std::uint32_t pair) noexcept
{
    return entries[(kEntriesPerStep * pair) + 1U]; // MISRA D-002
}

// The map entry that names this object.
std::uint32_t EntryOf(const MappableObject& object) noexcept
{
    return (std::uint32_t{object.index} << kIndexShift) | (std::uint32_t{object.sub} << kSubShift) |
           std::uint32_t{object.length_bits};
}

// What the objects are ordered by.
std::uint32_t KeyAt(const DeviceConfig& config, const std::uint32_t place) noexcept
{
    return EntryOf(config.objects[place]) >> kKeyShift; // MISRA D-002
}

// The objects are in ascending order of index and sub. Those before `first` are too small; of the `left` ones from
// there on the one in the middle decides which half is looked at next.
std::uint16_t FindObject(const DeviceConfig& config, const std::uint32_t entry) noexcept
{
    const std::uint32_t key = entry >> kKeyShift;
    std::uint32_t first = 0U;
    std::uint32_t left = config.object_count;
    while (left != 0U)
    {
        const std::uint32_t half = left / 2U;
        const bool is_above = KeyAt(config, first + half) < key;
        first += is_above ? (half + 1U) : 0U;
        left = is_above ? (left - half - 1U) : half;
    }
    const bool is_it = (first < config.object_count) && (KeyAt(config, first) == key);
    return is_it ? static_cast<std::uint16_t>(first) : kNoObject;
}

// [SRS_CFG_033]
bool IsDummy(const DeviceConfig& config, const Record& record, const std::uint32_t entry) noexcept
{
    const std::uint32_t type = (entry >> kIndexShift) - 1U; // Index 0 becomes greater than every type.
    if ((config.dummies != DummyMapping::kAllowed) || (record.grants.Of(Grant::kDirection) != kDirectionConsumer))
    {
        return false;
    }
    return (type < kLastDummyIndex) && ((entry & kSubAndLength) == kDummyBits[type]);
}

// Whether a place is that of the object that the entry names, for this direction.
bool Leads(const DeviceConfig& config, const Record& record, const std::uint16_t place,
           const std::uint32_t entry) noexcept
{
    const bool is_consumer = record.grants.Of(Grant::kDirection) == kDirectionConsumer;
    const MapAccess wanted = is_consumer ? MapAccess::kConsumer : MapAccess::kProducer;
    const MappableObject& object = ObjectAt(config, place);
    return (EntryOf(object) == entry) && (object.access == wanted);
}

// Whether a place is that of no object, and the entry a dummy entry.
bool LeadsNowhere(const DeviceConfig& config, const Record& record, const std::uint16_t place,
                  const std::uint32_t entry) noexcept
{
    return (place == kNoObject) && IsDummy(config, record, entry);
}

// Both entries name objects, or both are dummies; a static mapping has none.
bool IsStepOf(const DeviceConfig& config, const Record& record, const Mapping& mapping, const std::uint32_t pair,
              const Step& step) noexcept
{
    const std::uint32_t normal = NormalEntry(mapping.entries, pair);
    const std::uint32_t inverse = InverseEntry(mapping.entries, pair);
    if (Leads(config, record, step.normal, normal))
    {
        return Leads(config, record, step.inverse, inverse);
    }
    return (mapping.steps != nullptr) && LeadsNowhere(config, record, step.normal, normal) &&
           LeadsNowhere(config, record, step.inverse, inverse);
}

// Whether an object of a static mapping lies where the one before it ended; `next` is then its end. [SRS_CFG_032]
bool Follows(const MappableObject& object, const std::uint8_t*& next) noexcept
{
    const bool follows = (object.place == next) && ((object.length_bits % kBitsPerByte) == 0U);
    next = object.place + (object.length_bits / kBitsPerByte); // MISRA D-002
    return follows;
}

// Whether one of so many entries names the object that this entry names, whatever length it gives it. A dummy entry
// names no object.
bool IsNamedBy(const DeviceConfig& config, const Record& record, const std::uint32_t entry,
               const std::uint32_t* const entries, const std::uint32_t count) noexcept
{
    bool is_named = false;
    for (std::uint32_t position = 0U; position < count; ++position)
    {
        if (((entries[position] ^ entry) >> kKeyShift) == 0U) // MISRA D-002
        {
            is_named = true;
        }
    }
    return is_named && !IsDummy(config, record, entry);
}

// What only Validate asks of an entry: length of the granularity and of the partner, and no object twice.
// [SRS_CFG_027]
bool FitsOthers(const DeviceConfig& config, const Record& record, const Mapping& mapping,
                const std::uint32_t position) noexcept
{
    const std::uint32_t entry = mapping.entries[position];                                  // MISRA D-002
    const std::uint32_t partner = mapping.entries[position - (position % kEntriesPerStep)]; // MISRA D-002
    const bool has_length =
        (((entry ^ partner) & kLengthBits) == 0U) && (((entry & kLengthBits) % config.granularity_bits) == 0U);
    return has_length && !IsNamedBy(config, record, entry, mapping.entries, position);
}

// The step of a pair of entries whose bits begin at `first_bit`, by a search for both objects.
Step StepOf(const DeviceConfig& config, const std::uint32_t* const entries, const std::uint32_t pair,
            const std::uint32_t first_bit) noexcept
{
    return Step{FindObject(config, NormalEntry(entries, pair)), FindObject(config, InverseEntry(entries, pair)),
                static_cast<std::uint8_t>(first_bit & kByteMask)};
}

void WorkOut(const DeviceConfig& config, const std::uint32_t* const entries, const std::uint32_t count,
             Step* const steps) noexcept
{
    std::uint32_t first_bit = 0U;
    for (std::uint32_t pair = 0U; pair < count; ++pair)
    {
        steps[pair] = StepOf(config, entries, pair, first_bit); // MISRA D-002
        first_bit += NormalEntry(entries, pair) & kLengthBits;
    }
}

// What Validate and Recheck have in common: each step is that of its entries, and the objects of a static mapping lie
// one behind the other in its two fields. Bits of all normal entries; 0 where something does not fit.
std::uint32_t Measured(const DeviceConfig& config, const Record& record, const Mapping& mapping) noexcept
{
    const std::uint8_t* next_normal = record.fields.normal;
    const std::uint8_t* next_inverse = record.fields.inverse;
    std::uint32_t total = 0U;
    std::uint32_t wrong = 0U;
    for (std::uint32_t pair = 0U; pair < (mapping.count / kEntriesPerStep); ++pair)
    {
        const Step step = (mapping.steps != nullptr) ? mapping.steps[pair] // MISRA D-002
                                                     : StepOf(config, mapping.entries, pair, total);
        if (!IsStepOf(config, record, mapping, pair, step))
        {
            ++wrong;
        }
        if ((mapping.steps == nullptr) && !Follows(ObjectAt(config, step.normal), next_normal))
        {
            ++wrong;
        }
        if ((mapping.steps == nullptr) && !Follows(ObjectAt(config, step.inverse), next_inverse))
        {
            ++wrong;
        }
        if (step.first_bit != (total & kByteMask))
        {
            ++wrong;
        }
        total += NormalEntry(mapping.entries, pair) & kLengthBits;
    }
    return (wrong == 0U) ? total : 0U;
}

} // namespace

Mapping MappingOf(const Voice& voice, const std::size_t slot) noexcept
{
    const StaticMap& map = voice.config->srdos[slot].map; // MISRA D-002
    if (map.entries != nullptr)
    {
        return Mapping{map.entries, nullptr, Lesser(map.count, kMaxMapEntries), map.count, kMaxMapEntries};
    }
    const Storage& storage = voice.storage;
    const std::size_t first = slot * storage.map_entries;
    const std::uint32_t stored = storage.counts[slot]; // MISRA D-002
    const std::uint32_t limit = voice.config->map_entries;
    return Mapping{storage.entries + first, storage.steps + (first / kEntriesPerStep), // MISRA D-002
                   Lesser(stored, limit), stored, limit};
}

// A mapping that was validated has no more steps than there is room.
StepRange WorkedOut(Voice& voice, const std::size_t slot) noexcept
{
    const StaticMap& map = voice.config->srdos[slot].map; // MISRA D-002
    const std::uint32_t count = Lesser(map.count / kEntriesPerStep, kMaxStaticSteps);
    Step* const first = &voice.static_steps[0];
    WorkOut(*voice.config, map.entries, count, first);
    return StepRange{first, first + count}; // MISRA D-002
}

// [SRS_CFG_026, SRS_CFG_027, SRS_CFG_028, SRS_CFG_032]
ConfigFault Resolve(const DeviceConfig& config, Record& record, const Mapping& mapping) noexcept
{
    const std::uint32_t count = mapping.stored_count;
    if ((count == 0U) || ((count % kEntriesPerStep) != 0U) || (count > mapping.limit))
    {
        return ConfigFault::kMapping;
    }
    bool fits = true;
    for (std::uint32_t position = 0U; position < count; ++position)
    {
        if (!FitsOthers(config, record, mapping, position))
        {
            fits = false;
        }
    }
    if (mapping.steps != nullptr)
    {
        WorkOut(config, mapping.entries, count / kEntriesPerStep, mapping.steps);
    }
    const std::uint32_t total = Measured(config, record, mapping);
    if (!fits || (total == 0U))
    {
        return ConfigFault::kMapping;
    }
    if (total > kMaxPayloadBits)
    {
        return ConfigFault::kLengthExceeded;
    }
    record.grants.Set(Grant::kLength, LengthOf(total));
    record.mapped = MappedOf(LengthOf(total));
    record.spare_bits = SpareOf(total);
    record.total_bits = static_cast<std::uint8_t>(total);
    return ConfigFault::kNone;
}

bool SharesObject(const DeviceConfig& config, const Record& record, const Mapping& mapping,
                  const Mapping& other) noexcept
{
    bool shares = false;
    for (std::uint32_t position = 0U; position < mapping.count; ++position)
    {
        if (IsNamedBy(config, record, mapping.entries[position], other.entries, other.count)) // MISRA D-002
        {
            shares = true;
        }
    }
    return shares;
}

bool HoldsSteps(const DeviceConfig& config, const Record& record, const Mapping& mapping) noexcept
{
    if (!record.grants.Is(Grant::kResolved, kYes))
    {
        return false; // Its steps may be those of other entries, or of none.
    }
    const std::uint32_t total = Measured(config, record, mapping);
    if (total != record.total_bits)
    {
        return false;
    }
    return record.grants.Is(Grant::kLength, LengthOf(total)) && (SpareOf(total) == record.spare_bits) &&
           AreSame(MappedOf(LengthOf(total)), record.mapped);
}

} // namespace counterpoint::channel_a
