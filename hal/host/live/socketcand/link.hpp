// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_SOCKETCAND_LINK_HPP
#define HAL_HOST_LIVE_SOCKETCAND_LINK_HPP

#include "hal/host/live/poll.hpp"
#include "hal/host/live/socketcand/message.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace counterpoint::host
{

/// One end of a connection that carries elements of the socketcand protocol. Nothing blocks.
class SocketcandLink
{
  public:
    /// @brief Takes the socket over.
    explicit SocketcandLink(LiveFile socket);
    /// @brief The descriptor to poll; -1 once the connection is lost.
    [[nodiscard]] int Descriptor() const
    {
        return socket_.Get();
    }
    /// @brief Sends what the system takes at present, and keeps the rest.
    void Say(const SocketcandMessage& message);
    /// @brief The same with a message that is one word.
    void Say(SocketcandWord word);
    /// @brief Sends what was kept.
    void Flush();
    /// @brief How many bytes are kept.
    [[nodiscard]] std::size_t WaitingBytes() const
    {
        return waiting_.size();
    }
    /// @brief Takes what came; IsLost tells afterwards whether the other end is gone.
    void Read();
    /// @brief The next whole element that was read; empty: there is none.
    [[nodiscard]] std::optional<SocketcandMessage> Next()
    {
        return stream_.Next();
    }
    /// @brief Whether the other end is gone.
    [[nodiscard]] bool IsLost() const
    {
        return socket_.Get() < 0;
    }
    /// @brief Ends the connection.
    void Close();

  private:
    LiveFile socket_;
    SocketcandStream stream_{};
    std::string waiting_{};
};

} // namespace counterpoint::host

#endif
