// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_SEND_QUEUE_HPP
#define HAL_HOST_LIVE_SEND_QUEUE_HPP

#include "hal/host/live/bus.hpp"

#include <cstdint>
#include <deque>

namespace counterpoint::host
{

/// Frames that the system did not take yet, first in, first out. A frame sent while one waits waits behind it, which is
/// what keeps the order. [SRS_LIVE_004]
class LiveSendQueue
{
  public:
    [[nodiscard]] bool IsEmpty() const
    {
        return frames_.empty();
    }
    [[nodiscard]] bool IsFull() const
    {
        return frames_.size() >= kLiveQueueFrames;
    }
    [[nodiscard]] std::uint32_t Count() const
    {
        return static_cast<std::uint32_t>(frames_.size());
    }
    void Push(const LiveFrame& frame)
    {
        frames_.push_back(frame);
    }
    [[nodiscard]] const LiveFrame& First() const
    {
        return frames_.front();
    }
    void DropFirst()
    {
        frames_.pop_front();
    }
    /// @brief Throws everything away; returns how many that were.
    std::uint32_t Clear()
    {
        const std::uint32_t count = Count();
        frames_.clear();
        return count;
    }

  private:
    std::deque<LiveFrame> frames_;
};

} // namespace counterpoint::host

#endif
