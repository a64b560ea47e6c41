// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/network_manager/manager_device.hpp"

namespace counterpoint::examples
{
namespace
{

constexpr cia302::SdoTimes kSdoTimes{500000U, 3U};

} // namespace

ManagerDevice::ManagerDevice(const ManagerSettings& settings, cia301::FrameSink& sink,
                             cia302::ManagerListener& listener) noexcept
    : lanes_{sink, kSdoTimes},
      manager_{cia302::ManagerParts{settings.setup, sink, listener, Room(), settings.heartbeat_ms}},
      start_up_{manager_.ProfileParts(), boots_},
      flying_{cia302::FlyingMasterParts{settings.setup, settings.times, settings.options, sink, manager_.Role()}}
{
    manager_.Use(start_up_);
    if (settings.setup.Has(cia302::kFlyingMaster))
    {
        manager_.Role().Use(flying_);
    }
}

cia302::ManagerRoom ManagerDevice::Room() noexcept
{
    return {records_, watched_, gates_, {commands_, kCommands}, {safety_, kMostSafety}, lanes_.All(), kSdoTimes};
}

} // namespace counterpoint::examples
