// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/value.hpp"

#include "canopen/cia306/text/ini_document.hpp"
#include "canopen/cia306/text/number.hpp"

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint8_t kHighestNodeId = 127U;
constexpr std::uint64_t kMostMilliseconds = 0x0FFFFFFFU; ///< The upper four of the 32 bits are reserved.
constexpr std::uint64_t kMostDays = 0xFFFFU;
constexpr std::uint8_t kDaysShift = 32U;

std::uint64_t MaxOf(const std::uint8_t bits)
{
    return bits >= 64U ? std::numeric_limits<std::uint64_t>::max() : (std::uint64_t{1U} << bits) - 1U;
}

std::string RangeOf(const DataType& type)
{
    const std::string name = std::string(" (") + type.name + ")";
    switch (type.kind)
    {
    case DataKind::kSigned:
    {
        const std::uint64_t half = MaxOf(type.bits) / 2U;
        return "a number from -" + std::to_string(half + 1U) + " to " + std::to_string(half) + name;
    }
    case DataKind::kReal:
        return "a decimal fraction, or its IEEE 754 pattern after 0x" + name;
    case DataKind::kTime:
        return "days (0 to 65535) and milliseconds (0 to 268435455), or both as one number of 48 bits" + name;
    case DataKind::kBoolean:
    case DataKind::kUnsigned:
    case DataKind::kText:
    case DataKind::kStructure:
    case DataKind::kUnknown:
        break;
    }
    return "a number from 0 to " + std::to_string(MaxOf(type.bits)) + name;
}

ValueResult Bad(const std::string_view text, const DataType& type)
{
    return {std::nullopt, {"value " + Quoted(text), RangeOf(type)}};
}

ValueResult Good(const std::uint64_t bits)
{
    return {Value{bits, {}}, {}};
}

/// Hexadecimal is a bit pattern, so that 0xFF is -1 as an INTEGER8; decimal is a value.
ValueResult ParseSigned(const std::string_view text, const DataType& type)
{
    const auto number = ParseNumber(text);
    const std::uint64_t all = MaxOf(type.bits);
    const std::uint64_t half = all / 2U;
    if (!number)
    {
        return Bad(text, type);
    }
    const std::uint64_t limit = number->is_negative ? half + 1U : (number->is_hexadecimal ? all : half);
    if (number->magnitude > limit)
    {
        return Bad(text, type);
    }
    return Good((number->is_negative ? ~number->magnitude + 1U : number->magnitude) & all);
}

ValueResult ParseUnsignedValue(const std::string_view text, const DataType& type,
                               const std::optional<std::uint8_t> node_id)
{
    const auto formula = ParseFormula(text);
    const bool is_number = formula && !formula->number.is_negative;
    if (!is_number)
    {
        ValueResult bad = Bad(text, type);
        bad.problem.expected += ", or $NODEID+number";
        return bad;
    }
    const bool lacks_node_id = formula->has_node_id && !node_id;
    if (lacks_node_id)
    {
        return {std::nullopt,
                {"value " + Quoted(text) + " needs the node-ID and there is none",
                 "--node-id, or NodeID in [DeviceComissioning]"}};
    }
    const std::uint64_t addend = formula->has_node_id ? *node_id : 0U;
    const std::uint64_t max = MaxOf(type.bits);
    const bool fits = addend <= max && formula->number.magnitude <= max - addend;
    return fits ? Good(formula->number.magnitude + addend) : Bad(text, type);
}

template <typename Real, typename Bits> std::optional<std::uint64_t> RealBits(const std::string_view text)
{
    static_assert(sizeof(Real) == sizeof(Bits), "the pattern has the length of the number");
    const bool has_plus = !text.empty() && text.front() == '+';
    const std::string_view digits = has_plus ? text.substr(1U) : text;
    Real number{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool is_number = error == std::errc() && end == digits.data() + digits.size() && std::isfinite(number);
    if (!is_number)
    {
        return std::nullopt;
    }
    Bits bits{};
    std::memcpy(&bits, &number, sizeof(bits));
    return bits;
}

ValueResult ParseReal(const std::string_view text, const DataType& type)
{
    const auto number = ParseNumber(text);
    const bool is_pattern = number && number->is_hexadecimal && !number->is_negative;
    if (is_pattern)
    {
        return number->magnitude <= MaxOf(type.bits) ? Good(number->magnitude) : Bad(text, type);
    }
    const auto bits = type.bits == 32U ? RealBits<float, std::uint32_t>(text) : RealBits<double, std::uint64_t>(text);
    return bits ? Good(*bits) : Bad(text, type);
}
/// Days and milliseconds with blanks or a comma between them, or the 48 bits as one number.
ValueResult ParseTime(const std::string_view text, const DataType& type)
{
    const std::size_t end = text.find_first_of(" \t,");
    if (end == std::string_view::npos)
    {
        const auto bits = ParseNumber(text);
        const bool fits = bits && !bits->is_negative && bits->magnitude <= MaxOf(type.bits);
        return fits ? Good(bits->magnitude) : Bad(text, type);
    }
    std::string_view rest = Trimmed(text.substr(end));
    rest = Trimmed(rest.front() == ',' ? rest.substr(1U) : rest);
    const auto days = ParseUnsigned(text.substr(0U, end), kMostDays);
    const auto milliseconds = ParseUnsigned(rest, kMostMilliseconds);
    return days && milliseconds ? Good((*days << kDaysShift) | *milliseconds) : Bad(text, type);
}
} // namespace

ValueResult ParseValue(const std::string_view text, const std::uint16_t data_type,
                       const std::optional<std::uint8_t> node_id)
{
    return ParseValue(text, DataTypeOf(data_type), node_id);
}

ValueResult ParseValue(const std::string_view text, const DataType& type, const std::optional<std::uint8_t> node_id)
{
    switch (type.kind)
    {
    case DataKind::kSigned:
        return ParseSigned(text, type);
    case DataKind::kBoolean:
    case DataKind::kUnsigned:
        return ParseUnsignedValue(text, type, node_id);
    case DataKind::kTime:
        return ParseTime(text, type);
    case DataKind::kReal:
        return ParseReal(text, type);
    case DataKind::kText:
    case DataKind::kStructure:
    case DataKind::kUnknown:
        break;
    }
    return {Value{0U, std::string(text)}, {}};
}

std::optional<Problem> ProblemOf(const std::string_view text, const std::uint16_t data_type)
{
    return ProblemOf(text, DataTypeOf(data_type));
}

std::optional<Problem> ProblemOf(const std::string_view text, const DataType& type)
{
    ValueResult result = ParseValue(text, type, kHighestNodeId);
    return result.value ? std::nullopt : std::optional(std::move(result.problem));
}
} // namespace counterpoint::cia306
