// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/el6751/stops.hpp"

namespace counterpoint::cia302
{

El6751Stops::El6751Stops(El6751Slaves& slaves, El6751Pdos& pdos, El6751Sdos& sdos) noexcept
    : parts_(slaves.Parts()), slaves_(slaves), pdos_(pdos), sdos_(sdos)
{
}

void El6751Stops::Stop(const NodeId node, const El6751Event event, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    parts_.table.Unwatch(node);
    pdos_.Rest(node);
    slave.phase = Next(slave.phase, event);
    Drive(node, now);
}

void El6751Stops::Drive(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    if (parts_.nmt.Request(NmtCommand::kStop, node, now) == NmtAnswer::kTaken)
    {
        slave.phase = Next(slave.phase, El6751Event::kStopped);
        slave.signs = parts_.table.Record(node).signs;
        slave.reading.was_checked = false;
        slave.status.is_started = false;
        if (slave.phase == El6751Phase::kResetting)
        {
            sdos_.Reset(node, now);
        }
    }
}

void El6751Stops::StopOthers(const NodeId node, const Instant now) noexcept
{
    const bool is_asked = (slaves_.SetupOf(node).network_reaction == El6751NetworkReaction::kStopAll);
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        El6751Node& other = slaves_.Of(NodeId{id});
        const bool is_started = (other.phase == El6751Phase::kRunning) || (other.phase == El6751Phase::kStarting);
        if (is_asked && is_started && (id != node.value))
        {
            other.cause = kNodeDeactivated;
            slaves_.Tell(NodeId{id}, kNodeDeactivated, other.status.step, now);
            Stop(NodeId{id}, El6751Event::kDeactivate, now);
        }
    }
}

void El6751Stops::Hold(const NodeId node, const std::int16_t code, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    pdos_.Rest(node);
    slave.phase = Next(slave.phase, El6751Event::kHold);
    slave.held_code = code;
    slave.control_fault = 0;
    slave.reading.is_checking = false;
    slave.reading.was_checked = false;
    slave.signs = parts_.table.Record(node).signs;
    slave.status.is_started = false;
    slaves_.Tell(node, code, StartUpStep::kManual, now);
}

/// A slave that was stopped, and is read once more because somebody's start came so near that it may run, is silent:
/// what was found before stays, unless it said itself that it runs.
void El6751Stops::Refuse(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const bool differs = parts_.gate.State(node) == GateState::kDiffers;
    const GateFinding finding = parts_.gate.Finding(node);
    const NodeRecord& record = parts_.table.Record(node);
    const bool says_so = (record.state == SlaveState::kOperational) && !record.is_presumed;
    const bool is_silence = !differs && (finding.abort == SdoAbort::kTimeOut) && !says_so;
    const bool has_finding = (slave.status.step == StartUpStep::kSafety) &&
                             ((slave.status.code == kNodeMismatch) || (slave.status.code == kNodeSyntax));
    if (!is_silence || !has_finding)
    {
        slave.status.Take(finding);
        slave.cause = differs ? kNodeMismatch : kNodeSyntax;
        slave.held_code = slave.cause;
        slaves_.Tell(node, slave.cause, StartUpStep::kSafety, now);
    }
    slave.status.is_other = slave.status.is_other || parts_.gate.IsOther(node);
    slave.status.is_started = false;
    slave.reading.is_checking = false;
    Stop(node, El6751Event::kRefuse, now);
}

} // namespace counterpoint::cia302
