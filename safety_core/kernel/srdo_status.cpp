// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/srdo_status.hpp"

#include "safety_core/comparator/slot_mask.hpp"

namespace counterpoint
{

void SrdoStatus::Put(const SlotIndex slot, const std::uint32_t status) noexcept
{
    const SrdoMask slot_bit = OnlySlot(slot).mask;
    std::uint32_t rest = (status ^ kStatusReset) >> kLowestBit;
    for (SrdoMask& bit : bits_)
    {
        bit &= ~slot_bit;
        bit |= ((rest & 1U) != 0U) ? slot_bit : 0U;
        rest >>= 1U;
    }
}

StatusByte SrdoStatus::Get(const SlotIndex slot) const noexcept
{
    std::uint32_t status = 0U;
    for (std::uint32_t bit = kBits; bit != 0U; --bit)
    {
        status = (status << 1U) | (static_cast<std::uint32_t>(bits_[bit - 1U] >> slot) & 1U); // MISRA D-002
    }
    return StatusByte{static_cast<std::uint8_t>((status << kLowestBit) ^ kStatusReset)};
}

void SrdoStatus::OnEvent(const SlotIndex slot) noexcept
{
    Put(slot, static_cast<std::uint32_t>(Get(slot).value) & kStatusError);
}

void SrdoStatus::OnError(const SlotIndex slot) noexcept
{
    Put(slot, kStatusFaulty);
}

void SrdoStatus::Set(const SlotIndex slot, const StatusByte status) noexcept
{
    Put(slot, status.value);
    open_ &= Unanswered();
}

// Bits 5-4 other than 11, or bits 7-6 that are 01.
SrdoMask SrdoStatus::Unanswered() const noexcept
{
    return bits_[0] | bits_[1] | (bits_[2] & ~bits_[3]);
}

SrdoMask SrdoStatus::TakeOverdue() noexcept
{
    const SrdoMask overdue = open_;
    open_ = Unanswered();
    return overdue;
}

} // namespace counterpoint
