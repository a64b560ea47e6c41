// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Each bit of 1F80h and 1F81h, and what the letters leave open.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"

#include <algorithm>

namespace counterpoint::cia302
{
namespace
{

using Lines = std::vector<std::string>;
using cia301::NodeState;

class StartUpCia302Test : public BootRig
{
  public:
    [[nodiscard]] NodeState StateOf(std::uint8_t node) const
    {
        return slaves.at(node)->State();
    }
    NmtAnswer Command(NmtCommand command, std::uint8_t node)
    {
        const NmtAnswer answer = start_up.Command(command, NodeId{node}, Now());
        Deliver();
        return answer;
    }
};

TEST_F(StartUpCia302Test, DeviceThatIsNoMasterDoesNothing)
{
    Verifies(req::SRS_BOOT_021);
    Add(5U, kMust);
    setup.start_up = kStartAllAtOnce;
    Begin();
    Run(2000U);
    EXPECT_TRUE(log.empty());
    EXPECT_EQ(Step(), MasterStep::kIdle);
    EXPECT_FALSE(start_up.Boot(NodeId{5U}, Now()));
}

TEST_F(StartUpCia302Test, SlavesAreStartedEachByItself)
{
    Verifies(req::SRS_BOOT_014);
    Add(5U, kMust);
    Add(6U, kBoot);
    Begin();
    Run(20U);
    EXPECT_EQ(Commands(), (Lines{"0:82 00", "1:01 05", "1:01 06"}));
    EXPECT_TRUE(Of(5U).is_started);
    EXPECT_EQ(master_states, (std::vector<std::int16_t>{1, 2, 4, 5}));
}

TEST_F(StartUpCia302Test, AStartOfAllLeavesOutWhoIsRefused)
{
    Verifies(req::SRS_BOOT_023);
    setup.start_up = kIsMaster | kApplicationStartsSlaves;
    // Given slaves that were booted, and each one of another type, of another serial number, and without 1017h
    Add(4U, kBoot);
    Add(5U, kBoot);
    setups[5].device_type = 0x192U;
    Add(6U, kBoot);
    setups[6].serial_number = 0x9999U;
    Add(7U, kBoot);
    Add(8U, kBoot | kMandatory);
    Octets list{};
    AddEntry(list, 0x2FFFU, 0U, {1U});
    setups[7].concise_dcf = Bytes{list.data(), static_cast<std::uint32_t>(list.size())};
    Begin();
    Run(500U);
    EXPECT_EQ(Letter(5U) + Letter(6U) + Letter(7U), "COJ");
    EXPECT_EQ(Commands(), (Lines{"0:82 00"}));
    // When all are to be started
    EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kPartly);
    // Then each other one is, by itself
    EXPECT_EQ(Commands(), (Lines{"0:82 00", "500:01 04", "500:01 08"}));
    EXPECT_EQ(StateOf(4U), NodeState::kOperational);
    EXPECT_EQ(StateOf(5U), NodeState::kPreOperational);
    EXPECT_EQ(StateOf(6U), NodeState::kPreOperational);
    EXPECT_EQ(StateOf(7U), NodeState::kPreOperational);
    EXPECT_FALSE(Of(5U).is_started);
    // And where all are good again, one command goes to all
    setups[5].device_type = 0x191U;
    setups[6].serial_number = 0x1234U;
    setups[7].concise_dcf = Bytes{nullptr, 0U};
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}, std::uint8_t{7U}})
    {
        EXPECT_TRUE(start_up.Boot(NodeId{node}, Now()));
    }
    Run(500U);
    EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
    EXPECT_EQ(Commands().back(), "1000:01 00");
}

TEST_F(StartUpCia302Test, OneStartForAllIfAllAreBooted)
{
    Verifies(req::SRS_BOOT_014);
    Verifies(req::SRS_BOOT_015);
    setup.start_up = kIsMaster | kStartAllAtOnce;
    Add(5U, kMust);
    Add(6U, kMust).boot_ms = 50U;
    Add(7U, kBoot);
    Begin();
    Run(5U);
    EXPECT_EQ(Letter(7U), "-");
    EXPECT_EQ(Commands(), (Lines{"0:82 00"})); // Slave 6 is not there yet: nobody is started.
    EXPECT_EQ(Step(), MasterStep::kBooting);
    Run(60U);
    EXPECT_EQ(Commands().size(), 2U);
    EXPECT_EQ(Commands().back().substr(2U), ":01 00");
    EXPECT_EQ(StateOf(7U), NodeState::kOperational);
    EXPECT_TRUE(Of(7U).is_started);
}

TEST_F(StartUpCia302Test, StartOfAllBecomesSingleStartsIfOneIsNotBooted)
{
    Verifies(req::SRS_BOOT_014);
    Verifies(req::SRS_BOOT_015);
    setup.start_up = kIsMaster | kStartAllAtOnce;
    Add(5U, kMust);
    Add(6U, kBoot).boot_ms = 500U;
    Begin();
    Run(20U);
    EXPECT_EQ(Commands(), (Lines{"0:82 00", "1:01 05"}));
    // The late one is started when it has booted: the master is OPERATIONAL
    Run(500U);
    EXPECT_EQ(Commands().size(), 3U);
    EXPECT_EQ(StateOf(6U), NodeState::kOperational);
}

TEST_F(StartUpCia302Test, StartOfAllBecomesSingleStartsIfThereIsASafetySlave)
{
    Verifies(req::SRS_BOOT_015);
    Verifies(req::SRS_NMM_003);
    setup.start_up = kIsMaster | kStartAllAtOnce;
    Add(5U, kMust);
    Add(6U, kMust);
    Protect(6U);
    gate.cycles = 30;
    Begin();
    Run(20U);
    EXPECT_EQ(Commands(), (Lines{"0:82 00"}));
    EXPECT_EQ(Of(6U).step, StartUpStep::kSafety);
    Run(60U);
    const Lines commands = Commands();
    ASSERT_EQ(commands.size(), 3U);
    EXPECT_EQ(commands[1].substr(commands[1].size() - 5U), "01 05");
    EXPECT_EQ(commands[2].substr(commands[2].size() - 5U), "01 06");
    EXPECT_EQ(gate.verifications, 2); // At its boot, and once more directly before the start.
}

TEST_F(StartUpCia302Test, ApplicationStartsTheMaster)
{
    Verifies(req::SRS_BOOT_015);
    setup.start_up = kIsMaster | kStartAllAtOnce | kApplicationStartsSelf;
    Add(5U, kMust);
    Begin();
    Run(20U);
    EXPECT_EQ(Step(), MasterStep::kReady);
    EXPECT_EQ(StateOf(5U), NodeState::kPreOperational);
    EXPECT_EQ(own.size(), 1U); // The reset of all.
    EXPECT_EQ(Command(NmtCommand::kStart, 127U), NmtAnswer::kTaken);
    EXPECT_EQ(Step(), MasterStep::kOperational);
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 127U), NmtAnswer::kTaken);
    EXPECT_EQ(Step(), MasterStep::kReady);
}

TEST_F(StartUpCia302Test, ApplicationStartsTheSlaves)
{
    Verifies(req::SRS_BOOT_014);
    setup.start_up = kIsMaster | kStartAllAtOnce | kApplicationStartsSlaves;
    Add(5U, kMust);
    Begin();
    Run(20U);
    EXPECT_EQ(Step(), MasterStep::kOperational);
    EXPECT_EQ(Commands(), (Lines{"0:82 00"}));
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
    EXPECT_TRUE(Of(5U).is_started);
    EXPECT_EQ(Command(NmtCommand::kStop, 0U), NmtAnswer::kTaken);
    EXPECT_FALSE(Of(5U).is_started);
    EXPECT_EQ(Step(), MasterStep::kReady);
    EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
    EXPECT_EQ(Step(), MasterStep::kOperational);
}

TEST_F(StartUpCia302Test, StartOfAllStartsNobodyWhoWasNeverThere)
{
    Verifies(req::SRS_MGR_122);
    Add(5U, kMust);
    setups[6].assignment = kMust;
    Begin();
    Run(20U);
    EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
    Run(20U);
    EXPECT_TRUE(Of(5U).is_started);
    EXPECT_FALSE(Of(6U).is_started);
}

TEST_F(StartUpCia302Test, SlaveThatIsNotToBeBootedIsOnlySupervised)
{
    Verifies(req::SRS_BOOT_012);
    Add(5U, kInNetwork | kMandatory).heartbeat_ms = 50U;
    setups[5].heartbeat = HeartbeatSetup{150U, 50U, Arming::kFirstHeartbeat};
    Add(6U, kInNetwork | (2U << 8U) | (100U << 16U));
    Begin();
    Run(500U);
    EXPECT_EQ(Count(0x605U), 0);
    EXPECT_EQ(Count(0x606U), 0);
    EXPECT_EQ(Commands(), (Lines{"0:82 00"}));
    EXPECT_EQ(table.Record(NodeId{5U}).watch, Watch::kHeartbeat);
    EXPECT_EQ(table.Record(NodeId{6U}).watch, Watch::kGuarding);
    EXPECT_EQ(Step(), MasterStep::kOperational);
}

TEST_F(StartUpCia302Test, ConfigurationDateSparesTheConfiguration)
{
    Verifies(req::SRS_BOOT_008);
    Octets dcf{};
    AddEntry(dcf, 0x2000U, 0U, {0x77U});
    for (std::uint8_t node = 5U; node <= 8U; ++node)
    {
        FakeSlave& slave = Add(node, kBoot);
        slave.Put8(0x2000U, 0U, 0U);
        slave.Put32(0x1020U, 1U, 100U);
        slave.Put32(0x1020U, 2U, 200U);
        setups[node].configuration_date = 100U;
        setups[node].configuration_time = 200U;
        setups[node].concise_dcf = Bytes{dcf.data(), static_cast<std::uint32_t>(dcf.size())};
    }
    setups[6].configuration_time = 201U;                      // Another time.
    setups[7].configuration_date = 0U;                        // Nothing is expected.
    slaves[8]->refused[0x102001U] = SdoAbort::kObjectUnknown; // The slave does not tell.
    Begin();
    Run(20U);
    EXPECT_EQ(slaves[5]->Get(0x2000U, 0U), (Octets{0U}));
    EXPECT_EQ(slaves[6]->Get(0x2000U, 0U), (Octets{0x77U}));
    EXPECT_EQ(slaves[7]->Get(0x2000U, 0U), (Octets{0x77U}));
    EXPECT_EQ(slaves[8]->Get(0x2000U, 0U), (Octets{0x77U}));
    for (std::uint8_t node = 5U; node <= 8U; ++node)
    {
        EXPECT_EQ(StateOf(node), NodeState::kOperational);
        EXPECT_EQ(Of(node).abort, SdoAbort::kNone);
    }
}

TEST_F(StartUpCia302Test, LateAnswerToTheDeviceTypeIsNotTaken)
{
    Verifies(req::SRS_NMM_032);
    Add(5U, kMust).is_sdo_mute = true;
    Begin();
    Run(310U);
    // Given three tries without answer; the answers come when nobody waits any more, with another type
    const CanFrame late{0x585U, FrameKind::kData, CanPortId::kFirst, 8U, {0x43U, 0U, 0x10U, 0U, 0xADU, 0x0BU, 0U, 0U}};
    ToManager(late);
    // and once more when it was just asked again
    Run(1000U);
    ToManager(late);
    ToManager(late);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_TRUE(Of(5U).is_busy);
    // Then only the slave itself counts
    slaves[5]->is_sdo_mute = false;
    Run(110U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(Of(5U).step, StartUpStep::kDone);
}

TEST_F(StartUpCia302Test, BootUpMessageInTheMiddleBeginsTheBootAnew)
{
    Verifies(req::SRS_BOOT_018);
    FakeSlave& slave = Add(5U, kMust);
    slave.Put8(0x2000U, 0U, 0U);
    slave.Put8(0x2001U, 0U, 0U);
    Octets dcf{};
    AddEntry(dcf, 0x2000U, 0U, {1U});
    AddEntry(dcf, 0x2001U, 0U, {2U});
    setups[5].concise_dcf = Bytes{dcf.data(), static_cast<std::uint32_t>(dcf.size())};
    slave.mute_after_writes = 1U;
    Begin();
    Run(50U);
    EXPECT_EQ(Of(5U).step, StartUpStep::kConfigure);
    // When it is pulled and put back while it is configured
    slave.mute_after_writes = 100U;
    slave.Power(Now());
    Run(20U);
    EXPECT_EQ(slave.writes, (std::vector<std::uint32_t>{0x200000U, 0x200000U, 0x200100U}));
    EXPECT_EQ(Of(5U).step, StartUpStep::kDone);
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
}

TEST_F(StartUpCia302Test, SlaveThatBootedBeforeTheResetOfTheMasterIsBootedOnce)
{
    Verifies(req::SRS_BOOT_018);
    Verifies(req::SRS_BOOT_001);
    setup.inhibit_100us = 200U;                     // 20 ms
    Add(4U, kBoot | kKeepAlive).is_sdo_mute = true; // So that resets go singly.
    Add(5U, kMust);
    PowerAll();
    is_begun = true;
    begun_ms = ms;
    start_up.Begin(Now());
    Run(59U);
    EXPECT_EQ(Of(5U).step, StartUpStep::kDone); // Booted by its power-on; its reset leaves at 60 ms.
    Run(2600U);
    const Lines commands = Commands();
    EXPECT_EQ(std::count_if(commands.begin(), commands.end(),
                            [](const std::string& line) { return line.substr(line.find(':')) == ":01 05"; }),
              1); // The start of the first boot was dropped with it.
    EXPECT_EQ(slaves[5]->resets, 2);
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
    EXPECT_EQ(Step(), MasterStep::kOperational);
}

TEST_F(StartUpCia302Test, MandatorySlaveWithoutBootUpMessageIsAskedAfterASecond)
{
    Verifies(req::SRS_BOOT_002);
    Add(5U, kMust).has_boot_up = false;
    Add(6U, kBoot).has_boot_up = false;
    Begin();
    Run(999U);
    EXPECT_EQ(Count(0x605U), 0);
    EXPECT_EQ(table.RequestValue(NodeId{6U}), 0U); // Unknown,
    Run(10U);
    EXPECT_EQ(table.RequestValue(NodeId{6U}), 1U); // and from now on missing.
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
    Run(5000U);
    EXPECT_EQ(StateOf(6U), NodeState::kPreOperational); // An optional one is waited for.
    EXPECT_EQ(Of(6U).step, StartUpStep::kWaitBootUp);
}

TEST_F(StartUpCia302Test, SlavesThatNeverShowThemselvesAreTold)
{
    Verifies(req::SRS_NMM_025);
    setup.boot_time_ms = 2000U;
    Add(5U, kBoot);
    Add(6U, kBoot);
    Begin();
    slaves[6]->Unplug();
    Run(2000U);
    EXPECT_EQ(std::count(events.begin(), events.end(), "2001:6 8"), 0);
    Run(2U);
    EXPECT_EQ(std::count(events.begin(), events.end(), "2001:6 8"), 1);
    EXPECT_EQ(table.RequestValue(NodeId{6U}), 1U);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 5U);
    // and booted when they come after all
    slaves[6]->Power(Now());
    Run(20U);
    EXPECT_EQ(StateOf(6U), NodeState::kOperational);
}

TEST_F(StartUpCia302Test, CommandsBeforeTheStartUpHasBegunAreCommandsOnly)
{
    Verifies(req::SRS_BOOT_023);
    Add(5U, kMust);
    PowerAll();
    Run(10U);
    EXPECT_EQ(Command(NmtCommand::kResetCommunication, 0U), NmtAnswer::kTaken);
    EXPECT_EQ(Step(), MasterStep::kIdle);
    Run(10U);
    EXPECT_EQ(Count(0x605U), 0);
    EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
    EXPECT_EQ(Step(), MasterStep::kIdle);
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
}

TEST_F(StartUpCia302Test, EndGivesEverythingUp)
{
    Verifies(req::SRS_BOOT_022);
    Add(5U, kMust).is_sdo_mute = true;
    Add(6U, kBoot).heartbeat_ms = 10U;
    setups[6].heartbeat = HeartbeatSetup{50U, 10U, Arming::kImmediately};
    Begin();
    Run(50U);
    start_up.End();
    nmt.SetActive(false);
    Run(1U); // The abort of the upload that ran.
    log.clear();
    slaves[6]->Unplug();
    slaves[5]->Power(Now());
    Run(3000U);
    EXPECT_EQ(log.size(), 1U); // The boot-up message of slave 5.
    EXPECT_EQ(Step(), MasterStep::kIdle);
    EXPECT_FALSE(Of(5U).is_busy);
}

// Safety slaves: none runs that was not verified.
using StartUpSafetyTest = StartUpCia302Test;

TEST_F(StartUpSafetyTest, SafetySlaveWithAnotherConfigurationIsNotStarted)
{
    Verifies(req::SRS_BOOT_013);
    Verifies(req::SRS_BOOT_342);
    Add(5U, kMust);
    Protect(5U);
    gate.verdict = GateState::kDiffers;
    gate.finding = GateFinding{{0x1301U, 2U}, SdoAbort::kNone, 25U, 26U};
    Begin();
    Run(20U);
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(Of(5U).step, StartUpStep::kSafety);
    EXPECT_EQ(Of(5U).object.index, 0x1301U);
    EXPECT_EQ(Of(5U).expected, 25U);
    EXPECT_EQ(Of(5U).read, 26U);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped); // It tells no state: it might run.
    EXPECT_EQ(Step(), MasterStep::kHalted);
    // Not by command either: it is verified again, and refused again
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(20U);
    EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
    Run(20U);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(gate.verifications, 3);
    EXPECT_EQ(Commands(), (Lines{"0:82 00", "1:02 05", "20:80 05", "21:02 05", "40:80 05", "41:02 05"}));
    // When it is put right
    gate.verdict = GateState::kOpen;
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(20U);
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
    // A start of a slave that runs verifies it too, and stops it if it has changed
    gate.verdict = GateState::kDiffers;
    Run(10U);
    table.WatchHeartbeat(NodeId{5U}, 100U, Arming::kFirstHeartbeat, Now());
    ToManager(cia301::ErrorControlFrame(NodeId{5U}, 5U));
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(20U);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
}

TEST_F(StartUpSafetyTest, UnfitMandatorySafetySlaveStopsAllWithBit6)
{
    Verifies(req::SRS_BOOT_013);
    Verifies(req::SRS_BOOT_017);
    setup.start_up = kIsMaster | kStopAllOnError;
    Add(5U, kMust);
    Protect(5U);
    gate.verdict = GateState::kFailed;
    Begin();
    Run(20U);
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(Step(), MasterStep::kStopped);
    EXPECT_EQ(Commands().back().substr(1U), ":02 00");
    // Somebody else starts it: one sign may be of before the stop, with the second it is verified, and stopped, too
    const CanFrame start{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 5U}};
    slaves[5]->OnFrame(start, Now());
    ToManager(cia301::ErrorControlFrame(NodeId{5U}, 5U));
    Run(5U);
    EXPECT_EQ(gate.verifications, 1);
    ToManager(cia301::ErrorControlFrame(NodeId{5U}, 5U));
    Run(5U);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(gate.verifications, 2);
}

TEST_F(StartUpSafetyTest, SafetySlaveFoundOperationalIsVerifiedAndStopped)
{
    Verifies(req::SRS_BOOT_013);
    Verifies(req::SRS_BOOT_340);
    Verifies(req::SRS_BOOT_342);
    // Given a safety slave that starts by itself, kept alive or not booted at all
    Add(5U, kInNetwork).is_self_starting = true;
    slaves[5]->heartbeat_ms = 20U;
    setups[5].heartbeat = HeartbeatSetup{100U, 20U, Arming::kFirstHeartbeat};
    Protect(5U);
    Begin();
    Run(50U);
    EXPECT_EQ(gate.verifications, 1);
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
    EXPECT_EQ(Commands(), (Lines{"0:82 00"}));
    // When somebody else stops and starts it, verification stands; after a restart it does not
    gate.verdict = GateState::kDiffers;
    slaves[5]->Power(Now());
    Run(100U);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(Letter(5U), "J");
    // When somebody else starts it again, it is stopped again
    const CanFrame start{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 5U}};
    slaves[5]->OnFrame(start, Now());
    Run(100U);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(gate.verifications, 3);
}

TEST_F(StartUpSafetyTest, KeptAliveSafetySlaveIsVerifiedToo)
{
    Verifies(req::SRS_BOOT_013);
    Verifies(req::SRS_BOOT_341);
    Verifies(req::SRS_BOOT_342);
    Add(5U, kMust | kKeepAlive);
    Protect(5U);
    PowerAll();
    Run(10U);
    const CanFrame start{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 5U}};
    slaves[5]->OnFrame(start, Now());
    gate.verdict = GateState::kDiffers;
    is_begun = true;
    start_up.Begin(Now());
    Run(100U);
    EXPECT_EQ(slaves[5]->resets, 1);
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(Step(), MasterStep::kHalted);
}

TEST_F(StartUpSafetyTest, ThatLeftOperationalIsVerifiedWhenSomebodyElseStartsIt)
{
    Verifies(req::SRS_BOOT_013);
    Verifies(req::SRS_BOOT_340);
    Verifies(req::SRS_BOOT_342);
    Add(5U, kMust);
    slaves[5]->heartbeat_ms = 20U;
    setups[5].heartbeat = HeartbeatSetup{100U, 20U, Arming::kFirstHeartbeat};
    Protect(5U);
    Begin();
    Run(100U);
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
    EXPECT_EQ(gate.verifications, 1);
    // When somebody makes it PRE-OPERATIONAL, changes it and starts it
    const CanFrame leave{0U, FrameKind::kData, CanPortId::kFirst, 2U, {128U, 5U}};
    const CanFrame start{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 5U}};
    slaves[5]->OnFrame(leave, Now());
    Run(50U);
    gate.verdict = GateState::kDiffers;
    slaves[5]->OnFrame(start, Now());
    Run(100U);
    EXPECT_EQ(gate.verifications, 2);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(Letter(5U), "J");
}

/// Given a safety slave that is kept alive and was started by somebody before the master came.
class KeptAliveSafetyTest : public StartUpSafetyTest
{
  public:
    void Meet()
    {
        setups[5].heartbeat = HeartbeatSetup{100U, 20U, Arming::kFirstHeartbeat};
        slaves[5]->heartbeat_ms = 20U;
        Protect(5U);
        PowerAll();
        Run(10U);
        const CanFrame start{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 5U}};
        slaves[5]->OnFrame(start, Now());
        is_begun = true;
        start_up.Begin(Now());
        Run(200U);
    }
};

TEST_F(KeptAliveSafetyTest, OfAnotherVendorIsVerifiedThoughItsBootFailed)
{
    Verifies(req::SRS_BOOT_016);
    Verifies(req::SRS_BOOT_341);
    Add(5U, kMust | kKeepAlive).Put32(0x1018U, 1U, 0x99U);
    Meet();
    // With the configuration that is expected it is left running, and is of another vendor all the same
    EXPECT_EQ(gate.verifications, 1);
    EXPECT_EQ(Letter(5U), "D");
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
    EXPECT_EQ(Step(), MasterStep::kHalted);
}

TEST_F(KeptAliveSafetyTest, OfAnotherVendorWithAnotherConfigurationIsStopped)
{
    Verifies(req::SRS_BOOT_341);
    Verifies(req::SRS_BOOT_342);
    gate.verdict = GateState::kDiffers;
    Add(5U, kMust | kKeepAlive).Put32(0x1018U, 1U, 0x99U);
    Meet();
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(Step(), MasterStep::kHalted);
}

TEST_F(KeptAliveSafetyTest, ThatWasFoundRunningIsStartedAgainAfterAStop)
{
    Verifies(req::SRS_BOOT_014);
    Verifies(req::SRS_BOOT_023);
    Add(5U, kMust | kKeepAlive);
    Meet();
    EXPECT_EQ(Letter(5U), "L");
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(50U);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(50U);
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
    EXPECT_EQ(Letter(5U), "-");
}

} // namespace
} // namespace counterpoint::cia302
