// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_NETWORK_MANAGER_MANAGER_DEVICE_HPP
#define EXAMPLES_NETWORK_MANAGER_MANAGER_DEVICE_HPP

#include "canopen/cia302/flying_master/flying_master.hpp"
#include "canopen/manager/manager.hpp"
#include "canopen/start_up/cia302/start_up.hpp"

namespace counterpoint::examples
{

/// What tells one manager of a network from another; kept by reference.
struct ManagerSettings
{
    const cia302::NetworkSetup& setup;
    const cia302::FlyingMasterTimes& times; ///< 1F90h; of no effect without 1F80h bit 5.
    const cia302::FlyingMasterOptions& options;
    std::uint16_t heartbeat_ms; ///< 1017h.
};

/// A network manager as a device has it: start-up after CiA 302-2, supervision, the gate of safety slaves and, with
/// 1F80h bit 5, a flying master, with all the room that they work in. Goes into static memory; no heap, no clock.
/// The device's loop: each received frame to Core().OnFrame, each own frame that was on the bus to Core().OnSent, and
/// once a millisecond Core().OnCycle; what is to be sent comes by the sink. Lost frames to Core().OnLost, and a bus
/// that goes and comes back to Core().OnBus.
class ManagerDevice final
{
  public:
    static constexpr std::uint8_t kMostAtOnce = 4U;  ///< Slaves that are served by SDO at the same time.
    static constexpr std::uint8_t kMostSafety = 4U;  ///< Safety slaves; one more would never be started.
    static constexpr std::uint16_t kCommands = 256U; ///< NMT commands that may wait: each node, twice.

    ManagerDevice(const ManagerSettings& settings, cia301::FrameSink& sink, cia302::ManagerListener& listener) noexcept;
    ManagerDevice(const ManagerDevice&) = delete;
    ManagerDevice& operator=(const ManagerDevice&) = delete;
    ~ManagerDevice() = default;

    [[nodiscard]] cia302::Manager& Core() noexcept
    {
        return manager_;
    }

  private:
    [[nodiscard]] cia302::ManagerRoom Room() noexcept;

    cia302::NodeRecord records_[cia302::kNodeRoom]{};
    cia302::WatchedNode watched_[cia302::kNodeRoom]{};
    cia302::GateState gates_[cia302::kNodeRoom]{};
    cia302::BootRecord boots_[cia302::kNodeRoom]{};
    cia302::NmtRequest commands_[kCommands]{};
    cia302::SafetySlot safety_[kMostSafety]{};
    cia302::SdoLanes<kMostAtOnce> lanes_;
    cia302::Manager manager_;
    cia302::Cia302StartUp start_up_;
    cia302::FlyingMaster flying_;
};

} // namespace counterpoint::examples

#endif
