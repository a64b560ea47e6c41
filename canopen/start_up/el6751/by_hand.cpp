// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/el6751/by_hand.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint16_t kAdsRun = 5U;
constexpr std::uint16_t kAdsStop = 6U;

/// What a row of the table does.
enum class Transition : std::uint8_t
{
    kNone = 0U, ///< Not in the table.
    kStart,
    kStop,
    kPreOperational,
    kResetAndStart,
};

struct ControlRow
{
    std::uint16_t ads_state;
    std::uint16_t device_state;
    SlaveState from;
    Transition transition;
};

/// The text's table, row by row.
constexpr ControlRow kControlRows[]{
    {kAdsRun, 0U, SlaveState::kOperational, Transition::kPreOperational},
    {kAdsRun, 1U, SlaveState::kPreOperational, Transition::kStart},
    {kAdsStop, 0U, SlaveState::kOperational, Transition::kStop},
    {kAdsRun, 1U, SlaveState::kStopped, Transition::kResetAndStart},
    {kAdsRun, 3U, SlaveState::kStopped, Transition::kStart},
    {kAdsStop, 0U, SlaveState::kPreOperational, Transition::kStop},
    {kAdsRun, 2U, SlaveState::kStopped, Transition::kPreOperational},
};

} // namespace

El6751ByHand::El6751ByHand(El6751Slaves& slaves, El6751Sdos& sdos, El6751Stops& stops, El6751Release& release) noexcept
    : parts_(slaves.Parts()), slaves_(slaves), sdos_(sdos), stops_(stops), release_(release)
{
}

NmtAnswer El6751ByHand::Control(const NodeId node, const std::uint16_t ads_state, const std::uint16_t device_state,
                                const Instant now) noexcept
{
    const bool is_free = !slaves_.IsBusy(node) && (slaves_.Of(node).phase != El6751Phase::kOutside);
    // A deactivated slave was stopped, whatever became of it.
    const bool is_stopped = (slaves_.Of(node).phase == El6751Phase::kDeactivated);
    const std::uint8_t stopped = static_cast<std::uint8_t>(SlaveState::kStopped);
    const std::uint8_t state = is_stopped ? stopped : parts_.table.RequestValue(node);
    Transition transition = Transition::kNone;
    for (const ControlRow& row : kControlRows)
    {
        const bool is_command = (row.ads_state == ads_state) && (row.device_state == device_state);
        const bool is_from = (state == static_cast<std::uint8_t>(row.from));
        transition = (is_free && is_command && is_from) ? row.transition : transition;
    }
    NmtAnswer answer = NmtAnswer::kWrong;
    switch (transition)
    {
    case Transition::kStart:
        answer = Start(node, now);
        break;
    case Transition::kStop:
        answer = Hold(NmtCommand::kStop, node, now);
        break;
    case Transition::kPreOperational:
        answer = Hold(NmtCommand::kPreOperational, node, now);
        break;
    case Transition::kResetAndStart:
        answer = Reset(NmtCommand::kResetCommunication, node, now);
        slaves_.Of(node).is_start_wanted = (answer == NmtAnswer::kTaken);
        break;
    case Transition::kNone:
    default:
        break;
    }
    return answer;
}

NmtAnswer El6751ByHand::Command(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    NmtAnswer answer = NmtAnswer::kWrong;
    if ((node.value == kAllNodes.value))
    {
        answer = NmtAnswer::kTaken;
        for (std::uint8_t id = 1U; id <= kLastNode; ++id)
        {
            const bool is_one = (slaves_.Of(NodeId{id}).phase != El6751Phase::kOutside);
            const NmtAnswer one = is_one ? CommandOne(command, NodeId{id}, now) : NmtAnswer::kTaken;
            answer = (one == NmtAnswer::kTaken) ? answer : one;
        }
    }
    else if ((slaves_.Of(node).phase != El6751Phase::kOutside))
    {
        answer = CommandOne(command, node, now);
    }
    else if ((node.value == parts_.setup.own.value))
    {
        answer = parts_.nmt.Request(command, node, now);
    }
    else
    {
        // Not in the network.
    }
    return answer;
}

NmtAnswer El6751ByHand::CommandOne(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    NmtAnswer answer = NmtAnswer::kWrong;
    switch (command)
    {
    case NmtCommand::kStart:
        answer = Start(node, now);
        break;
    case NmtCommand::kStop:
    case NmtCommand::kPreOperational:
        answer = Hold(command, node, now);
        break;
    case NmtCommand::kResetNode:
    case NmtCommand::kResetCommunication:
        answer = Reset(command, node, now);
        break;
    case NmtCommand::kInvalid:
    default:
        break;
    }
    return answer;
}

/// A start-up that runs is given up.
NmtAnswer El6751ByHand::Hold(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    const NmtAnswer answer = parts_.nmt.Request(command, node, now);
    if (answer == NmtAnswer::kTaken)
    {
        parts_.gate.Close(node);
        parts_.sdo.Cancel(node, SdoAbort::kGeneral);
        slaves_.Of(node).is_cut = slaves_.Of(node).is_cut || (slaves_.Of(node).phase == El6751Phase::kRows);
        slaves_.Of(node).is_held_by_hand = true;
        slaves_.Of(node).is_start_wanted = false;
        stops_.Hold(node, (command == NmtCommand::kStop) ? kNodeDeactivated : kNodePreOperational, now);
    }
    return answer;
}

/// While SDOs are under way, the start follows them. A slave that restarted unnoticed needs them first. One that left
/// OPERATIONAL without a reaction is started again. One that was held in the middle of its SDOs gets all of them first.
NmtAnswer El6751ByHand::Start(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const std::uint8_t operational = static_cast<std::uint8_t>(SlaveState::kOperational);
    const bool runs = (parts_.table.RequestValue(node) == operational);
    const bool is_deaf = (parts_.table.Record(node).asked == SlaveState::kStopped);
    const bool is_unasked = slaves_.IsSafety(node) && (slave.place.row <= El6751Row::kSerialNumber); // Who it is.
    const bool is_unknown = slave.is_cut || is_unasked;
    const bool is_held = (slave.phase == El6751Phase::kHeld);
    NmtAnswer answer = NmtAnswer::kTaken;
    if (slaves_.IsSafety(node) && slave.status.is_other)
    {
        answer = NmtAnswer::kOtherDevice;
    }
    else if ((slave.has_restarted && !slaves_.IsBusy(node)) || (is_held && is_unknown && is_deaf))
    {
        answer = Reset(NmtCommand::kResetCommunication, node, now);
        slave.is_start_wanted = (answer == NmtAnswer::kTaken);
    }
    else if (slaves_.IsBusy(node))
    {
        slave.is_start_wanted = true;
    }
    else if (is_held && is_unknown)
    {
        slave.is_start_wanted = true;
        sdos_.Begin(node, kNodeStarts, now);
    }
    else if ((slave.phase != El6751Phase::kRunning) || !runs)
    {
        release_.Start(node, now);
    }
    else
    {
        // It runs.
    }
    return answer;
}

NmtAnswer El6751ByHand::Reset(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    const NmtAnswer answer = parts_.nmt.Request(command, node, now);
    if (answer == NmtAnswer::kTaken)
    {
        slaves_.Of(node).is_held_by_hand = false;
        sdos_.Begin(node, kNodeStarts, now);
    }
    return answer;
}

} // namespace counterpoint::cia302
