// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_NETWORK_PLAN_NETWORK_WARNINGS_HPP
#define CANOPEN_NETWORK_PLAN_NETWORK_WARNINGS_HPP

#include "canopen/network_plan/loaded_network.hpp"

#include <string>
#include <vector>

namespace counterpoint::network_plan
{
/// @brief What somebody wrote into a network file and would not get, a line each; what cannot work at all LoadedNetwork
/// refuses. Its setup is complete. [SRS_NET_006]
[[nodiscard]] std::vector<std::string> WarningsOf(const LoadedNetwork& network);
} // namespace counterpoint::network_plan

#endif // CANOPEN_NETWORK_PLAN_NETWORK_WARNINGS_HPP
