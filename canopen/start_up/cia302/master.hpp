// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_MASTER_HPP
#define CANOPEN_START_UP_CIA302_MASTER_HPP

#include "canopen/start_up/cia302/boot_slave.hpp"
#include "canopen/start_up/cia302/master_steps.hpp"

namespace counterpoint::cia302
{

/// The master while it starts the network: the resets, the boots of all slaves, its own start and the start of the
/// slaves. What follows which step is the table kRows in master_steps.hpp. Parts and boots are kept by reference.
/// [SRS_BOOT_001, SRS_BOOT_002, SRS_BOOT_015, SRS_BOOT_016]
class Cia302Master
{
  public:
    /// @brief Idle at first.
    Cia302Master(const StartUpParts& parts, BootSlave& boot) noexcept;

    /// @brief Begins with the resets; no boot runs. `reset`: reset node is sent to all, reset communication leaves out
    /// slaves that are kept alive.
    void Begin(NmtCommand reset, const BootTime& time) noexcept;
    /// @brief Ends the start-up: nothing is sent and nobody supervised any more, and nothing known of any slave but who
    /// is held.
    void End(Instant now) noexcept;
    /// @brief No command holds the master or a slave any more: a reset of all was ordered, or the role of the manager
    /// begins or ends. [SRS_BOOT_031, SRS_BOOT_032]
    void Free() noexcept;
    /// @brief Sends the resets that wait; when all have left, the boots begin. Does nothing in other steps.
    void SendResets(const BootTime& time) noexcept;
    /// @brief A reset of all was ordered: as End and Free, and then BootAll.
    void BootAnew(const BootTime& time) noexcept;
    /// @brief Boots all listed slaves that do not boot yet: the resets have left, or the application sent them.
    void BootAll(const BootTime& time) noexcept;
    /// @brief Tells which commands that waited were sent. Once a cycle. O(127) [SRS_BOOT_800, SRS_BOOT_820,
    /// SRS_BOOT_821]
    void TellSent(Instant now) noexcept;
    /// @brief Sends the start of the slaves that waits for room in the queue, if any.
    void SendStart(const BootTime& time) noexcept;
    /// @brief Looks at the mandatory slaves if a boot has ended. Call it at the end of a call, not from within a boot.
    void GoOn(const BootTime& time) noexcept;
    /// @brief A boot has ended.
    void OnNews() noexcept;
    /// @brief Carries out a command for this device itself.
    [[nodiscard]] NmtAnswer CommandOwn(NmtCommand command, const BootTime& time) noexcept;
    /// @brief A command for this device that was handed over. Out of OPERATIONAL it counts also for the start-up that
    /// runs: the master does not start itself. [SRS_BOOT_031]
    void Obey(NmtCommand command, Instant now) noexcept;
    /// @brief Error handling stopped all nodes.
    void Stop(Instant now) noexcept;

    /// @brief The present step.
    [[nodiscard]] MasterStep Step() const noexcept
    {
        return step_;
    }
    /// @brief The step as it is told: one that a command for all makes when that was sent. [SRS_BOOT_821]
    [[nodiscard]] MasterStep ToldStep() const noexcept
    {
        return told_;
    }
    /// @brief Whether the master is OPERATIONAL.
    [[nodiscard]] bool IsOperational() const noexcept;
    /// @brief Whether a start of several leaves somebody out: IsRefused of BootSlave.
    [[nodiscard]] bool IsAnyRefused() const noexcept;

  private:
    void Go(MasterEvent event, Instant now) noexcept;
    void TellStep(Instant now) noexcept;
    void Forget() noexcept;
    void StartSlaves(const BootTime& time) noexcept;
    void VerifyRunning(const BootTime& time) noexcept;
    [[nodiscard]] bool HasKeptAlive() const noexcept;
    [[nodiscard]] bool IsAnyHeld() const noexcept;
    [[nodiscard]] bool IsEach(std::uint32_t bits, bool is_booted) const noexcept;

    StartUpParts parts_;
    BootSlave& boot_;
    MasterStep step_;
    MasterStep told_;     ///< The step that was told last.
    NmtCommand reset_;    ///< Of the running kReset.
    std::uint8_t cursor_; ///< Next node to be reset; 0: all at once.
    bool is_start_due_;   ///< The slaves are to be started together.
    bool has_news_;       ///< A boot ended since the master looked.
    bool is_self_due_;    ///< Its own start waits for room in the queue.
    bool is_held_;        ///< A command holds it: it does not start itself.
};

} // namespace counterpoint::cia302

#endif
