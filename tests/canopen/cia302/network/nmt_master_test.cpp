// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/network/nmt_master.hpp"
#include "tests/canopen/cia301/keeping_sink.hpp"
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::cia302
{
namespace
{

using cia301::KeepingSink;
using Bytes2 = cia301::Octets;

/// Asks for a stop of node 9 as soon as it hears of a start of node 8.
class Asker final : public NmtListener
{
  public:
    void OnNmtSent(const NmtRequest& request, Instant now) noexcept override
    {
        heard.push_back(request);
        if ((master != nullptr) && (request.node.value == 8U))
        {
            EXPECT_EQ(master->Request(NmtCommand::kStop, NodeId{9U}, now), NmtAnswer::kTaken);
        }
    }

    void OnStartDropped(NodeId node, Instant) noexcept override
    {
        dropped.push_back(node.value);
    }

    std::vector<NmtRequest> heard{};
    std::vector<std::uint8_t> dropped{};
    NmtMaster* master{nullptr};
};

class NmtMasterTest : public ::testing::Test
{
  public:
    NmtMasterTest()
    {
        for (std::uint8_t node = 5U; node <= 9U; ++node)
        {
            slaves[node].assignment = kInNetwork | kBootSlave;
        }
        nmt.SetActive(true);
    }
    [[nodiscard]] NmtAnswer Ask(NmtCommand command, std::uint8_t node)
    {
        return nmt.Request(command, NodeId{node}, Instant{now_us});
    }
    void After(std::uint32_t us)
    {
        now_us += us;
        nmt.OnCycle(Instant{now_us});
    }

    std::uint32_t now_us{0xFFFF'FF00U};
    std::array<SlaveSetup, kNodeRoom> slaves{};
    NetworkSetup setup{NodeId{127U}, kIsMaster, 0U, 0U, 0U, slaves.data()};
    FakeGate gate{setup};
    KeepingSink sink{};
    Asker table{};
    Asker listener{};
    std::array<NmtRequest, 4> room{};
    NmtMaster nmt{NmtMasterParts{setup, NmtQueueRoom{room.data(), 4U}, sink, table, listener, gate}};
};

TEST_F(NmtMasterTest, WhoseStartWaitsIsKnown)
{
    Verifies(req::SRS_BOOT_230);
    // Given 1 ms between two commands: the first one leaves, three wait
    setup.inhibit_100us = 10U;
    EXPECT_EQ(Ask(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kPreOperational, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kStart, 7U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kPreOperational, 7U), NmtAnswer::kTaken);
    EXPECT_FALSE(nmt.HasStart(NodeId{5U}));
    EXPECT_FALSE(nmt.HasStart(NodeId{6U}));
    EXPECT_TRUE(nmt.HasStart(NodeId{7U}));
    EXPECT_TRUE(nmt.IsStarting(NodeId{7U}));
    EXPECT_FALSE(nmt.IsStarting(NodeId{6U}));
    After(1000U);
    After(1000U);
    EXPECT_FALSE(nmt.HasStart(NodeId{7U}));
    // And one of all
    EXPECT_EQ(Ask(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
    EXPECT_TRUE(nmt.IsStarting(NodeId{6U}));
    EXPECT_FALSE(nmt.HasStart(NodeId{6U}));
}

TEST_F(NmtMasterTest, CommandsLeaveInOrderWithTheInhibitTimeBetween)
{
    Verifies(req::SRS_NMM_001);
    setup.inhibit_100us = 20U; // 2 ms
    EXPECT_EQ(Ask(NmtCommand::kResetNode, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kStart, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kPreOperational, 0U), NmtAnswer::kTaken);
    EXPECT_EQ(sink.frames.size(), 1U);
    EXPECT_EQ(sink.Next(), (Bytes2{129U, 5U}));
    EXPECT_EQ(sink.identifier, 0U);
    After(1999U);
    EXPECT_TRUE(sink.frames.empty());
    After(1U);
    EXPECT_EQ(sink.Next(), (Bytes2{1U, 6U}));
    After(1999U);
    EXPECT_EQ(nmt.Waiting(), 1U);
    After(1U);
    EXPECT_EQ(sink.Next(), (Bytes2{128U, 0U}));
    EXPECT_EQ(nmt.Waiting(), 0U);
    ASSERT_EQ(table.heard.size(), 3U);
    EXPECT_EQ(table.heard[1].node.value, 6U);
}

TEST_F(NmtMasterTest, AtTheEndOfTheDeviceAllThatWaitsLeavesAtOnceInOrder)
{
    Verifies(req::SRS_NMM_520);
    setup.inhibit_100us = 20U; // 2 ms
    EXPECT_EQ(Ask(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kPreOperational, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kStart, 7U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kResetNode, 0U), NmtAnswer::kTaken);
    nmt.DropStarts(NodeId{7U});
    // Given one that has left, and three that wait, of which a start was given up
    ASSERT_EQ(nmt.Waiting(), 3U);
    EXPECT_EQ(nmt.WaitingAt(0U).command, NmtCommand::kPreOperational);
    EXPECT_EQ(nmt.WaitingAt(0U).node.value, 6U);
    EXPECT_EQ(nmt.WaitingAt(1U).command, NmtCommand::kInvalid);
    EXPECT_EQ(nmt.WaitingAt(2U).node.value, 0U);
    // When there is no room, then they wait on
    sink.room = 0;
    nmt.Finish(Instant{now_us});
    EXPECT_EQ(nmt.Waiting(), 3U);
    // And with room they leave, though the inhibit time is not over
    sink.room = 8;
    nmt.Finish(Instant{now_us});
    EXPECT_EQ(nmt.Waiting(), 0U);
    ASSERT_EQ(sink.frames.size(), 3U);
    EXPECT_EQ(sink.frames[1].data[0], 0x80U);
    EXPECT_EQ(sink.frames[1].data[1], 6U);
    EXPECT_EQ(sink.frames[2].data[0], 0x81U);
    EXPECT_EQ(sink.frames[2].data[1], 0U);
    // Behind it the inhibit time counts as before
    EXPECT_EQ(Ask(NmtCommand::kStop, 8U), NmtAnswer::kTaken);
    EXPECT_EQ(nmt.Waiting(), 1U);
    After(2000U);
    EXPECT_EQ(nmt.Waiting(), 0U);
}

TEST_F(NmtMasterTest, WithoutInhibitTimeAllLeaveAtOnceAndAFullSinkKeepsThem)
{
    Verifies(req::SRS_NMM_001);
    Verifies(req::SRS_NMM_005);
    sink.room = 1;
    EXPECT_EQ(Ask(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    for (std::uint8_t node = 6U; node <= 9U; ++node)
    {
        EXPECT_EQ(Ask(NmtCommand::kStop, node), NmtAnswer::kTaken);
    }
    EXPECT_EQ(Ask(NmtCommand::kStop, 5U), NmtAnswer::kQueueFull);
    EXPECT_EQ(table.heard.size(), 1U);
    sink.room = 10;
    After(1U);
    EXPECT_EQ(sink.frames.size(), 5U);
    for (const CanFrame& frame : sink.frames)
    {
        EXPECT_EQ(frame.identifier, 0x000U);
        EXPECT_EQ(frame.kind, FrameKind::kData);
        EXPECT_EQ(frame.length_bytes, 2U);
    }
    EXPECT_EQ(sink.frames[0].data[0], 1U); // In the order in which they were asked for,
    EXPECT_EQ(sink.frames[1].data[1], 6U);
    EXPECT_EQ(sink.frames[4].data[1], 9U);
    EXPECT_EQ(Ask(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
}

TEST_F(NmtMasterTest, AStopOfOneNodeGoesBeforeWhatWaitsForOthers)
{
    Verifies(req::SRS_NMM_213);
    using Node = std::pair<NmtCommand, std::uint8_t>;
    const auto stop = NmtCommand::kStop;
    const auto reset = NmtCommand::kResetNode;
    const std::pair<std::vector<Node>, std::vector<Bytes2>> runs[] = {
        {{{reset, 6U}, {reset, 7U}, {stop, 8U}, {stop, 9U}}, {{2U, 8U}, {2U, 9U}, {129U, 6U}, {129U, 7U}}},
        // Not before what waits for the same node, or for all
        {{{reset, 6U}, {reset, 7U}, {stop, 6U}}, {{129U, 6U}, {2U, 6U}, {129U, 7U}}},
        {{{reset, 6U}, {reset, 0U}, {reset, 7U}, {stop, 8U}}, {{129U, 6U}, {129U, 0U}, {2U, 8U}, {129U, 7U}}},
        // A stop of all is one of each
        {{{reset, 6U}, {reset, 7U}, {stop, 0U}}, {{129U, 6U}, {129U, 7U}, {2U, 0U}}}};
    setup.inhibit_100us = 20U;
    for (const auto& [asked, left] : runs)
    {
        EXPECT_EQ(Ask(reset, 5U), NmtAnswer::kTaken);
        EXPECT_EQ(sink.Next(), (Bytes2{129U, 5U}));
        for (const auto& [command, node] : asked)
        {
            EXPECT_EQ(Ask(command, node), NmtAnswer::kTaken);
        }
        for (const Bytes2& frame : left)
        {
            After(2000U);
            EXPECT_EQ(sink.Next(), frame);
        }
        EXPECT_EQ(nmt.Waiting(), 0U);
        After(2000U);
    }
}

TEST_F(NmtMasterTest, TheStopOfARefusedSlaveGoesBeforeAllButOtherSuchStops)
{
    Verifies(req::SRS_NMM_770);
    using Node = std::pair<NmtCommand, std::uint8_t>;
    const auto stop = NmtCommand::kStop;
    const auto reset = NmtCommand::kResetNode;
    const auto asleep = NmtCommand::kPreOperational;
    const auto anew = NmtCommand::kResetCommunication;
    const std::pair<std::vector<Node>, std::vector<Bytes2>> runs[] = {
        // Before stops that an order asked for, and before what waits for all
        {{{reset, 6U}, {stop, 7U}}, {{2U, 8U}, {2U, 9U}, {2U, 7U}, {129U, 6U}}},
        {{{asleep, 0U}, {reset, 7U}}, {{2U, 8U}, {2U, 9U}, {128U, 0U}, {129U, 7U}}},
        // Instead of what it supersedes; the stop of an order is asked for in its own right
        {{{asleep, 8U}, {NmtCommand::kStart, 9U}}, {{2U, 8U}, {2U, 9U}}},
        {{{asleep, 8U}, {stop, 8U}}, {{2U, 8U}, {2U, 9U}, {2U, 8U}}},
        // But from a reset of the node on it is for the time behind it
        {{{reset, 8U}, {asleep, 8U}}, {{2U, 8U}, {2U, 9U}, {129U, 8U}, {128U, 8U}}},
        {{{anew, 9U}, {NmtCommand::kStart, 9U}}, {{2U, 8U}, {2U, 9U}, {130U, 9U}, {1U, 9U}}}};
    setup.inhibit_100us = 20U;
    for (const auto& [asked, left] : runs)
    {
        EXPECT_EQ(Ask(reset, 5U), NmtAnswer::kTaken);
        for (const auto& [command, node] : asked)
        {
            EXPECT_EQ(Ask(command, node), NmtAnswer::kTaken);
        }
        for (const NodeId node : {NodeId{8U}, NodeId{9U}, NodeId{8U}}) // Asked for again it keeps its place.
        {
            EXPECT_EQ(nmt.Halt(node, Instant{now_us}), NmtAnswer::kTaken);
        }
        while (nmt.Waiting() > 0U)
        {
            After(2000U);
        }
        ASSERT_EQ(sink.frames.size(), left.size() + 1U);
        EXPECT_EQ(sink.Next(), (Bytes2{129U, 5U}));
        for (const Bytes2& frame : left)
        {
            EXPECT_EQ(sink.Next(), frame);
        }
        After(2000U);
    }
    EXPECT_EQ(nmt.Dropped(), 3U);
    EXPECT_TRUE(listener.dropped.empty()); // Whoever stops a slave does not start it again.
}

TEST_F(NmtMasterTest, TheStopOfARefusedSlaveIsRefusedAsAnyCommand)
{
    Verifies(req::SRS_NMM_770);
    // Given an asker that has it sent by the running cycle
    listener.master = &nmt;
    EXPECT_EQ(nmt.Halt(NodeId{8U}, Instant{now_us}), NmtAnswer::kTaken);
    EXPECT_EQ(sink.frames.size(), 2U);
    listener.master = nullptr;
    // No room, and no master
    sink.room = 0;
    for (std::uint8_t node = 5U; node <= 8U; ++node)
    {
        EXPECT_EQ(Ask(NmtCommand::kResetNode, node), NmtAnswer::kTaken);
    }
    EXPECT_EQ(nmt.Halt(NodeId{8U}, Instant{now_us}), NmtAnswer::kQueueFull);
    nmt.SetActive(false);
    EXPECT_EQ(nmt.Halt(NodeId{8U}, Instant{now_us}), NmtAnswer::kNotActive);
}

TEST_F(NmtMasterTest, TheStopOfARefusedSlaveThatIsVerifiedSinceDoesNotLeave)
{
    Verifies(req::SRS_NMM_771);
    slaves[6].safety = reinterpret_cast<const SafetyExpectation*>(&gate);
    sink.room = 0;
    EXPECT_EQ(nmt.Halt(NodeId{6U}, Instant{now_us}), NmtAnswer::kTaken);
    EXPECT_EQ(nmt.Halt(NodeId{7U}, Instant{now_us}), NmtAnswer::kTaken); // No safety slave.
    EXPECT_EQ(Ask(NmtCommand::kPreOperational, 6U), NmtAnswer::kTaken);
    gate.states[6] = GateState::kOpen;
    sink.room = 10;
    After(1U);
    EXPECT_EQ(sink.Next(), (Bytes2{2U, 7U}));
    EXPECT_EQ(sink.Next(), (Bytes2{128U, 6U}));
    // And the stop that an order asks for while it waits is not the same
    gate.Close(NodeId{6U});
    sink.room = 0;
    EXPECT_EQ(nmt.Halt(NodeId{6U}, Instant{now_us}), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kStop, 6U), NmtAnswer::kTaken);
    gate.states[6] = GateState::kOpen;
    sink.room = 10;
    After(1U);
    ASSERT_EQ(sink.frames.size(), 1U);
    EXPECT_EQ(sink.Next(), (Bytes2{2U, 6U}));
}

TEST_F(NmtMasterTest, WhoIsAboutToLeaveOperationalIsKnown)
{
    Verifies(req::SRS_BOOT_770);
    setup.inhibit_100us = 20U;
    EXPECT_EQ(Ask(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kStart, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kStart, 7U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kStop, 7U), NmtAnswer::kTaken);
    nmt.DropStarts(NodeId{6U});
    // Neither one whose command has left, nor one that is started or given up, nor another one
    EXPECT_FALSE(nmt.IsLeaving(NodeId{5U}));
    EXPECT_FALSE(nmt.IsLeaving(NodeId{6U}));
    EXPECT_TRUE(nmt.IsLeaving(NodeId{7U}));
    EXPECT_EQ(Ask(NmtCommand::kPreOperational, 0U), NmtAnswer::kTaken);
    EXPECT_TRUE(nmt.IsLeaving(NodeId{9U}));
    EXPECT_TRUE(nmt.IsLeaving(NodeId{7U}));
}

TEST_F(NmtMasterTest, ACommandThatWaitsForItsNodeIsNotPutBehindItself)
{
    Verifies(req::SRS_NMM_214);
    setup.inhibit_100us = 20U;
    EXPECT_EQ(Ask(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(sink.Next(), (Bytes2{128U, 5U}));
    // Given one that is asked for again and again while it waits, and others between
    for (int again = 0; again < 9; ++again)
    {
        EXPECT_EQ(Ask(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
        EXPECT_EQ(Ask(NmtCommand::kResetNode, 6U), NmtAnswer::kTaken);
    }
    EXPECT_EQ(nmt.Waiting(), 2U);
    After(2000U);
    EXPECT_EQ(sink.Next(), (Bytes2{128U, 5U}));
    // Behind another one for the node or for all it is not the same, nor is a start, which counts from its order on
    EXPECT_EQ(Ask(NmtCommand::kStop, 0U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kResetNode, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(nmt.Waiting(), 3U);
    for (const Bytes2& frame : {Bytes2{129U, 6U}, Bytes2{2U, 0U}, Bytes2{129U, 6U}})
    {
        After(2000U);
        EXPECT_EQ(sink.Next(), frame);
    }
    EXPECT_EQ(Ask(NmtCommand::kStart, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kStart, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kStop, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kStart, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(nmt.Waiting(), 4U);
    // What waits for one node and is then asked for of all is another command
    After(2000U);
    EXPECT_EQ(Ask(NmtCommand::kStop, 0U), NmtAnswer::kTaken);
    EXPECT_EQ(nmt.Waiting(), 4U);
}

TEST_F(NmtMasterTest, ACommandForTheOwnNodeReachesTheListenerOnly)
{
    Verifies(req::SRS_NMM_215);
    EXPECT_EQ(Ask(NmtCommand::kStart, 127U), NmtAnswer::kTaken);
    EXPECT_TRUE(sink.frames.empty());
    ASSERT_EQ(listener.heard.size(), 1U);
    EXPECT_EQ(listener.heard[0].command, NmtCommand::kStart);
}

TEST_F(NmtMasterTest, AListenerMayAskForMore)
{
    Verifies(req::SRS_NMM_001);
    listener.master = &nmt;
    EXPECT_EQ(Ask(NmtCommand::kStart, 8U), NmtAnswer::kTaken);
    ASSERT_EQ(sink.frames.size(), 2U);
    EXPECT_EQ(sink.frames[1].data[1], 9U);
}

TEST_F(NmtMasterTest, OnlyTheActiveMasterCommands)
{
    Verifies(req::SRS_NMM_002);
    sink.room = 0;
    EXPECT_EQ(Ask(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    nmt.SetActive(false);
    EXPECT_FALSE(nmt.IsActive());
    EXPECT_EQ(nmt.Waiting(), 0U);
    EXPECT_EQ(Ask(NmtCommand::kStart, 5U), NmtAnswer::kNotActive);
    EXPECT_EQ(Ask(NmtCommand::kStart, 127U), NmtAnswer::kNotActive);
    nmt.SetActive(true);
    sink.room = 10;
    After(1U);
    EXPECT_TRUE(sink.frames.empty());
}

TEST_F(NmtMasterTest, WrongCommandsAndNodes)
{
    Verifies(req::SRS_NMM_001);
    EXPECT_EQ(Ask(NmtCommand::kInvalid, 5U), NmtAnswer::kWrong);
    EXPECT_EQ(Ask(static_cast<NmtCommand>(3U), 5U), NmtAnswer::kWrong);
    EXPECT_EQ(Ask(NmtCommand::kStart, 128U), NmtAnswer::kWrong);
}

TEST_F(NmtMasterTest, NoStartOfAllWhileASafetySlaveIsListed)
{
    Verifies(req::SRS_NMM_003);
    EXPECT_EQ(Ask(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
    slaves[6].safety = reinterpret_cast<const SafetyExpectation*>(&gate); // Only looked at whether it is there.
    EXPECT_EQ(Ask(NmtCommand::kStart, 0U), NmtAnswer::kNoBroadcast);
    EXPECT_EQ(Ask(NmtCommand::kStop, 0U), NmtAnswer::kTaken);
    // Not in the list: no safety slave
    slaves[6].assignment = 0U;
    EXPECT_EQ(Ask(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
    // Only a start of all that waits when the list changes is dropped
    sink.room = 0;
    EXPECT_EQ(Ask(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
    slaves[6].assignment = kInNetwork;
    sink.room = 10;
    sink.frames.clear();
    After(1U);
    EXPECT_TRUE(sink.frames.empty());
    EXPECT_EQ(nmt.Dropped(), 1U);
}

TEST_F(NmtMasterTest, NoStartOfASafetySlaveThatWasNotVerified)
{
    Verifies(req::SRS_NMM_004);
    Verifies(req::SRS_NMM_120);
    slaves[6].safety = reinterpret_cast<const SafetyExpectation*>(&gate);
    EXPECT_EQ(Ask(NmtCommand::kStart, 6U), NmtAnswer::kNotVerified);
    EXPECT_EQ(Ask(NmtCommand::kStop, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kStart, 7U), NmtAnswer::kTaken);
    gate.states[6] = GateState::kOpen;
    EXPECT_EQ(Ask(NmtCommand::kStart, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(sink.frames.size(), 3U);
    // Taken, and the slave boots up before the frame leaves
    sink.room = 0;
    EXPECT_EQ(Ask(NmtCommand::kStart, 6U), NmtAnswer::kTaken);
    gate.Close(NodeId{6U});
    sink.room = 10;
    After(1U);
    EXPECT_EQ(sink.frames.size(), 3U);
    EXPECT_EQ(nmt.Dropped(), 1U);
}

TEST_F(NmtMasterTest, EachNodeOfTheListButOne)
{
    Verifies(req::SRS_NMM_001);
    EXPECT_EQ(nmt.RequestEach(NmtCommand::kStop, NodeId{7U}, Instant{now_us}), NmtAnswer::kTaken);
    ASSERT_EQ(sink.frames.size(), 4U);
    EXPECT_EQ(sink.frames[0].data[1], 5U);
    EXPECT_EQ(sink.frames[1].data[1], 6U);
    EXPECT_EQ(sink.frames[2].data[1], 8U);
    EXPECT_EQ(sink.frames[3].data[1], 9U);
}

TEST_F(NmtMasterTest, AStartOfASafetySlaveThatWaitedLongerThanTenMillisecondsDoesNotLeave)
{
    Verifies(req::SRS_SFS_152);
    slaves[6].safety = reinterpret_cast<const SafetyExpectation*>(&gate);
    gate.states[6] = GateState::kOpen;
    sink.room = 0;
    EXPECT_EQ(Ask(NmtCommand::kStart, 6U), NmtAnswer::kTaken);
    After(10'000U);
    sink.room = 10;
    After(0U);
    EXPECT_EQ(sink.Next(), (Bytes2{1U, 6U})); // Not longer.
    sink.room = 0;
    EXPECT_EQ(Ask(NmtCommand::kStart, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kStart, 7U), NmtAnswer::kTaken); // No safety slave.
    After(10'001U);
    sink.room = 10;
    After(0U);
    EXPECT_EQ(sink.Next(), (Bytes2{1U, 7U}));
    EXPECT_TRUE(sink.frames.empty());
    EXPECT_EQ(nmt.Dropped(), 1U);
    EXPECT_EQ(listener.dropped, (std::vector<std::uint8_t>{6U}));
}

TEST_F(NmtMasterTest, StartsOfOneNodeThatWaitAreTakenBack)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    sink.room = 0;
    EXPECT_EQ(Ask(NmtCommand::kResetNode, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kStart, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(Ask(NmtCommand::kStart, 7U), NmtAnswer::kTaken);
    nmt.DropStarts(NodeId{6U});
    nmt.DropStarts(NodeId{9U});
    sink.room = 10;
    After(1U);
    EXPECT_EQ(sink.Next(), (Bytes2{129U, 6U}));
    EXPECT_EQ(sink.Next(), (Bytes2{1U, 7U}));
    EXPECT_TRUE(sink.frames.empty());
    // Whoever took it back needs not to be told
    EXPECT_TRUE(listener.dropped.empty());
}

TEST_F(NmtMasterTest, TheFirstRefusalOfACommandToEachIsItsAnswer)
{
    Verifies(req::SRS_NMM_002);
    nmt.SetActive(false);
    EXPECT_EQ(nmt.RequestEach(NmtCommand::kStop, NodeId{0U}, Instant{now_us}), NmtAnswer::kNotActive);
    // One that does not take it keeps no other one from it
    nmt.SetActive(true);
    slaves[6].safety = reinterpret_cast<const SafetyExpectation*>(&gate);
    EXPECT_EQ(nmt.RequestEach(NmtCommand::kStart, NodeId{0U}, Instant{now_us}), NmtAnswer::kNotVerified);
    EXPECT_EQ(sink.frames.size(), 4U);
}

} // namespace
} // namespace counterpoint::cia302
