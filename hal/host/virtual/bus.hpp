// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_VIRTUAL_BUS_HPP
#define HAL_HOST_VIRTUAL_BUS_HPP

#include "hal/api/can_ports.hpp"
#include "hal/host/virtual/bus_events.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::host
{

/// Error state of a controller.
enum class ControllerState : std::uint8_t
{
    kErrorActive = 0U,
    kErrorPassive =
        1U, ///< A counter above 127. Counted only: error flags and suspend time are those of an active node.
    kBusOff = 2U,
};

/// How a controller is attached.
struct NodeSetup
{
    CanPortId port;             ///< What the listener's frames are to be marked with.
    std::size_t queue_capacity; ///< Mailboxes for transmission, at least 1.
};

/// One CAN bus and the controllers on it, simulated frame by frame with exact durations. Single-threaded and
/// deterministic: the same calls give the same results. Nothing costs time while the bus is idle.
///
/// A discrete-event loop around it:
///     t = min(bus.NextEvent(), instants of the devices);
///     bus.Advance(t, observer);   // first what happened on the bus up to and including t
///     run the devices due at t;   // then whoever has to do something at t; they Submit
/// All frames submitted at one instant t compete with each other: a frame that starts at t is chosen by the first
/// Advance that goes beyond t. [SRS_BUS_003, SRS_BUS_012]
class VirtualBus
{
  public:
    /// @brief A bus without nodes at time 0.
    explicit VirtualBus(BitRate rate);
    VirtualBus(const VirtualBus&) = delete;
    VirtualBus& operator=(const VirtualBus&) = delete;
    ~VirtualBus() = default;

    /// @brief A new node, connected, error-active, accepting every frame. `listener` outlives the bus or is detached
    /// before.
    NodeIndex Attach(BusListener& listener, const NodeSetup& setup);
    /// @brief The listener hears nothing any more, and the node is disconnected with an empty queue. The index stays
    /// taken.
    void Detach(NodeIndex node);

    /// @brief Gives a frame (any kind of classical CAN) to the node's transmit queue at Now().
    /// kQueueFull, kBusOff, kRefused (not a classical frame). A disconnected node accepts until its queue is full.
    hal::TransmitStatus Submit(NodeIndex node, const CanFrame& frame);
    /// @brief Empties the node's transmit queue; a frame on the bus stays there. What a controller reset does.
    void AbortAll(NodeIndex node);
    /// @brief Plans that `node` receives `frame` at `at` (not before Now()) without a frame on the bus. [SRS_BUS_011]
    void Plan(NodeIndex node, const CanFrame& frame, BusTime at);

    /// @brief Does everything up to and including `until`; Now() is `until` afterwards. An earlier `until` does
    /// nothing.
    void Advance(const BusTime until, BusObserver* const observer = nullptr)
    {
        events_.Advance(until, observer);
    }
    /// @brief Earliest instant at which something happens if nobody submits; kNever: nothing is under way.
    [[nodiscard]] BusTime NextEvent() const
    {
        return events_.NextEvent();
    }
    /// @brief The time up to which everything was done.
    [[nodiscard]] BusTime Now() const
    {
        return events_.Now();
    }
    /// @brief Duration of one bit, in ns.
    [[nodiscard]] BusTime BitDuration() const
    {
        return events_.BitDuration();
    }

    /// @brief The node receives every frame, also with 29-bit identifiers.
    void AcceptAll(NodeIndex node);
    /// @brief The node receives no frame until others are accepted.
    void AcceptNone(NodeIndex node);
    /// @brief The node also receives frames with 11-bit identifiers of this range, both ends included.
    void AcceptRange(NodeIndex node, std::uint32_t first_identifier, std::uint32_t last_identifier);

    /// @brief From now on, of several nodes that would start frames with the same arbitration field at one instant,
    /// only the one attached first sends: their clocks differ. Without this they send together, as if they had one
    /// clock. [SRS_BUS_015]
    void TakeTurns() noexcept
    {
        events_.TakeTurns();
    }

    /// @brief From now on a data frame with this 11-bit identifier takes the place of one with the same content that
    /// waits, as a status does in its mailbox. [SRS_BUS_017]
    void WaitOnce(NodeIndex node, std::uint32_t identifier);

    /// @brief From now on this fault is asked, after those that were installed before. It stays owned by the caller.
    void Install(BusFault& fault);
    /// @brief The fault is not asked any more.
    void Remove(BusFault& fault);

    // Cable, supply and bus-off are reasons not to be on the bus; a node is there when none of them holds.
    // [SRS_BUS_016]
    /// @brief The cable of the node is off: it hears nothing, sends nothing, and keeps its queue.
    void Disconnect(NodeIndex node);
    /// @brief The cable of the node is on again.
    void Connect(NodeIndex node);
    /// @brief The supply of the node goes: its queue is empty.
    void SwitchOff(NodeIndex node);
    /// @brief The supply of the node comes: its queue is empty and its counters are 0. A bus-off that they brought is
    /// over, a forced one is not.
    void SwitchOn(NodeIndex node);
    /// @brief Puts the node into bus-off as 256 counted errors would, until Recover; its queue is emptied.
    void ForceBusOff(NodeIndex node);
    /// @brief Back from bus-off, error-active with counters 0.
    void Recover(NodeIndex node);
    /// @brief Error state of the node's controller.
    [[nodiscard]] ControllerState State(NodeIndex node) const;
    /// @brief Whether it hears and is heard.
    [[nodiscard]] bool IsOnBus(NodeIndex node) const;
    /// @brief Its transmit error counter.
    [[nodiscard]] std::uint32_t TransmitErrors(NodeIndex node) const;
    /// @brief Its receive error counter.
    [[nodiscard]] std::uint32_t ReceiveErrors(NodeIndex node) const;
    /// @brief Frames in the node's queue, the one on the bus included.
    [[nodiscard]] std::size_t Pending(NodeIndex node) const;
    /// @brief Number of nodes that were ever attached.
    [[nodiscard]] std::size_t NodeCount() const
    {
        return nodes_.size();
    }

  private:
    std::vector<BusNode> nodes_;
    std::vector<BusFault*> faults_;
    BusEvents events_;
};

} // namespace counterpoint::host

#endif
