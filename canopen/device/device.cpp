// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/device.hpp"

namespace counterpoint::device
{
namespace
{

constexpr std::uint32_t kSdoTimeOutUs = 1000000U;
constexpr std::uint8_t kSdoBlock = 64U;
constexpr std::uint32_t kSdoRequest = 0x600U;
constexpr std::uint32_t kErrorControlFirst = 0x700U;
constexpr std::uint32_t kErrorControlLast = 0x77FU;

} // namespace

Device::Device(const DeviceParts& parts) noexcept
    : parts_(parts), command_frames_{}, safety_(parts.safety_room), commands_({command_frames_, kCommandRoom}),
      others_(parts.service_room), outbox_(parts.can), facade_(parts.kernel), dictionary_(parts.table, facade_),
      sdo_({dictionary_, parts.sdo_buffer, kSdoTimeOutUs, kSdoBlock}), kernel_state_(NmtState::kInvalid),
      is_failed_(false), has_lost_others_(false)
{
}

LoadResult Device::PowerOn(const Instant now) noexcept
{
    LoadResult result = LoadResult::kFailed;
    if (safety_.HasRoomFor(parts_.srdo_count) && cia301::IsUsable(parts_.table))
    {
        is_failed_ = false;
        Settle();
        outbox_.Poll(now);
        const bool is_up = cia301::StateByte(State()) != 0U;
        result = is_up ? LoadResult::kLoaded : LoadResult::kFailed;
    }
    return result;
}

void Device::OnFrame(const StampedFrame& frame) noexcept
{
    const QueuedFrame item{frame, Origin::kReceived};
    if (IsSafetyIdentifier(frame.frame.identifier))
    {
        safety_.Offer(item);
    }
    else if (frame.frame.identifier == 0U)
    {
        has_lost_others_ = !commands_.Put(item) || has_lost_others_;
    }
    else if (IsWanted(frame.frame))
    {
        has_lost_others_ = !others_.Put(item) || has_lost_others_;
    }
    else
    {
        // For others.
    }
}

void Device::OnConfirm(const StampedFrame& frame) noexcept
{
    if (IsSafetyIdentifier(frame.frame.identifier))
    {
        safety_.Offer(QueuedFrame{frame, Origin::kConfirmed});
    }
    else
    {
        outbox_.OnConfirm();
    }
}

void Device::OnLoss() noexcept
{
    safety_.MarkLoss();
    has_lost_others_ = true;
}

void Device::Cycle(const CycleCall& call) noexcept
{
    HandOver();
    parts_.kernel.Cycle(call);
    Serve(call.now.a);
}

// Whoever asks first for a loss may hear of it one frame early, never late.
void Device::HandOver() noexcept
{
    if (safety_.TakeLoss())
    {
        parts_.kernel.OnOverflow();
    }
    TakenFrame taken = safety_.Take();
    while (taken.is_present)
    {
        if (taken.item.origin == Origin::kConfirmed)
        {
            parts_.kernel.OnConfirm(taken.item.frame);
        }
        else
        {
            parts_.kernel.OnFrame(taken.item.frame);
        }
        taken = safety_.Take();
    }
}

cia301::NodeState Device::State() const noexcept
{
    return parts_.services.slave.State();
}

cia301::Dictionary& Device::Objects() noexcept
{
    return dictionary_;
}

bool Device::IsWanted(const CanFrame& frame) const noexcept
{
    const std::uint32_t identifier = frame.identifier;
    const bool is_error_control = (identifier >= kErrorControlFirst) && (identifier <= kErrorControlLast);
    return is_error_control || (identifier == (kSdoRequest + parts_.services.node.value));
}

} // namespace counterpoint::device
