// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_PLC_DESIGNER_START_UP_HPP
#define CANOPEN_START_UP_PLC_DESIGNER_START_UP_HPP

#include "canopen/cia302/network/concise_dcf.hpp"
#include "canopen/cia302/network/start_up.hpp"
#include "canopen/start_up/plc_designer/setup.hpp"
#include "canopen/start_up/plc_designer/states.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// MasterState of this profile: the master's nStatus. 0, 1 and 2 are passed in the first cycles.
constexpr std::int16_t kPlcConfigures = 3;
constexpr std::int16_t kPlcRuns = 5;

/// What a slave in state 3 is sent.
enum class PlcRow : std::uint8_t
{
    kDeviceType = 0U,
    kRestore = 1U, ///< 1011h:01.
    kList = 2U,    ///< SDOs of the configurator.
};

/// One slave. Zero-filled at first.
struct PlcNode
{
    NodeStatus status; ///< nStatus is its code and changes by Next alone.
    PlcRow row;
    ConcisePosition place; ///< In the list.
    Instant since;         ///< Begin of the state, or of the reading of 1000h.
    bool is_listed;
    bool is_transferring;
    bool is_type_wrong;
    bool was_reset;   ///< After 1011h:01, since Begin.
    bool is_held;     ///< By a command: not started again by itself.
    bool is_wanted;   ///< To be started.
    bool is_by_hand;  ///< By a command: no other slave is waited for.
    bool is_woken;    ///< STOPPED, and made PRE-OPERATIONAL to be verified.
    bool is_verified; ///< The gate was asked for this start.
    bool is_checking; ///< Found OPERATIONAL: the gate reads.
    bool was_checked; ///< Found OPERATIONAL and read.
    bool is_unread;   ///< Stopped because it ran and did not answer.
    bool ran_unread;  ///< Was OPERATIONAL since its SDOs were answered last, and not read.
    bool is_stop_due; ///< The gate refused, or it cannot be read.
    bool has_sdos;    ///< All were answered since Begin.
    std::uint8_t signs;
    std::uint8_t buffer[4];
};

/// `nodes` has kNodeRoom elements. All kept by reference.
struct PlcParts
{
    StartUpParts common;
    PlcNode* nodes;
};

/// Start-up as in the PLC Designer text. Of 1F80h bit 3 means without automatic start, bit 1 start of all at once. The
/// SDO pool should have kPlcSdoTimes. Each answer to an SDO is told by OnNodeStatus with object and abort code. See
/// StartUp for the order of calls.
class PlcStartUp final : public StartUp
{
  public:
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
    /// @brief The slave begins anew in state -1, also one in 97. [SRS_PLC_019]
    [[nodiscard]] bool Boot(NodeId node, Instant now) noexcept override;
    [[nodiscard]] bool Resume(NodeId node, Instant now) noexcept override;
    [[nodiscard]] NodeStatus Status(NodeId node) const noexcept override;
    [[nodiscard]] std::int16_t MasterState() const noexcept override;
    [[nodiscard]] IdentityRule Identity() const noexcept override
    {
        return IdentityRule::kPlcDesigner;
    }

  private:
    [[nodiscard]] PlcNode& Of(NodeId node) const noexcept;
    [[nodiscard]] const PlcSlave& SetupOf(NodeId node) const noexcept;
    void Go(NodeId node, PlcEvent event, StartUpStep step, Instant now) noexcept;
    void Drive(NodeId node, Instant now) noexcept;
    void DriveMaster(Instant now) noexcept;
    void BeginReset(NodeId node, Instant now) noexcept;
    void Settle(NodeId node, Instant now) noexcept;

    void OnLeft(NodeId node) noexcept;
    void DriveSdos(NodeId node, Instant now) noexcept;
    void Ask(NodeId node, Instant now) noexcept;
    void OnAnswer(NodeId node, Instant now) noexcept;
    void OnSilence(NodeId node, Instant now) noexcept;
    void EndSdos(NodeId node, Instant now) noexcept;
    void StopUnread(NodeId node, Instant now) noexcept;
    [[nodiscard]] bool RunsUnread(NodeId node) const noexcept;

    [[nodiscard]] bool WaitsForAll(NodeId node) const noexcept;
    void DriveStart(NodeId node, Instant now) noexcept;
    void StartOne(NodeId node, Instant now) noexcept;
    void Refuse(NodeId node, Instant now) noexcept;
    void DriveCheck(NodeId node, Instant now) noexcept;
    void StartAll(Instant now) noexcept;
    [[nodiscard]] NmtAnswer CommandOne(NmtCommand command, NodeId node, Instant now) noexcept;
    void Obey(NmtCommand command, NodeId node, Instant now) noexcept;

    PlcParts parts_;
    std::int16_t master_;
    bool is_active_;
    bool has_started_all_;
};

} // namespace counterpoint::cia302

#endif
