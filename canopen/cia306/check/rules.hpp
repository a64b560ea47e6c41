// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_CHECK_RULES_HPP
#define CANOPEN_CIA306_CHECK_RULES_HPP

#include "canopen/cia306/check/check.hpp"
#include "canopen/cia306/check/findings.hpp"
#include "canopen/cia306/safety/device_parameters.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"

#include <cstdint>
#include <optional>

namespace counterpoint::cia306
{
/// What all rules look at.
struct CheckContext
{
    const Device& device;
    const SafetyConfiguration& configuration;
    const DeviceParameters& parameters;
    std::optional<std::uint8_t> node_id;
    std::uint32_t granularity_bits;
};

/// Direction, transmission type, COB-IDs and times of one SRDO. [SRS_CLI_010, SRS_CLI_011, SRS_CLI_017]
void CheckCommunication(const CheckContext& context, const SrdoConfiguration& srdo, Findings& findings);

/// Number, lengths and pairs of the mapping entries of one SRDO. [SRS_CLI_012, SRS_CLI_014]
void CheckMapping(const CheckContext& context, const SrdoConfiguration& srdo, Findings& findings);

/// What one mapping entry names. [SRS_CLI_013, SRS_CLI_015]
void CheckMappedObject(const CheckContext& context, const SrdoConfiguration& srdo, const MappingEntry& entry,
                       Findings& findings);

/// Identifiers that two SRDOs of the device use. [SRS_CLI_010]
void CheckIdentifiers(const SafetyConfiguration& configuration, Findings& findings);

/// 1300h, 13FEh, 13FFh, reserved indices, limits, InvertedSRAD. Comes last: 13FEh depends on the other findings.
/// [SRS_CLI_014, SRS_CLI_016, SRS_CLI_017]
void CheckObjects(const CheckContext& context, Findings& findings);

/// What can and cannot be written, and what a static mapping has to be. [SRS_CLI_023]
void CheckStaticMapping(const CheckContext& context, const SrdoConfiguration& srdo, Findings& findings);

/// 5F04h. [SRS_CLI_022]
void CheckDigest(const CheckContext& context, Findings& findings);

/// 5F00h to 5F03h and 5F05h. [SRS_CLI_018]
void CheckParameters(const CheckContext& context, Findings& findings);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_CHECK_RULES_HPP
