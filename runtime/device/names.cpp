// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/names.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace counterpoint::runtime
{
std::string ObjectText(const ObjectAddress& object)
{
    std::array<char, 16U> text{};
    static_cast<void>(std::snprintf(text.data(), text.size(), "0x%04X:%02X", static_cast<unsigned>(object.index),
                                    static_cast<unsigned>(object.sub)));
    return text.data();
}

std::string IdentifierText(const std::uint32_t identifier)
{
    std::array<char, 16U> text{};
    static_cast<void>(std::snprintf(text.data(), text.size(), "0x%03X", static_cast<unsigned>(identifier)));
    return text.data();
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

std::string Words(std::string name)
{
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}
} // namespace counterpoint::runtime
