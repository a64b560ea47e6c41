// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_EL6751_STATES_HPP
#define CANOPEN_START_UP_EL6751_STATES_HPP

#include <cstdint>

namespace counterpoint::cia302
{

/// What the start-up of a slave is doing, and what it waits for.
enum class El6751Phase : std::uint8_t
{
    kOutside = 0U, ///< Not in the network.
    kResetting,    ///< Reset communication waits to be handed over.
    kRows,         ///< SDOs of the start-up.
    kVerify,       ///< The gate reads the safety objects.
    kStarting,     ///< NMT start waits to be sent.
    kRunning,
    kHeld,   ///< Not started: by hand, or because the automatic start is off.
    kFailed, ///< The start-up ended.
    kDeactivated,
    kStoppingToReset, ///< NMT stop waits to be handed over; then the start-up begins anew.
    kStoppingHeld,    ///< Likewise, then kHeld;
    kStoppingFailed,  ///< kFailed;
    kStoppingForGood, ///< kDeactivated.
};
constexpr std::uint8_t kEl6751Phases = 13U;

/// What leads the start-up of a slave from one phase to another.
enum class El6751Event : std::uint8_t
{
    kNone = 0U,
    kBegin = 1U,      ///< Its SDOs begin with the first one.
    kReset = 2U,      ///< It is to be reset: by order, or because no TxPDO came.
    kFail = 3U,       ///< An SDO of the start-up failed.
    kVerify = 4U,     ///< A safety slave is to be started, or to be read once more.
    kStart = 5U,      ///< A slave is to be started, or the gate is open.
    kRun = 6U,        ///< NMT start was sent.
    kHold = 7U,       ///< It is not to be started: by order, or because the automatic start is off.
    kRestart = 8U,    ///< Error reaction: stop, then the start-up anew.
    kDeactivate = 9U, ///< Error reaction: stop, then it is started by order only.
    kRefuse = 10U,    ///< The gate refused it: stop, and it is not started.
    kStopped = 11U,   ///< NMT stop was handed over.
};
constexpr std::uint8_t kEl6751Events = 12U;

/// One phase and what follows it. kOutside in a cell would mean that the cell was forgotten.
struct El6751StateRow
{
    El6751Phase phase;
    El6751Phase next[kEl6751Events]; ///< By El6751Event.
};

namespace el6751_table
{

using P = El6751Phase;
constexpr P kStays{0xFFU}; ///< The event has no meaning in this phase.
constexpr P kReset = P::kResetting;
constexpr P kAnew = P::kStoppingToReset;
constexpr P kGood = P::kStoppingForGood;
constexpr P kBad = P::kStoppingFailed;
constexpr P kKept = P::kStoppingHeld;

// clang-format off
constexpr El6751StateRow kRows[kEl6751Phases]{
    //                     none     begin     reset   fail        verify      start         run          hold      restart  deact.  refuse  stopped
    {P::kOutside,         {kStays, P::kRows, kStays, kStays,     kStays,     kStays,       kStays,      kStays,   kStays, kStays, kStays, kStays}},
    {P::kResetting,       {kStays, P::kRows, kReset, kStays,     kStays,     kStays,       kStays,      P::kHeld, kStays, kStays, kStays, kStays}},
    {P::kRows,            {kStays, P::kRows, kReset, P::kFailed, P::kVerify, P::kStarting, kStays,      P::kHeld, kStays, kStays, kStays, kStays}},
    {P::kVerify,          {kStays, P::kRows, kReset, kStays,     P::kVerify, P::kStarting, kStays,      P::kHeld, kAnew,  kGood,  kBad,   kStays}},
    {P::kStarting,        {kStays, P::kRows, kReset, kStays,     P::kVerify, kStays,       P::kRunning, P::kHeld, kAnew,  kGood,  kStays, kStays}},
    {P::kRunning,         {kStays, P::kRows, kReset, kStays,     P::kVerify, P::kStarting, kStays,      P::kHeld, kAnew,  kGood,  kBad,   kStays}},
    {P::kHeld,            {kStays, P::kRows, kReset, kStays,     P::kVerify, P::kStarting, kStays,      P::kHeld, kAnew,  kGood,  kKept,  kStays}},
    {P::kFailed,          {kStays, P::kRows, kReset, kStays,     P::kVerify, P::kStarting, kStays,      P::kHeld, kStays, kStays, kBad,   kStays}},
    {P::kDeactivated,     {kStays, P::kRows, kReset, kStays,     P::kVerify, P::kStarting, kStays,      P::kHeld, kStays, kStays, kGood,  kStays}},
    {P::kStoppingToReset, {kStays, P::kRows, kReset, kStays,     kStays,     kStays,       kStays,      P::kHeld, kStays, kStays, kStays, kReset}},
    {P::kStoppingHeld,    {kStays, P::kRows, kReset, kStays,     kStays,     kStays,       kStays,      P::kHeld, kStays, kStays, kStays, P::kHeld}},
    {P::kStoppingFailed,  {kStays, P::kRows, kReset, kStays,     kStays,     kStays,       kStays,      P::kHeld, kStays, kStays, kStays, P::kFailed}},
    {P::kStoppingForGood, {kStays, P::kRows, kReset, kStays,     kStays,     kStays,       kStays,      P::kHeld, kStays, kStays, kStays, P::kDeactivated}},
};
// clang-format on

/// @brief Whether every row is in its place and no cell was forgotten.
constexpr bool IsTotal() noexcept
{
    bool is_total = true;
    for (std::uint8_t i = 0U; i < kEl6751Phases; ++i)
    {
        is_total = is_total && (static_cast<std::uint8_t>(kRows[i].phase) == i);
        for (const El6751Phase next : kRows[i].next)
        {
            is_total = is_total && (next != P::kOutside);
        }
    }
    return is_total;
}
static_assert(IsTotal(), "a phase without a row, or a row without a cell");

} // namespace el6751_table

/// @brief What follows `phase`. A pure function, defined for every value; a value that is no phase counts as kOutside.
/// [SRS_ELM_052]
[[nodiscard]] constexpr El6751Phase Next(const El6751Phase phase, const El6751Event event) noexcept
{
    const auto index = static_cast<std::uint8_t>(phase);
    const auto column = static_cast<std::uint8_t>(event);
    const El6751StateRow& row = el6751_table::kRows[(index < kEl6751Phases) ? index : 0U];
    const El6751Phase next = row.next[(column < kEl6751Events) ? column : 0U];
    return (next == el6751_table::kStays) ? row.phase : next;
}

/// @brief Whether the phase waits until NMT stop is handed over.
[[nodiscard]] constexpr bool IsStopping(const El6751Phase phase) noexcept
{
    return Next(phase, El6751Event::kStopped) != phase;
}

} // namespace counterpoint::cia302

#endif
