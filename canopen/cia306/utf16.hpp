// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_UTF16_HPP
#define CANOPEN_CIA306_UTF16_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
/// The value of a UNICODE_STRING as CiA 301 has it on the bus: UTF-16, low byte first. The file is UTF-8; a byte that
/// is not is Latin-1.
[[nodiscard]] std::vector<std::uint8_t> Utf16Of(const std::string& text);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_UTF16_HPP
