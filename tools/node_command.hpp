// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_NODE_COMMAND_HPP
#define TOOLS_NODE_COMMAND_HPP

#include "tools/command_line/command.hpp"

#include <memory>

namespace counterpoint::tools
{
/// `counterpoint node`: a device on a live bus. [SRS_NODE_001, SRS_NODE_002, SRS_NODE_003, SRS_NODE_004, SRS_NODE_005,
/// SRS_NODE_006, SRS_NODE_007, SRS_NODE_008, SRS_NODE_009, SRS_NODE_010]
[[nodiscard]] std::unique_ptr<Command> MakeNodeCommand();
} // namespace counterpoint::tools

#endif // TOOLS_NODE_COMMAND_HPP
