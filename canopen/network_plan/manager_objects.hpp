// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_NETWORK_PLAN_MANAGER_OBJECTS_HPP
#define CANOPEN_NETWORK_PLAN_MANAGER_OBJECTS_HPP

#include "canopen/cia306/file/device.hpp"
#include "canopen/network_plan/network_plan.hpp"

#include <cstdint>

namespace counterpoint::network_plan
{
/// @brief Puts what the manager's own DCF says (1F80h to 1F90h, 1F26h, 1F27h, 1006h, 1016h, 1017h, 102Ah) where the
/// network file says nothing. Throws cia306::InputError. [SRS_NET_003]
void TakeManagerObjects(const cia306::Device& device, NetworkPlan& plan);
} // namespace counterpoint::network_plan

#endif // CANOPEN_NETWORK_PLAN_MANAGER_OBJECTS_HPP
