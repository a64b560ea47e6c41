// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_UDP_CROSS_LINK_HPP
#define HAL_HOST_UDP_CROSS_LINK_HPP

#include "hal/api/cross_link.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace counterpoint::host
{

/// Ports on 127.0.0.1.
struct UdpPorts
{
    std::uint16_t own;
    std::uint16_t peer;
};

/// Datagrams between two processes of one machine. Never blocks. Throws std::runtime_error, with the port, if there is
/// no such address. [SRS_LNK_022]
class UdpSocket
{
  public:
    /// @brief Opens the own port.
    explicit UdpSocket(const UdpPorts& ports);
    ~UdpSocket();
    UdpSocket(const UdpSocket&) = delete;
    UdpSocket(UdpSocket&&) = delete;
    UdpSocket& operator=(const UdpSocket&) = delete;
    UdpSocket& operator=(UdpSocket&&) = delete;

    /// @brief Sends a datagram. False: it was not handed over.
    [[nodiscard]] bool Send(const void* bytes, std::size_t count) noexcept;
    /// @brief Bytes of the next datagram; 0: there is none. A longer one is cut.
    [[nodiscard]] std::size_t Receive(void* bytes, std::size_t room) noexcept;

  private:
    int socket_;
    std::uint16_t peer_;
};

/// The link between two processes that run as the two CPUs. [SRS_LNK_022]
class UdpCrossLink final : public hal::CrossLink
{
  public:
    /// @brief Throws as UdpSocket.
    explicit UdpCrossLink(const UdpPorts& ports) : socket_{ports}
    {
    }
    [[nodiscard]] hal::LinkStatus Send(const hal::LinkFrame& frame) noexcept override;
    [[nodiscard]] hal::LinkStatus Receive(hal::LinkFrame& frame) noexcept override;

  private:
    UdpSocket socket_;
};

} // namespace counterpoint::host

#endif
