// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_INTERRUPT_LOCK_HPP
#define HAL_HOST_INTERRUPT_LOCK_HPP

#include "hal/api/interrupt_lock.hpp"

#include <csignal>

namespace counterpoint::host
{

/// Interrupts of a process are its signals: while it is locked all signals wait, but for those that stand for
/// exceptions. For a process with one thread. [SRS_STS_012]
class HostInterruptLock final : public hal::InterruptLock
{
  public:
    void Lock() noexcept override;
    void Unlock() noexcept override;

  private:
    sigset_t before_{};
};

} // namespace counterpoint::host

#endif
