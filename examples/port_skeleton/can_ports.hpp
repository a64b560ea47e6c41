// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_SKELETON_CAN_PORTS_HPP
#define EXAMPLES_PORT_SKELETON_CAN_PORTS_HPP

#include "hal/api/can_ports.hpp"
#include "parts.hpp"
#include "safety_core/contract/can_frame.hpp"

namespace port_skeleton
{

/// What happened on the bus. Anything but kReceived and kConfirmed is no frame.
enum class EventKind : std::uint8_t
{
    kInvalid = 0U, ///< Hand it to the device as a loss.
    kNothing = 1U,
    kLoss = 2U,
    kReceived = 0x3CU,
    kConfirmed = 0x5AU,
};

struct CanEvent
{
    EventKind kind;
    counterpoint::StampedFrame frame;
};

/// The CAN controllers of the device, one or two.
class CanPorts final : public counterpoint::hal::CanPorts
{
  public:
    /// @brief CONTRACT. Answer kGiven only for what is so on this hardware, with this setup: the kernel relies on it,
    /// and refuses to start otherwise. `bus_order`: frames of all controllers, received and confirmed, come out of Next
    /// in the order in which they ended on the bus. `stamps`: both counters of each frame were read in one place,
    /// directly one after the other. `confirmations`: each frame that was sent comes back once.
    [[nodiscard]] counterpoint::hal::CanGuarantees Guarantees() const noexcept override;

    /// @brief CONTRACT. The oldest event, for the loop of the device before each cycle. The receive interrupt stamps
    /// each frame by Clocks::Now and puts it into a queue; this takes it out. A frame that found no room, or whose
    /// order or stamp is not known, becomes a kLoss before the next frame. A confirmation is read back from the
    /// controller, and only a frame that equals what was handed over is confirmed. Foreign identifiers stay in the
    /// filters, and so do remote frames and those of 29 bits whose first 11 are yours. A loss in the controller
    /// (overrun) is told like one in your queue.
    [[nodiscard]] CanEvent Next() noexcept;

    /// @brief Change it to kThere with the body, and not before.
    [[nodiscard]] PartState State() const noexcept;
    [[nodiscard]] PartState StateOfReception() const noexcept;

  private:
    /// @brief CONTRACT. Called with a data frame of 11 bits that was checked. Puts it into a mailbox or FIFO and
    /// answers kAccepted, or says why not: kQueueFull, kBusOff, kRefused (no such controller). Never waits, not even
    /// for a register that should be free by now: a bounded number of looks, then kQueueFull. A frame that was taken
    /// leaves at most once; after bus-off nothing old leaves. The normal frame of a pair, handed over first, leaves
    /// first.
    [[nodiscard]] counterpoint::hal::TransmitStatus DoTransmit(const counterpoint::CanFrame& frame) noexcept override;
};

} // namespace port_skeleton

#endif
