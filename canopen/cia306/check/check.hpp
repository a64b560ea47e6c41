// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_CHECK_CHECK_HPP
#define CANOPEN_CIA306_CHECK_CHECK_HPP

#include "canopen/cia306/file/device.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace counterpoint::cia306
{
/// What the command line says about a check.
struct CheckOptions
{
    std::optional<std::uint8_t> node_id;
    std::optional<std::uint8_t> granularity_bits; ///< 1, 8, 16, 32 or 64, checked by the caller; else that of the file.
};

/// Everything that is wrong with the safety configuration of the device, the reader's warnings included, in the order
/// of the lines. Never throws for what the file says. [SRS_CLI_009, SRS_CLI_010, SRS_CLI_011, SRS_CLI_012, SRS_CLI_013,
/// SRS_CLI_014, SRS_CLI_015, SRS_CLI_016, SRS_CLI_017, SRS_CLI_018, SRS_CLI_036]
[[nodiscard]] std::vector<Finding> CheckDevice(const Device& device, const CheckOptions& options);

/// What is said of 13FEh in a file with errors, whoever found them: nothing where it is not A5h. [SRS_CLI_491]
[[nodiscard]] std::optional<Finding> ValidInSpiteOfErrors(const SafetyConfiguration& configuration);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_CHECK_CHECK_HPP
