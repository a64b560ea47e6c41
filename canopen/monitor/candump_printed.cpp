// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Lines as candump prints them with -ta or -tz, also with -x (direction and flags) and -a (characters at the end).
#include "canopen/monitor/readers.hpp"

#include <algorithm>

namespace counterpoint::monitor
{
namespace
{
constexpr std::string_view kHex = "0123456789ABCDEF";

/// The next word, and what is behind it.
std::string_view TakeWord(std::string_view& rest) noexcept
{
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    const std::string_view word = rest.substr(0U, rest.find(' '));
    rest.remove_prefix(word.size());
    return word;
}

/// Two decimal digits are a CAN FD frame, one a classical one; -1: no length.
int LengthOf(const std::string_view word) noexcept
{
    const bool is_fd = word.size() == 4U;
    const bool is_length = (is_fd || word.size() == 3U) && word.front() == '[' && word.back() == ']' &&
                           word.find_first_not_of("0123456789", 1U) == word.size() - 1U;
    if (!is_length)
    {
        return -1;
    }
    const int length = is_fd ? (word[1U] - '0') * 10 + (word[2U] - '0') : word[1U] - '0';
    constexpr std::array<int, 7U> long_ones{12, 16, 20, 24, 32, 48, 64};
    const bool is_long = is_fd && std::find(long_ones.begin(), long_ones.end(), length) != long_ones.end();
    return length <= kClassicalBytes || is_long ? length : -1;
}

/// -1: not two hexadecimal digits.
int ByteOf(const std::string_view word) noexcept
{
    const std::size_t high = word.size() == 2U ? kHex.find(word[0U]) : std::string_view::npos;
    const std::size_t low = word.size() == 2U ? kHex.find(word[1U]) : std::string_view::npos;
    const bool is_byte = high != std::string_view::npos && low != std::string_view::npos;
    return is_byte ? static_cast<int>(high * 16U + low) : -1;
}
} // namespace

/// A printed line behind its time; the name of the interface.
std::string_view CandumpReader::ReadPrinted(const std::string_view line, const std::size_t at, LogFrame& frame) const
{
    std::string_view rest = line.substr(at);
    const std::string_view name = TakeWord(rest);
    std::string_view word = TakeWord(rest);
    if (word == "RX" || word == "TX")
    {
        static_cast<void>(TakeWord(rest)); // Bit rate switch, error state of the sender.
        static_cast<void>(TakeWord(rest));
        word = TakeWord(rest);
    }
    ReadIdentifier(line, word, frame);
    const std::string_view length_word = TakeWord(rest);
    const int length = LengthOf(length_word);
    if (length < 0)
    {
        Refuse(line, "a length of 0 to 8 in brackets, or one of CAN FD in two digits");
    }
    frame.length = static_cast<std::uint8_t>(length);
    frame.is_fd = length_word.size() == 4U;
    const std::size_t remote = rest.find_first_not_of(' ');
    frame.is_remote = remote != std::string_view::npos && rest.substr(remote) == "remote request";
    if (frame.is_remote)
    {
        return name;
    }
    for (std::uint8_t place = 0U; place < frame.length; ++place)
    {
        const int byte = ByteOf(TakeWord(rest));
        if (byte < 0)
        {
            Refuse(line, "as many bytes of two hexadecimal digits as the length tells");
        }
        frame.data.at(place) = static_cast<std::uint8_t>(byte);
    }
    const std::size_t tail = rest.find_first_not_of(' ');
    const bool is_end = tail == std::string_view::npos || rest[tail] == '\'' || rest.substr(tail) == "ERRORFRAME";
    if (!is_end)
    {
        Refuse(line, "nothing behind the bytes but characters in quotes or ERRORFRAME");
    }
    return name;
}
} // namespace counterpoint::monitor
