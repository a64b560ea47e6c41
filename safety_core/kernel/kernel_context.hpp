// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_KERNEL_CONTEXT_HPP
#define SAFETY_CORE_KERNEL_KERNEL_CONTEXT_HPP

#include "safety_core/kernel/configuration_guard.hpp"
#include "safety_core/kernel/kernel_parts.hpp"
#include "safety_core/kernel/object_access.hpp"
#include "safety_core/kernel/parts_seal.hpp"
#include "safety_core/kernel/safe_state_latch.hpp"

#include <cstdint>

namespace counterpoint
{

/// What the parts of a kernel work with together; Kernel owns it and hands it to each of them.
struct KernelContext
{
    explicit KernelContext(const KernelParts& given) noexcept
        : parts{given}, seal{SealOf(given)}, guard{given.channel_a, given.channel_b, latch}
    {
    }

    KernelParts parts;
    std::uintptr_t seal;                    ///< Of the parts as they were given. [SRS_KRN_035]
    const DeviceConfig* config{&kNoDevice}; ///< Never null: a device without SRDOs before Start.
    SafeStateLatch latch{};
    ConfigurationGuard guard;
};

} // namespace counterpoint

#endif
