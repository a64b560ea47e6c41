// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_BOOT_RESET_HPP
#define CANOPEN_START_UP_CIA302_BOOT_RESET_HPP

#include "canopen/start_up/cia302/boot_record.hpp"

namespace counterpoint::cia302
{

/// What CiA 302-2 leaves to the master: from a reset to the boot-up message (kResetUs), at most, while SDOs of other
/// slaves keep the bus busy,
constexpr std::uint32_t kCrowdedUs = 10'000'000U;
constexpr std::uint32_t kCrowdedTimeOuts = 20U; ///< or as many SDO time-outs, which are long where the bus is slow.

/// The reset before a boot, and the boot-up messages that its states wait for.
class BootReset
{
  public:
    explicit BootReset(const StartUpParts& parts) noexcept : parts_(parts)
    {
    }

    /// @brief The work of one call in the states kResetDue, kResetSent, kUnheard, kStateReset and kRestored.
    [[nodiscard]] BootFinding Work(const BootJob& job) noexcept;

  private:
    [[nodiscard]] BootFinding Send(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding AwaitBootUp(const BootJob& job) noexcept;
    [[nodiscard]] bool IsSilent(const BootJob& job) noexcept;

    StartUpParts parts_;
};

/// @brief How the boot of this slave begins.
[[nodiscard]] inline BootEvent BeginOf(const SlaveSetup& setup) noexcept
{
    return setup.Has(kBootSlave) ? BootEvent::kBegin : BootEvent::kBeginUnasked;
}

} // namespace counterpoint::cia302

#endif
