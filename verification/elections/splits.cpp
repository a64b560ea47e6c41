// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/elections/enumerate.hpp"
#include "verification/elections/series.hpp"

namespace counterpoint::elections
{
namespace
{

constexpr Time kSettled = 9 * kSecond; // A cold start, and the longest loss of a master and election.
constexpr Time kJoinStep = 130 * kMs;
/// Longer than any cyclic message's period.
constexpr std::size_t kJoins = 32U;

/// Bit i of `split`: master i + 1 is on the other part; the first one never is.
void Apart(World& world, const std::vector<MasterPlan>& masters, const std::size_t split, const Time join)
{
    std::vector<std::uint8_t> part(masters.size(), 0U);
    for (std::size_t i = 1U; i < masters.size(); ++i)
    {
        part[i] = ((split >> (i - 1U)) & 1U) != 0U ? 1U : 0U;
    }
    world.Begin(masters, Loss{});
    world.Run(kSettled);
    world.Split(part);
    world.Run(join);
    world.Forget();
    world.Join();
}

void RunOne(World& world, const std::vector<MasterPlan>& masters, const std::size_t split, const Time join,
            const Losses losses, Tally& tally)
{
    const Bound bound = BoundOf(masters, WorldPlan{}.bit_us);
    const Time quiet = 2 * bound.greatest_cycle;
    Apart(world, masters, split, join);
    const std::uint32_t before = world.Frames();
    const Trial whole{masters, Loss{}, join, bound.FromJoin(), quiet, bound.TwoMasters(), 0};
    const std::uint32_t after = Judge(world, whole, tally);
    const auto lose = [&](const Loss& loss)
    {
        Apart(world, masters, split, join);
        world.SetLoss(loss);
        const Time limit = bound.FromJoin() + bound.Negotiation();
        static_cast<void>(
            Judge(world, Trial{masters, loss, join, limit, quiet, bound.TwoMasters(), bound.Negotiation()}, tally));
    };
    ForEachLoss(losses, before, after, masters.size(), lose);
}

} // namespace

Tally Splits(const Preset preset, const std::size_t count, const Losses losses, const Adapt& adapt)
{
    const std::size_t ways = PowerOf(2U, count - 1U) - 1U;
    const std::size_t all = PowerOf(kLevels, count) * ways * kJoins;
    const auto run_part = [&](const std::size_t part, const std::size_t parts)
    {
        Tally tally{};
        World world(PlanOf(preset));
        for (std::size_t number = part; number < all; number += parts)
        {
            const std::size_t of_join = number / PowerOf(kLevels, count);
            const Time join = (2 * kSettled) + (static_cast<Time>(of_join % kJoins) * kJoinStep);
            std::vector<MasterPlan> masters = MastersOf(LevelsOf(number, count), std::vector<Time>(count, 0));
            if (adapt)
            {
                adapt(masters, number);
            }
            RunOne(world, masters, 1U + (of_join / kJoins), join, losses, tally);
        }
        return tally;
    };
    return InParallel(run_part);
}

} // namespace counterpoint::elections
