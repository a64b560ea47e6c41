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

/// What decides how a frame is judged: the state of the negotiation and its settings.
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

/// What is to be done about a frame. Better and worse: by priority level, then by node-ID (IsBetter).
enum class FlyingReaction : std::uint8_t
{
    kNone = 0U,
    kReset,        ///< Communication of this node, too, was reset.
    kHalt,         ///< Another device has the own node-ID.
    kAccept,       ///< To accept the master that the negotiation looked for.
    kFollow,       ///< To follow a better master.
    kRefresh,      ///< To supervise on: the present master has claimed again.
    kForce,        ///< To make a worse master yield.
    kReject,       ///< As kForce, and to tell that this master should not have claimed to be one.
    kAnswer,       ///< To answer as master, at once.
    kAnswerInTurn, ///< To answer as master, in the own time slot.
    kJoin,         ///< To join a race that others have begun.
    kRace,         ///< To begin a race as a standby.
    kAsk,          ///< To ask as a standby whether the master is there.
    kRestart,      ///< To restart, reset all or race anew, as the options say: 076h was heard.
    kResetAll,
    kRaceAnew,
    kWatch,        ///< To note the heartbeat of the own master.
    kFoundCapable, ///< 074h.
    kTellCapable,  ///< 075h.
};

/// @brief What a frame 071h claims.
[[nodiscard]] constexpr MasterClaim ClaimOf(const CanFrame& frame) noexcept
{
    return MasterClaim{frame.data[0], NodeId{frame.data[1]}};
}

/// @brief Judges a frame. A pure function: it changes nothing.
[[nodiscard]] FlyingReaction Heard(const FlyingView& view, const CanFrame& frame) noexcept;

} // namespace counterpoint::cia302

#endif
