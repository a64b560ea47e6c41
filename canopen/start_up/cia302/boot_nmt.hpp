// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_BOOT_NMT_HPP
#define CANOPEN_START_UP_CIA302_BOOT_NMT_HPP

#include "canopen/start_up/cia302/boot_record.hpp"

namespace counterpoint::cia302
{

/// CiA 302-2 leaves open how long a boot-up message may take after a reset. Usually kResetUs are enough. While SDOs of
/// other slaves keep the bus busy, the master waits for this time, or for kCrowdedTimeOuts, whichever is longer.
constexpr std::uint32_t kCrowdedUs = 10'000'000U;
constexpr std::uint32_t kCrowdedTimeOuts = 20U; ///< SDO time-outs; they are long where the bus is slow.

/// Resets the slave before its boot, waits for the boot-up messages that the states of a boot need, and supervises,
/// verifies and starts the slave at the end of its boot. Failures are letters J and K, and those of another device.
class BootNmt
{
  public:
    /// @brief The parts are kept by reference.
    explicit BootNmt(const StartUpParts& parts) noexcept : parts_(parts)
    {
    }

    /// @brief The work of one call in the states kResetDue, kResetSent, kUnheard, kStateReset and kRestored.
    [[nodiscard]] BootFinding Restart(const BootJob& job) noexcept;
    /// @brief The work of one call in the states kWatch to kGateClosed.
    [[nodiscard]] BootFinding Release(const BootJob& job) noexcept;
    /// @brief The work of one call in the state kStart.
    [[nodiscard]] BootFinding Start(const BootJob& job, bool is_master_operational) noexcept;

  private:
    [[nodiscard]] BootFinding Send(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding AwaitBootUp(const BootJob& job) noexcept;
    [[nodiscard]] bool IsSilent(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding Watch(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding AwaitSign(const BootJob& job) const noexcept;
    [[nodiscard]] BootFinding Verify(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding AwaitGate(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding Refuse(const BootJob& job) noexcept;

    StartUpParts parts_;
};

/// @brief With which event the boot of this slave begins: with its first SDO, or with supervision alone.
[[nodiscard]] inline BootEvent BeginOf(const SlaveSetup& setup) noexcept
{
    return setup.Has(kBootSlave) ? BootEvent::kBegin : BootEvent::kBeginUnasked;
}

} // namespace counterpoint::cia302

#endif
