// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/tms570/output/cut_off.hpp"

#include "hal/tms570/can/dcan_registers.hpp"
#include "hal/tms570/chip/variant.hpp"
#include "hal/tms570/diagnosis/esm.hpp"
#include "hal/tms570/output/gio_registers.hpp"

namespace counterpoint::tms570
{

namespace
{

constexpr std::uint32_t kAllPins = 0xFFU;

} // namespace

void CloseAllPins() noexcept
{
    Write(At(gio::kPortA, gio::kClear), kAllPins);
    Write(At(gio::kPortB, gio::kClear), kAllPins);
    Write(At(gio::kPortA, gio::kDirection), 0U);
    Write(At(gio::kPortB, gio::kDirection), 0U);
}

void CutOffEverything() noexcept
{
    CloseAllPins();
    ForceErrorPin();
    Write(At(kDcan1Base, dcan::kControl), dcan::kControlInit | dcan::kControlParityOn);
    Write(At(kDcan2Base, dcan::kControl), dcan::kControlInit | dcan::kControlParityOn);
}

} // namespace counterpoint::tms570
