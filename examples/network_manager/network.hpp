// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_NETWORK_MANAGER_NETWORK_HPP
#define EXAMPLES_NETWORK_MANAGER_NETWORK_HPP

#include "canopen/cia302/flying_master/options.hpp"
#include "canopen/cia302/flying_master/times.hpp"
#include "examples/network_manager/manager_device.hpp"

namespace counterpoint::examples
{

/// The network of this example, all of it constant: the drive of examples/actuator (node 33, a safety slave, mandatory)
/// and two managers, node 1 and node 2. Node 2 has the higher priority.
constexpr cia302::NodeId kFirstManager{1U};
constexpr cia302::NodeId kSecondManager{2U};
constexpr cia302::NodeId kDrive{33U};

/// @brief Node 1 as the only manager.
[[nodiscard]] ManagerSettings AloneSettings() noexcept;
/// @brief Node 1 or node 2 as one of two flying masters, the default preset.
[[nodiscard]] ManagerSettings FlyingSettings(cia302::NodeId own) noexcept;

} // namespace counterpoint::examples

#endif
