// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Orders, events and frames that come where the EL6751 profile expects them least: while a stop or a reset waits, while
// a start is verified, for safety slaves that are not what they were.
#include "tests/canopen/start_up/el6751/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

class El6751OrdersTest : public El6751Rig
{
  public:
    NmtAnswer Command(const NmtCommand what, const std::uint8_t node)
    {
        return Do([&] { return el.Command(what, NodeId{node}, Now()); });
    }
    bool Boot(const std::uint8_t node)
    {
        return Do([&] { return el.Boot(NodeId{node}, Now()); });
    }
    bool Resume(const std::uint8_t node)
    {
        return Do([&] { return el.Resume(NodeId{node}, Now()); });
    }
    bool Configure(const std::uint8_t node)
    {
        return Do([&] { return el.Configure(NodeId{node}, Now()); });
    }
    void DropStart(const std::uint8_t node)
    {
        static_cast<void>(Do(
            [&]
            {
                gate.Close(NodeId{node}); // As the manager does it.
                el.OnStartDropped(NodeId{node}, Now());
                return true;
            }));
    }
    void Event(const std::uint8_t node, const NodeEvent event)
    {
        static_cast<void>(Do(
            [&]
            {
                el.OnNodeEvent(NodeId{node}, event, Now());
                return true;
            }));
    }
    void Controller(const ControllerState state)
    {
        static_cast<void>(Do(
            [&]
            {
                el.OnController(state, Now());
                return true;
            }));
    }
    /// It tells its state now.
    void Say(const std::uint8_t node, const std::uint8_t state)
    {
        slaves.at(node)->Turn(state);
        Put(0x700U + node, {state});
    }
    /// Safety slave 5, started.
    void Running()
    {
        AddSafety(5U);
        Begin();
        Run(50U);
        ASSERT_EQ(Code(5U), 0);
        Say(5U, 5U);
        Say(5U, 5U);
        sent.clear();
    }
};

TEST_F(El6751OrdersTest, EventsBeforeTheBeginAndWithoutABusChangeNothing)
{
    Verifies(req::SRS_ELM_044);
    AddBox(5U);
    Event(5U, NodeEvent::kBootUp);
    EXPECT_FALSE(Boot(5U) || Resume(5U));
    Begin();
    Run(50U);
    ASSERT_EQ(Code(5U), 0);
    // What changes no phase by itself, and what is told of a node that is not in the network
    for (const NodeEvent event : {NodeEvent::kNeverSeen, NodeEvent::kUnexpected, NodeEvent::kInvalid,
                                  NodeEvent::kGuardMissed, static_cast<NodeEvent>(0x7FU)})
    {
        Event(5U, event);
        EXPECT_EQ(Code(5U), 0);
    }
    EXPECT_FALSE(Boot(9U) || Resume(9U));
    // The same state of the controller twice
    sent.clear();
    Controller(ControllerState::kRunning);
    EXPECT_EQ(Commands(), (Log{}));
    Controller(ControllerState::kBusOff);
    const int code = Code(5U);
    Event(5U, NodeEvent::kBootUp);
    Event(5U, NodeEvent::kHeartbeatLost);
    Run(50U);
    EXPECT_EQ(Code(5U), code);
    EXPECT_EQ(Commands(), (Log{}));
    EXPECT_EQ(el.Identity(), IdentityRule::kEl6751);
}

TEST_F(El6751OrdersTest, ACommandThatIsNoneIsRefused)
{
    Verifies(req::SRS_ELM_047);
    AddBox(5U);
    Begin();
    Run(50U);
    sent.clear();
    EXPECT_EQ(Command(NmtCommand::kInvalid, 5U), NmtAnswer::kWrong);
    EXPECT_EQ(Command(static_cast<NmtCommand>(0x55U), 5U), NmtAnswer::kWrong);
    EXPECT_EQ(Commands(), (Log{}));
}

TEST_F(El6751OrdersTest, ResumedOrConfiguredItIsStartedUp)
{
    Verifies(req::SRS_SFS_214);
    Verifies(req::SRS_NMM_009);
    AddBox(5U);
    Begin();
    Run(50U);
    sent.clear();
    slaves[5]->log.clear();
    EXPECT_TRUE(Resume(5U));
    Run(50U);
    EXPECT_EQ(Commands(), (Log{"01 05"}));
    EXPECT_EQ(Code(5U), 0);
    EXPECT_FALSE(slaves[5]->log.empty());
    sent.clear();
    EXPECT_TRUE(Configure(5U));
    Run(50U);
    EXPECT_EQ(Commands(), (Log{"82 05", "01 05"}));
    // One that is held by hand stays as it is
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    sent.clear();
    EXPECT_TRUE(Resume(5U));
    Run(50U);
    EXPECT_EQ(Commands(), (Log{}));
    EXPECT_FALSE(Configure(9U));
}

TEST_F(El6751OrdersTest, ADroppedStartIsMadeUpForWhileItIsWanted)
{
    Verifies(req::SRS_NMM_121);
    // Given a start that waits for its turn behind the reset
    setup.inhibit_100us = 500U;
    AddSafety(5U);
    Begin();
    EXPECT_LT(RunUntil([this] { return Of(5U).step == StartUpStep::kStart; }, 200U), 200U);
    const int verified = gate.verifications;
    DropStart(5U);
    EXPECT_EQ(Of(5U).step, StartUpStep::kSafety);
    setup.inhibit_100us = 0U;
    Run(50U);
    EXPECT_GT(gate.verifications, verified);
    EXPECT_EQ(Code(5U), 0);
    // One that runs is owed nothing
    DropStart(5U);
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(El6751OrdersTest, AStopThatWaitsIsSentInEachPhaseThatStops)
{
    Verifies(req::SRS_ELM_042);
    // Given slaves whose reaction to a fault is a stop: 5 for good, 6 with a restart; and 7 that the gate refuses
    AddBox(5U);
    AddBox(6U);
    AddSafety(7U);
    boxes[5].restart = El6751Restart::kByHand;
    Begin();
    Run(50U);
    Say(7U, 5U);
    nmt.SetActive(false);
    gate.verdict = GateState::kDiffers;
    gate.Close(NodeId{7U});
    Say(7U, 5U);
    Event(5U, NodeEvent::kHeartbeatLost);
    Event(6U, NodeEvent::kHeartbeatLost);
    Run(50U);
    // A boot-up message meanwhile changes nothing of that
    Event(5U, NodeEvent::kBootUp);
    Event(6U, NodeEvent::kBootUp);
    Event(7U, NodeEvent::kBootUp);
    EXPECT_EQ(Command(NmtCommand::kStart, 6U), NmtAnswer::kTaken); // Behind all that.
    EXPECT_FALSE(Configure(6U));
    sent.clear();
    nmt.SetActive(true);
    Run(5U);
    const Log commands = Commands();
    for (const char* const command : {"02 05", "02 06", "02 07"})
    {
        EXPECT_EQ(std::count(commands.begin(), commands.end(), command), 1) << command;
    }
}

TEST_F(El6751OrdersTest, OneThatRestartsByHandMayRestartWhileItsStartWaits)
{
    Verifies(req::SRS_ELM_043);
    AddBox(5U);
    boxes[5].restart = El6751Restart::kByHand;
    setup.inhibit_100us = 500U;
    Begin();
    EXPECT_LT(RunUntil([this] { return Of(5U).step == StartUpStep::kStart; }, 200U), 200U);
    // When it boots anew, or is lost, before its start has left
    Event(5U, NodeEvent::kBootUp);
    Run(200U);
    EXPECT_EQ(Code(5U), 1);
    EXPECT_EQ(slaves[5]->state, 4U);
}

TEST_F(El6751OrdersTest, ALossWhileItIsVerifiedIsAFault)
{
    Verifies(req::SRS_ELM_042);
    AddSafety(5U);
    gate.cycles = 1000;
    Begin();
    Run(50U);
    ASSERT_EQ(Of(5U).step, StartUpStep::kSafety);
    sent.clear();
    Event(5U, NodeEvent::kGuardLost);
    Run(5U);
    EXPECT_EQ(Commands().front(), "02 05");
    // And one of a slave that nobody supervises is none
    Event(5U, NodeEvent::kGuardLost);
    AddBox(6U);
    Event(6U, NodeEvent::kGuardLost);
    EXPECT_EQ(Code(6U), 0);
}

TEST_F(El6751OrdersTest, AFaultStopsAlsoWhoseStartWaits)
{
    Verifies(req::SRS_ELM_043);
    AddBox(5U);
    AddBox(6U);
    boxes[5].network_reaction = El6751NetworkReaction::kStopAll;
    Begin();
    Run(50U);
    // Given slave 6 whose start waits
    setup.inhibit_100us = 5000U;
    EXPECT_TRUE(Boot(6U));
    EXPECT_LT(RunUntil([this] { return Of(6U).step == StartUpStep::kStart; }, 2000U), 2000U);
    Event(5U, NodeEvent::kHeartbeatLost);
    setup.inhibit_100us = 0U;
    Run(50U);
    EXPECT_EQ(Code(6U), 1);
    EXPECT_EQ(slaves[6]->state, 4U);
}

TEST_F(El6751OrdersTest, AStartUpBeginsWhenTheCommandsBeforeItHaveLeft)
{
    Verifies(req::SRS_ELM_770);
    // Given two slaves whose reactions wait for the inhibit time
    AddBox(5U);
    AddBox(6U);
    Begin();
    Run(50U);
    ASSERT_EQ(Code(6U), 0);
    setup.inhibit_100us = 500U;
    sent.clear();
    Event(5U, NodeEvent::kHeartbeatLost);
    Event(6U, NodeEvent::kHeartbeatLost);
    const std::size_t asked = Sdos(6U).size();
    Run(145U); // "02 05", "02 06" and "82 05" have left.
    EXPECT_EQ(Sdos(6U).size(), asked);
    EXPECT_NE(Code(6U), 0);
    // Then nothing of them is left behind the start
    Run(2000U);
    EXPECT_GT(Sdos(6U).size(), asked);
    EXPECT_EQ(Commands(), (Log{"02 05", "02 06", "82 05", "82 06", "01 05", "01 06"}));
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(Code(6U), 0);
}

TEST_F(El6751OrdersTest, AStartThatWaitsDoesNotReachASlaveThatBeginsAnew)
{
    Verifies(req::SRS_ELM_820);
    // Given the starts of 5 and 6, of which the second one waits 1 s
    AddBox(5U);
    AddBox(6U);
    setup.inhibit_100us = 10000U;
    Begin();
    EXPECT_LT(RunUntil([this] { return nmt.IsStarting(NodeId{6U}) && (Code(5U) == 0); }, 3000U), 3000U);
    ASSERT_EQ(Commands(), (Log{"82 00", "01 05"}));
    const std::size_t asked = Sdos(6U).size();
    // When 6 comes with a boot-up message
    Put(0x706U, Octets{0x00U});
    RunUs(step_us);
    // Then its start is given up, and it is set up from the beginning before it is started
    EXPECT_FALSE(nmt.IsStarting(NodeId{6U}));
    Run(2500U);
    EXPECT_EQ(nmt.Dropped(), 1U);
    EXPECT_GT(Sdos(6U).size(), asked);
    EXPECT_EQ(Commands(), (Log{"82 00", "01 05", "01 06", "01 00"}));
    EXPECT_EQ(Code(6U), 0);
}

TEST_F(El6751OrdersTest, TheStartOfAllThatWaitsDoesNotReachASlaveThatBeginsAnew)
{
    Verifies(req::SRS_ELM_820);
    // Given the start of all, which waits 1 s
    AddBox(5U);
    AddBox(6U);
    setup.inhibit_100us = 10000U;
    Begin();
    EXPECT_LT(RunUntil([this] { return nmt.HasStart(kAllNodes); }, 3000U), 3000U);
    ASSERT_EQ(Commands(), (Log{"82 00", "01 05", "01 06"}));
    // When 6 comes with a boot-up message and does not answer any more
    slaves[6]->is_on = false;
    Put(0x706U, Octets{0x00U});
    Run(1500U);
    // Then it is not started
    EXPECT_FALSE(nmt.HasStart(kAllNodes));
    EXPECT_EQ(Commands(), (Log{"82 00", "01 05", "01 06"}));
    // And all are when 6 runs again
    slaves[6]->is_on = true;
    Run(5000U);
    EXPECT_EQ(Commands(), (Log{"82 00", "01 05", "01 06", "01 06", "01 00"}));
}

TEST_F(El6751OrdersTest, AHeldSlaveKeepsItsNodeStateUntilTheCommandIsSent)
{
    Verifies(req::SRS_ELM_800);
    AddBox(5U);
    AddBox(6U);
    Begin();
    Run(50U);
    ASSERT_EQ(Code(6U), 0);
    // Given two holds, of which the first one is sent at once
    setup.inhibit_100us = 500U;
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kStop, 6U), NmtAnswer::kTaken);
    Run(40U);
    EXPECT_EQ(Code(5U), 12);
    EXPECT_EQ(Code(6U), 0);
    EXPECT_EQ(slaves[6]->state, 5U);
    Run(20U);
    EXPECT_EQ(Code(6U), 1);
    EXPECT_EQ(slaves[6]->state, 4U);
    EXPECT_EQ(told[6U].back(), "1");
}

TEST_F(El6751OrdersTest, WhoIsStoppedBecauseOfAnotherOneRunsUntilTheStopIsSent)
{
    Verifies(req::SRS_ELM_800);
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}, std::uint8_t{7U}})
    {
        AddBox(node);
    }
    boxes[5].network_reaction = El6751NetworkReaction::kStopAll;
    boxes[5].restart = El6751Restart::kByHand;
    Begin();
    Run(50U);
    ASSERT_EQ(Code(7U), 0);
    // Given a loss, behind which the stops of 6, 7 and 5 leave one after the other
    setup.inhibit_100us = 500U;
    Event(5U, NodeEvent::kToggleError);
    EXPECT_EQ(Code(6U), 1);
    Run(40U);
    EXPECT_EQ(Code(7U), 0);
    EXPECT_EQ(slaves[7]->state, 5U);
    EXPECT_EQ(Code(5U), 14);
    Run(20U);
    EXPECT_EQ(Code(7U), 1);
    EXPECT_EQ(Code(5U), 14);
    Run(50U);
    EXPECT_EQ(Code(5U), 1);
    EXPECT_EQ(slaves[5]->state, 4U);
}

TEST_F(El6751OrdersTest, AResetThatWaitsIsNoRestartOfItsOwn)
{
    Verifies(req::SRS_ELM_770);
    // Given slaves that a hand restarts, which are reset by order while one waits for the other
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}, std::uint8_t{7U}})
    {
        AddBox(node);
        boxes[node].restart = El6751Restart::kByHand;
    }
    Begin();
    Run(50U);
    setup.inhibit_100us = 400U;
    EXPECT_EQ(Command(NmtCommand::kResetNode, 0U), NmtAnswer::kTaken);
    Run(1000U);
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}, std::uint8_t{7U}})
    {
        EXPECT_EQ(Code(node), 0);
        EXPECT_EQ(slaves[node]->state, 5U);
    }
}

TEST_F(El6751OrdersTest, OneWhoseStartWaitsDoesNotRunYet)
{
    Verifies(req::SRS_ELM_771);
    // Given a slave that ran, whose PRE-OPERATIONAL and start wait
    AddBox(5U);
    Begin();
    Run(50U);
    ASSERT_EQ(Code(5U), 0);
    setup.inhibit_100us = 500U;
    static_cast<void>(nmt.Request(NmtCommand::kResetNode, NodeId{99U}, Now()));
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(40U);
    EXPECT_EQ(Code(5U), 8);
    Run(150U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(slaves[5]->state, 5U);
}

TEST_F(El6751OrdersTest, ACommandOfSomebodyElseRightBehindAStartHidesItNot)
{
    Verifies(req::SRS_ELM_771);
    AddBox(5U);
    boxes[5].node_reaction = El6751NodeReaction::kNone;
    setup.inhibit_100us = 500U;
    Begin();
    EXPECT_LT(RunUntil([this] { return Of(5U).step == StartUpStep::kStart; }, 200U), 200U);
    // When its start leaves and another master's command is heard before anything is done
    setup.inhibit_100us = 0U;
    nmt.OnCycle(Now());
    Put(0x000U, {0x80U, 5U});
    Run(5U);
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(El6751OrdersTest, ARunningSafetySlaveIsVerifiedAgainWhereItsGateIsNotOpen)
{
    Verifies(req::SRS_ELM_049);
    Running();
    const int verified = gate.verifications;
    // Given a gate that closed because frames were lost, and one that found something by itself
    gate.Close(NodeId{5U});
    Run(5U);
    EXPECT_EQ(gate.verifications, verified + 1);
    for (const GateState state : {GateState::kDiffers, GateState::kFailed})
    {
        gate.states[5U] = state;
        Run(5U);
    }
    EXPECT_EQ(gate.verifications, verified + 3);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(Commands(), (Log{}));
    // When it leaves OPERATIONAL and comes back, then it is read before anything else
    boxes[5].node_reaction = El6751NodeReaction::kNone;
    Say(5U, 127U);
    Run(5U);
    EXPECT_EQ(gate.State(NodeId{5U}), GateState::kClosed);
    Say(5U, 5U);
    Say(5U, 5U);
    Run(5U);
    EXPECT_EQ(gate.verifications, verified + 4);
    EXPECT_EQ(Commands(), (Log{}));
}

TEST_F(El6751OrdersTest, OneThatRunsThoughItIsHeldIsReadAgainWhenItsGateCloses)
{
    Verifies(req::SRS_ELM_049);
    boxes[5].is_started = false;
    AddSafety(5U);
    Begin();
    Run(50U);
    Say(5U, 5U);
    Say(5U, 5U);
    Run(5U);
    const int verified = gate.verifications;
    EXPECT_GT(verified, 0);
    gate.Close(NodeId{5U});
    Run(5U);
    EXPECT_EQ(gate.verifications, verified + 1);
}

TEST_F(El6751OrdersTest, AnotherDeviceThatTheGateFindsIsStartedByNoOrder)
{
    Verifies(req::SRS_SFS_009);
    Running();
    gate.verdict = GateState::kDiffers;
    gate.finding = GateFinding{{0x1018U, 1U}, SdoAbort::kNone, 1U, 2U};
    gate.Close(NodeId{5U});
    Run(50U);
    EXPECT_TRUE(Of(5U).is_other);
    EXPECT_EQ(Commands(), (Log{"02 05"}));
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kOtherDevice);
    // What is found of it later takes that not away; that it is silent is no news
    gate.finding = GateFinding{{0x1301U, 1U}, SdoAbort::kNone, 1U, 2U};
    Say(5U, 5U);
    Say(5U, 5U);
    Run(50U);
    EXPECT_TRUE(Of(5U).is_other);
    EXPECT_EQ(Of(5U).object.index, 0x1301U);
}

TEST_F(El6751OrdersTest, ASafetySlaveThatRunsAndDoesNotAnswerIsStoppedAndAskedOn)
{
    Verifies(req::SRS_SFS_006);
    Running();
    slaves[5]->Behave(0x1000U, 0U, Manner::kSilent);
    EXPECT_TRUE(Resume(5U));
    Say(5U, 5U);
    Say(5U, 5U);
    Run(2100U);
    EXPECT_EQ(Commands(), (Log{"02 05"}));
    Run(2100U);
    EXPECT_EQ(Commands(), (Log{"02 05", "80 05"}));
    slaves[5]->Behave(0x1000U, 0U, Manner::kGood);
    Run(2100U);
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(El6751OrdersTest, OneThatIsCutTwiceAndOneThatWasNeverAskedBeginAnew)
{
    Verifies(req::SRS_SFS_009);
    AddSafety(5U);
    slaves[5]->Behave(0x1000U, 0U, Manner::kSilent);
    Begin();
    Run(50U);
    // Given one that is held before it said who it is, twice
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    EXPECT_TRUE(Of(5U).is_other);
    slaves[5]->Behave(0x1000U, 0U, Manner::kGood);
    slaves[5]->log.clear();
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(50U);
    EXPECT_EQ(slaves[5]->log.front(), "r 1000:00");
    EXPECT_EQ(Code(5U), 0);
    EXPECT_FALSE(Of(5U).is_other);
}

TEST_F(El6751OrdersTest, AResetThatWaitsIsSentLater)
{
    Verifies(req::SRS_ELM_046);
    AddBox(5U);
    Begin();
    Run(50U);
    nmt.SetActive(false);
    EXPECT_TRUE(Boot(5U));
    Run(20U);
    EXPECT_EQ(Of(5U).step, StartUpStep::kReset);
    Event(5U, NodeEvent::kBootUp); // Not of this reset.
    Run(5U);
    EXPECT_EQ(Of(5U).step, StartUpStep::kReset);
    sent.clear();
    nmt.SetActive(true);
    Run(50U);
    EXPECT_EQ(Commands().front(), "82 05");
}

} // namespace
} // namespace counterpoint::cia302
