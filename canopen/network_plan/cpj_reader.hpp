// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_NETWORK_PLAN_CPJ_READER_HPP
#define CANOPEN_NETWORK_PLAN_CPJ_READER_HPP

#include "canopen/network_plan/network_plan.hpp"

#include <string>

namespace counterpoint::network_plan
{
/// @brief Reads a CPJ file (CiA 306-3). The node whose DCF says CANopenManager=1 is the manager, `manager` (0: none
/// given), which is none of its nodes, where no DCF does. Throws cia306::InputError. [SRS_NET_001, SRS_NET_750]
[[nodiscard]] NetworkPlan ReadCpj(const std::string& path, std::uint8_t manager);

/// @brief A file named in a network file, seen from where we are. Backslashes count as slashes.
[[nodiscard]] std::string BesideFile(const std::string& network_file, const std::string& name);

/// @brief Why nothing can be read from a file that a network file names: "'x.dcf' is a folder". Empty: it can.
[[nodiscard]] std::string ProblemOfFile(const std::string& path);
} // namespace counterpoint::network_plan

#endif // CANOPEN_NETWORK_PLAN_CPJ_READER_HPP
