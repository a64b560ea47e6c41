// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/contradictions.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>
#include <cstddef>

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
    }
    const std::vector<Contradiction> compared = cia306::ContradictionsOf(ends);
    found.insert(found.end(), compared.begin(), compared.end());
    return found;
}
} // namespace counterpoint::monitor
