// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_GENERATE_COMMAND_HPP
#define TOOLS_GENERATE_COMMAND_HPP

#include "tools/command_line/command.hpp"

#include <memory>

namespace counterpoint::tools
{
/// `counterpoint generate`: the C++ object dictionary of a device. [SRS_GEN_001, SRS_GEN_002, SRS_GEN_003, SRS_GEN_015]
[[nodiscard]] std::unique_ptr<Command> MakeGenerateCommand();
} // namespace counterpoint::tools

#endif // TOOLS_GENERATE_COMMAND_HPP
