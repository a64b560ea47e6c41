// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_SIMULATOR_SCENARIO_PARTS_HPP
#define VERIFICATION_SIMULATOR_SCENARIO_PARTS_HPP

#include "verification/simulator/fields.hpp"
#include "verification/simulator/scenario.hpp"

namespace counterpoint::simulator
{
/// Largest cycle count, frame count and so on in a scenario: 2^31.
inline constexpr Range kCountRange{1U, 0x7FFFFFFFU};
inline constexpr Range kSrdoRange{1U, 64U};

/// The node of that name. Throws ScenarioError.
[[nodiscard]] NodeIndex NodeNamed(const Scenario& scenario, const ScenarioValue& name);
[[nodiscard]] std::uint8_t SrdoNumber(const ScenarioValue& value);
/// One item of `faults`, `expect`.
[[nodiscard]] FaultSetup ReadFault(const Scenario& scenario, const ScenarioValue& value);
[[nodiscard]] Expectation ReadExpectation(const Scenario& scenario, const ScenarioValue& value);
} // namespace counterpoint::simulator

#endif // VERIFICATION_SIMULATOR_SCENARIO_PARTS_HPP
