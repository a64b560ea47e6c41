// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/crosslink/own_voice.hpp"

#include "safety_core/comparator/slot_mask.hpp"

namespace counterpoint
{
namespace
{

constexpr DeviceConfig kNoDevice{};

} // namespace

OwnVoice::OwnVoice(Channel& channel, const PeerRole role) noexcept
    : channel_{channel}, config_{&kNoDevice}, sending_{channel, role}
{
}

void OwnVoice::Restart(const DeviceConfig& config) noexcept
{
    config_ = &config;
    channel_.Restart(config);
    sending_.Restart();
    outcome_ = CycleOutcome{};
    outcome_.guard = GuardView::kUnconfigured;
    outcome_.not_operational = 1U;
    news_ = News{0U, 0U};
    now_ = Instant{0U};
    check_ = SlotCheck{kNoSlot, {ConfigFault::kInvalid, 0U}};
    digest_ = DeviceDigest{0U};
    running_ = DeviceDigest{0U};
    swept_ = 0U;
    moments_.Restart();
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
    moments_.Register(slot, channel_.Load(ConfigAddress{slot, ConfigField::kCobId1, 0U}).value);
    return check_.result;
}

CheckResult OwnVoice::Recheck(const SlotIndex slot) noexcept
{
    check_ = SlotCheck{slot, channel_.Recheck(slot)};
    return check_.result;
}

void OwnVoice::OnFrame(const CanFrame& frame, const Instant stamp) noexcept
{
    channel_.OnFrame(frame, stamp);
    moments_.OnFrame(frame, stamp);
}

void OwnVoice::Sweep(const Instant now) noexcept
{
    running_ = channel_.Digest(swept_, running_);
    moments_.LimitAge(swept_, now);
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
    const SrdoMask discarded = (is_operational && (!was_operational)) ? Consumers() : outcome.new_fault;
    moments_.Discard(discarded, now);
    moments_.Complete(outcome.fresh);
    news_.changed |= discarded | outcome.fresh;
    news_.faults |= outcome.new_fault;
    Sweep(now);
}

CycleOutcome OwnVoice::OnCycle(const CycleInput& input) noexcept
{
    const Statement before = Said();
    CycleInput given = input;
    given.request |= sending_.Wanted();
    given.stand = sending_.Standing();
    NoteOutcome(channel_.OnCycle(given), input.now);

    CycleOutcome shown = outcome_;
    shown.faulted = 0U;
    shown.ordinal_sum = 0U;
    shown.refresh = 0U; // The follower's schedule stands until the leader's slot is due.
    shown.due = sending_.Show(outcome_.due, input.now);
    if (sending_.IsFollower())
    {
        // The kernel asked the leader's voice before this one. It said what the own channel had said by then.
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
    moments_.Discard(OnlySlot(slot).mask, now_);
    news_.changed |= OnlySlot(slot).mask;
}

SrdoMask OwnVoice::Commit(const Agreement& agreement, const SrdoMask examine) noexcept
{
    return channel_.Commit(agreement, examine);
}

Permit OwnVoice::Answer(const std::uint32_t challenge) const noexcept
{
    return channel_.Answer(challenge);
}

PreparedPair OwnVoice::Prepare(const SlotIndex slot) noexcept
{
    return sending_.Prepare(slot);
}

Confirmation OwnVoice::OnConfirm(const CanFrame& frame, const Instant stamp) noexcept
{
    const Confirmation confirmation = channel_.OnConfirm(frame, stamp);
    if (confirmation.step == ConfirmStep::kNormal)
    {
        sending_.Armed().Answer(confirmation.slot, stamp);
    }
    return confirmation;
}

// The leader has sent the normal frame; the inverse one is the follower's.
CanFrame OwnVoice::InverseFrame(const SlotIndex slot) const noexcept
{
    return sending_.IsFollower() ? channel_.InverseFrame(slot) : CanFrame{};
}

void OwnVoice::OnTransmitFault(const SlotIndex slot, const TransmitFault& fault) noexcept
{
    channel_.OnTransmitFault(slot, fault);
}

void OwnVoice::Tell(LinkMessage& message) const noexcept
{
    message.digest = digest_;
    message.statement = Said();
    message.check = check_;
    message.released = outcome_.released;
    message.due = sending_.Due();
}

News OwnVoice::TakeNews() noexcept
{
    const News news = news_;
    news_ = News{0U, 0U};
    return news;
}

} // namespace counterpoint
