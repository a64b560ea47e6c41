// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_PARTS_HPP
#define SIMULATOR_SCENARIO_PARTS_HPP

#include "simulator/scenario/fields.hpp"
#include "simulator/scenario/scenario.hpp"

namespace counterpoint::simulator
{
/// Range of counts in a scenario, such as the n-th frame.
inline constexpr Range kCountRange{1U, 0x7FFFFFFFU};
inline constexpr Range kSrdoRange{1U, 64U};

/// The path of a file that `file` names; it is relative to `file`.
[[nodiscard]] std::string Beside(const std::string& file, const std::string& name);
/// Refuses a file that does not exist. Throws YamlError.
void RequireFile(const std::string& path, const Source& source, const std::string& expected);
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
/// The number of an SRDO, 1 to 64.
[[nodiscard]] std::uint8_t SrdoNumber(const YamlValue& value);
/// Reads the keys `at`, `until`, `on` and `off`.
void ReadSpan(Fields& fields, FaultSetup& fault);
/// Reads the keys `on` and `off`.
void ReadPattern(Fields& fields, Nanoseconds& on, Nanoseconds& off);
/// Reads a list of numbers, each within `range`, as bytes.
[[nodiscard]] std::vector<std::uint8_t> ReadBytes(const YamlValue& value, const Range& range);
/// Reads the keys of a fault of a node, beside kind and name.
void ReadNodeFault(Fields& fields, const Scenario& scenario, FaultSetup& fault);
/// Reads the keys of a fault of the link between two CPUs, beside kind and name.
void ReadLinkFault(Fields& fields, const Scenario& scenario, FaultSetup& fault);
/// Reads the keys of an expectation about a network.
void ReadOfNetwork(Fields& fields, const Scenario& scenario, Expectation& expectation);
/// Adds an action of its own for each controller that comes back.
void AddReturns(std::vector<Action>& actions);
/// Reads one item of `managers`.
[[nodiscard]] ManagerSetup ReadManager(const Scenario& scenario, const YamlValue& value);
/// Reads one item of `events`.
[[nodiscard]] Action ReadAction(const Scenario& scenario, const YamlValue& value);
/// Reads one item of `faults`.
[[nodiscard]] FaultSetup ReadFault(const Scenario& scenario, const YamlValue& value);
/// Reads one item of `expect`.
[[nodiscard]] Expectation ReadExpectation(const Scenario& scenario, const YamlValue& value);
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_PARTS_HPP
