// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/firmware/common/memory_protection.hpp"

#include "hal/zynqmp/start/memory_map.hpp"

namespace counterpoint::firmware
{

bool ProtectRegions(hal::MemoryProtection& protection) noexcept
{
    return zynqmp::ProtectParties(protection);
}

} // namespace counterpoint::firmware
