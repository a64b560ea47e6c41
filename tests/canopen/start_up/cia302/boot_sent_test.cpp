// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What is told of a slave whose start waits for the inhibit time.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

namespace counterpoint::cia302
{
namespace
{

using Lines = std::vector<std::string>;

class BootSentTest : public BootRig
{
  public:
    void OnNodeStatus(const NodeId node, const Instant /*now*/) noexcept override
    {
        const NodeStatus status = Of(node.value);
        if (status.step == StartUpStep::kDone)
        {
            told.push_back(std::to_string(ms - begun_ms) + ":" + std::to_string(node.value) +
                           (status.is_started ? " started" : ""));
        }
    }
    /// What was sent last, the reset of all or one of an order, makes the next command wait for 200 ms.
    void KeepWaiting()
    {
        setup.inhibit_100us = 2000U;
        log.clear();
        told.clear();
    }
    NmtAnswer Order(const NmtCommand command, const std::uint8_t node)
    {
        const NmtAnswer answer = start_up.Command(command, NodeId{node}, Now());
        Deliver();
        return answer;
    }

    Lines told{};
};

TEST_F(BootSentTest, StartedIsToldWhenTheStartIsSent)
{
    Verifies(req::SRS_BOOT_800);
    Add(5U, kBoot);
    Add(6U, kBoot);
    Begin();
    KeepWaiting();
    Run(100U);
    // While the starts wait
    EXPECT_EQ(Commands(), (Lines{}));
    EXPECT_EQ(Of(5U).step, StartUpStep::kDone);
    EXPECT_FALSE(Of(5U).is_started || Of(6U).is_started);
    Run(110U);
    EXPECT_EQ(Commands(), (Lines{"200:01 05"}));
    EXPECT_TRUE(Of(5U).is_started);
    EXPECT_FALSE(Of(6U).is_started);
    Run(200U);
    EXPECT_TRUE(Of(6U).is_started);
    EXPECT_EQ(told, (Lines{"1:5", "1:6", "201:5 started", "401:6 started"}));
}

TEST_F(BootSentTest, AStartOfAllIsToldWhenItIsSent)
{
    Verifies(req::SRS_BOOT_800);
    setup.start_up = kIsMaster | kStartAllAtOnce;
    Add(5U, kMust);
    Add(6U, kMust);
    Begin();
    KeepWaiting();
    Run(100U);
    EXPECT_EQ(Commands(), (Lines{}));
    EXPECT_FALSE(Of(5U).is_started || Of(6U).is_started);
    Run(110U);
    EXPECT_EQ(Commands(), (Lines{"200:01 00"}));
    EXPECT_TRUE(Of(5U).is_started && Of(6U).is_started);
    EXPECT_EQ(told, (Lines{"1:5", "1:6", "1:5", "1:6", "201:5 started", "201:6 started"}));
}

TEST_F(BootSentTest, AStartOfAllThatMayNotBeSentAnyMoreBecomesSingleStarts)
{
    Verifies(req::SRS_BOOT_800);
    setup.start_up = kIsMaster | kStartAllAtOnce;
    Add(5U, kMust);
    Add(6U, kMust);
    Begin();
    KeepWaiting();
    Run(100U);
    // When a safety slave is assigned while the start of all waits, of which it is none
    Add(7U, kInNetwork);
    Protect(7U);
    Run(100U);
    EXPECT_EQ(nmt.Dropped(), 1U);
    EXPECT_FALSE(Of(5U).is_started || Of(6U).is_started);
    Run(400U);
    EXPECT_EQ(Commands(), (Lines{"200:01 05", "400:01 06"}));
    EXPECT_TRUE(Of(5U).is_started && Of(6U).is_started);
    EXPECT_FALSE(Of(7U).is_started);
}

TEST_F(BootSentTest, AnOrderedStartIsToldWhenItIsSent)
{
    Verifies(req::SRS_BOOT_800);
    setup.start_up = kIsMaster | kApplicationStartsSlaves;
    Add(5U, kBoot);
    Add(6U, kBoot);
    Begin();
    Run(50U);
    EXPECT_EQ(Order(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    KeepWaiting();
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Order(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
    Run(100U);
    EXPECT_FALSE(Of(5U).is_started || Of(6U).is_started);
    // Then the one of its own, and behind it the one of all
    Run(110U);
    EXPECT_EQ(Commands(), (Lines{"250:01 05"}));
    EXPECT_FALSE(Of(6U).is_started);
    Run(200U);
    EXPECT_TRUE(Of(5U).is_started && Of(6U).is_started);
    // Who is started stays so while a further start waits
    Order(NmtCommand::kStart, 5U);
    EXPECT_EQ(nmt.Waiting(), 1U);
    EXPECT_TRUE(Of(5U).is_started);
}

TEST_F(BootSentTest, AStopBehindAStartThatWaitsCounts)
{
    Verifies(req::SRS_BOOT_800);
    Add(5U, kBoot);
    Begin();
    KeepWaiting();
    Run(100U);
    EXPECT_EQ(Order(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(400U);
    EXPECT_EQ(Commands(), (Lines{"200:01 05", "400:02 05"}));
    EXPECT_FALSE(Of(5U).is_started);
    EXPECT_EQ(told, (Lines{"1:5"}));
}

TEST_F(BootSentTest, StartedEndsWhenTheStopIsSent)
{
    Verifies(req::SRS_BOOT_820);
    Add(5U, kBoot);
    Add(7U, kBoot);
    Begin();
    Run(50U);
    ASSERT_TRUE(Of(5U).is_started);
    // Given a stop by order, which waits 200 ms
    Order(NmtCommand::kPreOperational, 7U);
    KeepWaiting();
    told.clear();
    EXPECT_EQ(Order(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(199U);
    EXPECT_EQ(Commands(), (Lines{}));
    EXPECT_TRUE(Of(5U).is_started);
    // Then it ends with the stop
    Run(2U);
    EXPECT_EQ(Commands(), (Lines{"250:02 05"}));
    EXPECT_FALSE(Of(5U).is_started);
    EXPECT_EQ(told, (Lines{"251:5"}));
}

TEST_F(BootSentTest, AStopOfAllEndsStartedWhenItIsSent)
{
    Verifies(req::SRS_BOOT_820);
    Add(5U, kBoot);
    Add(6U, kBoot);
    Add(7U, kBoot);
    Begin();
    Run(50U);
    Order(NmtCommand::kPreOperational, 7U);
    KeepWaiting();
    EXPECT_EQ(Order(NmtCommand::kPreOperational, 0U), NmtAnswer::kTaken);
    Run(199U);
    EXPECT_TRUE(Of(5U).is_started && Of(6U).is_started);
    Run(2U);
    EXPECT_FALSE(Of(5U).is_started || Of(6U).is_started);
}

TEST_F(BootSentTest, AStartBehindAStopThatWaitsIsToldBehindIt)
{
    Verifies(req::SRS_BOOT_800);
    Verifies(req::SRS_BOOT_820);
    Add(5U, kBoot);
    Add(7U, kBoot);
    Begin();
    Run(50U);
    Order(NmtCommand::kPreOperational, 7U);
    KeepWaiting();
    told.clear();
    Order(NmtCommand::kStop, 5U);
    Order(NmtCommand::kStart, 5U);
    // It runs until the stop at 250 ms, and again from the start at 450 ms on
    Run(199U);
    EXPECT_TRUE(Of(5U).is_started);
    Run(2U);
    EXPECT_FALSE(Of(5U).is_started);
    Run(200U);
    EXPECT_TRUE(Of(5U).is_started);
    EXPECT_EQ(Commands(), (Lines{"250:02 05", "450:01 05"}));
    EXPECT_EQ(told, (Lines{"251:5", "451:5 started"}));
}

TEST_F(BootSentTest, StoppedAllIsToldWhenTheStopIsSent)
{
    Verifies(req::SRS_BOOT_821);
    setup.start_up = kIsMaster | kStopAllOnError;
    Add(5U, kMust).heartbeat_ms = 50U;
    setups[5].heartbeat = HeartbeatSetup{150U, 50U, Arming::kFirstHeartbeat};
    Add(6U, kBoot);
    Add(7U, kBoot);
    Begin();
    Run(200U);
    ASSERT_TRUE(Of(6U).is_started);
    ASSERT_EQ(start_up.MasterState(), 5);
    // Given a stop of all because of a loss, which waits
    Order(NmtCommand::kPreOperational, 7U);
    setup.inhibit_100us = 20000U; // 2 s
    slaves[5]->Unplug();
    Run(1000U);
    EXPECT_EQ(nmt.Waiting(), 1U);
    EXPECT_EQ(start_up.MasterState(), 5);
    EXPECT_TRUE(Of(6U).is_started);
    // Then it is told with it
    Run(1001U);
    EXPECT_EQ(nmt.Waiting(), 0U);
    EXPECT_EQ(start_up.MasterState(), 6);
    EXPECT_FALSE(Of(6U).is_started);
}

TEST_F(BootSentTest, BootingIsToldWhenTheResetOfAllIsSent)
{
    Verifies(req::SRS_BOOT_821);
    Add(5U, kMust);
    Add(7U, kBoot);
    Begin();
    Run(50U);
    ASSERT_EQ(start_up.MasterState(), 5);
    Order(NmtCommand::kPreOperational, 7U);
    KeepWaiting();
    slaves[5]->Unplug(); // It does not come back.
    EXPECT_EQ(Order(NmtCommand::kResetNode, 0U), NmtAnswer::kTaken);
    Run(199U);
    EXPECT_EQ(start_up.MasterState(), 5);
    EXPECT_TRUE(Of(5U).is_started);
    Run(2U);
    EXPECT_EQ(start_up.MasterState(), 2);
    EXPECT_FALSE(Of(5U).is_started);
}

} // namespace
} // namespace counterpoint::cia302
