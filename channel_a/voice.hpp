// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_VOICE_HPP
#define CHANNEL_A_VOICE_HPP

#include "channel_a/slots.hpp"
#include "channel_a/storage.hpp"
#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/channel.hpp"
#include "safety_core/contract/configuration.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{

/// Places in Voice::globals, in the order of their ConfigField.
constexpr std::size_t kGfcParameterPlace = 0U;
constexpr std::size_t kConfigurationValidPlace = 1U;
constexpr std::size_t kGlobalCount = 2U;

/// Everything that is not of one SRDO. Restart makes it anew but for the storage; zero is the start of nearly all the
/// rest.
struct Voice
{
    Storage storage;
    const DeviceConfig* config;
    CanPortId ports[2]; ///< Controllers of the normal frames (0) and of the inverse frames (1). MISRA D-001
    std::uint8_t count;
    std::uint8_t globals[kGlobalCount]; ///< 1300h, then 13FEh. MISRA D-001
    bool has_run;
    bool may_send; ///< The first possible transmission has come.
    bool gfc_pending;
    bool is_late; ///< The OnCycle that runs.
    bool has_overflow;
    Instant now;
    Instant entered;              ///< OPERATIONAL, by the OnCycle that saw it first.
    Instant origin;               ///< The later of the first possible transmission and `now`.
    std::uint32_t step_us;        ///< Since the OnCycle before.
    std::uint32_t late_after_us;  ///< Since the OnCycle before.
    std::uint32_t first_delay_us; ///< From OPERATIONAL to the first possible transmission.
    /// What the next OnCycle returns, kept up to date by every event; the states of the slots are kept nowhere else as
    /// masks.
    CycleOutcome outcome;
    SrdoMask producers; ///< Active ones.
    SrdoMask wanted;    ///< Slots that are asked for or refreshed and were not prepared since.
    SrdoMask unwritten; ///< The held pair was not written yet.
    SrdoMask committed; ///< The objects hold a pair.
    SrdoMask levels;    ///< Acknowledge inputs as the last OnCycle saw them.
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

[[nodiscard]] inline Record& At(const Voice& voice, const std::size_t slot) noexcept
{
    return voice.storage.records[slot]; // MISRA D-002
}

/// @brief The row of a dynamic mapping.
[[nodiscard]] inline std::uint32_t* RowOf(const Voice& voice, const std::size_t slot) noexcept
{
    return voice.storage.entries + (slot * voice.storage.row); // MISRA D-002
}

/// @brief OPERATIONAL with a valid configuration.
[[nodiscard]] inline bool IsActive(const Voice& voice) noexcept
{
    return voice.outcome.not_operational == 0U;
}

/// @brief Which slot an identifier from 101h to 180h leads to; any other one leads where one of these does.
[[nodiscard]] inline std::uint8_t& LookUp(const Voice& voice, const std::uint32_t identifier) noexcept
{
    return voice.storage.look_up[identifier % kLookUpSize]; // MISRA D-002
}

[[nodiscard]] inline bool Is(const Record& record, const std::uint32_t bits) noexcept
{
    return (record.mode & bits) != 0U;
}

inline void Demand(Record& record, const std::uint32_t todo) noexcept
{
    record.todo = static_cast<std::uint8_t>(record.todo | todo);
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

// state.cpp: what follows every event, in one place.

/// @brief The slot's bit in one mask.
void Put(SrdoMask& mask, std::size_t slot, std::uint32_t is_in) noexcept;
/// @brief A mode with another state: the masks of the outcome follow it.
void Turn(Voice& voice, std::size_t slot, std::uint32_t mode) noexcept;
/// @brief A consumer loses what it held and is faulted; a pending normal frame stays if `kept` is kPending.
void Drop(Voice& voice, std::size_t slot, std::uint32_t kept) noexcept;
/// @brief Counts a fault and keeps it if it is the first. [SRS_CONS_020]
void Count(Record& record, SrdoCause cause) noexcept;
/// @brief A fault that the next OnCycle, or the one that goes on, tells.
void Report(Record& record, SrdoCause cause) noexcept;
/// @brief A fault of a consumer. [SRS_CONS_012]
void Fail(Voice& voice, std::size_t slot, SrdoCause cause) noexcept;
/// @brief A fault that gives up the pair in flight; nothing where there is none.
void Abort(Record& record, SrdoCause cause) noexcept;
/// @brief The limit of a consumer that has expired, the one with the earlier deadline; kNone if none has. SRVT with
/// late detection counts for an inverse frame only. [SRS_TIME_008, SRS_TIME_009]
[[nodiscard]] SrdoCause ExpiredLimit(const Record& record, Instant when, std::size_t half) noexcept;
/// @brief Every SRDO with a valid configuration becomes active, as of `now`.
void Enter(Voice& voice) noexcept;
/// @brief None is active any more.
void Leave(Voice& voice) noexcept;

// signature.cpp

/// @brief CRC-16 over the values of one SRDO, each fed as it is read. O(entries) [SRS_CFG_010]
[[nodiscard]] std::uint32_t Signature(const Record& record, const Mapping& mapping) noexcept;

// mapping.cpp: the only source that knows what entries name.

/// @brief The mapping of one SRDO, be it dynamic or static.
[[nodiscard]] Mapping MappingOf(const Voice& voice, std::size_t slot) noexcept;
/// @brief SRS_CFG_026, SRS_CFG_027, SRS_CFG_028; keeps the places of the objects of a dynamic mapping.
[[nodiscard]] ConfigFault Resolve(const DeviceConfig& config, Record& record, const Mapping& mapping) noexcept;
/// @brief Whether the places still lead to what the entries name. [SRS_CFG_030]
[[nodiscard]] bool HoldsTable(const DeviceConfig& config, const Record& record, const Mapping& mapping) noexcept;

// objects.cpp: the only source that reads and writes objects.

/// @brief The object of an entry; one without a single bit where its place leads to none.
[[nodiscard]] const MappableObject& ObjectAt(const DeviceConfig& config, const Mapping& mapping,
                                             std::uint32_t position) noexcept;
/// @brief Data into the normal objects.
void WriteObjects(const Voice& voice, std::size_t slot, const Payload& data) noexcept;

} // namespace counterpoint::channel_a

#endif
