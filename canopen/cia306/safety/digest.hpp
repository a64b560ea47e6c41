// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_SAFETY_DIGEST_HPP
#define CANOPEN_CIA306_SAFETY_DIGEST_HPP

#include "canopen/cia306/safety/device_parameters.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"
#include "canopen/cia306/safety/signature.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
/// The device digest that a file has in 5F04h and the one that follows from it. [SRS_EDS_030]
struct DigestRecord
{
    bool is_present{false}; ///< 5F04h is there, and an SRDO; otherwise everything else here is empty.
    Field stored;           ///< As the file has it; no value where the file gives it none.
    std::vector<SignedField> fields;
    /// What keeps the digest from being computed; empty: everything that goes into it has a value.
    std::vector<Finding> problems;
};

/// Reads the digest of a file and what goes into it. Never throws for what the file says.
[[nodiscard]] DigestRecord ExtractDigest(const Device& device, const SafetyConfiguration& configuration,
                                         std::optional<std::uint8_t> node_id);

/// The numbers that the digest covers, for all SRDOs, in the order of SRS_CFG_034.
[[nodiscard]] std::vector<SignedField> DigestFields(const SafetyConfiguration& configuration,
                                                    const DeviceParameters& parameters, std::uint8_t node_id);

/// CRC-32 (polynomial 04C11DB7h, reflected), as computed by Boost: neither channel's code.
[[nodiscard]] std::uint32_t DigestOf(const std::vector<SignedField>& fields);

/// "0x5F04:00"
[[nodiscard]] std::string DigestName();
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_SAFETY_DIGEST_HPP
