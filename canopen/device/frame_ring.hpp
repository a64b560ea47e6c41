// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_DEVICE_FRAME_RING_HPP
#define CANOPEN_DEVICE_FRAME_RING_HPP

#include "safety_core/contract/can_frame.hpp"

#include <atomic>
#include <cstdint>

namespace counterpoint::device
{

/// Where a frame came from.
enum class Origin : std::uint8_t
{
    kInvalid = 0U,
    kReceived = 1U,
    kConfirmed = 2U, ///< A frame of this device that was on the bus.
};

/// A frame in a queue.
struct QueuedFrame
{
    StampedFrame frame;
    Origin origin;
};

/// Room of a queue, kept by reference.
struct FrameRoom
{
    QueuedFrame* frames;
    std::uint32_t count; ///< Below 2^31.
};

/// First in, first out, for one writer and one reader that may interrupt each other.
///
/// Invariant: both positions count up to twice the room and then from 0; their distance is the number of frames.
class FrameRing
{
  public:
    /// @brief Empty at first.
    explicit FrameRing(const FrameRoom& room) noexcept;

    /// @brief Adds a frame. False: there was no room. For the writer. O(1)
    [[nodiscard]] bool Put(const StampedFrame& frame, Origin origin) noexcept;
    /// @brief The oldest frame where it lies, or null; it stays there until Drop. For the reader. O(1)
    [[nodiscard]] const QueuedFrame* Oldest() const noexcept
    {
        const std::uint32_t read = read_.load(std::memory_order_relaxed);
        return (read == written_.load(std::memory_order_acquire)) ? nullptr : &At(read);
    }
    /// @brief Takes the oldest frame out. Only after Oldest returned it. O(1)
    void Drop() noexcept;
    [[nodiscard]] std::uint32_t Room() const noexcept;

  private:
    [[nodiscard]] std::uint32_t After(std::uint32_t position) const noexcept;
    [[nodiscard]] QueuedFrame& At(std::uint32_t position) const noexcept;

    FrameRoom room_;
    std::atomic<std::uint32_t> written_;
    std::atomic<std::uint32_t> read_;
};

} // namespace counterpoint::device

#endif
