// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_CHECK_COMMAND_HPP
#define TOOLS_CHECK_COMMAND_HPP

#include "tools/command_line/command.hpp"

#include <memory>

namespace counterpoint::tools
{
/// counterpoint check FILE [--node-id N] [--granularity 1|8|16|32|64] [--json]
[[nodiscard]] std::unique_ptr<Command> MakeCheckCommand();
} // namespace counterpoint::tools

#endif // TOOLS_CHECK_COMMAND_HPP
