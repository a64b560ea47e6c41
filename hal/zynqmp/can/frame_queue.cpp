// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/zynqmp/can/frame_queue.hpp"

namespace counterpoint::zynqmp
{

namespace
{

constexpr QueuedFrame kNothingQueued{QueuedKind::kNothing, StampedFrame{}};
constexpr QueuedFrame kLossQueued{QueuedKind::kLoss, StampedFrame{}};
constexpr std::uint32_t kHalfRange = 0x80000000U;

[[nodiscard]] bool IsEarlier(const Instant one, const Instant other) noexcept
{
    return (one.us - other.us) >= kHalfRange;
}

} // namespace

void FrameQueue::Clear() noexcept
{
    put_ = 0U;
    taken_ = 0U;
    has_lost_ = false;
}

void FrameQueue::Put(const QueuedFrame& frame) noexcept
{
    if ((put_ - taken_) >= kPlaces)
    {
        PutLoss();
        return;
    }
    std::uint32_t place = put_;
    for (std::uint32_t moved = 0U; moved < kPlaces; ++moved)
    {
        if ((place == taken_) || !IsEarlier(frame.frame.stamp.a, frames_[Place(place - 1U)].frame.stamp.a))
        {
            break;
        }
        frames_[Place(place)] = frames_[Place(place - 1U)];
        --place;
    }
    frames_[Place(place)] = frame;
    ++put_;
}

void FrameQueue::PutLoss() noexcept
{
    has_lost_ = true;
}

QueuedFrame FrameQueue::Take(const Instant until) noexcept
{
    if (has_lost_)
    {
        has_lost_ = false;
        return kLossQueued;
    }
    if ((taken_ == put_) || IsEarlier(until, frames_[Place(taken_)].frame.stamp.a))
    {
        return kNothingQueued;
    }
    const QueuedFrame frame = frames_[Place(taken_)];
    ++taken_;
    return frame;
}

} // namespace counterpoint::zynqmp
