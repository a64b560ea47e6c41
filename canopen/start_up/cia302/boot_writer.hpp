// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_BOOT_WRITER_HPP
#define CANOPEN_START_UP_CIA302_BOOT_WRITER_HPP

#include "canopen/start_up/cia302/boot_transfer.hpp"

namespace counterpoint::cia302
{

constexpr std::uint32_t kFlashCheckUs = 100'000U; ///< Between two readings of 1F57h.
constexpr std::uint16_t kMaxFlashChecks = 600U;   ///< Readings of 1F57h before the update has failed: a minute.
/// How often an update is begun again after the slave's own restarts broke it off.
constexpr std::uint8_t kMaxUpdates = 3U;

/// Checks the software of a slave during its boot, updates it if that is wanted (failures are letters G, H and I), and
/// writes its configuration (letter J).
class BootWriter
{
  public:
    /// @brief The parts are kept by reference.
    explicit BootWriter(const StartUpParts& parts) noexcept : parts_(parts), transfer_(parts.sdo)
    {
    }

    /// @brief The work of one call in the states kSoftwareId to kSoftwareTime.
    [[nodiscard]] BootFinding Check(const BootJob& job) noexcept;
    /// @brief The work of one call in the states kProgramStop to kProgramStarted.
    [[nodiscard]] BootFinding Update(const BootJob& job) noexcept;
    /// @brief The work of one call in the states kConfigurationDate to kRestoreReset, kText and kConcise.
    [[nodiscard]] BootFinding Configure(const BootJob& job) noexcept;

  private:
    [[nodiscard]] BootFinding Load(const BootJob& job, SdoMode mode) noexcept;
    [[nodiscard]] BootFinding CheckFlash(const BootJob& job) noexcept;
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
