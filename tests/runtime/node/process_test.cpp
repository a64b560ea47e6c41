// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/bus.hpp"
#include "tests/runtime/node/process.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <memory>
#include <sys/wait.h>
#include <unistd.h>

// Devices of the shipped DCFs as processes of their own, on one bus.
namespace counterpoint::tools::test
{
namespace
{
const std::string kExamples = std::string(COUNTERPOINT_SOURCE) + "/examples/";

class NodeProcessTest : public ::testing::Test
{
  protected:
    static std::unique_ptr<NodeProcess> Start(const std::string& dcf, const std::vector<std::string>& more = {})
    {
        return StartNode(dcf, more);
    }
    /// Buttons let go, both nodes started, the controller's input released.
    void Exchange()
    {
        sensor = Start("emergency_stop/sensor.dcf");
        controller = Start("emergency_stop/controller.dcf");
        sensor->Type("set 0x2000:01 1");
        controller->Type("nmt start");
        sensor->Type("nmt start 1");
        ASSERT_FALSE(controller->WaitFor(Event("output", "open", true)).event.is_null());
        ASSERT_FALSE(controller->WaitFor(Event("value", "value", 1)).event.is_null());
    }
    /// From `since_ns` to the closed output of the controller, with what it may take.
    void ExpectClosed(const char* what, const std::uint64_t since_ns)
    {
        const NodeLine closed = controller->WaitFor(Event("output", "open", false));
        ASSERT_FALSE(closed.event.is_null());
        const double took_ms = static_cast<double>(closed.read_ns - since_ns) / 1e6;
        controller->Type("quit");
        EXPECT_EQ(controller->End(), 0);
        std::printf("%s: output closed %.1f ms later; limit %.1f ms\n", what, took_ms, LimitMsOf(*controller));
        EXPECT_LE(took_ms, LimitMsOf(*controller));
    }

    std::unique_ptr<NodeProcess> sensor;
    std::unique_ptr<NodeProcess> controller;
};

TEST_F(NodeProcessTest, NothingIsCarriedOutBehindQuit)
{
    Verifies(req::SRS_NODE_500);
    // When lines come in with quit
    sensor = Start("emergency_stop/sensor.dcf");
    sensor->Type("quit\nget 0x1000:00\nnonsense");
    EXPECT_EQ(sensor->End(), 0);
    // Then each is told, and none is carried out
    std::vector<std::string> told;
    for (const NodeLine& line : sensor->Lines())
    {
        EXPECT_NE(line.event["event"], "object");
        if (line.event["event"] == "problem")
        {
            told.push_back(line.event["text"]);
        }
    }
    EXPECT_EQ(told,
              (std::vector<std::string>{
                  "an order 'get 0x1000:00' behind the end of the node, expected none there; it is not carried out",
                  "an order 'nonsense' behind the end of the node, expected none there; it is not carried out"}));
}

TEST_F(NodeProcessTest, TwoNodesExchangePairs)
{
    Verifies(req::SRS_NODE_001);
    Verifies(req::SRS_NODE_003);
    Verifies(req::SRS_NODE_004);
    Exchange();
    sensor->Type("set 0x2000:01 0");
    EXPECT_TRUE(controller->Tells(Event("value", "value", 0), 2000));
    sensor->Type("get 0x1018:02");
    EXPECT_EQ(sensor->WaitFor("object").event["value"], 1);
    sensor->Type("set 0x2000:01 256");
    EXPECT_FALSE(sensor->WaitFor("problem").event.is_null());
    sensor->Type("set 0x2200:01 1");
    EXPECT_FALSE(sensor->WaitFor("problem").event.is_null());
    sensor->Type("start");
    EXPECT_FALSE(sensor->WaitFor("problem").event.is_null());
    sensor->Type("ack 2");
    EXPECT_FALSE(sensor->WaitFor("problem").event.is_null());
    sensor->Type("gfc");
    EXPECT_FALSE(controller->WaitFor("gfc").event.is_null());
    sensor->Type("nmt");
    EXPECT_EQ(sensor->WaitFor("nmt").event["state"], "operational");
    sensor->Type("state");
    EXPECT_EQ(sensor->WaitFor("state").event["srdos"][0]["state"], "producer");
    sensor->Type("quit");
    EXPECT_EQ(sensor->End(), 0);
}

TEST_F(NodeProcessTest, AnOutputThatCannotBeWrittenIsToldByTheExitStatus)
{
    Verifies(req::SRS_NODE_211);
    Verifies(req::SRS_NODE_212);
    const auto status = [](const std::string& output)
    {
        const std::string words = "echo quit | " + std::string(COUNTERPOINT_PROGRAM) + " node --can " + OwnBus() +
                                  " --dcf " + kExamples + "emergency_stop/sensor.dcf --cycle-us 10000 > " + output;
        return WEXITSTATUS(std::system(words.c_str()));
    };
    EXPECT_EQ(status("/dev/null"), 0);
    EXPECT_EQ(status("/dev/full"), 2);
    // A pipe that is full, and nobody reads it
    std::array<int, 2U> ends{};
    ASSERT_EQ(::pipe2(ends.data(), O_NONBLOCK), 0);
    while (::write(ends[1], "x", 1U) == 1)
    {
    }
    EXPECT_EQ(status("/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(ends[1])), 2);
    EXPECT_EQ(::close(ends[0]) + ::close(ends[1]), 0);
}

TEST_F(NodeProcessTest, AFloodOfOtherFramesDoesNotDisturbPairs)
{
    Verifies(req::SRS_DEV_007);
    Verifies(req::SRS_NODE_002);
    Exchange();
    // When somebody sends 5000 frames a second for two seconds: SDO, PDO, heartbeats, SYNC, SRDOs of others, wrong GFCs
    const std::unique_ptr<host::LiveBus> bus = host::OpenLiveBus(OwnBus());
    const std::uint64_t until_ns = NowNs() + 2000000000U;
    std::uint32_t sent = 0U;
    for (; NowNs() < until_ns; SleepMs(5))
    {
        for (const std::uint32_t identifier : {0x602U, 0x202U, 0x705U, 0x080U, 0x105U, 0x17FU, 0x582U, 0x001U})
        {
            for (int count = 0; count < 4; ++count)
            {
                host::LiveFrame frame;
                frame.identifier = identifier;
                frame.length_bytes = 8U;
                sent += (bus->Send(frame) == host::SendResult::kSent) ? 1U : 0U;
            }
        }
        host::LiveFrame own;
        while (bus->Receive(own))
        {
        }
    }
    // Then the output stayed open, and no error was seen
    EXPECT_GT(sent, 5000U);
    EXPECT_FALSE(controller->Tells([](const nlohmann::json& event)
                                   { return event["event"] == "output" || event["event"] == "srdo_error"; }, 100));
    controller->Type("state");
    EXPECT_EQ(controller->WaitFor("state").event["srdos"][0]["state"], "released");
    sensor->Type("quit");
    EXPECT_EQ(sensor->End(), 0);
}

TEST_F(NodeProcessTest, LatencyAndDelaysAreToldAtTheEnd)
{
    Verifies(req::SRS_NODE_002);
    Verifies(req::SRS_NODE_008);
    Exchange();
    EXPECT_FALSE(controller->Tells(Event("device_fault", "fault", "clock"), 1000));
    controller->Type("quit");
    EXPECT_EQ(controller->End(), 0);
    bool has_latency = false;
    for (const NodeLine& line : controller->Lines())
    {
        if (line.event["event"] == "latency")
        {
            has_latency = true;
            EXPECT_GE(line.event["pairs"], 20);
            EXPECT_LE(line.event["least_us"], line.event["median_us"]);
            EXPECT_LE(line.event["median_us"], line.event["percentile_99_us"]);
            EXPECT_LE(line.event["percentile_99_us"], line.event["greatest_us"]);
            EXPECT_LT(line.event["median_us"], 2 * kCycleUs);
            std::printf("receive stamp to released output: %s\n", line.event.dump().c_str());
        }
    }
    EXPECT_TRUE(has_latency);
    EXPECT_EQ(controller->Lines().back().event["event"], "stopped");
}

TEST_F(NodeProcessTest, AProducerThatIsKilledMakesItsConsumerSafe)
{
    Verifies(req::SRS_NODE_007);
    Exchange();
    const std::uint64_t since_ns = NowNs();
    sensor->Signal(SIGKILL);
    ExpectClosed("kill -9", since_ns);
}

TEST_F(NodeProcessTest, AProducerThatIsTerminatedSaysSoAndItsConsumerIsSafe)
{
    Verifies(req::SRS_NODE_005);
    Verifies(req::SRS_NODE_007);
    Exchange();
    const std::uint64_t since_ns = NowNs();
    sensor->Signal(SIGTERM);
    ExpectClosed("SIGTERM", since_ns);
    EXPECT_EQ(sensor->End(), 0);
    EXPECT_EQ(sensor->Lines().back().event["event"], "stopped");
    EXPECT_EQ(sensor->Lines().back().event["reason"], "SIGTERM");
}

TEST_F(NodeProcessTest, EachSignalOfAnEndIsTold)
{
    Verifies(req::SRS_NODE_005);
    for (const auto& [number, name] : {std::pair(SIGINT, "SIGINT"), std::pair(SIGHUP, "SIGHUP")})
    {
        // Given one that is started from a terminal, whatever started the test
        const auto before = std::signal(number, SIG_DFL);
        sensor = Start("emergency_stop/sensor.dcf");
        static_cast<void>(std::signal(number, before));
        sensor->Signal(number);
        EXPECT_EQ(sensor->End(), 0) << name;
        EXPECT_EQ(sensor->Lines().back().event["event"], "stopped") << name;
        EXPECT_EQ(sensor->Lines().back().event["reason"], name);
    }
    // One that is started as nohup starts it goes on
    const auto before = std::signal(SIGHUP, SIG_IGN);
    sensor = Start("emergency_stop/sensor.dcf");
    static_cast<void>(std::signal(SIGHUP, before));
    sensor->Signal(SIGHUP);
    sensor->Type("nmt");
    EXPECT_FALSE(sensor->WaitFor("nmt").event.is_null());
    sensor->Type("quit");
    EXPECT_EQ(sensor->End(), 0);
    EXPECT_EQ(sensor->Lines().back().event["reason"], "quit");
}

TEST_F(NodeProcessTest, AProducerThatIsStoppedStaysSafeWhenItGoesOn)
{
    Verifies(req::SRS_NODE_006);
    Verifies(req::SRS_NODE_007);
    Verifies(req::SRS_NODE_005);
    Exchange();
    const std::uint64_t since_ns = NowNs();
    sensor->Signal(SIGSTOP);
    ExpectClosed("SIGSTOP", since_ns);
    sensor->Signal(SIGCONT);
    EXPECT_EQ(sensor->WaitFor("device_fault").event["fault"], "late_call");
    // A typed end is told as the end of a device in its safe state
    sensor->Type("quit");
    EXPECT_EQ(sensor->End(), 1);
    EXPECT_EQ(sensor->Lines().back().event["device_safe_state"], true);
}

TEST_F(NodeProcessTest, AConsumerThatStarvedOpensNothingWithoutResetAndAcknowledge)
{
    Verifies(req::SRS_NODE_006);
    controller = Start("emergency_stop/controller.dcf");
    const auto actuator = Start("emergency_stop/actuator.dcf");
    controller->Type("nmt start");
    actuator->Type("nmt start");
    // Given an output that a person released
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), 300));
    actuator->Type("ack 1");
    EXPECT_TRUE(actuator->Tells(Event("output", "open", true), 2000));
    // When the process gets no processor for 200 ms
    actuator->Signal(SIGSTOP);
    ASSERT_FALSE(actuator->Tells(Event("output", "open", false), 200));
    actuator->Signal(SIGCONT);
    // Then its output is closed, and told with the time at which it closed, the device safe, and neither acknowledge
    // nor start changes that
    const NodeLine closed = actuator->WaitFor(Event("output", "open", false));
    const NodeLine fault = actuator->WaitFor("device_fault");
    EXPECT_EQ(fault.event["fault"], "late_call");
    EXPECT_GT(fault.event["at_us"].get<std::int64_t>() - closed.event["at_us"].get<std::int64_t>(), 150000);
    actuator->Type("ack 1");
    actuator->Type("nmt pre-operational");
    actuator->Type("nmt reset-communication");
    actuator->Type("nmt start");
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), 500));
    // When the node is reset and started, it still waits for a person
    actuator->Type("nmt reset-node");
    actuator->Type("nmt start");
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), 500));
    actuator->Type("ack 1");
    EXPECT_TRUE(actuator->Tells(Event("output", "open", true), 2000));
    actuator->Type("quit");
    EXPECT_EQ(actuator->End(), 0);
}

TEST_F(NodeProcessTest, WhatWasSavedIsThereAfterTheNextStart)
{
    Verifies(req::SRS_NODE_011);
    const std::string everything = "../tests/runtime/data/everything.dcf";
    const std::string file = ::testing::TempDir() + "node_store_" + OwnBus().substr(OwnBus().rfind(':') + 1U);
    std::remove(file.c_str());
    // Given a value and an SCT that were changed, and saved
    auto node = Start(everything, {"--store", file});
    node->Type("set 0x4005:00 50");
    node->Type("set 0x1301:02 60");
    node->Type("set 0x1010:01 0x65766173");
    EXPECT_FALSE(node->Tells(Event("device_fault", "fault", "late_call"), 500));
    node->Type("quit");
    EXPECT_EQ(node->End(), 0);
    // When another process starts, it has them, and its safety configuration is not valid
    node = Start(everything, {"--store", file});
    node->Type("get 0x4005:00");
    EXPECT_EQ(node->WaitFor("object").event["value"], 50);
    node->Type("get 0x1301:02");
    EXPECT_EQ(node->WaitFor("object").event["value"], 60);
    node->Type("get 0x13FE:00");
    EXPECT_EQ(node->WaitFor("object").event["value"], 0);
    // When defaults are asked for, they are back after a reset
    node->Type("set 0x1011:01 0x64616F6C");
    EXPECT_FALSE(node->Tells(Event("device_fault", "fault", "late_call"), 500));
    node->Type("nmt reset-node");
    EXPECT_FALSE(node->WaitFor("nmt").event.is_null());
    node->Type("get 0x4005:00");
    EXPECT_EQ(node->WaitFor("object").event["value"], 9);
    node->Type("get 0x13FE:00");
    EXPECT_EQ(node->WaitFor("object").event["value"], 0xA5);
    node->Type("quit");
    EXPECT_EQ(node->End(), 0);
    std::remove(file.c_str());
    // Without a store there is nothing to save to
    node = Start(everything);
    node->Type("set 0x1010:01 0x65766173");
    EXPECT_EQ(
        node->WaitFor("problem").event["text"],
        "set: 0x1010:01 = 1702257011 refused with 0800 0020h, expected an input or an object of the device, and a "
        "value that it takes");
}

TEST_F(NodeProcessTest, TheChainRunsByItsScripts)
{
    Verifies(req::SRS_NODE_003);
    Verifies(req::SRS_NODE_005);
    const std::string scripts = kExamples + "node/";
    const auto actuator = Start("emergency_stop/actuator.dcf", {"--script", scripts + "actuator.yaml"});
    controller = Start("emergency_stop/controller.dcf", {"--script", scripts + "controller.yaml"});
    sensor = Start("emergency_stop/sensor.dcf", {"--script", scripts + "sensor.yaml"});
    // Both buttons let go, a person acknowledges, one button pressed: the actuator follows
    EXPECT_TRUE(actuator->Tells(Event("output", "open", true), 5000));
    EXPECT_TRUE(actuator->Tells(Event("value", "value", 1), 5000));
    EXPECT_TRUE(actuator->Tells(Event("value", "value", 0), 5000));
    EXPECT_EQ(sensor->End(), 0);
    EXPECT_EQ(sensor->Lines().back().event["reason"], "quit");
}

} // namespace
} // namespace counterpoint::tools::test
