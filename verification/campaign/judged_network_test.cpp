// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the judge of a network with managers finds wrong, each with what it must not mind.
#include "verification/campaign/judged_network.hpp"

#include "canopen/cia306/text/text_file.hpp"
#include "verification/campaign/managed/memory.hpp"
#include "verification/campaign/managed/space.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <string>
#include <sys/wait.h>
#include <utility>

namespace counterpoint::campaign::test
{
namespace
{
TEST_F(JudgedNetworkTest, JudgeFindsEachWrongCommand)
{
    Verifies(req::SRS_CMG_072);
    Verifies(req::SRS_CMG_215);
    Verifies(req::SRS_CMG_216);
    Verifies(req::SRS_CMG_220);
    const managed::Plan plan = managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\n"));
    // Given a start of all; a start before anything was read
    JudgedNetwork all(plan);
    all.RunTo(100);
    ASSERT_EQ(all.watch.Found(), managed::Wrong::kNothing);
    all.Commands(1U, 0U);
    EXPECT_EQ(all.watch.Found(), managed::Wrong::kStartOfAll);
    JudgedNetwork early(plan);
    early.RunTo(1);
    early.Commands(1U, 33U);
    EXPECT_EQ(early.watch.Found(), managed::Wrong::kUnverified);
    // Given one that was read, then it may be started again, also within 3 ms behind another command, and no later
    JudgedNetwork late(plan);
    late.RunTo(100);
    late.Commands(1U, 33U);
    EXPECT_EQ(late.watch.Found(), managed::Wrong::kNothing);
    late.Commands(0x80U, 33U);
    late.RunTo(102);
    late.Commands(1U, 33U);
    EXPECT_EQ(late.watch.Found(), managed::Wrong::kNothing);
    late.RunTo(106);
    late.Commands(1U, 33U);
    EXPECT_EQ(late.watch.Found(), managed::Wrong::kUnverified);
    // Given one that has another configuration by then
    JudgedNetwork changed(plan);
    changed.RunTo(100);
    changed.Change();
    changed.Commands(1U, 33U);
    EXPECT_EQ(changed.watch.Found(), managed::Wrong::kConfiguration);
}

TEST_F(JudgedNetworkTest, ConfigurationThatIsAnotherOneOnlyBehindItsReadingIsNoWrongStart)
{
    Verifies(req::SRS_CMG_216);
    const managed::Plan plan = managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\n"));
    JudgedNetwork sound(plan);
    sound.RunTo(200);
    const managed::Reference reference = sound.watch.TakeReference();
    // Given a relay that was read, and a fault at 100 ms that changes it without a message
    JudgedNetwork network(plan);
    network.RunTo(100);
    network.watch.Compare(reference, 100'000'000);
    network.watch.NoteStored();
    network.Change();
    // When it is started, then no manager could know, and it is listed
    network.Commands(1U, 33U);
    EXPECT_EQ(network.watch.Found(), managed::Wrong::kNothing);
    EXPECT_EQ(network.watch.Listed(), managed::Limit::kChangedBehind);
}

TEST_F(JudgedNetworkTest, JudgeFindsWhoRunsOnAndForeignIdentifiers)
{
    Verifies(req::SRS_CMG_218);
    Verifies(req::SRS_CMG_219);
    const managed::Plan plan = managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\n"));
    // Given a relay that is changed, and that somebody else starts, looked at each 50 ms, and a manager without supply
    JudgedNetwork network(managed::ReadManagedPlan(NetworkPlan("short.yaml", "until: 60 ms\nstop_within: 1 ms\n")));
    network.RunTo(143);
    network.stage.Managers().front()->SwitchOff();
    network.Change();
    network.stage.Somebody().Send(CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 33U}});
    network.RunTo(199);
    EXPECT_EQ(network.watch.Found(), managed::Wrong::kNothing);
    network.RunTo(200);
    EXPECT_EQ(network.watch.Found(), managed::Wrong::kRunsOn);
    // Given a relay that sends what it sends without a fault, and something else
    JudgedNetwork other(plan);
    other.RunTo(100);
    const managed::Reference reference = other.watch.TakeReference();
    other.watch.Compare(reference, 100'000'000);
    const CanFrame heartbeat{0x721U, FrameKind::kData, CanPortId::kFirst, 1U, {5U}};
    other.Sends(heartbeat, other.Relay().bus_node);
    EXPECT_EQ(other.watch.Found(), managed::Wrong::kNothing);
    const CanFrame command{0x101U, FrameKind::kData, CanPortId::kFirst, 2U, {0U, 0U}};
    other.Sends(command, other.Relay().bus_node);
    EXPECT_EQ(other.watch.Found(), managed::Wrong::kIdentifier);
}

TEST_F(JudgedNetworkTest, StartOfAnotherDeviceIsWrongWhereTheSerialNumberIsExpected)
{
    Verifies(req::SRS_CMG_217);
    const managed::Plan plan = managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\n"));
    // Given a relay whose serial number the network tells, and that was read as expected since its boot-up message
    for (const bool is_relay : {true, false})
    {
        JudgedNetwork network(plan);
        ASSERT_EQ(network.Relay().serial, 33U);
        network.RunTo(100);
        // When it is another device, or another one of the slaves is
        network.watch.NoteExchanged(is_relay ? network.Relay() : network.stage.Slaves().front());
        network.Commands(1U, 33U);
        // Then its start is wrong for that alone
        EXPECT_EQ(network.watch.Found(), is_relay ? managed::Wrong::kIdentity : managed::Wrong::kNothing);
    }
}

TEST_F(JudgedNetworkTest, TwoActiveManagersAreWrongBehindTheTimeOfThePlan)
{
    Verifies(req::SRS_CMG_217);
    const managed::Plan plan =
        managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\nmasters_within: 200 ms\n", "flying.yaml"));
    // Given two flying masters of which one is active, and the other one hears nothing any more
    JudgedNetwork network(plan);
    network.RunTo(2500);
    Deaf deaf(network.stage.Managers()[1]->BusNode());
    network.stage.World().Bus().Install(deaf);
    // When both are active
    const auto active = [&network](const std::size_t index)
    { return network.stage.Managers()[index]->Station()->Assembly().Core().IsActive(); };
    ASSERT_TRUE(active(0U));
    ASSERT_FALSE(active(1U));
    std::int64_t ms = 2500;
    while (!(active(0U) && active(1U)) && (ms < 8000))
    {
        ++ms;
        network.RunTo(ms);
    }
    ASSERT_LT(ms, 8000);
    // Then that is wrong once it has lasted longer than 200 ms
    network.RunTo(ms + 200);
    EXPECT_EQ(network.watch.Found(), managed::Wrong::kNothing);
    network.RunTo(ms + 201);
    EXPECT_EQ(network.watch.Found(), managed::Wrong::kTwoMasters);
}

// t [ms]   500 stopped   505 an output follows its device within this   506 told
TEST_F(JudgedNetworkTest, OutputThatIsOpenOutsideOfOperationalIsWrong)
{
    Verifies(req::SRS_CMG_349);
    // Given a relay at work that its manager stops
    static_cast<void>(File("stopped.yaml", "extends: " COUNTERPOINT_SOURCE_FOLDER "/examples/campaigns/managed.yaml\n"
                                           "events: [{at: 500 ms, do: order, order: stop 33}]\n"));
    const std::string plan =
        File("plan.yaml", "title: A test\nnetwork: stopped.yaml\nfrom: 20 ms\nuntil: 60 ms\nparts: [sdo]\n"
                          "kinds: [lost]\nsample: 1\n");
    const auto run = [this, &plan](const std::string& program)
    {
        const int status = std::system((program + " campaign " + plan + " > " + Path("out")).c_str());
        return std::pair(WEXITSTATUS(status), cia306::ReadTextFile(Path("out")));
    };
    // When its kernel does not take STOPPED, then its output is wrong
    const auto [broken, told] = run(std::string(COUNTERPOINT_PLANTED) + "/counterpoint_campaign_stop_not_taken");
    EXPECT_EQ(broken, 1);
    EXPECT_NE(told.find("not well: without a fault, after 506.000 ms: output open outside of OPERATIONAL\n"),
              std::string::npos)
        << told;
    // and the kernel that ships closes it in time
    const auto [sound, text] = run(COUNTERPOINT_CAMPAIGN);
    EXPECT_EQ(sound, 0) << text;
}

TEST_F(JudgedNetworkTest, OutputThatOpensAgainWithoutAnAcknowledgeIsWrong)
{
    Verifies(req::SRS_CMG_349);
    const managed::Plan plan = managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\n"));
    JudgedNetwork sound(plan);
    sound.RunTo(1000);
    const managed::Reference reference = sound.watch.TakeReference();
    // Given a relay at work, which the scenario acknowledges from 400 ms to 450 ms
    JudgedNetwork network(plan);
    network.RunTo(500);
    network.watch.Compare(reference, 500'000'000);
    simulator::Node& relay = network.stage.World().At(network.Relay().index);
    ASSERT_NE(relay.Open(), 0U);
    // When somebody makes it PRE-OPERATIONAL, and it is started again
    network.stage.Somebody().Send(CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {0x80U, 33U}});
    network.RunTo(520);
    ASSERT_EQ(relay.Open(), 0U);
    network.stage.Somebody().Send(CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 33U}});
    network.RunTo(620);
    ASSERT_EQ(relay.Open(), 0U);
    EXPECT_EQ(network.watch.Found(), managed::Wrong::kNothing);
    // Then an output that opens is wrong: the scenario has nobody who acknowledges now
    relay.App().SetAcknowledge(1U, true);
    network.RunTo(660);
    ASSERT_NE(relay.Open(), 0U);
    EXPECT_EQ(network.watch.Found(), managed::Wrong::kNoAcknowledge);
}

TEST_F(JudgedNetworkTest, EachBitOfAMemberIsFlippedAtEachStepOfTheGrid)
{
    Verifies(req::SRS_CMG_080);
    // Given half a millisecond in steps of 50 us, and one member
    const managed::Plan plan = managed::ReadManagedPlan(
        NetworkPlan("plan.yaml", "from: 20 ms\nuntil: 20500 us\nparts: [memory]\nmembers: [gate]\n"));
    JudgedNetwork sound(plan);
    sound.RunTo(21);
    managed::Reference reference = sound.watch.TakeReference();
    managed::MemoryWatch memory;
    memory.Look(0U, *sound.stage.Managers().front());
    reference.memory = memory.Members();
    const auto gate = std::find_if(reference.memory.begin(), reference.memory.end(),
                                   [](const managed::ManagerMember& member) { return member.name == "gate"; });
    ASSERT_NE(gate, reference.memory.end());
    ASSERT_GT(gate->size_bytes, 0U);
    const managed::Space space(plan, sound.stage, reference);
    // Then each of its bits is flipped at each of these ten moments, and nothing twice
    std::set<std::pair<std::int64_t, std::uint32_t>> flips;
    for (std::uint64_t number = 0U; number < space.Size(); ++number)
    {
        const managed::Trial trial = space.At(number);
        EXPECT_EQ(trial.target, managed::Target::kMemory);
        EXPECT_EQ((trial.at - 20'000'000) % 50'000, 0);
        flips.insert({trial.at, (8U * managed::Space::ByteOf(trial)) + (trial.variant % 8U)});
    }
    EXPECT_EQ(space.Size(), 10U * 8U * gate->size_bytes);
    EXPECT_EQ(flips.size(), 10U * 8U * gate->size_bytes);
    EXPECT_EQ(flips.begin()->first, 20'000'000);
    EXPECT_EQ(flips.rbegin()->first, 20'450'000);
    EXPECT_EQ(flips.rbegin()->second, (8U * gate->size_bytes) - 1U);
}

TEST_F(JudgedNetworkTest, DataThatTheRunWithoutFaultHasNotHadAreWrong)
{
    Verifies(req::SRS_CMG_349);
    const managed::Plan plan = managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\n"));
    JudgedNetwork sound(plan);
    sound.RunTo(1100);
    const managed::Reference reference = sound.watch.TakeReference();
    // Given buttons that say 1, of which the scenario lets one go at 700 ms
    for (const std::int64_t late_ms : {0, 155, 165, 300})
    {
        JudgedNetwork network(plan);
        network.RunTo(500);
        network.watch.Compare(reference, 500'000'000);
        simulator::Node& sensor = network.stage.World().At(network.stage.Slaves().front().index);
        network.RunTo(699);
        // When it says 1 for longer than the scenario has it: data are at most 160 ms old at the relay
        for (std::int64_t ms = 700; ms < 700 + late_ms; ++ms)
        {
            network.RunTo(ms);
            sensor.App().SetInput({0x2000U, 2U}, 1U);
        }
        sensor.App().SetInput({0x2000U, 2U}, 0U);
        network.RunTo(1050);
        // Then that is wrong once they are older
        EXPECT_EQ(network.watch.Found(), (late_ms > 160) ? managed::Wrong::kData : managed::Wrong::kNothing) << late_ms;
    }
}
} // namespace
} // namespace counterpoint::campaign::test
