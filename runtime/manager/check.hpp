// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_CHECK_HPP
#define RUNTIME_MANAGER_CHECK_HPP

#include "canopen/network_plan/loaded_network.hpp"

#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// @brief What differs between the network configurations of all masters of one network, and what each of them lacks as
/// a flying master, a line each; no line: they agree. What is compared, and what may differ:
/// cia302::CompareFlyingMasters, and what only network files say. [SRS_MGR_009]
[[nodiscard]] std::vector<std::string> DifferencesOf(const std::vector<const network_plan::LoadedNetwork*>& masters);
/// @brief What a person should know besides: the warnings of each file, a master that is mandatory for another one, and
/// a master that nobody watches. [SRS_MGR_154]
[[nodiscard]] std::vector<std::string> WarningsOf(const std::vector<const network_plan::LoadedNetwork*>& masters);
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_CHECK_HPP
