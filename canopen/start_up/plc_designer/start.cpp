// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// From state 4 to 5, one by one or all at once, and commands of the application.
#include "canopen/start_up/plc_designer/start_up.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr ObjectAddress kDeviceType{0x1000U, 0U};
constexpr std::uint8_t kStoppedByte = 4U; ///< As 1F82h reads it.
constexpr std::uint8_t kOperationalByte = 5U;
constexpr std::uint8_t kPreOperationalByte = 127U;

} // namespace

/// State 4, or 98. [SRS_PLC_012, SRS_PLC_016]
void PlcStartUp::EndSdos(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    const bool is_automatic = !parts_.common.setup.Has(kApplicationStartsSlaves);
    slave.has_sdos = true;
    slave.is_wanted = is_automatic && !slave.is_held && !slave.is_type_wrong;
    slave.is_verified = false;
    slave.is_by_hand = false;
    slave.is_woken = false;
    slave.is_unread = false;
    slave.ran_unread = false;
    slave.signs = parts_.common.table.Record(node).signs;
    slave.status.is_other = slave.is_type_wrong;
    if (slave.is_type_wrong)
    {
        slave.status.object = kDeviceType;
        Go(node, PlcEvent::kOther, StartUpStep::kDeviceType, now);
    }
    else
    {
        parts_.common.table.WatchAsSetUp(node, now);
        Go(node, PlcEvent::kAnswered, StartUpStep::kManual, now);
    }
}

/// A safety slave that runs and cannot be read is stopped, and asked on in PRE-OPERATIONAL; so is one that says that it
/// is STOPPED, unless it is held by a command. [SRS_SFS_006, SRS_PLC_005]
void PlcStartUp::StopUnread(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    const bool is_deaf = (parts_.common.table.Record(node).state == SlaveState::kStopped) && !slave.is_held;
    const bool is_running = parts_.common.setup.IsSafetySlave(node) && parts_.common.table.RunsSurely(node);
    if (slave.is_unread || is_deaf || is_running) // A full queue: at the next silence.
    {
        const NmtCommand command = is_running ? NmtCommand::kStop : NmtCommand::kPreOperational;
        const NmtAnswer answer = parts_.common.nmt.Request(command, node, now);
        slave.is_unread = (answer == NmtAnswer::kTaken) ? is_running : slave.is_unread;
    }
}

/// A safety slave that says OPERATIONAL, or whose start was heard, and has no permission of the gate. [SRS_SFS_006]
bool PlcStartUp::RunsUnread(const NodeId node) const noexcept
{
    const bool is_one = parts_.common.setup.IsSafetySlave(node) && (Of(node).status.code >= kPlcSettles);
    const bool is_running = parts_.common.table.RequestValue(node) == kOperationalByte;
    return is_one && is_running && (parts_.common.gate.State(node) != GateState::kOpen);
}

/// It is to be started with all others, for which somebody else is waited for.
bool PlcStartUp::WaitsForAll(const NodeId node) const noexcept
{
    const PlcNode& slave = Of(node);
    const bool is_one = slave.is_wanted && !slave.is_by_hand && (slave.status.code == kPlcConfigured);
    return is_one && parts_.common.setup.Has(kStartAllAtOnce) && !has_started_all_;
}

/// [SRS_PLC_013, SRS_PLC_015]
void PlcStartUp::DriveStart(const NodeId node, const Instant now) noexcept
{
    if (Of(node).is_wanted && !WaitsForAll(node))
    {
        StartOne(node, now);
    }
}

/// A safety slave is verified first; a STOPPED one has no SDO and is made PRE-OPERATIONAL before. [SRS_PLC_020]
void PlcStartUp::StartOne(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    const bool is_safety = parts_.common.setup.IsSafetySlave(node);
    const bool is_stopped = (parts_.common.table.RequestValue(node) == kStoppedByte) && !slave.is_woken;
    const bool is_waking = slave.is_woken && (parts_.common.nmt.Waiting() > 0U) &&
                           (parts_.common.table.Record(node).asked != SlaveState::kPreOperational);
    const GateState gate = parts_.common.gate.State(node);
    if (is_safety && !slave.is_verified && is_stopped)
    {
        slave.is_woken = (parts_.common.nmt.Request(NmtCommand::kPreOperational, node, now) == NmtAnswer::kTaken);
    }
    else if (is_safety && !slave.is_verified)
    {
        slave.is_verified = !is_waking;
        slave.is_checking = false; // This reading serves.
        if (!is_waking)
        {
            Go(node, PlcEvent::kNone, StartUpStep::kSafety, now);
            parts_.common.gate.Verify(node, now);
        }
    }
    else if (gate == GateState::kOpen)
    {
        if (parts_.common.nmt.Request(NmtCommand::kStart, node, now) == NmtAnswer::kTaken)
        {
            slave.is_wanted = false;
            slave.status.is_started = true;
            Go(node, PlcEvent::kStarted, StartUpStep::kRunning, now);
        }
    }
    else if ((gate == GateState::kDiffers) || (gate == GateState::kFailed))
    {
        slave.is_wanted = false;
        Refuse(node, now);
    }
    else
    {
        slave.is_verified = (gate == GateState::kBusy); // Closed meanwhile: once more.
    }
}

/// Somebody commanded the slave while its start waited: it is read once more. [SRS_PLC_020]
void PlcStartUp::OnStartDropped(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    if ((slave.status.code == kPlcStarted) && slave.status.is_started)
    {
        slave.is_wanted = true;
        slave.is_by_hand = true; // Nobody else is waited for again.
        slave.is_verified = false;
        slave.is_woken = false;
        slave.is_checking = false;
        slave.status.is_started = false;
        Go(node, PlcEvent::kStartAgain, StartUpStep::kStart, now);
    }
}

void PlcStartUp::Refuse(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    const GateFinding finding = parts_.common.gate.Finding(node);
    slave.status.object = finding.object;
    slave.status.abort = finding.abort;
    slave.status.expected = finding.expected;
    slave.status.read = finding.read;
    const bool is_other = parts_.common.gate.IsOther(node);
    slave.status.is_other = slave.status.is_other || is_other;
    slave.status.is_started = false;
    slave.signs = parts_.common.table.Record(node).signs;
    slave.was_checked = false;
    slave.is_stop_due = (parts_.common.nmt.Request(NmtCommand::kStop, node, now) != NmtAnswer::kTaken);
    Go(node, is_other ? PlcEvent::kOther : PlcEvent::kNone, is_other ? StartUpStep::kDeviceType : StartUpStep::kSafety,
       now);
    parts_.common.listener.OnNodeStatus(node, now);
}

/// A safety slave that runs without having been started is verified, also while it waits for the start of all, and one
/// that was started, but whose gate did not stay open. [SRS_PLC_020]
void PlcStartUp::DriveCheck(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    const NodeRecord& record = parts_.common.table.Record(node);
    const GateState gate = parts_.common.gate.State(node);
    const bool is_free = !slave.is_wanted || WaitsForAll(node);
    const bool is_left = (slave.status.code > kPlcSdos) && is_free && parts_.common.setup.IsSafetySlave(node);
    const bool is_found = is_left && !slave.status.is_started && (record.signs != slave.signs) &&
                          parts_.common.table.IsFoundRunning(node);
    const bool is_refused = (gate == GateState::kDiffers) || (gate == GateState::kFailed);
    const bool is_back = (gate == GateState::kClosed) && parts_.common.table.RunsSurely(node);
    const bool is_again = is_left && (is_back || (is_refused && slave.status.is_started));
    if (slave.is_checking)
    {
        slave.is_checking = (gate == GateState::kBusy);
        slave.was_checked = (gate == GateState::kOpen);
        if (is_refused)
        {
            slave.is_wanted = false;
            Refuse(node, now);
        }
    }
    else if (is_again || (is_found && !slave.was_checked))
    {
        slave.is_checking = true;
        parts_.common.gate.Verify(node, now);
    }
    else
    {
        slave.was_checked = slave.was_checked && is_found;
    }
}

/// A safety slave that has left OPERATIONAL can be changed: it is read when it says that it runs again. [SRS_PLC_020]
void PlcStartUp::OnLeft(const NodeId node) noexcept
{
    PlcNode& slave = Of(node);
    const NodeRecord& record = parts_.common.table.Record(node);
    const GateState gate = parts_.common.gate.State(node);
    const bool is_refused = (gate == GateState::kDiffers) || (gate == GateState::kFailed); // Stays to be told.
    if (parts_.common.setup.IsSafetySlave(node) && (record.state != SlaveState::kOperational))
    {
        if (!is_refused)
        {
            parts_.common.gate.Close(node);
        }
        slave.status.is_started = false;
        slave.was_checked = false;
        slave.signs = record.signs;
    }
}

/// Once, when nobody is waited for any more. Slaves that must not start forbid the start of all. [SRS_PLC_014]
void PlcStartUp::StartAll(const Instant now) noexcept
{
    const bool is_asked = parts_.common.setup.Has(kStartAllAtOnce) && !has_started_all_ &&
                          !parts_.common.setup.Has(kApplicationStartsSlaves);
    bool is_ready = is_asked;
    bool is_one_by_one = parts_.common.setup.HasSafetySlave();
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const PlcNode& slave = Of(NodeId{id});
        const std::int16_t state = slave.status.code;
        const bool is_waiting = (state == kPlcConfigured) && slave.is_wanted;
        is_ready = is_ready && (!slave.is_listed || (state > kPlcSdos));
        is_one_by_one = is_one_by_one || (slave.is_listed && !is_waiting && (state != kPlcAbsent));
    }
    if (is_ready && is_one_by_one)
    {
        has_started_all_ = true;
    }
    else if (is_ready && (parts_.common.nmt.Request(NmtCommand::kStart, kAllNodes, now) == NmtAnswer::kTaken))
    {
        has_started_all_ = true;
        for (std::uint8_t id = 1U; id <= kLastNode; ++id)
        {
            PlcNode& slave = Of(NodeId{id});
            if (slave.is_wanted)
            {
                slave.is_wanted = false;
                slave.status.is_started = true;
                Go(NodeId{id}, PlcEvent::kStarted, StartUpStep::kRunning, now);
            }
        }
    }
    else
    {
        // Somebody is waited for.
    }
}

NmtAnswer PlcStartUp::Command(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    NmtAnswer answer = is_active_ ? NmtAnswer::kTaken : NmtAnswer::kNotActive;
    const bool is_all = (node.value == kAllNodes.value);
    bool is_any = is_all;
    bool has_taken = false;
    if (is_active_ && (node.value == parts_.common.setup.own.value))
    {
        answer = parts_.common.nmt.Request(command, node, now);
        is_any = true;
    }
    for (std::uint8_t id = 1U; (id <= kLastNode) && is_active_; ++id)
    {
        if (Of(NodeId{id}).is_listed && (is_all || (id == node.value)))
        {
            const NmtAnswer one = CommandOne(command, NodeId{id}, now);
            answer = (answer == NmtAnswer::kTaken) ? one : answer;
            is_any = true;
            has_taken = has_taken || (one == NmtAnswer::kTaken);
        }
    }
    answer = (has_taken && (answer == NmtAnswer::kWrong)) ? NmtAnswer::kPartly : answer;
    return (is_any || !is_active_) ? answer : NmtAnswer::kWrong;
}

NmtAnswer PlcStartUp::CommandOne(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    const std::int16_t state = slave.status.code;
    const bool is_start = (command == NmtCommand::kStart);
    const std::uint8_t heard = parts_.common.table.RequestValue(node);
    const bool has_left = (state == kPlcStarted) && ((heard == kStoppedByte) || (heard == kPreOperationalByte));
    NmtAnswer answer = NmtAnswer::kTaken;
    if (is_start && ((state == kPlcConfigured) || (state == kPlcLost) || has_left))
    {
        slave.is_wanted = true;
        slave.is_by_hand = true;
        slave.is_held = false;
        slave.is_verified = false;
        slave.is_woken = false;
        slave.is_checking = false;
        const std::uint16_t time_ms = parts_.common.setup.Slave(node).heartbeat.consumer_ms;
        if ((state == kPlcLost) && (time_ms > 0U))
        {
            parts_.common.table.WatchHeartbeat(node, time_ms, Arming::kImmediately, now); // It was there once.
        }
        else
        {
            parts_.common.table.WatchAsSetUp(node, now);
        }
        Go(node, PlcEvent::kStartAgain, StartUpStep::kStart, now);
    }
    else if (is_start)
    {
        const bool is_other = slave.status.is_other && parts_.common.setup.IsSafetySlave(node);
        answer = is_other ? NmtAnswer::kOtherDevice : NmtAnswer::kWrong;
        answer = (state == kPlcStarted) ? NmtAnswer::kTaken : answer;
    }
    else
    {
        answer = parts_.common.nmt.Request(command, node, now);
        if (answer == NmtAnswer::kTaken)
        {
            Obey(command, node, now);
        }
    }
    return answer;
}

/// What a command that was handed over makes of the slave's state.
void PlcStartUp::Obey(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    if ((command == NmtCommand::kResetNode) || (command == NmtCommand::kResetCommunication))
    {
        BeginReset(node, now);
        Go(node, PlcEvent::kResetSent, StartUpStep::kWaitBootUp, now);
    }
    else
    {
        parts_.common.gate.Close(node);
        slave.is_held = true;
        slave.is_unread = false; // Not woken: this command counts.
        slave.is_wanted = false;
        slave.is_checking = false;
        slave.status.is_started = false;
        slave.signs = parts_.common.table.Record(node).signs;
        Go(node, PlcEvent::kHold, StartUpStep::kManual, now);
    }
}

/// A slave that is held by a command waits for one.
bool PlcStartUp::Resume(const NodeId node, const Instant now) noexcept
{
    const bool is_one = is_active_ && Of(node).is_listed && (master_ >= kPlcConfigures);
    if (is_one && !Of(node).is_held)
    {
        Settle(node, now);
    }
    return is_one;
}

std::int16_t PlcStartUp::MasterState() const noexcept
{
    return master_;
}

bool PlcStartUp::Boot(const NodeId node, const Instant now) noexcept
{
    const bool is_one = is_active_ && Of(node).is_listed && (master_ >= kPlcConfigures);
    if (is_one)
    {
        BeginReset(node, now);
    }
    return is_one;
}

} // namespace counterpoint::cia302
