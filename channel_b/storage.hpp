// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_STORAGE_HPP
#define CHANNEL_B_STORAGE_HPP

#include "safety_core/contract/configuration.hpp"
#include "safety_core/contract/limits.hpp"
#include "safety_core/contract/srdo.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

/// Canonical image of one SRDO without its direction and its entries: refresh time or SCT (2 bytes), SRVT (1), COB-ID 1
/// and 2 (4 each), map count (1); behind it what the signature does not cover: transmission type (1), stored signature
/// (2).
constexpr std::uint8_t kImageBytes = 15U;
/// Identifiers 101h to 180h.
constexpr std::uint8_t kLookUpBytes = 128U;
/// 1300h and 13FEh.
constexpr std::uint8_t kDeviceBytes = 2U;

/// One bit for each slot of one half: slots 0 to 31, or 32 to 63. A word of a small processor holds it.
using HalfMask = std::uint32_t;
constexpr std::uint8_t kSlotsInHalf = 32U;
constexpr std::uint8_t kHalves = kMaxSrdoCount / kSlotsInHalf;

/// How far the transmission of a producer has come. Zero-filled memory is kInvalid: nothing is sent.
enum class Stage : std::uint8_t
{
    kInvalid = 0U,
    kOff = 0x1DU,          ///< Not an active producer.
    kIdle = 0x2BU,         ///< Prepare may follow.
    kAwaitNormal = 0x4EU,  ///< Prepared; the normal frame of the other channel has not been seen yet.
    kAwaitInverse = 0x98U, ///< Normal frame seen; the inverse frame has not been seen yet.
};

/// Whether the inverse frame has still to be handed out.
constexpr std::uint8_t kToSend = 0x71U;
constexpr std::uint8_t kHandedOut = 0U;

/// One mark for each slot that grants something: kept twice, once inverted. Only `on` without `off` counts as set; a
/// slot for which both agree is corrupted.
struct TwinMask
{
    HalfMask on;
    HalfMask off;
};

/// Of the slots of one half: bit n is slot n of it.
struct Marks
{
    TwinMask held;         ///< A complete valid pair is held.
    TwinMask acknowledged; ///< An acknowledge edge waits.
    TwinMask automatic;    ///< Policy kAutomatic.
    TwinMask valid;        ///< The last Validate or Recheck found no fault.
    TwinMask enrolled;     ///< Active since OPERATIONAL was entered.
    TwinMask released;     ///< Consumers that are released; less those that had a fault since.
    HalfMask pending;      ///< A normal frame waits for its inverse frame.
    HalfMask consumers;    ///< Active consumers as of the last OnCycle, which takes them from the enrolled ones.
    HalfMask producers;    ///< Those of the enrolled ones that are producers.
    HalfMask faulted;      ///< Consumers with a fault since they were released or entered OPERATIONAL.
    HalfMask fresh;        ///< A pair was completed since the last OnCycle.
    HalfMask committed;    ///< The objects hold a released pair.
    HalfMask unwritten;    ///< The held pair has not been written into the objects.
    HalfMask reporting;    ///< A fault has not been reported by OnCycle yet.
    HalfMask signalled;    ///< The last OnCycle signalled something.
    HalfMask unheard;      ///< Consumers without a pair and without a complaint about it since OPERATIONAL was entered.
    HalfMask window_open;  ///< A window of signals is running.
    HalfMask resolved;     ///< The table of objects belongs to the stored mapping.
    HalfMask requested;    ///< Producers that the application wants to send.
    HalfMask started;      ///< Producers whose first transmission is possible.
    HalfMask refresh_due;  ///< Producers whose refresh has fallen due.
    HalfMask provider;     ///< Producers of the form kProviderCalled.
    HalfMask late;         ///< Late detection of SRVT.
};

/// One field of all slots.
template <typename T> struct Column
{
    T* first;

    T& operator[](std::size_t index) const noexcept
    {
        return first[index]; // MISRA D-002
    }
};

/// What frames and faults lead to, slot by slot: no loop over all slots looks at it.
struct Row
{
    std::uint64_t
        inverse_data; ///< Inverse data of the held pair, or of the pair being sent; behind the length anything.
    std::uint64_t pending_data; ///< Normal data that wait for their inverse.
    std::uint64_t mask;         ///< All bits of the bytes of a frame.
    std::uint64_t spare;        ///< Of those the bits above the mapped length: 0 in the normal frame.
    std::uint32_t sent;         ///< Producer: pairs sent; else 0.
    std::uint32_t causes;       ///< Bit (1 << cause): recorded and not reported yet.
    std::uint32_t signals;      ///< Of the last OnCycle, where Marks::signalled says so.
    std::uint32_t told;         ///< Signalled in the open window.
    std::uint32_t window_left;  ///< Budget of the window of signals.
    std::uint32_t srvt_left;    ///< With late detection: budget of SRVT of the pending normal frame.
    std::uint32_t srvt_limit;   ///< What srvt_left started with.
    StaticFields fields;        ///< As registered; only compared with, never followed.
    std::uint16_t error_count;
    Stage stage;
    std::uint8_t length_bytes;       ///< Of a frame.
    std::uint8_t image[kImageBytes]; ///< MISRA D-001
    std::uint8_t to_send;            ///< kToSend or kHandedOut; counts while the inverse frame is awaited.
};

/// A mapping as it counts: of the program (static), or as stored.
struct Mapping
{
    Column<const std::uint32_t> entries;
    std::uint16_t declared; ///< Map count as set.
    std::uint16_t count;    ///< Entries that count: what is declared above those that exist does not. [SRS-CFG-020]
    std::uint32_t first;    ///< Of a dynamic mapping: where its part of entries and table begins; else kStatic.
};
constexpr std::uint32_t kStatic = 0xFFFFFFFFU;

/// A column for each field that every cycle looks at in all slots, and a row a slot for the rest; owned by the caller.
/// `capacity` slots; first_cause has room for the next multiple of 8, because it is examined eight at a time. Budgets
/// are microseconds that remain, as of the last OnCycle; a budget is spent when it exceeds its own limit (modular
/// subtraction has then gone below zero).
struct Storage
{
    Column<Row> rows;
    Column<Marks> marks;              ///< kHalves.
    Column<std::uint32_t> pair_left;  ///< Budget of SRVT while something is pending or in flight, else of SCT; with
                                      ///< late detection always of SCT.
    Column<std::uint32_t> pair_limit; ///< What pair_left started with; all bits set if nothing runs.
    Column<std::uint32_t> phase_left; ///< Consumer: of the acknowledge edge. Producer: to the next refresh.
    Column<std::uint32_t> ordinal;    ///< Consumer: pairs completed; else 0.
    Column<std::uint8_t> direction;   ///< First byte of the canonical image.
    Column<std::uint8_t> first_cause; ///< SrdoCause. A byte: one look takes eight.
    Column<std::uint8_t> slot_of;     ///< kLookUpBytes: slot of each identifier while SRDOs are active, or kNoSlot.
    Column<std::uint8_t> device;      ///< kDeviceBytes.
    Column<std::uint32_t> entries;    ///< `map_entries` for each slot: mapping as stored.
    Column<std::uint16_t> table;      ///< As many: place in DeviceConfig::objects of each entry.
    std::uint8_t capacity;
    std::uint8_t map_entries;
};

/// Memory for kSlots SRDOs, each with a dynamic mapping of up to kMapEntries entries (0: all mappings are static).
/// Zero-filled is a good start; Restart writes every byte that is read later.
template <std::uint8_t kSlots, std::uint8_t kMapEntries = kUsualMapEntries> struct StorageFor
{
    static_assert((kSlots >= 1U) && (kSlots <= kMaxSrdoCount), "1 to 64 SRDOs");
    static_assert(kMapEntries <= kMaxMapEntries, "at most 64 normal and 64 inverse objects");
    static constexpr std::size_t kEntries = (kMapEntries > 0U) ? (std::size_t{kSlots} * kMapEntries) : 1U;
    static constexpr std::size_t kPadded = ((kSlots + 7U) / 8U) * 8U;

    Row rows[kSlots];                   // MISRA D-001
    Marks marks[kHalves];               // MISRA D-001
    std::uint32_t pair_left[kSlots];    // MISRA D-001
    std::uint32_t pair_limit[kSlots];   // MISRA D-001
    std::uint32_t phase_left[kSlots];   // MISRA D-001
    std::uint32_t ordinal[kSlots];      // MISRA D-001
    std::uint32_t entries[kEntries];    // MISRA D-001
    std::uint16_t table[kEntries];      // MISRA D-001
    std::uint8_t direction[kSlots];     // MISRA D-001
    std::uint8_t first_cause[kPadded];  // MISRA D-001
    std::uint8_t slot_of[kLookUpBytes]; // MISRA D-001
    std::uint8_t device[kDeviceBytes];  // MISRA D-001

    /// What the constructor of the channel wants.
    [[nodiscard]] Storage Handle() noexcept
    {
        return Storage{{rows},        {marks},   {pair_left}, {pair_limit}, {phase_left}, {ordinal}, {direction},
                       {first_cause}, {slot_of}, {device},    {entries},    {table},      kSlots,    kMapEntries};
    }
};

} // namespace counterpoint::channel_b

#endif
