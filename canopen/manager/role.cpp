// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/manager/role.hpp"

namespace counterpoint::cia302
{
namespace
{

/// What waits is dropped with the role, and was answered as taken. One that was given up before concerns nobody.
/// [SRS_MGR_800]
void TellUnsent(const NmtMaster& nmt, ManagerListener& listener, const Instant now) noexcept
{
    for (std::uint16_t place = 0U; place < nmt.Waiting(); ++place)
    {
        const NmtRequest request = nmt.WaitingAt(place);
        if (request.command != NmtCommand::kInvalid)
        {
            listener.OnNmtUnsent(request, now);
        }
    }
}

} // namespace

ManagerRole::ManagerRole(const RoleParts& parts) noexcept
    : parts_(parts), profile_(nullptr), flying_(nullptr), negotiation_(NegotiationBy::kManager), is_running_(false),
      is_leading_(false), is_to_start_(false), is_refused_(false), is_off_bus_(false), is_to_reset_(false),
      is_owing_(false)
{
}

void ManagerRole::Use(StartUp& profile) noexcept
{
    profile_ = &profile;
}

void ManagerRole::Use(FlyingMaster& flying, const NegotiationBy by) noexcept
{
    flying_ = &flying;
    negotiation_ = by;
}

void ManagerRole::Begin(const Instant now) noexcept
{
    is_running_ = (profile_ != nullptr);
    if (is_running_)
    {
        parts_.own.Restart();
        is_to_start_ = (flying_ != nullptr) && (negotiation_ == NegotiationBy::kManager);
        parts_.own.Send(IsInitialising(), now);
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

void ManagerRole::End() noexcept
{
    if (is_running_)
    {
        profile_->End();
        parts_.nmt.SetActive(false);
    }
    is_leading_ = false;
    is_owing_ = false;
    is_running_ = false;
}

void ManagerRole::Lead(const bool is_leader, const Instant now) noexcept
{
    if (is_leader && !is_leading_)
    {
        is_leading_ = true;
        parts_.nmt.SetActive(true);
        profile_->Begin(now);
    }
    else if (!is_leader && is_leading_)
    {
        is_leading_ = false;
        is_owing_ = false;
        profile_->End();
        TellUnsent(parts_.nmt, parts_.listener, now);
        parts_.nmt.SetActive(false);
        UnwatchAll();
    }
    else
    {
        // As before.
    }
}

/// Nobody but the active master guards, and what was watched in another role counts no more.
void ManagerRole::UnwatchAll() noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        parts_.table.Unwatch(NodeId{id});
    }
}

void ManagerRole::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    if (flying_ != nullptr)
    {
        flying_->OnFrame(frame, now);
        FollowFlying(now);
    }
    if (is_owing_)
    {
        RunFlying(now);
    }
}

void ManagerRole::OnCycle(const Instant now) noexcept
{
    if (is_to_reset_ && (flying_ != nullptr))
    {
        flying_->Reset(now);
    }
    is_to_reset_ = false;
    if (is_to_start_ && !is_off_bus_)
    {
        TryNegotiation(now);
    }
    if (flying_ != nullptr)
    {
        RunFlying(now);
    }
}

/// What is due still had no room in the sink. Only the active master shares it with requests to slaves, and is asked
/// again with each frame: who gets no answer takes the master for gone. [SRS_MGR_231]
void ManagerRole::RunFlying(const Instant now) noexcept
{
    constexpr std::uint32_t kHalfRange = 0x80000000U;
    const bool was_slave = (flying_->State() == FlyingState::kSlave);
    const NodeId master = flying_->Master().node;
    flying_->OnCycle(now);
    if (was_slave && (flying_->State() != FlyingState::kSlave))
    {
        TellLost(master, now);
    }
    FollowFlying(now);
    const FlyingDeadline due = flying_->Next();
    is_owing_ = is_leading_ && due.is_set && ((now.us - due.at.us) < kHalfRange);
}

/// The flying master misses its master. Where the node table waits for its heartbeat, too, that tells it. [SRS_MGR_473]
void ManagerRole::TellLost(const NodeId master, const Instant now) noexcept
{
    if (!parts_.table.Record(master).is_running)
    {
        parts_.table.SetMissing(master);
        parts_.listener.OnNodeEvent(master, NodeEvent::kHeartbeatLost, now);
    }
}

void ManagerRole::OnBus(const bool is_there, const Instant now) noexcept
{
    const bool has_gone = !is_there && !is_off_bus_;
    is_off_bus_ = !is_there;
    if (has_gone && is_running_ && (flying_ != nullptr))
    {
        flying_->Reset(now);
    }
}

void ManagerRole::OnHeartbeatLost(const NodeId node, const Instant now) noexcept
{
    if (flying_ != nullptr)
    {
        flying_->OnHeartbeatLost(node, now);
    }
}

void ManagerRole::OnOwnReset() noexcept
{
    is_to_reset_ = true; // Not at once: the queue of commands is being worked through.
}

NmtAnswer ManagerRole::Command(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    return is_leading_ ? profile_->Command(command, node, now) : NmtAnswer::kNotActive;
}

bool ManagerRole::Boot(const NodeId node, const Instant now) noexcept
{
    return is_leading_ && profile_->Boot(node, now);
}

bool ManagerRole::Resume(const NodeId node, const Instant now) noexcept
{
    return is_leading_ && profile_->Resume(node, now);
}

FlyingStart ManagerRole::StartNegotiation(const Instant now) noexcept
{
    const FlyingStart refusal = (flying_ != nullptr) ? FlyingStart::kNoBus : FlyingStart::kInvalid;
    return ((flying_ != nullptr) && !is_off_bus_) ? flying_->Start(now) : refusal;
}

/// Values that cannot work may be corrected while the device is initialising.
void ManagerRole::TryNegotiation(const Instant now) noexcept
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

/// A negotiation may begin without an event: whoever negotiates commands nobody.
void ManagerRole::FollowFlying(const Instant now) noexcept
{
    if (is_leading_ && !flying_->IsActiveMaster())
    {
        Lead(false, now);
    }
}

bool ManagerRole::IsInitialising() const noexcept
{
    return (flying_ != nullptr) && flying_->IsInitialising();
}

void ManagerRole::OnFlyingMaster(const FlyingEvent event, const MasterClaim& claim, const Instant now) noexcept
{
    parts_.listener.OnFlyingMaster(event, claim, now);
    const bool is_settled = (event == FlyingEvent::kMasterMode) || (event == FlyingEvent::kSlaveMode);
    if (is_settled)
    {
        Lead(event == FlyingEvent::kMasterMode, now);
        if (event == FlyingEvent::kSlaveMode)
        {
            // The application of the flying master: presets that leave supervision to it have no other. Without a
            // consumer time for that node nobody watches, and this device stays slave.
            const HeartbeatSetup& heartbeat = parts_.setup.Slave(claim.node).heartbeat;
            parts_.table.WatchHeartbeat(claim.node, heartbeat.consumer_ms, heartbeat.arming, now);
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

void ManagerRole::OnInitialising(const Instant now) noexcept
{
    Lead(false, now);
    UnwatchAll();
    parts_.own.Restart();
    is_to_start_ = (negotiation_ == NegotiationBy::kManager);
    parts_.listener.OnInitialising(now);
}

} // namespace counterpoint::cia302
