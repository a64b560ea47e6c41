// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/variable.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kBitsPerByte = 8U;
constexpr std::uint32_t kByte = 0xFFU;

constexpr std::uint32_t kMostBits = 64U;

// [SRS_KRN_575]
std::uint32_t BitsOf(const VariablePlace& variable) noexcept
{
    return (variable.length_bits < kMostBits) ? variable.length_bits : kMostBits;
}

std::uint32_t BytesOf(const VariablePlace& variable) noexcept
{
    return (BitsOf(variable) + (kBitsPerByte - 1U)) / kBitsPerByte;
}

// The bits of the last byte that belong to a variable.
std::uint32_t LastByteOf(const VariablePlace& variable) noexcept
{
    return kByte >> ((0U - BitsOf(variable)) % kBitsPerByte);
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
    const std::uint32_t bytes = BytesOf(variable);
    for (std::uint32_t byte = 0U; byte < bytes; ++byte)
    {
        const std::uint32_t kept = ((byte + 1U) < bytes) ? kByte : LastByteOf(variable);
        variable.place[byte] = static_cast<std::uint8_t>(rest.bits & kept); // MISRA D-002
        rest.bits >>= kBitsPerByte;
    }
}

PairView IsInversePair(const VariablePlace& normal, const VariablePlace& inverse) noexcept
{
    // 0 - 1 is the greatest value.
    const bool is_length = (normal.length_bits - 1U) < kMostBits;
    bool is_inverse = is_length && (normal.length_bits == inverse.length_bits);
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
