// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// NMT commands, own ones and those of others: who obeys, and what they make of permissions.
#include "canopen/manager/manager.hpp"

namespace counterpoint::cia302
{
namespace
{

using cia301::NodeState;

bool IsReset(const NmtCommand command) noexcept
{
    return (command == NmtCommand::kResetNode) || (command == NmtCommand::kResetCommunication);
}

/// Takes a node out of OPERATIONAL without a reset.
bool IsLeave(const NmtCommand command) noexcept
{
    return (command == NmtCommand::kStop) || (command == NmtCommand::kPreOperational);
}

} // namespace

/// Commands of the active master to this device while it is not the master itself. A master is not commanded by
/// others: they show themselves by 071h.
void Manager::OnCommandFrame(const CanFrame& frame, const Instant now) noexcept
{
    constexpr std::uint8_t kCommandBytes = 2U;
    const bool is_command =
        (frame.kind == FrameKind::kData) && (frame.identifier == 0U) && (frame.length_bytes == kCommandBytes);
    const bool is_for_us =
        is_command && ((frame.data[1] == kAllNodes.value) || (frame.data[1] == parts_.setup.own.value));
    if (is_command && IsReset(static_cast<NmtCommand>(frame.data[0])))
    {
        OnReset(NodeId{frame.data[1]});
    }
    if (is_command && IsLeave(static_cast<NmtCommand>(frame.data[0])))
    {
        OnLeave(NodeId{frame.data[1]});
    }
    if (is_command && is_leading_ && (static_cast<NmtCommand>(frame.data[0]) == NmtCommand::kStart))
    {
        OnForeignStart(NodeId{frame.data[1]}, now);
    }
    if (is_for_us && (flying_ != nullptr) && !is_leading_)
    {
        Obey(static_cast<NmtCommand>(frame.data[0]));
    }
}

void Manager::Obey(const NmtCommand command) noexcept
{
    switch (command)
    {
    case NmtCommand::kStart:
        state_ = NodeState::kOperational;
        break;
    case NmtCommand::kStop:
        state_ = NodeState::kStopped;
        break;
    case NmtCommand::kPreOperational:
        state_ = NodeState::kPreOperational;
        break;
    case NmtCommand::kResetNode:
    case NmtCommand::kResetCommunication:
        state_ = NodeState::kPreOperational;
        owes_boot_up_ = true;
        break;
    case NmtCommand::kInvalid:
    default:
        break;
    }
}

/// A reset ends what was verified, at once and not when the slave comes back, and what was suspected: whoever sent it.
/// [SRS_SFS_002]
void Manager::OnReset(const NodeId node) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        if ((node.value == kAllNodes.value) || (node.value == id))
        {
            CloseGate(NodeId{id});
            gate_.Trust(NodeId{id});
            watch_.Forget(NodeId{id});
        }
    }
}

/// Out of OPERATIONAL it can be changed, and be back there before it says so. What was found before stays to be told.
/// [SRS_SFS_002]
void Manager::OnLeave(const NodeId node) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const GateState gate = gate_.State(NodeId{id});
        const bool is_hit = (node.value == kAllNodes.value) || (node.value == id);
        if (is_hit && ((gate == GateState::kOpen) || (gate == GateState::kBusy)))
        {
            CloseGate(NodeId{id});
        }
    }
}

/// What was read of a safety slave before holds no more, and what is being read begins anew.
void Manager::ReadAnew(const NodeId node) noexcept
{
    gate_.Renew(node);
    if (gate_.State(node) == GateState::kOpen)
    {
        CloseGate(node);
    }
}

/// Somebody else starts safety slaves. What this device has verified and started runs already; all others that were
/// there last are taken to run, whether or not they say so by any error control, and so are read. [SRS_SFS_006]
void Manager::OnForeignStart(const NodeId node, const Instant now) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId slave{id};
        const SlaveState state = table_.Record(slave).state;
        const GateState gate = gate_.State(slave);
        const bool is_started = profile_->Status(slave).is_started;
        const bool is_hit = (node.value == kAllNodes.value) || (node.value == id);
        const bool was_there = (state != SlaveState::kUnknown) || is_started || (gate == GateState::kDiffers);
        const bool has_left = (table_.Record(slave).asked == SlaveState::kOperational); // The start of this device.
        const bool is_ours = is_started && has_left && (gate == GateState::kOpen);
        if (is_hit && parts_.setup.IsSafetySlave(slave) && was_there && !is_ours)
        {
            ReadAnew(slave); // It may have been changed since it was read.
            table_.Presume(slave, now);
        }
    }
}

/// Whatever was on the bus meanwhile: who runs is read again, what is being read from the beginning, and who does not
/// run any more has booted. [SRS_SFS_002, SRS_NMM_020]
void Manager::OnLost(const Instant now) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId slave{id};
        gate_.Renew(slave);
        if (is_leading_)
        {
            table_.Miss(slave);
        }
        if (is_leading_ && parts_.setup.IsSafetySlave(slave) && (gate_.State(slave) == GateState::kOpen))
        {
            const NodeRecord& record = table_.Record(slave);
            const bool has_left = (record.asked == SlaveState::kOperational); // The start. Else it is given up.
            const bool is_started = profile_->Status(slave).is_started && has_left;
            CloseGate(slave);
            if (is_started || (record.state == SlaveState::kOperational))
            {
                table_.Presume(slave, now);
            }
        }
    }
}

/// [SRS_SFS_002]
void Manager::OnStartDropped(const NodeId node, const Instant now) noexcept
{
    if (is_leading_)
    {
        if (gate_.State(node) == GateState::kOpen)
        {
            CloseGate(node);
        }
        profile_->OnStartDropped(node, now);
    }
}

void Manager::OnNmtSent(const NmtRequest& request, const Instant now) noexcept
{
    const bool is_all = (request.node.value == kAllNodes.value);
    if (IsReset(request.command))
    {
        OnReset(request.node);
    }
    if (IsLeave(request.command))
    {
        OnLeave(request.node);
    }
    if (is_all || (request.node.value == parts_.setup.own.value))
    {
        Obey(request.command);
    }
    // Not here: the queue of commands is being worked through.
    is_to_reset_ =
        is_to_reset_ || (!is_all && IsReset(request.command) && (request.node.value == parts_.setup.own.value));
    parts_.listener.OnNmtSent(request, now);
}

} // namespace counterpoint::cia302
