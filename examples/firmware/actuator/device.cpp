// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The drive of examples/actuator as a device. Input bit 0: acknowledge. Output bit 0: the drive may move, in series
// with the pin that follows the gate.
#include "examples/actuator/actuator.hpp"
#include "examples/firmware/common/safe_device.hpp"

namespace counterpoint::firmware
{
namespace
{

constexpr std::uint8_t kSrdos = 1U;

[[gnu::section(".bss.party_channel_a")]] Cell<MemoryA<kSrdos>> memory_a;
[[gnu::section(".bss.party_channel_b")]] Cell<MemoryB<kSrdos>> memory_b;
[[gnu::section(".bss.party_core")]] Cell<CoreMemory> memory_core;
Cell<device::AppDevice<examples::Actuator, kSrdos>> memory_rest;
CauseWindows windows[kSrdos];
[[gnu::section(".bss.party_non_safety")]] std::uint32_t cycles_shown;

examples::Actuator actuator{};

} // namespace

DrivenDevice BuildDevice(const Hardware& hardware) noexcept
{
    const Regions<kSrdos> regions{memory_a, memory_b, memory_core, windows};
    return Build(hardware, regions, memory_rest, actuator);
}

SrdoMask ReadInputs(const Pins inputs) noexcept
{
    return inputs.bits & 1U;
}

SrdoMask ReadAcknowledge(const Pins inverted) noexcept
{
    return ((inverted.bits & 1U) == 0U) ? 1U : 0U;
}

Pins SetOutputs(const SrdoMask open) noexcept
{
    return Pins{actuator.MayMove(open) ? 1U : 0U};
}

void RunNonSafety() noexcept
{
    ++cycles_shown;
}

} // namespace counterpoint::firmware
