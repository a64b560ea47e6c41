// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_FLYING_MASTER_STATES_HPP
#define CANOPEN_CIA302_FLYING_MASTER_STATES_HPP

#include <cstdint>

namespace counterpoint::cia302
{

/// Where the negotiation stands. Steps are those of the text.
enum class FlyingState : std::uint8_t
{
    kInvalid = 0U,
    kInitialising = 1U, ///< Nothing happens until Start.
    kDelay = 2U,        ///< Step 1: the delay before 073h.
    kDetect = 3U,       ///< Steps 1 to 5: waits for 071h.
    kRace = 4U,         ///< Step 7: waits for the own time slot.
    kForcing = 5U,      ///< Steps 4 and 10: 076h is to be sent.
    kResetting = 6U,    ///< Reset communication of all nodes is to be sent.
    kSlave = 7U,        ///< Another one is master.
    kHalted = 8U,       ///< Another device has the own node-ID: nothing until the next reset.
    kMaster = 0x96U,    ///< The active master.
};

/// What moves the negotiation on.
enum class FlyingInput : std::uint8_t
{
    kNone = 0U,
    kStart = 1U,     ///< The application lets the negotiation begin.
    kSent = 2U,      ///< The frame that ends the step has left: 073h, 072h, 071h, 076h.
    kRestart = 3U,   ///< Begin with step 1: the master is lost, or 076h was heard.
    kResetAll = 4U,  ///< As kRestart, with a reset of all nodes before.
    kRaceAnew = 5U,  ///< As kRestart, but with 072h.
    kJoin = 6U,      ///< Others have begun a race.
    kForce = 7U,     ///< A worse master has to yield.
    kFollow = 8U,    ///< A master was accepted.
    kReset = 9U,     ///< Communication was reset, by a command or by this device itself.
    kSameNode = 10U, ///< Another device has the own node-ID.
};
constexpr std::uint8_t kFlyingInputs = 11U;

/// One state and what follows it. kInvalid in a cell would mean that the cell was forgotten.
struct FlyingRow
{
    FlyingState state;
    FlyingState next[kFlyingInputs]; ///< By FlyingInput.
};

namespace flying_table
{

using S = FlyingState;
constexpr S kStays{0xFFU}; ///< The input has no meaning in this state.
constexpr S kInit = S::kInitialising;
constexpr std::uint8_t kRowCount = 9U;

// clang-format off
constexpr FlyingRow kRows[kRowCount]{
    //                  none     start      sent        restart    reset all       race anew   join      force        follow     reset  same node
    {kInit,          {kStays, S::kDelay, kStays,     kStays,    kStays,         kStays,     kStays,   kStays,      kStays,    kInit, kStays}},
    {S::kDelay,      {kStays, kStays,    S::kDetect, S::kDelay, kStays,         kStays,     S::kRace, kStays,      S::kSlave, kInit, S::kHalted}},
    {S::kDetect,     {kStays, kStays,    S::kRace,   S::kDelay, kStays,         kStays,     S::kRace, S::kForcing, S::kSlave, kInit, S::kHalted}},
    {S::kRace,       {kStays, kStays,    S::kMaster, S::kDelay, kStays,         kStays,     S::kRace, S::kForcing, S::kSlave, kInit, S::kHalted}},
    {S::kForcing,    {kStays, kStays,    S::kDelay,  kStays,    kStays,         kStays,     kStays,   kStays,      kStays,    kInit, S::kHalted}},
    {S::kResetting,  {kStays, kStays,    kStays,     kStays,    kStays,         kStays,     kStays,   kStays,      kStays,    kInit, S::kHalted}},
    {S::kSlave,      {kStays, kStays,    kStays,     S::kDelay, S::kResetting,  S::kDetect, S::kRace, S::kForcing, S::kSlave, kInit, S::kHalted}},
    {S::kHalted,     {kStays, kStays,    kStays,     kStays,    kStays,         kStays,     kStays,   kStays,      kStays,    kInit, kStays}},
    {S::kMaster,     {kStays, kStays,    kStays,     S::kDelay, S::kResetting,  S::kDetect, kStays,   kStays,      S::kSlave, kInit, S::kHalted}},
};
// clang-format on

constexpr bool IsTotal() noexcept
{
    bool is_total = true;
    for (const FlyingRow& row : kRows)
    {
        for (const FlyingState next : row.next)
        {
            is_total = is_total && (next != S::kInvalid);
        }
    }
    return is_total;
}
static_assert(IsTotal(), "a row without a cell");

} // namespace flying_table

/// @brief What follows `state`. A pure function, defined for every value; a value that is no state waits for a reset.
/// [SRS_FLY_031]
[[nodiscard]] constexpr FlyingState Next(const FlyingState state, const FlyingInput input) noexcept
{
    const auto column = static_cast<std::uint8_t>(input);
    FlyingState next = (input == FlyingInput::kReset) ? FlyingState::kInitialising : state;
    for (const FlyingRow& row : flying_table::kRows)
    {
        const bool is_row = (row.state == state) && (column < kFlyingInputs);
        const FlyingState listed = row.next[(column < kFlyingInputs) ? column : 0U];
        next = (is_row && (listed != flying_table::kStays)) ? listed : next;
    }
    return next;
}

} // namespace counterpoint::cia302

#endif
