// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The functions of hal/tms570/chip/registers.hpp, processor.hpp and probe.hpp over the register models.
#include "hal/tms570/chip/processor.hpp"
#include "hal/tms570/chip/registers.hpp"
#include "hal/tms570/probe.hpp"
#include "verification/models/tms570/machine.hpp"

namespace counterpoint::tms570
{

namespace
{

using model::Machine;

constexpr std::uint32_t kProbeInstruction = 0x00001234U;
constexpr std::uint32_t kOtherInstruction = 0x00005678U;

/// What start-up's handler does with an abort.
void Abort(const std::uint32_t instruction) noexcept
{
    const model::AbortLine line = Machine::Current().TakeAbort();
    if (line.is_raised && !IsProvoked(AbortFacts{hal::ExceptionCause::kDataAccess, line.accessed, instruction}))
    {
        ++Machine::Current().real_aborts;
    }
}

} // namespace

std::uint32_t Read(const Register place) noexcept
{
    const std::uint32_t value = Machine::Current().Read(place.address);
    Abort(kOtherInstruction);
    Machine::Current().OfferInterrupts();
    return value;
}

void Write(const Register place, const std::uint32_t value) noexcept
{
    Machine::Current().Write(place.address, value);
    Machine::Current().OfferInterrupts();
}

std::uint32_t Probe(const Register place) noexcept
{
    const std::uint32_t value = Machine::Current().Read(place.address);
    Abort(kProbeInstruction);
    return value;
}

std::uint32_t ProbeInstruction() noexcept
{
    return kProbeInstruction;
}

std::uint32_t ReadProcessor(const ProcessorRegister which) noexcept
{
    return Machine::Current().processor.Read(which);
}

void WriteProcessor(const ProcessorRegister which, const std::uint32_t value) noexcept
{
    Machine::Current().processor.Write(which, value);
}

void WriteRegionAccess(const std::uint32_t region, const std::uint32_t access) noexcept
{
    Machine::Current().processor.WriteAccess(region, access);
}

void Synchronise() noexcept
{
}

void WaitForInterrupt() noexcept
{
    Machine::Current().Sleep();
}

std::uint32_t LockInterrupts() noexcept
{
    const bool was_locked = Machine::Current().interrupts_locked;
    Machine::Current().interrupts_locked = true;
    return was_locked ? 1U : 0U;
}

void UnlockInterrupts(const std::uint32_t before) noexcept
{
    Machine::Current().interrupts_locked = before != 0U;
}

} // namespace counterpoint::tms570
