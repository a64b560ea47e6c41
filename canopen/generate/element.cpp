// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generate/element.hpp"

#include <array>
#include <utility>

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

/// Words of the file and of the table, by cia306::Access.
constexpr std::array<std::pair<const char*, const char*>, 7U> kAccessWords{{
    {"no access told, taken for ro", "kReadOnly"},
    {"ro", "kReadOnly"},
    {"wo", "kWriteOnly"},
    {"rw", "kReadWrite"},
    {"rwr", "kReadWrite"},
    {"rww", "kReadWrite"},
    {"const", "kConstant"},
}};

/// The C++ type of a number, and the enumerator of cia301::DataType; both empty for what is no number.
std::pair<std::string, std::string> WordsOf(const cia306::DataType& type)
{
    const std::string bits = std::to_string(Rounded(type.bits));
    switch (type.kind)
    {
    case DataKind::kBoolean:
        return {"bool", "kBoolean"};
    case DataKind::kSigned:
        return {"std::int" + bits + "_t", "kInteger" + bits};
    case DataKind::kUnsigned:
    case DataKind::kTime:
        return {"std::uint" + bits + "_t", "kUnsigned" + bits};
    case DataKind::kReal:
        return {type.bits == 32U ? "float" : "double", type.bits == 32U ? "kReal32" : "kReal64"};
    case DataKind::kText:
    case DataKind::kStructure:
    case DataKind::kUnknown:
        break;
    }
    return {};
}
} // namespace

std::string CppTypeOf(const cia306::DataType& type)
{
    return WordsOf(type).first;
}

// The dictionary takes the length from the entry; the type tells sign and kind.
std::string TableTypeOf(const cia306::Entry& entry)
{
    const std::string number = WordsOf(entry.type).second;
    const std::string text = entry.data_type == kVisibleString ? "kVisibleString" : "kOctetString";
    return !number.empty() ? number : (entry.data_type == cia306::kDomainType ? "kDomain" : text);
}

std::string TableAccessOf(const Element& element)
{
    return kAccessWords.at(static_cast<std::size_t>(element.entry->access)).second;
}

std::string AccessName(const cia306::Access access)
{
    return kAccessWords.at(static_cast<std::size_t>(access)).first;
}
} // namespace counterpoint::generate
