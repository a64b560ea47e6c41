// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The SDOs of the EL6751 start-up: which one comes next, what it says and what its answer means. Pure functions.
#ifndef CANOPEN_START_UP_EL6751_ROWS_HPP
#define CANOPEN_START_UP_EL6751_ROWS_HPP

#include "canopen/cia302/network/concise_dcf.hpp"
#include "canopen/cia302/network/start_up.hpp"
#include "canopen/start_up/el6751/setup.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// The rows of the text, in its order. Those from kCobId to kEventReadBack are passed once for each PDO.
enum class El6751Row : std::uint8_t
{
    kBegin = 0U,
    kDeviceType,
    kVendorId,
    kProductCode,
    kRevisionNumber,
    kSerialNumber,
    kSyncPeriod,
    kCouplerPdos,
    kCobId,
    kCobIdReadBack,
    kType,
    kTypeReadBack,
    kInhibit,
    kInhibitReadBack,
    kEvent,
    kEventReadBack,
    kProducerHeartbeat,
    kConsumerHeartbeat,
    kGuardTime,
    kLifeTimeFactor,
    kUserObject,
    kEnd,
};

/// Where a slave is in its list. Zero-filled: before the first row.
struct El6751Place
{
    El6751Row row;
    std::uint8_t pdo; ///< Position of a PDO, see El6751PdoOf.
    ConcisePosition user;
    bool is_aborted;            ///< The server aborted this row: its read-back is due.
    bool is_heartbeat_aborted;  ///< 1017h: guarding instead.
    bool is_heartbeat_answered; ///< 1017h was written at all.
};

/// What decides which rows a slave has.
struct El6751Context
{
    const NetworkSetup& setup;
    NodeId node;
    bool is_sync_sent;
};

/// The SDO of a row.
struct El6751Access
{
    ObjectAddress object;
    StartUpStep step;
    bool is_upload;
    bool is_compared;        ///< An upload that must give `value`.
    std::uint8_t size_bytes; ///< Length of `value`; 0: `user` is written.
    std::uint32_t value;
    Bytes user;
};

/// What an answer means for the start-up. Values above kNext are the NodeState that follows.
enum class El6751Verdict : std::uint8_t
{
    kInvalid = 0U,
    kNext = 1U,
    kNotFound = 2U, ///< Nobody answered the first SDO, which is sent again.
    kSyntax = 4U,   ///< The SDO was aborted, or its value has a wrong length: the start-up ends.
    kMismatch = 5U, ///< The value is not the configured one: the start-up ends.
};

/// How an SDO ended.
struct El6751Answer
{
    SdoOutcome outcome;
    std::uint64_t read; ///< What an upload has read.
    bool is_first;      ///< The slave had not answered anything in this start-up.
};

/// @brief The next row that is active under its conditions, or kEnd. O(rows) [SRS_ELM_004, SRS_ELM_005, SRS_ELM_006,
/// SRS_ELM_007, SRS_ELM_008, SRS_ELM_010, SRS_ELM_011, SRS_ELM_012, SRS_ELM_013, SRS_ELM_014, SRS_ELM_015, SRS_ELM_016,
/// SRS_ELM_017, SRS_ELM_018, SRS_ELM_019, SRS_ELM_020, SRS_ELM_021, SRS_ELM_022, SRS_ELM_023, SRS_ELM_024, SRS_ELM_151]
[[nodiscard]] El6751Place NextRow(const El6751Context& context, const El6751Place& place) noexcept;
/// @brief The SDO of a row, neither kBegin nor kEnd. O(1)
[[nodiscard]] El6751Access AccessOf(const El6751Context& context, const El6751Place& place) noexcept;
/// @brief What an answer means for the start-up. O(1) [SRS_ELM_003, SRS_ELM_004, SRS_ELM_005, SRS_ELM_006, SRS_ELM_007,
/// SRS_ELM_008, SRS_ELM_010, SRS_ELM_011, SRS_ELM_012, SRS_ELM_013, SRS_ELM_014, SRS_ELM_015, SRS_ELM_016, SRS_ELM_017,
/// SRS_ELM_018, SRS_ELM_019, SRS_ELM_020, SRS_ELM_021, SRS_ELM_022, SRS_ELM_023, SRS_ELM_024, SRS_ELM_025]
[[nodiscard]] El6751Verdict JudgeAnswer(const El6751Access& access, El6751Row row, const El6751Answer& answer) noexcept;
/// @brief The place after an answer that was judged kNext, with what the conditions of later rows need.
[[nodiscard]] El6751Place Remember(const El6751Place& place, const SdoOutcome& outcome) noexcept;

} // namespace counterpoint::cia302

#endif
