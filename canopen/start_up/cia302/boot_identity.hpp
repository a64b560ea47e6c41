// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_BOOT_IDENTITY_HPP
#define CANOPEN_START_UP_CIA302_BOOT_IDENTITY_HPP

#include "canopen/cia302/network/safety_reader.hpp"
#include "canopen/start_up/cia302/boot_transfer.hpp"

namespace counterpoint::cia302
{

constexpr std::uint32_t kAskAgainUs = 1'000'000U;  ///< Between two readings of 1000h.
constexpr std::uint32_t kGuardAnswerUs = 100'000U; ///< From a remote frame to its answer.

/// Finds out whether the slave is there, is the expected device, and may be reset. Failures are letters B to F and M to
/// O.
class BootIdentity
{
  public:
    /// @brief The parts are kept by reference.
    explicit BootIdentity(const StartUpParts& parts) noexcept : parts_(parts), transfer_(parts.sdo), reader_(parts)
    {
    }

    /// @brief The work of one call in the states kTypeFirst to kStateSign.
    [[nodiscard]] BootFinding Work(const BootJob& job) noexcept;

  private:
    [[nodiscard]] BootFinding WakeUp(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding ReadDeviceType(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding Pause(const BootJob& job) const noexcept;
    [[nodiscard]] BootFinding Compare(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding AskState(const BootJob& job) noexcept;
    [[nodiscard]] BootFinding TakeState(const BootJob& job) noexcept;

    StartUpParts parts_;
    BootTransfer transfer_;
    SafetyReader reader_;
};

/// @brief Whether the state check is left out for this slave.
[[nodiscard]] inline bool IsStateUnasked(const BootJob& job) noexcept
{
    return !job.setup.Has(kKeepAlive) || job.record.is_fresh;
}

} // namespace counterpoint::cia302

#endif
