// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/dictionary/dictionary.hpp"

#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/dictionary/entry_value.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint32_t kMaxNumberBytes = 8U;

/// The kernel's codes are those of CiA 301 by number.
SdoAbort FromKernel(const AbortCode code) noexcept
{
    return static_cast<SdoAbort>(static_cast<std::uint32_t>(code));
}

bool IsKernels(const std::uint16_t index) noexcept
{
    return (index >= kFirstKernelIndex) && (index <= kLastKernelIndex);
}

} // namespace

Dictionary::Dictionary(const EntryTable& table, ForeignObjects& foreign) noexcept
    : table_(table), foreign_(foreign), state_(NmtState::kInitialising)
{
}

void Dictionary::SetNmtState(const NmtState state) noexcept
{
    state_ = state;
}

Reading Dictionary::Read(const ObjectAddress& address, const Room& room) noexcept
{
    const Entry* const entry = Find(address);
    Reading reading{SdoAbort::kNone, 0U};
    if (entry == nullptr)
    {
        reading = ReadForeign(address, room);
    }
    else
    {
        reading.abort = ReadRight(*entry);
        if (reading.abort == SdoAbort::kNone)
        {
            reading = ReadEntry(*entry, room);
        }
    }
    return reading;
}

SdoAbort Dictionary::Write(const ObjectAddress& address, const Bytes& value) noexcept
{
    return Put(address, value, Attempt::kFirst);
}

SdoAbort Dictionary::WriteAgain(const ObjectAddress& address, const Bytes& value) noexcept
{
    return Put(address, value, Attempt::kAgain);
}

SdoAbort Dictionary::Put(const ObjectAddress& address, const Bytes& value, const Attempt attempt) noexcept
{
    const Entry* const entry = Find(address);
    SdoAbort abort = SdoAbort::kNone;
    if (entry == nullptr)
    {
        abort = WriteForeign(address, value);
    }
    else
    {
        // What was taken goes on to its end in whatever state that comes. [SRS_OBD_530]
        abort = (attempt == Attempt::kAgain) ? SdoAbort::kNone : WriteRight(*entry);
        if (abort == SdoAbort::kNone)
        {
            abort = WriteEntry(*entry, value, attempt);
        }
    }
    return abort;
}

SdoAbort Dictionary::MayWrite(const ObjectAddress& address, const std::uint32_t size_bytes) noexcept
{
    const Entry* const entry = Find(address);
    SdoAbort abort = SdoAbort::kNone;
    if (entry == nullptr)
    {
        abort = Missing(address, foreign_.Read(address).abort);
        if ((abort == SdoAbort::kNone) && (size_bytes != kUnknownLength) && (size_bytes > kMaxPayloadBytes))
        {
            abort = SdoAbort::kLengthMismatch;
        }
    }
    else
    {
        abort = WriteRight(*entry);
        if ((abort == SdoAbort::kNone) && (size_bytes != kUnknownLength))
        {
            abort = CheckLength(*entry, size_bytes);
        }
    }
    return abort;
}

Reading Dictionary::SizeOf(const ObjectAddress& address) noexcept
{
    const Entry* const entry = Find(address);
    Reading reading{SdoAbort::kNone, 0U};
    if (entry != nullptr)
    {
        reading.size_bytes = entry->size_bytes;
    }
    else
    {
        const ObjectReading answer = foreign_.Read(address);
        reading = Reading{Missing(address, answer.abort), answer.data.size_bytes};
    }
    return reading;
}

NumberReading Dictionary::ReadNumber(const ObjectAddress& address) noexcept
{
    const Entry* const entry = Find(address);
    std::uint8_t bytes[kMaxNumberBytes] = {};
    const Room room{bytes, kMaxNumberBytes};
    const Reading reading = (entry == nullptr) ? ReadForeign(address, room) : ReadEntry(*entry, room);
    NumberReading number{reading.abort, 0U};
    if ((reading.abort == SdoAbort::kOutOfMemory) || ((reading.abort == SdoAbort::kNone) && (reading.size_bytes == 0U)))
    {
        number.abort = SdoAbort::kLengthMismatch;
    }
    else if (reading.abort == SdoAbort::kNone)
    {
        const DataType type = (entry == nullptr) ? DataType::kUnsigned64 : entry->type;
        number.value = NumberOf(type, Bytes{bytes, reading.size_bytes});
    }
    return number;
}

SdoAbort Dictionary::WriteNumber(const ObjectAddress& address, const std::uint64_t value,
                                 const std::uint32_t size_bytes) noexcept
{
    return PutNumber(address, value, size_bytes, Attempt::kFirst);
}

SdoAbort Dictionary::WriteNumberAgain(const ObjectAddress& address, const std::uint64_t value,
                                      const std::uint32_t size_bytes) noexcept
{
    return PutNumber(address, value, size_bytes, Attempt::kAgain);
}

SdoAbort Dictionary::PutNumber(const ObjectAddress& address, const std::uint64_t value, const std::uint32_t size_bytes,
                               const Attempt attempt) noexcept
{
    SdoAbort abort = SdoAbort::kLengthMismatch;
    if ((size_bytes > 0U) && (size_bytes <= kMaxNumberBytes))
    {
        const Entry* const entry = Find(address);
        std::uint8_t bytes[kMaxNumberBytes] = {};
        ToLittleEndian(value, bytes, size_bytes);
        const Bytes image{bytes, size_bytes};
        if (entry == nullptr)
        {
            abort = WriteForeign(address, image);
        }
        else if (entry->size_bytes == size_bytes)
        {
            abort = WriteEntry(*entry, image, attempt);
        }
    }
    return abort;
}

const Entry* Dictionary::Find(const ObjectAddress& address) const noexcept
{
    const std::uint32_t key = KeyOf(address.index, address.sub);
    const std::uint32_t at = Position(key);
    const Entry* found = nullptr;
    if ((at < table_.count) && (KeyOf(table_.entries[at].index, table_.entries[at].sub) == key))
    {
        found = &table_.entries[at];
    }
    return found;
}

/// Number of entries below the key.
std::uint32_t Dictionary::Position(const std::uint32_t key) const noexcept
{
    std::uint32_t low = 0U;
    std::uint32_t high = table_.count;
    while (low < high)
    {
        const std::uint32_t middle = low + ((high - low) / 2U);
        if (KeyOf(table_.entries[middle].index, table_.entries[middle].sub) < key)
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

/// What the bus is told if the own table has no such entry: the kernel's word, unless only the own table knows the
/// index.
SdoAbort Dictionary::Missing(const ObjectAddress& address, const AbortCode answer) const noexcept
{
    const std::uint32_t at = Position(KeyOf(address.index, address.sub));
    const bool is_before = (at > 0U) && (table_.entries[at - 1U].index == address.index);
    const bool is_here = (at < table_.count) && (table_.entries[at].index == address.index);
    SdoAbort abort = FromKernel(answer);
    if ((answer == AbortCode::kObjectUnknown) && (is_before || is_here) && !IsKernels(address.index))
    {
        abort = SdoAbort::kSubUnknown;
    }
    return abort;
}

bool Dictionary::IsNow(const std::uint8_t states) const noexcept
{
    const bool is_pre = (state_ == NmtState::kPreOperational) && ((states & kInPreOperational) != 0U);
    return is_pre || ((state_ == NmtState::kOperational) && ((states & kInOperational) != 0U));
}

SdoAbort Dictionary::ReadRight(const Entry& entry) const noexcept
{
    SdoAbort abort = SdoAbort::kUnsupportedAccess;
    switch (entry.access)
    {
    case Access::kConstant:
    case Access::kReadOnly:
    case Access::kReadWrite:
        abort = IsNow(entry.readable_in) ? SdoAbort::kNone : SdoAbort::kDeviceState;
        break;
    case Access::kWriteOnly:
        abort = SdoAbort::kWriteOnly;
        break;
    case Access::kInvalid:
    default:
        break;
    }
    return abort;
}

SdoAbort Dictionary::WriteRight(const Entry& entry) const noexcept
{
    SdoAbort abort = SdoAbort::kUnsupportedAccess;
    switch (entry.access)
    {
    case Access::kConstant:
    case Access::kReadOnly:
        abort = SdoAbort::kReadOnly;
        break;
    case Access::kWriteOnly:
    case Access::kReadWrite:
        abort = IsNow(entry.writable_in) ? SdoAbort::kNone : SdoAbort::kDeviceState;
        break;
    case Access::kInvalid:
    default:
        break;
    }
    return abort;
}

Reading Dictionary::ReadForeign(const ObjectAddress& address, const Room& room) noexcept
{
    const ObjectReading answer = foreign_.Read(address);
    Reading reading{Missing(address, answer.abort), answer.data.size_bytes};
    if ((reading.abort == SdoAbort::kNone) && (reading.size_bytes > room.size_bytes))
    {
        reading.abort = SdoAbort::kOutOfMemory;
    }
    if (reading.abort == SdoAbort::kNone)
    {
        for (std::uint32_t i = 0U; i < reading.size_bytes; ++i)
        {
            room.data[i] = answer.data.bytes[i];
        }
    }
    return reading;
}

SdoAbort Dictionary::WriteForeign(const ObjectAddress& address, const Bytes& value) noexcept
{
    SdoAbort abort = SdoAbort::kLengthMismatch;
    if (value.size_bytes <= kMaxPayloadBytes)
    {
        ObjectData data{};
        data.size_bytes = static_cast<std::uint8_t>(value.size_bytes);
        for (std::uint32_t i = 0U; i < value.size_bytes; ++i)
        {
            data.bytes[i] = value.data[i];
        }
        abort = Missing(address, foreign_.Write(address, data));
    }
    return abort;
}

} // namespace counterpoint::cia301
