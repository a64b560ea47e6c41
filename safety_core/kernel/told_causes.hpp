// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_TOLD_CAUSES_HPP
#define SAFETY_CORE_KERNEL_TOLD_CAUSES_HPP

#include "safety_core/comparator/slot_mask.hpp"
#include "safety_core/contract/srdo.hpp"
#include "safety_core/contract/time.hpp"

#include <cstdint>

namespace counterpoint
{

/// For how long a cause that was told is not told again.
struct ToldWindow
{
    Instant now;
    std::uint32_t length_us;
};

constexpr std::uint8_t kCausePlaces = 12U;

/// When each cause of one SRDO was told last; what it holds means nothing before Start. A cause of a consumer and one
/// of a producer share a place where an SRDO never has both. Invariant: an instant has a meaning only while the bit of
/// its cause is set in `open`.
struct CauseWindows
{
    Instant told[kCausePlaces]; // MISRA D-001
    std::uint32_t open;
};

/// When the causes of all SRDOs were told last. Invariant: the bit of a slot with an open window is set in `slots_`.
/// [SRS_KRN_032, SRS_KRN_346, SRS_KRN_347]
class ToldCauses
{
  public:
    /// @brief No window is open. `windows` has room for `count` SRDOs, or is null: then every cause is told whenever it
    /// is signalled. O(count)
    void Restart(CauseWindows* windows, std::uint8_t count) noexcept;
    /// @brief Whether the cause is to be told now; if so, its window begins. O(1)
    [[nodiscard]] bool Take(SlotIndex slot, SrdoCause cause, const ToldWindow& window) noexcept;
    /// @brief Slots with a window that may still be open.
    [[nodiscard]] SrdoMask Slots() const noexcept
    {
        return slots_;
    }
    /// @brief Whose turn it is to be swept: each slot comes at every 64th call.
    [[nodiscard]] SlotIndex NextSlot() noexcept
    {
        next_ = static_cast<SlotIndex>((next_ + 1U) % kMaxSrdoCount);
        return next_;
    }
    /// @brief Closes what is over in one slot, so that no instant gets so old that it would look new. O(causes)
    void Sweep(SlotIndex slot, const ToldWindow& window) noexcept;

  private:
    CauseWindows* windows_{nullptr};
    SrdoMask slots_{0U};
    SlotIndex next_{0U};
};

} // namespace counterpoint

#endif
