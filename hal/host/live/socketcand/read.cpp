// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/socketcand/words.hpp"
#include "hal/host/virtual/frame_bits.hpp"

#include <algorithm>
#include <charconv>
#include <linux/can.h>
#include <vector>

namespace counterpoint::host
{

using socketcand::kExtendedDigits;
using socketcand::kMicrosecondsPerSecond;
using socketcand::kStandardDigits;
using socketcand::kWords;
using socketcand::Shown;
using socketcand::WordName;

namespace
{

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

} // namespace counterpoint::host
