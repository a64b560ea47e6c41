// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/interrupt_lock.hpp"

#include "hal/host/exceptions.hpp"

namespace counterpoint::host
{

void HostInterruptLock::Lock() noexcept
{
    sigset_t all{};
    sigfillset(&all);
    for (const HostException& exception : kHostExceptions)
    {
        sigdelset(&all, exception.signal);
    }
    pthread_sigmask(SIG_BLOCK, &all, &before_);
}

void HostInterruptLock::Unlock() noexcept
{
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

} // namespace counterpoint::host
