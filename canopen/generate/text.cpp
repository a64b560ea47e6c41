// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generate/text.hpp"

#include "canopen/generate/names.hpp"

#include "canopen/cia306/text/input_error.hpp"

namespace counterpoint::generate
{
std::string HexLiteral(const std::uint64_t value, const int digits)
{
    return cia306::Hex(value, digits) + (value > 0xFFFFFFFFU ? "ULL" : "U");
}

std::string UnsignedLiteral(const std::uint64_t value)
{
    return std::to_string(value) + (value > 0xFFFFFFFFU ? "ULL" : "U");
}

std::string ByteList(const std::vector<std::uint8_t>& bytes)
{
    std::string text;
    for (const std::uint8_t byte : bytes)
    {
        text += HexLiteral(byte, 2) + ", ";
    }
    return text;
}

std::string AddressName(const cia306::Entry& entry)
{
    return cia306::Hex(entry.index, 4).substr(2U) + "h:" + cia306::Hex(entry.sub, 2).substr(2U);
}

std::string Describe(const Element& element)
{
    const cia306::Entry& entry = *element.entry;
    const bool is_whole = entry.name.empty() || entry.name == element.object_name;
    const std::string name = is_whole ? element.object_name : element.object_name + ", " + entry.name;
    return AddressName(entry) + " " + CommentText(name) + ", " + entry.type.name + ", " + AccessName(entry.access);
}

std::string PlaceText(const Element& element)
{
    return "counterpoint::VariablePlace{storage.bytes + " + UnsignedLiteral(element.offset) + ", " +
           UnsignedLiteral(element.entry->type.bits) + "}";
}

bool HasSetter(const Element& element)
{
    return element.home == Home::kStored || element.home == Home::kProduced;
}

bool IsNumber(const Element& element)
{
    return !CppTypeOf(element.entry->type).empty();
}
} // namespace counterpoint::generate
