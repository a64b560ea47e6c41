// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Orders and frames before the manager has begun, behind its end, and while it can do nothing with them.
#include "tests/canopen/manager/rig.hpp"
#include "verification/trace/ids/flying_master.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

class ManagerOrdersTest : public ManagerRig
{
  public:
    [[nodiscard]] bool Write(const std::uint8_t node)
    {
        return manager->WriteSafety(NodeId{node}, Now());
    }
    [[nodiscard]] bool Boot(const std::uint8_t node)
    {
        return manager->Role().Boot(NodeId{node}, Now());
    }
    [[nodiscard]] bool Resume(const std::uint8_t node)
    {
        return manager->Role().Resume(NodeId{node}, Now());
    }
    /// Safety slave 5, started.
    void Start()
    {
        Add(5U);
        MakeSafe(5U);
        Begin(Profile::kCia302);
        Run(100U);
        ASSERT_EQ(Running(5U), 1);
    }
    void OnNodeEvent(const NodeId node, const NodeEvent event, const Instant now) noexcept override
    {
        ManagerRig::OnNodeEvent(node, event, now);
        losses += ((event == NodeEvent::kGuardLost) && (node.value == 6U)) ? 1 : 0;
    }

    int losses{0};
};

TEST_F(ManagerOrdersTest, AnOwnerThatEndsItLetsCommandsLeaveThatWait)
{
    Verifies(req::SRS_NMM_520);
    setup.inhibit_100us = 1000U; // 100 ms
    Add(5U);
    Add(6U);
    Begin(Profile::kCia302);
    Run(500U);
    EXPECT_EQ(Order(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Order(NmtCommand::kStop, 6U), NmtAnswer::kTaken);
    ASSERT_EQ(manager->Role().Commands().Waiting(), 1U);
    ASSERT_EQ(stops, 1);
    manager->Role().Finish(Now());
    EXPECT_EQ(manager->Role().Commands().Waiting(), 0U);
    EXPECT_EQ(stops, 2);
}

TEST_F(ManagerOrdersTest, AStartThatCannotLeaveIsNotToldAsOne)
{
    Verifies(req::SRS_BOOT_800);
    Verifies(req::SRS_PLC_800);
    Verifies(req::SRS_ELM_771);
    Add(5U);
    for (const Profile profile : kProfiles)
    {
        SCOPED_TRACE(static_cast<int>(profile));
        Begin(profile);
        Run(3000U);
        ASSERT_TRUE(manager->Status(NodeId{5U}).is_started);
        EXPECT_EQ(Order(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
        Run(10U);
        EXPECT_FALSE(manager->Status(NodeId{5U}).is_started);
        // Given a controller that takes nothing
        is_sink_full = true;
        EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
        Run(500U);
        EXPECT_FALSE(manager->Status(NodeId{5U}).is_started);
        EXPECT_NE(manager->Status(NodeId{5U}).code, 5);
        EXPECT_EQ(Running(5U), 0);
        // When it takes frames again
        is_sink_full = false;
        Run(10U);
        EXPECT_TRUE(manager->Status(NodeId{5U}).is_started);
        EXPECT_EQ(Running(5U), 1);
        manager->End();
    }
}

TEST_F(ManagerOrdersTest, WithoutAProfileNothingBegins)
{
    Verifies(req::SRS_MGR_001);
    std::array<NodeRecord, kNodeRoom> records{};
    std::array<WatchedNode, kNodeRoom> watched{};
    std::array<GateState, kNodeRoom> gates{};
    std::array<NmtRequest, 8> queue{};
    std::array<SafetySlot, 1> slots{};
    SdoLanes<1> lanes{*this, SdoTimes{500'000U, 1U}};
    const ManagerRoom room{records.data(),     watched.data(), gates.data(),          {queue.data(), 8U},
                           {slots.data(), 1U}, lanes.All(),    SdoTimes{500'000U, 1U}};
    Manager bare{ManagerParts{setup, *this, *this, room, 0U}};
    bare.Begin(Now());
    bare.OnCycle(Now());
    bare.OnFrame(Nmt(NmtCommand::kStart, 5U), Now());
    EXPECT_FALSE(static_cast<const Manager&>(bare).Role().IsRunning());
    EXPECT_FALSE(bare.IsActive());
    EXPECT_EQ(bare.MasterState(), 0);
    EXPECT_EQ(bare.Status(NodeId{5U}).step, StartUpStep::kNone);
    EXPECT_EQ(asked, 0);
    bare.End();
    EXPECT_FALSE(bare.Role().IsRunning());
}

TEST_F(ManagerOrdersTest, BehindItsEndItCommandsNobody)
{
    Verifies(req::SRS_MGR_002);
    Start();
    manager->OnBus(true, Now()); // As it was.
    manager->End();
    asked = 0;
    EXPECT_EQ(Order(NmtCommand::kStop, 5U), NmtAnswer::kNotActive);
    EXPECT_FALSE(Boot(5U) || Resume(5U) || Write(5U));
    manager->OnStartDropped(NodeId{5U}, Now());
    manager->OnNodeEvent(NodeId{5U}, NodeEvent::kBootUp, Now());
    manager->OnLost(Now());
    Run(200U);
    EXPECT_EQ(asked, 0);
    EXPECT_EQ(Running(5U), 1);
}

TEST_F(ManagerOrdersTest, ItSendsItsHeartbeatAsOften)
{
    Verifies(req::SRS_MGR_020);
    Start();
    EXPECT_EQ(Order(NmtCommand::kPreOperational, 127U), NmtAnswer::kTaken);
    EXPECT_EQ(manager->OwnState(), cia301::NodeState::kPreOperational);
    EXPECT_EQ(Order(NmtCommand::kStart, 127U), NmtAnswer::kTaken);
    manager->Heartbeat().SetPeriod(50U);
    Run(100U);
    EXPECT_EQ(manager->Heartbeat().PeriodMs(), 50U);
}

TEST_F(ManagerOrdersTest, ASafetyConfigurationIsNotWrittenWhereItCannotBe)
{
    Verifies(req::SRS_SFS_212);
    // Given a slave in the middle of its start-up, one that is no safety slave, and one that runs
    Add(5U).boot_ms = 300U;
    MakeSafe(5U);
    Add(6U);
    Begin(Profile::kCia302);
    Run(20U);
    EXPECT_FALSE(Write(5U));
    EXPECT_FALSE(Write(6U));
    Run(500U);
    ASSERT_EQ(Running(5U), 1);
    EXPECT_FALSE(Write(5U));
    // One that was stopped, while the command that wakes it waits
    EXPECT_EQ(Order(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(20U);
    setup.inhibit_100us = 500U;
    EXPECT_EQ(Order(NmtCommand::kStop, 6U), NmtAnswer::kTaken);
    EXPECT_FALSE(Write(5U));
    EXPECT_FALSE(Write(5U)); // Commands wait.
    setup.inhibit_100us = 0U;
    Run(20U);
    EXPECT_TRUE(Write(5U));
    EXPECT_FALSE(Write(5U)); // It is being written.
    EXPECT_FALSE(Write(6U));
    Run(500U);
    EXPECT_EQ(devices[0]->Get(0x13FEU, 0U), (Octets{0xA5U}));
}

TEST_F(ManagerOrdersTest, FramesThatAreNoCommandsAndNoSignsChangeNothing)
{
    Verifies(req::SRS_MGR_003);
    Start();
    asked = 0;
    CanFrame shorter = Nmt(NmtCommand::kResetNode, 127U);
    shorter.length_bytes = 1U;
    Put(shorter);
    Put(CanFrame{0x700U, FrameKind::kData, CanPortId::kFirst, 1U, {0U}});
    // Somebody commands this device, which is no slave of anybody
    Put(Nmt(NmtCommand::kStop, 127U));
    EXPECT_EQ(manager->OwnState(), cia301::NodeState::kOperational);
    Run(100U);
    EXPECT_EQ(asked, 0);
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(Gate(), GateState::kOpen);
}

TEST_F(ManagerOrdersTest, AGuardedSlaveThatIsLostIsTold)
{
    Verifies(req::SRS_MGR_001);
    Add(6U);
    setups[6].assignment |= (3U << 8U) | (100U << 16U);
    Begin(Profile::kCia302);
    Run(500U);
    ASSERT_EQ(Running(6U), 1);
    devices[0]->Unplug();
    Run(600U);
    EXPECT_EQ(losses, 1);
}

TEST_F(ManagerOrdersTest, ResettingItselfWithoutAFlyingMasterLeavesItInCommand)
{
    Verifies(req::SRS_FLY_019);
    Start();
    EXPECT_EQ(Order(NmtCommand::kResetNode, 127U), NmtAnswer::kTaken);
    EXPECT_EQ(manager->OwnState(), cia301::NodeState::kPreOperational);
    Run(20U);
    EXPECT_TRUE(manager->IsActive());
    EXPECT_EQ(Running(5U), 1);
    EXPECT_TRUE(Resume(5U));
    EXPECT_FALSE(Boot(9U) || Resume(9U));
}

TEST_F(ManagerOrdersTest, AMasterWithoutANodeIdResetsAllAndNotItself)
{
    Verifies(req::SRS_MGR_001);
    setup.own = NodeId{0U};
    Add(5U);
    Begin(Profile::kCia302);
    Run(100U);
    EXPECT_TRUE(manager->IsActive());
    EXPECT_EQ(Running(5U), 1);
}

TEST_F(ManagerOrdersTest, AStartOfSomebodyElseOfOneThatIsStartedAndVerifiedChangesNothing)
{
    Verifies(req::SRS_SFS_006);
    Start();
    asked = 0;
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(100U);
    EXPECT_EQ(asked, 0);
    EXPECT_EQ(Gate(), GateState::kOpen);
    // Where its gate is not open, it is read
    manager->OnNodeEvent(NodeId{5U}, NodeEvent::kToggleError, Now());
    ASSERT_EQ(Gate(), GateState::kClosed);
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(100U);
    EXPECT_GT(asked, 0);
    EXPECT_EQ(Gate(), GateState::kOpen);
}

TEST_F(ManagerOrdersTest, LostFramesCountForOneThatRunsByItselfToo)
{
    Verifies(req::SRS_SFS_002);
    // Given a safety slave that was started by somebody else, told OPERATIONAL and was verified
    setup.start_up = kIsMaster | kApplicationStartsSlaves;
    Add(5U).heartbeat_ms = 20U;
    MakeSafe(5U);
    Begin(Profile::kCia302);
    Run(100U);
    ASSERT_EQ(Running(5U), 0);
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(200U);
    ASSERT_EQ(Gate(), GateState::kOpen);
    asked = 0;
    manager->OnLost(Now());
    Run(200U);
    EXPECT_GT(asked, 0);
    EXPECT_EQ(Gate(), GateState::kOpen);
    EXPECT_EQ(Running(5U), 1);
}

} // namespace
} // namespace counterpoint::cia302
