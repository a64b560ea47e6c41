// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/loop.hpp"
#include "tests/runtime/node/troubled_bus.hpp"
#include "tests/tools/echo_bus.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <csignal>
#include <deque>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

// A node whose bus has troubles: what it tells of them, in a time that the test makes.
namespace counterpoint::tools::test
{
namespace
{
constexpr std::uint64_t kMs = 1000000U;

class NodeTroublesTest : public ::testing::Test
{
  protected:
    NodeTroublesTest()
    {
        static_cast<void>(::sigprocmask(SIG_BLOCK, nullptr, &mask_));
    }
    ~NodeTroublesTest() override
    {
        for (const int number : {SIGTERM, SIGINT, SIGPIPE, SIGTTIN})
        {
            std::signal(number, SIG_DFL);
        }
        static_cast<void>(::sigprocmask(SIG_SETMASK, &mask_, nullptr));
    }
    /// What a node of the actuator tells until it ends after `end_ms`; orders come from `input`.
    std::string Run(std::unique_ptr<host::LiveBus> safety, std::unique_ptr<host::LiveBus> services,
                    const std::uint64_t end_ms, const int input = -1)
    {
        std::ostringstream out;
        runtime::NodeReport report{out, runtime::ReportForm::kText, host::LiveNow()};
        runtime::NodePorts ports{std::move(safety), std::move(services)};
        runtime::NodeScript script;
        script.steps = {{end_ms * kMs, 0U, runtime::ParseOrder("quit")}};
        const auto make = [&ports, &report](const std::optional<std::uint8_t> /*lss_node_id*/)
        {
            runtime::NodeSettings settings;
            settings.dcf = std::string(COUNTERPOINT_SOURCE) + "/examples/emergency_stop/actuator.dcf";
            settings.cycle_us = 20000U;
            settings.has_self_tests = false;
            return std::make_unique<runtime::NodeDevice>(settings, ports, report);
        };
        runtime::NodeLoop loop{{make, ports, report, script, input}};
        EXPECT_EQ(loop.Run(), runtime::ExitStatus::kHolds);
        EXPECT_TRUE(report.Finish());
        return out.str();
    }

    /// The same on a quiet bus, for 0.2 s: `early` is typed before, `late` when the node looks at its bus after 0.1 s;
    /// then the input ends.
    std::string Typed(const std::string& early, const std::string& late = "")
    {
        std::array<int, 2U> input{};
        EXPECT_EQ(::pipe(input.data()), 0);
        EXPECT_EQ(::write(input[1], early.data(), early.size()), static_cast<ssize_t>(early.size()));
        const std::uint64_t begin_ns = host::LiveNow();
        const auto write_late = [&input, &late, begin_ns, is_done = false]() mutable
        {
            if (!is_done && host::LiveNow() - begin_ns >= 100U * kMs)
            {
                is_done = true;
                EXPECT_EQ(::write(input[1], late.data(), late.size()), static_cast<ssize_t>(late.size()));
                EXPECT_EQ(::close(input[1]), 0);
            }
            host::BusHealth health;
            health.state = host::BusState::kActive;
            return health;
        };
        const std::string told =
            Run(std::make_unique<TroubledBus>(), std::make_unique<TroubledBus>(write_late), 200U, input[0]);
        EXPECT_EQ(::close(input[0]), 0);
        return told;
    }

  private:
    sigset_t mask_{};
};

std::size_t CountOf(const std::string& told, const std::string& text)
{
    std::size_t count = 0U;
    for (std::size_t at = told.find(text); at != std::string::npos; at = told.find(text, at + 1U))
    {
        ++count;
    }
    return count;
}

/// From 0.3 s on error passive, from 0.6 s off, from 0.9 s without anything that could be told, from 1.2 s on active,
/// with 3 frames lost from 1.5 s on.
TroubledBus::Condition Troubles()
{
    const std::uint64_t begin_ns = host::LiveNow();
    return [begin_ns]
    {
        const std::uint64_t ms = (host::LiveNow() - begin_ns) / kMs;
        host::BusHealth health;
        health.state = host::BusState::kActive;
        health.state = (ms >= 300U) ? host::BusState::kPassive : health.state;
        health.state = (ms >= 600U) ? host::BusState::kBusOff : health.state;
        health.state = (ms >= 900U) ? host::BusState::kInvalid : health.state;
        health.state = (ms >= 1200U) ? host::BusState::kActive : health.state;
        health.lost_frames = (ms >= 1500U) ? 3U : 0U;
        return health;
    };
}

TEST_F(NodeTroublesTest, EachStateOfTheBusAndEachLossIsToldOnce)
{
    Verifies(req::SRS_NODE_004);
    Verifies(req::SRS_DEV_016);
    const TroubledBus::Condition troubles = Troubles();
    const auto states_alone = [troubles]
    {
        host::BusHealth health = troubles();
        health.lost_frames = 0U;
        return health;
    };
    const std::string told =
        Run(std::make_unique<TroubledBus>(troubles), std::make_unique<TroubledBus>(states_alone), 2000U);
    const std::size_t passive = told.find("bus passive");
    const std::size_t off = told.find("bus bus_off");
    const std::size_t active = told.rfind("bus active");
    ASSERT_NE(passive, std::string::npos) << told;
    ASSERT_NE(off, std::string::npos) << told;
    EXPECT_LT(passive, off);
    EXPECT_LT(off, active);
    EXPECT_EQ(CountOf(told, "  bus "), 3U) << told; // What cannot be told is not told.
    EXPECT_EQ(CountOf(told, "3 frames lost between bus and node"), 1U) << told;
}

// A report of a bus that takes longer than a cycle: the cycle comes late, and the next one at its distance.
TEST_F(NodeTroublesTest, AStepThatTakesLongerThanACycleIsFollowedByTheCycleAtOnce)
{
    Verifies(req::SRS_NODE_005);
    Verifies(req::SRS_NODE_007);
    const std::uint64_t begin_ns = host::LiveNow();
    bool was_slow = false;
    const auto slow_once = [begin_ns, &was_slow]
    {
        if (!std::exchange(was_slow, was_slow || host::LiveNow() - begin_ns > 500U * kMs) && was_slow)
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(35));
        }
        host::BusHealth health;
        health.state = host::BusState::kActive;
        return health;
    };
    const std::string told = Run(std::make_unique<TroubledBus>(), std::make_unique<TroubledBus>(slow_once), 1000U);
    EXPECT_NE(told.find("stopped by quit: outputs closed, production ended"), std::string::npos) << told;
    EXPECT_NE(told.find("greatest delay of a cycle "), std::string::npos) << told;
    EXPECT_EQ(told.find("greatest delay of a cycle 0 us"), std::string::npos) << told;
}

// Each connection gives what is the other one's, too, and errors: only what is its own counts.
TEST_F(NodeTroublesTest, ErrorFramesAndFramesOfTheOtherConnectionAreLeftOut)
{
    Verifies(req::SRS_DEV_007);
    host::LiveFrame error = FrameOf(0x103U, {1U, 2U}, 0U);
    error.error = true;
    const host::LiveFrame start = FrameOf(0x000U, {1U, 0U}, 0U);
    const std::string told =
        Run(std::make_unique<TroubledBus>(TroubledBus::Condition{}, std::deque<host::LiveFrame>{error, start}),
            std::make_unique<TroubledBus>(TroubledBus::Condition{},
                                          std::deque<host::LiveFrame>{error, FrameOf(0x103U, {1U, 2U}, 0U)}),
            200U);
    EXPECT_EQ(told.find("NMT operational"), std::string::npos) << told;
    EXPECT_EQ(told.find("SRDO 1: "), std::string::npos) << told;
}

TEST_F(NodeTroublesTest, ALineThatHasNoEndWhenTheInputEndsIsTold)
{
    Verifies(req::SRS_NODE_003);
    const std::string told = Typed("nmt\nsta");
    EXPECT_EQ(CountOf(told, "NMT pre_operational"), 2U) << told;
    EXPECT_EQ(CountOf(told, "an order 'sta' without an end of its line, expected whole lines; no more are read"), 1U)
        << told;
    EXPECT_EQ(CountOf(Typed("nmt\n"), "without an end"), 0U);
}

// The rest of it is a part of it, also where that has no end.
TEST_F(NodeTroublesTest, AnOrderThatIsTooLongAndHasNoEndIsToldOnce)
{
    Verifies(req::SRS_NODE_331);
    const std::string told = Typed(std::string(1500U, 'x'), "y");
    EXPECT_EQ(CountOf(told, "an order of more than 1024 characters"), 1U) << told;
    EXPECT_EQ(CountOf(told, "without an end"), 0U) << told;
}
} // namespace
} // namespace counterpoint::tools::test
