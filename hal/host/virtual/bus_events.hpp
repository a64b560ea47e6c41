// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_VIRTUAL_BUS_EVENTS_HPP
#define HAL_HOST_VIRTUAL_BUS_EVENTS_HPP

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
    /// @brief A frame that the node's filters accept.
    virtual void OnReceived(const CanFrame& frame, BusTime at) = 0;
    /// @brief A frame of this node was on the bus, complete and acknowledged.
    virtual void OnConfirmed(const CanFrame& frame, BusTime at) = 0;
    /// @brief The controller went bus-off.
    virtual void OnBusOff(BusTime at)
    {
        static_cast<void>(at);
    }
};

/// How an attempt to send a frame ended.
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

/// Is told of every attempt to send a frame.
class BusObserver
{
  public:
    virtual ~BusObserver() = default;
    /// @brief At the end of each attempt, before any node gets anything of it.
    virtual void OnBusRecord(const BusRecord& record) = 0;
};

constexpr std::uint32_t kErrorPassiveAbove = 127U;
constexpr std::uint32_t kBusOffFrom = 256U;
constexpr std::uint32_t kNoIdentifier = 0xFFFFFFFFU;

/// Why a controller is not on the bus. Each reason ends by itself; several may hold at a time.
enum class Absence : std::uint8_t
{
    kSupply = 0x01U,
    kCable = 0x02U,
    kErrors = 0x04U,  ///< Bus-off by its counters.
    kHeldOff = 0x08U, ///< Bus-off because somebody holds it there.
    kDetached = 0x10U,
};

/// A controller on the bus.
struct BusNode
{
    BusListener* listener;
    TransmitQueue queue;
    std::bitset<2048U> accepted;
    std::uint32_t waits_once{kNoIdentifier}; ///< Frames with this identifier do, if their content is the same.
    std::uint32_t transmit_errors{0U};
    std::uint32_t receive_errors{0U};
    CanPortId port;
    bool accepts_extended{true};
    std::uint8_t absences{0U}; ///< Bits of Absence.

    /// @brief Whether it takes part in the traffic.
    [[nodiscard]] bool IsOnBus() const
    {
        return absences == 0U;
    }
    /// @brief Whether this reason keeps it away.
    [[nodiscard]] bool IsAway(const Absence why) const
    {
        return (absences & static_cast<std::uint8_t>(why)) != 0U;
    }
    /// @brief Whether it is in bus-off, for either reason.
    [[nodiscard]] bool IsBusOff() const
    {
        return IsAway(Absence::kErrors) || IsAway(Absence::kHeldOff);
    }
    /// @brief This reason holds from now on.
    void Leave(const Absence why)
    {
        absences = static_cast<std::uint8_t>(absences | static_cast<std::uint8_t>(why));
    }
    /// @brief It does not hold any more.
    void Return(const Absence why)
    {
        absences = static_cast<std::uint8_t>(absences & ~static_cast<std::uint32_t>(why));
    }
};

/// What happens on the bus of a VirtualBus as time goes on: arbitration, frames and how they end, planned receptions.
class BusEvents
{
  public:
    /// @brief Controllers and faults are kept by reference.
    BusEvents(BitRate rate, std::vector<BusNode>& nodes, const std::vector<BusFault*>& faults);

    /// @brief There is one node more: sets memory aside for what it gets.
    void OnAttached();
    /// @brief See VirtualBus::Advance.
    void Advance(const BusTime until, BusObserver* const observer)
    {
        if (next_event_ <= until)
        {
            Run(until, observer);
        }
        now_ = (until > now_) ? until : now_;
    }
    /// @brief See VirtualBus.
    [[nodiscard]] BusTime NextEvent() const
    {
        return next_event_;
    }
    /// @brief See VirtualBus.
    [[nodiscard]] BusTime Now() const
    {
        return now_;
    }
    /// @brief See VirtualBus.
    [[nodiscard]] BusTime BitDuration() const
    {
        return bit_time_;
    }
    /// @brief A number greater than all before.
    [[nodiscard]] std::uint64_t NextOrder()
    {
        return order_++;
    }
    /// @brief A reception at `at`, or now.
    void Plan(NodeIndex node, const CanFrame& frame, BusTime at);
    /// @brief A node has something to send, or is back on the bus.
    void OnWaiting();
    /// @brief Takes the node off the bus and empties its queue. `why` is kErrors or kHeldOff.
    void EnterBusOff(BusNode& node, Absence why);
    /// @brief See VirtualBus.
    void TakeTurns() noexcept
    {
        takes_turns_ = true;
    }

  private:
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
    void Run(BusTime until, BusObserver* observer);
    void RunPlanned();
    void Arbitrate();
    [[nodiscard]] bool TakeWinners();
    [[nodiscard]] std::uint16_t FirstHit() const;
    [[nodiscard]] std::uint16_t FirstDifference() const;
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
    void Arm();
    void Schedule();

    BusTime bit_time_;
    BusTime now_{0};
    BusTime next_event_{kNever};
    BusTime arbitration_at_{kNever}; ///< SOF of the next frame; kNever while a frame is on the bus or none waits.
    BusTime frame_end_{kNever};      ///< kNever while no frame is on the bus.
    BusTime free_at_{0};             ///< End of the last intermission.
    std::uint64_t order_{0U};
    bool takes_turns_{false};
    BusRecord record_{};
    std::vector<BusNode>& nodes_;
    std::vector<Sender> senders_; ///< Who is on the bus: one, or several with the same arbitration field.
    const std::vector<BusFault*>& faults_;
    std::vector<PlannedEvent> planned_;    ///< Heap, earliest first.
    std::vector<PlannedEvent> deliveries_; ///< Of the frame that ends now.
    ReceptionList receptions_;
};

} // namespace counterpoint::host

#endif
