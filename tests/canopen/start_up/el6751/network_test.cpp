// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What an error of one slave means for the others.
#include "tests/canopen/start_up/el6751/rig.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

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
