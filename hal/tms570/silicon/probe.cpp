// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The probe of hal/tms570/probe.hpp for silicon; its instructions are in probe.S.
#include "hal/tms570/probe.hpp"

extern "C"
{
    std::uint32_t ProbeRead(std::uint32_t address) noexcept;
    extern const std::uint8_t ProbeReadInstruction[]; // MISRA D-001
}

namespace counterpoint::tms570
{

std::uint32_t Probe(const Register place) noexcept
{
    return ProbeRead(place.address);
}

std::uint32_t ProbeInstruction() noexcept
{
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(ProbeReadInstruction)); // MISRA D-004
}

} // namespace counterpoint::tms570
