// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_COMMUNICATION_INDEX_HPP
#define SAFETY_CORE_KERNEL_COMMUNICATION_INDEX_HPP

#include "safety_core/contract/configuration.hpp"
#include "safety_core/kernel/object_access.hpp"

#include <cstdint>

namespace counterpoint
{

/// Index of an SRDO's communication parameters: 1301h to 1340h; 0000h stands for all SRDOs where a call says so.
struct CommunicationIndex
{
    std::uint16_t value;
};

/// Of SRDO 1.
constexpr std::uint16_t kFirstCommunication = 0x1301U;

/// @brief Index of the SRDO in a slot.
[[nodiscard]] inline CommunicationIndex IndexOf(const DeviceConfig& config, const SlotIndex slot) noexcept
{
    const std::uint32_t number = config.srdos[slot].number; // MISRA D-002
    return CommunicationIndex{static_cast<std::uint16_t>((kFirstCommunication - 1U) + number)};
}

/// @brief Slot of the SRDO that has this index, or kNoSlot. What lies outside of 1301h to 1340h leads to a number that
/// no SRDO has.
[[nodiscard]] inline SlotIndex SlotAt(const DeviceConfig& config, const CommunicationIndex index) noexcept
{
    const std::uint32_t place = static_cast<std::uint32_t>(index.value) - kFirstCommunication;
    // Most devices have no gaps: nothing to look for.
    if ((config.gaps != NumberGaps::kSearched) && (place < config.srdo_count))
    {
        return static_cast<SlotIndex>(place);
    }
    return SlotOf(config, SrdoNumber{place + 1U});
}

} // namespace counterpoint

#endif
