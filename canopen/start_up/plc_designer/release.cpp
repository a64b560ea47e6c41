// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/plc_designer/release.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr ObjectAddress kDeviceType{0x1000U, 0U};
constexpr std::uint8_t kStoppedByte = 4U; ///< As 1F82h reads it.
constexpr std::uint8_t kOperationalByte = 5U;

} // namespace

PlcRelease::PlcRelease(const PlcParts& parts) noexcept
    : parts_(parts.common), slaves_(parts), reader_(parts.common), has_started_all_(false)
{
}

void PlcRelease::Begin() noexcept
{
    has_started_all_ = false;
}

/// The first abort stays, whatever was answered behind it. [SRS_PLC_470]
void PlcRelease::TellRefused(PlcNode& slave) noexcept
{
    constexpr ObjectAddress kRestoreEntry{0x1011U, 1U};
    if (slave.restore_abort != SdoAbort::kNone)
    {
        slave.status.object = kRestoreEntry;
        slave.status.abort = slave.restore_abort;
    }
    else if (slave.list_abort != SdoAbort::kNone)
    {
        slave.status.object = slave.refused;
        slave.status.abort = slave.list_abort;
    }
    else
    {
        // All was confirmed.
    }
}

void PlcRelease::Configured(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    const bool is_automatic = !parts_.setup.Has(kApplicationStartsSlaves);
    slave.has_sdos = true;
    slave.is_wanted = is_automatic && !slave.is_held && !slave.is_type_wrong;
    slave.is_by_hand = false;
    slave.reading.is_asked = false;
    slave.reading.is_woken = false;
    slave.reading.is_unread = false;
    slave.ran_unread = false;
    slave.signs = parts_.table.Record(node).signs;
    slave.status.is_other = slave.is_type_wrong;
    if (slave.is_type_wrong)
    {
        slave.status.object = kDeviceType;
        slave.status.abort = slave.type_abort; // Not that of the SDOs behind it.
        slaves_.Go(node, PlcEvent::kOther, StartUpStep::kDeviceType, now);
    }
    else
    {
        TellRefused(slave);
        parts_.table.WatchAsSetUp(node, now);
        slaves_.Go(node, PlcEvent::kAnswered, StartUpStep::kManual, now);
    }
}

/// It is to be started with all others, for which somebody else is waited for.
/// Of a slave that is wanted, which is in state 4 then.
bool PlcRelease::WaitsForAll(const NodeId node) const noexcept
{
    return !slaves_.Of(node).is_by_hand && parts_.setup.Has(kStartAllAtOnce) && !has_started_all_;
}

void PlcRelease::Follow(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    if (slave.is_requested)
    {
        slave.is_requested = parts_.nmt.IsStarting(node);
        slaves_.Go(node, slave.is_requested ? PlcEvent::kNone : PlcEvent::kStarted,
                   slave.is_requested ? StartUpStep::kStart : StartUpStep::kRunning, now);
    }
}

/// A safety slave is verified first; a STOPPED one has no SDO and is made PRE-OPERATIONAL before.
void PlcRelease::Drive(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    if (slave.is_wanted && !WaitsForAll(node))
    {
        const bool is_safety = parts_.setup.IsSafetySlave(node);
        const bool is_deaf = !slave.reading.is_asked && (parts_.table.RequestValue(node) == kStoppedByte);
        const ReadingEnd end = is_safety ? reader_.BeforeStart(slave.reading, node, is_deaf, now) : ReadingEnd::kOpen;
        if (end == ReadingEnd::kBegun)
        {
            slave.reading.is_checking = false; // This reading serves.
            slaves_.Go(node, PlcEvent::kNone, StartUpStep::kSafety, now);
        }
        else if (end == ReadingEnd::kRefused)
        {
            slave.is_wanted = false;
            Refuse(node, now);
        }
        else if ((end == ReadingEnd::kOpen) && (parts_.nmt.Request(NmtCommand::kStart, node, now) == NmtAnswer::kTaken))
        {
            slave.is_wanted = false;
            slave.is_requested = true;
            slave.status.is_started = true;
            if (is_safety)
            {
                slave.status.ForgetObject(); // It is verified now: what stays is what its start-up found. [SRS_PLC_586]
                TellRefused(slave);
            }
            Follow(node, now);
        }
        else
        {
            // The gate or the queue is waited for.
        }
    }
}

/// It is read from the beginning, and nobody else is waited for.
void PlcRelease::Want(const NodeId node) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    slave.is_wanted = true;
    slave.is_by_hand = true;
    slave.reading.is_asked = false;
    slave.reading.is_woken = false;
    slave.reading.is_checking = false;
}

void PlcRelease::StartByHand(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    const std::uint16_t time_ms = parts_.setup.Slave(node).heartbeat.consumer_ms;
    Want(node);
    slave.is_held = false;
    slave.is_hold_due = false;
    if ((slave.status.code == kPlcLost) && (time_ms > 0U))
    {
        parts_.table.WatchHeartbeat(node, time_ms, Arming::kImmediately, now); // It was there once.
    }
    else
    {
        parts_.table.WatchAsSetUp(node, now);
    }
    slaves_.Go(node, PlcEvent::kStartAgain, StartUpStep::kStart, now);
}

void PlcRelease::OnStartDropped(const NodeId node, const Instant now) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        PlcNode& slave = slaves_.Of(NodeId{id});
        const bool is_meant = (node.value == kAllNodes.value) || (node.value == id);
        if (is_meant && slave.is_requested) // Not for a reset: who is reset has no start that waits. [SRS_PLC_820]
        {
            Want(NodeId{id});
            slave.is_requested = false;
            slave.status.is_started = false;
            slaves_.Go(NodeId{id}, PlcEvent::kNone, StartUpStep::kStart, now);
        }
    }
}

void PlcRelease::Refuse(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    slave.status.Take(parts_.gate.Finding(node));
    const bool is_other = parts_.gate.IsOther(node);
    slave.status.is_other = slave.status.is_other || is_other;
    slave.status.is_started = false;
    slave.is_requested = false; // Its stop takes the place of a start that waits.
    slave.signs = parts_.table.Record(node).signs;
    slave.reading.was_checked = false;
    slave.is_stop_due = (parts_.nmt.Halt(node, now) != NmtAnswer::kTaken);
    slaves_.Go(node, is_other ? PlcEvent::kOther : PlcEvent::kHold, // One that ran was stopped: 4. [SRS_PLC_031]
               is_other ? StartUpStep::kDeviceType : StartUpStep::kSafety, now);
    parts_.listener.OnNodeStatus(node, now);
}

void PlcRelease::Check(const NodeId node, const Instant now) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    const NodeRecord& record = parts_.table.Record(node);
    const GateState gate = parts_.gate.State(node);
    const bool is_free = !slave.is_wanted || WaitsForAll(node);
    const bool is_left = (slave.status.code > kPlcSdos) && is_free && parts_.setup.IsSafetySlave(node);
    const bool is_found =
        is_left && !slave.status.is_started && (record.signs != slave.signs) && parts_.table.IsFoundRunning(node);
    const bool is_refused = (gate == GateState::kDiffers) || (gate == GateState::kFailed);
    const bool is_back = (gate == GateState::kClosed) && parts_.table.RunsSurely(node);
    const bool is_again = is_left && (is_back || (is_refused && slave.status.is_started));
    const bool is_suspect = is_again || (is_found && !slave.reading.was_checked);
    const bool is_at_rest = !is_suspect && !slave.reading.is_checking;
    slave.reading.was_checked = slave.reading.was_checked && (is_found || !is_at_rest);
    if (reader_.OfRunning(slave.reading, node, is_suspect, now) == ReadingEnd::kRefused)
    {
        slave.is_wanted = false;
        Refuse(node, now);
    }
}

/// A safety slave that has left OPERATIONAL can be changed: it is read when it says that it runs again. [SRS_PLC_020]
void PlcRelease::OnLeft(const NodeId node) noexcept
{
    PlcNode& slave = slaves_.Of(node);
    const NodeRecord& record = parts_.table.Record(node);
    const GateState gate = parts_.gate.State(node);
    const bool is_refused = (gate == GateState::kDiffers) || (gate == GateState::kFailed); // Stays to be told.
    if (parts_.setup.IsSafetySlave(node) && (record.state != SlaveState::kOperational))
    {
        if (!is_refused)
        {
            parts_.gate.Close(node);
        }
        slave.status.is_started = false;
        slave.reading.was_checked = false;
        slave.signs = record.signs;
    }
}

bool PlcRelease::RunsUnread(const NodeId node) const noexcept
{
    const bool is_one = parts_.setup.IsSafetySlave(node) && (slaves_.Of(node).status.code >= kPlcSettles);
    const bool is_running = parts_.table.RequestValue(node) == kOperationalByte;
    return is_one && is_running && (parts_.gate.State(node) != GateState::kOpen);
}

/// Once, when nobody is waited for any more. Slaves that must not start forbid the start of all. [SRS_PLC_014]
void PlcRelease::StartAll(const Instant now) noexcept
{
    const bool is_asked =
        parts_.setup.Has(kStartAllAtOnce) && !has_started_all_ && !parts_.setup.Has(kApplicationStartsSlaves);
    bool is_ready = is_asked;
    bool is_one_by_one = parts_.setup.HasSafetySlave();
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const PlcNode& slave = slaves_.Of(NodeId{id});
        const std::int16_t state = slave.status.code;
        const bool is_waiting = (state == kPlcConfigured) && slave.is_wanted;
        is_ready = is_ready && (!slave.is_listed || (state > kPlcSdos));
        const bool is_gone = (state == kPlcAbsent) && !slave.is_held; // One that was stopped does not answer either.
        is_one_by_one = is_one_by_one || (slave.is_listed && !is_waiting && !is_gone);
    }
    if (is_ready && is_one_by_one)
    {
        has_started_all_ = true;
    }
    else if (is_ready && (parts_.nmt.Request(NmtCommand::kStart, kAllNodes, now) == NmtAnswer::kTaken))
    {
        has_started_all_ = true;
        for (std::uint8_t id = 1U; id <= kLastNode; ++id)
        {
            PlcNode& slave = slaves_.Of(NodeId{id});
            if (slave.is_wanted)
            {
                slave.is_wanted = false;
                slave.is_requested = true;
                slave.status.is_started = true;
                Follow(NodeId{id}, now);
            }
        }
    }
    else
    {
        // Somebody is waited for.
    }
}

} // namespace counterpoint::cia302
