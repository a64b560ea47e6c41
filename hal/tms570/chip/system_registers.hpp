// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_CHIP_SYSTEM_REGISTERS_HPP
#define HAL_TMS570_CHIP_SYSTEM_REGISTERS_HPP

#include "hal/tms570/chip/registers.hpp"

#include <cstdint>

/// System module, self-test controllers: offsets, bits, keys. Source: facts/tms570 2, 4; reference manual, chapters
/// "Architecture" (system control registers), "CPU Self-Test Controller", "Programmable Built-In Self-Test".
namespace counterpoint::tms570::system_module
{

inline constexpr RegisterBase kBase{0xFFFFFF00U};
inline constexpr std::uint32_t kSourcesOff = 0x30U;    ///< CSDIS; 1: off.
inline constexpr std::uint32_t kSourcesOffSet = 0x34U; ///< CSDISSET
inline constexpr std::uint32_t kMainSource = 0x48U;    ///< GHVSRC
inline constexpr std::uint32_t kRtiSource = 0x50U;     ///< RCLKSRC
inline constexpr std::uint32_t kSourcesValid = 0x54U;  ///< CSVSTAT
inline constexpr std::uint32_t kTestControl = 0x58U;   ///< MSTGCR
inline constexpr std::uint32_t kInitControl = 0x5CU;   ///< MINITGCR
inline constexpr std::uint32_t kInitEnable = 0x60U;    ///< MSINENA
inline constexpr std::uint32_t kTestStatus = 0x68U;    ///< MSTCGSTAT
inline constexpr std::uint32_t kPll1 = 0x70U;
inline constexpr std::uint32_t kPll2 = 0x74U;
inline constexpr std::uint32_t kClockControl = 0xD0U; ///< CLKCNTL
inline constexpr std::uint32_t kResetStatus = 0xE4U;  ///< SYSESR
inline constexpr std::uint32_t kGlobalStatus = 0xECU; ///< GLBSTAT

inline constexpr std::uint32_t kKeyOn = 0xAU;
inline constexpr std::uint32_t kKeyOff = 0x5U;
inline constexpr std::uint32_t kTestOn = 0x10AU; ///< With the clock of the ROM halved.
inline constexpr std::uint32_t kTestOff = 0x105U;
inline constexpr std::uint32_t kTestDone = 1U << 0U;
inline constexpr std::uint32_t kInitDone = 1U << 8U;

inline constexpr std::uint32_t kOscillatorBit = 1U << 0U;
inline constexpr std::uint32_t kPllBit = 1U << 1U;
inline constexpr std::uint32_t kOtherPllBit = 1U << 6U;
inline constexpr std::uint32_t kUsedSources = 0x33U;
inline constexpr std::uint32_t kGlobalErrors = 0x301U; ///< Oscillator failed, PLL slipped.
inline constexpr std::uint32_t kPllIsMain = 0x00000001U;
inline constexpr std::uint32_t kPeripheralsOn = 1U << 8U;
inline constexpr std::uint32_t kHalfVclk = 0x01010000U;
inline constexpr std::uint32_t kVclkMask = 0x0F0F0000U;
/// Dividers behind the PLL: the greatest until it is locked.
inline constexpr std::uint32_t kPllDivider = 0x1F000000U;

inline constexpr RegisterBase kFlash{0xFFF87000U};
inline constexpr std::uint32_t kReadControl = 0x00U;

inline constexpr std::uint32_t kPowerUp = 0xA0U; ///< Four registers of a controller of power.

inline constexpr std::uint32_t kResetPowerOn = 0x8000U;
inline constexpr std::uint32_t kResetOscillator = 0x4000U;
inline constexpr std::uint32_t kResetWatchdog = 0x2000U;
inline constexpr std::uint32_t kResetProcessor = 0x20U;
inline constexpr std::uint32_t kResetSoftware = 0x10U;
inline constexpr std::uint32_t kResetExternal = 0x8U;
inline constexpr std::uint32_t kResetAll = 0xE038U;

inline constexpr RegisterBase kSystem2{0xFFFFE100U};
inline constexpr std::uint32_t kStcDivider = 0x08U;
inline constexpr std::uint32_t kStcHalfClock = 0x01000000U;

inline constexpr RegisterBase kStc{0xFFFFE600U};
inline constexpr std::uint32_t kStcControl0 = 0x00U;
inline constexpr std::uint32_t kStcControl1 = 0x04U;
inline constexpr std::uint32_t kStcTimeout = 0x08U;
inline constexpr std::uint32_t kStcStatus = 0x14U;
inline constexpr std::uint32_t kStcSelfCheck = 0x3CU;
inline constexpr std::uint32_t kStcDone = 1U << 0U;
inline constexpr std::uint32_t kStcFailed = 1U << 1U;
inline constexpr std::uint32_t kStcRestart = 1U << 0U;
inline constexpr std::uint32_t kStcIntervalsShift = 16U;
inline constexpr std::uint32_t kStcFault = 0x1AU; ///< Self-check with a stuck-at fault.
inline constexpr std::uint32_t kStcNoFault = 0x05U;

inline constexpr RegisterBase kPbist{0xFFFFE400U};
inline constexpr std::uint32_t kPbistRam = 0x160U;
inline constexpr std::uint32_t kPbistLogger = 0x164U;
inline constexpr std::uint32_t kPbistRun = 0x16CU;
inline constexpr std::uint32_t kPbistActive = 0x180U;
inline constexpr std::uint32_t kPbistOverride = 0x188U;
inline constexpr std::uint32_t kPbistFail0 = 0x190U;
inline constexpr std::uint32_t kPbistFail1 = 0x194U;
inline constexpr std::uint32_t kPbistRom = 0x1C0U;
inline constexpr std::uint32_t kPbistAlgorithms = 0x1C4U;
inline constexpr std::uint32_t kPbistGroupsLow = 0x1C8U;
inline constexpr std::uint32_t kPbistGroupsHigh = 0x1CCU;

} // namespace counterpoint::tms570::system_module

#endif
