// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_FIRMWARE_EMULATED_PROTECTION_HPP
#define VERIFICATION_TARGET_FIRMWARE_EMULATED_PROTECTION_HPP

#include "hal/api/memory_protection.hpp"

namespace counterpoint::target
{

/// The MPU of the emulated Cortex-R5F (the same registers as a Cortex-R4F has), on the emulator's memory map.
class EmulatedProtection final : public hal::MemoryProtection
{
  public:
    /// @brief Lays down what is the same for all parties and turns the MPU on: flash is read-only for all; RAM and
    /// everything else can be written by privileged code alone, the non-safety region by all.
    void Start() noexcept;
    [[nodiscard]] hal::ProtectStatus Protect(const hal::MemoryRegion& region) noexcept override;
    void Enter(hal::MemoryOwner owner) noexcept override;
};

} // namespace counterpoint::target

#endif
