// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CROSSLINK_LINK_MESSAGE_HPP
#define SAFETY_CORE_CROSSLINK_LINK_MESSAGE_HPP

#include "hal/api/cross_link.hpp"
#include "safety_core/contract/channel.hpp"
#include "safety_core/contract/device_fault.hpp"
#include "safety_core/crosslink/link_config.hpp"

#include <cstdint>

namespace counterpoint
{

constexpr std::uint8_t kLinkVersion = 1U;
constexpr std::uint8_t kReportCount = 4U;
constexpr std::uint8_t kArmedCount = 2U;

/// Who speaks. Anything but the expected peer is a corrupt message.
struct LinkSender
{
    PeerRole role;
    std::uint8_t node_id;
};

/// The newest message that the sender has taken from the receiver.
struct LinkEcho
{
    std::uint32_t sequence;
    Instant stamp;         ///< By the receiver's clock.
    std::uint32_t hold_us; ///< From its reception to the composing of this message, by the sender's clock.
    std::uint8_t heard;    ///< kHeard: there is one.
};
constexpr std::uint8_t kHeard = 0x96U;

/// What a channel says about its cycle as a whole.
struct Statement
{
    GuardView guard;
    std::uint8_t sct_checked;
    std::uint8_t is_tx;
    std::uint8_t is_invalid;
    std::uint8_t not_operational;
};

/// Newest check of one SRDO; slot kNoSlot: none.
struct SlotCheck
{
    SlotIndex slot;
    CheckResult result;
};

/// Whether a reported consumer holds a pair.
enum class Holding : std::uint8_t
{
    kUnknown = 0U, ///< Nothing is reported.
    kPair = 0x33U,
    kNothing = 0xCCU,
};

/// What a channel says about one consumer.
struct SlotReport
{
    SlotIndex slot;
    Holding holding;
    SrdoState state;
    SrdoCause cause;
    std::uint32_t ordinal;
    std::uint32_t age_us; ///< Of the held pair's inverse frame, or of the last discard.
    Payload data;
};

/// The normal frame as channel B prepared it and awaits it; slot kNoSlot: none. Each Prepare has a new number, never 0.
struct ArmedFrame
{
    SlotIndex slot;
    std::uint8_t number;
    CanFrame frame;
};

/// The armed frame that the leader used last and gave up, and why; number 0: none.
struct Refusal
{
    std::uint8_t number;
    SrdoCause cause;
};

/// One message. Byte layout, multi-byte values low byte first:
///
///   0 version 01h        1 role           2 node-ID         3 device fault
///   4 sequence (4)       8 stamp (4)     12 echo sequence (4)   16 echo stamp (4)   20 echo hold (4)
///  24 flow (4)          28 digest (4)
///  32 heard             33 guard         34 sct_checked    35 is_tx   36 is_invalid   37 not_operational
///  38 check slot        39 check rule    40 check signature (2)       42 refused number  43 cause
///  44 released (8)      52 new faults (8)                  60 due (8)
///  68 four reports of 20: slot, holding, state, cause, ordinal (4), age (4), data (8)
/// 148 two armed frames of 18: slot, number, identifier (4), kind, port, length, data (8), 00h
/// 184 CRC-32 over the 184 bytes before (4)
struct LinkMessage
{
    LinkSender sender;
    DeviceFault fault; ///< kNone while the sender's kernel is running.
    std::uint32_t sequence;
    Instant stamp;
    LinkEcho echo;
    std::uint32_t flow;
    DeviceDigest digest;
    Statement statement;
    SlotCheck check;
    Refusal refusal;
    SrdoMask released;
    SrdoMask new_faults;
    SrdoMask due;
    SlotReport reports[kReportCount]; // MISRA D-001
    ArmedFrame armed[kArmedCount];    // MISRA D-001
};

/// @brief Lays a message out. O(bytes) [SRS_LNK_001]
void Encode(const LinkMessage& message, hal::LinkFrame& frame) noexcept;

enum class DecodeResult : std::uint8_t
{
    kInvalid = 0U, ///< Damaged, or not from `expected`; `message` has no meaning.
    kIntact = 0x69U,
};
/// @brief Reads a message back, without any judgement on what it says. O(bytes) [SRS_LNK_001, SRS_LNK_002]
[[nodiscard]] DecodeResult Decode(const hal::LinkFrame& frame, const LinkSender& expected,
                                  LinkMessage& message) noexcept;

} // namespace counterpoint

#endif
