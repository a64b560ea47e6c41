// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/virtual/transmit_queue.hpp"

#include <algorithm>

namespace counterpoint::host
{

namespace
{

/// Whether `left` waits behind `right`.
[[nodiscard]] bool IsBehind(const QueuedFrame& left, const QueuedFrame& right)
{
    return (left.key != right.key) ? (left.key > right.key) : (left.order > right.order);
}

} // namespace

TransmitQueue::TransmitQueue(const std::size_t capacity) : capacity_(std::max<std::size_t>(capacity, 1U))
{
    waiting_.reserve(capacity_);
}

void TransmitQueue::Insert(const QueuedFrame& queued)
{
    Place(queued);
}

QueuedFrame TransmitQueue::Take()
{
    const QueuedFrame taken = waiting_.back();
    waiting_.pop_back();
    sending_ = true;
    return taken;
}

void TransmitQueue::Release()
{
    sending_ = false;
}

void TransmitQueue::PutBack(const QueuedFrame& queued)
{
    sending_ = false;
    Place(queued);
}

void TransmitQueue::Discard(const QueuedFrame& same)
{
    const auto is_it = [&same](const QueuedFrame& queued)
    {
        return queued.key == same.key && queued.frame.length_bytes == same.frame.length_bytes &&
               std::equal(same.frame.data, same.frame.data + same.frame.length_bytes, queued.frame.data);
    };
    waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), is_it), waiting_.end());
}

void TransmitQueue::ClearWaiting()
{
    waiting_.clear();
}

void TransmitQueue::Clear()
{
    waiting_.clear();
    sending_ = false;
}

void TransmitQueue::Place(const QueuedFrame& queued)
{
    waiting_.insert(std::upper_bound(waiting_.begin(), waiting_.end(), queued, IsBehind), queued);
}

} // namespace counterpoint::host
