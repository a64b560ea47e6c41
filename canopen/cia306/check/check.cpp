// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/check/check.hpp"

#include "canopen/cia306/check/rules.hpp"
#include "canopen/cia306/check/sides.hpp"

namespace counterpoint::cia306
{
namespace
{
/// A device that takes its node-ID by LSS needs none in its file.
void CheckNodeId(const CheckContext& context, Findings& findings)
{
    const Device& device = context.device;
    const bool has_one = context.node_id || device.is_lss_supported;
    if (has_one || device.is_node_id_refused)
    {
        return;
    }
    const bool has_section = !device.commissioning_place.IsWhole();
    const Place place = has_section ? device.commissioning_place : device.device_info_place.OrBeginning();
    findings.Warning(place, "", "no node-ID",
                     "NodeID in [DeviceComissioning], --node-id, or LSS_Supported=1 in [DeviceInfo]");
}
} // namespace

std::vector<Finding> CheckDevice(const Device& device, const CheckOptions& options)
{
    const std::optional<std::uint8_t> node_id = options.node_id ? options.node_id : device.node_id;
    const SafetyConfiguration configuration = ExtractSafety(device, node_id);
    std::vector<Finding> parameter_problems;
    const DeviceParameters parameters = ReadDeviceParameters(device, node_id, parameter_problems);
    const CheckContext context{device, configuration, parameters, node_id,
                               options.granularity_bits.value_or(parameters.granularity_bits)};
    Findings findings;
    findings.Add(device.warnings);
    findings.Add(configuration.missing);
    findings.Add(configuration.problems);
    findings.Add(parameter_problems);
    for (const SrdoConfiguration& srdo : configuration.srdos)
    {
        findings.Add(srdo.signature_problems);
        findings.Add(srdo.other_problems);
        CheckCommunication(context, srdo, findings);
        CheckMapping(context, srdo, findings);
        CheckStaticMapping(context, srdo, findings);
    }
    CheckNodeId(context, findings);
    CheckMandatory(device, findings);
    CheckHighestSubs(context, findings);
    CheckKernelAccess(device, findings);
    CheckIdentifiers(configuration, findings);
    CheckShared(configuration, findings);
    findings.Add(ExchangedSides(configuration));
    CheckParameters(context, findings);
    CheckDigest(context, findings);
    CheckObjects(context, findings);
    return findings.Sorted();
}
} // namespace counterpoint::cia306
