// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Runs of a live manager with frames that are lost, late or of nobody else, with lines that never end, and for
// programs.
#include "canopen/cia306/text/input_error.hpp"
#include "tests/runtime/manager/run_rig.hpp"
#include "verification/trace/ids/comfort.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

#include <chrono>
#include <csignal>
#include <thread>

namespace counterpoint::tools
{
namespace
{
using test::Heartbeat;
using test::kMs;

class ManagerTroubledRunTest : public test::ManagerRun
{
  protected:
    /// These frames come once, in the first turn.
    void Give(const std::vector<host::LiveFrame>& frames)
    {
        script.receive = [frames, next = std::size_t{0U}](host::LiveFrame& frame) mutable
        {
            const bool is_one = next < frames.size();
            frame = is_one ? frames[next] : frame;
            next += is_one ? 1U : 0U;
            return is_one;
        };
    }
    /// Each line of the output that is an object, but for events.
    [[nodiscard]] std::vector<nlohmann::json> Answers() const
    {
        std::istringstream lines(shown);
        std::vector<nlohmann::json> answers;
        for (std::string line; std::getline(lines, line);)
        {
            const nlohmann::json object = nlohmann::json::parse(line);
            EXPECT_EQ(object["format"], "counterpoint-manager-1") << line;
            if (object["event"] == "answer" || object["event"] == "table")
            {
                answers.push_back(object);
            }
        }
        return answers;
    }
};

TEST_F(ManagerTroubledRunTest, FramesThatTheSystemDropsAreTold)
{
    Verifies(req::SRS_MGR_541);
    // Given a system that has dropped 3 frames within half a second, and 5 behind one second
    const std::uint64_t begin_ns = host::LiveNow();
    script.lost = [begin_ns]
    {
        const std::uint64_t ms = (host::LiveNow() - begin_ns) / kMs;
        return (ms < 400U) ? 0U : (ms < 1000U) ? 3U : 5U;
    };
    EXPECT_FALSE(Run());
    const std::vector<nlohmann::json> told = Told("lost_frames");
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(told[0]["count"], 3);
    EXPECT_EQ(told[0]["text"], "3 frames lost between bus and manager");
    EXPECT_EQ(told[1]["count"], 2);
}

TEST_F(ManagerTroubledRunTest, ABusThatIsOffIsToldAsThat)
{
    Verifies(req::SRS_MGR_125);
    script.state = host::BusState::kBusOff;
    settings.for_ns = 500U * kMs;
    EXPECT_FALSE(Run());
    ASSERT_EQ(Told("bus").size(), 1U);
    EXPECT_EQ(Told("bus")[0]["state"], "bus_off");
}

TEST_F(ManagerTroubledRunTest, ErrorFramesFramesOfCanFdAndOwnOnesAreOfNobodyElse)
{
    Verifies(req::SRS_MGR_543);
    for (const std::string profile : {"cia302", "el6751"})
    {
        // Given heartbeats with the identifier of the manager: of a controller that tells an error, of CAN FD, its own
        network = "manager: {node: 127, profile: " + profile + "}\nslaves: [{node: 5, boot: false}]\n";
        host::LiveFrame own = Heartbeat(0U);
        own.identifier = 0x77FU;
        std::vector<host::LiveFrame> frames(3U, own);
        frames[0].error = true;
        frames[1].fd = true;
        frames[2].own = true;
        settings.for_ns = 500U * kMs;
        script = test::Script{};
        Give(frames);
        EXPECT_FALSE(Run());
        EXPECT_EQ(script.received, 3U) << profile;
        EXPECT_TRUE(Told("duplicate").empty()) << profile;
        // And one that somebody else has sent
        frames[2].own = false;
        Give(frames);
        EXPECT_FALSE(Run());
        ASSERT_EQ(Told("duplicate").size(), 1U) << profile;
        EXPECT_EQ(Told("duplicate")[0]["text"], "another device has the manager's node-ID") << profile;
    }
}

TEST_F(ManagerTroubledRunTest, BehindAPauseNoErrorFrameOrOwnOneIsAnEmergency)
{
    Verifies(req::SRS_MGR_128);
    Verifies(req::SRS_MGR_543);
    // Given frames that waited too long, each with identifier and length of an emergency of node 5
    host::LiveFrame emergency = Heartbeat(host::LiveNow());
    emergency.identifier = 0x85U;
    emergency.length_bytes = 8U;
    emergency.data[1] = 0x10U;
    std::vector<host::LiveFrame> frames(4U, emergency);
    frames[0].error = true;
    frames[1].fd = true;
    frames[2].own = true;
    Pause(9000U * kMs + 1000U, frames);
    EXPECT_FALSE(Run());
    EXPECT_EQ(script.received, 1804U);
    ASSERT_EQ(Told("lost_frames").size(), 1U);
    EXPECT_EQ(Told("lost_frames")[0]["count"], 1804);
    EXPECT_EQ(Told("emergency").size(), 1U);
}

TEST_F(ManagerTroubledRunTest, OfAnEndlessBusAMillionFramesAreLeftAsideBeforeAnOrder)
{
    Verifies(req::SRS_MGR_128);
    // Given a pause that is too long, and then a bus that never falls silent
    const std::uint64_t end_ns = host::LiveNow() + 10U * kMs;
    settings.longest_pause_ns = kMs;
    script.receive = [this, end_ns](host::LiveFrame& frame)
    {
        const std::uint64_t now_ns = host::LiveNow();
        std::this_thread::sleep_for(std::chrono::nanoseconds((now_ns < end_ns) ? end_ns - now_ns : 0U));
        frame = Heartbeat(end_ns);
        return script.received < 1200000U;
    };
    settings.for_ns = 3600000U * kMs;
    Type("quit\n");
    EXPECT_FALSE(Run());
    EXPECT_EQ(Reason(), "quit");
    ASSERT_EQ(Told("lost_frames").size(), 1U);
    EXPECT_EQ(Told("lost_frames")[0]["count"], 1000000);
}

TEST_F(ManagerTroubledRunTest, ACycleThatIsDueIsNotWaitedFor)
{
    Verifies(req::SRS_MGR_125);
    // Given a bus that is down and takes 5 ms to say so, four times a second
    script.state = host::BusState::kDown;
    script.lost = []
    {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return 0U;
    };
    std::uint32_t turns = 0U;
    script.receive = [&turns](host::LiveFrame&)
    {
        ++turns;
        return false;
    };
    settings.for_ns = 1000U * kMs;
    EXPECT_FALSE(Run());
    EXPECT_EQ(Reason(), "--for");
    EXPECT_GE(turns, 970U);
}

TEST_F(ManagerTroubledRunTest, WithoutATimeItRunsUntilItIsToldToEnd)
{
    Verifies(req::SRS_MGR_120);
    settings.for_ns = 0U;
    const std::uint64_t begin_ns = host::LiveNow();
    script.receive = [begin_ns](host::LiveFrame&)
    {
        static_cast<void>((host::LiveNow() - begin_ns >= 5000U * kMs) ? std::raise(SIGTERM) : 0);
        return false;
    };
    EXPECT_FALSE(Run());
    EXPECT_EQ(Reason(), "signal");
    EXPECT_GE(Told("stopped")[0]["t_us"], 5000000);
}

TEST_F(ManagerTroubledRunTest, ALogThatCannotBeOpenedIsNoRun)
{
    Verifies(req::SRS_MGR_124);
    settings.log = Path("none/log.jsonl");
    try
    {
        static_cast<void>(Run());
        ADD_FAILURE();
    }
    catch (const cia306::InputError& error)
    {
        EXPECT_EQ(std::string(error.what()),
                  settings.log + ": error: it cannot be opened, expected a path in a writable folder");
    }
    EXPECT_TRUE(script.sent.empty());
    // Without one there is nothing to be opened
    settings.log.clear();
    settings.for_ns = 100U * kMs;
    EXPECT_FALSE(Run());
    EXPECT_TRUE(is_log_whole);
}

TEST_F(ManagerTroubledRunTest, ATypedLineWithoutAnEndIsRefusedOnceAndItsRestLeftAside)
{
    Verifies(req::SRS_MGR_542);
    const std::string refusal = "an order of more than 1024 bytes, expected at most so many in one line\n";
    settings.for_ns = 3600000U * kMs;
    Type(std::string(6000U, 'x') + " \nstop 99\nquit\n");
    EXPECT_FALSE(Run());
    EXPECT_EQ(Reason(), "quit");
    const std::size_t place = shown.find(refusal);
    ASSERT_NE(place, std::string::npos) << shown;
    EXPECT_EQ(shown.find(refusal, place + 1U), std::string::npos) << shown;
    ASSERT_EQ(Told("order").size(), 1U);
    EXPECT_EQ(Told("order")[0]["order"], "stop 99");
    // Also where the input ends within it: in the second or third part that is read of it
    for (const std::size_t length : {std::size_t{4196U}, std::size_t{9292U}})
    {
        settings.for_ns = 500U * kMs;
        Type(std::string(length, 'x'));
        EndInput();
        EXPECT_FALSE(Run());
        EXPECT_EQ(Reason(), "--for");
        EXPECT_NE(shown.find(refusal), std::string::npos) << shown;
        EXPECT_EQ(shown.find(refusal), shown.rfind(refusal)) << shown;
        EXPECT_TRUE(Told("order").empty());
    }
}

TEST_F(ManagerTroubledRunTest, WithJsonEachAnswerIsAnObject)
{
    Verifies(req::SRS_EASE_005);
    Verifies(req::SRS_MGR_005);
    settings.is_json = true;
    settings.for_ns = 3600000U * kMs;
    Type("status\nhelp\n\nfly\nstop 99\nquit\n");
    EXPECT_FALSE(Run());
    const std::vector<nlohmann::json> answers = Answers();
    ASSERT_EQ(answers.size(), 5U) << shown;
    EXPECT_EQ(answers[0]["event"], "table");
    EXPECT_EQ(answers[0]["manager"], 127);
    EXPECT_EQ(answers[1]["text"].get<std::string>().rfind("  status              the table of all slaves\n", 0U), 0U);
    EXPECT_EQ(answers[2]["text"], "order 'fly', expected status, start, stop, preop, reset, reset-comm, boot, "
                                  "write-safety, control, output, get, set, negotiate, help or quit");
    EXPECT_EQ(answers[3]["text"], "node 99 is not in the network file, expected a slave");
    EXPECT_EQ(answers[4]["text"], "taken");
    // And as text, the help is as it is
    settings.is_json = false;
    Type("help\nquit\n");
    EXPECT_FALSE(Run());
    EXPECT_NE(shown.find("\n  quit                end\n"), std::string::npos) << shown;
}

TEST_F(ManagerTroubledRunTest, FramesThatNeverLeaveThisHostAreToldWithoutAnyCommand)
{
    Verifies(req::SRS_MGR_520);
    settings.for_ns = 3600000U * kMs;
    script.waits_for = 100000U;
    Type("quit\n");
    EXPECT_FALSE(Run());
    ASSERT_EQ(Told("unsent").size(), 1U);
    EXPECT_EQ(Told("unsent")[0]["count"], 0);
    EXPECT_EQ(Told("unsent")[0]["frames"], 1);
    EXPECT_EQ(Told("unsent")[0]["text"], "0 NMT commands have not left; 1 frames wait in this host");
    // The manager is there still, to be asked for its table
    EXPECT_EQ(table.rfind("manager, node 127: ", 0U), 0U) << table;
}

TEST_F(ManagerTroubledRunTest, AnOrderThatAClientOfTheSocketCutsIsToldAndNotCarriedOut)
{
    Verifies(req::SRS_MGR_471);
    runtime::ManagerSocket socket(Path("m.sock"));
    const host::LiveFile client = Connect(Path("m.sock"));
    ASSERT_EQ(::send(client.Get(), "sto", 3U, 0), 3);
    ASSERT_EQ(::shutdown(client.Get(), SHUT_WR), 0);
    settings.for_ns = 500U * kMs;
    EXPECT_FALSE(Run(&socket));
    const std::string answer = "order 'sto' without an end of its line, expected whole lines; it is not carried out";
    ASSERT_EQ(Told("order").size(), 1U);
    EXPECT_EQ(Told("order")[0]["answer"], answer);
    char text[256] = {};
    EXPECT_EQ(::recv(client.Get(), text, sizeof(text), 0), static_cast<ssize_t>(answer.size() + 1U));
    EXPECT_EQ(std::string(text), answer + "\n");
}
} // namespace
} // namespace counterpoint::tools
