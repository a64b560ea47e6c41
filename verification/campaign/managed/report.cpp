// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/managed/report.hpp"
#include "verification/campaign/html.hpp"
#include "verification/campaign/json_pieces.hpp"
#include "verification/campaign/statistics.hpp"

#include <cstdio>
#include <initializer_list>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace counterpoint::campaign::managed
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr double kPercent = 100.0;
constexpr double kMedian = 0.5;
constexpr double kAlmostAll = 0.999;
constexpr std::size_t kMostLines = 30U;
constexpr std::size_t kMostRows = 1000U;

[[nodiscard]] std::string Number(const std::uint64_t number)
{
    return std::to_string(number);
}

[[nodiscard]] double BoundOf(const Campaign& campaign, const Tally& tally)
{
    return UpperBound(tally.Of(Class::kSilent), tally.Effective(), campaign.plan.confidence_percent / kPercent);
}

[[nodiscard]] std::string BoundText(const Campaign& campaign, const Tally& tally)
{
    char text[32] = {};
    std::snprintf(text, sizeof(text), "%.4f %%", BoundOf(campaign, tally) * kPercent);
    return (tally.Effective() == 0U) ? "-" : text;
}

[[nodiscard]] std::string TimeText(const Tally& tally, const double part)
{
    return tally.times.empty() ? "-" : MsText(Quantile(tally.times, part));
}

/// Of a part and kind of which there is anything.
[[nodiscard]] std::vector<std::string> CellsOf(const Campaign& campaign, const Tally& tally)
{
    const auto count = [&tally](const Class wanted) { return Number(tally.Of(wanted)); };
    return {WordOf(tally.stratum->target), WordOf(tally.stratum->fault), Number(tally.Injected()),
            count(Class::kMasked),         count(Class::kBenign),        Number(tally.Effective()),
            count(Class::kDetected),       count(Class::kSafeOther),     count(Class::kListed),
            count(Class::kSilent),         BoundText(campaign, tally),   TimeText(tally, kMedian),
            TimeText(tally, 1.0)};
}

const std::vector<std::string> kHeads{"part",     "kind",   "injected", "masked",  "benign",      "effective", "told",
                                      "not told", "listed", "silent",   "at most", "median [ms]", "worst [ms]"};

[[nodiscard]] std::string TextRow(const std::vector<std::string>& cells)
{
    constexpr int kNameWidth = 18;
    constexpr int kWidth = 12;
    std::ostringstream row;
    for (std::size_t cell = 0U; cell < cells.size(); ++cell)
    {
        row << (cell < 2U ? std::left : std::right) << std::setw(cell < 2U ? kNameWidth : kWidth) << cells[cell];
    }
    return row.str() + "\n";
}

[[nodiscard]] std::string TellerLine(const Summary& summary)
{
    std::string text = "told first by:";
    for (std::size_t teller = 1U; teller < kTellerCount; ++teller)
    {
        std::uint64_t count = 0U;
        for (const Tally& tally : summary.tallies)
        {
            count += tally.tellers.at(teller);
        }
        text += (count == 0U) ? "" : std::string(" ") + WordOf(static_cast<Teller>(teller)) + " " + Number(count);
    }
    return text + "\n";
}

[[nodiscard]] std::string FindingLines(const Campaign& campaign, const char* const title,
                                       const std::vector<Finding>& findings)
{
    std::string text;
    for (std::size_t index = 0U; index < findings.size() && index < kMostLines; ++index)
    {
        const Finding& finding = findings[index];
        text += std::string(title) + ": experiment " + Number(finding.number) + ": " +
                campaign.space.PlaceText(finding.trial) + ": " + WhyOf(finding.outcome) +
                (finding.known.empty() ? "" : " (known: " + finding.known + ")") + "\n";
    }
    return text + ((findings.size() > kMostLines) ? std::string(title) + ": " + Number(findings.size() - kMostLines) +
                                                        " more, all in --html and --csv\n"
                                                  : "");
}

[[nodiscard]] Json StratumOf(const Campaign& campaign, const Tally& tally)
{
    Json found = Json::object();
    for (std::size_t teller = 1U; teller < kTellerCount; ++teller)
    {
        if (tally.tellers.at(teller) != 0U)
        {
            found[WordOf(static_cast<Teller>(teller))] = tally.tellers.at(teller);
        }
    }
    Json stratum{{"part", WordOf(tally.stratum->target)},  {"kind", WordOf(tally.stratum->fault)},
                 {"faults", tally.stratum->Size()},        {"injected", tally.Injected()},
                 {"open", tally.Of(Class::kOpen)},         {"masked", tally.Of(Class::kMasked)},
                 {"benign", tally.Of(Class::kBenign)},     {"effective", tally.Effective()},
                 {"detected", tally.Of(Class::kDetected)}, {"safe_other", tally.Of(Class::kSafeOther)},
                 {"listed", tally.Of(Class::kListed)},     {"exposed", 0U},
                 {"silent", tally.Of(Class::kSilent)}};
    stratum["silent_at_most"] = (tally.Effective() == 0U) ? Json() : Json(BoundOf(campaign, tally));
    stratum["found_by"] = found;
    const auto time = [&tally](const double part)
    { return tally.times.empty() ? Json() : Json(Quantile(tally.times, part)); };
    stratum["median_us"] = time(kMedian);
    stratum["p999_us"] = time(kAlmostAll);
    stratum["worst_us"] = time(1.0);
    stratum["limit_us"] = Json();
    stratum["late"] = 0U;
    return stratum;
}

[[nodiscard]] Json SubjectsOf(const Summary& summary)
{
    Json subjects = Json::array();
    for (const MapRow& row : summary.map)
    {
        for (std::size_t kind = 0U; kind < kFaultCount; ++kind)
        {
            const auto& cell = row.cells.at(kind);
            if (cell[0U] != 0U)
            {
                subjects.push_back({{"subject", row.name},
                                    {"kind", WordOf(static_cast<Fault>(kind))},
                                    {"injected", cell[0U]},
                                    {"effective", cell[1U]},
                                    {"silent", cell[2U]},
                                    {"exposed", 0U}});
            }
        }
    }
    return subjects;
}

[[nodiscard]] std::string FindingTable(const Campaign& campaign, const std::string& title,
                                       const std::vector<Finding>& findings)
{
    std::string text = "<h2>" + title + ": " + Number(findings.size()) + "</h2>\n";
    if (findings.empty())
    {
        return text;
    }
    text += html::Table({"experiment", "place", "ms", "reason"}, "text");
    for (std::size_t index = 0U; index < findings.size() && index < kMostRows; ++index)
    {
        const Finding& finding = findings[index];
        const std::string known = finding.known.empty() ? "" : "; known: " + finding.known;
        text += html::Row({Number(finding.number), html::Escaped(campaign.space.PlaceText(finding.trial)),
                           MsText(finding.outcome.us), html::Escaped(WhyOf(finding.outcome) + known)},
                          (finding.outcome.result == Class::kSilent && finding.known.empty()) ? "bad" : "");
    }
    return text + html::kTableEnd;
}

[[nodiscard]] std::string TellerTable(const Summary& summary)
{
    std::vector<std::string> heads{"part", "kind"};
    for (std::size_t teller = 1U; teller < kTellerCount; ++teller)
    {
        heads.emplace_back(WordOf(static_cast<Teller>(teller)));
    }
    std::string text = "<h2>Told first by</h2>" + html::Table(heads);
    for (const Tally& tally : summary.tallies)
    {
        std::vector<std::string> row{WordOf(tally.stratum->target), WordOf(tally.stratum->fault)};
        for (std::size_t teller = 1U; teller < kTellerCount; ++teller)
        {
            row.push_back(Number(tally.tellers.at(teller)));
        }
        text += (tally.stratum->taken == 0U) ? "" : html::Row(row);
    }
    return text + html::kTableEnd;
}

[[nodiscard]] std::string MapTable(const Campaign& campaign, const Summary& summary)
{
    std::vector<std::string> heads{"hit"};
    for (const Fault kind : campaign.plan.kinds)
    {
        heads.emplace_back(WordOf(kind));
    }
    std::string text = "<h2>Map</h2><p>Faults with an effect; in bold: silent ones of them. Empty: not tried.</p>" +
                       html::Table(heads, "map");
    for (const MapRow& each : summary.map)
    {
        std::vector<std::string> row{each.name};
        bool is_bad = false;
        for (const Fault kind : campaign.plan.kinds)
        {
            const auto& cell = each.cells.at(static_cast<std::size_t>(kind));
            is_bad = is_bad || cell[2U] != 0U;
            const std::string silent = (cell[2U] == 0U) ? "" : "<b>" + Number(cell[2U]) + "</b>/";
            row.push_back((cell[0U] == 0U) ? "" : silent + Number(cell[1U]));
        }
        text += html::Row(row, is_bad ? "bad" : "");
    }
    return text + html::kTableEnd;
}

[[nodiscard]] bool HoldsAll(const Summary& summary)
{
    return summary.Holds() && summary.open == 0U;
}

[[nodiscard]] std::string Problems(const Summary& summary, const std::string& before, const std::string& behind)
{
    std::string text;
    for (const std::string& name : summary.idle)
    {
        text += before + "idle: " + name + " told nothing; the plan expects it to" + behind;
    }
    for (const std::string& place : summary.stale)
    {
        text += before + "stale: nothing was found at " + place + ", which the plan calls known" + behind;
    }
    return text;
}
} // namespace

std::string TextReport(const Campaign& campaign, const Summary& summary)
{
    std::string text = campaign.plan.title + "\n\n" + TextRow(kHeads);
    for (const Tally& tally : summary.tallies)
    {
        text += (tally.stratum->Size() == 0U) ? "" : TextRow(CellsOf(campaign, tally));
    }
    text += "at most: silent share of effective faults, Clopper-Pearson, one-sided, " +
            Number(campaign.plan.confidence_percent) + " %\n" + TellerLine(summary) +
            FindingLines(campaign, "listed", summary.listed) + FindingLines(campaign, "silent", summary.silent) +
            Problems(summary, "", "\n");
    if (!summary.silent.empty() || !summary.listed.empty())
    {
        text += "time line of one: counterpoint campaign " + campaign.plan.file + " --replay EXPERIMENT\n";
    }
    if (summary.open != 0U)
    {
        text += "open: " + Number(summary.open) + " experiments were not tried\n";
    }
    return text + (HoldsAll(summary) ? "verdict: holds\n" : "verdict: does not hold\n");
}

void JsonReport(const Campaign& campaign, const Summary& summary, const cia306::TextPiece& write)
{
    Json report{{"format", "counterpoint-campaign-1"},
                {"plan", campaign.plan.file},
                {"title", campaign.plan.title},
                {"holds", HoldsAll(summary)},
                {"seed", campaign.plan.seed},
                {"confidence_percent", campaign.plan.confidence_percent},
                {"experiments", campaign.space.Size()},
                {"open", summary.open},
                {"idle", summary.idle},
                {"stale", summary.stale}};
    Json strata = Json::array();
    for (const Tally& tally : summary.tallies)
    {
        if (tally.stratum->Size() != 0U)
        {
            strata.push_back(StratumOf(campaign, tally));
        }
    }
    report["strata"] = strata;
    report["subjects"] = SubjectsOf(summary);
    const auto survivor_of = [&campaign, &summary](const std::size_t index)
    {
        const Finding& finding = summary.silent[index];
        Json survivor{{"experiment", finding.number},
                      {"class", WordOf(finding.outcome.result)},
                      {"place", campaign.space.PlaceText(finding.trial)},
                      {"kind", WordOf(finding.trial.fault)},
                      {"found_by", WordOf(static_cast<Teller>(finding.outcome.detector))},
                      {"reason", WhyOf(finding.outcome)},
                      {"us", finding.outcome.us}};
        survivor["known"] = finding.known.empty() ? Json() : Json(finding.known);
        return survivor;
    };
    WriteWithSurvivors(report, summary.silent.size(), survivor_of, write);
}

void CsvReport(const Campaign& campaign, const cia306::TextPiece& write)
{
    write("experiment,part,kind,place,class,told_by,us,reason\n");
    for (std::uint64_t index = 0U; index < campaign.results.Size(); ++index)
    {
        const Outcome outcome = campaign.results.At(index);
        if (outcome.result == Class::kOpen)
        {
            continue;
        }
        const std::uint64_t number = campaign.results.NumberAt(index);
        const Trial trial = campaign.space.At(number);
        write(Number(number) + "," + WordOf(trial.target) + "," + WordOf(trial.fault) + ",\"" +
              campaign.space.PlaceText(trial) + "\"," + WordOf(outcome.result) + "," +
              WordOf(static_cast<Teller>(outcome.detector)) + "," + Number(outcome.us) + ",\"" + WhyOf(outcome) +
              "\"\n");
    }
}

std::string HtmlReport(const Campaign& campaign, const Summary& summary)
{
    std::string text = html::Head(campaign.plan.title) +
                       (HoldsAll(summary) ? "<p class=\"good\">The verdict: <b>holds</b>.</p>\n"
                                          : "<p class=\"bad\">The verdict: <b>does not hold</b>.</p>\n") +
                       html::Escaped(Problems(summary, "", ". ")) + "<h2>Classes</h2>" + html::Table(kHeads);
    for (const Tally& tally : summary.tallies)
    {
        text += (tally.stratum->Size() == 0U)
                    ? ""
                    : html::Row(CellsOf(campaign, tally), (tally.Of(Class::kSilent) != 0U) ? "bad" : "");
    }
    text += html::kTableEnd;
    text += "<p>Seed " + Number(campaign.plan.seed) + ", " + Number(campaign.space.Size()) + " experiments, " +
            Number(summary.open) +
            " of them not tried. At most: silent share of the effective faults, Clopper-Pearson, "
            "one-sided, " +
            Number(campaign.plan.confidence_percent) + " %. The time line of one: <code>counterpoint campaign " +
            html::Escaped(campaign.plan.file) + " --replay EXPERIMENT</code></p>\n";
    return text + FindingTable(campaign, "Silent", summary.silent) +
           FindingTable(campaign, "Listed limits, one of each part and kind", summary.listed) + TellerTable(summary) +
           MapTable(campaign, summary) + "</body></html>\n";
}
} // namespace counterpoint::campaign::managed
