// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/objects/service_length.hpp"

#include "canopen/cia301/dictionary/entry_value.hpp"

#include <algorithm>
#include <array>

namespace counterpoint::runtime
{
namespace
{
using cia301::DataType;
using cia301::SdoAbort;

DataType NumberType(const bool is_signed, const std::uint32_t size_bytes)
{
    switch (size_bytes)
    {
    case 1U:
        return is_signed ? DataType::kInteger8 : DataType::kUnsigned8;
    case 2U:
        return is_signed ? DataType::kInteger16 : DataType::kUnsigned16;
    default:
        return is_signed ? DataType::kInteger32 : DataType::kUnsigned32;
    }
}

/// Whose bytes are those of no integer.
constexpr std::array kNoNumbers{DataType::kReal32,         DataType::kReal64,        DataType::kVisibleString,
                                DataType::kOctetString,    DataType::kUnicodeString, DataType::kTimeOfDay,
                                DataType::kTimeDifference, DataType::kDomain};
} // namespace

void TakeServiceLength(cia301::Entry& entry) noexcept
{
    std::array<std::uint8_t, sizeof(std::uint64_t)> bytes{};
    const cia301::Reading reading = cia301::ReadEntry(entry, {bytes.data(), static_cast<std::uint32_t>(bytes.size())});
    // An error history without errors has its length, too.
    const bool has_length = reading.abort == SdoAbort::kNone || reading.abort == SdoAbort::kNoData;
    if (has_length && reading.size_bytes != entry.size_bytes)
    {
        entry.type = NumberType(cia301::IsSigned(entry.type), reading.size_bytes);
        entry.size_bytes = reading.size_bytes;
    }
}

void FitNumber(std::vector<std::uint8_t>& value, const DataType type, const std::uint32_t size_bytes)
{
    constexpr std::uint8_t kSign = 0x80U;
    if (std::find(kNoNumbers.begin(), kNoNumbers.end(), type) != kNoNumbers.end())
    {
        value.clear();
        return;
    }
    const bool is_negative = cia301::IsSigned(type) && !value.empty() && (value.back() & kSign) != 0U;
    const bool is_longer = value.size() > size_bytes;
    const bool fits = !is_longer || std::all_of(value.begin() + static_cast<std::ptrdiff_t>(size_bytes), value.end(),
                                                [](const std::uint8_t byte) { return byte == 0U; });
    if (fits && !is_negative)
    {
        value.resize(size_bytes);
    }
}
} // namespace counterpoint::runtime
