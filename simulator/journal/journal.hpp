// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_JOURNAL_JOURNAL_HPP
#define SIMULATOR_JOURNAL_JOURNAL_HPP

#include "simulator/scenario/scenario.hpp"

#include "hal/host/virtual/bus.hpp"
#include "safety_core/contract/can_frame.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::simulator
{
constexpr std::size_t kNoFaultIndex = static_cast<std::size_t>(-1);

/// Whose controller a node of the bus is: the first or second one of a device, or the one of a fault.
struct BusPlace
{
    NodeIndex node{kNoNode};
    std::uint32_t controller{1U};
    std::size_t fault{kNoFaultIndex}; ///< A controller that is no node's.
};
/// By the numbers of the nodes on the bus.
using BusPlaces = std::vector<BusPlace>;
/// Kinds of events. `node` and `srdo` (a number; 0: none) of an event say where it happened; `value` and `other` say
/// what.
enum class EventKind : std::uint8_t
{
    kNmt = 1U,         ///< value: NmtState.
    kInput = 2U,       ///< value: the new value; other: index << 8 | sub.
    kAcknowledge = 3U, ///< value: level.
    kGfc = 4U,         ///< value: 1 sent, 0 refused; other: the kernel's Result.
    kPowerOn = 5U,
    kFault = 6U, ///< A fault had its first effect. value: index in Scenario::faults.
    kFrameChanged =
        7U,      ///< A receiver gets something else than what was sent. value: identifier; other: index of the fault.
    kViewA = 8U, ///< Channel A shows a new state. value: SrdoState.
    kViewB = 9U,
    kCauseA = 10U, ///< Channel A reports a fault of an SRDO. value: first SrdoCause; other: signals of this cycle.
    kCauseB = 11U,
    kVerdict = 12U,     ///< The comparator's masks changed. value: agreed; other: matched.
    kDemotion = 13U,    ///< value: mask.
    kPermits = 14U,     ///< A party's permit changed. value: mask that all three give; other: 1 when all responses fit.
    kOutput = 15U,      ///< value: 1 open, 0 closed.
    kValue = 16U,       ///< What the application uses changed. value; other: index << 8 | sub.
    kSignal = 17U,      ///< The application was told of a cause. value: SrdoCause.
    kDeviceFault = 18U, ///< value: DeviceFault; other: that of the comparator's verdict.
    kWatchdog = 19U,    ///< The watchdog tripped.
    kHung = 20U,        ///< The node stands still. value: 0 a call did not return, 1 exception, 2 nothing runs.
    kConfigurationInvalid = 21U,
    kReception = 22U, ///< A consumer got a frame. value: identifier; other: 1 when it completed a good pair.
    kPowerOff = 23U,
    kNoStart = 24U,     ///< The kernel refused to start, or its configuration.
    kSelfTest = 25U,    ///< A self test failed. value: selftest::TestId.
    kLink = 26U,        ///< The link to the other CPU changed. value: LinkState; other: LinkFinding.
    kLinkMessage = 27U, ///< A message does not arrive here as it was sent. other: index of the fault.
    kTime = 28U,        ///< The device heard a time. value: ms of the day; other: days since 1 January 1984.
    kEmergency = 29U,   ///< The device heard one. value: node << 24 | register << 16 | code; other: the 5 bytes behind.
    kNewNodeId = 30U,   ///< LSS gave one, and communication was reset: the device is silent. value: the node-ID.
    kStore = 31U,       ///< Somebody writes into the device. value; other: abort code << 32 | index << 8 | sub.
};

/// One event of a run.
struct Event
{
    Nanoseconds at{0};
    EventKind kind{EventKind::kNmt};
    NodeIndex node{kNoNode};
    std::uint8_t srdo{0U};
    std::uint64_t value{0U};
    std::uint64_t other{0U};
    Nanoseconds since{-1};       ///< kOutput: normal frame of the last good pair; see PairTimes.
    Nanoseconds next_normal{-1}; ///< kOutput: the first one behind it, whatever became of it.
    Nanoseconds inverse{-1};     ///< kOutput: the first one behind it that made no good pair.
};

/// One frame as it was on the bus, or one that a fault inserted for a single receiver (`sender` kNoNode).
struct FrameEntry
{
    Nanoseconds start{0};
    Nanoseconds end{0};
    CanFrame frame{};
    NodeIndex sender{kNoNode};
    host::FrameFate fate{host::FrameFate::kComplete};

    /// @brief False: it came to single receivers past the bus, and took no time there.
    [[nodiscard]] bool IsOfBus() const noexcept
    {
        return end > start;
    }
};

/// Somebody told a device what to do, or took or gave its supply.
struct CommandEntry
{
    Nanoseconds at{0};
    NodeIndex node{kNoNode};
    bool closes{true}; ///< It takes the device out of OPERATIONAL; else it starts it.
};

/// An event of a manager.
struct ManagerEntry
{
    Nanoseconds at{0};
    NodeIndex manager{kNoNode}; ///< Behind the nodes come the managers, in the order of the scenario.
    std::uint8_t node_id{0U};   ///< 0: the network or the manager.
    std::string kind;
    std::string text; ///< For people; empty: only programs want to know.
    std::string line; ///< As in the log of a manager.
};

/// Everything that happened in a run, in the order of time. What expectations need is always kept; what only people
/// look at is kept if somebody asked for it. [SRS_SIM_040, SRS_SIM_046]
class Journal
{
  public:
    /// @brief `keeps_all`: also what only people look at.
    explicit Journal(bool keeps_all) : keeps_all_(keeps_all)
    {
    }

    /// @brief Whether everything is kept.
    [[nodiscard]] bool KeepsAll() const noexcept
    {
        return keeps_all_;
    }
    /// @brief Adds an event that expectations may need.
    void Note(const Event& event)
    {
        events_.push_back(event);
    }
    /// @brief Adds what somebody told a device.
    void Note(const CommandEntry& command)
    {
        commands_.push_back(command);
    }
    /// @brief Adds an event of a manager.
    void Note(ManagerEntry entry)
    {
        managers_.push_back(std::move(entry));
    }
    /// @brief Adds an event for people.
    void Tell(const Event& event)
    {
        if (keeps_all_)
        {
            events_.push_back(event);
        }
    }
    /// @brief Adds a frame for people.
    void Tell(const FrameEntry& frame)
    {
        if (keeps_all_)
        {
            frames_.push_back(frame);
        }
    }
    /// @brief When the fault of this index first had an effect; -1: never.
    [[nodiscard]] Nanoseconds EffectOf(const std::size_t fault) const
    {
        const auto found = std::find_if(events_.begin(), events_.end(), [fault](const Event& event)
                                        { return event.kind == EventKind::kFault && event.value == fault; });
        return (found == events_.end()) ? -1 : found->at;
    }
    /// @brief Puts the events in the order of time; events of one instant stay in their order. It is needed because
    /// some effects are told in advance.
    void Sort()
    {
        std::stable_sort(events_.begin(), events_.end(),
                         [](const Event& left, const Event& right) { return left.at < right.at; });
    }
    /// @brief The events.
    [[nodiscard]] const std::vector<Event>& Events() const noexcept
    {
        return events_;
    }
    /// @brief In order of time. [SRS_SIM_067]
    [[nodiscard]] const std::vector<CommandEntry>& Commands() const noexcept
    {
        return commands_;
    }
    /// @brief The events of managers.
    [[nodiscard]] const std::vector<ManagerEntry>& Managers() const noexcept
    {
        return managers_;
    }
    /// @brief The frames; none unless everything is kept.
    [[nodiscard]] const std::vector<FrameEntry>& Frames() const noexcept
    {
        return frames_;
    }

  private:
    bool keeps_all_;
    std::vector<Event> events_;
    std::vector<FrameEntry> frames_;
    std::vector<CommandEntry> commands_;
    std::vector<ManagerEntry> managers_;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_JOURNAL_JOURNAL_HPP
