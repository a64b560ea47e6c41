// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/html_text.hpp"
#include "simulator/report/page_parts.hpp"
#include "simulator/report/reports.hpp"
#include "simulator/scenario/names.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

namespace counterpoint::simulator
{
namespace
{
/// Replaces {{name}} once each; what is put in is not looked at again.
std::string Filled(const std::string& page, const std::map<std::string, std::string>& parts)
{
    std::string filled;
    std::size_t place = 0U;
    while (true)
    {
        const std::size_t begin = page.find("{{", place);
        const std::size_t end = (begin == std::string::npos) ? begin : page.find("}}", begin);
        if (end == std::string::npos)
        {
            return filled + page.substr(place);
        }
        const auto part = parts.find(page.substr(begin + 2U, end - begin - 2U));
        filled += page.substr(place, begin - place) + ((part == parts.end()) ? "" : part->second);
        place = end + 2U;
    }
}

/// JSON inside a script element: nothing in it may end the element.
std::string Embedded(const nlohmann::ordered_json& document)
{
    std::string text = document.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    std::string safe;
    safe.reserve(text.size());
    for (const char character : text)
    {
        safe += (character == '<') ? std::string("\\u003c") : std::string(1U, character);
    }
    return safe;
}

std::string Gauge(const Measurement& measurement)
{
    constexpr Nanoseconds kFull = 100;
    if (measurement.elapsed < 0 || measurement.limit <= 0)
    {
        return "";
    }
    const Nanoseconds share = std::min(kFull, measurement.elapsed * kFull / measurement.limit);
    return "<span class=\"gauge\" title=\"" + std::to_string(measurement.elapsed * kFull / measurement.limit) +
           " % of the limit\"><i class=\"" + (measurement.Holds() ? "" : "over") +
           "\" style=\"width:" + std::to_string(share) + "%\"></i></span>";
}

std::string Pill(const Run& run)
{
    const bool is_timed = run.FirstMeasurement() != nullptr;
    const char* const good = is_timed ? "in time" : "as expected";
    return std::string("<span class=\"pill ") + (run.Holds() ? "good" : "bad") + "\">" +
           (run.Holds() ? good : "FAILED") + "</span>";
}

std::string Row(const Run& run, const std::size_t place)
{
    const Measurement* const measurement = run.FirstMeasurement();
    const auto cell = [](const char* style, const std::string& text)
    { return std::string("<td class=\"") + style + "\">" + text + "</td>"; };
    std::string row = "<tr data-run=\"" + std::to_string(place) + "\" tabindex=\"0\">";
    row += cell("wide", cia306::HtmlText(run.Setting().title));
    if (measurement == nullptr)
    {
        row += cell("", "") + cell("", "") + cell("num", "") + cell("num", "") + cell("", "");
    }
    else
    {
        const bool is_safe = measurement->elapsed >= 0;
        row += cell("", Words(Name(measurement->detection.party))) + cell("", Words(measurement->detection.cause));
        row += cell("num", is_safe ? MillisecondsText(measurement->elapsed) : "never");
        row += cell("num", LimitText(measurement->limit)) + cell("", Gauge(*measurement));
    }
    return row + cell("", Pill(run)) + "</tr>\n";
}

std::string Summary(const std::vector<const Run*>& runs)
{
    if (runs.size() < 2U)
    {
        return "";
    }
    std::string table =
        "<table>\n<thead><tr><th>Run</th><th>Detected by</th><th>Cause</th><th class=\"num\">Time to safe output"
        "</th><th class=\"num\">Limit</th><th>Time / limit</th><th>Verdict</th></tr></thead>\n<tbody>\n";
    for (std::size_t place = 0U; place < runs.size(); ++place)
    {
        table += Row(*runs[place], place);
    }
    return table + "</tbody>\n</table>\n";
}

/// Tables and sequences of the managers.
std::string Managers(const std::vector<const Run*>& runs)
{
    std::string text;
    for (const Run* const run : runs)
    {
        text += (run->Managed() == nullptr) ? "" : run->Managed()->Pictures();
    }
    return text;
}

std::string Lead(const std::vector<const Run*>& runs)
{
    const auto held = std::count_if(runs.begin(), runs.end(), [](const Run* run) { return run->Holds(); });
    if (runs.size() == 1U)
    {
        const Scenario& scenario = runs.front()->Setting();
        const std::string profile = scenario.profile.empty() ? "" : ", profile " + scenario.profile;
        return cia306::HtmlText(std::filesystem::path(scenario.file).filename().string()) + profile + ", seed " +
               std::to_string(scenario.seed);
    }
    return std::to_string(held) + " of " + std::to_string(runs.size()) +
           " runs as expected. Choose a row; limits are computed from each device's configuration before the run.";
}
} // namespace

std::string HtmlReport(const std::string& title, const std::vector<const Run*>& runs)
{
    nlohmann::ordered_json data{{"runs", nlohmann::ordered_json::array()}};
    for (const Run* const run : runs)
    {
        data["runs"].push_back(RunToJson(*run));
    }
    return Filled(kPageHtml, {{"title", cia306::HtmlText(title)},
                              {"lead", Lead(runs)},
                              {"style", kPageCss},
                              {"script", kPageJs},
                              {"summary", Summary(runs)},
                              {"managers", Managers(runs)},
                              {"data", Embedded(data)}});
}
} // namespace counterpoint::simulator
