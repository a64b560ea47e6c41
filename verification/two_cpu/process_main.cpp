// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// One CPU of two as a process of its own, in real time or a test's: link and CAN bus are datagrams on the loopback
// interface. The process with role A plays the sensor as well. Exit status: 0 what was asked holds, 1 it does not, 2
// bad input.
#include "hal/host/udp_cross_link.hpp"
#include "safety_core/kernel/limits.hpp"
#include "verification/two_cpu/comparator_tap.hpp"
#include "verification/two_cpu/cpu.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <thread>

namespace counterpoint::two_cpu
{
namespace
{
using SteadyClock = std::chrono::steady_clock;

struct Options
{
    std::string role{"a"};
    std::uint16_t base_port{0U};
    double seconds{6.0};
    bool expects_loss{false};
};

constexpr std::uint32_t kPollUs = 500U;

/// Slow enough for a machine that has other things to do.
Timing ProcessTiming()
{
    Timing timing{};
    timing.cycle_us = 50'000U;
    timing.tolerance_us = 50'000U;
    timing.timeout_us = 600'000U;
    timing.discrepancy_us = 600'000U;
    timing.refresh_us = 300'000U;
    timing.sct_ms = 1500U;
    timing.stamp_tolerance_us = 4U * kPollUs; // Each process looks at its bus once a poll, the sender at once.
    return timing;
}

class Process
{
  public:
    explicit Process(const Options& options)
        : options_{options}, is_a_{options.role == "a"}, timing_{ProcessTiming()},
          link_{host::UdpPorts{PortOf(0U), PortOf(1U)}}, bus_{host::UdpPorts{PortOf(2U), PortOf(3U)}},
          // Clocks of different start and rate: nothing is shared but the bus.
          cpu_{is_a_ ? PeerRole::kA : PeerRole::kB, timing_,
               is_a_ ? CpuClock{0xFFFFF000U, 1.0001, -1.0} : CpuClock{77U, 0.9999, -1.0}}
    {
    }

    int Run();

  private:
    /// Four ports from the base on: link of A, link of B, bus of A, bus of B.
    [[nodiscard]] std::uint16_t PortOf(const std::uint16_t which) const
    {
        const std::uint16_t swapped = is_a_ ? which : static_cast<std::uint16_t>(which ^ 1U);
        return static_cast<std::uint16_t>(options_.base_port + swapped);
    }
    [[nodiscard]] double Now() const
    {
        return std::chrono::duration<double, std::micro>(SteadyClock::now() - start_).count();
    }
    void Listen();
    void SendOut();
    void Cycle();
    void Sense();
    void Watch();

    Options options_;
    bool is_a_;
    Timing timing_;
    host::UdpCrossLink link_;
    host::UdpSocket bus_;
    Cpu cpu_;
    SteadyClock::time_point start_{SteadyClock::now()};
    hal::LinkFrame frame_{};
    std::uint32_t taken_{0U};
    double heard_us_{0.0};
    double closed_us_{-1.0};
    bool was_open_{false};
};

void Process::Listen()
{
    while (link_.Receive(frame_) == hal::LinkStatus::kDone)
    {
        cpu_.OnLink(frame_, Now());
    }
    CanFrame frame{};
    while (bus_.Receive(&frame, sizeof(frame)) == sizeof(frame))
    {
        cpu_.OnBus(frame, false, Now());
    }
    SendOut();
}

void Process::SendOut()
{
    const std::vector<CanFrame> sent = cpu_.ports.sent;
    cpu_.ports.sent.clear();
    for (const CanFrame& frame : sent)
    {
        static_cast<void>(bus_.Send(&frame, sizeof(frame)));
        cpu_.OnBus(frame, true, Now());
    }
}

void Process::Sense()
{
    const std::uint32_t value = static_cast<std::uint32_t>(Now() / 1'000'000.0);
    for (const std::uint32_t identifier : {0x101U, 0x102U})
    {
        const std::uint32_t bits = (identifier == 0x101U) ? value : ~value;
        CanFrame frame{};
        frame.identifier = identifier;
        frame.kind = FrameKind::kData;
        frame.port = CanPortId::kFirst;
        frame.length_bytes = 2U;
        frame.data[0] = static_cast<std::uint8_t>(bits);
        frame.data[1] = static_cast<std::uint8_t>(bits >> 8U);
        static_cast<void>(bus_.Send(&frame, sizeof(frame)));
        cpu_.OnBus(frame, false, Now());
    }
}

void Process::Cycle()
{
    cpu_.Cycle(Now(), frame_);
    static_cast<void>(link_.Send(frame_));
    SendOut();
}

void Process::Watch()
{
    const double now_us = Now();
    const std::uint32_t taken = cpu_.peer.Link().Counts().taken;
    heard_us_ = (taken != taken_) ? now_us : heard_us_;
    taken_ = taken;
    const bool is_open = cpu_.IsOpen(now_us);
    if (was_open_ && (!is_open) && (closed_us_ < 0.0))
    {
        closed_us_ = now_us;
    }
    was_open_ = was_open_ || is_open;
}

int Process::Run()
{
    cpu_.PowerOn(Now());
    double next_cycle_us = Now();
    double next_pair_us = Now() + 1'000'000.0;
    bool is_operational = false;
    while (Now() < (options_.seconds * 1'000'000.0))
    {
        Listen();
        if (is_a_ && (Now() >= next_pair_us))
        {
            Sense();
            next_pair_us += timing_.refresh_us;
        }
        if (Now() >= next_cycle_us)
        {
            // In contact, as a start command of the network would reach both.
            if ((!is_operational) && cpu_.peer.Link().IsAlive())
            {
                is_operational = true;
                cpu_.OnBus(kStartCommand, false, Now());
            }
            Cycle();
            next_cycle_us += timing_.cycle_us;
        }
        Watch();
        std::this_thread::sleep_for(std::chrono::microseconds{kPollUs});
    }
    const DeviceFault fault = cpu_.kernel.DeviceState().fault;
    const double took_ms = (closed_us_ - heard_us_) / 1000.0;
    const std::uint32_t limit_us = ComputeLimit(cpu_.Config(), LinkTime{timing_.timeout_us}).us;
    std::printf("cpu %s opened=%d taken=%u released=%llu sent=%llu device_fault=%u", options_.role.c_str(),
                was_open_ ? 1 : 0, taken_, static_cast<unsigned long long>(cpu_.application.received),
                static_cast<unsigned long long>(cpu_.application.sent), static_cast<unsigned>(fault));
    bool holds = was_open_ && (fault == DeviceFault::kNone) && (closed_us_ < 0.0);
    if (options_.expects_loss)
    {
        const double limit_ms = limit_us / 1000.0; // The last message was composed before it was heard.
        std::printf(" closed_after=%.0f ms limit=%.0f ms", took_ms, limit_ms);
        holds = was_open_ && (fault == DeviceFault::kCrossLink) && (closed_us_ >= 0.0) && (took_ms <= limit_ms);
    }
    std::printf(": %s\n", holds ? "pass" : "FAIL");
    return holds ? 0 : 1;
}

} // namespace
} // namespace counterpoint::two_cpu

int main(int argc, char** argv)
{
    using namespace counterpoint::two_cpu;
    CLI::App app{"One CPU of two, in real time; the other one is another process of this program"};
    Options options{};
    app.add_option("--role", options.role, "a: leads, plays the sensor; b: follows")
        ->required()
        ->check(CLI::IsMember({"a", "b"}));
    app.add_option("--port", options.base_port, "First of four UDP ports on 127.0.0.1")
        ->required()
        ->check(CLI::Range(1024, 65532));
    app.add_option("--seconds", options.seconds, "How long it lives")->check(CLI::Range(2.0, 3600.0));
    app.add_flag("--expect-loss", options.expects_loss,
                 "The other one goes away meanwhile: this one has to close in time");
    try
    {
        app.parse(argc, argv);
        FreezeComparator(nullptr); // Brings the tap that the room's link option asks for; nothing is frozen here.
        Process process{options};
        return process.Run();
    }
    catch (const CLI::ParseError& error)
    {
        return (app.exit(error) == 0) ? 0 : 2;
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "two_cpu_process: %s\n", error.what());
        return 2;
    }
}
