// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/flying_master/heard.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kUsPerMs = 1000U;
constexpr std::uint32_t kErrorControl = 0x700U;
constexpr std::uint32_t kFirstService = static_cast<std::uint32_t>(FlyingService::kActiveMaster);
constexpr std::uint32_t kLastService = static_cast<std::uint32_t>(FlyingService::kForceNegotiation);

bool IsService(const CanFrame& frame) noexcept
{
    const bool is_claim = frame.identifier == kFirstService;
    const bool is_in_range = (frame.identifier >= kFirstService) && (frame.identifier <= kLastService);
    return is_in_range && (frame.length_bytes == (is_claim ? 2U : 0U));
}

/// An active master commands others and obeys nobody, so that a second one cannot stop it by a broadcast.
FlyingReaction OnCommand(const FlyingView& view, const CanFrame& frame) noexcept
{
    constexpr std::uint8_t kResetNode = 129U;
    constexpr std::uint8_t kResetCommunication = 130U;
    const bool is_reset = (frame.data[0] == kResetNode) || (frame.data[0] == kResetCommunication);
    const bool is_for_us = (frame.data[1] == kAllNodes.value) || (frame.data[1] == view.own.node.value);
    const bool is_ours = (frame.length_bytes == 2U) && is_reset && is_for_us && (view.state != FlyingState::kMaster);
    return is_ours ? FlyingReaction::kReset : FlyingReaction::kNone;
}

/// Whether this device becomes slave of such a master.
bool Accepts(const FlyingView& view, const MasterClaim& claim) noexcept
{
    // Once the waiting has begun, all that counts is who was first.
    const bool can_pre_empt =
        (view.options.equal_level == EqualLevel::kLowerNodeForces) && (view.state != FlyingState::kRace);
    const bool is_equal_accepted = !can_pre_empt || (claim.node.value < view.own.node.value);
    const bool is_equal = claim.level == view.own.level;
    return (claim.level < view.own.level) || (is_equal && is_equal_accepted);
}

/// The better one of two masters stays, and tells the other one by its own claim.
FlyingReaction OnClaimAsMaster(const FlyingView& view, const MasterClaim& claim) noexcept
{
    const FlyingReaction better = IsBetter(claim, view.own) ? FlyingReaction::kFollow : FlyingReaction::kAnswer;
    // Ignored: as if the only message buffer of 071h were one for sending.
    return view.options.ignores_claims ? FlyingReaction::kNone : better;
}

/// A standby that watches its master changes to a better one only: two masters settle who stays. Whoever does not watch
/// has only claims to go by.
FlyingReaction OnClaimAsSlave(const FlyingView& view, const MasterClaim& claim) noexcept
{
    const bool is_watched = view.options.watch != MasterWatch::kApplication;
    FlyingReaction reaction = FlyingReaction::kNone; // The own master lives.
    if (claim.node.value == view.master.node.value)
    {
        reaction = FlyingReaction::kRefresh;
    }
    else if (IsBetter(claim, view.master) || (!is_watched && Accepts(view, claim)))
    {
        reaction = FlyingReaction::kFollow;
    }
    else if (view.has_asked && !is_watched)
    {
        reaction = FlyingReaction::kForce;
    }
    return reaction;
}

FlyingReaction OnClaim(const FlyingView& view, const MasterClaim& claim) noexcept
{
    const bool is_node = (claim.node.value >= 1U) && (claim.node.value <= kLastNode);
    const bool is_negotiating = (view.state == FlyingState::kDetect) || (view.state == FlyingState::kRace);
    const bool listens = (view.state == FlyingState::kDelay) || is_negotiating;
    // In step 1 a worse master is left in peace until it was asked; and 076h or a reset that is to leave leaves.
    FlyingReaction reaction = FlyingReaction::kNone;
    if (!is_node)
    {
        // No such node.
    }
    else if (claim.node.value == view.own.node.value)
    {
        reaction = FlyingReaction::kHalt;
    }
    else if (view.state == FlyingState::kMaster)
    {
        reaction = OnClaimAsMaster(view, claim);
    }
    else if (view.state == FlyingState::kSlave)
    {
        reaction = OnClaimAsSlave(view, claim);
    }
    else if (listens && Accepts(view, claim))
    {
        reaction = FlyingReaction::kAccept;
    }
    else if (is_negotiating)
    {
        const bool has_asked = (view.state == FlyingState::kDetect) || view.has_asked;
        reaction = has_asked ? FlyingReaction::kForce : FlyingReaction::kReject;
    }
    return reaction;
}

/// What a standby does about 072h and 076h, but for 072h with kRaces: it ignores them, or asks.
FlyingReaction Asks(const FlyingView& view) noexcept
{
    return (view.options.standby == StandbyReaction::kAsks) ? FlyingReaction::kAsk : FlyingReaction::kNone;
}

FlyingReaction OnForce(const FlyingView& view) noexcept
{
    const ForceReaction wanted = view.options.on_force;
    const bool is_master = (view.state == FlyingState::kMaster);
    const bool is_waiting = (view.state == FlyingState::kDetect) || (view.state == FlyingState::kRace);
    const bool is_negotiating = (view.state == FlyingState::kDelay) || is_waiting;
    FlyingReaction reaction = FlyingReaction::kNone; // Of interest for active masters only.
    if (is_master && (wanted == ForceReaction::kResetAll))
    {
        reaction = FlyingReaction::kResetAll;
    }
    else if (is_master && (wanted == ForceReaction::kRace))
    {
        reaction = FlyingReaction::kRaceAnew;
    }
    else if (is_master || (is_negotiating && (wanted == ForceReaction::kRestart)))
    {
        reaction = FlyingReaction::kRestart;
    }
    else if (view.state == FlyingState::kSlave)
    {
        reaction = Asks(view);
    }
    return reaction;
}

FlyingReaction OnNegotiation(const FlyingView& view) noexcept
{
    // Where an active master sends 072h each cycle, only whoever races already knows that it is a race.
    const bool is_race = view.options.cyclic != CyclicMessage::kNegotiation;
    const bool is_waiting = (view.state == FlyingState::kDelay) || (view.state == FlyingState::kDetect);
    const bool is_before = is_waiting && is_race;
    // All who began nearly at once are of one race: to follow each of their frames would only put the end off.
    const std::uint32_t half_slot_us = (view.times.device_slot * kUsPerMs) / 2U;
    const bool is_late = (view.state == FlyingState::kRace) && (view.raced_us >= half_slot_us);
    FlyingReaction reaction = FlyingReaction::kNone; // Already in this race.
    if (view.state == FlyingState::kMaster)
    {
        reaction = FlyingReaction::kAnswer;
    }
    else if ((is_before || is_late) && !view.options.keeps_slot)
    {
        reaction = FlyingReaction::kJoin;
    }
    else if (view.state == FlyingState::kSlave)
    {
        const bool is_racing = (view.options.standby == StandbyReaction::kRaces);
        reaction = is_racing ? FlyingReaction::kRace : Asks(view);
    }
    return reaction;
}

FlyingReaction OnService(const FlyingView& view, const CanFrame& frame) noexcept
{
    FlyingReaction reaction = FlyingReaction::kNone;
    switch (static_cast<FlyingService>(frame.identifier))
    {
    case FlyingService::kActiveMaster:
        reaction = OnClaim(view, ClaimOf(frame));
        break;
    case FlyingService::kNegotiation:
        reaction = OnNegotiation(view);
        break;
    case FlyingService::kDetection:
        reaction = (view.state == FlyingState::kMaster) ? FlyingReaction::kAnswerInTurn : FlyingReaction::kNone;
        break;
    case FlyingService::kMasterCapable:
        reaction = FlyingReaction::kFoundCapable;
        break;
    case FlyingService::kCapableDetection:
        reaction = FlyingReaction::kTellCapable;
        break;
    case FlyingService::kForceNegotiation:
        reaction = OnForce(view);
        break;
    }
    return reaction;
}

FlyingReaction OnErrorControl(const FlyingView& view, const CanFrame& frame) noexcept
{
    const bool is_sign = frame.length_bytes == 1U;
    const bool is_boot_up = is_sign && (frame.data[0] == 0U);
    const bool is_of_master = (frame.identifier == (kErrorControl + view.master.node.value));
    FlyingReaction reaction = FlyingReaction::kNone;
    if ((view.state == FlyingState::kSlave) && is_sign && is_of_master)
    {
        reaction = FlyingReaction::kWatch;
    }
    else if ((view.state == FlyingState::kMaster) && is_boot_up && view.options.answers_boot_up)
    {
        reaction = FlyingReaction::kAnswerInTurn;
    }
    return reaction;
}

} // namespace

FlyingReaction Heard(const FlyingView& view, const CanFrame& frame) noexcept
{
    const bool is_deaf = (view.state == FlyingState::kInitialising) || (view.state == FlyingState::kHalted);
    const bool is_error_control =
        (frame.identifier > kErrorControl) && (frame.identifier <= (kErrorControl + kLastNode));
    FlyingReaction reaction = FlyingReaction::kNone; // Of another service, or only a reset is of interest.
    if (frame.kind != FrameKind::kData)
    {
        // None of these services is asked for.
    }
    else if (frame.identifier == 0U)
    {
        reaction = OnCommand(view, frame);
    }
    else if (!is_deaf && IsService(frame))
    {
        reaction = OnService(view, frame);
    }
    else if (!is_deaf && is_error_control)
    {
        reaction = OnErrorControl(view, frame);
    }
    return reaction;
}

} // namespace counterpoint::cia302
