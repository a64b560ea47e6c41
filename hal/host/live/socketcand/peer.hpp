// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_SOCKETCAND_PEER_HPP
#define HAL_HOST_LIVE_SOCKETCAND_PEER_HPP

#include "hal/host/live/address.hpp"
#include "hal/host/live/poll.hpp"

#include <cstddef>
#include <cstdint>
#include <sys/socket.h>
#include <vector>

namespace counterpoint::host
{

/// Where the server of an address is: all addresses that its name has. The name is looked up once.
class SocketcandPeer
{
  public:
    /// @brief Throws LiveBusError for a name that no machine has.
    explicit SocketcandPeer(const LiveAddress& address);
    /// @brief Connects to the first address that takes a connection, until `until_ns`. Throws LiveBusError.
    [[nodiscard]] LiveFile Connect(std::uint64_t until_ns);
    /// @brief Begins a connection to the address of the last one, without waiting; reading shows what becomes of it.
    [[nodiscard]] LiveFile BeginConnect() const;
    /// @brief The next connection goes to another address, if there is one.
    void TryOther();

  private:
    struct Place
    {
        sockaddr_storage address;
        socklen_t bytes;
    };

    LiveAddress address_;
    std::vector<Place> places_{};
    std::size_t chosen_{0U};
};

} // namespace counterpoint::host

#endif
