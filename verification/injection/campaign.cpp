// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/injection/campaign.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <stdexcept>

namespace counterpoint::injection
{
namespace
{

// Of `often` executions `each`, the first and the last among them.
bool IsChosen(const std::uint32_t number, const std::uint32_t often, const std::uint32_t each)
{
    if ((each == 0U) || (often <= each))
    {
        return true;
    }
    return (number == (often - 1U)) || (((number * (each - 1U)) % (often - 1U)) < (each - 1U));
}

} // namespace

Campaign::Campaign(Machine& machine, const Program& program, const std::vector<ScriptStep>& script)
    : machine_{machine}, program_{program}, script_{script}
{
    machine_.Start();
    // What configures the device, before the first step.
    Seen seen = machine_.Step(script_.front().mail, Fault{}, nullptr);
    before_.resize(script_.size() + 1U);
    traces_.resize(script_.size());
    for (std::size_t step = 0U; step < script_.size(); ++step)
    {
        if ((seen.end != StepEnd::kDone) || (seen.refused != 0U))
        {
            throw std::runtime_error{"the image refuses what comes before step " + std::to_string(step)};
        }
        machine_.Save(before_[step]);
        seen = machine_.Step(script_[step].mail, Fault{}, &traces_[step]);
        golden_.push_back(seen);
    }
    machine_.Save(before_[script_.size()]);
    for (const ScriptStep& step : script_)
    {
        for (std::uint32_t i = 0U; i < step.mail.frame_count; ++i)
        {
            const MailFrame& frame = step.mail.frames[i];
            if ((frame.identifier == 0x101U) || (frame.identifier == 0x103U))
            {
                values_[(frame.identifier - 0x101U) / 2U].push_back(__builtin_bswap32(frame.first));
            }
        }
    }
}

std::uint64_t Campaign::Instructions() const
{
    std::uint64_t sum = 0U;
    for (const std::vector<std::uint32_t>& trace : traces_)
    {
        sum += trace.size();
    }
    return sum;
}

Experiment Campaign::SkippedCall(const std::uint32_t step, const std::string& function) const
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

void Campaign::DrawCode(const Plan& plan, std::vector<Experiment>& to) const
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
                to.push_back({step, {FaultKind::kSkip, FindBlock(program_, trace, count), address, 0U}});
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

void Campaign::DrawRegisters(const Plan& plan, std::vector<Experiment>& to) const
{
    std::mt19937 random{plan.seed};
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

void Campaign::DrawMemory(const Plan& plan, std::vector<Experiment>& to) const
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
    std::mt19937 random{plan.seed};
    for (std::size_t i = 0U; (i < plan.memory) && (i < all.size()); ++i)
    {
        std::swap(all[i], all[i + (random() % (all.size() - i))]);
        to.push_back(all[i]);
    }
}

std::vector<Experiment> Campaign::Draw(const Plan& plan) const
{
    std::vector<Experiment> all;
    DrawCode(plan, all);
    DrawRegisters(plan, all);
    DrawMemory(plan, all);
    // In a drawn order, so that a part of the run says something of the whole.
    std::mt19937 random{plan.seed};
    for (std::size_t i = all.size(); i > 1U; --i)
    {
        std::swap(all[i - 1U], all[random() % i]);
    }
    std::vector<Experiment> mine;
    for (std::size_t i = plan.shard; i < all.size(); i += plan.shards)
    {
        mine.push_back(all[i]);
    }
    return mine;
}

Verdict Campaign::Run(const Experiment& experiment, const std::function<void(std::size_t, const Seen&)>& look)
{
    machine_.Restore(before_[experiment.step]);
    Fault fault = experiment.fault;
    if (fault.kind == FaultKind::kMemory)
    {
        machine_.FlipMemory(fault.address, fault.number);
        fault = Fault{};
    }
    Judge judge{golden_, values_, experiment.step};
    for (std::size_t step = experiment.step; step < script_.size(); ++step)
    {
        const Seen seen = machine_.Step(script_[step].mail, fault, nullptr);
        look(step, seen);
        if (judge.See(seen))
        {
            return judge.Conclude(false);
        }
        if (machine_.Equals(before_[step + 1U]))
        {
            return judge.Conclude(true);
        }
        fault = Fault{};
    }
    return judge.Conclude(false);
}

Verdict Campaign::RunControl(const std::uint32_t step, const std::function<void(Mailbox&, std::uint32_t)>& mail,
                             const std::function<void(Machine&, std::uint32_t)>& memory)
{
    machine_.Restore(before_[step]);
    Judge judge{golden_, values_, step};
    for (std::uint32_t now = step; now < script_.size(); ++now)
    {
        Mailbox changed = script_[now].mail;
        mail(changed, now - step);
        Seen seen = machine_.Step(changed, Fault{}, nullptr);
        memory(machine_, now - step);
        seen.objects = machine_.Objects();
        if (judge.See(seen))
        {
            break;
        }
    }
    return judge.Conclude(false);
}

} // namespace counterpoint::injection
