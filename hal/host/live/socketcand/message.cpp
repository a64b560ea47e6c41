// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Elements of the protocol, read and written.
#include "hal/host/live/socketcand/message.hpp"

#include "hal/host/virtual/frame_bits.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <linux/can.h>
#include <string>
#include <string_view>
#include <vector>

namespace counterpoint::host
{
namespace
{

constexpr std::uint64_t kMicrosecondsPerSecond = 1'000'000U;
constexpr std::size_t kStandardDigits = 3U;
constexpr std::size_t kExtendedDigits = 8U;

struct WordName
{
    SocketcandWord word;
    std::string_view name;
    std::size_t least; ///< Values behind the word.
    std::size_t most;
};

constexpr std::array<WordName, 14U> kWords{{
    {SocketcandWord::kHi, "hi", 0U, 0U},
    {SocketcandWord::kOk, "ok", 0U, 0U},
    {SocketcandWord::kEcho, "echo", 0U, 0U},
    {SocketcandWord::kOpen, "open", 1U, 1U},
    {SocketcandWord::kRawMode, "rawmode", 0U, 0U},
    {SocketcandWord::kBcmMode, "bcmmode", 0U, 0U},
    {SocketcandWord::kOwnMode, "ownmode", 0U, 0U},
    {SocketcandWord::kSend, "send", 2U, 10U},
    {SocketcandWord::kSendRemote, "sendrtr", 2U, 2U},
    {SocketcandWord::kFrame, "frame", 2U, 10U},
    {SocketcandWord::kRemote, "rtr", 3U, 3U},
    {SocketcandWord::kOwnFrame, "own", 2U, 10U},
    {SocketcandWord::kOwnRemote, "ownrtr", 3U, 3U},
    {SocketcandWord::kErrorText, "error", 1U, 64U},
}};

/// For an answer: what is no printable character, or a closing bracket, as a question mark; at most 32 characters.
/// There is no opening one in `text`: it would have begun an element.
std::string Shown(const std::string_view text)
{
    std::string shown;
    for (const char letter : text.substr(0U, 32U))
    {
        const bool is_plain = (std::isgraph(static_cast<unsigned char>(letter)) != 0) && (letter != '>');
        shown += is_plain ? letter : '?';
    }
    return shown;
}

constexpr std::uint64_t kGreatestSeconds = (~std::uint64_t{0U} / kMicrosecondsPerSecond) - 1U;
constexpr std::size_t kGreatestNameBytes = 16U;

using Values = std::vector<std::string_view>;

/// An element that is not what its word asks for; the text says why.
struct Problem
{
    std::string text;
};

[[noreturn]] void Refuse(const std::string_view word, const std::string_view what, const std::string_view found,
                         const std::string_view expected)
{
    throw Problem{std::string(word) + ": " + std::string(what) + " '" + Shown(found) + "', expected " +
                  std::string(expected)};
}

Values Split(const std::string_view inside)
{
    Values values;
    std::size_t at = 0U;
    while (at < inside.size())
    {
        const std::size_t first = inside.find_first_not_of(" \t\r\n", at);
        if (first == std::string_view::npos)
        {
            break;
        }
        const std::size_t end = std::min(inside.find_first_of(" \t\r\n", first), inside.size());
        values.push_back(inside.substr(first, end - first));
        at = end;
    }
    return values;
}

template <typename Number> std::optional<Number> NumberOf(const std::string_view text, const int base)
{
    Number number{};
    const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), number, base);
    const bool is_whole = (result.ec == std::errc{}) && (result.ptr == text.data() + text.size());
    return is_whole ? std::optional<Number>{number} : std::nullopt;
}

void ReadIdentifier(const std::string_view word, const std::string_view text, LiveFrame& frame)
{
    frame.extended = text.size() == kExtendedDigits;
    const std::optional<std::uint32_t> number = NumberOf<std::uint32_t>(text, 16);
    const std::uint32_t greatest = frame.extended ? kGreatestExtendedIdentifier : kGreatestStandardIdentifier;
    const bool is_wide_enough = frame.extended || (text.size() <= kStandardDigits);
    if (!number || !is_wide_enough || (*number > greatest))
    {
        Refuse(word, "identifier", text, "1 to 3 hexadecimal digits up to 7FF, or 8 up to 1FFFFFFF");
    }
    frame.identifier = *number;
}

void ReadLength(const std::string_view word, const std::string_view text, LiveFrame& frame)
{
    const std::optional<std::uint8_t> number = NumberOf<std::uint8_t>(text, 10);
    if (!number || (*number > kClassicalDataBytes))
    {
        Refuse(word, "length", text, "0 to 8");
    }
    frame.length_bytes = *number;
}

std::uint8_t ReadByte(const std::string_view word, const std::string_view text)
{
    const std::optional<std::uint8_t> number = (text.size() <= 2U) ? NumberOf<std::uint8_t>(text, 16) : std::nullopt;
    if (!number)
    {
        Refuse(word, "data byte", text, "1 or 2 hexadecimal digits");
    }
    return *number;
}

std::optional<std::uint64_t> StampOf(const std::string_view text)
{
    const std::size_t point = text.find('.');
    if (point == std::string_view::npos)
    {
        return std::nullopt;
    }
    const std::string_view fraction = text.substr(point + 1U);
    const std::optional<std::uint64_t> seconds = NumberOf<std::uint64_t>(text.substr(0U, point), 10);
    std::optional<std::uint64_t> rest = NumberOf<std::uint64_t>(fraction, 10);
    if (!seconds || !rest || (*seconds > kGreatestSeconds) || (fraction.size() > 6U))
    {
        return std::nullopt;
    }
    for (std::size_t digits = fraction.size(); digits < 6U; ++digits)
    {
        *rest *= 10U;
    }
    return (*seconds * kMicrosecondsPerSecond) + *rest;
}

std::uint64_t ReadStamp(const std::string_view word, const std::string_view text)
{
    const std::optional<std::uint64_t> stamp = StampOf(text);
    if (!stamp)
    {
        Refuse(word, "time", text, "SECONDS.MICROSECONDS");
    }
    return *stamp;
}

/// `send ID LENGTH BYTE...`
void ReadSend(const Values& values, SocketcandMessage& message)
{
    const std::string_view word = values[0];
    ReadIdentifier(word, values[1], message.frame);
    ReadLength(word, values[2], message.frame);
    message.frame.remote = message.word == SocketcandWord::kSendRemote;
    const std::size_t bytes = values.size() - 3U;
    if (!message.frame.remote && (bytes != message.frame.length_bytes))
    {
        Refuse(word, "count of data bytes", std::to_string(bytes),
               std::to_string(message.frame.length_bytes) + " as the length says");
    }
    for (std::size_t n = 0U; n < bytes; ++n)
    {
        message.frame.data[n] = ReadByte(word, values[3U + n]);
    }
}

/// `frame ID TIME DATA`, the data as one word or as several; `rtr ID TIME LENGTH`.
void ReadReceived(const Values& values, SocketcandMessage& message)
{
    const std::string_view word = values[0];
    ReadIdentifier(word, values[1], message.frame);
    message.stamp_us = ReadStamp(word, values[2]);
    message.frame.own = (message.word == SocketcandWord::kOwnFrame) || (message.word == SocketcandWord::kOwnRemote);
    message.frame.remote = (message.word == SocketcandWord::kRemote) || (message.word == SocketcandWord::kOwnRemote);
    if (message.frame.remote)
    {
        ReadLength(word, values[3], message.frame);
        return;
    }
    std::string data;
    for (std::size_t n = 3U; n < values.size(); ++n)
    {
        data += (values[n].size() == 1U) ? "0" : "";
        data += values[n];
    }
    if ((data.size() % 2U != 0U) || (data.size() > 2U * kClassicalDataBytes))
    {
        Refuse(word, "data", data, "0 to 8 bytes of 2 hexadecimal digits");
    }
    for (std::size_t n = 0U; n < data.size(); n += 2U)
    {
        message.frame.data[n / 2U] = ReadByte(word, std::string_view(data).substr(n, 2U));
    }
    message.frame.length_bytes = static_cast<std::uint8_t>(data.size() / 2U);
}

/// `error CLASSES TIME` tells of the bus, `error WORD...` of a command.
void ReadError(const Values& values, SocketcandMessage& message)
{
    const std::optional<std::uint32_t> classes =
        (values.size() == 3U) ? NumberOf<std::uint32_t>(values[1], 16) : std::nullopt;
    const std::optional<std::uint64_t> stamp = classes ? StampOf(values[2]) : std::nullopt;
    if (stamp && (*classes <= CAN_ERR_MASK))
    {
        message.word = SocketcandWord::kErrorFrame;
        message.frame.error = true;
        message.frame.identifier = *classes;
        message.frame.length_bytes = kClassicalDataBytes;
        message.stamp_us = *stamp;
        return;
    }
    for (std::size_t n = 1U; n < values.size(); ++n)
    {
        message.text += (n == 1U) ? "" : " ";
        message.text += values[n];
    }
    if (message.text.size() > kSocketcandErrorTextBytes)
    {
        Refuse(values[0], "text", message.text, "at most " + std::to_string(kSocketcandErrorTextBytes) + " characters");
    }
}

void ReadValues(const Values& values, SocketcandMessage& message)
{
    switch (message.word)
    {
    case SocketcandWord::kOpen:
        if (values[1].size() > kGreatestNameBytes)
        {
            Refuse(values[0], "bus", values[1], "a name of at most 16 characters");
        }
        message.text = values[1];
        break;
    case SocketcandWord::kSend:
    case SocketcandWord::kSendRemote:
        ReadSend(values, message);
        break;
    case SocketcandWord::kFrame:
    case SocketcandWord::kRemote:
    case SocketcandWord::kOwnFrame:
    case SocketcandWord::kOwnRemote:
        ReadReceived(values, message);
        break;
    case SocketcandWord::kErrorFrame:
    case SocketcandWord::kErrorText:
        ReadError(values, message);
        break;
    case SocketcandWord::kInvalid:
    case SocketcandWord::kHi:
    case SocketcandWord::kOk:
    case SocketcandWord::kEcho:
    case SocketcandWord::kRawMode:
    case SocketcandWord::kBcmMode:
    case SocketcandWord::kOwnMode:
        break;
    }
}

SocketcandMessage ReadInside(const std::string_view inside)
{
    SocketcandMessage message;
    const Values values = Split(inside);
    if (values.empty())
    {
        throw Problem{"empty element, expected a word"};
    }
    for (const WordName& row : kWords)
    {
        if (row.name != values[0])
        {
            continue;
        }
        const std::size_t count = values.size() - 1U;
        if ((count < row.least) || (count > row.most))
        {
            const std::string most = (row.least == row.most) ? "" : (" to " + std::to_string(row.most));
            Refuse(row.name, "count of values", std::to_string(count), std::to_string(row.least) + most);
        }
        message.word = row.word;
        ReadValues(values, message);
        return message;
    }
    throw Problem{"unknown command '" + Shown(values[0]) +
                  "', expected open, rawmode, bcmmode, ownmode, send, sendrtr or echo"};
}

std::string Hexadecimal(const std::uint32_t number, const int digits)
{
    std::array<char, 16U> text{};
    static_cast<void>(std::snprintf(text.data(), text.size(), "%0*X", digits, number));
    return text.data();
}

std::string Identifier(const LiveFrame& frame)
{
    return Hexadecimal(frame.identifier, static_cast<int>(frame.extended ? kExtendedDigits : kStandardDigits));
}

std::string Data(const LiveFrame& frame, const std::string& between)
{
    std::string text;
    for (std::size_t n = 0U; n < frame.length_bytes; ++n)
    {
        text += (n == 0U) ? "" : between;
        text += Hexadecimal(frame.data[n], 2);
    }
    return text;
}

std::string Stamp(const std::uint64_t stamp_us)
{
    std::array<char, 32U> text{};
    static_cast<void>(std::snprintf(text.data(), text.size(), "%llu.%06llu",
                                    static_cast<unsigned long long>(stamp_us / kMicrosecondsPerSecond),
                                    static_cast<unsigned long long>(stamp_us % kMicrosecondsPerSecond)));
    return text.data();
}

std::string NameOf(const SocketcandWord word)
{
    for (const WordName& row : kWords)
    {
        if (row.word == word)
        {
            return std::string(row.name);
        }
    }
    return "error";
}

} // namespace

SocketcandMessage ReadSocketcand(const std::string_view element)
{
    try
    {
        const bool is_closed = (element.size() >= 2U) && (element.front() == '<') && (element.back() == '>');
        if (!is_closed || (element.size() > kSocketcandElementBytes))
        {
            throw Problem{"element without brackets or of more than 256 characters, expected a word and its values in "
                          "angle brackets"};
        }
        const std::string_view inside = element.substr(1U, element.size() - 2U);
        if (inside.find_first_of("<>") != std::string_view::npos)
        {
            throw Problem{"bracket within an element, expected the end of the element before"};
        }
        return ReadInside(inside);
    }
    catch (const Problem& problem)
    {
        SocketcandMessage message;
        message.problem = problem.text;
        return message;
    }
}

std::string WriteSocketcand(const SocketcandMessage& message)
{
    const std::string start = "< " + NameOf(message.word) + " ";
    const LiveFrame& frame = message.frame;
    switch (message.word)
    {
    case SocketcandWord::kOpen:
    case SocketcandWord::kErrorText:
        return start + message.text + " >";
    case SocketcandWord::kSend:
        return start + Identifier(frame) + " " + std::to_string(frame.length_bytes) + " " + Data(frame, " ") + " >";
    case SocketcandWord::kSendRemote:
        return start + Identifier(frame) + " " + std::to_string(frame.length_bytes) + " >";
    case SocketcandWord::kFrame:
    case SocketcandWord::kOwnFrame:
        return start + Identifier(frame) + " " + Stamp(message.stamp_us) + " " + Data(frame, "") + " >";
    case SocketcandWord::kRemote:
    case SocketcandWord::kOwnRemote:
        return start + Identifier(frame) + " " + Stamp(message.stamp_us) + " " + std::to_string(frame.length_bytes) +
               " >";
    case SocketcandWord::kErrorFrame:
        return start + Hexadecimal(frame.identifier, static_cast<int>(kStandardDigits)) + " " +
               Stamp(message.stamp_us) + " >";
    case SocketcandWord::kInvalid:
    case SocketcandWord::kHi:
    case SocketcandWord::kOk:
    case SocketcandWord::kEcho:
    case SocketcandWord::kRawMode:
    case SocketcandWord::kBcmMode:
    case SocketcandWord::kOwnMode:
        break;
    }
    return start + ">";
}

void SocketcandStream::Feed(const char* const bytes, const std::size_t count)
{
    rest_.append(bytes, count);
}

std::optional<SocketcandMessage> SocketcandStream::Next()
{
    if (is_skipping_)
    {
        const std::size_t end = rest_.find('>');
        rest_.erase(0U, (end == std::string::npos) ? rest_.size() : end + 1U);
        is_skipping_ = end == std::string::npos;
    }
    rest_.erase(0U, std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
    if (rest_.empty())
    {
        return std::nullopt;
    }
    SocketcandMessage message;
    if (rest_.front() != '<')
    {
        const std::size_t start = std::min(rest_.find('<'), rest_.size());
        message.problem =
            "'" + Shown(std::string_view(rest_).substr(0U, start)) + "' outside of angle brackets, expected an element";
        rest_.erase(0U, start);
        return message;
    }
    const std::size_t end = rest_.find('>');
    if (end != std::string::npos)
    {
        message = ReadSocketcand(std::string_view(rest_).substr(0U, end + 1U));
        rest_.erase(0U, end + 1U);
        return message;
    }
    if (rest_.size() < kSocketcandElementBytes)
    {
        return std::nullopt;
    }
    message.problem = "element without an end in 256 characters, expected a closing bracket";
    rest_.clear();
    is_skipping_ = true;
    return message;
}

} // namespace counterpoint::host
