// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_MANAGER_COMMAND_HPP
#define TOOLS_MANAGER_COMMAND_HPP

#include "tools/command_line/command.hpp"

namespace counterpoint::tools
{
/// Runs a network manager on a live bus, or compares the network files of several. [SRS_MGR_004, SRS_MGR_009]
[[nodiscard]] std::unique_ptr<Command> MakeManagerCommand();
} // namespace counterpoint::tools

#endif // TOOLS_MANAGER_COMMAND_HPP
