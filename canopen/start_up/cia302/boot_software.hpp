// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_BOOT_SOFTWARE_HPP
#define CANOPEN_START_UP_CIA302_BOOT_SOFTWARE_HPP

#include "canopen/start_up/cia302/boot_transfer.hpp"

namespace counterpoint::cia302
{

constexpr std::uint32_t kFlashCheckUs = 100'000U; ///< Between two readings of 1F57h.
constexpr std::uint16_t kMaxFlashChecks = 600U;   ///< A minute; then the update has failed.
constexpr std::uint8_t kMaxUpdates = 3U;          ///< That the slave's own restarts broke off.

/// The slave has the software that is expected, or gets it: letters G, H, I.
class BootSoftware
{
  public:
    explicit BootSoftware(SdoPool& sdo) noexcept : sdo_(sdo), transfer_(sdo)
    {
    }

    /// @brief The work of one call in the states kSoftwareId to kSoftwareTime.
    [[nodiscard]] BootFinding Check(const BootJob& job) noexcept;
    /// @brief Likewise, kProgramStop to kProgramStarted.
    [[nodiscard]] BootFinding Update(const BootJob& job) noexcept;

  private:
    [[nodiscard]] BootFinding Load(const BootJob& job, SdoMode mode) noexcept;
    [[nodiscard]] BootFinding CheckFlash(const BootJob& job) noexcept;

    SdoPool& sdo_;
    BootTransfer transfer_;
};

} // namespace counterpoint::cia302

#endif
