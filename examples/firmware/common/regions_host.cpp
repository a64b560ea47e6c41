// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/firmware/common/memory_protection.hpp"

namespace counterpoint::firmware
{

bool ProtectRegions(hal::MemoryProtection& /*protection*/) noexcept
{
    return true;
}

} // namespace counterpoint::firmware
