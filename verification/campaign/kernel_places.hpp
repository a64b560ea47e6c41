// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_KERNEL_PLACES_HPP
#define VERIFICATION_CAMPAIGN_KERNEL_PLACES_HPP

#include "verification/campaign/device.hpp"

#include <vector>

namespace counterpoint::campaign
{
/// @brief The members of a kernel that lies in the region. [SRS_CMG_003]
[[nodiscard]] std::vector<Place> PlacesOf(const Kernel& kernel, const Region& region);
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_KERNEL_PLACES_HPP
