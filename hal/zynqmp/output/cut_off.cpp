// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/zynqmp/output/cut_off.hpp"

#include "hal/zynqmp/can/canps_registers.hpp"
#include "hal/zynqmp/output/gpio_registers.hpp"

namespace counterpoint::zynqmp
{

void CloseAllPins() noexcept
{
    for (std::uint32_t bank = 0U; bank < gpio::kBanks; ++bank)
    {
        Write(gpio::Output(bank), 0U);
        Write(gpio::Direction(bank), 0U);
        Write(gpio::OutputEnable(bank), 0U);
    }
}

void CutOffEverything() noexcept
{
    CloseAllPins();
    Write(At(canps::kCan0, canps::kReset), canps::kResetNow);
    Write(At(canps::kCan1, canps::kReset), canps::kResetNow);
}

} // namespace counterpoint::zynqmp
