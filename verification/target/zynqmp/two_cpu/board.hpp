// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_ZYNQMP_TWO_CPU_BOARD_HPP
#define VERIFICATION_TARGET_ZYNQMP_TWO_CPU_BOARD_HPP

#include "hal/api/can_ports.hpp"
#include "hal/api/cross_link.hpp"
#include "safety_core/contract/time.hpp"

#include <cstdint>

/// What one processor of the emulated board has for itself, and the link to the other one.
namespace counterpoint::two_cpu
{

/// @brief Clock and CAN controller of this processor begin to run. False: the controller does not.
[[nodiscard]] bool StartBoard() noexcept;
/// @brief Microseconds of this processor's own counter.
[[nodiscard]] Instant Now() noexcept;
/// @brief The next frame of the bus that another controller sent. False: there is none.
[[nodiscard]] bool ReceiveFrame(CanFrame& frame) noexcept;
/// @brief The controller of this processor.
[[nodiscard]] hal::CanPorts& Ports() noexcept;
/// @brief A frame that Ports has sent, in the order of sending. False: there is none.
[[nodiscard]] bool TakeSent(CanFrame& frame) noexcept;
/// @brief The link to the other processor.
[[nodiscard]] hal::CrossLink& Link() noexcept;
/// @brief The other processor may run.
void LetOthersRun() noexcept;

} // namespace counterpoint::two_cpu

#endif
