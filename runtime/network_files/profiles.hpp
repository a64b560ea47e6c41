// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NETWORK_FILES_PROFILES_HPP
#define RUNTIME_NETWORK_FILES_PROFILES_HPP

#include "canopen/network_plan/network_plan.hpp"
#include "canopen/start_up/el6751/setup.hpp"
#include "canopen/start_up/plc_designer/setup.hpp"
#include "runtime/yaml/value.hpp"

#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// @brief Reads the map `flying` of a network file. Throws runtime::YamlError. [SRS_FLY_029]
[[nodiscard]] network_plan::FlyingPlan ReadFlying(const std::string& file, const YamlValue& value);
/// @brief Reads the options of a slave under `el6751` of a network file. Throws runtime::YamlError. [SRS_ELM_211]
void ReadEl6751Slave(const std::string& file, const runtime::YamlValue& value, network_plan::SlavePlan& plan);
/// @brief Reads the options of the manager under `el6751`. Throws runtime::YamlError. [SRS_ELM_211]
[[nodiscard]] cia302::El6751Times ReadEl6751Times(const std::string& file, const runtime::YamlValue& value);
/// @brief Reads the list `outputs` of a slave: what RxPDOs carry. Throws runtime::YamlError. [SRS_MGR_022]
[[nodiscard]] std::vector<network_plan::OutputPlan> ReadOutputs(const std::string& file,
                                                                const runtime::YamlValue& value);
/// @brief Reads the options of a slave under `plc_designer`. A slave that is not mandatory is optional unless the
/// options say otherwise. Throws runtime::YamlError. [SRS_PLC_021]
[[nodiscard]] cia302::PlcSlave ReadPlcSlave(const std::string& file, const runtime::YamlValue& value,
                                            bool is_mandatory);
} // namespace counterpoint::runtime

#endif // RUNTIME_NETWORK_FILES_PROFILES_HPP
