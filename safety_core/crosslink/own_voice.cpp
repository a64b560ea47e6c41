// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/crosslink/own_voice.hpp"

#include "safety_core/comparator/slot_mask.hpp"

namespace counterpoint
{
namespace
{

constexpr DeviceConfig kNoDevice{};
constexpr std::uint32_t kOldestAgeUs = 0x20000000U;

} // namespace

OwnVoice::OwnVoice(Channel& channel, const PeerRole role) noexcept : channel_{channel}, config_{&kNoDevice}, role_{role}
{
}

void OwnVoice::Restart(const DeviceConfig& config) noexcept
{
    config_ = &config;
    channel_.Restart(config);
    armed_.Restart();
    outcome_ = CycleOutcome{};
    outcome_.guard = GuardView::kUnconfigured;
    outcome_.not_operational = 1U;
    prepared_ = PreparedPair{};
    news_ = 0U;
    faults_ = 0U;
    peer_due_ = 0U;
    contact_ = 0U;
    standing_ = 0U;
    now_ = Instant{0U};
    check_ = SlotCheck{kNoSlot, {ConfigFault::kInvalid, 0U}};
    digest_ = DeviceDigest{0U};
    running_ = DeviceDigest{0U};
    swept_ = 0U;
    for (SlotIndex& slot : slot_of_)
    {
        slot = kNoSlot;
    }
}

void OwnVoice::Store(const ConfigItem& item) noexcept
{
    channel_.Store(item);
}

ConfigItem OwnVoice::Load(const ConfigAddress& address) const noexcept
{
    return channel_.Load(address);
}

ChannelRoom OwnVoice::Room() const noexcept
{
    return channel_.Room();
}

void OwnVoice::SetFields(const SlotIndex slot, const StaticFields& fields) noexcept
{
    channel_.SetFields(slot, fields);
}

DeviceDigest OwnVoice::Digest(const SlotIndex slot, const DeviceDigest before) const noexcept
{
    return channel_.Digest(slot, before);
}

CheckResult OwnVoice::Validate(const SlotIndex slot) noexcept
{
    check_ = SlotCheck{slot, channel_.Validate(slot)};
    Register(slot);
    return check_.result;
}

CheckResult OwnVoice::Recheck(const SlotIndex slot) noexcept
{
    check_ = SlotCheck{slot, channel_.Recheck(slot)};
    return check_.result;
}

// Identifiers 101h and 102h belong to place 0, and so on.
void OwnVoice::Register(const SlotIndex slot) noexcept
{
    for (SlotIndex& place : slot_of_)
    {
        place = (place == slot) ? kNoSlot : place;
    }
    const std::uint32_t identifier = channel_.Load(ConfigAddress{slot, ConfigField::kCobId1, 0U}).value;
    const std::uint32_t place = (identifier - kFirstSrdoIdentifier) >> 1U;
    if (place < kMaxSrdoCount)
    {
        slot_of_[place] = slot; // MISRA D-002
    }
}

SlotIndex OwnVoice::SlotOfFrame(const CanFrame& frame) const noexcept
{
    const std::uint32_t place = (frame.identifier - kFirstSrdoIdentifier) >> 1U;
    if ((place >= kMaxSrdoCount) || (frame.kind != FrameKind::kData))
    {
        return kNoSlot;
    }
    return slot_of_[place]; // MISRA D-002
}

void OwnVoice::OnFrame(const CanFrame& frame, const Instant stamp) noexcept
{
    channel_.OnFrame(frame, stamp);
    const SlotIndex slot = SlotOfFrame(frame);
    const bool is_inverse = (frame.identifier & 1U) == 0U;
    if (is_inverse && (slot != kNoSlot))
    {
        Moments& moments = moments_[slot]; // MISRA D-002
        moments.former = moments.newest;
        moments.newest = stamp;
    }
}

void OwnVoice::Discard(const SrdoMask slots, const Instant at) noexcept
{
    news_ |= slots;
    SlotSet to_note{slots};
    while (to_note.mask != 0U)
    {
        moments_[TakeLowest(to_note)].discarded = at; // MISRA D-002
    }
}

// One slot a cycle: its part of the digest, and what was long ago stays long ago and does not come round again.
// [SRS_TWO_015]
void OwnVoice::Sweep(const Instant now) noexcept
{
    running_ = channel_.Digest(swept_, running_);
    Moments& moments = moments_[swept_]; // MISRA D-002
    if ((now.us - moments.discarded.us) > kOldestAgeUs)
    {
        moments.discarded.us = now.us - kOldestAgeUs;
    }
    ++swept_;
    if (swept_ >= config_->srdo_count)
    {
        swept_ = 0U;
        digest_ = running_;
        running_ = DeviceDigest{0U};
    }
}

void OwnVoice::NoteOutcome(const CycleOutcome& outcome, const Instant now) noexcept
{
    const bool was_operational = outcome_.not_operational == 0U;
    const bool is_operational = outcome.not_operational == 0U;
    outcome_ = outcome;
    now_ = now;
    faults_ |= outcome.new_fault;
    Discard((is_operational && (!was_operational)) ? Consumers() : outcome.new_fault, now);
    news_ |= outcome.fresh;
    SlotSet fresh{outcome.fresh};
    while (fresh.mask != 0U)
    {
        Moments& moments = moments_[TakeLowest(fresh)]; // MISRA D-002
        moments.pair = moments.newest;
        moments.before = moments.former;
    }
    Sweep(now);
}

CycleOutcome OwnVoice::OnCycle(const CycleInput& input) noexcept
{
    const Statement before = Said();
    CycleInput given = input;
    given.request |= Wanted();
    given.stand = standing_ | armed_.Slots(); // Both are empty in the leader.
    NoteOutcome(channel_.OnCycle(given), input.now);

    CycleOutcome shown = outcome_;
    shown.faulted = 0U;
    shown.ordinal_sum = 0U;
    shown.due &= contact_;
    if (IsFollower())
    {
        // The leader's place was asked before this one, and said what was known then.
        standing_ = outcome_.due & ~peer_due_;
        shown.due = armed_.Fitting(outcome_.due & Wanted());
        shown.guard = (outcome_.guard == GuardView::kStale) ? GuardView::kStale : before.guard;
        shown.sct_checked = before.sct_checked;
        shown.is_tx = before.is_tx;
        shown.is_invalid = before.is_invalid;
        shown.not_operational = before.not_operational;
    }
    return shown;
}

Statement OwnVoice::Said() const noexcept
{
    return Statement{outcome_.guard, outcome_.sct_checked, outcome_.is_tx, outcome_.is_invalid,
                     outcome_.not_operational};
}

HeldPair OwnVoice::Held(const SlotIndex slot) const noexcept
{
    return channel_.Held(slot);
}

SrdoView OwnVoice::View(const SlotIndex slot) const noexcept
{
    return channel_.View(slot);
}

void OwnVoice::Demote(const SlotIndex slot) noexcept
{
    channel_.Demote(slot);
    Discard(OnlySlot(slot).mask, now_);
}

void OwnVoice::Commit(const Agreement& agreement) noexcept
{
    channel_.Commit(agreement);
}

Permit OwnVoice::Answer(const std::uint32_t challenge) const noexcept
{
    return channel_.Answer(challenge);
}

void OwnVoice::TakeDue(const SrdoMask due, const Window& composed) noexcept
{
    peer_due_ = IsFollower() ? due : SrdoMask{0U};
    contact_ = ~SrdoMask{0U};
    armed_.Clear(composed);
}

void OwnVoice::TakeRefusal(const Refusal& refusal, const Instant at) noexcept
{
    const SlotIndex slot = armed_.Refuse(refusal, at);
    if (slot != kNoSlot)
    {
        channel_.OnTransmitFault(slot, TransmitFault{refusal.cause});
    }
}

PreparedPair OwnVoice::PrepareAhead(const SlotIndex slot) noexcept
{
    prepared_ = channel_.Prepare(slot);
    if (prepared_.status == PrepareStatus::kReady)
    {
        const std::uint32_t srvt_ms = channel_.Load(ConfigAddress{slot, ConfigField::kSrvt, 0U}).value;
        armed_.Arm(Arming{slot, prepared_.normal, now_, srvt_ms * kMicrosecondsPerMillisecond});
    }
    return PreparedPair{CanFrame{}, prepared_.status};
}

PreparedPair OwnVoice::Prepare(const SlotIndex slot) noexcept
{
    if (IsFollower())
    {
        return PreparedPair{CanFrame{}, prepared_.status};
    }
    prepared_ = channel_.Prepare(slot);
    outcome_.due &= ~OnlySlot(slot).mask;
    return prepared_;
}

Confirmation OwnVoice::OnConfirm(const CanFrame& frame, const Instant stamp) noexcept
{
    const Confirmation confirmation = channel_.OnConfirm(frame, stamp);
    if (confirmation.step == ConfirmStep::kNormal)
    {
        armed_.Answer(confirmation.slot, stamp);
    }
    return confirmation;
}

CanFrame OwnVoice::InverseFrame(const SlotIndex slot) noexcept
{
    return channel_.InverseFrame(slot);
}

void OwnVoice::OnTransmitFault(const SlotIndex slot, const TransmitFault& fault) noexcept
{
    channel_.OnTransmitFault(slot, fault);
}

SrdoMask OwnVoice::TakeNews() noexcept
{
    const SrdoMask news = news_ & Consumers();
    news_ = 0U;
    return news;
}

SrdoMask OwnVoice::TakeFaults() noexcept
{
    const SrdoMask faults = faults_;
    faults_ = 0U;
    return faults;
}

SlotReport OwnVoice::Report(const SlotIndex slot, const Instant now) const noexcept
{
    const HeldPair held = channel_.Held(slot);
    const SrdoView view = channel_.View(slot);
    const Moments& moments = moments_[slot]; // MISRA D-002
    const bool holds = held.holds_pair != 0U;
    const Instant moment = holds ? moments.pair : moments.discarded;
    return SlotReport{slot,         holds ? Holding::kPair : Holding::kNothing,
                      view.state,   view.first_cause,
                      held.ordinal, now.us - moment.us,
                      held.data};
}

bool OwnVoice::IsPair(const SlotIndex slot, const Window& window) const noexcept
{
    const Moments& moments = moments_[slot]; // MISRA D-002
    return Holds(window, moments.pair) && (!Holds(window, moments.before));
}

Instant OwnVoice::PairAt(const SlotIndex slot) const noexcept
{
    return moments_[slot].pair; // MISRA D-002
}

Instant OwnVoice::DiscardedAt(const SlotIndex slot) const noexcept
{
    return moments_[slot].discarded; // MISRA D-002
}

} // namespace counterpoint
