// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/variable.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kBitsPerByte = 8U;
constexpr std::uint32_t kByte = 0xFFU;

std::uint32_t BytesOf(const VariablePlace& variable) noexcept
{
    return (variable.length_bits + (kBitsPerByte - 1U)) / kBitsPerByte;
}

// The bits of the last byte that belong to a variable.
std::uint32_t LastByteOf(const VariablePlace& variable) noexcept
{
    return kByte >> ((0U - variable.length_bits) % kBitsPerByte);
}

} // namespace

VariableValue ReadVariable(const VariablePlace& variable) noexcept
{
    VariableValue value{0U};
    std::uint32_t kept = LastByteOf(variable);
    for (std::uint32_t byte = BytesOf(variable); byte != 0U; --byte)
    {
        value.bits = (value.bits << kBitsPerByte) | (variable.place[byte - 1U] & kept); // MISRA D-002
        kept = kByte;
    }
    return value;
}

void WriteVariable(const VariablePlace& variable, const VariableValue& value) noexcept
{
    VariableValue rest = value;
    const std::uint32_t last = BytesOf(variable) - 1U;
    for (std::uint32_t byte = 0U; byte < last; ++byte)
    {
        variable.place[byte] = static_cast<std::uint8_t>(rest.bits & kByte); // MISRA D-002
        rest.bits >>= kBitsPerByte;
    }
    variable.place[last] = static_cast<std::uint8_t>(rest.bits & LastByteOf(variable)); // MISRA D-002
}

PairView IsInversePair(const VariablePlace& normal, const VariablePlace& inverse) noexcept
{
    bool is_inverse = normal.length_bits == inverse.length_bits;
    std::uint32_t kept = LastByteOf(normal);
    for (std::uint32_t byte = BytesOf(normal); is_inverse && (byte != 0U); --byte)
    {
        const std::uint32_t differences =
            static_cast<std::uint32_t>(normal.place[byte - 1U]) ^ inverse.place[byte - 1U]; // MISRA D-002
        is_inverse = (differences & kept) == kept;
        kept = kByte;
    }
    return is_inverse ? PairView::kInverse : PairView::kNotInverse;
}

} // namespace counterpoint
