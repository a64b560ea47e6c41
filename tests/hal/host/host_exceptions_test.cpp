// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/exceptions.hpp"
#include "hal/host/interrupt_lock.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace counterpoint::host
{
namespace
{

/// What the process that meets an exception and the one that looks at it share; survives the first one's end.
struct SharedPage
{
    hal::ExceptionStorage storage;
    std::uint32_t output_open;
    std::uint32_t records_at_cutoff; ///< Whether the record was there when the output went off.
};

class SharedOutput final : public hal::OutputCutoff
{
  public:
    explicit SharedOutput(SharedPage& page) : page_(page)
    {
    }
    void CutOff() noexcept override
    {
        page_.output_open = 0U;
        page_.records_at_cutoff = hal::ExceptionMemory(page_.storage).Read().count;
    }

  private:
    SharedPage& page_;
};

class HostExceptionsTest : public ::testing::Test
{
  protected:
    HostExceptionsTest()
        : page(*static_cast<SharedPage*>(
              mmap(nullptr, 4096U, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)))
    {
        page.output_open = 1U;
    }
    ~HostExceptionsTest() override
    {
        munmap(&page, 4096U);
    }

    /// Runs `offence` in a process of its own with handled exceptions, and waits for its end.
    int StatusAfter(const std::function<void()>& offence)
    {
        const pid_t child = fork();
        if (child == 0)
        {
            SharedOutput output(page);
            hal::ExceptionMemory memory(page.storage);
            const HostExceptions exceptions(output, memory);
            offence();
            _exit(0);
        }
        int status = 0;
        EXPECT_EQ(waitpid(child, &status, 0), child);
        return status;
    }
    /// The output went off first, the record came then, the process ended with 86.
    hal::ExceptionRecord RecordAfter(const std::function<void()>& offence)
    {
        const int status = StatusAfter(offence);
        EXPECT_TRUE(WIFEXITED(status));
        EXPECT_EQ(WEXITSTATUS(status), 86);
        EXPECT_EQ(page.output_open, 0U);
        EXPECT_EQ(page.records_at_cutoff, 0U);
        const hal::ExceptionRecord record = hal::ExceptionMemory(page.storage).Read();
        EXPECT_EQ(record.count, 1U);
        return record;
    }

    SharedPage& page;
};

std::uint64_t AddressOf(const hal::ExceptionRecord& record)
{
    return (static_cast<std::uint64_t>(record.address_high) << 32U) | record.address_low;
}

TEST_F(HostExceptionsTest, AccessToProtectedMemory)
{
    Verifies(req::SRS_STS_051);
    // Given a page that may not be touched
    void* const forbidden = mmap(nullptr, 4096U, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    // When the program writes to its ninth byte
    const hal::ExceptionRecord record =
        RecordAfter([forbidden] { static_cast<volatile std::uint8_t*>(forbidden)[8] = 1U; });
    // Then cause and place are known
    EXPECT_EQ(record.cause, hal::ExceptionCause::kDataAccess);
    EXPECT_EQ(AddressOf(record), reinterpret_cast<std::uintptr_t>(forbidden) + 8U);
    munmap(forbidden, 4096U);
}

TEST_F(HostExceptionsTest, MemoryThatDoesNotAnswer)
{
    Verifies(req::SRS_STS_051);
    // Given a mapped file without the page that is read
    std::FILE* const file = std::tmpfile();
    ASSERT_NE(file, nullptr);
    void* const absent = mmap(nullptr, 4096U, PROT_READ, MAP_SHARED, fileno(file), 0);
    ASSERT_NE(absent, MAP_FAILED);
    const hal::ExceptionRecord record =
        RecordAfter([absent] { static_cast<void>(static_cast<const volatile std::uint8_t*>(absent)[0]); });
    EXPECT_EQ(record.cause, hal::ExceptionCause::kBus);
    EXPECT_EQ(AddressOf(record), reinterpret_cast<std::uintptr_t>(absent));
    munmap(absent, 4096U);
    std::fclose(file);
}

TEST_F(HostExceptionsTest, UndefinedInstruction)
{
    Verifies(req::SRS_STS_051);
    const hal::ExceptionRecord record = RecordAfter([] { __builtin_trap(); });
    EXPECT_EQ(record.cause, hal::ExceptionCause::kInstruction);
}

__attribute__((noinline, no_sanitize("undefined"))) int Divide(const volatile int& dividend,
                                                               const volatile int& divisor)
{
    return dividend / divisor;
}

TEST_F(HostExceptionsTest, DivisionByZero)
{
    Verifies(req::SRS_STS_051);
    const hal::ExceptionRecord record = RecordAfter(
        []
        {
            volatile int one = 1;
            volatile int zero = 0;
            one = Divide(one, zero);
        });
    EXPECT_EQ(record.cause, hal::ExceptionCause::kArithmetic);
}

TEST_F(HostExceptionsTest, ProgramThatGivesUp)
{
    Verifies(req::SRS_STS_051);
    const hal::ExceptionRecord record = RecordAfter([] { std::abort(); });
    EXPECT_EQ(record.cause, hal::ExceptionCause::kProgram);
}

// A chain of calls without end; the array keeps it from becoming a loop.
__attribute__((noinline)) std::uint32_t Deeper(const volatile std::uint32_t* const above, const std::uint32_t depth)
{
    volatile std::uint32_t frame[256] = {};
    frame[depth % 256U] = depth + above[0];
    return (depth == 0xFFFF'FFFFU) ? frame[0] : Deeper(frame, depth + 1U) + frame[1];
}

TEST_F(HostExceptionsTest, OverflowingStackIsHandledOnAStackOfItsOwn)
{
    Verifies(req::SRS_STS_051);
    const hal::ExceptionRecord record = RecordAfter(
        []
        {
            const volatile std::uint32_t first = 0U;
            static_cast<void>(Deeper(&first, 0U));
        });
    EXPECT_EQ(record.cause, hal::ExceptionCause::kDataAccess);
}

TEST_F(HostExceptionsTest, EachSignalHasItsCause)
{
    Verifies(req::SRS_STS_051);
    // Given each signal and what it stands for
    struct Expected
    {
        int signal;
        hal::ExceptionCause cause;
    };
    constexpr Expected kExpected[] = {{SIGSEGV, hal::ExceptionCause::kDataAccess},
                                      {SIGBUS, hal::ExceptionCause::kBus},
                                      {SIGILL, hal::ExceptionCause::kInstruction},
                                      {SIGFPE, hal::ExceptionCause::kArithmetic},
                                      {SIGABRT, hal::ExceptionCause::kProgram}};
    for (const Expected& expected : kExpected)
    {
        // When it comes while interrupts are locked, then it does not wait
        hal::ExceptionMemory(page.storage).Clear();
        const hal::ExceptionRecord record = RecordAfter(
            [&expected]
            {
                HostInterruptLock lock;
                lock.Lock();
                static_cast<void>(raise(expected.signal));
            });
        EXPECT_EQ(record.cause, expected.cause) << "signal " << expected.signal;
    }
}

TEST_F(HostExceptionsTest, AreAsBeforeAfterwards)
{
    Verifies(req::SRS_STS_051);
    // Given exceptions that were handled and no longer are
    const int status = StatusAfter([] { _exit(0); });
    EXPECT_EQ(WEXITSTATUS(status), 0);
    SharedOutput output(page);
    hal::ExceptionMemory memory(page.storage);
    struct sigaction before{};
    sigaction(SIGILL, nullptr, &before);
    {
        const HostExceptions exceptions(output, memory);
        // When somebody else wants to handle them too, then it is refused
        EXPECT_THROW(HostExceptions(output, memory), std::logic_error);
    }
    // Then the program's own handling is back, and the output was never touched
    struct sigaction after{};
    sigaction(SIGILL, nullptr, &after);
    EXPECT_EQ(after.sa_handler, before.sa_handler);
    EXPECT_EQ(page.output_open, 1U);
}

volatile std::sig_atomic_t interrupts = 0;
void CountInterrupt(int /*signal*/)
{
    interrupts = interrupts + 1;
}

TEST(HostInterruptLock, InterruptsWaitUntilUnlocked)
{
    Verifies(req::SRS_STS_012);
    // Given a handled interrupt
    struct sigaction action{};
    action.sa_handler = &CountInterrupt;
    struct sigaction before{};
    sigaction(SIGUSR1, &action, &before);
    HostInterruptLock lock;
    // When it comes while locked, then it waits
    lock.Lock();
    static_cast<void>(raise(SIGUSR1));
    EXPECT_EQ(interrupts, 0);
    // and comes after it
    lock.Unlock();
    EXPECT_EQ(interrupts, 1);
    sigaction(SIGUSR1, &before, nullptr);
}

} // namespace
} // namespace counterpoint::host
