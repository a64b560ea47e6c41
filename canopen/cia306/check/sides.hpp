// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_CHECK_SIDES_HPP
#define CANOPEN_CIA306_CHECK_SIDES_HPP

#include "canopen/cia306/file/device.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace counterpoint::cia306
{
/// Objects that the InvertedSRAD of another one names, by index * 256 + sub-index, and the one that does: inverse data,
/// which no SRDO can have as normal data, whatever InvertedSRAD they have themselves. [SRS_CLI_014, SRS_NEW_730]
[[nodiscard]] std::map<std::uint32_t, const Entry*> InverseObjects(const Device& device);

/// What the mapping of an SRDO says otherwise than each InvertedSRAD of the file, in the order of the entries: inverse
/// data in the place of normal data, normal data in that of inverse data, a pair of two that do not belong together.
/// Errors of an SRDO that is on, warnings of one that is off. Neither signature nor inversion tells any of it, and the
/// application would have another value than was sent: whoever makes a device of a file asks here, as the check does.
/// [SRS_CLI_014, SRS_CLI_031, SRS_CLI_550, SRS_NODE_550]
[[nodiscard]] std::vector<Finding> WrongSides(const Device& device, const SrdoConfiguration& srdo);

/// Objects that one SRDO that is on has as normal data and another one as inverse data: errors, for the same reason.
/// [SRS_CLI_730]
[[nodiscard]] std::vector<Finding> ExchangedSides(const SafetyConfiguration& configuration);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_CHECK_SIDES_HPP
