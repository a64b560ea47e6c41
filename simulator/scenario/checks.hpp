// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_CHECKS_HPP
#define SIMULATOR_SCENARIO_CHECKS_HPP

#include "simulator/scenario/scenario.hpp"

#include <string>
#include <vector>

namespace counterpoint::simulator
{
/// @brief Refuses a scenario that asks for something that cannot happen as it is written. Throws YamlError.
/// [SRS_SIM_014]
void RequirePossible(const Scenario& scenario);

/// Something that a scenario makes happen: when, where it is written, and what it is called.
struct Happening
{
    Nanoseconds at{0};
    Source source;
    std::string what;
};

/// @brief What begins at `end` or later, in the order of the file. [SRS_SIM_016]
[[nodiscard]] std::vector<Happening> HappeningsFrom(const Scenario& scenario, Nanoseconds end);
/// @brief Acknowledges, NMT commands and GFC for a device that has no supply then, as far as the scenario tells. Throws
/// YamlError for supply events of one device that do not fit together. [SRS_SIM_065, SRS_SIM_066]
[[nodiscard]] std::vector<Happening> UnheardIn(const Scenario& scenario);
/// @brief Refuses them where the scenario's own file has them. Throws YamlError.
void RequireSupply(const Scenario& scenario);
/// @brief Refuses what does not fit together in a network with managers. Throws YamlError and cia306::InputError.
void RequireNetwork(const Scenario& scenario);
/// @brief Refuses what the scenario's own file lets begin after its end, and faults that come and go too often. Throws
/// YamlError.
void RequireHappening(const Scenario& scenario);
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_CHECKS_HPP
