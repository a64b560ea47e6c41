// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MANAGER_MANAGER_HPP
#define CANOPEN_MANAGER_MANAGER_HPP

#include "canopen/cia302/safety_gate/safety_gate.hpp"
#include "canopen/manager/role.hpp"
#include "canopen/manager/safety_permissions.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// Room that the manager's parts work in, kept by reference. Arrays by node-ID have kNodeRoom elements.
struct ManagerRoom
{
    NodeRecord* records;
    WatchedNode* watched;
    GateState* gates; ///< As told last.
    NmtQueueRoom commands;
    SafetySlots safety;
    SdoLaneRoom lanes;
    SdoTimes times;
};

/// What a manager works with; all kept by reference.
struct ManagerParts
{
    const NetworkSetup& setup;
    cia301::FrameSink& sink; ///< All that the manager sends.
    ManagerListener& listener;
    ManagerRoom room;
    std::uint16_t heartbeat_ms; ///< 1017h of the manager itself; 0: none.
};

/// The network manager: table of nodes, NMT master, SDO connections and safety gate, in which a start-up profile works,
/// and a flying master if there is one. Order of use: construct; construct the profile with ProfileParts and, if
/// wanted, the flying master with Role as its listener; hand the profile over by Manager::Use, the flying master by
/// ManagerRole::Use; Begin; then each frame by OnFrame and OnCycle
/// each ms or so. Without a flying master it commands the network from Begin on, with one while the negotiation made it
/// the master. No clock, no heap, no waiting; O(127) a cycle, O(127) a frame. Not reentrant. [SRS_MGR_001, SRS_MGR_002,
/// SRS_MGR_003]
class Manager final : public NmtListener, public NodeListener, public NodeWatchListener
{
  public:
    /// @brief Nothing happens before Begin.
    explicit Manager(const ManagerParts& parts) noexcept;

    /// @brief What the profile is constructed with.
    [[nodiscard]] StartUpParts ProfileParts() noexcept;
    /// @brief The profile, kept by reference. Before Begin, which does nothing without one.
    void Use(StartUp& profile) noexcept;

    /// @brief The device starts: boot-up message, then the start-up of the network, or the negotiation first.
    void Begin(Instant now) noexcept;
    /// @brief From now on it sends no command, none that waits either, and takes part in no negotiation.
    void End() noexcept;
    /// @brief A frame from the bus; frames of this device itself must not come back.
    void OnFrame(const CanFrame& frame, Instant now) noexcept;
    /// @brief A frame of this device was on the bus: what it asked for is remembered, so that a second answer to it is
    /// noticed. O(1), a reset
    /// of all O(127)
    void OnSent(const CanFrame& frame) noexcept
    {
        watch_.OnSent(frame);
    }
    /// @brief Drives every part, once a ms or so: times are exact to the distance of two calls. O(127) [SRS_MGR_003]
    void OnCycle(Instant now) noexcept;
    /// @brief The controller went bus-off or is gone, or is back. Another one may be master meanwhile: the role of a
    /// flying master ends, and it negotiates when the bus is there; a manager without a flying master then reads the
    /// safety slaves as OnLost says. [SRS_FLY_150]
    void OnBus(bool is_there, Instant now) noexcept;
    /// @brief Frames of the bus were lost, or it was away: safety slaves that run are read again, and a started slave
    /// that says PRE-OPERATIONAL next has booted. O(127) [SRS_SFS_002, SRS_NMM_020]
    void OnLost(Instant now) noexcept;

    /// @brief Heartbeat of this device (1017h).
    [[nodiscard]] cia301::HeartbeatProducer& Heartbeat() noexcept
    {
        return own_.Heartbeat();
    }
    /// @brief Commands of the application go here; it is the listener of the flying master, if there is one.
    [[nodiscard]] ManagerRole& Role() noexcept
    {
        return role_;
    }
    /// @brief The same, to look at.
    [[nodiscard]] const ManagerRole& Role() const noexcept
    {
        return role_;
    }

    /// @brief Writes the safety configuration of a slave by the full procedure and verifies it; one that was stopped is
    /// made PRE-OPERATIONAL before. False: it is not possible now, since the slave is OPERATIONAL, is another device
    /// than the expected one, or commands for it wait. [SRS_SFS_005, SRS_SFS_212]
    [[nodiscard]] bool WriteSafety(NodeId node, Instant now) noexcept;

    /// @brief Whether it commands the network now. [SRS_MGR_002]
    [[nodiscard]] bool IsActive() const noexcept
    {
        return role_.Leading() != nullptr;
    }
    /// @brief NMT state of this device itself.
    [[nodiscard]] cia301::NodeState OwnState() const noexcept;
    /// @brief Status of a slave as the profile has it; all zero before Use.
    [[nodiscard]] NodeStatus Status(NodeId node) const noexcept;
    /// @brief MasterState of the profile (see StartUp); 0 before Use.
    [[nodiscard]] std::int16_t MasterState() const noexcept;
    /// @brief The node table, to look at.
    [[nodiscard]] const NodeTable& Table() const noexcept
    {
        return table_;
    }
    /// @brief Emergency messages and duplicates, to look at.
    [[nodiscard]] const NodeWatch& Watched() const noexcept
    {
        return watch_;
    }
    /// @brief The safety gate, to look at.
    [[nodiscard]] const SafetyGate& Gate() const noexcept
    {
        return gate_;
    }

    void OnNmtSent(const NmtRequest& request, Instant now) noexcept override;
    void OnStartDropped(NodeId node, Instant now) noexcept override;
    void OnNodeEvent(NodeId node, NodeEvent event, Instant now) noexcept override;
    void OnEmergency(NodeId node, const EmergencyRecord& emergency, Instant now) noexcept override;
    void OnDuplicate(NodeId node, Instant now) noexcept override;

  private:
    void OnCommandFrame(const CanFrame& frame, Instant now) noexcept;
    void OnCommand(NmtCommand command, NodeId node) noexcept;
    void SendWaiting(Instant now) noexcept;
    void CountHeartbeats(const CanFrame& frame) noexcept;

    ManagerParts parts_;
    SdoPool sdo_;
    NodeTable table_;
    SafetyGate gate_;
    NmtMaster nmt_;
    NodeWatch watch_;
    OwnDevice own_;
    SafetyPermissions permissions_;
    ManagerRole role_;
};

} // namespace counterpoint::cia302

#endif
