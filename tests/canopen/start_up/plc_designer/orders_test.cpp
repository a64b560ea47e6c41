// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Orders, events and frames that come before the PLC Designer profile has begun, for slaves that are not assigned,
// while nothing can be sent, or for safety slaves that are not what they were.
#include "tests/canopen/start_up/plc_designer/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

class PlcOrdersTest : public PlcRig
{
  public:
    bool Boot(const std::uint8_t node)
    {
        return Do([&] { return plc.Boot(NodeId{node}, Now()); });
    }
    bool Resume(const std::uint8_t node)
    {
        return Do([&] { return plc.Resume(NodeId{node}, Now()); });
    }
    bool Configure(const std::uint8_t node)
    {
        return Do([&] { return plc.Configure(NodeId{node}, Now()); });
    }
    void DropStart(const std::uint8_t node)
    {
        static_cast<void>(Do(
            [&]
            {
                gate.Close(NodeId{node}); // As the manager does it.
                plc.OnStartDropped(NodeId{node}, Now());
                return true;
            }));
    }
    void Event(const std::uint8_t node, const NodeEvent event)
    {
        static_cast<void>(Do(
            [&]
            {
                plc.OnNodeEvent(NodeId{node}, event, Now());
                return true;
            }));
    }
    /// A safety slave with a heartbeat of 50 ms that is supervised, in state 5.
    BusSlave& Running(const std::uint8_t node)
    {
        BusSlave& slave = AddSafety(node);
        setups.at(node).heartbeat = HeartbeatSetup{300U, 50U, Arming::kFirstHeartbeat};
        User(node, 0x1017U, 0U, {50U, 0U});
        Begin();
        Run(800U);
        EXPECT_EQ(Code(node), 5);
        sent.clear();
        return slave;
    }
};

TEST_F(PlcOrdersTest, BeforeTheMasterConfiguresNobodyIsBooted)
{
    Verifies(req::SRS_PLC_001);
    AddPlc(5U);
    EXPECT_FALSE(Boot(5U) || Resume(5U));
    Run(10U);
    EXPECT_EQ(masters, (Log{}));
    Begin();
    EXPECT_FALSE(Boot(5U) || Resume(5U) || Configure(5U));
    Run(600U);
    ASSERT_EQ(Code(5U), 5);
    EXPECT_FALSE(Boot(9U) || Resume(9U) || Configure(9U));
    plc.End();
    sent.clear();
    Run(600U);
    EXPECT_EQ(Commands(), (Log{}));
    EXPECT_EQ(plc.Identity(), IdentityRule::kPlcDesigner);
}

TEST_F(PlcOrdersTest, EventsOfOthersAndOfStatesThatAreNotSupervisedChangeNothing)
{
    Verifies(req::SRS_PLC_017);
    AddPlc(5U);
    slaves[5]->Behave(0x1000U, 0U, Manner::kSilent);
    Begin();
    Run(600U);
    ASSERT_EQ(Code(5U), 3);
    for (const NodeEvent event :
         {NodeEvent::kHeartbeatLost, NodeEvent::kGuardLost, NodeEvent::kChanged, NodeEvent::kBootUp})
    {
        Event(9U, event);
        EXPECT_EQ(Code(9U), 0);
    }
    Event(5U, NodeEvent::kHeartbeatLost);
    Event(5U, NodeEvent::kChanged);
    EXPECT_EQ(Code(5U), 3);
    slaves[5]->Behave(0x1000U, 0U, Manner::kGood);
    Run(600U);
    EXPECT_EQ(Code(5U), 5);
    Event(5U, NodeEvent::kStarted);
    EXPECT_EQ(Code(5U), 5);
}

TEST_F(PlcOrdersTest, ASlaveIsAskedBehindTheSdoOfTheApplication)
{
    Verifies(req::SRS_NMM_030);
    AddPlc(5U);
    slaves[5]->Behave(0x3000U, 0U, Manner::kSilent);
    Begin();
    Run(400U);
    std::array<std::uint8_t, 4> room{};
    EXPECT_TRUE(Do(
        [&]
        {
            return sdo.Upload(NodeId{5U}, ObjectAddress{0x3000U, 0U}, Room{room.data(), 4U}, SdoMode::kNormal, Now());
        }));
    Run(300U);
    EXPECT_EQ(Code(5U), 3);
    EXPECT_EQ(slaves[5]->log.back(), "r 3000:00");
    Run(2000U);
    EXPECT_EQ(Code(5U), 5);
}

TEST_F(PlcOrdersTest, AListThatIsCutWhileItIsWrittenKeepsTheSlaveInState3)
{
    Verifies(req::SRS_PLC_006);
    AddPlc(5U);
    User(5U, 0x2000U, 0U, {1U});
    User(5U, 0x2001U, 0U, {2U});
    slaves[5]->Behave(0x2001U, 0U, Manner::kSilent);
    Begin();
    Run(700U);
    ASSERT_EQ(Of(5U).object.index, 0x2001U);
    setups[5].concise_dcf.size_bytes -= 1U;
    Run(3000U);
    EXPECT_EQ(Code(5U), 3);
    EXPECT_EQ(Of(5U).object.index, 0x1F22U);
    EXPECT_EQ(Of(5U).object.sub, 5U);
}

TEST_F(PlcOrdersTest, ACommandThatCannotBeHandedOverChangesNothing)
{
    Verifies(req::SRS_PLC_015);
    AddPlc(5U);
    Begin600();
    ASSERT_EQ(Code(5U), 5);
    nmt.SetActive(false);
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kNotActive);
    EXPECT_EQ(Command(NmtCommand::kResetNode, 5U), NmtAnswer::kNotActive);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_TRUE(Of(5U).is_started);
}

TEST_F(PlcOrdersTest, TheStartOfAllWaitsUntilItCanBeHandedOver)
{
    Verifies(req::SRS_PLC_014);
    setup.start_up = kIsMaster | kStartAllAtOnce;
    AddPlc(5U);
    Begin();
    EXPECT_LT(RunUntil([this] { return plc.MasterState() == 5; }, 1000U), 1000U);
    nmt.SetActive(false);
    Run(600U);
    EXPECT_EQ(Code(5U), 4);
    sent.clear();
    nmt.SetActive(true);
    Run(5U);
    EXPECT_EQ(Commands(), (Log{"01 00"}));
    EXPECT_EQ(Code(5U), 5);
}

TEST_F(PlcOrdersTest, OneThatSomebodyElseStoppedIsStartedByOrder)
{
    Verifies(req::SRS_PLC_015);
    BusSlave& slave = Running(5U);
    slave.Turn(4U);
    Run(100U);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(50U);
    EXPECT_EQ(slave.state, 5U);
    EXPECT_EQ(Code(5U), 5);
}

TEST_F(PlcOrdersTest, AnotherDeviceIsNotStartedByOrder)
{
    Verifies(req::SRS_SFS_009);
    // Given a safety slave of another type, and a slave of another type
    AddSafety(5U).Set(0x1000U, 0U, 0x192U);
    AddPlc(6U).Set(0x1000U, 0U, 0x192U);
    Begin600();
    ASSERT_EQ(Code(5U), 98);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kOtherDevice);
    EXPECT_EQ(Command(NmtCommand::kStart, 6U), NmtAnswer::kWrong);
    EXPECT_FALSE(Configure(5U));
    EXPECT_TRUE(Configure(6U));
}

TEST_F(PlcOrdersTest, ADroppedStartIsMadeUpForWhereItIsStillWanted)
{
    Verifies(req::SRS_NMM_121);
    BusSlave& slave = Running(5U);
    // Given a start that is ordered behind a command, and waits for the inhibit time
    setup.inhibit_100us = 20000U;
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    const int verified = gate.verifications;
    EXPECT_LT(RunUntil([this] { return nmt.Dropped() == 1U; }, 1000U), 1000U);
    EXPECT_EQ(Code(5U), 4);
    setup.inhibit_100us = 0U;
    Run(50U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_GT(gate.verifications, verified + 1);
    EXPECT_EQ(Commands(), (Log{"80 05", "01 05"}));
    // One that runs, and one that was held since, is not started for it
    DropStart(5U);
    EXPECT_EQ(Code(5U), 5);
    setup.inhibit_100us = 20000U;
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(5U);
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    setup.inhibit_100us = 0U;
    Run(300U);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(slave.state, 127U);
}

TEST_F(PlcOrdersTest, ASafetySlaveThatRunsBehindAClosedGateIsReadAgain)
{
    Verifies(req::SRS_PLC_020);
    Verifies(req::SRS_PLC_031);
    Running(5U);
    const int verified = gate.verifications;
    // Given a gate that was closed because frames were lost, and one that said no by itself
    gate.Close(NodeId{5U});
    Run(100U);
    EXPECT_EQ(gate.verifications, verified + 1);
    EXPECT_EQ(Code(5U), 5);
    gate.states[5U] = GateState::kFailed;
    gate.cycles = 5;
    Run(100U);
    EXPECT_EQ(gate.verifications, verified + 2);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Commands(), (Log{}));
    // When it is another device, then it is stopped and stays so, whatever else is found of it later
    gate.verdict = GateState::kDiffers;
    gate.finding = GateFinding{{0x1018U, 1U}, SdoAbort::kNone, 1U, 2U};
    gate.Close(NodeId{5U});
    Run(100U);
    EXPECT_EQ(Code(5U), 98);
    EXPECT_TRUE(Of(5U).is_other);
    EXPECT_EQ(Commands(), (Log{"02 05"}));
    gate.finding = GateFinding{{0x1301U, 1U}, SdoAbort::kNone, 1U, 2U};
    slaves[5]->Turn(5U);
    Run(300U);
    EXPECT_TRUE(Of(5U).is_other);
    EXPECT_EQ(slaves[5]->state, 4U);
}

TEST_F(PlcOrdersTest, ItIsReadAgainHoweverSoonItsGateClosesAgain)
{
    Verifies(req::SRS_PLC_020);
    Running(5U);
    const int verified = gate.verifications;
    // Given a gate that is closed as soon as it is open, five times
    for (int closed = 0; closed < 5;)
    {
        const bool is_open = (gate.State(NodeId{5U}) == GateState::kOpen);
        closed += is_open ? 1 : 0;
        if (is_open)
        {
            gate.Close(NodeId{5U});
        }
        Run(1U);
    }
    Run(50U);
    EXPECT_EQ(gate.verifications, verified + 5);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Commands(), (Log{}));
}

TEST_F(PlcOrdersTest, WhatTheGateFoundStaysToBeToldOfOneThatLeaves)
{
    Verifies(req::SRS_PLC_020);
    BusSlave& slave = Running(5U);
    for (const GateState state : {GateState::kDiffers, GateState::kFailed})
    {
        gate.states[5U] = state;
        slave.Turn(127U);
        Put(0x705U, {127U});
        EXPECT_EQ(gate.State(NodeId{5U}), state);
        EXPECT_FALSE(Of(5U).is_started);
        gate.Close(NodeId{5U});
        EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
        Run(100U);
        ASSERT_EQ(Code(5U), 5);
    }
}

TEST_F(PlcOrdersTest, OneThatRanBeforeItWasReadAndBootsAnewIsStopped)
{
    Verifies(req::SRS_SFS_006);
    // Given an optional safety slave that says OPERATIONAL while it settles
    AddSafety(5U);
    plc_slaves[5].is_optional = true;
    Begin();
    Run(100U);
    ASSERT_EQ(Code(5U), 2);
    Put(0x705U, {5U});
    Run(5U);
    sent.clear();
    // When it tells again, three times, that it booted, while nothing can be sent
    nmt.SetActive(false);
    Put(0x705U, {0U});
    Put(0x705U, {5U});
    Run(5U);
    Put(0x705U, {0U});
    Put(0x705U, {5U});
    Run(5U);
    Put(0x705U, {0U});
    nmt.SetActive(true);
    Run(5U);
    // Then it is stopped, and woken to be asked, though it is optional and does not answer
    EXPECT_EQ(Commands(), (Log{"02 05"}));
    EXPECT_EQ(slaves[5]->state, 4U);
    Run(2000U);
    EXPECT_EQ(Commands(), (Log{"02 05", "80 05", "01 05"}));
    EXPECT_EQ(Code(5U), 5);
}

TEST_F(PlcOrdersTest, OneThatRanWhileItWasAskedIsStoppedAndOneThatWasConfiguredIsNot)
{
    Verifies(req::SRS_SFS_006);
    // Given a safety slave that says OPERATIONAL while 1000h is read, when it boots anew
    AddSafety(5U).Behave(0x1000U, 0U, Manner::kSilent);
    Begin();
    Run(600U);
    ASSERT_EQ(Code(5U), 3);
    sent.clear();
    Put(0x705U, {5U});
    Run(5U);
    Put(0x705U, {0U});
    Run(5U);
    EXPECT_EQ(Commands(), (Log{"02 05"}));
    plc.End();
    // Given one that is configured, says so while it is verified, and boots anew
    setup.start_up = kIsMaster | kApplicationStartsSlaves;
    gate.cycles = 1000;
    AddSafety(5U);
    Begin();
    Run(600U);
    ASSERT_EQ(Code(5U), 4);
    sent.clear();
    Put(0x705U, {5U});
    Put(0x705U, {5U});
    Run(5U);
    Put(0x705U, {0U});
    Run(5U);
    EXPECT_EQ(Commands(), (Log{}));
    EXPECT_EQ(Code(5U), 2);
}

TEST_F(PlcOrdersTest, AResumedSlaveIsConfiguredWithoutAReset)
{
    Verifies(req::SRS_SFS_214);
    AddPlc(5U);
    Begin600();
    sent.clear();
    EXPECT_TRUE(Resume(5U));
    EXPECT_EQ(Code(5U), 2);
    Run(600U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Commands(), (Log{"01 05"}));
    // One that is held is left as it is
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    EXPECT_TRUE(Resume(5U));
    EXPECT_EQ(Code(5U), 4);
}

} // namespace
} // namespace counterpoint::cia302
