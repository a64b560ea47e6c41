// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"

#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

// Start and details. Steps of the state: state.cpp; frames: consumer.cpp, producer.cpp; cycle: cycle.cpp.
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

constexpr std::uint32_t kHeldShift = 1U;
constexpr std::uint32_t kStateCount = 16U;

// By the bits of the mode's state; what is none or more than one of them is not released.
constexpr SrdoState kStates[kStateCount] = {
    // MISRA D-001
    SrdoState::kOff,      SrdoState::kWaiting, SrdoState::kFaulted, SrdoState::kFaulted,
    SrdoState::kReleased, SrdoState::kFaulted, SrdoState::kFaulted, SrdoState::kFaulted,
    SrdoState::kProducer, SrdoState::kFaulted, SrdoState::kFaulted, SrdoState::kFaulted,
    SrdoState::kFaulted,  SrdoState::kFaulted, SrdoState::kFaulted, SrdoState::kFaulted,
};

// Default connection set: SRDO 1 of the first 64 nodes. [SRS_CFG_002]
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
    voice_.outcome.not_operational = 1U;
    voice_.levels = ~SrdoMask{0U}; // A level of 1 at power-on is no edge.
    const std::size_t entries = (std::size_t{voice_.count} * storage.row) + kMoreEntries;
    for (std::size_t entry = 0U; entry < entries; ++entry)
    {
        storage.entries[entry] = 0U;       // MISRA D-002
        storage.places[entry] = kNoObject; // MISRA D-002
    }
    for (std::size_t slot = 0U; slot < voice_.count; ++slot)
    {
        const SrdoSetup& setup = config.srdos[slot]; // MISRA D-002
        Record& record = At(voice_, slot);
        record = Record{};
        // The only seal that is built: of a record of zeros with its first mode and cause.
        PutWord(&record.seal[0], kAllBits);
        SetMode(record, kOff);
        SetFirstCause(record, SrdoCause::kNone);
        record.limit_us = kNoLimit;
        record.policy = setup.policy;
        record.form = setup.form;
        record.detection = setup.detection;
        record.safe = setup.safe_value;
        SetDefaults(record, setup.number, config.node_id);
    }
}

SrdoView Channel::View(const SlotIndex slot) const noexcept
{
    const Record& record = At(voice_, slot);
    SrdoView view{};
    if (Is(record, kHeld | kFlying))
    {
        view.data = record.held;
    }
    view.ordinal = record.ordinal;
    view.signals = record.signals;
    view.error_count = record.error_count;
    view.state = IsSealed(record) ? kStates[record.mode >> kStateShift] : SrdoState::kFaulted; // [SRS_CONS_024]
    view.first_cause = record.first_cause;
    view.holds_pair = static_cast<std::uint8_t>((record.mode & kHeld) >> kHeldShift);
    return view;
}

} // namespace counterpoint::channel_a
