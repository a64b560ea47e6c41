// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/frame_queue.hpp"

#include <algorithm>

namespace counterpoint::host
{

FrameQueue::FrameQueue(const std::size_t capacity) : ring_(std::max<std::size_t>(capacity, 1U))
{
}

void FrameQueue::OnFrame(const StampedFrame& frame)
{
    Put(frame, ItemKind::kFrame);
}

void FrameQueue::OnConfirm(const StampedFrame& frame)
{
    Put(frame, ItemKind::kConfirmation);
}

void FrameQueue::OnOverflow()
{
    overflowed_ = true;
}

void FrameQueue::Drain(FrameSink& sink)
{
    if (overflowed_)
    {
        overflowed_ = false;
        sink.OnOverflow();
    }
    while (count_ > 0U)
    {
        const Item item = ring_[first_];
        first_ = (first_ + 1U) % ring_.size();
        --count_;
        if (item.kind == ItemKind::kFrame)
        {
            sink.OnFrame(item.frame);
        }
        else
        {
            sink.OnConfirm(item.frame);
        }
    }
}

void FrameQueue::Put(const StampedFrame& frame, const ItemKind kind)
{
    if (count_ == ring_.size())
    {
        overflowed_ = true;
        return;
    }
    ring_[(first_ + count_) % ring_.size()] = Item{frame, kind};
    ++count_;
}

} // namespace counterpoint::host
