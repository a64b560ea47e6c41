// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A firmware example on the host: the scenario's file is the program's argument. No memory protection.
#include "hal/absent/absent.hpp"
#include "verification/target/firmware/meter.hpp"
#include "verification/target/firmware/simulated_device.hpp"
#include "verification/target/target.hpp"

extern "C" std::uint32_t TargetMain() noexcept;

namespace counterpoint::target
{

std::uint32_t ReadMeter() noexcept
{
    return 0U;
}

} // namespace counterpoint::target

extern "C" std::uint32_t TargetMain() noexcept
{
    static char text[16384]{};
    if (!counterpoint::target::ReadText(counterpoint::target::Argument(), text, sizeof text))
    {
        counterpoint::target::Write("FAILURE: the scenario cannot be read\n");
        return 2U;
    }
    counterpoint::hal::AbsentMemoryProtection protection{};
    static counterpoint::target::SimulatedDevice device{protection};
    return device.Run(text, counterpoint::firmware::RunNonSafety) ? 0U : 1U;
}
