// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_NETWORK_PLAN_START_UP_BITS_HPP
#define CANOPEN_NETWORK_PLAN_START_UP_BITS_HPP

#include "canopen/network_plan/network_plan.hpp"

namespace counterpoint::network_plan
{
/// @brief Bits of 1F80h that the start-up follows, and those that say what the device is: master, flying master.
[[nodiscard]] constexpr std::uint32_t StartUpBits(const StartProfile profile) noexcept
{
    constexpr std::uint32_t kOfAll = cia302::kIsMaster | cia302::kFlyingMaster;
    std::uint32_t bits = cia302::kKnownStartUpBits;
    bits = (profile == StartProfile::kEl6751) ? kOfAll : bits;
    return (profile == StartProfile::kPlcDesigner)
               ? (kOfAll | cia302::kStartAllAtOnce | cia302::kApplicationStartsSlaves)
               : bits;
}
} // namespace counterpoint::network_plan

#endif // CANOPEN_NETWORK_PLAN_START_UP_BITS_HPP
