// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_FILE_STRING_VALUE_HPP
#define CANOPEN_CIA306_FILE_STRING_VALUE_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
/// @brief The bytes on the bus of a value that is no number: a UNICODE_STRING in UTF-16, low byte first; an
/// OCTET_STRING of pairs of hexadecimal digits, blanks left out, these octets; any other text its own bytes.
/// [SRS_GEN_354, SRS_NET_671]
[[nodiscard]] std::vector<std::uint8_t> BytesOfText(std::uint16_t data_type, const std::string& text);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_FILE_STRING_VALUE_HPP
