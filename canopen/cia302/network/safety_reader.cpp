// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/network/safety_reader.hpp"

namespace counterpoint::cia302
{
namespace
{

ReadingEnd EndOf(const GateState gate) noexcept
{
    const bool is_refused = (gate == GateState::kDiffers) || (gate == GateState::kFailed);
    const ReadingEnd end = is_refused ? ReadingEnd::kRefused : ReadingEnd::kWaits;
    return (gate == GateState::kOpen) ? ReadingEnd::kOpen : end;
}

} // namespace

SafetyReader::SafetyReader(const StartUpParts& parts) noexcept : parts_(parts)
{
}

ReadingEnd SafetyReader::BeforeStart(SafetyReading& reading, const NodeId node, const bool is_deaf,
                                     const Instant now) noexcept
{
    ReadingEnd end = ReadingEnd::kWaits;
    if (!reading.is_woken && is_deaf)
    {
        reading.is_woken = (parts_.nmt.Request(NmtCommand::kPreOperational, node, now) == NmtAnswer::kTaken);
    }
    else if (!reading.is_asked)
    {
        const bool is_asleep =
            (parts_.nmt.Waiting() > 0U) && (parts_.table.Record(node).asked != SlaveState::kPreOperational);
        reading.is_asked = !reading.is_woken || !is_asleep; // Else the command has not left.
        if (reading.is_asked)
        {
            parts_.gate.Verify(node, now);
            end = ReadingEnd::kBegun;
        }
    }
    else
    {
        end = EndOf(parts_.gate.State(node));
        reading.is_asked = (end != ReadingEnd::kWaits) || (parts_.gate.State(node) == GateState::kBusy);
    }
    return end;
}

ReadingEnd SafetyReader::OfRunning(SafetyReading& reading, const NodeId node, const bool is_suspect,
                                   const Instant now) noexcept
{
    ReadingEnd end = ReadingEnd::kWaits;
    if (reading.is_checking)
    {
        const GateState gate = parts_.gate.State(node);
        end = EndOf(gate);
        reading.is_checking = (gate == GateState::kBusy);
        reading.was_checked = (gate == GateState::kOpen);
    }
    else if (is_suspect)
    {
        reading.is_checking = true;
        parts_.gate.Verify(node, now);
        end = ReadingEnd::kBegun;
    }
    else
    {
        // As it is to be.
    }
    return end;
}

void SafetyReader::StopUnread(bool& is_unread, const NodeId node, const bool is_to_wake, const Instant now) noexcept
{
    const bool is_running = parts_.setup.IsSafetySlave(node) && parts_.table.RunsSurely(node);
    if (is_to_wake || is_running)
    {
        const NmtAnswer answer =
            is_running ? parts_.nmt.Halt(node, now) : parts_.nmt.Request(NmtCommand::kPreOperational, node, now);
        is_unread = (answer == NmtAnswer::kTaken) ? is_running : is_unread;
    }
}

} // namespace counterpoint::cia302
