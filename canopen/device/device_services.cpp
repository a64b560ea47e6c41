// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/device.hpp"

// NMT and the services behind the safety part. [SRS_DEV_002, SRS_DEV_003, SRS_DEV_004, SRS_DEV_005, SRS_DEV_010,
// SRS_DEV_011, SRS_DEV_014]
namespace counterpoint::device
{
namespace
{

using cia301::NodeState;

constexpr std::uint8_t kCobIdSub1 = 5U;
constexpr std::uint8_t kCobIdSub2 = 6U;

} // namespace

void Device::Serve(const Instant now) noexcept
{
    HandOver();
    ServiceSet& services = parts_.services;
    services.OnOverrun(has_lost_others_.exchange(false));
    for (const QueuedFrame* item = commands_.Oldest(); item != nullptr; item = commands_.Oldest())
    {
        // Each takes effect completely before the next one is looked at.
        services.slave.OnFrame(item->frame.frame);
        Settle();
        commands_.Drop();
    }
    for (const QueuedFrame* item = others_.Oldest(); item != nullptr; item = others_.Oldest())
    {
        services.OnFrame(item->frame.frame, {State(), now});
        others_.Drop();
    }
    services.OnCycle({State(), now});
    Settle();
}

/// Carries out what the state machine asks for, until it rests.
void Device::Settle() noexcept
{
    Initialise();
    ApplyState();
}

void Device::Initialise() noexcept
{
    ServiceSet& services = parts_.services;
    cia301::NmtSlave& slave = services.slave;
    is_waiting_ = is_waiting_ && !services.MayBoot();
    while ((!is_failed_) && (!is_waiting_) && (cia301::StateByte(slave.State()) == 0U))
    {
        ApplyState();
        is_waiting_ = (slave.State() == NodeState::kResetCommunication) && !services.TakeNodeId();
        is_failed_ = (!is_waiting_) && (Load() != LoadResult::kLoaded);
        if ((!is_failed_) && (!is_waiting_))
        {
            services.Send(slave.Advance());
        }
    }
}

/// What a sub-state of INITIALISATION loads.
LoadResult Device::Load() noexcept
{
    ServiceSet& services = parts_.services;
    LoadResult loaded = LoadResult::kLoaded;
    if (services.slave.State() == NodeState::kResetApplication)
    {
        services.OnResetNode();
        loaded = parts_.owner.OnResetNode();
    }
    else if (services.slave.State() == NodeState::kResetCommunication)
    {
        services.BeginConfiguration();
        loaded = parts_.owner.OnResetCommunication();
        services.EndConfiguration();
    }
    else
    {
        // The first one loads nothing.
    }
    return loaded;
}

void Device::ApplyState() noexcept
{
    const NmtState state = cia301::KernelState(State());
    if (state != kernel_state_)
    {
        const NmtState left = kernel_state_;
        kernel_state_ = state;
        parts_.services.OnState(left, state);
        if (left == NmtState::kOperational)
        {
            safety_.AdmitNone();
        }
        if (state == NmtState::kOperational)
        {
            AdmitSrdos();
        }
        parts_.kernel.SetNmtState(state);
        if (state == NmtState::kOperational)
        {
            parts_.services.OnOperational();
        }
    }
}

// Directions and identifiers stay as they are until OPERATIONAL is left.
void Device::AdmitSrdos() noexcept
{
    for (std::uint8_t number = 0U; number < kMaxSrdoCount; ++number)
    {
        const auto index = static_cast<std::uint16_t>(kFirstCommunication + number);
        const ParametersReply parameters = parts_.kernel.GetParameters(CommunicationIndex{index});
        if ((parameters.result == Result::kSuccessful) && (parameters.direction != kDirectionOff))
        {
            safety_.Admit(ToValue(parts_.kernel.ReadObject({index, kCobIdSub1}).data));
            safety_.Admit(ToValue(parts_.kernel.ReadObject({index, kCobIdSub2}).data));
        }
    }
}

} // namespace counterpoint::device
