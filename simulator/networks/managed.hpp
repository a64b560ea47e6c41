// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_NETWORKS_MANAGED_HPP
#define SIMULATOR_NETWORKS_MANAGED_HPP

#include "simulator/judge/managed.hpp"

namespace counterpoint::simulator
{
/// @brief Managers and devices of a scenario in simulated time; `scenario` and `journal` outlive it. Throws
/// cia306::InputError and YamlError. [SRS_MGR_012]
[[nodiscard]] std::unique_ptr<ManagedWorld> MakeManagedWorld(const Scenario& scenario, Journal& journal);
} // namespace counterpoint::simulator

#endif // SIMULATOR_NETWORKS_MANAGED_HPP
