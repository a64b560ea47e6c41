// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Full queues and frames at unusual moments.
#include "tests/canopen/cia302/flying_master/rig.hpp"
#include "verification/trace/ids/flying_master.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::cia302
{
namespace
{

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
