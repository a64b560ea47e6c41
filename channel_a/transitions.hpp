// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_TRANSITIONS_HPP
#define CHANNEL_A_TRANSITIONS_HPP

#include "safety_core/contract/srdo.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{

/// State of one SRDO. The low four bits are the column of the table, the high four bits a check of them: two codes
/// differ in at least four bits. Empty: nothing pending, nothing held. First: a normal frame is pending. Held: a pair
/// is held. Next: both.
enum class Mode : std::uint8_t
{
    kBroken = 0x00U, ///< Zeroed memory; every other value that is not listed leads to this column.
    kOff = 0xB1U,
    kWaitingEmpty = 0xD2U,
    kWaitingFirst = 0x63U,
    kWaitingHeld = 0xE4U,
    kWaitingNext = 0x55U,
    kFaultedEmpty = 0x36U,
    kFaultedFirst = 0x87U,
    kFaultedHeld = 0x78U,
    kFaultedNext = 0xC9U,
    kReleasedHeld = 0xAAU,
    kReleasedNext = 0x1BU,
    kIdle = 0x9CU,          ///< Producer without a pair in flight.
    kNormalAwaited = 0x4EU, ///< Producer that waits for the confirmation of the normal frame.
    kInverseAwaited = 0xFFU ///< Producer that waits for the confirmation of the inverse frame.
};

/// Rows of the table. What goes well with a pair is none of them: a frame that is as it should be takes a consumer on
/// by kAfterNormal and kAfterInverse, a producer as producer.cpp tells.
enum class Event : std::uint8_t
{
    kLeave = 0U,
    kError = 1U,   ///< What makes a consumer safe; the cause is given by who raises it.
    kDiscard = 2U, ///< The held pair is dropped, a pending normal frame stays.
    kRelease = 3U,
    kAbort = 4U,     ///< The pair in flight failed; the cause is given by who raises it.
    kCorrupted = 5U, ///< The record does not fit its seal.
};

constexpr std::size_t kEventCount = 6U;

/// What is to be done with the record besides its new mode.
enum class Effect : std::uint8_t
{
    kInvalid = 0U, ///< An omitted cell; does not compile.
    kNothing = 1U,
    kDropHeld = 2U, ///< The held pair is dropped without a fault, a pending normal frame stays.
    kDropAll = 3U,  ///< Likewise where nothing is pending.
    kFault = 4U,    ///< Consumer made safe, for the cell's cause or, where that is kNone, the given one.
    kAbort = 5U,    ///< The pair in flight is given up with a fault of the producer.
};

struct Cell
{
    Mode next;
    Effect effect;
    SrdoCause cause;
};

/// Which mask of the channel has the slot's bit.
constexpr std::uint8_t kGroupOff = 0U;
constexpr std::uint8_t kGroupWaiting = 1U;
constexpr std::uint8_t kGroupFaulted = 2U;
constexpr std::uint8_t kGroupReleased = 3U;
constexpr std::uint8_t kGroupProducer = 4U;
constexpr std::uint8_t kGroupCount = 5U;
/// From kGroupWaiting on.
constexpr std::uint32_t kConsumerGroups = 3U;

/// What a record holds.
constexpr std::uint8_t kNoData = 0U;
constexpr std::uint8_t kInFlight = 1U;   ///< Of a producer.
constexpr std::uint8_t kHeldPair = 3U;   ///< Of a consumer.
constexpr std::uint8_t kFirstFrame = 4U; ///< Besides: a normal frame is pending.
constexpr std::uint8_t kShownMask = 1U;
constexpr std::uint8_t kHoldsMask = 2U;
constexpr std::uint8_t kHoldsShift = 1U;

/// What a mode means to the rest of the channel. Four bytes, so that it is found by shifts.
struct ModeFacts
{
    Mode mode;
    SrdoState state;
    std::uint8_t group;
    std::uint8_t data;
};

constexpr std::uint8_t kModeMask = 0x0FU;
constexpr std::uint8_t kModeCount = 16U;

/// What the modes mean, by their low four bits.
extern const ModeFacts kModeFacts[kModeCount]; // MISRA D-001

/// @brief What a mode means. A value that is no mode is read as the one of its low four bits, here and in
/// NextCell: the seal of its record gives it away in the next OnCycle, whatever happens until then.
[[nodiscard]] inline const ModeFacts& FactsOf(const Mode mode) noexcept
{
    return kModeFacts[static_cast<std::uint8_t>(mode) & kModeMask];
}

/// @brief A normal frame is pending.
[[nodiscard]] inline bool HasFirstFrame(const Mode mode) noexcept
{
    return (FactsOf(mode).data & kFirstFrame) != 0U;
}

constexpr std::size_t kCellCount = 24U;

/// The different cells of the table. Cell 0 is that of an omitted entry.
extern const Cell kCells[kCellCount]; // MISRA D-001

/// The table of transitions: rows by event, columns by the low four bits of the mode, entries are numbers of cells.
extern const std::uint8_t kTransitions[kEventCount][kModeCount]; // MISRA D-001

/// Modes of a consumer after a normal frame, or an inverse frame, that is as it should be; kBroken where it is not its
/// turn. The group of the mode stays.
extern const Mode kAfterNormal[kModeCount];  // MISRA D-001
extern const Mode kAfterInverse[kModeCount]; // MISRA D-001

/// @brief What the event does in this mode.
[[nodiscard]] inline const Cell& NextCell(const Mode mode, const Event event) noexcept
{
    return kCells[kTransitions[static_cast<std::uint8_t>(event)][static_cast<std::uint8_t>(mode) & kModeMask]];
}

} // namespace counterpoint::channel_a

#endif
