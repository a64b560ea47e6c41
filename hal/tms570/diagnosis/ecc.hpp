// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_DIAGNOSIS_ECC_HPP
#define HAL_TMS570_DIAGNOSIS_ECC_HPP

#include "hal/tms570/chip/registers.hpp"

#include <cstdint>

/// Tests of the error correction of RAM (TCRAM modules, level 2 RAM) and flash (wrapper). Source: facts/tms570 2, 4;
/// reference manual, chapters "Tightly-Coupled RAM" and "F021 Flash Module".
namespace counterpoint::tms570
{

namespace tcram
{

inline constexpr RegisterBase kEvenBank{0xFFFFF800U};
inline constexpr RegisterBase kOddBank{0xFFFFF900U};
inline constexpr std::uint32_t kControl = 0x00U;
inline constexpr std::uint32_t kThreshold = 0x04U;
inline constexpr std::uint32_t kOccurrences = 0x08U;
inline constexpr std::uint32_t kInterrupt = 0x0CU;
inline constexpr std::uint32_t kErrorStatus = 0x10U;
inline constexpr std::uint32_t kCorrectedAddress = 0x14U;
inline constexpr std::uint32_t kUncorrectedAddress = 0x1CU;
inline constexpr std::uint32_t kDetect = 0x0005000AU;         ///< ECC detection on, ECC memory read-only.
inline constexpr std::uint32_t kDetectAndWrite = 0x0005010AU; ///< ECC memory can be written.
inline constexpr std::uint32_t kCorrected = 1U << 0U;
inline constexpr std::uint32_t kUncorrected = 1U << 5U;
/// From a word of RAM to its ECC.
inline constexpr std::uint32_t kEccOffset = 0x00400000U;
/// ACTLR: the processor checks the ECC of both banks.
inline constexpr std::uint32_t kProcessorChecks = 3U << 26U;

} // namespace tcram

namespace flash
{

inline constexpr RegisterBase kBase{0xFFF87000U};
inline constexpr std::uint32_t kErrorControl = 0x08U;
inline constexpr std::uint32_t kErrorStatus = 0x1CU;
inline constexpr std::uint32_t kUncorrectedAddress = 0x20U;
inline constexpr std::uint32_t kDiagnosisControl = 0x6CU;
inline constexpr std::uint32_t kParityOverride = 0x7CU;
inline constexpr std::uint32_t kErrorsOn = 0x000A060AU;
inline constexpr std::uint32_t kDiagnosisOn = 0x00050007U; ///< Mode 7.
inline constexpr std::uint32_t kDiagnosisOff = 0x000A0007U;
inline constexpr std::uint32_t kDiagnosisTrigger = 1U << 24U;
inline constexpr std::uint32_t kOneBit = 0x00005A01U;
inline constexpr std::uint32_t kTwoBits = 0x00005A03U;
inline constexpr std::uint32_t kCorrected = 1U << 1U;
inline constexpr std::uint32_t kUncorrected = 1U << 8U;
/// The mirror that the diagnosis corrupts; the flash itself is not changed.
inline constexpr Register kMirror{0x20000000U};
inline constexpr Register kMirrorNext{0x20000008U};

} // namespace flash

/// Reference manual SPNU563 (TMS570LC43x), chapter "Level 2 RAM (L2RAMW) Module".
namespace level_2_ram
{

inline constexpr RegisterBase kBase{0xFFFFF900U};
inline constexpr std::uint32_t kControl = 0x00U;     ///< RAMCTRL
inline constexpr std::uint32_t kErrorStatus = 0x10U; ///< RAMERRSTATUS; writing 1 clears.
inline constexpr std::uint32_t kDataHigh = 0x24U;
inline constexpr std::uint32_t kDataLow = 0x28U;
inline constexpr std::uint32_t kEccVector = 0x2CU;
inline constexpr std::uint32_t kTest = 0x30U; ///< RAMTEST
/// Detection on, as after reset; parity of addresses and control on; writes to the ECC memory off.
inline constexpr std::uint32_t kDetect = 0x0505000AU;
inline constexpr std::uint32_t kDetectMask = 0x000F010FU;
inline constexpr std::uint32_t kTestOn = 0xAU;
inline constexpr std::uint32_t kTestOff = 0x5U;
inline constexpr std::uint32_t kEquality = 0x80U;
inline constexpr std::uint32_t kTrigger = 1U << 8U; ///< Reads 0 when the test is done.
/// Both corrections, of writes and of reads before a write, have to see it.
inline constexpr std::uint32_t kOneBitErrors = 0x00280000U;
inline constexpr std::uint32_t kTwoBitErrors = 0x00500000U;
/// A new test runs only while all of these are clear.
inline constexpr std::uint32_t kAllDiagnosis = 0x00781C10U;

} // namespace level_2_ram

/// Four double words of RAM that nobody else uses, aligned to their size; even and odd bank in turn.
struct EccTestPlace
{
    std::uint32_t address;
};
inline constexpr std::uint32_t kEccTestBytes = 32U;

/// @brief Both banks of RAM: one bit is corrected and reported, two bits are reported and abort; then as it was.
/// Interrupts are locked and the ESM is not started. [SRS_TMS_044]
[[nodiscard]] Outcome TestRamEcc(EccTestPlace place) noexcept;

/// @brief Level 2 RAM: a right pair of data and ECC raises nothing, one and two wrong bits are each reported by both
/// corrections. No cell is touched; the correction of the processor itself is always on there. [SRS_TMS_044]
[[nodiscard]] Outcome TestLevel2Ram() noexcept;

/// @brief Flash: the same in diagnostic mode 7. [SRS_TMS_045]
[[nodiscard]] Outcome TestFlashEcc() noexcept;

} // namespace counterpoint::tms570

#endif
