// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NETWORK_FILES_FLYING_HPP
#define RUNTIME_NETWORK_FILES_FLYING_HPP

#include "canopen/network_plan/network_plan.hpp"
#include "runtime/yaml/map.hpp"

#include <string>

namespace counterpoint::runtime
{
/// @brief Reads the map `flying` of a network file. Throws runtime::YamlError. [SRS_FLY_029]
[[nodiscard]] network_plan::FlyingPlan ReadFlying(const std::string& file, const runtime::YamlValue& value);
} // namespace counterpoint::runtime

#endif // RUNTIME_NETWORK_FILES_FLYING_HPP
