// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/time_text.hpp"

#include "runtime/device/names.hpp"

#include <algorithm>

namespace counterpoint::runtime
{
std::string MillisecondsDigits(const Nanoseconds time)
{
    const Nanoseconds microseconds = time / kNanosecondsPerMicrosecond;
    const Nanoseconds size = (microseconds < 0) ? -microseconds : microseconds;
    return (microseconds < 0 ? "-" : "") + std::to_string(size / 1000) + "." +
           std::to_string(1000 + size % 1000).substr(1U);
}

std::string MillisecondsColumn(const Nanoseconds time, const std::size_t width)
{
    const std::string number = MillisecondsDigits(time);
    return std::string(width - std::min(width, number.size()), ' ') + number + " ms";
}

std::string ExactText(const Nanoseconds time)
{
    return (time % kNanosecondsPerMicrosecond == 0) ? MillisecondsText(time) : std::to_string(time) + " ns";
}
} // namespace counterpoint::runtime
