// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/summary.hpp"

#include "verification/campaign/variants.hpp"

#include <algorithm>

namespace counterpoint::campaign
{
namespace
{
bool HasTime(const Outcome& outcome)
{
    return outcome.result == Class::kDetected || outcome.result == Class::kSafeOther ||
           outcome.result == Class::kExposed;
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
        tally.limit_us = campaign.limits.Of(stratum.part, stratum.kind);
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
            if (outcome.is_late != 0U)
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
    std::copy_if(campaign.plan.detectors.begin(), campaign.plan.detectors.end(), std::back_inserter(summary.idle),
                 [&found](const Detector detector) { return found.at(static_cast<std::size_t>(detector)) == 0U; });
    return summary;
}

std::string PlaceText(const Campaign& campaign, const Experiment& experiment)
{
    if (!IsMemory(experiment.part))
    {
        return SubjectText(experiment, campaign.recording);
    }
    const Place& place = campaign.device.Places()[experiment.place];
    if (experiment.part == Part::kBothChannels)
    {
        const Place& other = campaign.device.Places()[experiment.second.place];
        return place.name + "+" + std::to_string(experiment.offset - place.offset) + "." +
               std::to_string(experiment.bit) + " and " + other.name + "+" +
               std::to_string(experiment.second.offset - other.offset) + "." + std::to_string(experiment.second.bit);
    }
    return place.name + "+" + std::to_string(experiment.offset - place.offset) + "." + std::to_string(experiment.bit);
}

std::string ListedText(const Summary& summary)
{
    std::uint64_t listed = 0U;
    std::uint64_t exposed = 0U;
    for (const Tally& tally : summary.tallies)
    {
        listed += tally.Of(Class::kListed);
        exposed += tally.Of(Class::kExposed);
    }
    std::string text;
    if (listed != 0U)
    {
        text += "listed: " + std::to_string(listed) +
                " open by a complete pair that is too old or that nobody sent, the limit that is listed\n";
    }
    if (exposed != 0U)
    {
        text += "exposed: " + std::to_string(exposed) + " open with wrong data for a time, closed within the limit\n";
    }
    return text;
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
                std::to_string(outcome.is_late) + "\n";
    }
    return text;
}
} // namespace counterpoint::campaign
