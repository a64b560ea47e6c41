// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_SIMULATE_COMMAND_HPP
#define TOOLS_SIMULATE_COMMAND_HPP

#include "tools/command_line/command.hpp"

#include <memory>

namespace counterpoint::tools
{
/// counterpoint simulate SCENARIO [--html OUT] [--json OUT] [--candump OUT] [--profile PROFILE] [--seed N] [--until T]
///                       [--frames] [--quiet] [--sweep ...] [--explain]
[[nodiscard]] std::unique_ptr<Command> MakeSimulateCommand();
} // namespace counterpoint::tools

#endif // TOOLS_SIMULATE_COMMAND_HPP
