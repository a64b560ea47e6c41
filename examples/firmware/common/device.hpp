// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_FIRMWARE_COMMON_DEVICE_HPP
#define EXAMPLES_FIRMWARE_COMMON_DEVICE_HPP

#include "hal/api/memory_protection.hpp"
#include "safety_core/kernel/kernel.hpp"

#include <cstdint>

/// What is between a device and the board that it runs on: every device defines these functions once, every board calls
/// them. Nothing here is virtual, the linker joins the two.
namespace counterpoint::firmware
{

/// What a device needs of its board; all of it outlives the device.
struct Hardware
{
    hal::CanPorts& can;
    hal::SafetyOutput& output;
    hal::Watchdog& watchdog;
    hal::MemoryProtection& protection;
};

/// Digital pins, bit by bit; what each means the device says.
struct Pins
{
    std::uint32_t bits;
};

/// @brief Builds kernel, channels and application, protects their memory and configures the kernel. Null: something
/// was refused, and the device must not run. Called once.
[[nodiscard]] Kernel* StartDevice(const Hardware& hardware) noexcept;

/// @brief Before each cycle: the inputs go to the application. The acknowledge levels come back.
[[nodiscard]] SrdoMask ReadInputs(Pins inputs) noexcept;

/// @brief After each cycle: what the outputs shall be. `open` is what the gate lets through.
[[nodiscard]] Pins SetOutputs(SrdoMask open) noexcept;

/// @brief Code without safety requirements, once a cycle, in user mode: may write nothing but its own memory.
void RunNonSafety() noexcept;

} // namespace counterpoint::firmware

#endif
