// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What a flying master does once it is master or standby, in the default preset.
#include "tests/canopen/cia302/flying_master/rig.hpp"
#include "verification/trace/ids/flying_master.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::cia302
{
namespace
{

TEST(FlyingMasterRole, AnswersARaceAtOnceAndAQuestionInItsPlace)
{
    Verifies(req::SRS_FLY_004);
    FlyingRig rig(5U, 0U, DefaultFlyingMaster());
    EXPECT_EQ(rig.MakeMaster(), 1250U);
    rig.Hear(0x72U);
    EXPECT_EQ(rig.Log(), Lines{"1250 071 00 05"});
    // Given a question: half of 100 ms has 16 places, 3.125 ms apart; node 5 answers at 15.625 ms
    rig.Hear(0x73U);
    rig.RunTo(1265U);
    EXPECT_EQ(rig.Log(), Lines{});
    rig.RunTo(1266U);
    EXPECT_EQ(rig.Log(), Lines{"1266 071 00 05"});
    // Given the last place
    FlyingRig last(127U, 0U, DefaultFlyingMaster());
    EXPECT_EQ(last.MakeMaster(), 2470U);
    last.Hear(0x73U);
    last.RunTo(2516U);
    EXPECT_EQ(last.Log(), Lines{});
    last.RunTo(2517U);
    EXPECT_EQ(last.Log(), Lines{"2517 071 00 7F"});
}

TEST(FlyingMasterRole, CyclicMessageEachCycleTime)
{
    Verifies(req::SRS_FLY_152);
    FlyingRig rig(5U, 0U, DefaultFlyingMaster());
    EXPECT_EQ(rig.MakeMaster(), 1250U);
    rig.RunTo(9400U);
    EXPECT_EQ(rig.Log(), (Lines{"5300 076", "9350 076"}));
    FlyingRig never(5U, 0U, DefaultFlyingMaster());
    never.times.detection_cycle = 0U;
    static_cast<void>(never.MakeMaster());
    never.RunTo(100'000U);
    EXPECT_EQ(never.Log(), Lines{});
}

TEST(FlyingMasterRole, OfTwoMastersTheWorseOneYields)
{
    Verifies(req::SRS_FLY_011);
    struct Case
    {
        std::vector<std::uint8_t> claim;
        Lines log;
    };
    const Case cases[] = {
        {{0U, 9U}, {"2750 slave of 0/9"}}, // Lower level.
        {{1U, 4U}, {"2750 slave of 1/4"}}, // Equal level, lower node-ID.
        {{1U, 6U}, {"2750 071 01 05"}},    // Equal level, higher node-ID: told who stays.
        {{2U, 1U}, {"2750 071 01 05"}},    // Higher level.
    };
    for (const Case& one : cases)
    {
        FlyingRig rig(5U, 1U, DefaultFlyingMaster());
        EXPECT_EQ(rig.MakeMaster(), 2750U);
        rig.Hear(0x71U, one.claim);
        EXPECT_EQ(rig.Log(), one.log);
    }
}

TEST(FlyingMasterRole, CommandsOfOthersDoNotStopIt)
{
    Verifies(req::SRS_FLY_153);
    FlyingRig rig(5U, 0U, DefaultFlyingMaster());
    static_cast<void>(rig.MakeMaster());
    rig.Hear(0U, {0x82U, 0U});
    rig.Hear(0U, {0x81U, 5U});
    rig.Hear(0U, {0x02U, 0U});
    EXPECT_TRUE(rig.master.IsActiveMaster());
    EXPECT_EQ(rig.Log(), Lines{});
}

// t [ms]  500    500 + 1500 = 2000: silence since the claim      2500  2600  2600 + 1 x 1500 + 5 x 10
//         slave  lost, begins step 1 without a first pass        073   072   071
TEST(FlyingStandby, MasterThatDiesBeforeItsFirstHeartbeatIsReplaced)
{
    Verifies(req::SRS_FLY_012);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.MakeSlave({0U, 9U});
    rig.RunTo(4150U);
    EXPECT_EQ(rig.Log(), (Lines{"2500 073", "2600 072", "4150 071 01 05", "4150 master 1/5"}));
}

TEST(FlyingStandby, WithoutADelayTheQuestionLeavesInTheCycleOfTheLoss)
{
    Verifies(req::SRS_FLY_026);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.times.delay = 0U;
    rig.Start();
    rig.Hear(0x71U, {0U, 9U});
    rig.RunTo(3150U);
    // 1500 + 0 + 100 + 1 x 1500 + 5 x 10
    EXPECT_EQ(rig.Log(), (Lines{"0 slave of 0/9", "1500 073", "1600 072", "3150 071 01 05", "3150 master 1/5"}));
}

TEST(FlyingStandby, HeartbeatOfTheMasterAloneKeepsItSlave)
{
    Verifies(req::SRS_FLY_012);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.MakeSlave({0U, 9U});
    for (int i = 0; i < 5; ++i)
    {
        rig.RunTo(rig.now_ms + 1499U);
        rig.Hear(0x709U, {5U});
    }
    EXPECT_EQ(rig.master.State(), FlyingState::kSlave);
    // When another node's heartbeat comes, or an empty frame
    rig.RunTo(rig.now_ms + 1000U);
    rig.Hear(0x708U, {5U});
    rig.Hear(0x709U, {});
    rig.RunTo(rig.now_ms + 499U);
    EXPECT_EQ(rig.master.State(), FlyingState::kSlave);
    rig.RunTo(rig.now_ms + 1U);
    // Then the master is lost 1500 ms after its last heartbeat
    EXPECT_EQ(rig.master.State(), FlyingState::kDelay);
}

TEST(FlyingStandby, ConsumerTimeOfTheNetworkSetupGoesBeforeTheOption)
{
    Verifies(req::SRS_FLY_012);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.slaves[9].heartbeat.consumer_ms = 300U;
    rig.MakeSlave({0U, 9U});
    rig.RunTo(799U);
    EXPECT_EQ(rig.master.State(), FlyingState::kSlave);
    rig.RunTo(800U);
    EXPECT_EQ(rig.master.State(), FlyingState::kDelay);
}

TEST(FlyingStandby, QuietWhileTheMasterLives)
{
    Verifies(req::SRS_FLY_013);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.MakeSlave({1U, 9U});
    rig.Hear(0x72U);
    rig.Hear(0x73U);
    rig.Hear(0x76U);
    rig.Hear(0x71U, {1U, 10U}); // Not better than 1/9.
    rig.Hear(0x71U, {2U, 1U});
    rig.RunTo(700U);
    EXPECT_EQ(rig.Log(), Lines{});
    EXPECT_EQ(rig.master.Master().node.value, 9U);
    // When a better one claims
    rig.Hear(0x71U, {1U, 8U});
    EXPECT_EQ(rig.Log(), Lines{"700 slave of 1/8"});
}

TEST(FlyingStandby, AResetMakesItAskAgain)
{
    Verifies(req::SRS_FLY_002);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.MakeSlave({1U, 9U});
    rig.Hear(0U, {0x82U, 0U});
    rig.RunTo(1000U);
    EXPECT_EQ(rig.Log(), (Lines{"500 initialising", "1000 073"}));
}

TEST(FlyingNegotiation, AllWaitingBeginsWithTheRaceOfAnother)
{
    Verifies(req::SRS_FLY_008);
    // Given one in step 1 that hears 072h: it joins at once, and asks whether a master sent it
    FlyingRig early(5U, 0U, DefaultFlyingMaster());
    early.Start();
    early.RunTo(200U);
    early.Hear(0x72U);
    early.RunTo(250U);
    EXPECT_EQ(early.Log(), (Lines{"200 073", "250 071 00 05", "250 master 0/5"}));
    // Given one that waits since 4 ms (of half a slot of 5 ms): of the same race
    FlyingRig same(5U, 0U, DefaultFlyingMaster());
    same.Start();
    same.RunTo(1204U);
    same.Hear(0x72U);
    same.RunTo(1249U);
    EXPECT_FALSE(same.master.IsActiveMaster());
    same.RunTo(1250U);
    EXPECT_TRUE(same.master.IsActiveMaster());
    // Given one that waits since 5 ms: the waiting begins anew
    FlyingRig late(5U, 0U, DefaultFlyingMaster());
    late.Start();
    late.RunTo(1205U);
    late.Hear(0x72U);
    late.RunTo(1254U);
    EXPECT_FALSE(late.master.IsActiveMaster());
    late.RunTo(1255U);
    EXPECT_TRUE(late.master.IsActiveMaster());
}

TEST(FlyingNegotiation, WhoeverMissedTheClaimAsksAtTheNextRace)
{
    Verifies(req::SRS_FLY_008);
    for (const FlyingMasterOptions& options : {DefaultFlyingMaster(), So1114FlyingMaster()})
    {
        // Given a cyclic 072h that comes more often than the own slot lasts
        FlyingRig rig(5U, 1U, options);
        rig.Start();
        rig.RunTo(1200U);
        static_cast<void>(rig.Log());
        for (const std::uint32_t at : {1600U, 1700U, 2200U})
        {
            rig.RunTo(at);
            rig.Hear(0x72U);
        }
        rig.RunTo(2300U);
        EXPECT_EQ(rig.Log(), (Lines{"1600 073", "1700 073", "2200 073"}));
        // When the master answers
        rig.Hear(0x71U, {0U, 9U});
        EXPECT_EQ(rig.Log(), Lines{"2300 slave of 0/9"});
    }
}

TEST(FlyingNegotiation, AWorseMasterThatAnswersInARaceIsForcedAndNoConfigurationError)
{
    Verifies(req::SRS_FLY_008);
    Verifies(req::SRS_FLY_006);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.Start();
    rig.RunTo(1600U);
    static_cast<void>(rig.Log());
    // Given a full queue when it wants to ask
    rig.refuses = 2U;
    rig.Hear(0x72U);
    rig.RunTo(1602U);
    EXPECT_EQ(rig.Log(), Lines{"1602 073"});
    rig.Hear(0x71U, {2U, 9U});
    EXPECT_EQ(rig.Log(), (Lines{"1602 076", "1602 force"}));
}

TEST(FlyingNegotiation, InStepOneAWorseMasterIsLeftInPeaceAndABetterOneFollowed)
{
    Verifies(req::SRS_FLY_005);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.Start();
    rig.RunTo(200U);
    rig.Hear(0x71U, {2U, 4U});
    EXPECT_EQ(rig.Log(), Lines{});
    rig.Hear(0x71U, {1U, 7U});
    EXPECT_EQ(rig.Log(), Lines{"200 slave of 1/7"});
}

TEST(FlyingNegotiation, OwnNodeIdOfAnotherDeviceStopsIt)
{
    Verifies(req::SRS_FLY_017);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.Start();
    rig.RunTo(550U);
    rig.Hear(0x71U, {2U, 5U});
    rig.Hear(0x75U);
    rig.Hear(0x72U);
    rig.RunTo(20'000U);
    EXPECT_EQ(rig.Log(), (Lines{"500 073", "550 configuration error 2/5"}));
    EXPECT_EQ(rig.master.State(), FlyingState::kHalted);
    EXPECT_TRUE(rig.master.IsInitialising());
    // When it is reset
    rig.Hear(0U, {0x82U, 0U});
    EXPECT_EQ(rig.master.State(), FlyingState::kDelay);
    // Given an active master that hears its own node-ID
    FlyingRig active(5U, 0U, DefaultFlyingMaster());
    static_cast<void>(active.MakeMaster());
    active.Hear(0x71U, {0U, 5U});
    EXPECT_FALSE(active.master.IsActiveMaster());
}

TEST(FlyingNegotiation, WhoCouldBeMasterIsAskedAndAnswered)
{
    Verifies(req::SRS_FLY_018);
    FlyingRig rig(5U, 1U, DefaultFlyingMaster());
    rig.Hear(0x75U);
    EXPECT_EQ(rig.Log(), Lines{});
    rig.Start();
    rig.Hear(0x75U);
    EXPECT_EQ(rig.Log(), Lines{"0 074"});
    rig.refuses = 1U;
    rig.Hear(0x75U);
    EXPECT_EQ(rig.Log(), Lines{});
    rig.RunTo(1U);
    EXPECT_EQ(rig.Log(), Lines{"1 074"});
    // When it asks itself, and nobody was found yet
    EXPECT_TRUE(rig.master.FindCapable());
    EXPECT_FALSE(rig.master.HasFoundCapable());
    EXPECT_EQ(rig.Log(), Lines{"1 075"});
    rig.Hear(0x74U);
    EXPECT_TRUE(rig.master.HasFoundCapable());
    EXPECT_TRUE(rig.master.FindCapable());
    EXPECT_FALSE(rig.master.HasFoundCapable());
    EXPECT_EQ(rig.Log(), Lines{"1 075"});
    rig.Hear(0x74U);
    EXPECT_TRUE(rig.master.HasFoundCapable());
    rig.refuses = 1U;
    EXPECT_FALSE(rig.master.FindCapable());
    EXPECT_TRUE(rig.master.HasFoundCapable());
}

TEST(FlyingNegotiation, BusOffEndsEveryRoleWithoutAFrame)
{
    Verifies(req::SRS_FLY_019);
    FlyingRig rig(5U, 0U, DefaultFlyingMaster());
    static_cast<void>(rig.MakeMaster());
    rig.restarts_itself = false;
    rig.master.Reset(rig.Now());
    EXPECT_EQ(rig.Log(), Lines{"1250 initialising"});
    EXPECT_FALSE(rig.master.IsActiveMaster());
    EXPECT_EQ(rig.master.Start(rig.Now()), FlyingStart::kStarted);
    rig.RunTo(1850U);
    EXPECT_EQ(rig.Log(), (Lines{"1750 073", "1850 072"}));
}

// t [ms]  0      700  749         750        1F90h:02 = 700 ms, 1F90h:01 = 50 ms
//         Start  073  071 or not  82 00
TEST(FlyingNegotiation, DelayAndWaitForTheActiveMasterAreThoseOfItsObjects)
{
    Verifies(req::SRS_FLY_003);
    for (const bool is_answered : {false, true})
    {
        FlyingRig rig(5U, 1U, DefaultFlyingMaster());
        rig.times.delay = 700U;
        rig.times.timeout = 50U;
        rig.Start();
        rig.RunTo(699U);
        EXPECT_EQ(rig.Log(), Lines{});
        rig.RunTo(749U);
        EXPECT_EQ(rig.Log(), Lines{"700 073"});
        if (is_answered)
        {
            rig.Hear(0x71U, {0U, 9U});
        }
        rig.RunTo(750U);
        EXPECT_EQ(rig.Log(), is_answered ? Lines{"749 slave of 0/9"}
                                         : (Lines{"750 000 82 00", "750 power-on reset", "750 initialising"}));
    }
}

TEST(FlyingNegotiation, NextTellsWhenSomethingIsDue)
{
    Verifies(req::SRS_FLY_003);
    // Given one that runs each ms and one that sleeps until Next
    FlyingRig each(5U, 1U, DefaultFlyingMaster());
    FlyingRig sleeper(5U, 1U, DefaultFlyingMaster());
    each.Start();
    sleeper.Start();
    each.RunTo(12'000U);
    while (sleeper.now_ms < 12'000U)
    {
        ASSERT_TRUE(sleeper.master.Next().is_set);
        const std::uint32_t left_us = sleeper.master.Next().at.us - sleeper.Now().us;
        sleeper.now_ms += left_us / 1000U;
        if (sleeper.now_ms <= 12'000U)
        {
            sleeper.master.OnCycle(sleeper.Now());
        }
    }
    // Then both did the same
    EXPECT_EQ(each.Log(), sleeper.Log());
}

} // namespace
} // namespace counterpoint::cia302
