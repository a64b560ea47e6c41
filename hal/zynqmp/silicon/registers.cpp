// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The registers of a controller: one volatile access each, the only place where an address becomes a pointer.
#include "hal/zynqmp/chip/registers.hpp"

namespace counterpoint::zynqmp
{

std::uint32_t Read(const Register place) noexcept
{
    return *reinterpret_cast<const volatile std::uint32_t*>(place.address); // MISRA D-004
}

void Write(const Register place, const std::uint32_t value) noexcept
{
    *reinterpret_cast<volatile std::uint32_t*>(place.address) = value; // MISRA D-004
}

} // namespace counterpoint::zynqmp
