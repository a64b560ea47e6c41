// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_VIRTUAL_BUS_HPP
#define HAL_HOST_VIRTUAL_BUS_HPP

#include "hal/api/can_ports.hpp"
#include "hal/host/virtual/bit_rate.hpp"
#include "hal/host/virtual/bus_fault.hpp"
#include "hal/host/virtual/transmit_queue.hpp"
#include "safety_core/contract/can_frame.hpp"

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::host
{

/// What a node hears from its controller. Called from within Advance, at the instant `at` == bus.Now(); may call
/// Submit, Plan, ForceBusOff, Recover, Connect, Disconnect and Accept..., not Advance, Attach or Detach. The frame's
/// `port` is the node's own.
class BusListener
{
  public:
    virtual ~BusListener() = default;
    virtual void OnReceived(const CanFrame& frame, BusTime at) = 0;
    /// @brief A frame of this node was on the bus, complete and acknowledged.
    virtual void OnConfirmed(const CanFrame& frame, BusTime at) = 0;
    virtual void OnBusOff(BusTime at)
    {
        static_cast<void>(at);
    }
};

enum class FrameFate : std::uint8_t
{
    kComplete = 0U,
    kHit = 1U,             ///< Destroyed by a WireHit.
    kCollision = 2U,       ///< Two nodes with the same arbitration field and different frames.
    kNotAcknowledged = 3U, ///< Nobody else listens.
    kSenderGone = 4U,      ///< The sender went bus-off or was disconnected under way.
};

/// One attempt to send a frame, as a bus analyser would write it down. [SRS_BUS_013]
struct BusRecord
{
    FrameOnBus sent;         ///< After a collision: of the node with the lowest index.
    BusTime end;             ///< End of EOF; destroyed: end of the error delimiter.
    std::uint16_t bits;      ///< From SOF to `end`.
    std::uint16_t receivers; ///< Nodes that get at least one reception out of it now or later, filters not counted.
    FrameFate fate;
};

class BusObserver
{
  public:
    virtual ~BusObserver() = default;
    /// @brief At the end of each attempt, before any node gets anything of it.
    virtual void OnBusRecord(const BusRecord& record) = 0;
};

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
        if (next_event_ <= until)
        {
            RunEvents(until, observer);
        }
        now_ = (until > now_) ? until : now_;
    }
    /// @brief Earliest instant at which something happens if nobody submits; kNever: nothing is under way.
    [[nodiscard]] BusTime NextEvent() const
    {
        return next_event_;
    }
    [[nodiscard]] BusTime Now() const
    {
        return now_;
    }
    [[nodiscard]] BusTime BitDuration() const
    {
        return bit_time_;
    }

    /// @brief Acceptance filter for 11-bit identifiers (data and remote); 29-bit frames pass only after AcceptAll.
    void AcceptAll(NodeIndex node);
    void AcceptNone(NodeIndex node);
    void AcceptRange(NodeIndex node, std::uint32_t first_identifier, std::uint32_t last_identifier);

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
    static constexpr std::uint32_t kErrorPassiveAbove = 127U;
    static constexpr std::uint32_t kBusOffFrom = 256U;

    struct Node
    {
        BusListener* listener;
        TransmitQueue queue;
        std::bitset<2048U> accepted;
        std::uint32_t transmit_errors{0U};
        std::uint32_t receive_errors{0U};
        CanPortId port;
        bool accepts_extended{true};
        bool connected{true};
        bool bus_off{false};

        [[nodiscard]] bool IsOnBus() const
        {
            return connected && !bus_off;
        }
    };
    enum class EventKind : std::uint8_t
    {
        kReception,
        kConfirmation,
    };
    struct PlannedEvent
    {
        BusTime at;
        std::uint64_t order;
        NodeIndex node;
        CanFrame frame;
        EventKind kind;
    };
    struct Sender
    {
        NodeIndex node;
        QueuedFrame queued;
    };

    [[nodiscard]] static bool IsLater(const PlannedEvent& left, const PlannedEvent& right);
    void RunEvents(BusTime until, BusObserver* observer);
    void RunPlanned();
    void Arbitrate();
    [[nodiscard]] bool TakeWinners();
    [[nodiscard]] std::uint16_t FirstHit() const;
    [[nodiscard]] std::uint16_t FirstDifference() const;
    [[nodiscard]] bool IsHeardByOthers() const;
    void FinishFrame(BusObserver* observer);
    void CompleteFrame(BusObserver* observer);
    void DestroyFrame(BusObserver* observer);
    void CountErrors();
    void CollectReceptions(NodeIndex receiver);
    void CollectConfirmation(NodeIndex sender);
    void Spread(NodeIndex node, EventKind kind);
    [[nodiscard]] bool IsSender(NodeIndex node) const;
    void Deliver(const PlannedEvent& event);
    void PlanEvent(const PlannedEvent& event);
    void EnterBusOff(Node& node);
    void Arm();
    void Schedule();

    BusTime bit_time_;
    BusTime now_{0};
    BusTime next_event_{kNever};
    BusTime arbitration_at_{kNever}; ///< SOF of the next frame; kNever while a frame is on the bus or none waits.
    BusTime frame_end_{kNever};      ///< kNever while no frame is on the bus.
    BusTime free_at_{0};             ///< End of the last intermission.
    std::uint64_t order_{0U};
    BusRecord record_{};
    std::vector<Node> nodes_;
    std::vector<Sender> senders_; ///< Who is on the bus: one, or several with the same arbitration field.
    std::vector<BusFault*> faults_;
    std::vector<PlannedEvent> planned_;    ///< Heap, earliest first.
    std::vector<PlannedEvent> deliveries_; ///< Of the frame that ends now.
    ReceptionList receptions_;
};

} // namespace counterpoint::host

#endif
