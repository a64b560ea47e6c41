// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_FIRMWARE_COMMON_MEMORY_PROTECTION_HPP
#define EXAMPLES_FIRMWARE_COMMON_MEMORY_PROTECTION_HPP

#include "hal/api/memory_protection.hpp"

namespace counterpoint::firmware
{

/// @brief Gives the regions of channel A, channel B and core, as the linker placed them, to the protection. False where
/// one was refused: then the device must not run. A host has no regions and no protection: true. [SRS_FW_002]
[[nodiscard]] bool ProtectRegions(hal::MemoryProtection& protection) noexcept;

} // namespace counterpoint::firmware

#endif
