// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MANAGER_SAFETY_PERMISSIONS_HPP
#define CANOPEN_MANAGER_SAFETY_PERMISSIONS_HPP

#include "canopen/cia302/safety_gate/safety_gate.hpp"
#include "canopen/manager/listener.hpp"

namespace counterpoint::cia302
{

/// Decides when the verification of a safety slave does not count any more, and when the slave is read again: after
/// resets, commands, losses and the start by somebody else. Everything is kept by reference.
class SafetyPermissions
{
  public:
    /// `told` has kNodeRoom elements by node-ID: the gates as told last.
    SafetyPermissions(const NetworkSetup& setup, GateState* told, SafetyGate& gate, NodeTable& table) noexcept;

    /// @brief The slave booted, or was lost: its verification does not count any more. Does nothing for other slaves.
    void Close(NodeId node) noexcept;
    /// @brief One node, or all with node 0, was reset by this device or another one.
    void OnReset(NodeId node) noexcept;
    /// @brief One node or all were commanded out of OPERATIONAL.
    void OnLeave(NodeId node) noexcept;
    /// @brief Somebody else commanded a start while this device leads the network. O(127)
    void OnForeignStart(NodeId node, const StartUp& profile, Instant now) noexcept;
    /// @brief A frame from the bus, before the SDO pool has it: a write of the safety configuration by somebody else,
    /// its request and its answer, ends what was read. `profile` is null while this device does not lead. [SRS_SFS_011,
    /// SRS_SFS_219, SRS_MGR_320]
    void OnFrame(const CanFrame& frame, const StartUp* profile, Instant now) noexcept;
    /// @brief See Manager::OnLost. `profile` is null while this device does not lead. O(127)
    void OnLost(const StartUp* profile, Instant now) noexcept;
    /// @brief The start of a slave was given up.
    void OnStartDropped(NodeId node) noexcept;
    /// @brief Tells the listener which gates changed since the last call. Once a cycle. O(127)
    void Tell(ManagerListener& listener, Instant now) noexcept;

  private:
    void ReadAnew(NodeId node) noexcept;
    [[nodiscard]] bool HasStarted(NodeId node, const StartUp& profile) const noexcept;

    const NetworkSetup& setup_;
    GateState* told_;
    SafetyGate& gate_;
    NodeTable& table_;
};

} // namespace counterpoint::cia302

#endif
