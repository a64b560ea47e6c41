// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Slaves that booted or were replaced while the manager lost frames, and starts that waited too long.
#include "tests/canopen/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"

namespace counterpoint::cia302
{
namespace
{

/// Given a safety slave 5 and another slave 6, with heartbeats each 100 ms.
class LostFramesTest : public ManagerRig, public ::testing::WithParamInterface<Profile>
{
  public:
    LostFramesTest()
    {
        Add(5U).heartbeat_ms = 100U;
        Add(6U).heartbeat_ms = 100U;
        MakeSafe(5U);
    }
    /// Its boot-up message is among the lost frames.
    void RestartUnheard(const std::size_t device)
    {
        devices[device]->has_boot_up = false;
        devices[device]->Power(Now());
        Run(5U);
        devices[device]->has_boot_up = true;
    }
    void RunUntilVerified()
    {
        for (int i = 0; (i < 5000) && (Gate() != GateState::kOpen); ++i)
        {
            Run(1U);
        }
        ASSERT_EQ(Gate(), GateState::kOpen);
    }
    /// 2 s between two commands, and the start of slave 5 waits for them.
    void BeginWithWaitingStart()
    {
        setup.inhibit_100us = 20000U;
        Begin(Profile::kCia302);
        RunUntilVerified();
        Run(50U);
        ASSERT_TRUE(manager->Role().Commands().HasStart(NodeId{5U}));
        ASSERT_FALSE(manager->Status(NodeId{5U}).is_started);
        ASSERT_EQ(starts, (std::vector<std::string>{}));
    }
    [[nodiscard]] char Letter() const
    {
        return manager->Status(NodeId{5U}).letter;
    }
};

TEST_P(LostFramesTest, WhoBootedMeanwhileIsStartedUpAgain)
{
    Verifies(req::SRS_NMM_020);
    Begin(GetParam());
    Run(3000U);
    ASSERT_EQ(Running(5U), 1);
    ASSERT_EQ(Running(6U), 1);
    RestartUnheard(0U);
    RestartUnheard(1U);
    manager->OnLost(Now());
    Run(3000U);
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(Running(6U), 1);
    EXPECT_EQ(Gate(), GateState::kOpen);
}

TEST_P(LostFramesTest, WhoRanOnIsLeftAlone)
{
    Verifies(req::SRS_NMM_020);
    Begin(GetParam());
    Run(3000U);
    starts.clear();
    manager->OnLost(Now());
    Run(3000U);
    EXPECT_EQ(starts, (std::vector<std::string>{}));
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(Running(6U), 1);
    // When it is made PRE-OPERATIONAL by order later, it stays so
    EXPECT_EQ(Order(NmtCommand::kPreOperational, 6U), NmtAnswer::kTaken);
    Run(3000U);
    EXPECT_EQ(Running(6U), 0);
}

TEST_P(LostFramesTest, WhoWasMadePreOperationalByOrderStaysSo)
{
    Verifies(req::SRS_NMM_020);
    Begin(GetParam());
    Run(3000U);
    EXPECT_EQ(Order(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Order(NmtCommand::kPreOperational, 6U), NmtAnswer::kTaken);
    manager->OnLost(Now());
    Run(3000U);
    EXPECT_EQ(Running(5U), 0);
    EXPECT_EQ(Running(6U), 0);
}

TEST_P(LostFramesTest, WhoIsReadAgainAndLeavesAndComesBackChangedIsStopped)
{
    Verifies(req::SRS_SFS_002);
    Verifies(req::SRS_SFS_153);
    Verifies(req::SRS_SFS_006);
    for (const std::uint32_t pause_ms : {1U, 2U, 10U, 40U, 80U})
    {
        devices[0]->Put(0x1301U, 2U, {25U, 0U});
        Begin(GetParam());
        Run(6000U);
        ASSERT_EQ(Running(5U), 1);
        // Given one that is being read again when somebody takes it out of OPERATIONAL
        manager->OnLost(Now());
        Run(2U);
        Put(Nmt(NmtCommand::kPreOperational, 5U));
        Run(pause_ms);
        // When it is changed and started by somebody, whether or not it was read to the end
        devices[0]->Put(0x1301U, 2U, {26U, 0U});
        Put(Nmt(NmtCommand::kStart, 5U));
        Run(1500U);
        EXPECT_EQ(Running(5U), 0) << pause_ms;
        EXPECT_EQ(Gate(), GateState::kDiffers) << pause_ms;
    }
}

INSTANTIATE_TEST_SUITE_P(Profiles, LostFramesTest, ::testing::ValuesIn(kProfiles));

TEST_F(LostFramesTest, WhoWasReplacedMeanwhileIsAskedWhoItIs)
{
    Verifies(req::SRS_NMM_020);
    Begin(Profile::kCia302);
    Run(1000U);
    ASSERT_EQ(Running(5U), 1);
    starts.clear();
    devices[0]->Put32(0x1018U, 4U, 0x4321U);
    RestartUnheard(0U);
    manager->OnLost(Now());
    Run(3000U);
    EXPECT_EQ(Letter(), 'O');
    EXPECT_EQ(starts, (std::vector<std::string>{}));
}

TEST_F(LostFramesTest, TwoStartsOfOneSlaveThatWaitedTooLongAreMadeUpFor)
{
    Verifies(req::SRS_BOOT_014);
    Verifies(req::SRS_SFS_152);
    BeginWithWaitingStart();
    // When it is ordered once more, so that both are too old in the same cycle
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(9000U);
    EXPECT_EQ(Running(5U), 1);
}

TEST_F(LostFramesTest, WhoseStartWaitsWhileTheBusIsAwayIsAskedWhoItIs)
{
    Verifies(req::SRS_BOOT_018);
    BeginWithWaitingStart();
    manager->OnBus(false, Now());
    devices[0]->Put32(0x1018U, 4U, 0x4321U);
    manager->OnBus(true, Now());
    Run(9000U);
    EXPECT_EQ(Letter(), 'O');
    EXPECT_EQ(Running(5U), 0);
}

TEST_F(LostFramesTest, WhoIsBootedBeforeAllResetsLeftIsAskedAgainToo)
{
    Verifies(req::SRS_BOOT_018);
    // Given 3 ms between two commands, and single resets because of a slave that is kept alive
    setup.inhibit_100us = 30U;
    setups[6].assignment |= kKeepAlive;
    Begin(Profile::kCia302);
    RunUntilVerified();
    ASSERT_EQ(manager->MasterState(), static_cast<std::int16_t>(MasterStep::kReset));
    manager->OnBus(false, Now());
    devices[0]->Put32(0x1018U, 4U, 0x4321U);
    manager->OnBus(true, Now());
    Run(3000U);
    EXPECT_EQ(Letter(), 'O');
    EXPECT_EQ(Running(5U), 0);
}

TEST_F(LostFramesTest, AnotherDeviceThatGaveWayWhileTheBusWasAwayIsStarted)
{
    Verifies(req::SRS_BOOT_018);
    devices[0]->Put32(0x1018U, 4U, 0x4321U);
    setups[5].serial_number = 0x1234U;
    Begin(Profile::kCia302);
    Run(1000U);
    ASSERT_EQ(Letter(), 'O');
    manager->OnBus(false, Now());
    devices[0]->PutIdentity();
    manager->OnBus(true, Now());
    Run(1000U);
    EXPECT_EQ(Letter(), '\0');
    EXPECT_EQ(Running(5U), 1);
}

TEST_F(LostFramesTest, WhoseStartByOrderWaitsWhileTheBusIsAwayIsAskedWhoItIs)
{
    Verifies(req::SRS_BOOT_018);
    // Given 2 s between two commands, and a start behind the command that made slave 6 PRE-OPERATIONAL
    setup.inhibit_100us = 20000U;
    Begin(Profile::kCia302);
    Run(20000U);
    ASSERT_EQ(Running(6U), 1);
    EXPECT_EQ(Order(NmtCommand::kPreOperational, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(Order(NmtCommand::kStart, 6U), NmtAnswer::kTaken);
    manager->OnBus(false, Now());
    devices[1]->Put32(0x1018U, 4U, 0x4321U);
    manager->OnBus(true, Now());
    Run(9000U);
    EXPECT_EQ(manager->Status(NodeId{6U}).letter, 'O');
    EXPECT_EQ(Running(6U), 0);
}

TEST_F(LostFramesTest, WhomSomebodyElseStoppedIsNotStartedWhenTheBusIsBack)
{
    Verifies(req::SRS_BOOT_018);
    Verifies(req::SRS_BOOT_230);
    Begin(Profile::kCia302);
    Run(1000U);
    ASSERT_EQ(Running(5U) + Running(6U), 2);
    Put(Nmt(NmtCommand::kStop, 5U));
    Put(Nmt(NmtCommand::kPreOperational, 6U));
    Run(300U);
    manager->OnBus(false, Now());
    Run(50U);
    manager->OnBus(true, Now());
    Run(3000U);
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kStopped);
    EXPECT_EQ(devices[1]->State(), cia301::NodeState::kPreOperational);
    EXPECT_EQ(starts, (std::vector<std::string>{"6", "5"})); // One start each.
    // When somebody starts them by order, they run again
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Order(NmtCommand::kStart, 6U), NmtAnswer::kTaken);
    Run(1000U);
    EXPECT_EQ(Running(5U) + Running(6U), 2);
}

TEST_F(LostFramesTest, WhomSomebodyElseResetAndWhoseBootUpMessageIsLostWithTheBusIsStartedAgain)
{
    Verifies(req::SRS_BOOT_018);
    Begin(Profile::kCia302);
    Run(1000U);
    // Given a reset by somebody else, and a bus that is away before the boot-up messages
    devices[0]->has_boot_up = false;
    devices[1]->has_boot_up = false;
    Put(Nmt(NmtCommand::kResetNode, 0U));
    Run(1U);
    manager->OnBus(false, Now());
    Run(10U);
    manager->OnBus(true, Now());
    Run(2000U);
    EXPECT_EQ(Running(5U) + Running(6U), 2);
}

} // namespace
} // namespace counterpoint::cia302
