// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_NETWORK_PLAN_NETWORK_WARNINGS_HPP
#define CANOPEN_NETWORK_PLAN_NETWORK_WARNINGS_HPP

#include "canopen/network_plan/loaded_network.hpp"

#include <string>
#include <vector>

namespace counterpoint::network_plan
{
/// @brief What a network file asks for without effect, a line each. What cannot work at all is refused by
/// LoadedNetwork. `network` is complete. [SRS_NET_006]
[[nodiscard]] std::vector<std::string> WarningsOf(const LoadedNetwork& network);
} // namespace counterpoint::network_plan

#endif // CANOPEN_NETWORK_PLAN_NETWORK_WARNINGS_HPP
