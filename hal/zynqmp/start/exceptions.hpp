// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_START_EXCEPTIONS_HPP
#define HAL_ZYNQMP_START_EXCEPTIONS_HPP

#include "hal/api/exception_record.hpp"

#include <cstdint>

namespace counterpoint::zynqmp
{

/// @brief The record that start-up does not clear: of an exception before the last reset, or of none. `address_low` is
/// what was accessed (0: not an access), `address_high` the instruction. [SRS_ZYN_005]
[[nodiscard]] hal::ExceptionMemory LastException() noexcept;

} // namespace counterpoint::zynqmp

extern "C"
{
    /// What start_up.S calls after an exception: closes, records, stands still.
    [[noreturn]] void FirmwareException(std::uint32_t cause, std::uint32_t accessed, std::uint32_t place) noexcept;

    /// What exceptions.cpp needs of the board. They use no memory but registers and the stack: what else an exception
    /// left whole nobody knows.
    void HardwareCutOff() noexcept;            ///< Closes every output until the next reset.
    [[noreturn]] void HardwareStop() noexcept; ///< Stands still in the safe state.

    /// What the program is and what the board interrupts it for.
    void FirmwareMain() noexcept;
    void FirmwareInterrupt() noexcept;
    void FirmwareFastInterrupt() noexcept;

    /// @brief Calls `code` in user mode with a stack that ends below `stack_top`. The memory protection decides what it
    /// may write. [SRS_ZYN_069]
    void RunUnprivileged(void (*code)() noexcept, std::uint32_t* stack_top) noexcept;
}

#endif
