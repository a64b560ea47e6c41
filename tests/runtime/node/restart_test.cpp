// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/loop.hpp"
#include "tests/tools/echo_bus.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <csignal>
#include <deque>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// A start that takes longer than the window of the watchdog: the actuator of the examples, whose output opens with the
// second pair after an acknowledge, if the watchdog is alive.
namespace counterpoint::tools::test
{
namespace
{
constexpr std::uint64_t kNsPerUs = 1000U;
constexpr std::uint64_t kNsPerMs = 1000000U;
const std::string kActuator = std::string(COUNTERPOINT_SOURCE) + "/examples/emergency_stop/actuator.dcf";

runtime::NodeSettings SettingsOf(const std::uint32_t cycle_us)
{
    runtime::NodeSettings settings;
    settings.dcf = kActuator;
    settings.cycle_us = cycle_us;
    settings.has_self_tests = false;
    return settings;
}

/// The device alone, in a time that the test makes. Cycle 10 ms, late above 20 ms.
class NodeRestartTest : public ::testing::Test
{
  protected:
    InstantPair Now() const
    {
        const Instant now{static_cast<std::uint32_t>(now_ns / kNsPerUs)};
        return {now, now};
    }
    void Receive(const std::uint32_t identifier, const std::initializer_list<std::uint8_t> bytes)
    {
        now_ns += kNsPerMs;
        device.OnFrame(FrameOf(identifier, bytes, now_ns), CanPortId::kFirst, Now());
    }
    /// A pair, and the cycle 10 ms after the one before.
    void Cycle()
    {
        Receive(0x103U, {1U, 2U});
        Receive(0x104U, {0xFEU, 0xFDU});
        now_ns += 8U * kNsPerMs;
        device.Cycle(Now(), now_ns);
        static_cast<void>(device.TakeRestart(now_ns));
        device.LookAtOutput(now_ns);
    }
    /// From PRE-OPERATIONAL to what an acknowledge opens.
    SrdoMask OpenAfterStart()
    {
        Receive(0x000U, {1U, device.Assembly().NodeId()});
        now_ns += 9U * kNsPerMs;
        device.Cycle(Now(), now_ns);
        device.LookAtOutput(now_ns);
        Cycle();
        Cycle();
        EXPECT_TRUE(device.Acknowledge(1U, now_ns));
        Cycle();
        EXPECT_EQ(device.Outputs().Open(), 0U);
        Cycle();
        return device.Outputs().Open();
    }

    std::ostringstream out{};
    runtime::NodeReport report{out, runtime::ReportForm::kText, 0U};
    runtime::NodePorts ports{std::make_unique<EchoBus>(false, 0U), std::make_unique<EchoBus>(false, 0U)};
    runtime::NodeDevice device{SettingsOf(10000U), ports, report};
    std::uint64_t now_ns{1000U * kNsPerMs};
};

// t [ms]   1000 power-on      1300 all done, window from here      1310 cycle
TEST_F(NodeRestartTest, TheWatchdogCountsFromTheEndOfTheFirstStart)
{
    Verifies(req::SRS_NODE_018);
    ASSERT_TRUE(device.PowerOn(Now(), now_ns));
    now_ns += 300U * kNsPerMs;
    ASSERT_TRUE(device.TakeRestart(now_ns));
    EXPECT_FALSE(device.TakeRestart(now_ns));
    EXPECT_EQ(OpenAfterStart(), 1U);
    EXPECT_EQ(device.Assembly().Core().DeviceState().fault, DeviceFault::kNone);
}

// t [ms]   0 cycle: reset node      0.3 s all done, window from here      cycles
TEST_F(NodeRestartTest, TheWatchdogCountsFromTheEndOfAStartByResetNode)
{
    Verifies(req::SRS_NODE_018);
    ASSERT_TRUE(device.PowerOn(Now(), now_ns));
    ASSERT_TRUE(device.TakeRestart(now_ns));
    ASSERT_EQ(OpenAfterStart(), 1U);
    // When the node is reset, and the start takes 300 ms
    Receive(0x000U, {129U, device.Assembly().NodeId()});
    device.Serve(Now(), now_ns);
    EXPECT_EQ(device.Assembly().Device().State(), cia301::NodeState::kPreOperational);
    device.LookAtOutput(now_ns);
    EXPECT_EQ(device.Outputs().Open(), 0U);
    now_ns += 300U * kNsPerMs;
    ASSERT_TRUE(device.TakeRestart(now_ns));
    // Then the output can open again
    EXPECT_EQ(OpenAfterStart(), 1U);
    EXPECT_EQ(device.Assembly().Core().DeviceState().fault, DeviceFault::kNone);
}

/// Signals as they were before a loop ran.
class SignalsAsBefore
{
  public:
    SignalsAsBefore()
    {
        static_cast<void>(::sigprocmask(SIG_BLOCK, nullptr, &mask_));
    }
    SignalsAsBefore(const SignalsAsBefore&) = delete;
    SignalsAsBefore& operator=(const SignalsAsBefore&) = delete;
    ~SignalsAsBefore()
    {
        for (const int number : {SIGTERM, SIGINT, SIGPIPE, SIGTTIN})
        {
            std::signal(number, SIG_DFL);
        }
        static_cast<void>(::sigprocmask(SIG_SETMASK, &mask_, nullptr));
    }

  private:
    sigset_t mask_{};
};

runtime::ScriptStep Step(const std::uint64_t at_ms, const std::uint64_t every_ms, const std::string& order)
{
    return {at_ms * kNsPerMs, every_ms * kNsPerMs, runtime::ParseOrder(order)};
}

// Cycle 20 ms, late above 40 ms; each boot-up message takes 150 ms, and with it each start.
TEST(NodeLoopTest, AStartThatTakesLongIsNoLateAnswerToTheWatchdog)
{
    Verifies(req::SRS_NODE_018);
    const SignalsAsBefore signals;
    std::ostringstream out;
    runtime::NodeReport report{out, runtime::ReportForm::kText, host::LiveNow()};
    runtime::NodePorts ports{std::make_unique<EchoBus>(true, 150U), std::make_unique<EchoBus>(false, 150U)};
    runtime::NodeScript script;
    script.steps = {Step(300U, 100U, "nmt start"), Step(400U, 250U, "ack 1"), Step(1500U, 0U, "nmt reset-node"),
                    Step(3000U, 0U, "quit")};
    const auto make = [&ports, &report](const std::optional<std::uint8_t> /*lss_node_id*/)
    { return std::make_unique<runtime::NodeDevice>(SettingsOf(20000U), ports, report); };
    runtime::NodeLoop loop{{make, ports, report, script, -1}};
    EXPECT_EQ(loop.Run(), runtime::ExitStatus::kHolds);
    ASSERT_TRUE(report.Finish());
    // Then the output opened after the power-on, closed with the reset, and opened again
    const std::string told = out.str();
    const std::size_t first = told.find("output of SRDO 1 open");
    ASSERT_NE(first, std::string::npos) << told;
    const std::size_t closed = told.find("output of SRDO 1 closed", first);
    ASSERT_NE(closed, std::string::npos) << told;
    EXPECT_NE(told.find("output of SRDO 1 open", closed), std::string::npos) << told;
}

/// A connection to a server, on which pairs come, and of whose frames some are too old from 1 s on, one more each 50
/// ms.
class HoldingBus final : public host::LiveBus
{
  public:
    host::SendResult Send(const host::LiveFrame& frame) override
    {
        return echo_.Send(frame);
    }
    bool Receive(host::LiveFrame& frame) override
    {
        return echo_.Receive(frame);
    }
    int Descriptor() const override
    {
        return -1;
    }
    host::BusHealth Health() const override
    {
        host::BusHealth health = echo_.Health();
        const std::uint64_t age_ns = host::LiveNow() - begin_ns_;
        health.stale_frames = (age_ns < 1000U * kNsPerMs)
                                  ? 0U
                                  : static_cast<std::uint32_t>(1U + (age_ns - 1000U * kNsPerMs) / (50U * kNsPerMs));
        return health;
    }
    std::string Name() const override
    {
        return "socketcand:localhost:1/can0";
    }
    bool Restart() override
    {
        return false;
    }

  private:
    EchoBus echo_{true, 0U};
    std::uint64_t begin_ns_{host::LiveNow()};
};

// Given an output that is open when the connection begins to hold frames, and somebody who acknowledges again and
// again, then it closes and stays so, and what was left aside is told at once, then once a second, with its number.
TEST(NodeLoopTest, WhatAConnectionHoldsIsALossThatIsToldOnceASecond)
{
    Verifies(req::SRS_NODE_031);
    const SignalsAsBefore signals;
    std::ostringstream out;
    runtime::NodeReport report{out, runtime::ReportForm::kJson, host::LiveNow()};
    runtime::NodePorts ports{std::make_unique<HoldingBus>(), std::make_unique<EchoBus>(false, 0U)};
    runtime::NodeScript script;
    script.steps = {Step(100U, 0U, "nmt start"), Step(300U, 100U, "ack 1"), Step(4500U, 0U, "quit")};
    const auto make = [&ports, &report](const std::optional<std::uint8_t> /*lss_node_id*/)
    { return std::make_unique<runtime::NodeDevice>(SettingsOf(20000U), ports, report); };
    runtime::NodeLoop loop{{make, ports, report, script, -1}};
    EXPECT_EQ(loop.Run(), runtime::ExitStatus::kHolds);
    ASSERT_TRUE(report.Finish());
    std::vector<bool> outputs;
    std::vector<std::uint64_t> told_us;
    std::uint64_t count = 0U;
    std::istringstream lines(out.str());
    for (std::string line; std::getline(lines, line);)
    {
        const nlohmann::json event = nlohmann::json::parse(line);
        if (event.at("event") == "output")
        {
            outputs.push_back(event.at("open"));
        }
        if (event.at("event") == "stale_frames")
        {
            told_us.push_back(event.at("at_us"));
            count += event.at("count").get<std::uint64_t>();
        }
    }
    ASSERT_GE(outputs.size(), 2U) << out.str();
    EXPECT_EQ(std::vector<bool>(outputs.end() - 2, outputs.end()), (std::vector<bool>{true, false})) << out.str();
    ASSERT_GE(told_us.size(), 2U) << out.str();
    for (std::size_t place = 1U; place < told_us.size(); ++place)
    {
        EXPECT_GE(told_us[place] - told_us[place - 1U], 1000000U);
    }
    // All of them but those since the last line, of which there is less than one second
    EXPECT_GE(count, 20U * (told_us.size() - 1U));
    EXPECT_LE(count, ports.StaleFrames());
}

/// A controller that has all frames of the next seconds at once, each with the time at which it comes.
class StampedBus final : public host::LiveBus
{
  public:
    explicit StampedBus(std::deque<host::LiveFrame> frames) : frames_(std::move(frames))
    {
    }
    host::SendResult Send(const host::LiveFrame& frame) override
    {
        return echo_.Send(frame);
    }
    bool Receive(host::LiveFrame& frame) override
    {
        const bool is_one = !frames_.empty();
        if (is_one)
        {
            frame = frames_.front();
            frames_.pop_front();
        }
        return is_one || echo_.Receive(frame);
    }
    int Descriptor() const override
    {
        return -1;
    }
    host::BusHealth Health() const override
    {
        return echo_.Health();
    }
    std::string Name() const override
    {
        return "stamped";
    }
    bool Restart() override
    {
        return false;
    }

  private:
    std::deque<host::LiveFrame> frames_;
    EchoBus echo_{false, 0U};
};

// Given normal frames by the first controller, and each 1 ms behind it the inverse one by the second, all of which can
// be read at once, then the kernel gets them in the order of their stamps: each pair is whole, and the output opens.
TEST(NodeLoopTest, FramesOfTwoControllersAreTakenInTheOrderOfTheirStamps)
{
    Verifies(req::SRS_NODE_014);
    Verifies(req::SRS_NODE_005);
    const SignalsAsBefore signals;
    std::deque<host::LiveFrame> normal;
    std::deque<host::LiveFrame> inverse;
    const std::uint64_t begin_ns = host::LiveNow() + 50U * kNsPerMs;
    for (std::uint64_t pair = 0U; pair < 300U; ++pair)
    {
        normal.push_back(FrameOf(0x103U, {1U, 2U}, begin_ns + pair * 10U * kNsPerMs));
        inverse.push_back(FrameOf(0x104U, {0xFEU, 0xFDU}, begin_ns + (pair * 10U + 1U) * kNsPerMs));
    }
    std::ostringstream out;
    runtime::NodeReport report{out, runtime::ReportForm::kText, host::LiveNow()};
    runtime::NodePorts ports{std::make_unique<StampedBus>(normal), std::make_unique<EchoBus>(false, 0U),
                             std::make_unique<StampedBus>(inverse)};
    runtime::NodeScript script;
    script.steps = {Step(300U, 0U, "nmt start"), Step(600U, 200U, "ack 1"), Step(2500U, 0U, "quit")};
    const auto make = [&ports, &report](const std::optional<std::uint8_t> /*lss_node_id*/)
    { return std::make_unique<runtime::NodeDevice>(SettingsOf(20000U), ports, report); };
    runtime::NodeLoop loop{{make, ports, report, script, -1}};
    EXPECT_EQ(loop.Run(), runtime::ExitStatus::kHolds);
    ASSERT_TRUE(report.Finish());
    const std::string told = out.str();
    const std::size_t open = told.find("output of SRDO 1 open");
    ASSERT_NE(open, std::string::npos) << told;
    // And it closes once, before the node says that it has ended
    const std::size_t closed = told.find("output of SRDO 1 closed", open);
    ASSERT_NE(closed, std::string::npos) << told;
    EXPECT_EQ(closed, told.rfind("output of SRDO 1 closed")) << told;
    EXPECT_LT(closed, told.find("stopped by quit")) << told;
}

// Given a frame with a stamp 300 us before that of the frame before it, then it counts as that one, and is
// told at the end.
TEST(NodeLoopTest, AStampBehindAnotherOneIsToldAtTheEnd)
{
    Verifies(req::SRS_NODE_002);
    const SignalsAsBefore signals;
    const std::uint64_t later_ns = host::LiveNow() + 200U * kNsPerMs;
    const std::deque<host::LiveFrame> frames{FrameOf(0x103U, {1U, 2U}, later_ns),
                                             FrameOf(0x103U, {1U, 2U}, later_ns - 300U * kNsPerUs)};
    std::ostringstream out;
    runtime::NodeReport report{out, runtime::ReportForm::kText, host::LiveNow()};
    runtime::NodePorts ports{std::make_unique<StampedBus>(frames), std::make_unique<EchoBus>(false, 0U)};
    runtime::NodeScript script;
    script.steps = {Step(50U, 0U, "nmt start"), Step(500U, 0U, "quit")};
    const auto make = [&ports, &report](const std::optional<std::uint8_t> /*lss_node_id*/)
    { return std::make_unique<runtime::NodeDevice>(SettingsOf(20000U), ports, report); };
    runtime::NodeLoop loop{{make, ports, report, script, -1}};
    EXPECT_EQ(loop.Run(), runtime::ExitStatus::kHolds);
    ASSERT_TRUE(report.Finish());
    const std::string told = out.str();
    EXPECT_NE(told.find("; frames stamped behind another: "), std::string::npos) << told;
    EXPECT_EQ(told.find("stamped behind another: 0,"), std::string::npos) << told;
    // It counts as that one: nothing is out of order to the kernel, which is at work
    EXPECT_NE(told.find("NMT operational"), std::string::npos) << told;
    EXPECT_EQ(told.find("device safe state"), std::string::npos) << told;
}
} // namespace
} // namespace counterpoint::tools::test
