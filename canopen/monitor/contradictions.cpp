// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/contradictions.hpp"

#include "canopen/cia306/safety/signature.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace counterpoint::monitor
{
namespace
{
using cia306::SrdoConfiguration;

/// A file that sets SRDOs up and does not declare them valid. [SRS_MON_021]
void TellInactive(const NodeModel& node, std::vector<Contradiction>& found)
{
    const auto& srdos = node.safety.srdos;
    const auto on = std::find_if(srdos.begin(), srdos.end(), [](const SrdoConfiguration& srdo) { return srdo.IsOn(); });
    if (on == srdos.end() || !node.active.empty())
    {
        return;
    }
    const cia306::Field& valid = node.safety.configuration_valid;
    const std::string what = valid.value ? cia306::Hex(*valid.value, 2) + ", so" : "is missing, so";
    found.push_back({node.device.file,
                     {cia306::Severity::kWarning, valid.value ? valid.place : on->place,
                      cia306::ObjectName(cia306::kConfigurationValidIndex, 0U),
                      what + " that no SRDO of " + node.name +
                          " is active and none is watched, expected 0xA5 where the device was declared valid"}});
}

/// An SRDO whose signature is that of other parameters: no device takes the file as it is. The network has refused
/// files whose signature cannot be computed; one without a signature says nothing that could contradict. [SRS_MON_400]
void TellForeignSignatures(const NodeModel& node, std::vector<Contradiction>& found)
{
    for (const SrdoConfiguration& srdo : node.active)
    {
        const std::uint16_t computed = cia306::SignatureOf(srdo);
        if (!srdo.signature.value || srdo.signature.Is(computed))
        {
            continue;
        }
        found.push_back(
            {node.device.file,
             {cia306::Severity::kWarning, srdo.signature.place,
              cia306::ObjectName(cia306::kSignatureIndex, srdo.number),
              "signature " + cia306::Hex(*srdo.signature.value, 4) + " of SRDO " + std::to_string(srdo.number) +
                  " of " + node.name + ", expected " + cia306::Hex(computed, 4) +
                  ": a device refuses this file, so that the one on the bus may have another"}});
    }
}
} // namespace

std::vector<Contradiction> ContradictionsOf(const Network& network)
{
    std::vector<cia306::SrdoEnd> ends;
    std::vector<Contradiction> found;
    for (std::size_t node = 0U; node < network.Nodes().size(); ++node)
    {
        const NodeModel& model = network.Nodes()[node];
        for (const SrdoConfiguration& srdo : model.active)
        {
            ends.push_back({node, model.name, model.device.file, &srdo});
        }
        TellInactive(model, found);
        TellForeignSignatures(model, found);
    }
    const std::vector<Contradiction> compared = cia306::ContradictionsOf(ends);
    found.insert(found.end(), compared.begin(), compared.end());
    return found;
}
} // namespace counterpoint::monitor
