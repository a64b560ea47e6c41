// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/srdo_status.hpp"

namespace counterpoint
{

namespace
{

constexpr std::uint32_t kReadable = 0xF0U;
constexpr std::uint32_t kErrorTold = 0x40U;

// Bits 5-4 are 11, and bits 7-6 are not 01.
bool IsAnswer(const StatusByte status) noexcept
{
    const bool is_transfer_handled = (status.value & kStatusTransfer) == kStatusTransfer;
    return is_transfer_handled && ((status.value & kStatusError) != kErrorTold);
}

} // namespace

StatusByte SrdoStatus::Get(const SlotIndex slot) const noexcept
{
    return StatusByte{static_cast<std::uint8_t>((bytes_[slot] & kReadable) ^ kStatusReset)};
}

void SrdoStatus::Set(const SlotIndex slot, const StatusByte status) noexcept
{
    const std::uint32_t marks = IsAnswer(status) ? 0U : ((bytes_[slot] & kOpen) | kUnanswered);
    const std::uint32_t kept = (status.value & kReadable) ^ kStatusReset;
    bytes_[slot] = static_cast<std::uint8_t>(kept | marks);
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
