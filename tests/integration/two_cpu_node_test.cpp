// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Devices with two CPUs on the simulated bus: the link between them, the loss of one of them, one that always says
// good. Each time to the safe output is held to the computed limit.
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/crosslink.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <ostream>
#include <string>

namespace counterpoint::simulator
{
namespace
{
/// A scenario on the chain whose actuator has two CPUs; `text` is what it adds.
std::unique_ptr<Run> RunTwoCpus(const std::string& text)
{
    auto run = std::make_unique<Run>(TextFile("extends: " + Examples() + "../two_cpus/chain.yaml\n" + text),
                                     std::nullopt, std::nullopt, false);
    run->Simulate(nullptr);
    return run;
}

TEST(TwoCpuNode, RunsWithDriftingClocksAndAJitterThatVaries)
{
    Verifies(req::SRS_SIM_056);
    Verifies(req::SRS_SIM_052);
    const auto run = RunTwoCpus("duration: 30 s\nexpect:\n  - {that: no_fault}\n"
                                "  - {that: value, node: actuator, object: 0x2200:01, is: 1, at: 29990 ms}\n"
                                "  - {that: released, node: actuator.a, srdo: 1, at: 29990 ms}\n"
                                "  - {that: released, node: actuator.b, srdo: 1, at: 29990 ms}\n");
    EXPECT_EQ(Failures(*run), "");
}

// Both CPUs obey in their own cycles, so that one is still told what the other one said before.
TEST(TwoCpuNode, IsResetAtAnyMomentOfItsCycles)
{
    Verifies(req::SRS_LNK_011);
    for (int at_us = 500000; at_us < 502000; at_us += 250)
    {
        const std::string at = std::to_string(at_us);
        const auto run = RunTwoCpus("duration: 1200 ms\nnmt:\n  - {at: " + at +
                                    " us, node: actuator, command: reset_node, start_after: 10 ms}\n"
                                    "acknowledge:\n  - {at: 800 ms, node: actuator, srdo: 1, pulse: 50 ms}\nexpect:\n"
                                    "  - {that: device_fault, node: actuator, is: none}\n"
                                    "  - {that: released, node: actuator, srdo: 1, at: 1190 ms}\n");
        EXPECT_EQ(Failures(*run), "") << at;
    }
}

/// A device of the chain whose channels may differ for 12 ms; the file that it is written to.
std::string PatientDevice(const std::string& name, const std::string& digest, const std::string& patient_digest)
{
    const std::string text =
        cia306::test::Changed(cia306::test::ExampleText(name), {{"\nParameterValue=5000\n", "\nParameterValue=12000\n"},
                                                                {"=" + digest + "\n", "=" + patient_digest + "\n"}});
    return TextFile(text, "." + name + ".dcf");
}

// What they send is prepared by both CPUs: the process values have to be the same on both when a pair is prepared, so
// that a pair may be given up in the moment of a change and the next one has the new value.
TEST(TwoCpuNode, ThreeOfThemAreAChain)
{
    Verifies(req::SRS_SIM_056);
    Verifies(req::SRS_SIM_057);
    simulator::Run run(TextFile("title: Three devices with two CPUs each\nbitrate: 500000\nduration: 2000 ms\nseed: 1\n"
                                "nodes:\n  sensor:\n    dcf: " +
                                PatientDevice("sensor", "0x66596575", "0x39B72C25") + R"(
    structure: two_cpu
    cpu_a: {phase: 130 us, counter: {ppm: 40}}
    cpu_b: {phase: 720 us, counter: {ppm: -30}}
  controller:
    dcf: )" + PatientDevice("controller", "0x0D6A53FF", "0x9476BC8B") +
                                R"(
    structure: two_cpu
    cpu_a: {phase: 470 us, counter: {ppm: 20, start_us: 4294900000}}
    cpu_b: {phase: 990 us, counter: {ppm: -60}}
  actuator:
    dcf: )" + PatientDevice("actuator", "0x046FFAB7", "0x5B81B3E7") +
                                R"(
    structure: two_cpu
    cpu_a: {phase: 810 us, counter: {ppm: 50, start_us: 123456}}
    cpu_b: {phase: 1330 us, counter: {ppm: -50}}
inputs:
  - {at: 30 ms, node: sensor, object: 0x2000:01, value: 1}
  - {at: 30 ms, node: sensor, object: 0x2000:02, value: 1}
  - {at: 1000 ms, node: sensor, object: 0x2000:01, value: 0}
logic:
  - {node: controller, set: 0x2000:01, op: and, from: [0x2200:01, 0x2200:02]}
  - {node: controller, set: 0x2000:02, op: or, from: [0x2200:01, 0x2200:02]}
acknowledge:
  - {at: 350 ms, node: actuator, srdo: 1, pulse: 50 ms}
expect:
  - {that: released, node: actuator, srdo: 1, at: 900 ms}
  - {that: value, node: actuator, object: 0x2200:01, is: 1, at: 900 ms}
  - {that: value, node: actuator, object: 0x2200:01, is: 0, at: 1100 ms}
  - {that: device_fault, node: sensor, is: none}
  - {that: device_fault, node: controller, is: none}
  - {that: device_fault, node: actuator, is: none}
)"),
                       std::nullopt, std::nullopt, false);
    run.Simulate(nullptr);
    EXPECT_EQ(Failures(run), "");
}

/// What goes wrong at 500 ms or later, and which CPUs lose the other one's voice.
struct LinkCase
{
    const char* fault;
    const char* cpus; ///< "a", "b" or "ab".
    const char* by{"cross_link"};
};

void PrintTo(const LinkCase& link, std::ostream* const out)
{
    *out << link.fault;
}

using LostPeer = ::testing::TestWithParam<LinkCase>;

TEST_P(LostPeer, IsFoundByTheLinkOfWhoIsLeftWithinTheLimit)
{
    Verifies(req::SRS_SIM_057);
    Verifies(req::SRS_LNK_006);
    Verifies(req::SRS_LNK_009);
    std::string text = std::string("duration: 2 s\nfaults:\n  - {fault: ") + GetParam().fault + R"(}
expect:
  - {that: safe_within, node: actuator, srdo: 1, limit: cross_link}
  - {that: safe, node: actuator, srdo: 1, at: 1999 ms}
)";
    for (const char* cpu = GetParam().cpus; *cpu != '\0'; ++cpu)
    {
        const std::string node = std::string("node: actuator.") + *cpu;
        text += "  - {that: safe_within, " + node + ", srdo: 1, limit: cross_link}\n";
        text += "  - {that: detected_by, " + node + ", by: " + GetParam().by + "}\n";
    }
    EXPECT_EQ(Failures(*RunTwoCpus(text)), "");
}

constexpr LinkCase kLostPeers[] = {
    // A pair that comes meanwhile is unmatched within the discrepancy time, which is shorter than this time-out.
    // The link, in each direction and both: cut, or nothing that can be believed comes through.
    {"link_cut, node: actuator, at: 500 ms", "ab"},
    {"link_cut, node: actuator, sender: a, at: 500.3 ms", "ab"},
    {"link_cut, node: actuator, sender: b, at: 511.7 ms", "ab", "[cross_link, comparator]"},
    {"link_cut, node: actuator, at: 500 ms, until: 520 ms", "ab"},
    {"link_loss, node: actuator, at: 500 ms", "ab"},
    {"link_loss, node: actuator, sender: a, at: 500 ms, count: 20", "ab"},
    {"link_delay, node: actuator, at: 500 ms, by: 15 ms", "ab"},
    {"link_delay, node: actuator, sender: b, at: 500 ms, by: 1 s", "ab"},
    {"link_corruption, node: actuator, at: 500 ms, bits: [0]", "ab"},
    {"link_corruption, node: actuator, sender: a, at: 500 ms, bits: [1503]", "ab"},
    {"link_corruption, node: actuator, sender: b, at: 500 ms, bits: [545, 770, 771]", "ab"},
    {"link_loss, node: actuator, at: 500 ms, on: 15 ms, off: 5 ms", "ab"},
    // The other CPU: it stands still, hangs, or has no supply.
    {"standstill, node: actuator.a, at: 500 ms", "b"},
    {"standstill, node: actuator.b, at: 512.2 ms", "a", "comparator"},
    {"hung, node: actuator.a, part: channel_a, at: 500 ms", "b"},
    {"hung, node: actuator.b, part: channel_b, at: 500 ms", "a"},
    {"hung, node: actuator.b, part: comparator, at: 500 ms", "a"},
    {"hung, node: actuator.a, part: self_test, at: 500 ms", "b"},
    // Its clock: it stands still, or jumps farther than the tolerance.
    {"clock, node: actuator.a, counter: a, stopped: true, at: 500 ms", "b"},
    {"clock, node: actuator.b, counter: a, stopped: true, at: 500 ms", "a"},
    {"clock, node: actuator.a, counter: a, jump: 30 ms, at: 500 ms", "b"},
    {"clock, node: actuator.b, counter: a, jump: 30 ms, at: 500 ms", "a"},
};
INSTANTIATE_TEST_SUITE_P(EachWay, LostPeer, ::testing::ValuesIn(kLostPeers));

// The clocks may be apart by 2 ms in 500 ms. A drift of a tenth more is found in the interval of the link that begins
// after the fault, by a message that may be as old as the time-out: 500 + 10 + 1.5 ms, six times 0.5 ms of drift,
// output 1 ms.
TEST(DriftingPeer, IsFoundWithinTheLimitWheneverItBegins)
{
    Verifies(req::SRS_LIM_002);
    Verifies(req::SRS_SIM_031);
    for (const std::string ppm : {"4400", "-4400"})
    {
        Nanoseconds longest = 0;
        for (int place = 0; place < 12; ++place)
        {
            const std::string at = std::to_string(500 + (43 * place)) + ".4 ms";
            const auto run =
                RunTwoCpus("duration: 2500 ms\nfaults:\n  - {fault: clock, node: actuator.b, counter: a, ppm: " + ppm +
                           ", at: " + at + "}\nexpect:\n  - {that: safe_within, node: actuator.a, srdo: 1}\n" +
                           "  - {that: device_fault, node: actuator.a, is: cross_link}\n");
            EXPECT_EQ(Failures(*run), "") << ppm << " at " << at;
            const Measurement& measurement = *run->Verdicts().at(1U).measurement;
            EXPECT_EQ(measurement.limit, 515500 * kNanosecondsPerMicrosecond);
            longest = std::max(longest, measurement.elapsed);
        }
        EXPECT_GT(longest, 250 * kNanosecondsPerMillisecond);
    }
}

TEST(LostPeer, WithoutSupplyIsFoundByTheOtherCpu)
{
    Verifies(req::SRS_SIM_057);
    Verifies(req::SRS_SIM_037);
    // When CPU B loses its supply and comes back
    const auto run = RunTwoCpus(R"(
duration: 2 s
power:
  - {at: 500 ms, node: actuator.b, off: 100 ms, start_after: 10 ms}
expect:
  - {that: device_fault, node: actuator.a, is: cross_link}
  - {that: safe, node: actuator, srdo: 1, at: 500 ms}
  - {that: safe, node: actuator.a, srdo: 1, at: 512 ms}
  - {that: safe, node: actuator, srdo: 1, at: 1999 ms}
)");
    // Then CPU A is safe within time-out 10 ms + cycle 1 ms + output 1 ms, and the device until both are restarted
    EXPECT_EQ(Failures(*run), "");
}

TEST(LostPeer, OfADeviceThatIsSwitchedOffAndOnIsThereAgain)
{
    Verifies(req::SRS_SIM_056);
    const auto run = RunTwoCpus(R"(
duration: 2 s
power:
  - {at: 600 ms, node: actuator, off: 100 ms, start_after: 10 ms}
acknowledge:
  - {at: 900 ms, node: actuator, srdo: 1}
faults:
  - {fault: link_cut, node: actuator, at: 500 ms, until: 550 ms}
expect:
  - {that: safe_within, node: actuator, srdo: 1}
  - {that: safe, node: actuator, srdo: 1, at: 890 ms}
  - {that: released, node: actuator, srdo: 1, at: 1990 ms}
)");
    EXPECT_EQ(Failures(*run), "");
}

using BorneByTheLink = ::testing::TestWithParam<const char*>;

TEST_P(BorneByTheLink, ChangesNothing)
{
    Verifies(req::SRS_SIM_057);
    Verifies(req::SRS_LNK_003);
    Verifies(req::SRS_LNK_210);
    const auto run =
        RunTwoCpus(std::string("duration: 2 s\nfaults:\n  - {node: actuator, at: 500 ms, fault: ") + GetParam() +
                   "}\nexpect:\n  - {that: no_fault}\n  - {that: detected_by, node: actuator, by: nobody}\n"
                   "  - {that: released, node: actuator, srdo: 1, at: 1999 ms}\n");
    EXPECT_EQ(Failures(*run), "");
}
INSTANTIATE_TEST_SUITE_P(
    EachWay, BorneByTheLink,
    ::testing::Values("link_loss, every: 20", "link_loss, sender: b, count: 1", "link_loss, probability_ppm: 10000",
                      "link_delay, by: 800 us", "link_delay, by: 3 ms, every: 9",
                      "link_repetition, times: 3, after: 700 us", "link_repetition, times: 50",
                      "link_reordering, every: 2", "link_reordering, sender: a, every: 5",
                      "link_corruption, bits: [64, 65, 900], every: 15", "link_insertion, times: 500, every: 1300 us",
                      "link_insertion, what: earlier, back: 1, times: 500, every: 1300 us",
                      "link_insertion, sender: b, what: earlier, back: 50, times: 500, every: 700 us"));

/// A CPU that always says good, what goes wrong beside it, and who closes.
struct GoodPeer
{
    const char* parts; ///< Of the faults that make it always good.
    const char* cpu;
    const char* fault;
    const char* other;
    const char* by;
};

void PrintTo(const GoodPeer& good, std::ostream* const out)
{
    *out << good.parts << " of CPU " << good.cpu << " always good, then " << good.fault;
}

using AlwaysGoodPeer = ::testing::TestWithParam<GoodPeer>;

TEST_P(AlwaysGoodPeer, LeavesTheFaultToTheOtherCpu)
{
    Verifies(req::SRS_SIM_056);
    Verifies(req::SRS_SIM_033);
    // Given a CPU of which channel, comparator and flow monitor say from 400 ms on that all is well
    const GoodPeer& good = GetParam();
    std::string text = "duration: 2 s\nfaults:\n";
    const std::string parts = good.parts;
    for (std::size_t begin = 0U; begin < parts.size();)
    {
        const std::size_t end = std::min(parts.find(' ', begin), parts.size());
        const std::string part = parts.substr(begin, end - begin);
        text += "  - {fault: always_good, optional: true, name: " + part + ", node: actuator." + good.cpu +
                ", part: " + part + ", at: 400 ms}\n";
        begin = end + 1U;
    }
    // When it should have found this
    text += std::string("  - {name: second, fault: ") + good.fault + "}\nexpect:\n";
    const std::string other = std::string("node: actuator.") + good.other;
    text += "  - {that: safe_within, fault: second, node: actuator, srdo: 1}\n"
            "  - {that: safe_within, fault: second, " +
            other + ", srdo: 1}\n  - {that: detected_by, fault: second, " + other + ", by: " + good.by +
            "}\n  - {that: safe, node: actuator, srdo: 1, at: 1999 ms}\n";
    // Then the other CPU closes in time: its output is in series
    EXPECT_EQ(Failures(*RunTwoCpus(text)), "");
}

constexpr const char* kGoodA = "channel_a comparator flow_monitor guard self_test";
constexpr const char* kGoodB = "channel_b comparator flow_monitor guard self_test";
constexpr const char* kLost = "loss, frames: {sender: controller, from: 500 ms, count: 1000}";
constexpr const char* kChanged = "corruption, frames: {identifier: 0x104, from: 500 ms, count: 1000}, bits: [0]";
constexpr GoodPeer kGoodPeers[] = {
    {kGoodA, "a", kLost, "b", "channel_b"},
    {kGoodB, "b", kLost, "a", "channel_a"},
    {kGoodA, "a", kChanged, "b", "channel_b"},
    {kGoodB, "b", kChanged, "a", "channel_a"},
    {kGoodA, "a", "frozen, node: actuator.b, part: channel_b, at: 500 ms", "b", "comparator"},
    {kGoodB, "b", "frozen, node: actuator.a, part: channel_a, at: 500 ms", "a", "comparator"},
    {kGoodA, "a", "link_cut, node: actuator, at: 500 ms", "b", "cross_link"},
    {kGoodB, "b", "link_cut, node: actuator, at: 500 ms", "a", "cross_link"},
    {"output_gate watchdog", "a", kLost, "b", "[channel_b, comparator, cross_link]"},
    {"output_gate watchdog", "b", kLost, "a", "[channel_a, comparator, cross_link]"},
};
INSTANTIATE_TEST_SUITE_P(EachCpu, AlwaysGoodPeer, ::testing::ValuesIn(kGoodPeers));

using FlippedInACpu = ::testing::TestWithParam<const char*>;

TEST_P(FlippedInACpu, IsFoundByItsSelfTestAndToldToTheOtherCpu)
{
    Verifies(req::SRS_SIM_053);
    Verifies(req::SRS_SIM_056);
    const std::string place = GetParam();
    const auto run = RunTwoCpus("duration: 2500 ms\nfaults:\n  - {fault: bit_flip, " + place + R"(}
expect:
  - {that: safe_within, node: actuator, srdo: 1}
  - {that: detected_by, node: actuator, by: self_test}
  - {that: safe, node: actuator.a, srdo: 1, at: 2499 ms}
  - {that: safe, node: actuator.b, srdo: 1, at: 2499 ms}
)");
    EXPECT_EQ(Failures(*run), "");
}
INSTANTIATE_TEST_SUITE_P(EachPlace, FlippedInACpu,
                         ::testing::Values("at: 500.7 ms, node: actuator.a, part: program, offset: 300",
                                           "at: 501.2 ms, node: actuator.b, part: program, offset: 3000",
                                           "at: 500.7 ms, node: actuator.a, part: stack_guard, offset: 2",
                                           "at: 501.2 ms, node: actuator.b, part: stack_guard, offset: 9",
                                           "at: 500.7 ms, node: actuator.a, part: table_pointer, offset: 0, bit: 4",
                                           "at: 501.2 ms, node: actuator.b, part: table_pointer, offset: 8, bit: 4",
                                           "at: 500.7 ms, node: actuator.a, part: table_pointer, offset: 40, bit: 4",
                                           "at: 501.2 ms, node: actuator.b, part: table_pointer, offset: 48, bit: 4"));
} // namespace
} // namespace counterpoint::simulator
