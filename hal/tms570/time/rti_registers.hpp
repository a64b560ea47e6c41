// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_TIME_RTI_REGISTERS_HPP
#define HAL_TMS570_TIME_RTI_REGISTERS_HPP

#include "hal/tms570/chip/registers.hpp"

#include <cstdint>

/// RTI with its digital watchdog: offsets, bits, keys. Source: facts/tms570 2, 4; reference manual, chapter "Real-Time
/// Interrupt (RTI) module".
namespace counterpoint::tms570::rti
{

inline constexpr RegisterBase kBase{0xFFFFFC00U};

inline constexpr std::uint32_t kGlobalControl = 0x00U;
inline constexpr std::uint32_t kTimebaseControl = 0x04U;
inline constexpr std::uint32_t kCompareControl = 0x0CU;
inline constexpr std::uint32_t kFreeCounter0 = 0x10U;
inline constexpr std::uint32_t kUpCounter0 = 0x14U;
inline constexpr std::uint32_t kCompareUp0 = 0x18U;
inline constexpr std::uint32_t kFreeCounter1 = 0x30U;
inline constexpr std::uint32_t kUpCounter1 = 0x34U;
inline constexpr std::uint32_t kCompareUp1 = 0x38U;
inline constexpr std::uint32_t kClearInterrupts = 0x84U;
inline constexpr std::uint32_t kWatchdogControl = 0x90U;
inline constexpr std::uint32_t kWatchdogPreload = 0x94U;
inline constexpr std::uint32_t kWatchdogStatus = 0x98U;
inline constexpr std::uint32_t kWatchdogKey = 0x9CU;
inline constexpr std::uint32_t kWatchdogCounter = 0xA0U;
inline constexpr std::uint32_t kWatchdogReaction = 0xA4U;
inline constexpr std::uint32_t kWatchdogWindow = 0xA8U;

inline constexpr std::uint32_t kCounter0On = 1U << 0U;
inline constexpr std::uint32_t kCounter1On = 1U << 1U;
inline constexpr std::uint32_t kAllInterrupts = 0x0007030FU;

inline constexpr std::uint32_t kWatchdogOn = 0xA98559DAU;
inline constexpr std::uint32_t kKeyFirst = 0x0000E51AU;
inline constexpr std::uint32_t kKeySecond = 0x0000A35CU;
inline constexpr std::uint32_t kReactionReset = 0x5U;
inline constexpr std::uint32_t kReactionInterrupt = 0xAU;
inline constexpr std::uint32_t kStatusBits = 0x3EU;
/// One step of the preload value: 2^13 cycles of RTICLK.
inline constexpr std::uint32_t kPreloadCycles = 8192U;
inline constexpr std::uint32_t kMostPreload = 0xFFFU;

/// Open window of the whole time: 100 %, 50 %, 25 %, 12.5 %, 6.25 %, 3.125 %.
inline constexpr std::uint32_t kWindowSizes = 6U;
inline constexpr std::uint32_t kWindowFull = 0x5U;
inline constexpr std::uint32_t kWindowStepBits = 4U;

} // namespace counterpoint::tms570::rti

#endif
