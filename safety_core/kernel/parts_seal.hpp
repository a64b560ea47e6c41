// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_PARTS_SEAL_HPP
#define SAFETY_CORE_KERNEL_PARTS_SEAL_HPP

#include "safety_core/kernel/kernel_parts.hpp"

#include <cstdint>

namespace counterpoint
{

/// Where an object is, as a number.
[[nodiscard]] inline std::uintptr_t PlaceOf(const void* const object) noexcept
{
    return reinterpret_cast<std::uintptr_t>(object); // MISRA D-009
}

/// All addresses of the parts in one word, which changes when one bit of one of them does. [SRS_KRN_035]
[[nodiscard]] inline std::uintptr_t SealOf(const KernelParts& parts) noexcept
{
    return PlaceOf(&parts.channel_a) ^ PlaceOf(&parts.channel_b) ^ PlaceOf(&parts.can) ^ PlaceOf(&parts.output) ^
           PlaceOf(&parts.watchdog) ^ PlaceOf(&parts.application) ^ PlaceOf(parts.self_test) ^ PlaceOf(parts.windows) ^
           PlaceOf(parts.flow);
}

} // namespace counterpoint

#endif
