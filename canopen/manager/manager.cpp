// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
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

Manager::Manager(const ManagerParts& parts) noexcept
    : parts_(parts), sdo_(parts.room.lanes, parts.room.times),
      table_(NodeTableParts{parts.room.records, parts_.setup, parts_.sink, *this}),
      gate_(parts_.setup, parts.room.safety, sdo_),
      nmt_(NmtMasterParts{parts_.setup, parts.room.commands, parts_.sink, table_, *this, gate_}),
      watch_(parts_.setup, parts.room.watched, *this), own_(parts_.setup.own, parts_.sink, parts.heartbeat_ms),
      permissions_(parts_.setup, gate_, table_), profile_(nullptr), flying_(nullptr),
      negotiation_(NegotiationBy::kManager), is_running_(false), is_leading_(false), is_to_start_(false),
      is_refused_(false), is_off_bus_(false), is_to_reset_(false)
{
}

StartUpParts Manager::ProfileParts() noexcept
{
    return StartUpParts{parts_.setup, table_, nmt_, sdo_, gate_, parts_.sink, parts_.listener};
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
        own_.Restart();
        is_to_start_ = (flying_ != nullptr) && (negotiation_ == NegotiationBy::kManager);
        own_.Send(IsInitialising(), now);
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
        own_.Send(IsInitialising(), now);
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
        permissions_.Close(node);
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
    return IsInitialising() ? NodeState::kInitialising : own_.State();
}

NodeStatus Manager::Status(const NodeId node) const noexcept
{
    return (profile_ != nullptr) ? profile_->Status(node) : NodeStatus{};
}

std::int16_t Manager::MasterState() const noexcept
{
    return (profile_ != nullptr) ? profile_->MasterState() : std::int16_t{0};
}

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
        permissions_.OnLeave(NodeId{frame.data[1]});
    }
    if (is_command && is_leading_ && (static_cast<NmtCommand>(frame.data[0]) == NmtCommand::kStart))
    {
        permissions_.OnForeignStart(NodeId{frame.data[1]}, *profile_, now);
    }
    if (is_for_us && (flying_ != nullptr) && !is_leading_)
    {
        own_.Obey(static_cast<NmtCommand>(frame.data[0]));
    }
}

/// [SRS_SFS_002]
void Manager::OnStartDropped(const NodeId node, const Instant now) noexcept
{
    if (is_leading_)
    {
        permissions_.OnStartDropped(node);
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
        permissions_.OnLeave(request.node);
    }
    if (is_all || (request.node.value == parts_.setup.own.value))
    {
        own_.Obey(request.command);
    }
    // Not here: the queue of commands is being worked through.
    is_to_reset_ =
        is_to_reset_ || (!is_all && IsReset(request.command) && (request.node.value == parts_.setup.own.value));
    parts_.listener.OnNmtSent(request, now);
}

void Manager::OnReset(const NodeId node) noexcept
{
    permissions_.OnReset(node);
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        if ((node.value == kAllNodes.value) || (node.value == id))
        {
            watch_.Forget(NodeId{id});
        }
    }
}

void Manager::OnLost(const Instant now) noexcept
{
    permissions_.OnLost(is_leading_ ? profile_ : nullptr, now);
}

FlyingStart Manager::StartNegotiation(const Instant now) noexcept
{
    const FlyingStart refusal = (flying_ != nullptr) ? FlyingStart::kNoBus : FlyingStart::kInvalid;
    return ((flying_ != nullptr) && !is_off_bus_) ? flying_->Start(now) : refusal;
}

void Manager::OnBus(const bool is_there, const Instant now) noexcept
{
    const bool has_gone = !is_there && !is_off_bus_;
    const bool is_back = is_there && is_off_bus_;
    is_off_bus_ = !is_there;
    if (is_back)
    {
        OnLost(now);
        if (is_leading_)
        {
            profile_->OnBusBack(now);
        }
    }
    if (has_gone && is_running_ && (flying_ != nullptr))
    {
        flying_->Reset(now);
    }
}

/// The active master that is commanded to reset itself, and not all, is as any other device after it. [SRS_FLY_019]
void Manager::ResetRole(const Instant now) noexcept
{
    const bool is_due = is_to_reset_ && (flying_ != nullptr);
    is_to_reset_ = false;
    if (is_due)
    {
        flying_->Reset(now);
    }
}

/// Values that cannot work may be corrected while the device is initialising.
void Manager::TryNegotiation(const Instant now) noexcept
{
    const FlyingStart answer = flying_->Start(now);
    is_to_start_ = (answer != FlyingStart::kStarted);
    if (is_to_start_ && !is_refused_ && (answer != FlyingStart::kNotInitialising))
    {
        is_refused_ = true;
        parts_.listener.OnNegotiationRefused(answer, now);
    }
    is_refused_ = is_refused_ && is_to_start_;
}

/// A negotiation may begin without an event: whoever negotiates commands nobody. [SRS_MGR_002]
void Manager::FollowRole(const Instant now) noexcept
{
    if (is_leading_ && !flying_->IsActiveMaster())
    {
        Lead(false, now);
    }
}

/// The application of the flying master: presets that leave supervision to it have no other. Without a consumer time
/// for that node nobody watches, and this device stays slave. [SRS_MGR_002]
void Manager::WatchMaster(const NodeId master, const Instant now) noexcept
{
    const HeartbeatSetup& heartbeat = parts_.setup.Slave(master).heartbeat;
    table_.WatchHeartbeat(master, heartbeat.consumer_ms, heartbeat.arming, now);
}

void Manager::OnFlyingMaster(const FlyingEvent event, const MasterClaim& claim, const Instant now) noexcept
{
    parts_.listener.OnFlyingMaster(event, claim, now);
    const bool is_settled = (event == FlyingEvent::kMasterMode) || (event == FlyingEvent::kSlaveMode);
    if (is_settled)
    {
        Lead(event == FlyingEvent::kMasterMode, now);
        if (event == FlyingEvent::kSlaveMode)
        {
            WatchMaster(claim.node, now);
        }
    }
    else if (!flying_->IsActiveMaster())
    {
        Lead(false, now);
    }
    else
    {
        // Told something, and still the master.
    }
}

void Manager::OnInitialising(const Instant now) noexcept
{
    Lead(false, now);
    UnwatchAll();
    own_.Restart();
    is_to_start_ = (negotiation_ == NegotiationBy::kManager);
    parts_.listener.OnInitialising(now);
}

} // namespace counterpoint::cia302
