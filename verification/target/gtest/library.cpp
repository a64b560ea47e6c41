// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the tests need of a library on a target that has none. Memory is given back as a whole after each test.
#include "verification/target/gtest/memory.hpp"
#include "verification/target/target.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>

namespace
{

constexpr std::size_t kArenaBytes = 5U * 1024U * 1024U;
constexpr std::size_t kAlignment = 8U;
constexpr std::size_t kGreatestAlignment = 256U;

alignas(kGreatestAlignment) std::uint8_t arena[kArenaBytes];
std::size_t arena_used = 0U;
const char* user_suite = "";
const char* user_name = "";

void* Allocate(const std::size_t bytes, const std::size_t alignment = kAlignment) noexcept
{
    const std::size_t rounded = (bytes + (kAlignment - 1U)) & ~(kAlignment - 1U);
    arena_used = (arena_used + (alignment - 1U)) & ~(alignment - 1U);
    if (alignment > kGreatestAlignment || (kArenaBytes - arena_used) < rounded)
    {
        counterpoint::target::Write("FAILURE: a test needs more memory than there is, or an alignment above 256: ");
        counterpoint::target::Write(user_suite);
        counterpoint::target::Write(".");
        counterpoint::target::Write(user_name);
        counterpoint::target::Write("\n");
        counterpoint::target::Exit(1U);
    }
    void* const place = &arena[arena_used];
    arena_used += rounded;
    return place;
}

[[noreturn]] void GiveUp(const char* const why) noexcept
{
    counterpoint::target::Write("FAILURE: ");
    counterpoint::target::Write(why);
    counterpoint::target::Write("\n");
    counterpoint::target::Exit(1U);
}

} // namespace

namespace counterpoint::target
{

std::size_t MarkMemory() noexcept
{
    return arena_used;
}

void NameMemoryUser(const char* const suite, const char* const name) noexcept
{
    user_suite = suite;
    user_name = name;
}

void ReleaseMemory(const std::size_t mark) noexcept
{
    arena_used = mark;
}

} // namespace counterpoint::target

template class std::basic_string<char>;

void* operator new(const std::size_t bytes)
{
    return Allocate(bytes);
}

void* operator new[](const std::size_t bytes)
{
    return Allocate(bytes);
}

void* operator new(const std::size_t bytes, const std::align_val_t alignment)
{
    return Allocate(bytes, static_cast<std::size_t>(alignment));
}

void operator delete(void* /*place*/, std::size_t /*bytes*/, std::align_val_t /*alignment*/) noexcept
{
}

void operator delete(void* /*place*/, std::align_val_t /*alignment*/) noexcept
{
}

void operator delete(void* /*place*/) noexcept
{
}

void operator delete(void* /*place*/, std::size_t /*bytes*/) noexcept
{
}

void operator delete[](void* /*place*/) noexcept
{
}

void operator delete[](void* /*place*/, std::size_t /*bytes*/) noexcept
{
}

namespace std
{

void __throw_length_error(const char* const why)
{
    GiveUp(why);
}
void __throw_logic_error(const char* const why)
{
    GiveUp(why);
}
void __throw_out_of_range_fmt(const char* const why, ...)
{
    GiveUp(why);
}
void __throw_bad_alloc()
{
    GiveUp("bad_alloc");
}
void __throw_bad_array_new_length()
{
    GiveUp("bad_array_new_length");
}
void __throw_bad_function_call()
{
    GiveUp("bad_function_call");
}

} // namespace std

extern "C"
{
    void* __dso_handle = nullptr;

    int __cxa_atexit(void (* /*destructor*/)(void*), void* /*object*/, void* /*handle*/)
    {
        return 0; // Nothing is destroyed: the emulation ends.
    }

    int __aeabi_atexit(void* /*object*/, void (* /*destructor*/)(void*), void* /*handle*/)
    {
        return 0;
    }

    std::size_t strlen(const char* const text)
    {
        std::size_t length = 0U;
        while (text[length] != '\0')
        {
            ++length;
        }
        return length;
    }

    void abort()
    {
        GiveUp("abort");
    }
}
