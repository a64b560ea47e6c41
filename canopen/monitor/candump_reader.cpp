// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/readers.hpp"

#include "canopen/cia306/text/number.hpp"

#include <algorithm>
#include <charconv>
#include <string>
#include <system_error>
#include <utility>

namespace counterpoint::monitor
{
namespace
{

constexpr std::size_t kMicrosecondDigits = 6U;
constexpr std::size_t kNanosecondDigits = 9U;
constexpr Time kMostSeconds = 9000000000; ///< In nanoseconds a number of 64 bits.
constexpr std::size_t kStandardDigits = 3U;
constexpr std::size_t kExtendedDigits = 8U;
constexpr std::size_t kMostInterfaceBytes = 32U;
constexpr std::uint32_t kErrorFlag = 0x20000000U;
constexpr std::uint32_t kExtendedMask = 0x1FFFFFFFU;
constexpr std::uint32_t kStandardMask = 0x7FFU;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF"; ///< Of UTF-8.
constexpr const char* kForm =
    "(SECONDS.MICROSECONDS) INTERFACE IDENTIFIER#DATA as candump -l writes it, or a line of candump -ta";

/// The number that `text` is in hexadecimal digits; -1: it is none.
int HexOf(const std::string_view text) noexcept
{
    const auto number = cia306::ParseDigits(text, 16);
    return number ? static_cast<int>(*number) : -1;
}

/// Reads decimal digits from `at` on; how many there were.
std::size_t Decimal(const std::string_view line, std::size_t& at, Time& number) noexcept
{
    const std::size_t begin = at;
    at = std::min(line.find_first_not_of("0123456789", begin), line.size());
    const auto result = std::from_chars(line.data() + begin, line.data() + at, number);
    return result.ec == std::errc() ? at - begin : 0U;
}

bool IsFdLength(const std::size_t count) noexcept
{
    constexpr std::array<std::size_t, 7U> lengths{12U, 16U, 20U, 24U, 32U, 48U, 64U};
    return count <= kClassicalBytes || std::find(lengths.begin(), lengths.end(), count) != lengths.end();
}

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
    const bool is_known = is_fd ? IsFdLength(static_cast<std::size_t>(length)) : length <= kClassicalBytes;
    return is_known ? length : -1;
}

/// -1: not two hexadecimal digits.
int ByteOf(const std::string_view word) noexcept
{
    return word.size() == 2U ? HexOf(word) : -1;
}
} // namespace

CandumpReader::CandumpReader(std::string file, const std::string_view text, const RecordingOptions& options)
    : file_(std::move(file)), text_(text), choice_(options.interface)
{
    // Written by editors of Windows. Columns count from behind it, as editors do. [SRS_MON_025]
    text_.remove_prefix(text_.substr(0U, kByteOrderMark.size()) == kByteOrderMark ? kByteOrderMark.size() : 0U);
}

std::size_t CandumpReader::Place() const noexcept
{
    return line_;
}

// [SRS_MON_401]
Origin CandumpReader::Seen() const
{
    Origin origin = choice_.Seen();
    if (is_end_open_)
    {
        origin.doubt = "line " + std::to_string(line_) +
                       " has no end; the recording may have been cut there, and its last frame be longer than told";
    }
    return origin;
}

void CandumpReader::Refuse(const std::string_view line, const std::string_view at, const char* const expected) const
{
    const auto column = static_cast<std::size_t>(at.data() - line.data()) + 1U;
    throw cia306::InputError(file_, {line_, column}, {"line " + cia306::Quoted(line), expected});
}

bool CandumpReader::Next(LogFrame& frame)
{
    while (at_ < text_.size())
    {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        std::string_view line = text_.substr(at_, end - at_);
        at_ = end + 1U;
        ++line_;
        is_end_open_ = end == text_.size();
        if (!line.empty() && line.back() == '\r')
        {
            line.remove_suffix(1U);
        }
        if (!line.empty() && ReadLine(line, frame))
        {
            return true;
        }
    }
    return false;
}

/// Whether the frame is of the interface that is looked at.
bool CandumpReader::ReadLine(const std::string_view line, LogFrame& frame)
{
    frame = LogFrame{};
    std::size_t at = 0U;
    ReadTime(line, at, frame);
    const bool is_printed = at < line.size() && line[at] == ' ';
    const std::string_view name = is_printed ? ReadPrinted(line, at, frame) : ReadLogged(line, at, frame);
    if (!choice_.Takes(name, {name}, frame.time))
    {
        return false;
    }
    if (frame.time < last_)
    {
        Refuse(line, line, "a time that is not before that of the frame before");
    }
    last_ = frame.time;
    return true;
}

/// A line of candump -l behind its time, where no space stands; the name of the interface.
std::string_view CandumpReader::ReadLogged(const std::string_view line, const std::size_t at, LogFrame& frame) const
{
    const std::size_t name_end = line.find(' ', at);
    const bool has_name = name_end != std::string_view::npos && name_end - at <= kMostInterfaceBytes;
    if (!has_name)
    {
        Refuse(line, line.substr(at), kForm);
    }
    std::string_view rest = line.substr(name_end + 1U);
    const std::size_t space = rest.find(' ');
    if (space != std::string_view::npos)
    {
        const std::string_view direction = rest.substr(space + 1U);
        if (direction != "R" && direction != "T")
        {
            Refuse(line, direction, "nothing behind the data, or the direction R or T");
        }
        rest = rest.substr(0U, space);
    }
    ReadFrame(line, rest, frame);
    return line.substr(at, name_end - at);
}

void CandumpReader::ReadTime(const std::string_view line, std::size_t& at, LogFrame& frame) const
{
    Time seconds = 0;
    Time fraction = 0;
    at = line.front() == ' ' ? 2U : 1U; // What candump prints begins with a space.
    const bool has_start = at <= line.size() && line[at - 1U] == '(';
    const std::size_t second_digits = has_start ? Decimal(line, at, seconds) : 0U;
    const bool is_in_range = second_digits != 0U && seconds <= kMostSeconds;
    const bool has_point = is_in_range && at < line.size() && line[at] == '.';
    ++at;
    const std::size_t digits = has_point ? Decimal(line, at, fraction) : 0U;
    const bool has_digits = digits == kMicrosecondDigits || digits == kNanosecondDigits;
    const bool has_end = has_digits && line.substr(at, 2U) == ") ";
    if (!has_end)
    {
        Refuse(line, line, kForm);
    }
    at += 2U;
    frame.time = seconds * kSecond + fraction * (digits == kMicrosecondDigits ? kMicrosecond : 1);
}

void CandumpReader::ReadFrame(const std::string_view line, const std::string_view text, LogFrame& frame) const
{
    const std::size_t mark = text.find('#');
    if (mark == std::string_view::npos)
    {
        Refuse(line, text, "an identifier of 3 or 8 hexadecimal digits and #");
    }
    ReadIdentifier(line, text.substr(0U, mark), frame);
    ReadData(line, text.substr(mark + 1U), frame);
}

void CandumpReader::ReadIdentifier(const std::string_view line, const std::string_view text, LogFrame& frame) const
{
    const bool is_standard = text.size() == kStandardDigits;
    const auto number = cia306::ParseDigits(text, 16);
    const bool is_number = number && (is_standard || text.size() == kExtendedDigits);
    if (!is_number)
    {
        Refuse(line, text, "an identifier of 3 or 8 hexadecimal digits");
    }
    const auto identifier = static_cast<std::uint32_t>(*number);
    frame.is_error = !is_standard && (identifier & kErrorFlag) != 0U;
    frame.is_extended = !is_standard && !frame.is_error;
    frame.identifier = identifier & kExtendedMask;
    const bool is_in_range = is_standard ? identifier <= kStandardMask : identifier <= (kExtendedMask | kErrorFlag);
    if (!is_in_range)
    {
        Refuse(line, text, "an identifier of 11 bits in 3 digits, or of 29 bits in 8");
    }
}

void CandumpReader::ReadData(const std::string_view line, std::string_view text, LogFrame& frame) const
{
    if (!text.empty() && (text.front() == 'R' || text.front() == 'r'))
    {
        frame.is_remote = true;
        const int length = text.size() == 2U ? HexOf(text.substr(1U)) : (text.size() == 1U ? 0 : -1);
        if (length < 0 || length > kClassicalBytes)
        {
            Refuse(line, text, "R and a length from 0 to 8");
        }
        frame.length = static_cast<std::uint8_t>(length);
        return;
    }
    if (!text.empty() && text.front() == '#')
    {
        frame.is_fd = text.size() >= 2U && HexOf(text.substr(1U, 1U)) >= 0;
        text = text.substr(std::min<std::size_t>(2U, text.size()));
        if (!frame.is_fd)
        {
            Refuse(line, text, "## and a digit of flags before the data of a CAN FD frame");
        }
    }
    // A length code above 8 stands behind 8 bytes as _9 to _F.
    const bool has_code =
        text.size() == 18U && text[16U] == '_' && HexOf(text.substr(17U)) > kClassicalBytes && !frame.is_fd;
    text = has_code ? text.substr(0U, 16U) : text;
    const std::size_t count = text.size() / 2U;
    const bool is_length = text.size() % 2U == 0U && (frame.is_fd ? IsFdLength(count) : count <= kClassicalBytes);
    if (!is_length)
    {
        Refuse(line, text, frame.is_fd ? "data of a length that CAN FD has" : "0 to 8 bytes of two hexadecimal digits");
    }
    for (std::size_t place = 0U; place < count; ++place)
    {
        const int byte = ByteOf(text.substr(2U * place, 2U));
        if (byte < 0)
        {
            Refuse(line, text.substr(2U * place), "bytes of two hexadecimal digits");
        }
        frame.data[place] = static_cast<std::uint8_t>(byte);
    }
    frame.length = static_cast<std::uint8_t>(count);
}

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
        Refuse(line, length_word, "a length of 0 to 8 in brackets, or one of CAN FD in two digits");
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
        word = TakeWord(rest);
        const int byte = ByteOf(word);
        if (byte < 0)
        {
            Refuse(line, word, "as many bytes of two hexadecimal digits as the length tells");
        }
        frame.data.at(place) = static_cast<std::uint8_t>(byte);
    }
    const std::size_t tail = rest.find_first_not_of(' ');
    const bool is_end = tail == std::string_view::npos || rest[tail] == '\'' || rest.substr(tail) == "ERRORFRAME";
    if (!is_end)
    {
        Refuse(line, rest.substr(tail), "nothing behind the bytes but characters in quotes or ERRORFRAME");
    }
    return name;
}

} // namespace counterpoint::monitor
