// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_INTERRUPTS_HPP
#define HAL_TMS570_INTERRUPTS_HPP

#include "hal/tms570/chip/registers.hpp"
#include "hal/tms570/chip/variant.hpp"

#include <cstdint>

/// Vectored interrupt manager (VIM). Source: facts/tms570 2; reference manual, chapter "Vectored Interrupt Manager";
/// for ECC that of the LC43x (SPNU563A, 19.5 and 19.9.1 to 19.9.5).
namespace counterpoint::tms570
{

namespace vim
{

inline constexpr RegisterBase kCheckBase{0xFFFFFDECU};
inline constexpr std::uint32_t kCheckStatus = 0x00U;
inline constexpr std::uint32_t kCheckControl = 0x04U;
inline constexpr std::uint32_t kErrorAddress = 0x08U;
inline constexpr std::uint32_t kFallback = 0x0CU;     ///< The vector while the table is bypassed after an error.
inline constexpr std::uint32_t kErrorFlag = 1U << 0U; ///< Parity; with ECC: two wrong bits, or one not corrected.
inline constexpr std::uint32_t kParityOn = 0xAU;
inline constexpr std::uint32_t kParityTest = 1U << 8U; ///< Parity bits can be written.
inline constexpr std::uint32_t kOneBitFlag = 1U << 8U; ///< ECC: one wrong bit.
/// ECC, keys of four bits from the highest: one wrong bit is reported to the ESM (Ah), not corrected (5h), check bits
/// cannot be written (Ah) or can (5h), ECC on (Ah).
inline constexpr std::uint32_t kEccOn = 0x0A050A0AU;
inline constexpr std::uint32_t kEccTest = 0x0A05050AU;

inline constexpr RegisterBase kBase{0xFFFFFE00U};
inline constexpr std::uint32_t kIrqIndex = 0x00U;
inline constexpr std::uint32_t kFiqIndex = 0x04U;
inline constexpr std::uint32_t kIsFast = 0x10U; ///< Four registers of 32 channels, as the next ones.
inline constexpr std::uint32_t kEnableSet = 0x30U;
inline constexpr std::uint32_t kEnableClear = 0x40U;

inline constexpr RegisterBase kTable{0xFFF82000U};
inline constexpr RegisterBase kTableCheckBits{0xFFF82400U}; ///< A word for each word of the table.
inline constexpr std::uint32_t kTableWords = 128U;
inline constexpr std::uint32_t kIndexMask = 0xFFU;

} // namespace vim

/// Requests that the drivers of this port use. Numbers are channels of the VIM.
enum class InterruptRequest : std::uint8_t
{
    kEsmHigh = 0U, ///< Always fast, always on.
    kDcan1 = 16U,
    kEsmLow = 20U,
    kDcan2 = 35U,
    kNone = 0xFEU,    ///< Nothing asks.
    kUnknown = 0xFFU, ///< Something that no driver asked for.
};

/// Interrupt requests by number: the processor's two vectors lead to the program, which asks here what it was. The
/// table of vectors is filled with one value and its check bits watched all the same. [SRS_TMS_041, SRS_TMS_042]
class Interrupts
{
  public:
    /// @brief Forces the errors that the check can tell and sees each reported by VIM and ESM; the table is then as it
    /// was.
    [[nodiscard]] static Outcome TestTable(TableCheck check) noexcept;
    /// @brief Table filled, its check on, all requests off but those of this port; read back.
    [[nodiscard]] static Outcome Start(TableCheck check) noexcept;
    /// @brief What raised the interrupt (IRQ).
    [[nodiscard]] static InterruptRequest Next() noexcept;
    /// @brief What raised the fast interrupt (FIQ).
    [[nodiscard]] static InterruptRequest NextFast() noexcept;
    /// @brief All requests off but the fast ones, which nothing turns off: after one that nobody asked for.
    static void MaskAll() noexcept;
    /// @brief Once a cycle: the check of the table on and no error, requests as set up.
    [[nodiscard]] static Outcome Examine(TableCheck check) noexcept;
};

} // namespace counterpoint::tms570

#endif
