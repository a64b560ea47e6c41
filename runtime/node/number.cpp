// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/number.hpp"

#include "canopen/cia301/dictionary/entry_value.hpp"

namespace counterpoint::runtime
{
namespace
{
using cia301::SdoAbort;

constexpr std::uint32_t kMostBits = 64U;

std::uint64_t MaskOf(const NumberForm& form)
{
    return ~std::uint64_t{0U} >> (kMostBits - form.bits);
}

bool IsNegative(const NumberForm& form, const std::uint64_t bits)
{
    return form.is_signed && ((bits >> (form.bits - 1U)) & 1U) != 0U;
}

/// Of a negative number.
std::uint64_t MagnitudeOf(const NumberForm& form, const std::uint64_t bits)
{
    return (~bits + 1U) & MaskOf(form);
}
} // namespace

NumberForm FormOf(const cia306::Device& file, const ObjectAddress& object)
{
    const cia306::Entry* const entry = file.Find(object.index, object.sub);
    NumberForm form;
    if (entry != nullptr && entry->type.kind == cia306::DataKind::kSigned)
    {
        form = {true, entry->type.bits};
    }
    return form;
}

NumberForm FormOf(const cia306::Device& file, const cia301::Dictionary& dictionary, const ObjectAddress& object)
{
    const cia301::Entry* const entry = dictionary.Find(object);
    const bool is_services = entry != nullptr && cia301::IsNumber(entry->type) && !cia301::IsSigned(entry->type);
    return is_services ? NumberForm{} : FormOf(file, object);
}

std::string NumberText(const NumberForm& form, const std::uint64_t bits)
{
    return IsNegative(form, bits) ? "-" + std::to_string(MagnitudeOf(form, bits)) : std::to_string(bits);
}

nlohmann::ordered_json NumberJson(const NumberForm& form, const std::uint64_t bits)
{
    // Not by the negative of a magnitude: the lowest number has none.
    return IsNegative(form, bits) ? nlohmann::ordered_json(static_cast<std::int64_t>(bits | ~MaskOf(form)))
                                  : nlohmann::ordered_json(bits);
}

NumberBits BitsOf(const NumberForm& form, const NodeOrder& order)
{
    const std::uint64_t half = MaskOf(form) >> 1U;
    std::uint64_t highest = (form.is_signed && !order.is_pattern) ? half : MaskOf(form);
    std::uint64_t bits = order.value;
    if (order.is_negative)
    {
        highest = form.is_signed ? half + 1U : 0U;
        bits = (~order.value + 1U) & MaskOf(form);
    }
    if (order.value > highest)
    {
        return {order.is_negative ? SdoAbort::kValueLow : SdoAbort::kValueHigh, 0U};
    }
    return {SdoAbort::kNone, bits};
}
} // namespace counterpoint::runtime
