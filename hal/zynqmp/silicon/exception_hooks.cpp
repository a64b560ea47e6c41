// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What hal/zynqmp/start asks of the hardware after an exception.
#include "hal/tms570/chip/processor.hpp"
#include "hal/zynqmp/output/cut_off.hpp"
#include "hal/zynqmp/start/exceptions.hpp"

extern "C" void HardwareCutOff() noexcept
{
    counterpoint::zynqmp::CutOffEverything();
}

extern "C" void HardwareStop() noexcept
{
    // The safe state: outputs closed. The watchdog, which nobody serves any more, resets the controller.
    for (;;)
    {
        counterpoint::tms570::WaitForInterrupt();
    }
}
