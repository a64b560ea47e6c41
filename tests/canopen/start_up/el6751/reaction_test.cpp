// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Errors of started slaves: their NodeState, and what follows for them and for the others.
#include "tests/canopen/start_up/el6751/rig.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

/// Slave 5 with heartbeat 100 ms x 3, slave 6 without anything; both run when Ready ends, at 500 ms.
class El6751ReactionTest : public El6751Rig
{
  public:
    void Ready()
    {
        AddBox(5U);
        AddBox(6U);
        boxes[5].guard_time_ms = 100U;
        boxes[5].life_time_factor = 3U;
        Prepare();
        Begin();
        Run(500U);
        ASSERT_EQ(slaves[5]->state, 5U);
        told.clear();
        sent.clear();
    }
    virtual void Prepare()
    {
    }
};

TEST_F(El6751ReactionTest, ByDefaultALostSlaveIsStoppedAndRestartedWithResetCommunication)
{
    Verifies(req::SRS_ELM_039);
    Verifies(req::SRS_ELM_042);
    Ready();
    EXPECT_EQ(Code(5U), 0);
    // Given that it falls silent but for its SDOs
    slaves[5]->heartbeat_us = 0U;
    const std::uint32_t took_ms = RunUntil([this] { return Code(5U) != 0; }, 1000U);
    EXPECT_LE(took_ms, 301U);
    EXPECT_GE(took_ms, 200U); // The last one came 100 ms before, at the most.
    EXPECT_EQ(Code(5U), 1);
    EXPECT_EQ(Commands(), (Log{"02 05", "82 05"}));
    Run(50U);
    // Then its start-up runs again as a whole, and nobody else is concerned
    EXPECT_EQ(told[5], (Log{"1", "8", "0"}));
    EXPECT_EQ(Commands(), (Log{"02 05", "82 05", "01 05"}));
    EXPECT_EQ(told.count(6U), 0U);
    EXPECT_EQ(el.Cause(NodeId{5U}), 1);
}

TEST_F(El6751ReactionTest, ASlaveThatWasPulledIsNotFoundUntilItComesBack)
{
    Verifies(req::SRS_ELM_039);
    Verifies(req::SRS_ELM_003);
    Ready();
    slaves[5]->is_on = false;
    Run(4000U);
    EXPECT_EQ(told[5], (Log{"1", "2"}));
    // Another one with other numbers is not taken
    slaves[5]->Set(0x1018U, 4U, 0x9999U);
    setups[5].serial_number = 0x1234U;
    slaves[5]->Power(Now().us);
    Run(50U);
    EXPECT_EQ(told[5], (Log{"1", "2", "8", "5"}));
    slaves[5]->Set(0x1018U, 4U, 0x1234U);
    slaves[5]->Power(Now().us);
    Run(50U);
    EXPECT_EQ(told[5], (Log{"1", "2", "8", "5", "8", "0"}));
}

class El6751GuardedTest : public El6751ReactionTest
{
  public:
    void Prepare() override
    {
        slaves[5]->Behave(0x1017U, 0U, Manner::kAbort);
    }
};

TEST_F(El6751GuardedTest, GuardingLostAfterTheLifeTimeFactor)
{
    Verifies(req::SRS_ELM_039);
    Ready();
    EXPECT_EQ(Code(5U), 0);
    slaves[5]->answers_guard = false;
    Run(299U);
    EXPECT_EQ(Code(5U), 0);
    const std::uint32_t took_ms = RunUntil([this] { return Code(5U) != 0; }, 1000U);
    EXPECT_LE(took_ms, 110U);
    EXPECT_EQ(Code(5U), 1);
    EXPECT_EQ(Commands(), (Log{"02 05", "82 05"}));
}

TEST_F(El6751GuardedTest, TheSameToggleBitTwiceIsNodeState14)
{
    Verifies(req::SRS_ELM_040);
    Ready();
    slaves[5]->is_toggle_stuck = true;
    const std::uint32_t took_ms = RunUntil([this] { return Code(5U) != 0; }, 1000U);
    EXPECT_LE(took_ms, 201U);
    EXPECT_EQ(Code(5U), 14);
    EXPECT_EQ(Commands(), (Log{"02 05", "82 05"}));
    slaves[5]->is_toggle_stuck = false;
    Run(50U);
    EXPECT_EQ(told[5], (Log{"14", "8", "0"}));
}

TEST_F(El6751GuardedTest, WithoutAReactionNodeState14StaysUntilTheAnswersToggle)
{
    Verifies(req::SRS_ELM_040);
    Verifies(req::SRS_ELM_043);
    Ready();
    boxes[5].node_reaction = El6751NodeReaction::kNone;
    // Given answers that do not toggle: the first one is an error, with the third one the slave is lost
    slaves[5]->is_toggle_stuck = true;
    const std::uint32_t took_ms = RunUntil([this] { return Code(5U) != 0; }, 1000U);
    EXPECT_LE(took_ms, 201U);
    Run(200U);
    EXPECT_EQ(told[5], (Log{"14"}));
    Run(600U);
    EXPECT_EQ(told[5], (Log{"14", "1"}));
    // When they toggle again
    slaves[5]->is_toggle_stuck = false;
    Run(250U);
    EXPECT_EQ(told[5], (Log{"14", "1", "0"}));
    EXPECT_TRUE(Commands().empty());
}

TEST_F(El6751ReactionTest, ASlaveThatTurnsPreOperationalByItselfIsNodeState12)
{
    Verifies(req::SRS_ELM_041);
    Ready();
    slaves[5]->Turn(127U);
    Run(101U);
    EXPECT_EQ(told[5].front(), "12");
    EXPECT_EQ(Commands()[0], "02 05");
    EXPECT_EQ(Commands()[1], "82 05");
    Run(50U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(el.Cause(NodeId{5U}), 12);
}

TEST_F(El6751ReactionTest, ASlaveThatStopsByItselfIsNodeState1)
{
    Verifies(req::SRS_ELM_041);
    Ready();
    slaves[5]->Turn(4U);
    Run(101U);
    EXPECT_EQ(told[5].front(), "1");
}

TEST_F(El6751ReactionTest, AHeartbeatThatCrossesTheStartIsNoErrorButRefusalOfTheStartIsOne)
{
    Verifies(req::SRS_ELM_041);
    Ready();
    slaves[5]->is_deaf_to_start = true;
    slaves[5]->Power(Now().us);
    Run(20U);
    ASSERT_EQ(Code(5U), 0);
    told.clear();
    // For 1 s it may say PRE-OPERATIONAL
    Run(980U);
    EXPECT_EQ(told[5], (Log{}));
    Run(130U);
    EXPECT_EQ(told[5].front(), "12");
}

TEST_F(El6751ReactionTest, APdoThatIsTooShortIsAnErrorThoughAGoodOneFollowsAtOnce)
{
    Verifies(req::SRS_ELM_038);
    Verifies(req::SRS_ELM_042);
    AddBox(5U);
    Tx(5U, MakePdo(1U, 0x185U, 255U, 4U, 0U, 0U));
    Begin();
    Run(50U);
    Put(0x185U, Octets(4U));
    Run(1U);
    ASSERT_EQ(Code(5U), 0);
    sent.clear();
    Put(0x185U, Octets(3U));
    Put(0x185U, Octets(4U));
    EXPECT_EQ(Code(5U), 20);
    EXPECT_EQ(Commands(), (Log{"02 05", "82 05"}));
    Run(50U);
    EXPECT_EQ(Code(5U), 23);
}

TEST_F(El6751ReactionTest, APdoMissingInItsCycleIsNodeState40AndLeadsToTheReaction)
{
    Verifies(req::SRS_ELM_034);
    Verifies(req::SRS_ELM_042);
    setup.sync_period_us = 10000U;
    step_us = 100U;
    AddBox(5U);
    Tx(5U, MakePdo(1U, 0x185U, 1U, 4U, 0U, 0U));
    slaves[5]->pdos.push_back(SentPdo{0x185U, 4U, 1U, 300U, 0U, 0, 0U, 0U});
    Begin();
    Run(200U);
    EXPECT_EQ(told[5], (Log{"8", "23", "0"}));
    slaves[5]->pdos[0].skip = 1;
    const std::uint32_t took_ms = RunUntil([this] { return Code(5U) != 0; }, 100U);
    EXPECT_LE(took_ms, 11U);
    EXPECT_EQ(Code(5U), 40);
    Run(100U);
    EXPECT_EQ(told[5], (Log{"8", "23", "0", "40", "8", "23", "0"}));
    // With an event time one is tolerated
    tx[5][0].event_ms = 20U;
    slaves[5]->pdos[0].skip = 1;
    Run(100U);
    EXPECT_EQ(Code(5U), 0);
    slaves[5]->pdos[0].skip = 2;
    Run(100U);
    EXPECT_EQ(told[5], (Log{"8", "23", "0", "40", "8", "23", "0", "22", "8", "23", "0"}));
    EXPECT_EQ(el.Cause(NodeId{5U}), 22);
}

TEST_F(El6751ReactionTest, AnAsynchronousPdoThatIsMissingIsNodeState22)
{
    Verifies(req::SRS_ELM_037);
    AddBox(5U);
    Tx(5U, MakePdo(1U, 0x185U, 255U, 4U, 0U, 50U));
    slaves[5]->pdos.push_back(SentPdo{0x185U, 4U, 0U, 5000U, 50000U, 0, 0U, 0U});
    Begin();
    Run(500U);
    EXPECT_EQ(told[5], (Log{"8", "23", "0"}));
    slaves[5]->pdos[0].skip = 1;
    Run(200U);
    EXPECT_EQ(Code(5U), 0);
    slaves[5]->pdos[0].skip = 2;
    Run(250U);
    EXPECT_EQ(told[5], (Log{"8", "23", "0", "22", "8", "23", "0"}));
}

TEST_F(El6751ReactionTest, TheOneEventTimeOfABusCouplerSupervisesItsPdos)
{
    Verifies(req::SRS_ELM_017);
    Verifies(req::SRS_ELM_037);
    AddBox(5U);
    slaves[5]->Set(0x5500U, 0U, 0U);
    boxes[5].kind = El6751Kind::kBusCoupler;
    boxes[5].coupler_event_ms = 50U;
    Tx(5U, MakePdo(1U, 0x185U, 255U, 4U, 0U, 0U));
    slaves[5]->pdos.push_back(SentPdo{0x185U, 4U, 0U, 5000U, 50000U, 0, 0U, 0U});
    Begin();
    Run(500U);
    EXPECT_EQ(told[5], (Log{"8", "23", "0"}));
    slaves[5]->pdos[0].skip = 2;
    Run(250U);
    EXPECT_EQ(told[5], (Log{"8", "23", "0", "22", "8", "23", "0"}));
}

TEST_F(El6751ReactionTest, WithoutAReactionTheNodeStateComesAndGoesWithItsCause)
{
    Verifies(req::SRS_ELM_043);
    Ready();
    boxes[5].node_reaction = El6751NodeReaction::kNone;
    slaves[5]->Turn(127U);
    Run(150U);
    EXPECT_EQ(Code(5U), 12);
    slaves[5]->Turn(5U);
    Run(150U);
    EXPECT_EQ(Code(5U), 0);
    slaves[5]->heartbeat_us = 0U;
    Run(350U);
    EXPECT_EQ(Code(5U), 1);
    slaves[5]->Beat();
    Run(1U);
    EXPECT_EQ(told[5], (Log{"12", "0", "1", "0"}));
    EXPECT_TRUE(Commands().empty());
    EXPECT_EQ(el.Cause(NodeId{5U}), 1);
}

TEST_F(El6751ReactionTest, AStartByHandOfALostSlaveThatIsNotThereIsLostAgain)
{
    Verifies(req::SRS_ELM_039);
    // Given two slaves without reaction, one of them with the heartbeat that the network's list says
    AddBox(7U);
    setups[7].heartbeat = HeartbeatSetup{300U, 100U, Arming::kFirstHeartbeat};
    User(7U, 0x1017U, 0U, {100U, 0U});
    Ready();
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{7U}})
    {
        boxes[node].node_reaction = El6751NodeReaction::kNone;
        slaves[node]->is_on = false;
    }
    Run(400U);
    // When they are started all the same
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{7U}})
    {
        ASSERT_EQ(Code(node), 1);
        EXPECT_EQ(Do([&] { return el.Command(NmtCommand::kStart, NodeId{node}, Now()); }), NmtAnswer::kTaken);
        EXPECT_EQ(Code(node), 0);
    }
    // Then the time begins with the start: 100 ms x 3, and the consumer time
    Run(298U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(Code(7U), 0);
    Run(4U);
    EXPECT_EQ(Code(5U), 1);
    EXPECT_EQ(Code(7U), 1);
}

TEST_F(El6751ReactionTest, WithoutAReactionASlaveThatLeftOperationalIsStartedByHand)
{
    Verifies(req::SRS_ELM_043);
    Verifies(req::SRS_ELM_046);
    Ready();
    boxes[5].node_reaction = El6751NodeReaction::kNone;
    slaves[5]->Turn(127U);
    Run(150U);
    EXPECT_EQ(Code(5U), 12);
    EXPECT_EQ(Control(5U, 5U, 1U), NmtAnswer::kTaken);
    Run(150U);
    EXPECT_EQ(Commands(), (Log{"01 05"}));
    EXPECT_EQ(slaves[5]->state, 5U);
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(El6751ReactionTest, RestartByHandDeactivatesTheSlaveAndKeepsTheCause)
{
    Verifies(req::SRS_ELM_043);
    Verifies(req::SRS_ELM_002);
    Ready();
    boxes[5].restart = El6751Restart::kByHand;
    slaves[5]->Turn(127U);
    told[5].clear();
    Run(150U);
    EXPECT_EQ(told[5], (Log{"12", "1"}));
    EXPECT_EQ(el.Cause(NodeId{5U}), 12);
    EXPECT_EQ(Commands(), (Log{"02 05"}));
    // Not even its boot-up message brings it back
    slaves[5]->Power(Now().us);
    Run(5000U);
    EXPECT_EQ(Code(5U), 1);
    EXPECT_EQ(Commands(), (Log{"02 05"}));
    // A start by hand, though without reset, includes the start-up that it lost
    EXPECT_EQ(Control(5U, 5U, 3U), NmtAnswer::kTaken);
    Run(50U);
    EXPECT_EQ(Commands(), (Log{"02 05", "82 05", "01 05"}));
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(El6751ReactionTest, ARestartOfARunningSlaveIsAnErrorIfOnlyAHandMayRestartIt)
{
    Verifies(req::SRS_ELM_002);
    Verifies(req::SRS_ELM_043);
    Ready();
    boxes[5].restart = El6751Restart::kByHand;
    slaves[5]->Power(Now().us);
    Run(50U);
    EXPECT_EQ(Code(5U), 1);
    EXPECT_EQ(el.Cause(NodeId{5U}), 12);
    EXPECT_EQ(Commands(), (Log{"02 05"}));
    // The hand's start begins with the start-up that it lost
    slaves[5]->log.clear();
    EXPECT_EQ(Control(5U, 5U, 1U), NmtAnswer::kTaken);
    Run(50U);
    EXPECT_EQ(Sdos(5U), (Log{"r 1000:00", "w 1017:00 64 00", "w 1016:01 2C 01 7F 00"}));
    EXPECT_EQ(Code(5U), 0);
}

/// Slave 5 with heartbeat 100 ms x 3, slave 6 without anything, slave 7 not started automatically.
class El6751NetworkTest : public El6751Rig
{
  public:
    void Ready()
    {
        AddBox(5U);
        AddBox(6U);
        AddBox(7U);
        boxes[5].guard_time_ms = 100U;
        boxes[5].life_time_factor = 3U;
        boxes[5].network_reaction = El6751NetworkReaction::kStopAll;
        boxes[7].is_started = false;
        Begin();
        Run(500U);
        ASSERT_EQ(slaves[5]->state, 5U);
        told.clear();
        sent.clear();
    }
};

TEST_F(El6751NetworkTest, TheNetworkReactionStopsAllOtherStartedSlaves)
{
    Verifies(req::SRS_ELM_043);
    Ready();
    slaves[5]->Turn(4U);
    Run(150U);
    EXPECT_EQ(Commands()[0], "02 06");
    EXPECT_EQ(Commands()[1], "02 05");
    EXPECT_EQ(Commands()[2], "82 05");
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(Code(6U), 1);
    EXPECT_EQ(slaves[6]->state, 4U);
    EXPECT_EQ(Code(7U), 12);
    EXPECT_EQ(slaves[7]->state, 127U);
    EXPECT_EQ(Control(6U, 5U, 1U), NmtAnswer::kTaken);
    Run(50U);
    EXPECT_EQ(Code(6U), 0);
}

TEST_F(El6751NetworkTest, ADeactivatedSlaveThatRestartedIsConfiguredBeforeItsStartOnEveryWay)
{
    Verifies(req::SRS_ELM_046);
    // Given a slave that only a hand restarts, deactivated, and restarted by itself meanwhile
    Ready();
    boxes[5].network_reaction = El6751NetworkReaction::kNone;
    boxes[5].restart = El6751Restart::kByHand;
    slaves[5]->Turn(127U);
    Run(150U);
    ASSERT_EQ(Code(5U), 1);
    slaves[5]->Power(Now().us);
    Run(50U);
    // When it is made PRE-OPERATIONAL first and then started
    EXPECT_EQ(Control(5U, 5U, 2U), NmtAnswer::kTaken);
    Run(50U);
    EXPECT_EQ(Code(5U), 12);
    slaves[5]->log.clear();
    EXPECT_EQ(Control(5U, 5U, 1U), NmtAnswer::kTaken);
    Run(50U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(Sdos(5U), (Log{"r 1000:00", "w 1017:00 64 00", "w 1016:01 2C 01 7F 00"}));
}

TEST_F(El6751NetworkTest, ASlaveThatWasHeldInTheMiddleOfItsSdosGetsThemAllBeforeItsStart)
{
    Verifies(req::SRS_ELM_047);
    AddBox(5U);
    boxes[5].guard_time_ms = 100U;
    boxes[5].life_time_factor = 3U;
    for (const NmtCommand hold : {NmtCommand::kStop, NmtCommand::kPreOperational})
    {
        Begin();
        RunUntil([this] { return Sdos(5U).size() >= 2U; }, 50U);
        ASSERT_EQ(Code(5U), 8);
        EXPECT_EQ(Do([&] { return el.Command(hold, NodeId{5U}, Now()); }), NmtAnswer::kTaken);
        Run(50U);
        slaves[5]->log.clear();
        sent.clear();
        EXPECT_EQ(Do([&] { return el.Command(NmtCommand::kStart, NodeId{5U}, Now()); }), NmtAnswer::kTaken);
        Run(50U);
        EXPECT_EQ(Code(5U), 0);
        EXPECT_EQ(Sdos(5U), (Log{"r 1000:00", "w 1017:00 64 00", "w 1016:01 2C 01 7F 00"}));
        // STOPPED, it has no SDO
        EXPECT_EQ(Commands().front(), (hold == NmtCommand::kStop) ? "82 05" : "01 05");
        slaves[5]->log.clear();
        sent.clear();
    }
}

TEST_F(El6751NetworkTest, TheNetworkReactionDoesNotNeedOneOfTheNode)
{
    Verifies(req::SRS_ELM_043);
    Ready();
    boxes[5].node_reaction = El6751NodeReaction::kNone;
    // When it turns PRE-OPERATIONAL, the others are stopped once, and it is not
    slaves[5]->Turn(127U);
    Run(150U);
    EXPECT_EQ(Code(5U), 12);
    EXPECT_EQ(Code(6U), 1);
    EXPECT_EQ(Commands(), (Log{"02 06"}));
    EXPECT_EQ(Control(6U, 5U, 1U), NmtAnswer::kTaken);
    Run(300U);
    EXPECT_EQ(Code(6U), 0);
    EXPECT_EQ(Commands(), (Log{"02 06", "82 06", "01 06"}));
    // and when it is lost again
    slaves[5]->is_on = false;
    Run(400U);
    EXPECT_EQ(Code(5U), 1);
    EXPECT_EQ(Commands(), (Log{"02 06", "82 06", "01 06", "02 06"}));
}

} // namespace
} // namespace counterpoint::cia302
