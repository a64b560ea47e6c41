// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/tms570/can/frame_queue.hpp"

namespace counterpoint::tms570
{

namespace
{

constexpr QueuedFrame kNothingQueued{QueuedKind::kNothing, StampedFrame{}};
constexpr QueuedFrame kLossQueued{QueuedKind::kLoss, StampedFrame{}};

} // namespace

void FrameQueue::Clear() noexcept
{
    put_.Store(0U);
    taken_.Store(0U);
    losses_.Store(0U);
    told_ = 0U;
}

void FrameQueue::Put(const QueuedFrame& frame) noexcept
{
    const std::uint32_t put = put_.Load();
    if ((put - taken_.Load()) >= kPlaces)
    {
        PutLoss();
        return;
    }
    frames_[put % kPlaces] = frame;
    put_.Store(put + 1U);
}

void FrameQueue::PutLoss() noexcept
{
    losses_.Store(losses_.Load() + 1U);
}

QueuedFrame FrameQueue::Take() noexcept
{
    const std::uint32_t losses = losses_.Load();
    if (losses != told_)
    {
        told_ = losses;
        return kLossQueued;
    }
    const std::uint32_t taken = taken_.Load();
    if (taken == put_.Load())
    {
        return kNothingQueued;
    }
    const QueuedFrame frame = frames_[taken % kPlaces];
    taken_.Store(taken + 1U);
    return frame;
}

} // namespace counterpoint::tms570
