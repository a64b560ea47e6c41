// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A network manager linked from the installed package alone. Its network is empty, so that it is OPERATIONAL at once.
#include "canopen/manager/manager.hpp"
#include "canopen/start_up/cia302/start_up.hpp"

#include <cstdio>

namespace
{

using namespace counterpoint;

class Quiet final : public cia301::FrameSink, public cia302::ManagerListener
{
  public:
    bool Send(const CanFrame& /*frame*/) noexcept override
    {
        return true;
    }
    void OnNodeEvent(cia302::NodeId /*node*/, cia302::NodeEvent /*event*/, Instant /*now*/) noexcept override
    {
    }
    void OnNodeStatus(cia302::NodeId /*node*/, Instant /*now*/) noexcept override
    {
    }
    void OnMasterState(std::int16_t /*state*/, Instant /*now*/) noexcept override
    {
    }
    void OnNmtSent(const cia302::NmtRequest& /*request*/, Instant /*now*/) noexcept override
    {
    }
    void OnGate(cia302::NodeId /*node*/, cia302::GateState /*state*/, Instant /*now*/) noexcept override
    {
    }
    void OnEmergency(cia302::NodeId /*node*/, const cia302::EmergencyRecord& /*emergency*/,
                     Instant /*now*/) noexcept override
    {
    }
    void OnDuplicate(cia302::NodeId /*node*/, Instant /*now*/) noexcept override
    {
    }
    void OnFlyingMaster(cia302::FlyingEvent /*event*/, const cia302::MasterClaim& /*claim*/,
                        Instant /*now*/) noexcept override
    {
    }
};

constexpr cia302::SlaveSetup kSlaves[cia302::kNodeRoom]{};
constexpr cia302::NetworkSetup kSetup{cia302::NodeId{1U}, cia302::kIsMaster, 0U, 0U, 0U, kSlaves};
constexpr cia302::SdoTimes kTimes{500000U, 3U};

Quiet bus{};
cia302::NodeRecord records[cia302::kNodeRoom]{};
cia302::WatchedNode watched[cia302::kNodeRoom]{};
cia302::GateState gates[cia302::kNodeRoom]{};
cia302::BootRecord boots[cia302::kNodeRoom]{};
cia302::NmtRequest commands[8]{};
cia302::SdoLanes<1U> lanes{bus, kTimes};
cia302::Manager manager{
    {kSetup, bus, bus, {records, watched, gates, {commands, 8U}, {nullptr, 0U}, lanes.All(), kTimes}, 0U}};
cia302::Cia302StartUp start_up{manager.ProfileParts(), boots};

} // namespace

int main()
{
    manager.Use(start_up);
    manager.Begin(Instant{0U});
    for (std::uint32_t ms = 1U; ms <= 100U; ++ms)
    {
        manager.OnCycle(Instant{ms * 1000U});
    }
    const bool is_operational = manager.OwnState() == cia301::NodeState::kOperational;
    std::puts(is_operational ? "the manager is operational" : "the manager is not operational");
    return is_operational ? 0 : 1;
}
