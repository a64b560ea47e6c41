// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_CAN_DCAN_REGISTERS_HPP
#define HAL_TMS570_CAN_DCAN_REGISTERS_HPP

#include <cstdint>

/// DCAN: offsets and bits. Source: facts/tms570 3; reference manual, chapter "Controller Area Network (DCAN)",
/// registers.
namespace counterpoint::tms570::dcan
{

inline constexpr std::uint32_t kControl = 0x00U;
inline constexpr std::uint32_t kErrorStatus = 0x04U;
inline constexpr std::uint32_t kBitTiming = 0x0CU;
inline constexpr std::uint32_t kInterrupt = 0x10U;
inline constexpr std::uint32_t kTest = 0x14U;
inline constexpr std::uint32_t kParityError = 0x1CU;
inline constexpr std::uint32_t kTransmitRequest = 0x88U; ///< Objects 1 to 32; 33 to 64 follow.
inline constexpr std::uint32_t kNewData = 0x9CU;
inline constexpr std::uint32_t kInterruptPending = 0xB0U;
inline constexpr std::uint32_t kMessageValid = 0xC4U;
inline constexpr std::uint32_t kInterruptLine = 0xD8U;
inline constexpr std::uint32_t kInterface1 = 0x100U; ///< Used by the program.
inline constexpr std::uint32_t kInterface2 = 0x120U; ///< Used by the interrupt.

/// From the start of an interface.
inline constexpr std::uint32_t kCommand = 0x00U;
inline constexpr std::uint32_t kMask = 0x04U;
inline constexpr std::uint32_t kArbitration = 0x08U;
inline constexpr std::uint32_t kMessageControl = 0x0CU;
inline constexpr std::uint32_t kDataA = 0x10U;
inline constexpr std::uint32_t kDataB = 0x14U;

inline constexpr std::uint32_t kControlInit = 1U << 0U;
inline constexpr std::uint32_t kControlLine0 = 1U << 1U;
inline constexpr std::uint32_t kControlErrorInterrupt = 1U << 3U;
inline constexpr std::uint32_t kControlChange = 1U << 6U;    ///< CCE
inline constexpr std::uint32_t kControlAutoBusOn = 1U << 9U; ///< ABO
inline constexpr std::uint32_t kControlParityOn = 0xAU << 10U;
inline constexpr std::uint32_t kControlParityMask = 0xFU << 10U;
inline constexpr std::uint32_t kControlReset = 1U << 15U;

inline constexpr std::uint32_t kStatusWarning = 1U << 6U;
inline constexpr std::uint32_t kStatusBusOff = 1U << 7U;
inline constexpr std::uint32_t kStatusParity = 1U << 8U;

inline constexpr std::uint32_t kInterruptIdMask = 0xFFFFU;
inline constexpr std::uint32_t kInterruptIsStatus = 0x8000U;

inline constexpr std::uint32_t kCommandBusy = 1U << 15U;
inline constexpr std::uint32_t kCommandDataB = 1U << 16U;
inline constexpr std::uint32_t kCommandDataA = 1U << 17U;
inline constexpr std::uint32_t kCommandRequest = 1U << 18U; ///< Write: set TxRqst. Read: clear NewDat.
inline constexpr std::uint32_t kCommandClearPending = 1U << 19U;
inline constexpr std::uint32_t kCommandControl = 1U << 20U;
inline constexpr std::uint32_t kCommandArbitration = 1U << 21U;
inline constexpr std::uint32_t kCommandMask = 1U << 22U;
inline constexpr std::uint32_t kCommandWrite = 1U << 23U;

inline constexpr std::uint32_t kArbitrationValid = 1U << 31U;
inline constexpr std::uint32_t kArbitrationExtended = 1U << 30U;
inline constexpr std::uint32_t kArbitrationTransmit = 1U << 29U;
inline constexpr std::uint32_t kIdentifierShift = 18U;
inline constexpr std::uint32_t kIdentifierMask = 0x7FFU;

inline constexpr std::uint32_t kMaskExtended = 1U << 31U;
inline constexpr std::uint32_t kMaskDirection = 1U << 30U;

inline constexpr std::uint32_t kMessageNew = 1U << 15U;
inline constexpr std::uint32_t kMessageLost = 1U << 14U;
inline constexpr std::uint32_t kMessagePending = 1U << 13U;
inline constexpr std::uint32_t kMessageUseMask = 1U << 12U;
inline constexpr std::uint32_t kMessageTransmitInterrupt = 1U << 11U;
inline constexpr std::uint32_t kMessageReceiveInterrupt = 1U << 10U;
inline constexpr std::uint32_t kMessageTransmit = 1U << 8U;
inline constexpr std::uint32_t kMessageEndOfBlock = 1U << 7U;
inline constexpr std::uint32_t kMessageLength = 0xFU;

inline constexpr std::uint32_t kMostObjects = 64U;

/// Bit rate = CAN_CLK / (prescaler * (1 + segment_1 + segment_2)); each as it is meant, not as the register counts.
[[nodiscard]] constexpr std::uint32_t BitTiming(const std::uint32_t prescaler, const std::uint32_t segment_1,
                                                const std::uint32_t segment_2, const std::uint32_t jump) noexcept
{
    const std::uint32_t low = ((prescaler - 1U) & 0x3FU) | ((jump - 1U) << 6U);
    const std::uint32_t high = (((prescaler - 1U) >> 6U) << 16U) | ((segment_2 - 1U) << 12U) | ((segment_1 - 1U) << 8U);
    return low | high;
}

/// 500 kbit/s of 80 MHz: 20 * (1 + 5 + 2). facts/tms570 3 have the same numbers.
static_assert(BitTiming(20U, 5U, 2U, 2U) == 0x1453U, "BRP 19, TSEG1 4, TSEG2 1, SJW 1");

} // namespace counterpoint::tms570::dcan

#endif
