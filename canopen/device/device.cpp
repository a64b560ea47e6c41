// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/device.hpp"

namespace counterpoint::device
{

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
        const bool is_up = is_waiting_ || (cia301::StateByte(State()) != 0U);
        result = is_up ? LoadResult::kLoaded : LoadResult::kFailed;
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

cia301::NodeState Device::State() const noexcept
{
    return parts_.services.slave.State();
}

} // namespace counterpoint::device
