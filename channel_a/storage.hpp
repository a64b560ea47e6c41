// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_STORAGE_HPP
#define CHANNEL_A_STORAGE_HPP

#include "safety_core/contract/configuration.hpp"
#include "safety_core/contract/limits.hpp"
#include "safety_core/contract/srdo.hpp"
#include "safety_core/contract/time.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{

/// Record::mode: what the SRDO is, one of five, and what it has of a pair. A step is a change of one or two bits; a
/// flipped bit is found by the seal.
constexpr std::uint32_t kPending = 0x01U; ///< Consumer: a normal frame is pending.
constexpr std::uint32_t kHeld = 0x02U;    ///< Consumer: a pair is held.
constexpr std::uint32_t kFlying = 0x04U;  ///< Producer: a pair is in flight.
constexpr std::uint32_t kOff = 0x08U;
constexpr std::uint32_t kWaiting = 0x10U;
constexpr std::uint32_t kFaulted = 0x20U;
constexpr std::uint32_t kReleased = 0x40U; ///< Holds a pair.
constexpr std::uint32_t kProducer = 0x80U;
constexpr std::uint32_t kConsumer = kWaiting | kFaulted | kReleased;
/// A producer that waits for the confirmation of the normal frame, then of the inverse frame.
constexpr std::uint32_t kNormalAwaited = kProducer | kFlying;
constexpr std::uint32_t kInverseAwaited = kNormalAwaited + 1U;
constexpr std::uint32_t kStateShift = 4U; ///< To the bits of the state, without kOff.

/// Record::todo: why the next OnCycle serves the slot.
constexpr std::uint32_t kLook = 0x01U;     ///< Once.
constexpr std::uint32_t kInFlight = 0x02U; ///< In every cycle until the pair is sent or given up.

/// Places in Record::seal.
constexpr std::size_t kModeSeal = 0U;
constexpr std::size_t kLengthSeal = 1U;
constexpr std::size_t kCauseSeal = 2U;
constexpr std::size_t kDirectionSeal = 3U;
constexpr std::size_t kSealCount = 4U;

/// Places of the fields in Record::values, but for the direction, which is a part of the sealed bytes, and the mapping,
/// which has a row of its own.
constexpr std::size_t kSctPlace = 0U;
constexpr std::size_t kSrvtPlace = 1U;
constexpr std::size_t kTransmissionTypePlace = 2U;
constexpr std::size_t kCobIdPlace = 3U; ///< COB-ID 1, then COB-ID 2.
constexpr std::size_t kSignaturePlace = 5U;
constexpr std::size_t kValueCount = 6U;

/// A row of a dynamic mapping has the sub-indices of 138xh: the count, then the entries.
constexpr std::size_t kFirstEntry = 1U;
constexpr std::size_t kSecondWord = 3U; ///< Of the second normal object.
/// What the arrays of entries and places have behind the last row; never an entry, and without an object.
constexpr std::size_t kMoreEntries = kSecondWord;

/// No place of an object.
constexpr std::uint16_t kNoObject = 0xFFFFU;

/// A limit that never expires.
constexpr std::uint32_t kNoLimit = 0xFFFFFFFFU;

/// Values of the marks of a record. Everything else, zero above all, means 'not so'.
constexpr std::uint8_t kMarked = 0xA6U;
constexpr std::uint8_t kUnmarked = 0U;

/// Everything of one SRDO. Invariants between two calls:
/// - `seal` is the complement of mode, length_bytes, first_cause and direction. Every change of one of them changes the
///   seal by the same bits; a flipped bit therefore never gets lost, the record stays unsealed until Restart.
/// - `since` is the stamp of the pending normal frame (limit SRVT), else that of the held pair's normal frame (limit
///   SCT); with late detection always the latter (no limit without a held pair). Of a producer that is called it is the
///   microsecond before the last refresh, of one whose application sends the last sending; the limit is then the next
///   refresh. There is no limit in other modes.
/// - `told` is not 0 exactly while the window of the signals is open.
/// What is looked at most comes first: it is reached by short instructions.
/// The size is a power of 2, so that a record is found by a shift.
struct alignas(16) Record
{
    std::uint8_t mode;
    std::uint8_t length_bytes; ///< Beside the mode: the two are compared at once.
    SrdoCause first_cause;
    std::uint8_t direction;
    std::uint8_t seal[kSealCount]; // MISRA D-001
    Instant since;
    std::uint32_t limit_us;
    std::uint8_t todo;
    std::uint8_t total_bits; ///< Mapped bits.
    SrvtDetection detection;
    ProducerForm form;
    ReleasePolicy policy;
    std::uint8_t awaiting;  ///< Marked: waiting past SCT is still to be signalled.
    std::uint8_t edge;      ///< Marked: an acknowledge edge waits.
    std::uint8_t mapping;   ///< Marked: resolved.
    std::uint8_t check;     ///< Marked: the last Validate or Recheck found no fault.
    std::uint8_t refreshed; ///< Marked: the due mark of a refresh has not been used up.
    std::uint16_t error_count;
    std::uint32_t ordinal;
    Instant frame_since;      ///< Stamp of the pending normal frame. Producer: start of the pair, then of that frame.
    std::uint32_t unreported; ///< Causes (bit 1 << cause) recorded since the last OnCycle.
    std::uint32_t told;       ///< Causes signalled in the open window.
    std::uint32_t signals;
    Instant told_since;
    Instant edge_since;                ///< When the waiting acknowledge edge was seen.
    std::uint32_t values[kValueCount]; // MISRA D-001
    StaticFields fields;               ///< Of a static mapping.
    std::uint64_t mapped;              ///< Bits of the bytes of a frame.
    std::uint64_t pending;             ///< Data, byte 0 of the frame in the lowest bits; 0 behind the length.
    Payload held;                      ///< Likewise. Of a producer: normal data of the pair in flight.
    Payload safe;
};

/// For each identifier from 101h to 180h, by its low bits: the slot of the SRDO, kNoSlot for none.
constexpr std::size_t kLookUpSize = kSrdoIdentifierCount;

/// What a channel works on; it belongs to the caller and outlives the channel.
struct Storage
{
    Record* records;
    std::uint32_t* entries; ///< Rows of the dynamic mappings, and kMoreEntries.
    std::uint16_t* places;  ///< Where in DeviceConfig::objects the objects are that the entries name, likewise.
    std::uint8_t* look_up;  ///< kLookUpSize bytes.
    std::uint8_t capacity;  ///< Number of records.
    std::uint8_t row;       ///< Length of a row.
};

/// Memory for `kSlots` SRDOs with `kMapEntries` entries in each dynamic mapping; 0 where all mappings are static.
template <std::uint8_t kSlots, std::uint8_t kMapEntries = kUsualMapEntries> struct StorageFor
{
    static_assert((kSlots >= 1U) && (kSlots <= kMaxSrdoCount), "1 to 64 SRDOs");
    static_assert(((kMapEntries % 2U) == 0U) && (kMapEntries <= kMaxMapEntries), "entries come in pairs");

    static constexpr std::uint8_t kRow = kMapEntries + kFirstEntry;
    /// Where an object of a word has its place is read before it is known whether there are so many entries.
    static constexpr std::size_t kEntryCount = (std::size_t{kSlots} * kRow) + kMoreEntries;

    Record records[kSlots];             // MISRA D-001
    std::uint32_t entries[kEntryCount]; // MISRA D-001
    std::uint16_t places[kEntryCount];  // MISRA D-001
    std::uint8_t look_up[kLookUpSize];  // MISRA D-001

    [[nodiscard]] Storage Handle() noexcept
    {
        return Storage{&records[0], &entries[0], &places[0], &look_up[0], kSlots, kRow};
    }
};

} // namespace counterpoint::channel_a

#endif
