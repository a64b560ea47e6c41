// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MANAGER_MANAGER_HPP
#define CANOPEN_MANAGER_MANAGER_HPP

#include "canopen/cia302/flying_master/flying_master.hpp"
#include "canopen/cia302/network/node_watch.hpp"
#include "canopen/cia302/network/start_up.hpp"
#include "canopen/cia302/safety_gate/safety_gate.hpp"
#include "canopen/manager/own_device.hpp"
#include "canopen/manager/safety_permissions.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// Is told everything that happens in the network, in order. It may read the manager, and command it later.
class ManagerListener : public StartUpListener
{
  public:
    /// @brief Boot-up message, supervision or state of any node.
    virtual void OnNodeEvent(NodeId node, NodeEvent event, Instant now) noexcept = 0;
    /// @brief A command left, or one for this device itself, for which no frame leaves.
    virtual void OnNmtSent(const NmtRequest& request, Instant now) noexcept = 0;
    /// @brief The gate of a safety slave changed, seen once a cycle.
    virtual void OnGate(NodeId node, GateState state, Instant now) noexcept = 0;
    /// @brief See NodeWatchListener.
    virtual void OnEmergency(NodeId node, const EmergencyRecord& emergency, Instant now) noexcept = 0;
    /// @brief Two devices seem to have this node-ID. Once until its reset.
    virtual void OnDuplicate(NodeId node, Instant now) noexcept = 0;
    /// @brief See FlyingMasterListener.
    virtual void OnFlyingMaster(FlyingEvent event, const MasterClaim& claim, Instant now) noexcept = 0;
    /// @brief The negotiation is to begin, at Begin and after each reset communication: local objects (1F90h) may be
    /// written now. Who calls StartNegotiation: see Manager::Use. [SRS_FLY_027]
    virtual void OnInitialising(Instant now) noexcept;
    /// @brief 1F90h or the own node-ID cannot be negotiated with. Told once; the manager begins when they can be.
    virtual void OnNegotiationRefused(FlyingStart reason, Instant now) noexcept;

  protected:
    ManagerListener() noexcept = default;
    ~ManagerListener() noexcept = default;
    ManagerListener(const ManagerListener&) = default;
    ManagerListener& operator=(const ManagerListener&) = default;
};

inline void ManagerListener::OnInitialising(const Instant /*now*/) noexcept
{
}

inline void ManagerListener::OnNegotiationRefused(const FlyingStart /*reason*/, const Instant /*now*/) noexcept
{
}

/// Who lets the negotiation begin whenever the device is initialising.
enum class NegotiationBy : std::uint8_t
{
    kManager = 0U,     ///< In the next cycle.
    kApplication = 1U, ///< By StartNegotiation; the device stays in INITIALISATION until then.
};

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
/// wanted, the flying master with this as listener; Use; Begin; then each frame by OnFrame and OnCycle each ms or so.
/// Without a flying master it commands the network from Begin on, with one while the negotiation made it the master.
/// No clock, no heap, no waiting; O(127) a cycle, O(127) a frame. Not reentrant. [SRS_MGR_001, SRS_MGR_002,
/// SRS_MGR_003]
class Manager final : public NmtListener, public NodeListener, public NodeWatchListener, public FlyingMasterListener
{
  public:
    /// @brief Nothing happens before Begin.
    explicit Manager(const ManagerParts& parts) noexcept;

    /// @brief What the profile is constructed with.
    [[nodiscard]] StartUpParts ProfileParts() noexcept;
    /// @brief The profile, kept by reference. Before Begin, which does nothing without one.
    void Use(StartUp& profile) noexcept;
    /// @brief The flying master, kept by reference, and who lets it begin. Before Begin. [SRS_MGR_002, SRS_FLY_027]
    void Use(FlyingMaster& flying, NegotiationBy by = NegotiationBy::kManager) noexcept;

    /// @brief The device is there: boot-up message, then the start-up, or the negotiation first.
    void Begin(Instant now) noexcept;
    /// @brief Commands nothing any more and takes part in no negotiation.
    void End() noexcept;
    /// @brief A frame from the bus; frames of this device itself must not come back.
    void OnFrame(const CanFrame& frame, Instant now) noexcept;
    /// @brief A frame of this device was on the bus: what it asked is known, and second answers are seen. O(1), a reset
    /// of all O(127)
    void OnSent(const CanFrame& frame) noexcept
    {
        watch_.OnSent(frame);
    }
    /// @brief Drives every part, once a ms or so: times are exact to the distance of two calls. O(127) [SRS_MGR_003]
    void OnCycle(Instant now) noexcept;
    /// @brief The controller went bus-off or is gone, or is back. Another one may be master meanwhile: the role of a
    /// flying master ends, and it negotiates when the bus is there; without one, safety slaves are then read as OnLost
    /// says. [SRS_FLY_019]
    void OnBus(bool is_there, Instant now) noexcept;
    /// @brief Frames of the bus were lost, or it was away: safety slaves that run are read again, and a started slave
    /// that says PRE-OPERATIONAL next has booted. O(127) [SRS_SFS_002, SRS_NMM_020]
    void OnLost(Instant now) noexcept;
    /// @brief The application lets the negotiation begin. kInvalid: there is no flying master. [SRS_FLY_027]
    [[nodiscard]] FlyingStart StartNegotiation(Instant now) noexcept;

    /// @brief 1017h of this device from now on; 0: no heartbeat.
    void SetHeartbeat(const std::uint16_t period_ms) noexcept
    {
        own_.Heartbeat().SetPeriod(period_ms);
    }
    /// @brief 1017h of this device as it is now; 0: no heartbeat.
    [[nodiscard]] std::uint16_t HeartbeatMs() const noexcept
    {
        return own_.Heartbeat().PeriodMs();
    }

    /// @brief A command of the application, by the profile: see StartUp::Command.
    [[nodiscard]] NmtAnswer Command(NmtCommand command, NodeId node, Instant now) noexcept;
    /// @brief Start-up of one slave anew: see StartUp::Boot. False also while it does not command the network.
    [[nodiscard]] bool Boot(NodeId node, Instant now) noexcept;
    /// @brief Start-up of one slave without a reset: see StartUp::Resume. False as Boot.
    [[nodiscard]] bool Resume(NodeId node, Instant now) noexcept;
    /// @brief Writes the safety configuration of a slave by the full procedure and verifies it; one that was stopped is
    /// made PRE-OPERATIONAL before. False: not now, it is OPERATIONAL, another device or commands wait. [SRS_SFS_005]
    [[nodiscard]] bool WriteSafety(NodeId node, Instant now) noexcept;

    /// @brief Whether it commands the network now. [SRS_MGR_002]
    [[nodiscard]] bool IsActive() const noexcept
    {
        return is_leading_;
    }
    /// @brief NMT state of this device itself.
    [[nodiscard]] cia301::NodeState OwnState() const noexcept;
    /// @brief Of the profile; all zero before Use.
    [[nodiscard]] NodeStatus Status(NodeId node) const noexcept;
    /// @brief Of the profile, see StartUp::MasterState; 0 before Use.
    [[nodiscard]] std::int16_t MasterState() const noexcept;
    [[nodiscard]] const NodeTable& Table() const noexcept
    {
        return table_;
    }
    [[nodiscard]] const NodeWatch& Watched() const noexcept
    {
        return watch_;
    }
    [[nodiscard]] const SafetyGate& Gate() const noexcept
    {
        return gate_;
    }
    [[nodiscard]] const NmtMaster& Nmt() const noexcept
    {
        return nmt_;
    }
    /// @brief Null: there is none.
    [[nodiscard]] const FlyingMaster* Flying() const noexcept
    {
        return flying_;
    }

    void OnNmtSent(const NmtRequest& request, Instant now) noexcept override;
    void OnStartDropped(NodeId node, Instant now) noexcept override;
    void OnNodeEvent(NodeId node, NodeEvent event, Instant now) noexcept override;
    void OnEmergency(NodeId node, const EmergencyRecord& emergency, Instant now) noexcept override;
    void OnDuplicate(NodeId node, Instant now) noexcept override;
    void OnFlyingMaster(FlyingEvent event, const MasterClaim& claim, Instant now) noexcept override;
    void OnInitialising(Instant now) noexcept override;

  private:
    [[nodiscard]] bool IsInitialising() const noexcept;
    void OnCommandFrame(const CanFrame& frame, Instant now) noexcept;
    void CountHeartbeats(const CanFrame& frame) noexcept;
    void OnReset(NodeId node) noexcept;
    void Lead(bool is_leader, Instant now) noexcept;
    void FollowRole(Instant now) noexcept;
    void TryNegotiation(Instant now) noexcept;
    void ResetRole(Instant now) noexcept;
    void UnwatchAll() noexcept;
    void WatchMaster(NodeId master, Instant now) noexcept;
    void TellGates(Instant now) noexcept;

    ManagerParts parts_;
    SdoPool sdo_;
    NodeTable table_;
    SafetyGate gate_;
    NmtMaster nmt_;
    NodeWatch watch_;
    OwnDevice own_;
    SafetyPermissions permissions_;
    StartUp* profile_;
    FlyingMaster* flying_; ///< Null: none.
    NegotiationBy negotiation_;
    bool is_running_;
    bool is_leading_;  ///< The profile was begun.
    bool is_to_start_; ///< The negotiation is to be started in the next cycle.
    bool is_refused_;  ///< That was told.
    bool is_off_bus_;  ///< No negotiation begins.
    bool is_to_reset_; ///< This device was commanded to reset itself.
};

} // namespace counterpoint::cia302

#endif
