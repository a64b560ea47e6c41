// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Template of a device with 4 SRDOs. Inputs: bits 0 and 1 are the two readings of input 1, bits 2 and 3 those of input
// 2, bits 4 and 5 acknowledge output 1 and 2. Outputs: bits 0 and 1.
#include "examples/firmware/common/safe_device.hpp"
#include "examples/firmware/own_device/inverse_port.hpp"
#include "examples/firmware/own_device/own_application.hpp"

namespace counterpoint::firmware
{
namespace
{
using examples::OwnApplication;

constexpr std::uint8_t kSrdos = OwnApplication::kSrdos;
constexpr std::uint32_t kAcknowledgeShift = 4U;

[[gnu::section(".bss.party_channel_a")]] Cell<MemoryA<kSrdos>> memory_a;
[[gnu::section(".bss.party_channel_b")]] Cell<MemoryB<kSrdos>> memory_b;
[[gnu::section(".bss.party_core")]] Cell<CoreMemory> memory_core;
Cell<device::AppDevice<OwnApplication, kSrdos>> memory_rest;
CauseWindows windows[kSrdos];
[[gnu::section(".bss.party_non_safety")]] std::uint32_t cycles_shown;

OwnApplication application{InversePort()};

} // namespace

DrivenDevice BuildDevice(const Hardware& hardware) noexcept
{
    const Regions<kSrdos> regions{memory_a, memory_b, memory_core, windows};
    return Build(hardware, regions, memory_rest, application);
}

SrdoMask ReadInputs(const Pins inputs) noexcept
{
    for (std::uint8_t input = 0U; input < OwnApplication::kProducers; ++input)
    {
        const std::uint32_t readings = inputs.bits >> (2U * input);
        application.Sense(input, static_cast<std::uint8_t>(readings & 1U),
                          static_cast<std::uint8_t>((readings >> 1U) & 1U));
    }
    const SrdoMask acknowledged = (inputs.bits >> kAcknowledgeShift) & 3U;
    return acknowledged << OwnApplication::kProducers;
}

SrdoMask ReadAcknowledge(const Pins inverted) noexcept
{
    SrdoMask acknowledged = 0U;
    for (std::uint8_t output = 0U; output < OwnApplication::kConsumers; ++output)
    {
        const bool is_pressed = (inverted.bits & (1U << (kAcknowledgeShift + output))) == 0U;
        acknowledged |= is_pressed ? (SrdoMask{1U} << (OwnApplication::kProducers + output)) : 0U;
    }
    return acknowledged;
}

Pins SetOutputs(const SrdoMask open) noexcept
{
    std::uint32_t bits = 0U;
    for (std::uint8_t output = 0U; output < OwnApplication::kConsumers; ++output)
    {
        bits |= application.IsEnabled(output, open) ? (1U << output) : 0U;
    }
    return Pins{bits};
}

// What has no safety requirement goes here: a display, a log, other services of CANopen.
void RunNonSafety() noexcept
{
    ++cycles_shown;
}

} // namespace counterpoint::firmware
