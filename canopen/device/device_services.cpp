// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/device.hpp"

// NMT and the services behind the safety part. [SRS_DEV_002, SRS_DEV_003, SRS_DEV_004, SRS_DEV_005, SRS_DEV_010,
// SRS_DEV_011, SRS_DEV_014]
namespace counterpoint::device
{
namespace
{

using cia301::CommunicationError;
using cia301::NodeState;

constexpr std::uint16_t kStartUpIndex = 0x1F80U;
constexpr std::uint16_t kConfigurationValidIndex = 0x13FEU;
constexpr std::uint8_t kCobIdSub1 = 5U;
constexpr std::uint8_t kCobIdSub2 = 6U;
constexpr std::uint16_t kServiceQueue = 1U; ///< Source of an overrun.

} // namespace

void Device::Serve(const Instant now) noexcept
{
    HandOver();
    Services& services = parts_.services;
    if (has_lost_others_.exchange(false))
    {
        services.errors.Raise(CommunicationError::kOverrun, kServiceQueue);
    }
    else
    {
        services.errors.Clear(CommunicationError::kOverrun, kServiceQueue);
    }
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
    Services& services = parts_.services;
    cia301::NmtSlave& slave = services.slave;
    is_waiting_ = is_waiting_ && !services.lss->MayBoot();
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
    Services& services = parts_.services;
    LoadResult loaded = LoadResult::kLoaded;
    if (services.slave.State() == NodeState::kResetApplication)
    {
        parts_.watch.OnRestart();
        loaded = parts_.owner.OnResetNode();
    }
    else if (services.slave.State() == NodeState::kResetCommunication)
    {
        services.BeginConfiguration();
        loaded = parts_.owner.OnResetCommunication();
        const cia301::NumberReading start_up = parts_.dictionary.ReadNumber({kStartUpIndex, 0U});
        const bool is_present = start_up.abort == cia301::SdoAbort::kNone;
        services.EndConfiguration({is_present, static_cast<std::uint32_t>(start_up.value)});
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
        const bool was_operational = kernel_state_ == NmtState::kOperational;
        const bool is_operational = state == NmtState::kOperational;
        kernel_state_ = state;
        parts_.dictionary.SetNmtState(state);
        if (was_operational)
        {
            safety_.AdmitNone();
            parts_.watch.OnOperationalLeft();
        }
        if (is_operational)
        {
            AdmitSrdos();
        }
        parts_.kernel.SetNmtState(state);
        const cia301::NumberReading valid = parts_.dictionary.ReadNumber({kConfigurationValidIndex, 0U});
        const bool is_there = valid.abort == cia301::SdoAbort::kNone; // A plain device has none. [SRS_DEV_021]
        if (is_operational && is_there && (valid.value != kConfigurationValidValue))
        {
            parts_.watch.OnNotConfigured();
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
            safety_.Admit(static_cast<std::uint32_t>(parts_.dictionary.ReadNumber({index, kCobIdSub1}).value));
            safety_.Admit(static_cast<std::uint32_t>(parts_.dictionary.ReadNumber({index, kCobIdSub2}).value));
        }
    }
}

} // namespace counterpoint::device
