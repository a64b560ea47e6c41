// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"

#include "channel_a/consumer.hpp"
#include "channel_a/cycle.hpp"
#include "channel_a/producer.hpp"
#include "channel_a/rules.hpp"
#include "channel_a/slot.hpp"
#include "channel_a/values.hpp"

#include <cstddef>

namespace counterpoint::channel_a
{
namespace
{

static_assert((State{} == State::kOff) && (kDirectionOff == 0U) && (kNo == 0U), "0 grants nothing");

// Power-on state of one slot. Its steps are nothing until they are worked out.
void Clear(const Voice& voice, const std::size_t slot) noexcept
{
    const SrdoSetup& setup = voice.config->srdos[slot]; // MISRA D-002
    Record& record = At(voice, slot);
    record = Record{};
    record.grants.Clear();
    record.grants.Set(Grant::kPolicy, static_cast<std::uint8_t>(setup.policy));
    record.limit_us = kNoLimit;
    record.form = setup.form;
    record.detection = setup.detection;
    record.safe = BytesOf(setup.safe_value);
    SetFirstCause(record, SrdoCause::kNone);
    SetDefaults(record, setup.number, voice.config->node_id);
    voice.storage.counts[slot] = 0U; // MISRA D-002
}

// Those of all slots.
void ClearEntries(const Voice& voice) noexcept
{
    const std::size_t entries = std::size_t{voice.count} * voice.storage.map_entries;
    for (std::size_t entry = 0U; entry < entries; ++entry)
    {
        voice.storage.entries[entry] = 0U; // MISRA D-002
    }
}

} // namespace

void Channel::Restart(const DeviceConfig& config) noexcept
{
    const Storage storage = voice_.storage;
    voice_ = Voice{};
    voice_.storage = storage;
    voice_.config = &config;
    voice_.count = config.srdo_count; // 1 to 64 and not above Room: the kernel refuses another device. [SRS_KRN_020]
    voice_.ports[kNormalHalf] = config.normal_port;
    voice_.ports[kInverseHalf] = config.inverse_port;
    voice_.late_after_us = config.cycle_us + config.cycle_tolerance_us;
    voice_.first_delay_us = kFirstTransmissionStepUs * config.node_id;
    voice_.outcome.not_operational = 1U;
    voice_.reading = ~SrdoMask{0U}; // An acknowledge that reads 1 from power-on on is no edge. [SRS_REL_005]
    ClearEntries(voice_);
    for (std::size_t slot = 0U; slot < voice_.count; ++slot)
    {
        Clear(voice_, slot);
    }
}

void Channel::Store(const ConfigItem& item) noexcept
{
    StoreValue(voice_, item);
}

ConfigItem Channel::Load(const ConfigAddress& address) const noexcept
{
    return ConfigItem{address, LoadValue(voice_, address)};
}

ChannelRoom Channel::Room() const noexcept
{
    return ChannelRoom{voice_.storage.capacity, voice_.storage.map_entries};
}

void Channel::SetFields(const SlotIndex slot, const StaticFields& fields) noexcept
{
    StoreFields(voice_, slot, fields);
}

DeviceDigest Channel::Digest(const SlotIndex slot, const DeviceDigest before) const noexcept
{
    return DigestOf(voice_, slot, before);
}

CheckResult Channel::Validate(const SlotIndex slot) noexcept
{
    return ValidateSlot(voice_, slot);
}

CheckResult Channel::Recheck(const SlotIndex slot) noexcept
{
    return RecheckSlot(voice_, slot);
}

void Channel::OnFrame(const CanFrame& frame, const Instant stamp) noexcept
{
    TakeFrame(voice_, frame, stamp);
}

CycleOutcome Channel::OnCycle(const CycleInput& input) noexcept
{
    return RunCycle(voice_, input);
}

// [SRS_CONS_025]
HeldPair Channel::Held(const SlotIndex slot) const noexcept
{
    const Record& record = At(voice_, slot);
    HeldPair pair{};
    if (FactsOf(record).holds_pair)
    {
        pair.data = PayloadOf(record.held);
        pair.ordinal = record.ordinal;
        pair.holds_pair = 1U;
    }
    return pair;
}

// [SRS_CONS_025]
SrdoView Channel::View(const SlotIndex slot) const noexcept
{
    const Record& record = At(voice_, slot);
    const Facts& facts = IsSound(record) ? FactsOf(record) : FactsOf(State::kBroken);
    SrdoView view{};
    if (facts.holds_pair || facts.is_flying)
    {
        view.data = PayloadOf(record.held);
    }
    view.ordinal = (facts.role == Role::kProducer) ? record.sent : record.ordinal;
    view.signals = record.signals;
    view.error_count = record.error_count;
    view.state = facts.shown;
    view.first_cause = FirstCauseOf(record);
    view.holds_pair = facts.holds_pair ? std::uint8_t{1U} : std::uint8_t{0U};
    return view;
}

void Channel::Demote(const SlotIndex slot) noexcept
{
    DemoteConsumer(voice_, slot);
}

SrdoMask Channel::Commit(const Agreement& agreement, const SrdoMask examine) noexcept
{
    return CommitPairs(voice_, agreement, examine);
}

Permit Channel::Answer(const std::uint32_t challenge) const noexcept
{
    return PermitFor(voice_, challenge);
}

PreparedPair Channel::Prepare(const SlotIndex slot) noexcept
{
    return PreparePair(voice_, slot);
}

Confirmation Channel::OnConfirm(const CanFrame& frame, const Instant stamp) noexcept
{
    return ConfirmFrame(voice_, frame, stamp);
}

CanFrame Channel::InverseFrame(const SlotIndex slot) const noexcept
{
    return InverseOf(voice_, slot);
}

// [SRS_PROD_009]
void Channel::OnTransmitFault(const SlotIndex slot, const TransmitFault& fault) noexcept
{
    const bool is_of_port = (fault.cause == SrdoCause::kTransmitQueue) || (fault.cause == SrdoCause::kBusOff);
    const bool is_of_channels = (fault.cause == SrdoCause::kNotInverse) || (fault.cause == SrdoCause::kNoConfirmation);
    if (is_of_port || is_of_channels)
    {
        GiveUp(voice_, slot, fault.cause);
    }
}

} // namespace counterpoint::channel_a
