// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/device.hpp"

#include <algorithm>

namespace counterpoint::third_voice
{
namespace
{
SrdoMask BitOf(const std::ptrdiff_t slot)
{
    return SrdoMask{1U} << static_cast<unsigned>(slot);
}

constexpr std::uint32_t kGfcIdentifier = 1U;
} // namespace

Device::Device(const DeviceConfig& config, const Flaw flaw, const Drift& drift)
    : flaw_(flaw), configuration_(config, flaw), variables_(config), own_gfc_(config, flaw)
{
    for (std::size_t slot = 0U; slot < config.srdo_count; ++slot)
    {
        const SrdoObjects& objects = configuration_.Objects(slot);
        srdos_.push_back({config.srdos[slot].number,
                          objects,
                          ConsumerSrdo{config, slot, objects, flaw, variables_},
                          ProducerSrdo{config, slot, objects, flaw, drift},
                          {}});
    }
}

void Device::Start(const std::vector<SrdoObjects>& objects, const std::uint32_t gfc_parameter)
{
    for (std::size_t slot = 0U; slot < objects.size(); ++slot)
    {
        configuration_.SetInitial(slot, objects[slot]);
    }
    configuration_.SetGfcParameter(gfc_parameter);
    configuration_.Start();
    own_gfc_.Start();
    nmt_ = NmtState::kInitialising;
    is_running_ = false;
}

AbortCode Device::Write(const Address address, const std::uint64_t value, const std::size_t size)
{
    if (variables_.Has(address))
    {
        return AbortCode::kReadOnly;
    }
    const Written written = configuration_.Write(address, static_cast<std::uint32_t>(value), size, nmt_);
    for (const std::size_t slot : written.safe)
    {
        srdos_[slot].consumer.WriteSafe();
    }
    return written.abort;
}

// ---- NMT

void Device::SetNmt(const NmtState state)
{
    const bool leaves = nmt_ == NmtState::kOperational && state != NmtState::kOperational;
    nmt_ = state;
    if (leaves)
    {
        has_left_ = true;
        Leave();
    }
}

void Device::Leave()
{
    for (Srdo& srdo : srdos_)
    {
        srdo.consumer.LeaveOperational(is_running_ && srdo.objects.direction == kDirectionConsumer);
        srdo.producer.LeaveOperational();
    }
    is_running_ = false;
    has_entered_ = false;
}

/// With the first cycle behind the command.
void Device::Enter(const Time now)
{
    has_entered_ = true;
    const bool is_sound = configuration_.IsValid() && configuration_.IsAllSound();
    seen_.is_configuration_invalid = configuration_.IsValid() && !is_sound;
    is_running_ = is_sound;
    for (Srdo& srdo : srdos_)
    {
        if (is_sound && srdo.objects.direction == kDirectionConsumer)
        {
            srdo.consumer.EnterOperational(now);
        }
        if (is_sound && srdo.objects.direction == kDirectionProducer)
        {
            srdo.producer.EnterOperational(now, level_2_.IsOn());
        }
    }
}

// ---- calls of the bus and of the application

void Device::OnFrame(const CanFrame& frame, const Time stamp)
{
    if (nmt_ != NmtState::kOperational || frame.kind != FrameKind::kData)
    {
        return;
    }
    if (frame.identifier == kGfcIdentifier && frame.length_bytes == 0U && configuration_.IsGfcOn())
    {
        has_gfc_ = true; // Takes effect with the cycle.
        has_gfc_fault_ = is_running_;
        return;
    }
    const Bytes data(frame.data, frame.data + std::min<std::size_t>(frame.length_bytes, 8U));
    for (Srdo& srdo : srdos_)
    {
        srdo.consumer.OnFrame(frame.identifier, data, stamp);
    }
}

void Device::OnConfirm(const Sent& frame, const Time stamp)
{
    for (Srdo& srdo : srdos_)
    {
        const Confirmed confirmed = srdo.producer.Confirm(frame, stamp);
        if (confirmed == Confirmed::kNormal && (!level_2_.IsOn() || flaw_ == Flaw::kSentInLevel2))
        {
            static_cast<void>(HandOver(srdo, srdo.producer.Inverse()));
        }
        else if (confirmed == Confirmed::kPair)
        {
            seen_.events.push_back(srdo.number);
        }
    }
}

void Device::Put(const Address address, const std::uint64_t value)
{
    variables_.Put(address, value);
}

void Device::Send(const std::uint8_t number)
{
    if (!level_2_.IsOn())
    {
        srdos_[configuration_.SlotOf(number).value()].producer.Request();
    }
}

bool Device::SendGfc()
{
    if (nmt_ != NmtState::kOperational || !configuration_.IsGfcOn() || level_2_.IsOn())
    {
        return false;
    }
    seen_.frames.push_back({kGfcIdentifier, {}});
    own_gfc_.OnSent(ShortestRefresh());
    return true;
}

/// Of the producers, 0 without one.
Time Device::ShortestRefresh() const
{
    Time shortest = 0;
    for (const Srdo& srdo : srdos_)
    {
        const Time refresh = kUsPerMs * srdo.objects.sct_ms;
        const bool is_shorter = shortest == 0 || refresh < shortest;
        if (srdo.objects.direction == kDirectionProducer && is_shorter)
        {
            shortest = refresh;
        }
    }
    return shortest;
}

void Device::DemandSafeState()
{
    level_2_.Demand();
}

void Device::RefuseNext(const std::optional<SrdoCause> cause)
{
    refused_ = cause;
}

// ---- the cycle

void Device::Cycle(const Time now, const SrdoMask acknowledge_a, const SrdoMask acknowledge_b)
{
    const bool is_shown_as_left = has_left_;
    has_left_ = false;
    if (nmt_ == NmtState::kOperational && !has_entered_ && !is_shown_as_left)
    {
        Enter(now);
    }
    const bool is_gfc = has_gfc_fault_ && is_running_;
    seen_.gfcs += has_gfc_ ? 1 : 0;
    has_gfc_ = false;
    has_gfc_fault_ = false;
    for (Srdo& srdo : srdos_)
    {
        const SrdoMask bit = BitOf(&srdo - srdos_.data());
        srdo.consumer.LookAtAcknowledge((acknowledge_a & bit) != 0U, (acknowledge_b & bit) != 0U, now);
        if (srdo.consumer.IsActive())
        {
            Consume(srdo, now, is_gfc);
        }
        const bool is_due = srdo.producer.IsActive() && srdo.producer.Look(now, level_2_.IsOn());
        TellCauses(srdo, now);
        if (is_due)
        {
            Produce(srdo, now);
        }
    }
    seen_.faults += level_2_.Tell() ? 1 : 0;
    seen_.unfollowed += own_gfc_.Look(now) ? 1 : 0;
}

void Device::Consume(Srdo& srdo, const Time now, const bool is_gfc)
{
    srdo.consumer.LookAtLimits(now);
    if (is_gfc)
    {
        srdo.consumer.Fail(SrdoCause::kGfc);
    }
    srdo.consumer.LookAtWaiting(now);
    if (srdo.consumer.Decide(now, level_2_.IsOn()))
    {
        seen_.events.push_back(srdo.number);
    }
}

void Device::Produce(Srdo& srdo, const Time now)
{
    if (srdo.producer.IsCalled())
    {
        seen_.refreshes.push_back(srdo.number);
    }
    const std::optional<Sent> normal = srdo.producer.Prepare(variables_, now);
    if (normal)
    {
        own_gfc_.OnNormal(HandOver(srdo, *normal));
    }
}

/// To the controller: whether it takes the frame.
bool Device::HandOver(Srdo& srdo, const Sent& frame)
{
    seen_.frames.push_back(frame);
    const bool is_taken = !refused_;
    if (refused_)
    {
        srdo.producer.Fail(*refused_);
        refused_.reset();
    }
    return is_taken;
}

/// At most once per SCT (or refresh time) and cause. [semantics 2]
void Device::TellCauses(Srdo& srdo, const Time now)
{
    std::set<SrdoCause> causes = srdo.consumer.TakeCauses();
    causes.merge(srdo.producer.TakeCauses());
    for (const SrdoCause cause : causes)
    {
        const auto told = srdo.told_at.find(cause);
        const Time window = (flaw_ == Flaw::kToldAlways) ? -1 : kUsPerMs * srdo.objects.sct_ms;
        if (told == srdo.told_at.end() || now - told->second > window)
        {
            srdo.told_at[cause] = now;
            seen_.signals.emplace_back(srdo.number, cause);
        }
    }
}

// ---- what is seen

std::uint64_t Device::Variable(const Address address) const
{
    return variables_.At(address);
}

const Configuration& Device::Configured() const
{
    return configuration_;
}

SrdoState Device::StateOf(const std::uint8_t number) const
{
    const Srdo& srdo = srdos_[configuration_.SlotOf(number).value()];
    if (!is_running_ || srdo.objects.direction == 0U)
    {
        return SrdoState::kOff;
    }
    return (srdo.objects.direction == kDirectionProducer) ? SrdoState::kProducer : srdo.consumer.State();
}

bool Device::IsInLevel2() const
{
    return level_2_.IsOn();
}

SrdoMask Device::Open() const
{
    SrdoMask open = 0U;
    for (const Srdo& srdo : srdos_)
    {
        open |= srdo.consumer.IsReleased() ? BitOf(&srdo - srdos_.data()) : 0U;
    }
    return open;
}

Time Device::NextRefresh(const std::uint8_t number) const
{
    return srdos_[configuration_.SlotOf(number).value()].producer.NextRefresh();
}

std::optional<Time> Device::SilenceEndsBetween(const Time first, const Time last) const
{
    for (const Srdo& srdo : srdos_)
    {
        const std::optional<Time> until = srdo.producer.SilentUntil();
        if (until && *until >= first && *until <= last)
        {
            return until;
        }
    }
    return std::nullopt;
}

bool Device::IsOpen() const
{
    return std::any_of(srdos_.begin(), srdos_.end(), [](const Srdo& srdo) { return srdo.consumer.IsOpen(); });
}

Seen Device::TakeSeen()
{
    Seen taken;
    std::swap(taken, seen_);
    return taken;
}
} // namespace counterpoint::third_voice
