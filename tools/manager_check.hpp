// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_MANAGER_CHECK_HPP
#define TOOLS_MANAGER_CHECK_HPP

#include "canopen/network/loaded_network.hpp"

#include <string>
#include <vector>

namespace counterpoint::tools
{
/// @brief What differs between the network configurations of two masters of one network, a line each; nothing: they
/// are equal where they have to be. 1F90h:03 and :06 may differ, and each master has the others as slaves.
/// [SRS-MGR-009]
[[nodiscard]] std::vector<std::string> DifferencesOf(const network::LoadedNetwork& first,
                                                     const network::LoadedNetwork& second);
} // namespace counterpoint::tools

#endif // TOOLS_MANAGER_CHECK_HPP
