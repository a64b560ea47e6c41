// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_BOOT_CONFIGURATION_HPP
#define CANOPEN_START_UP_CIA302_BOOT_CONFIGURATION_HPP

#include "canopen/start_up/cia302/boot_transfer.hpp"

namespace counterpoint::cia302
{

/// Writes the configuration of a slave during its boot. A failure is letter J.
class BootConfiguration
{
  public:
    /// @brief The parts are kept by reference.
    explicit BootConfiguration(const StartUpParts& parts) noexcept : parts_(parts), transfer_(parts.sdo)
    {
    }

    /// @brief The work of one call in the states kConfigurationDate to kRestoreReset, kText and kConcise.
    [[nodiscard]] BootFinding Work(const BootJob& job) noexcept;

  private:
    [[nodiscard]] BootFinding CompareDate(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding Restore(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding ResetRestored(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding WriteText(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding WriteConcise(const BootJob& job) noexcept;

    StartUpParts parts_;
    BootTransfer transfer_;
};

/// @brief Whether no defaults are to be restored in this boot.
[[nodiscard]] inline bool IsRestoreUnasked(const BootJob& job) noexcept
{
    return !job.setup.Has(kRestoreDefaults) || (job.setup.restore_sub == 0U) || job.record.is_resumed;
}

} // namespace counterpoint::cia302

#endif
