// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_VOICE_HPP
#define CHANNEL_A_VOICE_HPP

#include "channel_a/slots.hpp"
#include "channel_a/storage.hpp"
#include "channel_a/transitions.hpp"
#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/configuration.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{

/// Places in Voice::globals, in the order of their ConfigField.
constexpr std::size_t kGfcParameterPlace = 0U;
constexpr std::size_t kConfigurationValidPlace = 1U;
constexpr std::size_t kGlobalCount = 2U;

/// Everything that is not of one SRDO. Restart makes it anew but for the storage; zero is the start of all the rest.
struct Voice
{
    Storage storage;
    const DeviceConfig* config;
    CanPortId ports[2]; ///< Controllers of the normal frames (0) and of the inverse frames (1). MISRA D-001
    std::uint8_t count;
    std::uint8_t globals[kGlobalCount]; ///< 1300h, then 13FEh. MISRA D-001
    std::uint8_t consumer_count;
    std::uint8_t producer_count;
    std::uint8_t off_count;
    bool is_active; ///< OPERATIONAL with a valid configuration.
    bool has_run;
    bool may_send; ///< The first possible transmission has come.
    bool gfc_pending;
    Instant now;
    Instant entered; ///< OPERATIONAL, by the OnCycle that saw it first.
    std::uint32_t cycle;
    std::uint32_t late_after_us;  ///< Since the OnCycle before.
    std::uint32_t first_delay_us; ///< From OPERATIONAL to the first possible transmission.
    std::uint32_t ordinal_sum;
    SrdoMask fresh;
    SrdoMask attention;           ///< Slots that the next OnCycle has to serve even if no limit expires.
    SrdoMask flying;              ///< Producers with a pair in flight.
    SrdoMask requested;           ///< Producers whose application asked for sending.
    SrdoMask groups[kGroupCount]; ///< MISRA D-001
    SrdoMask unwritten;           ///< The held pair was not written yet.
    SrdoMask committed;           ///< The objects hold a pair.
    SrdoMask levels;              ///< Acknowledge inputs as the last OnCycle saw them.
    SrdoMask refreshed;           ///< Producers that are due by a refresh.

    // What the OnCycle that runs is about.
    SrdoMask edges;    ///< Acknowledge inputs that went from 0 to 1.
    SrdoMask standing; ///< Producers whose refresh stood still, if of the form that is called.
    SrdoMask new_fault;
    SrdoMask signalled;
    std::uint32_t step_us; ///< Since the OnCycle before.
    bool is_late;
    bool has_overflow;
    bool has_gfc;
};

/// What comes from the bus: a normal frame (or none), or an inverse frame.
enum class Half : std::uint8_t
{
    kNormal = 0U,
    kInverse = 1U,
};

/// The entries of one SRDO and where their objects are.
struct Mapping
{
    const std::uint32_t* entries;
    std::uint16_t* places; ///< In DeviceConfig::objects, of the entry of the same position; null: a static mapping,
                           ///< whose objects are looked up.
    std::uint32_t count;   ///< As the loops over a mapping use it: at most `limit`, whatever is stored.
    std::uint32_t stored_count;
    std::uint32_t limit;
};

[[nodiscard]] inline Record& At(const Voice& voice, const std::uint32_t slot) noexcept
{
    return voice.storage.records[slot]; // MISRA D-002
}

/// @brief Not below the count where no SRDO has this identifier.
[[nodiscard]] inline std::uint32_t SlotOfPlace(const Voice& voice, const std::uint32_t place) noexcept
{
    return voice.storage.look_up[place >> 1U]; // MISRA D-002
}

[[nodiscard]] inline SrdoMask ConsumersOf(const Voice& voice) noexcept
{
    return voice.groups[kGroupWaiting] | voice.groups[kGroupFaulted] | voice.groups[kGroupReleased];
}

/// @brief Whether the limit that the cycle looks at has passed.
[[nodiscard]] inline bool IsExpired(const Record& record, const Instant when) noexcept
{
    return (when.us - record.since.us) > record.limit_us;
}

/// @brief Refresh time or SCT.
[[nodiscard]] inline std::uint32_t SctUs(const Record& record) noexcept
{
    return record.values[kSctPlace] * kMicrosecondsPerMillisecond;
}

[[nodiscard]] inline std::uint32_t SrvtUs(const Record& record) noexcept
{
    return record.values[kSrvtPlace] * kMicrosecondsPerMillisecond;
}

// channel.cpp: what follows every event, in one place.

/// @brief A step of the table and its fault, if it is one; `given` is the cause where the cell names none.
void Raise(Voice& voice, std::uint32_t slot, Event event, SrdoCause given) noexcept;
/// @brief Counts a fault and keeps it if it is the first. [SRS-CONS-020]
void Count(Record& record, SrdoCause cause) noexcept;
/// @brief A fault that the next OnCycle, or the one that goes on, tells.
void Report(Voice& voice, std::uint32_t slot, SrdoCause cause) noexcept;
/// @brief The next OnCycle, or the one that goes on, serves the slot. Not inline: loops are shorter without a mask.
void Mark(Voice& voice, std::uint32_t slot) noexcept;
/// @brief Of a slot with late detection: whether the pending normal frame is too old for an inverse one. [SRS-TIME-009]
[[nodiscard]] bool IsTooOld(const Record& record, Instant when) noexcept;
/// @brief SRVT or SCT has expired: a fault by the one with the earlier deadline. [SRS-TIME-008]
void Expire(Voice& voice, std::uint32_t slot, Instant when, Half half) noexcept;
/// @brief Every SRDO with a valid configuration becomes active.
void Enter(Voice& voice, Instant now) noexcept;
/// @brief None is active any more.
void Leave(Voice& voice) noexcept;
/// @brief No identifier leads to an SRDO any more.
void ClearLookUp(const Voice& voice) noexcept;
/// @brief Puts slots into the mask of their group.
void MoveTo(Voice& voice, SrdoMask bits, std::uint8_t group) noexcept;

/// @brief A frame that no SRDO has for its own.
void ReceiveOther(Voice& voice, const CanFrame& frame) noexcept;
/// @brief A frame that is not as it should be.
void ReceiveOdd(Voice& voice, const CanFrame& frame, std::uint32_t slot) noexcept;
// mapping.cpp: the only source that knows where objects are and how long.

/// @brief The mapping of one SRDO, be it dynamic or static.
[[nodiscard]] Mapping MappingOf(const Voice& voice, std::uint32_t slot) noexcept;
/// @brief SRS-CFG-026 to 028; keeps the places of the objects of a dynamic mapping.
[[nodiscard]] ConfigFault Resolve(const DeviceConfig& config, Record& record, const Mapping& mapping) noexcept;
/// @brief Whether the places still lead to what the entries name. [SRS-CFG-030]
[[nodiscard]] bool HoldsTable(const DeviceConfig& config, const Record& record, const Mapping& mapping) noexcept;
/// @brief Data into the normal objects.
void WriteObjects(const Voice& voice, std::uint32_t slot, const Octets& data) noexcept;

} // namespace counterpoint::channel_a

#endif
