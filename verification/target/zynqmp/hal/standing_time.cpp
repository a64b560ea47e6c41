// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The register accesses of hal/zynqmp/silicon, and a moment from which on both counters stand. The machine's own timer
// is stopped then: it does not survive its roll-over, and nobody sets it back any more.
#include "verification/target/zynqmp/hal/standing_time.hpp"

#include "hal/zynqmp/chip/cycle_counter.hpp"
#include "hal/zynqmp/time/ttc_registers.hpp"

#include <cstdint>

extern "C"
{
    std::uint32_t ProcessorReadCycleControl() noexcept;
    std::uint32_t ProcessorReadCycleEnable() noexcept;
    std::uint32_t ProcessorReadCycleUserMode() noexcept;
    std::uint32_t ProcessorReadCycleCounter() noexcept;
    void ProcessorWriteCycleControl(std::uint32_t value) noexcept;
    void ProcessorWriteCycleEnable(std::uint32_t value) noexcept;
    void ProcessorWriteCycleUserMode(std::uint32_t value) noexcept;
}

namespace
{

using namespace counterpoint::zynqmp;

constexpr std::uint32_t kTimerValue = ttc::kTtc0.address + ttc::kCounterValue;
constexpr std::uint32_t kTimerControl = ttc::kTtc0.address + ttc::kCounterControl;

bool does_stand;
std::uint32_t timer;
std::uint32_t cycles;

volatile std::uint32_t& Word(const std::uint32_t address) noexcept
{
    return *reinterpret_cast<volatile std::uint32_t*>(address);
}

} // namespace

namespace counterpoint::tms570
{

std::uint32_t Read(const Register place) noexcept
{
    if (does_stand && (place.address == kTimerValue))
    {
        return timer;
    }
    return (does_stand && (place.address == kTimerControl)) ? zynqmp::ttc::kWaveformOff : Word(place.address);
}

void Write(const Register place, const std::uint32_t value) noexcept
{
    if (does_stand && (place.address == kTimerControl))
    {
        timer = 0U; // Set back, and it stands there.
        return;
    }
    Word(place.address) = value;
}

} // namespace counterpoint::tms570

namespace counterpoint::zynqmp
{

void SetUpCycles(const CycleSetup& setup) noexcept
{
    ProcessorWriteCycleUserMode(setup.user);
    ProcessorWriteCycleControl(setup.control);
    ProcessorWriteCycleEnable(setup.enabled);
}

CycleSetup ReadCycleSetup() noexcept
{
    return CycleSetup{ProcessorReadCycleControl(), ProcessorReadCycleEnable(), ProcessorReadCycleUserMode()};
}

std::uint32_t ReadCycleCounter() noexcept
{
    return does_stand ? cycles : ProcessorReadCycleCounter();
}

} // namespace counterpoint::zynqmp

namespace counterpoint::target
{

void LetTimeStand() noexcept
{
    timer = Word(kTimerValue);
    cycles = ProcessorReadCycleCounter();
    Word(kTimerControl) = ttc::kWaveformOff | ttc::kStopped;
    does_stand = true;
}

} // namespace counterpoint::target
