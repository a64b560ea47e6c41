// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/latency.hpp"
#include "runtime/node/number.hpp"
#include "runtime/node/order.hpp"
#include "runtime/node/script.hpp"
#include "runtime/yaml/document.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <utility>

namespace counterpoint::tools
{
namespace
{

TEST(NodeOrderTest, OrdersAreRead)
{
    Verifies(req::SRS_NODE_003);
    const runtime::NodeOrder set = runtime::ParseOrder("  set 0x2000:0A 0x10 ");
    EXPECT_EQ(set.kind, runtime::OrderKind::kSet);
    EXPECT_EQ(set.object.index, 0x2000U);
    EXPECT_EQ(set.object.sub, 10U);
    EXPECT_EQ(set.value, 16U);
    EXPECT_EQ(runtime::ParseOrder("get 0x1018:01").kind, runtime::OrderKind::kGet);
    EXPECT_EQ(runtime::ParseOrder("ack 64").value, 64U);
    EXPECT_EQ(runtime::ParseOrder("gfc").kind, runtime::OrderKind::kGfc);
    EXPECT_EQ(runtime::ParseOrder("nmt").kind, runtime::OrderKind::kNmt);
    EXPECT_EQ(runtime::ParseOrder("state").kind, runtime::OrderKind::kState);
    EXPECT_EQ(runtime::ParseOrder("help").kind, runtime::OrderKind::kHelp);
    EXPECT_EQ(runtime::ParseOrder("quit").kind, runtime::OrderKind::kQuit);
    EXPECT_EQ(runtime::ParseOrder("").kind, runtime::OrderKind::kNothing);
    EXPECT_EQ(runtime::ParseOrder("# a remark").kind, runtime::OrderKind::kNothing);
    const runtime::NodeOrder command = runtime::ParseOrder("nmt pre-operational 127");
    EXPECT_EQ(command.kind, runtime::OrderKind::kCommand);
    EXPECT_EQ(command.value, 128U);
    EXPECT_EQ(command.node, 127U);
    EXPECT_EQ(runtime::ParseOrder("nmt start").node, 0U);
    const runtime::NodeOrder read = runtime::ParseOrder("read 127 0x1018:01");
    EXPECT_EQ(read.kind, runtime::OrderKind::kRead);
    EXPECT_EQ(read.node, 127U);
    EXPECT_EQ(read.object.index, 0x1018U);
    const runtime::NodeOrder write = runtime::ParseOrder("write 5 0x2000:01 255 1");
    EXPECT_EQ(write.kind, runtime::OrderKind::kWrite);
    EXPECT_EQ(write.value, 255U);
    EXPECT_EQ(write.size_bytes, 1U);
}

TEST(NodeOrderTest, WhatCannotBeUsedIsToldWithWhatWasExpected)
{
    Verifies(req::SRS_NODE_003);
    for (const char* const line : {"set",
                                   "set 0x2000:01",
                                   "set 2000:01 1",
                                   "set 0x2000 1",
                                   "set 0x20000:01 1",
                                   "set 0x2000:100 1",
                                   "set 0x2000:01 -",
                                   "set 0x2000:01 --1",
                                   "set 0x2000:01 -+1",
                                   "set 0x2000:01 -01",
                                   "set 0x2000:01 -0x1",
                                   "write 5 0x2000:01 -1 2",
                                   "set 0x2000:01 x",
                                   "set 0x2000:01 -0X1",
                                   "set 0x2000:01 010",
                                   "set 02000:01 1",
                                   "ack 010",
                                   "nmt start 010",
                                   "set 0x2000:01 1 2",
                                   "get",
                                   "get 0x",
                                   "ack",
                                   "ack 0",
                                   "ack 65",
                                   "nmt go",
                                   "nmt start 0",
                                   "nmt start 128",
                                   "nmt start all",
                                   "nmt start 1 2",
                                   "read",
                                   "read 5",
                                   "read 0 0x2000:01",
                                   "read 128 0x2000:01",
                                   "read x 0x2000:01",
                                   "read 5 2000:01",
                                   "read 5 0x2000:01 1",
                                   "write 5 0x2000:01 1",
                                   "write 5 0x2000:01 1 x",
                                   "write 5 0x2000:01 1 0",
                                   "write 5 0x2000:01 1 9",
                                   "write 5 0x2000:01 256 1",
                                   "write 0 0x2000:01 1 1",
                                   "gfc now",
                                   "go"})
    {
        const runtime::NodeOrder order = runtime::ParseOrder(line);
        EXPECT_EQ(order.kind, runtime::OrderKind::kProblem) << line;
        EXPECT_NE(order.problem.find(", expected "), std::string::npos) << line;
    }
    // What is too much is named, not what is right
    EXPECT_EQ(
        runtime::ParseOrder("nmt start 5 5").problem.find("'5' behind the node-ID of an NMT command, expected nmt "),
        0U);
    EXPECT_EQ(runtime::ParseOrder("nmt go 5 5").problem.find("'go' is no NMT command, expected "), 0U);
}

// INTEGER16: a decimal number is a value, a hexadecimal one its bits, as in files.
TEST(NodeOrderTest, NumbersOfSignedObjectsAreTakenAndToldSigned)
{
    Verifies(req::SRS_NODE_054);
    using cia301::SdoAbort;
    const auto bits = [](const char* const number, const runtime::NumberForm& form)
    {
        const runtime::NumberBits taken =
            runtime::BitsOf(form, runtime::ParseOrder(std::string("set 0x2000:01 ") + number));
        return std::make_pair(taken.abort, taken.bits);
    };
    const runtime::NumberForm i16{true, 16U};
    const runtime::NumberForm i64{true, 64U};
    const runtime::NumberForm other{};
    EXPECT_EQ(bits("-7", i16), std::make_pair(SdoAbort::kNone, std::uint64_t{0xFFF9U}));
    EXPECT_EQ(bits("-0", i16), std::make_pair(SdoAbort::kNone, std::uint64_t{0U}));
    EXPECT_EQ(bits("-32768", i16), std::make_pair(SdoAbort::kNone, std::uint64_t{0x8000U}));
    EXPECT_EQ(bits("-32769", i16).first, SdoAbort::kValueLow);
    EXPECT_EQ(bits("32767", i16), std::make_pair(SdoAbort::kNone, std::uint64_t{0x7FFFU}));
    EXPECT_EQ(bits("32768", i16).first, SdoAbort::kValueHigh);
    EXPECT_EQ(bits("0xFFF9", i16), std::make_pair(SdoAbort::kNone, std::uint64_t{0xFFF9U}));
    EXPECT_EQ(bits("0x10000", i16).first, SdoAbort::kValueHigh);
    EXPECT_EQ(bits("-9223372036854775808", i64), std::make_pair(SdoAbort::kNone, std::uint64_t{1U} << 63U));
    EXPECT_EQ(bits("9223372036854775808", i64).first, SdoAbort::kValueHigh);
    EXPECT_EQ(bits("-1", other).first, SdoAbort::kValueLow);
    EXPECT_EQ(bits("-0", other), std::make_pair(SdoAbort::kNone, std::uint64_t{0U}));
    EXPECT_EQ(bits("18446744073709551615", other), std::make_pair(SdoAbort::kNone, ~std::uint64_t{0U}));
    // What is told; the dictionary has extended the sign, the kernel not
    EXPECT_EQ(runtime::NumberText(i16, 0xFFF9U), "-7");
    EXPECT_EQ(runtime::NumberText(i16, 0xFFFFFFFFFFFFFFF9U), "-7");
    EXPECT_EQ(runtime::NumberText(i16, 0x7FFFU), "32767");
    EXPECT_EQ(runtime::NumberText(i64, std::uint64_t{1U} << 63U), "-9223372036854775808");
    EXPECT_EQ(runtime::NumberText(other, 0xFFF9U), "65529");
    EXPECT_EQ(runtime::NumberJson(i16, 0xFFF9U).dump(), "-7");
    EXPECT_EQ(runtime::NumberJson(i16, 7U).dump(), "7");
    EXPECT_EQ(runtime::NumberJson(i64, std::uint64_t{1U} << 63U).dump(), "-9223372036854775808");
    EXPECT_EQ(runtime::NumberJson(other, ~std::uint64_t{0U}).dump(), "18446744073709551615");
}

TEST(NodeLatencyTest, TellsHowTimesAreSpread)
{
    Verifies(req::SRS_NODE_008);
    runtime::NodeLatency latency;
    EXPECT_NE(latency.Text().find("no pair was released"), std::string::npos);
    for (std::uint64_t us = 1U; us <= 100U; ++us)
    {
        latency.Add(us * 1000U);
    }
    latency.Add(5000000000U); // Five seconds, beyond the finest counts.
    EXPECT_EQ(latency.Count(), 101U);
    EXPECT_EQ(latency.Percentile(50U), 51U);
    EXPECT_EQ(latency.Percentile(99U), 100U);
    EXPECT_EQ(latency.Percentile(100U), 5000000U);
    EXPECT_EQ(latency.Json()["least_us"], 1);
    EXPECT_EQ(latency.Json()["below_us"]["4"], 2);
    EXPECT_NE(latency.Text().find("greatest 5000000"), std::string::npos);
}

class NodeScriptTest : public cia306::test::FolderTest
{
  protected:
    std::string Refusal(const std::string& text)
    {
        try
        {
            static_cast<void>(runtime::ReadNodeScript(File("script.yaml", text)));
        }
        catch (const runtime::YamlError& error)
        {
            return error.what();
        }
        return "accepted";
    }
};

TEST_F(NodeScriptTest, EachOrderHasItsTimeInAScript)
{
    Verifies(req::SRS_NODE_003);
    const runtime::NodeScript script =
        runtime::ReadNodeScript(File("orders.yaml", "steps:\n"
                                                    "  - {at: 1 ms, do: set 0x2000:01 7}\n"
                                                    "  - {at: 2 ms, do: ack 3}\n"
                                                    "  - {at: 3 ms, do: gfc}\n"
                                                    "  - {at: 4 ms, do: get 0x2000:01}\n"
                                                    "  - {at: 5 ms, do: nmt}\n"
                                                    "  - {at: 6 ms, do: state}\n"
                                                    "  - {at: 7 ms, do: quit}\n"));
    constexpr runtime::OrderKind kKinds[] = {
        runtime::OrderKind::kSet, runtime::OrderKind::kAcknowledge, runtime::OrderKind::kGfc, runtime::OrderKind::kGet,
        runtime::OrderKind::kNmt, runtime::OrderKind::kState,       runtime::OrderKind::kQuit};
    ASSERT_EQ(script.steps.size(), 7U);
    for (std::size_t step = 0U; step < 7U; ++step)
    {
        EXPECT_EQ(script.steps[step].order.kind, kKinds[step]) << step;
        EXPECT_EQ(script.steps[step].at_ns, (step + 1U) * 1000000U) << step;
    }
    EXPECT_EQ(script.steps[0].order.value, 7U);
    EXPECT_EQ(script.steps[1].order.value, 3U);
}

TEST_F(NodeScriptTest, StepsAndRulesAreRead)
{
    Verifies(req::SRS_NODE_003);
    const runtime::NodeScript script =
        runtime::ReadNodeScript(File("script.yaml", "logic: [{set: 0x2000:01, op: not, from: [0x2200:01]}]\n"
                                                    "steps:\n"
                                                    "  - {at: 1.5 s, do: set 0x2000:02 1, every: 20 ms}\n"));
    ASSERT_EQ(script.rules.size(), 1U);
    EXPECT_EQ(script.rules[0].operation, runtime::LogicOperation::kNot);
    const runtime::NodeScript more =
        runtime::ReadNodeScript(File("more.yaml", "logic: [{set: 0x2000:01, op: or, from: [0x2200:01, 0x2200:02]}]\n"));
    ASSERT_EQ(more.rules.size(), 1U);
    EXPECT_EQ(more.rules[0].inputs.size(), 2U);
    ASSERT_EQ(script.steps.size(), 1U);
    EXPECT_EQ(script.steps[0].at_ns, 1500000000U);
    EXPECT_EQ(script.steps[0].every_ns, 20000000U);
    EXPECT_EQ(script.steps[0].order.kind, runtime::OrderKind::kSet);
}

// Of two who write an object the last one won without a word.
TEST_F(NodeScriptTest, AnObjectHasOneWriter)
{
    Verifies(req::SRS_NODE_710);
    const std::string file = Path("script.yaml");
    const std::string rule = "{set: 0x2000:01, op: copy, from: [0x2200:01]}";
    const std::string wrong =
        "error: 0x2000:01, which the rule at " + file + ":2:5 sets, expected one writer of each object";
    EXPECT_EQ(Refusal("logic:\n  - " + rule + "\n  - {set: 0x2000:01, op: not, from: [0x2200:02]}\n"),
              file + ":3:5: " + wrong);
    EXPECT_EQ(Refusal("logic:\n  - " + rule + "\nsteps:\n  - {at: 1 s, do: set 0x2000:01 7}\n"),
              file + ":4:5: " + wrong);
    EXPECT_EQ(Refusal("logic:\n  - " + rule + "\n  - {set: 0x2000:02, op: not, from: [0x2200:02]}\n" +
                      "  - {set: 0x2001:01, op: not, from: [0x2200:02]}\n" +
                      "steps: [{at: 1 s, do: set 0x2002:01 7}, {at: 1 s, do: get 0x2000:01}]\n"),
              "accepted");
}

TEST_F(NodeScriptTest, NoStepStandsBehindTheEnd)
{
    Verifies(req::SRS_NODE_712);
    const std::string file = Path("script.yaml");
    const std::string wrong = "error: a step behind 'quit', which is never done, expected one before it";
    // By its time, wherever it stands, and of the same time and later in the list
    EXPECT_EQ(Refusal("steps:\n  - {at: 1 s, do: quit}\n  - {at: 2 s, do: get 0x2000:01}\n"), file + ":3:5: " + wrong);
    EXPECT_EQ(Refusal("steps:\n  - {at: 2 s, do: get 0x2000:01}\n  - {at: 1 s, do: quit}\n"), file + ":2:5: " + wrong);
    EXPECT_EQ(Refusal("steps:\n  - {at: 1 s, do: quit}\n  - {at: 1 s, do: get 0x2000:01}\n"), file + ":3:5: " + wrong);
    EXPECT_EQ(Refusal("steps:\n  - {at: 1 s, do: get 0x2000:01}\n  - {at: 1 s, do: quit}\n"), "accepted");
}

TEST_F(NodeScriptTest, WhatCannotBeUsedIsRefusedWithItsPlace)
{
    Verifies(req::SRS_NODE_009);
    const std::string file = Path("script.yaml");
    EXPECT_EQ(Refusal("steps: [{at: 1 s, do: go}]").find(file + ":1:"), 0U);
    EXPECT_NE(Refusal("steps:\n  - {do: quit}").find(":2:"), std::string::npos);
    EXPECT_NE(Refusal("steps: [{at: 1 s, do: quit, when: now}]").find("unknown key 'when'"), std::string::npos);
    EXPECT_NE(Refusal("stepps: []").find("unknown key"), std::string::npos);
    EXPECT_NE(Refusal("- 1").find("expected a map"), std::string::npos);
    EXPECT_NE(Refusal("steps: [{at: 1, do: quit}]"), "accepted");
    EXPECT_NE(Refusal("steps: [{at: 1 s, do: quit, every: 0 s}]"), "accepted");
    EXPECT_NE(Refusal("logic: [{set: 0x2000:01, op: copy, from: [0x2200:01, 0x2200:02]}]"), "accepted");
    EXPECT_NE(Refusal("logic: [{set: 0x2000:01, op: and, from: []}]"), "accepted");
    EXPECT_EQ(Refusal("steps: [{at: 1 s, at: 2 s, do: quit}]"),
              file + ":1:19: error: key 'at' twice, expected each key once");
    EXPECT_EQ(Refusal("steps: []\nsteps: []"), file + ":2:1: error: key 'steps' twice, expected each key once");
    EXPECT_EQ(Refusal("title: [1]"), file + ":1:8: error: a list, expected a title");
    try
    {
        static_cast<void>(runtime::ReadNodeScript(Path("missing.yaml")));
        ADD_FAILURE() << "expected a refusal";
    }
    catch (const runtime::YamlError& error)
    {
        EXPECT_EQ(error.what(), Path("missing.yaml") + ": error: no such file, expected a script of orders");
    }
    // A step behind the end, also one of the same time; one before it, in whatever order, is none
    const std::string behind = "error: a step behind 'quit', which is never done, expected one before it";
    EXPECT_EQ(Refusal("steps:\n  - {at: 3 s, do: quit}\n  - {at: 4 s, do: state}"), file + ":3:5: " + behind);
    EXPECT_EQ(Refusal("steps:\n  - {at: 3 s, do: quit}\n  - {at: 3 s, do: state}"), file + ":3:5: " + behind);
    EXPECT_EQ(Refusal("steps:\n  - {at: 3 s, do: quit}\n  - {at: 2 s, do: quit}"), file + ":2:5: " + behind);
    EXPECT_EQ(Refusal("steps:\n  - {at: 1 s, do: quit}\n  - {at: 2 s, do: quit}"), file + ":3:5: " + behind);
    EXPECT_EQ(Refusal("steps: [{at: 3 s, do: state}, {at: 3 s, do: quit}, {at: 1 s, do: nmt, every: 1 s}]"),
              "accepted");
    // A name that no file can have is one that cannot be read
    EXPECT_ANY_THROW(static_cast<void>(runtime::ReadNodeScript(Path(std::string(300U, 'x')))));
    EXPECT_EQ(Refusal("steps: [{at: 1 s, do: ''}]"),
              file + ":1:23: error: no order, expected an order such as set 0x2000:01 1");
}
} // namespace
} // namespace counterpoint::tools
