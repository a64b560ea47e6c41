// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Start-up of one slave: its SDOs row by row, the gate, NMT start.
#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/start_up/el6751/start_up.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kBufferBytes = 8U;
constexpr std::uint8_t kStoppedByte = 4U; ///< As 1F82h reads it.

} // namespace

/// The slave is reset; what it showed stays to be seen until it answers.
void El6751StartUp::DriveReset(const NodeId node, const Instant now) noexcept
{
    if (parts_.common.nmt.Request(NmtCommand::kResetCommunication, node, now) == NmtAnswer::kTaken)
    {
        BeginRows(node, Of(node).status.code, now);
    }
}

void El6751StartUp::BeginRows(const NodeId node, const std::int16_t code, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    parts_.common.sdo.Cancel(node, SdoAbort::kGeneral);
    parts_.common.gate.Close(node);
    parts_.common.table.Unwatch(node);
    pdos_.Rest(node);
    slave.phase = Next(slave.phase, El6751Event::kBegin);
    slave.place = NextRow(Context(node), El6751Place{});
    slave.control_fault = 0;
    slave.has_answered = false;
    slave.is_transferring = false;
    slave.is_requested = false;
    slave.is_checking = false;
    slave.was_checked = false;
    slave.has_restarted = false;
    slave.is_cut = false;
    slave.status.object = ObjectAddress{0U, 0U};
    slave.status.abort = SdoAbort::kNone;
    slave.status.expected = 0U;
    slave.status.read = 0U;
    slave.status.is_started = false;
    slave.status.is_other = false;
    slave.is_unread = false;
    Tell(node, code, AccessOf(Context(node), slave.place).step, now);
}

void El6751StartUp::DriveRows(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    const TransferState state = parts_.common.sdo.State(node);
    if (slave.is_transferring && (state != TransferState::kBusy))
    {
        EndTransfer(node, now);
    }
    if ((slave.phase == El6751Phase::kRows) && !slave.is_transferring)
    {
        if (slave.place.row == El6751Row::kEnd)
        {
            EndRows(node, now);
        }
        else
        {
            BeginTransfer(node, now);
        }
    }
}

void El6751StartUp::BeginTransfer(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    const El6751Access access = AccessOf(Context(node), slave.place);
    const Bytes& list = parts_.common.setup.Slave(node).concise_dcf;
    slave.status.object = access.object;
    if ((slave.place.row == El6751Row::kUserObject) && (slave.place.user.entry == 0U) && !IsConcise(list))
    {
        slave.status.object = ObjectAddress{0x1F22U, node.value};
        Fail(node, kNodeSyntax, now);
    }
    else if (access.is_upload)
    {
        const Room room{slave.buffer, kBufferBytes};
        slave.is_transferring = parts_.common.sdo.Upload(node, access.object, room, SdoMode::kNormal, now);
    }
    else
    {
        cia301::ToLittleEndian(access.value, slave.buffer, access.size_bytes);
        const Bytes number{slave.buffer, access.size_bytes};
        const Bytes& value = (access.size_bytes > 0U) ? number : access.user;
        slave.is_transferring = parts_.common.sdo.Download(node, access.object, value, SdoMode::kNormal, now);
    }
    if (slave.is_transferring)
    {
        Tell(node, slave.status.code, access.step, now);
    }
}

/// An answer, or none.
void El6751StartUp::EndTransfer(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    const El6751Access access = AccessOf(Context(node), slave.place);
    const bool has_end = parts_.common.sdo.State(node) != TransferState::kIdle;
    El6751Answer answer{parts_.common.sdo.Outcome(node), 0U, !slave.has_answered};
    if (answer.outcome.size_bytes <= kBufferBytes)
    {
        answer.read = cia301::FromLittleEndian(slave.buffer, answer.outcome.size_bytes);
    }
    slave.is_transferring = false;
    if (has_end)
    {
        const El6751Verdict verdict = JudgeAnswer(access, slave.place.row, answer);
        slave.status.abort = answer.outcome.abort;
        switch (verdict)
        {
        case El6751Verdict::kNext:
            slave.has_answered = true;
            slave.place = NextRow(Context(node), Remember(slave.place, answer.outcome));
            Tell(node, kNodeStarts, access.step, now);
            break;
        case El6751Verdict::kNotFound:
            StopUnread(node, now);
            Tell(node, kNodeNotFound, access.step, now);
            break;
        case El6751Verdict::kMismatch:
            slave.status.expected = access.value;
            slave.status.read = answer.read;
            Fail(node, kNodeMismatch, now);
            break;
        case El6751Verdict::kSyntax:
        case El6751Verdict::kInvalid:
        default:
            Fail(node, kNodeSyntax, now);
            break;
        }
    }
}

/// A safety slave that runs and cannot be read is stopped, and asked on in PRE-OPERATIONAL; so is one that says that it
/// is STOPPED: a command may have come in behind its boot-up message. [SRS_SFS_006, SRS_ELM_003]
void El6751StartUp::StopUnread(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    const NodeRecord& heard = parts_.common.table.Record(node);
    const bool is_ours = slave.is_unread && (heard.asked == SlaveState::kStopped);
    const bool is_deaf = (heard.state == SlaveState::kStopped);
    const bool is_running = IsSafety(node) && parts_.common.table.RunsSurely(node);
    if (is_ours || is_deaf || is_running) // A full queue: at the next silence.
    {
        const NmtCommand command = is_running ? NmtCommand::kStop : NmtCommand::kPreOperational;
        const NmtAnswer answer = parts_.common.nmt.Request(command, node, now);
        slave.is_unread = (answer == NmtAnswer::kTaken) ? is_running : slave.is_unread;
    }
}

void El6751StartUp::Fail(const NodeId node, const std::int16_t code, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    slave.phase = Next(slave.phase, El6751Event::kFail);
    slave.status.is_other = slave.status.is_other || (slave.place.row <= El6751Row::kSerialNumber);
    slave.cause = code;
    slave.signs = parts_.common.table.Record(node).signs;
    Tell(node, code, AccessOf(Context(node), slave.place).step, now);
}

void El6751StartUp::EndRows(const NodeId node, const Instant now) noexcept
{
    const El6751Node& slave = Of(node);
    const bool is_started = SetupOf(node).is_started && !slave.is_held_by_hand;
    Supervise(node, now);
    if (is_started || slave.is_start_wanted)
    {
        BeginStart(node, now);
    }
    else
    {
        Hold(node, kNodePreOperational, now);
    }
}

/// Heartbeat if the slave took it, else guarding; what the network's list says if this profile has no times.
/// [SRS_ELM_039]
void El6751StartUp::Supervise(const NodeId node, const Instant now) noexcept
{
    const El6751Slave& setup = SetupOf(node);
    NodeTable& table = parts_.common.table;
    constexpr std::uint32_t kLongestTime = 0xFFFFU;
    const std::uint32_t life_ms = std::uint32_t{setup.guard_time_ms} * setup.life_time_factor;
    const auto time_ms = static_cast<std::uint16_t>((life_ms > kLongestTime) ? kLongestTime : life_ms);
    const std::uint16_t listed_ms = parts_.common.setup.Slave(node).heartbeat.consumer_ms;
    const bool was_lost = (table.Record(node).state == SlaveState::kMissing);
    if (!setup.IsWatched() && was_lost && (listed_ms > 0U))
    {
        table.WatchHeartbeat(node, listed_ms, Arming::kImmediately, now); // It was there once.
    }
    else if (!setup.IsWatched())
    {
        table.WatchAsSetUp(node, now);
    }
    else if (Of(node).place.is_heartbeat_aborted)
    {
        table.WatchGuarding(node, setup.guard_time_ms, setup.life_time_factor, now);
    }
    else if (Of(node).place.is_heartbeat_answered)
    {
        table.WatchHeartbeat(node, time_ms, Arming::kImmediately, now);
    }
    else
    {
        // Started by hand after a start-up that did not come so far: it was told to send nothing.
    }
}

void El6751StartUp::BeginStart(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    slave.is_requested = false;
    slave.is_held_by_hand = false;
    slave.is_start_wanted = false;
    slave.is_checking = false;
    slave.control_fault = 0;
    slave.phase = Next(slave.phase, IsSafety(node) ? El6751Event::kVerify : El6751Event::kStart);
    Tell(node, kNodeStarts, IsSafety(node) ? StartUpStep::kSafety : StartUpStep::kStart, now);
    Drive(node, now);
}

/// The gate reads; a STOPPED slave has no SDO and is made PRE-OPERATIONAL before. [SRS_ELM_048]
void El6751StartUp::DriveVerify(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    const bool is_stopped = (parts_.common.table.Record(node).asked == SlaveState::kStopped) ||
                            (parts_.common.table.RequestValue(node) == kStoppedByte);
    const GateState gate = parts_.common.gate.State(node);
    if (!slave.is_requested && is_stopped)
    {
        const NmtAnswer answer = parts_.common.nmt.Request(NmtCommand::kPreOperational, node, now);
        slave.is_requested = (answer == NmtAnswer::kTaken);
    }
    else if (!slave.is_checking)
    {
        const bool has_left = !slave.is_requested || (parts_.common.nmt.Waiting() == 0U) ||
                              (parts_.common.table.Record(node).asked == SlaveState::kPreOperational);
        slave.is_checking = has_left;
        if (has_left)
        {
            parts_.common.gate.Verify(node, now);
        }
    }
    else if (gate == GateState::kOpen)
    {
        slave.is_checking = false;
        slave.is_requested = false;
        slave.phase = Next(slave.phase, El6751Event::kStart);
        Tell(node, kNodeStarts, StartUpStep::kStart, now);
        DriveStart(node, now);
    }
    else if ((gate == GateState::kDiffers) || (gate == GateState::kFailed))
    {
        RefuseSafety(node, now);
    }
    else
    {
        slave.is_checking = (gate == GateState::kBusy); // Closed meanwhile: once more.
    }
}

/// A slave that was stopped, and is read once more because somebody's start came so near that it may run, is silent:
/// what was found before stays, unless it said itself that it runs.
void El6751StartUp::RefuseSafety(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    const bool differs = parts_.common.gate.State(node) == GateState::kDiffers;
    const GateFinding finding = parts_.common.gate.Finding(node);
    const NodeRecord& record = parts_.common.table.Record(node);
    const bool says_so = (record.state == SlaveState::kOperational) && !record.is_presumed;
    const bool is_silence = !differs && (finding.abort == SdoAbort::kTimeOut) && !says_so;
    const bool has_finding = (slave.status.step == StartUpStep::kSafety) &&
                             ((slave.status.code == kNodeMismatch) || (slave.status.code == kNodeSyntax));
    if (!is_silence || !has_finding)
    {
        slave.status.object = finding.object;
        slave.status.abort = finding.abort;
        slave.status.expected = finding.expected;
        slave.status.read = finding.read;
        slave.cause = differs ? kNodeMismatch : kNodeSyntax;
        slave.held_code = slave.cause;
        Tell(node, slave.cause, StartUpStep::kSafety, now);
    }
    slave.status.is_other = slave.status.is_other || parts_.common.gate.IsOther(node);
    slave.status.is_started = false;
    slave.is_checking = false;
    Stop(node, El6751Event::kRefuse, now);
}

/// Somebody commanded the slave while its start waited: it is read once more. [SRS_ELM_048]
void El6751StartUp::OnStartDropped(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    if ((slave.phase == El6751Phase::kStarting) && slave.is_requested)
    {
        slave.phase = Next(slave.phase, El6751Event::kVerify);
        slave.is_requested = false;
        slave.is_checking = false;
        Tell(node, kNodeStarts, StartUpStep::kSafety, now);
    }
}

void El6751StartUp::DriveStart(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    if (!slave.is_requested)
    {
        pdos_.Await(node);
        const NmtAnswer answer = parts_.common.nmt.Request(NmtCommand::kStart, node, now);
        slave.is_requested = (answer == NmtAnswer::kTaken);
        if (answer == NmtAnswer::kNotVerified)
        {
            slave.phase = Next(slave.phase, El6751Event::kVerify);
        }
    }
    if (slave.is_requested && (parts_.common.table.Record(node).asked == SlaveState::kOperational))
    {
        Run(node, now);
    }
}

} // namespace counterpoint::cia302
