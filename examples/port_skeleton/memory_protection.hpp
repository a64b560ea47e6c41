// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_SKELETON_MEMORY_PROTECTION_HPP
#define EXAMPLES_PORT_SKELETON_MEMORY_PROTECTION_HPP

#include "hal/api/memory_protection.hpp"
#include "parts.hpp"

namespace port_skeleton
{

/// The MPU.
class MemoryProtection final : public counterpoint::hal::MemoryProtection
{
  public:
    /// @brief CONTRACT. kProtected only when a write by another party traps from the next Enter on; kRefused for a
    /// region that this MPU cannot have (size, alignment, number), kAbsent without an MPU. Never kProtected for less.
    [[nodiscard]] counterpoint::hal::ProtectStatus
    Protect(const counterpoint::hal::MemoryRegion& region) noexcept override;
    /// @brief CONTRACT. From its return on this party may write its own regions and no other party's.
    void Enter(counterpoint::hal::MemoryOwner owner) noexcept override;

    /// @brief kThere with the body, and not before; kAbsent where the device does without.
    [[nodiscard]] PartState State() const noexcept;
};

} // namespace port_skeleton

#endif
