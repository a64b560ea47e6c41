// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NETWORK_FILES_FILE_HPP
#define RUNTIME_NETWORK_FILES_FILE_HPP

#include "canopen/network_plan/network_plan.hpp"

#include <cstdint>
#include <string>

namespace counterpoint::runtime
{
/// @brief Reads a network file: CPJ where its name ends in .cpj, else YAML (docs/manager.md). `manager`: the node-ID of
/// the manager instead of the file's; 0: none given. `profile`: the word of a start-up profile instead of the file's.
/// Throws cia306::InputError and runtime::YamlError. [SRS_NET_001, SRS_NET_002, SRS_NET_004]
[[nodiscard]] network_plan::NetworkPlan ReadNetworkFile(const std::string& path, std::uint8_t manager,
                                                        const std::string& profile = {});
} // namespace counterpoint::runtime

#endif // RUNTIME_NETWORK_FILES_FILE_HPP
