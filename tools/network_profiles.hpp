// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_NETWORK_PROFILES_HPP
#define TOOLS_NETWORK_PROFILES_HPP

#include "canopen/start_up/el6751/setup.hpp"
#include "canopen/start_up/plc_designer/setup.hpp"
#include "canopen/network/network_plan.hpp"
#include "verification/simulator/fields.hpp"

#include <string>
#include <vector>

namespace counterpoint::tools
{
/// @brief Options of a slave under "el6751" of a network file. Throws simulator::ScenarioError. [SRS-ELM-051]
[[nodiscard]] cia302::El6751Slave ReadEl6751Slave(const std::string& file, const simulator::ScenarioValue& value);
/// @brief Options of the manager under "el6751". Throws simulator::ScenarioError. [SRS-ELM-051]
[[nodiscard]] cia302::El6751Times ReadEl6751Times(const std::string& file, const simulator::ScenarioValue& value);
/// @brief What RxPDOs carry, a list under "outputs" of a slave. Throws simulator::ScenarioError. [SRS-MGR-022]
[[nodiscard]] std::vector<network::OutputPlan> ReadOutputs(const std::string& file,
                                                           const simulator::ScenarioValue& value);
/// @brief Options of a slave under "plc_designer"; one that is not mandatory is optional unless they say otherwise.
/// Throws simulator::ScenarioError. [SRS-PLC-021]
[[nodiscard]] cia302::PlcSlave ReadPlcSlave(const std::string& file, const simulator::ScenarioValue& value,
                                            bool is_mandatory);
} // namespace counterpoint::tools

#endif // TOOLS_NETWORK_PROFILES_HPP
