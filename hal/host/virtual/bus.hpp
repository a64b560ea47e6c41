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
    [[nodiscard]] BusTime Now() const
    {
        return events_.Now();
    }
    [[nodiscard]] BusTime BitDuration() const
    {
        return events_.BitDuration();
    }

    /// @brief Acceptance filter for 11-bit identifiers (data and remote); 29-bit frames pass only after AcceptAll.
    void AcceptAll(NodeIndex node);
    void AcceptNone(NodeIndex node);
    void AcceptRange(NodeIndex node, std::uint32_t first_identifier, std::uint32_t last_identifier);

    /// @brief From now on of several nodes that would start frames with the same arbitration field at one instant the
    /// one attached first sends: clocks that differ. Else they send together, as clocks that do not. [SRS_BUS_015]
    void TakeTurns() noexcept
    {
        events_.TakeTurns();
    }

    /// @brief Faults stay owned by the caller and are asked in the order of installation.
    void Install(BusFault& fault);
    void Remove(BusFault& fault);

    /// @brief Cable of one node off and on. Disconnected: hears nothing, gets nothing out, keeps its queue.
    void Disconnect(NodeIndex node);
    void Connect(NodeIndex node);
    /// @brief Puts the node into bus-off as 256 counted errors would; its queue is emptied.
    void ForceBusOff(NodeIndex node);
    /// @brief Back to error-active with counters 0.
    void Recover(NodeIndex node);
    [[nodiscard]] ControllerState State(NodeIndex node) const;
    [[nodiscard]] std::uint32_t TransmitErrors(NodeIndex node) const;
    [[nodiscard]] std::uint32_t ReceiveErrors(NodeIndex node) const;
    /// @brief Frames in the node's queue, the one on the bus included.
    [[nodiscard]] std::size_t Pending(NodeIndex node) const;
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
