// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/frame_ring.hpp"

namespace counterpoint::device
{

FrameRing::FrameRing(const FrameRoom& room) noexcept : room_(room), written_(0U), read_(0U)
{
}

bool FrameRing::Put(const QueuedFrame& item) noexcept
{
    const std::uint32_t written = written_.load(std::memory_order_relaxed);
    const std::uint32_t read = read_.load(std::memory_order_acquire);
    // Full: apart by the room. Empty: equal.
    const std::uint32_t distance = (written >= read) ? (written - read) : ((written + (2U * room_.count)) - read);
    const bool has_room = distance < room_.count;
    if (has_room)
    {
        At(written) = item;
        written_.store(After(written), std::memory_order_release);
    }
    return has_room;
}

TakenFrame FrameRing::Take() noexcept
{
    const std::uint32_t read = read_.load(std::memory_order_relaxed);
    TakenFrame taken{};
    taken.is_present = read != written_.load(std::memory_order_acquire);
    if (taken.is_present)
    {
        taken.item = At(read);
        read_.store(After(read), std::memory_order_release);
    }
    return taken;
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
