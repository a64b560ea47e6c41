// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_ELECTIONS_NETWORK_SIDE_HPP
#define VERIFICATION_ELECTIONS_NETWORK_SIDE_HPP

#include "canopen/manager/manager.hpp"
#include "canopen/start_up/cia302/start_up.hpp"

#include <array>
#include <cstdint>

namespace counterpoint::elections
{

/// The whole manager around a flying master, with a network in which no slave is: what it sends beside the election is
/// its boot-up message, its heartbeat, and the reset of all with which it starts its network each time it became
/// master.
class NetworkSide final : public cia302::ManagerListener
{
  public:
    NetworkSide(const cia302::NetworkSetup& setup, cia301::FrameSink& sink, std::uint16_t heartbeat_ms);

    /// @brief Switches it on, with a flying master that has its role as listener.
    void Begin(cia302::FlyingMaster& flying, Instant now);
    [[nodiscard]] cia302::Manager& Core()
    {
        return manager_;
    }
    /// @brief Configuration errors told since the last call.
    [[nodiscard]] std::uint32_t TakeErrors();

    void OnNodeStatus(cia302::NodeId node, Instant now) noexcept override;
    void OnMasterState(std::int16_t state, Instant now) noexcept override;
    void OnNodeEvent(cia302::NodeId node, cia302::NodeEvent event, Instant now) noexcept override;
    void OnNmtSent(const cia302::NmtRequest& request, Instant now) noexcept override;
    void OnGate(cia302::NodeId node, cia302::GateState state, Instant now) noexcept override;
    void OnEmergency(cia302::NodeId node, const cia302::EmergencyRecord& emergency, Instant now) noexcept override;
    void OnDuplicate(cia302::NodeId node, Instant now) noexcept override;
    void OnFlyingMaster(cia302::FlyingEvent event, const cia302::MasterClaim& claim, Instant now) noexcept override;

  private:
    static constexpr cia302::SdoTimes kTimes{100'000U, 1U};

    std::array<cia302::NodeRecord, cia302::kNodeRoom> records_{};
    std::array<cia302::WatchedNode, cia302::kNodeRoom> watched_{};
    std::array<cia302::GateState, cia302::kNodeRoom> gates_{};
    std::array<cia302::NmtRequest, 8> queue_{};
    std::array<cia302::BootRecord, cia302::kNodeRoom> boots_{};
    cia302::SdoLanes<1> lanes_;
    cia302::Manager manager_;
    cia302::Cia302StartUp profile_;
    std::uint32_t errors_{0U};
};

} // namespace counterpoint::elections

#endif
