// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/crosslink/peer.hpp"

#include "safety_core/comparator/slot_mask.hpp"

namespace counterpoint
{
namespace
{

// The next slot of the set behind `last`, from the lowest again behind the highest.
SlotIndex NextBehind(const SrdoMask set, const SlotIndex last) noexcept
{
    const SrdoMask bit = OnlySlot(last).mask;
    const SrdoMask behind = set & ~((bit - 1U) | bit);
    SlotSet choice{(behind != 0U) ? behind : set};
    return TakeLowest(choice);
}

// What the peer is told of an active consumer.
SlotReport ReportOf(const OwnVoice& own, const SlotIndex slot, const Instant now) noexcept
{
    const HeldPair held = own.Held(slot);
    const SrdoView view = own.View(slot);
    const bool holds = held.holds_pair != 0U;
    const Instant moment = holds ? own.Moments().PairAt(slot) : own.Moments().DiscardedAt(slot);
    return SlotReport{slot,         holds ? Holding::kPair : Holding::kNothing,
                      view.state,   view.first_cause,
                      held.ordinal, now.us - moment.us,
                      held.data};
}

} // namespace

Peer::Peer(Channel& channel, hal::Watchdog& watchdog, const LinkConfig& config) noexcept
    : own_{channel, config.role}, remote_{own_, config}, flow_{watchdog}, config_{config}
{
}

Channel& Peer::VoiceA() noexcept
{
    if (config_.role == PeerRole::kA)
    {
        return own_;
    }
    return remote_;
}

Channel& Peer::VoiceB() noexcept
{
    if (config_.role == PeerRole::kA)
    {
        return remote_;
    }
    return own_;
}

hal::Watchdog& Peer::Watchdog() noexcept
{
    return flow_;
}

void Peer::OnMessage(const hal::LinkFrame& frame, const Instant received) noexcept
{
    const PeerRole role = (config_.role == PeerRole::kA) ? PeerRole::kB : PeerRole::kA;
    LinkMessage message{};
    if (Decode(frame, LinkSender{role, own_.Config().node_id}, message) == DecodeResult::kIntact)
    {
        remote_.OnMessage(message, received);
    }
    else
    {
        remote_.Link().CountCorrupt();
    }
}

LinkFinding Peer::Examine(const Instant now) noexcept
{
    remote_.Link().Examine(now);
    return remote_.Link().Finding();
}

SrdoMask Peer::TellFaults(const SrdoMask faults) noexcept
{
    if ((remote_.Link().Acknowledged() - carried_since_) < 0x80000000U)
    {
        carried_ = 0U;
    }
    if (faults != 0U)
    {
        carried_since_ = sequence_;
        carried_ |= faults;
    }
    return carried_;
}

void Peer::FillReports(const SrdoMask changed, const Instant now, LinkMessage& message) noexcept
{
    const SrdoMask consumers = own_.Consumers();
    SrdoMask turn = consumers;
    news_ = (news_ | changed) & consumers;
    for (SlotReport& report : message.reports)
    {
        report.slot = kNoSlot;
        if (turn != 0U)
        {
            reported_ = NextBehind((news_ != 0U) ? news_ : turn, reported_);
            report = ReportOf(own_, reported_, now);
            news_ &= ~OnlySlot(reported_).mask;
            turn &= ~OnlySlot(reported_).mask;
        }
    }
}

void Peer::Compose(const PeerMoment& moment, hal::LinkFrame& frame) noexcept
{
    ++sequence_;
    remote_.Link().OnCompose(sequence_);
    own_.Sending().Armed().Examine(moment.now);
    const News news = own_.TakeNews();
    LinkMessage message{};
    message.sender = LinkSender{config_.role, own_.Config().node_id};
    message.fault = moment.fault;
    message.sequence = sequence_;
    message.stamp = moment.now;
    message.echo = remote_.Link().Echo(moment.now);
    message.flow = flow_.TakeSignature();
    own_.Tell(message);
    message.refusal = remote_.Offered().Refused();
    message.new_faults = TellFaults(news.faults);
    FillReports(news.changed, moment.now, message);
    for (std::uint8_t place = 0U; place < kArmedCount; ++place)
    {
        message.armed[place] = own_.Sending().Armed().At(place); // MISRA D-002
    }
    Encode(message, frame);
}

bool Peer::IsEcho(const CanFrame& frame) const noexcept
{
    const SlotIndex slot = own_.Moments().SlotOfFrame(frame);
    return own_.Load(ConfigAddress{slot, ConfigField::kDirection, 0U}).value == kDirectionProducer;
}

const LinkSupervisor& Peer::Link() const noexcept
{
    return remote_.Link();
}

} // namespace counterpoint
