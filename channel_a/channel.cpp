// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"

#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/slots.hpp"

#include <cstdint>

// Start, steps of the table and what follows them, outcome, release. Frames and limits: consumer.cpp; cycle: cycle.cpp.
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kDefaultSctMs = 25U;
constexpr std::uint32_t kDefaultSctOfConsumerMs = 50U;
constexpr std::uint32_t kDefaultSrvtMs = 20U;
constexpr std::uint8_t kFirstSrdoNumber = 1U;
constexpr std::uint8_t kLastNodeIdOfProducers = 32U;
constexpr std::uint8_t kLastNodeIdWithDefault = 64U;
constexpr std::uint32_t kDefaultIdentifierBase = 0xFFU;

constexpr std::uint16_t kErrorCountMax = 0xFFFFU;
constexpr std::uint32_t kHalfMaskShift = 32U;
constexpr std::uint32_t kRotation = 16U;

// Default connection set: SRDO 1 of the first 64 nodes. [SRS-CFG-002]
void SetDefaults(Record& record, const std::uint8_t number, const std::uint8_t node_id) noexcept
{
    record.values[kSctPlace] = kDefaultSctMs;
    record.values[kSrvtPlace] = kDefaultSrvtMs;
    record.values[kTransmissionTypePlace] = kTransmissionTypeAsynchronous;
    if ((number == kFirstSrdoNumber) && (node_id <= kLastNodeIdWithDefault))
    {
        const std::uint32_t identifier = kDefaultIdentifierBase + (2U * std::uint32_t{node_id});
        record.values[kCobIdPlace] = identifier;
        record.values[kCobIdPlace + 1U] = identifier + 1U;
        record.values[kSctPlace] = (node_id > kLastNodeIdOfProducers) ? kDefaultSctOfConsumerMs : kDefaultSctMs;
    }
}

} // namespace

Channel::Channel(const Storage& storage) noexcept : storage_(storage)
{
}

void Channel::Restart(const DeviceConfig& config) noexcept
{
    config_ = &config;
    // 1 to 64, by the contract of DeviceConfig.
    count_ = (config.srdo_count < storage_.capacity) ? config.srdo_count : storage_.capacity;
    ports_.of_half[0] = config.normal_port;
    ports_.of_half[1] = config.inverse_port;
    existing_ = 0U;
    for (SlotIndex slot = 0U; slot < count_; ++slot)
    {
        const SrdoSetup& setup = config.srdos[slot]; // MISRA D-002
        Record& record = At(slot);
        existing_ |= BitOf(slot);
        record = Record{};
        record.mode = Mode::kOff;
        record.first_cause = SrdoCause::kNone;
        record.seal = ~SealedBytes(record);
        record.limit_us = kNoLimit;
        record.policy = setup.policy;
        record.form = setup.form;
        record.safe = OctetsOf((std::uint64_t{setup.safe_value.high} << kHalfMaskShift) | setup.safe_value.low);
        SetDefaults(record, setup.number, config.node_id);
    }
    late_after_us_ = config.cycle_us + config.cycle_tolerance_us;
    first_delay_us_ = kFirstTransmissionStepUs * config.node_id;
    MoveTo(~SrdoMask{0U}, kGroupOff);
    attention_ = 0U;
    levels_ = ~SrdoMask{0U}; // A level of 1 at power-on is no edge.
    fresh_ = 0U;
    unwritten_ = 0U;
    committed_ = 0U;
    cycle_ = 0U;
    ordinal_sum_ = 0U;
    gfc_parameter_ = 0U;
    configuration_valid_ = 0U;
    consumer_count_ = 0U;
    producer_count_ = 0U;
    off_count_ = 0U;
    is_active_ = false;
    has_run_ = false;
    may_send_ = false;
    gfc_pending_ = false;
}

SrdoMask Channel::Consumers() const noexcept
{
    return groups_[kGroupWaiting] | groups_[kGroupFaulted] | groups_[kGroupReleased];
}

void Channel::MoveTo(const SrdoMask bit, const std::uint8_t group) noexcept
{
    for (SrdoMask& mask : groups_)
    {
        mask &= ~bit;
    }
    groups_[group] |= bit;
}

const Cell& Channel::Step(Record& record, const SrdoMask bit, const Event event) noexcept
{
    const Cell& cell = NextCell(record.mode, event);
    const std::uint8_t group = FactsOf(cell.next).group;
    if (group != FactsOf(record.mode).group)
    {
        MoveTo(bit, group);
    }
    SetMode(record, cell.next);
    return cell;
}

void Channel::Raise(Record& record, const SrdoMask bit, const Event event, const SrdoCause given) noexcept
{
    Suffer(record, bit, Step(record, bit, event), given);
}

// What a fault does, if the cell is one.
void Channel::Suffer(Record& record, const SrdoMask bit, const Cell& cell, const SrdoCause given) noexcept
{
    const SrdoCause cause = (cell.cause == SrdoCause::kNone) ? given : cell.cause;
    if (cell.effect == Effect::kFault)
    {
        DropPair(record, bit);
        record.limit_us = kNoLimit;
        Report(record, bit, cause);
    }
    else if (cell.effect == Effect::kAbort)
    {
        record.limit_us = kNoLimit;
        Report(record, bit, cause);
    }
    else
    {
        // The event is no fault in this mode.
    }
}

// The first cause is kept. [SRS-CONS-020]
void Channel::Count(Record& record, const SrdoCause cause) noexcept
{
    if (record.first_cause == SrdoCause::kNone)
    {
        SetFirstCause(record, cause);
    }
    if (record.error_count != kErrorCountMax)
    {
        ++record.error_count;
    }
}

// The next OnCycle, or the one that goes on, tells it.
void Channel::Report(Record& record, const SrdoMask bit, const SrdoCause cause) noexcept
{
    Count(record, cause);
    record.unreported |= std::uint32_t{1U} << static_cast<std::uint8_t>(cause);
    attention_ |= bit;
}

SrdoView Channel::View(const SlotIndex slot) const noexcept
{
    const Record& record = At(slot);
    const ModeFacts& facts = FactsOf(record.mode);
    SrdoView view{};
    const Payload held = PayloadOf(record.held);
    view.data = Payload{held.low * facts.shown, held.high * facts.shown};
    view.ordinal = record.ordinal;
    view.signals = record.signals;
    view.error_count = record.error_count;
    view.state = (facts.mode == record.mode) ? facts.state : SrdoState::kFaulted; // [SRS-CONS-024]
    view.first_cause = record.first_cause;
    view.holds_pair = facts.holds_pair;
    return view;
}

void Channel::Commit(const Agreement& agreement) noexcept
{
    const SrdoMask own = agreement.agreed & groups_[kGroupReleased];
    SrdoMask to_write = own & agreement.matched & unwritten_;
    SrdoMask to_drop = committed_ & ~own;
    unwritten_ &= ~to_write;
    committed_ = (committed_ | to_write) & ~to_drop;
    while (to_write != 0U)
    {
        const Record& record = At(TakeLowest(to_write));
        WriteObjects(record, record.held);
    }
    while (to_drop != 0U)
    {
        const Record& record = At(TakeLowest(to_drop));
        WriteObjects(record, record.safe);
    }
}

Permit Channel::Answer(const std::uint32_t challenge) const noexcept
{
    Permit permit{};
    permit.mask = committed_ & Consumers();
    const std::uint32_t low = static_cast<std::uint32_t>(permit.mask);
    const std::uint32_t high = static_cast<std::uint32_t>(permit.mask >> kHalfMaskShift);
    permit.response = ((challenge + low) ^ ((high << kRotation) | (high >> kRotation))) * kPermitConstantA;
    return permit;
}

} // namespace counterpoint::channel_a
