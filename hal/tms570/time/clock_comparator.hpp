// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_TIME_CLOCK_COMPARATOR_HPP
#define HAL_TMS570_TIME_CLOCK_COMPARATOR_HPP

#include "hal/tms570/chip/registers.hpp"
#include "hal/tms570/chip/variant.hpp"

#include <cstdint>

/// Dual clock comparator DCC1: the PLL against the oscillator. Source: facts/tms570 2; reference manual, chapter
/// "Dual-Clock Comparator".
namespace counterpoint::tms570
{

namespace dcc
{

inline constexpr RegisterBase kBase{0xFFFFEC00U};
inline constexpr std::uint32_t kControl = 0x00U;
inline constexpr std::uint32_t kSeed0 = 0x08U;
inline constexpr std::uint32_t kValid0 = 0x0CU;
inline constexpr std::uint32_t kSeed1 = 0x10U;
inline constexpr std::uint32_t kStatus = 0x14U;
inline constexpr std::uint32_t kSource1 = 0x24U;
inline constexpr std::uint32_t kSource0 = 0x28U;

inline constexpr std::uint32_t kOff = 0x5555U;
/// Enabled, error signal on, interrupt when done off; single shot or for ever.
inline constexpr std::uint32_t kOnce = 0x5AAAU;
inline constexpr std::uint32_t kForEver = 0x55AAU;
inline constexpr std::uint32_t kError = 1U << 0U;
inline constexpr std::uint32_t kDone = 1U << 1U;
inline constexpr std::uint32_t kOscillator = 0xFU;
inline constexpr std::uint32_t kPll = 0xA000U;

/// 39 600 cycles of the oscillator, 1 percent to either side: within the accuracy of oscillator and PLL nothing is
/// found, and a counter of time is never wrong by more.
inline constexpr std::uint32_t kCycles = 39600U;
inline constexpr std::uint32_t kTolerance = 792U;

} // namespace dcc

/// Supervises the clock of the processor, of which both counters of time are made. [SRS_TMS_043]
class ClockComparator
{
  public:
    /// @brief Makes one comparison, then lets the comparator run without end. Interrupts are locked and the ESM is not
    /// started.
    [[nodiscard]] static Outcome Start(const ClockTree& clocks) noexcept;
    /// @brief Once a cycle: running, without an error.
    [[nodiscard]] static Outcome Examine() noexcept;
};

} // namespace counterpoint::tms570

#endif
