// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_FIFO_REGISTERS_HPP
#define EXAMPLES_PORT_FIFO_REGISTERS_HPP

#include <cstdint>

/// The registers of a controller that does not exist, of the kind that has a receive FIFO, buffers to send from and a
/// FIFO of transmit events.
namespace port_fifo
{

inline constexpr std::uint32_t kCanControl = 0x00U; ///< Bit 0: off the bus.
inline constexpr std::uint32_t kCanStatus = 0x04U;  ///< kBusOff, kReceiveLost, kEventLost; the latter two: 1 clears.
inline constexpr std::uint32_t kCanTimer = 0x08U;   ///< 16 bits of bit times.
inline constexpr std::uint32_t kReceiveLevel = 0x10U;
inline constexpr std::uint32_t kReceiveIdentifier = 0x14U; ///< 11 bits; kRemote, kExtended.
inline constexpr std::uint32_t kReceiveLength = 0x18U;     ///< Bits 16 to 31: kCanTimer at the end of the frame.
inline constexpr std::uint32_t kReceiveData = 0x1CU;       ///< Two words, byte 0 lowest.
inline constexpr std::uint32_t kReceivePop = 0x24U;
inline constexpr std::uint32_t kTransmitPending = 0x28U; ///< A bit each buffer.
inline constexpr std::uint32_t kTransmitRequest = 0x2CU; ///< Number of a buffer; they leave in the order of requests.
inline constexpr std::uint32_t kTransmitCancel = 0x30U;  ///< A bit each buffer.
inline constexpr std::uint32_t kEventLevel = 0x34U;
inline constexpr std::uint32_t kEventBuffer = 0x38U; ///< Bits 16 to 31: kCanTimer at the end of the frame.
inline constexpr std::uint32_t kEventPop = 0x3CU;
inline constexpr std::uint32_t kFilter = 0x40U;         ///< 8 identifiers of data frames; kFilterUnused.
inline constexpr std::uint32_t kTransmitBuffer = 0x80U; ///< 4 times identifier, length, two words of data.
inline constexpr std::uint32_t kTimerA = 0x100U;        ///< Cycles of 80 MHz, low word; reading it keeps the high word.
inline constexpr std::uint32_t kTimerAHigh = 0x104U;
inline constexpr std::uint32_t kTimerB = 0x108U; ///< Microseconds, of an oscillator of its own.
inline constexpr std::uint32_t kPinOut = 0x200U;
inline constexpr std::uint32_t kPinIn = 0x204U;
inline constexpr std::uint32_t kPinDirection = 0x208U; ///< 1: output.
inline constexpr std::uint32_t kWatchdogQuestion = 0x300U;
inline constexpr std::uint32_t kWatchdogAnswer =
    0x304U; ///< Right: (reference + question) * constant, by the chip itself.

inline constexpr std::uint32_t kOffTheBus = 1U;
inline constexpr std::uint32_t kBusOff = 1U;
inline constexpr std::uint32_t kReceiveLost = 2U;
inline constexpr std::uint32_t kEventLost = 4U;
inline constexpr std::uint32_t kRemote = 1U << 11U;
inline constexpr std::uint32_t kExtended = 1U << 12U;
inline constexpr std::uint32_t kFilterUnused = 0xFFFFFFFFU;
inline constexpr std::uint32_t kFilters = 8U;
inline constexpr std::uint32_t kBuffers = 4U;
inline constexpr std::uint32_t kBufferBytes = 16U;
inline constexpr std::uint32_t kStampShift = 16U;
inline constexpr std::uint32_t kStampMask = 0xFFFFU;
inline constexpr std::uint32_t kLengthMask = 0xFU;

/// @brief The only two places where a register is touched: registers_silicon.cpp on the controller, a model on a host.
[[nodiscard]] std::uint32_t ReadRegister(std::uint32_t offset) noexcept;
void WriteRegister(std::uint32_t offset, std::uint32_t value) noexcept;

} // namespace port_fifo

#endif
