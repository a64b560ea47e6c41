// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_PARTS_HPP
#define SIMULATOR_SCENARIO_PARTS_HPP

#include "simulator/scenario/fields.hpp"
#include "simulator/scenario/scenario.hpp"

namespace counterpoint::simulator
{
/// Largest cycle count, frame count and so on in a scenario: 2^31.
inline constexpr Range kCountRange{1U, 0x7FFFFFFFU};
inline constexpr Range kSrdoRange{1U, 64U};

/// What the file `name` means that another file names.
[[nodiscard]] std::string Beside(const std::string& file, const std::string& name);
/// Refuses a file that is not there. Throws YamlError.
void RequireFile(const std::string& path, const Source& source, const std::string& expected);
/// The items of a list, or a single one. Throws YamlError for none.
[[nodiscard]] std::vector<YamlValue> OneOrMore(const YamlValue& value, const std::string& expected);
/// By the key `profile`: whether something is there under the scenario's one. Throws YamlError. [SRS_SIM_059]
[[nodiscard]] bool IsOfProfile(Fields& fields, const Scenario& scenario);
/// The section `nodes`, added to the scenario.
void ReadNodes(const YamlValue& value, Scenario& scenario);
/// The node of that name; of a device with two CPUs the first one. Throws YamlError.
[[nodiscard]] NodeIndex NodeNamed(const Scenario& scenario, const YamlValue& name);
/// The node-ID of that node, or the node-ID itself. Throws YamlError.
[[nodiscard]] std::uint8_t NodeIdNamed(const Scenario& scenario, const YamlValue& name);
/// Of a node: as the file says, else as its DCF does. Throws cia306::InputError.
[[nodiscard]] std::uint8_t NodeIdOf(const NodeSetup& node);
/// Whether that is the name of a device with two CPUs; where one of them has to be named; and of an item's `node`.
[[nodiscard]] bool IsTwoCpus(const Scenario& scenario, const YamlValue& name);
[[nodiscard]] NodeIndex CpuNamed(const Scenario& scenario, const YamlValue& name);
[[nodiscard]] bool NamesBothCpus(const Scenario& scenario, const YamlValue& item);
[[nodiscard]] std::uint8_t SrdoNumber(const YamlValue& value);
/// The keys `at`, `until`, `on` and `off`; the last two alone.
void ReadSpan(Fields& fields, FaultSetup& fault);
void ReadPattern(Fields& fields, Nanoseconds& on, Nanoseconds& off);
[[nodiscard]] std::vector<std::uint8_t> ReadBytes(const YamlValue& value, const Range& range);
/// What a fault of a node says beside its kind and name.
void ReadNodeFault(Fields& fields, const Scenario& scenario, FaultSetup& fault);
/// What a fault of the link between two CPUs says beside its kind and name.
void ReadLinkFault(Fields& fields, const Scenario& scenario, FaultSetup& fault);
/// What an expectation about a network says beside what it looks at.
void ReadOfNetwork(Fields& fields, const Scenario& scenario, Expectation& expectation);
/// A controller that comes back is an action of its own.
void AddReturns(std::vector<Action>& actions);
/// One item of `managers`, `events`, `faults`, `expect`.
[[nodiscard]] ManagerSetup ReadManager(const Scenario& scenario, const YamlValue& value);
[[nodiscard]] Action ReadAction(const Scenario& scenario, const YamlValue& value);
[[nodiscard]] FaultSetup ReadFault(const Scenario& scenario, const YamlValue& value);
[[nodiscard]] Expectation ReadExpectation(const Scenario& scenario, const YamlValue& value);
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_PARTS_HPP
