// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Paths by which a safety slave could come to OPERATIONAL, or stay there, without having been read.
#include "tests/canopen/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"

namespace counterpoint::cia302
{
namespace
{

/// Given a safety slave 5 without heartbeat or guarding, unless a test says so.
class SafetyPathsTest : public ManagerRig, public ::testing::WithParamInterface<Profile>
{
  public:
    SafetyPathsTest()
    {
        Add(5U);
        MakeSafe(5U);
    }
    void Change()
    {
        devices[0]->Put(0x1301U, 2U, {26U, 0U});
    }
    /// A slave that was not expected as it is, and that the manager does not start.
    void BeginChanged()
    {
        Change();
        Begin(GetParam());
        Run(6000U);
        EXPECT_EQ(Running(5U), 0);
        EXPECT_EQ(Gate(), GateState::kDiffers);
    }
};

TEST_P(SafetyPathsTest, WithoutErrorControlAndStartedBySomebodyElseIsReadAndStopped)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    BeginChanged();
    // When nothing but the command of somebody else tells that it runs
    Put(Nmt(NmtCommand::kPreOperational, 5U));
    Put(Nmt(NmtCommand::kStart, 0U));
    EXPECT_EQ(Running(5U), 1);
    Run(1000U);
    EXPECT_EQ(Running(5U), 0);
    EXPECT_EQ(Gate(), GateState::kDiffers);
}

TEST_P(SafetyPathsTest, WithoutErrorControlLeavesAndComesBackChangedIsStopped)
{
    Verifies(req::SRS_SFS_006);
    Begin(GetParam());
    Run(6000U);
    EXPECT_EQ(Running(5U), 1);
    Put(Nmt(NmtCommand::kPreOperational, 5U));
    Change();
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(1000U);
    EXPECT_EQ(Running(5U), 0);
    EXPECT_EQ(Gate(), GateState::kDiffers);
}

TEST_P(SafetyPathsTest, RunsWithoutAnsweringAnySdoIsStopped)
{
    Verifies(req::SRS_SFS_006);
    // Given one that starts itself, and answers nothing
    devices[0]->heartbeat_ms = 100U;
    devices[0]->is_self_starting = true;
    devices[0]->is_sdo_mute = true;
    Begin(GetParam());
    Run(10000U);
    EXPECT_EQ(Running(5U), 0);
    EXPECT_EQ(stops, 1);
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kPreOperational); // It is asked on,
    devices[0]->is_sdo_mute = false;
    Run(6000U);
    EXPECT_EQ(Running(5U), 1); // and started when it answers.
    EXPECT_EQ(Gate(), GateState::kOpen);
}

TEST_P(SafetyPathsTest, StoppedByOrderBeforeItAnsweredIsNotWoken)
{
    Verifies(req::SRS_SFS_006);
    devices[0]->heartbeat_ms = 100U;
    devices[0]->is_sdo_mute = true;
    Begin(GetParam());
    Run(4000U);
    EXPECT_EQ(Order(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(6000U);
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kStopped);
}

TEST_P(SafetyPathsTest, ASignThatWasUnderWayWhenItWasStoppedKeepsWhatWasFound)
{
    Verifies(req::SRS_SFS_003);
    devices[0]->heartbeat_ms = 100U;
    BeginChanged();
    Put(Nmt(NmtCommand::kPreOperational, 5U));
    Put(Nmt(NmtCommand::kStart, 5U));
    for (int i = 0; (i < 500) && (devices[0]->State() != cia301::NodeState::kStopped); ++i)
    {
        Run(1U);
    }
    // When a heartbeat of before comes behind the stop
    Put(CanFrame{0x705U, FrameKind::kData, CanPortId::kFirst, 1U, {5U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}});
    Run(3000U);
    EXPECT_EQ(Gate(), GateState::kDiffers);
    EXPECT_EQ(manager->Gate().Finding(NodeId{5U}).object.index, 0x1301U);
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kStopped);
}

TEST_P(SafetyPathsTest, CommandedWhileItsStartWaitsIsReadAgainAndStarted)
{
    Verifies(req::SRS_SFS_002);
    Verifies(req::SRS_SFS_152);
    // Given starts that wait 100 ms behind each other command
    devices[0]->heartbeat_ms = 100U;
    setup.inhibit_100us = 10000U;
    Begin(GetParam());
    int waits = 0;
    for (int i = 0; (i < 9000) && (waits == 0); ++i)
    {
        Run(1U);
        const bool is_start_waiting = (Gate() == GateState::kOpen) && (manager->ProfileParts().nmt.Waiting() > 0U);
        waits += is_start_waiting ? 1 : 0;
    }
    EXPECT_EQ(waits, 1);
    Put(Nmt(NmtCommand::kPreOperational, 5U));
    Run(6000U);
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(Gate(), GateState::kOpen);
}

TEST_P(SafetyPathsTest, CommandedAndChangedWhileItsStartWaitsIsNotLeftRunning)
{
    Verifies(req::SRS_SFS_002);
    Verifies(req::SRS_SFS_152);
    devices[0]->heartbeat_ms = 100U;
    setup.inhibit_100us = 10000U;
    Begin(GetParam());
    for (int i = 0; (i < 9000) && !((Gate() == GateState::kOpen) && (manager->ProfileParts().nmt.Waiting() > 0U)); ++i)
    {
        Run(1U);
    }
    Put(Nmt(NmtCommand::kPreOperational, 5U));
    Change();
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(6000U);
    EXPECT_EQ(Running(5U), 0);
    EXPECT_EQ(Gate(), GateState::kDiffers);
}

TEST_P(SafetyPathsTest, WithAToggleErrorIsReadAgain)
{
    Verifies(req::SRS_SFS_002);
    // Given guarding, and one that resets itself unheard and starts itself
    setups[5].assignment |= (100U << 16U) | (3U << 8U);
    Begin(GetParam());
    Run(6030U);
    EXPECT_EQ(Running(5U), 1);
    devices[0]->has_boot_up = false;
    devices[0]->is_self_starting = true;
    Run((manager->Table().Record(NodeId{5U}).toggle == Toggle::kClear) ? 100U : 0U);
    Change();
    devices[0]->Power(Now());
    Run(1500U);
    EXPECT_EQ(Running(5U), 0);
}

TEST_P(SafetyPathsTest, OfAnotherDeviceIsNeitherStartedNorWritten)
{
    Verifies(req::SRS_SFS_009);
    Verifies(req::SRS_SFS_340);
    // Given another device with the very configuration that is expected, and a second slave as it is to be
    Add(6U);
    devices[0]->Put32(0x1018U, 4U, 0x4321U);
    devices[0]->Put32(0x1000U, 0U, (GetParam() == Profile::kPlcDesigner) ? 0x192U : 0x191U);
    Begin(GetParam());
    Run(6000U);
    EXPECT_TRUE(manager->Status(NodeId{5U}).is_other);
    EXPECT_FALSE(manager->Status(NodeId{6U}).is_other);
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kOtherDevice);
    EXPECT_EQ(Order(NmtCommand::kStart, 0U), NmtAnswer::kOtherDevice);
    EXPECT_FALSE(manager->WriteSafety(NodeId{5U}, Now()));
    Run(3000U);
    EXPECT_EQ(Running(5U), 0);
    EXPECT_EQ(Running(6U), 1);
    EXPECT_EQ(devices[0]->writes, (std::vector<std::uint32_t>{}));
    // When somebody else starts it, it is read, says still what is wrong with it, and is stopped
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(1000U);
    EXPECT_EQ(Gate(), GateState::kDiffers);
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kStopped);
    EXPECT_TRUE(manager->Status(NodeId{5U}).is_other);
    EXPECT_EQ(manager->Status(NodeId{5U}).letter, (GetParam() == Profile::kCia302) ? 'O' : '\0');
    // When the expected one takes its place
    devices[0]->PutIdentity();
    EXPECT_EQ(Order(NmtCommand::kResetNode, 5U), NmtAnswer::kTaken);
    Run(6000U);
    EXPECT_FALSE(manager->Status(NodeId{5U}).is_other);
    EXPECT_EQ(Running(5U), 1);
}

TEST_P(SafetyPathsTest, OfAnotherDeviceThatWasFoundChangedStaysAnotherDevice)
{
    Verifies(req::SRS_SFS_009);
    Verifies(req::SRS_SFS_340);
    devices[0]->Put32(0x1018U, 4U, 0x4321U);
    devices[0]->Put32(0x1000U, 0U, (GetParam() == Profile::kPlcDesigner) ? 0x192U : 0x191U);
    Begin(GetParam());
    Run(6000U);
    Change();
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(1000U);
    EXPECT_EQ(Gate(), GateState::kDiffers);
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kStopped);
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kOtherDevice);
    // When it is as expected again and somebody else starts it
    devices[0]->Put(0x1301U, 2U, {25U, 0U});
    Put(Nmt(NmtCommand::kPreOperational, 5U));
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(1000U);
    EXPECT_EQ(Gate(), GateState::kDiffers);
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kStopped);
    EXPECT_TRUE(manager->Status(NodeId{5U}).is_other);
    EXPECT_EQ(manager->Status(NodeId{5U}).letter, (GetParam() == Profile::kCia302) ? 'O' : '\0');
}

TEST_P(SafetyPathsTest, ThatRefusesToSayWhoItIsIsNeitherStartedNorWritten)
{
    Verifies(req::SRS_SFS_009);
    // Given one with the very configuration that is expected, which aborts what its profile compares
    const bool is_plc = (GetParam() == Profile::kPlcDesigner);
    devices[0]->refused[cia301::KeyOf(is_plc ? 0x1000U : 0x1018U, is_plc ? 0U : 4U)] = SdoAbort::kHardware;
    Begin(GetParam());
    Run(6000U);
    const NodeStatus status = manager->Status(NodeId{5U});
    EXPECT_EQ(status.letter, (GetParam() == Profile::kCia302) ? 'O' : '\0');
    EXPECT_EQ(status.code, (GetParam() == Profile::kEl6751) ? 4 : status.code);
    EXPECT_EQ(status.code, is_plc ? 98 : status.code);
    EXPECT_TRUE(status.is_other);
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kOtherDevice);
    EXPECT_EQ(Order(NmtCommand::kStart, 0U), NmtAnswer::kOtherDevice);
    EXPECT_FALSE(manager->WriteSafety(NodeId{5U}, Now()));
    Run(1000U);
    EXPECT_EQ(starts, (std::vector<std::string>{}));
    EXPECT_EQ(devices[0]->writes, (std::vector<std::uint32_t>{}));
    // When it says it, then its next start-up starts it
    devices[0]->refused.clear();
    EXPECT_EQ(Order(NmtCommand::kResetNode, 5U), NmtAnswer::kTaken);
    Run(6000U);
    EXPECT_FALSE(manager->Status(NodeId{5U}).is_other);
    EXPECT_EQ(Running(5U), 1);
}

// The answer to each request of the gate is there before the next cycle: what it reads or writes next would leave then.
TEST_P(SafetyPathsTest, WhoIsNotTheActiveMasterAnyMoreReadsAndWritesNoFurther)
{
    Verifies(req::SRS_BOOT_022);
    Verifies(req::SRS_MGR_002);
    for (const bool is_writing : {false, true})
    {
        SCOPED_TRACE(is_writing);
        Begin(GetParam());
        Run(6000U);
        EXPECT_EQ(Gate(), GateState::kOpen);
        EXPECT_EQ(Order(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
        Run(10U);
        if (is_writing)
        {
            EXPECT_TRUE(manager->WriteSafety(NodeId{5U}, Now()));
        }
        else
        {
            EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
        }
        Run(3U);
        EXPECT_EQ(Gate(), GateState::kBusy);
        // When another master takes over
        manager->Role().OnFlyingMaster(FlyingEvent::kSlaveMode, MasterClaim{0U, NodeId{9U}}, Now());
        EXPECT_EQ(Gate(), GateState::kClosed);
        asked = 0;
        Run(1000U);
        // Then nothing more is asked, written or started
        EXPECT_EQ(asked, 0);
        EXPECT_EQ(Running(5U), 0);
        EXPECT_EQ(Gate(), GateState::kClosed);
    }
}

TEST_P(SafetyPathsTest, WhatWasVerifiedAsTheActiveMasterHoldsNoMoreBehindIt)
{
    Verifies(req::SRS_BOOT_022);
    Begin(GetParam());
    Run(6000U);
    EXPECT_EQ(Gate(), GateState::kOpen);
    manager->Role().OnFlyingMaster(FlyingEvent::kSlaveMode, MasterClaim{0U, NodeId{9U}}, Now());
    EXPECT_EQ(Gate(), GateState::kClosed);
}

INSTANTIATE_TEST_SUITE_P(Each, SafetyPathsTest, ::testing::ValuesIn(kProfiles));

using SafetyPathsInCia302Test = SafetyPathsTest;

TEST_P(SafetyPathsInCia302Test, ReadWhileResetsLeaveIsBootedAllTheSame)
{
    Verifies(req::SRS_BOOT_013);
    // Given one that is kept alive and runs, and resets that leave one after the other
    devices[0]->heartbeat_ms = 20U;
    devices[0]->is_self_starting = true;
    setups[5].assignment |= kKeepAlive;
    setups[5].heartbeat.consumer_ms = 200U;
    setup.inhibit_100us = 10U;
    Begin(GetParam());
    int readings = 0;
    for (int i = 0; (i < 1000) && (manager->MasterState() == 1); ++i)
    {
        // When it leaves and comes back all the time
        if (Gate() != GateState::kBusy)
        {
            Put(Nmt(NmtCommand::kPreOperational, 5U));
            Put(Nmt(NmtCommand::kStart, 5U));
        }
        Run(1U);
        readings += (Gate() == GateState::kBusy) ? 1 : 0;
    }
    EXPECT_GT(readings, 100);
    Run(3000U);
    EXPECT_EQ(manager->MasterState(), 5);
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(Gate(), GateState::kOpen);
}

TEST_P(SafetyPathsInCia302Test, KeptAliveAndTellingNoStateIsReadAndStopped)
{
    Verifies(req::SRS_BOOT_341);
    Verifies(req::SRS_BOOT_342);
    // Given one that is kept alive, runs with another configuration, and has no heartbeat though it should
    devices[0]->has_boot_up = false;
    devices[0]->is_self_starting = true;
    setups[5].assignment |= kKeepAlive;
    setups[5].heartbeat.consumer_ms = 200U;
    Change();
    Begin(GetParam());
    Run(1000U);
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kStopped);
    EXPECT_EQ(Gate(), GateState::kDiffers);
    EXPECT_EQ(manager->Status(NodeId{5U}).letter, 'J');
}

TEST_P(SafetyPathsInCia302Test, StartsItselfAndTellsNoStateIsStopped)
{
    Verifies(req::SRS_BOOT_342);
    devices[0]->is_self_starting = true;
    Change();
    Begin(GetParam());
    Run(1000U);
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kStopped);
    EXPECT_EQ(Gate(), GateState::kDiffers);
}

TEST_P(SafetyPathsInCia302Test, ThatDoesNotAnswerWithinTheBootTimeIsNeitherStartedNorWritten)
{
    Verifies(req::SRS_SFS_009);
    // Given one that is silent until the boot time is over, and answers then
    setup.boot_time_ms = 1000U;
    setups[5].assignment |= kMandatory;
    devices[0]->is_sdo_mute = true;
    Begin(GetParam());
    Run(4000U);
    devices[0]->is_sdo_mute = false;
    EXPECT_EQ(manager->Status(NodeId{5U}).letter, 'B');
    EXPECT_TRUE(manager->Status(NodeId{5U}).is_other);
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kOtherDevice);
    EXPECT_FALSE(manager->WriteSafety(NodeId{5U}, Now()));
    Run(1000U);
    EXPECT_EQ(starts, (std::vector<std::string>{}));
    EXPECT_EQ(devices[0]->writes, (std::vector<std::uint32_t>{}));
    // When its boot is ordered
    EXPECT_TRUE(manager->Role().Boot(NodeId{5U}, Now()));
    Run(1000U);
    EXPECT_FALSE(manager->Status(NodeId{5U}).is_other);
    EXPECT_EQ(Running(5U), 1);
}

/// Given a slave 6 whose loss stops all, and 5 that runs.
class StoppedByErrorTest : public SafetyPathsTest
{
  public:
    StoppedByErrorTest()
    {
        setup.start_up = kIsMaster | kStartAllAtOnce | kStopAllOnError;
        Add(6U).heartbeat_ms = 20U;
        setups[6].heartbeat = HeartbeatSetup{100U, 20U, Arming::kFirstHeartbeat};
    }
    void BeginAndLose()
    {
        Begin(GetParam());
        Run(3000U);
        EXPECT_EQ(Running(5U), 1);
        devices[1]->Unplug();
    }
    void Replace(const bool is_mute)
    {
        devices[0]->Put32(0x1018U, 4U, 0x4321U);
        devices[0]->is_sdo_mute = is_mute;
        devices[0]->Power(Now());
    }
};

TEST_P(StoppedByErrorTest, ReplacedMeanwhileIsNeitherStartedNorWritten)
{
    Verifies(req::SRS_SFS_009);
    Verifies(req::SRS_BOOT_343);
    BeginAndLose();
    Run(300U);
    EXPECT_EQ(manager->MasterState(), 6);
    EXPECT_FALSE(manager->Status(NodeId{5U}).is_other);
    // When another device with the very configuration that is expected takes its place
    Replace(false);
    Run(1000U);
    EXPECT_TRUE(manager->Status(NodeId{5U}).is_other);
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kOtherDevice);
    EXPECT_FALSE(manager->WriteSafety(NodeId{5U}, Now()));
    // When somebody else starts it, it is read and still another one, also when it was found changed
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(1000U);
    EXPECT_EQ(Gate(), GateState::kDiffers);
    Put(Nmt(NmtCommand::kPreOperational, 5U));
    Change();
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(1000U);
    EXPECT_EQ(Gate(), GateState::kDiffers);
    EXPECT_FALSE(manager->WriteSafety(NodeId{5U}, Now()));
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kOtherDevice);
    EXPECT_EQ(Order(NmtCommand::kStart, 0U), NmtAnswer::kOtherDevice);
    Run(3000U);
    EXPECT_EQ(Running(5U), 0);
    EXPECT_EQ(devices[0]->writes, (std::vector<std::uint32_t>{}));
}

TEST_P(StoppedByErrorTest, WrittenBehindItIsNotStartedUpUnasked)
{
    Verifies(req::SRS_BOOT_343);
    BeginAndLose();
    Run(300U);
    EXPECT_EQ(manager->MasterState(), 6);
    EXPECT_FALSE(manager->Role().Resume(NodeId{5U}, Now()));
    Run(1000U);
    EXPECT_EQ(Running(5U), 0);
}

TEST_P(StoppedByErrorTest, InTheMiddleOfItsBootIsBootedByOrderAlone)
{
    Verifies(req::SRS_SFS_009);
    Verifies(req::SRS_BOOT_343);
    setup.start_up = kIsMaster | kStopAllOnError;
    setups[5].assignment &= ~kMandatory;
    BeginAndLose();
    Replace(true);
    Run(300U);
    EXPECT_EQ(manager->MasterState(), 6);
    devices[0]->is_sdo_mute = false;
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kOtherDevice);
    Run(1000U);
    EXPECT_EQ(Running(5U), 0);
    // When it is reset, its boot-up message begins its boot
    EXPECT_EQ(Order(NmtCommand::kResetNode, 5U), NmtAnswer::kTaken);
    Run(500U);
    EXPECT_EQ(manager->Status(NodeId{5U}).letter, 'O');
    // When the expected one is back
    devices[0]->PutIdentity();
    EXPECT_EQ(Order(NmtCommand::kResetNode, 5U), NmtAnswer::kTaken);
    Run(500U);
    EXPECT_FALSE(manager->Status(NodeId{5U}).is_other);
    EXPECT_EQ(Running(5U), 1);
}

INSTANTIATE_TEST_SUITE_P(Cia302, SafetyPathsInCia302Test, ::testing::Values(Profile::kCia302));
INSTANTIATE_TEST_SUITE_P(Cia302, StoppedByErrorTest, ::testing::Values(Profile::kCia302));

} // namespace
} // namespace counterpoint::cia302
