// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_START_CHECK_HPP
#define SAFETY_CORE_KERNEL_START_CHECK_HPP

#include "safety_core/contract/configuration.hpp"
#include "safety_core/kernel/kernel_parts.hpp"

#include <cstdint>

namespace counterpoint
{

/// First reason why Start refused. [SRS_KRN_001]
enum class StartResult : std::uint8_t
{
    kInvalid = 0U,
    kStarted = 0x69U,
    kSrdoCount = 1U,      ///< Not 1 to 64, or no setups.
    kSrdoNumbers = 2U,    ///< Not 1 to 64 in ascending order, or with a gap where gaps are refused.
    kNodeId = 3U,         ///< Not 1 to 127.
    kGranularity = 4U,    ///< Not 1, 8, 16, 32 or 64.
    kPorts = 5U,          ///< Not kFirst or kSecond.
    kObjects = 6U,        ///< Out of order, a length not 1 to 64, an access that there is not, no place, no table, more
                          ///< than 1024, at 1300h to 13FFh, or at 0001h to 0007h beside dummy entries.
    kTiming = 7U,         ///< A time outside its range.
    kBusOrder = 8U,       ///< The HAL does not guarantee bus order.
    kStamps = 9U,         ///< The HAL does not guarantee stamps.
    kConfirmations = 10U, ///< The HAL does not guarantee confirmations.
    kStorage = 11U,       ///< More SRDOs or map entries than a channel has room for, or an odd number of entries.
    kOptions = 12U,       ///< An option that is none of its values, or a static mapping without entries or of over 128.
};

/// @brief What Start looks at before anything runs: numbers, objects and times of the device, the room that the
/// channels have, the guarantees of the HAL. O(srdo_count + objects) [SRS_KRN_001, SRS_KRN_571, SRS_KRN_572,
/// SRS_KRN_573, SRS_KRN_574, SRS_CLK_213, SRS_CMP_213, SRS_LIM_214]
[[nodiscard]] StartResult CheckStart(const DeviceConfig& config, const KernelParts& parts) noexcept;

} // namespace counterpoint

#endif
