// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What hal/tms570/start asks of the hardware after an exception. [SRS_TMS_052]
#include "hal/tms570/chip/processor.hpp"
#include "hal/tms570/output/cut_off.hpp"

extern "C"
{
    void HardwareCutOff() noexcept;
    [[noreturn]] void HardwareStop() noexcept;
}

extern "C" void HardwareCutOff() noexcept
{
    counterpoint::tms570::CutOffEverything();
}

extern "C" void HardwareStop() noexcept
{
    // The safe state: outputs closed, nERROR low. The watchdog, which nobody serves any more, resets the controller.
    for (;;)
    {
        counterpoint::tms570::WaitForInterrupt();
    }
}
