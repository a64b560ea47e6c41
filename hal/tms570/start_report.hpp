// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_START_REPORT_HPP
#define HAL_TMS570_START_REPORT_HPP

#include "hal/tms570/time/clocks.hpp"

#include <cstdint>

namespace counterpoint::tms570
{

/// Steps of the start in their order. Source: facts/tms570 4; what comes before the first of them is in
/// hal/tms570/start (registers of the processors, flash correction, RAM by hardware).
enum class StartStep : std::uint8_t
{
    kColdErrors = 0U, ///< No uncorrectable error is left from before.
    kClocks = 1U,
    kLogicTest = 2U, ///< LBIST; resets the processor twice.
    kLockstep = 3U,
    kMemoryTest = 4U, ///< PBIST
    kMemoryInit = 5U, ///< MINIT
    kRamEcc = 6U,
    kFlashEcc = 7U,
    kTableParity = 8U, ///< VIM: parity of its table, or ECC.
    kErrorPin = 9U,
    kClockComparator = 10U,
    kCounters = 11U,
    kPins = 12U,
    kProtection = 13U,
    kInterrupts = 14U,
    kEsm = 15U,
    kWatchdogPlan = 16U,
    kCan = 17U, ///< Last: from here on frames are acknowledged and received.
};
constexpr std::uint8_t kStartSteps = 18U;

/// What a step of the start came to.
enum class StepResult : std::uint8_t
{
    kInvalid = 0U, ///< Not done.
    kPassed = 0x69U,
    kFailed = 1U,
    kAbsent = 2U,     ///< This variant has no such thing; the safety manual says what takes its place.
    kResetComes = 3U, ///< The processor tests itself and is reset.
};

/// What the start as a whole came to.
enum class StartAnswer : std::uint8_t
{
    kInvalid = 0U,
    kStarted = 0x69U,
    kRefused = 1U,
    kResetComes = 2U,
};

/// Result of the start: the answer, each step, and why the controller started.
struct StartReport
{
    StartAnswer answer;
    StartStep last;                ///< The last step that was done.
    StepResult steps[kStartSteps]; ///< By StartStep. // MISRA D-001
    ResetReason reason;
    std::uint8_t logic_test; ///< LogicTest.
};

/// First fault of the drivers. [SRS_TMS_062]
enum class BoardFault : std::uint8_t
{
    kInvalid = 0U, ///< Not started.
    kStart = 1U,   ///< A step of the start failed.
    kCan = 2U,
    kPins = 3U,
    kEsm = 4U,
    kLockstep = 5U,
    kInterrupts = 6U, ///< Set-up or check bits of the VIM, or a request that nobody asked for.
    kClocks = 7U,
    kClockComparator = 8U,
    kCounters = 9U,
    kWatchdog = 10U,
    kProtection = 11U,
    kNone = 0x5AU,
};

} // namespace counterpoint::tms570

#endif
