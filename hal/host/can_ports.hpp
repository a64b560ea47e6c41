// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_CAN_PORTS_HPP
#define HAL_HOST_CAN_PORTS_HPP

#include "hal/api/can_ports.hpp"
#include "hal/host/clocks.hpp"
#include "hal/host/virtual/bus.hpp"
#include "safety_core/contract/can_frame.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::host
{

/// Receives stamped frames, in bus order: an adapter in front of the kernel, or a FrameQueue.
class FrameSink
{
  public:
    virtual ~FrameSink() = default;
    /// @brief A frame was received.
    virtual void OnFrame(const StampedFrame& frame) = 0;
    /// @brief A frame of this device was on the bus.
    virtual void OnConfirm(const StampedFrame& frame) = 0;
    /// @brief Frames were lost.
    virtual void OnOverflow() = 0;
};

/// The CAN controllers of one device on a VirtualBus. Hands over each frame at its end on the bus with both stamps, as
/// an interrupt would; a device that polls puts a FrameQueue between. Two controllers may sit on the same bus (each
/// then also hears the other, so give them filters) or on two buses that the test advances in step, earliest event
/// first. [SRS_HAL_011, SRS_HAL_012]
class HostCanPorts final : public hal::CanPorts
{
  public:
    /// @brief `clocks` and `sink` outlive the ports, the ports outlive the buses' last Advance.
    HostCanPorts(HostClocks& clocks, FrameSink& sink);

    /// @brief Attaches one controller; a port is connected once.
    NodeIndex ConnectPort(CanPortId port, VirtualBus& bus, std::size_t queue_capacity);
    /// @brief Node of a connected port on its bus.
    [[nodiscard]] NodeIndex NodeOf(CanPortId port) const;
    [[nodiscard]] hal::CanGuarantees Guarantees() const noexcept override;

  private:
    class Controller final : public BusListener
    {
      public:
        void OnReceived(const CanFrame& frame, BusTime at) override;
        void OnConfirmed(const CanFrame& frame, BusTime at) override;

        HostCanPorts* ports{nullptr};
        VirtualBus* bus{nullptr};
        NodeIndex node{0U};
    };

    [[nodiscard]] hal::TransmitStatus DoTransmit(const CanFrame& frame) noexcept override;

    HostClocks& clocks_;
    FrameSink& sink_;
    Controller first_;
    Controller second_;
};

} // namespace counterpoint::host

#endif
