// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/two_cpu/device.hpp"

#include <algorithm>
#include <cmath>

namespace counterpoint::two_cpu
{
namespace
{
constexpr double kFrameUs = 250.0;
constexpr double kMillion = 1'000'000.0;

CanFrame FrameOf(const std::uint32_t identifier, const std::uint32_t value)
{
    CanFrame frame{};
    frame.identifier = identifier;
    frame.kind = FrameKind::kData;
    frame.port = CanPortId::kFirst;
    frame.length_bytes = 2U;
    frame.data[0] = static_cast<std::uint8_t>(value);
    frame.data[1] = static_cast<std::uint8_t>(value >> 8U);
    return frame;
}

// std::uniform_int_distribution differs between libraries; this does not.
std::uint32_t Below(std::mt19937_64& random, const std::uint32_t end)
{
    return static_cast<std::uint32_t>(((random() >> 32U) * end) >> 32U);
}

std::uint32_t ValueOf(const CanFrame& frame)
{
    return static_cast<std::uint32_t>(frame.data[0]) | (static_cast<std::uint32_t>(frame.data[1]) << 8U);
}
} // namespace

Device::Device(const DeviceSetup& setup)
    : wire{setup.seed ^ 0x5EEDU}, setup_{setup}, random_{setup.seed}, next_pair_us_{0.0}
{
    const std::array<PeerRole, 2U> roles{PeerRole::kA, PeerRole::kB};
    for (std::size_t cpu = 0U; cpu < 2U; ++cpu)
    {
        CpuClock clock{};
        clock.start_us = static_cast<std::uint32_t>(random_());
        clock.rate = 1.0 + (setup.drift_ppm[cpu] / kMillion);
        cpus[cpu] = std::make_unique<Cpu>(roles[cpu], setup.timing, clock);
        period_us_[cpu] = static_cast<double>(setup.timing.cycle_us) / clock.rate;
        first_cycle_us_[cpu] =
            static_cast<double>(Below(random_, setup.timing.cycle_us)) + ((cpu == 1U) ? setup.second_starts_us : 0.0);
        next_cycle_us_[cpu] = first_cycle_us_[cpu];
    }
    wire.Faults(host::WireEnd::kFirst) = setup.wire;
    wire.Faults(host::WireEnd::kSecond) = setup.wire;
    next_pair_us_ = static_cast<double>(Below(random_, setup.timing.refresh_us));
}

void Device::Submit(const CanFrame& frame, const int sender, const double after_us)
{
    const double ends_us = now_us_ + after_us;
    const auto behind = std::upper_bound(bus_.begin(), bus_.end(), ends_us,
                                         [](double at, const BusFrame& other) { return at < other.ends_us; });
    bus_.insert(behind, BusFrame{ends_us, frame, sender});
}

void Device::RunCpu(const std::size_t cpu)
{
    const auto end = (cpu == 0U) ? host::WireEnd::kFirst : host::WireEnd::kSecond;
    Cpu& self = *cpus[cpu];
    if (cycle_[cpu] == 0U)
    {
        self.PowerOn(now_us_);
    }
    ++cycle_[cpu];
    next_cycle_us_[cpu] = first_cycle_us_[cpu] + (static_cast<double>(cycle_[cpu]) * period_us_[cpu]);
    const bool stands = (self.clock.stopped_at_us >= 0.0) && (!cycles_on[cpu]);
    if (is_dead[cpu] || stands)
    {
        return;
    }
    ++cycles;
    if ((!is_operational_[cpu]) && (now_us_ >= setup_.operational_us))
    {
        is_operational_[cpu] = true;
        self.OnBus(kStartCommand, false, now_us_);
    }
    wire.SetNow(static_cast<host::LinkInstant>(now_us_));
    while (wire.End(end).Receive(link_frame_) == hal::LinkStatus::kDone)
    {
        self.OnLink(link_frame_, static_cast<double>(wire.ArrivedAt(end)));
    }
    self.Cycle(now_us_, link_frame_);
    static_cast<void>(wire.End(end).Send(link_frame_));
    for (const CanFrame& frame : self.ports.sent)
    {
        Submit(frame, static_cast<int>(cpu), kFrameUs);
    }
    self.ports.sent.clear();
}

void Device::SendPair()
{
    const std::uint32_t value = Below(random_, 0x10000U);
    const bool is_faulty = (sensor_faults_ppm != 0U) && (Below(random_, 1'000'000U) < sensor_faults_ppm);
    const std::uint32_t fault = is_faulty ? (1U + Below(random_, 5U)) : 0U;
    sensor_faults += is_faulty ? 1U : 0U;
    if (fault == 5U)
    {
        next_pair_us_ += 500'000.0; // Longer than SCT.
        return;
    }
    if (fault != 1U)
    {
        Submit(FrameOf(0x101U, value), 2, kFrameUs);
    }
    if (fault == 2U)
    {
        Submit(FrameOf(0x101U, value), 2, 2.0 * kFrameUs);
    }
    if (fault != 3U)
    {
        Submit(FrameOf(0x102U, (fault == 4U) ? value : ~value), 2, 3.0 * kFrameUs);
    }
}

void Device::RunSensor()
{
    const double jitter_us = static_cast<double>(Below(random_, 2000U));
    next_pair_us_ = now_us_ + static_cast<double>(setup_.timing.refresh_us) + jitter_us - 1000.0;
    if (!sensor_is_silent)
    {
        SendPair();
    }
}

void Device::Listen(const CanFrame& frame)
{
    if (frame.identifier == 0x103U)
    {
        heard_normal_ = ValueOf(frame);
    }
    if (frame.identifier == 0x104U)
    {
        const bool is_inverse = (heard_normal_ ^ ValueOf(frame)) == 0xFFFFU;
        is_inverse ? ++pairs_heard : ++pairs_bad;
    }
}

void Device::RunBus()
{
    const BusFrame arrived = bus_.front();
    bus_.pop_front();
    Listen(arrived.frame);
    for (std::size_t cpu = 0U; cpu < 2U; ++cpu)
    {
        if (is_dead[cpu] || (cycle_[cpu] == 0U))
        {
            continue;
        }
        Cpu& self = *cpus[cpu];
        self.OnBus(arrived.frame, arrived.sender == static_cast<int>(cpu), arrived.ends_us);
        for (const CanFrame& frame : self.ports.sent)
        {
            Submit(frame, static_cast<int>(cpu), kFrameUs);
        }
        self.ports.sent.clear();
    }
}

void Device::RunUntil(const double until_us)
{
    while (true)
    {
        const double bus_us = bus_.empty() ? HUGE_VAL : bus_.front().ends_us;
        const double cycle_us = std::min(next_cycle_us_[0U], next_cycle_us_[1U]);
        const double next_us = std::min({bus_us, cycle_us, next_pair_us_});
        if (next_us > until_us)
        {
            now_us_ = until_us;
            return;
        }
        now_us_ = next_us;
        if (bus_us <= next_us)
        {
            RunBus();
        }
        else if (next_pair_us_ <= next_us)
        {
            RunSensor();
        }
        else
        {
            RunCpu((next_cycle_us_[0U] <= next_us) ? 0U : 1U);
        }
    }
}

} // namespace counterpoint::two_cpu
