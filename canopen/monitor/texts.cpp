// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/texts.hpp"

#include <array>
#include <cstdio>

namespace counterpoint::monitor
{
namespace
{
/// Whole units, and so many decimals of what is left in microseconds.
std::string FractionText(const Time time, const Time unit, const int decimals)
{
    const Time positive = time < 0 ? -time : time;
    std::array<char, 40U> text{};
    static_cast<void>(std::snprintf(text.data(), text.size(), "%s%lld.%0*lld", time < 0 ? "-" : "",
                                    static_cast<long long>(positive / unit), decimals,
                                    static_cast<long long>(positive % unit / kMicrosecond)));
    return text.data();
}
} // namespace

std::string SecondsText(const Time time)
{
    return FractionText(time, kSecond, 6);
}

std::string MillisecondsText(const Time time)
{
    std::string number = FractionText(time, kMillisecond, 3);
    number.erase(number.find_last_not_of('0') + 1U);
    number.erase(number.find_last_not_of('.') + 1U);
    return number + " ms";
}

std::string DataText(const LogFrame& frame)
{
    std::string text;
    for (std::uint8_t place = 0U; place < frame.length && !frame.is_remote; ++place)
    {
        text += (place == 0U ? "" : " ") + cia306::Hex(frame.data.at(place), 2).substr(2U);
    }
    return text;
}

std::string AddressText(const std::uint16_t index, const std::uint8_t sub)
{
    return cia306::Hex(index, 4).substr(2U) + "h:" + cia306::Hex(sub, 2).substr(2U);
}

std::string IdentifierText(const LogFrame& frame)
{
    return cia306::Hex(frame.identifier, frame.is_extended || frame.is_error ? 8 : 3).substr(2U) + "h";
}
} // namespace counterpoint::monitor
