// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/plc_designer/start_up.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kBootUpUs = 2000000U;
constexpr std::uint32_t kSettlingUs = 500000U;
constexpr std::uint32_t kAnswerUs = 500000U;
constexpr ObjectAddress kDeviceType{0x1000U, 0U};
constexpr ObjectAddress kRestoreEntry{0x1011U, 1U};
constexpr std::uint16_t kConciseDcf = 0x1F22U;
constexpr std::uint32_t kLoad = 0x64616F6CU;
constexpr std::uint64_t kProfileMask = 0xFFFFU;
constexpr std::uint32_t kBufferBytes = 4U;
constexpr std::uint8_t kStoppedByte = 4U; ///< As 1F82h reads it.
constexpr std::uint8_t kPreOperationalByte = 127U;

} // namespace

PlcStartUp::PlcStartUp(const PlcParts& parts) noexcept
    : parts_(parts.common), slaves_(parts), reader_(parts.common), release_(parts), master_(0), is_active_(false),
      is_own_asked_(false)
{
}

void PlcStartUp::Begin(const Instant now) noexcept
{
    is_active_ = true;
    is_own_asked_ = false;
    release_.Begin();
    master_ = 0;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        parts_.sdo.Cancel(NodeId{id}, SdoAbort::kGeneral);
        parts_.table.Unwatch(NodeId{id});
        slaves_.Of(NodeId{id}) = PlcNode{};
        slaves_.Of(NodeId{id}).is_listed = parts_.setup.IsListed(NodeId{id});
    }
    parts_.listener.OnMasterState(master_, now);
}

void PlcStartUp::End() noexcept
{
    is_active_ = false;
    master_ = 0;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        parts_.gate.Close(NodeId{id});
        parts_.sdo.Cancel(NodeId{id}, SdoAbort::kGeneral);
        slaves_.Of(NodeId{id}) = PlcNode{};
    }
}

bool PlcStartUp::IsBegun(const NodeId node) const noexcept
{
    return is_active_ && slaves_.Of(node).is_listed && (master_ >= kPlcConfigures);
}

NodeStatus PlcStartUp::Status(const NodeId node) const noexcept
{
    NodeStatus status = slaves_.Of(node).status;
    const bool is_starting = slaves_.Of(node).is_wanted || slaves_.Of(node).is_requested;
    status.is_busy = slaves_.Of(node).is_listed && ((status.code <= kPlcSdos) || is_starting);
    status.is_started = status.is_started && !slaves_.Of(node).is_requested; // [SRS_PLC_800]
    status.is_other = status.is_other || (status.code == kPlcAbsent); // Nobody knows who came later. [SRS_SFS_009]
    return status;
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
            if (slaves_.Of(NodeId{id}).is_listed)
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
        const PlcNode& slave = slaves_.Of(NodeId{id});
        is_done = is_done && (!slave.is_listed || slave.has_sdos || (slave.status.code == kPlcAbsent));
    }
    if (master_ < kPlcConfigures)
    {
        ++master_;
    }
    else if ((master_ == kPlcConfigures) && is_done)
    {
        // This device too is OPERATIONAL then; that goes to nobody, but waits behind what does. [SRS_MGR_152,
        // SRS_PLC_821]
        const NodeId own = parts_.setup.own;
        is_own_asked_ = is_own_asked_ || (parts_.nmt.Request(NmtCommand::kStart, own, now) == NmtAnswer::kTaken);
        master_ = (is_own_asked_ && !parts_.nmt.HasStart(own)) ? kPlcRuns : master_;
    }
    else
    {
        release_.StartAll(now);
    }
    for (std::uint8_t id = 1U; (id <= kLastNode) && (before < kPlcConfigures) && (master_ == kPlcConfigures); ++id)
    {
        if (slaves_.Of(NodeId{id}).is_listed)
        {
            BeginReset(NodeId{id}, now);
        }
    }
    if (master_ != before)
    {
        parts_.listener.OnMasterState(master_, now);
    }
}

/// The start-up of the slave begins again: nothing of the one before goes on, a start that waits neither. The other
/// slaves of a start of all are started singly. [SRS_PLC_820]
void PlcStartUp::Forget(const NodeId node, const Instant now) noexcept
{
    parts_.nmt.DropStarts(node);
    if (parts_.nmt.HasStart(kAllNodes))
    {
        parts_.nmt.DropStarts(kAllNodes);
        release_.OnStartDropped(kAllNodes, now);
    }
    parts_.sdo.Cancel(node, SdoAbort::kGeneral);
    parts_.gate.Close(node);
    parts_.table.Unwatch(node);
}

/// State -1. [SRS_PLC_002]
void PlcStartUp::BeginReset(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    const bool was_reset = slave.was_reset;
    const bool has_sdos = slave.has_sdos;
    const SdoAbort restore_abort = slave.restore_abort;
    const NodeStatus before = slave.status;
    Forget(node, now);
    slave = PlcNode{};
    slave.is_listed = true;
    slave.was_reset = was_reset;
    slave.has_sdos = has_sdos;
    slave.restore_abort = restore_abort;
    slave.status.code = before.code;
    slaves_.Go(node, PlcEvent::kBegin, StartUpStep::kReset, now);
}

/// State 2. [SRS_PLC_003, SRS_PLC_018]
void PlcStartUp::Settle(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    Forget(node, now);
    slave.row = PlcRow::kDeviceType;
    slave.place = ConcisePosition{0U, 0U};
    slave.refused = ObjectAddress{0U, 0U};
    slave.list_abort = SdoAbort::kNone;
    slave.is_transferring = false;
    slave.is_type_wrong = false;
    slave.is_wanted = false;
    slave.is_requested = false;
    slave.is_hold_due = false;
    slave.reading.is_checking = false;
    slave.status.is_started = false;
    slave.status.abort = SdoAbort::kNone;
    slaves_.Go(node, PlcEvent::kSettle, StartUpStep::kSettling, now);
    slave.since = now;
}

void PlcStartUp::Drive(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    const std::uint32_t elapsed_us = now.us - slave.since.us;
    if (slave.is_stop_due)
    {
        slave.is_stop_due = (parts_.nmt.Halt(node, now) != NmtAnswer::kTaken);
    }
    slave.ran_unread = slave.ran_unread || release_.RunsUnread(node);
    FollowHold(node, now);
    switch (slave.status.code)
    {
    case kPlcReset:
        SendReset(node, now);
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
            slaves_.Go(node, PlcEvent::kTimeOver, StartUpStep::kDeviceType, now);
            Ask(node, now);
        }
        break;
    case kPlcSdos:
        DriveSdos(node, now);
        break;
    case kPlcConfigured:
        release_.Follow(node, now);
        release_.Drive(node, now);
        break;
    default:
        break;
    }
    release_.Check(node, now);
}

/// State -1 ends when the reset was sent, which may wait for a long time. [SRS_PLC_801]
void PlcStartUp::SendReset(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    slave.is_requested =
        slave.is_requested || (parts_.nmt.Request(NmtCommand::kResetNode, node, now) == NmtAnswer::kTaken);
    if (slave.is_requested && !parts_.nmt.IsLeaving(node))
    {
        slave.is_requested = false;
        slaves_.Go(node, PlcEvent::kResetSent, StartUpStep::kWaitBootUp, now);
    }
}

/// A slave runs until the command that holds it was sent. [SRS_PLC_802]
void PlcStartUp::FollowHold(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    if (slave.is_hold_due && !parts_.nmt.IsLeaving(node))
    {
        slave.is_hold_due = false;
        slaves_.Go(node, PlcEvent::kHold, StartUpStep::kManual, now);
    }
}

/// The SDOs of state 3: an answer is taken in one cycle, the next request is sent in the following one. [SRS_PLC_011]
void PlcStartUp::DriveSdos(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    const TransferState state = parts_.sdo.State(node);
    const bool is_silent = (slave.row == PlcRow::kDeviceType) && ((now.us - slave.since.us) >= kAnswerUs);
    if (!slave.is_transferring)
    {
        Ask(node, now);
    }
    else if (state == TransferState::kBusy)
    {
        if (is_silent)
        {
            parts_.sdo.Cancel(node, SdoAbort::kTimeOut);
            OnSilence(node, now);
        }
    }
    else
    {
        const SdoOutcome outcome = parts_.sdo.Outcome(node);
        const bool is_answer = (state == TransferState::kDone) || outcome.by_server || IsTooLong(outcome);
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

/// Starts the next SDO, if it can be started now.
void PlcStartUp::Ask(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    const Bytes& list = parts_.setup.Slave(node).concise_dcf;
    const ConciseReading entry = ReadConcise(list, slave.place);
    const bool is_usable = (slave.place.entry > 0U) || IsConcise(list);
    SdoPool& sdo = parts_.sdo;
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

/// A confirmation, an abort, or a device type that is too long to be one. [SRS_PLC_007, SRS_PLC_480]
void PlcStartUp::OnAnswer(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    const SdoOutcome outcome = parts_.sdo.Outcome(node);
    const std::uint32_t expected = parts_.setup.Slave(node).device_type;
    const SdoAbort compared = (expected != 0U) ? SdoAbort::kLengthMismatch : SdoAbort::kNone;
    slave.is_transferring = false;
    slave.status.abort = IsTooLong(outcome) ? compared : outcome.abort;
    parts_.listener.OnNodeStatus(node, now);
    if (slave.row == PlcRow::kDeviceType)
    {
        const std::uint32_t size = (outcome.size_bytes < kBufferBytes) ? outcome.size_bytes : kBufferBytes;
        const std::uint64_t read = cia301::FromLittleEndian(slave.buffer, size);
        const bool is_equal = (read & kProfileMask) == (expected & kProfileMask);
        slave.status.read = read;
        slave.status.expected = expected;
        slave.type_abort = slave.status.abort;
        slave.is_type_wrong = (slave.type_abort != SdoAbort::kNone) || ((expected != 0U) && !is_equal);
        const bool is_reset = slaves_.SetupOf(node).is_reset && !slave.was_reset;
        slave.row = is_reset ? PlcRow::kRestore : PlcRow::kList;
        slaves_.Go(node, PlcEvent::kNone, is_reset ? StartUpStep::kRestore : StartUpStep::kUserObjects, now);
    }
    else if (slave.row == PlcRow::kRestore)
    {
        const bool is_held = slave.is_held;
        slave.was_reset = true;
        slave.restore_abort = outcome.abort;
        BeginReset(node, now);
        slave.is_held = is_held; // This reset is the start-up's own. [SRS_PLC_030]
    }
    else
    {
        if ((outcome.abort != SdoAbort::kNone) && (slave.list_abort == SdoAbort::kNone))
        {
            slave.refused = slave.status.object;
            slave.list_abort = outcome.abort;
        }
        slave.place = ReadConcise(parts_.setup.Slave(node).concise_dcf, slave.place).next;
    }
    const Bytes& list = parts_.setup.Slave(node).concise_dcf;
    if ((slave.row == PlcRow::kList) && (ReadConcise(list, slave.place).state == ConciseState::kEnd))
    {
        release_.Configured(node, now);
    }
}

/// Again, in this cycle; an optional slave is asked once. What was no answer that can be used has its own abort code.
/// [SRS_PLC_005, SRS_PLC_006, SRS_PLC_008]
void PlcStartUp::OnSilence(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    slave.is_transferring = false;
    slave.status.abort = parts_.sdo.Outcome(node).abort;
    if ((slave.row == PlcRow::kDeviceType) && slaves_.SetupOf(node).is_optional && !slave.reading.is_unread)
    {
        slave.signs = parts_.table.Record(node).signs;
        slaves_.Go(node, PlcEvent::kSilence, StartUpStep::kDeviceType, now);
    }
    else
    {
        // One that says that it is STOPPED is made PRE-OPERATIONAL, unless it is held by a command.
        const bool is_deaf = (parts_.table.Record(node).state == SlaveState::kStopped) && !slave.is_held;
        reader_.StopUnread(slave.reading.is_unread, node, slave.reading.is_unread || is_deaf, now);
        Ask(node, now);
    }
}

void PlcStartUp::OnNodeEvent(const NodeId node, const NodeEvent event, const Instant now) noexcept
{
    const bool is_listed = IsBegun(node);
    if (is_listed && (slaves_.Of(node).status.code == kPlcReset) && slaves_.Of(node).is_requested)
    {
        SendReset(node, now); // It may have been sent since the last cycle.
    }
    const std::int16_t state = slaves_.Of(node).status.code;
    const bool is_lost = (event == NodeEvent::kHeartbeatLost) || (event == NodeEvent::kGuardLost);
    const bool is_watched = (state == kPlcConfigured) || (state == kPlcStarted);
    if (is_listed && (event == NodeEvent::kBootUp) && (state != kPlcReset) && (state != kPlcAbsent))
    {
        // One that ran while it waited to be read, and now has to wait again, could so run unread for ever.
        PlcNode& slave = slaves_.Of(node);
        const bool is_cut = slave.ran_unread && ((state == kPlcSettles) || (state == kPlcSdos));
        slave.is_stop_due = slave.is_stop_due || is_cut;
        slave.reading.is_unread = slave.reading.is_unread || is_cut;
        slave.ran_unread = slave.ran_unread && !is_cut;
        Settle(node, now);
    }
    else if (is_listed && is_lost && is_watched)
    {
        parts_.gate.Close(node);
        slaves_.Of(node).is_wanted = false;
        slaves_.Of(node).is_requested = false;
        slaves_.Of(node).is_hold_due = false;
        slaves_.Of(node).status.is_started = false;
        slaves_.Go(node, PlcEvent::kLost, StartUpStep::kErrorControl, now);
    }
    else if (is_listed && (event == NodeEvent::kChanged) && (state == kPlcStarted))
    {
        release_.OnLeft(node);
    }
    else
    {
        // Nothing that a state waits for.
    }
}

void PlcStartUp::OnStartDropped(const NodeId node, const Instant now) noexcept
{
    release_.OnStartDropped(node, now);
}

NmtAnswer PlcStartUp::Command(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    NmtAnswer answer = is_active_ ? NmtAnswer::kTaken : NmtAnswer::kNotActive;
    const bool is_all = (node.value == kAllNodes.value);
    bool is_any = is_all;
    bool has_taken = false;
    if (is_active_ && (node.value == parts_.setup.own.value))
    {
        answer = parts_.nmt.Request(command, node, now);
        is_any = true;
    }
    for (std::uint8_t id = 1U; (id <= kLastNode) && is_active_; ++id)
    {
        if (slaves_.Of(NodeId{id}).is_listed && (is_all || (id == node.value)))
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
    PlcNode& slave = slaves_.Of(node);
    const std::int16_t state = slave.status.code;
    const bool is_start = (command == NmtCommand::kStart);
    const std::uint8_t heard = parts_.table.RequestValue(node);
    const bool is_out = (heard == kStoppedByte) || (heard == kPreOperationalByte) || slave.is_hold_due;
    const bool has_left = (state == kPlcStarted) && is_out;
    NmtAnswer answer = NmtAnswer::kTaken;
    if (is_start && slave.is_requested && (state == kPlcConfigured))
    {
        // Its start waits.
    }
    else if (is_start && ((state == kPlcConfigured) || (state == kPlcLost) || has_left))
    {
        release_.StartByHand(node, now);
    }
    else if (is_start)
    {
        const bool is_other = slave.status.is_other && parts_.setup.IsSafetySlave(node);
        answer = is_other ? NmtAnswer::kOtherDevice : NmtAnswer::kWrong;
        answer = (state == kPlcStarted) ? NmtAnswer::kTaken : answer;
    }
    else
    {
        answer = parts_.nmt.Request(command, node, now);
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
    PlcNode& slave = slaves_.Of(node);
    if ((command == NmtCommand::kResetNode) || (command == NmtCommand::kResetCommunication))
    {
        BeginReset(node, now);
        slave.is_requested = true;
        SendReset(node, now);
    }
    else
    {
        parts_.gate.Close(node);
        slave.is_held = true;
        slave.reading.is_unread = false; // Not woken: this command counts.
        slave.is_wanted = false;
        slave.is_requested = slave.is_requested && (slave.status.code == kPlcReset);
        slave.is_hold_due = true;
        slave.reading.is_checking = false;
        slave.status.is_started = false;
        slave.signs = parts_.table.Record(node).signs;
        FollowHold(node, now);
    }
}

bool PlcStartUp::Boot(const NodeId node, const Instant now) noexcept
{
    const bool is_one = IsBegun(node);
    if (is_one)
    {
        BeginReset(node, now);
    }
    return is_one;
}

/// A slave that is held by a command waits for one.
bool PlcStartUp::Resume(const NodeId node, const Instant now) noexcept
{
    const bool is_one = IsBegun(node);
    if (is_one && !slaves_.Of(node).is_held)
    {
        Settle(node, now);
    }
    return is_one;
}

bool PlcStartUp::Configure(const NodeId node, const Instant now) noexcept
{
    return IsConfigurable(parts_, *this, node) && Boot(node, now);
}

std::int16_t PlcStartUp::MasterState() const noexcept
{
    return master_;
}

} // namespace counterpoint::cia302
