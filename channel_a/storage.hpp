// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_STORAGE_HPP
#define CHANNEL_A_STORAGE_HPP

#include "channel_a/transitions.hpp"
#include "safety_core/contract/configuration.hpp"
#include "safety_core/contract/limits.hpp"
#include "safety_core/contract/srdo.hpp"
#include "safety_core/contract/time.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{

/// Data of one frame in the order of the bus; bytes behind the mapped length are 0.
struct Octets
{
    std::uint8_t at[kMaxPayloadBytes]; // MISRA D-001
};

/// Places of the fields in Record::values, but for the direction, which is a part of the sealed bytes, and the entries
/// of the mapping, which have an array of their own.
constexpr std::size_t kSctPlace = 0U;
constexpr std::size_t kSrvtPlace = 1U;
constexpr std::size_t kTransmissionTypePlace = 2U;
constexpr std::size_t kCobIdPlace = 3U; ///< COB-ID 1, then COB-ID 2.
constexpr std::size_t kMapCountPlace = 5U;
constexpr std::size_t kSignaturePlace = 6U;
constexpr std::size_t kValueCount = 7U;

/// Position of the second normal object, from 0.
constexpr std::size_t kSecondWord = 2U;
/// What the arrays of entries and places have besides those of the records; never an entry, and without an object.
constexpr std::size_t kMoreEntries = kSecondWord + 1U;

/// No place of an object.
constexpr std::uint16_t kNoObject = 0xFFFFU;

/// A limit that never expires.
constexpr std::uint32_t kNoLimit = 0xFFFFFFFFU;

/// Values of the marks of a record. Everything else, zero above all, means 'not so'.
constexpr std::uint8_t kMarked = 0xA6U;
constexpr std::uint8_t kUnmarked = 0U;

/// Everything of one SRDO. Invariants between two calls:
/// - `seal` is the complement of mode, first_cause, direction and length_bytes. Every change of one of them changes the
///   seal by the same bits; a flipped bit therefore never gets lost, the record stays unsealed until Restart.
/// - `since` is the stamp of the pending normal frame (modes First and Next, limit SRVT), else that of the held pair's
///   normal frame (Held, limit SCT); with late detection always the latter (no limit in First). Of a producer that is
///   called it is the microsecond before the last refresh, of one whose application sends the last sending; the limit
///   is then the next refresh. There is no limit in other modes.
/// - `told` is not 0 exactly while the window of the signals is open.
struct Record
{
    Mode mode;
    SrdoCause first_cause;
    std::uint8_t direction;
    std::uint8_t length_bytes;
    std::uint32_t seal;
    Instant since;
    std::uint32_t limit_us;
    std::uint8_t awaiting; ///< Marked: waiting past SCT is still to be signalled.
    std::uint8_t edge;     ///< Marked: an acknowledge edge waits.
    ReleasePolicy policy;
    ProducerForm form;
    std::uint8_t mapping; ///< Marked: resolved.
    std::uint8_t check;   ///< Marked: the last Validate or Recheck found no fault.
    SrvtDetection detection;
    std::uint8_t spare_bits; ///< How many of the last byte are not mapped.
    std::uint16_t error_count;
    std::uint32_t ordinal;
    Octets pending;           ///< As received; 0 behind the length.
    Octets held;              ///< Of a producer: normal data of the pair in flight.
    Instant frame_since;      ///< Stamp of the pending normal frame. Producer: start of the pair, then of that frame.
    std::uint32_t unreported; ///< Causes (bit 1 << cause) recorded since the last OnCycle.
    std::uint32_t told;       ///< Causes signalled in the open window.
    std::uint32_t signals;
    Instant told_since;
    Instant edge_since;                ///< When the waiting acknowledge edge was seen.
    std::uint32_t values[kValueCount]; // MISRA D-001
    Octets safe;
    StaticFields fields; ///< Of a static mapping.
};

/// For each pair of identifiers (odd, even) from 101h on: the slot of the SRDO, kNoSlot for none.
constexpr std::size_t kLookUpSize = kSrdoIdentifierCount / 2U;

/// What a channel works on; it belongs to the caller and outlives the channel.
struct Storage
{
    Record* records;
    std::uint32_t* entries;   ///< Of dynamic mappings, map_entries for each record, and kMoreEntries.
    std::uint16_t* places;    ///< Where in DeviceConfig::objects the objects are that they name, likewise.
    std::uint8_t* look_up;    ///< kLookUpSize bytes.
    std::uint8_t capacity;    ///< Number of records.
    std::uint8_t map_entries; ///< Even.
};

/// Memory for `kSlots` SRDOs with `kMapEntries` entries in each dynamic mapping; 0 where all mappings are static.
template <std::uint8_t kSlots, std::uint8_t kMapEntries = kUsualMapEntries> struct StorageFor
{
    static_assert((kSlots >= 1U) && (kSlots <= kMaxSrdoCount), "1 to 64 SRDOs");
    static_assert(((kMapEntries % 2U) == 0U) && (kMapEntries <= kMaxMapEntries), "entries come in pairs");

    /// Where an object of a word has its place is read before it is known whether there are so many entries.
    static constexpr std::size_t kEntryCount = (std::size_t{kSlots} * kMapEntries) + kMoreEntries;

    Record records[kSlots];             // MISRA D-001
    std::uint32_t entries[kEntryCount]; // MISRA D-001
    std::uint16_t places[kEntryCount];  // MISRA D-001
    std::uint8_t look_up[kLookUpSize];  // MISRA D-001

    [[nodiscard]] Storage Handle() noexcept
    {
        return Storage{&records[0], &entries[0], &places[0], &look_up[0], kSlots, kMapEntries};
    }
};

} // namespace counterpoint::channel_a

#endif
