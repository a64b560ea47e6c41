// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_CAN_FILTERS_HPP
#define HAL_ZYNQMP_CAN_FILTERS_HPP

#include "hal/zynqmp/can/canps_registers.hpp"

#include <cstdint>

namespace counterpoint::zynqmp
{

/// Which identifiers a filter lets pass: those that agree with `identifier` in the bits of `mask`.
struct AcceptanceFilter
{
    std::uint16_t identifier;
    std::uint16_t mask;
};

/// Identifiers of a device, in any order.
struct IdentifierList
{
    const std::uint16_t* first;
    std::uint8_t count;
};

/// What the filters of a controller are set to.
struct FilterPlan
{
    AcceptanceFilter filters[canps::kMostFilters]; // MISRA D-001
    std::uint8_t count;
};

/// @brief Filters that let every identifier of the list pass and as few others as joining the nearest ones leaves; what
/// passes besides, the driver drops. `count` 0: no identifier or one above 7FFh. [SRS_ZYN_045]
[[nodiscard]] FilterPlan PlanFilters(const IdentifierList& identifiers) noexcept;

} // namespace counterpoint::zynqmp

#endif
