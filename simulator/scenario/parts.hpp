// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_PARTS_HPP
#define SIMULATOR_SCENARIO_PARTS_HPP

#include "simulator/scenario/fields.hpp"
#include "simulator/scenario/scenario.hpp"

namespace counterpoint::simulator
{
/// The path of a file that `file` names; it is relative to `file`.
[[nodiscard]] std::string Beside(const std::string& file, const std::string& name);
/// Refuses a file that does not exist. Throws YamlError.
void RequireFile(const std::string& path, const Source& source, const std::string& expected);
/// The value of a key of a map that nothing is known of yet; nullptr: there is none.
[[nodiscard]] const runtime::YamlNode* MemberOf(const runtime::YamlNode& map, const std::string& key);
/// The items of a list, or a single value as a list of one. Throws YamlError for an empty list.
[[nodiscard]] std::vector<YamlValue> OneOrMore(const YamlValue& value, const std::string& expected);
/// Whether something is there under the profile of the scenario, by its key `profile`. Throws YamlError. [SRS_SIM_059]
[[nodiscard]] bool IsOfProfile(Fields& fields, const Scenario& scenario);
/// Reads the section `nodes` into the scenario.
void ReadNodes(const YamlValue& value, Scenario& scenario);
/// The node of that name; for a device with two CPUs the first of them. Throws YamlError.
[[nodiscard]] NodeIndex NodeNamed(const Scenario& scenario, const YamlValue& name);
/// The node-ID of the node of that name; the name may be a node-ID itself. Throws YamlError.
[[nodiscard]] std::uint8_t NodeIdNamed(const Scenario& scenario, const YamlValue& name);
/// The node-ID of a node: that of the scenario, else that of its DCF. Throws cia306::InputError.
[[nodiscard]] std::uint8_t NodeIdOf(const NodeSetup& node);
/// Whether that is the name of a device with two CPUs.
[[nodiscard]] bool IsTwoCpus(const Scenario& scenario, const YamlValue& name);
/// The node of that name where one CPU must be named. Throws YamlError.
[[nodiscard]] NodeIndex CpuNamed(const Scenario& scenario, const YamlValue& name);
/// Whether the key `node` of an item names a device with two CPUs.
[[nodiscard]] bool NamesBothCpus(const Scenario& scenario, const YamlValue& item);
/// Reads the keys of an expectation about a network.
void ReadOfNetwork(Fields& fields, const Scenario& scenario, Expectation& expectation);
/// Adds an action of its own for each controller that comes back.
void AddReturns(std::vector<Action>& actions);
// One item of `managers`, `events`, `faults` and `expect`; its place is known.
void ReadManager(Fields& fields, const Scenario& scenario, ManagerSetup& manager);
void ReadAction(Fields& fields, const Scenario& scenario, Action& action);
void ReadFault(Fields& fields, const Scenario& scenario, FaultSetup& fault);
void ReadExpectation(Fields& fields, const Scenario& scenario, Expectation& expectation);
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_PARTS_HPP
