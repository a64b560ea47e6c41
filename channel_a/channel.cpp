// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"

#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/slots.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

// Start, steps of the table and what follows them, details. Frames: consumer.cpp, producer.cpp; cycle: cycle.cpp.
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
constexpr std::uint32_t kHalfMask = 1U; // Of an identifier that is not odd, as those of normal frames are.
constexpr std::uint8_t kGfcEnabled = 1U;
constexpr std::uint32_t kCauseBits = 0x1FU; // Causes are smaller, but for the one that is none.

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

// The new mode, with its group.
void Follow(Voice& voice, Record& record, const SrdoMask bit, const Mode next) noexcept
{
    const std::uint8_t group = FactsOf(next).group;
    if (group != FactsOf(record.mode).group)
    {
        MoveTo(voice, bit, group);
    }
    SetMode(record, next);
}

[[gnu::noinline]] void ReportWith(Voice& voice, Record& record, const SrdoMask bit, const SrdoCause cause) noexcept
{
    Count(record, cause);
    record.unreported |= std::uint32_t{1U} << (static_cast<std::uint32_t>(cause) & kCauseBits);
    voice.attention |= bit;
}

// Only directions 1 and 2 come as far as a resolved mapping. `since` of a producer that is called is one refresh and a
// microsecond before the first possible transmission, so that the first refresh falls due there; it is the first
// possible transmission itself where the application sends.
void EnterSlot(Voice& voice, const std::uint32_t slot) noexcept
{
    Record& record = At(voice, slot);
    const std::uint32_t place = record.values[kCobIdPlace] - kFirstSrdoIdentifier;
    voice.storage.look_up[(place >> 1U) % kLookUpSize] = static_cast<std::uint8_t>(slot); // MISRA D-002
    record.ordinal = 0U;
    Mark(voice, slot);
    --voice.off_count;
    if (record.direction == kDirectionConsumer)
    {
        Follow(voice, record, BitOf(slot), Mode::kWaitingEmpty);
        record.awaiting = kMarked;
        ++voice.consumer_count;
        return;
    }
    Follow(voice, record, BitOf(slot), Mode::kIdle);
    ++voice.producer_count;
    record.since.us = voice.entered.us + voice.first_delay_us;
    if (record.form == ProducerForm::kProviderCalled)
    {
        record.since.us -= SctUs(record) + 1U;
    }
}

} // namespace

const std::uint64_t kMapped[kLengthMask + 1U] = {
    // MISRA D-001
    0xFFFFFFFFFFFFFFFFU, 0x00000000000000FFU, 0x000000000000FFFFU, 0x0000000000FFFFFFU,
    0x00000000FFFFFFFFU, 0x000000FFFFFFFFFFU, 0x0000FFFFFFFFFFFFU, 0x00FFFFFFFFFFFFFFU,
};

void Channel::Restart(const DeviceConfig& config) noexcept
{
    const Storage storage = voice_.storage;
    voice_ = Voice{};
    voice_.storage = storage;
    voice_.config = &config;
    // 1 to 64, by the contract of DeviceConfig.
    voice_.count = (config.srdo_count < storage.capacity) ? config.srdo_count : storage.capacity;
    voice_.ports[0] = config.normal_port;
    voice_.ports[1] = config.inverse_port;
    voice_.late_after_us = config.cycle_us + config.cycle_tolerance_us;
    voice_.first_delay_us = kFirstTransmissionStepUs * config.node_id;
    voice_.groups[kGroupOff] = ~SrdoMask{0U};
    voice_.levels = ~SrdoMask{0U}; // A level of 1 at power-on is no edge.
    ClearLookUp(voice_);
    const std::size_t entries = (std::size_t{voice_.count} * storage.map_entries) + kMoreEntries;
    for (std::size_t entry = 0U; entry < entries; ++entry)
    {
        storage.entries[entry] = 0U;       // MISRA D-002
        storage.places[entry] = kNoObject; // MISRA D-002
    }
    for (std::uint32_t slot = 0U; slot < voice_.count; ++slot)
    {
        const SrdoSetup& setup = config.srdos[slot]; // MISRA D-002
        Record& record = At(voice_, slot);
        record = Record{};
        record.mode = Mode::kOff;
        record.first_cause = SrdoCause::kNone;
        record.seal = ~SealedBytes(record);
        record.limit_us = kNoLimit;
        record.policy = setup.policy;
        record.form = setup.form;
        record.detection = setup.detection;
        PutWord(&record.safe.at[0], setup.safe_value.low);
        PutWord(&record.safe.at[kBytesPerWord], setup.safe_value.high);
        SetDefaults(record, setup.number, config.node_id);
    }
}

void ClearLookUp(const Voice& voice) noexcept
{
    for (std::size_t place = 0U; place < kLookUpSize; ++place)
    {
        voice.storage.look_up[place] = kNoSlot; // MISRA D-002
    }
}

void MoveTo(Voice& voice, const SrdoMask bits, const std::uint8_t group) noexcept
{
    for (SrdoMask& mask : voice.groups)
    {
        mask &= ~bits;
    }
    voice.groups[group] |= bits;
}

// In every other cell the event changes the mode at most.
void Raise(Voice& voice, const std::uint32_t slot, const Event event, const SrdoCause given) noexcept
{
    Record& record = At(voice, slot);
    const SrdoMask bit = BitOf(slot);
    const Cell& cell = NextCell(record.mode, event);
    Follow(voice, record, bit, cell.next);
    const SrdoCause cause = (cell.cause == SrdoCause::kNone) ? given : cell.cause;
    if ((cell.effect >= Effect::kDropHeld) && (cell.effect != Effect::kAbort))
    {
        voice.ordinal_sum -= record.ordinal;
        record.ordinal = 0U;
        record.edge = kUnmarked;
        record.awaiting = kUnmarked;
        voice.fresh &= ~bit;
    }
    const bool is_limit_of_pair = (cell.effect == Effect::kDropHeld) && (record.detection == SrvtDetection::kLate);
    if (is_limit_of_pair || (cell.effect == Effect::kDropAll) || (cell.effect == Effect::kFault))
    {
        record.limit_us = kNoLimit;
    }
    if (cell.effect >= Effect::kFault)
    {
        voice.flying &= ~bit;
        ReportWith(voice, record, bit, cause);
    }
}

void Count(Record& record, const SrdoCause cause) noexcept
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

void Report(Voice& voice, const std::uint32_t slot, const SrdoCause cause) noexcept
{
    ReportWith(voice, At(voice, slot), BitOf(slot), cause);
}

bool IsTooOld(const Record& record, const Instant when) noexcept
{
    return ((when.us - record.frame_since.us) > SrvtUs(record)) && HasFirstFrame(record.mode);
}

// Early: SRVT follows SCT when a normal frame is there. Late: SRVT counts for an inverse frame only.
void Expire(Voice& voice, const std::uint32_t slot, const Instant when, const Half half) noexcept
{
    const Record& record = At(voice, slot);
    bool is_srvt = HasFirstFrame(record.mode);
    if (record.detection == SrvtDetection::kLate)
    {
        const std::uint32_t over_sct_us = (when.us - record.since.us) - record.limit_us;
        const std::uint32_t over_srvt_us = (when.us - record.frame_since.us) - SrvtUs(record);
        const bool is_first = !IsExpired(record, when) || (over_srvt_us >= over_sct_us);
        is_srvt = (half == Half::kInverse) && IsTooOld(record, when) && is_first;
    }
    Raise(voice, slot, Event::kError, is_srvt ? SrdoCause::kSrvt : SrdoCause::kSct);
}

void Mark(Voice& voice, const std::uint32_t slot) noexcept
{
    voice.attention |= BitOf(slot);
}

void Enter(Voice& voice, const Instant now) noexcept
{
    voice.entered = now;
    voice.may_send = false;
    voice.flying = 0U;
    voice.requested = 0U;
    voice.refreshed = 0U;
    voice.ordinal_sum = 0U;
    voice.off_count = voice.count;
    for (std::uint32_t slot = 0U; slot < voice.count; ++slot)
    {
        const Record& record = At(voice, slot);
        if ((record.mapping == kMarked) && (record.check == kMarked) && IsSealed(record))
        {
            EnterSlot(voice, slot);
        }
    }
}

// What an SRDO that is off has to leave is nothing.
void Leave(Voice& voice) noexcept
{
    for (std::uint32_t slot = 0U; slot < voice.count; ++slot)
    {
        Raise(voice, slot, Event::kLeave, SrdoCause::kNone);
        At(voice, slot).limit_us = kNoLimit;
        At(voice, slot).ordinal = 0U;
    }
    MoveTo(voice, ~SrdoMask{0U}, kGroupOff);
    ClearLookUp(voice);
    voice.flying = 0U;
    voice.consumer_count = 0U;
    voice.producer_count = 0U;
    voice.off_count = 0U;
}

// [SRS-CONS-017]
void ReceiveOther(Voice& voice, const CanFrame& frame) noexcept
{
    const bool is_gfc = (frame.identifier == kGfcIdentifier) && (frame.length_bytes == 0U);
    if (is_gfc && voice.is_active && (voice.globals[kGfcParameterPlace] == kGfcEnabled))
    {
        voice.gfc_pending = true;
    }
}

// In the order of SRS-CONS-011, backwards: the last one counts.
void ReceiveOdd(Voice& voice, const CanFrame& frame, const std::uint32_t slot) noexcept
{
    const Record& record = At(voice, slot);
    const std::uint32_t half = ~frame.identifier & kHalfMask;
    SrdoCause cause = SrdoCause::kNormalTwice;
    if (half != 0U)
    {
        cause = HasFirstFrame(record.mode) ? SrdoCause::kNotInverse : SrdoCause::kInverseFirst;
    }
    if (frame.length_bytes != record.length_bytes)
    {
        cause = SrdoCause::kLength;
    }
    if ((frame.identifier != record.values[kCobIdPlace + half]) || (frame.port != voice.ports[half]))
    {
        cause = SrdoCause::kIdentifier;
    }
    Raise(voice, slot, Event::kError, cause);
}

SrdoView Channel::View(const SlotIndex slot) const noexcept
{
    const Record& record = At(voice_, slot);
    const ModeFacts& facts = FactsOf(record.mode);
    const std::uint32_t shown = facts.data & kShownMask;
    const Payload data = PayloadOf(record.held);
    SrdoView view{};
    view.data = Payload{data.low * shown, data.high * shown};
    view.ordinal = record.ordinal;
    view.signals = record.signals;
    view.error_count = record.error_count;
    view.state = (facts.mode == record.mode) ? facts.state : SrdoState::kFaulted; // [SRS-CONS-024]
    view.first_cause = record.first_cause;
    view.holds_pair = static_cast<std::uint8_t>((std::uint32_t{facts.data} & kHoldsMask) >> kHoldsShift);
    return view;
}

} // namespace counterpoint::channel_a
