// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The small series; `counterpoint_elections` runs the large ones.
#include "verification/elections/failover_record.hpp"
#include "verification/elections/series.hpp"
#include "verification/trace/ids/flying_master.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace counterpoint::elections
{
namespace
{

class Elections : public ::testing::TestWithParam<Preset>
{
};

void ExpectGood(const Tally& tally, const std::uint64_t least_runs)
{
    EXPECT_EQ(tally.failures, 0U) << tally.first_failure;
    EXPECT_GE(tally.runs, least_runs);
}

TEST_P(Elections, TwoMastersOfAllPrioritiesAndOffsets)
{
    Verifies(req::SRS_FLY_023);
    // 9 priorities x 11 offsets, and each frame of each lost.
    const Tally tally = Combinations(GetParam(), 2U, OffsetsOfTheText(), Losses::kForEachToo);
    ExpectGood(tally, 900U);
    EXPECT_GT(tally.with_loss, 800U);
}

TEST_P(Elections, ThreeMastersOfAllPrioritiesAndOffsets)
{
    Verifies(req::SRS_FLY_023);
    // 27 priorities x 121 offsets, undisturbed.
    ExpectGood(Combinations(GetParam(), 3U, OffsetsOfTheText(), Losses::kNone), 3267U);
}

TEST_P(Elections, AFrameThatOneReceiverOfThreeOrFourMisses)
{
    Verifies(req::SRS_FLY_023);
    // 27 priorities x 4 offsets and 81 x 1, and each frame lost for all and for each of the masters.
    const Tally of_three = Combinations(GetParam(), 3U, {0, 10 * kMs}, Losses::kForEachToo);
    ExpectGood(of_three, 1000U);
    EXPECT_GT(of_three.with_loss, 900U);
    const Tally of_four = Combinations(GetParam(), 4U, {0}, Losses::kForEachToo);
    ExpectGood(of_four, 1000U);
    EXPECT_GT(of_four.with_loss, 900U);
}

TEST_P(Elections, SplitAndJoinedBusOfTwoAndThree)
{
    Verifies(req::SRS_FLY_024);
    ExpectGood(Splits(GetParam(), 2U, Losses::kForAll), 288U);
    ExpectGood(Splits(GetParam(), 3U, Losses::kNone), 2592U);
}

TEST_P(Elections, FailoverInTheComputedCycle)
{
    Verifies(req::SRS_FLY_026);
    const Tally tally = Failovers(GetParam());
    ExpectGood(tally, 3000U);
    EXPECT_GE(tally.late_us.begin()->first, 0);
    EXPECT_LE(tally.late_us.rbegin()->first, 1000);
}

TEST_P(Elections, FailoverInTheComputedCycleWhateverTheTimes)
{
    Verifies(req::SRS_FLY_026);
    const Tally tally = FailoversDrawn(GetParam(), 100U);
    ExpectGood(tally, 100U);
    EXPECT_GT(tally.failovers.size(), 50U);
    EXPECT_GE(tally.late_us.begin()->first, 0);
    EXPECT_LE(tally.late_us.rbegin()->first, 1000);
}

TEST_P(Elections, WhoeverMissesTheClaimFindsTheMasterThoughItsCycleIsShorterThanTheSlot)
{
    Verifies(req::SRS_FLY_008);
    Verifies(req::SRS_FLY_023);
    // Given master 1 with 2 s between its cyclic messages and master 2, which waits for 3020 ms
    std::vector<MasterPlan> masters = MastersOf({0U, 2U}, {0, 0});
    masters[0].times.detection_cycle = 2000U;
    for (std::uint32_t frame = 0U; frame < 12U; ++frame)
    {
        // When any one frame is lost
        World world(PlanOf(GetParam()));
        world.Begin(masters, Loss{frame, Loss::kEverybody});
        world.Run(20 * kSecond);
        // Then master 2 knows its master
        EXPECT_TRUE(world.IsAgreed()) << frame;
        EXPECT_EQ(world.Active(), 0U) << frame;
    }
}

TEST(Failovers, ALateOneIsRecordedAsAFailure)
{
    Verifies(req::SRS_FLY_026);
    const std::string path = ::testing::TempDir() + "counterpoint_failovers/late.json";
    Tally punctual{};
    punctual.runs = 1U;
    punctual.late_us[900] = 1U;
    punctual.failovers[3'120'000].Add(999);
    Tally late = punctual;
    late.failures = 1U;
    const auto holds = [&path](const std::vector<FailoverSeries>& all)
    {
        EXPECT_TRUE(WriteFailovers(path, all));
        std::ifstream file(path);
        return nlohmann::json::parse(file).at("requirements").at("SRS_FLY_026").get<bool>();
    };
    EXPECT_TRUE(holds({{"punctual", punctual}}));
    EXPECT_FALSE(holds({{"punctual", punctual}, {"late", late}}));
    EXPECT_FALSE(holds({{"none", Tally{}}}));
    EXPECT_FALSE(holds({}));
    EXPECT_FALSE(WriteFailovers("/dev/null/none.json", {}));
}

TEST_P(Elections, SeededOfUpTo127)
{
    Verifies(req::SRS_FLY_025);
    ExpectGood(Seeded(GetParam(), 1U, 0U, 100U, Crowd::kUpTo, 127U), 150U);
}

TEST_P(Elections, SeededOf127)
{
    Verifies(req::SRS_FLY_025);
    ExpectGood(Seeded(GetParam(), 2U, 0U, 50U, Crowd::kExactly, 127U), 75U);
}

TEST_P(Elections, ClocksThatDriftApartAndTurnOver)
{
    Verifies(req::SRS_FLY_023);
    Verifies(req::SRS_FLY_025);
    ExpectGood(Combinations(GetParam(), 2U, OffsetsOfTheText(), Losses::kForEachToo, GiveClocks), 900U);
    ExpectGood(Seeded(GetParam(), 3U, 0U, 50U, Crowd::kUpTo, 127U, GiveClocks), 75U);
}

TEST(ElectionsClocks, EachDeviceGoesByItsOwn)
{
    Verifies(req::SRS_FLY_026);
    // Given one master whose clock is 1 % fast, and one 1 % slow, both turning over after 1 s
    for (const Time ppm : {Time{0}, Time{10'000}, Time{-10'000}})
    {
        World world(PlanOf(Preset::kDefault));
        std::vector<MasterPlan> masters = MastersOf({2U}, {0});
        masters[0].clock_ppm = ppm;
        masters[0].clock_begin = 0xFFFF'FFFFU - 999'999U;
        world.Begin(masters, Loss{});
        world.Run(10 * kSecond);
        // Then 2 x (500 + 100) + 2 x 1500 + 10 ms of its own time have passed when it is master
        const Time computed = (Time{4'210'000} * kSecond) / (kSecond + ppm);
        EXPECT_TRUE(world.IsAgreed());
        EXPECT_GE(world.LastMaster(), computed);
        EXPECT_LE(world.LastMaster(), computed + (6 * kMs));
    }
}

TEST_P(Elections, TheFirstAndTheLastNodeIds)
{
    Verifies(req::SRS_FLY_023);
    ExpectGood(Combinations(GetParam(), 2U, OffsetsOfTheText(), Losses::kForEachToo, GiveFarNodes), 900U);
    ExpectGood(Combinations(GetParam(), 4U, {0, 10 * kMs}, Losses::kNone, GiveFarNodes), 648U);
}

TEST_P(Elections, OtherBehavioursAloneAndBesideEachOther)
{
    Verifies(req::SRS_FLY_016);
    Verifies(req::SRS_FLY_023);
    // 40 or 43 sets of masters x 9 priorities x 11 offsets and 32 instants of joining
    ExpectGood(Variants(GetParam(), Losses::kNone), 15'000U);
}

TEST_P(Elections, AMasterThatIsNotTheBestIsAFailure)
{
    Verifies(req::SRS_FLY_023);
    // Given a better master that cannot win, because its slot was changed to be the longer one, and gave up
    WorldPlan plan = PlanOf(GetParam());
    plan.options.max_restarts = 1U;
    World world(plan);
    std::vector<MasterPlan> masters = MastersOf({2U, 1U}, {0, 0});
    masters[1].times.priority_slot = 6000U;
    world.Begin(masters, Loss{});
    world.Run(60 * kSecond);
    EXPECT_TRUE(world.IsAgreed());
    EXPECT_FALSE(world.IsBest());
    Tally tally{};
    static_cast<void>(Judge(world, Trial{masters, Loss{}, 60 * kSecond, kSecond, kMs, kMs, 0}, tally));
    EXPECT_EQ(tally.failures, 1U);
    EXPECT_NE(tally.first_failure.find("not the best level"), std::string::npos) << tally.first_failure;
}

TEST_P(Elections, ALimitThatIsNotKeptIsAFailure)
{
    Verifies(req::SRS_FLY_023);
    // Given two masters and a limit of 1 ms, which no election keeps
    World world(PlanOf(GetParam()));
    const std::vector<MasterPlan> masters = MastersOf({1U, 1U}, {0, 0});
    world.Begin(masters, Loss{});
    Tally tally{};
    // When it is judged
    static_cast<void>(Judge(world, Trial{masters, Loss{}, 0, kMs, kMs, kMs, 0}, tally));
    // Then it has failed, and the failure names the masters
    EXPECT_EQ(tally.failures, 1U);
    EXPECT_NE(tally.first_failure.find("1/1/0 2/1/0"), std::string::npos);
}

TEST_P(Elections, WhoeverDoesNotKnowTheMasterOrComesLateIsAFailure)
{
    Verifies(req::SRS_FLY_023);
    // Given a master, and a second one that is switched on 100 ms before the limit of 20 s
    World world(PlanOf(GetParam()));
    std::vector<MasterPlan> masters = MastersOf({1U, 1U}, {0, (20 * kSecond) - (100 * kMs)});
    world.Begin(masters, Loss{});
    Tally unknown{};
    static_cast<void>(Judge(world, Trial{masters, Loss{}, 0, 20 * kSecond, kMs, kSecond, 0}, unknown));
    // Then there is one active master, and the other one does not know it
    EXPECT_EQ(unknown.failures, 1U);
    EXPECT_NE(unknown.first_failure.find("active 1, not agreed; "), std::string::npos) << unknown.first_failure;
    // Given one that comes behind the limit, then there is no rest
    masters[1].power_on = (20 * kSecond) + kMs;
    world.Begin(masters, Loss{});
    Tally restless{};
    static_cast<void>(Judge(world, Trial{masters, Loss{}, 0, 20 * kSecond, 10 * kSecond, kSecond, 0}, restless));
    EXPECT_EQ(restless.failures, 1U);
    EXPECT_NE(restless.first_failure.find("active 1, agreed; rest after 20"), std::string::npos)
        << restless.first_failure;
}

TEST_P(Elections, TwoMastersForTooLongAreAFailure)
{
    Verifies(req::SRS_FLY_023);
    Verifies(req::SRS_FLY_024);
    // Given two masters on a bus that was split
    const std::vector<MasterPlan> masters = MastersOf({1U, 1U}, {0, 0});
    for (const bool is_enough : {false, true})
    {
        World world(PlanOf(GetParam()));
        world.Begin(masters, Loss{});
        world.Run(9 * kSecond);
        world.Split({0U, 1U});
        world.Run(18 * kSecond);
        world.Forget();
        world.Join();
        // When 1 ms is the limit for both of them, or 10 s
        const Time two = is_enough ? 10 * kSecond : kMs;
        Tally tally{};
        static_cast<void>(Judge(world, Trial{masters, Loss{}, 18 * kSecond, 20 * kSecond, kSecond, two, 0}, tally));
        EXPECT_EQ(tally.failures, is_enough ? 0U : 1U) << tally.first_failure;
        EXPECT_GT(tally.longest_two, kMs);
    }
}

TEST(ElectionsClocks, AreUpTo200PpmSlowOrFastAndTurnOverWithin20Seconds)
{
    Verifies(req::SRS_FLY_023);
    Time least = 0;
    Time greatest = 0;
    for (std::uint64_t seed = 0U; seed < 2000U; ++seed)
    {
        std::vector<MasterPlan> masters = MastersOf({0U, 1U}, {0, 0});
        GiveClocks(masters, seed);
        for (const MasterPlan& plan : masters)
        {
            least = std::min(least, plan.clock_ppm);
            greatest = std::max(greatest, plan.clock_ppm);
            EXPECT_GT(plan.clock_begin, 0xFFFF'FFFFU - 20'000'000U);
        }
    }
    EXPECT_EQ(least, -200);
    EXPECT_EQ(greatest, 200);
}

/// Master 1 of level 2 waits 3010 ms, master 2 of level 1 with another 1F90h:04 waits 6020 ms: the worse one is first.
std::vector<MasterPlan> Misconfigured()
{
    std::vector<MasterPlan> masters = MastersOf({2U, 1U}, {0, 0});
    masters[1].times.priority_slot = 6000U;
    return masters;
}

TEST(ElectionsOfUnequalTimes, EndByDefault)
{
    Verifies(req::SRS_FLY_010);
    World world(PlanOf(Preset::kDefault));
    world.Begin(Misconfigured(), Loss{});
    // When time enough for many elections is over
    world.Run(60 * kSecond);
    // Then the better one has forced three times, told it once more and follows
    EXPECT_TRUE(world.IsAgreed());
    EXPECT_EQ(world.Active(), 0U);
    EXPECT_EQ(world.Found().configuration_errors, 4U);
    EXPECT_LT(world.Found().last_change, 20 * kSecond);
}

TEST(ElectionsOfUnequalTimes, OfManagersEndWhateverTheBoundAndTheOffset)
{
    Verifies(req::SRS_FLY_010);
    // Given two managers, each of which resets all whenever it became master
    for (std::uint8_t bound = 1U; bound <= 5U; ++bound)
    {
        for (const Time offset : {Time{0}, 100 * kMs, kSecond, 3 * kSecond, 5 * kSecond, 12 * kSecond})
        {
            WorldPlan plan = PlanOf(Preset::kDefault);
            plan.has_managers = true;
            plan.options.max_restarts = bound;
            std::vector<MasterPlan> masters = Misconfigured();
            masters[1].power_on = offset;
            World world(plan);
            world.Begin(masters, Loss{});
            world.Run(90 * kSecond);
            // Then the better one has given up, and the network is left alone
            EXPECT_TRUE(world.IsAgreed()) << int{bound} << " " << offset;
            EXPECT_EQ(world.Active(), 0U) << int{bound} << " " << offset;
            // It told so at the claim that made it give up, and behind the reset that followed
            EXPECT_LE(world.Found().configuration_errors, bound + 2U) << int{bound} << " " << offset;
            EXPECT_LT(world.Found().last_change, 50 * kSecond) << int{bound} << " " << offset;
            const std::uint32_t resets = world.Found().resets;
            world.Run(120 * kSecond);
            EXPECT_EQ(world.Found().resets, resets) << int{bound} << " " << offset;
        }
    }
}

TEST(ElectionsOfUnequalTimes, OfManagersThatLoseAFrameEndByDefault)
{
    Verifies(req::SRS_FLY_010);
    WorldPlan plan = PlanOf(Preset::kDefault);
    plan.has_managers = true;
    for (std::uint32_t frame = 0U; frame < 40U; ++frame)
    {
        World world(plan);
        world.Begin(Misconfigured(), Loss{frame, Loss::kEverybody});
        world.Run(60 * kSecond);
        EXPECT_TRUE(world.IsAgreed()) << frame;
        EXPECT_LE(world.Found().configuration_errors, 5U) << frame;
        EXPECT_LT(world.Found().last_change, 40 * kSecond) << frame;
    }
}

TEST(ElectionsOfManagers, TwoOfAllPrioritiesAndOffsetsAgree)
{
    Verifies(req::SRS_FLY_023);
    WorldPlan plan = PlanOf(Preset::kDefault);
    plan.has_managers = true;
    for (std::uint8_t first = 0U; first <= 2U; ++first)
    {
        for (std::uint8_t second = 0U; second <= 2U; ++second)
        {
            for (const Time offset : {Time{0}, 10 * kMs, 600 * kMs, 5 * kSecond, 10 * kSecond})
            {
                World world(plan);
                world.Begin(MastersOf({first, second}, {0, offset}), Loss{});
                world.Run(30 * kSecond);
                EXPECT_TRUE(world.IsAgreed()) << first << second << offset;
                EXPECT_TRUE(world.IsBest()) << first << second << offset;
                EXPECT_LT(world.Found().last_change, 22 * kSecond) << first << second << offset;
            }
        }
    }
}

TEST(ElectionsOfUnequalTimes, NeverEndAsInTheText)
{
    Verifies(req::SRS_FLY_010);
    World world(PlanOf(Preset::kSo1114));
    world.Begin(Misconfigured(), Loss{});
    world.Run(60 * kSecond);
    // One each 3.6 s after the first pass.
    EXPECT_GE(world.Found().configuration_errors, 15U);
    EXPECT_GT(world.Found().last_change, 55 * kSecond);
}

INSTANTIATE_TEST_SUITE_P(Presets, Elections, ::testing::Values(Preset::kDefault, Preset::kSo1114));

} // namespace
} // namespace counterpoint::elections
