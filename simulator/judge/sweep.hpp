// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_JUDGE_SWEEP_HPP
#define SIMULATOR_JUDGE_SWEEP_HPP

#include "simulator/judge/managed.hpp"
#include "simulator/judge/verdicts.hpp"
#include "simulator/scenario/reader.hpp"

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
/// One key of a scenario and the values that it takes.
struct SweepAxis
{
    std::string path; ///< faults.NAME.at, duration, nodes.sensor.counter_a.ppm: keys, names or numbers from 0, joined
                      ///< by points.
    bool is_time{false};
    bool is_hexadecimal{false};       ///< FROM was written so.
    std::vector<std::int64_t> values; ///< Nanoseconds, or plain numbers.

    /// @brief One of the values, as it stands in a scenario.
    [[nodiscard]] std::string Text(std::size_t place) const;
};

constexpr std::size_t kMostSweepRuns = 20000U;

/// @brief From "NAME=FROM:TO:STEP". Throws YamlError. [SRS_SIM_050]
[[nodiscard]] SweepAxis ParseSweepAxis(const std::string& text);
/// @brief Sets the key at `path` to `value`; a key of a map that is not there is added. Throws YamlError.
void SetByPath(std::vector<ScenarioDocument>& documents, const std::string& path, const std::string& value);

/// One run of a sweep.
struct SweepRow
{
    std::vector<std::size_t> places; ///< Into the values of each axis.
    std::optional<Measurement> measurement;
    bool holds{false};
    std::string failure; ///< The first expectation that did not come; "" if all did.

    /// @brief Time from the first effect to its detection; -1: it was not detected.
    [[nodiscard]] Nanoseconds DetectionTime() const noexcept;
};

/// All runs of a sweep.
struct SweepResult
{
    std::string scenario; ///< File name without folder.
    std::string title;
    std::string profile; ///< Start-up profile of the managers; empty: the scenario has none.
    std::vector<SweepAxis> axes;
    std::vector<SweepRow> rows;

    /// @brief Whether every run holds.
    [[nodiscard]] bool Holds() const noexcept;
    /// @brief The run that comes nearest to its limit; null: nothing was measured.
    [[nodiscard]] const SweepRow* Worst() const noexcept;
};

/// What the command line says about the runs.
struct SweepOptions
{
    std::optional<std::uint64_t> seed;
    std::optional<Nanoseconds> until;
    MakeManaged make;    ///< Of scenarios with managers.
    std::string profile; ///< Empty: the scenario's first one.
};

/// @brief Runs the scenario for each combination of values. `progress` is told which part of the runs, from 0 to 1, is
/// done. Throws YamlError and cia306::InputError.
[[nodiscard]] SweepResult RunSweep(const std::string& file, const std::vector<SweepAxis>& axes,
                                   const SweepOptions& options, const std::function<void(double)>& progress);

/// @brief Writes a row for each run. [SRS_SIM_050, SRS_SIM_051]
void WriteSweepTable(const SweepResult& result, std::ostream& out);
/// @brief The runs as JSON.
[[nodiscard]] std::string SweepJson(const SweepResult& result);
/// @brief The runs as a page with a diagram.
[[nodiscard]] std::string SweepHtml(const SweepResult& result);
} // namespace counterpoint::simulator

#endif // SIMULATOR_JUDGE_SWEEP_HPP
