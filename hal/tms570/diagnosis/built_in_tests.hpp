// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_DIAGNOSIS_BUILT_IN_TESTS_HPP
#define HAL_TMS570_DIAGNOSIS_BUILT_IN_TESTS_HPP

#include "hal/tms570/chip/registers.hpp"
#include "hal/tms570/chip/variant.hpp"
#include "hal/tms570/time/clocks.hpp"

#include <cstdint>

namespace counterpoint::tms570
{

/// How far the logic test is, or how it ended.
enum class LogicTest : std::uint8_t
{
    kInvalid = 0U,
    kPassed = 0x69U,   ///< Self-check failed as it must, then all intervals passed.
    kResetComes = 1U,  ///< Started; the processor is reset now. Only a processor that was not reset returns this.
    kCheckPassed = 2U, ///< The self-check did not find its fault.
    kFailed = 3U,
    kTimedOut = 4U, ///< The reset came without the test being done.
};

/// @brief Logic test of both processors (LBIST): call once after each reset, with its reason. After power-on it starts
/// the self-check, after the reset of that the test, after the reset of that it tells the result. The state between
/// resets is in the controller of the test itself. [SRS_TMS_047]
[[nodiscard]] LogicTest ContinueLogicTest(ResetReason reason) noexcept;

/// @brief Memory test by hardware (PBIST): a run that must fail, then the ROMs of the test and the memories of
/// peripherals. Their content is lost; the RAM of the processor is not among them (its march test is in
/// safety_core/selftest). [SRS_TMS_048]
[[nodiscard]] Outcome TestMemories(const MemorySelection& memories) noexcept;

} // namespace counterpoint::tms570

#endif
