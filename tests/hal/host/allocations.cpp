// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/hal/host/allocations.hpp"

#include <cstddef>
#include <cstdlib>
#include <new>

namespace
{

std::uint64_t allocations = 0U;

} // namespace

void* operator new(const std::size_t size)
{
    ++allocations;
    void* const memory = std::malloc((size > 0U) ? size : 1U);
    if (memory == nullptr)
    {
        throw std::bad_alloc();
    }
    return memory;
}

void operator delete(void* const memory) noexcept
{
    std::free(memory);
}

void operator delete(void* const memory, const std::size_t size) noexcept
{
    static_cast<void>(size);
    std::free(memory);
}

namespace counterpoint::host
{

std::uint64_t Allocations()
{
    return allocations;
}

} // namespace counterpoint::host
