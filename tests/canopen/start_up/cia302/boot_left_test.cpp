// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A slave that was refused, was started all the same, and is OPERATIONAL no more.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::cia302
{
namespace
{

using Lines = std::vector<std::string>;

class BootLeftTest : public BootRig
{
  public:
    /// Slave 5 is booted; 6 ended with letter D, and a start of its own has started it.
    void StartRefused()
    {
        setup.start_up = kIsMaster | kApplicationStartsSlaves;
        Add(5U, kBoot);
        Add(6U, kBoot);
        setups[6].vendor_id = 0x2BU;
        Begin();
        Run(50U);
        ASSERT_EQ(Letter(5U) + Letter(6U), "-D");
        StartAgain();
        ASSERT_FALSE(start_up.IsLeftOut(NodeId{6U}));
    }
    void StartAgain()
    {
        ASSERT_EQ(start_up.Command(NmtCommand::kStart, NodeId{6U}, Now()), NmtAnswer::kTaken);
        Deliver();
        Says(SlaveState::kOperational);
    }
    /// Node 6, in a heartbeat.
    void Says(const SlaveState state)
    {
        ToManager(CanFrame{0x706U, FrameKind::kData, CanPortId::kFirst, 1U, {static_cast<std::uint8_t>(state)}});
    }
    /// Somebody else.
    void Commands(const std::uint8_t command, const std::uint8_t node, const std::uint8_t length = 2U,
                  const std::uint32_t identifier = 0U, const FrameKind kind = FrameKind::kData)
    {
        ToManager(CanFrame{identifier, kind, CanPortId::kFirst, length, {command, node}});
    }
    /// What a start of all sends.
    Lines StartAll()
    {
        log.clear();
        static_cast<void>(start_up.Command(NmtCommand::kStart, NodeId{0U}, Now()));
        Deliver();
        Lines sent;
        for (const Sent& each : log)
        {
            const bool is_start = (each.frame.identifier == 0U) && (each.frame.data[0] == 1U);
            if (is_start)
            {
                sent.push_back(std::to_string(each.frame.data[1]));
            }
        }
        return sent;
    }
};

TEST_F(BootLeftTest, SomebodyElsesCommandMakesItOneThatWasNotStarted)
{
    Verifies(req::SRS_BOOT_520);
    StartRefused();
    EXPECT_EQ(StartAll(), (Lines{"0"}));
    // Such a start of all takes nothing back
    EXPECT_EQ(StartAll(), (Lines{"0"}));
    for (const std::uint8_t command : {std::uint8_t{2U}, std::uint8_t{0x80U}, std::uint8_t{0x81U}, std::uint8_t{0x82U}})
    {
        for (const std::uint8_t node : {std::uint8_t{6U}, std::uint8_t{0U}})
        {
            Commands(command, node);
            EXPECT_TRUE(start_up.IsLeftOut(NodeId{6U})) << int{command};
            EXPECT_FALSE(start_up.IsLeftOut(NodeId{5U})) << int{command};
            EXPECT_EQ(StartAll(), (Lines{"5"})) << int{command};
            StartAgain();
        }
    }
    // But not a command for another node, a start, what is no command, or no such frame
    Commands(2U, 5U);
    Commands(1U, 6U);
    Commands(3U, 6U);
    Commands(2U, 6U, 1U);
    Commands(2U, 6U, 2U, 0x80U);
    Commands(2U, 6U, 2U, 0U, FrameKind::kRemote);
    EXPECT_FALSE(start_up.IsLeftOut(NodeId{6U}));
    EXPECT_EQ(StartAll(), (Lines{"0"}));
    // The start of somebody else, behind it, is no start by this one
    Commands(2U, 6U);
    Commands(1U, 6U);
    Says(SlaveState::kOperational);
    EXPECT_TRUE(start_up.IsLeftOut(NodeId{6U}));
}

TEST_F(BootLeftTest, WhatItSaysMakesItOneThatWasNotStarted)
{
    Verifies(req::SRS_BOOT_520);
    StartRefused();
    for (const SlaveState state : {SlaveState::kPreOperational, SlaveState::kStopped})
    {
        Says(state);
        EXPECT_TRUE(start_up.IsLeftOut(NodeId{6U}));
        EXPECT_EQ(StartAll(), (Lines{"5"}));
        // Also when it is back there by itself
        Says(SlaveState::kOperational);
        EXPECT_EQ(StartAll(), (Lines{"5"}));
        StartAgain();
        EXPECT_FALSE(start_up.IsLeftOut(NodeId{6U}));
    }
    // Its silence, where it is supervised
    table.WatchHeartbeat(NodeId{6U}, 20U, Arming::kImmediately, Now());
    Run(30U);
    ASSERT_EQ(table.Record(NodeId{6U}).state, SlaveState::kMissing);
    EXPECT_TRUE(start_up.IsLeftOut(NodeId{6U}));
}

TEST_F(BootLeftTest, OwnCommandsMakeItOneThatWasNotStarted)
{
    Verifies(req::SRS_BOOT_520);
    StartRefused();
    for (const std::uint8_t node : {std::uint8_t{6U}, std::uint8_t{0U}})
    {
        for (const NmtCommand command : {NmtCommand::kStop, NmtCommand::kPreOperational})
        {
            EXPECT_EQ(start_up.Command(command, NodeId{node}, Now()), NmtAnswer::kTaken);
            EXPECT_TRUE(start_up.IsLeftOut(NodeId{6U}));
            StartAgain();
        }
    }
    // Behind a stop of all by error handling so does its boot-up message
    setup.start_up = kIsMaster | kStopAllOnError | kApplicationStartsSlaves;
    setups[5].assignment = kMust;
    table.WatchHeartbeat(NodeId{5U}, 20U, Arming::kImmediately, Now());
    Run(30U);
    ASSERT_EQ(Step(), MasterStep::kStopped);
    EXPECT_TRUE(start_up.IsLeftOut(NodeId{6U}));
    StartAgain();
    Says(SlaveState::kUnknown); // Its boot-up message has 0.
    EXPECT_EQ(Letter(6U), "D");
    EXPECT_TRUE(start_up.IsLeftOut(NodeId{6U}));
}

TEST_F(BootLeftTest, WhoWasNotRefusedStaysStarted)
{
    Verifies(req::SRS_BOOT_520);
    StartRefused();
    EXPECT_EQ(start_up.Command(NmtCommand::kStart, NodeId{5U}, Now()), NmtAnswer::kTaken);
    Commands(2U, 5U);
    EXPECT_TRUE(Of(5U).is_started);
    EXPECT_FALSE(start_up.IsLeftOut(NodeId{5U}));
    // Nor is a safety slave, which is verified before each start
    Protect(6U);
    Commands(2U, 6U);
    EXPECT_TRUE(Of(6U).is_started);
}

} // namespace
} // namespace counterpoint::cia302
