// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_TEXT_FINDING_HPP
#define CANOPEN_CIA306_TEXT_FINDING_HPP

#include "canopen/cia306/text/place.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
/// Whether a file cannot be used because of a finding.
enum class Severity : std::uint8_t
{
    kError = 1U,
    kWarning = 2U,
};

/// One thing that is wrong with a file, or that its author may not have meant.
struct Finding
{
    Severity severity{Severity::kError};
    Place place;
    std::string object; ///< "0x1301:02", or empty where no object is concerned.
    std::string text;   ///< What is wrong, and what was expected.
};

/// In the order of the lines; findings of one line stay in their order.
[[nodiscard]] std::vector<Finding> SortedByLine(std::vector<Finding> findings);

/// Each finding once, where equal ones stand one behind the other.
[[nodiscard]] std::vector<Finding> WithoutRepeated(std::vector<Finding> findings);

/// The finding as a line: FILE:LINE:COLUMN: error|warning: OBJECT: TEXT
[[nodiscard]] std::string FormatFinding(const std::string& file, const Finding& finding);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_TEXT_FINDING_HPP
