// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia302/network/node_table_rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"

namespace counterpoint::cia302
{
namespace
{

TEST_F(NodeTableTest, OneQuestionForTheState)
{
    Verifies(req::SRS_NMM_020);
    EXPECT_FALSE(table.AskState(NodeId{0U}));
    sink.room = 0;
    EXPECT_FALSE(table.AskState(NodeId{5U}));
    sink.room = 1;
    EXPECT_TRUE(table.AskState(NodeId{5U}));
    ASSERT_EQ(sink.frames.size(), 1U);
    EXPECT_EQ(sink.frames[0].identifier, 0x705U);
    EXPECT_EQ(sink.frames[0].kind, FrameKind::kRemote);
    Hear(0x85U); // Whatever its toggle bit.
    EXPECT_EQ(State(), SlaveState::kOperational);
    EXPECT_EQ(Told(), (std::vector<NodeEvent>{NodeEvent::kChanged}));
}

TEST_F(NodeTableTest, PreOperationalBehindLostFramesIsABootUp)
{
    Verifies(req::SRS_NMM_020);
    table.Miss(NodeId{0U});
    // Its last command was no start, or its sign says something else
    table.Miss(NodeId{5U});
    Hear(0x7FU);
    EXPECT_EQ(Told(), (std::vector<NodeEvent>{NodeEvent::kChanged}));
    Sent(NmtCommand::kStart, 5U);
    table.Miss(NodeId{5U});
    Hear(5U);
    EXPECT_EQ(Told(), (std::vector<NodeEvent>{NodeEvent::kChanged}));
    // The first sign counts, not the second one
    Hear(0x7FU);
    EXPECT_EQ(Told(), (std::vector<NodeEvent>{NodeEvent::kChanged}));
    EXPECT_FALSE(table.Record(NodeId{5U}).has_booted);
    Hear(5U);
    table.Miss(NodeId{5U});
    Hear(0x7FU);
    EXPECT_EQ(Told(), (std::vector<NodeEvent>{NodeEvent::kChanged, NodeEvent::kBootUp}));
    EXPECT_TRUE(table.Record(NodeId{5U}).has_booted);
    EXPECT_EQ(table.Record(NodeId{5U}).asked, SlaveState::kUnknown);
}

TEST_F(NodeTableTest, TwoSignsBehindAStartDenyIt)
{
    Verifies(req::SRS_NMM_521);
    // Behind no command at all, or its boot-up message, nothing is denied
    Hear(0x7FU);
    Hear(0x7FU);
    EXPECT_FALSE(DeniesStart(table, NodeId{5U}));
    EXPECT_FALSE(DeniesStart(table, NodeId{0U}));
    // One sign may have been under way, two were not, and three are no more
    Sent(NmtCommand::kStart, 5U);
    Hear(0x7FU);
    EXPECT_FALSE(DeniesStart(table, NodeId{5U}));
    Hear(4U);
    EXPECT_TRUE(DeniesStart(table, NodeId{5U}));
    Hear(4U);
    EXPECT_TRUE(DeniesStart(table, NodeId{5U}));
    // Until it says that it runs
    Hear(5U);
    EXPECT_FALSE(DeniesStart(table, NodeId{5U}));
    Hear(0x7FU);
    EXPECT_FALSE(DeniesStart(table, NodeId{5U}));
    // A further command counts from the beginning, whoever sent it; one for another node does not
    Foreign(NmtCommand::kStart, 5U);
    Hear(0x7FU);
    EXPECT_FALSE(DeniesStart(table, NodeId{5U}));
    Foreign(NmtCommand::kStart, 6U);
    Hear(0x7FU);
    EXPECT_TRUE(DeniesStart(table, NodeId{5U}));
    // Who denies a stop denies no start
    Foreign(NmtCommand::kStop, 0U);
    Hear(0x7FU);
    Hear(0x7FU);
    EXPECT_FALSE(DeniesStart(table, NodeId{5U}));
    // Nor does who has booted since
    Sent(NmtCommand::kStart, 5U);
    Hear(0x7FU);
    Hear(0x7FU);
    EXPECT_TRUE(DeniesStart(table, NodeId{5U}));
    Hear(0U);
    EXPECT_FALSE(DeniesStart(table, NodeId{5U}));
}

TEST_F(NodeTableTest, FramesBesideErrorControlAndSdoSayNothing)
{
    Verifies(req::SRS_NMM_020);
    const CanFrame frames[] = {{0x780U, FrameKind::kData, CanPortId::kFirst, 1U, {5U}},
                               {0x700U, FrameKind::kData, CanPortId::kFirst, 1U, {5U}},
                               {0x600U, FrameKind::kData, CanPortId::kFirst, 8U, {5U}},
                               {0x580U, FrameKind::kData, CanPortId::kFirst, 8U, {5U}},
                               {0x000U, FrameKind::kData, CanPortId::kFirst, 1U, {1U}},
                               {0x000U, FrameKind::kRemote, CanPortId::kFirst, 2U, {1U, 5U}}};
    for (const CanFrame& frame : frames)
    {
        table.OnFrame(frame, Now());
    }
    Foreign(static_cast<NmtCommand>(3U), 5U); // No command.
    EXPECT_EQ(Told(), std::vector<NodeEvent>{});
    EXPECT_FALSE(table.Record(NodeId{5U}).was_seen);
    EXPECT_EQ(table.Record(NodeId{5U}).asked, SlaveState::kUnknown);
}

TEST_F(NodeTableTest, WhoIsPresumedIsWhatItWasToldUntilItSpeaks)
{
    Verifies(req::SRS_SFS_150);
    table.Presume(NodeId{0U}, Now());
    table.KeepStarted(NodeId{0U});
    table.Presume(NodeId{5U}, Now());
    EXPECT_EQ(State(), SlaveState::kOperational);
    EXPECT_TRUE(table.RunsSurely(NodeId{5U}));
    Sent(NmtCommand::kStop, 5U);
    EXPECT_EQ(State(), SlaveState::kStopped);
    Sent(NmtCommand::kPreOperational, 5U);
    EXPECT_EQ(State(), SlaveState::kPreOperational);
    Hear(5U);
    Sent(NmtCommand::kStop, 5U);
    EXPECT_EQ(State(), SlaveState::kOperational); // It has spoken.
    // That its start was dropped says nothing of it
    table.OnStartDropped(NodeId{5U}, Now());
    EXPECT_EQ(State(), SlaveState::kOperational);
    // One that is missing stays missing
    table.SetMissing(NodeId{5U});
    static_cast<void>(Told());
    table.Presume(NodeId{5U}, Now());
    EXPECT_EQ(State(), SlaveState::kMissing);
    EXPECT_EQ(Told(), std::vector<NodeEvent>{});
}

TEST_F(NodeTableTest, WhoWasToldToLeaveHasLeftUntilASecondSignSaysOtherwise)
{
    Verifies(req::SRS_SFS_150);
    const NodeId node{5U};
    EXPECT_FALSE(HasLeft(table, node));
    Hear(5U);
    EXPECT_TRUE(table.IsFoundRunning(node)); // Nobody told it otherwise.
    for (const NmtCommand command : {NmtCommand::kStop, NmtCommand::kPreOperational})
    {
        Sent(command, 5U);
        EXPECT_TRUE(HasLeft(table, node));
        EXPECT_EQ(IsStopped(table, node), command == NmtCommand::kStop);
        EXPECT_FALSE(table.IsFoundRunning(node));
        Hear(5U); // May have been under way.
        EXPECT_TRUE(HasLeft(table, node));
        EXPECT_FALSE(table.IsFoundRunning(node));
        Hear(5U);
        EXPECT_FALSE(HasLeft(table, node));
        EXPECT_FALSE(IsStopped(table, node));
        EXPECT_TRUE(table.IsFoundRunning(node));
    }
    Hear(4U);
    EXPECT_TRUE(IsStopped(table, node)); // It says so.
    EXPECT_FALSE(table.IsFoundRunning(node));
}

TEST_F(NodeTableTest, LossesOfOneThatDoesNotToggleAreCountedUpToThree)
{
    Verifies(req::SRS_NMM_024);
    table.WatchGuarding(NodeId{5U}, 10U, 1U, Now());
    // Given a node that answers each remote frame with the same toggle bit, and boots up behind each loss
    for (int loss = 1; loss <= 5; ++loss)
    {
        for (int step = 0; step < 4; ++step)
        {
            At(ms + 10U);
            Hear(0x05U);
        }
        EXPECT_EQ(table.Record(NodeId{5U}).untoggled, (loss < 3) ? loss : 3) << loss;
        Hear(0x00U);
    }
    // It begins anew with the supervision
    table.WatchGuarding(NodeId{5U}, 10U, 1U, Now());
    EXPECT_EQ(table.Record(NodeId{5U}).untoggled, 0U);
}

} // namespace
} // namespace counterpoint::cia302
