// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/srdo_status.hpp"

namespace counterpoint
{

namespace
{

constexpr std::uint32_t kReadable = 0xF0U;

} // namespace

StatusByte SrdoStatus::Get(const SlotIndex slot) const noexcept
{
    return StatusByte{static_cast<std::uint8_t>((bytes_[slot] & kReadable) ^ kStatusReset)};
}

void SrdoStatus::OnError(const SlotIndex slot) noexcept
{
    constexpr std::uint32_t kFaulty = std::uint32_t{kStatusFaulty} ^ kStatusReset;
    bytes_[slot] = static_cast<std::uint8_t>((bytes_[slot] & kOpen) | kFaulty | kUnanswered | kError);
}

// Bits 5-4 are 11; bits 7-6 are 10 behind an error, and behind an event alone whatever does not say that one was told.
// Anything else leaves open what is open, and opens nothing.
void SrdoStatus::Answer(const SlotIndex slot, const StatusByte status) noexcept
{
    const std::uint32_t marks = bytes_[slot] & (kUnanswered | kOpen | kError);
    const std::uint32_t error = status.value & kStatusError;
    const bool is_error_handled =
        ((marks & kError) != 0U) ? (error == kStatusErrorHandled) : (error != kStatusErrorTold);
    const bool is_answer = ((status.value & kStatusTransfer) == kStatusTransfer) && is_error_handled;
    const std::uint32_t kept = (status.value & kReadable) ^ kStatusReset;
    bytes_[slot] = static_cast<std::uint8_t>(kept | (is_answer ? 0U : marks));
}

SlotIndex SrdoStatus::TakeOverdue() noexcept
{
    SlotIndex overdue = kNoSlot;
    for (SlotIndex slot = kMaxSrdoCount; slot != 0U; --slot)
    {
        std::uint8_t& byte = bytes_[slot - 1U];
        if ((byte & kOpen) != 0U)
        {
            overdue = static_cast<SlotIndex>(slot - 1U);
        }
        byte = static_cast<std::uint8_t>(byte | ((byte & kUnanswered) * kOpen));
    }
    return overdue;
}

} // namespace counterpoint
