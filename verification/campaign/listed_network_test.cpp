// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the judge of a network with managers lists and does not call wrong, each with its near-miss.
#include "verification/campaign/judged_network.hpp"

#include "verification/campaign/managed/frame_fault.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace counterpoint::campaign::test
{
namespace
{
using ListedNetworkTest = JudgedNetworkTest;

TEST_F(ListedNetworkTest, SlaveThatRunsByACommandOfNoManagerIsListed)
{
    Verifies(req::SRS_CMG_073);
    const managed::Plan plan = managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\n"));
    JudgedNetwork sound(plan);
    sound.RunTo(200);
    const managed::Reference reference = sound.watch.TakeReference();
    // Given a relay that its manager starts at 30 ms
    for (const bool is_of_a_manager : {false, true})
    {
        JudgedNetwork network(plan);
        network.RunTo(10);
        network.watch.Compare(reference, 10'000'000);
        // When it becomes OPERATIONAL before, by a command of somebody else or by one of the manager
        if (is_of_a_manager)
        {
            network.Commands(1U, 33U);
        }
        network.stage.Somebody().Send(CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 33U}});
        network.RunTo(15);
        ASSERT_EQ(network.stage.World().At(network.Relay().index).State(), cia301::NodeState::kOperational);
        // Then the former alone is listed, and nobody did anything wrong by it
        EXPECT_EQ(network.watch.Listed(), is_of_a_manager ? managed::Limit::kNothing : managed::Limit::kForeignStart);
        EXPECT_EQ(network.watch.Found(), is_of_a_manager ? managed::Wrong::kUnverified : managed::Wrong::kNothing);
    }
}

// t [ms]   30 the relay is started   100 1300h changes   150 it is looked at
TEST_F(ListedNetworkTest, GfcParameterThatIsWrittenBehindTheStartIsListed)
{
    Verifies(req::SRS_CMG_073);
    const managed::Plan plan = managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\n"));
    JudgedNetwork sound(plan);
    sound.RunTo(200);
    const managed::Reference reference = sound.watch.TakeReference();
    // Given a fault behind the start, or one before it
    for (const std::int64_t fault_ms : {std::int64_t{100}, std::int64_t{20}})
    {
        JudgedNetwork network(plan);
        network.RunTo(fault_ms);
        network.watch.Compare(reference, fault_ms * 1'000'000);
        network.RunTo(100);
        const std::uint32_t before = network.stage.ValueIn(network.Relay(), {0x1300U, 0U}).value_or(9U);
        ASSERT_LE(before, 1U);
        // When 1300h of the relay that runs is another one
        network.stage.World().At(network.Relay().index).Firmware().Store({0x1300U, 0U}, before ^ 1U);
        network.RunTo(149);
        EXPECT_EQ(network.watch.Listed(), managed::Limit::kNothing);
        network.RunTo(150);
        // Then it is listed where it was started before the fault
        EXPECT_EQ(network.watch.Listed(), (fault_ms == 100) ? managed::Limit::kGfcBehind : managed::Limit::kNothing);
        EXPECT_EQ(network.watch.Found(), managed::Wrong::kNothing);
    }
}

// A relay that is changed runs by somebody's command, and no manager is there: looked at each 50 ms, by a plan that
// gives it 3 s.
TEST_F(ListedNetworkTest, SlaveThatNoManagerReachesForASecondIsListed)
{
    Verifies(req::SRS_CMG_073);
    JudgedNetwork network(managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\nstop_within: 3 s\n")));
    network.RunTo(143);
    network.stage.Managers().front()->SwitchOff();
    network.Change();
    network.stage.Somebody().Send(CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 33U}});
    // Then it is listed once nothing of a manager has come to it for more than a second, and not before
    network.RunTo(1000);
    EXPECT_EQ(network.watch.Listed(), managed::Limit::kNothing);
    network.RunTo(1200);
    EXPECT_EQ(network.watch.Listed(), managed::Limit::kApart);
    EXPECT_EQ(network.watch.Found(), managed::Wrong::kNothing);
}

TEST_F(ListedNetworkTest, TwoActiveManagersThatDoNotHearEachOtherForASecondAreListed)
{
    Verifies(req::SRS_CMG_073);
    const managed::Plan plan =
        managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\nmasters_within: 4 s\n", "flying.yaml"));
    // Given two flying masters of which one is active, when nobody receives anything any more
    JudgedNetwork network(plan);
    network.RunTo(2500);
    const auto active = [&network](const std::size_t index)
    { return network.stage.Managers()[index]->Station()->Assembly().Core().IsActive(); };
    ASSERT_TRUE(active(0U));
    ASSERT_FALSE(active(1U));
    const std::vector<std::uint32_t> identifiers{0U};
    managed::FrameHit hit;
    hit.fault = managed::Fault::kLost;
    hit.variant = 5U; // All of the bus.
    hit.start = network.stage.World().Now();
    hit.receiver = managed::kEverybody;
    network.stage.Hit().Arm(hit, identifiers);
    std::int64_t ms = 2500;
    while (!(active(0U) && active(1U)) && (ms < 7000))
    {
        ++ms;
        network.RunTo(ms);
    }
    ASSERT_LT(ms, 7000);
    // Then that is listed once they have not heard each other for more than a second, and is not wrong
    network.RunTo(std::max<std::int64_t>(ms + 2, 3510));
    EXPECT_EQ(network.watch.Listed(), managed::Limit::kApart);
    EXPECT_EQ(network.watch.Found(), managed::Wrong::kNothing);
}

TEST_F(ListedNetworkTest, RuleThatAManagerWhichIsHitBreaksIsListedWhereSlavesAreAsExpected)
{
    Verifies(req::SRS_CMG_348);
    const managed::Plan plan = managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\n"));
    // Given a manager whose memory is wrong, and that starts all; or a slave before it was read
    for (const bool is_hit : {true, false})
    {
        JudgedNetwork all(plan);
        all.RunTo(100);
        JudgedNetwork early(plan);
        early.RunTo(1);
        if (is_hit)
        {
            all.watch.NoteManagerHit();
            early.watch.NoteManagerHit();
        }
        all.Commands(1U, 0U);
        early.Commands(1U, 33U);
        // Then that is listed; of a manager that nobody hit it is wrong
        for (const auto& [network, wrong] :
             {std::pair(&all, managed::Wrong::kStartOfAll), std::pair(&early, managed::Wrong::kUnverified)})
        {
            EXPECT_EQ(network->watch.Found(), is_hit ? managed::Wrong::kNothing : wrong);
            EXPECT_EQ(network->watch.Listed(), is_hit ? managed::Limit::kOwnRule : managed::Limit::kNothing);
        }
    }
    // And so is a frame under an identifier that it never uses
    JudgedNetwork foreign(plan);
    foreign.RunTo(100);
    const managed::Reference reference = foreign.watch.TakeReference();
    foreign.watch.NoteManagerHit();
    foreign.watch.Compare(reference, 100'000'000);
    foreign.Sends(CanFrame{0x101U, FrameKind::kData, CanPortId::kFirst, 2U, {0U, 0U}},
                  foreign.stage.Managers().front()->BusNode());
    EXPECT_EQ(foreign.watch.Found(), managed::Wrong::kNothing);
    EXPECT_EQ(foreign.watch.Listed(), managed::Limit::kOwnRule);
}

TEST_F(ListedNetworkTest, TwoActiveManagersOfWhichOneIsHitAreListed)
{
    Verifies(req::SRS_CMG_348);
    const managed::Plan plan =
        managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\nmasters_within: 200 ms\n", "flying.yaml"));
    JudgedNetwork network(plan);
    network.RunTo(2500);
    network.watch.NoteManagerHit();
    Deaf deaf(network.stage.Managers()[1]->BusNode());
    network.stage.World().Bus().Install(deaf);
    std::int64_t ms = 2500;
    while (!network.stage.Managers()[1]->Station()->Assembly().Core().IsActive() && (ms < 8000))
    {
        ++ms;
        network.RunTo(ms);
    }
    ASSERT_LT(ms, 8000);
    network.RunTo(ms + 250);
    EXPECT_EQ(network.watch.Found(), managed::Wrong::kNothing);
    EXPECT_EQ(network.watch.Listed(), managed::Limit::kOwnRule);
}

TEST_F(ListedNetworkTest, SlaveThatHoldsItselfBackIsListedBehindAFaultOfAManagerAlone)
{
    Verifies(req::SRS_CMG_348);
    const managed::Plan plan = managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\n"));
    // Given a relay with another configuration, of which 13FEh is 0, that its manager starts
    for (const bool is_hit : {true, false})
    {
        JudgedNetwork network(plan);
        network.RunTo(100);
        network.Change();
        EXPECT_EQ(network.stage.ValueIn(network.Relay(), {0x13FEU, 0U}), 0U);
        if (is_hit)
        {
            network.watch.NoteManagerHit();
        }
        network.Commands(1U, 33U);
        // Then its own signature holds it back, which excuses a manager whose memory is wrong
        EXPECT_EQ(network.watch.Found(), is_hit ? managed::Wrong::kNothing : managed::Wrong::kConfiguration);
        EXPECT_EQ(network.watch.Listed(), is_hit ? managed::Limit::kOwnGate : managed::Limit::kNothing);
    }
}
} // namespace
} // namespace counterpoint::campaign::test
