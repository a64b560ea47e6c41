// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/texts.hpp"

#include <array>
#include <cstdio>

namespace counterpoint::monitor
{
std::string SecondsText(const Time time)
{
    std::array<char, 40U> text{};
    const char* const sign = time < 0 ? "-" : "";
    const Time positive = time < 0 ? -time : time;
    static_cast<void>(std::snprintf(text.data(), text.size(), "%s%lld.%06lld", sign,
                                    static_cast<long long>(positive / kSecond),
                                    static_cast<long long>(positive % kSecond / kMicrosecond)));
    return text.data();
}

std::string MillisecondsText(const Time time)
{
    std::array<char, 40U> text{};
    const char* const sign = time < 0 ? "-" : "";
    const Time positive = time < 0 ? -time : time;
    static_cast<void>(std::snprintf(text.data(), text.size(), "%s%lld.%03lld", sign,
                                    static_cast<long long>(positive / kMillisecond),
                                    static_cast<long long>(positive % kMillisecond / kMicrosecond)));
    std::string number = text.data();
    while (number.back() == '0')
    {
        number.pop_back();
    }
    if (number.back() == '.')
    {
        number.pop_back();
    }
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
