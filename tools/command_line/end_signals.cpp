// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/command_line/end_signals.hpp"

#include "tools/command_line/command.hpp"

#include <csignal>
#include <unistd.h>

namespace counterpoint::tools
{
namespace
{
constexpr unsigned kPatienceSeconds = 2U;

volatile std::sig_atomic_t is_asked = 0;
volatile std::sig_atomic_t is_wait_limited = 0;
volatile std::sig_atomic_t is_limit_running = 0;

/// At Ctrl-C it waits for the reader as long as it takes, for he sits before it.
void Ask(const int signal)
{
    is_asked = 1;
    const bool is_limit = (signal == SIGTERM) && (is_wait_limited != 0) && (is_limit_running == 0);
    is_limit_running = is_limit ? 1 : is_limit_running;
    static_cast<void>(is_limit ? ::alarm(kPatienceSeconds) : 0U);
}

void GiveUp(int /*signal*/)
{
    ::_exit(static_cast<int>(ExitStatus::kBadInput));
}
} // namespace

void LimitWaitForReader()
{
    static_cast<void>(std::signal(SIGALRM, &GiveUp));
    is_wait_limited = 1;
}

EndSignals::EndSignals()
{
    is_asked = 0;
    before_int_ = std::signal(SIGINT, &Ask);
    before_term_ = std::signal(SIGTERM, &Ask);
}

EndSignals::~EndSignals()
{
    static_cast<void>(std::signal(SIGINT, before_int_));
    // A second SIGTERM, as timeout sends it, must not cut off what is written last: that has its limit.
    if (is_limit_running == 0)
    {
        static_cast<void>(std::signal(SIGTERM, before_term_));
    }
}

bool EndSignals::IsAsked() const noexcept
{
    return is_asked != 0;
}
} // namespace counterpoint::tools
