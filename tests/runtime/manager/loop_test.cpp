// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The executive of a live manager on a bus of this test.
#include "runtime/manager/loop.hpp"
#include "runtime/network_files/file.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "tests/hal/host/live_server_rig.hpp"
#include "tests/runtime/manager/run_rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <deque>
#include <memory>
#include <sstream>
#include <thread>
#include <utility>

namespace counterpoint::tools
{
namespace
{
using test::kMs;

constexpr std::size_t kFrames = 300U; ///< More than the loop takes in a turn.
constexpr std::uint64_t kPeriodNs = 5U * kMs;
constexpr std::uint64_t kPauseNs = kFrames * kPeriodNs;

/// Heartbeats of node 5 that nobody could read for a while: all at once, with the times at which they came; behind them
/// emergency 6100h of node 5, and frames of the same length that are none.
class WaitingBus final : public host::LiveBus
{
  public:
    WaitingBus(const std::uint64_t apart_ns, std::string name)
        : name_(std::move(name)), begin_ns_(host::LiveNow() + 20U * kMs)
    {
        for (std::size_t place = 0U; place < kFrames; ++place)
        {
            host::LiveFrame frame;
            frame.identifier = 0x705U;
            frame.length_bytes = 1U;
            frame.data[0] = 0x7FU;
            frame.time_ns = begin_ns_ + kPauseNs - apart_ns * (kFrames - place);
            frames_.push_back(frame);
        }
        frames_.push_back(Fault(0x385U));
        frames_.push_back(Fault(0x85U));
        frames_.push_back(Fault(0x85U));
        frames_.back().extended = true;
        frames_.push_back(Fault(0x85U));
        frames_.back().length_bytes = 7U;
    }
    [[nodiscard]] host::SendResult Send(const host::LiveFrame& /*frame*/) override
    {
        return host::SendResult::kSent;
    }
    [[nodiscard]] bool Receive(host::LiveFrame& frame) override
    {
        const std::uint64_t now_ns = host::LiveNow();
        const std::uint64_t end_ns = begin_ns_ + kPauseNs;
        std::this_thread::sleep_for(std::chrono::nanoseconds((now_ns < end_ns) ? end_ns - now_ns : 0U)); // The pause.
        const bool is_one = !frames_.empty();
        if (is_one)
        {
            frame = frames_.front();
            frames_.pop_front();
        }
        return is_one;
    }
    [[nodiscard]] int Descriptor() const override
    {
        return -1;
    }
    [[nodiscard]] host::BusHealth Health() const override
    {
        host::BusHealth health;
        health.state = host::BusState::kActive;
        return health;
    }
    [[nodiscard]] std::string Name() const override
    {
        return name_;
    }
    [[nodiscard]] bool Restart() override
    {
        return false;
    }

  private:
    [[nodiscard]] host::LiveFrame Fault(const std::uint32_t identifier) const
    {
        host::LiveFrame frame;
        frame.identifier = identifier;
        frame.length_bytes = 8U;
        frame.data[1] = 0x61U;
        frame.data[2] = 0x81U;
        frame.time_ns = begin_ns_ + kPauseNs;
        return frame;
    }

    std::string name_;
    std::uint64_t begin_ns_;
    std::deque<host::LiveFrame> frames_;
};

std::vector<host::LiveFrame> Frames(const std::size_t count, const std::uint32_t identifier = 0x185U,
                                    const std::uint8_t byte = 0x05U)
{
    host::LiveFrame frame;
    frame.identifier = identifier;
    frame.length_bytes = 1U;
    frame.data[0] = byte;
    return std::vector<host::LiveFrame>(count, frame);
}

class ManagerLoopTest : public cia306::test::FolderTest
{
  protected:
    /// What the log says of `event`, from a run on heartbeats that came `apart_ns` from each other.
    std::vector<nlohmann::json> Told(const std::string& event, const std::uint64_t apart_ns,
                                     const std::uint64_t longest_pause_ns, const std::string& name)
    {
        network_plan::LoadedNetwork net(runtime::ReadNetworkFile(
            File("net.yaml",
                 "manager: {node: 127}\nslaves: [{node: 5, heartbeat: 5 ms, consumer: 9 s, arming: immediately}]\n"),
            0U));
        std::ostringstream out;
        runtime::NodeReport report(out, runtime::ReportForm::kText, host::LiveNow());
        runtime::ManagerLoopSettings settings;
        settings.log = Path("log.jsonl");
        settings.longest_pause_ns = longest_pause_ns;
        settings.for_ns = kPauseNs + 200U * kMs;
        runtime::ManagerLoop loop(net, std::make_unique<WaitingBus>(apart_ns, name), report, nullptr, settings);
        EXPECT_FALSE(loop.Run());
        std::istringstream log(cia306::ReadTextFile(Path("log.jsonl")));
        std::vector<nlohmann::json> told;
        for (std::string line; std::getline(log, line);)
        {
            told.push_back(nlohmann::json::parse(line));
        }
        told.erase(std::remove_if(told.begin(), told.end(), [&](const auto& each) { return each["event"] != event; }),
                   told.end());
        return told;
    }
    std::size_t Duplicates(const std::uint64_t apart_ns,
                           const std::uint64_t longest_pause_ns = runtime::kLongestPauseNs,
                           const std::string& name = "udp:239.74.163.91:43191")
    {
        return Told("duplicate", apart_ns, longest_pause_ns, name).size();
    }
};

TEST_F(ManagerLoopTest, WhatWaitedDuringAPauseIsNoSecondDevice)
{
    Verifies(req::SRS_MGR_127);
    Verifies(req::SRS_MGR_128);
    Verifies(req::SRS_MGR_140);
    Verifies(req::SRS_MGR_010);
    // Given 300 heartbeats that came each 5 ms while the process was paused, then one device is seen
    EXPECT_EQ(Duplicates(kPeriodNs), 0U);
    // And given as many that came within 300 us, then two
    EXPECT_EQ(Duplicates(1000U), 1U);
    // But after a pause that is too long to know, what waited is left aside
    EXPECT_EQ(Duplicates(1000U, 1000U * kMs), 0U);
    // Nor is there a second device when a connection without times gives all of it at once
    EXPECT_EQ(Duplicates(0U, runtime::kLongestPauseNs, "socketcand:localhost:1/can0"), 0U);
}

// A device in its safe state tells it once: what else says that it is in it?
TEST_F(ManagerLoopTest, AnEmergencyThatWaitedIsNotLeftAside)
{
    Verifies(req::SRS_MGR_128);
    Verifies(req::SRS_MGR_140);
    Verifies(req::SRS_MGR_025);
    const std::pair<std::uint64_t, const char*> runs[] = {{1000U * kMs, "udp:239.74.163.91:43191"},
                                                          {runtime::kLongestPauseNs, "socketcand:localhost:1/can0"}};
    for (const auto& [longest_pause_ns, name] : runs)
    {
        // Given an emergency of node 5 among what waited too long, or in a heap, and frames that look like one
        const std::vector<nlohmann::json> told = Told("emergency", 1000U, longest_pause_ns, name);
        // Then it is told, and alone
        ASSERT_EQ(told.size(), 1U) << name;
        EXPECT_EQ(told[0]["node"], 5) << name;
        EXPECT_EQ(told[0]["code"], 0x6100) << name;
    }
}

/// A connection that is down, and opens itself again some day. It looks who else is at its server.
class DownBus final : public host::LiveBus
{
  public:
    DownBus(const host::RunningServer& server, std::uint32_t& others) : server_(server), others_(others)
    {
    }
    [[nodiscard]] host::SendResult Send(const host::LiveFrame& /*frame*/) override
    {
        return host::SendResult::kDown;
    }
    [[nodiscard]] bool Receive(host::LiveFrame& /*frame*/) override
    {
        others_ = std::max(others_, server_.Counts().clients);
        return false;
    }
    [[nodiscard]] int Descriptor() const override
    {
        return -1;
    }
    [[nodiscard]] host::BusHealth Health() const override
    {
        host::BusHealth health;
        health.state = host::BusState::kDown;
        return health;
    }
    [[nodiscard]] std::string Name() const override
    {
        return server_.Address("can0");
    }
    [[nodiscard]] bool Restart() override
    {
        return false;
    }

  private:
    const host::RunningServer& server_;
    std::uint32_t& others_;
};

// Given a connection that is lost, then only its bus opens it again: by a second one the manager would hear itself.
TEST_F(ManagerLoopTest, ALostConnectionIsOpenedByItsBusAlone)
{
    Verifies(req::SRS_MGR_125);
    const host::RunningServer server("udp:239.74.163.92:43192");
    std::uint32_t others = 0U;
    network_plan::LoadedNetwork net(
        runtime::ReadNetworkFile(File("net.yaml", "manager: {node: 127}\nslaves: [{node: 5, heartbeat: 5 ms}]\n"), 0U));
    std::ostringstream out;
    runtime::NodeReport report(out, runtime::ReportForm::kText, host::LiveNow());
    runtime::ManagerLoopSettings settings;
    settings.for_ns = 2000U * kMs;
    runtime::ManagerLoop loop(net, std::make_unique<DownBus>(server, others), report, nullptr, settings);
    EXPECT_FALSE(loop.Run());
    EXPECT_EQ(others, 0U);
}

TEST_F(ManagerLoopTest, AHeapIsMoreThanABusCarriesAfterASilence)
{
    Verifies(req::SRS_MGR_140);
    // Given a full bus of 1 Mbit/s, 21 frames a millisecond, after a silence of 600 ms
    runtime::FrameBacklog full(0U);
    for (std::uint64_t ms = 600U; ms < 3000U; ++ms)
    {
        EXPECT_FALSE(full.Has(Frames(21U), ms * kMs)) << ms;
    }
    // And a connection that gives 73 frames in each of 13 ms, some in each turn, and then what is on the bus
    runtime::FrameBacklog backlog(0U);
    std::size_t passed = 0U;
    for (std::uint64_t turn = 0U; turn < 130U; ++turn)
    {
        passed += backlog.Has(Frames(7U + turn % 2U), 600U * kMs + turn * 100000U) ? 0U : 7U + turn % 2U;
    }
    EXPECT_LT(passed, 80U);
    for (std::uint64_t ms = 700U; ms < 1000U; ++ms)
    {
        EXPECT_FALSE(backlog.Has(Frames(1U), ms * kMs)) << ms;
    }
    // Then a backlog without a silence before it is none
    EXPECT_FALSE(runtime::FrameBacklog(0U).Has(Frames(300U), 400U * kMs));
}

TEST_F(ManagerLoopTest, AHeapHasItsLimits)
{
    Verifies(req::SRS_MGR_140);
    // Given a silence of 500 ms, or one that is longer
    EXPECT_FALSE(runtime::FrameBacklog(0U).Has(Frames(300U), 500U * kMs));
    EXPECT_TRUE(runtime::FrameBacklog(0U).Has(Frames(300U), 500U * kMs + 1U));
    // Given 42 frames of 47 us, which are 1974 us, and 43, which are 2021
    EXPECT_FALSE(runtime::FrameBacklog(0U).Has(Frames(42U), 600U * kMs));
    EXPECT_TRUE(runtime::FrameBacklog(0U).Has(Frames(43U), 600U * kMs));
    // Given two heartbeats of one node, 1 ms each, and three
    EXPECT_FALSE(runtime::FrameBacklog(0U).Has(Frames(2U, 0x705U), 600U * kMs));
    EXPECT_TRUE(runtime::FrameBacklog(0U).Has(Frames(3U, 0x705U), 600U * kMs));
    // Given 300 frames within 1 s behind the end of the silence at 600 ms, and at its end
    for (const std::uint64_t ms : {1599U, 1600U})
    {
        runtime::FrameBacklog backlog(0U);
        for (const std::uint64_t before : {std::uint64_t{600U}, std::uint64_t{1000U}, std::uint64_t{1400U}, ms - 1U})
        {
            EXPECT_FALSE(backlog.Has(Frames((before == ms - 1U) ? 0U : 1U), before * kMs));
        }
        EXPECT_EQ(backlog.Has(Frames(300U), ms * kMs), ms == 1599U) << ms;
    }
}

TEST_F(ManagerLoopTest, AHeapIsAlsoMoreHeartbeatsOfANodeThanItCanSend)
{
    Verifies(req::SRS_MGR_140);
    // Given a server that stalled for 800 ms, and eight heartbeats of node 5 that it then gives at once, or in two
    // parts
    runtime::FrameBacklog at_once(0U);
    EXPECT_TRUE(at_once.Has(Frames(8U, 0x705U), 800U * kMs));
    runtime::FrameBacklog in_parts(0U);
    EXPECT_FALSE(in_parts.Has(Frames(2U, 0x705U), 800U * kMs));
    EXPECT_TRUE(in_parts.Has(Frames(6U, 0x705U), 800U * kMs + 300000U));
    // Then that ends with them
    EXPECT_FALSE(in_parts.Has({}, 810U * kMs));
    EXPECT_FALSE(in_parts.Has(Frames(1U, 0x705U), 900U * kMs));
    // And given a heartbeat each of 20 nodes behind each other, or two devices with one node-ID, then it is none
    runtime::FrameBacklog nodes(0U);
    for (std::uint32_t node = 1U; node <= 20U; ++node)
    {
        EXPECT_FALSE(nodes.Has(Frames(1U, 0x700U + node), 800U * kMs + node * 60000U)) << node;
    }
    runtime::FrameBacklog two(0U);
    EXPECT_FALSE(two.Has(Frames(2U, 0x705U), 800U * kMs));
    // Nor other frames, or boot-up messages, which are taken anyway
    runtime::FrameBacklog others(0U);
    EXPECT_FALSE(others.Has(Frames(8U, 0x185U), 800U * kMs));
    runtime::FrameBacklog boot_ups(0U);
    EXPECT_FALSE(boot_ups.Has(Frames(8U, 0x705U, 0U), 800U * kMs));
}

TEST_F(ManagerLoopTest, ABootUpMessageIsOneByteOfSomebodyElse)
{
    Verifies(req::SRS_MGR_128);
    const host::LiveFrame boot_up = Frames(1U, 0x705U, 0U).front();
    EXPECT_TRUE(runtime::IsBootUp(boot_up));
    std::vector<host::LiveFrame> others(8U, boot_up);
    others[0].own = true;
    others[1].error = true;
    others[2].remote = true;
    others[3].extended = true;
    others[4].identifier = 0x700U;
    others[5].identifier = 0x780U;
    others[6].length_bytes = 2U;
    others[7].data[0] = 5U;
    for (std::size_t place = 0U; place < others.size(); ++place)
    {
        EXPECT_FALSE(runtime::IsBootUp(others[place])) << place;
    }
    others[4].identifier = 0x701U;
    others[5].identifier = 0x77FU;
    EXPECT_TRUE(runtime::IsBootUp(others[4]));
    EXPECT_TRUE(runtime::IsBootUp(others[5]));
}
} // namespace
} // namespace counterpoint::tools
