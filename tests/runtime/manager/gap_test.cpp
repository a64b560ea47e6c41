// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A live manager whose bus was away for a moment, lost frames, or gave what is no frame.
#include "runtime/manager/loop.hpp"
#include "runtime/network_files/file.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <deque>
#include <functional>
#include <memory>
#include <sstream>

namespace counterpoint::tools
{
namespace
{
constexpr std::uint64_t kGapMs = 1000000U;

/// What the bus of a test is like, by the time since its first frame was asked for, and what was sent on it.
struct GapBus
{
    std::function<void(std::uint64_t ms, host::BusHealth& health)> health{[](std::uint64_t, host::BusHealth&) {}};
    std::string problem;
    std::uint64_t begin_ns{host::LiveNow()};
    std::uint64_t next_sign_ms{0U};
    std::uint8_t state{0U}; ///< What slave 5 says: each 10 ms; first that it boots up.
    std::vector<std::uint8_t> commands;
    std::deque<host::LiveFrame> answers; ///< Of its SDO server, which has 0 everywhere and takes everything.

    [[nodiscard]] std::uint64_t Ms() const
    {
        return (host::LiveNow() - begin_ns) / kGapMs;
    }
};

class BusWithGap final : public host::LiveBus
{
  public:
    explicit BusWithGap(GapBus& bus) : bus_(bus)
    {
    }
    [[nodiscard]] host::SendResult Send(const host::LiveFrame& frame) override
    {
        if (frame.identifier == 0U)
        {
            const std::uint8_t command = frame.data[0];
            bus_.commands.push_back(command);
            bus_.state = (command == 1U) ? 5U : bus_.state;
            bus_.state = (command == 0x82U) ? 0U : bus_.state;
        }
        if (frame.identifier == 0x605U)
        {
            host::LiveFrame answer = frame;
            answer.identifier = 0x585U;
            answer.data[0] = ((frame.data[0] & 0xE0U) == 0x40U) ? 0x43U : 0x60U;
            std::fill(answer.data + 4, answer.data + 8, std::uint8_t{0U});
            bus_.answers.push_back(answer);
        }
        return host::SendResult::kSent;
    }
    [[nodiscard]] bool Receive(host::LiveFrame& frame) override
    {
        if (!bus_.answers.empty())
        {
            frame = bus_.answers.front();
            frame.time_ns = host::LiveNow();
            bus_.answers.pop_front();
            return true;
        }
        const std::uint64_t ms = bus_.Ms();
        const bool is_sign = ms >= bus_.next_sign_ms;
        if (is_sign)
        {
            bus_.next_sign_ms = ms + 10U;
            frame = host::LiveFrame{};
            frame.identifier = 0x705U;
            frame.length_bytes = 1U;
            frame.data[0] = bus_.state;
            frame.time_ns = host::LiveNow();
            bus_.state = (bus_.state == 0U) ? 0x7FU : bus_.state;
        }
        return is_sign;
    }
    [[nodiscard]] int Descriptor() const override
    {
        return -1;
    }
    [[nodiscard]] host::BusHealth Health() const override
    {
        host::BusHealth health;
        health.state = host::BusState::kActive;
        bus_.health(bus_.Ms(), health);
        return health;
    }
    [[nodiscard]] std::string Problem() const override
    {
        return bus_.problem;
    }
    [[nodiscard]] std::string Name() const override
    {
        return "udp:239.74.163.91:43191";
    }
    [[nodiscard]] bool Restart() override
    {
        return false;
    }

  private:
    GapBus& bus_;
};

/// Manager 127 and slave 5, which boots up, is started and runs, for 3 s.
class ManagerGapTest : public cia306::test::FolderTest
{
  protected:
    void Run()
    {
        runtime::ManagerLoopSettings settings;
        settings.log = Path("log.jsonl");
        settings.for_ns = 3000U * kGapMs;
        network_plan::LoadedNetwork net(runtime::ReadNetworkFile(
            File("net.yaml",
                 "manager: {node: 127" + manager + "}\nslaves: [{node: 5, heartbeat: 10 ms, consumer: 100 ms}]\n"),
            0U));
        std::ostringstream out;
        runtime::NodeReport report(out, runtime::ReportForm::kText, host::LiveNow());
        runtime::ManagerLoop loop(net, std::make_unique<BusWithGap>(bus), report, nullptr, settings);
        static_cast<void>(loop.Run());
        EXPECT_TRUE(report.Finish());
    }
    /// The events of this kind in the log.
    [[nodiscard]] std::vector<nlohmann::json> Told(const std::string& event) const
    {
        std::istringstream log(cia306::ReadTextFile(Path("log.jsonl")));
        std::vector<nlohmann::json> told;
        for (std::string line; std::getline(log, line);)
        {
            const nlohmann::json each = nlohmann::json::parse(line);
            if (each["event"] == event)
            {
                told.push_back(each);
            }
        }
        return told;
    }
    /// From this time on it says PRE-OPERATIONAL, as if it had booted up unheard.
    void RestartUnheard(const std::uint64_t ms)
    {
        if (!has_restarted && ms >= restart_ms)
        {
            has_restarted = true;
            bus.state = 0x7FU;
        }
    }
    [[nodiscard]] std::size_t Resets() const
    {
        return static_cast<std::size_t>(std::count(bus.commands.begin(), bus.commands.end(), 0x82U));
    }

    GapBus bus;
    std::string manager;
    std::uint64_t restart_ms{1000U};
    bool has_restarted{false};
};

/// It was bus-off for a moment at that time, and works at each look.
void WasOff(const std::uint64_t from_ms, const std::uint64_t ms, host::BusHealth& health)
{
    health.absences = (ms >= from_ms) ? 1U : 0U;
    health.absence = (ms >= from_ms) ? host::BusState::kBusOff : host::BusState::kInvalid;
}

// Given a controller that is bus-off and works again between two looks at it, when it is looked at, then both are told
// one behind the other.
TEST_F(ManagerGapTest, ABusOffThatIsOverWhenTheManagerLooksIsTold)
{
    Verifies(req::SRS_MGR_580);
    bus.health = [](const std::uint64_t ms, host::BusHealth& health) { WasOff(1000U, ms, health); };
    Run();
    const std::vector<nlohmann::json> told = Told("bus");
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(told[0]["state"], "bus_off");
    EXPECT_EQ(told[1]["state"], "active");
    EXPECT_GE(told[0]["t_us"], 1000000);
    EXPECT_LE(told[1]["t_us"], 1260000);
}

// Given the profile el6751, then everything begins anew behind it, as behind each bus-off.
TEST_F(ManagerGapTest, AProfileDoesWhatItDoesAtEachBusOff)
{
    Verifies(req::SRS_MGR_580);
    manager = ", profile: el6751";
    Run();
    const std::size_t resets = Resets();
    ASSERT_GE(resets, 1U);
    bus = GapBus{};
    bus.health = [](const std::uint64_t ms, host::BusHealth& health) { WasOff(1000U, ms, health); };
    Run();
    EXPECT_GT(Resets(), resets);
}

// Given a slave that was started, and whose boot-up message came in the moment in which the bus was away, then it is
// started again: without the absence it stays as somebody has put it.
TEST_F(ManagerGapTest, ASlaveThatBootedUnheardIsStartedUpAgain)
{
    Verifies(req::SRS_MGR_580);
    Verifies(req::SRS_MGR_581);
    const auto starts = [this] { return std::count(bus.commands.begin(), bus.commands.end(), 1U); };
    const auto with = [this](const std::function<void(std::uint64_t, host::BusHealth&)>& trouble)
    {
        bus = GapBus{};
        has_restarted = false;
        bus.health = [this, trouble](const std::uint64_t ms, host::BusHealth& health)
        {
            RestartUnheard(ms);
            trouble(ms, health);
        };
        Run();
    };
    with([](std::uint64_t, host::BusHealth&) {});
    const auto quiet = starts();
    ASSERT_GE(quiet, 1);
    with([](const std::uint64_t ms, host::BusHealth& health) { WasOff(990U, ms, health); });
    EXPECT_GT(starts(), quiet);
    with([](const std::uint64_t ms, host::BusHealth& health) { health.malformed = (ms >= 990U) ? 1U : 0U; });
    EXPECT_GT(starts(), quiet);
    with([](const std::uint64_t ms, host::BusHealth& health) { health.lost_frames = (ms >= 990U) ? 1U : 0U; });
    EXPECT_GT(starts(), quiet);
}

// Given an absence that is seen, and another one within it, then each state is told once.
TEST_F(ManagerGapTest, AnAbsenceThatIsSeenIsToldOnce)
{
    Verifies(req::SRS_MGR_580);
    bus.health = [](const std::uint64_t ms, host::BusHealth& health)
    {
        const bool is_off = ms >= 1000U && ms < 2000U;
        health.state = is_off ? host::BusState::kBusOff : host::BusState::kActive;
        health.absences = (ms >= 1000U) ? 1U : 0U;
        health.absences += (ms >= 1500U) ? 1U : 0U;
        health.absence = is_off ? host::BusState::kBusOff : host::BusState::kInvalid;
    };
    Run();
    const std::vector<nlohmann::json> told = Told("bus");
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(told[0]["state"], "bus_off");
    EXPECT_EQ(told[1]["state"], "active");
}

TEST_F(ManagerGapTest, WhatCouldNotBeReadIsToldAtMostOnceASecond)
{
    Verifies(req::SRS_MGR_581);
    bus.problem = "frame: time 'zz', expected SECONDS.MICROSECONDS";
    bus.health = [](const std::uint64_t ms, host::BusHealth& health)
    {
        health.malformed = (ms >= 1000U) ? 3U : 0U;
        health.malformed += (ms >= 1300U) ? 4U : 0U;
    };
    Run();
    const std::vector<nlohmann::json> told = Told("malformed");
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(told[0]["count"], 3);
    EXPECT_EQ(told[0]["problem"], bus.problem);
    EXPECT_EQ(told[0]["text"], "3 malformed elements of the bus left out, the last: " + bus.problem);
    EXPECT_EQ(told[1]["count"], 4);
    EXPECT_GE(told[1]["t_us"].get<std::uint64_t>() - told[0]["t_us"].get<std::uint64_t>(), 1000000U);
}
} // namespace
} // namespace counterpoint::tools
