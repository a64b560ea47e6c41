// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generate/element.hpp"

#include "canopen/cia306/file/string_value.hpp"
#include "canopen/cia306/safety/signature.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/number.hpp"

#include <algorithm>

namespace counterpoint::generate
{
namespace
{
using cia306::DataKind;

constexpr std::uint32_t kLeastTextRoom = 32U; ///< Of a string that can be written: a file tells no room.

bool IsSigned(const cia306::DataType& type)
{
    return type.kind == DataKind::kSigned;
}

std::uint64_t Extended(const std::uint64_t bits, const cia306::DataType& type)
{
    const bool is_negative = IsSigned(type) && type.bits < 64U && ((bits >> (type.bits - 1U)) & 1U) != 0U;
    return is_negative ? bits | (~std::uint64_t{0U} << type.bits) : bits;
}

Limits RangeOf(const cia306::DataType& type)
{
    const std::uint64_t all = ~std::uint64_t{0U} >> (64U - type.bits);
    return IsSigned(type) ? Limits{~(all / 2U), all / 2U} : Limits{0U, all};
}

void ReadText(Element& element)
{
    element.is_text = true;
    element.value = cia306::BytesOfText(element.entry->data_type, element.entry->Configured().text);
    const auto length = static_cast<std::uint32_t>(element.value.size());
    element.size_bytes = element.home == Home::kConstant ? length : std::max(length, kLeastTextRoom);
}

/// The limit that the file gives; nothing where it gives none, or one that the reader has warned of.
std::optional<std::uint64_t> LimitOf(const ElementContext& context, const Element& element, const cia306::Text& text)
{
    const cia306::DataType& type = element.entry->type;
    const cia306::ValueResult result =
        text.IsSet() ? cia306::ParseValue(text.text, type, context.node_id) : cia306::ValueResult{};
    return result.value ? std::optional(Extended(result.value->bits, type)) : std::nullopt;
}

bool IsBelow(const std::uint64_t left, const std::uint64_t right, const bool is_signed)
{
    constexpr std::uint64_t sign = std::uint64_t{1U} << 63U;
    return is_signed ? (left ^ sign) < (right ^ sign) : left < right;
}

/// Sets the limits. An element to which the file gives no value begins with the limit next to 0.
void ReadLimits(const ElementContext& context, Element& element, std::uint64_t& value)
{
    const cia306::Entry& entry = *element.entry;
    const bool has_limits = IsSigned(entry.type) || entry.type.kind == DataKind::kUnsigned;
    if (!has_limits)
    {
        return;
    }
    const Limits range = RangeOf(entry.type);
    const auto low = LimitOf(context, element, entry.low_limit);
    const auto high = LimitOf(context, element, entry.high_limit);
    const Limits limits{low.value_or(range.low), high.value_or(range.high)};
    const bool is_narrow = limits.low != range.low || limits.high != range.high || entry.type.bits % 8U != 0U;
    if (is_narrow)
    {
        element.limits = limits;
    }
    const bool is_configured = cia306::UsableValue(context.device.file, entry, context.node_id).has_value();
    const std::uint64_t extended = Extended(value, entry.type);
    const bool is_below = IsBelow(extended, limits.low, IsSigned(entry.type));
    const bool is_above = IsBelow(limits.high, extended, IsSigned(entry.type));
    if (!is_configured)
    {
        value = is_below ? limits.low : (is_above ? limits.high : value);
    }
    else if (is_below || is_above)
    {
        context.warnings.push_back({cia306::Severity::kWarning, entry.ValuePlace(),
                                    cia306::ObjectName(entry.index, entry.sub),
                                    "value " + cia306::Quoted(entry.Configured().text) +
                                        ", expected one between LowLimit and HighLimit; it is generated all the same"});
    }
}
} // namespace

void ReadValue(const ElementContext& context, Element& element)
{
    const cia306::Entry& entry = *element.entry;
    if (element.home == Home::kNowhere)
    {
        return;
    }
    if (entry.type.kind == DataKind::kText)
    {
        ReadText(element);
        return;
    }
    std::uint64_t value = 0U;
    const auto configured = cia306::UsableValue(context.device.file, entry, context.node_id);
    if (configured)
    {
        value = configured->bits;
        const auto formula = cia306::ParseFormula(entry.Configured().text);
        const bool has_node_id = formula && formula->has_node_id;
        element.node_addend = has_node_id ? std::optional(formula->number.magnitude) : std::nullopt;
    }
    element.size_bytes = (entry.type.bits + 7U) / 8U;
    ReadLimits(context, element, value);
    element.value = cia306::LittleEndian(value, element.size_bytes);
}
} // namespace counterpoint::generate
