// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_SOCKETCAND_GREETING_HPP
#define HAL_HOST_LIVE_SOCKETCAND_GREETING_HPP

#include "hal/host/live/socketcand/link.hpp"

#include <cstdint>
#include <deque>
#include <string>

namespace counterpoint::host
{

/// What a client says to its server before frames come: open, rawmode, ownmode. Each call takes the answers that are
/// there; nothing waits. [SRS_LIVE_051, SRS_LIVE_052, SRS_LIVE_582]
class SocketcandGreeting
{
  public:
    /// @brief `bus` is the name by which the server offers the bus.
    explicit SocketcandGreeting(std::string bus);

    /// @brief Goes on with what the link has read.
    void GoOn(SocketcandLink& link);
    /// @brief Whether the greeting is complete: what the link reads from now on is of the bus.
    [[nodiscard]] bool IsOver() const;
    /// @brief Why it cannot go on; empty: it can.
    [[nodiscard]] const std::string& Problem() const
    {
        return problem_;
    }
    /// @brief What the server has to do next: "answer ownmode"; only before it is over.
    [[nodiscard]] std::string Awaited() const;
    /// @brief Whether the server tells own frames.
    [[nodiscard]] bool HasOwn() const
    {
        return has_own_;
    }
    /// @brief Messages of the bus that came before the last answer; a bounded number.
    [[nodiscard]] std::deque<SocketcandMessage>& Early()
    {
        return early_;
    }

  private:
    enum class Step : std::uint8_t
    {
        kHi = 0U,
        kOpen = 1U,
        kRawMode = 2U,
        kOwnMode = 3U,
        kOver = 4U,
    };

    void Take(const SocketcandMessage& message, SocketcandLink& link);
    void TakeOwnMode(const SocketcandMessage& message);
    void Say(Step step, SocketcandLink& link);

    std::string bus_;
    Step step_{Step::kHi};
    std::string problem_{};
    std::deque<SocketcandMessage> early_{};
    bool has_own_{false};
};

} // namespace counterpoint::host

#endif
