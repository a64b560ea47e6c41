// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_COMMAND_TABLE_HPP
#define TOOLS_COMMAND_TABLE_HPP

#include "tools/command_line/command.hpp"

#include <memory>
#include <vector>

namespace counterpoint::tools
{
/// All commands, in the order of the help.
[[nodiscard]] std::vector<CommandRow> CommandTable();

/// counterpoint simulate SCENARIO [--html OUT] [--json OUT] [--candump OUT] [--profile PROFILE] [--seed N] [--until T]
///                       [--frames] [--quiet] [--sweep ...] [--explain]
[[nodiscard]] std::unique_ptr<Command> MakeSimulateCommand();
/// counterpoint campaign PLAN [--out RESULTS] [--html OUT] [--csv OUT] [--shard K/N] [--jobs N]
/// counterpoint campaign merge PLAN RESULTS ... [--out ALL] [--html OUT] [--csv OUT]
[[nodiscard]] std::unique_ptr<Command> MakeCampaignCommand();
/// `counterpoint node`: a device on a live bus. [SRS_NODE_001, SRS_NODE_002, SRS_NODE_003, SRS_NODE_004, SRS_NODE_005,
/// SRS_NODE_006, SRS_NODE_007, SRS_NODE_008, SRS_NODE_009, SRS_NODE_010]
[[nodiscard]] std::unique_ptr<Command> MakeNodeCommand();
/// Runs a network manager on a live bus, or compares the network files of several. [SRS_MGR_004, SRS_MGR_009,
/// SRS_MGR_123]
[[nodiscard]] std::unique_ptr<Command> MakeManagerCommand();
/// counterpoint bus [NAME=]ADDRESS ... [--listen HOST:PORT] [--seconds N] [--json]
[[nodiscard]] std::unique_ptr<Command> MakeBusCommand();
/// `counterpoint new`: the DCF of a new device. [SRS_NEW_001, SRS_NEW_002]
[[nodiscard]] std::unique_ptr<Command> MakeNewCommand();
/// counterpoint srdo add|remove|list FILE ... [SRS_NEW_010, SRS_NEW_014, SRS_NEW_015]
[[nodiscard]] std::unique_ptr<Command> MakeSrdoCommand();
/// counterpoint sign FILE [--node-id N] [--write OUT] [--verbose] [--json]
[[nodiscard]] std::unique_ptr<Command> MakeSignCommand();
/// counterpoint check FILE [--node-id N] [--granularity 1|8|16|32|64] [--json]
[[nodiscard]] std::unique_ptr<Command> MakeCheckCommand();
/// `counterpoint generate`: the C++ object dictionary of a device. [SRS_GEN_001, SRS_GEN_002, SRS_GEN_003, SRS_GEN_015]
[[nodiscard]] std::unique_ptr<Command> MakeGenerateCommand();
/// `counterpoint monitor`: what the SRDOs of a recording or a live bus do. [SRS_MON_001]
[[nodiscard]] std::unique_ptr<Command> MakeMonitorCommand();
/// counterpoint completion SHELL [SRS_EASE_003]
[[nodiscard]] std::unique_ptr<Command> MakeCompletionCommand();
/// `counterpoint man`: its manual page. [SRS_EASE_004]
[[nodiscard]] std::unique_ptr<Command> MakeManCommand();
} // namespace counterpoint::tools

#endif // TOOLS_COMMAND_TABLE_HPP
