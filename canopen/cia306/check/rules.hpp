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

/// Whether the object that one mapping entry names can be mapped. [SRS_CLI_013, SRS_CLI_015]
void CheckMappedObject(const CheckContext& context, const SrdoConfiguration& srdo, const MappingEntry& entry,
                       Findings& findings);

/// Whether two SRDOs of the device use the same identifier. [SRS_CLI_010]
void CheckIdentifiers(const SafetyConfiguration& configuration, Findings& findings);

/// 1300h, 13FEh, 13FFh, reserved indices, limits, InvertedSRAD. Comes last: 13FEh depends on the other findings.
/// [SRS_CLI_014, SRS_CLI_016, SRS_CLI_017]
void CheckObjects(const CheckContext& context, Findings& findings);

/// Whether a mapping that cannot be written keeps the rules of a static mapping. [SRS_CLI_023]
void CheckStaticMapping(const CheckContext& context, const SrdoConfiguration& srdo, Findings& findings);

/// Whether 5F04h is the digest that follows from the file. [SRS_CLI_022]
void CheckDigest(const CheckContext& context, Findings& findings);

/// Whether 5F00h to 5F03h and 5F05h have values that a device can use. [SRS_CLI_018]
void CheckParameters(const CheckContext& context, Findings& findings);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_CHECK_RULES_HPP
