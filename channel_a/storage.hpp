// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_STORAGE_HPP
#define CHANNEL_A_STORAGE_HPP

#include "channel_a/transitions.hpp"
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

/// Places of the fields in Record::values, but for the direction, which is a part of the sealed bytes.
constexpr std::size_t kSctPlace = 0U;
constexpr std::size_t kSrvtPlace = 1U;
constexpr std::size_t kTransmissionTypePlace = 2U;
constexpr std::size_t kCobIdPlace = 3U; ///< COB-ID 1, then COB-ID 2.
constexpr std::size_t kMapCountPlace = 5U;
constexpr std::size_t kSignaturePlace = 6U;
constexpr std::size_t kMapEntryPlace = 7U; ///< Entry 1; the others follow.
constexpr std::size_t kValueCount = kMapEntryPlace + kMaxMapEntries;

/// A limit that never expires.
constexpr std::uint32_t kNoLimit = 0xFFFFFFFFU;

/// Values of the marks of a record. Everything else, zero above all, means 'not so'.
constexpr std::uint8_t kMarked = 0xA6U;
constexpr std::uint8_t kUnmarked = 0U;

/// Everything of one SRDO. Invariants between two calls:
/// - `seal` is the complement of mode, first_cause, direction and length_bytes. Every change of one of them changes the
/// seal by
///   the same bits; a flipped bit therefore never gets lost, the record stays unsealed until Restart.
/// - `since` is the stamp of the pending normal frame (modes First and Next, limit SRVT), else that of the held pair's
/// normal
///   frame (Held, limit SCT); of a producer the start or the confirmed half of the pair in flight (limit SRVT). Of an
///   idle producer the refresh before the next one, with the refresh as limit. There is no limit in the other modes.
/// - `told` is not 0 exactly while the window of the signals is open.
/// - `objects` holds places in DeviceConfig::objects, of the entry of the same position, while `mapping` is marked.
struct Record
{
    Mode mode;
    SrdoCause first_cause;
    std::uint8_t direction;
    std::uint8_t length_bytes;
    std::uint32_t seal;
    Instant since;
    std::uint32_t limit_us;
    std::uint32_t ordinal;
    std::uint32_t unreported; ///< Causes (bit 1 << cause) recorded since the last OnCycle.
    std::uint32_t signals;
    std::uint32_t told; ///< Causes signalled in the open window.
    Instant told_since;
    Instant edge_since;    ///< When the waiting acknowledge edge was seen.
    Instant refresh_since; ///< Producer: the refresh before the next one, or the last sending.
    Octets pending;        ///< Of a producer: as prepared.
    Octets held;           ///< Of a producer: normal data of the pair in flight.
    Octets safe;
    std::uint32_t values[kValueCount];     // MISRA D-001
    std::uint16_t objects[kMaxMapEntries]; // MISRA D-001
    std::uint16_t error_count;
    ReleasePolicy policy;
    ProducerForm form;
    std::uint8_t mapping;  ///< Marked: resolved.
    std::uint8_t check;    ///< Marked: the last Validate or Recheck found no fault.
    std::uint8_t edge;     ///< Marked: an acknowledge edge waits.
    std::uint8_t awaiting; ///< Marked: waiting past SCT is still to be signalled.
    std::uint8_t refresh;  ///< Marked: due by a refresh.
    std::uint8_t request;  ///< Marked: the application asked for sending.
    std::uint8_t prepared; ///< Marked: the last Prepare was ready.
};

/// For each pair of identifiers (odd, even) from 101h on: slot + 1 of the SRDO, 0 for none.
constexpr std::size_t kLookUpSize = kSrdoIdentifierCount / 2U;

/// What a channel works on; it belongs to the caller and outlives the channel.
struct Storage
{
    Record* records;
    std::uint8_t* look_up; ///< kLookUpSize bytes.
    std::uint8_t capacity; ///< Number of records.
};

/// Memory for `kSlots` SRDOs.
template <std::uint8_t kSlots> struct StorageFor
{
    static_assert((kSlots >= 1U) && (kSlots <= kMaxSrdoCount), "1 to 64 SRDOs");

    Record records[kSlots];            // MISRA D-001
    std::uint8_t look_up[kLookUpSize]; // MISRA D-001

    [[nodiscard]] Storage Handle() noexcept
    {
        return Storage{&records[0], &look_up[0], kSlots};
    }
};

} // namespace counterpoint::channel_a

#endif
