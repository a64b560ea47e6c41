// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/judge/sweep.hpp"

#include "simulator/judge/run.hpp"
#include "simulator/scenario/names.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <ostream>

namespace counterpoint::simulator
{
namespace
{
using Json = nlohmann::ordered_json;

/// The next combination, the last axis first; false: there is none.
bool Advance(std::vector<std::size_t>& places, const std::vector<SweepAxis>& axes)
{
    for (std::size_t axis = axes.size(); axis > 0U; --axis)
    {
        ++places[axis - 1U];
        if (places[axis - 1U] < axes[axis - 1U].values.size())
        {
            return true;
        }
        places[axis - 1U] = 0U;
    }
    return false;
}

SweepRow RunOne(const Scenario& scenario, const SweepOptions& options, std::vector<std::size_t> places)
{
    Run run(scenario, options.until, false, options.make);
    run.Simulate(nullptr);
    SweepRow row;
    row.places = std::move(places);
    row.holds = run.Holds();
    if (const Measurement* const measurement = run.FirstMeasurement())
    {
        row.measurement = *measurement;
    }
    for (const ExpectationVerdict& verdict : run.Verdicts())
    {
        if (!verdict.holds && row.failure.empty())
        {
            row.failure = verdict.wanted + ": " + verdict.seen;
        }
    }
    return row;
}

std::size_t CountOf(const std::vector<SweepAxis>& axes)
{
    std::size_t count = 1U;
    for (const SweepAxis& axis : axes)
    {
        count *= axis.values.size();
        if (count > kMostSweepRuns)
        {
            throw YamlError("--sweep", {}, "more than " + std::to_string(kMostSweepRuns) + " runs", "larger steps");
        }
    }
    return count;
}

/// Each row is the run that its cells name: nothing else sets what an axis sets.
void RequireEffects(const std::vector<SweepAxis>& axes, const SweepOptions& options)
{
    std::vector<std::string> taken;
    if (options.seed)
    {
        taken.emplace_back("seed");
    }
    if (options.until)
    {
        taken.emplace_back("duration");
    }
    for (const SweepAxis& axis : axes)
    {
        if (std::find(taken.begin(), taken.end(), axis.path) != taken.end())
        {
            throw YamlError("--sweep", {}, axis.path + " twice, by '--sweep', '--seed' or '--until'", "each key once");
        }
        taken.push_back(axis.path);
    }
}

std::string TimeText(const Nanoseconds time, const char* const none)
{
    return (time < 0) ? none : MillisecondsText(time);
}

/// The cells of one row of the table.
std::vector<std::string> CellsOf(const SweepResult& result, const SweepRow& row)
{
    std::vector<std::string> cells;
    for (std::size_t axis = 0U; axis < result.axes.size(); ++axis)
    {
        cells.push_back(result.axes[axis].Text(row.places[axis]));
    }
    if (row.measurement)
    {
        const Measurement& measurement = *row.measurement;
        cells.push_back(Words(Name(measurement.detection.party)));
        cells.push_back(measurement.detection.cause.empty() ? "-" : Words(measurement.detection.cause));
        cells.push_back(TimeText(row.DetectionTime(), "-"));
        cells.push_back(TimeText(measurement.elapsed, "never"));
        cells.push_back(LimitText(measurement.limit));
    }
    else
    {
        cells.insert(cells.end(), {"-", "-", "-", "-", "-"});
    }
    cells.push_back(row.holds ? "holds" : "FAILED  " + row.failure);
    return cells;
}

void WriteCells(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths, std::ostream& out)
{
    for (std::size_t column = 0U; column < cells.size(); ++column)
    {
        const bool is_last = column + 1U == cells.size();
        out << cells[column] << (is_last ? "\n" : std::string(widths[column] - cells[column].size() + 2U, ' '));
    }
}
} // namespace

Nanoseconds SweepRow::DetectionTime() const noexcept
{
    const bool is_known = measurement && measurement->detection.at >= 0 && measurement->effect >= 0;
    return is_known ? measurement->detection.at - measurement->effect : -1;
}

bool SweepResult::Holds() const noexcept
{
    return std::all_of(rows.begin(), rows.end(), [](const SweepRow& row) { return row.holds; });
}

const SweepRow* SweepResult::Worst() const noexcept
{
    const SweepRow* worst = nullptr;
    for (const SweepRow& row : rows)
    {
        const bool is_measured = row.measurement && row.measurement->elapsed >= 0;
        const bool is_worse =
            is_measured && (worst == nullptr || row.measurement->elapsed - row.measurement->limit >
                                                    worst->measurement->elapsed - worst->measurement->limit);
        worst = is_worse ? &row : worst;
    }
    return worst;
}

SweepResult RunSweep(const std::string& file, const std::vector<SweepAxis>& axes, const SweepOptions& options,
                     const std::function<void(double)>& progress)
{
    RequireEffects(axes, options);
    const std::vector<ScenarioDocument> documents = LoadScenario(file);
    const std::size_t count = CountOf(axes);
    SweepResult result;
    result.scenario = std::filesystem::path(file).filename().string();
    result.axes = axes;
    std::vector<std::size_t> places(axes.size(), 0U);
    do
    {
        std::vector<ScenarioDocument> changed = documents;
        for (std::size_t axis = 0U; axis < axes.size(); ++axis)
        {
            SetByPath(changed, axes[axis].path, axes[axis].Text(places[axis]));
        }
        Scenario scenario = ReadScenario(changed, options.profile);
        scenario.seed = options.seed.value_or(scenario.seed);
        result.title = scenario.title;
        result.profile = scenario.profile;
        result.rows.push_back(RunOne(scenario, options, places));
        if (progress)
        {
            progress(static_cast<double>(result.rows.size()) / static_cast<double>(count));
        }
    } while (Advance(places, axes));
    return result;
}

void WriteSweepTable(const SweepResult& result, std::ostream& out)
{
    std::vector<std::vector<std::string>> table(1U);
    for (const SweepAxis& axis : result.axes)
    {
        table.front().push_back(axis.path);
    }
    table.front().insert(table.front().end(), {"detected by", "cause", "detection", "safe after", "limit", "verdict"});
    for (const SweepRow& row : result.rows)
    {
        table.push_back(CellsOf(result, row));
    }
    std::vector<std::size_t> widths(table.front().size(), 0U);
    for (const std::vector<std::string>& cells : table)
    {
        for (std::size_t column = 0U; column < cells.size(); ++column)
        {
            widths[column] = std::max(widths[column], cells[column].size());
        }
    }
    out << result.title << (result.title.empty() ? "" : "\n");
    for (const std::vector<std::string>& cells : table)
    {
        WriteCells(cells, widths, out);
    }
    const auto held =
        std::count_if(result.rows.begin(), result.rows.end(), [](const SweepRow& row) { return row.holds; });
    out << held << " of " << result.rows.size() << " runs hold";
    if (const SweepRow* const worst = result.Worst())
    {
        out << "; nearest to its limit: " << MillisecondsText(worst->measurement->elapsed) << " of "
            << MillisecondsText(worst->measurement->limit) << " at " << result.axes.front().Text(worst->places.front());
    }
    out << "\n";
}

std::string SweepJson(const SweepResult& result)
{
    const auto time = [](const Nanoseconds at) { return (at < 0) ? Json() : Json(at); };
    Json rows = Json::array();
    for (const SweepRow& row : result.rows)
    {
        Json values = Json::object();
        for (std::size_t axis = 0U; axis < result.axes.size(); ++axis)
        {
            const SweepAxis& swept = result.axes[axis];
            const std::int64_t value = swept.values[row.places[axis]];
            constexpr auto unit = static_cast<double>(kNanosecondsPerMillisecond);
            values[swept.path] = swept.is_time ? Json(static_cast<double>(value) / unit) : Json(value);
        }
        Json json{{"values", values}, {"holds", row.holds}};
        if (row.measurement)
        {
            json["detected_by"] = Name(row.measurement->detection.party);
            json["cause"] = row.measurement->detection.cause;
            json["effect_ns"] = time(row.measurement->effect);
            json["detection_ns"] = time(row.DetectionTime());
            json["elapsed_ns"] = time(row.measurement->elapsed);
            json["limit_ns"] = row.measurement->limit;
            json["limit_class"] = Name(row.measurement->fault_class);
        }
        if (!row.holds)
        {
            json["failure"] = row.failure;
        }
        rows.push_back(std::move(json));
    }
    Json axes = Json::array();
    for (const SweepAxis& axis : result.axes)
    {
        axes.push_back({{"path", axis.path}, {"unit", axis.is_time ? "ms" : ""}, {"count", axis.values.size()}});
    }
    const Json document{{"format", "counterpoint-sweep-1"},
                        {"scenario", result.scenario},
                        {"title", result.title},
                        {"profile", result.profile.empty() ? Json() : Json(result.profile)},
                        {"holds", result.Holds()},
                        {"axes", axes},
                        {"runs", rows}};
    return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}
} // namespace counterpoint::simulator
