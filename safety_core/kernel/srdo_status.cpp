// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/srdo_status.hpp"

#include "safety_core/comparator/slot_mask.hpp"

namespace counterpoint
{

namespace
{

constexpr std::uint32_t kHalfBits = 4U;
constexpr std::uint32_t kHalf = 0x0FU;
constexpr std::uint32_t kErrorTold = 0x40U;

std::uint32_t ShiftOf(const SlotIndex slot) noexcept
{
    return (static_cast<std::uint32_t>(slot) % 2U) * kHalfBits;
}

// Bits 5-4 are 11, and bits 7-6 are not 01.
bool IsAnswer(const StatusByte status) noexcept
{
    const bool is_transfer_handled = (status.value & kStatusTransfer) == kStatusTransfer;
    return is_transfer_handled && ((status.value & kStatusError) != kErrorTold);
}

} // namespace

StatusByte SrdoStatus::Get(const SlotIndex slot) const noexcept
{
    const std::uint32_t pair = pairs_[slot / 2U]; // MISRA D-002
    const std::uint32_t half = (pair >> ShiftOf(slot)) & kHalf;
    return StatusByte{static_cast<std::uint8_t>((half << kHalfBits) ^ kStatusReset)};
}

void SrdoStatus::OnEvent(const SlotIndex slot) noexcept
{
    constexpr std::uint32_t kGood = kStatusTransfer >> kHalfBits; // Kept inverted.
    std::uint8_t& pair = pairs_[slot / 2U];                       // MISRA D-002
    pair = static_cast<std::uint8_t>(pair | (kGood << ShiftOf(slot)));
    unanswered_ |= OnlySlot(slot).mask;
}

void SrdoStatus::OnError(const SlotIndex slot) noexcept
{
    Set(slot, StatusByte{kStatusFaulty});
}

void SrdoStatus::Set(const SlotIndex slot, const StatusByte status) noexcept
{
    const std::uint32_t shift = ShiftOf(slot);
    const std::uint32_t half = (static_cast<std::uint32_t>(status.value) ^ kStatusReset) >> kHalfBits;
    std::uint8_t& pair = pairs_[slot / 2U]; // MISRA D-002
    pair = static_cast<std::uint8_t>((pair & ~(kHalf << shift)) | (half << shift));
    unanswered_ |= OnlySlot(slot).mask;
    if (IsAnswer(status))
    {
        unanswered_ ^= OnlySlot(slot).mask;
    }
    open_ &= unanswered_;
}

SrdoMask SrdoStatus::TakeOverdue() noexcept
{
    const SrdoMask overdue = open_;
    open_ = unanswered_;
    return overdue;
}

} // namespace counterpoint
