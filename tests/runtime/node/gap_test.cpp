// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/loop.hpp"
#include "tests/runtime/node/troubled_bus.hpp"
#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <memory>
#include <sstream>
#include <string>

// A node whose bus was away for a moment, or gave what is no frame, in a time that the test makes.
namespace counterpoint::tools::test
{
namespace
{
constexpr std::uint64_t kMillisecondNs = 1000000U;

host::BusHealth HealthyBus()
{
    host::BusHealth health;
    health.state = host::BusState::kActive;
    return health;
}

/// Since the test began.
class TestClock
{
  public:
    [[nodiscard]] std::uint64_t Ms() const
    {
        return (host::LiveNow() - begin_ns_) / kMillisecondNs;
    }

  private:
    std::uint64_t begin_ns_{host::LiveNow()};
};

class NodeGapTest : public ::testing::Test
{
  protected:
    NodeGapTest()
    {
        static_cast<void>(::sigprocmask(SIG_BLOCK, nullptr, &mask_));
    }
    ~NodeGapTest() override
    {
        for (const int number : {SIGTERM, SIGINT, SIGPIPE, SIGTTIN})
        {
            std::signal(number, SIG_DFL);
        }
        static_cast<void>(::sigprocmask(SIG_SETMASK, &mask_, nullptr));
    }
    /// What a node of the actuator tells in 2 s, which is started after 100 ms.
    static std::string Run(std::unique_ptr<host::LiveBus> safety, std::unique_ptr<host::LiveBus> services)
    {
        std::ostringstream out;
        runtime::NodeReport report{out, runtime::ReportForm::kText, host::LiveNow()};
        runtime::NodePorts ports{std::move(safety), std::move(services)};
        runtime::NodeScript script;
        script.steps = {{100U * kMillisecondNs, 0U, runtime::ParseOrder("nmt start")},
                        {2000U * kMillisecondNs, 0U, runtime::ParseOrder("quit")}};
        const auto make = [&ports, &report](const std::optional<std::uint8_t> /*lss_node_id*/)
        {
            runtime::NodeSettings settings;
            settings.dcf = std::string(COUNTERPOINT_SOURCE) + "/examples/emergency_stop/actuator.dcf";
            settings.cycle_us = 20000U;
            settings.has_self_tests = false;
            return std::make_unique<runtime::NodeDevice>(settings, ports, report);
        };
        runtime::NodeLoop loop{{make, ports, report, script, -1}};
        EXPECT_EQ(loop.Run(), runtime::ExitStatus::kHolds);
        EXPECT_TRUE(report.Finish());
        return out.str();
    }

  private:
    sigset_t mask_{};
};

/// The lines of the report that have one of the texts, without their times, one behind the other.
std::string LinesWith(const std::string& told, const std::vector<std::string>& texts)
{
    std::istringstream all(told);
    std::string found;
    for (std::string line; std::getline(all, line);)
    {
        for (const std::string& text : texts)
        {
            const std::size_t at = line.find(text);
            found += (at == std::string::npos) ? "" : line.substr(at) + "; ";
        }
    }
    return found;
}

// Given a controller that is bus-off and works again between two looks at it, when the node runs, then both are told,
// and it leaves OPERATIONAL as at every bus-off (1029h).
TEST_F(NodeGapTest, ABusOffThatIsOverWhenTheNodeLooksIsToldAndHasItsReaction)
{
    Verifies(req::SRS_NODE_580);
    const TestClock clock;
    const auto condition = [clock]
    {
        host::BusHealth health = HealthyBus();
        const bool was_off = clock.Ms() >= 500U;
        health.absences = was_off ? 1U : 0U;
        health.absence = was_off ? host::BusState::kBusOff : host::BusState::kInvalid;
        return health;
    };
    const std::string told = Run(std::make_unique<TroubledBus>(condition), std::make_unique<TroubledBus>());
    EXPECT_EQ(LinesWith(told, {"bus ", "NMT "}),
              "NMT pre_operational; NMT operational; bus bus_off; bus active; NMT pre_operational; ")
        << told;
}

// Given a second one behind it, which is seen, then that is told as ever, once.
TEST_F(NodeGapTest, AnAbsenceThatIsSeenIsToldOnce)
{
    Verifies(req::SRS_NODE_580);
    const TestClock clock;
    const auto condition = [clock]
    {
        host::BusHealth health = HealthyBus();
        const bool is_down = clock.Ms() >= 500U && clock.Ms() < 1000U;
        health.absences = (clock.Ms() >= 500U) ? 1U : 0U;
        health.absences += (clock.Ms() >= 800U) ? 1U : 0U; // Back and away again between two looks.
        health.absence = (clock.Ms() >= 500U) ? host::BusState::kDown : host::BusState::kInvalid;
        health.state = is_down ? host::BusState::kDown : host::BusState::kActive;
        return health;
    };
    const std::string told = Run(std::make_unique<TroubledBus>(), std::make_unique<TroubledBus>(condition));
    EXPECT_EQ(LinesWith(told, {"bus "}), "bus down; bus active; ") << told;
}

TEST_F(NodeGapTest, WhatCouldNotBeReadIsToldAtMostOnceASecond)
{
    Verifies(req::SRS_NODE_581);
    const TestClock clock;
    const auto condition = [clock]
    {
        host::BusHealth health = HealthyBus();
        health.malformed = (clock.Ms() >= 500U) ? 3U : 0U;
        health.malformed += (clock.Ms() >= 700U) ? 4U : 0U;
        return health;
    };
    auto services = std::make_unique<TroubledBus>(condition);
    services->problem = "a frame without an end";
    const std::string told = Run(std::make_unique<TroubledBus>(), std::move(services));
    const std::string line = "malformed elements of the bus left out, the last: a frame without an end; ";
    EXPECT_EQ(LinesWith(told, {"malformed"}), line + line) << told;
    EXPECT_NE(told.find("3 malformed elements"), std::string::npos) << told;
    EXPECT_NE(told.find("4 malformed elements"), std::string::npos) << told;
}
} // namespace
} // namespace counterpoint::tools::test
