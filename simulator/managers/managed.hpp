// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_MANAGERS_MANAGED_HPP
#define SIMULATOR_MANAGERS_MANAGED_HPP

#include "simulator/judge/managed.hpp"

namespace counterpoint::simulator
{
/// @brief Makes the managers of a scenario; they join its network. All arguments outlive them. Throws
/// cia306::InputError and YamlError. [SRS_MGR_012]
[[nodiscard]] std::unique_ptr<ManagedWorld> MakeManagedWorld(const Scenario& scenario, Journal& journal,
                                                             Network& network);
} // namespace counterpoint::simulator

#endif // SIMULATOR_MANAGERS_MANAGED_HPP
