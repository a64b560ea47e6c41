// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/zynqmp/chip/registers.hpp"

namespace counterpoint::zynqmp
{

Outcome WaitFor(const Register place, const Bits bits, const Looks most) noexcept
{
    for (std::uint32_t look = 0U; look < most.count; ++look)
    {
        if ((Read(place) & bits.mask) == bits.value)
        {
            return Outcome::kDone;
        }
    }
    return Outcome::kFailed;
}

Outcome WriteChecked(const Register place, const std::uint32_t value, const std::uint32_t mask) noexcept
{
    Write(place, value);
    return ((Read(place) & mask) == (value & mask)) ? Outcome::kDone : Outcome::kFailed;
}

} // namespace counterpoint::zynqmp
