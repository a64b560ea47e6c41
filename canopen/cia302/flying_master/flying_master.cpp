// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The steps of the negotiation in time; flying_master_heard.cpp has what is heard.
#include "canopen/cia302/flying_master/flying_master.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kUsPerMs = 1000U;
constexpr std::uint32_t kHalfRange = 0x80000000U;
constexpr FlyingDeadline kNone{false, Instant{0U}};
constexpr MasterClaim kNobody{0U, NodeId{0U}};

bool IsDue(const FlyingDeadline& deadline, const Instant now) noexcept
{
    return deadline.is_set && ((now.us - deadline.at.us) < kHalfRange);
}

CanFrame ResetAllFrame() noexcept
{
    constexpr std::uint8_t kResetCommunication = 130U;
    return CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {kResetCommunication, kAllNodes.value}};
}

} // namespace

FlyingMaster::FlyingMaster(const FlyingMasterParts& parts) noexcept
    : parts_(parts), times_(parts.times), master_(kNobody), state_(FlyingState::kInitialising), main_(kNone),
      second_(kNone), race_begin_{0U}, restarts_(0U), is_first_pass_(true), has_asked_(false), tells_force_(false),
      owes_capable_(false), has_found_capable_(false)
{
}

FlyingStart FlyingMaster::Start(const Instant now) noexcept
{
    const std::uint8_t node = parts_.setup.own.value;
    FlyingStart answer = FlyingStart::kStarted;
    if (state_ != FlyingState::kInitialising)
    {
        answer = FlyingStart::kNotInitialising;
    }
    else if ((node == 0U) || (node > kLastNode))
    {
        answer = FlyingStart::kNode;
    }
    else if (parts_.times.priority > kLowestPriority)
    {
        answer = FlyingStart::kPriority;
    }
    else if (!HasSeparateSlots(parts_.times))
    {
        answer = FlyingStart::kSlots;
    }
    else
    {
        times_ = parts_.times;
        Delay(now);
    }
    return answer;
}

void FlyingMaster::Reset(const Instant now) noexcept
{
    is_first_pass_ = false;
    Initialise(now);
}

void FlyingMaster::OnHeartbeatLost(const NodeId node, const Instant now) noexcept
{
    if ((state_ == FlyingState::kSlave) && (node.value == master_.node.value))
    {
        Lose(now);
    }
}

bool FlyingMaster::FindCapable() noexcept
{
    const bool is_sent = Send(FlyingService::kCapableDetection);
    has_found_capable_ = has_found_capable_ && !is_sent;
    return is_sent;
}

bool FlyingMaster::IsInitialising() const noexcept
{
    const bool has_role = (state_ == FlyingState::kMaster) || (state_ == FlyingState::kSlave);
    const bool has_none = (state_ == FlyingState::kInitialising) || (state_ == FlyingState::kHalted);
    return has_none || (!has_role && !parts_.options.negotiates_pre_operational);
}

FlyingDeadline FlyingMaster::Next() const noexcept
{
    return IsEarlier(second_, main_) ? second_ : main_;
}

void FlyingMaster::OnCycle(const Instant now) noexcept
{
    owes_capable_ = owes_capable_ && !Send(FlyingService::kMasterCapable);
    if (state_ == FlyingState::kMaster)
    {
        RunMaster(now);
    }
    else if (state_ == FlyingState::kSlave)
    {
        RunSlave(now);
    }
    else if (IsDue(main_, now))
    {
        RunNegotiation(now);
    }
    else
    {
        RunQuestion(now);
    }
}

/// Each step ends with a frame; if it is refused, the step stays due.
void FlyingMaster::RunNegotiation(const Instant now) noexcept
{
    switch (state_)
    {
    case FlyingState::kDelay:
        if (Send(FlyingService::kDetection))
        {
            Enter(FlyingState::kDetect, now, times_.timeout * kUsPerMs);
        }
        break;
    case FlyingState::kDetect:
        EndDetection(now);
        break;
    case FlyingState::kRace:
        EndRace(now);
        break;
    case FlyingState::kForcing:
        EndForcing(now);
        break;
    case FlyingState::kResetting:
        SendReset(now);
        break;
    case FlyingState::kInvalid:
    case FlyingState::kInitialising:
    case FlyingState::kSlave:
    case FlyingState::kHalted:
    case FlyingState::kMaster:
        break; // No deadline of a negotiation.
    }
}

/// 073h while a race goes on, see Join.
void FlyingMaster::RunQuestion(const Instant now) noexcept
{
    if ((state_ == FlyingState::kRace) && IsDue(second_, now) && Send(FlyingService::kDetection))
    {
        second_ = kNone;
        has_asked_ = true;
    }
}

void FlyingMaster::EndDetection(const Instant now) noexcept
{
    if (is_first_pass_)
    {
        SendReset(now);
    }
    else if (Send(FlyingService::kNegotiation))
    {
        Race(now);
    }
    else
    {
        // Again in the next cycle.
    }
}

void FlyingMaster::EndRace(const Instant now) noexcept
{
    if (parts_.sink.Send(ClaimFrame(Own())))
    {
        Enter(FlyingState::kMaster, now, times_.detection_cycle * kUsPerMs);
        main_.is_set = times_.detection_cycle > 0U;
        master_ = Own();
        restarts_ = 0U;
        Tell(FlyingEvent::kMasterMode, now);
    }
}

void FlyingMaster::EndForcing(const Instant now) noexcept
{
    if (Send(FlyingService::kForceNegotiation))
    {
        const bool tells = tells_force_;
        Delay(now);
        if (tells)
        {
            Tell(FlyingEvent::kForceNegotiation, now);
        }
    }
}

void FlyingMaster::SendReset(const Instant now) noexcept
{
    if (parts_.sink.Send(ResetAllFrame()))
    {
        const bool is_power_on = is_first_pass_;
        is_first_pass_ = false;
        if (is_power_on)
        {
            Tell(FlyingEvent::kPowerOnReset, now);
        }
        Initialise(now);
    }
}

void FlyingMaster::RunMaster(const Instant now) noexcept
{
    if (IsDue(second_, now) && parts_.sink.Send(ClaimFrame(Own())))
    {
        second_ = kNone;
    }
    const bool is_force = parts_.options.cyclic == CyclicMessage::kForce;
    const FlyingService cyclic = is_force ? FlyingService::kForceNegotiation : FlyingService::kNegotiation;
    if (IsDue(main_, now) && Send(cyclic))
    {
        main_.at.us = now.us + (times_.detection_cycle * kUsPerMs);
    }
}

void FlyingMaster::RunSlave(const Instant now) noexcept
{
    if (IsDue(main_, now))
    {
        Lose(now);
    }
    else if (IsDue(second_, now) && has_asked_)
    {
        // Nobody answers as master. Asking was the detection: the race begins.
        Enter(FlyingState::kDetect, now, 0U);
        RunNegotiation(now);
    }
    else if (IsDue(second_, now) && Send(FlyingService::kDetection))
    {
        has_asked_ = true;
        second_.at.us = now.us + (times_.timeout * kUsPerMs);
    }
    else
    {
        // The master lives, as far as is known.
    }
}

void FlyingMaster::Enter(const FlyingState state, const Instant now, const std::uint32_t time_us) noexcept
{
    state_ = state;
    main_ = FlyingDeadline{true, Instant{now.us + time_us}};
    second_ = kNone;
    master_ = kNobody;
    has_asked_ = false;
    tells_force_ = false;
}

void FlyingMaster::Delay(const Instant now) noexcept
{
    Enter(FlyingState::kDelay, now, times_.delay * kUsPerMs);
}

void FlyingMaster::Race(const Instant now) noexcept
{
    is_first_pass_ = false;
    race_begin_ = now;
    Enter(FlyingState::kRace, now, times_.WaitingUs(parts_.setup.own));
}

/// Bounded, because whoever claims to be master may be deaf to 076h, or may win again and again by other times.
void FlyingMaster::Force(const MasterClaim& claim, const FlyingEvent event, const Instant now) noexcept
{
    const std::uint8_t bound = parts_.options.max_restarts;
    if (event == FlyingEvent::kConfigurationError)
    {
        parts_.listener.OnFlyingMaster(event, claim, now);
    }
    if ((bound > 0U) && (restarts_ >= bound))
    {
        Follow(claim, now);
    }
    else
    {
        constexpr std::uint8_t kGreatest = 255U;
        restarts_ = static_cast<std::uint8_t>((restarts_ < kGreatest) ? (restarts_ + 1U) : kGreatest);
        Enter(FlyingState::kForcing, now, 0U);
        tells_force_ = event == FlyingEvent::kForceNegotiation;
        RunNegotiation(now);
    }
}

void FlyingMaster::Initialise(const Instant now) noexcept
{
    const bool was_at_rest = (state_ == FlyingState::kSlave) || (state_ == FlyingState::kMaster);
    restarts_ = was_at_rest ? 0U : restarts_;
    Enter(FlyingState::kInitialising, now, 0U);
    main_ = kNone;
    owes_capable_ = false;
    parts_.listener.OnInitialising(now);
}

void FlyingMaster::Follow(const MasterClaim& claim, const Instant now) noexcept
{
    is_first_pass_ = false;
    Enter(FlyingState::kSlave, now, 0U);
    master_ = claim;
    WatchMaster(now);
    Tell(FlyingEvent::kSlaveMode, now);
}

/// Its 071h counts as a first sign: a master that dies before its first heartbeat is missed too.
void FlyingMaster::WatchMaster(const Instant now) noexcept
{
    const bool is_own = parts_.options.watch != MasterWatch::kApplication;
    main_ = FlyingDeadline{is_own, Instant{now.us + WatchUs()}};
}

void FlyingMaster::Lose(const Instant now) noexcept
{
    restarts_ = 0U;
    switch (parts_.options.on_loss)
    {
    case LossReaction::kRestart:
        Delay(now);
        if (times_.delay == 0U)
        {
            RunNegotiation(now);
        }
        break;
    case LossReaction::kResetAll:
        Enter(FlyingState::kResetting, now, 0U);
        RunNegotiation(now);
        break;
    case LossReaction::kRace:
        Enter(FlyingState::kDetect, now, 0U);
        RunNegotiation(now);
        break;
    }
}

void FlyingMaster::Tell(const FlyingEvent event, const Instant now) noexcept
{
    const bool has_master = (event == FlyingEvent::kSlaveMode) || (event == FlyingEvent::kMasterMode);
    parts_.listener.OnFlyingMaster(event, has_master ? master_ : kNobody, now);
}

bool FlyingMaster::Send(const FlyingService service) noexcept
{
    return parts_.sink.Send(ServiceFrame(service));
}

MasterClaim FlyingMaster::Own() const noexcept
{
    return MasterClaim{times_.Level(), parts_.setup.own};
}

std::uint32_t FlyingMaster::WatchUs() const noexcept
{
    const bool is_twice =
        (parts_.options.watch == MasterWatch::kTwiceProducer) && (parts_.options.own_producer_ms > 0U);
    const std::uint32_t other_ms = is_twice ? (2U * parts_.options.own_producer_ms) : parts_.options.watch_ms;
    const std::uint16_t own_ms = parts_.setup.Slave(master_.node).heartbeat.consumer_ms;
    return ((own_ms > 0U) ? own_ms : other_ms) * kUsPerMs;
}

} // namespace counterpoint::cia302
