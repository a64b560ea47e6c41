// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/tms570/start/memory_map.hpp"

extern "C"
{
    // Addresses, and lengths that are addresses to the linker: tms570.ld and image.cmake.
    extern const std::uint8_t region_flash_length[];
    extern const std::uint8_t region_ram[];
    extern const std::uint8_t region_ram_length[];
    extern const std::uint8_t region_non_safety[];
    extern const std::uint8_t region_non_safety_length[];
    extern const std::uint8_t region_channel_a[];
    extern const std::uint8_t region_channel_b[];
    extern const std::uint8_t region_channel_length[];
    extern const std::uint8_t region_core[];
    extern const std::uint8_t region_core_length[];
}

namespace counterpoint::tms570
{
namespace
{

[[nodiscard]] std::uint32_t NumberOf(const std::uint8_t* const symbol) noexcept
{
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(symbol)); // MISRA D-006
}

} // namespace

MpuSetup FixedRegions() noexcept
{
    return MpuSetup{{0U, NumberOf(region_flash_length)},
                    {NumberOf(region_ram), NumberOf(region_ram_length)},
                    {NumberOf(region_non_safety), NumberOf(region_non_safety_length)}};
}

bool ProtectParties(hal::MemoryProtection& protection) noexcept
{
    const hal::MemoryRegion regions[]{
        {region_channel_a, NumberOf(region_channel_length), hal::MemoryOwner::kChannelA},
        {region_channel_b, NumberOf(region_channel_length), hal::MemoryOwner::kChannelB},
        {region_core, NumberOf(region_core_length), hal::MemoryOwner::kKernel},
    };
    bool are_protected = true;
    for (const hal::MemoryRegion& region : regions)
    {
        are_protected = (protection.Protect(region) == hal::ProtectStatus::kProtected) && are_protected;
    }
    protection.Enter(hal::MemoryOwner::kKernel);
    return are_protected;
}

} // namespace counterpoint::tms570
