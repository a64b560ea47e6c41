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

/// A fact that grants something. It counts only if the byte is exactly its word: at least four bits lie between any two
/// words, those of Stage included. [SRS_CONS_024]
enum class Mark : std::uint8_t
{
    kUnset = 0U,
    kHeld = 0xC3U,    ///< A complete valid pair is held.
    kGranted = 0x3CU, ///< The pair was released, and no fault has come since.
    kWaits = 0x96U,   ///< An acknowledge edge waits.
    kGood = 0x69U,    ///< No fault was found.
    kRunning = 0xCCU, ///< SRDOs are active.
};

/// How far the transmission of a producer has come.
enum class Stage : std::uint8_t
{
    kIdle = 0x33U,    ///< Prepare may follow.
    kNormal = 0x55U,  ///< The normal frame has not been seen yet.
    kInverse = 0x66U, ///< Normal frame seen; the inverse frame has not been seen yet.
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

/// Canonical image of one SRDO without its entries: direction (1 byte), refresh time or SCT (2), SRVT (1), COB-ID 1 and
/// 2 (4 each), map count (1); behind it what the signature does not cover: transmission type (1), stored signature (2).
constexpr std::uint8_t kImageBytes = 16U;
/// 1300h and 13FEh.
constexpr std::uint8_t kDeviceBytes = 2U;
/// Identifiers 101h to 180h.
constexpr std::uint8_t kLookUpBytes = 128U;

/// What was set: by the configuration, and by the setups as far as the digest covers them.
struct SettingColumns
{
    Column<std::uint8_t> image; ///< kImageBytes for each slot.
    Column<std::uint8_t> device;
    Column<ReleasePolicy> policy;
    Column<ProducerForm> form;
    Column<SrvtDetection> detection;
};

/// Mappings that are stored, and where they lead.
struct MappingColumns
{
    Column<std::uint32_t> entries;     ///< `map_entries` for each slot.
    Column<std::uint16_t> places;      ///< As many: place in DeviceConfig::objects of each entry.
    Column<StaticFields> fields;       ///< As registered; only compared with, never followed.
    Column<std::uint64_t> mapped;      ///< Bits of the word that are mapped, found when the places were ...
    Column<std::uint8_t> length_bytes; ///< ... and the bytes that they take.
};

/// Pairs and their time. A budget is in microseconds and is what remains at the last OnCycle; it is over when it is
/// greater than the limit that it began with, because modular subtraction has then gone below zero. [SRS_TIME_001]
struct PairColumns
{
    Column<std::uint64_t> data;    ///< Consumer: inverse frame of the held pair. Producer: normal data in flight.
    Column<std::uint64_t> pending; ///< Consumer: normal frame that waits for its inverse.
    Column<std::uint32_t> left;    ///< Consumer: budget of SCT. Producer: of the confirmation.
    Column<std::uint32_t> limit;
    Column<std::uint32_t> srvt_left; ///< Consumer: budget of SRVT.
    Column<std::uint32_t> srvt_limit;
    Column<std::uint32_t> phase_left; ///< Consumer: budget of the acknowledge edge. Producer: to the next refresh.
    Column<std::uint32_t> ordinal;
    Column<Mark> held;
    Column<Mark> granted;
    Column<Mark> edge;
    Column<Stage> stage;
};

struct FaultColumns
{
    Column<std::uint32_t> causes;  ///< Bit (1 << cause): recorded and not reported yet.
    Column<std::uint32_t> signals; ///< Of the last OnCycle that signalled something.
    Column<std::uint16_t> error_count;
    Column<std::uint8_t> first_cause; ///< SrdoCause.
};

/// Which slots become active, and which identifiers lead to them.
struct AdmissionColumns
{
    Column<Mark> valid;           ///< The last Validate or Recheck found no fault.
    Column<Mark> resolved;        ///< The places belong to the mapping.
    Column<std::uint8_t> slot_of; ///< kLookUpBytes: slot of each identifier as of entering OPERATIONAL, or kNoSlot.
};

/// Owned by the caller.
struct Storage
{
    SettingColumns settings;
    MappingColumns mappings;
    PairColumns pairs;
    FaultColumns faults;
    AdmissionColumns admission;
    ChannelRoom room;
};

/// Memory for kSlots SRDOs, each with a dynamic mapping of up to kMapEntries entries (0: all mappings are static).
/// Zero-filled is a good start; Restart writes every byte that counts later.
template <std::uint8_t kSlots, std::uint8_t kMapEntries = kUsualMapEntries> struct StorageFor
{
    static_assert((kSlots >= 1U) && (kSlots <= kMaxSrdoCount), "1 to 64 SRDOs");
    static_assert(kMapEntries <= kMaxMapEntries, "at most 64 normal and 64 inverse objects");
    static constexpr std::size_t kEntries = (kMapEntries > 0U) ? (std::size_t{kSlots} * kMapEntries) : 1U;

    std::uint64_t data[kSlots];                            // MISRA D-001
    std::uint64_t pending[kSlots];                         // MISRA D-001
    std::uint64_t mapped[kSlots];                          // MISRA D-001
    StaticFields fields[kSlots];                           // MISRA D-001
    std::uint32_t entries[kEntries];                       // MISRA D-001
    std::uint32_t left[kSlots];                            // MISRA D-001
    std::uint32_t limit[kSlots];                           // MISRA D-001
    std::uint32_t srvt_left[kSlots];                       // MISRA D-001
    std::uint32_t srvt_limit[kSlots];                      // MISRA D-001
    std::uint32_t phase_left[kSlots];                      // MISRA D-001
    std::uint32_t ordinal[kSlots];                         // MISRA D-001
    std::uint32_t causes[kSlots];                          // MISRA D-001
    std::uint32_t signals[kSlots];                         // MISRA D-001
    std::uint16_t error_count[kSlots];                     // MISRA D-001
    std::uint16_t places[kEntries];                        // MISRA D-001
    std::uint8_t image[std::size_t{kSlots} * kImageBytes]; // MISRA D-001
    std::uint8_t length_bytes[kSlots];                     // MISRA D-001
    std::uint8_t first_cause[kSlots];                      // MISRA D-001
    Mark held[kSlots];                                     // MISRA D-001
    Mark granted[kSlots];                                  // MISRA D-001
    Mark edge[kSlots];                                     // MISRA D-001
    Mark valid[kSlots];                                    // MISRA D-001
    Mark resolved[kSlots];                                 // MISRA D-001
    Stage stage[kSlots];                                   // MISRA D-001
    ReleasePolicy policy[kSlots];                          // MISRA D-001
    ProducerForm form[kSlots];                             // MISRA D-001
    SrvtDetection detection[kSlots];                       // MISRA D-001
    std::uint8_t slot_of[kLookUpBytes];                    // MISRA D-001
    std::uint8_t device[kDeviceBytes];                     // MISRA D-001

    /// What the constructor of the channel wants.
    [[nodiscard]] Storage Handle() noexcept
    {
        return Storage{{{image}, {device}, {policy}, {form}, {detection}},
                       {{entries}, {places}, {fields}, {mapped}, {length_bytes}},
                       {{data},
                        {pending},
                        {left},
                        {limit},
                        {srvt_left},
                        {srvt_limit},
                        {phase_left},
                        {ordinal},
                        {held},
                        {granted},
                        {edge},
                        {stage}},
                       {{causes}, {signals}, {error_count}, {first_cause}},
                       {{valid}, {resolved}, {slot_of}},
                       {kSlots, kMapEntries}};
    }
};

} // namespace counterpoint::channel_b

#endif
