// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_VARIABLE_HPP
#define SAFETY_CORE_KERNEL_VARIABLE_HPP

#include <cstdint>

namespace counterpoint
{

/// A mapped variable as the application sees it: its bytes in little-endian order, its length in bits. Bits of the last
/// byte above the length are ignored when it is read and 0 when it was written.
struct VariablePlace
{
    std::uint8_t* place;
    std::uint8_t length_bits; ///< 1 to 64. More counts as 64, but is no pair; 0 is no variable.
};

/// Up to 64 bits of a variable, native.
struct VariableValue
{
    std::uint64_t bits;
};

enum class PairView : std::uint8_t
{
    kInvalid = 0U,
    kNotInverse = 1U,
    kInverse = 0x96U,
};

/// @brief Value of a variable on a processor of either byte order; of at most 64 bits, 0 of none. O(bytes)
/// [SRS_KRN_575]
[[nodiscard]] VariableValue ReadVariable(const VariablePlace& variable) noexcept;
/// @brief Writes the low length_bits of a value: at most 8 bytes, nothing with length 0. O(bytes) [SRS_KRN_575]
void WriteVariable(const VariablePlace& variable, const VariableValue& value) noexcept;
/// @brief Whether each of the bits of `inverse` is the inverse of that of `normal`; lengths must be equal, and 1 to 64.
/// [SRS_KRN_016, SRS_KRN_575]
[[nodiscard]] PairView IsInversePair(const VariablePlace& normal, const VariablePlace& inverse) noexcept;

} // namespace counterpoint

#endif
