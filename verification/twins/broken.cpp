// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/twins/broken.hpp"

#include "verification/twins/plain/channel.hpp"

#include <algorithm>

namespace counterpoint::twins
{

namespace
{
/// The value as the rule leaves it; as it is without one.
template <typename T> T Changed(const std::function<void(T&)>& rule, T value)
{
    if (rule)
    {
        rule(value);
    }
    return value;
}

/// Whether the call goes on, with what the rule leaves of it.
template <typename... T> bool Goes(const std::function<bool(T&...)>& rule, T&... values)
{
    return (!rule) || rule(values...);
}

/// Rules are driven at the side of the normal objects.
Channel& Keeping(Channel& subject, const Rule& rule)
{
    static plain::PlainChannel plain_channel{Side::kNormal};
    if (rule.point != nullptr)
    {
        rule.point->Break(rule.slip);
    }
    return rule.is_plain ? plain_channel : subject;
}
} // namespace

Broken::Broken(Channel& subject, const Rule& rule) noexcept : Voice{Keeping(subject, rule)}, rule_{rule}
{
}

void Broken::Restart(const DeviceConfig& config) noexcept
{
    config_ = config;
    std::copy_n(config.srdos, config.srdo_count, setups_);
    config_.srdos = setups_;
    if (rule_.config)
    {
        rule_.config(config_, setups_);
    }
    Subject().Restart(config_);
}

void Broken::Store(const ConfigItem& item) noexcept
{
    ConfigItem changed = item;
    if (Goes(rule_.store, changed))
    {
        Subject().Store(changed);
    }
}

ConfigItem Broken::Load(const ConfigAddress& address) const noexcept
{
    return Changed(rule_.load, Subject().Load(address));
}

void Broken::SetFields(SlotIndex slot, const StaticFields& fields) noexcept
{
    StaticFields changed = fields;
    if (Goes(rule_.fields, changed))
    {
        Subject().SetFields(slot, changed);
    }
}

DeviceDigest Broken::Digest(SlotIndex slot, DeviceDigest before) const noexcept
{
    if (rule_.whole_digest)
    {
        const ConfigAddress gfc{0U, ConfigField::kGfcParameter, 0U};
        const ConfigAddress type{slot, ConfigField::kTransmissionType, 0U};
        return rule_.whole_digest(DigestSource{&config_, Subject().Load(gfc).value, Subject().Load(type).value, slot},
                                  before);
    }
    return Changed(rule_.digest, Subject().Digest(slot, Changed(rule_.before, before)));
}

CheckResult Broken::Validate(SlotIndex slot) noexcept
{
    return Changed(rule_.validated, Subject().Validate(slot));
}

CheckResult Broken::Recheck(SlotIndex slot) noexcept
{
    return Changed(rule_.rechecked, Subject().Recheck(slot));
}

void Broken::OnFrame(const CanFrame& frame, Instant stamp) noexcept
{
    CanFrame changed = frame;
    if (Goes(rule_.frame, changed, stamp))
    {
        Subject().OnFrame(changed, stamp);
    }
}

CycleOutcome Broken::OnCycle(const CycleInput& input) noexcept
{
    return Changed(rule_.outcome, Subject().OnCycle(Changed(rule_.input, input)));
}

HeldPair Broken::Held(SlotIndex slot) const noexcept
{
    return Changed(rule_.held, Subject().Held(slot));
}

SrdoView Broken::View(SlotIndex slot) const noexcept
{
    return Changed(rule_.view, Subject().View(slot));
}

void Broken::Demote(SlotIndex slot) noexcept
{
    if ((!rule_.demote) || rule_.demote(slot))
    {
        Subject().Demote(slot);
    }
}

SrdoMask Broken::Commit(const Agreement& agreement, SrdoMask examine) noexcept
{
    Agreement changed = agreement;
    const SrdoMask found = Goes(rule_.commit, changed) ? Subject().Commit(changed, examine) : SrdoMask{0U};
    return Changed(rule_.found, found);
}

Permit Broken::Answer(std::uint32_t challenge) const noexcept
{
    return Changed(rule_.permit, Subject().Answer(challenge));
}

PreparedPair Broken::Prepare(SlotIndex slot) noexcept
{
    return Changed(rule_.prepared, Subject().Prepare(slot));
}

Confirmation Broken::OnConfirm(const CanFrame& frame, Instant stamp) noexcept
{
    CanFrame changed = frame;
    return Changed(rule_.confirmation, Goes(rule_.confirmed, changed, stamp)
                                           ? Subject().OnConfirm(changed, stamp)
                                           : Confirmation{kNoSlot, ConfirmStep::kNone});
}

CanFrame Broken::InverseFrame(SlotIndex slot) const noexcept
{
    return Changed(rule_.inverse, Subject().InverseFrame(slot));
}

void Broken::OnTransmitFault(SlotIndex slot, const TransmitFault& fault) noexcept
{
    TransmitFault changed = fault;
    if (Goes(rule_.fault, changed))
    {
        Subject().OnTransmitFault(slot, changed);
    }
}

} // namespace counterpoint::twins
