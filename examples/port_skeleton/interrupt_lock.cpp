// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "interrupt_lock.hpp"

namespace port_skeleton
{

void InterruptLock::Lock() noexcept
{
}

void InterruptLock::Unlock() noexcept
{
}

PartState InterruptLock::State() const noexcept
{
    return PartState::kMissing;
}

} // namespace port_skeleton
