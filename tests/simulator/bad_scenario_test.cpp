// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/input_error.hpp"
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
namespace
{

/// What is added to the chain, and what the one line has to say behind the file name.
struct BadCase
{
    const char* name;
    const char* text;
    const char* message; ///< Its beginning, with line and column.
};

void PrintTo(const BadCase& bad, std::ostream* const out)
{
    *out << bad.name;
}

/// The message of the refusal; empty if there is none.
std::string Refusal(const std::string& file)
{
    try
    {
        const simulator::Run run(file, std::nullopt, std::nullopt, false);
    }
    catch (const YamlError& error)
    {
        return error.what();
    }
    catch (const cia306::InputError& error)
    {
        return error.what();
    }
    return "";
}

using BadScenario = ::testing::TestWithParam<BadCase>;

TEST_P(BadScenario, IsRefusedByOneLineThatNamesThePlace)
{
    Verifies(req::SRS_SIM_010);
    Verifies(req::SRS_SIM_012);
    Verifies(req::SRS_SIM_016);
    Verifies(req::SRS_SIM_075);
    Verifies(req::SRS_SIM_020);
    Verifies(req::SRS_SIM_491);
    // Given a scenario with one thing wrong in it, from line 2 on
    const std::string file = TextFile("extends: " + Examples() + "chain.yaml\n" + GetParam().text);
    // When it is read and built
    const std::string refusal = Refusal(file);
    // Then the line says where, what, and what was expected
    EXPECT_EQ(refusal.substr(0U, file.size() + 1U), file + ":") << refusal;
    EXPECT_EQ(
        refusal.substr(std::min(refusal.size(), file.size() + 1U)).substr(0U, std::string(GetParam().message).size()),
        GetParam().message);
    EXPECT_NE(refusal.find("expected"), std::string::npos) << refusal;
    EXPECT_EQ(refusal.find('\n'), std::string::npos) << refusal;
}

constexpr BadCase kBadCases[] = {
    {"unknown key", "colour: red\n", "2:1: error: unknown key 'colour' in a scenario, expected one of extends, title"},
    {"repeated key", "seed: 1\nseed: 2\n", "3:1: error: key 'seed' twice"},
    {"key of a fault", "faults:\n  - {fault: loss, frames: {identifier: 0x103}, bits: [1]}\n",
     "3:48: error: unknown key 'bits' in a fault"},
    {"every n-th of one frame", "faults:\n  - {fault: loss, frames: {identifier: 0x103, every: 2}}\n",
     "3:54: error: key 'every' where one frame is hit, expected key 'count' beside it"},
    {"end of one frame", "faults:\n  - {fault: loss, frames: {identifier: 0x103, until: 700 ms}}\n",
     "3:54: error: key 'until' where one frame is hit, expected key 'count' beside it"},
    {"pattern of one frame", "faults:\n  - {fault: loss, frames: {identifier: 0x103, on: 30 ms, off: 5 ms}}\n",
     "3:51: error: key 'on' where one frame is hit, expected key 'count' beside it"},
    {"unknown word", "faults:\n  - {fault: explosion}\n",
     "3:13: error: 'explosion', expected one of corruption, repetition"},
    {"number for text", "duration: [1, 2]\n", "2:11: error: a list, expected a time with its unit"},
    {"no unit", "duration: 100\n", "2:11: error: '100', expected a time with its unit such as 10 ms"},
    {"negative time", "duration: -5 ms\n", "2:11: error: '-5 ms', expected a time"},
    {"endless time", "duration: 99999999999999999999 s\n", "2:11: error: '99999999999999999999 s', expected a time"},
    {"number too large", "seed: 18446744073709551616\n",
     "2:7: error: '18446744073709551616', expected a number from 0 to"},
    {"number with text", "seed: 12abc\n", "2:7: error: '12abc', expected a number"},
    {"bit rate", "bitrate: 333333\n", "2:10: error: '333333', expected one of 10000"},
    {"unknown node", "inputs:\n  - {at: 1 ms, node: sensr, object: 0x2000:01, value: 1}\n",
     "3:22: error: node 'sensr' (did you mean 'sensor'?), expected one of sensor, controller, actuator"},
    {"unknown object", "inputs:\n  - {at: 1 ms, node: sensor, object: 0x2000:07, value: 1}\n",
     "3:5: error: object 0x2000:07 in "},
    {"object of the wrong direction", "inputs:\n  - {at: 1 ms, node: actuator, object: 0x2200:01, value: 1}\n",
     "3:5: error: object 0x2200:01 in "},
    {"no object", "inputs:\n  - {at: 1 ms, node: sensor, object: 2000, value: 1}\n",
     "3:38: error: '2000', expected an object such as"},
    {"unknown SRDO", "expect:\n  - {that: safe, node: actuator, srdo: 2, at: 1 ms}\n", "3:5: error: SRDO 2 in "},
    {"SRDO out of range", "expect:\n  - {that: safe, node: actuator, srdo: 65, at: 1 ms}\n",
     "3:40: error: '65', expected a number from 1 to 64"},
    {"after the end", "expect:\n  - {that: safe, node: actuator, srdo: 1, at: 2 s}\n",
     "3:5: error: expectation at 2000 ms, after the end of the run"},
    {"unknown fault", "expect:\n  - {that: safe_within, fault: x, node: actuator, srdo: 1}\n",
     "3:32: error: fault 'x', expected"},
    {"fault not named", "expect:\n  - {that: safe_within, node: actuator, srdo: 1}\n",
     "3:5: error: expectation without key 'fault'"},
    {"missing key", "inputs:\n  - {at: 1 ms, node: sensor, value: 1}\n", "3:5: error: an input without key 'object'"},
    {"list for map", "nodes:\n  - sensor\n", "3:3: error: a list, expected a map with the keys of nodes"},
    {"map for list", "inputs: {at: 1 ms}\n", "2:9: error: a map, expected a list"},
    {"nothing for list", "faults:\n", "2:8: error: nothing, expected a list"},
    {"node twice", "nodes:\n  sensor: {dcf: sensor.dcf}\n", "3:3: error: node 'sensor' twice"},
    {"node without DCF", "nodes:\n  more: {phase: 1 ms}\n", "3:9: error: a node without key 'dcf'"},
    {"corruption of nothing", "faults:\n  - {fault: corruption, frames: {identifier: 1}}\n",
     "3:5: error: corruption that changes nothing"},
    {"bit 64", "faults:\n  - {fault: corruption, frames: {identifier: 1}, bits: [64]}\n",
     "3:57: error: '64', expected a number from 0 to 63"},
    {"nine bytes", "faults:\n  - {fault: insertion, at: 1 ms, identifier: 1, data: [1,2,3,4,5,6,7,8,9]}\n",
     "3:55: error: 9 bytes, expected at most 8"},
    {"latch always good", "faults:\n  - {fault: always_good, node: actuator, part: latch, at: 1 ms}\n",
     "3:48: error: 'latch', expected one of channel_a, channel_b, comparator, flow_monitor, guard"},
    {"half a pattern", "faults:\n  - {fault: bus_off, node: actuator, at: 1 ms, on: 1 ms}\n",
     "3:5: error: an on/off pattern of one part, expected both 'on' and 'off'"},
    {"second controller of one", "faults:\n  - {fault: bus_off, node: actuator, at: 1 ms, controller: 2}\n",
     "3:5: error: controller 2 of a node with one, expected 'controllers: 2' of that node, or a DCF that names two"},
    {"jump and rate", "faults:\n  - {fault: clock, node: actuator, counter: a, at: 1 ms, ppm: 5, jump: 1 ms}\n",
     "3:5: error: clock fault without an effect of its own, expected one of 'stopped: true', 'ppm' and 'jump'"},
    {"rate without a drift", "faults:\n  - {fault: clock, node: actuator, counter: a, at: 1 ms, ppm: 0}\n",
     "3:5: error: clock fault without an effect of its own, expected one of 'stopped: true', 'ppm' and 'jump'"},
    {"acknowledge of a producer", "acknowledge: [{at: 200 ms, node: sensor, srdo: 1, pulse: 50 ms}]\n",
     "2:15: error: SRDO 1 in "},
    {"acknowledge that nobody presses", "acknowledge: [{at: 200 ms, node: actuator, srdo: 1, pulse: 0 ms}]\n",
     "2:60: error: '0 ms', expected a time above 0"},
    {"jump of nothing", "faults:\n  - {fault: clock, node: actuator, counter: a, at: 1 ms, jump: 0 ms}\n",
     "3:64: error: '0 ms', expected a time above 0"},
    {"identifier and SRDO", "faults:\n  - {fault: loss, frames: {identifier: 1, srdo: {node: sensor, srdo: 1}}}\n",
     "3:27: error: both 'identifier' and 'srdo', expected one of them"},
    {"SRDO that is not there", "faults:\n  - {fault: loss, frames: {srdo: {node: sensor, srdo: 9}}}\n",
     "3:5: error: SRDO 9 in "},
    {"key of another kind", "faults:\n  - {fault: loss, frames: {}, by: 3 ms}\n",
     "3:31: error: unknown key 'by' in a fault, expected one of fault, name, optional, frames"},
    {"key without an effect", "faults:\n  - {fault: confirmation, frames: {}, by: 3 ms}\n",
     "3:39: error: key 'by' without an effect in this fault, expected only keys that fit its others"},
    {"receiver of wire_error", "faults:\n  - {fault: wire_error, frames: {identifier: 1, receiver: actuator}}\n",
     "3:49: error: key 'receiver' without an effect in this choice of frames, expected only keys that fit its others"},
    {"controller of wire_error", "faults:\n  - {fault: wire_error, frames: {identifier: 1, controller: 1}}\n",
     "3:49: error: key 'controller' without an effect in this choice of frames, expected only keys that fit its "
     "others"},
    {"receiver of queue_full", "faults:\n  - {fault: queue_full, frames: {identifier: 1, receiver: actuator}}\n",
     "3:49: error: key 'receiver' without an effect in this choice of frames, expected only keys that fit its others"},
    {"controller of queue_full", "faults:\n  - {fault: queue_full, frames: {identifier: 1, controller: 1}}\n",
     "3:49: error: key 'controller' without an effect in this choice of frames, expected only keys that fit its "
     "others"},
    {"receiver of swallowed", "faults:\n  - {fault: swallowed, frames: {identifier: 1, receiver: actuator}}\n",
     "3:48: error: key 'receiver' without an effect in this choice of frames, expected only keys that fit its others"},
    {"controller of swallowed", "faults:\n  - {fault: swallowed, frames: {identifier: 1, controller: 1}}\n",
     "3:48: error: key 'controller' without an effect in this choice of frames, expected only keys that fit its "
     "others"},
    {"receiver of confirmation", "faults:\n  - {fault: confirmation, frames: {identifier: 1, receiver: actuator}}\n",
     "3:51: error: key 'receiver' without an effect in this choice of frames, expected only keys that fit its others"},
    {"controller of confirmation", "faults:\n  - {fault: confirmation, frames: {identifier: 1, controller: 1}}\n",
     "3:51: error: key 'controller' without an effect in this choice of frames, expected only keys that fit its "
     "others"},
    {"receiver of duplicate", "faults:\n  - {fault: duplicate, frames: {identifier: 1, receiver: actuator}}\n",
     "3:48: error: key 'receiver' without an effect in this choice of frames, expected only keys that fit its others"},
    {"controller of duplicate", "faults:\n  - {fault: duplicate, frames: {identifier: 1, controller: 1}}\n",
     "3:48: error: key 'controller' without an effect in this choice of frames, expected only keys that fit its "
     "others"},
    {"time between one frame of insertion",
     "faults:\n  - {fault: insertion, at: 1 ms, identifier: 1, times: 1, every: 3 ms}\n",
     "3:59: error: key 'every' without an effect in this fault, expected only keys that fit its others"},
    {"time between one frame of masquerade",
     "faults:\n  - {fault: masquerade, at: 1 ms, identifier: 1, times: 1, every: 3 ms, node: sensor}\n",
     "3:60: error: key 'every' without an effect in this fault, expected only keys that fit its others"},
    {"state and command", "nmt:\n  - {at: 1 ms, node: all, state: stopped, command: stop}\n",
     "3:5: error: an NMT event, expected either 'state' or 'command'"},
    {"power for no time", "power:\n  - {at: 1 ms, node: sensor, off: 0 ms}\n",
     "3:35: error: '0 ms', expected a time above 0"},
    {"three controllers", "nodes:\n  d: {dcf: x.dcf, controllers: 3}\n",
     "3:32: error: '3', expected a number from 1 to 2"},
    {"comes and goes too often", "faults:\n  - {fault: bus_off, node: actuator, at: 1 ms, on: 1 us, off: 1 us}\n",
     "3:5: error: fault 'bus_off' that comes and goes 499500 times, expected at most 100000"},
    {"input after the end", "inputs:\n  - {at: 1000 ms, node: sensor, object: 0x2000:01, value: 0}\n",
     "3:5: error: input at 1000 ms, not before the end of the run, expected a time below 1000 ms"},
    {"input after a short end",
     "duration: 0.0000001 s\ninputs:\n  - {at: 100 ms, node: sensor, object: 0x2000:01, value: 0}\n",
     "4:5: error: input at 100 ms, not before the end of the run, expected a time below 100 ns"},
    {"fault after the end", "faults:\n  - {fault: loss, frames: {from: 2 s}}\n",
     "3:5: error: fault 'loss' at 2000 ms, not before the end of the run, expected a time below 1000 ms"},
    {"acknowledge after the end", "acknowledge:\n  - {at: 1000 ms, node: actuator, srdo: 1}\n",
     "3:5: error: acknowledge at 1000 ms, not before the end of the run, expected a time below 1000 ms"},
    {"NMT command after the end", "nmt:\n  - {at: 1000 ms, node: actuator, command: stop}\n",
     "3:5: error: NMT event at 1000 ms, not before the end of the run, expected a time below 1000 ms"},
    {"GFC after the end", "gfc:\n  - {at: 1000 ms, node: sensor}\n",
     "3:5: error: GFC event at 1000 ms, not before the end of the run, expected a time below 1000 ms"},
    {"power cycle after the end", "power:\n  - {at: 1000 ms, node: sensor, off: 1 ms}\n",
     "3:5: error: power cycle at 1000 ms, not before the end of the run"},
    {"until before at", "faults:\n  - {fault: frozen, node: actuator, part: guard, at: 5 ms, until: 5 ms}\n",
     "3:67: error: '5 ms', expected a time after 'at'"},
    {"two places of a bit",
     "faults:\n  - {fault: bit_flip, node: actuator, part: channel_a, at: 1 ms, offset: 1, config: {srdo: 1, field: "
     "sct}}\n",
     "3:5: error: both 'offset' and 'config'"},
    {"bit that is not kept",
     "faults:\n  - {fault: bit_flip, node: actuator, part: channel_a, at: 1 ms, config: {srdo: 1, field: sct}, bit: "
     "31}\n",
     "3:5: error: bit 31 of that value"},
    {"copy of two", "logic:\n  - {node: controller, set: 0x2000:01, op: copy, from: [0x2200:01, 0x2200:02]}\n",
     "3:56: error: 2 objects, expected one object"},
    {"alias", "title: &a b\ndescription: *a\n", "3:14: error: alias, expected the value itself"},
    {"recursive alias", "inputs: &a [*a]\n", "2:13: error: alias"},
    {"tag", "title: !!binary aGFsbG8=\n", "2:8: error: tag "},
    {"second document", "title: a\n---\ntitle: b\n", "4:1: error: a second document"},
    {"unclosed list", "inputs: [\n", "3:1: error: not YAML"},
    {"unclosed quote", "title: \"abc\n", "2:8: error: quoted text without an end, expected a closing \""},
    {"bad indentation", "inputs:\n  - at: 1 ms\n node: x\n", "4:2: error: not YAML"},
    {"tab", "inputs:\n\t- x\n", "3:2: error: not YAML"},
    {"control character", "title: a\x01z\n", "2:9: error: byte 0x1, expected UTF-8 text"},
    {"not UTF-8", "title: \xC3(\n", "2:8: error: byte 0xc3, expected UTF-8 text"},
    {"unknown state", "nmt:\n  - {at: 1 ms, node: all, state: dancing}\n",
     "3:34: error: 'dancing', expected one of initialising"},
};

INSTANTIATE_TEST_SUITE_P(EachMistake, BadScenario, ::testing::ValuesIn(kBadCases));

constexpr BadCase kImpossibleCases[] = {
    {"overlap on a part",
     "faults:\n  - {fault: frozen, node: actuator, part: guard, at: 1 ms, until: 9 ms}\n"
     "  - {fault: not_called, node: actuator, part: guard, at: 8 ms}\n",
     "4:5: error: fault 'not_called' overlaps 'frozen'"},
    {"overlap on a counter",
     "faults:\n  - {fault: clock, node: actuator, counter: b, ppm: 5, at: 1 ms}\n"
     "  - {fault: clock, node: actuator, counter: b, ppm: 9, at: 8 ms}\n",
     "4:5: error: fault 'clock' overlaps 'clock'"},
    {"overlap on an object",
     "faults:\n  - {fault: not_inverse, node: sensor, object: 0x2000:01, bits: [0], at: 1 ms}\n"
     "  - {fault: not_inverse, node: sensor, object: 0x2000:01, bits: [1], at: 1 ms}\n",
     "4:5: error: fault 'not_inverse' overlaps 'not_inverse'"},
    {"node-ID twice", "nodes:\n  more: {dcf: EXAMPLES/sensor.dcf}\n", "3:15: error: node-ID 1, which sensor has"},
    {"fault of two names",
     "faults:\n  - {fault: loss, frames: {identifier: 1}}\n  - {fault: loss, frames: {identifier: 2}}\n"
     "expect:\n  - {that: safe_within, fault: loss, node: actuator, srdo: 1}\n",
     "6:5: error: fault 'loss', which is the name of several"},
    {"value of nine bits", "inputs:\n  - {at: 1 ms, node: sensor, object: 0x2000:01, value: 256}\n",
     "3:5: error: value 256 for object 0x2000:01, expected a value of 8 bits"},
    {"expected value of nine bits",
     "expect:\n  - {that: value, node: actuator, object: 0x2200:01, is: 0x1FF, at: 5 ms}\n",
     "3:5: error: value 511 for object 0x2200:01, expected a value of 8 bits"},
    {"bit of no object", "faults:\n  - {fault: not_inverse, node: sensor, object: 0x2000:01, bits: [8], at: 1 ms}\n",
     "3:5: error: value 256 for object 0x2000:01, expected a value of 8 bits"},
    {"offset of no storage",
     "faults:\n  - {fault: bit_flip, node: actuator, part: channel_a, at: 1 ms, offset: 999999}\n",
     "3:5: error: offset 999999, expected an offset below "},
    {"long identifier of a short frame", "faults:\n  - {fault: insertion, at: 1 ms, identifier: 0x800}\n",
     "3:5: error: a frame of 11-bit identifier with identifier 0x800, expected an identifier up to 0x7FF"},
    {"CAN FD sent by a node",
     "faults:\n  - {fault: masquerade, node: sensor, at: 1 ms, identifier: 1, kind: flexible_data_rate}\n",
     "3:5: error: masquerade with a CAN FD frame"},
    {"counter at rest", "nodes:\n  more: {dcf: x.dcf, counter_a: {ppm: -1000000}}\n",
     "3:39: error: a counter that stands still from the start"},
    {"escape sequence", "title: \"a\\e[31mb\"\n", "2:8: error: text with a character that is not printable"},
    {"C1 control", "title: \"a\\u009bb\"\n", "2:8: error: text with a character that is not printable"},
    {"hung for a while", "faults:\n  - {fault: hung, node: actuator, part: guard, at: 1 ms, until: 9 ms}\n",
     "3:58: error: unknown key 'until' in a fault"},
    {"sixteen repetitions", "faults:\n  - {fault: repetition, frames: {identifier: 1}, times: 16}\n",
     "3:57: error: '16', expected a number from 1 to 15"},
    {"count of a late cycle", "faults:\n  - {fault: cycle, node: actuator, at: 1 ms, late: 1 ms, count: 2}\n",
     "3:58: error: unknown key 'count' in a fault"},
    {"line end in a title", "title: \"a\\nb\"\n", "2:8: error: text with a line end or tabulator"},
};

using ImpossibleScenario = ::testing::TestWithParam<BadCase>;

TEST_P(ImpossibleScenario, IsRefusedBeforeItRuns)
{
    Verifies(req::SRS_SIM_014);
    // Given a scenario that asks for what cannot happen
    std::string text = GetParam().text;
    const std::size_t place = text.find("EXAMPLES/");
    text = (place == std::string::npos) ? text : text.replace(place, 9U, Examples());
    const std::string file = TextFile("extends: " + Examples() + "chain.yaml\n" + text);
    // When it is read and built; then the line says what and where
    const std::string refusal = Refusal(file);
    EXPECT_EQ(refusal.substr(0U, file.size() + 1U + std::string(GetParam().message).size()),
              file + ":" + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(EachReason, ImpossibleScenario, ::testing::ValuesIn(kImpossibleCases));

TEST(ImpossibleScenario, ShortenedRunRefusesLaterExpectations)
{
    Verifies(req::SRS_SIM_014);
    const std::string file = Examples() + "00_no_fault.yaml";
    EXPECT_THROW(simulator::Run(file, std::nullopt, 300 * kNanosecondsPerMillisecond, false), YamlError);
}

TEST(ImpossibleScenario, FaultsOneAfterTheOtherAreLeftAlone)
{
    Verifies(req::SRS_SIM_014);
    EXPECT_EQ(Refusal(TextFile("extends: " + Examples() + R"(chain.yaml
faults:
  - {fault: frozen, node: actuator, part: guard, at: 1 ms, until: 9 ms}
  - {fault: not_called, node: actuator, part: guard, at: 9 ms}
  - {fault: not_called, node: sensor, part: guard, at: 5 ms}
)")),
              "");
}

TEST(BadScenarioFile, MissingFolderEmptyOrTooLargeIsRefused)
{
    Verifies(req::SRS_SIM_010);
    EXPECT_EQ(Refusal("/nonexistent/x.yaml"), "/nonexistent/x.yaml: error: no such file, expected a YAML file");
    EXPECT_EQ(Refusal(Examples()), Examples() + ": error: not a regular file, expected a YAML file");
    EXPECT_EQ(Refusal("/dev/zero"), "/dev/zero: error: not a regular file, expected a YAML file");
    const std::string empty = TextFile("");
    EXPECT_EQ(Refusal(empty), empty + ":1:1: error: no document, expected a map of keys and values");
    const std::string large = TextFile(std::string(1048577U, '#'));
    EXPECT_EQ(Refusal(large), large + ": error: 1048577 bytes, expected at most 1048576");
    const std::string nothing = TextFile("title: x\n");
    EXPECT_EQ(Refusal(nothing), nothing + ":1:1: error: no nodes, expected key 'nodes' with at least one node");
}

TEST(BadScenarioFile, BaseThatExtendsOrIsMissingIsRefused)
{
    Verifies(req::SRS_SIM_013);
    // Given a scenario that extends itself
    const std::string own =
        ::testing::TempDir() + "counterpoint_BadScenarioFile_BaseThatExtendsOrIsMissingIsRefused.yaml";
    const std::string file = TextFile("extends: " + own + "\n");
    EXPECT_EQ(Refusal(file),
              file + ":1:10: error: a scenario that extends another one, expected none here: one step only");
    const std::string lost = TextFile("extends: /nonexistent/y.yaml\n");
    EXPECT_EQ(Refusal(lost), lost + ":1:10: error: there is no file '/nonexistent/y.yaml', expected a scenario");
}

TEST(BadScenarioFile, WhatItNamesAndCannotBeReadIsToldAtItsName)
{
    Verifies(req::SRS_SIM_081);
    const std::string device = TextFile("duration: 1 s\nnodes:\n  a: {dcf: /nonexistent/a.dcf}\n");
    EXPECT_EQ(Refusal(device), device + ":3:12: error: there is no file '/nonexistent/a.dcf', expected a DCF");
    const std::string folder = TextFile("duration: 1 s\nnodes:\n  a: {dcf: /dev}\n");
    EXPECT_EQ(Refusal(folder), folder + ":3:12: error: '/dev' is no regular file, expected a DCF");
    const std::string managed =
        TextFile("duration: 1 s\nmanagers: [{network: /nonexistent/n.yaml}]\nnodes:\n  1: {dcf: /dev}\n");
    EXPECT_EQ(Refusal(managed),
              managed + ":2:22: error: there is no file '/nonexistent/n.yaml', expected a network file");
}

TEST(BadScenarioFile, DeepOrWideNestingEndsSoon)
{
    Verifies(req::SRS_SIM_012);
    for (const char* const piece : {"[", "{", "- ", "? ", "a: ", "[a,", "{a: ", "\"", "'",   "|",
                                    ">", "&", "*",  "!",  "%",   "@",   "`",    "\n", "a\n", ": "})
    {
        // Given a file that repeats one piece of YAML 100000 times
        std::string text;
        for (int time = 0; time < 100000; ++time)
        {
            text += piece;
        }
        // Then there is one refusal
        EXPECT_NE(Refusal(TextFile(text)), "") << piece;
    }
}

TEST(BadScenarioFile, EveryTruncationEndsInAResultOrARefusal)
{
    Verifies(req::SRS_SIM_012);
    const std::string whole = runtime::ReadYamlText(Examples() + "chain.yaml");
    std::size_t refused = 0U;
    for (std::size_t length = 0U; length < whole.size(); ++length)
    {
        refused += Refusal(TextFile(whole.substr(0U, length))).empty() ? 0U : 1U;
    }
    EXPECT_GT(refused, 100U);
}

TEST(BadDevice, IsReportedWithFileAndObject)
{
    Verifies(req::SRS_SIM_002);
    // Given the actuator's DCF with another SCT, so that its signature is wrong
    std::string dcf = runtime::ReadYamlText(Examples() + "actuator.dcf");
    const std::size_t section = dcf.find("[1301sub2]");
    const std::size_t value = dcf.find("ParameterValue=50", section);
    ASSERT_NE(value, std::string::npos);
    dcf.replace(value, 17U, "ParameterValue=49");
    const std::string device = ::testing::TempDir() + "counterpoint_bad.dcf";
    std::ofstream(device, std::ios::binary) << dcf;
    // When it is simulated
    const std::string refusal = Refusal(TextFile("duration: 1 s\nnodes:\n  a: {dcf: " + device + "}\n"));
    // Then A5h is refused with its line
    EXPECT_EQ(refusal.substr(0U, device.size() + 1U), device + ":");
    EXPECT_NE(refusal.find("0x13FE:00: the device refuses 0xA5 with abort code 0604 0043h"), std::string::npos)
        << refusal;
}

TEST(ImpossibleFault, IsRefusedAtTheValueThatCannotBe)
{
    Verifies(req::SRS_SIM_014);
    Verifies(req::SRS_SIM_012);
    Verifies(req::SRS_SIM_080);
    struct Case
    {
        const char* fault;
        const char* message; ///< Its beginning, with line and column.
    };
    for (const Case& impossible : {
             Case{"insertion, at: 1 s, identifier: 1, times: 1000, every: 10000000 s",
                  "3:68: error: '10000000 s', expected a time that fits 1000 times into 10000000 s"},
             Case{"insertion, at: 1 s, identifier: 1, times: 2, every: 0 s",
                  "3:65: error: '0 s', expected a time above 0"},
             Case{"repetition, frames: {identifier: 0x103}, times: 16",
                  "3:61: error: '16', expected a number from 1 to 15"},
             Case{"delay, frames: {identifier: 0x103}, by: 0 ms", "3:53: error: '0 ms', expected a time above 0"},
             Case{"cycle, node: actuator, late: 0 s, at: 5 ms", "3:42: error: '0 s', expected a time above 0"},
             Case{"cycle, node: actuator, late: 1 ms, at: 5 ms, count: 5",
                  "3:58: error: unknown key 'count' in a fault"},
             Case{"clock, node: actuator, counter: a, stopped: maybe, at: 5 ms",
                  "3:57: error: 'maybe', expected one of true, false"},
             Case{"not_inverse, node: controller, object: 0x2000:01, bits: [], at: 5 ms", "3:69: error: an empty list"},
             Case{"corruption, frames: {identifier: 0x103}, bits: [0, 0]",
                  "3:64: error: 0 a second time, expected each number once"},
             Case{"corruption, frames: {identifier: 0x103}, bits: [7, 0x10, 16]",
                  "3:70: error: 16 a second time, expected each number once"},
             Case{"not_inverse, node: controller, object: 0x2000:01, bits: [3, 3], at: 5 ms",
                  "3:73: error: 3 a second time, expected each number once"},
             Case{"confirmation, frames: {identifier: 0x103}, how: wrong, bits: [1, 1]",
                  "3:78: error: 1 a second time, expected each number once"},
         })
    {
        // Given a fault with one value that the simulator could not do as it is written
        const std::string file =
            TextFile("extends: " + Examples() + "chain.yaml\nfaults:\n  - {fault: " + impossible.fault + "}\n");
        // When it is read, then the line names the value
        const std::string refusal = Refusal(file);
        EXPECT_EQ(refusal.rfind(file + ":" + impossible.message, 0U), 0U) << refusal;
    }
}

TEST(ImpossibleFault, NodeIsNotCalledBus)
{
    Verifies(req::SRS_SIM_014);
    const std::string file = TextFile("duration: 1 s\nnodes:\n  bus: {dcf: sensor.dcf}\n");
    EXPECT_EQ(Refusal(file), file + ":3:3: error: node name 'bus', expected a name other than 'all' and 'bus'");
}

TEST(ScenarioFileName, IsShownInOnePrintableLineWithTheReason)
{
    Verifies(req::SRS_SIM_010);
    EXPECT_EQ(Refusal("no\nsuch\x1B.yaml"), "no\\x0Asuch\\x1B.yaml: error: no such file, expected a YAML file");
    const std::string loop = ::testing::TempDir() + "counterpoint_loop.yaml";
    std::filesystem::remove(loop);
    std::filesystem::create_symlink(loop, loop);
    EXPECT_EQ(Refusal(loop),
              loop + ": error: cannot be opened (Too many levels of symbolic links), expected a readable file");
    std::filesystem::remove(loop);
}

TEST(FaultWithoutEffect, IsOneThatLeavesTheFrameAsItIs)
{
    Verifies(req::SRS_SIM_015);
    // Given faults that change nothing: a bit behind the last byte, the identifier or rate it has anyway
    for (const char* const fault :
         {"corruption, frames: {identifier: 0x103}, bits: [63]", "addressing, frames: {identifier: 0x103}, as: 0x103",
          "clock, node: actuator, counter: a, ppm: 5, at: 500 ms"})
    {
        // When somebody expects that nobody notices it
        const auto run = RunChain("faults:\n  - {fault: " + std::string(fault) +
                                  "}\nexpect:\n  - {that: detected_by, node: actuator, by: nobody}\n");
        // Then that does not hold, and the fault is told
        const std::string kind = std::string(fault).substr(0U, std::string(fault).find(','));
        EXPECT_EQ(Failures(*run), "detected at actuator by nobody: the fault never happened\nfault '" + kind +
                                      "' happens: never happened\n")
            << fault;
        EXPECT_EQ(run->FaultsWithoutEffect().size(), 1U) << fault;
    }
    // And a fault that came is not
    EXPECT_TRUE(RunChain("faults:\n  - {fault: loss, frames: {identifier: 0x103}}\n")->FaultsWithoutEffect().empty());
}

/// When the only fault of a run had its effect; -1: never.
Nanoseconds EffectIn(const Run& run)
{
    for (const Event& event : run.Record().Events())
    {
        if (event.kind == EventKind::kFault)
        {
            return event.at;
        }
    }
    return -1;
}

const std::string kOff = "power: [{at: 400 ms, node: actuator, off: 100 ms, start_after: 10 ms}]\n";

TEST(FaultWithoutSupply, OfOneInstantHasNoEffect)
{
    Verifies(req::SRS_SIM_063);
    for (const char* const fault :
         {"bit_flip, node: actuator, part: channel_a", "clock, node: actuator, counter: a, jump: 1 s",
          "cycle, node: actuator, late: 10 ms", "standstill, node: actuator",
          "insertion, receiver: actuator, identifier: 0x103, data: [0]"})
    {
        const std::string head = kOff + "faults:\n  - {fault: " + fault;
        // Given a fault while the device is off, then it never happens
        EXPECT_EQ(EffectIn(*RunChain(head + ", at: 450 ms}\n")), -1) << fault;
        // And at the instant at which the supply is back it does
        EXPECT_EQ(EffectIn(*RunChain(head + ", at: 500 ms}\n")), 500000000) << fault;
    }
}

TEST(FaultWithoutSupply, ThatLastsHasItsEffectWhenTheSupplyComes)
{
    Verifies(req::SRS_SIM_063);
    for (const char* const fault :
         {"unplugged, node: actuator", "bus_off, node: actuator", "clock, node: actuator, counter: a, ppm: 50000"})
    {
        const std::string head = kOff + "faults:\n  - {fault: " + fault;
        // Given a fault that begins while the device is off
        EXPECT_EQ(EffectIn(*RunChain(head + ", at: 450 ms}\n")), 500000000) << fault;
        // One that is over by then never happens
        EXPECT_EQ(EffectIn(*RunChain(head + ", at: 420 ms, until: 480 ms}\n")), -1) << fault;
    }
}

TEST(FaultOfAController, OutlastsAPowerCycle)
{
    Verifies(req::SRS_SIM_064);
    for (const char* const fault : {"unplugged", "bus_off"})
    {
        // Given a device whose supply blinks while its controller is off the bus
        const auto run = RunChain("power: [{at: 500 ms, node: actuator, off: 20 ms, start_after: 10 ms}]\n"
                                  "acknowledge: [{at: 600 ms, node: actuator, srdo: 1, pulse: 50 ms},\n"
                                  "  {at: 950 ms, node: actuator, srdo: 1, pulse: 20 ms}]\n"
                                  "faults: [{fault: " +
                                  std::string(fault) +
                                  ", node: actuator, at: 400 ms, until: 900 ms}]\n"
                                  "expect: [{that: safe, node: actuator, srdo: 1, at: 800 ms},\n"
                                  "  {that: released, node: actuator, srdo: 1, at: 990 ms}]\n");
        // Then no acknowledge opens its output before the fault is over
        EXPECT_EQ(Failures(*run), "") << fault;
    }
}

TEST(FaultOfAController, IsTheOnlyOneThereAtATime)
{
    Verifies(req::SRS_SIM_064);
    const std::string first = "faults:\n  - {fault: bus_off, node: actuator, at: 400 ms, until: 500 ms}\n";
    for (const char* const other : {"unplugged", "queue_overflow"})
    {
        const std::string second = std::string("  - {fault: ") + other + ", node: actuator, at: ";
        const std::string file =
            TextFile("extends: " + Examples() + "chain.yaml\n" + first + second + "450 ms, until: 600 ms}\n");
        EXPECT_EQ(Refusal(file), file + ":4:5: error: fault '" + other +
                                     "' overlaps 'bus_off' on the same part, counter, object or controller, expected "
                                     "one fault there at a time");
        EXPECT_EQ(
            Refusal(TextFile("extends: " + Examples() + "chain.yaml\n" + first + second + "500 ms, until: 600 ms}\n")),
            "");
    }
}
} // namespace
} // namespace counterpoint::simulator
