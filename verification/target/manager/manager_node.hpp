// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_MANAGER_MANAGER_NODE_HPP
#define VERIFICATION_TARGET_MANAGER_MANAGER_NODE_HPP

#include "examples/network_manager/manager_device.hpp"
#include "verification/target/manager/wire.hpp"

namespace counterpoint::target
{

/// The manager of the example on the wire. Prints what it tells.
class ManagerNode final : public WireNode, private cia301::FrameSink, private cia302::ManagerListener
{
  public:
    explicit ManagerNode(const examples::ManagerSettings& settings) noexcept;

    [[nodiscard]] cia302::Manager& Core() noexcept
    {
        return device_.Core();
    }
    void Cycle(Instant now) noexcept override;
    [[nodiscard]] CanFrame Waiting() const noexcept override;
    void Sent(Instant now) noexcept override;
    void Hear(const CanFrame& frame, Instant now) noexcept override;

  private:
    [[nodiscard]] bool Send(const CanFrame& frame) noexcept override;
    void OnNodeEvent(cia302::NodeId node, cia302::NodeEvent event, Instant now) noexcept override;
    void OnNodeStatus(cia302::NodeId node, Instant now) noexcept override;
    void OnMasterState(std::int16_t state, Instant now) noexcept override;
    void OnNmtSent(const cia302::NmtRequest& request, Instant now) noexcept override;
    void OnGate(cia302::NodeId node, cia302::GateState state, Instant now) noexcept override;
    void OnEmergency(cia302::NodeId node, const cia302::EmergencyRecord& emergency, Instant now) noexcept override;
    void OnDuplicate(cia302::NodeId node, Instant now) noexcept override;
    void OnFlyingMaster(cia302::FlyingEvent event, const cia302::MasterClaim& claim, Instant now) noexcept override;

    void Tell(Instant now, const char* what, std::uint32_t node) const noexcept;

    static constexpr std::uint32_t kPlaces = 16U;

    std::uint8_t own_;
    bool has_begun_{false};
    CanFrame frames_[kPlaces]{};
    std::uint32_t written_{0U};
    std::uint32_t read_{0U};
    examples::ManagerDevice device_;
};

} // namespace counterpoint::target

#endif
