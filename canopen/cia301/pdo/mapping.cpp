// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/pdo/mapping.hpp"

#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/dictionary/entry_value.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint32_t kDummies = 8U;
constexpr std::uint32_t kBooleanDummy = 1U;
constexpr std::uint32_t kByteBits = 8U;
constexpr std::uint32_t kHighResolution = 0x1013U;
/// Bits of the dummies 0001h to 0007h: BOOLEAN, INTEGER and UNSIGNED of 8, 16 and 32 bits.
constexpr std::uint8_t kDummyBits[kDummies] = {0U, 1U, 8U, 16U, 32U, 8U, 16U, 32U};

std::uint32_t BitsOf(const PdoField& field) noexcept
{
    return field.mapping & 0xFFU;
}

/// All ones below `bits`, 0 to 64.
std::uint64_t MaskOf(const std::uint32_t bits) noexcept
{
    return (bits >= kPdoBits) ? ~std::uint64_t{0U} : ((std::uint64_t{1U} << bits) - 1U);
}

/// A BOOLEAN is one bit, or a byte in devices that map whole bytes.
bool IsLength(const std::uint32_t bits, const bool is_boolean, const std::uint32_t object_bits) noexcept
{
    return (bits == object_bits) || (is_boolean && (bits == kByteBits));
}

bool IsLengthOf(const Entry& entry, const std::uint32_t mapping) noexcept
{
    const bool is_boolean = entry.type == DataType::kBoolean;
    return IsLength(mapping & 0xFFU, is_boolean, is_boolean ? 1U : (kByteBits * entry.size_bytes));
}

bool IsDummyField(const std::uint32_t mapping) noexcept
{
    const std::uint32_t index = mapping >> 16U;
    const bool is_dummy = (index > 0U) && (index < kDummies) && (((mapping >> 8U) & 0xFFU) == 0U);
    return is_dummy && IsLength(mapping & 0xFFU, index == kBooleanDummy, kDummyBits[index]);
}

std::uint64_t ValueOf(const PdoField& field) noexcept
{
    std::uint8_t bytes[kPdoBytes] = {};
    Reading reading{SdoAbort::kNoData, 0U};
    if (field.entry != nullptr)
    {
        reading = ReadEntry(*field.entry, Room{bytes, kPdoBytes});
    }
    const bool is_value = (reading.abort == SdoAbort::kNone);
    return is_value ? (FromLittleEndian(bytes, reading.size_bytes) & MaskOf(BitsOf(field))) : std::uint64_t{0U};
}

} // namespace

ObjectValue FetchField(const PdoMap& map, const std::uint8_t sub) noexcept
{
    ObjectValue value{SdoAbort::kNone, map.count, 1U};
    if (sub > map.room)
    {
        value.abort = SdoAbort::kSubUnknown;
    }
    else if (sub > 0U)
    {
        value = ObjectValue{SdoAbort::kNone, map.fields[sub - 1U].mapping, 4U};
    }
    return value;
}

SdoAbort ChangeMap(PdoMap& map, const bool is_valid, const FieldChange& change, Dictionary& dictionary) noexcept
{
    SdoAbort abort = SdoAbort::kUnsupportedAccess;
    if (!is_valid && (change.sub == 0U))
    {
        abort = WriteCount(map, change.value);
    }
    else if (!is_valid && (map.count == 0U))
    {
        abort = WriteField(map, change.sub, change.value, change.direction, dictionary);
    }
    return abort;
}

SdoAbort WriteField(PdoMap& map, const std::uint8_t sub, const std::uint32_t mapping, const std::uint8_t direction,
                    Dictionary& dictionary) noexcept
{
    const ObjectAddress address{static_cast<std::uint16_t>(mapping >> 16U),
                                static_cast<std::uint8_t>((mapping >> 8U) & 0xFFU)};
    const Entry* const entry = dictionary.Find(address);
    SdoAbort abort = SdoAbort::kNone;
    if ((sub == 0U) || (sub > map.room))
    {
        abort = SdoAbort::kSubUnknown;
    }
    else if ((mapping == 0U) || ((direction == kInRpdo) && IsDummyField(mapping)))
    {
        map.fields[sub - 1U] = PdoField{mapping, nullptr};
    }
    else if (entry == nullptr)
    {
        // The kernel's variables exist, but an SRDO is the only way to them.
        const SdoAbort missing = dictionary.SizeOf(address).abort;
        abort = (missing == SdoAbort::kNone) ? SdoAbort::kNotMappable : missing;
    }
    else if (((entry->uses & direction) == 0U) || !IsLengthOf(*entry, mapping) || (entry->size_bytes > kPdoBytes))
    {
        abort = SdoAbort::kNotMappable;
    }
    else
    {
        map.fields[sub - 1U] = PdoField{mapping, entry};
    }
    return abort;
}

SdoAbort WriteCount(PdoMap& map, const std::uint32_t count) noexcept
{
    SdoAbort abort = SdoAbort::kNone;
    std::uint32_t bits = 0U;
    if (count > kMaxPdoFields)
    {
        abort = SdoAbort::kValueRange;
    }
    else if (count > map.room)
    {
        abort = SdoAbort::kMapTooLong;
    }
    else
    {
        for (std::uint32_t i = 0U; i < count; ++i)
        {
            abort = (map.fields[i].mapping == 0U) ? SdoAbort::kObjectUnknown : abort;
            bits += BitsOf(map.fields[i]);
        }
        abort = ((abort == SdoAbort::kNone) && (bits > kPdoBits)) ? SdoAbort::kMapTooLong : abort;
    }
    if (abort == SdoAbort::kNone)
    {
        map.count = static_cast<std::uint8_t>(count);
        map.bits = static_cast<std::uint8_t>(bits);
    }
    return abort;
}

void PrepareMap(PdoMap& map, const std::uint8_t sub, const std::uint32_t value) noexcept
{
    if (sub == 0U)
    {
        map.count = static_cast<std::uint8_t>((value > 0xFFU) ? 0xFFU : value);
    }
    else if (sub <= map.room)
    {
        map.fields[sub - 1U] = PdoField{value, nullptr};
    }
}

SdoAbort ResolveMap(PdoMap& map, const std::uint8_t direction, Dictionary& dictionary) noexcept
{
    const std::uint8_t count = map.count;
    SdoAbort abort = SdoAbort::kNone;
    map.count = 0U;
    map.bits = 0U;
    for (std::uint8_t i = 0U; i < map.room; ++i)
    {
        const std::uint32_t mapping = map.fields[i].mapping;
        map.fields[i] = PdoField{};
        const SdoAbort one = WriteField(map, static_cast<std::uint8_t>(i + 1U), mapping, direction, dictionary);
        abort = ((abort == SdoAbort::kNone) && (i < count)) ? one : abort;
    }
    return (abort == SdoAbort::kNone) ? WriteCount(map, count) : abort;
}

void ClearMap(PdoMap& map) noexcept
{
    map.count = 0U;
    map.bits = 0U;
    for (std::uint8_t i = 0U; i < map.room; ++i)
    {
        map.fields[i] = PdoField{};
    }
}

std::uint8_t LengthOf(const PdoMap& map) noexcept
{
    return static_cast<std::uint8_t>((map.bits + 7U) / 8U);
}

PdoData Pack(const PdoMap& map) noexcept
{
    std::uint64_t word = 0U;
    std::uint32_t at = 0U;
    for (std::uint8_t i = 0U; (i < map.count) && (at < kPdoBits); ++i)
    {
        word |= ValueOf(map.fields[i]) << at;
        at += BitsOf(map.fields[i]);
    }
    PdoData data{};
    ToLittleEndian(word, data.bytes, kPdoBytes);
    return data;
}

bool IsChanged(const PdoMap& map, const PdoData& before, const PdoData& now) noexcept
{
    std::uint64_t changes = FromLittleEndian(before.bytes, kPdoBytes) ^ FromLittleEndian(now.bytes, kPdoBytes);
    std::uint32_t at = 0U;
    for (std::uint8_t i = 0U; (i < map.count) && (at < kPdoBits); ++i)
    {
        const bool is_time = (map.fields[i].mapping >> 16U) == kHighResolution;
        changes &= is_time ? ~(MaskOf(BitsOf(map.fields[i])) << at) : ~std::uint64_t{0U};
        at += BitsOf(map.fields[i]);
    }
    return changes != 0U;
}

void Unpack(const PdoMap& map, const PdoData& data) noexcept
{
    const std::uint64_t word = FromLittleEndian(data.bytes, kPdoBytes);
    std::uint32_t at = 0U;
    for (std::uint8_t i = 0U; (i < map.count) && (at < kPdoBits); ++i)
    {
        const PdoField& field = map.fields[i];
        if (field.entry != nullptr)
        {
            std::uint8_t bytes[kPdoBytes] = {};
            ToLittleEndian((word >> at) & MaskOf(BitsOf(field)), bytes, kPdoBytes);
            // A value beyond its limits stays on the bus: nobody waits for an answer to a PDO.
            static_cast<void>(WriteEntry(*field.entry, Bytes{bytes, field.entry->size_bytes}, Attempt::kFirst));
        }
        at += BitsOf(field);
    }
}

} // namespace counterpoint::cia301
