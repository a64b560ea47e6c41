// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_FLYING_MASTER_HEARD_HPP
#define CANOPEN_CIA302_FLYING_MASTER_HEARD_HPP

#include "canopen/cia302/flying_master/frames.hpp"
#include "canopen/cia302/flying_master/options.hpp"
#include "canopen/cia302/flying_master/states.hpp"
#include "canopen/cia302/flying_master/times.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// What a frame is judged by.
struct FlyingView
{
    FlyingState state;
    const FlyingMasterOptions& options;
    const FlyingMasterTimes& times;
    MasterClaim own;
    MasterClaim master;     ///< In kSlave and kMaster.
    bool has_asked;         ///< 073h of a slave or in a race is out.
    std::uint32_t raced_us; ///< Of kRace: since it began.
};

/// What is to be done about a frame.
enum class FlyingReaction : std::uint8_t
{
    kNone = 0U,
    kReset,        ///< Communication of this node, too, was reset.
    kHalt,         ///< Another device has the own node-ID.
    kAccept,       ///< The master that the negotiation looked for.
    kFollow,       ///< A better one.
    kRefresh,      ///< The own master claims again.
    kForce,        ///< A worse one has to yield.
    kReject,       ///< Likewise, and it should not have claimed to be one.
    kAnswer,       ///< As master, at once.
    kAnswerInTurn, ///< As master, at the own place.
    kJoin,         ///< A race of others.
    kRace,         ///< A standby that races.
    kAsk,          ///< A standby may ask for its master.
    kRestart,      ///< As FlyingInput, by 076h.
    kResetAll,
    kRaceAnew,
    kWatch,        ///< Heartbeat of the own master.
    kFoundCapable, ///< 074h.
    kTellCapable,  ///< 075h.
};

/// @brief The claim of 071h.
[[nodiscard]] constexpr MasterClaim ClaimOf(const CanFrame& frame) noexcept
{
    return MasterClaim{frame.data[0], NodeId{frame.data[1]}};
}

/// @brief Judges a frame, without effect.
[[nodiscard]] FlyingReaction Heard(const FlyingView& view, const CanFrame& frame) noexcept;

} // namespace counterpoint::cia302

#endif
