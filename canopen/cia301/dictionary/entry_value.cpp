// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/dictionary/entry_value.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint64_t kSignBit = 0x8000000000000000U;
constexpr std::uint32_t kMaxNumberBytes = 8U;

constexpr DataType kSignedTypes[] = {DataType::kInteger8,  DataType::kInteger16, DataType::kInteger24,
                                     DataType::kInteger32, DataType::kInteger40, DataType::kInteger48,
                                     DataType::kInteger56, DataType::kInteger64};
constexpr DataType kUnsignedTypes[] = {DataType::kUnsigned8,  DataType::kUnsigned16, DataType::kUnsigned24,
                                       DataType::kUnsigned32, DataType::kUnsigned40, DataType::kUnsigned48,
                                       DataType::kUnsigned56, DataType::kUnsigned64};

std::uint32_t LengthOf(const Entry& entry) noexcept
{
    return (entry.length_bytes == nullptr) ? entry.size_bytes : *entry.length_bytes;
}

/// Order of signed numbers is that of unsigned ones with the sign bit inverted.
std::uint64_t Ordered(const DataType type, const std::uint64_t number) noexcept
{
    return IsSigned(type) ? (number ^ kSignBit) : number;
}

} // namespace

bool IsSigned(const DataType type) noexcept
{
    bool is_signed = false;
    for (const DataType one : kSignedTypes)
    {
        is_signed = is_signed || (type == one);
    }
    return is_signed;
}

bool IsNumber(const DataType type) noexcept
{
    bool is_number = IsSigned(type);
    for (const DataType one : kUnsignedTypes)
    {
        is_number = is_number || (type == one);
    }
    return is_number;
}

std::uint64_t NumberOf(const DataType type, const Bytes& value) noexcept
{
    std::uint64_t number = FromLittleEndian(value.data, value.size_bytes);
    const std::uint32_t bits = 8U * value.size_bytes;
    if (IsSigned(type) && (bits < 64U) && (((number >> (bits - 1U)) & 1U) != 0U))
    {
        number |= ~std::uint64_t{0U} << bits;
    }
    return number;
}

SdoAbort CheckLength(const Entry& entry, const std::uint32_t size_bytes) noexcept
{
    SdoAbort abort = SdoAbort::kNone;
    if (size_bytes > entry.size_bytes)
    {
        abort = SdoAbort::kTooLong;
    }
    else if ((size_bytes < entry.size_bytes) && (entry.length_bytes == nullptr))
    {
        abort = SdoAbort::kTooShort;
    }
    return abort;
}

SdoAbort CheckLimits(const Entry& entry, const Bytes& value) noexcept
{
    SdoAbort abort = SdoAbort::kNone;
    if (entry.type == DataType::kBoolean)
    {
        abort = (FromLittleEndian(value.data, value.size_bytes) > 1U) ? SdoAbort::kValueRange : SdoAbort::kNone;
    }
    else if ((entry.limits != nullptr) && IsNumber(entry.type) && (value.size_bytes <= kMaxNumberBytes))
    {
        const std::uint64_t number = Ordered(entry.type, NumberOf(entry.type, value));
        const std::uint64_t low = Ordered(entry.type, entry.limits->low);
        const std::uint64_t high = Ordered(entry.type, entry.limits->high);
        if (high < low)
        {
            abort = SdoAbort::kLimitsContradict;
        }
        else if (number > high)
        {
            abort = SdoAbort::kValueHigh;
        }
        else if (number < low)
        {
            abort = SdoAbort::kValueLow;
        }
    }
    return abort;
}

Reading ReadEntry(const Entry& entry, const Room& room) noexcept
{
    Reading reading{SdoAbort::kGeneral, 0U};
    if (entry.read_hook != nullptr)
    {
        reading = entry.read_hook->OnRead(ObjectAddress{entry.index, entry.sub}, room);
        if ((reading.abort == SdoAbort::kNone) && (reading.size_bytes > room.size_bytes))
        {
            reading.abort = SdoAbort::kOutOfMemory; // The hook promised otherwise; nobody reads beyond the room.
        }
    }
    else if (entry.place != nullptr)
    {
        reading = Reading{SdoAbort::kOutOfMemory, LengthOf(entry)};
        if (reading.size_bytes <= room.size_bytes)
        {
            reading.abort = SdoAbort::kNone;
            for (std::uint32_t i = 0U; i < reading.size_bytes; ++i)
            {
                room.data[i] = entry.place[i];
            }
        }
    }
    return reading;
}

SdoAbort WriteEntry(const Entry& entry, const Bytes& value, const Attempt attempt) noexcept
{
    SdoAbort abort = CheckLength(entry, value.size_bytes);
    if (abort == SdoAbort::kNone)
    {
        abort = CheckLimits(entry, value);
    }
    if ((abort == SdoAbort::kNone) && (entry.write_hook != nullptr))
    {
        const ObjectAddress address{entry.index, entry.sub};
        abort = (attempt == Attempt::kAgain) ? entry.write_hook->OnWriteAgain(address, value)
                                             : entry.write_hook->OnWrite(address, value);
    }
    else if ((abort == SdoAbort::kNone) && (entry.place == nullptr))
    {
        abort = SdoAbort::kGeneral;
    }
    if ((abort == SdoAbort::kNone) && (entry.place != nullptr))
    {
        for (std::uint32_t i = 0U; i < value.size_bytes; ++i)
        {
            entry.place[i] = value.data[i];
        }
        if (entry.length_bytes != nullptr)
        {
            *entry.length_bytes = value.size_bytes;
        }
    }
    return abort;
}

bool HasObject(ReadHook& hook, const ObjectAddress& address) noexcept
{
    std::uint8_t bytes[kMaxNumberBytes] = {};
    const SdoAbort abort = hook.OnRead(address, Room{bytes, kMaxNumberBytes}).abort;
    return (abort != SdoAbort::kSubUnknown) && (abort != SdoAbort::kObjectUnknown);
}

} // namespace counterpoint::cia301
