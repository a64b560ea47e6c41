// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/report.hpp"

#include "canopen/cia306/text/html_text.hpp"
#include "canopen/monitor/texts.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace counterpoint::monitor
{
namespace
{
constexpr std::size_t kMostRows = 2000U; ///< Of the list of violations.
constexpr int kBarWidth = 8;
constexpr int kChartHeight = 120;

constexpr const char* kStyle =
    "body{font:15px/1.5 system-ui,sans-serif;color:#1b2733;background:#fff;max-width:72rem;margin:2rem auto;padding:0 "
    "1rem}"
    "h1,h2{overflow-wrap:anywhere}h1{font-size:1.5rem}h2{font-size:1.1rem;margin:2rem 0 .3rem;border-top:1px solid "
    "#d5dce3;padding-top:1rem}"
    "table{border-collapse:collapse;width:100%}td,th{text-align:left;padding:.25rem .6rem;border-bottom:1px solid "
    "#e6ebf0;"
    "vertical-align:top}td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}"
    ".bad{color:#a51d24;font-weight:600}.good{color:#1c6b3c;font-weight:600}.charts{display:flex;flex-wrap:wrap;gap:"
    "2rem}"
    "figure{margin:.5rem 0;max-width:min(31rem,100%);overflow-x:auto}"
    "figcaption{color:#52616f}rect{fill:#3b6ea5}rect.over{fill:#a51d24}line{stroke:#a51d24;stroke-width:2}svg "
    "text{font-size:11px;fill:#52616f}.scroll{overflow-x:auto}"
    "@media(prefers-color-scheme:dark){body{background:#12181e;color:#dfe7ee}td,th,h2{border-color:#2c3945}"
    ".bad{color:#ff8087}.good{color:#6fcf97}rect{fill:#6ea3dc}svg text,figcaption{fill:#9fb0bf;color:#9fb0bf}}";

std::string Bar(const std::size_t bin, const std::size_t count, const std::size_t most)
{
    const auto scaled = static_cast<int>(static_cast<double>(count) * kChartHeight / static_cast<double>(most));
    const int height = std::max(scaled, 1);
    std::array<char, 200U> text{};
    static_cast<void>(std::snprintf(
        text.data(), text.size(), "<rect%s x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\"><title>%zu</title></rect>",
        bin >= TimeStatistics::kBinsToLimit ? " class=\"over\"" : "", static_cast<int>(bin) * kBarWidth,
        kChartHeight - height + 10, kBarWidth - 1, height, count));
    return text.data();
}

/// Histogram with the limit in it; the last bar is all that is beyond one and a half times the limit.
std::string Chart(const char* const name, const TimeStatistics& times)
{
    if (times.count == 0U)
    {
        return std::string("<figure><figcaption>") + name + ": none measured</figcaption></figure>";
    }
    const std::size_t most = *std::max_element(times.bins.begin(), times.bins.end());
    const int width = static_cast<int>(TimeStatistics::kBins) * kBarWidth;
    const int limit = static_cast<int>(TimeStatistics::kBinsToLimit) * kBarWidth;
    std::string bars;
    for (std::size_t bin = 0U; bin < TimeStatistics::kBins; ++bin)
    {
        bars += times.bins.at(bin) == 0U ? "" : Bar(bin, times.bins.at(bin), most);
    }
    std::array<char, 400U> frame{};
    static_cast<void>(std::snprintf(
        frame.data(), frame.size(),
        "<line x1=\"%d\" y1=\"4\" x2=\"%d\" y2=\"%d\"/><text x=\"%d\" y=\"%d\">limit %s</text><text x=\"0\" "
        "y=\"%d\">0</text></svg>",
        limit, limit, kChartHeight + 10, limit - 30, kChartHeight + 26, MillisecondsText(times.limit).c_str(),
        kChartHeight + 26));
    return std::string("<figure><figcaption>") + name + ": least " + MillisecondsText(times.least) + ", mean " +
           MillisecondsText(times.Mean()) + ", greatest " + MillisecondsText(times.greatest) + ", margin " +
           MillisecondsText(times.limit - times.greatest) + "</figcaption><svg role=\"img\" width=\"" +
           std::to_string(width) + "\" height=\"" + std::to_string(kChartHeight + 32) + "\" viewBox=\"0 0 " +
           std::to_string(width) + " " + std::to_string(kChartHeight + 32) + "\">" + bars + frame.data() + "</figure>";
}

std::string Causes(const std::array<std::size_t, kCauseCount>& counts)
{
    std::string text;
    for (std::size_t cause = 0U; cause < kCauseCount; ++cause)
    {
        text += counts.at(cause) == 0U ? ""
                                       : (text.empty() ? "" : ", ") + std::to_string(counts.at(cause)) + " " +
                                             CauseName(static_cast<Cause>(cause));
    }
    return text.empty() ? "<span class=\"good\">no violation</span>" : "<span class=\"bad\">" + text + "</span>";
}

std::string SrdoSection(const Report& report, const std::size_t number)
{
    const WatchModel& model = report.network.Watches()[number];
    const SrdoWatch& watch = report.analysis.Watches()[number];
    const std::vector<std::size_t> silent = Silent(report);
    const bool is_silent = std::count(silent.begin(), silent.end(), number) != 0;
    return "<h2>" + cia306::HtmlText(report.network.NameOf(model)) + "</h2><p>" +
           cia306::Hex(model.setup.normal_id, 3).substr(2U) + "h, " +
           cia306::Hex(model.setup.inverse_id, 3).substr(2U) + "h; " + (model.setup.is_late ? "late" : "early") +
           " detection; " + std::to_string(watch.PairCount()) + " pairs; " + Causes(report.analysis.CountsOf(number)) +
           "</p>" + (is_silent ? "<p class=\"bad\">no valid pair came</p>" : "") + "<div class=\"charts\">" +
           Chart("Cycle, normal to normal frame", watch.Cycle()) +
           Chart("SRVT, normal to inverse frame", watch.Srvt()) + "</div>";
}

std::string ViolationTable(const Report& report)
{
    if (report.violations.empty())
    {
        return "";
    }
    std::string rows;
    for (std::size_t row = 0U; row < std::min(report.violations.size(), kMostRows); ++row)
    {
        const Violation& violation = report.violations[row];
        rows += "<tr><td class=\"n\">" + SecondsText(violation.breach.time) + "</td><td>" +
                CauseName(violation.breach.cause) + "</td><td>" +
                cia306::HtmlText(Watchers(report.network, violation)) + "</td><td>" +
                cia306::HtmlText(violation.breach.details) + "</td></tr>";
    }
    const bool is_cut = report.analysis.ViolationCount() > kMostRows;
    return "<h2>Violations</h2>" + std::string(is_cut ? "<p>The first 2000.</p>" : "") +
           "<div class=\"scroll\"><table><tr><th class=\"n\">time [s]</th><th>cause</th><th>SRDO</th><th></th></tr>" +
           rows + "</table></div>";
}
/// What was left out, and what may be mixed.
std::string OriginText(const Report& report)
{
    const Origin& origin = report.origin;
    const std::string others = origin.other_frames == 0U ? "" : "<p>" + cia306::HtmlText(OthersText(report)) + "</p>";
    const std::string missed = HasMissed(report) ? "<p class=\"bad\">" + MissedText(report) + "</p>" : "";
    return others + missed +
           (origin.doubt.empty() ? "" : "<p class=\"bad\">" + cia306::HtmlText(origin.doubt) + "</p>");
}
} // namespace

std::string HtmlReport(const Report& report)
{
    const Analysis& analysis = report.analysis;
    const std::size_t count = analysis.ViolationCount();
    std::string sections;
    for (std::size_t number = 0U; number < report.network.Watches().size(); ++number)
    {
        sections += SrdoSection(report, number);
    }
    return std::string("<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
                       "content=\"width=device-width,initial-scale=1\"><title>SRDOs of ") +
           cia306::HtmlText(report.source) + "</title><style>" + kStyle + "</style></head><body><h1>SRDOs of " +
           cia306::HtmlText(report.source) + "</h1><p>" + std::to_string(analysis.FrameCount()) + " frames in " +
           SecondsText(analysis.Last() - analysis.First()) + " s: " +
           (count == 0U ? "<span class=\"good\">no violation</span>"
                        : "<span class=\"bad\">" + std::to_string(count) + " violations</span>") +
           "</p>" + OriginText(report) + sections + ViolationTable(report) + "</body></html>\n";
}
} // namespace counterpoint::monitor
