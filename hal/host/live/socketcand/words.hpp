// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_SOCKETCAND_WORDS_HPP
#define HAL_HOST_LIVE_SOCKETCAND_WORDS_HPP

#include "hal/host/live/socketcand/text.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace counterpoint::host::socketcand
{

// What reading and writing of the protocol share.
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

/// @brief For an answer: what is no printable character, or a bracket, as a question mark; at most 32 characters.
[[nodiscard]] std::string Shown(std::string_view text);

} // namespace counterpoint::host::socketcand

#endif
