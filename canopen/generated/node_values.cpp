// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generated/node_values.hpp"

namespace counterpoint::generated
{

namespace
{

constexpr std::uint32_t kLongestNumber = 8U;

bool IsNumber(const cia301::Bytes& value, const std::uint64_t number) noexcept
{
    bool is_number = (value.size_bytes >= 1U) && (value.size_bytes <= kLongestNumber);
    for (std::uint32_t i = 0U; is_number && (i < value.size_bytes); ++i)
    {
        is_number = value.data[i] == ((number >> (8U * i)) & 0xFFU);
    }
    return is_number;
}

} // namespace

bool NodeValues::IsNodeDefault(const std::uint32_t number, const cia301::Bytes& value) const noexcept
{
    bool is_default = false;
    for (std::uint32_t i = 0U; i < table_.count; ++i)
    {
        const NodeValue& each = table_.values[i];
        is_default = is_default || ((each.number == number) && IsNumber(value, each.addend + node_.value));
    }
    return is_default;
}

} // namespace counterpoint::generated
