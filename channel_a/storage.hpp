// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_STORAGE_HPP
#define CHANNEL_A_STORAGE_HPP

#include "channel_a/bytes.hpp"
#include "channel_a/grants.hpp"
#include "channel_a/state.hpp"
#include "safety_core/contract/configuration.hpp"
#include "safety_core/contract/limits.hpp"
#include "safety_core/contract/srdo.hpp"
#include "safety_core/contract/time.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{

/// Record::todo: why the next OnCycle serves the slot.
constexpr std::uint32_t kLook = 0x01U;     ///< Once.
constexpr std::uint32_t kInFlight = 0x02U; ///< In every cycle until the pair is sent or given up.

/// A limit that never expires.
constexpr std::uint32_t kNoLimit = 0xFFFFFFFFU;

/// The fields of 130xh and 13FFh that are a number and nothing else, as they are stored.
struct Values
{
    std::uint16_t sct_ms; ///< Producer: refresh time.
    std::uint16_t signature;
    std::uint8_t srvt_ms;
    std::uint8_t transmission_type;
    std::uint32_t cob_id[2]; ///< COB-ID 1, of the normal frame, then COB-ID 2. MISRA D-001
};

/// Everything of one SRDO but its mapping. Between two calls:
/// - `since` and `limit_us` are the limit that runs: with a pending normal frame its stamp and SRVT, else the stamp of
///   the held pair's normal frame and SCT; with late detection always the latter. Of a producer that is called they are
///   the microsecond before the last refresh, of one whose application sends the last sending, and the time to the
///   next. No limit runs in other states.
/// - `ordinal` is 0 unless the SRDO is a consumer.
struct Record
{
    Grants grants;
    Instant since;
    std::uint32_t limit_us;
    std::uint8_t todo;
    std::uint8_t total_bits; ///< Mapped bits.
    std::uint8_t spare_bits; ///< Those of the last byte of a frame that are not mapped.
    SrvtDetection detection;
    ProducerForm form;
    std::uint8_t awaiting;  ///< kYes: waiting past SCT is still to be signalled.
    std::uint8_t refreshed; ///< kYes: a refresh fell due and was not prepared since. [SRS_PROD_013]
    std::uint16_t error_count;
    std::uint32_t ordinal;    ///< Pairs received since the last fault or since OPERATIONAL was entered.
    std::uint32_t sent;       ///< Pairs sent since OPERATIONAL was entered.
    Instant frame_since;      ///< Stamp of the pending normal frame. Producer: start of the pair, then of that frame.
    std::uint32_t unreported; ///< Causes (bit 1 << cause) recorded since the last OnCycle.
    std::uint32_t signals;    ///< What the last OnCycle told.
    Instant edge_since;       ///< When the waiting acknowledge edge was seen.
    Values values;
    StaticFields fields; ///< Of a static mapping.
    Bytes mapped;        ///< FFh for each byte of a frame.
    Bytes pending;       ///< Of the pending normal frame.
    Bytes held;          ///< Of the held pair. Producer: normal data of the pair in flight.
    Bytes safe;
};

/// What is done with the bits of one pair of entries, worked out when the mapping is validated.
struct Step
{
    std::uint16_t normal;   ///< Place in DeviceConfig::objects of the object that is written and read; kNoObject: none.
    std::uint16_t inverse;  ///< Likewise of its inverse; only confirmed.
    std::uint8_t first_bit; ///< In the frame.
};

constexpr std::uint16_t kNoObject = 0xFFFFU;

/// Each step of a static mapping is of one byte at least.
constexpr std::uint32_t kMaxStaticSteps = kMaxPayloadBytes;

/// For each identifier from 101h to 180h, by its low bits: the slot of the SRDO, kNoSlot for none.
constexpr std::size_t kLookUpSize = kSrdoIdentifierCount;

/// What a channel works on; it belongs to the caller and outlives the channel. A dynamic mapping of a slot has
/// `map_entries` entries and half as many steps.
struct Storage
{
    Record* records;
    std::uint8_t* counts; ///< 138xh sub 0 of each slot.
    std::uint32_t* entries;
    Step* steps;
    std::uint8_t* look_up;    ///< kLookUpSize bytes.
    std::uint8_t capacity;    ///< Number of records.
    std::uint8_t map_entries; ///< Of each dynamic mapping.
};

/// Memory for `kSlots` SRDOs with `kMapEntries` entries in each dynamic mapping; 0 where all mappings are static.
template <std::uint8_t kSlots, std::uint8_t kMapEntries = kUsualMapEntries> struct StorageFor
{
    static_assert((kSlots >= 1U) && (kSlots <= kMaxSrdoCount), "1 to 64 SRDOs");
    static_assert(((kMapEntries % 2U) == 0U) && (kMapEntries <= kMaxMapEntries), "entries come in pairs");

    /// An array has one element at least.
    static constexpr std::size_t kEntryCount =
        (kMapEntries == 0U) ? std::size_t{1U} : (std::size_t{kSlots} * kMapEntries);
    static constexpr std::size_t kStepCount = (kEntryCount + 1U) / 2U;

    Record records[kSlots];             // MISRA D-001
    std::uint32_t entries[kEntryCount]; // MISRA D-001
    Step steps[kStepCount];             // MISRA D-001
    std::uint8_t counts[kSlots];        // MISRA D-001
    std::uint8_t look_up[kLookUpSize];  // MISRA D-001

    [[nodiscard]] Storage Handle() noexcept
    {
        return Storage{&records[0], &counts[0], &entries[0], &steps[0], &look_up[0], kSlots, kMapEntries};
    }
};

} // namespace counterpoint::channel_a

#endif
