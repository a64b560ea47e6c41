// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The command manager, and networks in simulated time.
#include "canopen/cia306/text/input_error.hpp"
#include "hal/host/live/bus.hpp"
#include "hal/host/live/poll.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/comfort.hpp"
#include "verification/trace/ids/flying_master.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <memory>
#include <sstream>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <thread>
#include <unistd.h>

namespace counterpoint::tools
{
namespace
{
using cia306::test::NetworkFile;
using test::Answer;
using test::RunCommand;

class ManagerCommandTest : public test::CommandTest
{
  protected:
    /// The scenario holds; otherwise what it told.
    static void ExpectHolds(const std::string& name)
    {
        const Answer answer = RunCommand({"simulate", "--quiet", NetworkFile(name)});
        EXPECT_EQ(answer.status, 0) << name << "\n" << answer.out << answer.err;
    }
    /// Under each of these profiles.
    static void ExpectHoldsUnder(const std::vector<std::string>& profiles, const std::string& name)
    {
        for (const std::string& profile : profiles)
        {
            const Answer answer = RunCommand({"simulate", "--quiet", NetworkFile(name), "--profile", profile});
            EXPECT_EQ(answer.status, 0) << name << " " << profile << "\n" << answer.out << answer.err;
            EXPECT_EQ(answer.err, "") << name << " " << profile;
        }
    }
};

TEST_F(ManagerCommandTest, ANetworkBootsInSimulatedTime)
{
    Verifies(req::SRS_MGR_001);
    Verifies(req::SRS_MGR_012);
    ExpectHoldsUnder({"cia302", "el6751", "plc_designer"}, "boot.yaml");
}

TEST_F(ManagerCommandTest, ASafetySlaveWithAnotherConfiguration)
{
    Verifies(req::SRS_SFS_003);
    Verifies(req::SRS_SFS_005);
    ExpectHolds("written.yaml");
    ExpectHolds("stopped.yaml");
}

TEST_F(ManagerCommandTest, NoProfileStartsASafetySlaveThatDiffers)
{
    Verifies(req::SRS_SFS_002);
    Verifies(req::SRS_MGR_155);
    Verifies(req::SRS_SFS_003);
    Verifies(req::SRS_SFS_005);
    ExpectHoldsUnder({"cia302", "el6751", "plc_designer"}, "changed.yaml");
}

TEST_F(ManagerCommandTest, AFlyingMasterDiesAndTheOtherOneTakesOver)
{
    Verifies(req::SRS_MGR_002);
    Verifies(req::SRS_FLY_150);
    ExpectHoldsUnder({"cia302", "el6751", "plc_designer"}, "flying.yaml");
    ExpectHolds("flying_bus_off.yaml");
    // In the middle of the slave's boot-up, under the other profiles
    ExpectHoldsUnder({"el6751", "plc_designer"}, "flying_boot.yaml");
    // Such masters know the same network
    for (const std::string profile : {"el6751", "plc_designer"})
    {
        const auto master = [this, &profile](const std::string& node, const std::string& other)
        {
            return File(node + ".yaml", "manager: {node: " + node + ", heartbeat: 200 ms, profile: " + profile +
                                            ", flying: {priority: 1}}\nslaves:\n  - {node: " + other +
                                            ", mandatory: false, consumer: 500 ms}\n  - {node: 95, dcf: " +
                                            NetworkFile("slave.dcf") + "}\n");
        };
        const Answer equal = RunCommand({"manager", "--check", master("2", "5"), master("5", "2")});
        EXPECT_EQ(equal.status, 0) << equal.out;
        EXPECT_EQ(equal.err, "");
    }
}

TEST_F(ManagerCommandTest, ForeignFramesOfTheNegotiation)
{
    Verifies(req::SRS_FLY_001);
    Verifies(req::SRS_FLY_012);
    Verifies(req::SRS_FLY_021);
    Verifies(req::SRS_MGR_155);
    ExpectHolds("flying_babble.yaml");
}

TEST_F(ManagerCommandTest, TheDemoOfTheReference)
{
    Verifies(req::SRS_MGR_002);
    Verifies(req::SRS_MGR_155);
    ExpectHolds("demo.yaml");
    ExpectHolds("demo_later.yaml");
    ExpectHolds("demo_fails.yaml");
    // With swapped priorities and a failing master: without and with supervision of it in node 2
    ExpectHolds("demo_swapped.yaml");
    ExpectHolds("demo_watching.yaml");
    const Answer printed =
        RunCommand({"manager", "--check", NetworkFile("demo_master_2.yaml"), NetworkFile("demo_master_5.yaml")});
    EXPECT_EQ(printed.status, 0) << printed.out;
    const Answer swapped =
        RunCommand({"manager", "--check", NetworkFile("demo_watching_2.yaml"), NetworkFile("demo_swapped_5.yaml")});
    EXPECT_EQ(swapped.status, 0) << swapped.out;
}

TEST_F(ManagerCommandTest, TheSameScenarioGivesTheSameEvents)
{
    Verifies(req::SRS_MGR_156);
    const Answer first = RunCommand({"simulate", NetworkFile("babbling.yaml")});
    const Answer second = RunCommand({"simulate", NetworkFile("babbling.yaml")});
    EXPECT_EQ(first.out, second.out);
    EXPECT_NE(first.out.find("9 of 9 expectations hold"), std::string::npos);
}

TEST_F(ManagerCommandTest, AnExpectationThatDoesNotHoldEndsWith1)
{
    Verifies(req::SRS_MGR_155);
    const std::string file =
        File("s.yaml", "title: x\nduration: 1 s\nmanagers: [{network: " + NetworkFile("chain.yaml") +
                           "}]\nexpect:\n  - {that: state, node: 33, is: operational}\n");
    const Answer answer = RunCommand({"simulate", "--quiet", file});
    EXPECT_EQ(answer.status, 1);
    EXPECT_EQ(answer.out, "  FAILED  state of node 33 is operational at 1000 ms: unknown  (" + file +
                              ":5:5)\n0 of 1 expectations hold\n");
}

TEST_F(ManagerCommandTest, EachExpectationThatDoesNotHoldIsTold)
{
    Verifies(req::SRS_MGR_155);
    // Given a network that runs, its outputs closed, and expectations of something else
    const std::string folder = NetworkFile("master_2.yaml").substr(0U, NetworkFile("master_2.yaml").rfind('/') + 1U);
    const std::string network = "title: x\nduration: 8 s\nmanagers: [{network: " + folder +
                                "master_2.yaml}, {network: " + folder + "master_5.yaml}]\nnodes: {95: {dcf: " + folder +
                                "slave.dcf}}\nexpect:\n";
    const std::vector<std::pair<std::string, std::string>> all{
        {"state, node: 95, is: stopped", "state of node 95 is stopped at 8000 ms: operational"},
        {"device, node: 95, is: stopped", "device of node 95 is stopped at 8000 ms: operational"},
        {"letter, node: 95, is: C", "letter of node 95 is C at 8000 ms: none"},
        {"gate, node: 95, is: differs", "gate of node 95 is differs at 8000 ms: open"},
        {"output, node: 95, is: open", "output of node 95 SRDO 1 is open at 8000 ms: closed"}};
    std::string expected;
    for (const auto& [what, told] : all)
    {
        expected += "  - {that: " + what + "}\n";
    }
    const Answer answer = RunCommand({"simulate", "--quiet", File("wrong.yaml", network + expected)});
    EXPECT_EQ(answer.status, 1);
    for (const auto& [what, told] : all)
    {
        EXPECT_NE(answer.out.find("  FAILED  " + told + "  ("), std::string::npos) << told << "\n" << answer.out;
    }
    EXPECT_NE(answer.out.find("\n0 of 5 expectations hold\n"), std::string::npos) << answer.out;
}

TEST_F(ManagerCommandTest, EventsAreJsonAndThePageShowsTheSequence)
{
    Verifies(req::SRS_MGR_007);
    Verifies(req::SRS_MGR_008);
    Verifies(req::SRS_SFS_008);
    const Answer answer = RunCommand(
        {"simulate", "--quiet", "--json", Path("out.json"), "--html", Path("out.html"), NetworkFile("boot.yaml")});
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

TEST_F(ManagerCommandTest, EachKindOfEventIsAnObjectWithItsTime)
{
    Verifies(req::SRS_MGR_007);
    // Given networks with a boot, a storm of emergencies and flying masters of which one dies
    std::map<std::string, nlohmann::json> first;
    for (const char* const name : {"boot.yaml", "emcy_storm.yaml", "flying.yaml"})
    {
        const Answer answer = RunCommand({"simulate", "--quiet", "--json", Path("out.json"), NetworkFile(name)});
        ASSERT_EQ(answer.status, 0) << name;
        const auto document = nlohmann::json::parse(cia306::ReadTextFile(Path("out.json")));
        for (const auto& manager : document["managers"])
        {
            for (const auto& event : manager["events"])
            {
                EXPECT_TRUE(event["t_us"].is_number_unsigned()) << event;
                first.emplace(event["event"], event);
            }
        }
    }
    const std::pair<std::string, std::vector<std::string>> kinds[] = {
        {"state", {"node", "state"}},
        {"status", {"node", "letter", "step", "abort", "code"}},
        {"supervision_started", {"node"}},
        {"heartbeat_lost", {"node"}},
        {"emergency", {"node", "code", "register"}},
        {"nmt", {"node", "command"}},
        {"gate", {"node", "state"}},
        {"flying_master", {"number", "priority", "master"}}};
    for (const auto& [kind, keys] : kinds)
    {
        ASSERT_EQ(first.count(kind), 1U) << kind;
        for (const std::string& key : keys)
        {
            EXPECT_TRUE(first[kind].contains(key)) << kind << " " << key;
        }
    }
}

TEST_F(ManagerCommandTest, OneStartOfAllThatIsAskedForIsManyWithASafetySlave)
{
    Verifies(req::SRS_NET_005);
    for (const std::string profile : {"cia302", "plc_designer"})
    {
        // Given a network that asks for one start, with a safety slave
        static_cast<void>(File("net.yaml", "manager: {node: 127, start_up: 0x3, profile: " + profile +
                                               "}\nslaves:\n  - {node: 33, dcf: " + cia306::test::SourceFolder() +
                                               "/examples/emergency_stop/actuator.dcf}\n"));
        const std::string scenario =
            File("s.yaml", "title: x\nduration: 4 s\nmanagers: [{network: net.yaml}]\nnodes:\n  33: {dcf: " +
                               cia306::test::SourceFolder() +
                               "/examples/emergency_stop/actuator.dcf}\nexpect:\n"
                               "  - {that: device, node: 33, is: operational}\n");
        const Answer answer = RunCommand({"simulate", "--quiet", "--candump", Path("out.log"), scenario});
        EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
        // Then the slave is started by itself, and nothing goes to node 0
        const std::string frames = cia306::ReadTextFile(Path("out.log"));
        EXPECT_NE(frames.find(" can0 000#0121\n"), std::string::npos) << profile;
        EXPECT_EQ(frames.find(" can0 000#0100\n"), std::string::npos) << profile;
    }
}

TEST_F(ManagerCommandTest, TheManagerIsOperationalWhenItsProfileHasStartedTheNetwork)
{
    Verifies(req::SRS_MGR_152);
    for (const std::string profile : {"cia302", "el6751", "plc_designer"})
    {
        // Given three safety slaves, which are never started by a command to all
        const Answer answer = RunCommand(
            {"simulate", "--quiet", "--profile", profile, "--candump", Path("out.log"), NetworkFile("boot.yaml")});
        ASSERT_EQ(answer.status, 0) << answer.out;
        const std::string frames = cia306::ReadTextFile(Path("out.log"));
        EXPECT_EQ(frames.find(" can0 000#0100\n"), std::string::npos) << profile;
        // Then the heartbeat of manager 127 is that of PRE-OPERATIONAL, and of OPERATIONAL behind the last start
        const std::size_t before = frames.find(" can0 77F#7F\n");
        const std::size_t last_start = std::max(
            {frames.rfind(" can0 000#0101\n"), frames.rfind(" can0 000#0102\n"), frames.rfind(" can0 000#0121\n")});
        const std::size_t first_operational = frames.find(" can0 77F#05\n");
        EXPECT_LT(before, last_start) << profile;
        EXPECT_LT(last_start, first_operational) << profile;
        EXPECT_NE(first_operational, std::string::npos) << profile;
        EXPECT_EQ(frames.find(" can0 77F#7F\n", first_operational), std::string::npos) << profile;
    }
}

TEST_F(ManagerCommandTest, FramesOfASimulatedNetworkAreWrittenAsCandumpDoes)
{
    Verifies(req::SRS_SIM_042);
    const Answer answer =
        RunCommand({"simulate", "--candump", Path("out.log"), "--json", Path("out.json"), NetworkFile("boot.yaml")});
    ASSERT_EQ(answer.status, 0);
    const std::string frames = cia306::ReadTextFile(Path("out.log"));
    const auto count = std::count(frames.begin(), frames.end(), '\n');
    const auto document = nlohmann::json::parse(cia306::ReadTextFile(Path("out.json")));
    EXPECT_EQ(static_cast<std::size_t>(count), document["frames"].size());
    EXPECT_GT(count, 500);
    EXPECT_NE(frames.find(") can0 000#8200\n"), std::string::npos);
    EXPECT_NE(frames.find(") can0 000#0121\n"), std::string::npos);
    // Without the option nothing else happens
    EXPECT_EQ(RunCommand({"simulate", NetworkFile("boot.yaml")}).out, answer.out);
}

TEST_F(ManagerCommandTest, WithoutItsSlavesTheManagerEndsWith1)
{
    Verifies(req::SRS_MGR_007);
    Verifies(req::SRS_MGR_004);
    Verifies(req::SRS_MGR_005);
    const Answer answer =
        RunCommand({"manager", "--can", "udp:239.74.163.91:43191", "--network", NetworkFile("chain.yaml"), "--for", "1",
                    "--no-input", "--log", Path("log.jsonl")});
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

/// What one answers at the socket; "" while nobody listens there.
std::string AnswerAt(const std::string& path, const std::string& order)
{
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::copy(path.begin(), path.end(), address.sun_path);
    const host::LiveFile client(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    std::string answer;
    if (::connect(client.Get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0 &&
        ::send(client.Get(), order.data(), order.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(order.size()))
    {
        char text[4096] = {};
        const ssize_t count = ::recv(client.Get(), text, sizeof(text), 0);
        answer.assign(text, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
    return answer;
}

TEST_F(ManagerCommandTest, WithItsSlavesTheManagerEndsWith0)
{
    Verifies(req::SRS_MGR_004);
    Verifies(req::SRS_MGR_005);
    Verifies(req::SRS_MGR_061);
    const std::string bus = "udp:239.74.163.91:" + std::to_string(20000 + ::getpid() % 40000);
    const std::string file = File("net.yaml", "manager: {node: 127}\nslaves: [{node: 5, name: Pump, boot: false}]\n");
    // Given a mandatory slave that says that it runs, until the manager shows it so, which is then told to quit
    std::string shown;
    std::thread person(
        [this, &bus, &shown]
        {
            const std::unique_ptr<host::LiveBus> own = host::OpenLiveBus(bus);
            host::LiveFrame beat;
            beat.identifier = 0x705U;
            beat.length_bytes = 1U;
            beat.data[0] = 0x05U;
            for (int turn = 0; turn < 60000 && shown.find("Pump                  operational") == std::string::npos;
                 ++turn)
            {
                static_cast<void>(own->Send(beat));
                shown = AnswerAt(Path("m.sock"), "status\n");
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            }
            EXPECT_EQ(std::filesystem::status(Path("m.sock")).permissions(), std::filesystem::perms{0660});
            EXPECT_EQ(AnswerAt(Path("m.sock"), "quit\n"), "taken\n");
        });
    const Answer answer = RunCommand({"manager", "--can", bus, "--network", file, "--no-input", "--socket",
                                      Path("m.sock"), "--socket-group", "--for", "600"});
    person.join();
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_NE(answer.out.find("\n5     Pump                  operational      "), std::string::npos) << answer.out;
    EXPECT_NE(shown.find("\n5     Pump                  operational      "), std::string::npos) << shown;
}

TEST_F(ManagerCommandTest, ALogThatEndsEarlyIsExitStatus2)
{
    Verifies(req::SRS_MGR_124);
    // Given files of at most 100 bytes
    const std::string file = File("net.yaml", "manager: {node: 127}\nslaves: [{node: 5, mandatory: false}]\n");
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto on_limit = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit few{100U, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &few), 0);
    const Answer answer = RunCommand({"manager", "--can", "udp:239.74.163.91:43191", "--network", file, "--for", "1",
                                      "--no-input", "--log", Path("log.jsonl")});
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    static_cast<void>(std::signal(SIGXFSZ, on_limit));
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.err, Path("log.jsonl") + ": error: the event log could not be written to its end, expected a file "
                                              "system with room\n");
    EXPECT_NE(answer.out.find("the event log cannot be written any more\n"), std::string::npos) << answer.out;
}

TEST_F(ManagerCommandTest, WhatCannotBeUsedEndsWith2)
{
    Verifies(req::SRS_MGR_004);
    Verifies(req::SRS_NET_004);
    const Answer no_bus = RunCommand({"manager", "--network", NetworkFile("chain.yaml")});
    EXPECT_EQ(no_bus.status, 2);
    EXPECT_EQ(no_bus.err, "counterpoint manager: --can is missing, expected --can ADDRESS --network FILE, or --check "
                          "FILE...\n");
    const Answer bad_bus = RunCommand({"manager", "--can", "udp:nowhere", "--network", NetworkFile("chain.yaml")});
    EXPECT_EQ(bad_bus.status, 2);
    const std::string file = File("net.yaml", "manager: {node: 127}\nslaves: [{node: 300}]\n");
    const Answer bad_file = RunCommand({"manager", "--can", "udp:239.74.163.91:43191", "--network", file});
    EXPECT_EQ(bad_file.status, 2);
    EXPECT_EQ(bad_file.err.rfind(file + ":2:17: error: ", 0U), 0U) << bad_file.err;
}

TEST_F(ManagerCommandTest, AnOutputWithoutANameIsRefused)
{
    Verifies(req::SRS_MGR_123);
    const std::string empty = ": an empty name, expected the name of a file; expected a command line as told by "
                              "'counterpoint ";
    for (const char* const option : {"--log", "--html", "--socket"})
    {
        const Answer answer = RunCommand({"manager", "--can", "udp:239.74.163.91:43191", "--network",
                                          NetworkFile("chain.yaml"), "--for", "1", "--no-input", option, ""});
        EXPECT_EQ(answer.status, 2) << option;
        EXPECT_EQ(answer.err, "counterpoint: " + std::string(option) + empty + "manager --help'\n");
    }
    for (const char* const option : {"--html", "--json", "--candump"})
    {
        const Answer answer = RunCommand({"simulate", "--quiet", NetworkFile("boot.yaml"), option, ""});
        EXPECT_EQ(answer.status, 2) << option;
        EXPECT_EQ(answer.err, "counterpoint: " + std::string(option) + empty + "simulate --help'\n");
    }
}

TEST_F(ManagerCommandTest, ASocketForAGroupWithoutASocketIsRefused)
{
    Verifies(req::SRS_MGR_752);
    const Answer answer = RunCommand({"manager", "--can", "udp:239.74.163.91:43191", "--network",
                                      NetworkFile("chain.yaml"), "--for", "1", "--no-input", "--socket-group"});
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.err, "--socket-group: error: without --socket, whose rights it tells, expected --socket PATH with "
                          "it, or neither\n");
}

TEST_F(ManagerCommandTest, ACheckRunsNothingAndTakesNoOptionOfARun)
{
    Verifies(req::SRS_MGR_009);
    const std::vector<std::string> check{"manager", "--check", NetworkFile("master_2.yaml"),
                                         NetworkFile("master_5.yaml")};
    for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
             {"--can", "udp:239.74.163.91:43191"}, {"--network", NetworkFile("chain.yaml")}, {"--log", Path("x")}})
    {
        std::vector<std::string> words = check;
        words.insert(words.end(), more.begin(), more.end());
        const Answer answer = RunCommand(words);
        EXPECT_EQ(answer.status, 2) << more[0];
        EXPECT_EQ(answer.err,
                  more[0] + ": error: with --check, which runs nothing, expected --check FILE FILE... alone, or with "
                            "--node-id and --json\n");
    }
}

TEST_F(ManagerCommandTest, ComparisonIsOneJsonDocument)
{
    Verifies(req::SRS_EASE_005);
    const std::string chain = NetworkFile("chain.yaml");
    const Answer answer = RunCommand({"manager", "--check", chain, chain, "--json"});
    const nlohmann::json document = nlohmann::json::parse(answer.out);
    EXPECT_EQ(document["format"], "counterpoint-manager-check-1");
    EXPECT_EQ(document["files"], (std::vector<std::string>{chain, chain}));
    EXPECT_EQ(document["holds"], answer.status == 0);
    EXPECT_EQ(document["differences"].size() == 0U, answer.status == 0);
    EXPECT_EQ(document["warnings"].size(),
              static_cast<std::size_t>(std::count(answer.err.begin(), answer.err.end(), '\n')));
}

TEST_F(ManagerCommandTest, TheHelpTellsTheOrders)
{
    Verifies(req::SRS_MGR_006);
    const Answer answer = RunCommand({"manager", "--help"});
    EXPECT_NE(answer.out.find("\n  write-safety NODE "), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find("Exit status: 0"), std::string::npos) << answer.out;
}

TEST_F(ManagerCommandTest, NoOutputReplacesWhatIsReadOrAnotherOne)
{
    Verifies(req::SRS_MGR_123);
    // Given a network file, its DCF and a scenario of them
    const std::string dcf_text = cia306::ReadTextFile(NetworkFile("slave.dcf"));
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
} // namespace
} // namespace counterpoint::tools
