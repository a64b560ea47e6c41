// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generate/element.hpp"

namespace counterpoint::generate
{
namespace
{
using cia306::DataKind;

constexpr std::uint16_t kVisibleString = 0x0009U;

/// The least of 8, 16, 32, 64 that is not below.
std::uint32_t Rounded(const std::uint8_t bits)
{
    std::uint32_t rounded = 8U;
    while (rounded < bits)
    {
        rounded *= 2U;
    }
    return rounded;
}
} // namespace

std::string CppTypeOf(const cia306::DataType& type)
{
    switch (type.kind)
    {
    case DataKind::kBoolean:
        return "bool";
    case DataKind::kSigned:
        return "std::int" + std::to_string(Rounded(type.bits)) + "_t";
    case DataKind::kUnsigned:
    case DataKind::kTime:
        return "std::uint" + std::to_string(Rounded(type.bits)) + "_t";
    case DataKind::kReal:
        return type.bits == 32U ? "float" : "double";
    case DataKind::kText:
    case DataKind::kStructure:
    case DataKind::kUnknown:
        break;
    }
    return "";
}

// The dictionary takes the length from the entry; the type tells sign and kind.
std::string TableTypeOf(const cia306::Entry& entry)
{
    switch (entry.type.kind)
    {
    case DataKind::kBoolean:
        return "kBoolean";
    case DataKind::kSigned:
        return "kInteger" + std::to_string(Rounded(entry.type.bits));
    case DataKind::kUnsigned:
    case DataKind::kTime:
        return "kUnsigned" + std::to_string(Rounded(entry.type.bits));
    case DataKind::kReal:
        return entry.type.bits == 32U ? "kReal32" : "kReal64";
    case DataKind::kText:
    case DataKind::kStructure:
    case DataKind::kUnknown:
        break;
    }
    if (entry.data_type == cia306::kDomainType)
    {
        return "kDomain";
    }
    return entry.data_type == kVisibleString ? "kVisibleString" : "kOctetString";
}

std::string TableAccessOf(const Element& element)
{
    switch (element.entry->access)
    {
    case cia306::Access::kConstant:
        return "kConstant";
    case cia306::Access::kWriteOnly:
        return "kWriteOnly";
    case cia306::Access::kReadWrite:
    case cia306::Access::kReadWriteInput:
    case cia306::Access::kReadWriteOutput:
        return "kReadWrite";
    case cia306::Access::kReadOnly:
    case cia306::Access::kUnknown:
        break;
    }
    return "kReadOnly";
}

std::string AccessName(const cia306::Access access)
{
    switch (access)
    {
    case cia306::Access::kConstant:
        return "const";
    case cia306::Access::kWriteOnly:
        return "wo";
    case cia306::Access::kReadWrite:
        return "rw";
    case cia306::Access::kReadWriteInput:
        return "rwr";
    case cia306::Access::kReadWriteOutput:
        return "rww";
    case cia306::Access::kReadOnly:
        return "ro";
    case cia306::Access::kUnknown:
        break;
    }
    return "no access told, taken for ro";
}
} // namespace counterpoint::generate
