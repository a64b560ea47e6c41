// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_MASTER_HPP
#define CANOPEN_START_UP_CIA302_MASTER_HPP

#include "canopen/start_up/cia302/boot_slave.hpp"
#include "canopen/start_up/cia302/master_steps.hpp"

namespace counterpoint::cia302
{

/// The master while it starts the network: the resets, the boots of all, its own start and that of the slaves. Its
/// steps are kRows of master_steps.hpp. Parts and boots are kept by reference. [SRS_BOOT_001, SRS_BOOT_002,
/// SRS_BOOT_015, SRS_BOOT_016]
class Cia302Master
{
  public:
    Cia302Master(const StartUpParts& parts, BootSlave& boot) noexcept;

    /// @brief From the resets on; all slaves are at rest. `reset`: reset node hits all, reset communication spares
    /// slaves that are kept alive.
    void Begin(NmtCommand reset, const BootTime& time) noexcept;
    void End(Instant now) noexcept;
    /// @brief Resets that wait; when all have left, the boots begin. Nothing in other steps.
    void SendResets(const BootTime& time) noexcept;
    /// @brief Boots all that are listed and do not boot yet: the resets have left, or the application sent them.
    void BootAll(const BootTime& time) noexcept;
    /// @brief The start of the slaves that waits for the queue, if any.
    void SendStart(const BootTime& time) noexcept;
    /// @brief Follows the mandatory slaves if there is news. At the end of a call, not inside a boot.
    void GoOn(const BootTime& time) noexcept;
    /// @brief A boot ended.
    void OnNews() noexcept;
    /// @brief A command for this device itself.
    [[nodiscard]] NmtAnswer CommandOwn(NmtCommand command, const BootTime& time) noexcept;
    /// @brief The application started all, or took all out of OPERATIONAL.
    void Go(MasterEvent event, Instant now) noexcept;
    /// @brief Error handling stopped all nodes.
    void Stop(Instant now) noexcept;

    [[nodiscard]] MasterStep Step() const noexcept
    {
        return step_;
    }
    [[nodiscard]] bool IsOperational() const noexcept;

  private:
    void StartSlaves(const BootTime& time) noexcept;
    void VerifyRunning(const BootTime& time) noexcept;
    [[nodiscard]] bool HasKeptAlive() const noexcept;
    [[nodiscard]] bool IsEach(std::uint32_t bits, bool is_booted) const noexcept;

    StartUpParts parts_;
    BootSlave& boot_;
    MasterStep step_;
    NmtCommand reset_;    ///< Of the running kReset.
    std::uint8_t cursor_; ///< Next node to be reset; 0: all at once.
    bool is_start_due_;   ///< The slaves are to be started together.
    bool has_news_;       ///< A boot ended since the master looked.
};

} // namespace counterpoint::cia302

#endif
