// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The ten steps of the text, one device against frames; default preset and 1F90h unless told.
#include "tests/canopen/cia302/flying_master/rig.hpp"
#include "verification/trace/ids/flying_master.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace counterpoint::cia302
{
namespace
{

// t [ms]  0      500  600             1100 1200             2720 = 1200 + 1 x 1500 + 2 x 10
//         Start  073  82 00 to all    073  072              071
TEST(FlyingSteps, AloneAfterPowerOnItResetsOnceAndBecomesMaster)
{
    Verifies(req::SRS_FLY_003);
    Verifies(req::SRS_FLY_007);
    Verifies(req::SRS_FLY_008);
    Verifies(req::SRS_FLY_009);
    FlyingRig rig(2U, 1U, DefaultFlyingMaster());
    rig.Start();
    rig.RunTo(2720U);
    EXPECT_EQ(rig.Log(), (Lines{"500 073", "600 000 82 00", "600 power-on reset", "600 initialising", "1100 073",
                                "1200 072", "2720 071 01 02", "2720 master 1/2"}));
    EXPECT_TRUE(rig.master.IsActiveMaster());
    EXPECT_EQ(rig.master.Master().level, 1U);
    EXPECT_EQ(rig.master.Master().node.value, 2U);
}

TEST(FlyingSteps, NothingHappensBeforeTheApplicationCallsStart)
{
    Verifies(req::SRS_FLY_002);
    FlyingRig rig(2U, 1U, DefaultFlyingMaster());
    // Given nobody who calls Start, and every service
    rig.RunTo(100U);
    for (std::uint32_t identifier = 0x72U; identifier <= 0x76U; ++identifier)
    {
        rig.Hear(identifier);
    }
    rig.Hear(0x71U, {0U, 9U});
    rig.RunTo(5000U);
    // Then it stays in INITIALISATION in silence
    EXPECT_EQ(rig.Log(), Lines{});
    EXPECT_EQ(rig.master.State(), FlyingState::kInitialising);
    EXPECT_TRUE(rig.master.IsInitialising());
    EXPECT_FALSE(rig.master.Next().is_set);
    // When local objects are written and Start is called
    rig.times.priority = 0U;
    rig.times.delay = 50U;
    EXPECT_EQ(rig.master.Start(rig.Now()), FlyingStart::kStarted);
    EXPECT_EQ(rig.master.Start(rig.Now()), FlyingStart::kNotInitialising);
    rig.RunTo(5050U);
    // Then it begins with these values
    EXPECT_EQ(rig.Log(), Lines{"5050 073"});
}

TEST(FlyingSteps, AfterAResetTheApplicationHasToCallStartAgain)
{
    Verifies(req::SRS_FLY_002);
    FlyingRig rig(2U, 1U, DefaultFlyingMaster());
    static_cast<void>(rig.master.Start(rig.Now()));
    rig.RunTo(600U);
    EXPECT_EQ(rig.Log(), (Lines{"500 073", "600 000 82 00", "600 power-on reset", "600 initialising"}));
    rig.RunTo(10'000U);
    EXPECT_EQ(rig.Log(), Lines{});
    EXPECT_EQ(rig.master.State(), FlyingState::kInitialising);
}

TEST(FlyingSteps, StartRefusesValuesThatCannotWork)
{
    Verifies(req::SRS_FLY_002);
    FlyingRig rig(2U, 3U, DefaultFlyingMaster());
    EXPECT_EQ(rig.master.Start(rig.Now()), FlyingStart::kPriority);
    rig.times.priority = 2U;
    rig.times.device_slot = 0U;
    EXPECT_EQ(rig.master.Start(rig.Now()), FlyingStart::kSlots);
    rig.times.device_slot = 10U;
    rig.times.priority_slot = 1270U; // 127 x 10: the last slot of a level is the first one of the next.
    EXPECT_EQ(rig.master.Start(rig.Now()), FlyingStart::kSlots);
    rig.times.priority_slot = 1271U;
    EXPECT_EQ(rig.master.Start(rig.Now()), FlyingStart::kStarted);
    FlyingRig none(0U, 1U, DefaultFlyingMaster());
    EXPECT_EQ(none.master.Start(none.Now()), FlyingStart::kNode);
    FlyingRig beyond(128U, 1U, DefaultFlyingMaster());
    EXPECT_EQ(beyond.master.Start(beyond.Now()), FlyingStart::kNode);
}

TEST(FlyingSteps, MasterOfHigherOrEqualPriorityIsFollowed)
{
    Verifies(req::SRS_FLY_005);
    for (const std::uint8_t level : {std::uint8_t{0U}, std::uint8_t{1U}})
    {
        FlyingRig rig(5U, 1U, DefaultFlyingMaster());
        rig.Start();
        rig.RunTo(540U);
        rig.Hear(0x71U, {level, 9U});
        EXPECT_EQ(rig.Log(), (Lines{"500 073", "540 slave of " + std::to_string(level) + "/9"}));
        EXPECT_EQ(rig.master.State(), FlyingState::kSlave);
        EXPECT_EQ(rig.master.Master().node.value, 9U);
        EXPECT_FALSE(rig.master.IsInitialising());
    }
}

// t [ms]  500  540              540        1040 1140 (no power-on reset any more: the master resets all)
//         073  071 of level 2   076        073  ...
TEST(FlyingSteps, MasterOfLowerPriorityIsForcedToNegotiate)
{
    Verifies(req::SRS_FLY_006);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.Start();
    rig.RunTo(540U);
    rig.Hear(0x71U, {2U, 9U});
    EXPECT_EQ(rig.Log(), (Lines{"500 073", "540 076", "540 force"}));
    // When the master resets all
    rig.RunTo(541U);
    rig.Hear(0U, {0x82U, 0U});
    rig.RunTo(541U + 600U + 1550U);
    // Then both negotiate anew, and nobody resets a second time
    EXPECT_EQ(rig.Log(), (Lines{"541 initialising", "1041 073", "1141 072", "2691 071 01 05", "2691 master 1/5"}));
}

TEST(FlyingSteps, ActiveMasterThatIsForcedResetsAllAndBeginsAgain)
{
    Verifies(req::SRS_FLY_006);
    FlyingRig rig(5U, 0U, DefaultFlyingMaster());
    EXPECT_EQ(rig.MakeMaster(), 1250U);
    rig.Hear(0x76U);
    EXPECT_EQ(rig.Log(), (Lines{"1250 000 82 00", "1250 initialising"}));
    EXPECT_FALSE(rig.master.IsActiveMaster());
    rig.RunTo(1900U);
    EXPECT_EQ(rig.Log(), (Lines{"1750 073", "1850 072", "1900 071 00 05", "1900 master 0/5"}));
}

TEST(FlyingSteps, AResetByOthersEndsTheFirstPass)
{
    Verifies(req::SRS_FLY_007);
    for (const std::uint8_t command : {std::uint8_t{0x81U}, std::uint8_t{0x82U}})
    {
        for (const std::uint8_t node : {std::uint8_t{0U}, std::uint8_t{5U}})
        {
            FlyingRig rig(5U, 0U, DefaultFlyingMaster());
            rig.Start();
            rig.RunTo(300U);
            rig.Hear(0U, {command, node});
            rig.RunTo(900U);
            EXPECT_EQ(rig.Log(), (Lines{"300 initialising", "800 073", "900 072"}));
        }
    }
}

TEST(FlyingSteps, AResetBeforeStartEndsTheFirstPassToo)
{
    Verifies(req::SRS_FLY_007);
    FlyingRig rig(5U, 0U, DefaultFlyingMaster());
    rig.Hear(0U, {0x82U, 0U});
    rig.Start();
    rig.RunTo(600U);
    EXPECT_EQ(rig.Log(), (Lines{"500 073", "600 072"}));
}

TEST(FlyingSteps, CommandsForOthersAndOtherCommandsAreIgnored)
{
    Verifies(req::SRS_FLY_007);
    FlyingRig rig(5U, 0U, DefaultFlyingMaster());
    rig.Start();
    rig.RunTo(300U);
    rig.Hear(0U, {0x82U, 6U});
    rig.Hear(0U, {0x80U, 0U});
    rig.Hear(0U, {0x01U, 0U});
    rig.Hear(0U, {0x82U});
    rig.Hear(0U, {0x82U, 0U, 0U});
    rig.RunTo(600U);
    EXPECT_EQ(rig.Log(), (Lines{"500 073", "600 000 82 00", "600 power-on reset", "600 initialising"}));
}

TEST(FlyingSteps, WhoeverWasFirstInTheRaceIsFollowed)
{
    Verifies(req::SRS_FLY_005);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.Start();
    rig.RunTo(1300U);
    static_cast<void>(rig.Log());
    rig.Hear(0x71U, {1U, 4U});
    EXPECT_EQ(rig.Log(), Lines{"1300 slave of 1/4"});
}

TEST(FlyingSteps, WorseOneThatWinsTheRaceIsAConfigurationError)
{
    Verifies(req::SRS_FLY_010);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.Start();
    rig.RunTo(1300U);
    static_cast<void>(rig.Log());
    rig.Hear(0x71U, {2U, 4U});
    EXPECT_EQ(rig.Log(), (Lines{"1300 configuration error 2/4", "1300 076"}));
    rig.RunTo(1900U);
    EXPECT_EQ(rig.Log(), (Lines{"1800 073", "1900 072"}));
}

/// A master of level 2 that is deaf to 076h: all there is in the way of an endless loop.
std::size_t ForcesOf(const FlyingMasterOptions& options, FlyingState& end)
{
    FlyingRig rig(5U, 1U, options);
    rig.Start();
    std::size_t forces = 0U;
    for (int i = 0; i < 20; ++i)
    {
        rig.RunTo(rig.now_ms + 550U);
        rig.Hear(0x71U, {2U, 4U});
        for (const std::string& line : rig.Log())
        {
            forces += (line.find(" 076") != std::string::npos) ? 1U : 0U;
        }
    }
    end = rig.master.State();
    return forces;
}

TEST(FlyingSteps, RestartsAreBoundedByDefaultAndEndlessAsInTheText)
{
    Verifies(req::SRS_FLY_010);
    FlyingState end = FlyingState::kInvalid;
    EXPECT_EQ(ForcesOf(DefaultFlyingMaster(), end), 3U);
    EXPECT_EQ(end, FlyingState::kSlave);
    EXPECT_EQ(ForcesOf(So1114FlyingMaster(), end), 20U);
    EXPECT_EQ(end, FlyingState::kDelay);
}

/// 076h of a device of level 1 beside a master of level 2 that wins each race and resets all 100 ms later.
std::size_t ForcesBesideResets(const std::uint8_t reset, FlyingRig& rig)
{
    rig.Start();
    std::size_t forces = 0U;
    for (int i = 0; i < 20; ++i)
    {
        rig.RunTo(rig.now_ms + 1300U);
        rig.Hear(0x71U, {2U, 4U});
        rig.RunTo(rig.now_ms + 100U);
        rig.Hear(0U, {reset, 0U});
        for (const std::string& line : rig.Log())
        {
            forces += (line.find(" 076") != std::string::npos) ? 1U : 0U;
        }
    }
    return forces;
}

TEST(FlyingSteps, AResetOfWhoeverDoesNotClearTheCountOfRestarts)
{
    Verifies(req::SRS_FLY_010);
    for (const std::uint8_t reset : {std::uint8_t{129U}, std::uint8_t{130U}})
    {
        FlyingRig rig(5U, 1U, DefaultFlyingMaster());
        EXPECT_EQ(ForcesBesideResets(reset, rig), 3U);
    }
    FlyingRig endless(5U, 1U, So1114FlyingMaster());
    EXPECT_EQ(ForcesBesideResets(130U, endless), 20U);
}

TEST(FlyingSteps, ARoleThatDoesNotLastDoesNotClearTheCountOfRestarts)
{
    Verifies(req::SRS_FLY_010);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.Start();
    rig.RunTo(1300U);
    rig.Hear(0x71U, {2U, 4U});
    EXPECT_EQ(rig.master.Restarts(), 1U);
    // A better master is accepted, and lost; the race is won, and the device itself is reset
    rig.RunTo(1900U);
    rig.Hear(0x71U, {0U, 9U});
    EXPECT_EQ(rig.master.State(), FlyingState::kSlave);
    rig.RunTo(4000U);
    EXPECT_EQ(rig.master.State(), FlyingState::kRace);
    EXPECT_EQ(rig.master.Restarts(), 1U);
    rig.RunTo(6000U);
    EXPECT_TRUE(rig.master.IsActiveMaster());
    rig.master.Reset(rig.Now());
    EXPECT_EQ(rig.master.Restarts(), 1U);
}

TEST(FlyingSteps, ARoleThatLastsOneNegotiationClearsTheCountOfRestarts)
{
    Verifies(req::SRS_FLY_010);
    for (const bool is_master : {false, true})
    {
        FlyingRig rig(5U, 1U, DefaultFlyingMaster());
        rig.options.watch = MasterWatch::kApplication;
        rig.Start();
        rig.RunTo(1300U);
        rig.Hear(0x71U, {2U, 4U});
        EXPECT_EQ(rig.master.Restarts(), 1U);
        // 073h at 1800 ms, 072h at 1900 ms; the own slot is 1500 + 5 x 10 ms behind it
        rig.RunTo(3450U);
        EXPECT_EQ(rig.master.IsActiveMaster(), true);
        if (!is_master)
        {
            rig.Hear(0x71U, {0U, 9U});
        }
        // 500 + 100 + 2 x 1500 + 127 x 10 ms
        rig.RunTo(3450U + 4869U);
        EXPECT_EQ(rig.master.Restarts(), 1U);
        rig.RunTo(3450U + 4870U);
        EXPECT_EQ(rig.master.Restarts(), 0U);
        EXPECT_EQ(rig.master.IsActiveMaster(), is_master);
    }
}

TEST(FlyingSteps, WhoeverGivesUpTellsItInTheDetectionToo)
{
    Verifies(req::SRS_FLY_010);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.Start();
    for (int i = 0; i < 3; ++i)
    {
        rig.RunTo(rig.now_ms + 550U);
        rig.Hear(0x71U, {2U, 4U});
    }
    rig.RunTo(rig.now_ms + 550U);
    static_cast<void>(rig.Log());
    rig.Hear(0x71U, {2U, 4U});
    EXPECT_EQ(rig.Log(), (Lines{"2200 configuration error 2/4", "2200 slave of 2/4"}));
}

TEST(FlyingSteps, RefusedFramesAreRepeatedAndTheirTimeBeginsWhenTaken)
{
    Verifies(req::SRS_FLY_020);
    FlyingRig rig(1U, 0U, DefaultFlyingMaster());
    rig.Start();
    rig.refuses = 7U;
    rig.RunTo(507U);
    EXPECT_EQ(rig.Log(), Lines{"507 073"});
    rig.refuses = 3U;
    rig.RunTo(610U);
    EXPECT_EQ(rig.Log(), (Lines{"610 000 82 00", "610 power-on reset", "610 initialising"}));
    rig.RunTo(1200U);
    rig.refuses = 2U;
    rig.RunTo(1212U);
    EXPECT_EQ(rig.Log(), (Lines{"1110 073", "1212 072"}));
    rig.RunTo(1221U);
    rig.refuses = 1U;
    rig.RunTo(1223U);
    EXPECT_EQ(rig.Log(), (Lines{"1223 071 00 01", "1223 master 0/1"}));
}

TEST(FlyingSteps, OtherLengthsKindsAndNodesAreIgnored)
{
    Verifies(req::SRS_FLY_001);
    FlyingRig rig(5U, 0U, DefaultFlyingMaster());
    EXPECT_EQ(rig.MakeMaster(), 1250U);
    for (std::uint32_t identifier = 0x72U; identifier <= 0x76U; ++identifier)
    {
        rig.Hear(identifier, {0U});
    }
    rig.Hear(0x71U, {0U});
    rig.Hear(0x71U, {0U, 1U, 0U});
    rig.Hear(0x71U, {0U, 0U});
    rig.Hear(0x71U, {0U, 128U});
    rig.Hear(0x77U);
    rig.Hear(0x70U);
    CanFrame remote{0x76U, FrameKind::kRemote, CanPortId::kFirst, 0U, {}};
    rig.master.OnFrame(remote, rig.Now());
    rig.RunTo(1500U);
    EXPECT_EQ(rig.Log(), Lines{});
    EXPECT_TRUE(rig.master.IsActiveMaster());
}

TEST(FlyingSteps, NothingButServicesAndResetsIsEverSent)
{
    Verifies(req::SRS_FLY_021);
    const std::set<std::string> allowed{"071 01 05", "072", "073", "074", "075", "076", "000 82 00"};
    for (const FlyingMasterOptions& options : {DefaultFlyingMaster(), So1114FlyingMaster()})
    {
        // Given every way to become master, to lose it and to be slave, and to lose a master
        FlyingRig rig(5U, 1U, options);
        static_cast<void>(rig.MakeMaster());
        for (int i = 0; i < 50; ++i)
        {
            rig.Hear(0x71U + static_cast<std::uint32_t>(i % 6),
                     (i % 6 == 0) ? std::vector<std::uint8_t>{2U, 7U} : std::vector<std::uint8_t>{});
            rig.RunTo(rig.now_ms + 700U);
        }
        EXPECT_TRUE(rig.master.FindCapable());
        rig.Hear(0x71U, {0U, 9U});
        rig.RunTo(rig.now_ms + 700U);
        rig.master.OnHeartbeatLost(NodeId{9U}, rig.Now());
        rig.RunTo(rig.now_ms + 10'000U);
        EXPECT_TRUE(rig.master.IsActiveMaster());
        // Then no frame but 071h to 076h and reset communication left: what is told has a small letter in front
        std::set<std::string> sent;
        for (const std::string& line : rig.Log())
        {
            const std::string what = line.substr(line.find(' ') + 1U);
            if ((what[0] < 'a') || (what[0] > 'z'))
            {
                sent.insert(what);
                EXPECT_EQ(allowed.count(what), 1U) << line;
            }
        }
        EXPECT_EQ(sent.size(), allowed.size());
    }
}

TEST(FlyingFullQueue, MasterRepeatsItsAnswerAndItsCyclicMessage)
{
    Verifies(req::SRS_FLY_020);
    FlyingRig rig(5U, 0U, DefaultFlyingMaster());
    EXPECT_EQ(rig.MakeMaster(), 1250U);
    rig.refuses = 3U;
    rig.Hear(0x72U);
    rig.RunTo(1260U);
    EXPECT_EQ(rig.Log(), Lines{"1253 071 00 05"});
    rig.RunTo(5299U);
    rig.refuses = 2U;
    rig.RunTo(9352U);
    EXPECT_EQ(rig.Log(), (Lines{"5302 076", "9352 076"}));
}

TEST(FlyingFullQueue, StandbyRepeatsItsQuestion)
{
    Verifies(req::SRS_FLY_020);
    FlyingRig rig(5U, 1U, So1114FlyingMaster());
    rig.MakeSlave({0U, 9U});
    rig.refuses = 3U;
    rig.Hear(0x72U);
    rig.RunTo(603U);
    EXPECT_EQ(rig.Log(), (Lines{"503 073", "603 072"}));
}

TEST(FlyingFullQueue, AForceThatWaitsIsSentWhateverIsHeardMeanwhile)
{
    Verifies(req::SRS_FLY_020);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.Start();
    rig.RunTo(540U);
    rig.refuses = 4U;
    rig.Hear(0x71U, {2U, 9U});
    EXPECT_EQ(rig.master.State(), FlyingState::kForcing);
    rig.Hear(0x71U, {0U, 7U});
    rig.Hear(0x72U);
    rig.Hear(0x76U);
    rig.RunTo(545U);
    EXPECT_EQ(rig.Log(), (Lines{"500 073", "544 076", "544 force"}));
}

TEST(FlyingFullQueue, AResetThatWaitsEndsTheRoleAtOnce)
{
    Verifies(req::SRS_FLY_020);
    FlyingRig rig(5U, 0U, DefaultFlyingMaster());
    EXPECT_EQ(rig.MakeMaster(), 1250U);
    rig.refuses = 3U;
    rig.Hear(0x76U);
    EXPECT_EQ(rig.master.State(), FlyingState::kResetting);
    EXPECT_FALSE(rig.master.IsActiveMaster());
    rig.RunTo(1253U);
    EXPECT_EQ(rig.Log(), (Lines{"1253 000 82 00", "1253 initialising"}));
}

TEST(FlyingFullQueue, AnswerToWhoCouldBeMasterWaits)
{
    Verifies(req::SRS_FLY_018);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.Start();
    rig.refuses = 3U;
    rig.Hear(0x75U);
    rig.RunTo(10U);
    EXPECT_EQ(rig.Log(), Lines{"3 074"});
}

TEST(FlyingMoments, NextIsTheEarlierOfAnswerAndCycle)
{
    Verifies(req::SRS_FLY_004);
    FlyingRig rig(5U, 0U, DefaultFlyingMaster());
    EXPECT_EQ(rig.MakeMaster(), 1250U);
    rig.Hear(0x73U);
    EXPECT_EQ(rig.master.Next().at.us - rig.Now().us, 15'625U);
    // Then a second question changes nothing
    rig.RunTo(1260U);
    rig.Hear(0x73U);
    EXPECT_EQ(rig.master.Next().at.us - rig.Now().us, 5'625U);
    rig.RunTo(1270U);
    EXPECT_EQ(rig.Log(), Lines{"1266 071 00 05"});
    EXPECT_EQ(rig.master.Next().at.us - rig.Now().us, 4'030'000U);
    // Given a question just before the cycle, the cycle is the earlier one
    rig.RunTo(5299U);
    rig.Hear(0x73U);
    EXPECT_EQ(rig.master.Next().at.us - rig.Now().us, 1'000U);
    // Given no cycle at all
    FlyingRig never(5U, 0U, DefaultFlyingMaster());
    never.times.detection_cycle = 0U;
    EXPECT_EQ(never.MakeMaster(), 1250U);
    EXPECT_FALSE(never.master.Next().is_set);
    never.Hear(0x73U);
    EXPECT_EQ(never.master.Next().at.us - never.Now().us, 15'625U);
}

TEST(FlyingMoments, RaceThatBeginsWhileTheAnswerIsWaitedFor)
{
    Verifies(req::SRS_FLY_008);
    FlyingRig rig(5U, 0U, DefaultFlyingMaster());
    rig.Start();
    rig.RunTo(550U);
    rig.Hear(0x72U);
    rig.RunTo(600U);
    EXPECT_EQ(rig.Log(), (Lines{"500 073", "600 071 00 05", "600 master 0/5"}));
}

TEST(FlyingMoments, ForceHeardInDetectionAndRace)
{
    Verifies(req::SRS_FLY_016);
    FlyingMasterOptions options = DefaultFlyingMaster();
    for (const bool restarts : {false, true})
    {
        options.on_force = restarts ? ForceReaction::kRestart : ForceReaction::kResetAll;
        for (const std::uint32_t at : {550U, 1300U})
        {
            FlyingRig rig(5U, 1U, options);
            rig.Start();
            rig.RunTo(at);
            const FlyingState before = rig.master.State();
            rig.Hear(0x76U);
            EXPECT_EQ(rig.master.State(), restarts ? FlyingState::kDelay : before);
        }
    }
}

TEST(FlyingMoments, EqualLevelDoesNotPreEmptInTheRace)
{
    Verifies(req::SRS_FLY_016);
    FlyingMasterOptions options = DefaultFlyingMaster();
    options.equal_level = EqualLevel::kLowerNodeForces;
    FlyingRig rig(5U, 1U, options);
    rig.Start();
    rig.RunTo(1300U);
    static_cast<void>(rig.Log());
    rig.Hear(0x71U, {1U, 9U});
    EXPECT_EQ(rig.Log(), Lines{"1300 slave of 1/9"});
}

TEST(FlyingMoments, WithoutSupervisionAnyMasterOfItsLevelIsFollowed)
{
    Verifies(req::SRS_FLY_013);
    FlyingRig rig(5U, 1U, So1114FlyingMaster());
    rig.MakeSlave({0U, 9U});
    rig.Hear(0x71U, {2U, 3U});
    EXPECT_EQ(rig.Log(), Lines{});
    rig.Hear(0x71U, {1U, 3U});
    EXPECT_EQ(rig.Log(), Lines{"500 slave of 1/3"});
}

TEST(FlyingMoments, AWatchedMasterOfAnotherIsNoAnswer)
{
    Verifies(req::SRS_FLY_013);
    FlyingMasterOptions options = DefaultFlyingMaster();
    options.standby = StandbyReaction::kAsks;
    FlyingRig rig(5U, 1U, options);
    rig.MakeSlave({0U, 9U});
    rig.Hear(0x76U);
    rig.RunTo(510U);
    rig.Hear(0x71U, {2U, 3U});
    EXPECT_EQ(rig.Log(), Lines{"500 073"});
    EXPECT_EQ(rig.master.Master().node.value, 9U);
}

TEST(FlyingMoments, LostHeartbeatsOfNoInterest)
{
    Verifies(req::SRS_FLY_012);
    FlyingRig rig(5U, 0U, DefaultFlyingMaster());
    static_cast<void>(rig.MakeMaster());
    rig.master.OnHeartbeatLost(NodeId{5U}, rig.Now());
    EXPECT_TRUE(rig.master.IsActiveMaster());
    rig.Hear(0x780U, {0U});
    EXPECT_EQ(rig.Log(), Lines{});
}

TEST(FlyingMoments, RestartsAreCountedUpTo255)
{
    Verifies(req::SRS_FLY_010);
    FlyingRig rig(5U, 1U, So1114FlyingMaster());
    rig.Start();
    for (int i = 0; i < 300; ++i)
    {
        rig.RunTo(rig.now_ms + 500U);
        rig.Hear(0x71U, {2U, 4U});
    }
    EXPECT_EQ(rig.master.Restarts(), 255U);
}

} // namespace
} // namespace counterpoint::cia302
