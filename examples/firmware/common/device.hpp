// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_FIRMWARE_COMMON_DEVICE_HPP
#define EXAMPLES_FIRMWARE_COMMON_DEVICE_HPP

#include "canopen/device/device.hpp"
#include "hal/api/memory_protection.hpp"

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

/// A device as its board drives it; the kernel for a demand of the safe state, and to look at.
struct DrivenDevice
{
    device::Device& device;
    Kernel& kernel;
    bool is_protected; ///< The memory protection took every region; else the device must not run.
};

/// Digital pins, bit by bit; what each means the device says.
struct Pins
{
    std::uint32_t bits;
};

/// @brief Builds kernel, channels and application and protects their memory. Called once.
[[nodiscard]] DrivenDevice BuildDevice(const Hardware& hardware) noexcept;

/// @brief Before each cycle: the inputs go to the application. The acknowledge levels for channel A come back.
[[nodiscard]] SrdoMask ReadInputs(Pins inputs) noexcept;

/// @brief The acknowledge levels for channel B, from a second reading; `inverted` has 0 where the input is 1.
[[nodiscard]] SrdoMask ReadAcknowledge(Pins inverted) noexcept;

/// @brief After each cycle: what the outputs shall be. `open` is what the gate lets through.
[[nodiscard]] Pins SetOutputs(SrdoMask open) noexcept;

/// @brief Code without safety requirements, once a cycle, in user mode: may write nothing but its own memory.
void RunNonSafety() noexcept;

} // namespace counterpoint::firmware

#endif
