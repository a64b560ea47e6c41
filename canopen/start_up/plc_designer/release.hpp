// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_PLC_DESIGNER_RELEASE_HPP
#define CANOPEN_START_UP_PLC_DESIGNER_RELEASE_HPP

#include "canopen/start_up/plc_designer/slaves.hpp"

namespace counterpoint::cia302
{

/// Leads slaves from state 4 to 5, one by one or all at once. Safety slaves are verified before their start, and when
/// they run without having been verified. [SRS_PLC_012, SRS_PLC_013, SRS_PLC_014, SRS_PLC_015, SRS_PLC_150,
/// SRS_PLC_151, SRS_PLC_016, SRS_PLC_020]
class PlcRelease
{
  public:
    /// @brief The parts are kept by reference.
    explicit PlcRelease(const PlcParts& parts) noexcept;

    /// @brief The start-up of the network begins: the start of all has not been sent.
    void Begin() noexcept;
    /// @brief All SDOs of the slave were answered: it goes to state 4, or to 98.
    void Configured(NodeId node, Instant now) noexcept;
    /// @brief A start that was handed over: state 5 when it was sent. [SRS_PLC_800]
    void Follow(NodeId node, Instant now) noexcept;
    /// @brief One step of a slave in state 4. Once a cycle.
    void Drive(NodeId node, Instant now) noexcept;
    /// @brief A safety slave that runs without having been started is verified, also while it waits for the start of
    /// all, and one that was started, but whose gate did not stay open. Once a cycle, in any state.
    void Check(NodeId node, Instant now) noexcept;
    /// @brief Sends the start of all when it is due. Once a cycle while the master runs.
    void StartAll(Instant now) noexcept;
    /// @brief The slave told another state than before.
    void OnLeft(NodeId node) noexcept;
    /// @brief Somebody commanded the slave while its start waited: it is verified once more.
    void OnStartDropped(NodeId node, Instant now) noexcept;
    /// @brief Starts a slave by order, without waiting for other slaves. It is in state 4 or 99, or has left 5.
    void StartByHand(NodeId node, Instant now) noexcept;
    /// @brief Whether a safety slave says OPERATIONAL, or its start was heard, without having been verified.
    /// [SRS_SFS_006]
    [[nodiscard]] bool RunsUnread(NodeId node) const noexcept;

  private:
    static void TellRefused(PlcNode& slave) noexcept;
    [[nodiscard]] bool WaitsForAll(NodeId node) const noexcept;
    void Want(NodeId node) noexcept;
    void Refuse(NodeId node, Instant now) noexcept;

    StartUpParts parts_;
    PlcSlaves slaves_;
    SafetyReader reader_;
    bool has_started_all_;
};

} // namespace counterpoint::cia302

#endif
