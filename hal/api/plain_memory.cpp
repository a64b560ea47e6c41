// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/api/plain_memory.hpp"

namespace counterpoint::hal
{

namespace
{

[[nodiscard]] volatile std::uint32_t& At(const Address place) noexcept
{
    return *reinterpret_cast<volatile std::uint32_t*>(place); // MISRA D-003
}

} // namespace

std::uint32_t PlainMemory::Read(const Address place) const noexcept
{
    return At(place);
}

void PlainMemory::Write(const Address place, const std::uint32_t value) noexcept
{
    At(place) = value;
}

std::uint32_t PlainMemory::Exchange(const Address place, const std::uint32_t value) noexcept
{
    volatile std::uint32_t& word = At(place);
    const std::uint32_t before = word;
    word = value;
    return before;
}

Address PlainMemory::StackPosition() const noexcept
{
    return reinterpret_cast<Address>(__builtin_frame_address(0)); // MISRA D-003
}

Address PlainMemory::PlaceOf(const void* const object) const noexcept
{
    return reinterpret_cast<Address>(object); // MISRA D-003
}

} // namespace counterpoint::hal
