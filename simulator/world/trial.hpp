// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_TRIAL_HPP
#define SIMULATOR_WORLD_TRIAL_HPP

#include "canopen/cia306/text/finding.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace counterpoint::simulator
{
/// @brief A warning where the self tests of a simulated device do not fit into its diagnostic interval; nothing where
/// they do, or where the file cannot be simulated for another reason. [SRS_CLI_710]
[[nodiscard]] std::optional<cia306::Finding> TrySelfTests(const std::string& file, std::optional<std::uint8_t> node_id);
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_TRIAL_HPP
