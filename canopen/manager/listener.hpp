// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MANAGER_LISTENER_HPP
#define CANOPEN_MANAGER_LISTENER_HPP

#include "canopen/cia302/flying_master/flying_master.hpp"
#include "canopen/cia302/network/node_watch.hpp"
#include "canopen/cia302/network/start_up.hpp"

namespace counterpoint::cia302
{

/// Is told everything that happens in the network, in order. From within a call it may read the manager, but not
/// command it.
class ManagerListener : public StartUpListener
{
  public:
    /// @brief Boot-up message, supervision or state of any node.
    virtual void OnNodeEvent(NodeId node, NodeEvent event, Instant now) noexcept = 0;
    /// @brief A command left, or one for this device itself, for which no frame leaves.
    virtual void OnNmtSent(const NmtRequest& request, Instant now) noexcept = 0;
    /// @brief A command that was taken never leaves: this device commands the network no more. [SRS_MGR_800]
    virtual void OnNmtUnsent(const NmtRequest& request, Instant now) noexcept;
    /// @brief The gate of a safety slave changed, seen once a cycle.
    virtual void OnGate(NodeId node, GateState state, Instant now) noexcept = 0;
    /// @brief See NodeWatchListener.
    virtual void OnEmergency(NodeId node, const EmergencyRecord& emergency, Instant now) noexcept = 0;
    /// @brief Two devices seem to have this node-ID. Told once, and again after a reset of that node.
    virtual void OnDuplicate(NodeId node, Instant now) noexcept = 0;
    /// @brief See FlyingMasterListener.
    virtual void OnFlyingMaster(FlyingEvent event, const MasterClaim& claim, Instant now) noexcept = 0;
    /// @brief The negotiation is to begin, at Begin and after each reset communication: local objects (1F90h) may be
    /// written now. Who calls StartNegotiation: see ManagerRole::Use. [SRS_FLY_027]
    virtual void OnInitialising(Instant now) noexcept;
    /// @brief 1F90h or the own node-ID have values with which no negotiation can begin. Told once; the manager begins
    /// when the values are right.
    virtual void OnNegotiationRefused(FlyingStart reason, Instant now) noexcept;
    /// @brief The sink may have room, and nothing that goes first waits for it: services of the owner that share the
    /// sink send what they have waiting, before requests to slaves are sent. With each frame and in each cycle.
    /// [SRS_MGR_321]
    virtual void OnRoom(Instant now) noexcept;

  protected:
    ManagerListener() noexcept = default;
    ~ManagerListener() noexcept = default;
    ManagerListener(const ManagerListener&) = default;
    ManagerListener& operator=(const ManagerListener&) = default;
};

inline void ManagerListener::OnInitialising(const Instant /*now*/) noexcept
{
}

inline void ManagerListener::OnNmtUnsent(const NmtRequest& /*request*/, const Instant /*now*/) noexcept
{
}

inline void ManagerListener::OnRoom(const Instant /*now*/) noexcept
{
}

inline void ManagerListener::OnNegotiationRefused(const FlyingStart /*reason*/, const Instant /*now*/) noexcept
{
}

} // namespace counterpoint::cia302

#endif
