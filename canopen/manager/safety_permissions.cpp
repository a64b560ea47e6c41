// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/manager/safety_permissions.hpp"

namespace counterpoint::cia302
{

SafetyPermissions::SafetyPermissions(const NetworkSetup& setup, GateState* const told, SafetyGate& gate,
                                     NodeTable& table) noexcept
    : setup_(setup), told_(told), gate_(gate), table_(table)
{
}

void SafetyPermissions::Close(const NodeId node) noexcept
{
    if (setup_.IsSafetySlave(node))
    {
        gate_.Close(node);
    }
}

/// A reset ends what was verified, at once and not when the slave comes back, and what was suspected: whoever sent it.
/// [SRS_SFS_002]
void SafetyPermissions::OnReset(const NodeId node) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        if ((node.value == kAllNodes.value) || (node.value == id))
        {
            Close(NodeId{id});
            gate_.Trust(NodeId{id});
        }
    }
}

/// Out of OPERATIONAL it can be changed, and be back there before it says so. What was found before stays to be told.
/// [SRS_SFS_002]
void SafetyPermissions::OnLeave(const NodeId node) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const GateState gate = gate_.State(NodeId{id});
        const bool is_hit = (node.value == kAllNodes.value) || (node.value == id);
        if (is_hit && ((gate == GateState::kOpen) || (gate == GateState::kBusy)))
        {
            Close(NodeId{id});
        }
    }
}

/// What was read of a safety slave before holds no more, and what is being read begins anew.
void SafetyPermissions::ReadAnew(const NodeId node) noexcept
{
    gate_.Renew(node);
    if (gate_.State(node) == GateState::kOpen)
    {
        Close(node);
    }
}

/// Somebody else starts safety slaves. What this device has verified and started runs already; all others that were
/// there last are taken to run, whether or not they say so by any error control, and so are read. [SRS_SFS_006]
void SafetyPermissions::OnForeignStart(const NodeId node, const StartUp& profile, const Instant now) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId slave{id};
        const SlaveState state = table_.Record(slave).state;
        const GateState gate = gate_.State(slave);
        const bool is_started = profile.Status(slave).is_started;
        const bool is_hit = (node.value == kAllNodes.value) || (node.value == id);
        const bool was_there = (state != SlaveState::kUnknown) || is_started || (gate == GateState::kDiffers);
        const bool has_left = (table_.Record(slave).asked == SlaveState::kOperational); // The start of this device.
        const bool is_ours = is_started && has_left && (gate == GateState::kOpen);
        if (is_hit && setup_.IsSafetySlave(slave) && was_there && !is_ours)
        {
            ReadAnew(slave); // It may have been changed since it was read.
            table_.Presume(slave, now);
        }
    }
}

/// Whatever was on the bus meanwhile: who runs is read again, what is being read from the beginning, and who does not
/// run any more has booted. [SRS_SFS_002, SRS_NMM_020]
void SafetyPermissions::OnLost(const StartUp* const profile, const Instant now) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId slave{id};
        gate_.Renew(slave);
        if (profile != nullptr)
        {
            table_.Miss(slave);
        }
        if ((profile != nullptr) && setup_.IsSafetySlave(slave) && (gate_.State(slave) == GateState::kOpen))
        {
            const NodeRecord& record = table_.Record(slave);
            const bool has_left = (record.asked == SlaveState::kOperational); // The start. Else it is given up.
            const bool is_started = profile->Status(slave).is_started && has_left;
            Close(slave);
            if (is_started || (record.state == SlaveState::kOperational))
            {
                table_.Presume(slave, now);
            }
        }
    }
}

void SafetyPermissions::OnStartDropped(const NodeId node) noexcept
{
    if (gate_.State(node) == GateState::kOpen)
    {
        Close(node);
    }
}

void SafetyPermissions::Tell(ManagerListener& listener, const Instant now) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        const GateState gate = gate_.State(node);
        if (setup_.IsSafetySlave(node) && (gate != told_[id]))
        {
            told_[id] = gate;
            listener.OnGate(node, gate, now);
        }
    }
}

} // namespace counterpoint::cia302
