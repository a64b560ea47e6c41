// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/managed/space.hpp"

#include "canopen/cia301/dictionary/entry.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "runtime/device/time_text.hpp"
#include "verification/campaign/drawn.hpp"

#include <algorithm>
#include <cstdio>

namespace counterpoint::campaign::managed
{
namespace
{
constexpr std::uint32_t kLengths = 12U; ///< For so many times, each twice the one before, something is away.
constexpr std::uint64_t kByteBits = 8U;

[[nodiscard]] Target TargetOf(const CanFrame& frame)
{
    const std::uint32_t id = frame.identifier;
    const auto is_from_to = [id](const std::uint32_t first, const std::uint32_t last)
    { return id >= first && id <= last; };
    return (id == 0U)                   ? Target::kNmt
           : is_from_to(0x71U, 0x76U)   ? Target::kElection
           : is_from_to(0x580U, 0x67FU) ? Target::kSdo
           : is_from_to(0x700U, 0x77FU) ? Target::kLife
           : is_from_to(0x101U, 0x180U) ? Target::kSrdo
                                        : Target::kOther;
}

[[nodiscard]] std::string FrameText(const CanFrame& frame)
{
    char text[8] = {};
    std::snprintf(text, sizeof(text), "%03X#", static_cast<unsigned>(frame.identifier));
    std::string all = text;
    for (std::uint8_t byte = 0U; byte < frame.length_bytes; ++byte)
    {
        std::snprintf(text, sizeof(text), "%02X", static_cast<unsigned>(frame.data[byte]));
        all += text;
    }
    return all;
}

/// Whether the plan names this member, or its first word.
[[nodiscard]] bool IsNamed(const std::string& wanted, const std::string& member)
{
    return member == wanted || member.rfind(wanted + " ", 0U) == 0U;
}

[[nodiscard]] bool IsMeant(const std::vector<std::string>& wanted, const std::string& member)
{
    return wanted.empty() || std::any_of(wanted.begin(), wanted.end(),
                                         [&member](const std::string& each) { return IsNamed(each, member); });
}

/// As the clocks of a device.
[[nodiscard]] FaultKind KindOf(const Fault fault)
{
    switch (fault)
    {
    case Fault::kStopped:
        return FaultKind::kStopped;
    case Fault::kFast:
        return FaultKind::kFast;
    case Fault::kSlow:
        return FaultKind::kSlow;
    default:
        return FaultKind::kJump;
    }
}

[[nodiscard]] std::string TimeText(const Nanoseconds time)
{
    return runtime::MillisecondsColumn(time, 0U);
}
} // namespace

Space::Space(const Plan& plan, Stage& stage, const Reference& reference)
    : plan_(plan), stage_(stage), reference_(reference), until_(plan.until == 0 ? stage.End() : plan.until)
{
    if (plan.from >= stage.End() || until_ > stage.End())
    {
        throw runtime::YamlError(plan.file, plan.scenario_source.place,
                                 "a scenario that ends before 'until', or at 'from'", "times within the scenario");
    }
    TakeFrames();
    TakeObjects();
    for (const Target target : plan.parts)
    {
        for (const Fault fault : plan.kinds)
        {
            if (!IsOf(target, fault))
            {
                continue;
            }
            Stratum stratum = StratumOf(target, fault);
            stratum.taken = (plan.sample == 0U) ? stratum.Size() : std::min(plan.sample, stratum.Size());
            stratum.first = size_;
            size_ += stratum.taken;
            strata_.push_back(std::move(stratum));
        }
    }
    Require();
}

void Space::TakeFrames()
{
    for (std::size_t frame = 0U; frame < reference_.frames.size(); ++frame)
    {
        const RecordedFrame& recorded = reference_.frames[frame];
        const auto place = std::lower_bound(identifiers_.begin(), identifiers_.end(), recorded.frame.identifier);
        if (place == identifiers_.end() || *place != recorded.frame.identifier)
        {
            identifiers_.insert(place, recorded.frame.identifier);
        }
        if (recorded.start >= plan_.from && recorded.start < until_)
        {
            frames_[static_cast<std::size_t>(TargetOf(recorded.frame))].push_back(frame);
        }
    }
}

void Space::TakeObjects()
{
    for (std::size_t slave = 0U; slave < stage_.Slaves().size(); ++slave)
    {
        for (const ExpectedValue& expected : stage_.Slaves()[slave].expected)
        {
            if (expected.object.index <= cia301::kLastKernelIndex) // Behind it: a part of the program.
            {
                objects_.push_back({slave, expected});
            }
        }
    }
}

/// What is named and hits nothing is refused where it is named.
void Space::Require() const
{
    for (std::size_t index = 0U; index < plan_.members.size(); ++index)
    {
        const std::vector<ManagerMember>& all = reference_.memory;
        const bool is_there = std::any_of(all.begin(), all.end(), [this, index](const ManagerMember& each)
                                          { return IsNamed(plan_.members[index], each.name); });
        if (!is_there)
        {
            throw runtime::YamlError(plan_.file, plan_.member_sources[index].place,
                                     "no member of a manager's memory that is hit", "one that reports name, as gate");
        }
    }
    for (std::size_t index = 0U; index < plan_.part_sources.size(); ++index)
    {
        const bool hits = std::any_of(strata_.begin(), strata_.end(), [this, index](const Stratum& stratum)
                                      { return stratum.target == plan_.parts[index] && stratum.taken != 0U; });
        if (!hits)
        {
            throw runtime::YamlError(plan_.file, plan_.part_sources[index].place,
                                     "a part of which nothing is there between 'from' and 'until'", "one that is");
        }
    }
    for (std::size_t index = 0U; index < plan_.kind_sources.size(); ++index)
    {
        const bool hits = std::any_of(strata_.begin(), strata_.end(), [this, index](const Stratum& stratum)
                                      { return stratum.fault == plan_.kinds[index] && stratum.taken != 0U; });
        if (!hits)
        {
            throw runtime::YamlError(plan_.file, plan_.kind_sources[index].place,
                                     "a kind of which nothing is hit between 'from' and 'until'", "one that hits");
        }
    }
}

std::size_t Space::SubjectsOf(const Target target) const
{
    switch (target)
    {
    case Target::kWrites:
        return objects_.size();
    case Target::kSlaves:
        return stage_.Slaves().size();
    case Target::kMemory:
        return reference_.memory.size();
    default:
        return stage_.Managers().size();
    }
}

Stratum Space::StratumOf(const Target target, const Fault fault) const
{
    Stratum stratum{target, fault, {}, {}, 0U, 0U};
    std::size_t count = 0U;
    if (IsOfFrames(target))
    {
        stratum.subjects = frames_[static_cast<std::size_t>(target)];
    }
    else
    {
        count = SubjectsOf(target);
    }
    for (std::size_t subject = 0U; subject < count; ++subject)
    {
        stratum.subjects.push_back(subject);
    }
    std::uint64_t end = 0U;
    for (const std::size_t subject : stratum.subjects)
    {
        end += FaultsOf(target, fault, subject);
        stratum.ends.push_back(end);
    }
    return stratum;
}

/// Who hears the frame: everybody at once, and each one alone.
std::vector<host::NodeIndex> Space::ReceiversOf(const std::size_t frame) const
{
    std::vector<host::NodeIndex> receivers{kEverybody};
    const auto add = [this, frame, &receivers](const host::NodeIndex node)
    {
        if (node != reference_.frames[frame].sender)
        {
            receivers.push_back(node);
        }
    };
    for (const Slave& slave : stage_.Slaves())
    {
        add(slave.bus_node);
    }
    for (const auto& manager : stage_.Managers())
    {
        add(manager->BusNode());
    }
    return receivers;
}

std::uint64_t Space::FaultsOf(const Target target, const Fault fault, const std::size_t subject) const
{
    const auto instants = static_cast<std::uint64_t>((until_ - plan_.from) / kStep);
    if (IsOfFrames(target))
    {
        const auto reach = static_cast<std::uint64_t>(plan_.reach / kStep);
        return VariantsOf(fault, reference_.frames[subject].frame, reach, identifiers_.size()) *
               ReceiversOf(subject).size();
    }
    if (target == Target::kWrites)
    {
        return instants * objects_[subject].expected.size * kByteBits;
    }
    if (target == Target::kMemory)
    {
        const std::uint64_t bits = std::uint64_t{reference_.memory[subject].size_bytes} * kByteBits;
        return IsMeant(plan_.members, reference_.memory[subject].name) ? instants * bits : 0U;
    }
    if (target == Target::kClocks)
    {
        return instants * campaign::VariantsOf(Part::kCounters, KindOf(fault), 0U, 0U);
    }
    const bool is_for_a_time = fault == Fault::kRestarted || fault == Fault::kBack || fault == Fault::kOffBus;
    return instants * (is_for_a_time ? kLengths : 1U);
}

Trial Space::At(const std::uint64_t number) const
{
    const auto behind =
        std::upper_bound(strata_.begin(), strata_.end(), number, [](const std::uint64_t value, const Stratum& stratum)
                         { return value < stratum.first + stratum.taken; });
    const Stratum& stratum = *behind;
    const std::uint64_t place = number - stratum.first;
    const std::uint64_t rest_of_all = stratum.Size() % stratum.taken;
    const auto stretch = [&stratum, rest_of_all](const std::uint64_t which)
    { return (which * (stratum.Size() / stratum.taken)) + std::min(which, rest_of_all); };
    const std::uint64_t begin = stretch(place);
    const std::uint64_t end = stretch(place + 1U);
    const std::uint64_t index = begin + (Drawn(plan_.seed, number) % (end - begin));
    const auto found = std::upper_bound(stratum.ends.begin(), stratum.ends.end(), index);
    const auto which = static_cast<std::size_t>(found - stratum.ends.begin());
    Trial trial{stratum.target, stratum.fault, stratum.subjects[which], 0U, 0, {}};
    std::uint64_t rest = index - ((which == 0U) ? 0U : stratum.ends[which - 1U]);
    if (IsOfFrames(trial.target))
    {
        const RecordedFrame& recorded = reference_.frames[trial.subject];
        const std::vector<host::NodeIndex> receivers = ReceiversOf(trial.subject);
        trial.at = recorded.start;
        trial.variant = static_cast<std::uint32_t>(rest / receivers.size());
        trial.hit = {trial.fault,
                     trial.variant,
                     recorded.start,
                     recorded.frame,
                     receivers[rest % receivers.size()],
                     Drawn(~plan_.seed, number)};
        return trial;
    }
    const std::uint64_t instants = static_cast<std::uint64_t>((until_ - plan_.from) / kStep);
    trial.at = plan_.from + static_cast<Nanoseconds>(rest % instants) * kStep;
    rest /= instants;
    trial.variant = static_cast<std::uint32_t>(rest);
    return trial;
}

Nanoseconds Space::AwayOf(const Trial& trial)
{
    return runtime::kNanosecondsPerMillisecond << trial.variant;
}

std::uint32_t Space::ByteOf(const Trial& trial)
{
    return static_cast<std::uint32_t>(trial.variant / kByteBits);
}

CounterFault Space::ClockFaultOf(const Trial& trial)
{
    Experiment fault;
    fault.part = Part::kCounters;
    fault.kind = KindOf(trial.fault);
    fault.variant = trial.variant;
    return CounterFaultOf(fault);
}

std::string Space::SubjectText(const Trial& trial) const
{
    if (IsOfFrames(trial.target))
    {
        return FrameText(reference_.frames[trial.subject].frame);
    }
    if (trial.target == Target::kMemory)
    {
        const ManagerMember& member = reference_.memory[trial.subject];
        return "manager " + std::to_string(stage_.Managers()[member.manager]->Node()) + " " + member.name;
    }
    if (trial.target == Target::kManagers || trial.target == Target::kClocks)
    {
        return "manager " + std::to_string(stage_.Managers()[trial.subject]->Node());
    }
    if (trial.target == Target::kSlaves)
    {
        return "node " + std::to_string(stage_.Slaves()[trial.subject].node_id);
    }
    const WrittenObject& object = objects_[trial.subject];
    return "node " + std::to_string(stage_.Slaves()[object.slave].node_id) + " " +
           cia306::ObjectName(object.expected.object.index, object.expected.object.sub);
}

std::string Space::PlaceText(const Trial& trial) const
{
    std::string text = std::string(WordOf(trial.target)) + " " + WordOf(trial.fault) + " " + SubjectText(trial) +
                       " at " + TimeText(trial.at);
    if (IsOfFrames(trial.target))
    {
        text += ", " + VariantText(trial.hit, identifiers_);
        return text + (trial.hit.receiver == kEverybody ? "" : ", " + stage_.NameOf(trial.hit.receiver) + " alone");
    }
    if (trial.target == Target::kWrites)
    {
        return text + ", bit " + std::to_string(trial.variant);
    }
    if (trial.target == Target::kMemory)
    {
        return text + ", bit " + std::to_string(ByteOf(trial)) + "." + std::to_string(trial.variant % kByteBits);
    }
    if (trial.target == Target::kClocks)
    {
        const CounterFault what = ClockFaultOf(trial);
        return text + ((trial.fault == Fault::kJump) ? ", by " + std::to_string(what.jump_us) + " us"
                                                     : ", by " + std::to_string(what.rate_ppm) + " ppm");
    }
    const bool is_for_a_time =
        trial.fault == Fault::kRestarted || trial.fault == Fault::kBack || trial.fault == Fault::kOffBus;
    return text + (is_for_a_time ? ", for " + TimeText(AwayOf(trial)) : "");
}
} // namespace counterpoint::campaign::managed
