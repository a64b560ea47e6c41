// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/random.hpp"
#include "verification/elections/enumerate.hpp"
#include "verification/elections/series.hpp"

#include <algorithm>
#include <array>

namespace counterpoint::elections
{
namespace
{

using simulator::Random;

constexpr Time kSettled = 20 * kSecond;
constexpr std::size_t kInstants = 1000U; ///< One a ms of the heartbeat's period, at changing parts of a ms.
constexpr Time kHistogramStep = 100;

std::vector<MasterPlan> WithPhases(std::vector<MasterPlan> masters, const std::size_t number)
{
    for (std::size_t i = 0U; i < masters.size(); ++i)
    {
        masters[i].phase = static_cast<Time>((number * (i + 1U) * 77U) % 1000U);
    }
    return masters;
}

/// Rounded down also below 0: what is early shall not look punctual.
Time BinOf(const Time late)
{
    const Time rest = late % kHistogramStep;
    return late - rest - ((rest < 0) ? kHistogramStep : 0);
}

/// The active one of `masters` dies now, at rest: when is the next one active?
void Fail(World& world, const std::vector<MasterPlan>& masters, const WorldPlan& plan, Tally& tally)
{
    const std::size_t failing = world.Active();
    world.Forget();
    world.Kill(failing);
    const Time sign = world.LastSign();
    std::vector<MasterPlan> left = masters;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(failing));
    const Bound bound = BoundOf(left, plan.bit_us);
    const Time computed = bound.Failover(plan.options.watch_ms * kMs);
    const Trial trial{left, Loss{}, sign, computed + bound.slack, bound.greatest_cycle, 0, 0};
    static_cast<void>(Judge(world, trial, tally));
    const Time late = world.LastMaster() - (sign + computed);
    const bool is_in_time = (late >= 0) && (late <= plan.cycle);
    ++tally.late_us[BinOf(late)];
    tally.failovers[computed].Add(late);
    tally.failures += is_in_time ? 0U : 1U;
    if (!is_in_time && tally.first_failure.empty())
    {
        tally.first_failure = "failover " + std::to_string(late) + " us after the computed instant, failed at " +
                              std::to_string(sign) + " us";
    }
}

/// One failover with drawn 1F90h, heartbeat, bit rate, reception and other traffic.
class DrawnFailover
{
  public:
    DrawnFailover(const Preset preset, const std::size_t number)
        : random_((std::uint64_t{kSeed} << 32U) | number), plan_(DrawPlan(preset)), masters_(DrawMasters(preset)),
          world_(plan_)
    {
    }

    void Run(Tally& tally)
    {
        const Bound bound = BoundOf(masters_, plan_.bit_us);
        world_.Begin(masters_, Loss{});
        world_.Run(kWindow + bound.FromPowerOn() + random_.Below(static_cast<std::uint32_t>(2 * kSecond)));
        if (world_.IsAgreed())
        {
            Fail(world_, masters_, plan_, tally);
        }
        else
        {
            ++tally.failures;
            tally.first_failure = "no master to fail";
        }
    }

  private:
    static constexpr std::uint32_t kSeed = 26U;
    static constexpr Time kWindow = 20 * kMs; ///< In which all are switched on.

    WorldPlan DrawPlan(const Preset preset)
    {
        constexpr std::array<Time, 4> kBits{8, 4, 2, 1};
        WorldPlan plan = PlanOf(preset);
        plan.bit_us = kBits.at(random_.Below(4U));
        plan.polls = random_.Below(2U) == 0U;
        plan.traffic_gap = (random_.Below(2U) == 0U) ? 0 : ((2 * kMs) + random_.Below(20'000U));
        plan.traffic_seed = random_.Next();
        const std::uint32_t heartbeat_ms = 50U + random_.Below(1500U);
        plan.heartbeat = heartbeat_ms * kMs;
        plan.options.watch_ms = static_cast<std::uint16_t>((2U * heartbeat_ms) + random_.Below(1000U));
        return plan;
    }

    /// In preset so1114 without cyclic message: a standby that asks a master which dies meanwhile does not wait for its
    /// heartbeat to be missed.
    std::vector<MasterPlan> DrawMasters(const Preset preset)
    {
        cia302::FlyingMasterTimes times{};
        times.timeout = Draw(20U, 300U);
        times.delay = (random_.Below(4U) == 0U) ? std::uint16_t{0U} : Draw(1U, 1000U);
        times.device_slot = Draw(10U, 30U);
        times.priority_slot = static_cast<std::uint16_t>((cia302::kLastNode * times.device_slot) + Draw(1U, 500U));
        std::array<bool, cia302::kNodeRoom> is_taken{};
        const std::size_t count = (random_.Below(8U) == 0U) ? cia302::kLastNode : Draw(2U, 10U);
        std::vector<MasterPlan> masters{};
        while (masters.size() < count)
        {
            const auto node = static_cast<std::uint8_t>(Draw(1U, cia302::kLastNode));
            times.priority = Draw(0U, 2U);
            times.detection_cycle = (preset == Preset::kDefault) ? Draw(500U, 6500U) : std::uint16_t{0U};
            const Time power_on = random_.Below(static_cast<std::uint32_t>(kWindow));
            const Time phase = random_.Below(static_cast<std::uint32_t>(kMs));
            if (!is_taken.at(node))
            {
                is_taken.at(node) = true;
                masters.push_back(MasterPlan{cia302::NodeId{node}, times, power_on, phase});
            }
        }
        return masters;
    }

    std::uint16_t Draw(const std::uint32_t least, const std::uint32_t greatest)
    {
        return static_cast<std::uint16_t>(least + random_.Below(greatest - least + 1U));
    }

    Random random_;
    WorldPlan plan_;
    std::vector<MasterPlan> masters_;
    World world_;
};

} // namespace

Tally Failovers(const Preset preset)
{
    const auto run_part = [&](const std::size_t part, const std::size_t parts)
    {
        Tally tally{};
        const WorldPlan plan = PlanOf(preset);
        World world(plan);
        for (std::size_t count = 2U; count <= 4U; ++count)
        {
            for (std::size_t number = part; number < kInstants; number += parts)
            {
                const std::vector<MasterPlan> masters =
                    WithPhases(MastersOf(LevelsOf(number, count), std::vector<Time>(count, 0)), number);
                world.Begin(masters, Loss{});
                world.Run(kSettled + (static_cast<Time>(number) * (kMs + 1)));
                Fail(world, masters, plan, tally);
            }
        }
        return tally;
    };
    return InParallel(run_part);
}

Tally FailoversDrawn(const Preset preset, const std::size_t count)
{
    const auto run_part = [&](const std::size_t part, const std::size_t parts)
    {
        Tally tally{};
        for (std::size_t number = part; number < count; number += parts)
        {
            DrawnFailover(preset, number).Run(tally);
        }
        return tally;
    };
    return InParallel(run_part);
}

} // namespace counterpoint::elections
