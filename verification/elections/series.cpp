// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/elections/series.hpp"

#include "simulator/faults/random.hpp"

#include <algorithm>
#include <array>

namespace counterpoint::elections
{
namespace
{

std::string Describe(const World& world, const Trial& trial)
{
    std::string text = "node/level/power-on ms:";
    for (const MasterPlan& plan : trial.masters)
    {
        text += " " + std::to_string(plan.node.value) + "/" + std::to_string(plan.times.priority) + "/" +
                std::to_string(plan.power_on / kMs);
    }
    if (trial.loss.frame != Loss::kNoFrame)
    {
        const bool is_all = trial.loss.receiver == Loss::kEverybody;
        text += "; frame " + std::to_string(trial.loss.frame) + " lost for " +
                (is_all ? std::string("all") : ("master " + std::to_string(trial.loss.receiver)));
    }
    const Seen& seen = world.Found();
    text += "; active " + std::to_string(world.ActiveCount()) + (world.IsAgreed() ? ", agreed" : ", not agreed") +
            (world.IsBest() ? "" : ", not the best level") + "; rest after " +
            std::to_string((seen.last_change - trial.from) / kMs) + " ms, limit " + std::to_string(trial.limit / kMs) +
            " ms; two masters for " + std::to_string(seen.longest_two / kMs) + " ms, limit " +
            std::to_string(trial.limit_two / kMs) + " ms";
    return text;
}

} // namespace

void Lateness::Add(const Time late)
{
    least = (runs == 0U) ? late : std::min(least, late);
    greatest = (runs == 0U) ? late : std::max(greatest, late);
    ++runs;
}

void Lateness::Add(const Lateness& other)
{
    least = (runs == 0U) ? other.least : std::min(least, other.least);
    greatest = (runs == 0U) ? other.greatest : std::max(greatest, other.greatest);
    runs += other.runs;
}

void Tally::Add(const Tally& other)
{
    runs += other.runs;
    with_loss += other.with_loss;
    frames += other.frames;
    collisions += other.collisions;
    bus_offs += other.bus_offs;
    configuration_errors += other.configuration_errors;
    failures += other.failures;
    longest = std::max(longest, other.longest);
    longest_with_loss = std::max(longest_with_loss, other.longest_with_loss);
    least_left = std::min(least_left, other.least_left);
    longest_two = std::max(longest_two, other.longest_two);
    for (const auto& [late, count] : other.late_us)
    {
        late_us[late] += count;
    }
    for (const auto& [computed, lateness] : other.failovers)
    {
        failovers[computed].Add(lateness);
    }
    first_failure = first_failure.empty() ? other.first_failure : first_failure;
}

std::uint32_t Judge(World& world, const Trial& trial, Tally& tally)
{
    world.Run(trial.from + trial.limit - trial.repair);
    world.SetLoss(Loss{}); // A frame lost later would be the beginning of something else.
    world.Run(trial.from + trial.limit);
    const bool is_at_rest = world.IsAgreed();
    const std::uint32_t frames = world.Frames();
    world.Run(trial.from + trial.limit + trial.quiet);
    const Seen& seen = world.Found();
    const Time rest = std::max<Time>(seen.last_change - trial.from, 0);
    const bool is_good = is_at_rest && world.IsAgreed() && world.IsBest() && (rest <= trial.limit) &&
                         (seen.longest_two <= trial.limit_two);
    const bool has_loss = trial.loss.frame != Loss::kNoFrame;
    Tally run{};
    run.runs = 1U;
    run.with_loss = has_loss ? 1U : 0U;
    run.frames = world.Frames();
    run.collisions = world.Collisions();
    run.bus_offs = seen.bus_offs;
    run.configuration_errors = seen.configuration_errors;
    run.failures = is_good ? 0U : 1U;
    (has_loss ? run.longest_with_loss : run.longest) = rest;
    run.least_left = trial.limit - rest;
    run.longest_two = seen.longest_two;
    run.first_failure = is_good ? std::string{} : Describe(world, trial);
    tally.Add(run);
    return frames;
}

void GiveClocks(std::vector<MasterPlan>& masters, const std::uint64_t seed)
{
    constexpr std::uint32_t kGreatestPpm = 200U;
    constexpr std::uint32_t kTurnsOver = 20U * 1'000'000U;
    simulator::Random random(seed);
    for (MasterPlan& plan : masters)
    {
        plan.clock_ppm = static_cast<Time>(random.Below((2U * kGreatestPpm) + 1U)) - kGreatestPpm;
        plan.clock_begin = 0U - random.Below(kTurnsOver);
    }
}

void GiveFarNodes(std::vector<MasterPlan>& masters, const std::uint64_t number)
{
    static_cast<void>(number);
    constexpr std::array<std::uint8_t, 4> kNodes{127U, 1U, 126U, 2U};
    for (std::size_t i = 0U; i < masters.size(); ++i)
    {
        masters[i].node = cia302::NodeId{kNodes.at(i)};
        masters[i].times.detection_cycle = cia302::DefaultTimes(masters[i].node).detection_cycle;
    }
}

WorldPlan PlanOf(const Preset preset)
{
    WorldPlan plan{};
    plan.options = (preset == Preset::kDefault) ? cia302::DefaultFlyingMaster() : cia302::So1114FlyingMaster();
    plan.options.watch = cia302::MasterWatch::kInstalled;
    plan.options.watch_ms = 2500U;
    return plan;
}

std::vector<MasterPlan> MastersOf(const std::vector<std::uint8_t>& levels, const std::vector<Time>& power_on)
{
    std::vector<MasterPlan> masters{};
    for (std::size_t i = 0U; i < levels.size(); ++i)
    {
        const cia302::NodeId node{static_cast<std::uint8_t>(i + 1U)};
        MasterPlan plan{node, cia302::DefaultTimes(node), power_on[i], 0};
        plan.times.priority = levels[i];
        masters.push_back(plan);
    }
    return masters;
}

} // namespace counterpoint::elections
