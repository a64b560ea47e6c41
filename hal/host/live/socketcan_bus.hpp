// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_SOCKETCAN_BUS_HPP
#define HAL_HOST_LIVE_SOCKETCAN_BUS_HPP

#include "hal/host/live/hardware_clock.hpp"
#include "hal/host/live/link.hpp"
#include "hal/host/live/opened_bus.hpp"

#include <linux/can.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace counterpoint::host
{

/// A frame in the form of a raw socket, and how many of its bytes count (CAN_MTU or CANFD_MTU).
struct SocketCanFrame
{
    canfd_frame frame;
    std::size_t bytes;
};
/// @brief The frame in that form.
[[nodiscard]] SocketCanFrame ToSocketCan(const LiveFrame& frame);
/// @brief Reads a frame of that form. False: the bytes are none.
[[nodiscard]] bool FromSocketCan(const canfd_frame& raw, std::size_t bytes, LiveFrame& frame);

/// One interface of Linux, by a raw socket. Survives the interface's going down and up, and its being removed and made
/// again under the same name. Restart, and the policy kTimed, need CAP_NET_ADMIN. [SRS_LIVE_020, SRS_LIVE_021,
/// SRS_LIVE_022, SRS_LIVE_023, SRS_LIVE_024, SRS_LIVE_025, SRS_LIVE_026]
class LiveSocketCanBus final : public OpenedBus
{
  public:
    /// @brief Opens the interface. Throws LiveBusError.
    LiveSocketCanBus(const LiveAddress& address, const LiveOptions& options);

    [[nodiscard]] SendResult Send(const LiveFrame& frame) override;
    [[nodiscard]] bool Receive(LiveFrame& frame) override;
    [[nodiscard]] bool Restart() override;

  private:
    void Configure();
    void ApplyFilters();
    [[nodiscard]] bool Bind();
    void Look();
    void Enter(BusState state);
    void Learn(const LiveFrame& frame);
    [[nodiscard]] int Transmit(const LiveFrame& frame);
    void SendWaiting();
    void CarryOutPolicy();
    void PlanWake();
    void Service();

    LiveFile socket_;
    LiveLink link_{};
    HardwareClock clock_{};
    int index_{0};
    bool has_controller_{false};      ///< Linux tells its state; else only error frames do.
    bool is_carrying_{false};         ///< Else the kernel takes frames and throws them away without a word.
    std::uint32_t dropped_{0U};       ///< By the system, as it told last.
    std::uint64_t restart_at_ns_{0U}; ///< 0: no restart is due.
    std::uint64_t retry_at_ns_{0U};   ///< When to offer what waits to the system again.
};

} // namespace counterpoint::host

#endif
