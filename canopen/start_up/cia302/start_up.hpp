// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_START_UP_HPP
#define CANOPEN_START_UP_CIA302_START_UP_HPP

#include "canopen/start_up/cia302/master.hpp"

namespace counterpoint::cia302
{

/// Start-up and error handling after CiA 302-2; see StartUp for the order of calls. `records` has kNodeRoom elements by
/// node-ID; they and the parts are kept by reference. When error handling has reset all nodes (1F80h bit 4), the
/// start-up begins again by itself. Commands for the own node are carried out by the listener of the NMT master.
class Cia302StartUp final : public StartUp, private BootListener
{
  public:
    Cia302StartUp(const StartUpParts& parts, BootRecord* records) noexcept;

    /// @brief As StartUp. Does nothing without 1F80h bit 0. [SRS_BOOT_001, SRS_BOOT_002, SRS_BOOT_021]
    void Begin(Instant now) noexcept override;
    void End() noexcept override;
    void OnFrame(const CanFrame& frame, Instant now) noexcept override;
    void OnCycle(Instant now) noexcept override;
    void OnNodeEvent(NodeId node, NodeEvent event, Instant now) noexcept override;
    void OnStartDropped(NodeId node, Instant now) noexcept override;
    /// @brief Begins boots again: those that ran, those that failed, and those whose start has not left. [SRS_BOOT_018]
    void OnBusBack(Instant now) noexcept override;
    [[nodiscard]] NmtAnswer Command(NmtCommand command, NodeId node, Instant now) noexcept override;
    [[nodiscard]] bool Boot(NodeId node, Instant now) noexcept override;
    /// @brief As StartUp. Also false after error handling stopped all nodes: slaves are then booted by order only.
    /// [SRS_BOOT_017]
    [[nodiscard]] bool Resume(NodeId node, Instant now) noexcept override;
    /// @brief Writes the configuration alone. False: not listed, not IsConfigurable, or no start-up runs. [SRS_NMM_009]
    [[nodiscard]] bool Configure(NodeId node, Instant now) noexcept override;

    /// @brief Whether its boot ended with an error, and no start of its own started it since it was OPERATIONAL last.
    /// [SRS_BOOT_470, SRS_BOOT_520]
    [[nodiscard]] bool IsLeftOut(NodeId node) const noexcept override;
    [[nodiscard]] NodeStatus Status(NodeId node) const noexcept override;
    [[nodiscard]] std::int16_t MasterState() const noexcept override;

  private:
    /// Error handling that has not left yet.
    enum class Reaction : std::uint8_t
    {
        kNone = 0U,
        kStopAll = 1U,
        kResetAll = 2U,
    };

    void OnBooted(NodeId node, const BootTime& time) noexcept override;
    void OnBootFailed(NodeId node, const BootTime& time) noexcept override;
    [[nodiscard]] bool IsMasterOperational() const noexcept override;

    void NoteLeft(NodeId node) noexcept;
    void VerifyAgain(NodeId node, const BootTime& time) noexcept;
    void React(const BootTime& time) noexcept;
    void EndBoots(const BootTime& time) noexcept;
    void OnBootUp(NodeId node, const BootTime& time) noexcept;
    void OnLost(NodeId node, const BootTime& time) noexcept;
    void OnForeign(NodeId node, Instant now) noexcept;
    void OnState(NodeId node, NodeEvent event, const BootTime& time) noexcept;
    [[nodiscard]] NmtAnswer CommandAll(NmtCommand command, const BootTime& time) noexcept;
    [[nodiscard]] NmtAnswer StartEach(const BootTime& time) noexcept;
    [[nodiscard]] NmtAnswer CommandNode(NmtCommand command, NodeId node, const BootTime& time) noexcept;
    void Keep(NmtCommand command, NodeId node, const BootTime& time) noexcept;

    StartUpParts parts_;
    BootSlave boot_;
    Cia302Master master_;
    BootClock clock_;
    Reaction reaction_;
};

} // namespace counterpoint::cia302

#endif
