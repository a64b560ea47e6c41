// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MONITOR_TEXTS_HPP
#define CANOPEN_MONITOR_TEXTS_HPP

#include "canopen/monitor/recording.hpp"

#include <string>

namespace counterpoint::monitor
{
/// "12.000345", microseconds.
[[nodiscard]] std::string SecondsText(Time time);
/// "20.5 ms": up to three decimals, none where they are 0.
[[nodiscard]] std::string MillisecondsText(Time time);
/// "01 FE"
[[nodiscard]] std::string DataText(const LogFrame& frame);
/// "2200h:01"
[[nodiscard]] std::string AddressText(std::uint16_t index, std::uint8_t sub);
/// "103h", of 29 bits "00000103h"
[[nodiscard]] std::string IdentifierText(const LogFrame& frame);
} // namespace counterpoint::monitor

#endif // CANOPEN_MONITOR_TEXTS_HPP
