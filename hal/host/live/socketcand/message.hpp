// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_SOCKETCAND_MESSAGE_HPP
#define HAL_HOST_LIVE_SOCKETCAND_MESSAGE_HPP

#include "hal/host/live/bus.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace counterpoint::host
{

/// Longest element, with its brackets.
constexpr std::size_t kSocketcandElementBytes = 256U;
/// Longest text of an element `< error TEXT >`.
constexpr std::size_t kSocketcandErrorTextBytes = kSocketcandElementBytes - std::string_view("< error  >").size();

/// Elements of the socketcand protocol, and of our extension of it.
enum class SocketcandWord : std::uint8_t
{
    kInvalid = 0U,
    kHi,
    kOk,
    kEcho,
    kOpen,
    kRawMode,
    kBcmMode,
    kOwnMode, ///< Ours: own frames are told too.
    kSend,
    kSendRemote,
    kFrame,
    kRemote,
    kOwnFrame,  ///< Ours.
    kOwnRemote, ///< Ours.
    kErrorFrame,
    kErrorText,
};

/// One element. Which fields have a meaning depends on the word; `stamp_us` is the time that the sender gave the frame.
struct SocketcandMessage
{
    SocketcandWord word{SocketcandWord::kInvalid};
    LiveFrame frame{};
    std::uint64_t stamp_us{0U};
    std::string text{};    ///< Bus of kOpen; words of kErrorText, at most kSocketcandErrorTextBytes.
    std::string problem{}; ///< Not empty: the element is malformed, and why; `word` is kInvalid then.
};

/// @brief Reads one element with its brackets. [SRS_LIVE_050]
[[nodiscard]] SocketcandMessage ReadSocketcand(std::string_view element);
/// @brief Writes a message as an element; ReadSocketcand reads the same message from it.
[[nodiscard]] std::string WriteSocketcand(const SocketcandMessage& message);

/// A stream cut into elements. What stands between them may be white space only. [SRS_LIVE_050]
class SocketcandStream
{
  public:
    /// @brief Adds bytes as they come.
    void Feed(const char* bytes, std::size_t count);
    /// @brief The next element, read; empty: none is whole yet.
    [[nodiscard]] std::optional<SocketcandMessage> Next();

  private:
    std::string rest_{};
    bool is_skipping_{false}; ///< Within an element that is too long: to its end.
};

} // namespace counterpoint::host

#endif
