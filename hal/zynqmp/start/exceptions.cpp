// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/zynqmp/start/exceptions.hpp"

namespace
{

constexpr std::uint32_t kWordBits = 32U;

/// Neither cleared nor set by start-up; its seal says whether it is a record at all.
[[gnu::section(".noinit.exception")]] counterpoint::hal::ExceptionStorage storage; // MISRA D-007

} // namespace

namespace counterpoint::zynqmp
{

hal::ExceptionMemory LastException() noexcept
{
    return hal::ExceptionMemory{storage};
}

} // namespace counterpoint::zynqmp

extern "C" void FirmwareException(const std::uint32_t cause, const std::uint32_t accessed,
                                  const std::uint32_t place) noexcept
{
    HardwareCutOff();
    counterpoint::hal::ExceptionMemory memory = counterpoint::zynqmp::LastException();
    memory.Record(static_cast<counterpoint::hal::ExceptionCause>(cause),
                  (std::uint64_t{place} << kWordBits) | accessed);
    HardwareStop();
}
