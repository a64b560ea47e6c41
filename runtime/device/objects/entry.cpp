// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/objects/entry.hpp"

#include "canopen/cia306/safety/device_parameters.hpp"

#include <algorithm>
#include <cctype>

namespace counterpoint::runtime
{
using cia301::DataType;

namespace
{
constexpr std::uint16_t kLastFixed = 0x5F05U;
} // namespace

bool IsStore(const std::uint16_t index)
{
    return index == 0x1010U || index == 0x1011U;
}

bool IsFixedAtStart(const std::uint16_t index)
{
    return index >= cia306::kDeviceParametersIndex && index <= kLastFixed;
}
DataType TypeOf(const cia306::Entry& entry)
{
    const bool is_known = entry.data_type != 0U && entry.data_type <= static_cast<std::uint16_t>(DataType::kUnsigned64);
    if (is_known && entry.type.kind != cia306::DataKind::kUnknown)
    {
        return static_cast<DataType>(entry.data_type);
    }
    return (entry.type.kind == cia306::DataKind::kUnsigned) ? DataType::kUnsigned8 : DataType::kOctetString;
}

std::uint8_t UsesOf(const cia306::Entry& entry)
{
    const bool is_sent = entry.access != cia306::Access::kWriteOnly && entry.access != cia306::Access::kReadWriteOutput;
    const bool is_received = !entry.IsFixed() && entry.access != cia306::Access::kReadWriteInput;
    const unsigned uses = (is_sent ? cia301::kInTpdo : 0U) | (is_received ? cia301::kInRpdo : 0U);
    const bool is_kept = !entry.IsFixed() && entry.access != cia306::Access::kWriteOnly && entry.index != 0x1003U &&
                         !IsStore(entry.index) && !IsFixedAtStart(entry.index);
    return static_cast<std::uint8_t>((entry.is_pdo_mappable ? uses : 0U) | (is_kept ? cia301::kStored : 0U));
}

cia301::Access AccessOf(const cia306::Entry& entry)
{
    switch (entry.access)
    {
    case cia306::Access::kConstant:
        return cia301::Access::kConstant;
    case cia306::Access::kReadOnly:
        return cia301::Access::kReadOnly;
    case cia306::Access::kWriteOnly:
        return cia301::Access::kWriteOnly;
    case cia306::Access::kReadWrite:
    case cia306::Access::kReadWriteInput:
    case cia306::Access::kReadWriteOutput:
        return cia301::Access::kReadWrite;
    case cia306::Access::kUnknown:
        break;
    }
    return cia301::Access::kInvalid;
}

std::vector<std::uint8_t> OctetsOf(const std::string& text)
{
    std::string digits;
    for (const char letter : text)
    {
        if (std::isspace(static_cast<unsigned char>(letter)) == 0)
        {
            digits += letter;
        }
    }
    const bool is_hexadecimal =
        !digits.empty() && digits.size() % 2U == 0U &&
        std::all_of(digits.begin(), digits.end(), [](const unsigned char c) { return std::isxdigit(c) != 0; });
    std::vector<std::uint8_t> octets;
    if (!is_hexadecimal)
    {
        octets.assign(text.begin(), text.end());
    }
    for (std::size_t place = 0U; is_hexadecimal && place < digits.size(); place += 2U)
    {
        octets.push_back(static_cast<std::uint8_t>(std::stoul(digits.substr(place, 2U), nullptr, 16)));
    }
    return octets;
}
} // namespace counterpoint::runtime
