// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_SOCKETCAND_SERVER_HPP
#define HAL_HOST_LIVE_SOCKETCAND_SERVER_HPP

#include "hal/host/live/bus.hpp"
#include "hal/host/live/poll.hpp"
#include "hal/host/live/socketcand/link.hpp"

#include <poll.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::host
{

constexpr std::size_t kSocketcandClients = 32U;

/// A bus under the name that clients open it by.
struct ServedBus
{
    std::string name;
    std::string address;
};

/// What a server has done.
struct ServerCounts
{
    std::uint32_t clients{0U};  ///< Now.
    std::uint64_t accepted{0U}; ///< Since the start.
    std::uint64_t to_bus{0U};   ///< Frames.
    std::uint64_t from_bus{0U};
    std::uint64_t malformed{0U}; ///< Elements answered by an error.
    std::uint64_t too_slow{0U};  ///< Clients disconnected because 1 MiB waited for them.
};

/// One client of the server: its connection, and a bus object of its own, so that it is a sender of its own on the bus.
class SocketcandClient
{
  public:
    /// @brief `buses` and `counts` outlive the client.
    SocketcandClient(LiveFile socket, const std::vector<ServedBus>& buses, ServerCounts& counts);
    /// @brief What to poll for the connection.
    [[nodiscard]] pollfd Connection() const;
    /// @brief What to poll for the bus of one that has opened a bus.
    [[nodiscard]] pollfd Bus() const;
    /// @brief Reads, obeys and answers what is there. False: the connection has ended.
    [[nodiscard]] bool Serve();
    /// @brief Whether it has opened a bus.
    [[nodiscard]] bool HasBus() const
    {
        return bus_ != nullptr;
    }
    /// @brief Whether a frame waits because the bus was full.
    [[nodiscard]] bool HoldsFrame() const
    {
        return held_.has_value();
    }

  private:
    void Say(SocketcandWord word);
    void SayError(const std::string& text);
    void Obey(const SocketcandMessage& message);
    void Open(const std::string& name);
    void Transmit(const LiveFrame& frame);
    void Tell(const LiveFrame& frame);

    SocketcandLink link_;
    const std::vector<ServedBus>& buses_;
    ServerCounts& counts_;
    std::unique_ptr<LiveBus> bus_{};
    std::optional<LiveFrame> held_{}; ///< Refused by a full bus; nothing is read before it is gone.
    bool is_raw_{false};
    bool tells_own_{false};
    bool is_ending_{false}; ///< After the last answer.
};

/// Offers buses by the socketcand protocol. For one thread. A connection that opened no bus gives its place to a new
/// one. [SRS_LIVE_053] [SRS_LIVE_054] [SRS_LIVE_061]
class SocketcandServer
{
  public:
    /// @brief Listens; port 0: a free one. Throws LiveBusError when it cannot, or when a bus cannot be opened.
    SocketcandServer(const std::string& host, std::uint16_t port, std::vector<ServedBus> buses);
    /// @brief The port on which it listens.
    [[nodiscard]] std::uint16_t Port() const;
    /// @brief Serves its clients for at most that time.
    void Serve(int milliseconds);
    /// @brief What it has done so far.
    [[nodiscard]] ServerCounts Counts() const
    {
        return counts_;
    }

  private:
    void Accept();
    [[nodiscard]] bool MakeRoom();

    std::vector<ServedBus> buses_;
    LiveFile listener_;
    std::vector<std::unique_ptr<SocketcandClient>> clients_{}; ///< The oldest first.
    ServerCounts counts_{};
    bool is_full_{false}; ///< Who calls waits for one turn: the system has no descriptor for it.
};

} // namespace counterpoint::host

#endif
