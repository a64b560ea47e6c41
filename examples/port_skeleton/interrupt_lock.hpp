// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_SKELETON_INTERRUPT_LOCK_HPP
#define EXAMPLES_PORT_SKELETON_INTERRUPT_LOCK_HPP

#include "hal/api/interrupt_lock.hpp"
#include "parts.hpp"

namespace port_skeleton
{

/// Interrupts off, for the RAM test.
class InterruptLock final : public counterpoint::hal::InterruptLock
{
  public:
    /// @brief CONTRACT. From its return on nothing else of this processor touches memory: no interrupt, no DMA, no
    /// second core. On a Cortex-M PRIMASK, not BASEPRI, and the fault handlers touch nothing that is tested.
    void Lock() noexcept override;
    /// @brief CONTRACT. Back to what it was before Lock, not simply on.
    void Unlock() noexcept override;

    /// @brief Change it to kThere with the body, and not before.
    [[nodiscard]] PartState State() const noexcept;
};

} // namespace port_skeleton

#endif
