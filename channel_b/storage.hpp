// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_STORAGE_HPP
#define CHANNEL_B_STORAGE_HPP

#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/configuration.hpp"
#include "safety_core/contract/limits.hpp"
#include "safety_core/contract/srdo.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

/// Canonical image of one SRDO without its entries: direction (1 byte), refresh time or SCT (2), SRVT (1), COB-ID 1 and
/// 2 (4 each), map count (1); behind it what the signature does not cover: transmission type (1), stored signature (2).
constexpr std::uint8_t kImageBytes = 16U;
/// Identifiers 101h to 180h.
constexpr std::uint8_t kLookUpBytes = 128U;
/// 1300h and 13FEh.
constexpr std::uint8_t kDeviceBytes = 2U;

/// What an active SRDO is. Sealed: at least two bits lie between any two of them, and what is none of them is nothing.
/// The consumers have a high half of their own.
enum class Standing : std::uint8_t
{
    kOff = 0U,
    kWaiting = 0x63U,
    kFaulted = 0x65U,
    kReleased = 0x6EU,
    kProducer = 0x98U,
};

/// How far the transmission of a producer has come.
enum class Stage : std::uint8_t
{
    kOff = 0U,          ///< Not an active producer.
    kIdle = 0x2BU,      ///< Prepare may follow.
    kPrepared = 0x4EU,  ///< The normal frame of the other channel has not been seen yet.
    kToSend = 0x71U,    ///< Normal frame seen; the inverse frame has to be handed out.
    kHandedOut = 0x98U, ///< The inverse frame has not been seen yet.
};

// Sealed marks: set only if the byte is exactly this one.
constexpr std::uint8_t kHeld = 0xC6U;
constexpr std::uint8_t kWaits = 0x5CU;
constexpr std::uint8_t kGood = 0x93U;
constexpr std::uint8_t kUnset = 0U;

// Bits of Row::news: what OnCycle has to look at. None of them grants anything by itself.
constexpr std::uint32_t kPending = 0x01U;    ///< Consumer: a normal frame waits for its inverse frame.
constexpr std::uint32_t kStarted = 0x01U;    ///< Producer: its first transmission is possible.
constexpr std::uint32_t kFresh = 0x02U;      ///< Consumer: a pair was completed since the last OnCycle.
constexpr std::uint32_t kRefreshDue = 0x02U; ///< Producer: its refresh has fallen due.
constexpr std::uint32_t kUnheard = 0x04U;    ///< Consumer: no pair, fault or complaint since OPERATIONAL was entered.
constexpr std::uint32_t kRequested = 0x04U;  ///< Producer: the application wants to send.
constexpr std::uint32_t kEdge = 0x08U;       ///< Consumer: Row::edge is to be looked at.
constexpr std::uint32_t kReported = 0x10U;   ///< Row::causes is to be reported.
constexpr std::uint32_t kWindowOpen = 0x20U; ///< A window of signals is running.
constexpr std::uint32_t kSilence = 0x40U;    ///< Producer: the phase is that of the application's silence.

/// One field of all slots.
template <typename T> struct Column
{
    T* first;

    T& operator[](std::size_t index) const noexcept
    {
        return first[index]; // MISRA D-002
    }
};

/// All of one slot but its entries; what is used most comes first, where the shortest instructions reach it. Budgets
/// are microseconds that remain, as of the last OnCycle; a budget is spent when it exceeds what it started with
/// (modular subtraction has then gone below zero).
struct Row
{
    std::uint32_t left;       ///< Consumer: budget of SCT while a pair is held. Producer: of the confirmation.
    std::uint32_t limit;      ///< What `left` started with; all bits set if nothing runs.
    Standing standing;        ///< These four bytes are looked at in one word by every cycle.
    std::uint8_t held;        ///< kHeld: a complete valid pair is held.
    std::uint8_t first_cause; ///< SrdoCause.
    std::uint8_t news;
    std::uint32_t ordinal; ///< Consumer: pairs completed. Producer: pairs sent. Else 0.
    std::uint8_t edge;     ///< kWaits: an acknowledge edge waits.
    ReleasePolicy policy;  ///< Of the setup, as the next two.
    ProducerForm form;
    SrvtDetection detection;
    Stage stage;
    std::uint8_t length_bits;        ///< Of the mapped data.
    std::uint8_t valid;              ///< kGood: the last Validate or Recheck found no fault.
    std::uint8_t resolved;           ///< kGood: the table of objects belongs to the mapping.
    std::uint8_t image[kImageBytes]; // MISRA D-001
    std::uint16_t error_count;
    std::uint32_t phase_left; ///< Consumer: budget of the acknowledge edge. Producer: to the next refresh.
    std::uint32_t srvt_left;  ///< Consumer: budget of SRVT while a normal frame is pending.
    std::uint32_t srvt_limit; ///< What `srvt_left` started with; all bits set if nothing is pending.
    std::uint32_t window_us;  ///< Age of the window of signals.
    std::uint32_t causes;     ///< Bit (1 << cause): recorded and not reported yet.
    std::uint32_t told;       ///< Signalled in the open window.
    std::uint32_t signals;    ///< Of the last OnCycle.
    CanFrame awaited;    ///< Producer: the frame that must be on the bus next; identifier 0 if none is in flight. Its
                         ///< length is that of all frames of the slot.
    std::uint64_t mask;  ///< All bits of the bytes of a frame.
    std::uint64_t spare; ///< Of those the bits above the mapped length: 0 in the normal frame.
    std::uint64_t inverse_data; ///< Inverse data of the held pair; behind the length anything.
    std::uint64_t pending_data; ///< Normal data that wait for their inverse.
    std::uint32_t unused;       ///< Fills the row up to 128 bytes, so that a shift finds it.
    std::uint32_t words;        ///< Of a mapping of four entries the places of its two inverse objects, else kNoWords.
};

/// Owned by the caller: `capacity` rows, and for each `map_entries` entries.
struct Storage
{
    Column<Row> rows;
    Column<std::uint8_t> slot_of;  ///< kLookUpBytes: slot of each identifier as of entering OPERATIONAL, or kNoSlot.
    Column<std::uint8_t> device;   ///< kDeviceBytes.
    Column<StaticFields> fields;   ///< One for each slot, as registered; only compared with, never followed.
    Column<std::uint32_t> entries; ///< `map_entries` for each slot: mapping as stored.
    Column<std::uint16_t> table;   ///< As many: place in DeviceConfig::objects of each entry.
    std::uint8_t capacity;
    std::uint8_t map_entries;
};

/// Memory for kSlots SRDOs, each with a dynamic mapping of up to kMapEntries entries (0: all mappings are static).
/// Zero-filled is a good start; Restart writes every byte that counts later.
template <std::uint8_t kSlots, std::uint8_t kMapEntries = kUsualMapEntries> struct StorageFor
{
    static_assert((kSlots >= 1U) && (kSlots <= kMaxSrdoCount), "1 to 64 SRDOs");
    static_assert(kMapEntries <= kMaxMapEntries, "at most 64 normal and 64 inverse objects");
    static constexpr std::size_t kEntries = (kMapEntries > 0U) ? (std::size_t{kSlots} * kMapEntries) : 1U;

    Row rows[kSlots];                   // MISRA D-001
    StaticFields fields[kSlots];        // MISRA D-001
    std::uint32_t entries[kEntries];    // MISRA D-001
    std::uint16_t table[kEntries];      // MISRA D-001
    std::uint8_t slot_of[kLookUpBytes]; // MISRA D-001
    std::uint8_t device[kDeviceBytes];  // MISRA D-001

    /// What the constructor of the channel wants.
    [[nodiscard]] Storage Handle() noexcept
    {
        return Storage{{rows}, {slot_of}, {device}, {fields}, {entries}, {table}, kSlots, kMapEntries};
    }
};

} // namespace counterpoint::channel_b

#endif
