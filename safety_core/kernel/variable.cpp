// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/variable.hpp"

#include "safety_core/contract/limits.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kBitsPerByte = 8U;

// The value's bits that belong to a variable of this length, which is 1 to 64.
VariableValue Cut(const VariableValue& value, const std::uint8_t length_bits) noexcept
{
    return VariableValue{value.bits & (~std::uint64_t{0U} >> (std::uint32_t{kMaxPayloadBits} - length_bits))};
}

std::uint32_t BytesOf(const VariablePlace& variable) noexcept
{
    return (variable.length_bits + (kBitsPerByte - 1U)) / kBitsPerByte;
}

} // namespace

VariableValue ReadVariable(const VariablePlace& variable) noexcept
{
    VariableValue value{0U};
    for (std::uint32_t byte = BytesOf(variable); byte != 0U; --byte)
    {
        value.bits = (value.bits << kBitsPerByte) | variable.place[byte - 1U]; // MISRA D-002
    }
    return Cut(value, variable.length_bits);
}

void WriteVariable(const VariablePlace& variable, const VariableValue& value) noexcept
{
    VariableValue rest = Cut(value, variable.length_bits);
    const std::uint32_t bytes = BytesOf(variable);
    for (std::uint32_t byte = 0U; byte < bytes; ++byte)
    {
        variable.place[byte] = static_cast<std::uint8_t>(rest.bits & 0xFFU); // MISRA D-002
        rest.bits >>= kBitsPerByte;
    }
}

PairView IsInversePair(const VariablePlace& normal, const VariablePlace& inverse) noexcept
{
    const VariableValue same{~(ReadVariable(normal).bits ^ ReadVariable(inverse).bits)};
    const std::uint32_t lengths =
        static_cast<std::uint32_t>(normal.length_bits) ^ static_cast<std::uint32_t>(inverse.length_bits);
    return ((Cut(same, normal.length_bits).bits | lengths) == 0U) ? PairView::kInverse : PairView::kNotInverse;
}

} // namespace counterpoint
