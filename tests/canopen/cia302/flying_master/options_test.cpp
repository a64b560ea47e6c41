// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Each variant of the known implementations: the same events, once as by default and once otherwise.
#include "canopen/cia302/flying_master/times.hpp"
#include "tests/canopen/cia302/flying_master/rig.hpp"
#include "verification/trace/ids/flying_master.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::cia302
{
namespace
{

using cia301::SdoAbort;

constexpr FlyingMasterOptions kDefault = DefaultFlyingMaster();
constexpr FlyingMasterOptions kSo1114 = So1114FlyingMaster();

TEST(FlyingPresets, DifferInFourThings)
{
    Verifies(req::SRS_FLY_015);
    EXPECT_EQ(kDefault.cyclic, CyclicMessage::kForce);
    EXPECT_EQ(kDefault.max_restarts, 3U);
    EXPECT_EQ(kDefault.watch, MasterWatch::kInstalled);
    EXPECT_EQ(kDefault.standby, StandbyReaction::kIgnores);
    EXPECT_EQ(kSo1114.cyclic, CyclicMessage::kNegotiation);
    EXPECT_EQ(kSo1114.max_restarts, 0U);
    EXPECT_EQ(kSo1114.watch, MasterWatch::kApplication);
    EXPECT_EQ(kSo1114.standby, StandbyReaction::kAsks);
    EXPECT_EQ(kDefault.on_force, kSo1114.on_force);
    EXPECT_EQ(kDefault.equal_level, kSo1114.equal_level);
    EXPECT_EQ(kDefault.on_loss, kSo1114.on_loss);
    EXPECT_EQ(kDefault.keeps_slot, kSo1114.keeps_slot);
    EXPECT_EQ(kDefault.ignores_claims, kSo1114.ignores_claims);
}

/// What an active master 0/5 sends from 1250 ms up to `ms` after `heard`.
Lines AsMaster(const FlyingMasterOptions& options, const std::uint32_t heard, const std::vector<std::uint8_t>& data,
               const std::uint32_t ms)
{
    FlyingRig rig(5U, 0U, options);
    EXPECT_EQ(rig.MakeMaster(), 1250U);
    rig.Hear(heard, data);
    rig.RunTo(ms);
    return rig.Log();
}

TEST(FlyingVariants, CyclicMessage)
{
    Verifies(req::SRS_FLY_016);
    FlyingMasterOptions options = kDefault;
    EXPECT_EQ(AsMaster(options, 0x77U, {}, 5300U), Lines{"5300 076"});
    options.cyclic = CyclicMessage::kNegotiation;
    EXPECT_EQ(AsMaster(options, 0x77U, {}, 5300U), Lines{"5300 072"});
}

TEST(FlyingVariants, ReactionOfTheActiveMasterToForce)
{
    Verifies(req::SRS_FLY_016);
    FlyingMasterOptions options = kDefault;
    EXPECT_EQ(AsMaster(options, 0x76U, {}, 1750U), (Lines{"1250 000 82 00", "1250 initialising", "1750 073"}));
    options.on_force = ForceReaction::kRace;
    EXPECT_EQ(AsMaster(options, 0x76U, {}, 1750U), (Lines{"1250 072", "1300 071 00 05", "1300 master 0/5"}));
    options.on_force = ForceReaction::kRestart;
    EXPECT_EQ(AsMaster(options, 0x76U, {}, 1750U), Lines{"1750 073"});
}

TEST(FlyingVariants, WithRestartEverybodyWhoNegotiatesRestarts)
{
    Verifies(req::SRS_FLY_016);
    FlyingMasterOptions options = kDefault;
    for (const bool restarts : {false, true})
    {
        options.on_force = restarts ? ForceReaction::kRestart : ForceReaction::kResetAll;
        FlyingRig rig(5U, 1U, options);
        rig.Start();
        rig.RunTo(400U);
        rig.Hear(0x76U);
        rig.RunTo(899U);
        EXPECT_EQ(rig.Log().empty(), restarts);
        rig.RunTo(900U);
        EXPECT_EQ(rig.Log().empty(), !restarts);
    }
}

TEST(FlyingVariants, WhoForcedTheNegotiationIsNoMoreInItsFirstPass)
{
    Verifies(req::SRS_FLY_480);
    FlyingMasterOptions options = kDefault;
    options.on_force = ForceReaction::kRestart;
    // Given a device that was just switched on, and a worse master that begins again without a reset
    FlyingRig rig(5U, 0U, options);
    rig.Start();
    rig.RunTo(540U);
    rig.Hear(0x71U, {1U, 7U});
    // When nobody answers in the pass behind its 076h, then it races and resets nobody
    rig.RunTo(1200U);
    EXPECT_EQ(rig.Log(),
              (Lines{"500 073", "540 076", "540 force", "1040 073", "1140 072", "1190 071 00 05", "1190 master 0/5"}));
}

TEST(FlyingVariants, WithRestartA076hOfAnotherEndsTheFirstPass)
{
    Verifies(req::SRS_FLY_480);
    FlyingMasterOptions options = kDefault;
    options.on_force = ForceReaction::kRestart;
    // Given a device that was just switched on, when it hears 076h while it negotiates
    FlyingRig rig(5U, 0U, options);
    rig.Start();
    rig.RunTo(400U);
    rig.Hear(0x76U);
    // Then it begins again, and races in that pass
    rig.RunTo(1060U);
    EXPECT_EQ(rig.Log(), (Lines{"900 073", "1000 072", "1050 071 00 05", "1050 master 0/5"}));
}

TEST(FlyingVariants, EqualLevel)
{
    Verifies(req::SRS_FLY_016);
    FlyingMasterOptions options = kDefault;
    options.equal_level = EqualLevel::kLowerNodeForces;
    struct Case
    {
        FlyingMasterOptions options;
        std::uint8_t other;
        Lines log;
    };
    const Case cases[] = {
        {kDefault, 9U, {"500 073", "540 slave of 1/9"}},
        {options, 9U, {"500 073", "540 076", "540 force"}},
        {options, 4U, {"500 073", "540 slave of 1/4"}},
    };
    for (const Case& one : cases)
    {
        FlyingRig rig(5U, 1U, one.options);
        rig.Start();
        rig.RunTo(540U);
        rig.Hear(0x71U, {1U, one.other});
        EXPECT_EQ(rig.Log(), one.log);
    }
}

/// What a standby 1/5 does up to 2600 ms, whose master 0/9 is lost at 2000 ms.
Lines AfterLoss(const LossReaction reaction)
{
    FlyingMasterOptions options = kDefault;
    options.on_loss = reaction;
    FlyingRig rig(5U, 1U, options);
    rig.MakeSlave({0U, 9U});
    rig.RunTo(2600U);
    return rig.Log();
}

TEST(FlyingVariants, ReactionToALostMaster)
{
    Verifies(req::SRS_FLY_016);
    EXPECT_EQ(AfterLoss(LossReaction::kRestart), (Lines{"2500 073", "2600 072"}));
    EXPECT_EQ(AfterLoss(LossReaction::kResetAll),
              (Lines{"2000 000 82 00", "2000 initialising", "2500 073", "2600 072"}));
    EXPECT_EQ(AfterLoss(LossReaction::kRace), Lines{"2000 072"});
}

/// When a standby, slave since 500 ms, takes its silent master for lost; 0: not within 10 s.
std::uint32_t LostAt(const MasterWatch watch, const std::uint16_t consumer_ms, const std::uint16_t producer_ms = 350U)
{
    FlyingMasterOptions options = kDefault;
    options.watch = watch;
    options.watch_ms = 800U;
    options.own_producer_ms = producer_ms;
    FlyingRig rig(5U, 1U, options);
    rig.slaves[9].heartbeat.consumer_ms = consumer_ms;
    rig.MakeSlave({0U, 9U});
    while ((rig.master.State() == FlyingState::kSlave) && (rig.now_ms < 10'000U))
    {
        rig.RunTo(rig.now_ms + 1U);
    }
    return (rig.master.State() == FlyingState::kSlave) ? 0U : rig.now_ms;
}

TEST(FlyingVariants, SourceOfTheSupervisionTime)
{
    Verifies(req::SRS_FLY_016);
    EXPECT_EQ(LostAt(MasterWatch::kInstalled, 600U), 1100U);
    EXPECT_EQ(LostAt(MasterWatch::kInstalled, 0U), 1300U); // watch_ms.
    EXPECT_EQ(LostAt(MasterWatch::kTwiceProducer, 600U), 1100U);
    EXPECT_EQ(LostAt(MasterWatch::kTwiceProducer, 0U), 1200U);     // 2 x 350 ms.
    EXPECT_EQ(LostAt(MasterWatch::kTwiceProducer, 0U, 0U), 1300U); // No heartbeat of its own: watch_ms.
    EXPECT_EQ(LostAt(MasterWatch::kApplication, 600U), 0U);
}

TEST(FlyingVariants, WithoutSupervisionOnlyTheApplicationsCallEndsTheSlave)
{
    Verifies(req::SRS_FLY_012);
    FlyingRig rig(5U, 1U, kSo1114);
    rig.MakeSlave({0U, 9U});
    rig.RunTo(60'000U);
    EXPECT_EQ(rig.master.State(), FlyingState::kSlave);
    rig.master.OnHeartbeatLost(NodeId{8U}, rig.Now());
    EXPECT_EQ(rig.master.State(), FlyingState::kSlave);
    rig.master.OnHeartbeatLost(NodeId{9U}, rig.Now());
    rig.RunTo(60'600U);
    EXPECT_EQ(rig.Log(), (Lines{"60500 073", "60600 072"}));
}

TEST(FlyingVariants, StateWhileNegotiating)
{
    Verifies(req::SRS_FLY_016);
    FlyingMasterOptions options = kDefault;
    for (const bool is_pre_operational : {false, true})
    {
        options.negotiates_pre_operational = is_pre_operational;
        FlyingRig rig(5U, 1U, options);
        EXPECT_TRUE(rig.master.IsInitialising());
        rig.Start();
        EXPECT_EQ(rig.master.IsInitialising(), !is_pre_operational);
        static_cast<void>(rig.MakeMaster());
        EXPECT_FALSE(rig.master.IsInitialising());
    }
}

TEST(FlyingVariants, RaceHeardByWhoeverNegotiates)
{
    Verifies(req::SRS_FLY_016);
    FlyingMasterOptions options = kDefault;
    for (const bool keeps_slot : {false, true})
    {
        options.keeps_slot = keeps_slot;
        FlyingRig rig(5U, 1U, options);
        rig.Start();
        rig.RunTo(2000U);
        rig.Hear(0x72U); // Its slot would end at 1200 + 1550 = 2750 ms.
        rig.RunTo(2750U);
        EXPECT_EQ(rig.master.IsActiveMaster(), keeps_slot);
        rig.RunTo(3550U);
        EXPECT_TRUE(rig.master.IsActiveMaster());
    }
}

/// What a standby 1/5 of 0/9 does from 600 ms up to 2200 ms after `heard` at 600 ms.
Lines AsStandby(const StandbyReaction reaction, const std::uint32_t heard)
{
    FlyingMasterOptions options = kDefault;
    options.standby = reaction;
    options.watch_ms = 60'000U;
    FlyingRig rig(5U, 1U, options);
    rig.MakeSlave({0U, 9U});
    rig.RunTo(600U);
    rig.Hear(heard);
    rig.RunTo(2150U);
    return rig.Log();
}

TEST(FlyingVariants, RaceAndForceHeardByAStandby)
{
    Verifies(req::SRS_FLY_016);
    Verifies(req::SRS_FLY_013);
    EXPECT_EQ(AsStandby(StandbyReaction::kIgnores, 0x72U), Lines{});
    EXPECT_EQ(AsStandby(StandbyReaction::kIgnores, 0x76U), Lines{});
    EXPECT_EQ(AsStandby(StandbyReaction::kAsks, 0x72U), (Lines{"600 073", "700 072"}));
    EXPECT_EQ(AsStandby(StandbyReaction::kAsks, 0x76U), (Lines{"600 073", "700 072"}));
    EXPECT_EQ(AsStandby(StandbyReaction::kRaces, 0x72U), (Lines{"2150 071 01 05", "2150 master 1/5"}));
    // 076h is for active masters: the cyclic one of the default preset begins no race
    EXPECT_EQ(AsStandby(StandbyReaction::kRaces, 0x76U), Lines{});
}

TEST(FlyingVariants, StandbyThatIsAnsweredStaysSlaveWithoutAnEvent)
{
    Verifies(req::SRS_FLY_013);
    FlyingRig rig(5U, 1U, kSo1114);
    rig.MakeSlave({0U, 9U});
    rig.Hear(0x72U);
    rig.RunTo(560U);
    rig.Hear(0x72U); // It has asked already.
    rig.Hear(0x71U, {0U, 9U});
    rig.RunTo(5000U);
    EXPECT_EQ(rig.Log(), Lines{"500 073"});
    EXPECT_EQ(rig.master.State(), FlyingState::kSlave);
}

TEST(FlyingVariants, StandbyThatIsAnsweredByAWorseMasterForces)
{
    Verifies(req::SRS_FLY_006);
    FlyingRig rig(5U, 1U, kSo1114);
    rig.MakeSlave({0U, 9U});
    rig.Hear(0x72U);
    rig.RunTo(560U);
    rig.Hear(0x71U, {2U, 3U});
    EXPECT_EQ(rig.Log(), (Lines{"500 073", "560 076", "560 force"}));
}

TEST(FlyingVariants, ClaimHeardByAnActiveMaster)
{
    Verifies(req::SRS_FLY_016);
    FlyingMasterOptions options = kDefault;
    EXPECT_EQ(AsMaster(options, 0x71U, {0U, 4U}, 1260U), Lines{"1250 slave of 0/4"});
    options.ignores_claims = true;
    EXPECT_EQ(AsMaster(options, 0x71U, {0U, 4U}, 1260U), Lines{});
}

TEST(FlyingVariants, ClaimAtEachForeignBootUp)
{
    Verifies(req::SRS_FLY_016);
    Verifies(req::SRS_FLY_004);
    FlyingMasterOptions options = kDefault;
    EXPECT_EQ(AsMaster(options, 0x708U, {0U}, 1260U), Lines{});
    options.answers_boot_up = true;
    // At the place of node 5, as after 073h: two masters would else answer in the same instant
    EXPECT_EQ(AsMaster(options, 0x708U, {0U}, 1270U), Lines{"1266 071 00 05"});
    EXPECT_EQ(AsMaster(options, 0x708U, {5U}, 1270U), Lines{}); // A heartbeat.
}

TEST(FlyingVariants, WhereRacesAreCyclicAJoiningDeviceAsksFirst)
{
    Verifies(req::SRS_FLY_008);
    FlyingRig rig(5U, 0U, kSo1114);
    rig.Start();
    rig.RunTo(200U);
    rig.Hear(0x72U);
    rig.RunTo(500U);
    EXPECT_EQ(rig.Log(), Lines{"500 073"});
}

TEST(FlyingObject, Defaults)
{
    Verifies(req::SRS_FLY_014);
    FlyingMasterTimes times = DefaultTimes(NodeId{5U});
    const FlyingMasterObject object(times);
    const std::uint32_t expected[7] = {6U, 100U, 500U, 2U, 1500U, 10U, 4050U};
    for (std::uint8_t sub = 0U; sub <= 6U; ++sub)
    {
        EXPECT_EQ(object.Read(sub).abort, SdoAbort::kNone);
        EXPECT_EQ(object.Read(sub).value, expected[sub]);
        EXPECT_EQ(object.Read(sub).size_bytes, (sub == 0U) ? 1U : 2U);
    }
    EXPECT_EQ(object.Read(7U).abort, SdoAbort::kSubUnknown);
    EXPECT_EQ(DefaultTimes(NodeId{127U}).detection_cycle, 5270U);
}

TEST(FlyingObject, RangeOfEachSubIndex)
{
    Verifies(req::SRS_FLY_014);
    FlyingMasterTimes times = DefaultTimes(NodeId{5U});
    FlyingMasterObject object(times);
    for (const std::uint8_t sub :
         {std::uint8_t{1U}, std::uint8_t{2U}, std::uint8_t{4U}, std::uint8_t{5U}, std::uint8_t{6U}})
    {
        EXPECT_EQ(object.Write(sub, 0U), SdoAbort::kNone);
        EXPECT_EQ(object.Read(sub).value, 0U);
        EXPECT_EQ(object.Write(sub, 65535U), SdoAbort::kNone);
        EXPECT_EQ(object.Read(sub).value, 65535U);
        EXPECT_EQ(object.Write(sub, 65536U), SdoAbort::kValueRange);
    }
    EXPECT_EQ(object.Write(3U, 0U), SdoAbort::kNone);
    EXPECT_EQ(object.Write(3U, 2U), SdoAbort::kNone);
    EXPECT_EQ(object.Write(3U, 3U), SdoAbort::kValueRange);
    EXPECT_EQ(object.Write(3U, 0x100U), SdoAbort::kValueRange);
    EXPECT_EQ(object.Read(3U).value, 2U);
    EXPECT_EQ(object.Write(0U, 6U), SdoAbort::kReadOnly);
    EXPECT_EQ(object.Write(7U, 1U), SdoAbort::kSubUnknown);
}

TEST(FlyingObject, BytesOfTheDictionaryAreLittleEndian)
{
    Verifies(req::SRS_FLY_014);
    FlyingMasterTimes times = DefaultTimes(NodeId{5U});
    FlyingMasterObject object(times);
    const std::uint8_t value[2] = {0x34U, 0x12U};
    EXPECT_EQ(object.OnWrite(ObjectAddress{0x1F90U, 4U}, cia301::Bytes{value, 2U}), SdoAbort::kNone);
    EXPECT_EQ(times.priority_slot, 0x1234U);
    std::uint8_t room[2] = {0U, 0U};
    EXPECT_EQ(object.OnRead(ObjectAddress{0x1F90U, 4U}, cia301::Room{room, 2U}).size_bytes, 2U);
    EXPECT_EQ(room[0], 0x34U);
    EXPECT_EQ(room[1], 0x12U);
}

TEST(FlyingObject, WaitingAndSlotRelation)
{
    Verifies(req::SRS_FLY_008);
    Verifies(req::SRS_FLY_002);
    FlyingMasterTimes times = DefaultTimes(NodeId{127U});
    EXPECT_EQ(times.WaitingUs(NodeId{127U}), 4'270'000U); // 2 x 1500 + 127 x 10 ms.
    times.priority = 0U;
    EXPECT_EQ(times.WaitingUs(NodeId{1U}), 10'000U);
    EXPECT_TRUE(IsUsable(times));
    times.priority_slot = 1270U;
    EXPECT_FALSE(IsUsable(times));
    times.priority_slot = 1271U;
    EXPECT_TRUE(IsUsable(times));
    // The greatest values that may be: no overflow of the counter of time.
    times = FlyingMasterTimes{65535U, 65535U, 2U, 65535U, 516U, 65535U};
    EXPECT_TRUE(IsUsable(times));
    EXPECT_EQ(times.WaitingUs(NodeId{127U}), 196'602'000U);
    times.priority = 3U; // There are three levels.
    EXPECT_FALSE(IsUsable(times));
}

TEST(FlyingOptions, OfTwoDeadlinesAtTheSameTimeNoneIsEarlier)
{
    Verifies(req::SRS_FLY_031);
    const FlyingDeadline none{false, Instant{0U}};
    const FlyingDeadline before{true, Instant{0xFFFF'FFFFU}};
    const FlyingDeadline behind{true, Instant{0U}};
    EXPECT_TRUE(IsEarlier(before, behind)); // The counter turned over between them.
    EXPECT_FALSE(IsEarlier(behind, before));
    EXPECT_FALSE(IsEarlier(before, before));
    EXPECT_TRUE(IsEarlier(before, none));
    EXPECT_FALSE(IsEarlier(none, before));
}

} // namespace
} // namespace counterpoint::cia302
