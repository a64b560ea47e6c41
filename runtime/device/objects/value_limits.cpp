// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/objects/value_limits.hpp"

#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/dictionary/entry_value.hpp"

#include <array>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint64_t kSign = std::uint64_t{1U} << 63U;
constexpr std::uint32_t kByteBits = 8U;

/// Whether its bytes hold more than its type: BIT1 to BIT7, and such types of a file.
bool IsShort(const cia306::DataType& type)
{
    return type.kind == cia306::DataKind::kUnsigned && type.bits % kByteBits != 0U;
}

/// All that a number of this type can be.
cia301::ValueLimits RangeOf(const cia306::DataType& type, const bool is_signed)
{
    if (is_signed)
    {
        return {kSign, kSign - 1U};
    }
    return {0U, IsShort(type) ? (std::uint64_t{1U} << type.bits) - 1U : ~std::uint64_t{0U}};
}

std::optional<std::uint64_t> LimitOf(const cia306::Entry& source, const cia306::Text& text, const cia301::DataType type,
                                     const std::uint8_t node_id, const OnNoLimit& on_no_limit)
{
    if (!text.IsSet() || source.type.bits == 0U)
    {
        return std::nullopt;
    }
    const cia306::ValueResult result = cia306::ParseValue(text.text, source.type, node_id);
    if (!result.value)
    {
        on_no_limit(text, {"limit: " + result.problem.wrong, result.problem.expected});
        return std::nullopt;
    }
    std::array<std::uint8_t, sizeof(std::uint64_t)> bytes{};
    const std::uint32_t size = (source.type.bits + kByteBits - 1U) / kByteBits;
    cia301::ToLittleEndian(result.value->bits, bytes.data(), size);
    return cia301::NumberOf(type, {bytes.data(), size});
}
} // namespace

std::optional<cia301::ValueLimits> LimitsOf(const cia306::Entry& source, const cia301::DataType type,
                                            const std::uint8_t node_id, const OnNoLimit& on_no_limit)
{
    if (!IsShort(source.type) && !source.low_limit.IsSet() && !source.high_limit.IsSet())
    {
        return std::nullopt;
    }
    const cia301::ValueLimits range = RangeOf(source.type, cia301::IsSigned(type));
    const auto low = LimitOf(source, source.low_limit, type, node_id, on_no_limit);
    const auto high = LimitOf(source, source.high_limit, type, node_id, on_no_limit);
    return cia301::ValueLimits{low.value_or(range.low), high.value_or(range.high)};
}

std::uint64_t FirstValue(const cia301::ValueLimits& limits, const cia301::DataType type) noexcept
{
    const bool has_sign = cia301::IsSigned(type);
    const bool is_low_negative = has_sign && (limits.low & kSign) != 0U;
    const bool is_high_negative = has_sign && (limits.high & kSign) != 0U;
    if (limits.low != 0U && !is_low_negative)
    {
        return limits.low;
    }
    return is_high_negative ? limits.high : 0U;
}
} // namespace counterpoint::runtime
