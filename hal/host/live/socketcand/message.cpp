// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/socketcand/text.hpp"

#include "hal/host/live/socketcand/words.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace counterpoint::host
{

std::string socketcand::Shown(const std::string_view text)
{
    std::string shown;
    for (const char letter : text.substr(0U, 32U))
    {
        const bool is_plain = (letter > ' ') && (letter <= '~') && (letter != '<') && (letter != '>');
        shown += is_plain ? letter : '?';
    }
    return shown;
}

using socketcand::kExtendedDigits;
using socketcand::kMicrosecondsPerSecond;
using socketcand::kStandardDigits;
using socketcand::Shown;

namespace
{

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
    for (const socketcand::WordName& row : socketcand::kWords)
    {
        if (row.word == word)
        {
            return std::string(row.name);
        }
    }
    return "error";
}

} // namespace

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
