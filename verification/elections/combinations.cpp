// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/elections/enumerate.hpp"
#include "verification/elections/series.hpp"

#include <algorithm>

namespace counterpoint::elections
{
namespace
{

/// One set of priorities and offsets: undisturbed, then with each frame lost that was on the bus until rest.
void RunOne(World& world, const std::vector<MasterPlan>& masters, const Losses losses, Tally& tally)
{
    Time last = 0;
    for (const MasterPlan& plan : masters)
    {
        last = std::max(last, plan.power_on);
    }
    const Bound bound = BoundOf(masters, WorldPlan{}.bit_us);
    const Time quiet = 2 * bound.greatest_cycle;
    world.Begin(masters, Loss{});
    const Trial whole{masters, Loss{}, last, bound.FromPowerOn(), quiet, bound.TwoMasters(), 0};
    const std::uint32_t frames = Judge(world, whole, tally);
    const auto lose = [&](const Loss& loss)
    {
        world.Begin(masters, loss);
        const Time limit = bound.FromPowerOn() + bound.Negotiation();
        static_cast<void>(
            Judge(world, Trial{masters, loss, last, limit, quiet, bound.TwoMasters(), bound.Negotiation()}, tally));
    };
    ForEachLoss(losses, 0U, frames, masters.size(), lose);
}

} // namespace

std::vector<Time> OffsetsOfTheText()
{
    std::vector<Time> offsets{0};
    for (const Time ms : {1, 10, 100, 500, 1500})
    {
        offsets.push_back(ms * kMs);
        offsets.push_back(-ms * kMs);
    }
    return offsets;
}

std::vector<Time> OffsetsInSlots()
{
    std::vector<Time> offsets{};
    for (Time ms = -8000; ms <= 8000; ms += 10)
    {
        offsets.push_back(ms * kMs);
    }
    return offsets;
}

Tally Combinations(const Preset preset, const std::size_t count, const std::vector<Time>& offsets, const Losses losses,
                   const Adapt& adapt)
{
    const Time base = -*std::min_element(offsets.begin(), offsets.end());
    const std::size_t all = PowerOf(kLevels, count) * PowerOf(offsets.size(), count - 1U);
    const auto run_part = [&](const std::size_t part, const std::size_t parts)
    {
        Tally tally{};
        World world(PlanOf(preset));
        for (std::size_t number = part; number < all; number += parts)
        {
            const std::size_t of_offsets = number / PowerOf(kLevels, count);
            std::vector<Time> power_on(count, base);
            for (std::size_t i = 1U; i < count; ++i)
            {
                power_on[i] += offsets[Digit(of_offsets, offsets.size(), i - 1U)];
            }
            std::vector<MasterPlan> masters = MastersOf(LevelsOf(number, count), power_on);
            if (adapt)
            {
                adapt(masters, number);
            }
            RunOne(world, masters, losses, tally);
        }
        return tally;
    };
    return InParallel(run_part);
}

} // namespace counterpoint::elections
