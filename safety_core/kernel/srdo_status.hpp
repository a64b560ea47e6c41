// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_SRDO_STATUS_HPP
#define SAFETY_CORE_KERNEL_SRDO_STATUS_HPP

#include "safety_core/contract/srdo.hpp"

#include <cstdint>

namespace counterpoint
{

/// The status byte of an SRDO as the application reads and writes it. [SRS_KRN_021, SRS_KRN_227, SRS_KRN_228]
struct StatusByte
{
    std::uint8_t value;
};

constexpr std::uint8_t kStatusReset = 0x30U;
constexpr std::uint8_t kStatusTransfer = 0x30U; ///< Bits 5-4: 00 good, 01 faulty, 11 handled.
constexpr std::uint8_t kStatusError = 0xC0U;    ///< Bits 7-6: 00 none, 01 told, 10 handled.
constexpr std::uint8_t kStatusFaulty = 0x50U;   ///< Before OnSrdoError.
constexpr std::uint8_t kStatusErrorTold = 0x40U;
constexpr std::uint8_t kStatusErrorHandled = 0x80U;

/// Status bytes of all SRDOs; they signal and release nothing. A byte is kept with bits 5 and 4 inverted, so that
/// zero-filled memory is the reset value, and with three marks of the handshake in the bits that read 0.
class SrdoStatus
{
  public:
    /// @brief Bits 5-4 become 00, bits 7-6 stay.
    void OnEvent(const SlotIndex slot) noexcept
    {
        constexpr std::uint32_t kGood = std::uint32_t{kStatusTransfer} | kUnanswered; // Kept inverted.
        bytes_[slot] = static_cast<std::uint8_t>(bytes_[slot] | kGood);
    }
    /// @brief The byte becomes kStatusFaulty.
    void OnError(SlotIndex slot) noexcept;
    /// @brief What the application answers. [SRS_KRN_343]
    void Answer(SlotIndex slot, StatusByte status) noexcept;
    /// @brief The byte as the application reads it, without the marks.
    [[nodiscard]] StatusByte Get(SlotIndex slot) const noexcept;
    /// @brief Lowest slot that was unanswered at the last call and still is, or kNoSlot; once a cycle. O(slots)
    /// [SRS_KRN_022]
    [[nodiscard]] SlotIndex TakeOverdue() noexcept;

  private:
    static constexpr std::uint32_t kUnanswered = 0x01U;
    static constexpr std::uint32_t kOpen = 0x02U;  ///< Unanswered since before the last call of TakeOverdue.
    static constexpr std::uint32_t kError = 0x04U; ///< An error is among what is unanswered.

    std::uint8_t bytes_[kMaxSrdoCount]{}; // MISRA D-001
};

} // namespace counterpoint

#endif
