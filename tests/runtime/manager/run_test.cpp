// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// How a run of a live manager ends, what it shows, and what it makes of a bus that is lost, endless or late.
#include "tests/runtime/manager/run_rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/verifies.hpp"

#include <csignal>

namespace counterpoint::tools
{
namespace
{
using test::Heartbeat;
using test::kMs;
using test::Script;

using ManagerRunTest = test::ManagerRun;

TEST_F(ManagerRunTest, EndsByEachSignalByQuitAndByItsTime)
{
    Verifies(req::SRS_MGR_120);
    EXPECT_FALSE(Run());
    EXPECT_EQ(Reason(), "--for");
    // From here on only what is tried may end it within an hour.
    settings.for_ns = 3600000U * kMs;
    for (const int number : {SIGINT, SIGTERM, SIGHUP})
    {
        const auto before = std::signal(number, SIG_DFL);
        int turns = 0;
        script.receive = [number, turns](host::LiveFrame&) mutable
        {
            ++turns;
            static_cast<void>((turns == 3) ? std::raise(number) : 0);
            return false;
        };
        EXPECT_FALSE(Run());
        static_cast<void>(std::signal(number, before));
        EXPECT_EQ(Reason(), "signal") << number;
    }
    script.receive = [](host::LiveFrame&) { return false; };
    Type("quit\n");
    EXPECT_FALSE(Run());
    EXPECT_EQ(Reason(), "quit");
}

TEST_F(ManagerRunTest, WhereSighupIsIgnoredItEndsNothing)
{
    Verifies(req::SRS_MGR_120);
    // Given a program that nohup has started
    const auto before = std::signal(SIGHUP, SIG_IGN);
    int turns = 0;
    script.receive = [&turns](host::LiveFrame&)
    {
        ++turns;
        static_cast<void>((turns == 3) ? std::raise(SIGHUP) : 0);
        return false;
    };
    EXPECT_FALSE(Run());
    EXPECT_TRUE(std::signal(SIGHUP, before) == SIG_IGN);
    EXPECT_EQ(Reason(), "--for");
    EXPECT_GT(turns, 1000);
}

TEST_F(ManagerRunTest, AFurtherSigtermCutsNothingOff)
{
    Verifies(req::SRS_MGR_121);
    const auto before = std::signal(SIGTERM, SIG_DFL);
    script.receive = [](host::LiveFrame&)
    {
        static_cast<void>(std::raise(SIGTERM));
        return false;
    };
    EXPECT_FALSE(Run());
    // When the next one comes behind the run, where table and page are written
    const auto left = std::signal(SIGTERM, SIG_IGN);
    ASSERT_TRUE(left != SIG_DFL);
    static_cast<void>(std::signal(SIGTERM, left));
    static_cast<void>(std::raise(SIGTERM));
    static_cast<void>(std::signal(SIGTERM, before));
    EXPECT_EQ(Reason(), "signal");
    // And behind a run that something else ended it is as it was before
    script.receive = [](host::LiveFrame&) { return false; };
    EXPECT_FALSE(Run());
    EXPECT_TRUE(std::signal(SIGTERM, before) == before);
}

TEST_F(ManagerRunTest, OfABusThatNeverFallsSilent256FramesComeBeforeAnOrder)
{
    Verifies(req::SRS_MGR_126);
    script.receive = [this](host::LiveFrame& frame)
    {
        frame = Heartbeat(host::LiveNow());
        return script.received < 100000U;
    };
    Type("quit\n");
    EXPECT_FALSE(Run());
    EXPECT_EQ(Reason(), "quit");
    EXPECT_EQ(script.received, 256U);
    // Nor does the cycle wait: the resets of the start-up went out in it
    EXPECT_TRUE(std::any_of(script.sent.begin(), script.sent.end(), [](const host::LiveFrame& frame)
                            { return frame.identifier == 0U && frame.data[0] == 0x82U; }));
}

TEST_F(ManagerRunTest, ABusThatIsLostAndBackIsToldAndHoldsUpNothing)
{
    Verifies(req::SRS_MGR_125);
    runtime::ManagerSocket socket(Path("m.sock"));
    const host::LiveFile client = Connect(Path("m.sock"));
    // Given a bus that is down from 500 ms to 1500 ms, and an order at 1000 ms
    const std::uint64_t begin_ns = host::LiveNow();
    std::vector<std::size_t> sent_until;
    script.receive = [this, begin_ns, &client, &sent_until](host::LiveFrame&)
    {
        const std::uint64_t ms = (host::LiveNow() - begin_ns) / kMs;
        script.state = (ms >= 500U && ms < 1500U) ? host::BusState::kDown : host::BusState::kActive;
        if (ms >= 1000U + 200U * sent_until.size() && sent_until.size() < 2U)
        {
            sent_until.push_back(script.sent.size());
            EXPECT_EQ(::send(client.Get(), "preop 5\n", 8U, MSG_NOSIGNAL), 8);
        }
        return false;
    };
    EXPECT_FALSE(Run(&socket));
    const std::vector<nlohmann::json> told = Told("bus");
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(told[0]["state"], "down");
    EXPECT_EQ(told[1]["state"], "active");
    // Then both orders are carried out while it is down
    const std::vector<nlohmann::json> orders = Told("order");
    ASSERT_EQ(orders.size(), 2U);
    EXPECT_EQ(orders[0]["answer"], "taken");
    EXPECT_GE(orders[0]["t_us"], 1000000);
    EXPECT_LT(orders[1]["t_us"], 1210000);
    // And what they are to send is tried again in each cycle
    ASSERT_EQ(sent_until.size(), 2U);
    EXPECT_GE(sent_until[1] - sent_until[0], 190U);
}

TEST_F(ManagerRunTest, NoSlaveIsLostByAPauseOfNineSeconds)
{
    Verifies(req::SRS_MGR_127);
    // Given a process that stood still, and 1800 heartbeats 5 ms apart, of a slave that is lost after 20 ms
    Pause(9000U * kMs);
    EXPECT_FALSE(Run());
    EXPECT_EQ(script.received, 1800U);
    EXPECT_EQ(Told("heartbeat_lost").size(), 0U);
    EXPECT_EQ(Told("duplicate").size(), 0U);
    EXPECT_EQ(Told("lost_frames").size(), 0U);
}

TEST_F(ManagerRunTest, BehindALongerPauseWhatWaitedIsLeftAsideAndTold)
{
    Verifies(req::SRS_MGR_128);
    // Given the same and one microsecond more, and among what waited a boot-up message and an emergency of node 6
    host::LiveFrame boot_up = Heartbeat(host::LiveNow(), 0U);
    boot_up.identifier = 0x706U;
    host::LiveFrame emergency = Heartbeat(host::LiveNow());
    emergency.identifier = 0x86U;
    emergency.length_bytes = 8U;
    emergency.data[0] = 0x00U;
    emergency.data[1] = 0x10U;
    Pause(9000U * kMs + 1000U, {boot_up, emergency});
    EXPECT_FALSE(Run());
    EXPECT_EQ(script.received, 1802U);
    const std::vector<nlohmann::json> told = Told("lost_frames");
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0]["count"], 1802);
    ASSERT_EQ(Told("boot_up").size(), 1U);
    EXPECT_EQ(Told("boot_up")[0]["node"], 6);
    ASSERT_EQ(Told("emergency").size(), 1U);
    EXPECT_EQ(Told("emergency")[0]["code"], 0x1000);
}

TEST_F(ManagerRunTest, ALogThatCannotBeWrittenIsToldAndEndsNothing)
{
    Verifies(req::SRS_MGR_124);
    // Given a file system without room
    settings.log = "/dev/full";
    EXPECT_FALSE(Run());
    EXPECT_FALSE(is_log_whole);
    const std::string told = "the event log cannot be written any more\n";
    const std::size_t place = shown.find(told);
    ASSERT_NE(place, std::string::npos) << shown;
    EXPECT_EQ(shown.find(told, place + 1U), std::string::npos) << shown;
    // Then the run goes on to its end
    EXPECT_NE(shown.find("stopped by --for\n", place), std::string::npos) << shown;
}

TEST_F(ManagerRunTest, OnATerminalTheTableIsRedrawnAboveTheLastAnswer)
{
    Verifies(req::SRS_MGR_129);
    settings.is_screen = true;
    Type("stop 99\nboot 98\nfly");
    EXPECT_FALSE(Run());
    const std::string home = "\x1b[H\x1b[2J";
    const std::string head = "node  name                  state";
    const std::string first = "\nnode 99 is not in the network file, expected a slave\n\norder (help): ";
    const std::string second = "\nnode 98 is not in the network file, expected a slave\n\norder (help): ";
    // Each drawing begins at the top, with the table
    std::vector<std::string> drawings;
    for (std::size_t place = shown.find(home); place != std::string::npos;)
    {
        const std::size_t next = shown.find(home, place + 1U);
        drawings.push_back(shown.substr(place + home.size(), next - place - home.size()));
        EXPECT_EQ(drawings.back().rfind("manager, node 127: ", 0U), 0U) << drawings.back();
        EXPECT_NE(drawings.back().find(head), std::string::npos) << drawings.back();
        place = next;
    }
    // At once, at each answer, each 250 ms of 2 s, and at the end
    ASSERT_GE(drawings.size(), 10U);
    EXPECT_NE(drawings[0].find(first), std::string::npos) << drawings[0];
    // And the answer to the second order stays until the end, with what is typed so far
    EXPECT_EQ(drawings.back().find(first), std::string::npos) << drawings.back();
    EXPECT_NE(drawings.back().find(second + "fly"), std::string::npos) << drawings.back();
    // The answer to status is the table
    Type("stop 99\nstatus\n");
    EXPECT_FALSE(Run());
    const std::string last = shown.substr(shown.rfind(home));
    EXPECT_EQ(last.find(first), std::string::npos) << last;
    EXPECT_EQ(last.find(head), last.rfind(head)) << last;
}

TEST_F(ManagerRunTest, AnOrderThatTheEndOfTheInputCutsIsToldAndNotCarriedOut)
{
    Verifies(req::SRS_MGR_471);
    const std::string answer = "order 'qui' without an end of its line, expected whole lines; it is not carried out";
    settings.for_ns = 500U * kMs;
    Type("stop 99\nqui");
    EndInput();
    EXPECT_FALSE(Run());
    EXPECT_EQ(Reason(), "--for");
    ASSERT_EQ(Told("order").size(), 2U);
    EXPECT_EQ(Told("order")[0]["order"], "stop 99");
    EXPECT_EQ(Told("order")[1]["order"], "qui");
    EXPECT_EQ(Told("order")[1]["answer"], answer);
    EXPECT_NE(shown.find("\n" + answer + "\n"), std::string::npos) << shown;
    // And whole, it is an order
    settings.for_ns = 3600000U * kMs;
    Type("stop 99\nquit\n");
    EndInput();
    EXPECT_FALSE(Run());
    EXPECT_EQ(Reason(), "quit");
}

const std::string kSix = "slaves: [{node: 50}, {node: 51}, {node: 52}, {node: 53}, {node: 54}, {node: 55}]\n";
const std::vector<std::string> kSixStops{"130 0", "2 50", "2 51", "2 52", "2 53", "2 54", "2 55"};

TEST_F(ManagerRunTest, WhatWaitsForTheInhibitTimeLeavesBeforeTheEnd)
{
    Verifies(req::SRS_MGR_520);
    Verifies(req::SRS_NMM_001);
    for (const char* const profile : {"cia302", "el6751", "plc_designer"})
    {
        // Given six stops that were taken one behind the other, and the end right behind them
        network = "manager: {node: 127, inhibit: 20 ms, profile: " + std::string(profile) + "}\n" + kSix;
        settings.for_ns = 3600000U * kMs;
        script = Script{};
        Type("stop 50\nstop 51\nstop 52\nstop 53\nstop 54\nstop 55\nquit\n");
        EXPECT_FALSE(Run());
        EXPECT_EQ(Reason(), "quit");
        // Then all of them leave
        std::vector<std::string> stops = Commands();
        stops.erase(
            std::remove_if(stops.begin(), stops.end(), [](const auto& each) { return each.rfind("2 ", 0U) != 0U; }),
            stops.end());
        EXPECT_EQ(stops, std::vector<std::string>(kSixStops.begin() + 1, kSixStops.end())) << profile;
        EXPECT_TRUE(Told("unsent").empty()) << profile;
    }
}

TEST_F(ManagerRunTest, WhateverEndsARunCommandsLeaveBeforeIt)
{
    Verifies(req::SRS_MGR_520);
    network = "manager: {node: 127, inhibit: 20 ms, profile: el6751}\n" + kSix;
    for (const int number : {SIGINT, SIGTERM, SIGHUP, 0})
    {
        settings.for_ns = (number == 0) ? 1U : 3600000U * kMs;
        const auto before = (number == 0) ? SIG_DFL : std::signal(number, SIG_DFL);
        script = Script{};
        script.receive = [number](host::LiveFrame&)
        {
            static_cast<void>((number == 0) ? 0 : std::raise(number));
            return false;
        };
        Type("stop all\n");
        EXPECT_FALSE(Run());
        static_cast<void>((number == 0) ? SIG_DFL : std::signal(number, before));
        EXPECT_EQ(Reason(), (number == 0) ? "--for" : "signal");
        EXPECT_EQ(Commands(), kSixStops) << number;
    }
}

TEST_F(ManagerRunTest, TheEndIsBoundedWhateverTheInhibitTime)
{
    Verifies(req::SRS_MGR_520);
    // Given 6 s between two commands, then what waits goes without them
    network = "manager: {node: 127, inhibit: 6 s, profile: el6751}\n" + kSix;
    settings.for_ns = 3600000U * kMs;
    Type("stop all\nquit\n");
    EXPECT_FALSE(Run());
    EXPECT_EQ(Commands(), kSixStops);
    ASSERT_EQ(Told("stopped").size(), 1U);
    EXPECT_GE(Told("stopped")[0]["t_us"].get<std::uint64_t>(), 2000000U);
    EXPECT_TRUE(Told("unsent").empty());
}

TEST_F(ManagerRunTest, CommandsThatDoNotLeaveAreTold)
{
    Verifies(req::SRS_MGR_520);
    network = "manager: {node: 127, inhibit: 20 ms, profile: el6751}\nslaves: [{node: 50}, {node: 51}]\n";
    settings.for_ns = 3600000U * kMs;
    // Given a controller that has no room for stops
    script.refused = 2U;
    Type("stop all\nquit\n");
    EXPECT_FALSE(Run());
    EXPECT_EQ(Commands(), (std::vector<std::string>{"130 0"}));
    ASSERT_EQ(Told("unsent").size(), 1U);
    EXPECT_EQ(Told("unsent")[0]["count"], 2);
    EXPECT_EQ(Told("unsent")[0]["commands"], nlohmann::json({"stop node 50", "stop node 51"}));
    EXPECT_EQ(Told("unsent")[0]["frames"], 0);
    EXPECT_EQ(Told("unsent")[0]["text"], "2 NMT commands have not left: stop node 50, stop node 51");
    // 2 s, and 0.1 s more
    ASSERT_EQ(Told("stopped").size(), 1U);
    EXPECT_GE(Told("stopped")[0]["t_us"].get<std::uint64_t>(), 2100000U);
    EXPECT_LT(Told("stopped")[0]["t_us"].get<std::uint64_t>(), 2110000U);
    // Or a bus that is down, or bus-off, which is not waited for
    for (const host::BusState state : {host::BusState::kDown, host::BusState::kBusOff})
    {
        script = Script{};
        script.state = state;
        Type("stop 50\nquit\n");
        EXPECT_FALSE(Run());
        ASSERT_EQ(Told("unsent").size(), 1U);
        EXPECT_EQ(Told("unsent")[0]["commands"], nlohmann::json({"reset-comm all", "stop node 50"}));
        EXPECT_LT(script.turns, 100U); // 2 s have many more turns.
    }
}

TEST_F(ManagerRunTest, FramesThatWaitInThisHostAreHandedOverBeforeTheEnd)
{
    Verifies(req::SRS_MGR_520);
    settings.for_ns = 3600000U * kMs;
    script.waits_for = 20U;
    Type("quit\n");
    EXPECT_FALSE(Run());
    EXPECT_EQ(script.turns, 22U); // And once more for what is told.
    EXPECT_TRUE(Told("unsent").empty());
    // Or told
    script = Script{};
    script.state = host::BusState::kDown;
    script.waits_for = 1000U;
    Type("quit\n");
    EXPECT_FALSE(Run());
    ASSERT_EQ(Told("unsent").size(), 1U);
    EXPECT_EQ(Told("unsent")[0]["frames"], 1);
}

TEST_F(ManagerRunTest, NothingIsCarriedOutBehindQuit)
{
    Verifies(req::SRS_MGR_521);
    Verifies(req::SRS_MGR_520);
    const std::string answer = "not carried out: the manager ends";
    settings.for_ns = 3600000U * kMs;
    network = "manager: {node: 127}\nslaves: [{node: 50}]\n";
    Type("stop 50\nquit\nstart 50\n\nstatus\n");
    EXPECT_FALSE(Run());
    EXPECT_EQ(Commands(), (std::vector<std::string>{"130 0", "2 50"}));
    ASSERT_EQ(Told("order").size(), 3U);
    EXPECT_EQ(Told("order")[1]["order"], "start 50");
    EXPECT_EQ(Told("order")[1]["answer"], answer);
    EXPECT_EQ(Told("order")[2]["order"], "status");
    EXPECT_NE(shown.find("\n" + answer + "\n"), std::string::npos) << shown;
    // By the socket alike
    script = Script{};
    runtime::ManagerSocket socket(Path("m.sock"));
    const host::LiveFile client = Connect(Path("m.sock"));
    const std::string lines = "stop 50\nquit\nstart 50\n";
    ASSERT_EQ(::send(client.Get(), lines.data(), lines.size(), 0), static_cast<ssize_t>(lines.size()));
    settings.input = -1;
    EXPECT_FALSE(Run(&socket));
    EXPECT_EQ(Commands(), (std::vector<std::string>{"130 0", "2 50"}));
    ASSERT_EQ(Told("order").size(), 2U);
    EXPECT_EQ(Told("order")[1]["answer"], answer);
}
} // namespace
} // namespace counterpoint::tools
