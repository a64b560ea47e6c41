// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/frame_ring.hpp"

namespace counterpoint::device
{

FrameRing::FrameRing(const FrameRoom& room) noexcept : room_(room), written_(0U), read_(0U)
{
}

bool FrameRing::Put(const StampedFrame& frame, const Origin origin) noexcept
{
    const std::uint32_t written = written_.load(std::memory_order_relaxed);
    const std::uint32_t read = read_.load(std::memory_order_acquire);
    // Full: apart by the room. Empty: equal.
    const std::uint32_t distance = (written >= read) ? (written - read) : ((written + (2U * room_.count)) - read);
    const bool has_room = distance < room_.count;
    if (has_room)
    {
        QueuedFrame& place = At(written);
        place.frame = frame;
        place.origin = origin;
        written_.store(After(written), std::memory_order_release);
    }
    return has_room;
}

void FrameRing::Drop() noexcept
{
    read_.store(After(read_.load(std::memory_order_relaxed)), std::memory_order_release);
}

std::uint32_t FrameRing::Room() const noexcept
{
    return room_.count;
}

std::uint32_t FrameRing::After(const std::uint32_t position) const noexcept
{
    return ((position + 1U) == (2U * room_.count)) ? 0U : (position + 1U);
}

QueuedFrame& FrameRing::At(const std::uint32_t position) const noexcept
{
    return room_.frames[(position >= room_.count) ? (position - room_.count) : position];
}

} // namespace counterpoint::device
