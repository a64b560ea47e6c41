// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/tms570/frame_queue.hpp"

namespace counterpoint::tms570
{

namespace
{

constexpr QueuedFrame kNothingQueued{QueuedKind::kNothing, StampedFrame{}};
constexpr QueuedFrame kLossQueued{QueuedKind::kLoss, StampedFrame{}};

} // namespace

void FrameQueue::Clear() noexcept
{
    put_.store(0U, std::memory_order_relaxed);
    taken_.store(0U, std::memory_order_relaxed);
    losses_.store(0U, std::memory_order_relaxed);
    told_ = 0U;
}

void FrameQueue::Put(const QueuedFrame& frame) noexcept
{
    const std::uint32_t put = put_.load(std::memory_order_relaxed);
    if ((put - taken_.load(std::memory_order_acquire)) >= kPlaces)
    {
        PutLoss();
        return;
    }
    frames_[put % kPlaces] = frame;
    put_.store(put + 1U, std::memory_order_release);
}

void FrameQueue::PutLoss() noexcept
{
    losses_.store(losses_.load(std::memory_order_relaxed) + 1U, std::memory_order_release);
}

QueuedFrame FrameQueue::Take() noexcept
{
    const std::uint32_t losses = losses_.load(std::memory_order_acquire);
    if (losses != told_)
    {
        told_ = losses;
        return kLossQueued;
    }
    const std::uint32_t taken = taken_.load(std::memory_order_relaxed);
    if (taken == put_.load(std::memory_order_acquire))
    {
        return kNothingQueued;
    }
    const QueuedFrame frame = frames_[taken % kPlaces];
    taken_.store(taken + 1U, std::memory_order_release);
    return frame;
}

} // namespace counterpoint::tms570
