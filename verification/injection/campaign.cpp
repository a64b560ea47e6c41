// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/injection/campaign.hpp"

#include "verification/injection/thumb.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace counterpoint::injection
{
namespace
{

constexpr std::uint32_t kGfc = 0x001U;
constexpr std::uint32_t kNoStep = 0xFFFFFFFFU;

bool IsShown(const Shown& shown, const Seen& seen)
{
    const bool is_told =
        (shown.event == 0U) || (std::find(seen.events.begin(), seen.events.end(), shown.event) != seen.events.end());
    return is_told && ((shown.pins == kAnyPins) || (shown.pins == seen.pins)) && (seen.sent.size() >= shown.frames) &&
           (seen.device_fault == shown.device_fault) && (seen.end == StepEnd::kDone) && (seen.refused == 0U);
}

bool IsLasting(const FaultKind kind)
{
    return (kind == FaultKind::kMemory) || (kind == FaultKind::kStuck) || (kind == FaultKind::kFlash);
}

} // namespace

Campaign::Campaign(Machine& machine, const Program& program, const std::vector<ScriptStep>& script)
    : machine_{machine}, program_{program}, script_{script}, middle_step_{kNoStep}
{
    before_.resize(script_.size() + 1U);
    traces_.resize(script_.size());
    accesses_.resize(script_.size());
    is_executed_.assign(script_.size(), std::vector<bool>(program_.Code().size()));
    RunUndisturbed();
    for (const ScriptStep& step : script_)
    {
        golden_.is_operational.push_back(step.is_operational);
        for (std::uint32_t i = 0U; i < step.mail.frame_count; ++i)
        {
            const MailFrame& frame = step.mail.frames[i];
            if ((frame.identifier == 0x101U) || (frame.identifier == 0x103U))
            {
                golden_.values[(frame.identifier - 0x101U) / 2U].push_back(__builtin_bswap32(frame.first));
            }
        }
    }
}

// Each step twice: for its instructions, and for what it reads.
void Campaign::RunUndisturbed()
{
    machine_.Start();
    machine_.Save(before_.front());
    for (std::size_t step = 0U; step < script_.size(); ++step)
    {
        (void)machine_.Note(script_[step].mail, accesses_[step]);
        machine_.Restore(before_[step]);
        golden_.steps.push_back(machine_.Trace(script_[step].mail, traces_[step]));
        machine_.Save(before_[step + 1U]);
        if (!IsShown(script_[step].shown, golden_.steps.back()))
        {
            throw std::runtime_error{"step " + std::to_string(step) + " does not show " + script_[step].scene};
        }
        for (const std::uint32_t address : traces_[step])
        {
            is_executed_[step][address] = true;
        }
    }
}

// What lies between the experiment before and this one is run; the whole step is not.
void Campaign::WalkTo(const Experiment& experiment)
{
    const std::uint32_t count = FindBlock(program_, traces_[experiment.step], experiment.fault.count);
    if ((middle_step_ != experiment.step) || (middle_.count > count))
    {
        machine_.Restore(before_[experiment.step]);
        machine_.Begin(script_[experiment.step].mail);
    }
    else
    {
        machine_.Restore(middle_);
    }
    machine_.WalkTo(count);
    machine_.Save(middle_);
    middle_step_ = experiment.step;
}

Seen Campaign::FirstStep(const Experiment& experiment)
{
    const Fault& fault = experiment.fault;
    if (fault.kind == FaultKind::kNone)
    {
        machine_.Restore(before_[experiment.step]);
        return machine_.Step(script_[experiment.step].mail);
    }
    WalkTo(experiment);
    return machine_.Finish(fault);
}

Digest Campaign::StateOf(const Judge& judge)
{
    Digest state{};
    machine_.Add(state);
    judge.Add(state);
    return state;
}

Verdict Campaign::RunOnce(const Experiment& experiment, const Look& look)
{
    Judge judge{golden_, experiment.step};
    std::vector<Digest> states{};
    Seen seen = FirstStep(experiment);
    Verdict verdict{};
    for (std::size_t step = experiment.step;; ++step)
    {
        look(step, seen);
        const bool is_final = judge.See(seen);
        const bool is_equal = (!is_final) && machine_.Equals(before_[step + 1U]);
        if (is_final || is_equal || ((step + 1U) == script_.size()))
        {
            verdict = judge.Conclude(is_equal);
            break;
        }
        states.push_back(StateOf(judge));
        if (verdicts_.Find(states.back(), experiment.step, verdict))
        {
            break;
        }
        seen = machine_.Step(script_[step + 1U].mail);
    }
    verdicts_.Keep(states, experiment.step, verdict);
    return verdict;
}

// Whether the undisturbed step meets what is wrong.
Campaign::Meeting Campaign::MeetingOf(const Fault& fault, const std::uint32_t step) const
{
    if (fault.kind == FaultKind::kFlash)
    {
        return is_executed_[step][fault.count] ? Meeting::kMeets : Meeting::kPasses;
    }
    const std::uint32_t place = machine_.Memory().PlaceOf(fault.address);
    const Accesses& accesses = accesses_[step];
    const bool is_read_0 = ((accesses.zeros[place] >> (fault.number % 8U)) & 1U) != 0U;
    const bool is_read_1 = ((accesses.ones[place] >> (fault.number % 8U)) & 1U) != 0U;
    if (fault.kind == FaultKind::kStuck)
    {
        return ((fault.number >= 8U) ? is_read_0 : is_read_1) ? Meeting::kMeets : Meeting::kPasses;
    }
    if (is_read_0 || is_read_1)
    {
        return Meeting::kMeets;
    }
    return accesses.is_written[place] ? Meeting::kEnds : Meeting::kPasses;
}

// From this step on; the end of the script where none meets it.
std::uint32_t Campaign::NextMeeting(const Fault& fault, std::uint32_t step, Verdict& without) const
{
    without.kind = (fault.kind == FaultKind::kMemory) ? Class::kLatent : Class::kMasked;
    for (; step < script_.size(); ++step)
    {
        const Meeting meeting = MeetingOf(fault, step);
        if (meeting == Meeting::kMeets)
        {
            return step;
        }
        if (meeting == Meeting::kEnds)
        {
            without.kind = Class::kMasked;
            break;
        }
    }
    return static_cast<std::uint32_t>(script_.size());
}

void Campaign::Plant(const Fault& fault, const std::uint32_t step)
{
    machine_.Restore(before_[step]);
    if (fault.kind == FaultKind::kStuck)
    {
        machine_.Memory().Stick(fault.address, fault.number % 8U, fault.number >= 8U);
    }
    else if (fault.kind == FaultKind::kMemory)
    {
        machine_.Memory().Flip(fault.address, fault.number);
    }
}

// Whether nothing but the fault itself differs from the undisturbed device before this step.
bool Campaign::IsFaultAlone(const Fault& fault, const std::uint32_t step)
{
    if (fault.kind != FaultKind::kMemory)
    {
        return machine_.Equals(before_[step]);
    }
    machine_.Memory().Flip(fault.address, fault.number);
    const bool is_alone = machine_.Equals(before_[step]);
    machine_.Memory().Flip(fault.address, fault.number);
    return is_alone;
}

// A fault that stays: where all else is as without it, what comes next is the next step that meets it.
Verdict Campaign::RunLasting(const Experiment& experiment, const Look& look)
{
    const auto end = static_cast<std::uint32_t>(script_.size());
    const Fault& fault = experiment.fault;
    Verdict verdict{};
    const std::uint32_t first = NextMeeting(fault, experiment.step, verdict);
    if (first == end)
    {
        return verdict;
    }
    Plant(fault, first);
    Judge judge{golden_, first};
    std::vector<Digest> states{};
    std::uint32_t step = first;
    for (bool is_known = false; !is_known;)
    {
        const Seen seen = machine_.Step(script_[step].mail);
        look(step, seen);
        const bool is_final = judge.See(seen);
        ++step;
        const bool is_gone =
            (!is_final) && ((step == end) || (fault.kind == FaultKind::kMemory)) && machine_.Equals(before_[step]);
        if (is_final || is_gone || (step == end))
        {
            verdict = judge.Conclude(is_gone);
            break;
        }
        if (IsFaultAlone(fault, step))
        {
            const std::uint32_t next = NextMeeting(fault, step, verdict);
            if (next == end)
            {
                verdict = judge.Conclude(verdict.kind == Class::kMasked);
                break;
            }
            if (next != step)
            {
                judge.SkipTo(next);
                Plant(fault, next);
                step = next;
            }
        }
        if (fault.kind == FaultKind::kMemory)
        {
            states.push_back(StateOf(judge));
            is_known = verdicts_.Find(states.back(), first, verdict);
        }
    }
    verdicts_.Keep(states, first, verdict);
    return verdict;
}

// Whether all is as if the bus had lost the GFC of this step.
bool Campaign::IsLostGfc(const Experiment& experiment)
{
    const Mailbox& mail = script_[experiment.step].mail;
    if ((mail.frame_count == 0U) || (mail.frames[0].identifier != kGfc))
    {
        return false;
    }
    Mailbox without = mail;
    without.frame_count = 0U;
    Seen seen = FirstStep(experiment);
    std::vector<Seen> faulted{seen};
    for (std::size_t step = experiment.step + 1U; step < script_.size(); ++step)
    {
        faulted.push_back(machine_.Step(script_[step].mail));
    }
    machine_.Restore(before_[experiment.step]);
    seen = machine_.Step(without);
    for (std::size_t i = 0U; i < faulted.size(); ++i)
    {
        if (!AreSame(seen, faulted[i]))
        {
            return false;
        }
        if ((i + 1U) < faulted.size())
        {
            seen = machine_.Step(script_[experiment.step + i + 1U].mail);
        }
    }
    return true;
}

Verdict Campaign::Show(const Experiment& experiment, const Look& look)
{
    if (!IsLasting(experiment.fault.kind))
    {
        return RunOnce(experiment, look);
    }
    const bool is_code = experiment.fault.kind == FaultKind::kFlash;
    if (is_code)
    {
        machine_.FlipCode(experiment.fault.address, experiment.fault.number);
    }
    const Verdict verdict = RunLasting(experiment, look);
    if (is_code)
    {
        machine_.FlipCode(experiment.fault.address, experiment.fault.number);
    }
    return verdict;
}

Verdict Campaign::Run(const Experiment& experiment)
{
    const Verdict verdict = Show(experiment, [](std::size_t, const Seen&) {});
    if ((verdict.kind == Class::kSilent) && (!IsLasting(experiment.fault.kind)) && IsLostGfc(experiment))
    {
        return {Class::kLostFrame, "GFC", 0U};
    }
    return verdict;
}

Verdict Campaign::RunAnew(const Experiment& experiment)
{
    MemoryOfVerdicts verdicts{};
    std::swap(verdicts, verdicts_);
    middle_step_ = kNoStep;
    const Verdict verdict = Run(experiment);
    std::swap(verdicts, verdicts_);
    return verdict;
}

Verdict Campaign::RunControl(const std::uint32_t step, const Planted& planted)
{
    machine_.Restore(before_[step]);
    Judge judge{golden_, step};
    for (std::uint32_t now = step; now < script_.size(); ++now)
    {
        Mailbox changed = script_[now].mail;
        planted.mail(changed, now - step);
        Seen seen = machine_.Step(changed);
        planted.memory(machine_, now - step);
        seen.objects = machine_.Memory().Objects();
        planted.seen(seen, now - step);
        if (judge.See(seen))
        {
            break;
        }
    }
    return judge.Conclude(false);
}

} // namespace counterpoint::injection
