// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/zynqmp/can/send_queue.hpp"

namespace counterpoint::zynqmp
{

void SendQueue::Clear() noexcept
{
    put_ = 0U;
    taken_ = 0U;
    has_urgent_ = false;
    lane_ = SendLane::kInvalid;
}

bool SendQueue::Put(const CanFrame& frame, const SendLane lane) noexcept
{
    if (lane == SendLane::kUrgent)
    {
        const bool has_room = !has_urgent_;
        urgent_ = has_room ? frame : urgent_;
        has_urgent_ = true;
        return has_room;
    }
    if ((put_ - taken_) >= kPlaces)
    {
        return false;
    }
    waiting_[put_ % kPlaces] = frame;
    ++put_;
    return true;
}

SendLane SendQueue::Begin() noexcept
{
    if (lane_ != SendLane::kInvalid)
    {
        return SendLane::kInvalid;
    }
    if (has_urgent_)
    {
        has_urgent_ = false;
        under_way_ = urgent_;
        lane_ = SendLane::kUrgent;
    }
    else if (taken_ != put_)
    {
        under_way_ = waiting_[taken_ % kPlaces];
        ++taken_;
        lane_ = SendLane::kFifo;
    }
    else
    {
        return SendLane::kInvalid;
    }
    return lane_;
}

} // namespace counterpoint::zynqmp
