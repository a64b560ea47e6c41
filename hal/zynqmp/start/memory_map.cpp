// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/zynqmp/start/memory_map.hpp"

extern "C"
{
    // Addresses, and lengths that are addresses to the linker: zynqmp.ld and image.cmake.
    extern const std::uint8_t image_code_start[];
    extern const std::uint8_t image_code_length[];
    extern const std::uint8_t image_ram_start[];
    extern const std::uint8_t image_ram_length[];
    extern const std::uint8_t region_non_safety[];
    extern const std::uint8_t region_non_safety_length[];
    extern const std::uint8_t region_channel_a[];
    extern const std::uint8_t region_channel_b[];
    extern const std::uint8_t region_channel_length[];
    extern const std::uint8_t region_core[];
    extern const std::uint8_t region_core_length[];
}

namespace counterpoint::zynqmp
{
namespace
{

[[nodiscard]] std::uint32_t NumberOf(const std::uint8_t* const symbol) noexcept
{
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(symbol)); // MISRA D-006
}

} // namespace

tms570::MpuSetup FixedRegions() noexcept
{
    return tms570::MpuSetup{{NumberOf(&image_code_start[0]), NumberOf(&image_code_length[0])},
                            {NumberOf(&image_ram_start[0]), NumberOf(&image_ram_length[0])},
                            {NumberOf(&region_non_safety[0]), NumberOf(&region_non_safety_length[0])}};
}

bool ProtectParties(hal::MemoryProtection& protection) noexcept
{
    const hal::MemoryRegion regions[]{
        // MISRA D-001
        {&region_channel_a[0], NumberOf(&region_channel_length[0]), hal::MemoryOwner::kChannelA},
        {&region_channel_b[0], NumberOf(&region_channel_length[0]), hal::MemoryOwner::kChannelB},
        {&region_core[0], NumberOf(&region_core_length[0]), hal::MemoryOwner::kKernel},
    };
    bool are_protected = true;
    for (const hal::MemoryRegion& region : regions)
    {
        are_protected = (protection.Protect(region) == hal::ProtectStatus::kProtected) && are_protected;
    }
    protection.Enter(hal::MemoryOwner::kKernel);
    return are_protected;
}

} // namespace counterpoint::zynqmp
