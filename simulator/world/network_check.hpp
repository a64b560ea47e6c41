// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NETWORK_CHECK_HPP
#define SIMULATOR_WORLD_NETWORK_CHECK_HPP

#include "simulator/world/world.hpp"

namespace counterpoint::simulator
{
/// @brief Compares a scenario with the DCFs of its devices: every object, SRDO and node that it names exists. Throws
/// YamlError for the first one that does not.
void RequireThatEverythingExists(const World& world);
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NETWORK_CHECK_HPP
