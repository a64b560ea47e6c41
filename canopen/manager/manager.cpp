// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/manager/manager.hpp"

namespace counterpoint::cia302
{
namespace
{

using cia301::NodeState;

} // namespace

Manager::Manager(const ManagerParts& parts) noexcept
    : parts_(parts), sdo_(parts.room.lanes, parts.room.times),
      table_(NodeTableParts{parts.room.records, parts_.setup, parts_.sink, *this}),
      gate_(parts_.setup, parts.room.safety, sdo_),
      nmt_(NmtMasterParts{parts_.setup, parts.room.commands, parts_.sink, table_, *this, gate_}),
      watch_(parts_.setup, parts.room.watched, *this), producer_(parts_.setup.own), profile_(nullptr), flying_(nullptr),
      negotiation_(NegotiationBy::kManager), state_(NodeState::kInitialising), is_running_(false), is_leading_(false),
      owes_boot_up_(false), is_to_start_(false), is_refused_(false), is_off_bus_(false), is_to_reset_(false)
{
    producer_.SetPeriod(parts.heartbeat_ms);
}

StartUpParts Manager::ProfileParts() noexcept
{
    return StartUpParts{parts_.setup, table_, nmt_, sdo_, gate_, parts_.sink, *this};
}

void Manager::Use(StartUp& profile) noexcept
{
    profile_ = &profile;
    gate_.Use(profile.Identity());
}

void Manager::Use(FlyingMaster& flying, const NegotiationBy by) noexcept
{
    flying_ = &flying;
    negotiation_ = by;
}

void Manager::Begin(const Instant now) noexcept
{
    is_running_ = (profile_ != nullptr);
    if (is_running_)
    {
        state_ = NodeState::kPreOperational;
        owes_boot_up_ = true;
        is_to_start_ = (flying_ != nullptr) && (negotiation_ == NegotiationBy::kManager);
        SendOwn(now);
        if (flying_ == nullptr)
        {
            Lead(true, now);
        }
        else
        {
            parts_.listener.OnInitialising(now);
        }
    }
}

void Manager::End() noexcept
{
    if (is_running_)
    {
        profile_->End();
        nmt_.SetActive(false);
    }
    is_leading_ = false;
    is_running_ = false;
}

/// Without a flying master it leads from the beginning; with one the negotiation says so. [SRS_MGR_002]
void Manager::Lead(const bool is_leader, const Instant now) noexcept
{
    if (is_leader && !is_leading_)
    {
        is_leading_ = true;
        nmt_.SetActive(true);
        profile_->Begin(now);
    }
    else if (!is_leader && is_leading_)
    {
        is_leading_ = false;
        profile_->End();
        nmt_.SetActive(false);
        UnwatchAll();
    }
    else
    {
        // As before.
    }
}

/// Nobody but the active master guards, and what was watched in another role counts no more.
void Manager::UnwatchAll() noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        table_.Unwatch(NodeId{id});
    }
}

void Manager::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    if (is_running_)
    {
        if (flying_ != nullptr)
        {
            flying_->OnFrame(frame, now);
            FollowRole(now);
        }
        OnCommandFrame(frame, now);
        CountHeartbeats(frame);
        watch_.OnFrame(frame, now);
        table_.OnFrame(frame, now);
        sdo_.OnFrame(frame, now);
        profile_->OnFrame(frame, now);
    }
}

/// A slave that was not started up since it booted sends heartbeats by a time of its own. [SRS_MGR_010]
void Manager::CountHeartbeats(const CanFrame& frame) noexcept
{
    constexpr std::uint32_t kErrorControl = 0x700U;
    const NodeId node{static_cast<std::uint8_t>(frame.identifier & kLastNode)};
    const bool is_sign = ((frame.identifier & ~std::uint32_t{kLastNode}) == kErrorControl) && (node.value != 0U);
    if (is_sign && parts_.setup.IsListed(node))
    {
        const NodeStatus status = Status(node);
        const bool is_set_up = status.is_started || (table_.Record(node).watch != Watch::kNone);
        if (!is_set_up || status.is_other)
        {
            watch_.CountAnew(node);
        }
    }
}

void Manager::OnCycle(const Instant now) noexcept
{
    if (is_running_)
    {
        ResetRole(now);
        if (is_to_start_ && !is_off_bus_)
        {
            TryNegotiation(now);
        }
        if (flying_ != nullptr)
        {
            flying_->OnCycle(now);
            FollowRole(now);
        }
        SendOwn(now);
        watch_.OnCycle(now);
        table_.OnCycle(now);
        sdo_.OnCycle(now);
        gate_.OnCycle(now);
        TellGates(now);
        profile_->OnCycle(now);
        nmt_.OnCycle(now);
    }
}

bool Manager::IsInitialising() const noexcept
{
    return (flying_ != nullptr) && flying_->IsInitialising();
}

/// Boot-up message and heartbeat of this device. What the sink does not take comes in a later cycle.
void Manager::SendOwn(const Instant now) noexcept
{
    if (!IsInitialising() && owes_boot_up_)
    {
        owes_boot_up_ = !parts_.sink.Send(cia301::ErrorControlFrame(parts_.setup.own, 0U));
    }
    else if (!IsInitialising())
    {
        const cia301::FrameToSend heartbeat = producer_.Poll(state_, now);
        if (heartbeat.is_present)
        {
            static_cast<void>(parts_.sink.Send(heartbeat.frame)); // The next one is as good.
        }
    }
    else
    {
        // Nobody is to take this device for one that is there. Whoever leaves INITIALISATION says so. [SRS_FLY_028]
        state_ = NodeState::kPreOperational;
        owes_boot_up_ = true;
    }
}

NmtAnswer Manager::Command(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    return is_leading_ ? profile_->Command(command, node, now) : NmtAnswer::kNotActive;
}

bool Manager::Boot(const NodeId node, const Instant now) noexcept
{
    return is_leading_ && profile_->Boot(node, now);
}

bool Manager::Resume(const NodeId node, const Instant now) noexcept
{
    return is_leading_ && profile_->Resume(node, now);
}

bool Manager::WriteSafety(const NodeId node, const Instant now) noexcept
{
    const NodeStatus status = Status(node);
    const bool is_running = table_.RequestValue(node) == static_cast<std::uint8_t>(SlaveState::kOperational);
    const bool is_free = is_leading_ && !is_running && !status.is_other && !status.is_busy && (nmt_.Waiting() == 0U) &&
                         (gate_.State(node) != GateState::kBusy);
    if (is_free && (table_.Record(node).asked == SlaveState::kStopped))
    {
        // STOPPED, it has no SDO to be written by. Where the command has to wait, the next call goes on.
        static_cast<void>(nmt_.Request(NmtCommand::kPreOperational, node, now));
    }
    return is_free && (nmt_.Waiting() == 0U) && gate_.Write(node, now);
}

void Manager::TellGates(const Instant now) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        if (parts_.setup.IsSafetySlave(node) && (gate_.State(node) != parts_.room.gates[id]))
        {
            parts_.room.gates[id] = gate_.State(node);
            parts_.listener.OnGate(node, parts_.room.gates[id], now);
        }
    }
}

void Manager::CloseGate(const NodeId node) noexcept
{
    if (parts_.setup.IsSafetySlave(node))
    {
        gate_.Close(node);
    }
}

void Manager::OnNodeEvent(const NodeId node, const NodeEvent event, const Instant now) noexcept
{
    const bool is_boot_up = (event == NodeEvent::kBootUp);
    const bool is_lost = (event == NodeEvent::kHeartbeatLost) || (event == NodeEvent::kGuardLost);
    if (is_boot_up)
    {
        sdo_.OnBootUp(node);
    }
    if (is_boot_up || is_lost || (event == NodeEvent::kToggleError))
    {
        CloseGate(node);
    }
    parts_.listener.OnNodeEvent(node, event, now);
    if ((flying_ != nullptr) && is_lost)
    {
        flying_->OnHeartbeatLost(node, now);
    }
    if (is_leading_)
    {
        profile_->OnNodeEvent(node, event, now);
    }
}

void Manager::OnNodeStatus(const NodeId node, const Instant now) noexcept
{
    parts_.listener.OnNodeStatus(node, now);
}

void Manager::OnMasterState(const std::int16_t state, const Instant now) noexcept
{
    parts_.listener.OnMasterState(state, now);
}

void Manager::OnEmergency(const NodeId node, const EmergencyRecord& emergency, const Instant now) noexcept
{
    parts_.listener.OnEmergency(node, emergency, now);
}

/// What a device says that may be two is worth nothing. [SRS_MGR_010]
void Manager::OnDuplicate(const NodeId node, const Instant now) noexcept
{
    gate_.Doubt(node);
    parts_.listener.OnDuplicate(node, now);
}

NodeState Manager::OwnState() const noexcept
{
    return IsInitialising() ? NodeState::kInitialising : state_;
}

NodeStatus Manager::Status(const NodeId node) const noexcept
{
    return (profile_ != nullptr) ? profile_->Status(node) : NodeStatus{};
}

std::int16_t Manager::MasterState() const noexcept
{
    return (profile_ != nullptr) ? profile_->MasterState() : std::int16_t{0};
}

} // namespace counterpoint::cia302
