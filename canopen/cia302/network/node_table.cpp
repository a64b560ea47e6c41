// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/network/node_table.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kUsPerMs = 1000U;
constexpr std::uint32_t kAnswers = 0x580U;
constexpr std::uint8_t kSdoBytes = 8U;
constexpr std::uint32_t kErrorControl = 0x700U;
constexpr std::uint8_t kToggleBit = 0x80U;
constexpr NodeRecord kNothing{};

bool IsState(const std::uint8_t byte) noexcept
{
    return (byte == 4U) || (byte == 5U) || (byte == 127U);
}

/// State that a command asks for.
SlaveState AskedBy(const NmtCommand command) noexcept
{
    SlaveState state = SlaveState::kUnknown;
    switch (command)
    {
    case NmtCommand::kStart:
        state = SlaveState::kOperational;
        break;
    case NmtCommand::kStop:
        state = SlaveState::kStopped;
        break;
    case NmtCommand::kPreOperational:
        state = SlaveState::kPreOperational;
        break;
    case NmtCommand::kResetNode:
    case NmtCommand::kResetCommunication:
    case NmtCommand::kInvalid:
    default:
        break;
    }
    return state;
}

/// Null: no node.
NodeRecord* Find(const NodeTableParts& parts, const NodeId node) noexcept
{
    const bool is_node = (node.value >= 1U) && (node.value <= kLastNode);
    return is_node ? &parts.records[node.value] : nullptr;
}

} // namespace

NodeTable::NodeTable(const NodeTableParts& parts) noexcept : parts_(parts)
{
}

const NodeRecord& NodeTable::Record(const NodeId node) const noexcept
{
    const bool is_node = (node.value >= 1U) && (node.value <= kLastNode);
    return is_node ? parts_.records[node.value] : kNothing;
}

std::uint8_t NodeTable::RequestValue(const NodeId node) const noexcept
{
    const NodeRecord& record = Record(node);
    const bool is_heard = record.is_running || (record.state == SlaveState::kMissing);
    const SlaveState unwatched = (record.asked != SlaveState::kUnknown) ? record.asked : record.state;
    return static_cast<std::uint8_t>(is_heard ? record.state : unwatched);
}

bool NodeTable::RunsSurely(const NodeId node) const noexcept
{
    const NodeRecord& record = Record(node); // A node that is missing is not OPERATIONAL, whatever it said last.
    return (record.state == SlaveState::kOperational) && (record.runs >= kRunsSurely);
}

void NodeTable::WatchHeartbeat(const NodeId node, const std::uint16_t time_ms, const Arming arming,
                               const Instant now) noexcept
{
    NodeRecord* const record = Find(parts_, node);
    if (record != nullptr)
    {
        record->watch = (time_ms > 0U) ? Watch::kHeartbeat : Watch::kNone;
        record->time_us = kUsPerMs * time_ms;
        record->arming = arming;
        const bool is_armed = (arming == Arming::kImmediately) || ((arming == Arming::kBootUp) && record->has_booted);
        record->is_running = (time_ms > 0U) && is_armed;
        record->has_begun = false;
        record->since = now;
    }
}

void NodeTable::WatchGuarding(const NodeId node, const std::uint16_t time_ms, const std::uint8_t retry_factor,
                              const Instant now) noexcept
{
    NodeRecord* const record = Find(parts_, node);
    if (record != nullptr)
    {
        const bool is_on = (time_ms > 0U) && (retry_factor > 0U);
        record->watch = is_on ? Watch::kGuarding : Watch::kNone;
        record->time_us = kUsPerMs * time_ms;
        record->retry_factor = retry_factor;
        record->is_running = is_on;
        record->has_begun = false;
        record->is_asked = false;
        record->missed = 0U;
        record->untoggled = (record->untoggled < kMostUntoggled) ? record->untoggled : std::uint8_t{0U};
        record->since = Instant{now.us - record->time_us};
    }
}

void NodeTable::Unwatch(const NodeId node) noexcept
{
    WatchHeartbeat(node, 0U, Arming::kFirstHeartbeat, Instant{0U});
}

void NodeTable::WatchAsSetUp(const NodeId node, const Instant now) noexcept
{
    const SlaveSetup& setup = parts_.setup.Slave(node);
    if (setup.heartbeat.consumer_ms > 0U)
    {
        WatchHeartbeat(node, setup.heartbeat.consumer_ms, setup.heartbeat.arming, now);
    }
    else
    {
        WatchGuarding(node, setup.GuardTimeMs(), setup.RetryFactor(), now);
    }
}

void NodeTable::Expect(const NodeId node, const std::uint32_t time_ms, const Instant now) noexcept
{
    NodeRecord* const record = Find(parts_, node);
    if (record != nullptr)
    {
        record->is_expected = true;
        record->expect_us = kUsPerMs * time_ms;
        record->expected_from = now;
    }
}

bool NodeTable::AskState(const NodeId node) noexcept
{
    NodeRecord* const record = Find(parts_, node);
    const bool has_left = (record != nullptr) && SendRemote(node);
    if (has_left)
    {
        record->is_asked = true;
        record->toggle = Toggle::kAny; // One answer alone has nothing to alternate with.
    }
    return has_left;
}

void NodeTable::SetMissing(const NodeId node) noexcept
{
    NodeRecord* const record = Find(parts_, node);
    if (record != nullptr)
    {
        record->state = SlaveState::kMissing;
    }
}

void NodeTable::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    const bool is_sign = (frame.kind == FrameKind::kData) && (frame.length_bytes == 1U) &&
                         (frame.identifier > kErrorControl) && (frame.identifier <= (kErrorControl + kLastNode));
    const bool is_answer = (frame.kind == FrameKind::kData) && (frame.length_bytes == kSdoBytes) &&
                           (frame.identifier > kAnswers) && (frame.identifier <= (kAnswers + kLastNode));
    const NodeId node{static_cast<std::uint8_t>(frame.identifier & kLastNode)};
    if (is_answer)
    {
        HearAnswer(node, now);
    }
    else if (is_sign && (node.value != parts_.setup.own.value))
    {
        Hear(node, frame.data[0], now);
    }
    else if ((frame.kind == FrameKind::kData) && (frame.identifier == 0U) && (frame.length_bytes == 2U))
    {
        HearCommand(static_cast<NmtCommand>(frame.data[0]), NodeId{frame.data[1]});
    }
    else
    {
        // Neither error control nor an answer.
    }
}

/// It is there, in a state that nobody knows. Whether a supervised node is lost is a matter of its supervision alone.
void NodeTable::HearAnswer(const NodeId node, const Instant now) noexcept
{
    NodeRecord& record = parts_.records[node.value];
    const bool is_back = (record.state == SlaveState::kMissing) && (record.watch == Watch::kNone);
    record.is_expected = false;
    record.state = is_back ? SlaveState::kUnknown : record.state;
    if (is_back && record.is_kept_started)
    {
        Presume(node, now);
    }
}

/// Of somebody else: the nodes may be OPERATIONAL no more, whatever their next sign says.
void NodeTable::HearCommand(const NmtCommand command, const NodeId node) noexcept
{
    for (std::uint8_t id = 1U; (id <= kLastNode) && IsNmtCommand(command); ++id)
    {
        NodeRecord& record = parts_.records[id];
        const bool is_hit = (node.value == kAllNodes.value) || (node.value == id);
        const bool is_start = (command == NmtCommand::kStart);
        record.runs = (is_hit && !is_start) ? std::uint8_t{0U} : record.runs;
        record.is_kept_started = record.is_kept_started && (!is_hit || is_start);
        record.asked = is_hit ? AskedBy(command) : record.asked;
        record.denials = is_hit ? std::uint8_t{0U} : record.denials;
        record.state = (is_hit && record.is_presumed) ? record.asked : record.state;
    }
}

/// The command was the last one for it: no sign of before is on its way.
void NodeTable::Presume(const NodeId node, const Instant now) noexcept
{
    NodeRecord* const record = Find(parts_, node);
    if ((record != nullptr) && (record->state != SlaveState::kMissing))
    {
        record->state = SlaveState::kOperational;
        record->is_presumed = true;
        record->runs = kRunsSurely;
        ++record->signs;
        parts_.listener.OnNodeEvent(node, NodeEvent::kChanged, now);
    }
}

void NodeTable::KeepStarted(const NodeId node) noexcept
{
    NodeRecord* const record = Find(parts_, node);
    if (record != nullptr)
    {
        record->is_kept_started = true;
    }
}

void NodeTable::Miss(const NodeId node) noexcept
{
    NodeRecord* const record = Find(parts_, node);
    if (record != nullptr)
    {
        record->has_gap = true;
    }
}

void NodeTable::Hear(const NodeId node, const std::uint8_t byte, const Instant now) noexcept
{
    NodeRecord& record = parts_.records[node.value];
    const auto state = static_cast<std::uint8_t>(byte & kLastNode);
    const bool is_boot_up = (byte == 0U);
    if (is_boot_up || IsState(state))
    {
        const bool is_new = !record.was_seen && !parts_.setup.IsListed(node);
        const bool was_reset = record.has_gap && (record.asked == SlaveState::kOperational) &&
                               (state == static_cast<std::uint8_t>(SlaveState::kPreOperational));
        record.was_seen = true;
        record.has_gap = false;
        record.is_presumed = false;
        record.is_kept_started = record.is_kept_started && is_boot_up;
        record.is_expected = false;
        record.last_sign = now;
        ++record.signs;
        if (is_new)
        {
            parts_.listener.OnNodeEvent(node, NodeEvent::kUnexpected, now);
        }
        if (is_boot_up)
        {
            HearBootUp(node, record, Toggle::kClear, now);
        }
        else if (was_reset)
        {
            HearBootUp(node, record, Toggle::kAny, now);
        }
        else
        {
            HearState(node, record, byte, now);
        }
    }
}

/// `next` is the toggle bit of the first answer. The message has the lowest priority on the bus: a start behind the
/// reset may have come before it.
void NodeTable::HearBootUp(const NodeId node, NodeRecord& record, const Toggle next, const Instant now) noexcept
{
    record.state = SlaveState::kPreOperational;
    record.has_booted = true;
    record.asked = SlaveState::kUnknown;
    record.denials = 0U;
    record.runs = 0U;
    record.toggle = next;
    record.is_toggle_wrong = false;
    record.is_asked = false;
    record.missed = 0U;
    record.has_begun = false;
    record.is_running = (record.watch == Watch::kGuarding) ||
                        ((record.watch == Watch::kHeartbeat) && (record.arming != Arming::kFirstHeartbeat));
    record.since = now;
    parts_.listener.OnNodeEvent(node, NodeEvent::kBootUp, now);
    if (record.is_kept_started)
    {
        record.asked = SlaveState::kOperational;
        Presume(node, now);
    }
}

void NodeTable::HearState(const NodeId node, NodeRecord& record, const std::uint8_t byte, const Instant now) noexcept
{
    const bool is_answer = record.is_asked;
    const bool is_right = !is_answer || TakeToggle(node, record, (byte & kToggleBit) != 0U, now);
    const auto state = static_cast<SlaveState>(byte & kLastNode);
    const bool has_changed = (state != record.state);
    record.state = state;
    const std::uint8_t more = (record.runs < kRunsSurely) ? static_cast<std::uint8_t>(record.runs + 1U) : kRunsSurely;
    record.runs = (state == SlaveState::kOperational) ? more : std::uint8_t{0U};
    const bool is_denial = (record.asked != SlaveState::kUnknown) && (state != record.asked);
    const bool is_more = is_denial && (record.denials < kRunsSurely);
    record.denials = is_denial ? static_cast<std::uint8_t>(record.denials + (is_more ? 1U : 0U)) : std::uint8_t{0U};
    if (is_right)
    {
        const bool is_first = (record.watch != Watch::kNone) && !record.has_begun;
        ++record.beats;
        record.missed = 0U;
        record.is_running = (record.watch != Watch::kNone);
        record.has_begun = record.is_running;
        record.since = (record.watch == Watch::kGuarding) ? record.since : now;
        if (is_first || has_changed)
        {
            parts_.listener.OnNodeEvent(node, is_first ? NodeEvent::kStarted : NodeEvent::kChanged, now);
        }
    }
}

/// Of a node that was asked. An answer was lost, or the slave does not toggle: either way the bit to come is the other
/// one than this.
bool NodeTable::TakeToggle(const NodeId node, NodeRecord& record, const bool is_set, const Instant now) noexcept
{
    const Toggle heard = is_set ? Toggle::kSet : Toggle::kClear;
    const bool is_right = (record.toggle == Toggle::kAny) || (record.toggle == heard);
    const bool is_news = !is_right && !record.is_toggle_wrong;
    const bool has_changed = is_right && (record.toggle == Toggle::kSet); // It was 0 before.
    record.untoggled = has_changed ? std::uint8_t{0U} : record.untoggled;
    record.toggle = is_set ? Toggle::kClear : Toggle::kSet;
    record.is_toggle_wrong = !is_right;
    record.is_asked = !is_right;
    if (is_news)
    {
        parts_.listener.OnNodeEvent(node, NodeEvent::kToggleError, now);
    }
    return is_right;
}

void NodeTable::OnNmtSent(const NmtRequest& request, const Instant now) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const bool is_hit = (request.node.value == kAllNodes.value) || (request.node.value == id);
        if (is_hit)
        {
            Command(parts_.records[id], request.command, now);
        }
    }
}

/// After a reset the node is silent for a while: what waits for its boot-up message or first heartbeat waits anew, and
/// guarding rests until the boot-up message.
void NodeTable::Command(NodeRecord& record, const NmtCommand command, const Instant now) noexcept
{
    record.asked = AskedBy(command);
    record.denials = 0U;
    record.is_kept_started = false;
    record.state = record.is_presumed ? record.asked : record.state;
    record.runs = (command == NmtCommand::kStart) ? record.runs : std::uint8_t{0U};
    if ((command == NmtCommand::kResetNode) || (command == NmtCommand::kResetCommunication))
    {
        record.state = SlaveState::kUnknown;
        record.has_booted = false;
        record.toggle = Toggle::kClear;
        record.is_asked = false;
        record.has_begun = false;
        record.missed = 0U;
        record.is_running = (record.watch == Watch::kHeartbeat) && (record.arming == Arming::kImmediately);
        record.since = now;
    }
}

void NodeTable::OnCycle(const Instant now) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        NodeRecord& record = parts_.records[id];
        if (record.is_expected)
        {
            CheckExpected(NodeId{id}, record, now);
        }
        if ((record.watch == Watch::kHeartbeat) && record.is_running)
        {
            CheckHeartbeat(NodeId{id}, record, now);
        }
        else if ((record.watch == Watch::kGuarding) && record.is_running)
        {
            Guard(NodeId{id}, record, now);
        }
    }
}

void NodeTable::CheckExpected(const NodeId node, NodeRecord& record, const Instant now) noexcept
{
    if ((now.us - record.expected_from.us) > record.expect_us)
    {
        record.is_expected = false;
        record.state = SlaveState::kMissing;
        parts_.listener.OnNodeEvent(node, NodeEvent::kNeverSeen, now);
    }
}

void NodeTable::CheckHeartbeat(const NodeId node, NodeRecord& record, const Instant now) noexcept
{
    if ((now.us - record.since.us) > record.time_us)
    {
        record.is_running = false;
        record.has_begun = false;
        record.state = SlaveState::kMissing;
        parts_.listener.OnNodeEvent(node, NodeEvent::kHeartbeatLost, now);
    }
}

/// One remote frame each guard time; the one before is missed if it was not answered by then.
void NodeTable::Guard(const NodeId node, NodeRecord& record, const Instant now) noexcept
{
    const std::uint32_t since_us = now.us - record.since.us;
    if ((since_us >= record.time_us) && SendRemote(node))
    {
        const bool is_late = since_us >= (2U * record.time_us); // The cycle rested: no drift is to be kept.
        const bool is_missed = record.is_asked;
        record.since = is_late ? now : Instant{record.since.us + record.time_us};
        record.is_asked = true;
        if (is_missed)
        {
            Miss(node, record, now);
        }
    }
}

void NodeTable::Miss(const NodeId node, NodeRecord& record, const Instant now) noexcept
{
    if (record.missed < record.retry_factor)
    {
        ++record.missed;
        const bool is_lost = (record.missed == record.retry_factor);
        if (is_lost)
        {
            record.state = SlaveState::kMissing;
            record.has_begun = false;
            const bool is_more = record.is_toggle_wrong && (record.untoggled < kMostUntoggled);
            record.untoggled = is_more ? static_cast<std::uint8_t>(record.untoggled + 1U) : record.untoggled;
        }
        parts_.listener.OnNodeEvent(node, is_lost ? NodeEvent::kGuardLost : NodeEvent::kGuardMissed, now);
    }
}

bool NodeTable::SendRemote(const NodeId node) noexcept
{
    const CanFrame frame{kErrorControl + node.value, FrameKind::kRemote, CanPortId::kFirst, 1U, {}};
    return parts_.sink.Send(frame);
}

} // namespace counterpoint::cia302
