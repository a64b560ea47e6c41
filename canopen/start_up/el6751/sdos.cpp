// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/el6751/sdos.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kBufferBytes = 8U;

} // namespace

El6751Sdos::El6751Sdos(El6751Slaves& slaves, El6751Pdos& pdos) noexcept
    : parts_(slaves.Parts()), slaves_(slaves), pdos_(pdos), reader_(slaves.Parts())
{
}

El6751Context El6751Sdos::Context(const NodeId node) const noexcept
{
    return El6751Context{parts_.setup, node, pdos_.IsSyncSent()};
}

void El6751Sdos::Reset(const NodeId node, const Instant now) noexcept
{
    if (parts_.nmt.Request(NmtCommand::kResetCommunication, node, now) == NmtAnswer::kTaken)
    {
        Begin(node, slaves_.Of(node).status.code, now);
    }
}

void El6751Sdos::Begin(const NodeId node, const std::int16_t code, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    parts_.nmt.DropStarts(node); // It is of the start-up before. [SRS_ELM_820]
    parts_.sdo.Cancel(node, SdoAbort::kGeneral);
    parts_.gate.Close(node);
    parts_.table.Unwatch(node);
    pdos_.Rest(node);
    slave.phase = Next(slave.phase, El6751Event::kBegin);
    slave.place = NextRow(Context(node), El6751Place{});
    slave.control_fault = 0;
    slave.has_answered = false;
    slave.is_transferring = false;
    slave.is_requested = false;
    slave.reading = SafetyReading{};
    slave.has_restarted = false;
    slave.is_cut = false;
    slave.status.ForgetObject();
    slave.status.is_started = false;
    slave.status.has_failed = false;
    slave.status.is_other = false;
    slaves_.Tell(node, code, AccessOf(Context(node), slave.place).step, now);
}

bool El6751Sdos::Drive(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    if (slave.is_transferring && (parts_.sdo.State(node) != TransferState::kBusy))
    {
        EndTransfer(node, now);
    }
    // The commands before it, its reset too, have to leave first: they would break it off. [SRS_ELM_770]
    const bool is_early = !slave.has_answered && parts_.nmt.IsLeaving(node);
    const bool is_free = (slave.phase == El6751Phase::kRows) && !slave.is_transferring && !is_early;
    const bool is_over = is_free && (slave.place.row == El6751Row::kEnd);
    if (is_free && !is_over)
    {
        BeginTransfer(node, now);
    }
    return is_over;
}

void El6751Sdos::BeginTransfer(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const El6751Access access = AccessOf(Context(node), slave.place);
    const Bytes& list = parts_.setup.Slave(node).concise_dcf;
    slave.status.object = access.object;
    if ((slave.place.row == El6751Row::kUserObject) && (slave.place.user.entry == 0U) && !IsConcise(list))
    {
        slave.status.object = ObjectAddress{0x1F22U, node.value};
        slave.status.abort = SdoAbort::kNoDictionary;
        Fail(node, kNodeSyntax, now);
    }
    else if (access.is_upload)
    {
        const Room room{slave.buffer, kBufferBytes};
        slave.is_transferring = parts_.sdo.Upload(node, access.object, room, SdoMode::kNormal, now);
    }
    else
    {
        cia301::ToLittleEndian(access.value, slave.buffer, access.size_bytes);
        const Bytes number{slave.buffer, access.size_bytes};
        const Bytes& value = (access.size_bytes > 0U) ? number : access.user;
        slave.is_transferring = parts_.sdo.Download(node, access.object, value, SdoMode::kNormal, now);
    }
    if (slave.is_transferring)
    {
        slaves_.Tell(node, slave.status.code, access.step, now);
    }
}

/// An answer, or none.
void El6751Sdos::EndTransfer(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const El6751Access access = AccessOf(Context(node), slave.place);
    const bool has_end = parts_.sdo.State(node) != TransferState::kIdle;
    El6751Answer answer{parts_.sdo.Outcome(node), 0U, !slave.has_answered};
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
            slaves_.Tell(node, kNodeStarts, access.step, now);
            break;
        case El6751Verdict::kNotFound:
            StopUnread(node, now);
            slaves_.Tell(node, kNodeNotFound, access.step, now);
            break;
        case El6751Verdict::kMismatch:
            slave.status.expected = access.value;
            slave.status.read = answer.read;
            Fail(node, kNodeMismatch, now);
            break;
        case El6751Verdict::kSyntax:
        case El6751Verdict::kInvalid:
        default:
            // Not aborted by anybody: another length. The numbers would not say what is wrong.
            slave.status.abort = ((slave.status.abort == SdoAbort::kNone) || IsTooLong(answer.outcome))
                                     ? SdoAbort::kLengthMismatch
                                     : slave.status.abort;
            Fail(node, kNodeSyntax, now);
            break;
        }
    }
}

/// A safety slave that runs and cannot be read is stopped, and asked on in PRE-OPERATIONAL; so is one that says that it
/// is STOPPED: a command may have come in behind its boot-up message. [SRS_SFS_150, SRS_ELM_003]
void El6751Sdos::StopUnread(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const NodeRecord& heard = parts_.table.Record(node);
    const bool is_ours = slave.reading.is_unread && (heard.asked == SlaveState::kStopped);
    const bool is_deaf = (heard.state == SlaveState::kStopped);
    reader_.StopUnread(slave.reading.is_unread, node, is_ours || is_deaf, now);
}

void El6751Sdos::Fail(const NodeId node, const std::int16_t code, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    slave.phase = Next(slave.phase, El6751Event::kFail);
    slave.status.is_other = (slave.place.row <= El6751Row::kSerialNumber);
    slave.status.has_failed = true;
    slave.cause = code;
    slave.signs = slaves_.SignsBefore(node);
    slaves_.Tell(node, code, AccessOf(Context(node), slave.place).step, now);
}

} // namespace counterpoint::cia302
