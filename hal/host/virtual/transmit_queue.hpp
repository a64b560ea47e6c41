// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_VIRTUAL_TRANSMIT_QUEUE_HPP
#define HAL_HOST_VIRTUAL_TRANSMIT_QUEUE_HPP

#include "safety_core/contract/can_frame.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::host
{

/// A frame that waits for the bus. Order: lower key first, then lower `order`.
struct QueuedFrame
{
    CanFrame frame;
    std::uint32_t key;     ///< ArbitrationKey of the frame.
    std::uint32_t attempt; ///< Attempts so far.
    std::uint64_t order;   ///< Ascending with the time of submission.
};

/// Mailboxes of one controller. The frame on the bus keeps its mailbox until it is confirmed. [SRS_BUS_005]
class TransmitQueue
{
  public:
    /// @brief `capacity` mailboxes, at least 1.
    explicit TransmitQueue(std::size_t capacity);

    /// @brief Whether no frame waits.
    [[nodiscard]] bool IsEmpty() const
    {
        return waiting_.empty();
    }
    /// @brief Whether every mailbox is taken.
    [[nodiscard]] bool IsFull() const
    {
        return (waiting_.size() + (sending_ ? 1U : 0U)) >= capacity_;
    }
    /// @brief Frames waiting or on the bus.
    [[nodiscard]] std::size_t Size() const
    {
        return waiting_.size() + (sending_ ? 1U : 0U);
    }
    /// @brief The frame that would be sent next. Not on an empty queue.
    [[nodiscard]] const QueuedFrame& Front() const
    {
        return waiting_.back();
    }
    /// @brief Whether a frame of this queue is on the bus.
    [[nodiscard]] bool IsSending() const
    {
        return sending_;
    }
    /// @brief Takes a new frame. Not on a full queue.
    void Insert(const QueuedFrame& queued);
    /// @brief The front frame goes on the bus. Not on an empty queue.
    [[nodiscard]] QueuedFrame Take();
    /// @brief The frame on the bus is done with: its mailbox is free.
    void Release();
    /// @brief The frame on the bus has to be sent again.
    void PutBack(const QueuedFrame& queued);
    /// @brief A frame with the same content that waits is not sent any more.
    void Discard(const QueuedFrame& same);
    /// @brief Empties all mailboxes but that of the frame on the bus.
    void ClearWaiting();
    /// @brief Empties all mailboxes; what is on the bus is not of this queue any more.
    void Clear();

  private:
    void Place(const QueuedFrame& queued);

    std::size_t capacity_;
    bool sending_{false};
    std::vector<QueuedFrame> waiting_; ///< Sorted, the next one to be sent at the back.
};

} // namespace counterpoint::host

#endif
