// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/command_line/run.hpp"
#include "tools/command_table.hpp"

// `counterpoint` with the command `node` alone.
int main(const int count, const char* const* const arguments)
{
    return counterpoint::tools::RunProgram(
        count, arguments,
        {{"node", "Run the device of a DCF on a live CAN bus", &counterpoint::tools::MakeNodeCommand}});
}
