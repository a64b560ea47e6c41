// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_SAFE_STATE_LATCH_HPP
#define SAFETY_CORE_KERNEL_SAFE_STATE_LATCH_HPP

#include "safety_core/contract/device_fault.hpp"

#include <cstdint>

namespace counterpoint
{

/// Device safe state: one way in, Start alone leads out. Runs only while `word_` is the running pattern and `inverse_`
/// its complement; zero-filled or corrupted memory is the safe state. [SRS_KRN_003]
class SafeStateLatch
{
  public:
    /// @brief Leaves the safe state; only Kernel::Start calls this.
    void Arm() noexcept;
    /// @brief The power-on state: safe, no fault recorded.
    void Disarm() noexcept
    {
        word_ = 0U;
        inverse_ = 0U;
        report_ = DeviceFaultReport{DeviceFault::kInvalid, kNoSlot, 0U};
    }
    /// @brief Enters the device safe state; the first fault is kept. A fault of kNone has no effect.
    void Enter(DeviceFault fault, SlotIndex slot) noexcept;
    /// @brief Enter, for who looks in each cycle: without a fault there is no call.
    void Take(const DeviceFault fault, const SlotIndex slot) noexcept
    {
        if (fault != DeviceFault::kNone)
        {
            Enter(fault, slot);
        }
    }
    /// @brief Enter, for who asks once and not in every cycle. A word is spoiled first, by a statement of its own:
    /// neither a lost call of Enter nor a lost decision in it keeps this running. [SRS_KRN_031]
    void Demand(const DeviceFault fault) noexcept
    {
        inverse_ = 0U;
        Enter(fault, kNoSlot);
    }
    /// @brief All bits set while running, no bit otherwise.
    [[nodiscard]] SrdoMask Gate() noexcept
    {
        return IsRunning() ? ~SrdoMask{0U} : SrdoMask{0U};
    }
    /// @brief 0 while running, something else otherwise: spoils the kernel's permit. [SRS_KRN_005]
    [[nodiscard]] std::uint32_t Spoiler() noexcept
    {
        Settle();
        return (word_ ^ kRunning) | (inverse_ ^ ~kRunning);
    }
    /// @brief Both words say so; anything else is the device safe state, and stays it. [SRS_KRN_041]
    [[nodiscard]] bool IsRunning() noexcept
    {
        Settle();
        return SaysRunning();
    }
    /// @brief What both words say now; for who looks and decides nothing by it.
    [[nodiscard]] bool SaysRunning() const noexcept
    {
        return (word_ == kRunning) && (inverse_ == ~kRunning);
    }
    /// @brief The first fault, and how many there were. kNone while running; kInvalid where the words say safe and
    /// nobody entered a fault.
    [[nodiscard]] DeviceFaultReport Report() const noexcept;

  private:
    /// @brief A bit that was otherwise and comes back does not start the device again: no single bit leads from here to
    /// the running pattern.
    void Settle() noexcept
    {
        if (!SaysRunning())
        {
            word_ = kSafe;
            inverse_ = kSafe;
        }
    }

    static constexpr std::uint32_t kSafe = 0U;
    static constexpr std::uint32_t kRunning = 0x5A5A5A5AU;

    std::uint32_t word_{0U};
    std::uint32_t inverse_{0U};
    DeviceFaultReport report_{DeviceFault::kInvalid, kNoSlot, 0U};
};

} // namespace counterpoint

#endif
