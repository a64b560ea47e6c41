// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_TIME_TEXT_HPP
#define RUNTIME_DEVICE_TIME_TEXT_HPP

#include "runtime/yaml/value.hpp"

#include <cstddef>
#include <string>

namespace counterpoint::runtime
{
/// @brief A time in milliseconds with three decimals: the microseconds that have passed in full, as stamps count them;
/// nothing is rounded up. MillisecondsText tells the same number. [SRS_SIM_083]
[[nodiscard]] std::string MillisecondsDigits(Nanoseconds time);
/// @brief The same with its unit for a column that is so wide before the unit.
[[nodiscard]] std::string MillisecondsColumn(Nanoseconds time, std::size_t width);
/// @brief A time of a file, to tell what is wrong with it: in milliseconds, one that is no whole number of microseconds
/// in nanoseconds. [SRS_SIM_491]
[[nodiscard]] std::string ExactText(Nanoseconds time);
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_TIME_TEXT_HPP
