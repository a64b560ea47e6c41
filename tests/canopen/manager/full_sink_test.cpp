// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Commands that wait for room in the sink, beside requests and remote frames that wait for it, too.
#include "tests/canopen/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kHeartbeat = 0x77FU; ///< Of the manager.

/// Given a safety slave 5 and another slave 6, both started, and from `is_narrow` on a sink that holds one frame.
class FullSinkTest : public ManagerRig
{
  public:
    FullSinkTest()
    {
        Add(5U);
        Add(6U);
        MakeSafe(5U);
    }
    bool Send(const CanFrame& frame) noexcept override
    {
        const std::uint32_t service = frame.identifier & 0x780U;
        const bool is_request = (frame.identifier == 0U) || (frame.identifier == kHeartbeat) || (service == 0x600U) ||
                                (frame.kind == FrameKind::kRemote);
        const bool is_kept = is_narrow && is_request;
        const bool is_taken = !is_kept || is_free;
        if (is_kept && is_taken)
        {
            is_free = false;
            sent.push_back(frame.identifier);
            last = frame;
        }
        return is_kept ? is_taken : ManagerRig::Send(frame);
    }
    void StartBoth()
    {
        Begin(Profile::kCia302);
        Run(200U);
        ASSERT_EQ(Running(5U) + Running(6U), 2);
        is_narrow = true;
    }
    void ExpectStopOfFive() const
    {
        EXPECT_EQ(sent, (std::vector<std::uint32_t>{0U}));
        EXPECT_EQ(last.data[0], 2U);
        EXPECT_EQ(last.data[1], 5U);
    }

    bool is_narrow{false};
    bool is_free{false};               ///< The place of the sink.
    std::vector<std::uint32_t> sent{}; ///< Identifiers that it took.
    CanFrame last{};
};

TEST_F(FullSinkTest, AStopGoesBeforeARequestThatWaitedLonger)
{
    Verifies(req::SRS_NMM_230);
    StartBoth();
    EXPECT_TRUE(manager->Role().Boot(NodeId{6U}, Now()));
    Run(5U);
    EXPECT_EQ(Order(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(5U);
    ASSERT_TRUE(sent.empty());
    is_free = true;
    Run(1U);
    ExpectStopOfFive();
}

TEST_F(FullSinkTest, AStopGoesBeforeARemoteFrame)
{
    Verifies(req::SRS_NMM_230);
    // Given slave 6 guarded each 10 ms
    setups[6].assignment |= (10U << 16U) | (100U << 8U);
    StartBoth();
    EXPECT_EQ(Order(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(30U);
    ASSERT_TRUE(sent.empty());
    is_free = true;
    Run(1U);
    ExpectStopOfFive();
}

TEST_F(FullSinkTest, AStopGoesBeforeTheRequestBehindAnAnswer)
{
    Verifies(req::SRS_NMM_230);
    StartBoth();
    is_free = true;
    EXPECT_TRUE(manager->Role().Boot(NodeId{6U}, Now()));
    Run(5U);
    ASSERT_EQ(sent, (std::vector<std::uint32_t>{0x606U}));
    EXPECT_EQ(Order(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    // When the request has left, and its answer comes: 1000h is 191h
    sent.clear();
    is_free = true;
    Put(CanFrame{0x586U, FrameKind::kData, CanPortId::kFirst, 8U, {0x43U, 0x00U, 0x10U, 0U, 0x91U, 0x01U, 0U, 0U}});
    ExpectStopOfFive();
}

TEST_F(FullSinkTest, AHeartbeatThatFoundNoRoomGoesBeforeARequest)
{
    Verifies(req::SRS_MGR_231);
    StartBoth();
    manager->Heartbeat().SetPeriod(100U);
    EXPECT_TRUE(manager->Role().Boot(NodeId{6U}, Now()));
    Run(150U);
    ASSERT_TRUE(sent.empty());
    is_free = true;
    Run(1U);
    EXPECT_EQ(sent, (std::vector<std::uint32_t>{kHeartbeat}));
    EXPECT_EQ(last.data[0], 5U);
    // When it has left, the request does
    is_free = true;
    Run(1U);
    EXPECT_EQ(sent, (std::vector<std::uint32_t>{kHeartbeat, 0x606U}));
}

TEST_F(FullSinkTest, AHeartbeatGoesBeforeTheRequestBehindAnAnswerAndBehindACommand)
{
    Verifies(req::SRS_MGR_231);
    Verifies(req::SRS_NMM_230);
    StartBoth();
    is_free = true;
    EXPECT_TRUE(manager->Role().Boot(NodeId{6U}, Now()));
    Run(5U);
    ASSERT_EQ(sent, (std::vector<std::uint32_t>{0x606U}));
    manager->Heartbeat().SetPeriod(100U);
    EXPECT_EQ(Order(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(5U);
    sent.clear();
    is_free = true;
    Put(CanFrame{0x701U, FrameKind::kData, CanPortId::kFirst, 1U, {5U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}});
    ExpectStopOfFive();
    is_free = true;
    Put(CanFrame{0x586U, FrameKind::kData, CanPortId::kFirst, 8U, {0x43U, 0x00U, 0x10U, 0U, 0x91U, 0x01U, 0U, 0U}});
    EXPECT_EQ(sent, (std::vector<std::uint32_t>{0U, kHeartbeat}));
}

TEST_F(FullSinkTest, OneHeartbeatIsKeptAndTellsTheStateOfWhenItLeaves)
{
    Verifies(req::SRS_MGR_231);
    StartBoth();
    // Given three periods of 100 ms without room, and a manager that leaves OPERATIONAL behind them
    manager->Heartbeat().SetPeriod(100U);
    Run(350U);
    ASSERT_TRUE(sent.empty());
    EXPECT_EQ(Order(NmtCommand::kPreOperational, 127U), NmtAnswer::kTaken);
    // When there is room again
    is_free = true;
    Run(1U);
    // Then one heartbeat leaves, with the state of now, and the next one when it is due
    EXPECT_EQ(sent, (std::vector<std::uint32_t>{kHeartbeat}));
    EXPECT_EQ(last.data[0], 0x7FU);
    is_free = true;
    Run(30U);
    EXPECT_EQ(sent.size(), 1U);
    Run(71U);
    EXPECT_EQ(sent, (std::vector<std::uint32_t>{kHeartbeat, kHeartbeat}));
}

TEST_F(FullSinkTest, AHeartbeatThatIsSwitchedOffMeanwhileDoesNotLeave)
{
    Verifies(req::SRS_MGR_231);
    StartBoth();
    manager->Heartbeat().SetPeriod(100U);
    EXPECT_TRUE(manager->Role().Boot(NodeId{6U}, Now()));
    Run(150U);
    manager->Heartbeat().SetPeriod(0U);
    is_free = true;
    Run(1U);
    EXPECT_EQ(sent, (std::vector<std::uint32_t>{0x606U}));
}

TEST_F(FullSinkTest, ABootUpMessageThatFoundNoRoomGoesBeforeARequest)
{
    Verifies(req::SRS_MGR_231);
    StartBoth();
    EXPECT_EQ(Order(NmtCommand::kResetCommunication, 127U), NmtAnswer::kTaken);
    EXPECT_TRUE(manager->Role().Boot(NodeId{6U}, Now()));
    Run(5U);
    ASSERT_TRUE(sent.empty());
    is_free = true;
    Put(CanFrame{0x701U, FrameKind::kData, CanPortId::kFirst, 1U, {5U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}});
    EXPECT_EQ(sent, (std::vector<std::uint32_t>{kHeartbeat}));
    EXPECT_EQ(last.data[0], 0U);
}

} // namespace
} // namespace counterpoint::cia302
