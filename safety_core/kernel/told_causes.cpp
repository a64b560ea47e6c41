// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/told_causes.hpp"

namespace counterpoint
{
namespace
{

// Causes 1 to 12 have a place each; 13 to 17 are of producers alone and share those of 7 to 11, which are of consumers
// alone; 18 shares that of 12, which is never told.
constexpr std::uint32_t kFirstShared = static_cast<std::uint32_t>(SrdoCause::kIdentifier);
constexpr std::uint32_t kFirstOfProducer = static_cast<std::uint32_t>(SrdoCause::kTransmitQueue);
constexpr std::uint32_t kLastCause = static_cast<std::uint32_t>(SrdoCause::kWaitingPastSct);
constexpr std::uint32_t kSharing = kFirstOfProducer - kFirstShared;

// The first of the causes that have this one's place.
std::uint32_t FirstOf(const std::uint32_t cause) noexcept
{
    return (cause >= kFirstOfProducer) ? (cause - kSharing) : cause;
}

} // namespace

void ToldCauses::Restart(CauseWindows* const windows, const std::uint8_t count) noexcept
{
    windows_ = windows;
    const std::uint8_t rooms = (windows == nullptr) ? 0U : count;
    for (std::uint8_t slot = 0U; slot < rooms; ++slot)
    {
        windows[slot].open = 0U; // MISRA D-002
    }
    slots_ = 0U;
    next_ = 0U;
}

bool ToldCauses::Take(const SlotIndex slot, const SrdoCause cause, const ToldWindow& window) noexcept
{
    if (windows_ == nullptr)
    {
        return true;
    }
    const std::uint32_t number = static_cast<std::uint32_t>(cause);
    const std::uint32_t first = FirstOf(number);
    std::uint32_t& open = windows_[slot].open;       // MISRA D-002
    Instant& told = windows_[slot].told[first - 1U]; // MISRA D-002
    const bool is_open = ((open >> number) & 1U) != 0U;
    if (is_open && ((window.now.us - told.us) <= window.length_us))
    {
        return false;
    }
    const std::uint32_t other = (first >= kFirstShared) ? (1U << (first + kSharing)) : 0U;
    open = (open & ~((1U << first) | other)) | (1U << number);
    told = window.now;
    slots_ |= OnlySlot(slot).mask;
    return true;
}

void ToldCauses::Sweep(const SlotIndex slot, const ToldWindow& window) noexcept
{
    std::uint32_t& open = windows_[slot].open; // MISRA D-002
    for (std::uint32_t number = 1U; number <= kLastCause; ++number)
    {
        const Instant told = windows_[slot].told[FirstOf(number) - 1U]; // MISRA D-002
        if ((window.now.us - told.us) > window.length_us)
        {
            open &= ~(1U << number);
        }
    }
    if (open == 0U)
    {
        slots_ &= ~OnlySlot(slot).mask;
    }
}

} // namespace counterpoint
