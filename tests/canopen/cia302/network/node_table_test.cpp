// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia302/network/node_table_rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"

namespace counterpoint::cia302
{
namespace
{

TEST_F(NodeTableTest, StatesAreKeptAndChangesTold)
{
    Verifies(req::SRS_NMM_020);
    EXPECT_EQ(State(), SlaveState::kUnknown);
    Hear(0U);
    Hear(127U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kBootUp}));
    EXPECT_EQ(State(), SlaveState::kPreOperational);
    Hear(5U);
    Hear(5U);
    Hear(4U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kChanged, NodeEvent::kChanged}));
    EXPECT_EQ(State(), SlaveState::kStopped);
    Hear(3U); // No state.
    EXPECT_EQ(State(), SlaveState::kStopped);
    Sent(NmtCommand::kStart, 0U);
    EXPECT_EQ(State(), SlaveState::kStopped);
    Sent(NmtCommand::kResetNode, 5U);
    EXPECT_EQ(State(), SlaveState::kUnknown);
    Sent(NmtCommand::kResetCommunication, 6U);
    Hear(127U);
    EXPECT_EQ(State(), SlaveState::kPreOperational);
}

TEST_F(NodeTableTest, ValueOfTheRequestObject)
{
    Verifies(req::SRS_NMM_007);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 0U);
    Sent(NmtCommand::kStart, 5U);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 5U); // Nothing supervises: what was asked for.
    Sent(NmtCommand::kStop, 0U);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 4U);
    Sent(NmtCommand::kPreOperational, 5U);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 127U);
    table.WatchHeartbeat(NodeId{5U}, 100U, Arming::kFirstHeartbeat, Now());
    Hear(5U);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 5U); // What was heard.
    At(101U);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 1U);
    EXPECT_EQ(table.RequestValue(NodeId{0U}), 0U);
    EXPECT_EQ(table.RequestValue(NodeId{128U}), 0U);
}

TEST_F(NodeTableTest, ForeignFramesAreNoSigns)
{
    Verifies(req::SRS_NMM_020);
    CanFrame frame{0x705U, FrameKind::kRemote, CanPortId::kFirst, 1U, {5U}};
    table.OnFrame(frame, Now());
    frame = CanFrame{0x705U, FrameKind::kData, CanPortId::kFirst, 2U, {5U, 5U}};
    table.OnFrame(frame, Now());
    frame = CanFrame{0x685U, FrameKind::kData, CanPortId::kFirst, 1U, {5U}};
    table.OnFrame(frame, Now());
    frame = CanFrame{0x700U, FrameKind::kData, CanPortId::kFirst, 1U, {5U}};
    table.OnFrame(frame, Now());
    frame = CanFrame{0x77FU, FrameKind::kData, CanPortId::kFirst, 1U, {5U}}; // The own node.
    table.OnFrame(frame, Now());
    EXPECT_EQ(Told(), (Events{}));
    EXPECT_EQ(State(), SlaveState::kUnknown);
}

TEST_F(NodeTableTest, HeartbeatOneCycleTooLateIsALoss)
{
    Verifies(req::SRS_NMM_021);
    table.WatchHeartbeat(NodeId{5U}, 100U, Arming::kFirstHeartbeat, Now());
    At(500U);
    EXPECT_EQ(Told(), (Events{})); // Never seen, and not armed.
    Hear(5U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kStarted}));
    At(600U); // On the limit
    Hear(5U);
    At(700U);
    EXPECT_EQ(Told(), (Events{}));
    At(701U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kHeartbeatLost}));
    EXPECT_EQ(State(), SlaveState::kMissing);
    At(2000U);
    EXPECT_EQ(Told(), (Events{})); // Told once.
    Hear(5U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kStarted}));
    // A boot-up message directly before a heartbeat is told
    Hear(0U);
    Hear(127U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kBootUp, NodeEvent::kStarted}));
    table.Unwatch(NodeId{5U});
    At(5000U);
    EXPECT_EQ(Told(), (Events{}));
}

TEST_F(NodeTableTest, ArmingAtTheBootUpMessage)
{
    Verifies(req::SRS_NMM_022);
    table.WatchHeartbeat(NodeId{5U}, 100U, Arming::kBootUp, Now());
    At(300U);
    EXPECT_EQ(Told(), (Events{}));
    Hear(0U);
    At(400U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kBootUp}));
    At(401U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kHeartbeatLost}));
    // Supervision that is asked for behind that message begins at once, but not behind a reset
    table.WatchHeartbeat(NodeId{5U}, 100U, Arming::kBootUp, Now());
    At(502U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kHeartbeatLost}));
    Sent(NmtCommand::kResetNode, 5U);
    table.WatchHeartbeat(NodeId{5U}, 100U, Arming::kBootUp, Now());
    At(900U);
    EXPECT_EQ(Told(), (Events{}));
}

TEST_F(NodeTableTest, ArmingAtTheFirstHeartbeatAndTheBootUpMessageIsNone)
{
    Verifies(req::SRS_NMM_022);
    table.WatchHeartbeat(NodeId{5U}, 100U, Arming::kFirstHeartbeat, Now());
    Hear(0U);
    At(1000U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kBootUp}));
}

TEST_F(NodeTableTest, ArmingAtOnce)
{
    Verifies(req::SRS_NMM_022);
    table.WatchHeartbeat(NodeId{5U}, 100U, Arming::kImmediately, Now());
    At(100U);
    EXPECT_EQ(Told(), (Events{}));
    At(101U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kHeartbeatLost}));
}

TEST_F(NodeTableTest, AfterAResetTheNodeGetsTime)
{
    Verifies(req::SRS_NMM_026);
    table.WatchHeartbeat(NodeId{5U}, 100U, Arming::kFirstHeartbeat, Now());
    Hear(127U);
    Sent(NmtCommand::kResetNode, 5U);
    At(900U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kStarted}));
    // With supervision at once it gets the consumer time
    table.WatchHeartbeat(NodeId{5U}, 100U, Arming::kImmediately, Now());
    At(950U);
    Sent(NmtCommand::kResetCommunication, 0U);
    At(1050U);
    EXPECT_EQ(Told(), (Events{}));
    At(1051U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kHeartbeatLost}));
    // Guarding rests until the boot-up message
    table.WatchGuarding(NodeId{5U}, 100U, 3U, Now());
    Sent(NmtCommand::kResetNode, 5U);
    At(9000U);
    EXPECT_EQ(Told(), (Events{}));
    EXPECT_TRUE(sink.frames.empty());
    Hear(0U);
    At(9100U);
    EXPECT_EQ(sink.frames.size(), 1U);
}

TEST_F(NodeTableTest, GuardingCountsUpToTheRetryFactor)
{
    Verifies(req::SRS_NMM_023);
    // Given remote frames in the first cycle, at 100, 200, ... ms and a factor of 3
    table.WatchGuarding(NodeId{5U}, 100U, 3U, Now());
    At(1U);
    ASSERT_EQ(sink.frames.size(), 1U);
    EXPECT_EQ(sink.frames[0].identifier, 0x705U);
    EXPECT_EQ(sink.frames[0].kind, FrameKind::kRemote);
    Hear(0x7FU);
    EXPECT_EQ(Told(), (Events{NodeEvent::kStarted}));
    At(100U);
    Hear(0xFFU);
    // When three in a row stay without answer
    At(299U);
    EXPECT_EQ(Told(), (Events{}));
    At(300U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kGuardMissed}));
    At(399U);
    Hear(0x7FU); // Answered just in time: counted from the beginning.
    EXPECT_EQ(records[5].missed, 0U);
    At(600U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kGuardMissed, NodeEvent::kGuardMissed}));
    At(700U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kGuardLost}));
    EXPECT_EQ(State(), SlaveState::kMissing);
    // Then remote frames go on, told no more, until one is answered
    const std::size_t before = sink.frames.size();
    At(1100U);
    EXPECT_EQ(sink.frames.size(), before + 4U);
    EXPECT_EQ(Told(), (Events{}));
    Hear(0xFFU);
    EXPECT_EQ(Told(), (Events{NodeEvent::kStarted}));
    EXPECT_EQ(State(), SlaveState::kPreOperational);
}

TEST_F(NodeTableTest, ABootUpMessageForgetsMissedAnswers)
{
    Verifies(req::SRS_NMM_023);
    table.WatchGuarding(NodeId{5U}, 100U, 3U, Now());
    At(250U);
    Hear(0U);
    At(600U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kGuardMissed, NodeEvent::kGuardMissed, NodeEvent::kBootUp,
                              NodeEvent::kGuardMissed, NodeEvent::kGuardMissed}));
    At(650U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kGuardLost}));
}

TEST_F(NodeTableTest, RemoteFrameWaitsForRoomAndZeroTimesAreOff)
{
    Verifies(req::SRS_NMM_023);
    sink.room = 0;
    table.WatchGuarding(NodeId{5U}, 100U, 1U, Now());
    At(500U);
    EXPECT_EQ(Told(), (Events{}));
    sink.room = 10;
    At(501U);
    EXPECT_EQ(sink.frames.size(), 1U);
    Hear(0x7FU);
    table.WatchGuarding(NodeId{5U}, 0U, 3U, Now());
    At(5000U);
    table.WatchGuarding(NodeId{5U}, 100U, 0U, Now());
    At(9000U);
    EXPECT_EQ(sink.frames.size(), 1U);
}

TEST_F(NodeTableTest, ToggleThatStandsStillIsToldOnceAndIsNoAnswer)
{
    Verifies(req::SRS_NMM_024);
    Hear(0U);
    static_cast<void>(Told());
    table.WatchGuarding(NodeId{5U}, 100U, 2U, Now());
    At(1U);
    Hear(0x7FU); // 0 after a boot-up message
    At(101U);
    Hear(0x7FU); // Again 0
    EXPECT_EQ(Told(), (Events{NodeEvent::kStarted, NodeEvent::kToggleError}));
    At(201U);
    Hear(0x7FU);
    EXPECT_EQ(Told(), (Events{NodeEvent::kGuardMissed}));
    At(301U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kGuardLost}));
    // A loss does not make 0 expected: the bit goes on from what was heard last
    Hear(0xFFU);
    EXPECT_EQ(Told(), (Events{NodeEvent::kStarted}));
    At(401U);
    Hear(0x7FU);
    EXPECT_EQ(Told(), (Events{}));
}

TEST_F(NodeTableTest, FirstAnswerOfANodeThatWasNotResetMayHaveAnyToggle)
{
    Verifies(req::SRS_NMM_024);
    table.WatchGuarding(NodeId{5U}, 100U, 2U, Now());
    At(1U);
    Hear(0x85U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kStarted}));
    EXPECT_EQ(State(), SlaveState::kOperational);
    At(101U);
    Hear(0x05U);
    EXPECT_EQ(Told(), (Events{}));
    // After a boot-up message it must be 0
    Hear(0U);
    At(201U);
    Hear(0x85U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kBootUp, NodeEvent::kToggleError}));
}

TEST_F(NodeTableTest, NodeThatNeverShowsItself)
{
    Verifies(req::SRS_NMM_025);
    table.Expect(NodeId{5U}, 200U, Now());
    At(200U);
    EXPECT_EQ(Told(), (Events{}));
    At(201U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kNeverSeen}));
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 1U);
    At(900U);
    EXPECT_EQ(Told(), (Events{}));
    table.Expect(NodeId{5U}, 200U, Now());
    Hear(0U);
    At(2000U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kBootUp}));
}

TEST_F(NodeTableTest, NodeThatAnswersHasShownItself)
{
    Verifies(req::SRS_NMM_025);
    // Given one that sends neither boot-up message nor heartbeat
    table.Expect(NodeId{5U}, 200U, Now());
    Answer(8U);
    At(900U);
    EXPECT_EQ(Told(), (Events{}));
    EXPECT_EQ(records[5].state, SlaveState::kUnknown);
    // When what it sends is no answer, or of another node
    table.Expect(NodeId{5U}, 200U, Now());
    Answer(7U);
    table.OnFrame(CanFrame{0x586U, FrameKind::kData, CanPortId::kFirst, 8U, {}}, Now());
    table.OnFrame(CanFrame{0x585U, FrameKind::kRemote, CanPortId::kFirst, 8U, {}}, Now());
    table.OnFrame(CanFrame{0x580U, FrameKind::kData, CanPortId::kFirst, 8U, {}}, Now());
    At(2000U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kNeverSeen}));
}

TEST_F(NodeTableTest, AnAnswerEndsMissingUnlessSupervisionSaysSo)
{
    Verifies(req::SRS_NMM_020);
    table.SetMissing(NodeId{5U});
    Answer(8U);
    EXPECT_EQ(records[5].state, SlaveState::kUnknown);
    table.SetMissing(NodeId{5U});
    // When it was started, and is not supervised
    Answer(8U);
    Sent(NmtCommand::kStart, 5U);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 5U);
    // When its heartbeat is lost
    table.WatchHeartbeat(NodeId{5U}, 100U, Arming::kImmediately, Now());
    At(101U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kHeartbeatLost}));
    Answer(8U);
    EXPECT_EQ(records[5].state, SlaveState::kMissing);
    EXPECT_EQ(Told(), (Events{}));
}

TEST_F(NodeTableTest, AStartOfSomebodyElseOutlastsBootUpMessageAndSilence)
{
    Verifies(req::SRS_SFS_150);
    Sent(NmtCommand::kResetCommunication, 0U);
    table.KeepStarted(NodeId{5U});
    Foreign(NmtCommand::kStart, 5U);
    // When its boot-up message comes behind the start, or it answers an SDO at last
    Hear(0U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kBootUp, NodeEvent::kChanged}));
    EXPECT_TRUE(table.RunsSurely(NodeId{5U}));
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 5U);
    table.SetMissing(NodeId{5U});
    EXPECT_FALSE(table.RunsSurely(NodeId{5U}));
    Answer(8U);
    EXPECT_TRUE(table.RunsSurely(NodeId{5U}));
    // When it tells its state itself
    Hear(127U);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 5U); // Unwatched: what was asked for last.
    EXPECT_FALSE(table.RunsSurely(NodeId{5U}));
    Hear(0U);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 127U);
    EXPECT_FALSE(table.RunsSurely(NodeId{5U}));
}

TEST_F(NodeTableTest, ALaterCommandEndsTheStartOfSomebodyElse)
{
    Verifies(req::SRS_SFS_150);
    const auto is_kept = [this](const auto& command)
    {
        table.KeepStarted(NodeId{5U});
        command();
        Hear(0U);
        return table.RunsSurely(NodeId{5U});
    };
    EXPECT_TRUE(is_kept([this] { Foreign(NmtCommand::kStart, 0U); }));
    EXPECT_TRUE(is_kept([this] { Foreign(NmtCommand::kStop, 6U); }));
    EXPECT_TRUE(is_kept([this] { Sent(NmtCommand::kStop, 6U); }));
    EXPECT_FALSE(is_kept([this] { Foreign(NmtCommand::kStop, 5U); }));
    EXPECT_FALSE(is_kept([this] { Foreign(NmtCommand::kResetNode, 0U); }));
    EXPECT_FALSE(is_kept([this] { Sent(NmtCommand::kPreOperational, 5U); }));
    EXPECT_FALSE(is_kept([this] { Sent(NmtCommand::kStart, 5U); }));
}

TEST_F(NodeTableTest, NodeThatNobodyListed)
{
    Verifies(req::SRS_NMM_025);
    watched = 6U;
    Hear(5U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kUnexpected, NodeEvent::kChanged}));
    Hear(5U);
    Hear(0U);
    EXPECT_EQ(Told(), (Events{NodeEvent::kBootUp}));
}

TEST_F(NodeTableTest, SupervisionAsSetUpPrefersHeartbeat)
{
    Verifies(req::SRS_BOOT_011);
    slaves[5].assignment = kInNetwork | (3U << 8U) | (100U << 16U);
    table.WatchAsSetUp(NodeId{5U}, Now());
    EXPECT_EQ(records[5].watch, Watch::kGuarding);
    EXPECT_EQ(records[5].time_us, 100000U);
    EXPECT_EQ(records[5].retry_factor, 3U);
    slaves[5].heartbeat = HeartbeatSetup{250U, 100U, Arming::kBootUp};
    table.WatchAsSetUp(NodeId{5U}, Now());
    EXPECT_EQ(records[5].watch, Watch::kHeartbeat);
    EXPECT_EQ(records[5].time_us, 250000U);
    // With one of both times of 1F81h alone there is no guarding
    slaves[5].heartbeat = HeartbeatSetup{};
    for (const std::uint32_t times : {std::uint32_t{3U} << 8U, std::uint32_t{100U} << 16U})
    {
        slaves[5].assignment = kInNetwork | times;
        table.WatchAsSetUp(NodeId{5U}, Now());
        EXPECT_EQ(records[5].watch, Watch::kNone) << times;
    }
    slaves[5] = SlaveSetup{};
    table.WatchAsSetUp(NodeId{5U}, Now());
    EXPECT_EQ(records[5].watch, Watch::kNone);
}

TEST_F(NodeTableTest, NodesThatDoNotExistAreLeftAlone)
{
    Verifies(req::SRS_NMM_020);
    for (const std::uint8_t node : {std::uint8_t{0U}, std::uint8_t{128U}, std::uint8_t{255U}})
    {
        table.WatchHeartbeat(NodeId{node}, 1U, Arming::kImmediately, Now());
        table.WatchGuarding(NodeId{node}, 1U, 1U, Now());
        table.Expect(NodeId{node}, 1U, Now());
        table.SetMissing(NodeId{node});
        EXPECT_FALSE(table.AskState(NodeId{node}));
        EXPECT_EQ(table.Record(NodeId{node}).state, SlaveState::kUnknown);
    }
    At(100U);
    EXPECT_EQ(Told(), (Events{}));
}

} // namespace
} // namespace counterpoint::cia302
