// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_BOOT_RELEASE_HPP
#define CANOPEN_START_UP_CIA302_BOOT_RELEASE_HPP

#include "canopen/start_up/cia302/boot_record.hpp"

namespace counterpoint::cia302
{

/// Supervises, verifies and starts the slave at the end of its boot. Failures are letters J and K, and those of another
/// device.
class BootRelease
{
  public:
    /// @brief The parts are kept by reference.
    explicit BootRelease(const StartUpParts& parts) noexcept : parts_(parts)
    {
    }

    /// @brief The work of one call in the states kWatch to kGateClosed.
    [[nodiscard]] BootFinding Work(const BootJob& job) noexcept;
    /// @brief The work of one call in the state kStart.
    [[nodiscard]] BootFinding Start(const BootJob& job, bool is_master_operational) noexcept;

  private:
    [[nodiscard]] BootFinding Watch(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding AwaitSign(const BootJob& job) const noexcept;
    [[nodiscard]] BootFinding Verify(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding AwaitGate(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding Refuse(const BootJob& job) noexcept;

    StartUpParts parts_;
};

} // namespace counterpoint::cia302

#endif
