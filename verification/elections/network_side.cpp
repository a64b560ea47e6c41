// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/elections/network_side.hpp"

#include <utility>

namespace counterpoint::elections
{

NetworkSide::NetworkSide(const cia302::NetworkSetup& setup, cia301::FrameSink& sink, const std::uint16_t heartbeat_ms)
    : lanes_(sink, kTimes), manager_(cia302::ManagerParts{setup, sink, *this,
                                                          cia302::ManagerRoom{records_.data(),
                                                                              watched_.data(),
                                                                              gates_.data(),
                                                                              {queue_.data(), 8U},
                                                                              {nullptr, 0U},
                                                                              lanes_.All(),
                                                                              kTimes},
                                                          heartbeat_ms}),
      profile_(manager_.ProfileParts(), boots_.data())
{
}

void NetworkSide::Begin(cia302::FlyingMaster& flying, const Instant now)
{
    manager_.Use(profile_);
    manager_.Role().Use(flying);
    manager_.Begin(now);
}

std::uint32_t NetworkSide::TakeErrors()
{
    return std::exchange(errors_, 0U);
}

void NetworkSide::OnNodeStatus(const cia302::NodeId /*node*/, const Instant /*now*/) noexcept
{
}

void NetworkSide::OnMasterState(const std::int16_t /*state*/, const Instant /*now*/) noexcept
{
}

void NetworkSide::OnNodeEvent(const cia302::NodeId /*node*/, const cia302::NodeEvent /*event*/,
                              const Instant /*now*/) noexcept
{
}

void NetworkSide::OnNmtSent(const cia302::NmtRequest& /*request*/, const Instant /*now*/) noexcept
{
}

void NetworkSide::OnGate(const cia302::NodeId /*node*/, const cia302::GateState /*state*/,
                         const Instant /*now*/) noexcept
{
}

void NetworkSide::OnEmergency(const cia302::NodeId /*node*/, const cia302::EmergencyRecord& /*emergency*/,
                              const Instant /*now*/) noexcept
{
}

void NetworkSide::OnDuplicate(const cia302::NodeId /*node*/, const Instant /*now*/) noexcept
{
}

void NetworkSide::OnFlyingMaster(const cia302::FlyingEvent event, const cia302::MasterClaim& /*claim*/,
                                 const Instant /*now*/) noexcept
{
    errors_ += (event == cia302::FlyingEvent::kConfigurationError) ? 1U : 0U;
}

} // namespace counterpoint::elections
