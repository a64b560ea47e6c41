// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_CAN_CANPS_REGISTERS_HPP
#define HAL_ZYNQMP_CAN_CANPS_REGISTERS_HPP

#include "hal/zynqmp/chip/registers.hpp"

#include <cstdint>

/// The CAN controllers of the processing system: offsets and bits. Source: UG1085, pages of chapter "CAN
/// Controller"; offsets and bits as QEMU's hw/net/can/xlnx-zynqmp-can.c has them.
namespace counterpoint::zynqmp::canps
{

inline constexpr RegisterBase kCan0{0xFF060000U};
inline constexpr RegisterBase kCan1{0xFF070000U};

inline constexpr std::uint32_t kReset = 0x00U;       ///< SRR
inline constexpr std::uint32_t kMode = 0x04U;        ///< MSR
inline constexpr std::uint32_t kPrescaler = 0x08U;   ///< BRPR
inline constexpr std::uint32_t kBitTiming = 0x0CU;   ///< BTR
inline constexpr std::uint32_t kStatus = 0x18U;      ///< SR
inline constexpr std::uint32_t kEvents = 0x1CU;      ///< ISR
inline constexpr std::uint32_t kInterrupts = 0x20U;  ///< IER
inline constexpr std::uint32_t kClearEvents = 0x24U; ///< ICR
inline constexpr std::uint32_t kTimeStamp = 0x28U;   ///< TCR
/// Four words each: identifier, length, data, data. The last one hands the frame over.
inline constexpr std::uint32_t kTransmit = 0x30U; ///< TXFIFO
inline constexpr std::uint32_t kUrgent = 0x40U;   ///< TXHPB
inline constexpr std::uint32_t kReceive = 0x50U;  ///< RXFIFO
inline constexpr std::uint32_t kLengthWord = 0x4U;
inline constexpr std::uint32_t kDataWord = 0x8U;
inline constexpr std::uint32_t kLastDataWord = 0xCU;
inline constexpr std::uint32_t kFilters = 0x60U;          ///< AFR
inline constexpr std::uint32_t kFilterMask = 0x64U;       ///< AFMR1
inline constexpr std::uint32_t kFilterIdentifier = 0x68U; ///< AFIR1
inline constexpr std::uint32_t kFilterBytes = 0x8U;       ///< From one filter to the next.
inline constexpr std::uint8_t kMostFilters = 4U;

inline constexpr std::uint32_t kResetNow = 1U << 0U;
inline constexpr std::uint32_t kEnabled = 1U << 1U;

inline constexpr std::uint32_t kIsConfiguring = 1U << 0U;
inline constexpr std::uint32_t kIsNormal = 1U << 3U;
inline constexpr std::uint32_t kErrorState = 3U << 7U; ///< ESTAT
inline constexpr std::uint32_t kErrorIsBusOff = 2U << 7U;
inline constexpr std::uint32_t kUrgentFull = 1U << 9U;
inline constexpr std::uint32_t kTransmitFull = 1U << 10U;
inline constexpr std::uint32_t kFilterBusy = 1U << 11U;

inline constexpr std::uint32_t kSent = 1U << 1U;
inline constexpr std::uint32_t kUnderflow = 1U << 5U;
inline constexpr std::uint32_t kOverflow = 1U << 6U;
inline constexpr std::uint32_t kNotEmpty = 1U << 7U;
inline constexpr std::uint32_t kBusOff = 1U << 9U;
inline constexpr std::uint32_t kTransmitEmpty = 1U << 14U; ///< TXFEMP; set after a reset.
inline constexpr std::uint32_t kAllEvents = 0x7FFFU;

inline constexpr std::uint32_t kClearTimeStamp = 1U << 0U;
inline constexpr std::uint32_t kTimeStampMask = 0xFFFFU;

inline constexpr std::uint32_t kIdentifierShift = 21U;
inline constexpr std::uint32_t kIdentifierMask = 0x7FFU;
/// Remote, extended, the lower 18 bits: all 0 in a data frame with 11 bits of identifier.
inline constexpr std::uint32_t kOtherFormats = 0x001FFFFFU;
inline constexpr std::uint32_t kLengthShift = 28U;

/// BTR: each of its parts is written less 1. Bit time: 1 + before + after quanta.
[[nodiscard]] constexpr std::uint32_t BitTiming(const std::uint32_t before, const std::uint32_t after,
                                                const std::uint32_t jump) noexcept
{
    return (before - 1U) | ((after - 1U) << 4U) | ((jump - 1U) << 7U);
}

} // namespace counterpoint::zynqmp::canps

#endif
