// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/command_table.hpp"

#include "tools/check_command.hpp"
#include "tools/demo_command.hpp"
#include "tools/generate_command.hpp"
#include "tools/node_command.hpp"
#include "tools/sign_command.hpp"
#include "tools/simulate_command.hpp"

namespace counterpoint::tools
{
std::vector<CommandRow> CommandTable()
{
    return {
        {"demo", "Simulate the emergency-stop chain under faults and show the timing diagrams", &MakeDemoCommand},
        {"simulate", "Simulate a scenario: devices, faults, expectations", &MakeSimulateCommand},
        {"node", "Run the device of a DCF on a live CAN bus", &MakeNodeCommand},
        {"sign", "Compute the safety configuration signatures (13FFh) of a DCF", &MakeSignCommand},
        {"check", "Check the safety configuration of a DCF against every rule", &MakeCheckCommand},
        {"generate", "Generate the C++ object dictionary of a device from its EDS or DCF", &MakeGenerateCommand},
    };
}
} // namespace counterpoint::tools
