// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/tms570/start/exceptions.hpp"

#include "hal/tms570/probe.hpp"

namespace
{

constexpr std::uint32_t kWordBits = 32U;

/// Neither cleared nor set by start-up; its seal says whether it is a record at all.
[[gnu::section(".noinit.exception")]] counterpoint::hal::ExceptionStorage storage; // MISRA D-007

} // namespace

namespace counterpoint::tms570
{

hal::ExceptionMemory LastException() noexcept
{
    return hal::ExceptionMemory{storage};
}

} // namespace counterpoint::tms570

extern "C" [[noreturn]] void ProbeReturn() noexcept; // hal/tms570/silicon/probe.S

extern "C" void FirmwareException(const std::uint32_t cause, const std::uint32_t accessed,
                                  const std::uint32_t place) noexcept
{
    const auto why = static_cast<counterpoint::hal::ExceptionCause>(cause);
    if (counterpoint::tms570::IsProvoked(counterpoint::tms570::AbortFacts{why, accessed, place}))
    {
        ProbeReturn();
    }
    HardwareCutOff();
    counterpoint::hal::ExceptionMemory memory = counterpoint::tms570::LastException();
    memory.Record(why, (std::uint64_t{place} << kWordBits) | accessed);
    HardwareStop();
}
