// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/random.hpp"
#include "verification/elections/enumerate.hpp"
#include "verification/elections/series.hpp"

#include <algorithm>
#include <numeric>

namespace counterpoint::elections
{
namespace
{

using simulator::Random;

/// What happens in one seeded run; all of it follows from seed and number.
class SeededRun
{
  public:
    SeededRun(const Preset preset, const std::uint32_t seed, const std::uint32_t number, const Crowd crowd,
              const std::size_t greatest, const Adapt& adapt)
        : random_((static_cast<std::uint64_t>(seed) << 32U) | number), plan_(DrawPlan(preset)), world_(plan_),
          masters_(DrawMasters(crowd, greatest)), bound_(BoundOf(masters_, plan_.bit_us))
    {
        if (adapt)
        {
            adapt(masters_, (static_cast<std::uint64_t>(number) << 32U) | seed);
        }
    }

    void Run(Tally& tally)
    {
        Time last = 0;
        for (const MasterPlan& plan : masters_)
        {
            last = std::max(last, plan.power_on);
        }
        world_.Begin(masters_, Loss{});
        Settle(last, bound_.FromPowerOn(), tally);
        if (random_.Below(2U) == 0U)
        {
            Fail(tally);
        }
        if (random_.Below(2U) == 0U)
        {
            SplitAndJoin(tally);
        }
    }

  private:
    WorldPlan DrawPlan(const Preset preset)
    {
        constexpr Time kBits[4] = {8, 4, 2, 1};
        WorldPlan plan = PlanOf(preset);
        plan.bit_us = kBits[random_.Below(4U)];
        plan.polls = random_.Below(2U) == 0U;
        // Half of the time at most, at the lowest bit rate.
        plan.traffic_gap = (random_.Below(2U) == 0U) ? 0 : ((2 * kMs) + random_.Below(20'000U));
        plan.traffic_seed = random_.Next();
        return plan;
    }

    std::vector<MasterPlan> DrawMasters(const Crowd crowd, const std::size_t greatest)
    {
        std::vector<std::uint8_t> nodes(cia302::kLastNode);
        std::iota(nodes.begin(), nodes.end(), std::uint8_t{1U});
        const bool is_full = (crowd == Crowd::kExactly) || (random_.Below(4U) == 0U);
        const std::size_t count = is_full ? greatest : (2U + random_.Below(static_cast<std::uint32_t>(greatest - 1U)));
        constexpr std::uint32_t kWindows[4] = {1U, 1000U, 20'000U, 6'000'000U};
        const std::uint32_t window = kWindows[random_.Below(4U)];
        const bool is_in_phase = random_.Below(2U) == 0U;
        std::vector<MasterPlan> masters{};
        for (std::size_t i = 0U; i < count; ++i)
        {
            const std::size_t other = i + random_.Below(static_cast<std::uint32_t>(nodes.size() - i));
            std::swap(nodes[i], nodes[other]);
            const cia302::NodeId node{nodes[i]};
            MasterPlan plan{node, cia302::DefaultTimes(node), random_.Below(window), 0};
            plan.times.priority = static_cast<std::uint16_t>(random_.Below(3U));
            plan.phase = is_in_phase ? 0 : random_.Below(static_cast<std::uint32_t>(kMs));
            masters.push_back(plan);
        }
        return masters;
    }

    /// Half of the times a frame is lost before rest, for all or for one.
    void Settle(const Time from, const Time limit, Tally& tally)
    {
        Loss loss{};
        if (random_.Below(2U) == 0U)
        {
            loss.frame = world_.Frames() + random_.Below(40U);
            loss.receiver = (random_.Below(2U) == 0U) ? Loss::kEverybody
                                                      : random_.Below(static_cast<std::uint32_t>(masters_.size()));
        }
        world_.SetLoss(loss);
        const bool has_loss = loss.frame != Loss::kNoFrame;
        const Time repair = has_loss ? bound_.Negotiation() : 0;
        const Trial trial{masters_, loss, from, limit + repair, bound_.greatest_cycle, bound_.TwoMasters(), repair};
        static_cast<void>(Judge(world_, trial, tally));
        world_.Forget();
    }

    void Fail(Tally& tally)
    {
        const std::size_t failing = world_.Active();
        if ((failing == world_.Count()) || (masters_.size() < 2U))
        {
            return;
        }
        world_.Run(world_.Now() + random_.Below(static_cast<std::uint32_t>(kSecond)));
        world_.Kill(failing);
        // Standbys lose it at nearly the same time; one that began alone is found by the better ones.
        const Time watch = plan_.options.watch_ms * kMs;
        Settle(world_.Now(), watch + bound_.greatest_slot + bound_.FromPowerOn(), tally);
        world_.Restart(failing, world_.Now() + random_.Below(static_cast<std::uint32_t>(kSecond)) + 1);
        Settle(world_.Now() + kSecond, bound_.FromPowerOn(), tally);
    }

    void SplitAndJoin(Tally& tally)
    {
        std::vector<std::uint8_t> part(masters_.size(), 0U);
        for (std::uint8_t& of_master : part)
        {
            of_master = static_cast<std::uint8_t>(random_.Below(2U));
        }
        world_.Split(part);
        world_.Run(world_.Now() + (2 * kSecond) + random_.Below(static_cast<std::uint32_t>(16 * kSecond)));
        world_.Join();
        world_.Forget();
        // Joined in the middle of a negotiation, one loss of a heartbeat and one election may be under way.
        const Time watch = plan_.options.watch_ms * kMs;
        Settle(world_.Now(), watch + bound_.FromJoin() + bound_.Negotiation(), tally);
    }

    Random random_;
    WorldPlan plan_;
    World world_;
    std::vector<MasterPlan> masters_;
    Bound bound_;
};

} // namespace

Tally Seeded(const Preset preset, const std::uint32_t seed, const std::uint32_t first, const std::uint32_t count,
             const Crowd crowd, const std::size_t greatest, const Adapt& adapt)
{
    const auto run_part = [&](const std::size_t part, const std::size_t parts)
    {
        Tally tally{};
        for (std::size_t i = part; i < count; i += parts)
        {
            const std::uint32_t number = first + static_cast<std::uint32_t>(i);
            Tally run{};
            SeededRun(preset, seed, number, crowd, greatest, adapt).Run(run);
            if (run.failures > 0U)
            {
                run.first_failure = "run " + std::to_string(number) + ": " + run.first_failure;
            }
            tally.Add(run);
        }
        return tally;
    };
    return InParallel(run_part);
}

} // namespace counterpoint::elections
