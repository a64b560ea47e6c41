// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CONTRACT_DEVICE_FAULT_HPP
#define SAFETY_CORE_CONTRACT_DEVICE_FAULT_HPP

#include "safety_core/contract/srdo.hpp"

#include <cstdint>

namespace counterpoint
{

/// Why a device is in its safe state (level 2). [SRS_KRN_003]
enum class DeviceFault : std::uint8_t
{
    kInvalid = 0U,       ///< Also: the latch itself was found corrupted.
    kDisagreement = 1U,  ///< Outcomes, data or checks of the channels are not equal, or an object or the GFC is wrong.
    kUnmatched = 2U,     ///< Ordinals or due marks differed for longer than the discrepancy time.
    kGuard = 3U,         ///< A channel found the guard's token stale.
    kConfiguration = 4U, ///< Signature or resolved mapping wrong while 13FEh was A5h, or a copy of it changed.
    kComparator = 5U,    ///< The comparator missed a deliberate difference, or its verdict is not of this cycle.
    kFlow = 6U,          ///< The program flow was not the one laid down.
    kClock = 7U,         ///< The two counters drift apart.
    kLateCall = 8U,      ///< The cycle came too late.
    kFrameOrder = 9U,    ///< Frames out of order, or with stamps that cannot be.
    kApplication = 10U,  ///< The application demanded the safe state.
    kSelfTest = 11U,     ///< A self test found a defect, stands still or was not done.
    kHandshake = 12U,    ///< The application did not answer in time.
    kCrossLink = 13U,    ///< The link to the other CPU is lost or wrong.
    kOutput = 14U,       ///< The output closed without a decision to close it, and stays closed.
    kNone = 0x5AU,
};

/// The first device fault and the slot at which it was seen; kNoSlot where it belongs to no slot.
struct DeviceFaultReport
{
    DeviceFault fault;
    SlotIndex slot;
    std::uint16_t count; ///< Device faults since Start, this one included; stays at 65535.
};

} // namespace counterpoint

#endif
