// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_TEXT_UTF16_HPP
#define CANOPEN_CIA306_TEXT_UTF16_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace counterpoint::cia306
{
/// Number of bytes of the character that begins at `at`; 0: the bytes there are no UTF-8.
[[nodiscard]] std::size_t LengthOfUtf8(std::string_view text, std::size_t at) noexcept;

/// The value of a UNICODE_STRING as CiA 301 has it on the bus: UTF-16, low byte first. The file is UTF-8; a byte that
/// is not is Latin-1.
[[nodiscard]] std::vector<std::uint8_t> Utf16Of(const std::string& text);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_TEXT_UTF16_HPP
