// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_FILE_LIMITS_HPP
#define CANOPEN_CIA306_FILE_LIMITS_HPP

#include "canopen/cia306/file/device.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace counterpoint::cia306
{
/// Warns of a LowLimit above the HighLimit, and of the value of an object that is no safety object and an integer
/// outside of them. [SRS_EDS_038, SRS_EDS_045]
void WarnOfLimits(const Entry& entry, std::optional<std::uint8_t> node_id, std::vector<Finding>& warnings);

/// Unsigned values of safety objects outside of their limits, and limits there that are no values, as errors: no
/// command takes such a file. [SRS_CLI_017, SRS_EDS_045]
[[nodiscard]] std::vector<Finding> LimitProblems(const Device& device, std::optional<std::uint8_t> node_id);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_FILE_LIMITS_HPP
