// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_SIMULATOR_SCENARIO_CHECKS_HPP
#define VERIFICATION_SIMULATOR_SCENARIO_CHECKS_HPP

#include "verification/simulator/scenario.hpp"

namespace counterpoint::simulator
{
/// @brief Refuses a whole scenario that asks for what cannot happen as it is written. Throws ScenarioError.
/// [SRS-SIM-014]
void RequirePossible(const Scenario& scenario);
} // namespace counterpoint::simulator

#endif // VERIFICATION_SIMULATOR_SCENARIO_CHECKS_HPP
