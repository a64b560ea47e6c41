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

// In every message until the peer has echoed one that carried the newest of them. [SRS_TWO_006]
SrdoMask Peer::TellFaults() noexcept
{
    if ((remote_.Link().Acknowledged() - carried_since_) < 0x80000000U)
    {
        carried_ = 0U;
    }
    const SrdoMask faults = own_.TakeFaults();
    if (faults != 0U)
    {
        carried_since_ = sequence_;
        carried_ |= faults;
    }
    return carried_;
}

void Peer::FillReports(const Instant now, LinkMessage& message) noexcept
{
    const SrdoMask consumers = own_.Consumers();
    SrdoMask turn = consumers;
    news_ = (news_ | own_.TakeNews()) & consumers;
    for (SlotReport& report : message.reports)
    {
        report.slot = kNoSlot;
        if (turn != 0U)
        {
            reported_ = NextBehind((news_ != 0U) ? news_ : turn, reported_);
            report = own_.Report(reported_, now);
            news_ &= ~OnlySlot(reported_).mask;
            turn &= ~OnlySlot(reported_).mask;
        }
    }
}

void Peer::Compose(const PeerMoment& moment, hal::LinkFrame& frame) noexcept
{
    ++sequence_;
    own_.Armed().Examine(moment.now);
    LinkMessage message{};
    message.sender = LinkSender{config_.role, own_.Config().node_id};
    message.fault = moment.fault;
    message.sequence = sequence_;
    message.stamp = moment.now;
    message.echo = remote_.Link().Echo(moment.now);
    message.flow = flow_.TakeSignature();
    message.digest = own_.LastDigest();
    message.statement = own_.Said();
    message.check = own_.LastCheck();
    message.refusal = remote_.Refused();
    message.released = own_.Outcome().released;
    message.new_faults = TellFaults();
    message.due = own_.Outcome().due;
    FillReports(moment.now, message);
    for (std::uint8_t place = 0U; place < kArmedCount; ++place)
    {
        message.armed[place] = own_.Armed().At(place); // MISRA D-002
    }
    Encode(message, frame);
}

bool Peer::IsEcho(const CanFrame& frame) const noexcept
{
    const SlotIndex slot = own_.SlotOfFrame(frame);
    return own_.Load(ConfigAddress{slot, ConfigField::kDirection, 0U}).value == kDirectionProducer;
}

const LinkSupervisor& Peer::Link() const noexcept
{
    return remote_.Link();
}

} // namespace counterpoint
