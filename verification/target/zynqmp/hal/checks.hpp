// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_ZYNQMP_HAL_CHECKS_HPP
#define VERIFICATION_TARGET_ZYNQMP_HAL_CHECKS_HPP

#include <cstdint>

/// Verdicts of a program that tests in the emulator: a line each on the UART, and their count at the end.
namespace counterpoint::target
{

/// @brief One verdict: `holds  <name>` or `FAILS  <name>`.
void Check(bool holds, const char* name) noexcept;
/// @brief The same of a number that must be another one; a failure tells both.
void CheckEqual(std::uint32_t got, std::uint32_t expected, const char* name) noexcept;
/// @brief Writes `checks=<n> failures=<n>`; 0 if there is no failure.
[[nodiscard]] std::uint32_t EndChecks() noexcept;

} // namespace counterpoint::target

#endif
