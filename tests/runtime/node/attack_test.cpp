// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/bus.hpp"
#include "tests/runtime/node/process.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <fstream>
#include <gtest/gtest.h>
#include <sched.h>
#include <string>
#include <thread>
#include <unistd.h>

// A node of the running chain is stopped for long, starved, or changed in its memory: its peers are safe in time, and
// nothing comes back without an acknowledge.
namespace counterpoint::tools::test
{
namespace
{
/// From a line that a node writes to the test that reads it.
constexpr double kReadingMs = 100.0;
constexpr int kLongStopMs = 10000;

class NodeAttackTest : public ::testing::Test
{
  protected:
    /// Sensor, controller and actuator; the actuator's output was released by a person.
    void SetUp() override
    {
        actuator = StartNode("emergency_stop/actuator.dcf", {});
        controller = StartNode("emergency_stop/controller.dcf", {});
        sensor = StartNode("emergency_stop/sensor.dcf", {});
        sensor->Type("nmt start");
        controller->Type("nmt start");
        actuator->Type("nmt start");
        ASSERT_FALSE(controller->WaitFor(Event("output", "open", true)).event.is_null());
        ASSERT_FALSE(actuator->Tells(Event("output", "open", true), 300));
        actuator->Type("ack 1");
        ASSERT_FALSE(actuator->WaitFor(Event("output", "open", true)).event.is_null());
    }
    /// What each node told, where a test failed.
    void TearDown() override
    {
        for (NodeProcess* const node : {sensor.get(), controller.get(), actuator.get()})
        {
            for (const NodeLine& line : node->Lines())
            {
                if (HasFailure() && line.event["event"] != "srdo_error")
                {
                    std::printf("%s\n", line.event.dump().c_str());
                }
            }
        }
    }
    /// When the last frame with this identifier came, in the time of NowNs; 0: none did.
    static std::uint64_t LastFrameNs(host::LiveBus& bus, std::uint32_t identifier)
    {
        std::uint64_t last_ns = 0U;
        host::LiveFrame frame;
        while (bus.Receive(frame))
        {
            last_ns = (frame.identifier == identifier) ? frame.time_ns : last_ns;
        }
        return last_ns;
    }
    /// When a node told a line, by its own clock: the least delay of all lines is nearly none.
    static std::uint64_t ToldNs(const NodeProcess& node, const NodeLine& line)
    {
        std::uint64_t start_ns = line.read_ns;
        for (const NodeLine& each : node.Lines())
        {
            start_ns = std::min(start_ns, each.read_ns - each.event["at_us"].get<std::uint64_t>() * 1000U);
        }
        return start_ns + line.event["at_us"].get<std::uint64_t>() * 1000U;
    }
    static double CycleDelayMs(NodeProcess& node)
    {
        node.Type("quit");
        static_cast<void>(node.End());
        double delay_ms = 0.0;
        for (const NodeLine& line : node.Lines())
        {
            delay_ms = (line.event["event"] == "delays") ? line.event["cycle_us"].get<double>() / 1000.0 : delay_ms;
        }
        return delay_ms;
    }
    /// Nothing opens the actuator but a person, whatever the controller went through.
    void ExpectOpenOnlyByAcknowledge()
    {
        controller->Type("nmt reset-node");
        controller->Type("nmt start");
        EXPECT_FALSE(controller->WaitFor(Event("output", "open", true)).event.is_null());
        EXPECT_FALSE(actuator->Tells(Event("output", "open", true), 1000));
        actuator->Type("ack 1");
        EXPECT_FALSE(actuator->WaitFor(Event("output", "open", true)).event.is_null());
    }

    std::unique_ptr<NodeProcess> sensor;
    std::unique_ptr<NodeProcess> controller;
    std::unique_ptr<NodeProcess> actuator;
};

TEST_F(NodeAttackTest, AControllerThatStandsStillForTenSecondsOpensNothingWhenItGoesOn)
{
    Verifies(req::SRS_NODE_006);
    Verifies(req::SRS_NODE_007);
    const std::uint64_t since_ns = NowNs();
    controller->Signal(SIGSTOP);
    const NodeLine closed = actuator->WaitFor(Event("output", "open", false));
    ASSERT_FALSE(closed.event.is_null());
    const double took_ms = static_cast<double>(closed.read_ns - since_ns) / 1e6;
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), kLongStopMs));
    // When it goes on, it is in its safe state, its own outputs are closed, and it sends nothing
    const std::unique_ptr<host::LiveBus> bus = host::OpenLiveBus(OwnBus());
    controller->Signal(SIGCONT);
    EXPECT_EQ(controller->WaitFor("device_fault").event["fault"], "late_call");
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), 1000));
    EXPECT_EQ(LastFrameNs(*bus, 0x103U), 0U);
    controller->Type("nmt start");
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), 500));
    ExpectOpenOnlyByAcknowledge();
    const double delay_ms = CycleDelayMs(*actuator);
    std::printf("SIGSTOP for 10 s: output closed %.1f ms later; limit %.1f ms, delay of the scheduler %.1f ms\n",
                took_ms, LimitMsOf(*actuator), delay_ms);
    EXPECT_LE(took_ms, LimitMsOf(*actuator) + delay_ms + kReadingMs);
}

TEST_F(NodeAttackTest, AStarvedControllerLeavesItsPeerSafe)
{
    Verifies(req::SRS_NODE_006);
    Verifies(req::SRS_NODE_007);
    const std::unique_ptr<host::LiveBus> bus = host::OpenLiveBus(OwnBus());
    ::usleep(200000); // Some frames are heard, however soon it starves.
    // When the controller gets only what everybody else leaves of a processor that is always busy
    cpu_set_t one{};
    CPU_SET(0, &one);
    cpu_set_t all{};
    const sched_param none{};
    sched_param before{};
    const int policy = ::sched_getscheduler(controller->Process());
    ASSERT_EQ(::sched_getparam(controller->Process(), &before), 0);
    ASSERT_EQ(::sched_getaffinity(controller->Process(), sizeof all, &all), 0);
    ASSERT_EQ(::sched_setaffinity(controller->Process(), sizeof one, &one), 0);
    ASSERT_EQ(::sched_setscheduler(controller->Process(), SCHED_IDLE, &none), 0);
    const std::uint64_t until_ns = NowNs() + 3000000000U;
    const auto burn = [&one, until_ns]
    {
        static_cast<void>(::sched_setaffinity(0, sizeof one, &one));
        while (NowNs() < until_ns)
        {
        }
    };
    std::thread first(burn);
    std::thread second(burn);
    const NodeLine closed = actuator->WaitFor(Event("output", "open", false));
    const std::uint64_t last_ns = LastFrameNs(*bus, 0x103U);
    first.join();
    second.join();
    ASSERT_FALSE(closed.event.is_null());
    ASSERT_NE(last_ns, 0U);
    EXPECT_EQ(controller->WaitFor("device_fault").event["fault"], "late_call");
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), 500));
    ASSERT_EQ(::sched_setscheduler(controller->Process(), policy, &before), 0);
    ASSERT_EQ(::sched_setaffinity(controller->Process(), sizeof all, &all), 0);
    ExpectOpenOnlyByAcknowledge();
    const double delay_ms = CycleDelayMs(*actuator);
    const std::uint64_t closed_ns = ToldNs(*actuator, closed);
    const double took_ms = (closed_ns > last_ns) ? static_cast<double>(closed_ns - last_ns) / 1e6 : 0.0;
    std::printf("starved: output closed %.1f ms after the last frame; limit %.1f ms, delay of the scheduler %.1f ms\n",
                took_ms, LimitMsOf(*actuator), delay_ms);
    EXPECT_LE(took_ms, LimitMsOf(*actuator) + delay_ms + kReadingMs);
}

TEST_F(NodeAttackTest, AChangedProgramIsFoundWhileItRuns)
{
    Verifies(req::SRS_NODE_013);
    // Given the code of a function that runs only when the program starts
    std::ifstream maps("/proc/" + std::to_string(controller->Process()) + "/maps");
    std::string line;
    while (std::getline(maps, line) && line.find("r-xp") == std::string::npos)
    {
    }
    const auto first = static_cast<off_t>(std::stoull(line.substr(0U, line.find('-')), nullptr, 16));
    const int memory = ::open(("/proc/" + std::to_string(controller->Process()) + "/mem").c_str(), O_RDWR);
    ASSERT_GE(memory, 0);
    std::uint8_t byte = 0U;
    ASSERT_EQ(::pread(memory, &byte, 1U, first + 4), 1);
    // When one bit of it flips
    byte = static_cast<std::uint8_t>(byte ^ 0x10U);
    ASSERT_EQ(::pwrite(memory, &byte, 1U, first + 4), 1);
    ::close(memory);
    // Then the self test finds it within the diagnostic interval of 10 s, and the outputs of both nodes are closed
    const NodeProcess::Wanted failed = Event("self_test", "failed", "program");
    EXPECT_TRUE(controller->Tells(failed, 15000));
    EXPECT_TRUE(actuator->Tells(Event("output", "open", false), 2000));
    controller->Type("state");
    EXPECT_EQ(controller->WaitFor("state").event["device_fault"], "self_test");
    // A new start finds it again: the program is still changed
    controller->Type("nmt reset-node");
    EXPECT_TRUE(controller->Tells(failed, 5000));
    EXPECT_TRUE(controller->Tells(Event("device_fault", "fault", "self_test"), 1000));
    controller->Type("quit");
    EXPECT_EQ(controller->End(), 1);
}

TEST_F(NodeAttackTest, SelfTestsCanBeLeftOut)
{
    Verifies(req::SRS_NODE_013);
    const auto covered = [](const NodeProcess& node)
    {
        for (const NodeLine& line : node.Lines())
        {
            if (line.event["event"] == "self_tests")
            {
                return line.event["covered"].get<std::string>();
            }
        }
        return std::string();
    };
    EXPECT_NE(covered(*sensor).find("KiB of program"), std::string::npos);
    sensor = StartNode("emergency_stop/sensor.dcf", {"--no-self-tests"});
    EXPECT_EQ(covered(*sensor), "none");
}

} // namespace
} // namespace counterpoint::tools::test
