// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/verifies.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>

namespace counterpoint::tools::test
{
namespace
{

const std::string kGroup = "udp:239.74.163.11:" + std::to_string(20'000 + (::getpid() % 40'000));

/// Sends a signal to this process until it is destroyed; before the command catches it, it does nothing.
class Insistent
{
  public:
    explicit Insistent(const int number) : number_{number}
    {
        static_cast<void>(std::signal(number, [](int) {}));
    }
    ~Insistent()
    {
        is_done_ = true;
        thread_.join();
        static_cast<void>(std::signal(number_, SIG_DFL));
    }
    Insistent(const Insistent&) = delete;
    Insistent& operator=(const Insistent&) = delete;

  private:
    void Run() const
    {
        while (!is_done_)
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            static_cast<void>(::kill(::getpid(), number_));
        }
    }

    int number_;
    std::atomic<bool> is_done_{false};
    std::thread thread_{[this] { Run(); }};
};

// Given a bus and a free port, then the command tells where it serves and, when asked to end, what was carried.
TEST(BusCommandTest, TellsWhereItServesAndEndsBySignals)
{
    Verifies(req::SRS_LIVE_056);
    for (const int number : {SIGINT, SIGTERM})
    {
        const Insistent asking(number);
        const Answer answer = RunCommand({"bus", "line=" + kGroup, "--listen", "127.0.0.1:0"});
        EXPECT_EQ(answer.status, 0) << answer.err;
        const std::string start = kGroup + " is socketcand:127.0.0.1:";
        EXPECT_EQ(answer.out.substr(0U, start.size()), start);
        EXPECT_NE(answer.out.find(
                      "/line\n0 clients, 0 frames to the bus, 0 told to clients, 0 malformed orders, 0 clients too "
                      "slow and disconnected\n"),
                  std::string::npos)
            << answer.out;
        EXPECT_EQ(answer.err, "");
    }
}

// Given a time and --json, then it ends by itself and every line is an object.
TEST(BusCommandTest, EndsByItself)
{
    Verifies(req::SRS_LIVE_056);
    const Answer answer =
        RunCommand({"bus", kGroup + "?bitrate=125000", "--listen", "127.0.0.1:0", "--seconds", "1", "--json"});
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(answer.out.substr(0U, 57U), "{\"format\":\"counterpoint-bus-1\",\"host\":\"127.0.0.1\",\"port\":");
    EXPECT_NE(answer.out.find("\"buses\":{\"can0\":\"" + kGroup +
                              "?bitrate=125000\"}}\n{\"format\":\"counterpoint-bus-1\",\"clients\":0,\"to_bus\":0,"
                              "\"from_bus\":0,\"malformed\":0,\"too_slow\":0}\n"),
              std::string::npos)
        << answer.out;
}

// Given what cannot be served, then one line says so, with status 2.
TEST(BusCommandTest, RefusesWhatItCannotServe)
{
    Verifies(req::SRS_LIVE_056);
    const auto error_of = [](const std::vector<std::string>& arguments)
    {
        const Answer answer = RunCommand(arguments);
        EXPECT_EQ(answer.status, 2);
        EXPECT_EQ(answer.out, "");
        return answer.err;
    };
    EXPECT_EQ(error_of({"bus", "tcp:1"}),
              "counterpoint bus: bus 'tcp:1': kind 'tcp', expected can0, socketcan:can0, socketcand:HOST:PORT/can0 or "
              "udp:239.74.163.2:43113\n");
    EXPECT_EQ(error_of({"bus", "can0=" + kGroup, "can0=" + kGroup}),
              "counterpoint bus: two buses are named 'can0', expected NAME=ADDRESS with names that differ\n");
    for (const std::string name : {"", "a b", "a>", "a_name_that_is_too_long"})
    {
        EXPECT_EQ(error_of({"bus", name + "=" + kGroup, "--listen", "127.0.0.1:0", "--seconds", "1"}),
                  "counterpoint bus: name '" + name +
                      "', expected 1 to 15 characters without space, <, >, / and :, such as can0\n");
    }
    for (const std::string place :
         {"127.0.0.1", "127.0.0.1:65536", "::1:0", "[]:0", ":1", "127.0.0.1:", "127.0.0.1:1x"})
    {
        EXPECT_EQ(error_of({"bus", kGroup, "--listen", place}),
                  "counterpoint bus: --listen '" + place +
                      "', expected HOST:PORT with a port from 0 (a free one) to 65535, and an IPv6 address in "
                      "brackets\n");
    }
    EXPECT_NE(error_of({"bus"}).find("BUS"), std::string::npos);
}

} // namespace
} // namespace counterpoint::tools::test
