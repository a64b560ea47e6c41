// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_ZYNQMP_TWO_CPU_BOARD_HPP
#define VERIFICATION_TARGET_ZYNQMP_TWO_CPU_BOARD_HPP

#include "hal/api/cross_link.hpp"
#include "hal/zynqmp/board.hpp"
#include "safety_core/contract/time.hpp"

#include <cstdint>

/// What one processor of the emulated board has for itself: the drivers of hal/zynqmp as they ship. And the link to the
/// other processor.
namespace counterpoint::two_cpu
{

/// @brief Counters, CAN controller, pins, watchdog and memory protection of this processor.
[[nodiscard]] zynqmp::Board& OwnBoard() noexcept;
/// @brief Starts all but the watchdog. False: a driver refuses.
[[nodiscard]] bool StartBoard() noexcept;
/// @brief From the last restart of the watchdog to its end.
[[nodiscard]] std::uint32_t WatchdogPeriodUs() noexcept;
/// @brief Whether the pin of the consumer's output is high, by the registers alone.
[[nodiscard]] bool IsPinHigh() noexcept;
/// @brief Stops the timer of this processor, which is about to stand or has come to its end: the emulator's timers may
/// not roll over, and nobody would set it back.
void StopTimer() noexcept;
/// @brief The link to the other processor.
[[nodiscard]] hal::CrossLink& Link() noexcept;
/// @brief The other processor may run.
void LetOthersRun() noexcept;

} // namespace counterpoint::two_cpu

#endif
