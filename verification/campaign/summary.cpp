// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/summary.hpp"

#include <algorithm>

namespace counterpoint::campaign
{
namespace
{
/// Whether this channel said this cause by itself in at least one experiment.
bool IsHeard(const Voice& voice, const Results& results)
{
    for (std::uint64_t index = 0U; index < results.Size(); ++index)
    {
        const Outcome outcome = results.At(index);
        if (outcome.detector == Detector::kChannels && outcome.detail == static_cast<std::uint8_t>(voice.cause) &&
            (outcome.marks & voice.mark) != 0U)
        {
            return true;
        }
    }
    return false;
}

bool HasTime(const Outcome& outcome)
{
    return outcome.result == Class::kDetected || outcome.result == Class::kSafeOther;
}
} // namespace

Summary Summarise(const Campaign& campaign, const Results& results)
{
    Summary summary;
    std::array<std::uint64_t, kDetectorCount> found{};
    for (const Stratum& stratum : campaign.space.Strata())
    {
        Tally tally;
        tally.stratum = stratum;
        tally.limit_us = campaign.limits.us.at(static_cast<std::size_t>(stratum.part));
        summary.tallies.push_back(tally);
    }
    auto tally = summary.tallies.begin();
    for (std::uint64_t index = 0U; index < results.Size(); ++index)
    {
        const std::uint64_t number = results.NumberAt(index);
        while (number >= tally->stratum.first + tally->stratum.taken)
        {
            ++tally;
        }
        const Outcome outcome = results.At(index);
        ++tally->classes.at(static_cast<std::size_t>(outcome.result));
        ++tally->detectors.at(static_cast<std::size_t>(outcome.detector));
        ++found.at(static_cast<std::size_t>(outcome.detector));
        summary.open += (outcome.result == Class::kOpen) ? 1U : 0U;
        if (outcome.result == Class::kSilent)
        {
            summary.silent.push_back({number, campaign.space.At(number), outcome});
        }
        if (HasTime(outcome))
        {
            tally->times.push_back(outcome.us);
            if (IsLate(outcome))
            {
                ++tally->late;
                summary.late.push_back({number, campaign.space.At(number), outcome});
            }
        }
    }
    for (Tally& each : summary.tallies)
    {
        std::sort(each.times.begin(), each.times.end());
    }
    for (const Detector detector : campaign.plan.detectors)
    {
        if (found.at(static_cast<std::size_t>(detector)) == 0U)
        {
            summary.idle.emplace_back(WordOf(detector));
        }
    }
    for (const Voice& voice : campaign.plan.voices)
    {
        if (!IsHeard(voice, results))
        {
            summary.idle.push_back(voice.name);
        }
    }
    return summary;
}

std::string PlaceText(const Campaign& campaign, const Experiment& experiment)
{
    const Place& place = campaign.device.Places()[experiment.place];
    return place.name + "+" + std::to_string(experiment.offset - place.offset) + "." + std::to_string(experiment.bit);
}

std::string CsvReport(const Campaign& campaign, const Results& results)
{
    std::string text = "number,part,place,kind,cycle,phase,class,detector,reason,us,late\n";
    for (std::uint64_t index = 0U; index < results.Size(); ++index)
    {
        const Outcome outcome = results.At(index);
        if (outcome.result == Class::kOpen)
        {
            continue;
        }
        const Experiment experiment = campaign.space.At(results.NumberAt(index));
        text += std::to_string(results.NumberAt(index)) + "," + WordOf(experiment.part) + "," +
                PlaceText(campaign, experiment) + "," + WordOf(experiment.kind) + "," +
                std::to_string(experiment.cycle) + "," + WordOf(experiment.phase) + "," + WordOf(outcome.result) + "," +
                WordOf(outcome.detector) + "," + ReasonOf(outcome) + "," + std::to_string(outcome.us) + "," +
                std::to_string(IsLate(outcome) ? 1 : 0) + "\n";
    }
    return text;
}
} // namespace counterpoint::campaign
