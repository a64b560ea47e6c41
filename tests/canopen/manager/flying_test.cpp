// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A manager with a flying master and a profile that does nothing: what it does with the role that was negotiated.
#include "tests/canopen/manager/flying_rig.hpp"
#include "verification/trace/ids/flying_master.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::cia302
{
namespace
{

TEST_F(ManagerFlying, NegotiationOnTheApplicationsCallWithWhatItWrote)
{
    Verifies(req::SRS_FLY_007);
    Verifies(req::SRS_FLY_027);
    Verifies(req::SRS_FLY_002);
    Use(NegotiationBy::kApplication);
    manager.Begin(Now());
    RunTo(10'000U);
    EXPECT_EQ(Log(), Lines{"0 initialising"});
    EXPECT_EQ(manager.OwnState(), cia301::NodeState::kInitialising);
    // When it wrote a slot relation that cannot work, and one that can
    FlyingMasterObject object(times);
    EXPECT_EQ(object.Write(4U, 1270U), cia301::SdoAbort::kNone);
    EXPECT_EQ(manager.Role().StartNegotiation(Now()), FlyingStart::kSlots);
    EXPECT_EQ(object.Write(4U, 2000U), cia301::SdoAbort::kNone);
    EXPECT_EQ(object.Write(2U, 300U), cia301::SdoAbort::kNone);
    EXPECT_EQ(manager.Role().StartNegotiation(Now()), FlyingStart::kStarted);
    EXPECT_EQ(manager.Role().StartNegotiation(Now()), FlyingStart::kNotInitialising);
    RunTo(20'000U);
    // Then the power-on reset ends in INITIALISATION again, and nothing happens before the next call
    EXPECT_EQ(Log(), (Lines{"10300 073", "10400 000 82 00", "event 3 0/0", "10400 initialising"}));
    EXPECT_EQ(manager.Role().StartNegotiation(Now()), FlyingStart::kStarted);
    RunTo(22'450U);
    // 20000 + 300 + 100 + 1 x 2000 + 5 x 10
    EXPECT_EQ(Log(), (Lines{"20300 073", "20400 072", "22450 071 01 05", "event 4 1/5", "leads", "22450 705 00"}));
}

TEST_F(ManagerFlying, RoomInTheSinkIsOfferedToTheProfileThatLeads)
{
    Verifies(req::SRS_ELM_230);
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(2000U);
    Hear(0x710U, {0x05U});
    EXPECT_EQ(profile.rooms, 0);
    RunTo(4000U);
    ASSERT_TRUE(manager.IsActive());
    const int before = profile.rooms;
    Hear(0x710U, {0x05U});
    EXPECT_EQ(profile.rooms, before + 1);
    RunTo(4001U);
    EXPECT_EQ(profile.rooms, before + 2);
}

TEST_F(ManagerFlying, ACommandThatWaitsHasTheRoomBeforeThePdosOfTheProfile)
{
    Verifies(req::SRS_NMM_230);
    slaves[16].assignment = 1U;
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(4000U);
    ASSERT_TRUE(manager.IsActive());
    // Given a full sink, and a command that waits
    refuses = 1'000'000U;
    EXPECT_EQ(manager.ProfileParts().nmt.Request(NmtCommand::kStop, NodeId{16U}, Now()), NmtAnswer::kTaken);
    RunTo(4010U);
    Log();
    profile.tells_room = true;
    // When there is room: with a frame, and with a cycle
    refuses = 0U;
    Hear(0x710U, {0x05U});
    EXPECT_EQ(Log(), (Lines{"4010 000 02 10", "room"}));
    refuses = 1'000'000U;
    EXPECT_EQ(manager.ProfileParts().nmt.Request(NmtCommand::kStop, NodeId{16U}, Now()), NmtAnswer::kTaken);
    RunTo(4020U);
    Log();
    refuses = 0U;
    RunTo(4021U);
    EXPECT_EQ(Log(), (Lines{"4021 000 02 10", "room"}));
}

TEST_F(ManagerFlying, WhatTheActiveMasterOwesLeavesWithTheFirstRoom)
{
    Verifies(req::SRS_MGR_231);
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(4000U);
    ASSERT_TRUE(manager.IsActive());
    Log();
    // When somebody asks who is master, and the sink is full
    refuses = 1'000'000U;
    Hear(0x073U);
    RunTo(4100U);
    EXPECT_EQ(Log(), Lines{});
    // Then the answer leaves with the next frame, whatever it is, and once
    refuses = 0U;
    Hear(0x710U, {0x05U});
    Hear(0x710U, {0x05U});
    EXPECT_EQ(Log(), Lines{"4100 071 01 05"});
    // And so does what it sends again and again, with the heartbeat behind it
    refuses = 1'000'000U;
    RunTo(9000U);
    refuses = 0U;
    Hear(0x710U, {0x05U});
    Hear(0x710U, {0x05U});
    EXPECT_EQ(Log(), (Lines{"9000 076", "9000 705 7F"}));
    // When it is not the active master any more, nothing is owed
    refuses = 1'000'000U;
    Hear(0x073U);
    RunTo(9100U);
    Hear(0x071U, {0x00U, 0x02U});
    refuses = 0U;
    Hear(0x710U, {0x05U});
    EXPECT_FALSE(manager.IsActive());
    for (const std::string& line : Log())
    {
        EXPECT_EQ(line.find("071 01"), std::string::npos) << line;
    }
}

TEST_F(ManagerFlying, AnActiveMasterWithoutACyclicMessageOwesNothing)
{
    Verifies(req::SRS_MGR_231);
    Use(NegotiationBy::kManager);
    times.detection_cycle = 0U;
    manager.Begin(Now());
    RunTo(4000U);
    ASSERT_TRUE(manager.IsActive());
    Log();
    refuses = 1'000'000U;
    RunTo(4800U);
    refuses = 0U;
    Hear(0x710U, {0x05U});
    EXPECT_EQ(Log(), Lines{"4800 705 7F"});
}

TEST_F(ManagerFlying, ValuesThatCannotWorkAreToldOnceAndMayBeCorrected)
{
    Verifies(req::SRS_FLY_027);
    Use(NegotiationBy::kManager);
    times.priority_slot = 1270U;
    manager.Begin(Now());
    RunTo(2000U);
    EXPECT_EQ(Log(), (Lines{"0 initialising", "1 refused 4"}));
    times.priority_slot = 1271U;
    RunTo(2501U);
    EXPECT_EQ(Log(), Lines{"2501 073"});
}

// t [ms]  0             501  601                  1102 = 602 + 500  1202  1300: 82 05 of somebody else  1801 = 1301 +
// 500
//         INITIALISING  073  82 00, INITIALISING  073               072   INITIALISING                  073
TEST_F(ManagerFlying, AManagerBeginsTheNegotiationInTheCycleBehindEachReset)
{
    Verifies(req::SRS_FLY_027);
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(600U);
    EXPECT_EQ(Log(), (Lines{"0 initialising", "501 073"}));
    // When nobody answers, then its own reset of all is one, too
    RunTo(1300U);
    EXPECT_EQ(Log(), (Lines{"601 000 82 00", "event 3 0/0", "601 initialising", "1102 073", "1202 072"}));
    // When somebody else commands one, then it begins anew with the next cycle
    Hear(0U, {0x82U, 0x05U});
    RunTo(1801U);
    EXPECT_EQ(Log(), (Lines{"1300 initialising", "1801 073"}));
}

TEST_F(ManagerFlying, WithoutAFlyingMasterThereIsNoNegotiation)
{
    Verifies(req::SRS_FLY_027);
    manager.Use(profile);
    EXPECT_EQ(manager.Role().StartNegotiation(Now()), FlyingStart::kInvalid);
}

// t [ms]  501  540 (slave of 0/9)  2040 lost     2540  2640  4190 = 2640 + 1500 + 50
//         073  boot-up             INITIALISING  073   072   071, boot-up
TEST_F(ManagerFlying, WhoNegotiatesAfterALossIsInitialisingAndBootsUpAgain)
{
    Verifies(req::SRS_FLY_028);
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(540U);
    Hear(0x71U, {0U, 9U});
    RunTo(541U);
    EXPECT_EQ(Log(), (Lines{"0 initialising", "501 073", "event 1 0/9", "541 705 00"}));
    Hear(0U, {1U, 0U});
    EXPECT_EQ(manager.OwnState(), cia301::NodeState::kOperational);
    // Given a heartbeat of its own, then a master that was silent for 1500 ms since its claim
    RunTo(2039U);
    EXPECT_EQ(Log(), (Lines{"542 705 05", "1542 705 05"}));
    RunTo(2041U);
    EXPECT_EQ(manager.OwnState(), cia301::NodeState::kInitialising);
    static_cast<void>(Log());
    RunTo(4190U);
    // Then no heartbeat leaves until it has a role, and the boot-up message comes first
    EXPECT_EQ(Log(), (Lines{"2540 073", "2640 072", "4190 071 01 05", "event 4 1/5", "leads", "4190 705 00"}));
    EXPECT_EQ(manager.OwnState(), cia301::NodeState::kPreOperational);
}

TEST_F(ManagerFlying, ARaceOrRestartAtAForceEndsTheLeadAtOnce)
{
    Verifies(req::SRS_MGR_002);
    Verifies(req::SRS_MGR_212);
    for (const ForceReaction reaction : {ForceReaction::kRace, ForceReaction::kRestart, ForceReaction::kResetAll})
    {
        SCOPED_TRACE(static_cast<int>(reaction));
        options.on_force = reaction;
        Use(NegotiationBy::kManager);
        if (!manager.IsActive())
        {
            manager.Begin(Now());
            RunTo(now_ms + 3000U);
        }
        ASSERT_TRUE(manager.IsActive());
        // When 076h is heard and no frame can leave
        refuses = 1U;
        Hear(0x76U);
        // Then it commands nobody any more
        EXPECT_FALSE(manager.IsActive());
        EXPECT_EQ(manager.Role().Command(NmtCommand::kStart, NodeId{9U}, Now()), NmtAnswer::kNotActive);
        refuses = 0U;
        RunTo(now_ms + 3000U);
        EXPECT_TRUE(manager.IsActive());
    }
}

TEST_F(ManagerFlying, AsSlaveOfALivingMasterItTakesPartInNoNegotiation)
{
    Verifies(req::SRS_MGR_212);
    slaves[3].heartbeat = HeartbeatSetup{200U, 100U, Arming::kImmediately};
    options.on_force = ForceReaction::kRace;
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(3000U);
    ASSERT_TRUE(manager.IsActive());
    // When another negotiation is forced, which node 3 of a higher priority wins, and lives
    Hear(0x76U);
    RunTo(3010U);
    Hear(0x71U, {0U, 3U});
    static_cast<void>(Log());
    for (std::uint32_t beat_ms = 3100U; beat_ms <= 8000U; beat_ms += 100U)
    {
        RunTo(beat_ms);
        Hear(0x703U, {5U});
    }
    // Then it asks for no master and claims nothing
    EXPECT_FALSE(manager.IsActive());
    for (const std::string& line : Log())
    {
        EXPECT_EQ(line.find(" 07"), std::string::npos) << line;
    }
    // When the master is silent, it takes part again
    RunTo(11000U);
    EXPECT_TRUE(manager.IsActive());
}

TEST_F(ManagerFlying, CommandsThatNeverLeaveAreTold)
{
    Verifies(req::SRS_MGR_800);
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(3000U);
    ASSERT_TRUE(manager.IsActive());
    // Given a command that has left, and three that wait, of which one was given up
    setup.inhibit_100us = 10000U;
    NmtMaster& nmt = manager.ProfileParts().nmt;
    EXPECT_EQ(nmt.Request(NmtCommand::kStop, NodeId{8U}, Now()), NmtAnswer::kTaken);
    EXPECT_EQ(nmt.Request(NmtCommand::kStop, NodeId{9U}, Now()), NmtAnswer::kTaken);
    EXPECT_EQ(nmt.Request(NmtCommand::kStart, NodeId{10U}, Now()), NmtAnswer::kTaken);
    EXPECT_EQ(nmt.Request(NmtCommand::kResetNode, NodeId{0U}, Now()), NmtAnswer::kTaken);
    nmt.DropStarts(NodeId{10U});
    EXPECT_EQ(unsent, "");
    // When it commands nobody any more
    manager.OnBus(false, Now());
    EXPECT_EQ(unsent, "2 9; 129 0; ");
    EXPECT_EQ(nmt.Waiting(), 0U);
}

TEST_F(ManagerFlying, OffTheBusNoRoleIsKeptAndNoneNegotiatedBeforeItIsBack)
{
    Verifies(req::SRS_FLY_150);
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(3000U);
    ASSERT_TRUE(manager.IsActive());
    static_cast<void>(Log());
    // When the controller of the active master goes bus-off, told twice
    manager.OnBus(false, Now());
    manager.OnBus(false, Now());
    // Then it commands nobody at once, and nothing is tried before the bus is back
    EXPECT_FALSE(manager.IsActive());
    EXPECT_EQ(manager.Role().Command(NmtCommand::kStart, NodeId{9U}, Now()), NmtAnswer::kNotActive);
    RunTo(8000U);
    EXPECT_EQ(Log(), (Lines{"leads no more", "3000 initialising"}));
    EXPECT_EQ(manager.Role().StartNegotiation(Now()), FlyingStart::kNoBus);
    manager.OnBus(true, Now());
    RunTo(10'151U);
    // Then it asks, and resets nobody: 8001 + 500, + 100, + 1 x 1500 + 5 x 10
    EXPECT_EQ(Log(), (Lines{"8501 073", "8601 072", "10151 071 01 05", "event 4 1/5", "leads", "10151 705 00"}));
}

TEST_F(ManagerFlying, OffTheBusAManagerWithoutAFlyingMasterLeadsOn)
{
    Verifies(req::SRS_FLY_150);
    manager.Use(profile);
    manager.Begin(Now());
    manager.OnBus(false, Now());
    RunTo(10U);
    EXPECT_TRUE(manager.IsActive());
}

TEST_F(ManagerFlying, ResettingItselfEndsTheRoleAndResettingAllDoesNot)
{
    Verifies(req::SRS_FLY_151);
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(3000U);
    ASSERT_TRUE(manager.IsActive());
    NmtMaster& nmt = manager.ProfileParts().nmt;
    static_cast<void>(Log());
    // When it resets all nodes, or another one
    EXPECT_EQ(nmt.Request(NmtCommand::kResetCommunication, kAllNodes, Now()), NmtAnswer::kTaken);
    EXPECT_EQ(nmt.Request(NmtCommand::kResetNode, NodeId{9U}, Now()), NmtAnswer::kTaken);
    RunTo(3010U);
    // Then it stays the master
    EXPECT_TRUE(manager.IsActive());
    static_cast<void>(Log());
    // When it resets itself
    EXPECT_EQ(nmt.Request(NmtCommand::kResetNode, NodeId{5U}, Now()), NmtAnswer::kTaken);
    RunTo(5161U);
    // Then it asks as anybody else: 3011 + 500, + 100, + 1 x 1500 + 5 x 10
    EXPECT_EQ(Log(), (Lines{"leads no more", "3011 initialising", "3511 073", "3611 072", "5161 071 01 05",
                            "event 4 1/5", "leads", "5161 705 00"}));
}

TEST_F(ManagerFlying, WhatIsTwiceSaidIsDoneOnce)
{
    Verifies(req::SRS_MGR_002);
    Use(NegotiationBy::kManager);
    manager.OnBus(false, Now()); // Before it has begun there is nothing to reset.
    manager.OnBus(true, Now());
    manager.Begin(Now());
    RunTo(3000U);
    ASSERT_TRUE(manager.IsActive());
    static_cast<void>(Log());
    const MasterClaim own{1U, NodeId{5U}};
    manager.Role().OnFlyingMaster(FlyingEvent::kMasterMode, own, Now());
    // Told something that ends no role, it is still the master
    manager.Role().OnFlyingMaster(FlyingEvent::kConfigurationError, own, Now());
    EXPECT_TRUE(manager.IsActive());
    EXPECT_EQ(Log(), (Lines{"event 4 1/5", "event 5 1/5"}));
    // And obeys nobody: whoever commands all, or this device
    Hear(0U, {0x02U, 5U});
    Hear(0U, {0x02U, 0U});
    EXPECT_NE(manager.OwnState(), cia301::NodeState::kStopped);
}

TEST_F(ManagerFlying, AsSlaveItObeysCommandsAndWatchesItsMaster)
{
    Verifies(req::SRS_MGR_002);
    Verifies(req::SRS_MGR_210);
    slaves[3].heartbeat = HeartbeatSetup{200U, 100U, Arming::kImmediately};
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(10U);
    Hear(0x071U, {0U, 3U}); // A master of a higher priority.
    RunTo(100U);
    ASSERT_FALSE(manager.IsActive());
    static_cast<void>(Log());
    EXPECT_FALSE(manager.Role().Boot(NodeId{9U}, Now()));
    EXPECT_FALSE(manager.Role().Resume(NodeId{9U}, Now()));
    for (const std::uint8_t command : {std::uint8_t{0x80U}, std::uint8_t{0U}, std::uint8_t{0x55U}})
    {
        Hear(0U, {command, 5U});
        EXPECT_EQ(manager.OwnState(), cia301::NodeState::kPreOperational);
    }
    Hear(0x706U, {5U}); // A node that was never heard.
    EXPECT_FALSE(manager.IsActive());
    // When the master is silent, then it negotiates
    RunTo(2500U);
    const Lines log = Log();
    EXPECT_NE(std::find(log.begin(), log.end(), "leads"), log.end());
}

TEST_F(ManagerFlying, BegunWhileItNegotiatesItGoesOn)
{
    Verifies(req::SRS_FLY_002);
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(600U);
    ASSERT_EQ(manager.Role().StartNegotiation(Now()), FlyingStart::kNotInitialising);
    manager.Begin(Now());
    RunTo(4000U);
    const Lines log = Log();
    EXPECT_NE(std::find(log.begin(), log.end(), "leads"), log.end());
    EXPECT_EQ(std::count_if(log.begin(), log.end(),
                            [](const std::string& line) { return line.find("refused") != std::string::npos; }),
              0);
}

TEST_F(ManagerFlying, WhatIsWrittenToASafetySlaveIsTheConcernOfTheMaster)
{
    Verifies(req::SRS_MGR_002);
    static constexpr ExpectedObject kExpected[]{{{0x1301U, 1U}, 1U, false}};
    static constexpr SafetyExpectation kExpectation{kExpected, 1U};
    // Given a manager that knows a safety slave, and is the slave of another one
    slaves[9].assignment = kInNetwork | kBootSlave;
    slaves[9].safety = &kExpectation;
    Manager other{ManagerParts{setup, *this, *this,
                               ManagerRoom{records.data(),
                                           watched.data(),
                                           gates.data(),
                                           {commands.data(), 8U},
                                           {safety.data(), 1U},
                                           lanes.All(),
                                           SdoTimes{500'000U, 3U}},
                               1000U}};
    FlyingMaster its{FlyingMasterParts{setup, times, options, *this, other.Role()}};
    other.Use(profile);
    other.Role().Use(its, NegotiationBy::kManager);
    times.priority = 1U;
    other.Begin(Now());
    const auto hear = [this, &other](const std::uint32_t identifier, const std::vector<std::uint8_t>& data)
    {
        CanFrame frame{identifier, FrameKind::kData, CanPortId::kFirst, static_cast<std::uint8_t>(data.size()), {}};
        std::copy(data.begin(), data.end(), frame.data);
        other.OnFrame(frame, Now());
        other.OnCycle(Now());
    };
    hear(0x071U, {0U, 3U});
    ASSERT_FALSE(other.IsActive());
    // When somebody writes its safety configuration, then nothing is presumed of it
    hear(0x589U, {0x60U, 0x01U, 0x13U, 0x01U, 0U, 0U, 0U, 0U});
    EXPECT_EQ(other.Gate().State(NodeId{9U}), GateState::kClosed);
    EXPECT_EQ(other.Table().Record(NodeId{9U}).signs, 0U);
}

} // namespace
} // namespace counterpoint::cia302
