// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/safety_queue.hpp"

namespace counterpoint::device
{
namespace
{

constexpr std::uint32_t kFramesOfSrdo = 2U;
constexpr std::uint32_t kSpareFrames = 2U;

/// Of another length it is none, and must not take the place of one.
bool IsGfc(const CanFrame& frame) noexcept
{
    return (frame.identifier == kGfcIdentifier) && (frame.kind == FrameKind::kData) && (frame.length_bytes == 0U);
}

} // namespace

SafetyQueue::SafetyQueue(const FrameRoom& room) noexcept : ring_(room), admitted_{}, has_gfc_(false), has_lost_(false)
{
}

bool SafetyQueue::HasRoomFor(const std::uint8_t srdo_count) const noexcept
{
    return ring_.Room() >= ((kFramesOfSrdo * srdo_count) + kSpareFrames);
}

void SafetyQueue::Admit(const std::uint32_t identifier) noexcept
{
    const std::uint32_t number = identifier - kFirstSrdoIdentifier;
    if (number < kSrdoIdentifierCount)
    {
        static_cast<void>(admitted_[number / kWordBits].fetch_or(std::uint32_t{1U} << (number % kWordBits)));
    }
}

void SafetyQueue::AdmitNone() noexcept
{
    for (std::atomic<std::uint32_t>& word : admitted_)
    {
        word.store(0U);
    }
}

void SafetyQueue::Offer(const StampedFrame& frame, const Origin origin) noexcept
{
    if (IsGfc(frame.frame))
    {
        // Own GFCs need no confirmation; a second one says nothing new.
        const bool is_new = (origin == Origin::kReceived) && !has_gfc_.load();
        if (is_new)
        {
            has_gfc_.store(true);
            if (!ring_.Put(frame, origin))
            {
                has_gfc_.store(false);
                MarkLoss();
            }
        }
    }
    else if (IsAdmitted(frame.frame) && !ring_.Put(frame, origin))
    {
        MarkLoss();
    }
}

void SafetyQueue::MarkLoss() noexcept
{
    has_lost_.store(true);
}

bool SafetyQueue::TakeLoss() noexcept
{
    const bool has_lost = has_lost_.load();
    if (has_lost)
    {
        has_lost_.store(false);
    }
    return has_lost;
}

// From now on another GFC is a new one, while this one is worked on, too.
const QueuedFrame* SafetyQueue::Oldest() noexcept
{
    const QueuedFrame* const oldest = ring_.Oldest();
    if ((oldest != nullptr) && IsGfc(oldest->frame.frame))
    {
        has_gfc_.store(false);
    }
    return oldest;
}

void SafetyQueue::Drop() noexcept
{
    ring_.Drop();
}

bool SafetyQueue::IsAdmitted(const CanFrame& frame) const noexcept
{
    const std::uint32_t number = frame.identifier - kFirstSrdoIdentifier;
    bool is_admitted = false;
    if ((frame.kind == FrameKind::kData) && (number < kSrdoIdentifierCount))
    {
        is_admitted = ((admitted_[number / kWordBits].load() >> (number % kWordBits)) & 1U) != 0U;
    }
    return is_admitted;
}

} // namespace counterpoint::device
