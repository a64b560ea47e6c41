// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "clocks.hpp"

#include "registers.hpp"

namespace port_fifo
{

namespace
{

constexpr std::uint64_t kCyclesPerMicrosecond = 80U;
constexpr std::uint32_t kWordBits = 32U;

} // namespace

counterpoint::InstantPair Clocks::Now() noexcept
{
    // 64 bits are divided: 32 bits of cycles wrap after 53 s, which is no wrap of microseconds.
    const std::uint64_t low = ReadRegister(kTimerA);
    const std::uint32_t b = ReadRegister(kTimerB);
    const std::uint64_t high = ReadRegister(kTimerAHigh);
    const std::uint64_t us = ((high << kWordBits) | low) / kCyclesPerMicrosecond;
    return counterpoint::InstantPair{{static_cast<std::uint32_t>(us)}, {b}};
}

} // namespace port_fifo
