// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_SRDO_REPORT_HPP
#define TOOLS_SRDO_REPORT_HPP

#include "canopen/cia306/file/device.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"

#include <nlohmann/json.hpp>
#include <ostream>

namespace counterpoint::tools
{
/// The SRDOs for people: one line each, and one for each pair of objects that it maps. [SRS_NEW_014]
void PrintSrdos(const cia306::Device& device, const cia306::SafetyConfiguration& configuration, std::ostream& out);
/// The same for programs.
[[nodiscard]] nlohmann::ordered_json SrdosToJson(const cia306::Device& device,
                                                 const cia306::SafetyConfiguration& configuration);
} // namespace counterpoint::tools

#endif // TOOLS_SRDO_REPORT_HPP
