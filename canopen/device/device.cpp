// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/device.hpp"

namespace counterpoint::device
{
namespace
{

using cia301::NodeState;

constexpr std::uint8_t kCobIdSub1 = 5U;
constexpr std::uint8_t kCobIdSub2 = 6U;

} // namespace

Device::Device(const BareParts& parts) noexcept
    : parts_(parts), command_frames_{}, safety_(parts.safety_room), commands_({command_frames_, kCommandRoom}),
      others_(parts.service_room), kernel_state_(NmtState::kInvalid), bus_(BusCondition::kActive), is_failed_(false),
      is_waiting_(false), has_lost_others_(false)
{
}

Device::Device(const DeviceParts& parts) noexcept
    : Device(
          BareParts{parts.kernel, parts.services, parts.owner, parts.safety_room, parts.srdo_count, parts.service_room})
{
    parts.services.watch = &parts.watch;
    parts.services.dictionary = &parts.dictionary;
}

LoadResult Device::PowerOn(const Instant now) noexcept
{
    LoadResult result = LoadResult::kFailed;
    if (safety_.HasRoomFor(parts_.srdo_count))
    {
        is_failed_ = false;
        is_waiting_ = false;
        Settle();
        parts_.services.Flush(now);
        result = is_failed_ ? LoadResult::kFailed : LoadResult::kLoaded;
    }
    return result;
}

void Device::PowerOff() noexcept
{
    while (safety_.Oldest() != nullptr)
    {
        safety_.Drop();
    }
    while (commands_.Oldest() != nullptr)
    {
        commands_.Drop();
    }
    while (others_.Oldest() != nullptr)
    {
        others_.Drop();
    }
    safety_.AdmitNone();
    static_cast<void>(safety_.TakeLoss());
    has_lost_others_.store(false);
    parts_.services.PowerOff();
    kernel_state_ = NmtState::kInvalid;
    bus_ = BusCondition::kActive;
}

void Device::OnFrame(const StampedFrame& frame) noexcept
{
    if (IsSafetyIdentifier(frame.frame.identifier))
    {
        safety_.Offer(frame, Origin::kReceived);
    }
    else
    {
        const bool is_command = frame.frame.identifier == 0U;
        const bool is_wanted = is_command || parts_.services.Wants(frame.frame);
        if (is_wanted && !(is_command ? commands_ : others_).Put(frame, Origin::kReceived))
        {
            has_lost_others_.store(true);
        }
    }
}

void Device::OnConfirm(const StampedFrame& frame) noexcept
{
    if (IsSafetyIdentifier(frame.frame.identifier))
    {
        safety_.Offer(frame, Origin::kConfirmed);
    }
    else
    {
        parts_.services.OnConfirm();
    }
}

void Device::OnLoss() noexcept
{
    safety_.MarkLoss();
    has_lost_others_.store(true);
}

void Device::OnBus(const BusCondition condition) noexcept
{
    const BusCondition left = bus_;
    bus_ = (condition == BusCondition::kInvalid) ? BusCondition::kOff : condition;
    parts_.services.OnBus(left, bus_);
}

void Device::Cycle(const CycleCall& call) noexcept
{
    HandOver();
    parts_.kernel.Cycle(call);
    Serve(call.now.a);
}

// A loss is told before the frames that wait: earlier than it happened, never later.
void Device::HandOver() noexcept
{
    if (safety_.TakeLoss())
    {
        parts_.kernel.OnOverflow();
    }
    for (const QueuedFrame* item = safety_.Oldest(); item != nullptr; item = safety_.Oldest())
    {
        if (item->origin == Origin::kConfirmed)
        {
            parts_.kernel.OnConfirm(item->frame);
        }
        else
        {
            parts_.kernel.OnFrame(item->frame);
        }
        safety_.Drop();
    }
}

// A loss in between is told by the one that was there.
bool Device::TakeLostOthers() noexcept
{
    const bool has_lost = has_lost_others_.load();
    if (has_lost)
    {
        has_lost_others_.store(false);
    }
    return has_lost;
}

NodeState Device::State() const noexcept
{
    return parts_.services.slave.State();
}

void Device::Serve(const Instant now) noexcept
{
    HandOver();
    ServiceSet& services = parts_.services;
    services.OnOverrun(TakeLostOthers());
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
    if (cia301::StateByte(State()) == 0U)
    {
        Initialise();
    }
    ApplyState();
}

void Device::Initialise() noexcept
{
    ServiceSet& services = parts_.services;
    cia301::NmtSlave& slave = services.slave;
    is_waiting_ = is_waiting_ && !services.MayBoot();
    // A store that reads what is reset would keep values that nobody saved.
    const bool is_storing = parts_.owner.IsStoring();
    while ((!is_storing) && (!is_failed_) && (!is_waiting_) && (cia301::StateByte(slave.State()) == 0U))
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
