// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/variable.hpp"

#include "safety_core/contract/limits.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kBitsPerByte = 8U;
constexpr std::uint64_t kByteMask = 0xFFU;

} // namespace

VariableValue ReadVariable(const VariablePlace& variable) noexcept
{
    VariableValue value{0U};
    for (std::uint32_t bit = 0U; bit < variable.length_bits; bit += kBitsPerByte)
    {
        const std::uint64_t byte = variable.place[bit / kBitsPerByte]; // MISRA D-002
        value.bits |= byte << bit;
    }
    return value;
}

void WriteVariable(const VariablePlace& variable, const VariableValue& value) noexcept
{
    for (std::uint32_t bit = 0U; bit < variable.length_bits; bit += kBitsPerByte)
    {
        variable.place[bit / kBitsPerByte] = static_cast<std::uint8_t>((value.bits >> bit) & kByteMask); // MISRA D-002
    }
}

PairView IsInversePair(const VariablePlace& normal, const VariablePlace& inverse) noexcept
{
    const std::uint64_t all_bits = ~std::uint64_t{0U} >> (std::uint32_t{kMaxPayloadBits} - normal.length_bits);
    const std::uint64_t same = ~(ReadVariable(normal).bits ^ ReadVariable(inverse).bits) & all_bits;
    const std::uint64_t lengths =
        static_cast<std::uint64_t>(normal.length_bits) ^ static_cast<std::uint64_t>(inverse.length_bits);
    return ((same | lengths) == 0U) ? PairView::kInverse : PairView::kNotInverse;
}

} // namespace counterpoint
