// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The command manager, and networks in simulated time.
#include "canopen/cia306/input_error.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "tools/manager_order.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace counterpoint::tools
{
namespace
{
using test::Answer;
using test::RunCommand;

class ManagerCommandTest : public test::CommandTest
{
  protected:
    static std::string Network(const std::string& name)
    {
        return cia306::test::SourceFolder() + "/examples/networks/" + name;
    }
    /// The scenario holds; otherwise what it told.
    static void ExpectHolds(const std::string& name)
    {
        const Answer answer = RunCommand({"simulate", "--quiet", Network(name)});
        EXPECT_EQ(answer.status, 0) << name << "\n" << answer.out << answer.err;
    }
};

TEST_F(ManagerCommandTest, ANetworkBootsInSimulatedTime)
{
    Verifies(req::SRS_MGR_001);
    Verifies(req::SRS_MGR_012);
    ExpectHolds("boot.yaml");
}

TEST_F(ManagerCommandTest, ASafetySlaveWithAnotherConfiguration)
{
    Verifies(req::SRS_SFS_003);
    Verifies(req::SRS_SFS_005);
    ExpectHolds("changed.yaml");
    ExpectHolds("written.yaml");
    ExpectHolds("stopped.yaml");
}

TEST_F(ManagerCommandTest, NoProfileStartsASafetySlaveThatDiffers)
{
    Verifies(req::SRS_SFS_002);
    Verifies(req::SRS_MGR_012);
    ExpectHolds("boot_el6751.yaml");
    ExpectHolds("boot_plc_designer.yaml");
}

TEST_F(ManagerCommandTest, AFlyingMasterDiesAndTheOtherOneTakesOver)
{
    Verifies(req::SRS_MGR_002);
    ExpectHolds("flying.yaml");
}

TEST_F(ManagerCommandTest, TheDemoOfTheReference)
{
    Verifies(req::SRS_MGR_002);
    Verifies(req::SRS_MGR_012);
    ExpectHolds("demo.yaml");
    ExpectHolds("demo_later.yaml");
    ExpectHolds("demo_fails.yaml");
    // With swapped priorities and a failing master: without and with supervision of it in node 2
    ExpectHolds("demo_swapped.yaml");
    ExpectHolds("demo_watching.yaml");
    const Answer printed =
        RunCommand({"manager", "--check", Network("demo_master_2.yaml"), Network("demo_master_5.yaml")});
    EXPECT_EQ(printed.status, 0) << printed.out;
    const Answer swapped =
        RunCommand({"manager", "--check", Network("demo_watching_2.yaml"), Network("demo_swapped_5.yaml")});
    EXPECT_EQ(swapped.status, 0) << swapped.out;
}

TEST_F(ManagerCommandTest, TheSameScenarioGivesTheSameEvents)
{
    Verifies(req::SRS_MGR_012);
    const Answer first = RunCommand({"simulate", Network("babbling.yaml")});
    const Answer second = RunCommand({"simulate", Network("babbling.yaml")});
    EXPECT_EQ(first.out, second.out);
    EXPECT_NE(first.out.find("9 of 9 expectations hold"), std::string::npos);
}

TEST_F(ManagerCommandTest, AnExpectationThatDoesNotHoldEndsWith1)
{
    Verifies(req::SRS_MGR_012);
    const std::string file = File("s.yaml", "title: x\nduration: 1 s\nmanagers: [{network: " + Network("chain.yaml") +
                                                "}]\nexpect:\n  - {that: state, node: 33, is: operational}\n");
    const Answer answer = RunCommand({"simulate", "--quiet", file});
    EXPECT_EQ(answer.status, 1);
    EXPECT_EQ(answer.out,
              "VIOLATED  " + file + ":5: 1.000 s: state of node 33 for the manager is unknown, expected operational\n");
}

TEST_F(ManagerCommandTest, MalformedNetworkScenariosAreRefused)
{
    Verifies(req::SRS_MGR_012);
    constexpr const char* kPlain = "manager: {node: 127}\nslaves: [{node: 5}]\n";
    const std::string head = "title: x\nduration: 1 s\nmanagers: [{network: " + Network("chain.yaml") + "}]\n";
    const std::pair<std::string, std::string> bad[] = {
        {head + "events: [{at: 1 s, do: explode, node: 1}]\n", ":4:24: 'explode', expected one of pull, insert"},
        {head + "events: [{at: 1 s, do: pull}]\n", ":4:10: no key 'node', expected it here"},
        {head + "events: [{at: 1 s, do: order, order: fly}]\n", ":4:38: order 'fly', expected status, start"},
        {head + "expect: [{that: state, node: 1, is: x, at: 2 s}]\n", "a time after the end of the scenario"},
        {head + "expect: [{that: active, manager: 9, is: x}]\n", ":4:10: no manager with node-ID 9"},
        {head + "speed: 3\n", ":4:1: unknown key 'speed'"},
        {head + "bitrate: 5\n", "5, expected 10000, 20000"},
        {"title: x\nduration: 1 s\nmanagers: [{network: nobody.yaml}]\n", ":3:22: there is no file "},
        // What would never end, do nothing, or hold whatever happens
        {head + "title: y\n", ":4:1: key 'title' twice, expected each key once"},
        {head + "events: [{at: 0 s, do: babble, every: 0 s, until: 1 s}]\n", ":4:39: '0 s', expected a time above 0"},
        {head + "events: [{at: 500 ms, do: emcy_storm, node: 1, until: 1 ms}]\n", ":4:10: an end before the beginning"},
        {head + "events: [{at: 0 s, do: send}]\n", ":4:10: no key 'identifier', expected it here"},
        {head + "events: [{at: 0 s, do: send, identifier: 0, data: 1}]\n", ":4:51: '1', expected up to 8 bytes of two"},
        {head + "events: [{at: 0 s, do: send, identifier: 0, data: 0g}]\n", ":4:51: '0g', expected up to 8 bytes"},
        {head + "events: [{at: 0 s, do: bus_off}]\n", ":4:10: no key 'until', expected it here"},
        {head + "events: [{at: 0 s, do: no_controller, until: 1 s, node: 9}]\n", ":4:10: no manager with node-ID 9"},
        {head + "events: [{at: 1 s, do: order, order: status}]\n", ":4:10: a time at the end of the scenario or later"},
        {head + "events: [{at: 0 s, do: pull, node: 9}]\n", ":4:10: no device with node-ID 9"},
        {head + "events: [{at: 0 s, do: kill_manager, node: 9}]\n", ":4:10: no manager with node-ID 9"},
        {head + "expect: [{that: no_event, is: heartbeat_lots}]\n", ":4:10: event 'heartbeat_lots', expected one of"},
        {head + "expect: [{that: no_event, is: gate, from: 9 ms, until: 8 ms}]\n", ":4:10: a window that ends before"},
        {head + "expect: [{that: output, node: 9, is: closed}]\n", ":4:10: no device with node-ID 9"},
        {head + "expect: [{that: state, node: 9, is: x}]\n", ":4:10: node 9, which is no slave of manager 127"},
        {head + "expect: [{that: no_event, node: 9, is: gate}]\n", ":4:10: node 9, which is no slave of manager"},
        {"title: x\nduration: 1 s\nmanagers: [{network: " + File("plain.yaml", kPlain) +
             "}]\nexpect: [{that: gate, node: 5, is: closed}]\n",
         ":4:10: the gate of node 5, which has no safety configuration"},
        {"title: x\nduration: 1 s\nmanagers: []\n", ": an empty list of managers, expected at least one"},
        {"title: x\nduration: 1 s\nmanagers: [{network: " + Network("chain.yaml") +
             "},\n  {network: " + Network("chain.yaml") + "}]\n",
         ":4:3: manager 127 a second time"},
        {head + "devices: [{node: 33, dcf: " + Network("slave.dcf") + "},\n  {node: 33, dcf: " + Network("slave.dcf") +
             "}]\n",
         ":5:3: device 33 a second time"}};
    for (const auto& [text, message] : bad)
    {
        const Answer answer = RunCommand({"simulate", File("s.yaml", text)});
        EXPECT_EQ(answer.status, 2) << text;
        EXPECT_NE(answer.err.find(message), std::string::npos) << text << "\n" << answer.err;
    }
}

TEST_F(ManagerCommandTest, EventsAreJsonAndThePageShowsTheSequence)
{
    Verifies(req::SRS_MGR_007);
    Verifies(req::SRS_MGR_008);
    Verifies(req::SRS_SFS_008);
    const Answer answer = RunCommand(
        {"simulate", "--quiet", "--json", Path("out.json"), "--html", Path("out.html"), Network("boot.yaml")});
    ASSERT_EQ(answer.status, 0);
    const auto document = nlohmann::json::parse(cia306::ReadTextFile(Path("out.json")));
    const auto& events = document["managers"][0]["events"];
    const auto is_start = [](const nlohmann::json& event)
    { return event["event"] == "nmt" && event["command"] == "start" && event["node"] == 33; };
    EXPECT_EQ(std::count_if(events.begin(), events.end(), is_start), 1);
    EXPECT_EQ(events[0]["t_us"], 0);
    // And the safety slaves were verified at the same time: all three were begun before the first one was done
    int busy = 0;
    bool is_open = false;
    for (const auto& event : events)
    {
        is_open = is_open || (event["event"] == "gate" && event["state"] == "open");
        busy += (!is_open && event["event"] == "gate" && event["state"] == "busy") ? 1 : 0;
    }
    EXPECT_EQ(busy, 3);
    const std::string page = cia306::ReadTextFile(Path("out.html"));
    EXPECT_NE(page.find("<svg"), std::string::npos);
    EXPECT_NE(page.find(">33</text>"), std::string::npos);
    EXPECT_NE(page.find(">Relay</text>"), std::string::npos);
    // What the reset overtook is nobody's fault
    EXPECT_NE(page.find("read 0x1000:00: given up at boot-up"), std::string::npos);
    EXPECT_EQ(page.find("no answer"), std::string::npos);
    EXPECT_NE(page.find("read 0x1018:04: 0x21"), std::string::npos);
    EXPECT_NE(page.find("safety configuration verified"), std::string::npos);
    EXPECT_EQ(page.find("src="), std::string::npos);
}

TEST_F(ManagerCommandTest, WithoutItsSlavesTheManagerEndsWith1)
{
    Verifies(req::SRS_MGR_004);
    Verifies(req::SRS_MGR_005);
    const Answer answer = RunCommand({"manager", "--can", "udp:239.74.163.91:43191", "--network", Network("chain.yaml"),
                                      "--for", "1", "--no-input", "--log", Path("log.jsonl")});
    EXPECT_EQ(answer.status, 1) << answer.err;
    EXPECT_NE(answer.out.find("node  name                  state"), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find("33    Relay"), std::string::npos);
    std::istringstream log(cia306::ReadTextFile(Path("log.jsonl")));
    std::string line;
    std::size_t count = 0U;
    while (std::getline(log, line))
    {
        EXPECT_TRUE(nlohmann::json::parse(line).contains("t_us")) << line;
        ++count;
    }
    EXPECT_GE(count, 3U);
}

TEST_F(ManagerCommandTest, WhatCannotBeUsedEndsWith2)
{
    Verifies(req::SRS_MGR_004);
    Verifies(req::SRS_NET_004);
    const Answer no_bus = RunCommand({"manager", "--network", Network("chain.yaml")});
    EXPECT_EQ(no_bus.status, 2);
    EXPECT_EQ(no_bus.err, "counterpoint manager: --can is missing, expected --can ADDRESS --network FILE, or --check "
                          "FILE...\n");
    const Answer bad_bus = RunCommand({"manager", "--can", "udp:nowhere", "--network", Network("chain.yaml")});
    EXPECT_EQ(bad_bus.status, 2);
    const std::string file = File("net.yaml", "manager: {node: 127}\nslaves: [{node: 300}]\n");
    const Answer bad_file = RunCommand({"manager", "--can", "udp:239.74.163.91:43191", "--network", file});
    EXPECT_EQ(bad_file.status, 2);
    EXPECT_EQ(bad_file.err.rfind(file + ":2:17: ", 0U), 0U) << bad_file.err;
}

TEST_F(ManagerCommandTest, NoOutputReplacesWhatIsReadOrAnotherOne)
{
    Verifies(req::SRS_MGR_004);
    // Given a network file, its DCF and a scenario of them
    const std::string dcf_text = cia306::ReadTextFile(Network("slave.dcf"));
    const std::string dcf = File("k.dcf", dcf_text);
    const std::string net_text = "manager: {node: 127}\nslaves: [{node: 95, dcf: k.dcf}]\n";
    const std::string net = File("k.yaml", net_text);
    const std::string text = "title: x\nduration: 1 ms\nmanagers: [{network: k.yaml}]\n";
    const std::string scenario = File("s.yaml", text);
    const std::vector<std::string> manager{
        "manager", "--can", "udp:239.74.163.91:43191", "--network", net, "--for", "1", "--no-input", "--html",
        Path("x"), "--log"};
    const std::vector<std::string> simulate{"simulate", scenario, "--json", Path("x"), "--html"};
    for (const auto& [command, output] : {std::pair(manager, net),
                                          {manager, dcf},
                                          {manager, Path("x")},
                                          {simulate, net},
                                          {simulate, dcf},
                                          {simulate, scenario},
                                          {simulate, Path("x")}})
    {
        std::vector<std::string> words = command;
        words.push_back(output);
        // When an output is to replace one of them, then nothing runs
        const Answer answer = RunCommand(words);
        EXPECT_EQ(answer.status, 2) << output;
        EXPECT_NE(answer.err.find(", which is named already or read by the run, expected a file of its own"),
                  std::string::npos)
            << answer.err;
        EXPECT_EQ(answer.out, "");
    }
    EXPECT_EQ(cia306::ReadTextFile(net), net_text);
    EXPECT_EQ(cia306::ReadTextFile(dcf), dcf_text);
    EXPECT_EQ(cia306::ReadTextFile(scenario), text);
}

TEST_F(ManagerCommandTest, OrdersAreReadStrictly)
{
    Verifies(req::SRS_MGR_006);
    EXPECT_EQ(ParseManagerOrder("start 33").command, cia302::NmtCommand::kStart);
    EXPECT_EQ(ParseManagerOrder("start 33").node, 33U);
    EXPECT_EQ(ParseManagerOrder("reset-comm all").node, 0U);
    EXPECT_EQ(ParseManagerOrder("boot 5").kind, ManagerOrderKind::kBoot);
    EXPECT_EQ(ParseManagerOrder("write-safety 5 # now").kind, ManagerOrderKind::kWriteSafety);
    EXPECT_EQ(ParseManagerOrder("  ").kind, ManagerOrderKind::kNothing);
    EXPECT_EQ(ParseManagerOrder("boot all").problem, "boot: 'all', expected a node-ID from 1 to 127");
    EXPECT_EQ(ParseManagerOrder("stop").problem, "stop: no node, expected a node-ID from 1 to 127, or all");
    EXPECT_EQ(ParseManagerOrder("stop 128").problem, "stop: '128', expected a node-ID from 1 to 127, or all");
    EXPECT_EQ(ParseManagerOrder("fly").problem,
              "order 'fly', expected status, start, stop, preop, reset, reset-comm, "
              "boot, write-safety, control, output, get, set, negotiate, help or quit");
}
} // namespace
} // namespace counterpoint::tools
