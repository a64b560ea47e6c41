// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"

#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

// Power-on values. [SRS_CFG_002]
constexpr std::uint8_t kDefaultRefreshMs = 25U;
constexpr std::uint8_t kDefaultSctMs = 50U;
constexpr std::uint8_t kDefaultSrvtMs = 20U;
constexpr std::uint8_t kLastDefaultProducer = 32U;
constexpr std::uint8_t kLastDefaultNode = 64U;

[[nodiscard]] std::uint32_t RotateLeft(std::uint32_t value, std::uint32_t count) noexcept
{
    return (value << count) | (value >> (32U - count));
}

/// The value that counts, or that of all others.
template <typename T> [[nodiscard]] constexpr T OnlyIf(T value, T expected, T other) noexcept
{
    return (value == expected) ? expected : other;
}

[[nodiscard]] Payload PayloadOf(std::uint64_t word) noexcept
{
    return Payload{PartOf(word, 0U), PartOf(word, 1U)};
}

[[nodiscard]] SrdoState StateOf(const Row& row) noexcept
{
    switch (row.standing)
    {
    case Standing::kWaiting:
        return SrdoState::kWaiting;
    case Standing::kFaulted:
        return SrdoState::kFaulted;
    case Standing::kReleased:
        return SrdoState::kReleased;
    case Standing::kProducer:
        return SrdoState::kProducer;
    case Standing::kOff:
        break;
    }
    return SrdoState::kOff;
}

} // namespace

void Channel::Restart(const DeviceConfig& config) noexcept
{
    const Column<const SrdoSetup> setups{config.srdos};
    x_config = &config;
    x_objects = Column<const MappableObject>{config.objects};
    x_object_count = config.object_count;
    x_count = (config.srdo_count < x_storage.capacity) ? config.srdo_count : x_storage.capacity;
    x_map_entries = (config.map_entries < x_storage.map_entries) ? config.map_entries : x_storage.map_entries;
    x_port[0U] = config.inverse_port;
    x_port[1U] = config.normal_port;
    x_running = 0U;
    x_alarms = 0U;
    x_late_us = 0xFFFFFFFFU; // The first call is never late.
    x_cycle = 0U;
    x_storage.device[kGfcParameterAt] = 0U;
    x_storage.device[kConfigurationValidAt] = 0U;
    for (std::uint8_t half = 0U; half < kHalves; ++half)
    {
        x_levels[half] = ~HalfMask{0U}; // A level that is 1 from the start is no edge.
        x_committed[half] = 0U;
        x_released[half] = 0U;
        x_unwritten[half] = 0U;
    }
    for (SlotIndex slot = 0U; slot < x_count; ++slot)
    {
        TakeSetup(slot, setups[slot]);
    }
}

void Channel::TakeSetup(SlotIndex slot, const SrdoSetup& setup) noexcept
{
    const std::uint32_t node = x_config->node_id;
    const std::uint32_t first = FirstEntryOf(x_storage, slot);
    Row& row = x_storage.rows[slot];
    row = Row{};
    x_storage.fields[slot] = StaticFields{nullptr, nullptr};
    Ground(row, Stage::kOff);
    row.first_cause = Code(SrdoCause::kNone);
    row.awaited.kind = FrameKind::kData;
    row.policy = OnlyIf(setup.policy, ReleasePolicy::kAutomatic, ReleasePolicy::kInterlock);
    row.form = OnlyIf(setup.form, ProducerForm::kProviderCalled, ProducerForm::kApplicationSends);
    row.detection = OnlyIf(setup.detection, SrvtDetection::kLate, SrvtDetection::kEarly);
    row.image[kSctAt] = kDefaultRefreshMs;
    row.image[kSrvtAt] = kDefaultSrvtMs;
    row.image[kTransmissionTypeAt] = kTransmissionTypeAsynchronous;
    for (std::uint32_t index = 0U; index < x_storage.map_entries; ++index)
    {
        x_storage.entries[first + index] = 0U;
    }
    if ((setup.number == 1U) && (node <= kLastDefaultNode))
    {
        const std::uint32_t normal = (kFirstSrdoIdentifier - 2U) + (2U * node); // 0FFh + 2n
        UnpackFourBytes(normal, &row.image[kCobId1At]);
        UnpackFourBytes(normal + 1U, &row.image[kCobId2At]);
        row.image[kSctAt] = (node > kLastDefaultProducer) ? kDefaultSctMs : kDefaultRefreshMs;
    }
}

ChannelRoom Channel::Room() const noexcept
{
    return ChannelRoom{x_storage.capacity, x_storage.map_entries};
}

/// Of a valid pair the inverse data tell the normal data.
HeldPair Channel::Held(SlotIndex slot) const noexcept
{
    const Row& row = x_storage.rows[slot];
    HeldPair pair{{0U, 0U}, 0U, 0U};
    if (IsConsumer(row))
    {
        pair.ordinal = row.ordinal;
        if (IsHeld(row))
        {
            pair.data = PayloadOf(~row.inverse_data & row.mask);
            pair.holds_pair = 1U;
        }
    }
    return pair;
}

SrdoView Channel::View(SlotIndex slot) const noexcept
{
    const Row& row = x_storage.rows[slot];
    const HeldPair held = Held(slot);
    SrdoView view{held.data,
                  row.ordinal,
                  row.signals,
                  row.error_count,
                  StateOf(row),
                  static_cast<SrdoCause>(row.first_cause),
                  static_cast<std::uint8_t>(held.holds_pair)};
    if (IsInFlight(row))
    {
        const std::uint64_t data = PackBytes(&row.awaited.data[0]);
        const bool is_normal = row.stage == Stage::kPrepared;
        view.data = PayloadOf(is_normal ? data : (~data & row.mask));
    }
    return view;
}

Permit Channel::Answer(std::uint32_t challenge) const noexcept
{
    const HalfMask low = x_committed[0U] & x_running;
    const HalfMask high = x_committed[1U] & x_running;
    return Permit{Join(low, high), ((challenge + low) ^ RotateLeft(high, 16U)) * kPermitConstantB};
}

} // namespace counterpoint::channel_b
