// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/firmware/common/memory_protection.hpp"

#include <cstdint>

extern "C"
{
    // Addresses, and lengths that are addresses to the linker: hal/tms570/start/tms570.ld.
    extern const std::uint8_t region_channel_a[];
    extern const std::uint8_t region_channel_b[];
    extern const std::uint8_t region_core[];
    extern const std::uint8_t region_channel_length[];
    extern const std::uint8_t region_core_length[];
}

namespace counterpoint::firmware
{
namespace
{

[[nodiscard]] std::uint32_t LengthOf(const std::uint8_t* const symbol) noexcept
{
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(symbol));
}

} // namespace

bool ProtectRegions(hal::MemoryProtection& protection) noexcept
{
    const hal::MemoryRegion regions[]{
        {region_channel_a, LengthOf(region_channel_length), hal::MemoryOwner::kChannelA},
        {region_channel_b, LengthOf(region_channel_length), hal::MemoryOwner::kChannelB},
        {region_core, LengthOf(region_core_length), hal::MemoryOwner::kKernel},
    };
    bool are_protected = true;
    for (const hal::MemoryRegion& region : regions)
    {
        are_protected = (protection.Protect(region) == hal::ProtectStatus::kProtected) && are_protected;
    }
    protection.Enter(hal::MemoryOwner::kKernel);
    return are_protected;
}

} // namespace counterpoint::firmware
