// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_UDP_BUS_HPP
#define HAL_HOST_LIVE_UDP_BUS_HPP

#include "hal/host/live/opened_bus.hpp"

#include <cstdint>
#include <string>
#include <sys/types.h>

namespace counterpoint::host
{

/// A bus for the processes of one machine: a multicast group on the loopback interface, one datagram a frame. Frames of
/// one sender keep their order; those of two senders may reach two receivers in different orders, and there is no
/// arbitration. [SRS_LIVE_010, SRS_LIVE_011, SRS_LIVE_012, SRS_LIVE_013]
class LiveUdpBus final : public OpenedBus
{
  public:
    /// @brief Joins the group. Throws LiveBusError.
    LiveUdpBus(const LiveAddress& address, const LiveOptions& options);

    [[nodiscard]] SendResult Send(const LiveFrame& frame) override;
    [[nodiscard]] bool Receive(LiveFrame& frame) override;

  private:
    void Join();
    [[nodiscard]] bool Transmit(const LiveFrame& frame);
    void SendWaiting();
    void PlanWake();
    [[nodiscard]] bool Unpack(const std::uint8_t* bytes, std::size_t count, LiveFrame& frame) const;
    void Occupy(const LiveFrame& frame, std::uint64_t from_ns);

    LiveFile socket_;
    std::uint64_t sender_;         ///< Tells own frames from those of others.
    std::uint64_t free_at_ns_{0U}; ///< When the frames seen so far have left the bus.
};

} // namespace counterpoint::host

#endif
