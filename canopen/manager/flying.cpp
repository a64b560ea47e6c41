// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a manager does with the role that its flying master negotiates; manager.cpp has the rest.
#include "canopen/manager/manager.hpp"

namespace counterpoint::cia302
{

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
    state_ = cia301::NodeState::kPreOperational;
    owes_boot_up_ = true;
    is_to_start_ = (negotiation_ == NegotiationBy::kManager);
    parts_.listener.OnInitialising(now);
}

} // namespace counterpoint::cia302
