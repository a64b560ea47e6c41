// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// States of master and slaves up to 4. Start and commands are in a file of their own.
#include "canopen/start_up/plc_designer/start_up.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr PlcSlave kPlainSlave{};
constexpr std::uint32_t kBootUpUs = 2000000U;
constexpr std::uint32_t kSettlingUs = 500000U;
constexpr std::uint32_t kAnswerUs = 500000U;
constexpr ObjectAddress kDeviceType{0x1000U, 0U};
constexpr ObjectAddress kRestoreEntry{0x1011U, 1U};
constexpr std::uint16_t kConciseDcf = 0x1F22U;
constexpr std::uint32_t kLoad = 0x64616F6CU;
constexpr std::uint64_t kProfileMask = 0xFFFFU;
constexpr std::uint32_t kBufferBytes = 4U;

} // namespace

PlcStartUp::PlcStartUp(const PlcParts& parts) noexcept
    : parts_(parts), master_(0), is_active_(false), has_started_all_(false)
{
}

void PlcStartUp::Begin(const Instant now) noexcept
{
    is_active_ = true;
    has_started_all_ = false;
    master_ = 0;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        parts_.common.sdo.Cancel(NodeId{id}, SdoAbort::kGeneral);
        parts_.common.table.Unwatch(NodeId{id});
        Of(NodeId{id}) = PlcNode{};
        Of(NodeId{id}).is_listed = parts_.common.setup.IsListed(NodeId{id});
    }
    parts_.common.listener.OnMasterState(master_, now);
}

void PlcStartUp::End() noexcept
{
    is_active_ = false;
    master_ = 0;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        parts_.common.sdo.Cancel(NodeId{id}, SdoAbort::kGeneral);
        Of(NodeId{id}) = PlcNode{};
    }
}

PlcNode& PlcStartUp::Of(const NodeId node) const noexcept
{
    return parts_.nodes[node.value & kLastNode];
}

const PlcSlave& PlcStartUp::SetupOf(const NodeId node) const noexcept
{
    const PlcSlave* const slave = parts_.common.setup.Slave(node).plc;
    return (slave != nullptr) ? *slave : kPlainSlave;
}

NodeStatus PlcStartUp::Status(const NodeId node) const noexcept
{
    NodeStatus status = Of(node).status;
    status.is_busy = Of(node).is_listed && ((status.code <= kPlcSdos) || Of(node).is_wanted);
    status.is_other = status.is_other || (status.code == kPlcAbsent); // Nobody knows who came later. [SRS_SFS_009]
    return status;
}

/// The next state, and what is told of it.
void PlcStartUp::Go(const NodeId node, const PlcEvent event, const StartUpStep step, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    const std::int16_t state = Next(slave.status.code, event);
    const bool has_changed = (slave.status.code != state) || (slave.status.step != step);
    slave.since = (slave.status.code != state) ? now : slave.since;
    slave.status.code = state;
    slave.status.step = step;
    if (has_changed)
    {
        parts_.common.listener.OnNodeStatus(node, now);
    }
}

void PlcStartUp::OnFrame(const CanFrame&, const Instant) noexcept
{
    // All that it waits for comes by table and SDO pool.
}

void PlcStartUp::OnCycle(const Instant now) noexcept
{
    if (is_active_)
    {
        for (std::uint8_t id = 1U; (id <= kLastNode) && (master_ >= kPlcConfigures); ++id)
        {
            if (Of(NodeId{id}).is_listed)
            {
                Drive(NodeId{id}, now);
            }
        }
        DriveMaster(now);
    }
}

/// [SRS_PLC_001, SRS_PLC_009, SRS_PLC_010]
void PlcStartUp::DriveMaster(const Instant now) noexcept
{
    const std::int16_t before = master_;
    bool is_done = true;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const PlcNode& slave = Of(NodeId{id});
        is_done = is_done && (!slave.is_listed || slave.has_sdos || (slave.status.code == kPlcAbsent));
    }
    if (master_ < kPlcConfigures)
    {
        ++master_;
    }
    else if ((master_ == kPlcConfigures) && is_done)
    {
        // This device too is OPERATIONAL then; that goes to nobody. [SRS_MGR_020]
        const NodeId own = parts_.common.setup.own;
        const NmtAnswer answer = parts_.common.nmt.Request(NmtCommand::kStart, own, now);
        master_ = (answer == NmtAnswer::kTaken) ? kPlcRuns : master_;
    }
    else
    {
        StartAll(now);
    }
    for (std::uint8_t id = 1U; (id <= kLastNode) && (before < kPlcConfigures) && (master_ == kPlcConfigures); ++id)
    {
        if (Of(NodeId{id}).is_listed)
        {
            BeginReset(NodeId{id}, now);
        }
    }
    if (master_ != before)
    {
        parts_.common.listener.OnMasterState(master_, now);
    }
}

/// State -1. [SRS_PLC_002]
void PlcStartUp::BeginReset(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    const bool was_reset = slave.was_reset;
    const bool has_sdos = slave.has_sdos;
    const NodeStatus before = slave.status;
    parts_.common.sdo.Cancel(node, SdoAbort::kGeneral);
    parts_.common.gate.Close(node);
    parts_.common.table.Unwatch(node);
    slave = PlcNode{};
    slave.is_listed = true;
    slave.was_reset = was_reset;
    slave.has_sdos = has_sdos;
    slave.status.code = before.code;
    Go(node, PlcEvent::kBegin, StartUpStep::kReset, now);
}

/// State 2. [SRS_PLC_003, SRS_PLC_018]
void PlcStartUp::Settle(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    parts_.common.sdo.Cancel(node, SdoAbort::kGeneral);
    parts_.common.gate.Close(node);
    parts_.common.table.Unwatch(node);
    slave.row = PlcRow::kDeviceType;
    slave.place = ConcisePosition{0U, 0U};
    slave.is_transferring = false;
    slave.is_type_wrong = false;
    slave.is_wanted = false;
    slave.is_checking = false;
    slave.status.is_started = false;
    slave.status.abort = SdoAbort::kNone;
    Go(node, PlcEvent::kSettle, StartUpStep::kSettling, now);
    slave.since = now;
}

void PlcStartUp::Drive(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    const std::uint32_t elapsed_us = now.us - slave.since.us;
    if (slave.is_stop_due)
    {
        slave.is_stop_due = (parts_.common.nmt.Request(NmtCommand::kStop, node, now) != NmtAnswer::kTaken);
    }
    slave.ran_unread = slave.ran_unread || RunsUnread(node);
    switch (slave.status.code)
    {
    case kPlcReset:
        if (parts_.common.nmt.Request(NmtCommand::kResetNode, node, now) == NmtAnswer::kTaken)
        {
            Go(node, PlcEvent::kResetSent, StartUpStep::kWaitBootUp, now);
        }
        break;
    case kPlcBootUp:
        if (elapsed_us >= kBootUpUs)
        {
            Settle(node, now);
        }
        break;
    case kPlcSettles:
        if (elapsed_us >= kSettlingUs)
        {
            Go(node, PlcEvent::kTimeOver, StartUpStep::kDeviceType, now);
            Ask(node, now);
        }
        break;
    case kPlcSdos:
        DriveSdos(node, now);
        break;
    case kPlcConfigured:
        DriveStart(node, now);
        break;
    default:
        break;
    }
    DriveCheck(node, now);
}

void PlcStartUp::OnNodeEvent(const NodeId node, const NodeEvent event, const Instant now) noexcept
{
    const std::int16_t state = Of(node).status.code;
    const bool is_listed = is_active_ && Of(node).is_listed && (master_ >= kPlcConfigures);
    const bool is_lost = (event == NodeEvent::kHeartbeatLost) || (event == NodeEvent::kGuardLost);
    const bool is_watched = (state == kPlcConfigured) || (state == kPlcStarted);
    if (is_listed && (event == NodeEvent::kBootUp) && (state != kPlcReset) && (state != kPlcAbsent))
    {
        // One that ran while it waited to be read, and now has to wait again, could so run unread for ever.
        const bool is_cut = Of(node).ran_unread && ((state == kPlcSettles) || (state == kPlcSdos));
        Of(node).is_stop_due = Of(node).is_stop_due || is_cut;
        Of(node).is_unread = Of(node).is_unread || is_cut;
        Of(node).ran_unread = Of(node).ran_unread && !is_cut;
        Settle(node, now);
    }
    else if (is_listed && is_lost && is_watched)
    {
        parts_.common.gate.Close(node);
        Of(node).is_wanted = false;
        Of(node).status.is_started = false;
        Go(node, PlcEvent::kLost, StartUpStep::kErrorControl, now);
    }
    else if (is_listed && (event == NodeEvent::kChanged) && (state == kPlcStarted))
    {
        OnLeft(node);
    }
    else
    {
        // Nothing that a state waits for.
    }
}

/// One SDO a cycle: an answer is taken in one, the next request goes in the following one.
void PlcStartUp::DriveSdos(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    const TransferState state = parts_.common.sdo.State(node);
    const bool is_silent = (slave.row == PlcRow::kDeviceType) && ((now.us - slave.since.us) >= kAnswerUs);
    if (!slave.is_transferring)
    {
        Ask(node, now);
    }
    else if (state == TransferState::kBusy)
    {
        if (is_silent)
        {
            parts_.common.sdo.Cancel(node, SdoAbort::kTimeOut);
            OnSilence(node, now);
        }
    }
    else
    {
        const SdoOutcome outcome = parts_.common.sdo.Outcome(node);
        const bool is_answer = (state == TransferState::kDone) || outcome.by_server;
        if (is_answer)
        {
            OnAnswer(node, now);
        }
        else if (is_silent || (slave.row != PlcRow::kDeviceType))
        {
            OnSilence(node, now);
        }
        else
        {
            // The pool gave up before the half second was over.
        }
    }
}

void PlcStartUp::Ask(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    const Bytes& list = parts_.common.setup.Slave(node).concise_dcf;
    const ConciseReading entry = ReadConcise(list, slave.place);
    const bool is_usable = (slave.place.entry > 0U) || IsConcise(list);
    SdoPool& sdo = parts_.common.sdo;
    slave.since = now;
    if (slave.row == PlcRow::kDeviceType)
    {
        slave.status.object = kDeviceType;
        slave.is_transferring = sdo.Upload(node, kDeviceType, Room{slave.buffer, kBufferBytes}, SdoMode::kNormal, now);
        if (slave.is_transferring)
        {
            sdo.TryOnce(node); // Half a second is this profile's own, and an optional slave is asked once.
        }
    }
    else if (slave.row == PlcRow::kRestore)
    {
        cia301::ToLittleEndian(kLoad, slave.buffer, kBufferBytes);
        slave.status.object = kRestoreEntry;
        slave.is_transferring =
            sdo.Download(node, kRestoreEntry, Bytes{slave.buffer, kBufferBytes}, SdoMode::kNormal, now);
    }
    else if (is_usable && (entry.state == ConciseState::kEntry))
    {
        slave.status.object = entry.object;
        slave.is_transferring = sdo.Download(node, entry.object, entry.value, SdoMode::kNormal, now);
    }
    else
    {
        slave.status.object = ObjectAddress{kConciseDcf, node.value}; // It has no end: the slave stays in state 3.
    }
}

/// A confirmation or an abort. [SRS_PLC_007]
void PlcStartUp::OnAnswer(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    const SdoOutcome outcome = parts_.common.sdo.Outcome(node);
    const std::uint32_t expected = parts_.common.setup.Slave(node).device_type;
    slave.is_transferring = false;
    slave.status.abort = outcome.abort;
    parts_.common.listener.OnNodeStatus(node, now);
    if (slave.row == PlcRow::kDeviceType)
    {
        const std::uint32_t size = (outcome.size_bytes < kBufferBytes) ? outcome.size_bytes : kBufferBytes;
        const std::uint64_t read = cia301::FromLittleEndian(slave.buffer, size);
        const bool is_equal = (read & kProfileMask) == (expected & kProfileMask);
        slave.status.read = read;
        slave.status.expected = expected;
        slave.is_type_wrong = (expected != 0U) && ((outcome.abort != SdoAbort::kNone) || !is_equal);
        const bool is_reset = SetupOf(node).is_reset && !slave.was_reset;
        slave.row = is_reset ? PlcRow::kRestore : PlcRow::kList;
        Go(node, PlcEvent::kNone, is_reset ? StartUpStep::kRestore : StartUpStep::kUserObjects, now);
    }
    else if (slave.row == PlcRow::kRestore)
    {
        slave.was_reset = true;
        BeginReset(node, now);
    }
    else
    {
        slave.place = ReadConcise(parts_.common.setup.Slave(node).concise_dcf, slave.place).next;
    }
    const Bytes& list = parts_.common.setup.Slave(node).concise_dcf;
    const bool is_over = ReadConcise(list, slave.place).state == ConciseState::kEnd;
    if ((slave.status.code == kPlcSdos) && (slave.row == PlcRow::kList) && is_over)
    {
        EndSdos(node, now);
    }
}

/// Again, in this cycle; an optional slave is asked once. [SRS_PLC_005, SRS_PLC_006, SRS_PLC_008]
void PlcStartUp::OnSilence(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    slave.is_transferring = false;
    slave.status.abort = SdoAbort::kTimeOut;
    if ((slave.row == PlcRow::kDeviceType) && SetupOf(node).is_optional && !slave.is_unread)
    {
        slave.signs = parts_.common.table.Record(node).signs;
        Go(node, PlcEvent::kSilence, StartUpStep::kDeviceType, now);
    }
    else
    {
        StopUnread(node, now);
        Ask(node, now);
    }
}

} // namespace counterpoint::cia302
