// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_READ_BYTES_HPP
#define VERIFICATION_CAMPAIGN_READ_BYTES_HPP

#include "verification/campaign/device.hpp"

#include <cstddef>
#include <vector>

namespace counterpoint::campaign
{
/// Bytes of the memory of a device.
struct ReadBytes
{
    std::size_t offset{0U};
    std::size_t size{0U};
};

/// @brief What the application is given of the objects: the variables of consumers, as those of producers are what it
/// senses.
[[nodiscard]] std::vector<ReadBytes> WhatIsRead(Device& device);
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_READ_BYTES_HPP
