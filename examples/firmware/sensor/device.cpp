// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The two-button sensor of examples/sensor as a device. Inputs: bits 0 and 1 are the contacts A and B of button 1, bits
// 2 and 3 those of button 2. No output.
#include "examples/firmware/common/safe_device.hpp"
#include "examples/sensor/sensor.hpp"

namespace counterpoint::firmware
{
namespace
{

constexpr std::uint8_t kSrdos = 1U;

[[gnu::section(".bss.party_channel_a")]] Cell<MemoryA<kSrdos>> memory_a;
[[gnu::section(".bss.party_channel_b")]] Cell<MemoryB<kSrdos>> memory_b;
[[gnu::section(".bss.party_core")]] Cell<CoreMemory> memory_core;
Cell<device::AppDevice<examples::Sensor, kSrdos>> memory_rest;
CauseWindows windows[kSrdos];
[[gnu::section(".bss.party_non_safety")]] std::uint32_t cycles_shown;

examples::Sensor sensor{};

} // namespace

DrivenDevice BuildDevice(const Hardware& hardware) noexcept
{
    const Regions<kSrdos> regions{memory_a, memory_b, memory_core, windows};
    return Build(hardware, regions, memory_rest, sensor);
}

SrdoMask ReadInputs(const Pins inputs) noexcept
{
    for (std::uint8_t button = 0U; button < examples::Sensor::kButtons; ++button)
    {
        const std::uint32_t contacts = inputs.bits >> (2U * button);
        sensor.Sense(button, examples::Contacts{static_cast<std::uint8_t>(contacts & 1U),
                                                static_cast<std::uint8_t>((contacts >> 1U) & 1U)});
    }
    return 0U;
}

SrdoMask ReadAcknowledge(Pins /*inverted*/) noexcept
{
    return 0U;
}

Pins SetOutputs(SrdoMask /*open*/) noexcept
{
    return Pins{0U};
}

void RunNonSafety() noexcept
{
    ++cycles_shown;
}

} // namespace counterpoint::firmware
