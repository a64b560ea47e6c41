// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/injection/space.hpp"

#include "verification/injection/thumb.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <stdexcept>
#include <tuple>

namespace counterpoint::injection
{
namespace
{

constexpr std::size_t kTogether = 256U; // So many neighbours are run by one shard.

// Of `often` executions `each`, the first and the last among them.
bool IsChosen(const std::uint32_t number, const std::uint32_t often, const std::uint32_t each)
{
    if ((each == 0U) || (often <= each))
    {
        return true;
    }
    return (number == (often - 1U)) || (((number * (each - 1U)) % (often - 1U)) < (each - 1U));
}

bool IsBefore(const Experiment& first, const Experiment& second)
{
    const auto order = [](const Experiment& one)
    { return std::tie(one.step, one.fault.count, one.fault.kind, one.fault.address, one.fault.number); };
    return order(first) < order(second);
}

} // namespace

std::uint32_t Space::FaultedSteps() const
{
    return static_cast<std::uint32_t>(traces_.size()) - kTailSteps;
}

Experiment Space::SkippedCall(const std::uint32_t step, const std::string& function) const
{
    const std::uint32_t entry = program_.Symbol(function) & ~1U;
    const std::vector<std::uint32_t>& trace = traces_[step];
    for (std::uint32_t count = 1U; count < trace.size(); ++count)
    {
        if ((trace[count] == entry) && (!program_.IsFaulted(trace[count - 1U])))
        {
            return {step, {FaultKind::kSkip, count - 1U, trace[count - 1U], 0U}};
        }
    }
    throw std::runtime_error{"no call of " + function + " in step " + std::to_string(step)};
}

void Space::DrawCode(const Plan& plan, std::vector<Experiment>& to) const
{
    for (std::uint32_t step = 0U; step < FaultedSteps(); ++step)
    {
        const std::vector<std::uint32_t>& trace = traces_[step];
        std::map<std::uint32_t, std::uint32_t> often;
        std::map<std::uint32_t, std::uint32_t> seen;
        for (const std::uint32_t address : trace)
        {
            ++often[address];
        }
        for (std::uint32_t count = 0U; count < trace.size(); ++count)
        {
            const std::uint32_t address = trace[count];
            const std::uint32_t before = seen[address]++;
            if ((!program_.IsFaulted(address)) || (!IsChosen(before, often[address], plan.each)))
            {
                continue;
            }
            if (plan.skips)
            {
                to.push_back({step, {FaultKind::kSkip, count, address, 0U}});
            }
            if (plan.inversions && IsDecision(program_, address) && ((count + 1U) < trace.size()))
            {
                const bool is_taken = trace[count + 1U] != (address + program_.Length(address));
                to.push_back({step, {FaultKind::kInvert, count, address, is_taken ? 1U : 0U}});
            }
        }
    }
    if ((plan.sample != 0U) && (plan.sample < to.size()))
    {
        std::mt19937 random{plan.seed};
        for (std::size_t i = 0U; i < plan.sample; ++i)
        {
            std::swap(to[i], to[i + (random() % (to.size() - i))]);
        }
        to.resize(plan.sample);
    }
}

void Space::DrawRegisters(const Plan& plan, std::vector<Experiment>& to) const
{
    std::mt19937 random{plan.seed + 1U};
    std::uint32_t left = plan.registers;
    while (left != 0U)
    {
        const auto step = static_cast<std::uint32_t>(random() % FaultedSteps());
        const std::vector<std::uint32_t>& trace = traces_[step];
        const auto count = static_cast<std::uint32_t>(random() % trace.size());
        const std::uint32_t reads = program_.Reads(trace[count]);
        const auto which = static_cast<std::uint32_t>(random() % 15U);
        const auto bit = static_cast<std::uint32_t>(random() % 32U);
        if (program_.IsFaulted(trace[count]) && (((reads >> which) & 1U) != 0U))
        {
            to.push_back({step, {FaultKind::kRegister, count, trace[count], (32U * which) + bit}});
            --left;
        }
    }
}

void Space::DrawMemory(const Plan& plan, std::vector<Experiment>& to) const
{
    std::vector<Experiment> all;
    for (std::uint32_t step = 0U; step < FaultedSteps(); ++step)
    {
        for (const Range& range : program_.Memory())
        {
            for (std::uint32_t bit = 0U; bit < (8U * (range.end - range.begin)); ++bit)
            {
                all.push_back({step, {FaultKind::kMemory, 0U, range.begin + (bit / 8U), bit % 8U}});
            }
        }
    }
    std::mt19937 random{plan.seed + 2U};
    for (std::size_t i = 0U; (i < plan.memory) && (i < all.size()); ++i)
    {
        std::swap(all[i], all[i + (random() % (all.size() - i))]);
        to.push_back(all[i]);
    }
}

// A bit of an instruction: at one execution, or from that step on.
void Space::DrawInstructions(const FaultKind kind, const std::uint32_t number, const std::uint32_t seed,
                             std::vector<Experiment>& to) const
{
    std::mt19937 random{seed};
    std::uint32_t left = number;
    while (left != 0U)
    {
        const auto step = static_cast<std::uint32_t>(random() % FaultedSteps());
        const std::vector<std::uint32_t>& trace = traces_[step];
        const auto count = static_cast<std::uint32_t>(random() % trace.size());
        const std::uint32_t address = trace[count];
        const auto bit = static_cast<std::uint32_t>(random() % 32U);
        if ((!program_.IsFaulted(address)) || (bit >= (8U * program_.Length(address))))
        {
            continue;
        }
        if (kind == FaultKind::kOpcode)
        {
            to.push_back({step, {kind, count, address, bit}});
        }
        else
        {
            to.push_back({step, {kind, address, address + (bit / 8U), bit % 8U}});
        }
        --left;
    }
}

void Space::DrawStuck(const Plan& plan, std::vector<Experiment>& to) const
{
    std::uint32_t bytes = 0U;
    for (const Range& range : program_.Memory())
    {
        bytes += range.end - range.begin;
    }
    std::mt19937 random{plan.seed + 3U};
    for (std::uint32_t i = 0U; (bytes != 0U) && (i < plan.stuck); ++i)
    {
        const auto step = static_cast<std::uint32_t>(random() % FaultedSteps());
        auto place = static_cast<std::uint32_t>(random() % bytes);
        const auto number = static_cast<std::uint32_t>(random() % 16U);
        for (const Range& range : program_.Memory())
        {
            if (place < (range.end - range.begin))
            {
                to.push_back({step, {FaultKind::kStuck, 0U, range.begin + place, number}});
                break;
            }
            place -= range.end - range.begin;
        }
    }
}

std::vector<Drawn> Space::Draw(const Plan& plan, std::size_t& all) const
{
    std::vector<Experiment> experiments;
    DrawCode(plan, experiments);
    DrawRegisters(plan, experiments);
    DrawInstructions(FaultKind::kOpcode, plan.opcodes, plan.seed + 4U, experiments);
    DrawInstructions(FaultKind::kFlash, plan.flash, plan.seed + 5U, experiments);
    DrawMemory(plan, experiments);
    DrawStuck(plan, experiments);
    const auto is_outside = [&plan](const Experiment& experiment)
    { return (experiment.step < plan.first) || (experiment.step > plan.last); };
    experiments.erase(std::remove_if(experiments.begin(), experiments.end(), is_outside), experiments.end());
    // Neighbours have most in common: the way to them, and what they come to.
    std::sort(experiments.begin(), experiments.end(), IsBefore);
    all = experiments.size();
    std::vector<Drawn> mine;
    for (std::size_t i = 0U; i < experiments.size(); ++i)
    {
        if (((i / kTogether) % plan.shards) == plan.shard)
        {
            mine.push_back({i, experiments[i]});
        }
    }
    return mine;
}

} // namespace counterpoint::injection
