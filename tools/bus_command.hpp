// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_BUS_COMMAND_HPP
#define TOOLS_BUS_COMMAND_HPP

#include "tools/command_line/command.hpp"

#include <memory>

namespace counterpoint::tools
{
/// counterpoint bus [NAME=]ADDRESS ... [--listen HOST:PORT] [--seconds N] [--json]
[[nodiscard]] std::unique_ptr<Command> MakeBusCommand();
} // namespace counterpoint::tools

#endif // TOOLS_BUS_COMMAND_HPP
