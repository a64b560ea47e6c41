// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generate/text.hpp"

#include "canopen/generate/names.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <cmath>
#include <cstring>
#include <iomanip>
#include <sstream>

namespace counterpoint::generate
{
namespace
{
/// Each bit of it, as a hexadecimal number.
template <typename Real, typename Bits> std::string ExactLiteral(const Bits bits, const char* const suffix)
{
    Real value{};
    static_assert(sizeof(value) == sizeof(bits), "the bits of it");
    std::memcpy(&value, &bits, sizeof(value));
    std::ostringstream text;
    text << std::hexfloat << value << suffix;
    return std::isfinite(value) ? text.str() : "";
}

std::string RealLiteral(const std::uint32_t width, const std::uint64_t bits)
{
    return (width == 32U) ? ExactLiteral<float>(static_cast<std::uint32_t>(bits), "F") : ExactLiteral<double>(bits, "");
}
} // namespace

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

std::string BitsLiteral(const cia306::DataType& type, const std::uint64_t bits)
{
    if (type.kind == cia306::DataKind::kBoolean)
    {
        return bits != 0U ? "true" : "false";
    }
    if (type.kind == cia306::DataKind::kReal)
    {
        return RealLiteral(type.bits, bits);
    }
    const bool is_signed = type.kind == cia306::DataKind::kSigned;
    const bool is_negative = is_signed && ((bits >> (type.bits - 1U)) & 1U) != 0U;
    if (!is_negative)
    {
        return is_signed ? std::to_string(bits) + (type.bits > 32U ? "LL" : "") : UnsignedLiteral(bits);
    }
    // The most negative number has no literal.
    const std::uint64_t all = ~std::uint64_t{0U} >> (64U - type.bits);
    return "-" + std::to_string(all - bits) + (type.bits > 32U ? "LL" : "") + " - 1";
}

std::string GetterName(const Element& element)
{
    return "Get" + element.name + (element.home == Home::kConsumed ? "Unchecked" : "");
}

bool HasCheckedGetter(const Element& element)
{
    return element.safe_read && !SafeLiteral(element).empty();
}

std::string SafeLiteral(const Element& element)
{
    return BitsLiteral(element.entry->type, element.safe_read->bits);
}

bool IsNumber(const Element& element)
{
    return !CppTypeOf(element.entry->type).empty();
}
} // namespace counterpoint::generate
