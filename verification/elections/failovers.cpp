// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/elections/enumerate.hpp"
#include "verification/elections/series.hpp"

#include <algorithm>

namespace counterpoint::elections
{
namespace
{

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

void RunOne(World& world, const std::vector<MasterPlan>& masters, const Time kill, Tally& tally)
{
    const WorldPlan plan{};
    world.Begin(masters, Loss{});
    world.Run(kill);
    const std::size_t failing = world.Active();
    world.Forget();
    world.Kill(failing);
    const Time sign = world.LastSign();
    std::vector<MasterPlan> left = masters;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(failing));
    const Bound bound = BoundOf(left, plan.bit_us);
    const Time computed = bound.Failover(2500 * kMs);
    const Trial trial{left, Loss{}, sign, computed + bound.slack, bound.greatest_cycle, 0, 0};
    static_cast<void>(Judge(world, trial, tally));
    const Time late = world.LastMaster() - (sign + computed);
    const bool is_in_time = (late >= 0) && (late <= plan.cycle);
    ++tally.late_us[(late / kHistogramStep) * kHistogramStep];
    tally.failures += is_in_time ? 0U : 1U;
    if (!is_in_time && tally.first_failure.empty())
    {
        tally.first_failure = "failover " + std::to_string(late) + " us after the computed instant, failed at " +
                              std::to_string(kill) + " us";
    }
}

} // namespace

Tally Failovers(const Preset preset)
{
    const auto run_part = [&](const std::size_t part, const std::size_t parts)
    {
        Tally tally{};
        World world(PlanOf(preset));
        for (std::size_t count = 2U; count <= 4U; ++count)
        {
            for (std::size_t number = part; number < kInstants; number += parts)
            {
                const std::vector<MasterPlan> masters = MastersOf(LevelsOf(number, count), std::vector<Time>(count, 0));
                const Time kill = kSettled + (static_cast<Time>(number) * (kMs + 1));
                RunOne(world, WithPhases(masters, number), kill, tally);
            }
        }
        return tally;
    };
    return InParallel(run_part);
}

} // namespace counterpoint::elections
