// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_SRDO_STATUS_HPP
#define SAFETY_CORE_KERNEL_SRDO_STATUS_HPP

#include "safety_core/contract/srdo.hpp"

#include <cstdint>

namespace counterpoint
{

/// The status byte of an SRDO as the application reads and writes it. [SRS-KRN-021]
struct StatusByte
{
    std::uint8_t value;
};

constexpr std::uint8_t kStatusReset = 0x30U;
constexpr std::uint8_t kStatusTransfer = 0x30U; ///< Bits 5-4: 00 good, 01 faulty, 11 handled.
constexpr std::uint8_t kStatusError = 0xC0U;    ///< Bits 7-6: 00 none, 01 told, 10 handled.
constexpr std::uint8_t kStatusFaulty = 0x50U;   ///< Before OnSrdoError.

/// Status bytes of all SRDOs; they signal and release nothing. Bits 7 to 4 of two SRDOs share a byte, bits 5 and 4
/// inverted, so that zero-filled memory is the reset value. What is unanswered is also kept as a mask, so that it is
/// found without a loop.
class SrdoStatus
{
  public:
    /// @brief Bits 5-4 become 00, bits 7-6 stay.
    void OnEvent(SlotIndex slot) noexcept;
    /// @brief Bits 5-4 and 7-6 become 01.
    void OnError(SlotIndex slot) noexcept;
    /// @brief What the application answers.
    void Set(SlotIndex slot, StatusByte status) noexcept;
    [[nodiscard]] StatusByte Get(SlotIndex slot) const noexcept;
    /// @brief What was unanswered at the last call and is still; O(1), once a cycle. [SRS-KRN-022]
    [[nodiscard]] SrdoMask TakeOverdue() noexcept;

  private:
    static constexpr std::uint32_t kPairs = kMaxSrdoCount / 2U;

    std::uint8_t pairs_[kPairs]{}; // MISRA D-001
    SrdoMask unanswered_{0U};
    SrdoMask open_{0U}; ///< Unanswered since before the last call of TakeOverdue.
};

} // namespace counterpoint

#endif
