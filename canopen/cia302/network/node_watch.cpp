// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/network/node_watch.hpp"

#include "canopen/cia302/network/nmt_command.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kEmergencies = 0x80U;
constexpr std::uint32_t kAnswers = 0x580U;
constexpr std::uint32_t kRequests = 0x600U;
constexpr std::uint32_t kErrorControl = 0x700U;
constexpr std::uint32_t kNodeMask = 0x7FU;
constexpr std::uint8_t kEmergencyBytes = 8U;
constexpr std::uint8_t kSdoBytes = 8U;
constexpr std::uint32_t kUsPerMs = 1000U;

/// The device itself is faulty (hardware, software, modules), as in its safe state, until it takes back all of its
/// errors or boots. Errors of the bus are no faults of the device. [SRS_MGR_025]
std::uint16_t FaultAfter(const std::uint16_t fault, const CanFrame& emergency) noexcept
{
    constexpr std::uint16_t kFirstFault = 0x5000U;
    constexpr std::uint16_t kLastFault = 0x7FFFU;
    const auto code = static_cast<std::uint16_t>(emergency.data[0] | (std::uint32_t{emergency.data[1]} << 8U));
    const bool is_end = (code < 0x0100U) && (emergency.data[2] == 0U);
    const bool is_begin = (fault == 0U) && (code >= kFirstFault) && (code <= kLastFault);
    const std::uint16_t next = is_begin ? code : fault;
    return is_end ? std::uint16_t{0U} : next;
}

} // namespace

NodeWatch::NodeWatch(const NetworkSetup& setup, WatchedNode* const nodes, NodeWatchListener& listener) noexcept
    : setup_(setup), nodes_(nodes), listener_(listener)
{
}

void NodeWatch::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    const NodeId node{static_cast<std::uint8_t>(frame.identifier & kNodeMask)};
    const std::uint32_t function = frame.identifier & ~kNodeMask;
    const bool is_data = (frame.kind == FrameKind::kData) && (node.value != 0U);
    const NodeId sender = EmergencySender(frame);
    OnSent(frame); // Others ask too.
    if (sender.value != 0U)
    {
        OnEmergency(sender, frame, now);
    }
    else if (is_data && (function == kErrorControl) && (frame.length_bytes == 1U))
    {
        OnAnswer(node, frame, now);
        OnSign(node, frame.data[0], now);
    }
    else if (is_data && (function == kAnswers))
    {
        OnAnswer(node, frame, now);
        OnTime(node, frame);
    }
    else
    {
        // Of no concern here.
    }
}

/// A slave of which 1014h names another identifier keeps that; of all others it is 80h + node-ID.
NodeId NodeWatch::EmergencySender(const CanFrame& frame) const noexcept
{
    const bool is_emergency = (frame.kind == FrameKind::kData) && (frame.length_bytes == kEmergencyBytes);
    NodeId sender{0U};
    bool is_named = false;
    for (std::uint8_t id = 1U; (id <= kLastNode) && is_emergency && !is_named; ++id)
    {
        const std::uint32_t named = setup_.Slave(NodeId{id}).emergency_id;
        const std::uint32_t expected = (named == 0U) ? (kEmergencies + id) : named;
        const bool is_one = (frame.identifier == expected);
        is_named = is_one && (named != 0U);
        sender = is_one ? NodeId{id} : sender;
    }
    return sender;
}

/// Questions alone: what is asked by whom makes no difference.
void NodeWatch::OnSent(const CanFrame& frame) noexcept
{
    const std::uint32_t node = frame.identifier & kNodeMask;
    const std::uint32_t function = frame.identifier & ~kNodeMask;
    const bool is_remote = (frame.kind == FrameKind::kRemote);
    const bool is_question = (function == kErrorControl) ? is_remote : ((function == kRequests) && !is_remote);
    if (is_question && (node != 0U))
    {
        AnswerWatch::OnQuestion(nodes_[node].asked, frame);
    }
    else if (frame.identifier == 0U)
    {
        OnReset(frame);
    }
    else
    {
        // Nothing that a node answers.
    }
}

void NodeWatch::OnReset(const CanFrame& frame) noexcept
{
    constexpr std::uint8_t kCommandBytes = 2U;
    const auto command = static_cast<NmtCommand>(frame.data[0]);
    const bool is_reset = (frame.kind == FrameKind::kData) && (frame.length_bytes == kCommandBytes) &&
                          ((command == NmtCommand::kResetNode) || (command == NmtCommand::kResetCommunication));
    for (std::uint8_t id = 1U; is_reset && (id <= kLastNode); ++id)
    {
        if ((frame.data[1] == kAllNodes.value) || (frame.data[1] == id))
        {
            AnswerWatch::OnReset(nodes_[id].asked);
        }
    }
}

/// Only this device itself answers with its own node-ID.
void NodeWatch::OnAnswer(const NodeId node, const CanFrame& frame, const Instant now) noexcept
{
    const bool is_too_many = AnswerWatch::OnAnswer(nodes_[node.value].asked, frame);
    if (is_too_many || (node.value == setup_.own.value))
    {
        Suspect(node, now);
    }
}

/// The answer to a write of 1017h, whoever writes: taken, the heartbeats come as configured; refused, as the device
/// likes. [SRS_MGR_083]
void NodeWatch::OnTime(const NodeId node, const CanFrame& frame) noexcept
{
    constexpr std::uint8_t kTaken = 0x60U;
    constexpr std::uint8_t kAborted = 0x80U;
    const bool is_heartbeat_time =
        (frame.length_bytes == kSdoBytes) && (frame.data[1] == 0x17U) && (frame.data[2] == 0x10U);
    WatchedNode& watched = nodes_[node.value];
    const bool is_refused = is_heartbeat_time && (frame.data[0] == kAborted);
    const bool is_taken = is_heartbeat_time && (frame.data[0] == kTaken);
    watched.has_own_time = is_refused || (watched.has_own_time && !is_taken);
}

void NodeWatch::OnEmergency(const NodeId node, const CanFrame& frame, const Instant now) noexcept
{
    EmergencyRecord& record = nodes_[node.value].emergency;
    nodes_[node.value].fault = FaultAfter(nodes_[node.value].fault, frame);
    record.code = static_cast<std::uint16_t>(frame.data[0] | (std::uint32_t{frame.data[1]} << 8U));
    record.error_register = frame.data[2];
    for (std::uint32_t byte = 0U; byte < sizeof(record.details); ++byte)
    {
        record.details[byte] = frame.data[byte + 3U];
    }
    ++record.count;
    if (!record.has_told || ((now.us - record.told.us) >= kEmergencyGapUs))
    {
        Tell(node, now);
    }
    else
    {
        ++record.untold;
    }
}

void NodeWatch::Tell(const NodeId node, const Instant now) noexcept
{
    EmergencyRecord& record = nodes_[node.value].emergency;
    record.has_told = true;
    record.told = now;
    listener_.OnEmergency(node, record, now);
    record.untold = 0U;
}

/// The error reset behind an error is not to be the one that is left out.
void NodeWatch::OnCycle(const Instant now) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        EmergencyRecord& record = nodes_[id].emergency;
        const bool is_over = record.has_told && ((now.us - record.told.us) >= kEmergencyGapUs);
        if (is_over && (record.untold > 0U))
        {
            --record.untold; // The last one is told itself.
            Tell(NodeId{id}, now);
        }
        else if (is_over)
        {
            record.has_told = false; // Before the counter comes round.
        }
        else
        {
            // Nothing to tell, or not yet.
        }
    }
}

/// A restart has its own boot-up message and first heartbeat: the count begins anew behind them.
void NodeWatch::OnSign(const NodeId node, const std::uint8_t byte, const Instant now) noexcept
{
    constexpr std::uint8_t kBootUp = 0U;
    WatchedNode& watched = nodes_[node.value];
    watched.fault = (byte == kBootUp) ? std::uint16_t{0U} : watched.fault;
    const std::uint32_t window_us = std::uint32_t{setup_.Slave(node).heartbeat.producer_ms} * kUsPerMs * kWindowPeriods;
    const bool is_new = (watched.signs == 0U) || ((now.us - watched.window.us) > window_us);
    watched.window = is_new ? now : watched.window;
    watched.signs = is_new ? std::uint8_t{1U} : static_cast<std::uint8_t>(watched.signs + 1U);
    watched.signs = (byte == kBootUp) ? std::uint8_t{0U} : watched.signs;
    const bool is_too_often = (window_us > 0U) && !watched.has_own_time && (watched.signs >= kWindowSigns);
    if (is_too_often)
    {
        watched.signs = 0U;
        Suspect(node, now);
    }
}

void NodeWatch::Suspect(const NodeId node, const Instant now) noexcept
{
    WatchedNode& watched = nodes_[node.value];
    if (!watched.is_duplicate)
    {
        watched.is_duplicate = true;
        listener_.OnDuplicate(node, now);
    }
}

void NodeWatch::CountAnew(const NodeId node) noexcept
{
    nodes_[node.value].signs = 0U;
}

void NodeWatch::OnLost() noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        nodes_[id].asked = AskedNode{};
        nodes_[id].signs = 0U;
    }
}

void NodeWatch::OnReset(const NodeId node) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        if ((node.value == kAllNodes.value) || (node.value == id))
        {
            WatchedNode& watched = nodes_[id];
            watched.asked = watched.is_duplicate ? AskedNode{} : watched.asked; // Else the count goes on.
            watched.signs = 0U;
            watched.is_duplicate = false;
        }
    }
}

const WatchedNode& NodeWatch::Of(const NodeId node) const noexcept
{
    return nodes_[node.value];
}

} // namespace counterpoint::cia302
