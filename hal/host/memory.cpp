// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/memory.hpp"

#include "hal/host/memcheck/tell.hpp"

namespace counterpoint::host
{

namespace
{

// A test of live memory walks over free stack, gaps between objects and bytes that nobody ever wrote: a sanitizer or
// memcheck would take each for an error, so that both are told.

[[nodiscard]] __attribute__((no_sanitize("address"))) std::uint32_t ReadCell(const hal::Address place)
{
    const volatile std::uint32_t* const cell = reinterpret_cast<const volatile std::uint32_t*>(place); // MISRA D-003
    TellMemcheck(cell);
    return *cell;
}

__attribute__((no_sanitize("address"))) void WriteCell(const hal::Address place, const std::uint32_t value)
{
    volatile std::uint32_t* const cell = reinterpret_cast<volatile std::uint32_t*>(place); // MISRA D-003
    TellMemcheck(cell);
    *cell = value;
}

} // namespace

std::uint32_t HostMemory::Read(const hal::Address place) const noexcept
{
    return ReadCell(place);
}

void HostMemory::Write(const hal::Address place, const std::uint32_t value) noexcept
{
    WriteCell(place, value);
}

std::uint32_t HostMemory::Exchange(const hal::Address place, const std::uint32_t value) noexcept
{
    const std::uint32_t before = ReadCell(place);
    WriteCell(place, value);
    return before;
}

hal::Address HostMemory::StackPosition() const noexcept
{
    return reinterpret_cast<hal::Address>(__builtin_frame_address(0)); // MISRA D-003
}

hal::Address HostMemory::PlaceOf(const void* const object) const noexcept
{
    return reinterpret_cast<hal::Address>(object); // MISRA D-003
}

} // namespace counterpoint::host
