// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "memory_protection.hpp"

namespace port_skeleton
{

counterpoint::hal::ProtectStatus MemoryProtection::Protect(const counterpoint::hal::MemoryRegion& /*region*/) noexcept
{
    return counterpoint::hal::ProtectStatus::kAbsent;
}

void MemoryProtection::Enter(const counterpoint::hal::MemoryOwner /*owner*/) noexcept
{
}

PartState MemoryProtection::State() const noexcept
{
    return PartState::kMissing;
}

} // namespace port_skeleton
