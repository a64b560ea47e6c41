// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the flying master does when it hears a frame; flying_master.cpp has the steps in time.
#include "canopen/cia302/flying_master/flying_master.hpp"

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

/// Two masters that answer the same 073h or boot-up message in the same instant would collide until both are bus-off.
/// 16 places, 3 ms apart with the default of 1F90h:01, keep them apart, and the last one is well within the time of the
/// asker. 072h is answered at once: it comes from the other one of two masters more often than from a third device, and
/// a later answer would meet the one to the 073h that standbys ask then.
std::uint32_t AnswerDelayUs(const FlyingMasterTimes& times, const NodeId node) noexcept
{
    constexpr std::uint32_t kPlaces = 16U;
    return ((node.value % kPlaces) * times.timeout * kUsPerMs) / (2U * kPlaces);
}

} // namespace

void FlyingMaster::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    const bool is_deaf = (state_ == FlyingState::kInitialising) || (state_ == FlyingState::kHalted);
    if (frame.kind != FrameKind::kData)
    {
        return;
    }
    if (frame.identifier == 0U)
    {
        OnCommand(frame, now);
    }
    else if (is_deaf)
    {
        // Only a reset is of interest.
    }
    else if (IsService(frame))
    {
        const MasterClaim claim{frame.data[0], NodeId{frame.data[1]}};
        if (frame.identifier != kFirstService)
        {
            OnService(static_cast<FlyingService>(frame.identifier), now);
        }
        else if ((claim.node.value >= 1U) && (claim.node.value <= kLastNode))
        {
            OnClaim(claim, now);
        }
        else
        {
            // No such node.
        }
    }
    else if ((frame.identifier > kErrorControl) && (frame.identifier <= (kErrorControl + kLastNode)))
    {
        OnErrorControl(frame, now);
    }
    else
    {
        // Of another service.
    }
}

/// An active master commands others and obeys nobody, so that a second one cannot stop it by a broadcast.
void FlyingMaster::OnCommand(const CanFrame& frame, const Instant now) noexcept
{
    constexpr std::uint8_t kResetNode = 129U;
    constexpr std::uint8_t kResetCommunication = 130U;
    const bool is_reset = (frame.data[0] == kResetNode) || (frame.data[0] == kResetCommunication);
    const bool is_for_us = (frame.data[1] == kAllNodes.value) || (frame.data[1] == parts_.setup.own.value);
    if ((frame.length_bytes != 2U) || !is_reset || !is_for_us || (state_ == FlyingState::kMaster))
    {
        return;
    }
    is_first_pass_ = false;
    if (state_ != FlyingState::kInitialising)
    {
        Initialise(now);
    }
}

void FlyingMaster::OnService(const FlyingService service, const Instant now) noexcept
{
    switch (service)
    {
    case FlyingService::kActiveMaster:
        break; // See OnClaim.
    case FlyingService::kNegotiation:
        OnNegotiation(now);
        break;
    case FlyingService::kDetection:
        if (state_ == FlyingState::kMaster)
        {
            Answer(AnswerDelayUs(times_, parts_.setup.own), now);
        }
        break;
    case FlyingService::kMasterCapable:
        has_found_capable_ = true;
        break;
    case FlyingService::kCapableDetection:
        owes_capable_ = !Send(FlyingService::kMasterCapable);
        break;
    case FlyingService::kForceNegotiation:
        OnForce(now);
        break;
    }
}

void FlyingMaster::OnErrorControl(const CanFrame& frame, const Instant now) noexcept
{
    const bool is_sign = frame.length_bytes == 1U;
    const bool is_boot_up = is_sign && (frame.data[0] == 0U);
    if ((state_ == FlyingState::kSlave) && is_sign && (frame.identifier == (kErrorControl + master_.node.value)))
    {
        WatchMaster(now);
    }
    else if ((state_ == FlyingState::kMaster) && is_boot_up && parts_.options.answers_boot_up)
    {
        Answer(AnswerDelayUs(times_, parts_.setup.own), now);
    }
    else
    {
        // Not of the active master.
    }
}

void FlyingMaster::OnClaim(const MasterClaim& claim, const Instant now) noexcept
{
    const bool is_negotiating = (state_ == FlyingState::kDetect) || (state_ == FlyingState::kRace);
    const bool listens = (state_ == FlyingState::kDelay) || is_negotiating;
    if (claim.node.value == parts_.setup.own.value)
    {
        Halt(claim, now);
    }
    else if (state_ == FlyingState::kMaster)
    {
        OnClaimAsMaster(claim, now);
    }
    else if (state_ == FlyingState::kSlave)
    {
        OnClaimAsSlave(claim, now);
    }
    else if (listens && Accepts(claim))
    {
        restarts_ = 0U;
        Follow(claim, now);
    }
    else if (is_negotiating)
    {
        const bool has_asked = (state_ == FlyingState::kDetect) || has_asked_;
        Force(claim, has_asked ? FlyingEvent::kForceNegotiation : FlyingEvent::kConfigurationError, now);
    }
    else
    {
        // In step 1 a worse master is left in peace until it was asked; and 076h or a reset that is to leave leaves.
    }
}

/// Whether this device becomes slave of such a master.
bool FlyingMaster::Accepts(const MasterClaim& claim) const noexcept
{
    // Once the waiting has begun, all that counts is who was first.
    const bool can_pre_empt =
        (parts_.options.equal_level == EqualLevel::kLowerNodeForces) && (state_ != FlyingState::kRace);
    const bool is_equal_accepted = !can_pre_empt || (claim.node.value < parts_.setup.own.value);
    const bool is_equal = claim.level == times_.Level();
    return (claim.level < times_.Level()) || (is_equal && is_equal_accepted);
}

/// The better one of two masters stays, and tells the other one by its own claim.
void FlyingMaster::OnClaimAsMaster(const MasterClaim& claim, const Instant now) noexcept
{
    if (parts_.options.ignores_claims)
    {
        // As if the only message buffer of 071h were one for sending.
    }
    else if (IsBetter(claim, Own()))
    {
        Follow(claim, now);
    }
    else
    {
        Answer(0U, now);
    }
}

/// One answer is enough for all who wait for one, at the earliest of their times.
void FlyingMaster::Answer(const std::uint32_t delay_us, const Instant now) noexcept
{
    const FlyingDeadline answer{true, Instant{now.us + delay_us}};
    second_ = IsEarlier(answer, second_) ? answer : second_;
    RunMaster(now);
}

/// A standby that watches its master changes to a better one only: two masters settle who stays. Whoever does not watch
/// has only claims to go by.
void FlyingMaster::OnClaimAsSlave(const MasterClaim& claim, const Instant now) noexcept
{
    const bool is_watched = parts_.options.watch != MasterWatch::kApplication;
    const bool has_asked = has_asked_;
    if (claim.node.value == master_.node.value)
    {
        master_ = claim;
        second_.is_set = false;
        has_asked_ = false;
        WatchMaster(now);
    }
    else if (IsBetter(claim, master_) || (!is_watched && Accepts(claim)))
    {
        Follow(claim, now);
    }
    else if (has_asked && !is_watched)
    {
        Force(claim, FlyingEvent::kForceNegotiation, now);
    }
    else
    {
        // The own master lives.
    }
}

void FlyingMaster::OnForce(const Instant now) noexcept
{
    const ForceReaction reaction = parts_.options.on_force;
    const bool is_waiting = (state_ == FlyingState::kDetect) || (state_ == FlyingState::kRace);
    const bool is_negotiating = (state_ == FlyingState::kDelay) || is_waiting;
    if ((state_ == FlyingState::kMaster) && (reaction == ForceReaction::kResetAll))
    {
        Enter(FlyingState::kResetting, now, 0U);
        RunNegotiation(now);
    }
    else if ((state_ == FlyingState::kMaster) && (reaction == ForceReaction::kRace))
    {
        Enter(FlyingState::kDetect, now, 0U);
        RunNegotiation(now);
    }
    else if ((state_ == FlyingState::kMaster) || (is_negotiating && (reaction == ForceReaction::kRestart)))
    {
        Delay(now);
    }
    else if (state_ == FlyingState::kSlave)
    {
        Ask(now);
    }
    else
    {
        // Of interest for active masters only.
    }
}

void FlyingMaster::OnNegotiation(const Instant now) noexcept
{
    // Where an active master sends 072h each cycle, only whoever races already knows that it is a race.
    const bool is_race = parts_.options.cyclic != CyclicMessage::kNegotiation;
    const bool is_waiting = (state_ == FlyingState::kDelay) || (state_ == FlyingState::kDetect);
    const bool is_before = is_waiting && is_race;
    // All who began nearly at once are of one race: to follow each of their frames would only put the end off.
    const std::uint32_t half_slot_us = (times_.device_slot * kUsPerMs) / 2U;
    const bool is_late = (state_ == FlyingState::kRace) && ((now.us - race_begin_.us) >= half_slot_us);
    if (state_ == FlyingState::kMaster)
    {
        Answer(0U, now);
    }
    else if ((is_before || is_late) && !parts_.options.keeps_slot)
    {
        Join(now);
    }
    else if ((state_ == FlyingState::kSlave) && (parts_.options.standby == StandbyReaction::kRaces))
    {
        Race(now);
    }
    else if (state_ == FlyingState::kSlave)
    {
        Ask(now);
    }
    else
    {
        // Already in this race.
    }
}

/// The 072h of another may be the cyclic one of an active master, whose claim was lost or not yet asked for. Waiting
/// alone would never end where its cycle is shorter than the own slot: this device asks while it waits.
void FlyingMaster::Join(const Instant now) noexcept
{
    const bool has_asked = (state_ == FlyingState::kDetect);
    Race(now);
    second_ = FlyingDeadline{!has_asked, now};
    RunQuestion(now);
}

/// What a standby does about 072h and 076h, but for 072h with kRaces: it ignores them, or asks unless it has asked.
void FlyingMaster::Ask(const Instant now) noexcept
{
    const StandbyReaction reaction = parts_.options.standby;
    if ((reaction == StandbyReaction::kAsks) && !second_.is_set)
    {
        second_ = FlyingDeadline{true, now};
        RunSlave(now);
    }
}

void FlyingMaster::Halt(const MasterClaim& claim, const Instant now) noexcept
{
    Enter(FlyingState::kHalted, now, 0U);
    main_.is_set = false;
    owes_capable_ = false;
    parts_.listener.OnFlyingMaster(FlyingEvent::kConfigurationError, claim, now);
}

} // namespace counterpoint::cia302
