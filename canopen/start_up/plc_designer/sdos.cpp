// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/plc_designer/sdos.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kAnswerUs = 500000U;
constexpr ObjectAddress kDeviceType{0x1000U, 0U};
constexpr ObjectAddress kRestoreEntry{0x1011U, 1U};
constexpr std::uint16_t kConciseDcf = 0x1F22U;
constexpr std::uint32_t kLoad = 0x64616F6CU;
constexpr std::uint64_t kProfileMask = 0xFFFFU;
constexpr std::uint32_t kBufferBytes = 4U;

} // namespace

PlcSdos::PlcSdos(const PlcParts& parts) noexcept : parts_(parts.common), slaves_(parts), reader_(parts.common)
{
}

PlcSdoEnd PlcSdos::Drive(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    PlcSdoEnd end = PlcSdoEnd::kNone;
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
        const bool is_answer = (state == TransferState::kDone) || outcome.by_server;
        if (is_answer)
        {
            end = OnAnswer(node, now);
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
    return end;
}

void PlcSdos::Ask(const NodeId node, const Instant now) noexcept
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

/// A confirmation or an abort. [SRS_PLC_007]
PlcSdoEnd PlcSdos::OnAnswer(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    const SdoOutcome outcome = parts_.sdo.Outcome(node);
    const std::uint32_t expected = parts_.setup.Slave(node).device_type;
    PlcSdoEnd end = PlcSdoEnd::kNone;
    slave.is_transferring = false;
    slave.status.abort = outcome.abort;
    parts_.listener.OnNodeStatus(node, now);
    if (slave.row == PlcRow::kDeviceType)
    {
        const std::uint32_t size = (outcome.size_bytes < kBufferBytes) ? outcome.size_bytes : kBufferBytes;
        const std::uint64_t read = cia301::FromLittleEndian(slave.buffer, size);
        const bool is_equal = (read & kProfileMask) == (expected & kProfileMask);
        slave.status.read = read;
        slave.status.expected = expected;
        slave.is_type_wrong = (expected != 0U) && ((outcome.abort != SdoAbort::kNone) || !is_equal);
        const bool is_reset = slaves_.SetupOf(node).is_reset && !slave.was_reset;
        slave.row = is_reset ? PlcRow::kRestore : PlcRow::kList;
        slaves_.Go(node, PlcEvent::kNone, is_reset ? StartUpStep::kRestore : StartUpStep::kUserObjects, now);
    }
    else if (slave.row == PlcRow::kRestore)
    {
        slave.was_reset = true;
        end = PlcSdoEnd::kRestored;
    }
    else
    {
        slave.place = ReadConcise(parts_.setup.Slave(node).concise_dcf, slave.place).next;
    }
    const Bytes& list = parts_.setup.Slave(node).concise_dcf;
    const bool is_over = ReadConcise(list, slave.place).state == ConciseState::kEnd;
    return ((slave.row == PlcRow::kList) && is_over) ? PlcSdoEnd::kAll : end;
}

/// Again, in this cycle; an optional slave is asked once. [SRS_PLC_005, SRS_PLC_006, SRS_PLC_008]
void PlcSdos::OnSilence(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    slave.is_transferring = false;
    slave.status.abort = SdoAbort::kTimeOut;
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

} // namespace counterpoint::cia302
