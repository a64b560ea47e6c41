// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_MONITOR_COMMAND_HPP
#define TOOLS_MONITOR_COMMAND_HPP

#include "tools/command_line/command.hpp"

#include <memory>

namespace counterpoint::tools
{
/// `counterpoint monitor`: what the SRDOs of a recording or a live bus do. [SRS_MON_001]
[[nodiscard]] std::unique_ptr<Command> MakeMonitorCommand();
} // namespace counterpoint::tools

#endif // TOOLS_MONITOR_COMMAND_HPP
