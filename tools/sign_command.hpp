// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_SIGN_COMMAND_HPP
#define TOOLS_SIGN_COMMAND_HPP

#include "tools/command_line/command.hpp"

#include <memory>

namespace counterpoint::tools
{
/// counterpoint sign FILE [--node-id N] [--write OUT] [--verbose] [--json]
[[nodiscard]] std::unique_ptr<Command> MakeSignCommand();
} // namespace counterpoint::tools

#endif // TOOLS_SIGN_COMMAND_HPP
