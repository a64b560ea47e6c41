// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_SEND_QUEUE_HPP
#define HAL_HOST_LIVE_SEND_QUEUE_HPP

#include "hal/host/live/bus.hpp"

#include <cstdint>
#include <deque>

namespace counterpoint::host
{

/// Frames that the system has not taken yet, first in, first out. While a frame waits, each further one waits behind
/// it; that keeps the order. [SRS_LIVE_004]
class LiveSendQueue
{
  public:
    /// @brief Whether no frame waits.
    [[nodiscard]] bool IsEmpty() const
    {
        return frames_.empty();
    }
    /// @brief Whether kLiveQueueFrames frames wait.
    [[nodiscard]] bool IsFull() const
    {
        return frames_.size() >= kLiveQueueFrames;
    }
    /// @brief How many frames wait.
    [[nodiscard]] std::uint32_t Count() const
    {
        return static_cast<std::uint32_t>(frames_.size());
    }
    /// @brief Adds a frame at the end.
    void Push(const LiveFrame& frame)
    {
        frames_.push_back(frame);
    }
    /// @brief The oldest frame. Not of an empty queue.
    [[nodiscard]] const LiveFrame& First() const
    {
        return frames_.front();
    }
    /// @brief Takes the oldest frame out. Not of an empty queue.
    void DropFirst()
    {
        frames_.pop_front();
    }
    /// @brief Throws all frames away; returns how many they were.
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
