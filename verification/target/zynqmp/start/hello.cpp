// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The least program: what the way into an image does, told over the UART.
#include "verification/target/target.hpp"

extern "C" std::uint32_t TargetMain() noexcept;

extern "C" std::uint32_t TargetMain() noexcept
{
    counterpoint::target::Write("hello ");
    counterpoint::target::Write(counterpoint::target::Argument());
    counterpoint::target::Write("\n");
    return 0U;
}
