// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_VOICE_HPP
#define CHANNEL_A_VOICE_HPP

#include "channel_a/storage.hpp"
#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/channel.hpp"
#include "safety_core/contract/configuration.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{

/// Everything that is not of one SRDO. Restart makes it anew but for the storage.
struct Voice
{
    Storage storage;
    const DeviceConfig* config;
    CanPortId ports[2]; ///< Controllers of the normal frames (0) and of the inverse frames (1). MISRA D-001
    std::uint8_t count;
    std::uint8_t gfc_parameter;       ///< 1300h.
    std::uint8_t configuration_valid; ///< 13FEh.
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
    /// What the next OnCycle returns, kept up to date by every event; `due` and `refresh` are made by each anew.
    CycleOutcome outcome;
    SrdoMask producers; ///< Active ones.
    SrdoMask wanted;    ///< Slots that are asked for and were not prepared since.
    SrdoMask unwritten; ///< The held pair was not written yet.
    SrdoMask committed; ///< The objects hold a pair.
    SrdoMask permitted; ///< Slots of the permit, beside those that are not. [SRS_REL_010]
    SrdoMask refused;
    SrdoMask low_levels; ///< Slots with an acknowledge level of 0, beside those with 1. [SRS_REL_005]
    SrdoMask high_levels;
    SrdoMask reading;                   ///< Acknowledge inputs as the last OnCycle read them.
    Step static_steps[kMaxStaticSteps]; ///< Of a static mapping, worked out at every use. MISRA D-001
};

/// The halves of a pair, as places of what there is one of for each.
constexpr std::size_t kNormalHalf = 0U;
constexpr std::size_t kInverseHalf = 1U;

[[nodiscard]] inline Record& At(const Voice& voice, const std::size_t slot) noexcept
{
    return voice.storage.records[slot]; // MISRA D-002
}

/// @brief OPERATIONAL with a valid configuration. [SRS_CONS_002]
[[nodiscard]] inline bool IsActive(const Voice& voice) noexcept
{
    return voice.outcome.not_operational == 0U;
}

/// @brief Which slot an identifier from 101h to 180h leads to; any other one leads where one of these does.
[[nodiscard]] inline std::uint8_t& LookUp(const Voice& voice, const std::uint32_t identifier) noexcept
{
    return voice.storage.look_up[identifier % kLookUpSize]; // MISRA D-002
}

[[nodiscard]] inline SrdoMask BitOf(const std::size_t slot) noexcept
{
    return SrdoMask{1U} << slot;
}

[[nodiscard]] inline bool IsIn(const SrdoMask mask, const std::size_t slot) noexcept
{
    return (mask & BitOf(slot)) != 0U;
}

/// @brief Sets the bit of a slot.
void PutIn(SrdoMask& mask, std::size_t slot) noexcept;
/// @brief Clears it.
void TakeOut(SrdoMask& mask, std::size_t slot) noexcept;

inline void SetPermitted(Voice& voice, const SrdoMask permitted) noexcept
{
    voice.permitted = permitted;
    voice.refused = ~permitted;
}

/// @brief A slot that is not beside its complement is not permitted.
[[nodiscard]] inline SrdoMask PermittedOf(const Voice& voice) noexcept
{
    return voice.permitted & ~voice.refused;
}

inline void Demand(Record& record, const std::uint32_t todo) noexcept
{
    record.todo = static_cast<std::uint8_t>(record.todo | todo);
}

/// @brief How long ago an instant is; the counter may have wrapped since. [SRS_TIME_001, SRS_TIME_002]
[[nodiscard]] inline std::uint32_t AgeUs(const Instant since, const Instant now) noexcept
{
    return now.us - since.us;
}

/// @brief Whether the limit that runs has passed; the limit itself is accepted. [SRS_TIME_004]
[[nodiscard]] inline bool IsExpired(const Record& record, const Instant when) noexcept
{
    return AgeUs(record.since, when) > record.limit_us;
}

/// @brief Refresh time or SCT.
[[nodiscard]] inline std::uint32_t SctUs(const Record& record) noexcept
{
    return record.values.sct_ms * kMicrosecondsPerMillisecond;
}

[[nodiscard]] inline std::uint32_t SrvtUs(const Record& record) noexcept
{
    return record.values.srvt_ms * kMicrosecondsPerMillisecond;
}

} // namespace counterpoint::channel_a

#endif
