// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What becomes of a fault of a network: its outcome, who told it first, and when it is over; and of writes that a
// device refuses.
#include "verification/campaign/judged_network.hpp"

#include "canopen/cia306/text/text_file.hpp"
#include "verification/campaign/managed/course.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace counterpoint::campaign::test
{
namespace
{
class NetworkOutcomeTest : public JudgedNetworkTest
{
  protected:
    /// What became of each fault of this plan: class and who told it first, by the object that was hit.
    using Outcomes = std::map<std::pair<std::string, std::string>, std::uint32_t>;
    [[nodiscard]] Outcomes OutcomesOf(const std::string& more) const
    {
        const tools::test::Answer answer =
            Campaign({NetworkPlan("plan.yaml", more), "--jobs", "2", "--csv", Path("rows.csv")});
        EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
        const std::string rows = cia306::ReadTextFile(Path("rows.csv"));
        Outcomes outcomes;
        // number,part,kind,"writes KIND node 33 0x1301:02 at ...",class,teller,us,"..."
        for (std::size_t begin = rows.find('\n') + 1U; begin < rows.size(); begin = rows.find('\n', begin) + 1U)
        {
            const std::size_t node = rows.find(" node ", begin) + 1U;
            const std::string place = rows.substr(node, rows.find(" at ", begin) - node);
            const std::size_t result = rows.find("\",", begin) + 2U;
            const std::size_t teller = rows.find(',', rows.find(',', result) + 1U);
            ++outcomes[{place, rows.substr(result, teller - result)}];
        }
        return outcomes;
    }
    /// The sentence of an experiment.
    [[nodiscard]] std::string OutcomeOf(const std::string& network, const std::string& more,
                                        const std::string& number) const
    {
        const tools::test::Answer answer = Campaign({NetworkPlan("plan.yaml", more, network), "--replay", number});
        EXPECT_EQ(answer.status, 0) << answer.err;
        return answer.out.substr(answer.out.find("\noutcome: ") + 1U);
    }
};

/// All faults of this outcome.
std::uint32_t CountOf(const std::map<std::pair<std::string, std::string>, std::uint32_t>& outcomes,
                      const std::string& outcome)
{
    std::uint32_t count = 0U;
    for (const auto& [key, faults] : outcomes)
    {
        count += (key.second == outcome) ? faults : 0U;
    }
    return count;
}

TEST_F(NetworkOutcomeTest, EachBitOfEachObjectIsWrittenOnceAtEachStep)
{
    Verifies(req::SRS_CMG_156);
    // Given three steps of 50 us
    const managed::Plan plan =
        managed::ReadManagedPlan(NetworkPlan("plan.yaml", "from: 283 ms\nuntil: 283150 us\nparts: [writes]\n"));
    managed::Course course(plan);
    const managed::Reference reference = course.RunWithout();
    const managed::Space space(plan, course.World(), reference);
    std::set<std::tuple<managed::Fault, std::string, std::uint32_t, std::int64_t>> writes;
    std::map<std::string, std::uint32_t> bits_of_relay;
    for (std::uint64_t number = 0U; number < space.Size(); ++number)
    {
        const managed::Trial trial = space.At(number);
        EXPECT_EQ((trial.at - 283'000'000) % 50'000, 0);
        writes.insert({trial.fault, space.SubjectText(trial), trial.variant, trial.at});
        const std::string subject = space.SubjectText(trial);
        const bool is_of_relay = subject.find("node 33 ") == 0U && trial.at == 283'100'000;
        bits_of_relay[subject] += (is_of_relay && trial.fault == managed::Fault::kStored) ? 1U : 0U;
    }
    // Then each bit of 141 bytes is written in both ways at each of them, and nothing twice
    EXPECT_EQ(space.Size(), 2U * 3U * 8U * 141U);
    EXPECT_EQ(writes.size(), 2U * 3U * 8U * 141U);
    // And of the relay with one SRDO of two pairs these objects
    for (const auto& [object, bits] : std::map<std::string, std::uint32_t>{{"0x1300:00", 8U},
                                                                           {"0x1301:00", 8U},
                                                                           {"0x1301:01", 8U},
                                                                           {"0x1301:02", 16U},
                                                                           {"0x1301:03", 8U},
                                                                           {"0x1301:04", 8U},
                                                                           {"0x1301:05", 32U},
                                                                           {"0x1301:06", 32U},
                                                                           {"0x1381:00", 8U},
                                                                           {"0x1381:01", 32U},
                                                                           {"0x1381:02", 32U},
                                                                           {"0x1381:03", 32U},
                                                                           {"0x1381:04", 32U},
                                                                           {"0x13FE:00", 8U},
                                                                           {"0x13FF:00", 8U},
                                                                           {"0x13FF:01", 16U}})
    {
        EXPECT_EQ(bits_of_relay["node 33 " + object], bits) << object;
    }
}

TEST_F(NetworkOutcomeTest, WhatADeviceThatRunsRefusesIsMaskedOrBenignByItsAnswer)
{
    Verifies(req::SRS_CMG_156);
    // Given three devices in OPERATIONAL, which take 0 and 1 of 1300h and nothing else, and each bit of 141 bytes
    for (const auto& [kind, refused] : {std::pair("stored", "masked,nobody"), {"foreign", "benign,nobody"}})
    {
        const Outcomes outcomes =
            OutcomesOf("from: 283500 us\nuntil: 283550 us\nparts: [writes]\nkinds: [" + std::string(kind) + "]\n");
        // Then all but bit 0 of the three is refused, and has no effect but the answer
        EXPECT_EQ(CountOf(outcomes, refused), 8U * 141U - 3U) << kind;
        for (const char* const object : {"node 1 0x1300:00", "node 2 0x1300:00", "node 33 0x1300:00"})
        {
            EXPECT_EQ(outcomes.at({object, "listed,nobody"}), 1U) << kind << object;
        }
    }
}

TEST_F(NetworkOutcomeTest, WhatADeviceBeforeItsStartRefusesIsMaskedOrBenignByItsAnswer)
{
    Verifies(req::SRS_CMG_156);
    // Given a controller in PRE-OPERATIONAL, which its manager reads and starts later, with SRDOs that are on
    for (const auto& [kind, refused] : {std::pair("stored", "masked,nobody"), {"foreign", "benign,nobody"}})
    {
        const Outcomes outcomes =
            OutcomesOf("from: 50 ms\nuntil: 50050 us\nparts: [writes]\nkinds: [" + std::string(kind) + "]\n");
        const std::string told = "detected,safety_gate";
        // Then it takes 0 of a direction, any SCT and SRVT, any signature, and whatever else than A5h for 0 of 13FEh
        for (const auto& [object, taken, left] :
             {std::tuple("0x1300:00", 1U, 7U),
              {"0x1301:01", 1U, 7U},
              {"0x1301:02", 16U, 0U},
              {"0x1301:03", 8U, 0U},
              {"0x1302:01", 1U, 7U},
              {"0x1302:02", 16U, 0U},
              {"0x1302:03", 8U, 0U},
              {"0x13FE:00", 8U, 0U},
              {"0x13FF:01", 16U, 0U},
              {"0x13FF:02", 16U, 0U},
              // and refuses another transmission type, COB-IDs and mapping of one that is on, and what is constant
              {"0x1301:00", 0U, 8U},
              {"0x1301:04", 0U, 8U},
              {"0x1301:05", 0U, 32U},
              {"0x1301:06", 0U, 32U},
              {"0x1302:05", 0U, 32U},
              {"0x1381:00", 0U, 8U},
              {"0x1381:01", 0U, 32U},
              {"0x1382:02", 0U, 32U},
              {"0x13FF:00", 0U, 8U}})
        {
            const std::string place = std::string("node 2 ") + object;
            const auto count = [&outcomes, &place](const std::string& outcome)
            {
                const auto found = outcomes.find({place, outcome});
                return (found == outcomes.end()) ? 0U : found->second;
            };
            EXPECT_EQ(count(told), taken) << kind << place;
            EXPECT_EQ(count(refused), left) << kind << place;
        }
        EXPECT_EQ(CountOf(outcomes, told), 91U) << kind;
    }
}

TEST_F(NetworkOutcomeTest, WhatADeviceRefusesStaysAsItIs)
{
    Verifies(req::SRS_CMG_156);
    const managed::Plan plan = managed::ReadManagedPlan(
        NetworkPlan("plan.yaml", "from: 283500 us\nuntil: 283550 us\nsettle: 5 ms\nparts: [writes]\n"));
    managed::Course sound(plan);
    const managed::Reference reference = sound.RunWithout();
    const managed::Space space(plan, sound.World(), reference);
    // Given each object of the relay in OPERATIONAL
    for (const managed::Fault kind : {managed::Fault::kStored, managed::Fault::kForeign})
    {
        std::uint32_t tried = 0U;
        for (std::size_t object = 0U; object < space.Objects().size(); ++object)
        {
            const managed::ExpectedValue& expected = space.Objects()[object].expected;
            for (const std::uint32_t bit : {0U, 1U})
            {
                if (space.Objects()[object].slave != 2U)
                {
                    continue;
                }
                managed::Course course(plan);
                course.AdvanceTo(283'500'000);
                managed::Slave relay = course.World().Slaves().at(2U);
                ASSERT_EQ(course.World().ValueIn(relay, expected.object), expected.value);
                const managed::Trial trial{managed::Target::kWrites, kind, object, bit, 283'500'000, {}};
                // When a bit of it is written
                static_cast<void>(course.Try(trial, space, reference));
                // Then all of them are as they were, but for bit 0 of 1300h
                const bool is_taken = expected.object.index == 0x1300U && bit == 0U;
                for (const managed::ExpectedValue& each : relay.expected)
                {
                    const bool is_another = is_taken && each.object.index == 0x1300U;
                    EXPECT_EQ(course.World().ValueIn(relay, each.object), each.value ^ (is_another ? 1U : 0U))
                        << expected.object.index << ":" << int{expected.object.sub} << " bit " << bit;
                }
                ++tried;
            }
        }
        EXPECT_EQ(tried, 32U); // 16 objects.
    }
}

TEST_F(NetworkOutcomeTest, MaskedHasEachFrameAtItsTimeAndBenignHasOthersAndTheSameEnd)
{
    Verifies(req::SRS_CMG_074);
    // Given a write that a device refuses without a message
    EXPECT_EQ(OutcomeOf("managed.yaml",
                        "from: 283500 us\nuntil: 283550 us\nparts: [writes]\nkinds: [stored]\nsample: 2\n", "1")
                  .find("outcome: masked"),
              0U);
    // and the same by a message, which it answers: another frame
    EXPECT_EQ(OutcomeOf("managed.yaml",
                        "from: 283500 us\nuntil: 283550 us\nparts: [writes]\nkinds: [foreign]\nsample: 2\n", "1")
                  .find("outcome: benign"),
              0U);
    // Given a manager's clock that is slower by 100 ppm, whose frames are the same ones later, or faster
    for (const char* const kind : {"slow", "fast"})
    {
        EXPECT_EQ(OutcomeOf("managed.yaml",
                            std::string("from: 300 ms\nuntil: 300050 us\nparts: [clocks]\nkinds: [") + kind + "]\n",
                            "0")
                      .find("outcome: benign"),
                  0U)
            << kind;
    }
    // Given a command that comes to its receiver later, which changes its state later, and nothing else
    EXPECT_EQ(OutcomeOf("managed.yaml", "until: 1 ms\nparts: [nmt]\nkinds: [delayed]\nsample: 6\n", "0")
                  .find("outcome: benign"),
              0U);
}

TEST_F(NetworkOutcomeTest, FrameThatIsMissingOrAtAnotherTimeIsNotTheSame)
{
    Verifies(req::SRS_CMG_074);
    const managed::Plan plan = managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\n"));
    JudgedNetwork sound(plan);
    sound.RunTo(300);
    const managed::Reference reference = sound.watch.TakeReference();
    ASSERT_FALSE(reference.frames.empty());
    // Given the frames of 200 ms
    JudgedNetwork network(plan);
    network.RunTo(200);
    network.watch.Compare(reference, 200'000'000);
    EXPECT_TRUE(network.watch.HasSentTheSame(200'000'000));
    // When none comes any more, then the next one is missing as soon as its sender would know that it was sent
    const managed::RecordedFrame& next = reference.frames.at(network.watch.Frames().size());
    EXPECT_GT(next.end, 200'000'000);
    EXPECT_TRUE(network.watch.HasSentTheSame(next.end - 1));
    EXPECT_FALSE(network.watch.HasSentTheSame(next.end));
    // When this one comes at another time, with another byte, or of another sender
    for (const std::uint32_t what : {0U, 1U, 2U, 3U})
    {
        managed::Reference other = reference;
        managed::RecordedFrame& last = other.frames.at(network.watch.Frames().size() - 1U);
        last.start += (what == 1U) ? 1 : 0;
        last.frame.data[0] = static_cast<std::uint8_t>(last.frame.data[0] ^ ((what == 2U) ? 1U : 0U));
        last.sender += (what == 3U) ? 1U : 0U;
        network.watch.Compare(other, 200'000'000);
        EXPECT_EQ(network.watch.HasSentTheSame(200'000'000), what == 0U) << what;
    }
    // When there is one more than without the fault
    managed::Reference shorter = reference;
    shorter.frames.resize(network.watch.Frames().size() - 1U);
    network.watch.Compare(shorter, 200'000'000);
    EXPECT_FALSE(network.watch.HasSentTheSame(200'000'000));
}

/// A fault of which somebody tells first.
struct FirstTeller
{
    const char* network;
    const char* plan;
    const char* number;
    const char* outcome;
};

TEST_F(NetworkOutcomeTest, WhoToldFirstIsNamedWithTheTimeSinceTheFault)
{
    Verifies(req::SRS_CMG_074);
    for (const FirstTeller& each : {
             // No answer to the manager's first questions; a clock at half its speed, whose node is asked for too late.
             FirstTeller{"managed.yaml", "from: 2500 us\nuntil: 3 ms\nparts: [sdo]\nkinds: [lost]\nsample: 12\n", "5",
                         "outcome: detected, told by status, after 1499.321 ms\n"},
             FirstTeller{"managed.yaml", "from: 300 ms\nuntil: 301 ms\nparts: [clocks]\nkinds: [slow]\nsample: 40\n",
                         "33", "outcome: detected, told by duplicate, after 1307.213 ms\n"},
             // A command that comes late, and one that comes as 080h.
             FirstTeller{"managed.yaml", "until: 1 ms\nparts: [nmt]\nkinds: [delayed]\nsample: 6\n", "5",
                         "outcome: detected, told by command, after 80.879 ms\n"},
             FirstTeller{"managed.yaml",
                         "from: 31 ms\nuntil: 32 ms\nparts: [nmt]\nkinds: [wrong_identifier]\nsample: 40\n", "9",
                         "outcome: detected, told by emergency, after 0.619 ms\n"},
             // An active manager of another priority.
             FirstTeller{"flying.yaml",
                         "from: 660 ms\nuntil: 663 ms\nparts: [election]\nkinds: [wrong_byte]\nsample: 12\n", "0",
                         "outcome: detected, told by election, after 0.141 ms\n"},
         })
    {
        EXPECT_EQ(OutcomeOf(each.network, each.plan, each.number), each.outcome);
    }
    // And a reset of all that nobody gets: less runs, and nobody tells it
    EXPECT_EQ(OutcomeOf("managed.yaml", "until: 1 ms\nparts: [nmt]\nkinds: [lost]\nsample: 30\n", "16")
                  .find("outcome: safe_other"),
              0U);
}

TEST_F(NetworkOutcomeTest, FaultIsOverWhenAllIsAsWithoutItForTheTimeOfThePlan)
{
    Verifies(req::SRS_CMG_074);
    const auto ended_at = [this](const std::string& settle, const std::string& more, const std::uint64_t number)
    {
        const managed::Plan plan =
            managed::ReadManagedPlan(NetworkPlan("plan.yaml", more + "settle: " + settle + "\n"));
        managed::Course sound(plan);
        const managed::Reference reference = sound.RunWithout();
        managed::Course course(plan);
        const managed::Space space(plan, course.World(), reference);
        course.AdvanceTo(space.At(number).at);
        static_cast<void>(course.Try(space.At(number), space, reference));
        return course.World().World().Now();
    };
    // Given a write at 283.500 ms that has no effect: looked at each ms
    const std::string write = "from: 283500 us\nuntil: 283550 us\nparts: [writes]\nkinds: [stored]\nsample: 2\n";
    EXPECT_EQ(ended_at("5 ms", write, 1U), 289'000'000);
    EXPECT_EQ(ended_at("600 ms", write, 1U), 884'000'000);
    // Given a manager that misses a heartbeat at 107.127 ms, and learns from the one of 207.127 ms what it missed
    const std::string lost = "from: 107 ms\nuntil: 108 ms\nparts: [life]\nkinds: [lost]\nsample: 20\n";
    EXPECT_EQ(ended_at("20 ms", lost, 1U), 227'000'000);
    EXPECT_EQ(ended_at("60 ms", lost, 1U), 267'000'000);
}

TEST_F(NetworkOutcomeTest, DevicesOutputsAndWhatManagersKnowAreSeen)
{
    Verifies(req::SRS_CMG_074);
    const managed::Plan plan = managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\n"));
    JudgedNetwork sound(plan);
    JudgedNetwork same(plan);
    JudgedNetwork device(plan);
    JudgedNetwork output(plan);
    for (JudgedNetwork* const each : {&sound, &same, &device, &output})
    {
        each->RunTo(500);
        ASSERT_EQ(each->watch.Seen().words, sound.watch.Seen().words);
        ASSERT_EQ(each->watch.Seen().values, sound.watch.Seen().values);
    }
    // Given a sensor that stops by itself, and a button that is let go
    device.stage.World().At(device.stage.Slaves().front().index).Firmware().Obey(cia301::NmtCommand::kStop);
    output.stage.World().At(output.stage.Slaves().front().index).App().SetInput({0x2000U, 2U}, 0U);
    same.RunTo(503);
    sound.RunTo(503);
    device.RunTo(503);
    EXPECT_TRUE(same.watch.Seen() == sound.watch.Seen());
    // Then its state is seen at once, and its manager knows nothing of it yet
    const auto of_managers = [](const JudgedNetwork& network)
    {
        const std::vector<std::uint32_t>& words = network.watch.Seen().words;
        return std::vector<std::uint32_t>(words.begin() + 3, words.end());
    };
    EXPECT_EQ(device.watch.Seen().words.at(0U) & 0xFFU, 6U); // STOPPED.
    EXPECT_EQ(sound.watch.Seen().words.at(0U) & 0xFFU, 5U);
    EXPECT_EQ(of_managers(device), of_managers(sound));
    // and what it knows with the next heartbeat, of about 507 ms
    sound.RunTo(510);
    device.RunTo(510);
    EXPECT_NE(of_managers(device), of_managers(sound));
    // Then the value of the output is seen
    sound.RunTo(600);
    output.RunTo(600);
    EXPECT_EQ(output.watch.Seen().words, sound.watch.Seen().words);
    EXPECT_NE(output.watch.Seen().values, sound.watch.Seen().values);
    EXPECT_FALSE(output.watch.Seen() == sound.watch.Seen());
}
} // namespace
} // namespace counterpoint::campaign::test
