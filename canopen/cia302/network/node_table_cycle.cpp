// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What time brings: nodes that were never seen, heartbeats that stay away, remote frames and their answers.
#include "canopen/cia302/network/node_table.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kErrorControl = 0x700U;

} // namespace

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
