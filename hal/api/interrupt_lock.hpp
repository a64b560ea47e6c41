// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_API_INTERRUPT_LOCK_HPP
#define HAL_API_INTERRUPT_LOCK_HPP

namespace counterpoint::hal
{

/// Keeps everything else of this processor away from memory for a bounded time. Calls are not nested. [SRS_STS_012]
class InterruptLock
{
  public:
    /// @brief From now on nothing else accesses memory, until Unlock.
    virtual void Lock() noexcept = 0;
    /// @brief Back to what it was before Lock.
    virtual void Unlock() noexcept = 0;

    InterruptLock(const InterruptLock&) = delete;
    InterruptLock(InterruptLock&&) = delete;
    InterruptLock& operator=(const InterruptLock&) = delete;
    InterruptLock& operator=(InterruptLock&&) = delete;

  protected:
    InterruptLock() noexcept = default;
    ~InterruptLock() noexcept = default;
};

} // namespace counterpoint::hal

#endif
