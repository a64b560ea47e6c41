// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/names.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "names/safety_core/kernel/start_check.hpp"
#include "runtime/device/time_text.hpp"

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
    std::string number = MillisecondsDigits(time);
    number.erase(number.find_last_not_of('0') + 1U);
    number.erase(number.find_last_not_of('.') + 1U);
    return number + " ms";
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
