// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
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

/// Two masters that answer the same 073h or boot-up message in the same instant would collide until both are bus-off.
/// 16 places, 3 ms apart with the default of 1F90h:01, keep them apart, and the last one is well within the time of the
/// asker. 072h is answered at once: it comes from the other one of two masters more often than from a third device, and
/// a later answer would meet the one to the 073h that standbys ask then.
std::uint32_t AnswerDelayUs(const FlyingMasterTimes& times, const NodeId node) noexcept
{
    constexpr std::uint32_t kPlaces = 16U;
    return ((node.value % kPlaces) * times.timeout * kUsPerMs) / (2U * kPlaces);
}

/// How long the heartbeat of `master` may be missing.
std::uint32_t WatchUs(const FlyingMasterParts& parts, const NodeId master) noexcept
{
    const bool is_twice = (parts.options.watch == MasterWatch::kTwiceProducer) && (parts.options.own_producer_ms > 0U);
    const std::uint32_t other_ms = is_twice ? (2U * parts.options.own_producer_ms) : parts.options.watch_ms;
    const std::uint16_t own_ms = parts.setup.Slave(master).heartbeat.consumer_ms;
    return ((own_ms > 0U) ? own_ms : other_ms) * kUsPerMs;
}

/// A role that lasts ends the count of restarts. One that ends sooner is a part of the same election, whoever ended it:
/// a new master resets all, and so does a manager that starts its network.
std::uint8_t RestartsAfter(const std::uint8_t restarts, const FlyingState state, const std::uint32_t rest_us,
                           const FlyingMasterTimes& times) noexcept
{
    const bool is_at_rest = (state == FlyingState::kSlave) || (state == FlyingState::kMaster);
    return (is_at_rest && (rest_us >= LongestNegotiationUs(times))) ? std::uint8_t{0U} : restarts;
}

bool Send(cia301::FrameSink& sink, const FlyingService service) noexcept
{
    return sink.Send(ServiceFrame(service));
}

CanFrame ResetAllFrame() noexcept
{
    constexpr std::uint8_t kResetCommunication = 130U;
    return CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {kResetCommunication, kAllNodes.value}};
}

} // namespace

FlyingMaster::FlyingMaster(const FlyingMasterParts& parts) noexcept
    : parts_(parts), times_(parts.times), master_(kNobody), state_(FlyingState::kInitialising), main_(kNone),
      second_(kNone), race_begin_{0U}, rest_begin_{0U}, restarts_(0U), is_first_pass_(true), has_asked_(false),
      tells_force_(false), owes_capable_(false), has_found_capable_(false)
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
        Enter(FlyingInput::kStart, now, times_.delay * kUsPerMs);
    }
    return answer;
}

void FlyingMaster::Reset(const Instant now) noexcept
{
    restarts_ = RestartsAfter(restarts_, state_, now.us - rest_begin_.us, times_);
    is_first_pass_ = false;
    Initialise(now);
}

void FlyingMaster::OnHeartbeatLost(const NodeId node, const Instant now) noexcept
{
    restarts_ = RestartsAfter(restarts_, state_, now.us - rest_begin_.us, times_);
    if ((state_ == FlyingState::kSlave) && (node.value == master_.node.value))
    {
        Lose(now);
    }
}

bool FlyingMaster::FindCapable() noexcept
{
    const bool is_sent = Send(parts_.sink, FlyingService::kCapableDetection);
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

void FlyingMaster::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    restarts_ = RestartsAfter(restarts_, state_, now.us - rest_begin_.us, times_);
    const MasterClaim own{times_.Level(), parts_.setup.own};
    const FlyingView view{state_, parts_.options, times_, own, master_, has_asked_, now.us - race_begin_.us};
    React(Heard(view, frame), frame, now);
}

void FlyingMaster::React(const FlyingReaction reaction, const CanFrame& frame, const Instant now) noexcept
{
    switch (reaction)
    {
    case FlyingReaction::kNone:
        break;
    case FlyingReaction::kReset:
        is_first_pass_ = false;
        if (state_ != FlyingState::kInitialising)
        {
            Initialise(now);
        }
        break;
    case FlyingReaction::kHalt:
    case FlyingReaction::kAccept:
    case FlyingReaction::kFollow:
    case FlyingReaction::kRefresh:
    case FlyingReaction::kForce:
    case FlyingReaction::kReject:
        ReactToClaim(reaction, ClaimOf(frame), now);
        break;
    case FlyingReaction::kAnswer:
        Answer(0U, now);
        break;
    case FlyingReaction::kAnswerInTurn:
        Answer(AnswerDelayUs(times_, parts_.setup.own), now);
        break;
    case FlyingReaction::kJoin:
    case FlyingReaction::kRace:
        Join(reaction == FlyingReaction::kJoin, now);
        break;
    case FlyingReaction::kAsk:
        if (!second_.is_set)
        {
            second_ = FlyingDeadline{true, now};
            RunSlave(now);
        }
        break;
    case FlyingReaction::kRestart:
        is_first_pass_ = false;
        Enter(FlyingInput::kRestart, now, times_.delay * kUsPerMs);
        break;
    case FlyingReaction::kResetAll:
    case FlyingReaction::kRaceAnew:
        Enter((reaction == FlyingReaction::kResetAll) ? FlyingInput::kResetAll : FlyingInput::kRaceAnew, now, 0U);
        RunNegotiation(now);
        break;
    case FlyingReaction::kWatch:
        WatchMaster(now);
        break;
    case FlyingReaction::kFoundCapable:
        has_found_capable_ = true;
        break;
    case FlyingReaction::kTellCapable:
        owes_capable_ = !Send(parts_.sink, FlyingService::kMasterCapable);
        break;
    }
}

void FlyingMaster::ReactToClaim(const FlyingReaction reaction, const MasterClaim& claim, const Instant now) noexcept
{
    if (reaction == FlyingReaction::kHalt)
    {
        Enter(FlyingInput::kSameNode, now, 0U);
        main_.is_set = false;
        owes_capable_ = false;
        parts_.listener.OnFlyingMaster(FlyingEvent::kConfigurationError, claim, now);
    }
    else if (reaction == FlyingReaction::kRefresh)
    {
        master_ = claim;
        second_.is_set = false;
        has_asked_ = false;
        WatchMaster(now);
    }
    else if (reaction == FlyingReaction::kForce)
    {
        Force(claim, FlyingEvent::kForceNegotiation, now);
    }
    else if (reaction == FlyingReaction::kReject)
    {
        Force(claim, FlyingEvent::kConfigurationError, now);
    }
    else
    {
        Follow(claim, now);
    }
}

/// One answer is enough for all who wait for one, at the earliest of their times.
void FlyingMaster::Answer(const std::uint32_t delay_us, const Instant now) noexcept
{
    const FlyingDeadline answer{true, Instant{now.us + delay_us}};
    second_ = IsEarlier(answer, second_) ? answer : second_;
    RunMaster(now);
}

/// The 072h of another may be the cyclic one of an active master, whose claim was lost or not yet asked for. Waiting
/// alone would never end where its cycle is shorter than the own slot: this device asks while it waits, unless it was a
/// standby or has asked.
void FlyingMaster::Join(const bool is_asking, const Instant now) noexcept
{
    const bool has_asked = (state_ == FlyingState::kDetect) || !is_asking;
    Enter(FlyingInput::kJoin, now, times_.WaitingUs(parts_.setup.own));
    second_ = FlyingDeadline{!has_asked, now};
    RunQuestion(now);
}

void FlyingMaster::OnCycle(const Instant now) noexcept
{
    restarts_ = RestartsAfter(restarts_, state_, now.us - rest_begin_.us, times_);
    owes_capable_ = owes_capable_ && !Send(parts_.sink, FlyingService::kMasterCapable);
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
        if (Send(parts_.sink, FlyingService::kDetection))
        {
            Enter(FlyingInput::kSent, now, times_.timeout * kUsPerMs);
        }
        break;
    case FlyingState::kDetect:
        if (is_first_pass_)
        {
            SendReset(now);
        }
        else if (Send(parts_.sink, FlyingService::kNegotiation))
        {
            Enter(FlyingInput::kSent, now, times_.WaitingUs(parts_.setup.own));
        }
        break;
    case FlyingState::kRace:
        EndRace(now);
        break;
    case FlyingState::kForcing:
        if (Send(parts_.sink, FlyingService::kForceNegotiation))
        {
            const bool tells = tells_force_;
            Enter(FlyingInput::kSent, now, times_.delay * kUsPerMs);
            if (tells)
            {
                parts_.listener.OnFlyingMaster(FlyingEvent::kForceNegotiation, kNobody, now);
            }
        }
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
    if ((state_ == FlyingState::kRace) && IsDue(second_, now) && Send(parts_.sink, FlyingService::kDetection))
    {
        second_ = kNone;
        has_asked_ = true;
    }
}

void FlyingMaster::EndRace(const Instant now) noexcept
{
    const MasterClaim own{times_.Level(), parts_.setup.own};
    if (parts_.sink.Send(ClaimFrame(own)))
    {
        Enter(FlyingInput::kSent, now, times_.detection_cycle * kUsPerMs);
        main_.is_set = times_.detection_cycle > 0U;
        master_ = own;
        parts_.listener.OnFlyingMaster(FlyingEvent::kMasterMode, master_, now);
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
            parts_.listener.OnFlyingMaster(FlyingEvent::kPowerOnReset, kNobody, now);
        }
        Initialise(now);
    }
}

void FlyingMaster::RunMaster(const Instant now) noexcept
{
    const MasterClaim own{times_.Level(), parts_.setup.own};
    if (IsDue(second_, now) && parts_.sink.Send(ClaimFrame(own)))
    {
        second_ = kNone;
    }
    const bool is_force = parts_.options.cyclic == CyclicMessage::kForce;
    const FlyingService cyclic = is_force ? FlyingService::kForceNegotiation : FlyingService::kNegotiation;
    if (IsDue(main_, now) && Send(parts_.sink, cyclic))
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
        Enter(FlyingInput::kRaceAnew, now, 0U);
        RunNegotiation(now);
    }
    else if (IsDue(second_, now) && Send(parts_.sink, FlyingService::kDetection))
    {
        has_asked_ = true;
        second_.at.us = now.us + (times_.timeout * kUsPerMs);
    }
    else
    {
        // The master lives, as far as is known.
    }
}

/// The next state, with nothing left of the one before.
void FlyingMaster::Enter(const FlyingInput input, const Instant now, const std::uint32_t time_us) noexcept
{
    state_ = cia302::Next(state_, input);
    main_ = FlyingDeadline{true, Instant{now.us + time_us}};
    second_ = kNone;
    master_ = kNobody;
    rest_begin_ = now;
    has_asked_ = false;
    tells_force_ = false;
    if (state_ == FlyingState::kRace)
    {
        is_first_pass_ = false;
        race_begin_ = now;
    }
}

/// Bounded, because whoever claims to be master may be deaf to 076h, or may win again and again by other times.
void FlyingMaster::Force(const MasterClaim& claim, const FlyingEvent event, const Instant now) noexcept
{
    const std::uint8_t bound = parts_.options.max_restarts;
    const bool is_given_up = (bound > 0U) && (restarts_ >= bound);
    if ((event == FlyingEvent::kConfigurationError) || is_given_up)
    {
        parts_.listener.OnFlyingMaster(FlyingEvent::kConfigurationError, claim, now);
    }
    if (is_given_up)
    {
        Follow(claim, now);
    }
    else
    {
        constexpr std::uint8_t kGreatest = 255U;
        restarts_ = static_cast<std::uint8_t>((restarts_ < kGreatest) ? (restarts_ + 1U) : kGreatest);
        is_first_pass_ = false; // Nor is the one that follows, though nobody resets this device. [SRS_FLY_480]
        Enter(FlyingInput::kForce, now, 0U);
        tells_force_ = event == FlyingEvent::kForceNegotiation;
        RunNegotiation(now);
    }
}

void FlyingMaster::Initialise(const Instant now) noexcept
{
    Enter(FlyingInput::kReset, now, 0U);
    main_ = kNone;
    owes_capable_ = false;
    parts_.listener.OnInitialising(now);
}

void FlyingMaster::Follow(const MasterClaim& claim, const Instant now) noexcept
{
    is_first_pass_ = false;
    Enter(FlyingInput::kFollow, now, 0U);
    master_ = claim;
    WatchMaster(now);
    parts_.listener.OnFlyingMaster(FlyingEvent::kSlaveMode, master_, now);
}

/// Its 071h counts as a first sign: a master that dies before its first heartbeat is missed too.
void FlyingMaster::WatchMaster(const Instant now) noexcept
{
    const bool is_own = parts_.options.watch != MasterWatch::kApplication;
    main_ = FlyingDeadline{is_own, Instant{now.us + WatchUs(parts_, master_.node)}};
}

void FlyingMaster::Lose(const Instant now) noexcept
{
    switch (parts_.options.on_loss)
    {
    case LossReaction::kRestart:
        Enter(FlyingInput::kRestart, now, times_.delay * kUsPerMs);
        if (times_.delay == 0U)
        {
            RunNegotiation(now);
        }
        break;
    case LossReaction::kResetAll:
        Enter(FlyingInput::kResetAll, now, 0U);
        RunNegotiation(now);
        break;
    case LossReaction::kRace:
        Enter(FlyingInput::kRaceAnew, now, 0U);
        RunNegotiation(now);
        break;
    }
}

} // namespace counterpoint::cia302
