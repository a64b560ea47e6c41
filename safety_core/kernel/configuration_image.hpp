// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_CONFIGURATION_IMAGE_HPP
#define SAFETY_CORE_KERNEL_CONFIGURATION_IMAGE_HPP

#include "safety_core/kernel/result.hpp"

#include <cstdint>

namespace counterpoint
{

/// What a store keeps beside the items, so that a damaged or foreign configuration is found. [SRS_CFG_051]
struct ImageHeader
{
    std::uint32_t count; ///< Items, numbered from 0.
    std::uint32_t crc;   ///< CRC-32 over addresses and values of all items and 13FEh.
    std::uint8_t valid;  ///< 13FEh when it was saved.
};

struct ItemReply
{
    Result result;
    std::uint32_t value;
};

struct HeaderReply
{
    Result result;
    ImageHeader header;
};

} // namespace counterpoint

#endif
