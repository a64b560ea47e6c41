// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CONTRACT_SRDO_HPP
#define SAFETY_CORE_CONTRACT_SRDO_HPP

#include "safety_core/contract/limits.hpp"

#include <cstdint>

namespace counterpoint
{

/// Dense place of an SRDO in the storage of the device: 0 for the existing SRDO of the lowest number, without gaps.
using SlotIndex = std::uint8_t;
constexpr SlotIndex kNoSlot = 0xFFU;

/// Bit n stands for slot n.
using SrdoMask = std::uint64_t;

/// Object 130xh sub 1. Not an enumeration of grants: the raw value of the object.
constexpr std::uint8_t kDirectionOff = 0U;
constexpr std::uint8_t kDirectionProducer = 1U;
constexpr std::uint8_t kDirectionConsumer = 2U;

/// Why an SRDO is safe, or why a pair was not sent. Values are the bit positions in `SrdoView::signals`.
/// Zero-filled memory reads as kInvalid, which every reader treats as a fault. [SRS_CONS_020]
enum class SrdoCause : std::uint8_t
{
    kInvalid = 0U,
    kLength = 1U,          ///< Not the mapped length rounded up to bytes: shorter or longer.
    kInverseFirst = 2U,    ///< Inverse frame without a normal frame before it.
    kNormalTwice = 3U,     ///< Second normal frame before the inverse frame.
    kNotInverse = 4U,      ///< At least one mapped bit is not inverted (consumer: frames, producer: objects).
    kSrvt = 5U,            ///< SRVT expired between normal and inverse frame.
    kSct = 6U,             ///< SCT expired between two normal frames.
    kIdentifier = 7U,      ///< Identifier on the wrong controller, or not the configured one of the SRDO it leads to.
    kQueueOverflow = 8U,   ///< Frames were lost between controller and kernel.
    kLateCall = 9U,        ///< The cycle came later than cycle time plus tolerance.
    kNotOperational = 10U, ///< OPERATIONAL was left.
    kGfc = 11U,            ///< Global fail-safe command received.
    kDemoted = 12U,        ///< The other channel reported a fault that this one did not see.
    kTransmitQueue = 13U,  ///< Producer: the controller took no frame (queue full).
    kBusOff = 14U,         ///< Producer: the controller is bus-off.
    kNoConfirmation = 15U, ///< Producer: no confirmation of a transmission within SRVT.
    kRefreshMissed = 16U,  ///< Producer: a refresh could not take place, or the application did not send in time.
    kWrongEcho = 17U,      ///< Producer: the confirmed frame is not the frame that should have been sent.
    kWaitingPastSct = 18U, ///< Consumer, signal only: no first pair within SCT of entering OPERATIONAL. Never a cause.
    kNone = 0x5AU,         ///< No cause recorded. No bit in `signals`.
};

/// State of one SRDO in one channel, as its outcome shows it. How a channel keeps the state is not part of the
/// contract.
enum class SrdoState : std::uint8_t
{
    kInvalid = 0U,
    kOff = 0x12U,      ///< Direction 0, not OPERATIONAL, or configuration not valid. Safe.
    kWaiting = 0x24U,  ///< Consumer: no release yet since OPERATIONAL was entered, no fault since. Safe.
    kFaulted = 0x48U,  ///< Consumer: a fault since the last release or since OPERATIONAL was entered. Safe.
    kProducer = 0x81U, ///< Producer in OPERATIONAL.
    kReleased = 0xB7U, ///< Consumer: the held pair may be used.
};

/// Restart behaviour of a consumer. Everything that is not kAutomatic is the restart interlock. [SRS_REL_004]
enum class ReleasePolicy : std::uint8_t
{
    kInterlock = 0U,
    kAutomatic = 0x5AU,
};

/// Who starts the transmission of a producer. [SRS_PROD_002]
enum class ProducerForm : std::uint8_t
{
    kApplicationSends = 0U,
    kProviderCalled = 1U,
};

/// When a missing inverse frame is found. Everything that is not kLate is early. [SRS_TIME_007, SRS_TIME_009]
enum class SrvtDetection : std::uint8_t
{
    kEarly = 0U,   ///< By the cycle in which SRVT has expired.
    kLate = 0x3CU, ///< By an inverse frame that comes too late, or by SCT.
};

/// Data of one frame: byte 0 of the frame is bits 0 to 7 of `low`, byte 4 is bits 0 to 7 of `high`. Bits above the
/// mapped length are 0.
struct Payload
{
    std::uint32_t low;
    std::uint32_t high;
};

} // namespace counterpoint

#endif
