// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Scenarios of networks that are malformed, would do nothing, or hold whatever happens: one line each, file:line.
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace counterpoint::tools
{
namespace
{
using test::Answer;
using test::RunCommand;

/// What stands in line 4 and on, and the message behind the name of the file.
using BadPart = std::pair<const char*, const char*>;

constexpr BadPart kMalformed[] = {
    {"events: [{at: 1 s, do: explode, node: 1}]", ":4:24: error: 'explode', expected one of pull, insert"},
    {"events: [{at: 1 s, do: pull}]", ":4:10: error: an event without key 'node', expected that key"},
    {"events: [{do: pull, node: 33}]", ":4:10: error: an event without key 'at', expected that key"},
    {"events: [{at: 1 s, do: order, order: fly}]", ":4:38: error: order 'fly', expected status, start"},
    {"expect: [{that: state, node: 1, is: stopped, at: 3 s}]",
     ":4:10: error: expectation at 3000 ms, after the end of the run, expected a time up to 2000 ms"},
    {"expect: [{that: active, manager: 9, is: true}]", ":4:10: error: no manager with node-ID 9"},
    {"speed: 3",
     ":4:1: error: unknown key 'speed' (did you mean 'seed'?) in a scenario, expected one of extends, title, "
     "description"},
    {"bitrate: 5", ":4:10: error: '5', expected a number from 10000 to 1000000"},
    {"bitrate: 10001", ":4:10: error: '10001', expected one of 10000, 20000"},
    {"title: y", ":4:1: error: key 'title' twice, expected each key once"},
    {"events: {at: 1 s}", ":4:9: error: a map, expected a list"},
    {"events: [pull]", ":4:10: error: 'pull', expected a map with the keys of an event"},
    {"events: [{at: 0 s, do: babble, identifier: 1, every: 0 s, until: 1 s}]",
     ":4:54: error: '0 s', expected a time above 0"},
    {"events: [{at: 500 ms, do: emcy_storm, node: 1, until: 1 ms}]", ":4:10: error: an end before the beginning"},
    {"events: [{at: 0 s, do: send}]", ":4:10: error: an event without key 'identifier', expected that key"},
    {"events: [{at: 0 s, do: babble, until: 1 s}]",
     ":4:10: error: an event without key 'identifier', expected that key"},
    {"events: [{at: 0 s, do: send, identifier: 0, data: 1}]", ":4:51: error: '1', expected up to 8 bytes of two"},
    {"events: [{at: 0 s, do: send, identifier: 0, data: 0g}]", ":4:51: error: '0g', expected up to 8 bytes"},
    {"events: [{at: 0 s, do: send, identifier: 0x800}]", ":4:42: error: '0x800', expected a number from 0 to 2047"},
    {"events: [{at: 0 s, do: bus_off}]", ":4:10: error: an event without key 'until', expected that key"},
    {"events: [{at: 0 s, do: replace, node: 33}]", ":4:10: error: an event without key 'serial', expected that key"},
    {"events: [{at: 0 s, do: no_controller, until: 1 s, node: 9}]", ":4:10: error: no manager with node-ID 9"},
    {"events: [{at: 2 s, do: order, order: start all}]",
     ":4:10: error: order at 2000 ms, not before the end of the run, expected a time below 2000 ms"},
    {"events: [{at: 0 s, do: pull, node: 9}]", ":4:36: error: node '9', expected one of 33, 2, 5"},
    {"events: [{at: 0 s, do: kill_manager, node: 9}]", ":4:10: error: no manager with node-ID 9"},
    {"expect: [{that: no_event, is: heartbeat_lots}]",
     ":4:31: error: 'heartbeat_lots' (did you mean 'heartbeat_lost'?), expected one of boot_up"},
    {"expect: [{that: no_event, is: gate, from: 9 ms, until: 8 ms}]", ":4:10: error: a window that ends before"},
    {"expect: [{that: output, node: 9, is: closed}]", ":4:31: error: node '9', expected one of 33, 2, 5"},
    {"expect: [{that: state, node: 9, is: stopped}]", ":4:10: error: node 9, which is no slave of manager 127"},
    {"expect: [{that: no_event, node: 9, is: gate}]", ":4:10: error: node 9, which is no slave of manager"},
};

constexpr BadPart kIdle[] = {
    // Keys that the event or the expectation does not look at
    {"events: [{at: 0 s, do: pull, node: 33, serial: 3}]",
     ":4:40: error: unknown key 'serial' in an event, expected one of"},
    {"events: [{at: 0 s, do: send, identifier: 1, every: 1 ms}]",
     ":4:52: error: one of 'every' and 'until', expected both"},
    {"expect: [{that: state, node: 33, is: stopped, from: 1 s}]", ":4:47: error: unknown key 'from' in an expectation"},
    {"expect: [{that: event, is: gate, at: 1 s}]", ":4:34: error: unknown key 'at' in an expectation, expected one of"},
    {"expect: [{that: active, node: 33, is: true}]", ":4:25: error: unknown key 'node' in an expectation"},
    {"expect: [{that: device, node: 33, is: stopped, manager: 127}]",
     ":4:48: error: unknown key 'manager' in an expectation"},
    // Events of what is not there then, or is there already
    {"events: [{at: 1 s, do: insert, node: 33}]",
     ":4:10: error: insert of device 33, which is there, expected a pull before"},
    {"events: [{at: 1 s, do: insert, node: 33}, {at: 500 ms, do: pull, node: 33}, {at: 1500 ms, do: insert, node: 33}]",
     ":4:77: error: insert of device 33, which is there, expected a pull before it"},
    {"events: [{at: 0 s, do: pull, node: 33}, {at: 1 s, do: pull, node: 33}]",
     ":4:41: error: pull of device 33, which is not there, expected an insert before it"},
    {"events: [{at: 0 s, do: pull, node: 33}, {at: 1 s, do: duplicate, node: 33}]",
     ":4:41: error: duplicate of device 33, which is not there"},
    {"events: [{at: 0 s, do: pull, node: 2}]",
     ":4:10: error: pull of device 2 before it comes, expected a time from its 'phase'"},
    {"events: [{at: 0 s, do: kill_manager, node: 127}, {at: 1 s, do: order, order: start 33}]",
     ":4:50: error: an event of manager 127 after it was killed, expected a time at which it is there"},
    {"events: [{at: 0 s, do: bus_off, until: 1 s}, {at: 500 ms, do: no_controller, until: 1 s}]",
     ":4:46: error: manager 127 is off the bus already, expected a time after the 'until' before it"},
    {"events: [{at: 1 s, do: bus_off, until: 2001 ms}]",
     ":4:10: error: an end after that of the scenario, expected a time within its duration behind 'until'"},
    {"events: [{at: 1 s, do: no_controller, until: 3 s}]", ":4:10: error: an end after that of the scenario"},
    {"events: [{at: 0 s, do: order, order: status}]", ":4:38: error: order 'status', which does nothing here"},
    {"events: [{at: 0 s, do: order, order: '# start 33'}]",
     ":4:38: error: order '# start 33', which does nothing here"},
    // What the device does not have
    {"events: [{at: 0 s, do: store, node: 33, object: '0x5FFF:00', value: 1}]",
     ":4:10: error: object 0x5FFF:00 of device 33, which its DCF does not have, expected an object of "},
    {"events: [{at: 0 s, do: store, node: 33, object: '0x1017:00', value: 65536}]",
     ":4:10: error: value 65536 for object 0x1017:00 of device 33, expected one of 16 bits"},
    {"events: [{at: 0 s, do: acknowledge, node: 33, srdo: 9}]",
     ":4:10: error: SRDO 9 of device 33, which has no such output"},
    {"expect: [{that: output, node: 33, srdo: 64, is: closed}]",
     ":4:10: error: SRDO 64 of device 33, which has no such"},
    {"expect: [{that: output, node: 5, is: closed}]",
     ":4:10: error: SRDO 1 of device 5, which has no such output, expected the"},
    // Values that are never found
    {"expect: [{that: state, node: 33, is: banana}]",
     ":4:38: error: 'banana', expected one of unknown, missing, stopped"},
    {"expect: [{that: device, node: 33, is: running}]",
     ":4:39: error: 'running', expected one of absent, initialising"},
    {"expect: [{that: letter, node: 33, is: P}]", ":4:39: error: 'P', expected one of none, A, B, C"},
    {"expect: [{that: gate, node: 33, is: opened}]",
     ":4:37: error: 'opened' (did you mean 'open'?), expected one of closed, busy, differs"},
    {"expect: [{that: output, node: 33, is: shut}]", ":4:39: error: 'shut', expected one of open, closed"},
    {"expect: [{that: active, is: yes}]", ":4:29: error: 'yes', expected one of true, false"},
    {"expect: [{that: finding, node: 33, is: 1018}]", ":4:40: error: '1018', expected an object such as 0x2000:01"},
    {"expect: [{that: code, node: 33, is: 0}]",
     ":4:10: error: a code of manager 127 with the profile cia302, expected 'letter'"},
    {"expect: [{that: no_event, is: pdo}]", ":4:10: error: event 'pdo' of manager 127 with the profile cia302"},
    {"expect: [{that: no_event, is: master, node: 33}]",
     ":4:10: error: event 'master' of a node, expected it without 'node'"},
    {"expect: [{that: flying, is: none}]",
     ":4:10: error: events of the election at manager 127, which is no flying master"},
    {"expect: [{that: flying, is: 3 6}]", ":4:29: error: '6', expected none, or numbers from 1 to 5 such as 3 4"},
    {"expect: [{that: flying, is: 3 none}]", ":4:29: error: 'none', expected none, or numbers from 1 to 5"},
    {"expect: [{that: gate, node: 5, is: closed}]",
     ":4:10: error: the gate of node 5, which has no safety configuration"},
    {"expect: [{that: active, is: true}]",
     ":4:10: error: the active master at manager 127, which is no flying master and "
     "commands the network while it is there, expected a "
     "manager with 'flying'"},
    {"expect: [{that: event, is: guard_lost, node: 33}]", ":4:10: error: guard_lost of node 33, which manager 127 does "
                                                          "not guard, expected a slave with guard_time and without "
                                                          "consumer time, or heartbeat_lost"},
    {"expect: [{that: no_event, is: toggle_error}]",
     ":4:10: error: toggle_error of any node, and manager 127 guards none"},
    {"expect: [{that: no_event, is: gate, node: 5}]",
     ":4:10: error: the gate of node 5, which has no safety configuration"},
};

class BadScenarioTest : public test::CommandTest
{
  protected:
    BadScenarioTest()
    {
        const std::string dcf = cia306::test::SourceFolder() + "/examples/emergency_stop/";
        const std::string slaves = "slaves:\n  - {node: 33, dcf: " + dcf + "actuator.dcf}\n  - {node: 2, dcf: " + dcf +
                                   "controller.dcf}\n  - {node: 5}\n";
        static_cast<void>(File("net.yaml", "manager: {node: 127}\n" + slaves));
        static_cast<void>(File("el.yaml", "manager: {node: 127, profile: el6751}\nslaves: [{node: 5}]\n"));
        devices_ = "nodes:\n  33: {dcf: " + dcf + "actuator.dcf}\n  2: {phase: 500 ms, dcf: " + dcf +
                   "controller.dcf}\n  5: {dcf: " + dcf + "sensor.dcf}\n";
    }
    void ExpectRefused(const std::string& text, const std::string& message)
    {
        const std::string file = File("s.yaml", text);
        const Answer answer = RunCommand({"simulate", "--quiet", file});
        EXPECT_EQ(answer.status, 2) << text;
        EXPECT_EQ(answer.err.rfind(file + message, 0U), 0U) << text << "\n" << answer.err;
        EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
        EXPECT_EQ(answer.out, "") << text;
    }

    std::string devices_;
    const std::string head_ = "title: x\nduration: 2 s\nmanagers: [{network: net.yaml}]\n";
};

TEST_F(BadScenarioTest, EachMalformedScenarioHasItsLine)
{
    Verifies(req::SRS_MGR_157);
    Verifies(req::SRS_MGR_343);
    for (const auto& [part, message] : kMalformed)
    {
        ExpectRefused(head_ + part + "\n" + devices_, message);
    }
}

TEST_F(BadScenarioTest, WhatDoesNothingOrHoldsWhateverHappensIsRefused)
{
    Verifies(req::SRS_MGR_157);
    Verifies(req::SRS_MGR_342);
    Verifies(req::SRS_MGR_343);
    for (const auto& [part, message] : kIdle)
    {
        ExpectRefused(head_ + part + "\n" + devices_, message);
    }
}

TEST_F(BadScenarioTest, ManagersAndDevices)
{
    Verifies(req::SRS_MGR_157);
    Verifies(req::SRS_MGR_342);
    Verifies(req::SRS_MGR_343);
    const std::string two = "title: x\nduration: 2 s\n";
    ExpectRefused(two + "managers: [{network: nobody.yaml}]\n", ":3:22: error: there is no file ");
    ExpectRefused(two + "managers: [{network: .}]\n", ":3:22: error: '" + Path("."));
    ExpectRefused(two + "managers: []\n", ":3:11: error: an empty list of managers, expected at least one");
    ExpectRefused(two + "managers: 5\n", ":3:11: error: '5', expected a list");
    ExpectRefused(two + "managers: [{network: net.yaml},\n  {network: net.yaml}]\n",
                  ":4:3: error: manager 127 a second time");
    ExpectRefused(head_ + devices_ + "  33: {dcf: net.yaml}\n", ":8:3: error: key '33' twice");
    ExpectRefused(two + "managers: [{network: net.yaml, node: 9}]\n" + devices_ +
                      "  9: {dcf: " + cia306::test::SourceFolder() + "/examples/emergency_stop/sensor.dcf}\n",
                  ":8:12: error: node-ID 9, which a manager has, expected a node-ID of its own for each node");
    ExpectRefused(head_ + "nodes: {5: {dcf: /dev/zero}}\n",
                  ":4:18: error: '/dev/zero' is no regular file, expected a DCF");
    // Given a manager that comes later, then nothing is asked of it before
    const std::string late = two + "managers: [{network: net.yaml, at: 1 s}]\n";
    ExpectRefused(late + "expect: [{that: no_event, is: nmt, until: 1 s}]\n",
                  ":4:10: error: a time before manager 127 comes");
    ExpectRefused(late + "events: [{at: 0 s, do: order, order: start all}]\n",
                  ":4:10: error: an event of manager 127 before it comes");
    // Given another profile, then it has codes of its own and no letters
    const std::string el6751 = two + "managers: [{network: el.yaml}]\n";
    ExpectRefused(el6751 + "expect: [{that: letter, node: 5, is: none}]\n",
                  ":4:10: error: a letter of manager 127 with the profile el6751, expected 'code'");
    ExpectRefused(el6751 + "expect: [{that: code, node: 5, is: banana}]\n",
                  ":4:10: error: code 'banana' of manager 127 with the profile el6751, expected a decimal code that");
    ExpectRefused(el6751 + "expect: [{that: code, node: 5, is: 98}]\n", ":4:10: error: code '98' of manager 127");
    ExpectRefused(el6751 + "expect: [{that: no_event, is: gate}]\n",
                  ":4:10: error: the gate of a network, which has no safety configuration, expected a safety slave");
}

TEST_F(BadScenarioTest, WhoComesAtTheEndAndASerialNumberWithoutItsObject)
{
    Verifies(req::SRS_MGR_157);
    Verifies(req::SRS_MGR_342);
    // Given a run of 2 s, then a manager or a device that comes at its end never does
    ExpectRefused("title: x\nduration: 2 s\nmanagers: [{network: net.yaml, at: 2 s}]\n" + devices_,
                  ":3:12: error: manager at 2000 ms, not before the end of the run, expected a time below 2000 ms\n");
    const std::string folder = cia306::test::SourceFolder() + "/examples/emergency_stop/";
    ExpectRefused(head_ + "nodes:\n  33: {phase: 2 s, dcf: " + folder + "actuator.dcf}\n",
                  ":5:25: error: node '33' at 2000 ms, not before the end of the run, expected a time below 2000 ms\n");
    // Given a sensor whose file has no serial number, then another one is none of its
    std::string text = cia306::ReadTextFile(folder + "sensor.dcf");
    const std::size_t serial = text.find("[1018sub4]");
    text.erase(serial, text.find("\n[", serial) + 1U - serial);
    text.replace(text.find("SubNumber=5"), 11U, "SubNumber=4");
    static_cast<void>(File("no_serial.dcf", text));
    const std::string event = "events: [{at: 0 s, do: replace, node: 5, serial: 9}]\n";
    ExpectRefused(head_ + event + "nodes: {5: {dcf: no_serial.dcf}}\n",
                  ":4:10: error: object 0x1018:04 of device 5, which its DCF does not have, expected an object of ");
}

TEST_F(BadScenarioTest, AnObjectIsTheSameHoweverItIsWritten)
{
    Verifies(req::SRS_MGR_157);
    // Given a relay with another serial number, and its finding with one digit of the sub-index
    const std::string dcf = cia306::test::SourceFolder() + "/examples/emergency_stop/actuator.dcf";
    const Answer answer = RunCommand({"simulate", "--quiet",
                                      File("s.yaml", head_ + "nodes: {33: {serial: 77, dcf: " + dcf +
                                                         "}}\nexpect:\n"
                                                         "  - {that: finding, node: 33, is: '0x1018:4'}\n  - {that: "
                                                         "finding, node: 33, is: none, at: 1 ms}\n")});
    EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
}

TEST_F(BadScenarioTest, GuardingIsExpectedWhereItCanBe)
{
    Verifies(req::SRS_MGR_343);
    const std::string base = "title: x\nduration: 100 ms\nmanagers: [{network: guard.yaml}]\n";
    const auto answer = [this, &base](const std::string& slave, const std::string& part)
    {
        static_cast<void>(File("guard.yaml", "manager: {node: 127}\nslaves: [{node: 5" + slave + "}]\n"));
        return RunCommand({"simulate", "--quiet", File("s.yaml", base + part)});
    };
    const std::string none = "expect: [{that: no_event, is: guard_lost, node: 5}]\n";
    const std::string guarded = ", guard_time: 100 ms, retry_factor: 3";
    EXPECT_EQ(answer(guarded, none).status, 0) << answer(guarded, none).err;
    // Heartbeat goes first
    EXPECT_EQ(answer(guarded + ", consumer: 300 ms", none).status, 2);
    // Unless somebody changes that: an order, or an SDO of somebody else
    EXPECT_EQ(answer("", "events: [{at: 50 ms, do: order, order: set 0x1F81:05 0x0064030D}]\n" + none).status, 0);
    EXPECT_EQ(answer("", "events: [{at: 50 ms, do: send, identifier: 0x67F, data: 40 00 10 00}]\n" + none).status, 0);
    EXPECT_EQ(answer("", "events: [{at: 50 ms, do: order, order: reset 5}]\n" + none).status, 2);
    // A controller that is back at the very end
    EXPECT_EQ(answer(guarded, "events: [{at: 50 ms, do: bus_off, until: 100 ms}]\n" + none).status, 0);
}
} // namespace
} // namespace counterpoint::tools
