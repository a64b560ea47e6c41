// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/mapping.hpp"

#include "channel_b/words.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

/// Entries of a static mapping at most.
constexpr std::uint8_t kLargestMapping = 2U * kMaxPayloadBits;
/// Not the place of an object, and the place of a dummy entry.
constexpr std::uint16_t kNoPlace = 0xFFFFU;
constexpr std::uint16_t kDummyPlace = 0xFFFEU;

/// Lengths of the data types that stand for an object nobody wants; the index is the row.
constexpr std::uint8_t kDummyBits[kLastDummyIndex + 1U] = {0U, 1U, 8U, 16U, 32U, 8U, 16U, 32U}; // MISRA D-001

[[nodiscard]] std::uint32_t LengthOf(std::uint32_t entry) noexcept
{
    return entry & 0xFFU;
}

/// Whether the entry has the form of a dummy: no length goes with index 0. [SRS_CFG_033]
[[nodiscard]] bool IsDummy(std::uint32_t entry) noexcept
{
    const std::uint32_t index = entry >> 16U;
    const std::uint32_t bits = kDummyBits[(index <= kLastDummyIndex) ? index : 0U]; // MISRA D-002
    return (bits != 0U) && ((entry & 0xFFFFU) == bits);
}

/// Whether one of the first `count` entries names the object that this entry names; dummies name none.
[[nodiscard]] bool IsNamedAmong(const Mapping& mapping, std::uint32_t count, std::uint32_t entry) noexcept
{
    if (IsDummy(entry))
    {
        return false;
    }
    for (std::uint32_t index = 0U; index < count; ++index)
    {
        if ((mapping.entries[index] >> 8U) == (entry >> 8U))
        {
            return true;
        }
    }
    return false;
}

/// Whether an entry before this one names the same object.
[[nodiscard]] bool IsNamedBefore(const Mapping& mapping, std::uint32_t index) noexcept
{
    return IsNamedAmong(mapping, index, mapping.entries[index]);
}

/// Whether any object is named by both.
[[nodiscard]] bool HaveCommonObject(const Mapping& mapping, const Mapping& other) noexcept
{
    for (std::uint32_t index = 0U; index < mapping.count; ++index)
    {
        if (IsNamedAmong(other, other.count, mapping.entries[index]))
        {
            return true;
        }
    }
    return false;
}

/// [SRS_CFG_026]
[[nodiscard]] bool IsCountRight(const Mapping& mapping) noexcept
{
    return (mapping.count == mapping.declared) && (mapping.count != 0U) && ((mapping.count % 2U) == 0U);
}

/// How many bits the data of a frame have: those of the normal entries.
[[nodiscard]] std::uint32_t BitsOf(const Mapping& mapping) noexcept
{
    std::uint32_t bits = 0U;
    for (std::uint32_t index = 0U; index < mapping.count; index += 2U)
    {
        bits += LengthOf(mapping.entries[index]);
    }
    return bits;
}

/// How far an object's bits move the others in the word. What fills the word alone has no others; no corrupted entry
/// shifts by more than the word has.
[[nodiscard]] std::uint32_t Within(std::uint32_t at) noexcept
{
    return at % kMaxPayloadBits;
}

} // namespace

void Mappings::Restart(const DeviceConfig& config) noexcept
{
    x_objects.Restart(config);
    x_entries = (config.map_entries < x_room) ? config.map_entries : x_room;
    for (SlotIndex slot = 0U; slot < x_settings.Count(); ++slot)
    {
        x_columns.fields[slot] = StaticFields{nullptr, nullptr};
        x_columns.mapped[slot] = 0U;
        x_columns.length_bytes[slot] = 0U;
        for (std::uint32_t index = 0U; index < x_room; ++index)
        {
            x_columns.entries[FirstEntryOf(slot) + index] = 0U;
        }
    }
}

/// [SRS_CFG_020, SRS_CFG_032]
Mapping Mappings::Of(SlotIndex slot) const noexcept
{
    const StaticMap& map = x_settings.Setup(slot).map;
    if (map.entries != nullptr)
    {
        return Mapping{
            {map.entries}, {nullptr}, map.count, (map.count < kLargestMapping) ? map.count : kLargestMapping};
    }
    const std::size_t first = FirstEntryOf(slot);
    const std::uint8_t declared = x_settings.MapCount(slot);
    return Mapping{{&x_columns.entries[first]},
                   {&x_columns.places[first]},
                   declared,
                   (declared < x_entries) ? declared : x_entries};
}

/// [SRS_CFG_003]
bool Mappings::StoreEntry(SlotIndex slot, std::uint8_t sub, std::uint32_t value) noexcept
{
    if (IsStatic(slot) || (sub == 0U) || (sub > x_entries))
    {
        return false;
    }
    x_columns.entries[FirstEntryOf(slot) + (sub - 1U)] = value;
    return true;
}

/// [SRS_CFG_003]
std::uint32_t Mappings::LoadEntry(SlotIndex slot, std::uint8_t sub) const noexcept
{
    const Mapping mapping = Of(slot);
    const std::uint8_t last = IsStatic(slot) ? mapping.count : x_entries;
    if ((sub == 0U) || (sub > last))
    {
        return 0U;
    }
    return mapping.entries[sub - 1U];
}

/// What an entry behind the last one leads to is no object.
void Mappings::FindPlaces(SlotIndex slot, const Mapping& mapping) noexcept
{
    const bool is_consumer = x_settings.Direction(slot) == kDirectionConsumer;
    const bool may_be_dummy = is_consumer && (x_settings.Config().dummies == DummyMapping::kAllowed);
    for (std::uint32_t index = 0U; index < x_entries; ++index)
    {
        std::uint32_t place = kNoPlace;
        if (index < mapping.count)
        {
            const std::uint32_t entry = mapping.entries[index];
            place = (may_be_dummy && IsDummy(entry)) ? kDummyPlace : x_objects.Find(entry);
        }
        x_columns.places[FirstEntryOf(slot) + index] = static_cast<std::uint16_t>(place);
    }
}

/// The rules that need no object, for a normal entry and the inverse entry behind it. [SRS_CFG_027, SRS_CFG_033]
bool Mappings::IsPairAllowed(const Mapping& mapping, std::uint32_t index) const noexcept
{
    const std::uint32_t normal = mapping.entries[index];
    const std::uint32_t inverse = mapping.entries[index + 1U];
    const std::uint32_t granularity_bits = x_settings.Config().granularity_bits; // A power of 2.
    if (LengthOf(normal) != LengthOf(inverse))
    {
        return false;
    }
    if ((LengthOf(normal) & (granularity_bits - 1U)) != 0U)
    {
        return false;
    }
    if (IsDummy(normal) != IsDummy(inverse))
    {
        return false;
    }
    return !(IsNamedBefore(mapping, index) || IsNamedBefore(mapping, index + 1U));
}

/// Two producers may send one object; a consumer has its objects for itself. [SRS_CFG_037]
bool Mappings::IsShared(SlotIndex slot) const noexcept
{
    const Mapping mapping = Of(slot);
    const bool is_consumer = x_settings.Direction(slot) == kDirectionConsumer;
    for (SlotIndex lower = 0U; lower < slot; ++lower)
    {
        const std::uint8_t direction = x_settings.Direction(lower);
        const bool is_writing = is_consumer || (direction == kDirectionConsumer);
        if ((direction != kDirectionOff) && is_writing && HaveCommonObject(mapping, Of(lower)))
        {
            return true;
        }
    }
    return false;
}

/// The places that it finds count only after a Validate without fault. [SRS_CFG_026, SRS_CFG_027, SRS_CFG_028,
/// SRS_CFG_037]
ConfigFault Mappings::Resolve(SlotIndex slot) noexcept
{
    const Mapping mapping = Of(slot);
    const std::uint32_t bits = BitsOf(mapping);
    if (!IsCountRight(mapping))
    {
        return ConfigFault::kMapping;
    }
    if (mapping.places.first != nullptr)
    {
        FindPlaces(slot, mapping);
    }
    for (std::uint32_t index = 0U; index < mapping.count; index += 2U)
    {
        if (!IsPairAllowed(mapping, index))
        {
            return ConfigFault::kMapping;
        }
    }
    if (!IsRight(slot))
    {
        return ConfigFault::kMapping;
    }
    if (bits > kMaxPayloadBits)
    {
        return ConfigFault::kLengthExceeded;
    }
    if (IsShared(slot))
    {
        return ConfigFault::kMapping;
    }
    x_columns.mapped[slot] = LowBits(bits);
    x_columns.length_bytes[slot] = static_cast<std::uint8_t>(BytesFor(bits));
    return ConfigFault::kNone;
}

/// [SRS_CFG_027, SRS_CFG_030, SRS_CFG_032, SRS_CFG_033]
bool Mappings::IsRight(SlotIndex slot) const noexcept
{
    const Mapping mapping = Of(slot);
    const bool is_static = mapping.places.first == nullptr;
    const bool is_sent = x_settings.Direction(slot) == kDirectionProducer;
    const MapAccess access = is_sent ? MapAccess::kProducer : MapAccess::kConsumer;
    StaticFields next = x_columns.fields[slot];
    for (std::uint32_t index = 0U; index < mapping.count; ++index)
    {
        const std::uint32_t entry = mapping.entries[index];
        const std::uint32_t place = PlaceOf(mapping, index);
        const bool is_dummy = IsDummy(entry) ? (place == kDummyPlace) : false;
        if (!(is_dummy || x_objects.IsNamed(place, entry, access)))
        {
            return false;
        }
        if (is_static)
        {
            std::uint8_t*& expected = ((index % 2U) == 0U) ? next.normal : next.inverse;
            if ((x_objects.Begin(place) != expected) || ((LengthOf(entry) % kBitsPerByte) != 0U))
            {
                return false;
            }
            expected = x_objects.End(place);
        }
    }
    return true;
}

/// [SRS_CHB_191]
bool Mappings::IsMeasured(SlotIndex slot) const noexcept
{
    const std::uint32_t bits = BitsOf(Of(slot));
    return (MappedBits(slot) == LowBits(bits)) && (LengthBytes(slot) == BytesFor(bits));
}

/// [SRS_PROD_005, SRS_CFG_036]
std::uint64_t Mappings::ReadInverse(SlotIndex slot) const noexcept
{
    const Mapping mapping = Of(slot);
    std::uint64_t data = 0U;
    for (std::uint32_t pair = mapping.count / 2U; pair != 0U; --pair) // The highest bits first.
    {
        const std::uint32_t index = (2U * pair) - 1U;
        data = (data << Within(LengthOf(mapping.entries[index]))) | x_objects.Read(PlaceOf(mapping, index));
    }
    return data;
}

/// The bits of a dummy, or of a corrupted place, go nowhere. [SRS_CFG_033, SRS_CFG_036]
void Mappings::WriteInverse(SlotIndex slot, std::uint64_t data) const noexcept
{
    const Mapping mapping = Of(slot);
    std::uint64_t rest = data;
    for (std::uint32_t index = 1U; index < mapping.count; index += 2U)
    {
        x_objects.Write(PlaceOf(mapping, index), rest);
        rest >>= Within(LengthOf(mapping.entries[index]));
    }
}

/// Gathered like the data of a producer. [SRS_REL_011, SRS_CFG_033, SRS_CFG_036]
bool Mappings::HoldsInverse(SlotIndex slot, std::uint64_t data) const noexcept
{
    const Mapping mapping = Of(slot);
    std::uint64_t held = 0U;
    std::uint64_t of_dummies = 0U;
    for (std::uint32_t pair = mapping.count / 2U; pair != 0U; --pair) // The highest bits first.
    {
        const std::uint32_t index = (2U * pair) - 1U;
        const std::uint32_t bits = LengthOf(mapping.entries[index]);
        const std::uint32_t place = PlaceOf(mapping, index);
        held <<= Within(bits);
        of_dummies <<= Within(bits);
        if (x_objects.IsThere(place))
        {
            held |= x_objects.Read(place);
        }
        else if (place == kDummyPlace)
        {
            of_dummies |= LowBits(bits);
        }
        else
        {
            return false;
        }
    }
    return ((held ^ data) & MappedBits(slot) & ~of_dummies) == 0U;
}

} // namespace counterpoint::channel_b
