// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/names.hpp"
#include "verification/campaign/html.hpp"
#include "verification/campaign/statistics.hpp"
#include "verification/campaign/summary.hpp"

#include <algorithm>
#include <cstdio>

namespace counterpoint::campaign
{
namespace
{
using html::Escaped;
using html::Row;
using html::Table;

constexpr double kPercent = 100.0;
constexpr std::uint64_t kBarWidth = 200U;
/// More are in the file of --csv and --json.
constexpr std::size_t kMostRows = 1000U;

std::string Number(const std::uint64_t number)
{
    return std::to_string(number);
}

std::string Bound(const Campaign& campaign, const Tally& tally)
{
    if (tally.Effective() == 0U)
    {
        return "-";
    }
    char text[32] = {};
    const double confidence = campaign.plan.confidence_percent / kPercent;
    std::snprintf(text, sizeof(text), "%.4f %%",
                  UpperBound(tally.Of(Class::kSilent), tally.Effective(), confidence) * kPercent);
    return text;
}

std::string CountTable(const Campaign& campaign, const Summary& summary)
{
    std::string text =
        "<h2>Classes</h2>" + Table({"part", "kind", "effective", "silent", "silent at most", "exposed", "detected",
                                    "safe by others", "listed", "injected", "masked", "benign", "faults"});
    for (const Tally& tally : summary.tallies)
    {
        if (tally.stratum.size == 0U)
        {
            continue;
        }
        text += Row({WordOf(tally.stratum.part), WordOf(tally.stratum.kind), Number(tally.Effective()),
                     Number(tally.Of(Class::kSilent)), Bound(campaign, tally), Number(tally.Of(Class::kExposed)),
                     Number(tally.Of(Class::kDetected)), Number(tally.Of(Class::kSafeOther)),
                     Number(tally.Of(Class::kListed)), Number(tally.Injected()), Number(tally.Of(Class::kMasked)),
                     Number(tally.Of(Class::kBenign)), Number(tally.stratum.size)},
                    (tally.Of(Class::kSilent) + tally.Of(Class::kExposed) != 0U) ? "bad" : "");
    }
    return text + html::kTableEnd + "<p>Silent at most: share of the effective faults, Clopper-Pearson, one-sided, " +
           Number(campaign.plan.confidence_percent) +
           " %. Faults that had no effect count for nothing. Exposed: open with wrong data until the self test found "
           "it, which is not detected in time. Listed: open by a complete valid pair that is too old or that nobody "
           "sent, the limit that the safety manual lists.</p>\n";
}

std::string DetectorTable(const Summary& summary)
{
    std::vector<std::string> head{"part", "kind"};
    for (const Mechanism& mechanism : summary.mechanisms)
    {
        head.emplace_back(WordOf(mechanism.detector));
    }
    std::string text = "<h2>Found first by</h2>" + Table(head);
    for (const Tally& tally : summary.tallies)
    {
        if (tally.stratum.size == 0U)
        {
            continue;
        }
        std::vector<std::string> row{WordOf(tally.stratum.part), WordOf(tally.stratum.kind)};
        for (const Mechanism& mechanism : summary.mechanisms)
        {
            row.push_back(Number(tally.detectors.at(static_cast<std::size_t>(mechanism.detector))));
        }
        text += Row(row);
    }
    return text + html::kTableEnd;
}

std::vector<std::string> Times(const std::vector<std::uint32_t>& sorted)
{
    std::vector<std::string> times = TimeTexts(sorted);
    times.insert(times.begin(), Number(sorted.size()));
    return times;
}

std::string TimeTables(const Summary& summary)
{
    std::string text = "<h2>Time to the safe output [ms]</h2>" +
                       Table({"part", "kind", "found", "median", "99.9 %", "worst", "limit", "late"});
    for (const Tally& tally : summary.tallies)
    {
        if (tally.stratum.size == 0U)
        {
            continue;
        }
        std::vector<std::string> row{WordOf(tally.stratum.part), WordOf(tally.stratum.kind)};
        const std::vector<std::string> times = Times(tally.times);
        row.insert(row.end(), times.begin(), times.end());
        row.insert(row.end(), {LimitText(tally), Number(tally.late)});
        text += Row(row, (tally.late != 0U) ? "bad" : "");
    }
    text += std::string(html::kTableEnd) + Table({"mechanism", "found", "median", "99.9 %", "worst"});
    for (const Mechanism& mechanism : summary.mechanisms)
    {
        std::vector<std::string> row = Times(mechanism.times);
        row.insert(row.begin(), WordOf(mechanism.detector));
        text += Row(row);
    }
    return text + html::kTableEnd;
}

std::string Histogram(const Summary& summary)
{
    const std::vector<Bin> bins = HistogramOf(summary);
    std::uint64_t most = 1U;
    for (const Bin& bin : bins)
    {
        most = std::max(most, bin.count);
    }
    std::string text = "<h2>Histogram of these times</h2>" + Table({"up to [ms]", "faults", ""});
    for (const Bin& bin : bins)
    {
        const std::uint64_t width = bin.count * kBarWidth / most;
        text +=
            Row({MsText(bin.up_to_us), Number(bin.count),
                 "<span class=\"bar\" style=\"width:" + Number(std::max<std::uint64_t>(width, 1U)) + "px\"></span>"},
                "text");
    }
    return text + html::kTableEnd;
}

/// Of a cell of the map: silent and exposed ones of those that had an effect.
std::string CellText(const MapCell& cell)
{
    if (cell.injected == 0U)
    {
        return "";
    }
    const std::string effective = Number(cell.effective);
    const std::uint64_t dangerous = cell.silent + cell.exposed;
    return (dangerous == 0U) ? effective : "<b>" + Number(dangerous) + "</b>/" + effective;
}

/// Of what is no memory, each once.
std::vector<FaultKind> KindsOf(const Summary& summary)
{
    std::vector<FaultKind> kinds;
    for (const Tally& tally : summary.tallies)
    {
        const bool is_new = std::find(kinds.begin(), kinds.end(), tally.stratum.kind) == kinds.end();
        if (is_new && tally.stratum.size != 0U && !IsMemory(tally.stratum.part))
        {
            kinds.push_back(tally.stratum.kind);
        }
    }
    return kinds;
}

/// Rows in which anything was tried; columns are phases or kinds.
template <typename Column>
std::string MapTable(const std::string& first, const std::vector<Column>& columns, const std::vector<MapRow>& rows)
{
    std::vector<std::string> head{first};
    for (const Column column : columns)
    {
        head.push_back(runtime::Words(WordOf(column)));
    }
    std::string text = Table(head, "map");
    for (const MapRow& each : rows)
    {
        std::vector<std::string> row{each.name};
        bool is_bad = false;
        bool has_any = false;
        for (const Column column : columns)
        {
            const MapCell& cell = each.cells.at(static_cast<std::size_t>(column));
            is_bad = is_bad || cell.silent + cell.exposed != 0U;
            has_any = has_any || cell.injected != 0U;
            row.push_back(CellText(cell));
        }
        text += has_any ? Row(row, is_bad ? "bad" : "") : "";
    }
    return text + html::kTableEnd;
}

std::string Map(const Campaign& campaign, const Summary& summary)
{
    std::string text = "<h2>Map</h2><p>Faults with an effect; in bold: silent and exposed ones of them. Empty: not "
                       "tried. Two bits at once count for the members of both.</p>";
    const bool has_memory = std::any_of(campaign.plan.parts.begin(), campaign.plan.parts.end(), IsMemory);
    text += has_memory ? MapTable("member", campaign.plan.phases, summary.map) : "";
    return text + (summary.subjects.empty() ? "" : MapTable("no memory", KindsOf(summary), summary.subjects));
}

std::string FindingTable(const Campaign& campaign, const std::string& title, const Findings& findings)
{
    std::string text = "<h2>" + title + ": " + Number(findings.size()) + "</h2>\n";
    if (findings.empty())
    {
        return text;
    }
    text += Table({"experiment", "place", "declared in", "kind", "cycle", "phase", "found by", "ms", "reason"}, "text");
    for (std::size_t index = 0U; index < findings.size() && index < kMostRows; ++index)
    {
        const Finding& finding = findings[index];
        const Experiment experiment = campaign.space.At(finding.number);
        const std::string known = (finding.known == nullptr) ? "" : "; known: " + finding.known->reason;
        text += Row({Number(finding.number), PlaceText(campaign, experiment),
                     DeclarationOf(MemberText(campaign, experiment)), WordOf(experiment.kind), Number(experiment.cycle),
                     WordOf(experiment.phase), WordOf(finding.outcome.detector), MsText(finding.outcome.us),
                     Escaped(ReasonOf(finding.outcome) + known)},
                    finding.known == nullptr ? "bad" : "");
    }
    return text + html::kTableEnd;
}

std::string Verdict(const Campaign& campaign, const Summary& summary)
{
    std::string text = summary.Holds() && summary.open == 0U
                           ? "<p class=\"good\">The verdict: <b>holds</b>.</p>\n"
                           : "<p class=\"bad\">The verdict: <b>does not hold</b>.</p>\n";
    for (const std::string& name : summary.idle)
    {
        text += "<p class=\"bad\">" + name + " found nothing; the plan expects it to.</p>\n";
    }
    for (const std::string& place : summary.stale)
    {
        text += "<p class=\"bad\">Nothing was found at " + Escaped(place) + ", which the plan calls known.</p>\n";
    }
    return text + "<p>Seed " + Number(campaign.plan.seed) + ", " + Number(campaign.space.Size()) + " experiments, " +
           Number(summary.open) + " of them not tried; " + Number(campaign.space.LeftOut()) +
           " bytes that hold addresses of the program are left out. The time line of an experiment: <code>counterpoint "
           "campaign " +
           Escaped(campaign.plan.file) + " --replay EXPERIMENT --html PAGE</code></p>\n" +
           (summary.latent == 0U ? "" : "<p>" + LatentText(summary) + "</p>\n");
}
} // namespace

std::string HtmlReport(const Campaign& campaign, const Summary& summary)
{
    return html::Head(campaign.plan.title) + Verdict(campaign, summary) + CountTable(campaign, summary) +
           FindingTable(campaign, "Silent", summary.silent) +
           FindingTable(campaign, "Exposed: open with wrong data until the self test found it", summary.exposed) +
           FindingTable(campaign, "Later than the limit", summary.late) + DetectorTable(summary) + TimeTables(summary) +
           Histogram(summary) + Map(campaign, summary) + "</body></html>\n";
}
} // namespace counterpoint::campaign
