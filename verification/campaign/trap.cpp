// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/trap.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <initializer_list>
#include <sys/time.h>
#include <sys/wait.h>

namespace counterpoint::campaign
{
namespace
{
constexpr suseconds_t kTickUs = 50000;
/// A run of the longest kind takes a few milliseconds of processor time.
constexpr int kMostTicks = 8;
constexpr std::size_t kStackBytes = 65536U;

sigjmp_buf return_place;
volatile std::sig_atomic_t is_armed = 0;
volatile std::sig_atomic_t ticks = 0;
std::array<char, kStackBytes> stack{};

extern "C" void OnException(const int number)
{
    if (is_armed == 0)
    {
        signal(number, SIG_DFL); // A defect of the campaign itself.
        return;
    }
    siglongjmp(return_place, static_cast<int>(Return::kException));
}

extern "C" void OnTick(const int /*number*/)
{
    ticks = ticks + 1;
    if (is_armed != 0 && ticks >= kMostTicks)
    {
        siglongjmp(return_place, static_cast<int>(Return::kNever));
    }
}

constexpr std::initializer_list<int> kExceptions{SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGTRAP};

void SetTimer(const suseconds_t tick)
{
    const itimerval timer{{0, tick}, {0, tick}};
    setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}
} // namespace

Trap::Trap()
{
    stack_t other{};
    other.ss_sp = stack.data();
    other.ss_size = stack.size();
    sigaltstack(&other, nullptr);
    struct sigaction action = {};
    action.sa_flags = SA_ONSTACK | SA_NODEFER;
    action.sa_handler = &OnException;
    for (const int number : kExceptions)
    {
        sigaction(number, &action, nullptr);
    }
    action.sa_handler = &OnTick;
    sigaction(SIGVTALRM, &action, nullptr);
    SetTimer(kTickUs);
}

Trap::~Trap()
{
    SetTimer(0);
    for (const int number : kExceptions)
    {
        signal(number, SIG_DFL);
    }
    signal(SIGVTALRM, SIG_DFL);
    stack_t none{};
    none.ss_flags = SS_DISABLE;
    sigaltstack(&none, nullptr);
}

sigjmp_buf& Trap::Place() noexcept
{
    return return_place;
}

void Trap::Arm() noexcept
{
    ticks = 0;
    is_armed = 1;
}

void Trap::Disarm() noexcept
{
    is_armed = 0;
}

bool IsEndFromOutside(const int status) noexcept
{
    return WIFSIGNALED(status) &&
           std::find(kExceptions.begin(), kExceptions.end(), WTERMSIG(status)) == kExceptions.end();
}
} // namespace counterpoint::campaign
