// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_MASTER_STEPS_HPP
#define CANOPEN_START_UP_CIA302_MASTER_STEPS_HPP

#include <cstdint>

namespace counterpoint::cia302
{

/// Where the master is in the start-up. MasterState gives these numbers.
enum class MasterStep : std::int16_t
{
    kIdle = 0,
    kReset = 1, ///< The resets are being sent.
    kBooting = 2,
    kHalted = 3, ///< A mandatory slave failed.
    kReady = 4,  ///< All mandatory slaves are booted; the application starts the master.
    kOperational = 5,
    kStopped = 6, ///< Error handling has stopped all nodes; Begin starts again.
};
constexpr std::uint8_t kMasterSteps = 7U;

/// What leads the master from one step to another.
enum class MasterEvent : std::uint8_t
{
    kNone = 0U,
    kReset = 1U,  ///< The start-up begins, with resets.
    kBoot = 2U,   ///< The resets have left, or the application sent them.
    kFailed = 3U, ///< The boot of a mandatory slave failed.
    kBooted = 4U, ///< All mandatory slaves are booted.
    kAgain = 5U,  ///< A slave whose boot failed boots again.
    kStart = 6U,
    kLeave = 7U, ///< OPERATIONAL is left by a command.
    kStop = 8U,  ///< Error handling stopped all.
    kEnd = 9U,
};
constexpr std::uint8_t kMasterEvents = 10U;

/// One step and what follows it. kIdle in a cell would mean that the cell was forgotten: only kEnd leads there.
struct MasterRow
{
    MasterStep step;
    MasterStep next[kMasterEvents - 1U]; ///< By MasterEvent, but for kEnd.
};

namespace master_table
{

using M = MasterStep;
constexpr M kStays{0x7F}; ///< The event has no meaning in this step.
constexpr M kOn = M::kOperational;
constexpr M kOff = M::kStopped;

// clang-format off
constexpr MasterRow kRows[kMasterSteps]{
    //                 none    reset      boot         failed      booted     again        start   leave      stop
    {M::kIdle,        {kStays, M::kReset, M::kBooting, kStays,     kStays,    kStays,      kStays, kStays,    kOff}},
    {M::kReset,       {kStays, kStays,    M::kBooting, kStays,     kStays,    kStays,      kOn,    kStays,    kOff}},
    {M::kBooting,     {kStays, kStays,    kStays,      M::kHalted, M::kReady, M::kBooting, kOn,    kStays,    kOff}},
    {M::kHalted,      {kStays, kStays,    kStays,      M::kHalted, M::kReady, M::kBooting, kOn,    kStays,    kOff}},
    {M::kReady,       {kStays, kStays,    kStays,      kStays,     kStays,    kStays,      kOn,    kStays,    kOff}},
    {M::kOperational, {kStays, kStays,    kStays,      kStays,     kStays,    kStays,      kOn,    M::kReady, kOff}},
    {M::kStopped,     {kStays, kStays,    kStays,      kStays,     kStays,    kStays,      kOn,    kStays,    kOff}},
};
// clang-format on

/// @brief Whether every row is in its place and no cell was forgotten.
constexpr bool IsTotal() noexcept
{
    bool is_total = true;
    for (std::uint8_t i = 0U; i < kMasterSteps; ++i)
    {
        is_total = is_total && (static_cast<std::int16_t>(kRows[i].step) == i);
        for (const MasterStep next : kRows[i].next)
        {
            is_total = is_total && (next != M::kIdle);
        }
    }
    return is_total;
}
static_assert(IsTotal(), "a step without a row, or a row without a cell");

} // namespace master_table

/// @brief What follows `step`. A pure function, defined for every value; a value that is no step stays. [SRS_BOOT_025]
[[nodiscard]] constexpr MasterStep Next(const MasterStep step, const MasterEvent event) noexcept
{
    const auto column = static_cast<std::uint8_t>(event);
    MasterStep next = (event == MasterEvent::kEnd) ? MasterStep::kIdle : step;
    for (const MasterRow& row : master_table::kRows)
    {
        const bool is_cell = (row.step == step) && (column < (kMasterEvents - 1U));
        const MasterStep listed = row.next[is_cell ? column : 0U];
        next = (is_cell && (listed != master_table::kStays)) ? listed : next;
    }
    return next;
}

} // namespace counterpoint::cia302

#endif
