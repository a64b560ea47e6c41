// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The tables of the network: what `counterpoint manager` reads from a network file and its DCFs.
#include "examples/network_manager/network.hpp"

#include "canopen/cia302/safety_gate/safety_check.hpp"

namespace counterpoint::examples
{
namespace
{

using cia302::ExpectedObject;
using cia302::SlaveSetup;

// 1300h to 13FFh of examples/actuator/actuator.dcf, and its device digest, which no manager writes.
constexpr ExpectedObject kDriveObjects[]{
    {{0x1300U, 0U}, 1U, false},          {{0x1301U, 0U}, 6U, true},           {{0x1301U, 1U}, 2U, false},
    {{0x1301U, 2U}, 50U, false},         {{0x1301U, 3U}, 20U, false},         {{0x1301U, 4U}, 254U, true},
    {{0x1301U, 5U}, 0x103U, false},      {{0x1301U, 6U}, 0x104U, false},      {{0x1381U, 0U}, 4U, false},
    {{0x1381U, 1U}, 0x22000108U, false}, {{0x1381U, 2U}, 0x23000108U, false}, {{0x1381U, 3U}, 0x22000208U, false},
    {{0x1381U, 4U}, 0x23000208U, false}, {{0x13FFU, 0U}, 1U, true},           {{0x13FFU, 1U}, 0x9FCBU, false},
    {{0x5F04U, 0U}, 0xBEE7CE1CU, true},
};
constexpr cia302::SafetyExpectation kDriveSafety{
    kDriveObjects, static_cast<std::uint16_t>(sizeof(kDriveObjects) / sizeof(kDriveObjects[0]))};

// One entry: 1017h = 100 ms.
constexpr std::uint8_t kDriveConcise[]{1U, 0U, 0U, 0U, 0x17U, 0x10U, 0U, 2U, 0U, 0U, 0U, 100U, 0U};

constexpr std::uint16_t kHeartbeatMs = 100U;
constexpr std::uint16_t kConsumerMs = 250U;

struct SlaveTable
{
    SlaveSetup slaves[cia302::kNodeRoom];
};

/// Another manager is supervised, never booted.
constexpr SlaveSetup OtherManager() noexcept
{
    SlaveSetup slave{};
    slave.assignment = cia302::kInNetwork;
    slave.heartbeat = {kConsumerMs, kHeartbeatMs, cia302::Arming::kFirstHeartbeat};
    return slave;
}

constexpr SlaveSetup Drive() noexcept
{
    SlaveSetup slave{};
    slave.assignment = cia302::kInNetwork | cia302::kBootSlave | cia302::kMandatory;
    slave.product_code = 3U;
    slave.revision_number = 0x00010000U;
    slave.serial_number = 33U;
    slave.heartbeat = {kConsumerMs, kHeartbeatMs, cia302::Arming::kFirstHeartbeat};
    slave.concise_dcf = cia302::Bytes{kDriveConcise, sizeof(kDriveConcise)};
    slave.safety = &kDriveSafety;
    return slave;
}

constexpr SlaveTable Slaves(const bool has_other_managers) noexcept
{
    SlaveTable table{};
    table.slaves[kDrive.value] = Drive();
    if (has_other_managers)
    {
        table.slaves[kFirstManager.value] = OtherManager();
        table.slaves[kSecondManager.value] = OtherManager();
    }
    return table;
}

constexpr SlaveTable kAlone = Slaves(false);
constexpr SlaveTable kFlying = Slaves(true);

constexpr cia302::NetworkSetup kAloneSetup{kFirstManager, cia302::kIsMaster, 5000U, 0U, 0U, kAlone.slaves};
constexpr std::uint32_t kFlyingStartUp = cia302::kIsMaster | cia302::kFlyingMaster;
constexpr cia302::NetworkSetup kFirstSetup{kFirstManager, kFlyingStartUp, 5000U, 0U, 0U, kFlying.slaves};
constexpr cia302::NetworkSetup kSecondSetup{kSecondManager, kFlyingStartUp, 5000U, 0U, 0U, kFlying.slaves};

constexpr cia302::FlyingMasterTimes TimesOf(const cia302::NodeId node, const std::uint16_t priority) noexcept
{
    cia302::FlyingMasterTimes times = cia302::DefaultTimes(node);
    times.priority = priority;
    return times;
}

constexpr cia302::FlyingMasterTimes kFirstTimes = TimesOf(kFirstManager, 1U);
constexpr cia302::FlyingMasterTimes kSecondTimes = TimesOf(kSecondManager, 0U);
constexpr cia302::FlyingMasterOptions kOptions = cia302::DefaultFlyingMaster();

} // namespace

ManagerSettings AloneSettings() noexcept
{
    return ManagerSettings{kAloneSetup, kFirstTimes, kOptions, kHeartbeatMs};
}

ManagerSettings FlyingSettings(const cia302::NodeId own) noexcept
{
    const bool is_first = own.value == kFirstManager.value;
    return is_first ? ManagerSettings{kFirstSetup, kFirstTimes, kOptions, kHeartbeatMs}
                    : ManagerSettings{kSecondSetup, kSecondTimes, kOptions, kHeartbeatMs};
}

} // namespace counterpoint::examples
