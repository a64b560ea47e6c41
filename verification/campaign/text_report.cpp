// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/statistics.hpp"
#include "verification/campaign/summary.hpp"

#include <initializer_list>
#include <iomanip>
#include <sstream>

namespace counterpoint::campaign
{
namespace
{
constexpr std::size_t kMostLines = 30U;
constexpr double kPercent = 100.0;
constexpr int kNameWidth = 14; // The longest part, and a space.
constexpr int kWidth = 11;

/// Two names to the left, the others to the right.
std::string Row(const std::initializer_list<std::string> cells)
{
    std::ostringstream row;
    int column = 0;
    for (const std::string& cell : cells)
    {
        row << (column < 2 ? std::left : std::right) << std::setw(column < 2 ? kNameWidth : kWidth) << cell;
        ++column;
    }
    return row.str() + "\n";
}

std::string BoundText(const Tally& tally, const double confidence)
{
    if (tally.Effective() == 0U)
    {
        return "-";
    }
    std::ostringstream text;
    text << std::fixed << std::setprecision(4)
         << UpperBound(tally.Of(Class::kSilent), tally.Effective(), confidence) * kPercent << " %";
    return text.str();
}

std::string CountTable(const Campaign& campaign, const Summary& summary)
{
    const double confidence = campaign.plan.confidence_percent / kPercent;
    std::string text = Row({"part", "kind", "injected", "masked", "benign", "effective", "detected", "by others",
                            "listed", "exposed", "silent", "at most"});
    for (const Tally& tally : summary.tallies)
    {
        if (tally.stratum.size == 0U)
        {
            continue; // The device has none, or the plan names others.
        }
        const auto count = [&tally](const Class wanted) { return std::to_string(tally.Of(wanted)); };
        text += Row({WordOf(tally.stratum.part), WordOf(tally.stratum.kind), std::to_string(tally.Injected()),
                     count(Class::kMasked), count(Class::kBenign), std::to_string(tally.Effective()),
                     count(Class::kDetected), count(Class::kSafeOther), count(Class::kListed), count(Class::kExposed),
                     count(Class::kSilent), BoundText(tally, confidence)});
    }
    return text + "at most: silent share of effective faults, Clopper-Pearson, one-sided, " +
           std::to_string(campaign.plan.confidence_percent) + " %\n";
}

std::string TimeTable(const Summary& summary)
{
    std::string text = Row({"time [ms]", "kind", "median", "99.9 %", "worst", "limit", "late"});
    for (const Tally& tally : summary.tallies)
    {
        if (tally.stratum.size == 0U)
        {
            continue; // The device has none, or the plan names others.
        }
        const std::vector<std::string> times = TimeTexts(tally.times);
        text += Row({WordOf(tally.stratum.part), WordOf(tally.stratum.kind), times[0], times[1], times[2],
                     " " + LimitText(tally), std::to_string(tally.late)});
    }
    return text;
}

std::string DetectorLine(const Summary& summary)
{
    std::string text = "found first by:";
    for (std::size_t detector = 1U; detector < kDetectorCount; ++detector)
    {
        std::uint64_t count = 0U;
        for (const Tally& tally : summary.tallies)
        {
            count += tally.detectors.at(detector);
        }
        if (count != 0U)
        {
            text += std::string(" ") + WordOf(static_cast<Detector>(detector)) + " " + std::to_string(count);
        }
    }
    return text + "\n";
}

std::string FindingLines(const Campaign& campaign, const std::string& title, const Findings& findings)
{
    std::string text;
    for (std::size_t index = 0U; index < findings.size() && index < kMostLines; ++index)
    {
        const Finding& finding = findings[index];
        const Experiment experiment = campaign.space.At(finding.number);
        const std::string reason = ReasonOf(finding.outcome);
        text += title + ": experiment " + std::to_string(finding.number) + ": " + PlaceText(campaign, experiment) +
                ", " + WordOf(experiment.kind) + ", cycle " + std::to_string(experiment.cycle) + ", phase " +
                WordOf(experiment.phase) + ": " + WordOf(finding.outcome.detector) + (reason.empty() ? "" : ", ") +
                reason + ", " + MsText(finding.outcome.us) + " ms" +
                (finding.known == nullptr ? "" : " (known: " + finding.known->reason + ")") + "\n";
    }
    if (findings.size() > kMostLines)
    {
        text += title + ": " + std::to_string(findings.size() - kMostLines) + " more, all in --html and --csv\n";
    }
    return text;
}
} // namespace

std::string TextReport(const Campaign& campaign, const Summary& summary)
{
    std::string text = campaign.plan.title + "\n\n" + CountTable(campaign, summary) + "\n" + TimeTable(summary) + "\n" +
                       DetectorLine(summary) + "left out: " + std::to_string(campaign.space.LeftOut()) +
                       " bytes that hold addresses of the program\n" + ListedText(summary) + LatentText(summary) +
                       FindingLines(campaign, "silent", summary.silent) +
                       FindingLines(campaign, "exposed", summary.exposed) +
                       FindingLines(campaign, "late", summary.late);
    for (const std::string& name : summary.idle)
    {
        text += "idle: " + name + " found nothing; the plan expects it to\n";
    }
    for (const std::string& place : summary.stale)
    {
        text += "stale: nothing was found at " + place + ", which the plan calls known\n";
    }
    if (!summary.silent.empty() || !summary.exposed.empty() || !summary.late.empty())
    {
        text += "time line of one: counterpoint campaign " + campaign.plan.file + " --replay EXPERIMENT\n";
    }
    if (summary.open != 0U)
    {
        text += "open: " + std::to_string(summary.open) + " experiments were not tried\n";
    }
    return text + (summary.Holds() && summary.open == 0U ? "verdict: holds\n" : "verdict: does not hold\n");
}
} // namespace counterpoint::campaign
