// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_TEXT_INPUT_ERROR_HPP
#define CANOPEN_CIA306_TEXT_INPUT_ERROR_HPP

#include "canopen/cia306/text/place.hpp"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace counterpoint::cia306
{
/// What is wrong with a piece of text, and what would have been right. Both are halves of one sentence.
struct Problem
{
    std::string wrong;
    std::string expected;
};

/// Text of a file for a message: in quotes, control and non-ASCII bytes as \xNN, at most 60 characters.
[[nodiscard]] std::string Quoted(std::string_view text);

/// A file name for a message: as given, but control bytes as \xNN.
[[nodiscard]] std::string Printable(std::string_view text);

/// "0x13FF:01"
[[nodiscard]] std::string ObjectName(std::uint16_t index, std::uint8_t sub);

/// `value` as "0x" and at least `digits` upper case hexadecimal digits.
[[nodiscard]] std::string Hex(std::uint64_t value, int digits);

/// Refuses a file. what() is the one line that a person reads: FILE:LINE:COLUMN: error: WRONG, expected EXPECTED.
class InputError : public std::runtime_error
{
  public:
    InputError(std::string file, Place place, const Problem& problem);

    /// Name of the file.
    [[nodiscard]] const std::string& File() const noexcept
    {
        return file_;
    }
    /// Where in the file.
    [[nodiscard]] Place Where() const noexcept
    {
        return place_;
    }
    /// The message without file and place.
    [[nodiscard]] const std::string& Message() const noexcept
    {
        return message_;
    }

  private:
    std::string file_;
    Place place_;
    std::string message_;
};
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_TEXT_INPUT_ERROR_HPP
