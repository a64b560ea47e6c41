// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The guard on the stack of a thread: only where there are threads.
#include "hal/host/memory.hpp"
#include "safety_core/selftest/stack_guard.hpp"
#include "tests/safety_core/selftest/support.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <pthread.h>
#include <sys/mman.h>

#include <cstdint>

namespace counterpoint::selftest
{
namespace
{

/// Uses at least the given number of bytes of the stack it runs on; a sanitizer would move the array elsewhere.
[[gnu::noinline]] __attribute__((no_sanitize("address"))) void* UseKilobytes(void* const kilobytes)
{
    volatile std::uint8_t frame[1024];
    frame[0] = 1U;
    auto* const left = static_cast<std::uint32_t*>(kilobytes);
    if (*left > 1U)
    {
        --*left;
        UseKilobytes(kilobytes);
    }
    frame[1023] = frame[0];
    return nullptr;
}

TEST(StackGuardOfARealStack, SeesHowDeepAThreadWent)
{
    Verifies(req::SRS_STS_020);
    // Given a real stack of 256 KiB, guarded before it runs
    constexpr std::uint32_t kBytes = 262144U;
    void* const stack = mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    host::HostMemory memory;
    StackGuard guard;
    const auto deepest_of = [&](std::uint32_t kilobytes)
    {
        guard.Restart(StackSetup{{memory.PlaceOf(stack), kBytes / 4U}, 4U}, memory);
        pthread_attr_t attributes{};
        pthread_attr_init(&attributes);
        pthread_attr_setstack(&attributes, stack, kBytes);
        pthread_t thread{};
        EXPECT_EQ(pthread_create(&thread, &attributes, &UseKilobytes, &kilobytes), 0);
        pthread_join(thread, nullptr);
        pthread_attr_destroy(&attributes);
        return guard.HighWaterBytes(memory);
    };
    // When a thread uses 4 and then 64 KiB of it
    const std::uint32_t little = deepest_of(4U);
    const std::uint32_t much = deepest_of(64U);
    // Then the mark tells, and the guard is as it was
    EXPECT_GE(little, 4096U);
    EXPECT_GE(much, little + (59U * 1024U));
    EXPECT_LT(much, kBytes);
    EXPECT_EQ(guard.Check(memory), SliceResult::kPassed);
    munmap(stack, kBytes);
}

} // namespace
} // namespace counterpoint::selftest
