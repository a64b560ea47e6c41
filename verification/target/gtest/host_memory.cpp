// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The cells of this program for the tests of the self tests, in place of hal/host/memory.cpp, which tells tools of
// a host what it does.
#include "hal/host/memory.hpp"

#include "hal/api/plain_memory.hpp"

namespace counterpoint::host
{

std::uint32_t HostMemory::Read(const hal::Address place) const noexcept
{
    return hal::PlainMemory{}.Read(place);
}

void HostMemory::Write(const hal::Address place, const std::uint32_t value) noexcept
{
    hal::PlainMemory{}.Write(place, value);
}

std::uint32_t HostMemory::Exchange(const hal::Address place, const std::uint32_t value) noexcept
{
    return hal::PlainMemory{}.Exchange(place, value);
}

hal::Address HostMemory::StackPosition() const noexcept
{
    return hal::PlainMemory{}.StackPosition();
}

hal::Address HostMemory::PlaceOf(const void* const object) const noexcept
{
    return hal::PlainMemory{}.PlaceOf(object);
}

} // namespace counterpoint::host
