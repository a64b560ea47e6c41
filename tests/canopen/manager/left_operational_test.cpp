// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Safety slaves that left OPERATIONAL, were changed and came back, without having said so by any heartbeat.
#include "tests/canopen/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

/// Given a safety slave 5 with heartbeats each 100 ms.
class LeftOperationalTest : public ManagerRig, public ::testing::WithParamInterface<Profile>
{
  public:
    LeftOperationalTest()
    {
        Add(5U).heartbeat_ms = 100U;
        MakeSafe(5U);
    }
    void OnGate(NodeId, const GateState state, Instant) noexcept override
    {
        readings += (state == GateState::kBusy) ? 1 : 0;
    }
    void StartAndForget(const Profile profile)
    {
        Begin(profile);
        Run(6050U);
        EXPECT_EQ(Running(5U), 1);
        readings = 0;
        stops = 0;
    }
    void Change()
    {
        devices[0]->Put8(0x13FEU, 0U, 0U);
    }
    void ExpectStopped()
    {
        EXPECT_EQ(Running(5U), 0);
        EXPECT_EQ(devices[0]->State(), cia301::NodeState::kStopped);
        EXPECT_EQ(Gate(), GateState::kDiffers);
        EXPECT_FALSE(manager->Status(NodeId{5U}).is_started);
    }

    int readings{0}; ///< As the gate told.
};

TEST_P(LeftOperationalTest, ChangedWhileItsStartWaitsForTheInhibitTimeIsNotStarted)
{
    Verifies(req::SRS_SFS_152);
    // Given 2 s between two commands, and a start that waits behind another command
    setup.inhibit_100us = 20000U;
    Begin(GetParam());
    for (int i = 0; (i < 5000) && (Gate() != GateState::kOpen); ++i)
    {
        Run(1U);
    }
    ASSERT_EQ(Gate(), GateState::kOpen);
    Run(50U);
    ASSERT_TRUE(starts.empty());
    // When it is changed before its turn
    Change();
    Run(9000U);
    EXPECT_TRUE(starts.empty());
    EXPECT_EQ(Gate(), GateState::kDiffers);
    EXPECT_EQ(Running(5U), 0);
}

TEST_P(LeftOperationalTest, UnchangedWhileItsStartWaitsIsReadAgainAndStarted)
{
    Verifies(req::SRS_SFS_152);
    setup.inhibit_100us = 20000U;
    StartAndForget(GetParam());
    EXPECT_EQ(starts.size(), 1U);
}

TEST_P(LeftOperationalTest, ChangedWhileTheBusWasAwayIsStopped)
{
    Verifies(req::SRS_SFS_002);
    Verifies(req::SRS_SFS_153);
    StartAndForget(GetParam());
    manager->OnBus(false, Now());
    Change();
    Run(60U);
    manager->OnBus(true, Now());
    Run(200U);
    ExpectStopped();
}

TEST_P(LeftOperationalTest, WhileFramesWereLostIsReadAgain)
{
    Verifies(req::SRS_SFS_002);
    Verifies(req::SRS_SFS_153);
    StartAndForget(GetParam());
    // Given that it is as expected, nothing happens to it
    manager->OnLost(Now());
    Run(200U);
    EXPECT_EQ(readings, 1);
    EXPECT_EQ(stops, 0);
    EXPECT_EQ(Running(5U), 1);
    Change();
    manager->OnLost(Now());
    Run(200U);
    ExpectStopped();
}

TEST_P(LeftOperationalTest, StartedBySomebodyElseBeforeItsOwnStartLeftIsRead)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    setup.inhibit_100us = 20000U;
    Begin(GetParam());
    for (int i = 0; (i < 5000) && (Gate() != GateState::kOpen); ++i)
    {
        Run(1U);
    }
    Change();
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(9000U);
    EXPECT_TRUE(starts.empty());
    ExpectStopped();
}

TEST_P(LeftOperationalTest, BySomebodyElseAndCameBackChangedIsStopped)
{
    Verifies(req::SRS_SFS_002);
    Verifies(req::SRS_ELM_049);
    Verifies(req::SRS_PLC_020);
    Verifies(req::SRS_BOOT_340);
    Verifies(req::SRS_BOOT_342);
    StartAndForget(GetParam());
    Put(Nmt(NmtCommand::kPreOperational, 5U));
    Run(1U);
    Change();
    Put(Nmt(NmtCommand::kStart, 5U));
    EXPECT_NE(Gate(), GateState::kOpen);
    Run(1000U);
    ExpectStopped();
}

TEST_P(LeftOperationalTest, BehindACommandItIsVerifiedWithItsSecondSign)
{
    Verifies(req::SRS_PLC_020);
    StartAndForget(GetParam());
    // Given a stop of somebody else that it did not get: of its heartbeats, one each 100 ms, the first one behind it
    // may be one of before
    manager->OnFrame(Nmt(NmtCommand::kStop, 5U), Now());
    EXPECT_NE(Gate(), GateState::kOpen);
    std::uint32_t waited_ms = 0U;
    while ((readings == 0) && (waited_ms < 1000U))
    {
        Run(1U);
        ++waited_ms;
    }
    EXPECT_GT(waited_ms, 100U);
    EXPECT_LE(waited_ms, 202U);
}

TEST_P(LeftOperationalTest, BySomebodyElseAndCameBackAsItWasRunsOnVerifiedOnce)
{
    Verifies(req::SRS_SFS_002);
    Verifies(req::SRS_ELM_049);
    Verifies(req::SRS_PLC_020);
    Verifies(req::SRS_BOOT_340);
    StartAndForget(GetParam());
    Put(Nmt(NmtCommand::kStop, 0U));
    Run(1U);
    Put(Nmt(NmtCommand::kStart, 0U));
    Run(2000U);
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(Gate(), GateState::kOpen);
    EXPECT_EQ(readings, 1);
    EXPECT_EQ(stops, 0);
}

TEST_P(LeftOperationalTest, ByOrderAndWasStartedChangedBySomebodyElseIsStopped)
{
    Verifies(req::SRS_SFS_002);
    Verifies(req::SRS_BOOT_340);
    Verifies(req::SRS_BOOT_342);
    StartAndForget(GetParam());
    EXPECT_EQ(Order(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    Change();
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(1000U);
    ExpectStopped();
}

TEST_P(LeftOperationalTest, ByAStopOfWhichItHasNotSpokenYetIsStartedAgainByOrder)
{
    Verifies(req::SRS_BOOT_023);
    setups[5].heartbeat = HeartbeatSetup{300U, 100U, Arming::kFirstHeartbeat};
    StartAndForget(GetParam());
    EXPECT_EQ(Order(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kStopped);
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(2000U);
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(Gate(), GateState::kOpen);
    EXPECT_TRUE(manager->Status(NodeId{5U}).is_started);
}

TEST_P(LeftOperationalTest, ByAStopOfWhichItHasNotSpokenYetIsMadePreOperationalToBeWritten)
{
    Verifies(req::SRS_SFS_212);
    setups[5].heartbeat = HeartbeatSetup{300U, 100U, Arming::kFirstHeartbeat};
    StartAndForget(GetParam());
    EXPECT_FALSE(manager->WriteSafety(NodeId{5U}, Now())); // It is OPERATIONAL.
    EXPECT_EQ(Order(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(manager->ProfileParts().table.RequestValue(NodeId{5U}), 5U);
    EXPECT_TRUE(manager->WriteSafety(NodeId{5U}, Now()));
    Run(1U);
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kPreOperational);
}

TEST_P(LeftOperationalTest, ADeviceThatRestartsOftenIsNotTakenForTwo)
{
    Verifies(req::SRS_MGR_010);
    setups[5].heartbeat.producer_ms = 100U;
    StartAndForget(GetParam());
    for (int i = 0; i < 10; ++i)
    {
        devices[0]->Power(Now());
        Run(60U);
    }
    Run(6000U);
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{}));
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(Gate(), GateState::kOpen);
}

TEST_P(LeftOperationalTest, ThatMayBeTwoWhileItRunsIsStopped)
{
    Verifies(req::SRS_MGR_226);
    Verifies(req::SRS_SFS_151);
    setups[5].heartbeat.producer_ms = 100U;
    StartAndForget(GetParam());
    // When somebody else's heartbeats say OPERATIONAL too, until it is suspected
    for (int i = 0; (i < 20) && !IsSuspected(5U); ++i)
    {
        Put(CanFrame{0x705U, FrameKind::kData, CanPortId::kFirst, 1U, {5U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}});
        Run(100U);
    }
    EXPECT_TRUE(IsSuspected(5U));
    Run(1000U);
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kStopped);
    EXPECT_EQ(Gate(), GateState::kFailed);
    EXPECT_EQ(manager->Status(NodeId{5U}).object.index, 0U);
}

TEST_P(LeftOperationalTest, FramesLostWhileItIsReadMakeTheReadingBeginAnew)
{
    Verifies(req::SRS_SFS_002);
    Verifies(req::SRS_SFS_153);
    StartAndForget(GetParam());
    manager->OnLost(Now());
    Run(1U);
    std::uint32_t reading_ms = 0U;
    for (; Gate() == GateState::kBusy; ++reading_ms)
    {
        Run(1U);
    }
    EXPECT_EQ(Gate(), GateState::kOpen);
    // When it is changed, and declared valid again, behind what was read of it already
    manager->OnLost(Now());
    Run(reading_ms);
    EXPECT_EQ(Gate(), GateState::kBusy);
    devices[0]->Put(0x1301U, 2U, {26U, 0U});
    manager->OnLost(Now());
    Run(200U);
    ExpectStopped();
}

TEST_P(LeftOperationalTest, EighteenSignsInTenPeriodsAreThoseOfTwoAndSeventeenAreNot)
{
    Verifies(req::SRS_MGR_010);
    struct Signs
    {
        int count;
        std::uint32_t apart_ms;
        bool is_suspected;
    };
    for (const Signs& signs : {Signs{17, 50U, false}, Signs{18, 60U, false}, Signs{18, 58U, true}})
    {
        // Given a slave that was started and says nothing by itself, with a producer time of 100 ms, when so many signs
        // of it come: the last one 800 ms, 1020 ms or 986 ms behind the first one
        devices[0]->heartbeat_ms = 0U;
        setups[5].heartbeat = HeartbeatSetup{0U, 100U, Arming::kFirstHeartbeat};
        StartAndForget(GetParam());
        Run(2000U);
        duplicates.clear();
        for (int sign = 0; sign < signs.count; ++sign)
        {
            Put(CanFrame{0x705U, FrameKind::kData, CanPortId::kFirst, 1U, {5U}});
            Run(signs.apart_ms);
        }
        // Then it may be two with 18 in 1 s alone
        EXPECT_EQ(!duplicates.empty(), signs.is_suspected) << signs.count << " " << signs.apart_ms;
    }
}

TEST_P(LeftOperationalTest, HeartbeatsOfADeviceThatWasNotStartedUpAreNotThoseOfTwo)
{
    Verifies(req::SRS_MGR_010);
    // Given another device than the expected one, so that nobody sets its heartbeat, which comes each 100 ms
    setups[5].heartbeat.producer_ms = 400U;
    devices[0]->Put32(0x1018U, 4U, 0x4321U);
    devices[0]->Put32(0x1000U, 0U, (GetParam() == Profile::kPlcDesigner) ? 0x192U : 0x191U);
    Begin(GetParam());
    Run(9000U);
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{}));
    // When the expected one takes its place it is started without a reset
    devices[0]->PutIdentity();
    devices[0]->heartbeat_ms = 400U;
    devices[0]->Power(Now());
    Run(6000U);
    EXPECT_EQ(Running(5U), 1);
}

INSTANTIATE_TEST_SUITE_P(Each, LeftOperationalTest, ::testing::ValuesIn(kProfiles));

using LeftInCia302Test = LeftOperationalTest;

TEST_P(LeftInCia302Test, WhoseLastSignIsOlderThanTheStartOfSomebodyElseIsStopped)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    Verifies(req::SRS_BOOT_340);
    Verifies(req::SRS_BOOT_342);
    // Given one that is stopped and changed, and says nothing by itself
    devices[0]->heartbeat_ms = 0U;
    StartAndForget(GetParam());
    EXPECT_EQ(Order(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Change();
    // When a guarding answer of before comes in behind the start
    Put(Nmt(NmtCommand::kStart, 5U));
    Put(CanFrame{0x705U, FrameKind::kData, CanPortId::kFirst, 1U, {4U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}});
    Run(1000U);
    ExpectStopped();
}

TEST_P(LeftInCia302Test, ReplacedWhileTheBusWasAwayFromItsBootIsAskedWhoItIs)
{
    Verifies(req::SRS_BOOT_018);
    Begin(GetParam());
    for (int i = 0; (i < 1000) && (Gate() != GateState::kBusy); ++i)
    {
        Run(1U);
    }
    EXPECT_EQ(manager->Status(NodeId{5U}).step, StartUpStep::kSafety);
    manager->OnBus(false, Now());
    devices[0]->Put32(0x1018U, 4U, 0x4321U);
    manager->OnBus(true, Now());
    Run(1000U);
    EXPECT_EQ(manager->Status(NodeId{5U}).letter, 'O');
    EXPECT_EQ(starts, (std::vector<std::string>{}));
}

TEST_P(LeftInCia302Test, ReplacedWhileTheBusWasAwayFromItsStartByOrderIsAskedWhoItIs)
{
    Verifies(req::SRS_BOOT_018);
    setup.start_up |= kApplicationStartsSlaves;
    Begin(GetParam());
    Run(1000U);
    EXPECT_EQ(starts, (std::vector<std::string>{}));
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(2U);
    EXPECT_EQ(Gate(), GateState::kBusy);
    manager->OnBus(false, Now());
    devices[0]->Put32(0x1018U, 4U, 0x4321U);
    manager->OnBus(true, Now());
    Run(1000U);
    EXPECT_EQ(manager->Status(NodeId{5U}).letter, 'O');
    EXPECT_EQ(starts, (std::vector<std::string>{}));
    // When it is the expected one, the order still counts
    devices[0]->PutIdentity();
    EXPECT_TRUE(manager->Role().Boot(NodeId{5U}, Now()));
    Run(1000U);
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(2U);
    manager->OnBus(false, Now());
    manager->OnBus(true, Now());
    Run(1000U);
    EXPECT_EQ(Running(5U), 1);
}

TEST_P(LeftInCia302Test, BootThatEndedInSilenceWhileTheBusWasAwayIsBegunAnew)
{
    Verifies(req::SRS_BOOT_018);
    Begin(GetParam());
    for (int i = 0; (i < 1000) && (Gate() != GateState::kBusy); ++i)
    {
        Run(1U);
    }
    manager->OnBus(false, Now());
    devices[0]->is_sdo_mute = true;
    Run(3000U);
    EXPECT_EQ(manager->Status(NodeId{5U}).letter, 'J');
    devices[0]->is_sdo_mute = false;
    manager->OnBus(true, Now());
    Run(1000U);
    EXPECT_EQ(manager->Status(NodeId{5U}).letter, '\0');
    EXPECT_EQ(Running(5U), 1);
}

TEST_P(LeftInCia302Test, ASignThatWasUnderWayDoesNotMakeItBeRead)
{
    Verifies(req::SRS_BOOT_340);
    // When it is stopped by order, and a heartbeat of before comes in
    StartAndForget(GetParam());
    EXPECT_EQ(Order(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Put(CanFrame{0x705U, FrameKind::kData, CanPortId::kFirst, 1U, {5U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}});
    Run(500U);
    EXPECT_EQ(readings, 0);
    EXPECT_EQ(stops, 1);
    EXPECT_EQ(Gate(), GateState::kClosed);
    EXPECT_EQ(manager->Status(NodeId{5U}).letter, '\0');
}

TEST_P(LeftInCia302Test, VerifiedButNotStartedAndThenStartedChangedBySomebodyElseIsStopped)
{
    Verifies(req::SRS_BOOT_340);
    Verifies(req::SRS_BOOT_342);
    setup.start_up |= kApplicationStartsSlaves;
    Begin(GetParam());
    Run(1000U);
    EXPECT_EQ(Gate(), GateState::kOpen);
    Change();
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(1000U);
    ExpectStopped();
}

TEST_P(LeftInCia302Test, VerifiedButNotStartedAndThenStartedAsItWasRunsOnVerifiedAgain)
{
    Verifies(req::SRS_BOOT_340);
    setup.start_up |= kApplicationStartsSlaves;
    Begin(GetParam());
    Run(1000U);
    EXPECT_EQ(readings, 1);
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(1000U);
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(readings, 2);
    EXPECT_EQ(stops, 0);
    EXPECT_EQ(manager->Status(NodeId{5U}).letter, 'L');
}

TEST_P(LeftInCia302Test, RunsOnChangedBehindAResetThatItDidNotHearIsStopped)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    Verifies(req::SRS_BOOT_340);
    Verifies(req::SRS_BOOT_342);
    // Given an optional one, whose boot-up message is waited for without end
    setups[5].assignment = static_cast<std::uint32_t>(setups[5].assignment & ~kMandatory);
    setups[5].heartbeat = HeartbeatSetup{300U, 100U, Arming::kFirstHeartbeat};
    StartAndForget(GetParam());
    devices[0]->is_on = false; // Its cable, not its supply.
    Run(3000U);
    EXPECT_EQ(manager->Status(NodeId{5U}).step, StartUpStep::kWaitBootUp);
    Change();
    devices[0]->is_on = true;
    Run(1000U);
    ExpectStopped();
    EXPECT_EQ(manager->Status(NodeId{5U}).letter, 'J');
}

TEST_P(LeftInCia302Test, RunsOnAsItWasBehindAResetThatItDidNotHearIsVerifiedAndSupervised)
{
    Verifies(req::SRS_BOOT_340);
    setups[5].assignment = static_cast<std::uint32_t>(setups[5].assignment & ~kMandatory);
    setups[5].heartbeat = HeartbeatSetup{300U, 100U, Arming::kFirstHeartbeat};
    StartAndForget(GetParam());
    devices[0]->is_on = false;
    Run(3000U);
    devices[0]->is_on = true;
    Run(1000U);
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(Gate(), GateState::kOpen);
    EXPECT_EQ(readings, 1);
    EXPECT_EQ(stops, 0);
    EXPECT_EQ(manager->Status(NodeId{5U}).letter, 'L');
    // When it is lost once more, that is told, and its next boot-up message boots it
    devices[0]->is_on = false;
    Run(3000U);
    EXPECT_EQ(manager->Status(NodeId{5U}).step, StartUpStep::kWaitBootUp);
    devices[0]->Power(Now());
    Run(1000U);
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(manager->Status(NodeId{5U}).letter, '\0');
}

TEST_P(LeftInCia302Test, FoundRunningIsNotBootedAnewWhenTheBusIsBack)
{
    Verifies(req::SRS_BOOT_018);
    Verifies(req::SRS_BOOT_230);
    // Given letter L behind a reset that it did not hear
    setups[5].assignment = static_cast<std::uint32_t>(setups[5].assignment & ~kMandatory);
    setups[5].heartbeat = HeartbeatSetup{300U, 100U, Arming::kFirstHeartbeat};
    StartAndForget(GetParam());
    devices[0]->is_on = false;
    Run(3000U);
    devices[0]->is_on = true;
    Run(1000U);
    ASSERT_EQ(manager->Status(NodeId{5U}).letter, 'L');
    starts.clear();
    // When the bus was away, it is read and runs on
    manager->OnBus(false, Now());
    manager->OnBus(true, Now());
    Run(1000U);
    EXPECT_EQ(manager->Status(NodeId{5U}).letter, 'L');
    EXPECT_EQ(readings, 2);
    EXPECT_EQ(Running(5U), 1);
    // When somebody else has stopped it before, it stays so
    Put(Nmt(NmtCommand::kStop, 5U));
    Run(10U);
    manager->OnBus(false, Now());
    manager->OnBus(true, Now());
    Run(1000U);
    EXPECT_EQ(manager->Status(NodeId{5U}).letter, 'L');
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kStopped);
    EXPECT_EQ(starts, (std::vector<std::string>{}));
}

TEST_P(LeftInCia302Test, SaysPreOperationalWhileItsBootUpIsWaitedForIsNotAsked)
{
    Verifies(req::SRS_BOOT_002);
    setups[5].assignment = static_cast<std::uint32_t>(setups[5].assignment & ~kMandatory);
    setups[5].heartbeat = HeartbeatSetup{300U, 100U, Arming::kFirstHeartbeat};
    StartAndForget(GetParam());
    devices[0]->is_on = false;
    Run(3000U);
    devices[0]->has_boot_up = false;
    devices[0]->Power(Now());
    Run(1000U);
    EXPECT_EQ(readings, 0);
    EXPECT_EQ(manager->Status(NodeId{5U}).step, StartUpStep::kWaitBootUp);
}

INSTANTIATE_TEST_SUITE_P(Cia302, LeftInCia302Test, ::testing::Values(Profile::kCia302));

} // namespace
} // namespace counterpoint::cia302
