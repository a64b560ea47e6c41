// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_BOOT_STATES_HPP
#define CANOPEN_START_UP_CIA302_BOOT_STATES_HPP

#include "canopen/cia302/network/start_up.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// What the boot of a slave is doing. The table kRows says for each state which step it belongs to, what it waits for,
/// and what follows.
enum class BootState : std::uint8_t
{
    kIdle = 0U,      ///< No boot runs; the step of the status tells where the last one ended.
    kResetDue = 1U,  ///< NMT reset node is to be handed to the NMT master.
    kResetSent = 2U, ///< The slave was reset, by the boot or by somebody else.
    kUnheard = 3U,   ///< No boot-up message came in time; it is waited for without end.
    kTypeFirst = 4U, ///< Before the first reading of 1000h: a STOPPED slave, which has no SDO, is made PRE-OPERATIONAL.
    kTypeAgain = 5U, ///< Before each further reading of 1000h.
    kType = 6U,      ///< Reads 1000h.
    kTypePause = 7U, ///< Between two readings.
    kVendorId = 8U,  ///< Reads 1018h:01.
    kProductCode = 9U,        ///< Reads 1018h:02.
    kRevisionNumber = 10U,    ///< Reads 1018h:03.
    kSerialNumber = 11U,      ///< Reads 1018h:04.
    kStateAsk = 12U,          ///< Asks a slave that is kept alive for its state.
    kStateSign = 13U,         ///< Waits for its heartbeat or guarding answer.
    kStateReset = 14U,        ///< It did not run and was reset.
    kSoftwareId = 15U,        ///< Reads 1F56h:01.
    kSoftwareDate = 16U,      ///< Reads 1F52h:01.
    kSoftwareTime = 17U,      ///< Reads 1F52h:02.
    kProgramStop = 18U,       ///< Writes 1F51h:01.
    kProgramClear = 19U,      ///< Writes 1F51h:01.
    kClearCheck = 20U,        ///< Reads 1F57h:01.
    kClearPause = 21U,        ///< Between two readings.
    kLoadBlocks = 22U,        ///< Writes 1F50h:01 by block transfer.
    kLoadSegments = 23U,      ///< Writes it by segments: the slave knows no block transfer.
    kProgramCheck = 24U,      ///< Reads 1F57h:01.
    kProgramPause = 25U,      ///< Between two readings.
    kProgramStart = 26U,      ///< Writes 1F51h:01.
    kProgramStarted = 27U,    ///< Waits for the restart of the slave, if it does restart.
    kConfigurationDate = 28U, ///< Reads 1020h:01.
    kConfigurationTime = 29U, ///< Reads 1020h:02.
    kRestore = 30U,           ///< Writes "load" to 1011h.
    kRestoreReset = 31U,      ///< The reset that lets the restored values take effect is to be handed over.
    kRestored = 32U,          ///< The slave restarts.
    kText = 33U,              ///< Writes the entries of 1F20h.
    kConcise = 34U,           ///< Writes the entries of 1F22h.
    kWatch = 35U,             ///< Supervision begins.
    kWatched = 36U,           ///< Waits for the first heartbeat.
    kGate = 37U,              ///< The gate is asked to verify.
    kGateBusy = 38U,          ///< The gate verifies.
    kGateClosed = 39U,        ///< The gate was closed meanwhile: it verifies again in the next call.
    kStart = 40U,             ///< NMT start is to be handed over, unless it is left to others.
};
constexpr std::uint8_t kBootStates = 41U;

/// What happens to a boot. kDone to kSilence are results of the present state, and have a meaning in some states only;
/// the others lead to the same state from every state.
enum class BootEvent : std::uint8_t
{
    kNone = 0U,         ///< Nothing yet.
    kDone = 1U,         ///< What the state is for is done, and as expected.
    kSkip = 2U,         ///< The setup of the slave does not ask for it.
    kElse = 3U,         ///< The result is not the hoped-for one, and there is another way on.
    kBootUp = 4U,       ///< The boot-up message for which the state waits.
    kSilence = 5U,      ///< What the state waits for did not come in time.
    kBegin = 6U,        ///< A boot begins, with its first SDO.
    kBeginUnasked = 7U, ///< A boot without 1F81h bit 2 begins: supervision alone.
    kAwait = 8U,        ///< The slave was reset: wait for its boot-up message.
    kReset = 9U,        ///< The slave is to be reset.
    kConfigure = 10U,   ///< Its configuration alone is to be written.
    kVerify = 11U,      ///< A slave that runs is to be verified.
    kFinished = 12U,    ///< The boot ended well.
    kFailed = 13U,      ///< The boot ended with a letter.
    kGivenUp = 14U,     ///< The boot was ended from outside.
};
constexpr std::uint8_t kBootEvents = 15U;

/// What a state waits for.
enum class BootWait : std::uint8_t
{
    kNothing = 0U,
    kQueue = 1U,  ///< Room for a command or a remote frame.
    kAnswer = 2U, ///< An SDO: first for a lane, then for the answer.
    kTime = 3U,
    kSign = 4U, ///< Heartbeat or guarding answer.
    kBootUp = 5U,
    kGate = 6U,
    kCall = 7U, ///< The next call.
};

/// One state and what follows it. kIdle in a cell would mean that the cell was forgotten.
struct BootRow
{
    BootState state;
    StartUpStep step;
    BootWait wait;
    BootState on_done;
    BootState on_skip;
    BootState on_else;
    BootState on_boot_up;
    BootState on_silence;
};

namespace boot_table
{

using S = BootState;
using P = StartUpStep;
using W = BootWait;

/// The event has no meaning in this state, which stays.
constexpr BootState kStays{0xFFU};

// clang-format off
constexpr BootRow kRows[kBootStates]{
    // state                 step                   waits for    done                   skip                   else               boot-up         silence
    {S::kIdle,              P::kNone,              W::kNothing, kStays,                kStays,                kStays,            kStays,         kStays},
    {S::kResetDue,          P::kReset,             W::kQueue,   S::kResetSent,         kStays,                kStays,            kStays,         kStays},
    {S::kResetSent,         P::kReset,             W::kBootUp,  kStays,                kStays,                kStays,            kStays,         S::kUnheard},
    {S::kUnheard,           P::kWaitBootUp,        W::kBootUp,  kStays,                kStays,                kStays,            kStays,         kStays},
    {S::kTypeFirst,         P::kDeviceType,        W::kNothing, S::kType,              kStays,                kStays,            kStays,         kStays},
    {S::kTypeAgain,         P::kDeviceType,        W::kNothing, S::kType,              kStays,                kStays,            kStays,         kStays},
    {S::kType,              P::kDeviceType,        W::kAnswer,  S::kVendorId,          kStays,                S::kTypePause,     kStays,         kStays},
    {S::kTypePause,         P::kDeviceType,        W::kTime,    S::kTypeAgain,         kStays,                kStays,            kStays,         kStays},
    {S::kVendorId,          P::kVendorId,          W::kAnswer,  S::kProductCode,       kStays,                kStays,            kStays,         kStays},
    {S::kProductCode,       P::kProductCode,       W::kAnswer,  S::kRevisionNumber,    kStays,                kStays,            kStays,         kStays},
    {S::kRevisionNumber,    P::kRevisionNumber,    W::kAnswer,  S::kSerialNumber,      kStays,                kStays,            kStays,         kStays},
    {S::kSerialNumber,      P::kSerialNumber,      W::kAnswer,  S::kStateAsk,          kStays,                kStays,            kStays,         kStays},
    {S::kStateAsk,          P::kStateCheck,        W::kQueue,   S::kStateSign,         S::kSoftwareId,        kStays,            kStays,         kStays},
    {S::kStateSign,         P::kStateCheck,        W::kSign,    S::kWatch,             S::kSoftwareId,        S::kStateReset,    kStays,         kStays},
    {S::kStateReset,        P::kStateCheck,        W::kBootUp,  kStays,                S::kSoftwareId,        kStays,            S::kSoftwareId, S::kTypeFirst},
    {S::kSoftwareId,        P::kSoftwareVersion,   W::kAnswer,  S::kSoftwareDate,      S::kConfigurationDate, S::kProgramStop,   kStays,         kStays},
    {S::kSoftwareDate,      P::kSoftwareVersion,   W::kAnswer,  S::kSoftwareTime,      S::kConfigurationDate, S::kProgramStop,   kStays,         kStays},
    {S::kSoftwareTime,      P::kSoftwareVersion,   W::kAnswer,  S::kConfigurationDate, S::kConfigurationDate, S::kProgramStop,   kStays,         kStays},
    {S::kProgramStop,       P::kSoftwareUpdate,    W::kAnswer,  S::kProgramClear,      kStays,                kStays,            kStays,         kStays},
    {S::kProgramClear,      P::kSoftwareUpdate,    W::kAnswer,  S::kClearCheck,        kStays,                kStays,            kStays,         kStays},
    {S::kClearCheck,        P::kSoftwareUpdate,    W::kAnswer,  S::kLoadBlocks,        kStays,                S::kClearPause,    kStays,         kStays},
    {S::kClearPause,        P::kSoftwareUpdate,    W::kTime,    S::kClearCheck,        kStays,                kStays,            kStays,         kStays},
    {S::kLoadBlocks,        P::kSoftwareUpdate,    W::kAnswer,  S::kProgramCheck,      kStays,                S::kLoadSegments,  kStays,         kStays},
    {S::kLoadSegments,      P::kSoftwareUpdate,    W::kAnswer,  S::kProgramCheck,      kStays,                kStays,            kStays,         kStays},
    {S::kProgramCheck,      P::kSoftwareUpdate,    W::kAnswer,  S::kProgramStart,      kStays,                S::kProgramPause,  kStays,         kStays},
    {S::kProgramPause,      P::kSoftwareUpdate,    W::kTime,    S::kProgramCheck,      kStays,                kStays,            kStays,         kStays},
    {S::kProgramStart,      P::kSoftwareUpdate,    W::kAnswer,  S::kProgramStarted,    kStays,                kStays,            kStays,         kStays},
    {S::kProgramStarted,    P::kSoftwareUpdate,    W::kBootUp,  kStays,                kStays,                kStays,            S::kTypeFirst,  S::kTypeFirst},
    {S::kConfigurationDate, P::kConfigurationDate, W::kAnswer,  S::kConfigurationTime, S::kRestore,           S::kRestore,       kStays,         kStays},
    {S::kConfigurationTime, P::kConfigurationDate, W::kAnswer,  S::kWatch,             S::kRestore,           S::kRestore,       kStays,         kStays},
    {S::kRestore,           P::kRestore,           W::kAnswer,  S::kRestoreReset,      S::kText,              kStays,            kStays,         kStays},
    {S::kRestoreReset,      P::kRestore,           W::kQueue,   S::kRestored,          S::kText,              kStays,            kStays,         kStays},
    {S::kRestored,          P::kRestore,           W::kBootUp,  kStays,                S::kText,              kStays,            S::kText,       kStays},
    {S::kText,              P::kConfigure,         W::kAnswer,  S::kConcise,           kStays,                S::kText,          kStays,         kStays},
    {S::kConcise,           P::kConfigure,         W::kAnswer,  S::kWatch,             S::kStart,             S::kConcise,       kStays,         kStays},
    {S::kWatch,             P::kErrorControl,      W::kNothing, S::kWatched,           S::kGate,              kStays,            kStays,         kStays},
    {S::kWatched,           P::kErrorControl,      W::kSign,    S::kGate,              kStays,                kStays,            kStays,         kStays},
    {S::kGate,              P::kSafety,            W::kNothing, S::kGateBusy,          S::kStart,             kStays,            kStays,         kStays},
    {S::kGateBusy,          P::kSafety,            W::kGate,    S::kStart,             kStays,                S::kGateClosed,    kStays,         kStays},
    {S::kGateClosed,        P::kSafety,            W::kCall,    S::kGateBusy,          S::kStart,             kStays,            kStays,         kStays},
    {S::kStart,             P::kStart,             W::kQueue,   kStays,                kStays,                S::kGate,          kStays,         kStays},
};
// clang-format on

/// @brief Whether every row is in its place and no cell was forgotten.
constexpr bool IsTotal() noexcept
{
    bool is_total = true;
    for (std::uint8_t i = 0U; i < kBootStates; ++i)
    {
        const BootRow& row = kRows[i];
        const bool is_whole = (row.on_done != S::kIdle) && (row.on_skip != S::kIdle) && (row.on_else != S::kIdle) &&
                              (row.on_boot_up != S::kIdle) && (row.on_silence != S::kIdle);
        is_total = is_total && is_whole && (static_cast<std::uint8_t>(row.state) == i);
    }
    return is_total;
}
static_assert(IsTotal(), "a state without a row, or a row without a cell");

} // namespace boot_table

/// @brief The row of a state; that of kIdle for a value that is no state.
[[nodiscard]] constexpr const BootRow& RowOf(const BootState state) noexcept
{
    const auto index = static_cast<std::uint8_t>(state);
    return boot_table::kRows[(index < kBootStates) ? index : 0U];
}

/// @brief What follows `state`. A pure function, defined for every value. [SRS_BOOT_024]
[[nodiscard]] constexpr BootState Next(const BootState state, const BootEvent event) noexcept
{
    const BootRow& row = RowOf(state);
    BootState next = boot_table::kStays;
    switch (event)
    {
    case BootEvent::kDone:
        next = row.on_done;
        break;
    case BootEvent::kSkip:
        next = row.on_skip;
        break;
    case BootEvent::kElse:
        next = row.on_else;
        break;
    case BootEvent::kBootUp:
        next = row.on_boot_up;
        break;
    case BootEvent::kSilence:
        next = row.on_silence;
        break;
    case BootEvent::kBegin:
        next = BootState::kTypeFirst;
        break;
    case BootEvent::kBeginUnasked:
        next = BootState::kWatch;
        break;
    case BootEvent::kAwait:
        next = BootState::kResetSent;
        break;
    case BootEvent::kReset:
        next = BootState::kResetDue;
        break;
    case BootEvent::kConfigure:
        next = BootState::kRestore;
        break;
    case BootEvent::kVerify:
        next = BootState::kGate;
        break;
    case BootEvent::kFinished:
    case BootEvent::kFailed:
    case BootEvent::kGivenUp:
        next = BootState::kIdle;
        break;
    case BootEvent::kNone:
        break;
    }
    return (next == boot_table::kStays) ? row.state : next;
}

/// @brief Whether the state has something to do as soon as it is entered.
[[nodiscard]] constexpr bool ActsAtOnce(const BootState state) noexcept
{
    const BootWait wait = RowOf(state).wait;
    return (wait == BootWait::kNothing) || (wait == BootWait::kQueue) || (wait == BootWait::kAnswer);
}

} // namespace counterpoint::cia302

#endif
