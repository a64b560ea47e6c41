// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/names.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "names/safety_core/kernel/start_check.hpp"

#include <algorithm>

namespace counterpoint::runtime
{
std::string ObjectText(const ObjectAddress& object)
{
    return cia306::ObjectName(object.index, object.sub);
}

std::string IdentifierText(const std::uint32_t identifier)
{
    return cia306::Hex(identifier, 3);
}

std::string MillisecondsText(const Nanoseconds time)
{
    const Nanoseconds microseconds = time / kNanosecondsPerMicrosecond;
    std::string whole = std::to_string(microseconds / 1000);
    std::string fraction = std::to_string(1000 + ((microseconds < 0) ? -microseconds : microseconds) % 1000).substr(1U);
    while (!fraction.empty() && fraction.back() == '0')
    {
        fraction.pop_back();
    }
    const bool needs_sign = microseconds < 0 && microseconds > -1000;
    return (needs_sign ? "-" : "") + whole + (fraction.empty() ? "" : "." + fraction) + " ms";
}

std::string NoStartText(const StartResult result)
{
    std::string meaning = MeaningOf(result);
    if (!meaning.empty() && meaning.back() == '.')
    {
        meaning.pop_back();
    }
    return "the kernel refuses this device: " + Words(NameOf(result)) + (meaning.empty() ? "" : " (" + meaning + ")");
}

std::string Words(std::string name)
{
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}
} // namespace counterpoint::runtime
