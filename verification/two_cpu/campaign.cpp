// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/two_cpu/campaign.hpp"

#include "safety_core/kernel/limits.hpp"
#include "verification/two_cpu/comparator_tap.hpp"

#include <algorithm>
#include <random>

namespace counterpoint::two_cpu
{
namespace
{
constexpr double kMillion = 1'000'000.0;

// std::uniform_real_distribution differs between libraries; this does not.
double Between(std::mt19937_64& random, const double low, const double high)
{
    return low + ((high - low) * (static_cast<double>(random() >> 11U) / 9007199254740992.0));
}

// Which outputs must be closed: a CPU that stands still is judged by the other one, whose output is in series.
struct Judged
{
    bool first;
    bool second;
    std::uint32_t limit_us;
    bool any{false}; ///< One of them is enough: the outputs are in series.
};

Judged Break(Device& device, const Breakage breakage, const std::size_t victim)
{
    Cpu& broken = *device.cpus[victim];
    const DeviceConfig& config = broken.Config();
    const Timing timing{};
    const std::uint32_t link_us = ComputeLimit(config, LinkTime{timing.timeout_us}).us;
    const std::uint32_t channel_us =
        ComputeLimit(config, SrdoTimes{timing.sct_ms, timing.srvt_ms}, FaultClass::kChannel).us;
    const std::uint32_t supervisor_us =
        ComputeLimit(config, SrdoTimes{timing.sct_ms, timing.srvt_ms}, FaultClass::kSupervisor).us;
    const Judged survivor{victim == 1U, victim == 0U, link_us};
    const host::WireEnd end = (victim == 0U) ? host::WireEnd::kFirst : host::WireEnd::kSecond;
    switch (breakage)
    {
    case Breakage::kCpuDead:
        device.is_dead[victim] = true;
        return survivor;
    case Breakage::kLinkCut:
        device.wire.Faults(host::WireEnd::kFirst).is_cut = true;
        device.wire.Faults(host::WireEnd::kSecond).is_cut = true;
        return Judged{true, true, link_us};
    case Breakage::kLinkHalfCut:
        device.wire.Faults(end).is_cut = true;
        return Judged{true, true, link_us};
    case Breakage::kClockStops:
        broken.clock.stopped_at_us = device.Now();
        return survivor;
    case Breakage::kClockStands:
        broken.clock.stopped_at_us = device.Now();
        device.cycles_on[victim] = true;
        return survivor;
    case Breakage::kFlippedData:
        broken.tap.flip = 4U;
        return Judged{true, true, channel_us, true};
    case Breakage::kDeaf:
        // The first effect is the first frame that is not heard.
        broken.tap.is_deaf = true;
        return Judged{true, true, channel_us + timing.refresh_us + 2000U, true};
    case Breakage::kFrozenChannel:
        broken.tap.is_frozen = true;
        return Judged{victim == 0U, victim == 1U, supervisor_us};
    case Breakage::kFrozenComparator:
        FreezeComparator(&broken.kernel);
        return Judged{victim == 0U, victim == 1U, supervisor_us};
    }
    return survivor;
}

bool IsSafe(Device& device, const Judged& judged)
{
    const bool first = judged.first && device.cpus[0U]->IsOpen(device.Now());
    const bool second = judged.second && device.cpus[1U]->IsOpen(device.Now());
    return judged.any ? !(first && second) : ((!first) && (!second));
}
} // namespace

const char* NameOf(const Breakage breakage)
{
    constexpr std::array<const char*, kBreakages> kNames{
        "cpu dead",     "link cut",        "link cut one way", "clock and cycle stop", "clock stands",
        "flipped data", "channel is deaf", "channel frozen",   "comparator frozen"};
    return kNames[static_cast<std::size_t>(breakage)];
}

DeviceSetup UsualSetup(const std::uint64_t seed)
{
    DeviceSetup setup{};
    setup.seed = seed;
    setup.wire.loss_ppm = 1000U;
    setup.wire.most_lost_in_a_row = 3U;
    setup.wire.repeat_ppm = 100U;
    setup.wire.flip_ppm = 100U;
    setup.wire.shortest_us = 300U;
    setup.wire.longest_us = 28'000U; // More than a cycle: messages overtake each other.
    return setup;
}

void RunOnce(const Breakage breakage, const std::uint64_t seed, Score& score)
{
    std::mt19937_64 random{seed};
    DeviceSetup setup = UsualSetup(random());
    setup.drift_ppm = {Between(random, -100.0, 100.0), Between(random, -100.0, 100.0)};
    setup.second_starts_us = Between(random, 0.0, 300'000.0);
    Device device{setup};
    device.RunUntil(Between(random, 1'100'000.0, 1'400'000.0));
    ++score.runs;
    if (!device.IsOpen())
    {
        ++score.not_open;
        return;
    }
    const std::size_t victim = static_cast<std::size_t>(random() & 1U);
    const double broken_us = device.Now();
    const Judged judged = Break(device, breakage, victim);
    score.limit_us = judged.limit_us;
    // By the slower one of the clocks that are asked.
    const double rate = std::min(device.cpus[0U]->clock.rate, device.cpus[1U]->clock.rate);
    const double limit_us = static_cast<double>(judged.limit_us) / rate;
    double safe_us = -1.0;
    for (double after_us = 1000.0; after_us < limit_us; after_us += 1000.0)
    {
        device.RunUntil(broken_us + after_us);
        const bool is_safe = IsSafe(device, judged);
        safe_us = is_safe ? ((safe_us < 0.0) ? after_us : safe_us) : -1.0;
    }
    device.RunUntil(broken_us + limit_us);
    bool holds = IsSafe(device, judged);
    for (std::uint32_t later = 1U; later <= 20U; ++later)
    {
        device.RunUntil(broken_us + limit_us + (20'000.0 * later));
        holds = holds && IsSafe(device, judged);
    }
    FreezeComparator(nullptr);
    const double took_us = (safe_us < 0.0) ? limit_us : safe_us;
    score.late += holds ? 0U : 1U;
    score.longest_us = std::max(score.longest_us, took_us);
    score.sum_us += took_us;
}

bool CampaignResult::Holds() const
{
    return std::all_of(scores.begin(), scores.end(),
                       [](const Score& score) { return (score.late == 0U) && (score.not_open == 0U); });
}

CampaignResult RunCampaign(const std::uint32_t runs, const std::uint64_t seed)
{
    CampaignResult result{};
    for (std::uint32_t run = 0U; run < runs; ++run)
    {
        const std::size_t kind = run % kBreakages;
        Score& score = result.scores[kind];
        const std::uint32_t bad = score.late + score.not_open;
        const std::uint64_t run_seed = (seed * 1'000'003U) + run;
        RunOnce(static_cast<Breakage>(kind), run_seed, score);
        if (((score.late + score.not_open) != bad) && (result.first_bad_seed == 0U))
        {
            result.first_bad_seed = run_seed;
        }
    }
    return result;
}

bool SoakResult::Holds() const
{
    return (faults[0U].fault == DeviceFault::kNone) && (faults[1U].fault == DeviceFault::kNone) && (pairs_bad == 0U) &&
           (is_open || (sensor_faults != 0U));
}

SoakResult RunSoak(const double seconds, const std::uint64_t seed, const std::uint32_t sensor_faults_ppm)
{
    Device device{UsualSetup(seed)};
    device.sensor_faults_ppm = sensor_faults_ppm;
    device.RunUntil(seconds * kMillion);
    SoakResult result{};
    for (std::size_t cpu = 0U; cpu < 2U; ++cpu)
    {
        const Cpu& self = *device.cpus[cpu];
        result.faults[cpu] = self.kernel.DeviceState();
        result.counts[cpu] = self.peer.Link().Counts();
        result.released[cpu] = self.application.received;
        result.sent[cpu] = self.application.sent;
        result.consumer_errors[cpu] = self.application.consumer_errors;
        result.producer_errors[cpu] = self.application.producer_errors;
        result.demotions[cpu] = self.kernel.DemotionCount();
    }
    result.pairs_heard = device.pairs_heard;
    result.pairs_bad = device.pairs_bad;
    result.sensor_faults = device.sensor_faults;
    result.seconds = seconds;
    result.is_open = device.IsOpen();
    return result;
}

} // namespace counterpoint::two_cpu
