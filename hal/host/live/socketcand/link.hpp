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

/// One end of a connection that carries elements. Nothing blocks.
class SocketcandLink
{
  public:
    explicit SocketcandLink(LiveFile socket);
    [[nodiscard]] int Descriptor() const
    {
        return socket_.Get();
    }
    /// @brief Sends now what the system takes, keeps the rest.
    void Say(const SocketcandMessage& message);
    void Say(SocketcandWord word);
    /// @brief Hands on what was kept.
    void Flush();
    [[nodiscard]] std::size_t WaitingBytes() const
    {
        return waiting_.size();
    }
    /// @brief Takes what came; IsLost tells afterwards whether the other end is gone.
    void Read();
    [[nodiscard]] std::optional<SocketcandMessage> Next()
    {
        return stream_.Next();
    }
    [[nodiscard]] bool IsLost() const
    {
        return socket_.Get() < 0;
    }
    void Close();

  private:
    LiveFile socket_;
    SocketcandStream stream_{};
    std::string waiting_{};
};

} // namespace counterpoint::host

#endif
