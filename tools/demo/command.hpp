// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_DEMO_COMMAND_HPP
#define TOOLS_DEMO_COMMAND_HPP

#include "tools/command_line/command.hpp"

#include <memory>

namespace counterpoint::tools
{
/// counterpoint demo [--html DIR|FILE] [--scenarios DIR] [--list]
[[nodiscard]] std::unique_ptr<Command> MakeDemoCommand();

inline constexpr CommandRow kDemoRow{
    "demo", "Simulate the emergency-stop chain under faults and show the timing diagrams", &MakeDemoCommand};
} // namespace counterpoint::tools

#endif // TOOLS_DEMO_COMMAND_HPP
