// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_GENERATED_NUMBERS_HPP
#define CANOPEN_GENERATED_NUMBERS_HPP

#include "safety_core/kernel/variable.hpp"

#include <cstdint>

namespace counterpoint::generated
{

/// @brief Reads a variable as a two's complement of its length. O(bytes) [SRS_GEN_013]
[[nodiscard]] std::int64_t ReadSigned(const VariablePlace& variable) noexcept;
/// @brief Writes it likewise. O(bytes)
void WriteSigned(const VariablePlace& variable, std::int64_t value) noexcept;
/// @brief Reads a variable of 32 bits as a number of IEEE 754.
[[nodiscard]] float ReadReal32(const VariablePlace& variable) noexcept;
/// @brief Writes it likewise.
void WriteReal32(const VariablePlace& variable, float value) noexcept;
/// @brief Reads a variable of 64 bits as a number of IEEE 754.
[[nodiscard]] double ReadReal64(const VariablePlace& variable) noexcept;
/// @brief Writes it likewise.
void WriteReal64(const VariablePlace& variable, double value) noexcept;

} // namespace counterpoint::generated

#endif
