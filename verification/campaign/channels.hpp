// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_CHANNELS_HPP
#define VERIFICATION_CAMPAIGN_CHANNELS_HPP

#include "verification/campaign/device.hpp"

namespace counterpoint::campaign
{
/// A channel in the region, with the members of its memory.
struct MadeChannel
{
    Channel* voice{nullptr};
    std::vector<Place> places;
};

/// @brief Makes a shipped channel with room for at least so much in the region. Throws std::runtime_error for a device
/// with more than 8 SRDOs.
[[nodiscard]] MadeChannel MakeChannelA(Region& region, const ChannelRoom& room);
[[nodiscard]] MadeChannel MakeChannelB(Region& region, const ChannelRoom& room);
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_CHANNELS_HPP
