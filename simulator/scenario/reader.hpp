// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_READER_HPP
#define SIMULATOR_SCENARIO_READER_HPP

#include "simulator/scenario/scenario.hpp"

#include <string>
#include <vector>

namespace counterpoint::simulator
{
/// One file of a scenario, parsed.
struct ScenarioDocument
{
    std::string file;
    runtime::YamlNode root;
    bool is_base{false}; ///< It is extended by the other one.
};

/// The file and the one that it extends, which comes first. Throws YamlError. [SRS_SIM_013]
[[nodiscard]] std::vector<ScenarioDocument> LoadScenario(const std::string& file);
/// The scenario of these files. `profile`: a start-up profile instead of the first one that the scenario is written
/// for. Throws YamlError.
[[nodiscard]] Scenario ReadScenario(const std::vector<ScenarioDocument>& documents, const std::string& profile = {});
/// All files that a run of the scenario reads: its own and the DCFs of its nodes, whether or not the scenario is right
/// otherwise.
[[nodiscard]] std::vector<std::string> FilesOf(const std::vector<ScenarioDocument>& documents);
/// The network files of its managers; they name other files.
[[nodiscard]] std::vector<std::string> NetworkFilesOf(const std::vector<ScenarioDocument>& documents);

/// The scenario in `file`, with what it extends. Whether objects and SRDOs exist is known only with the DCFs: see
/// simulator/world/network.hpp. Throws YamlError. [SRS_SIM_010, SRS_SIM_011, SRS_SIM_012, SRS_SIM_013]
[[nodiscard]] Scenario ReadScenario(const std::string& file, const std::string& profile = {});

/// Reads a time with its unit that does not come from a file; `place` stands for the file in messages. Throws
/// YamlError.
[[nodiscard]] Nanoseconds ParseDuration(const std::string& place, const std::string& text);
/// Reads a seed likewise. Throws YamlError.
[[nodiscard]] std::uint64_t ParseSeed(const std::string& place, const std::string& text);
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_READER_HPP
