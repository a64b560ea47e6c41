// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_READER_HPP
#define SIMULATOR_SCENARIO_READER_HPP

#include "simulator/scenario/scenario.hpp"

#include <string>
#include <vector>

namespace counterpoint::simulator
{
/// One file of a scenario as it stands there.
struct ScenarioDocument
{
    std::string file;
    runtime::YamlNode root;
    bool is_base{false}; ///< It is extended by the other one.
};

/// The file and what it extends, which comes first. Throws YamlError. [SRS_SIM_013]
[[nodiscard]] std::vector<ScenarioDocument> LoadScenario(const std::string& file);
/// `profile`: the start-up profile instead of the first one that the scenario is written for.
[[nodiscard]] Scenario ReadScenario(const std::vector<ScenarioDocument>& documents, const std::string& profile = {});
/// All files that a run of the scenario reads: its own and the DCFs of its nodes, whether or not it is right otherwise.
[[nodiscard]] std::vector<std::string> FilesOf(const std::vector<ScenarioDocument>& documents);
/// The network files of its managers, which name other files.
[[nodiscard]] std::vector<std::string> NetworkFilesOf(const std::vector<ScenarioDocument>& documents);

/// The scenario in `file`, with what it extends. Whether objects and SRDOs exist is known only with the DCFs: see
/// network.hpp. Throws YamlError. [SRS_SIM_010, SRS_SIM_011, SRS_SIM_012, SRS_SIM_013]
[[nodiscard]] Scenario ReadScenario(const std::string& file, const std::string& profile = {});

/// A time with its unit that did not come from a file; `place` stands for the file in a message. Throws YamlError.
[[nodiscard]] Nanoseconds ParseDuration(const std::string& place, const std::string& text);
/// The same for a seed.
[[nodiscard]] std::uint64_t ParseSeed(const std::string& place, const std::string& text);
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_READER_HPP
