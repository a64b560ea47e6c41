// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_NODE_COMMAND_HPP
#define TOOLS_NODE_COMMAND_HPP

#include "tools/command.hpp"

#include <memory>

namespace counterpoint::tools
{
/// `counterpoint node`: a device on a live bus. [SRS-NODE-001..010]
[[nodiscard]] std::unique_ptr<Command> MakeNodeCommand();
} // namespace counterpoint::tools

#endif // TOOLS_NODE_COMMAND_HPP
