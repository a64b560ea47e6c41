// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_BOOT_SOFTWARE_HPP
#define CANOPEN_START_UP_CIA302_BOOT_SOFTWARE_HPP

#include "canopen/start_up/cia302/boot_transfer.hpp"

namespace counterpoint::cia302
{

constexpr std::uint32_t kFlashCheckUs = 100'000U; ///< Between two readings of 1F57h.
constexpr std::uint16_t kMaxFlashChecks = 600U;   ///< Readings of 1F57h before the update has failed: a minute.
/// How often an update is begun again after the slave's own restarts broke it off.
constexpr std::uint8_t kMaxUpdates = 3U;

/// Checks whether the slave has the expected software, and updates it if that is wanted. Failures are letters G, H and
/// I.
class BootSoftware
{
  public:
    /// @brief `sdo` is kept by reference.
    explicit BootSoftware(SdoPool& sdo) noexcept : sdo_(sdo), transfer_(sdo)
    {
    }

    /// @brief The work of one call in the states kSoftwareId to kSoftwareTime.
    [[nodiscard]] BootFinding Check(const BootJob& job) noexcept;
    /// @brief The work of one call in the states kProgramStop to kProgramStarted.
    [[nodiscard]] BootFinding Update(const BootJob& job) noexcept;

  private:
    [[nodiscard]] BootFinding Load(const BootJob& job, SdoMode mode) noexcept;
    [[nodiscard]] BootFinding CheckFlash(const BootJob& job) noexcept;

    SdoPool& sdo_;
    BootTransfer transfer_;
};

} // namespace counterpoint::cia302

#endif
