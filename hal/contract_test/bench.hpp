// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_CONTRACT_TEST_BENCH_HPP
#define HAL_CONTRACT_TEST_BENCH_HPP

#include "hal/contract_test/check.hpp"
#include "hal/contract_test/port_under_test.hpp"

#include <cstdint>

/// Steps that the checks share.
namespace counterpoint::hal::contract
{

/// Number of a frame among those of one check: it travels in the first bytes.
using FrameNumber = std::uint32_t;

/// @brief A frame of two bytes that hold the number.
[[nodiscard]] CanFrame NumberedFrame(const FrameName& name, FrameNumber number) noexcept;
[[nodiscard]] FrameNumber NumberOf(const CanFrame& frame) noexcept;
/// @brief Whether both have the same identifier, kind, port, length and bytes.
[[nodiscard]] bool AreEqual(const CanFrame& left, const CanFrame& right) noexcept;

/// @brief Device as after power-on, bus free, no event waiting.
void Settle(const PortUnderTest& port) noexcept;
/// @brief Lets cycles go by, the watchdog served in each.
void PassCycles(const PortUnderTest& port, std::uint32_t cycles) noexcept;
/// @brief Gives the right answer of this moment.
void Serve(const PortUnderTest& port) noexcept;
/// @brief So many cycles that one frame has ended, at least one.
[[nodiscard]] std::uint32_t CyclesForFrames(const PortUnderTest& port, std::uint32_t frames) noexcept;
/// @brief The other node sends a frame, and it ends. False: the bench cannot.
[[nodiscard]] bool Receive(const PortUnderTest& port, const CanFrame& frame) noexcept;

/// What `next` gave until it had nothing more; at most 2000 events.
struct Drained
{
    std::uint32_t received;
    std::uint32_t confirmed;
    std::uint32_t losses;
    std::uint32_t others; ///< No kind that there is.
    PortEvent first;      ///< kNothing if there was none.
};
[[nodiscard]] Drained Drain(const PortUnderTest& port) noexcept;

/// @brief Permits of all three parties that answer the challenge, and open these slots (slots 0 to 31).
[[nodiscard]] PermitSet RightPermits(std::uint32_t challenge, std::uint32_t slots) noexcept;
/// @brief Closes and arms the output as the start of a kernel does.
void Arm(const PortUnderTest& port) noexcept;
/// @brief Slot 0 by right permits, then a moment for the pin.
void Open(const PortUnderTest& port) noexcept;

} // namespace counterpoint::hal::contract

#endif
