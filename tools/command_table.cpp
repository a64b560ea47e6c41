// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/command_table.hpp"

#include "tools/demo/command.hpp"

namespace counterpoint::tools
{
std::vector<CommandRow> CommandTable()
{
    return {
        kDemoRow,
        {"simulate", "Simulate a scenario: devices, faults, expectations", &MakeSimulateCommand},
        {"campaign", "Hit a device with a million faults and account for each of them", &MakeCampaignCommand},
        {"node", "Run the device of a DCF on a live CAN bus", &MakeNodeCommand},
        {"manager", "Manage a CANopen network on a live CAN bus: start, check, supervise its slaves",
         &MakeManagerCommand},
        {"bus", "Serve a CAN bus to other programs by the socketcand protocol", &MakeBusCommand},
        {"new", "Write the DCF of a new safety device from a few answers", &MakeNewCommand},
        {"srdo", "Add an SRDO to an EDS or DCF, remove one, or list those that it has", &MakeSrdoCommand},
        {"sign", "Compute the safety configuration signatures (13FFh) of a DCF", &MakeSignCommand},
        {"check", "Check the safety configuration of a DCF against every rule", &MakeCheckCommand},
        {"generate", "Generate the C++ object dictionary of a device from its EDS or DCF", &MakeGenerateCommand},
        {"monitor", "Watch the SRDOs of a recording or a live bus by the DCFs of its devices", &MakeMonitorCommand},
        {"completion", "Print the script by which a shell completes command lines of counterpoint",
         &MakeCompletionCommand},
        {"man", "Print the manual page of counterpoint", &MakeManCommand},
    };
}
} // namespace counterpoint::tools
