// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/space.hpp"

#include "verification/campaign/drawn.hpp"
#include "verification/campaign/two_cpus.hpp"
#include "verification/campaign/variants.hpp"

#include <algorithm>
#include <cstring>

/// Given by the linker: where the program begins and ends.
extern "C" const char __executable_start; // NOLINT(bugprone-reserved-identifier)
extern "C" const char _end;               // NOLINT(bugprone-reserved-identifier)

namespace counterpoint::campaign
{
namespace
{
constexpr std::uint64_t kBitsOfByte = 8U;
constexpr std::uint64_t kMostExperiments = 100'000'000U;

bool IsAddressOfProgram(const std::uint8_t* const word)
{
    std::uintptr_t value = 0U;
    std::memcpy(&value, word, sizeof(value));
    return value >= reinterpret_cast<std::uintptr_t>(&__executable_start) &&
           value < reinterpret_cast<std::uintptr_t>(&_end);
}
} // namespace

Space::Space(const Plan& plan, const Recording& recording, Device& device, const std::size_t horizon)
    : plan_(plan), recording_(recording), input_count_(device.Receives().Inputs().size()),
      has_two_cpus_(device.AsTwoCpus() != nullptr)
{
    TakeReach(device);
    TakeCycles(plan, recording, horizon);
    TakeFrames();
    TakeCommands(device);
    TakeBytes(device);
    for (const Part part : plan.parts)
    {
        for (const FaultKind kind : plan.kinds)
        {
            if (!IsOf(part, kind))
            {
                continue;
            }
            Stratum stratum;
            stratum.part = part;
            stratum.kind = kind;
            stratum.first = size_;
            stratum.size = SizeOf(part, kind);
            stratum.taken = (plan.sample == 0U) ? stratum.size : std::min(plan.sample, stratum.size);
            if (stratum.taken > kMostExperiments - std::min(size_, kMostExperiments))
            {
                throw runtime::YamlError(plan.file, {}, "more than " + std::to_string(kMostExperiments) + " faults",
                                         "a sample");
            }
            size_ += stratum.taken;
            strata_.push_back(stratum);
        }
    }
    RequireFaults();
}

/// A part or kind that the plan names and that hits nothing here would be told as tried. [SRS_CMG_004]
void Space::RequireFaults() const
{
    constexpr const char* kExpected = "one that has something to hit: a frame in these cycles, an input, output: pins; "
                                      "with two CPUs all but both_channels and pins, with one no link, cpu";
    const auto has_some = [this](const auto& is_it)
    {
        return std::any_of(strata_.begin(), strata_.end(),
                           [&is_it](const Stratum& stratum) { return is_it(stratum) && stratum.size != 0U; });
    };
    for (std::size_t index = 0U; index < plan_.part_sources.size(); ++index)
    {
        const Part part = plan_.parts[index];
        if (!has_some([part](const Stratum& stratum) { return stratum.part == part; }))
        {
            throw runtime::YamlError(plan_.part_sources[index].file, plan_.part_sources[index].place,
                                     "part " + runtime::Shown(WordOf(part)) + " of which nothing is hit", kExpected);
        }
    }
    for (std::size_t index = 0U; index < plan_.kind_sources.size(); ++index)
    {
        const FaultKind kind = plan_.kinds[index];
        if (!has_some([kind](const Stratum& stratum) { return stratum.kind == kind; }))
        {
            throw runtime::YamlError(plan_.kind_sources[index].file, plan_.kind_sources[index].place,
                                     "kind " + runtime::Shown(WordOf(kind)) + " of which nothing is hit", kExpected);
        }
    }
}

/// How far faults move in time. [SRS_CMG_020]
void Space::TakeReach(const Device& device)
{
    const Nanoseconds cycle = device.Config().cycle_us * runtime::kNanosecondsPerMicrosecond;
    reach_ = static_cast<std::uint64_t>(plan_.reach / kGrid);
    early_ = static_cast<std::uint64_t>(std::max<Nanoseconds>(cycle / kGrid, 1) - 1);
}

void Space::TakeCycles(const Plan& plan, const Recording& recording, const std::size_t horizon)
{
    for (const Nanoseconds at : plan.at)
    {
        const auto first = std::find_if(recording.cycles.begin(), recording.cycles.end(),
                                        [at](const RecordedCycle& cycle) { return cycle.at >= at; });
        const auto begin = static_cast<std::size_t>(first - recording.cycles.begin());
        const bool moves =
            std::any_of(plan.parts.begin(), plan.parts.end(), [](const Part part) { return part == Part::kBus; });
        const std::size_t last = begin + plan.cycles - 1U;
        const Nanoseconds end =
            (last < recording.cycles.size()) ? recording.cycles[last].at + (moves ? plan.reach : 0) : 0;
        const std::size_t behind = (end == 0) ? recording.cycles.size() : CycleOf(recording, end);
        last_cycle_ = behind;
        if (begin == 0U || behind + horizon >= recording.cycles.size())
        {
            throw runtime::YamlError(plan.at_source.file, plan.at_source.place,
                                     "an instant at which the device is not running, or with less than " +
                                         std::to_string(horizon) + " cycles of the scenario behind its last cycle",
                                     "an earlier instant, or a longer scenario");
        }
        for (std::size_t cycle = begin; cycle < begin + plan.cycles; ++cycle)
        {
            cycles_.push_back(cycle);
        }
    }
    std::sort(cycles_.begin(), cycles_.end());
    cycles_.erase(std::unique(cycles_.begin(), cycles_.end()), cycles_.end());
}

bool Space::IsHit(const Part part) const
{
    const bool is_of_both = part == Part::kChannelA || part == Part::kChannelB;
    return std::any_of(plan_.parts.begin(), plan_.parts.end(), [part, is_of_both](const Part each)
                       { return each == part || (is_of_both && each == Part::kBothChannels); });
}

namespace
{
/// A byte behind the last one of a member that there is.
void RequireByte(const Device& device, const Member& member)
{
    const auto is_longer = [&member](const Place& place)
    { return place.name == member.name && member.byte.value_or(0U) < place.size; };
    const auto is_of = [&member](const Place& place) { return place.name == member.name; };
    const auto& places = device.Places();
    const auto found = std::find_if(places.begin(), places.end(), is_of);
    if (found != places.end() && std::none_of(places.begin(), places.end(), is_longer))
    {
        throw runtime::YamlError(member.source.file, member.source.place,
                                 "byte " + std::to_string(member.byte.value_or(0U)) + " of member " +
                                     runtime::Shown(member.name) + ", which has " + std::to_string(found->size),
                                 member.name + "+0 to " + member.name + "+" + std::to_string(found->size - 1U));
    }
}

/// Whether a place has the form and the range of a bit or byte of a member, or is the member.
bool IsOfMember(const Place& member, const std::string& place)
{
    if (place == member.name)
    {
        return true;
    }
    for (std::size_t byte = 0U; byte < member.size; ++byte)
    {
        const std::string text = member.name + "+" + std::to_string(byte);
        const bool is_bit = place.size() == text.size() + 2U && place.rfind(text + ".", 0U) == 0U &&
                            place.back() >= '0' && place.back() <= '7';
        if (place == text || is_bit)
        {
            return true;
        }
    }
    return false;
}

/// What no report can tell would answer for nothing: a part of the memory, a byte or bit that no member has.
void RequireKnown(const Device& device, const Known& known)
{
    const auto& places = device.Places();
    if (std::any_of(places.begin(), places.end(),
                    [&known](const Place& member) { return IsOfMember(member, known.place); }))
    {
        return;
    }
    bool is_part = known.place == WordOf(Part::kBothChannels);
    for (std::size_t part = 0U; part < kMemoryPartCount; ++part)
    {
        is_part = is_part || known.place == WordOf(static_cast<Part>(part));
    }
    const bool is_byte = known.place.find('+') != std::string::npos && known.place.find(' ') == std::string::npos;
    if (is_part || is_byte)
    {
        throw runtime::YamlError(known.source.file, known.source.place,
                                 (is_part ? "part " : "place ") + runtime::Shown(known.place) +
                                     (is_part ? " as a known place" : " that the device does not have"),
                                 "a member, byte or bit as in the reports, comparator.verdict+8.0 for instance");
    }
}
} // namespace

/// Members that the device does not have, or of which the plan hits nothing, are refused.
void Space::RequireMembers(const Device& device) const
{
    for (const Member& member : plan_.members)
    {
        const auto has = [&member](const Place& place)
        { return place.name == member.name && member.byte.value_or(0U) < place.size; };
        const auto found = std::find_if(device.Places().begin(), device.Places().end(), has);
        RequireByte(device, member);
        if (found == device.Places().end())
        {
            throw runtime::YamlError(member.source.file, member.source.place,
                                     "member " + runtime::Shown(member.name) + " that the device does not have",
                                     "one as in the reports, channel_a.records for instance");
        }
        if (!IsHit(found->part))
        {
            throw runtime::YamlError(member.source.file, member.source.place,
                                     "member " + runtime::Shown(member.name) + " without an effect",
                                     "one of the parts that the plan names");
        }
    }
}

/// A member of which every byte is left out would be told as tried.
void Space::RequireBytes(const Device& device) const
{
    for (const Member& member : plan_.members)
    {
        const auto is_of = [&device, &member](const Byte& byte)
        {
            const Place& place = device.Places()[byte.place];
            return place.name == member.name &&
                   byte.offset - place.offset == member.byte.value_or(byte.offset - place.offset);
        };
        if (std::none_of(std::begin(bytes_), std::end(bytes_), [&is_of](const std::vector<Byte>& bytes)
                         { return std::any_of(bytes.begin(), bytes.end(), is_of); }))
        {
            throw runtime::YamlError(member.source.file, member.source.place,
                                     "member " + runtime::Shown(member.name) +
                                         " that holds nothing but addresses of the program, which are not hit",
                                     "another one");
        }
    }
}

bool Space::IsChosen(const Place& place, const std::size_t byte) const
{
    return plan_.members.empty() ||
           std::any_of(plan_.members.begin(), plan_.members.end(), [&place, byte](const Member& member)
                       { return member.name == place.name && member.byte.value_or(byte) == byte; });
}

void Space::TakeBytes(Device& device)
{
    RequireMembers(device);
    for (const Known& known : plan_.known)
    {
        RequireKnown(device, known);
    }
    for (std::size_t place = 0U; place < device.Places().size(); ++place)
    {
        const Place& each = device.Places()[place];
        for (std::size_t byte = 0U; byte < each.size; ++byte)
        {
            const std::size_t offset = each.offset + byte;
            if (!IsChosen(each, byte))
            {
                continue;
            }
            if (IsAddressOfProgram(device.Memory().Bytes() + (offset & ~(sizeof(std::uintptr_t) - 1U))))
            {
                ++left_out_;
            }
            else
            {
                bytes_[static_cast<std::size_t>(each.part)].push_back({place, offset});
            }
        }
    }
    RequireBytes(device);
}

Experiment Space::At(const std::uint64_t number) const
{
    const auto behind =
        std::upper_bound(strata_.begin(), strata_.end(), number, [](const std::uint64_t wanted, const Stratum& stratum)
                         { return wanted < stratum.first + stratum.taken; });
    const Stratum& stratum = *behind;
    std::uint64_t index = number - stratum.first;
    if (stratum.taken < stratum.size)
    {
        // Of stretch number `index` out of `taken` ones of (almost) equal length.
        const std::uint64_t begin = index * stratum.size / stratum.taken;
        const std::uint64_t end = (index + 1U) * stratum.size / stratum.taken;
        index = begin + (Drawn(plan_.seed, number) % (end - begin));
    }
    Experiment experiment;
    experiment.part = stratum.part;
    experiment.kind = stratum.kind;
    if (IsMemory(stratum.part))
    {
        TakeMemory(experiment, index);
    }
    else
    {
        TakeSubject(experiment, index);
    }
    return experiment;
}

Bit Space::BitAt(const Part part, const std::uint64_t index) const
{
    const Byte& byte = bytes_[static_cast<std::size_t>(part)][index / kBitsOfByte];
    return {byte.place, byte.offset, static_cast<std::uint8_t>(index % kBitsOfByte)};
}

void Space::TakeMemory(Experiment& experiment, std::uint64_t index) const
{
    experiment.phase = plan_.phases[index % plan_.phases.size()];
    index /= plan_.phases.size();
    experiment.cycle = cycles_[index % cycles_.size()];
    index /= cycles_.size();
    Part first = experiment.part;
    if (experiment.part == Part::kBothChannels)
    {
        const std::uint64_t others = BytesOf(Part::kChannelB) * kBitsOfByte;
        experiment.second = BitAt(Part::kChannelB, index % others);
        index /= others;
        first = Part::kChannelA;
    }
    const Bit bit = BitAt(first, index);
    experiment.place = bit.place;
    experiment.offset = bit.offset;
    experiment.bit = bit.bit;
}

void Space::TakeSubject(Experiment& experiment, std::uint64_t index) const
{
    const std::uint64_t variants = VariantsOf(experiment.part, experiment.kind);
    experiment.variant = static_cast<std::uint32_t>(index % variants);
    index /= variants;
    if (experiment.part == Part::kBus)
    {
        TakeBusSubject(experiment, index);
        return;
    }
    if (experiment.part == Part::kCommands && experiment.kind != FaultKind::kInserted)
    {
        const ToldCommand& told = commands_[index];
        experiment.subject = told.command;
        experiment.cpu = told.cpu;
        experiment.cycle = told.cycle;
        return;
    }
    experiment.cycle = cycles_[index % cycles_.size()];
    experiment.subject = TakeCpu(experiment, index / cycles_.size());
    if (experiment.part == Part::kSteps)
    {
        experiment.phase = static_cast<Phase>(static_cast<std::size_t>(Phase::kFirstStep) + 1U + experiment.subject);
    }
}

/// What remains of a subject that each of two CPUs has.
std::uint64_t Space::TakeCpu(Experiment& experiment, const std::uint64_t subject) const
{
    if (!has_two_cpus_ || !IsOfEachCpu(experiment.part))
    {
        return subject;
    }
    const std::uint64_t of_one = SubjectsOfCpu(experiment.part, experiment.kind);
    experiment.cpu = subject / of_one;
    return subject % of_one;
}

/// A fault that comes later begins where it comes.
void Space::TakeBusSubject(Experiment& experiment, const std::uint64_t subject) const
{
    const bool is_pair = IsOfPair(experiment.kind);
    std::size_t frame = 0U;
    if (experiment.kind == FaultKind::kCorrupted)
    {
        const auto behind = std::upper_bound(frame_bits_.begin(), frame_bits_.end(), subject);
        const auto which = static_cast<std::size_t>(behind - frame_bits_.begin());
        frame = frames_[which];
        experiment.variant = static_cast<std::uint32_t>(subject - ((which == 0U) ? 0U : frame_bits_[which - 1U]));
    }
    else
    {
        frame = is_pair ? recording_.pairs[frame_pairs_[subject]].normal : frames_[subject];
    }
    experiment.subject = is_pair ? frame_pairs_[subject] : frame;
    const bool is_later = experiment.kind == FaultKind::kRepeated || experiment.kind == FaultKind::kInserted ||
                          experiment.kind == FaultKind::kPairRepeated || experiment.kind == FaultKind::kPairForged;
    const Nanoseconds offset = is_later ? kGrid * (Nanoseconds{experiment.variant} + 1) : 0;
    experiment.cycle = CycleOf(recording_, recording_.frames[frame].at + offset);
}

std::uint64_t Space::VariantsOf(const Part part, const FaultKind kind) const
{
    if (part == Part::kCycle && kind == FaultKind::kEarly)
    {
        return early_;
    }
    return campaign::VariantsOf(part, kind, reach_, recording_.identifiers.size());
}

/// Without cycles, and without variants.
std::uint64_t Space::SubjectsOf(const Part part, const FaultKind kind) const
{
    if (part == Part::kCommands && kind != FaultKind::kInserted)
    {
        return commands_.size();
    }
    const bool is_twice = has_two_cpus_ && IsOfEachCpu(part);
    return (is_twice ? kCpuSubjects : std::size_t{1U}) * SubjectsOfCpu(part, kind);
}

/// Of one CPU, where each has its own.
std::uint64_t Space::SubjectsOfCpu(const Part part, const FaultKind kind) const
{
    if (part == Part::kBus && kind == FaultKind::kCorrupted)
    {
        return frame_bits_.empty() ? 0U : frame_bits_.back();
    }
    if (part == Part::kBus)
    {
        return IsOfPair(kind) ? frame_pairs_.size() : frames_.size();
    }
    if (part == Part::kKernelCalls)
    {
        return std::uint64_t{kKernelCalls} * kTurns;
    }
    if (part == Part::kCallsOfA || part == Part::kCallsOfB)
    {
        return std::uint64_t{kChannelCalls} * kTurns;
    }
    if (part == Part::kSteps)
    {
        return (kind == FaultKind::kReordered) ? kStepSubjects - 1U : kStepSubjects;
    }
    if (part == Part::kCounters)
    {
        return has_two_cpus_ ? kCpuSubjects : kCounterSubjects; // Both at once are two faults of two oscillators.
    }
    if (part == Part::kLink || part == Part::kCpu)
    {
        return kCpuSubjects;
    }
    return (part == Part::kInputs) ? input_count_ : 1U;
}

/// What is tried of a device of two CPUs alone, and of one with one. [SRS_CMG_130]
bool Space::Has(const Part part) const
{
    const bool is_of_two = part == Part::kLink || part == Part::kCpu;
    return has_two_cpus_ ? part != Part::kBothChannels : !is_of_two;
}

std::uint64_t Space::SizeOf(const Part part, const FaultKind kind) const
{
    if (!Has(part))
    {
        return 0U;
    }
    if (part == Part::kBus || (part == Part::kCommands && kind != FaultKind::kInserted))
    {
        return SubjectsOf(part, kind) * VariantsOf(part, kind); // Each has its own cycle.
    }
    if (!IsMemory(part))
    {
        return SubjectsOf(part, kind) * VariantsOf(part, kind) * cycles_.size();
    }
    const std::uint64_t moments = cycles_.size() * plan_.phases.size();
    if (part == Part::kBothChannels)
    {
        return BytesOf(Part::kChannelA) * kBitsOfByte * BytesOf(Part::kChannelB) * kBitsOfByte * moments;
    }
    return BytesOf(part) * kBitsOfByte * moments;
}

void Space::TakeCommands(const Device& device)
{
    const TwoCpus* const two = device.AsTwoCpus();
    for (std::size_t cpu = 0U; cpu < (has_two_cpus_ ? kCpuSubjects : std::size_t{1U}); ++cpu)
    {
        for (std::size_t command = 0U; command < recording_.commands.size(); ++command)
        {
            const std::size_t cycle = recording_.commands[command].cycle;
            const std::optional<std::size_t> told = (two == nullptr) ? cycle : two->CycleOfCommand(command, cpu);
            if (told && std::binary_search(cycles_.begin(), cycles_.end(), cycle))
            {
                commands_.push_back({command, has_two_cpus_ ? cpu : kNoCpu, *told});
            }
        }
    }
}

void Space::TakeFrames()
{
    const auto is_hit = [this](const RecordedFrame& frame)
    { return std::binary_search(cycles_.begin(), cycles_.end(), CycleOf(recording_, frame.at)); };
    std::uint64_t bits = 0U;
    for (std::size_t frame = 0U; frame < recording_.frames.size(); ++frame)
    {
        if (is_hit(recording_.frames[frame]))
        {
            frames_.push_back(frame);
            bits += recording_.frames[frame].stamped.frame.length_bytes * kBitsOfByte;
            frame_bits_.push_back(bits);
        }
    }
    for (std::size_t pair = 0U; pair < recording_.pairs.size(); ++pair)
    {
        if (is_hit(recording_.frames[recording_.pairs[pair].normal]))
        {
            frame_pairs_.push_back(pair);
        }
    }
}
} // namespace counterpoint::campaign
