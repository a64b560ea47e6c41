// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/bus.hpp"
#include "tests/runtime/node/process.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

// A node of the running chain is stopped for long, starved, or changed in its memory: its peers are safe in time, and
// nothing comes back without an acknowledge.
namespace counterpoint::tools::test
{
namespace
{
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
    /// Whether a frame with this identifier came.
    static bool Hears(host::LiveBus& bus, std::uint32_t identifier)
    {
        bool has_come = false;
        host::LiveFrame frame;
        while (bus.Receive(frame))
        {
            has_come = has_come || frame.identifier == identifier;
        }
        return has_come;
    }
    void ExpectClosedInTime(const char* what, const std::uint64_t since_ns, const NodeLine& closed) const
    {
        const double took_ms = static_cast<double>(closed.read_ns - since_ns) / 1e6;
        std::printf("%s: output closed %.1f ms later; limit %.1f ms\n", what, took_ms, LimitMsOf(*actuator));
        EXPECT_LE(took_ms, LimitMsOf(*actuator));
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
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), kLongStopMs));
    // When it goes on, it is in its safe state, its own outputs are closed, and it sends nothing
    const std::unique_ptr<host::LiveBus> bus = host::OpenLiveBus(OwnBus());
    controller->Signal(SIGCONT);
    EXPECT_EQ(controller->WaitFor("device_fault").event["fault"], "late_call");
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), 1000));
    EXPECT_FALSE(Hears(*bus, 0x103U));
    controller->Type("nmt start");
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), 500));
    ExpectOpenOnlyByAcknowledge();
    ExpectClosedInTime("SIGSTOP for 10 s", since_ns, closed);
}

TEST_F(NodeAttackTest, AStarvedControllerLeavesItsPeerSafe)
{
    Verifies(req::SRS_NODE_006);
    Verifies(req::SRS_NODE_007);
    // When the controller may go on for a millisecond in each tenth of a second
    const std::uint64_t since_ns = NowNs();
    controller->Signal(SIGSTOP);
    const NodeLine closed = actuator->WaitFor(Event("output", "open", false));
    for (int turn = 0; turn < 30; ++turn)
    {
        controller->Signal(SIGCONT);
        SleepMs(1);
        controller->Signal(SIGSTOP);
        SleepMs(99);
    }
    controller->Signal(SIGCONT);
    ASSERT_FALSE(closed.event.is_null());
    ExpectClosedInTime("starved", since_ns, closed);
    EXPECT_EQ(controller->WaitFor("device_fault").event["fault"], "late_call");
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), 500));
    ExpectOpenOnlyByAcknowledge();
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
    EXPECT_NE(covered(*sensor).find("KiB of program, "), std::string::npos);
    EXPECT_NE(covered(*sensor).find(" bytes of channels and kernel, every "), std::string::npos);
    sensor = StartNode("emergency_stop/sensor.dcf", {"--no-self-tests"});
    EXPECT_EQ(covered(*sensor), "none");
}

} // namespace
} // namespace counterpoint::tools::test
