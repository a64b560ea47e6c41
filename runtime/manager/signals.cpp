// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/signals.hpp"

#include <csignal>

namespace counterpoint::runtime
{
namespace
{
volatile std::sig_atomic_t caught_signal = 0;

void Catch(const int number)
{
    caught_signal = number;
}
} // namespace

CaughtSignals::CaughtSignals() : before_int_(SIG_DFL), before_term_(SIG_DFL), before_hup_(std::signal(SIGHUP, SIG_IGN))
{
    caught_signal = 0;
    static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
    before_int_ = std::signal(SIGINT, &Catch);
    before_term_ = std::signal(SIGTERM, &Catch);
    if (before_hup_ != SIG_IGN)
    {
        static_cast<void>(std::signal(SIGHUP, &Catch));
    }
}

CaughtSignals::~CaughtSignals()
{
    static_cast<void>(std::signal(SIGINT, before_int_));
    static_cast<void>(std::signal(SIGTERM, before_term_));
    static_cast<void>(std::signal(SIGHUP, before_hup_));
}

bool CaughtSignals::IsCaught() noexcept
{
    return caught_signal != 0;
}
} // namespace counterpoint::runtime
