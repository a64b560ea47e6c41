// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/statistics.hpp"
#include "verification/campaign/summary.hpp"

#include <algorithm>
#include <cstdio>

namespace counterpoint::campaign
{
namespace
{
constexpr double kPercent = 100.0;
constexpr double kThousand = 1000.0;

constexpr const char* kHead =
    "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<style>"
    "body{font:16px/1.4 sans-serif;margin:1em auto;max-width:70em;padding:0 .6em}"
    ".wide{overflow-x:auto}table{border-collapse:collapse;font-size:.9em}"
    "td,th{border-bottom:1px solid #ccc;padding:.2em .6em;text-align:right;white-space:nowrap}"
    "td:first-child,th:first-child,.text td{text-align:left}.bad{background:#fdd}"
    ".bar{display:inline-block;height:.8em;background:#47a}"
    "@media(prefers-color-scheme:dark){body{background:#111;color:#eee}.bad{background:#622}td,th{border-color:#444}}"
    "</style>\n";

std::string Escaped(const std::string& text)
{
    std::string escaped;
    for (const char character : text)
    {
        switch (character)
        {
        case '&':
            escaped += "&amp;";
            break;
        case '<':
            escaped += "&lt;";
            break;
        case '>':
            escaped += "&gt;";
            break;
        default:
            escaped += character;
            break;
        }
    }
    return escaped;
}

std::string Ms(const std::uint32_t us)
{
    char text[32] = {};
    std::snprintf(text, sizeof(text), "%.3f", us / kThousand);
    return text;
}

std::string Cells(const std::vector<std::string>& cells, const char* const tag)
{
    std::string row;
    for (const std::string& cell : cells)
    {
        row += "<" + std::string(tag) + ">" + cell + "</" + tag + ">";
    }
    return row;
}

std::string CountTable(const Campaign& campaign, const Summary& summary)
{
    std::string text = "<h2>Classes</h2><div class=\"wide\"><table><tr>" +
                       Cells({"part", "kind", "faults", "injected", "masked", "benign", "effective", "detected",
                              "safe by others", "silent", "silent at most"},
                             "th") +
                       "</tr>\n";
    for (const Tally& tally : summary.tallies)
    {
        char bound[32] = "-";
        if (tally.Effective() != 0U)
        {
            std::snprintf(
                bound, sizeof(bound), "%.4f %%",
                UpperBound(tally.Of(Class::kSilent), tally.Effective(), campaign.plan.confidence_percent / kPercent) *
                    kPercent);
        }
        text += std::string("<tr") + ((tally.Of(Class::kSilent) != 0U) ? " class=\"bad\">" : ">") +
                Cells({WordOf(tally.stratum.part), WordOf(tally.stratum.kind), std::to_string(tally.stratum.size),
                       std::to_string(tally.stratum.taken), std::to_string(tally.Of(Class::kMasked)),
                       std::to_string(tally.Of(Class::kBenign)), std::to_string(tally.Effective()),
                       std::to_string(tally.Of(Class::kDetected)), std::to_string(tally.Of(Class::kSafeOther)),
                       std::to_string(tally.Of(Class::kSilent)), bound},
                      "td") +
                "</tr>\n";
    }
    return text + "</table></div><p>Silent at most: share of the effective faults, Clopper-Pearson, one-sided, " +
           std::to_string(campaign.plan.confidence_percent) + " %. Faults that had no effect count for nothing.</p>\n";
}

std::string DetectorTable(const Summary& summary)
{
    std::vector<std::string> head{"part", "kind"};
    for (std::size_t detector = 1U; detector < kDetectorCount; ++detector)
    {
        head.emplace_back(WordOf(static_cast<Detector>(detector)));
    }
    std::string text = "<h2>Found first by</h2><div class=\"wide\"><table><tr>" + Cells(head, "th") + "</tr>\n";
    for (const Tally& tally : summary.tallies)
    {
        std::vector<std::string> row{WordOf(tally.stratum.part), WordOf(tally.stratum.kind)};
        for (std::size_t detector = 1U; detector < kDetectorCount; ++detector)
        {
            row.push_back(std::to_string(tally.detectors[detector]));
        }
        text += "<tr>" + Cells(row, "td") + "</tr>\n";
    }
    return text + "</table></div>\n";
}

std::string TimeTable(const Summary& summary)
{
    std::string text = "<h2>Time to the safe output [ms]</h2><div class=\"wide\"><table><tr>" +
                       Cells({"part", "kind", "median", "99.9 %", "worst", "limit", "late"}, "th") + "</tr>\n";
    for (const Tally& tally : summary.tallies)
    {
        text += std::string("<tr") + ((tally.late != 0U) ? " class=\"bad\">" : ">") +
                Cells({WordOf(tally.stratum.part), WordOf(tally.stratum.kind), Ms(Quantile(tally.times, 0.5)),
                       Ms(Quantile(tally.times, 0.999)), Ms(tally.times.empty() ? 0U : tally.times.back()),
                       Ms(tally.limit_us), std::to_string(tally.late)},
                      "td") +
                "</tr>\n";
    }
    return text + "</table></div>\n";
}

/// How many came within twice the time of the row before.
std::string Histogram(const Summary& summary)
{
    std::string text = "<h2>Histogram of these times</h2><div class=\"wide\"><table><tr>" +
                       Cells({"up to [ms]", "faults", ""}, "th") + "</tr>\n";
    std::vector<std::uint32_t> times;
    for (const Tally& tally : summary.tallies)
    {
        times.insert(times.end(), tally.times.begin(), tally.times.end());
    }
    std::sort(times.begin(), times.end());
    auto begin = times.begin();
    for (std::uint64_t limit = 1000U; begin != times.end(); limit *= 2U)
    {
        const auto end = std::upper_bound(begin, times.end(), limit);
        const auto count = static_cast<std::uint64_t>(end - begin);
        const std::uint64_t width = count * 300U / times.size();
        text += "<tr>" +
                Cells({Ms(static_cast<std::uint32_t>(limit)), std::to_string(count),
                       "<span class=\"bar\" style=\"width:" + std::to_string(width) + "px\"></span>"},
                      "td") +
                "</tr>\n";
        begin = end;
    }
    return text + "</table></div>\n";
}

std::string FindingTable(const Campaign& campaign, const std::string& title, const std::vector<Finding>& findings)
{
    std::string text = "<h2>" + title + ": " + std::to_string(findings.size()) + "</h2>\n";
    if (findings.empty())
    {
        return text;
    }
    text += "<div class=\"wide\"><table class=\"text\"><tr>" +
            Cells({"experiment", "place", "kind", "cycle", "phase", "found by", "reason", "ms"}, "th") + "</tr>\n";
    for (const Finding& finding : findings)
    {
        text += "<tr>" +
                Cells({std::to_string(finding.number), PlaceText(campaign, finding.experiment),
                       WordOf(finding.experiment.kind), std::to_string(finding.experiment.cycle),
                       WordOf(finding.experiment.phase), WordOf(finding.outcome.detector), ReasonOf(finding.outcome),
                       Ms(finding.outcome.us)},
                      "td") +
                "</tr>\n";
    }
    return text + "</table></div>\n";
}
} // namespace

std::string HtmlReport(const Campaign& campaign, const Summary& summary)
{
    const std::string title = Escaped(campaign.plan.title);
    std::string text = std::string(kHead) + "<title>" + title + "</title></head><body><h1>" + title + "</h1>\n";
    text += summary.Holds() && summary.open == 0U ? "<p>The verdict: <b>holds</b>.</p>\n"
                                                  : "<p class=\"bad\">The verdict: <b>does not hold</b>.</p>\n";
    for (const Detector detector : summary.idle)
    {
        text += "<p class=\"bad\">" + std::string(WordOf(detector)) + " found nothing; the plan expects it to.</p>\n";
    }
    text += "<p>Seed " + std::to_string(campaign.plan.seed) + ", " + std::to_string(campaign.space.Size()) +
            " experiments, " + std::to_string(summary.open) + " of them not tried; " +
            std::to_string(campaign.space.LeftOut()) + " bytes that hold addresses of the program are left out. " +
            ListedText(summary) + "</p>\n";
    text += CountTable(campaign, summary) + FindingTable(campaign, "Silent", summary.silent) + DetectorTable(summary) +
            TimeTable(summary) + Histogram(summary) + FindingTable(campaign, "Later than the limit", summary.late);
    return text + "</body></html>\n";
}
} // namespace counterpoint::campaign
