// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_PLC_DESIGNER_STATES_HPP
#define CANOPEN_START_UP_PLC_DESIGNER_STATES_HPP

#include <cstdint>

namespace counterpoint::cia302
{

/// nStatus of a slave: its state, and what its status has as `code`.
constexpr std::int16_t kPlcReset = -1;     ///< Reset node waits to be sent.
constexpr std::int16_t kPlcOutside = 0;    ///< Not begun.
constexpr std::int16_t kPlcBootUp = 1;     ///< Waits for the boot-up message.
constexpr std::int16_t kPlcSettles = 2;    ///< Waits 0.5 s.
constexpr std::int16_t kPlcSdos = 3;       ///< Is configured.
constexpr std::int16_t kPlcConfigured = 4; ///< PRE-OPERATIONAL.
constexpr std::int16_t kPlcStarted = 5;    ///< OPERATIONAL.
constexpr std::int16_t kPlcAbsent = 97;    ///< Optional, and did not answer.
constexpr std::int16_t kPlcWrongType = 98; ///< 1000h is not the expected one.
constexpr std::int16_t kPlcLost = 99;      ///< Heartbeat or guarding lost.

/// What leads a slave from one state to another.
enum class PlcEvent : std::uint8_t
{
    kNone = 0U,       ///< Only its step changes.
    kBegin = 1U,      ///< Its start-up begins, with the reset.
    kResetSent = 2U,  ///< The reset was sent, by the profile or by a command.
    kSettle = 3U,     ///< The boot-up message came, or is not waited for any more.
    kTimeOver = 4U,   ///< The time in kPlcSettles is over.
    kAnswered = 5U,   ///< All SDOs were answered.
    kOther = 6U,      ///< It is another device than the expected one.
    kSilence = 7U,    ///< An optional slave did not answer.
    kStarted = 8U,    ///< NMT start was sent.
    kStartAgain = 9U, ///< It is to be started again: by order, or because a start was given up.
    kHold = 10U,      ///< A command that holds it was sent, or the gate refused it.
    kLost = 11U,      ///< Heartbeat or guarding was lost.
};
constexpr std::uint8_t kPlcEvents = 12U;

/// One state and what follows it. kPlcOutside in a cell would mean that the cell was forgotten.
struct PlcStateRow
{
    std::int16_t state;
    std::int16_t next[kPlcEvents]; ///< By PlcEvent.
};

namespace plc_table
{

constexpr std::int16_t kStays = 0x7FFF; ///< The event has no meaning in this state.
constexpr std::int16_t kTold = kPlcConfigured;
constexpr std::int16_t kWrong = kPlcWrongType;
constexpr std::uint8_t kStates = 10U;

// clang-format off
constexpr PlcStateRow kRows[kStates]{
    //                none     begin      reset sent  settle       settled   answered  other   silence     started      again   hold    lost
    {kPlcReset,      {kStays, kPlcReset, kPlcBootUp, kPlcSettles, kStays,   kStays,   kStays, kStays,     kStays,      kStays, kStays, kStays}},
    {kPlcOutside,    {kStays, kPlcReset, kStays,     kPlcSettles, kStays,   kStays,   kStays, kStays,     kStays,      kStays, kStays, kStays}},
    {kPlcBootUp,     {kStays, kPlcReset, kStays,     kPlcSettles, kStays,   kStays,   kStays, kStays,     kStays,      kStays, kStays, kStays}},
    {kPlcSettles,    {kStays, kPlcReset, kStays,     kPlcSettles, kPlcSdos, kStays,   kStays, kStays,     kStays,      kStays, kStays, kStays}},
    {kPlcSdos,       {kStays, kPlcReset, kStays,     kPlcSettles, kStays,   kTold,    kWrong, kPlcAbsent, kStays,      kStays, kStays, kStays}},
    {kPlcConfigured, {kStays, kPlcReset, kStays,     kPlcSettles, kStays,   kStays,   kWrong, kStays,     kPlcStarted, kStays, kStays, kPlcLost}},
    {kPlcStarted,    {kStays, kPlcReset, kStays,     kPlcSettles, kStays,   kStays,   kWrong, kStays,     kStays,      kTold,  kTold,  kPlcLost}},
    {kPlcAbsent,     {kStays, kPlcReset, kStays,     kPlcSettles, kStays,   kStays,   kWrong, kStays,     kStays,      kStays, kStays, kStays}},
    {kPlcWrongType,  {kStays, kPlcReset, kStays,     kPlcSettles, kStays,   kStays,   kWrong, kStays,     kStays,      kStays, kStays, kStays}},
    {kPlcLost,       {kStays, kPlcReset, kStays,     kPlcSettles, kStays,   kStays,   kWrong, kStays,     kStays,      kTold,  kStays, kStays}},
};
// clang-format on

/// @brief Whether no cell was forgotten.
constexpr bool IsTotal() noexcept
{
    bool is_total = true;
    for (const PlcStateRow& row : kRows)
    {
        for (const std::int16_t next : row.next)
        {
            is_total = is_total && (next != kPlcOutside);
        }
    }
    return is_total;
}
static_assert(IsTotal(), "a row without a cell");

} // namespace plc_table

/// @brief What follows `state`. A pure function, defined for every value; a value that is no state stays. [SRS_PLC_022]
[[nodiscard]] constexpr std::int16_t Next(const std::int16_t state, const PlcEvent event) noexcept
{
    const auto column = static_cast<std::uint8_t>(event);
    std::int16_t next = state;
    for (const PlcStateRow& row : plc_table::kRows)
    {
        const bool is_row = (row.state == state) && (column < kPlcEvents);
        const std::int16_t listed = row.next[(column < kPlcEvents) ? column : 0U];
        next = (is_row && (listed != plc_table::kStays)) ? listed : next;
    }
    return next;
}

} // namespace counterpoint::cia302

#endif
