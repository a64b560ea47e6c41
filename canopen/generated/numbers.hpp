// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_GENERATED_NUMBERS_HPP
#define CANOPEN_GENERATED_NUMBERS_HPP

#include "safety_core/kernel/variable.hpp"

#include <cstdint>

namespace counterpoint::generated
{

/// @brief A two's complement of the variable's length. O(bytes) [SRS_GEN_013]
[[nodiscard]] std::int64_t ReadSigned(const VariablePlace& variable) noexcept;
void WriteSigned(const VariablePlace& variable, std::int64_t value) noexcept;
/// @brief A number of IEEE 754 in 32 or 64 bits.
[[nodiscard]] float ReadReal32(const VariablePlace& variable) noexcept;
void WriteReal32(const VariablePlace& variable, float value) noexcept;
[[nodiscard]] double ReadReal64(const VariablePlace& variable) noexcept;
void WriteReal64(const VariablePlace& variable, double value) noexcept;

} // namespace counterpoint::generated

#endif
