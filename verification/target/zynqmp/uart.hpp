// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_ZYNQMP_UART_HPP
#define VERIFICATION_TARGET_ZYNQMP_UART_HPP

namespace counterpoint::target
{

/// @brief Writes text to the UART of this processor (0 or 1, as the image was linked). Waits while its FIFO is full, at
/// most so long as the emulator takes: nothing of this is part of a device.
void WriteUart(const char* text) noexcept;

} // namespace counterpoint::target

#endif
