// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_SIMULATE_NETWORK_HPP
#define TOOLS_SIMULATE_NETWORK_HPP

#include "tools/command_line/command.hpp"

#include <string>

namespace counterpoint::tools
{
/// What `simulate` may be asked for a network scenario.
struct NetworkOptions
{
    std::string html;    ///< Page of the first manager; empty: none.
    std::string json;    ///< Events and verdicts; empty: none.
    std::string candump; ///< Frames of the bus; empty: none.
    bool is_quiet{false};
};

/// @brief Simulates a scenario with managers and says whether all its expectations hold. Throws
/// runtime::YamlError and cia306::InputError. [SRS_MGR_012]
[[nodiscard]] ExitStatus SimulateNetwork(const std::string& path, const NetworkOptions& options,
                                         const Streams& streams);
} // namespace counterpoint::tools

#endif // TOOLS_SIMULATE_NETWORK_HPP
