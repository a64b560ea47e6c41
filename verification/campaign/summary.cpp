// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/summary.hpp"

#include "verification/campaign/statistics.hpp"
#include "verification/campaign/variants.hpp"

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

Summary EmptySummary(const Campaign& campaign)
{
    Summary summary;
    for (const Stratum& stratum : campaign.space.Strata())
    {
        Tally tally;
        tally.stratum = stratum;
        tally.limit_us = campaign.limits.Of(stratum.part, stratum.kind);
        tally.least_limit_us = tally.limit_us;
        summary.tallies.push_back(tally);
    }
    for (std::size_t detector = 0U; detector < kDetectorCount; ++detector)
    {
        summary.mechanisms.push_back({static_cast<Detector>(detector), {}});
    }
    for (const Place& place : campaign.device.Places())
    {
        summary.map.push_back({place.name, std::vector<MapCell>(kPhaseCount)});
    }
    return summary;
}

/// Whether a bit of the memory, as member+byte.bit, is the known one, or one of a known byte or member. The beginning
/// of a name is none of these: a part would answer for all of its members.
bool IsWithin(const std::string& bit, const std::string& known)
{
    const std::size_t dot = bit.rfind('.');
    return known == bit || known == bit.substr(0U, dot) || known == bit.substr(0U, bit.find('+'));
}

/// Whether the place of what is no memory, a row of words, begins with the known ones.
bool BeginsWith(const std::string& place, const std::string& known)
{
    return (place + " ").rfind(known + " ", 0U) == 0U;
}

std::string BitText(const Campaign& campaign, const Bit& bit)
{
    const Place& place = campaign.device.Places()[bit.place];
    return place.name + "+" + std::to_string(bit.offset - place.offset) + "." + std::to_string(bit.bit);
}

Bit FirstOf(const Experiment& experiment)
{
    return {experiment.place, experiment.offset, experiment.bit};
}

/// Of two bits at once either of them.
bool IsOf(const Campaign& campaign, const Finding& finding, const Known& known)
{
    const Experiment experiment = campaign.space.At(finding.number);
    const bool is_memory = IsMemory(experiment.part);
    const bool is_pair = experiment.part == Part::kBothChannels;
    const bool is_there = BeginsWith(PlaceText(campaign, experiment), known.place) ||
                          (is_memory && IsWithin(BitText(campaign, FirstOf(experiment)), known.place)) ||
                          (is_pair && IsWithin(BitText(campaign, experiment.second), known.place));
    return is_there && known.result.value_or(finding.outcome.result) == finding.outcome.result;
}

Finding FindingOf(const Campaign& campaign, const std::uint64_t number, const Outcome& outcome)
{
    Finding finding{number, outcome, nullptr};
    for (const Known& known : campaign.plan.known)
    {
        finding.known = IsOf(campaign, finding, known) ? &known : finding.known;
    }
    return finding;
}

void Count(const Outcome& outcome, MapCell& cell)
{
    ++cell.injected;
    cell.effective += IsEffective(outcome.result) ? 1U : 0U;
    cell.silent += (outcome.result == Class::kSilent) ? 1U : 0U;
    cell.exposed += (outcome.result == Class::kExposed) ? 1U : 0U;
}

/// Two bits at once count for the members of both.
void CountInMap(const Campaign& campaign, const Experiment& experiment, const Outcome& outcome, Summary& summary)
{
    const auto phase = static_cast<std::size_t>(experiment.phase);
    if (IsMemory(experiment.part))
    {
        Count(outcome, summary.map.at(experiment.place).cells.at(phase));
        if (experiment.part == Part::kBothChannels)
        {
            Count(outcome, summary.map.at(experiment.second.place).cells.at(phase));
        }
        return;
    }
    const std::string name = MemberText(campaign, experiment);
    auto row = std::find_if(summary.subjects.begin(), summary.subjects.end(),
                            [&name](const MapRow& each) { return each.name == name; });
    if (row == summary.subjects.end())
    {
        row = summary.subjects.insert(row, MapRow{name, std::vector<MapCell>(kFaultKindCount)});
    }
    Count(outcome, row->cells.at(static_cast<std::size_t>(experiment.kind)));
}

/// Of the first one that was tried there is no other.
void CountLimit(const std::uint32_t us, Tally& tally)
{
    const bool is_first = tally.Injected() == 1U;
    tally.limit_us = is_first ? us : std::max(tally.limit_us, us);
    tally.least_limit_us = is_first ? us : std::min(tally.least_limit_us, us);
}

void Count(const Campaign& campaign, const std::uint64_t number, const Outcome& outcome, Tally& tally, Summary& summary)
{
    ++tally.classes.at(static_cast<std::size_t>(outcome.result));
    tally.detectors.at(static_cast<std::size_t>(outcome.detector)) += (outcome.result != Class::kExposed) ? 1U : 0U;
    if (outcome.result == Class::kOpen)
    {
        ++summary.open;
        return;
    }
    const Experiment experiment = campaign.space.At(number);
    CountLimit(campaign.limits.Of(experiment, campaign.recording), tally);
    CountInMap(campaign, experiment, outcome, summary);
    if (HasTime(outcome))
    {
        tally.times.push_back(outcome.us);
        summary.mechanisms.at(static_cast<std::size_t>(outcome.detector)).times.push_back(outcome.us);
    }
    summary.latent += IsLatent(outcome) ? 1U : 0U;
    if (outcome.result == Class::kSilent)
    {
        summary.silent.push_back(FindingOf(campaign, number, outcome));
    }
    else if (outcome.result == Class::kExposed)
    {
        summary.exposed.push_back(FindingOf(campaign, number, outcome));
    }
    else if (IsLate(outcome))
    {
        ++tally.late;
        summary.late.push_back(FindingOf(campaign, number, outcome));
    }
    else
    {
        // Nobody has to look at it.
    }
}

/// What the plan expects and what did not come.
void Expect(const Campaign& campaign, const Results& results, Summary& summary)
{
    for (const Detector detector : campaign.plan.detectors)
    {
        if (summary.mechanisms.at(static_cast<std::size_t>(detector)).times.empty())
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
    for (const Known& known : campaign.plan.known)
    {
        const auto is_needed = [&campaign, &known](const Findings& findings)
        {
            return std::any_of(findings.begin(), findings.end(),
                               [&](const Finding& finding) { return IsOf(campaign, finding, known); });
        };
        // A sample need not draw it.
        if (campaign.plan.sample == 0U && !is_needed(summary.silent) && !is_needed(summary.exposed) &&
            !is_needed(summary.late))
        {
            summary.stale.push_back(known.place);
        }
    }
}

/// A field of a row: between quotation marks where commas or quotation marks are in it, as RFC 4180 says.
std::string Field(const std::string& text)
{
    if (text.find_first_of(",\"\n") == std::string::npos)
    {
        return text;
    }
    std::string field = "\"";
    for (const char character : text)
    {
        field += (character == '"') ? "\"\"" : std::string(1U, character);
    }
    return field + "\"";
}
} // namespace

bool Summary::IsKnown(const Findings& findings) noexcept
{
    return std::none_of(findings.begin(), findings.end(),
                        [](const Finding& finding) { return finding.known == nullptr; });
}

Summary Summarise(const Campaign& campaign, const Results& results)
{
    Summary summary = EmptySummary(campaign);
    auto tally = summary.tallies.begin();
    for (std::uint64_t index = 0U; index < results.Size(); ++index)
    {
        const std::uint64_t number = results.NumberAt(index);
        while (number >= tally->stratum.first + tally->stratum.taken)
        {
            ++tally;
        }
        Count(campaign, number, results.At(index), *tally, summary);
    }
    for (Tally& each : summary.tallies)
    {
        std::sort(each.times.begin(), each.times.end());
    }
    for (Mechanism& each : summary.mechanisms)
    {
        std::sort(each.times.begin(), each.times.end());
    }
    Expect(campaign, results, summary);
    const auto has_none = [](const Mechanism& each) { return each.times.empty(); };
    summary.mechanisms.erase(std::remove_if(summary.mechanisms.begin(), summary.mechanisms.end(), has_none),
                             summary.mechanisms.end());
    return summary;
}

std::vector<Bin> HistogramOf(const Summary& summary)
{
    constexpr std::uint32_t kFirstUs = 1000U;
    std::vector<Bin> bins;
    for (const Mechanism& mechanism : summary.mechanisms)
    {
        for (const std::uint32_t us : mechanism.times)
        {
            std::size_t bin = 0U;
            for (std::uint64_t limit = kFirstUs; limit < us; limit *= 2U)
            {
                ++bin;
            }
            while (bins.size() <= bin)
            {
                bins.push_back({bins.empty() ? kFirstUs : bins.back().up_to_us * 2U, 0U});
            }
            ++bins[bin].count;
        }
    }
    return bins;
}

std::string PlaceText(const Campaign& campaign, const Experiment& experiment)
{
    if (!IsMemory(experiment.part))
    {
        return SubjectText(experiment, campaign.recording);
    }
    const std::string text = BitText(campaign, FirstOf(experiment));
    return (experiment.part == Part::kBothChannels) ? text + " and " + BitText(campaign, experiment.second) : text;
}

std::string MemberText(const Campaign& campaign, const Experiment& experiment)
{
    return IsMemory(experiment.part) ? campaign.device.Places()[experiment.place].name
                                     : SubjectName(experiment, campaign.recording);
}

std::vector<std::string> TimeTexts(const std::vector<std::uint32_t>& sorted)
{
    if (sorted.empty())
    {
        return {"-", "-", "-"};
    }
    constexpr double kMedian = 0.5;
    constexpr double kAlmostAll = 0.999;
    return {MsText(Quantile(sorted, kMedian)), MsText(Quantile(sorted, kAlmostAll)), MsText(sorted.back())};
}

std::string LimitText(const Tally& tally)
{
    const std::string longest = MsText(tally.limit_us);
    return (tally.least_limit_us == tally.limit_us) ? longest : MsText(tally.least_limit_us) + " to " + longest;
}

std::string ListedText(const Summary& summary)
{
    std::uint64_t listed = 0U;
    for (const Tally& tally : summary.tallies)
    {
        listed += tally.Of(Class::kListed);
    }
    return (listed == 0U)
               ? ""
               : "listed: " + std::to_string(listed) +
                     " open by a complete pair that is too old or that nobody sent, the limit that is listed\n";
}

std::string LatentText(const Summary& summary)
{
    return (summary.latent == 0U) ? ""
                                  : "latent: " + std::to_string(summary.latent) +
                                        " differed elsewhere in memory for longer than the limit, and were found in " +
                                        "time behind the first thing that the device did otherwise\n";
}

void CsvReport(const Campaign& campaign, const Results& results, const cia306::TextPiece& write)
{
    write("number,part,place,kind,cycle,phase,class,detector,reason,us,late\n");
    for (std::uint64_t index = 0U; index < results.Size(); ++index)
    {
        const Outcome outcome = results.At(index);
        if (outcome.result == Class::kOpen)
        {
            continue;
        }
        const Experiment experiment = campaign.space.At(results.NumberAt(index));
        write(std::to_string(results.NumberAt(index)) + "," + WordOf(experiment.part) + "," +
              Field(PlaceText(campaign, experiment)) + "," + WordOf(experiment.kind) + "," +
              std::to_string(experiment.cycle) + "," + WordOf(experiment.phase) + "," + WordOf(outcome.result) + "," +
              WordOf(outcome.detector) + "," + Field(ReasonOf(outcome)) + "," + std::to_string(outcome.us) + "," +
              std::to_string(IsLate(outcome) ? 1 : 0) + "\n");
    }
}
} // namespace counterpoint::campaign
