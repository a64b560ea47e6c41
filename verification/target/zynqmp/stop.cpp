// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Where an exception ends a program that measures: it tells what hal/zynqmp/start recorded.
#include "hal/zynqmp/start/exceptions.hpp"
#include "verification/target/target.hpp"

extern "C" void HardwareStop() noexcept
{
    using namespace counterpoint::target;
    const counterpoint::hal::ExceptionRecord record = counterpoint::zynqmp::LastException().Read();
    Write("FAILURE: exception ");
    WriteNumber(static_cast<std::uint32_t>(record.cause));
    Write(" accessed 0x");
    WriteHex(record.address_low);
    Write(" at 0x");
    WriteHex(record.address_high);
    Write("\n");
    Exit(1U);
}
