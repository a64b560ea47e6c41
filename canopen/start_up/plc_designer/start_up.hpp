// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_PLC_DESIGNER_START_UP_HPP
#define CANOPEN_START_UP_PLC_DESIGNER_START_UP_HPP

#include "canopen/start_up/plc_designer/release.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// MasterState of this profile: the master's nStatus. 0, 1 and 2 are passed in the first cycles.
constexpr std::int16_t kPlcConfigures = 3;
constexpr std::int16_t kPlcRuns = 5;

/// Start-up as in the PLC Designer text. Of 1F80h bit 3 means without automatic start, bit 1 start of all at once. The
/// SDO pool should have kPlcSdoTimes. Each answer to an SDO is told by OnNodeStatus with object and abort code. See
/// StartUp for the order of calls.
class PlcStartUp final : public StartUp
{
  public:
    /// @brief The parts are kept by reference.
    explicit PlcStartUp(const PlcParts& parts) noexcept;

    void Begin(Instant now) noexcept override;
    void End() noexcept override;
    void OnFrame(const CanFrame& frame, Instant now) noexcept override;
    void OnCycle(Instant now) noexcept override;
    void OnNodeEvent(NodeId node, NodeEvent event, Instant now) noexcept override;
    void OnStartDropped(NodeId node, Instant now) noexcept override;
    /// @brief A start puts a slave in state 4 or 99 to 4, starts it and its supervision; stop and PRE-OPERATIONAL take
    /// it to 4 and hold it there; resets lead to state 1.
    [[nodiscard]] NmtAnswer Command(NmtCommand command, NodeId node, Instant now) noexcept override;
    /// @brief The slave begins again with state -1, also a slave in state 97. [SRS_PLC_019]
    [[nodiscard]] bool Boot(NodeId node, Instant now) noexcept override;
    [[nodiscard]] bool Resume(NodeId node, Instant now) noexcept override;
    /// @brief Boot of a slave that IsConfigurable. [SRS_NMM_151]
    [[nodiscard]] bool Configure(NodeId node, Instant now) noexcept override;
    [[nodiscard]] NodeStatus Status(NodeId node) const noexcept override;
    [[nodiscard]] std::int16_t MasterState() const noexcept override;
    [[nodiscard]] IdentityRule Identity() const noexcept override
    {
        return IdentityRule::kPlcDesigner;
    }

  private:
    [[nodiscard]] bool IsBegun(NodeId node) const noexcept;
    void Drive(NodeId node, Instant now) noexcept;
    void DriveMaster(Instant now) noexcept;
    void Forget(NodeId node, Instant now) noexcept;
    void BeginReset(NodeId node, Instant now) noexcept;
    void Settle(NodeId node, Instant now) noexcept;
    void Ask(NodeId node, Instant now) noexcept;
    void SendReset(NodeId node, Instant now) noexcept;
    void FollowHold(NodeId node, Instant now) noexcept;
    void DriveSdos(NodeId node, Instant now) noexcept;
    void OnAnswer(NodeId node, Instant now) noexcept;
    void OnSilence(NodeId node, Instant now) noexcept;
    [[nodiscard]] NmtAnswer CommandOne(NmtCommand command, NodeId node, Instant now) noexcept;
    void Obey(NmtCommand command, NodeId node, Instant now) noexcept;

    StartUpParts parts_;
    PlcSlaves slaves_;
    SafetyReader reader_;
    PlcRelease release_;
    std::int16_t master_;
    bool is_active_;
    bool is_own_asked_; ///< The start of this device was handed over.
};

} // namespace counterpoint::cia302

#endif
