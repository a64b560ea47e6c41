// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_NETWORK_FILE_FLYING_HPP
#define TOOLS_NETWORK_FILE_FLYING_HPP

#include "canopen/network/network_plan.hpp"
#include "tools/yaml_map.hpp"

#include <string>

namespace counterpoint::tools
{
/// @brief The map `flying` of a network file. Throws simulator::ScenarioError. [SRS-FLY-029]
[[nodiscard]] network::FlyingPlan ReadFlying(const std::string& file, const simulator::ScenarioValue& value);
} // namespace counterpoint::tools

#endif // TOOLS_NETWORK_FILE_FLYING_HPP
