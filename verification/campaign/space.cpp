// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/space.hpp"

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

/// A number that looks drawn, of seed and number alone (SplitMix64).
std::uint64_t Drawn(const std::uint64_t seed, const std::uint64_t number)
{
    std::uint64_t state = seed + (number + 1U) * 0x9E3779B97F4A7C15U;
    state = (state ^ (state >> 30U)) * 0xBF58476D1CE4E5B9U;
    state = (state ^ (state >> 27U)) * 0x94D049BB133111EBU;
    return state ^ (state >> 31U);
}

bool IsAddressOfProgram(const std::uint8_t* const word)
{
    std::uintptr_t value = 0U;
    std::memcpy(&value, word, sizeof(value));
    return value >= reinterpret_cast<std::uintptr_t>(&__executable_start) &&
           value < reinterpret_cast<std::uintptr_t>(&_end);
}
} // namespace

Space::Space(const Plan& plan, const Recording& recording, Device& device, const std::size_t horizon) : plan_(plan)
{
    TakeCycles(plan, recording, horizon);
    TakeBytes(device);
    for (const Part part : plan.parts)
    {
        for (const FaultKind kind : plan.kinds)
        {
            Stratum stratum;
            stratum.part = part;
            stratum.kind = kind;
            stratum.first = size_;
            stratum.size = BytesOf(part) * kBitsOfByte * cycles_.size() * plan.phases.size();
            stratum.taken = (plan.sample == 0U) ? stratum.size : std::min(plan.sample, stratum.size);
            size_ += stratum.taken;
            strata_.push_back(stratum);
        }
    }
}

void Space::TakeCycles(const Plan& plan, const Recording& recording, const std::size_t horizon)
{
    for (const Nanoseconds at : plan.at)
    {
        const auto first = std::find_if(recording.cycles.begin(), recording.cycles.end(),
                                        [at](const RecordedCycle& cycle) { return cycle.at >= at; });
        const auto begin = static_cast<std::size_t>(first - recording.cycles.begin());
        if (begin == 0U || begin + plan.cycles + horizon > recording.cycles.size())
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

/// Members that the device does not have are refused.
void Space::RequireMembers(const Device& device) const
{
    for (const Member& member : plan_.members)
    {
        const auto has = [&member](const Place& place)
        { return place.name == member.name && member.byte.value_or(0U) < place.size; };
        if (std::none_of(device.Places().begin(), device.Places().end(), has))
        {
            throw runtime::YamlError(member.source.file, member.source.place,
                                     "member " + runtime::Shown(member.name) + " that the device does not have",
                                     "one as in the reports, channel_a.records for instance");
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
    experiment.phase = plan_.phases[index % plan_.phases.size()];
    index /= plan_.phases.size();
    experiment.cycle = cycles_[index % cycles_.size()];
    index /= cycles_.size();
    experiment.bit = static_cast<std::uint8_t>(index % kBitsOfByte);
    const Byte& byte = bytes_[static_cast<std::size_t>(stratum.part)][index / kBitsOfByte];
    experiment.place = byte.place;
    experiment.offset = byte.offset;
    return experiment;
}
} // namespace counterpoint::campaign
