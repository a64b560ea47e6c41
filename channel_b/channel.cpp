// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"

#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

// Power-on values. [SRS-CFG-002]
constexpr std::uint8_t kDefaultRefreshMs = 25U;
constexpr std::uint8_t kDefaultSctMs = 50U;
constexpr std::uint8_t kDefaultSrvtMs = 20U;
constexpr std::uint8_t kLastDefaultProducer = 32U;
constexpr std::uint8_t kLastDefaultNode = 64U;

[[nodiscard]] std::uint32_t RotateLeft(std::uint32_t value, std::uint32_t count) noexcept
{
    return (value << count) | (value >> (32U - count));
}

/// Of a valid pair the inverse data tell the normal data.
[[nodiscard]] Payload DataOf(const Row& row) noexcept
{
    return PayloadOf(~row.inverse_data & row.mask);
}

} // namespace

void Channel::ClearSlot(SlotIndex slot) noexcept
{
    Row& row = x_storage.rows[slot];
    row = Row{};
    const std::uint32_t first = FirstEntryOf(x_storage, slot);
    for (std::uint32_t index = 0U; index < x_storage.map_entries; ++index)
    {
        x_storage.entries[first + index] = 0U;
        x_storage.table[first + index] = kNoPlace;
    }
    row.image[kSctAt] = kDefaultRefreshMs;
    row.image[kSrvtAt] = kDefaultSrvtMs;
    row.image[kTransmissionTypeAt] = kTransmissionTypeAsynchronous;
    x_storage.direction[slot] = kDirectionOff;
    x_storage.first_cause[slot] = Code(SrdoCause::kNone);
    x_storage.ordinal[slot] = 0U;
    x_storage.phase_left[slot] = kLongestPhase;
    Ground(slot, Stage::kOff);
}

void Channel::Restart(const DeviceConfig& config) noexcept
{
    const Column<const SrdoSetup> setups{config.srdos};
    x_config = &config;
    x_count = (config.srdo_count < x_storage.capacity) ? config.srdo_count : x_storage.capacity;
    x_map_entries = (config.map_entries < x_storage.map_entries) ? config.map_entries : x_storage.map_entries;
    x_port[0U] = config.inverse_port;
    x_port[1U] = config.normal_port;
    x_running = 0U;
    x_gfc = 0U;
    x_any_late = 0U;
    x_late_us = 0xFFFFFFFFU; // The first call is never late.
    x_cycle = 0U;
    x_storage.device[kGfcParameterAt] = 0U;
    x_storage.device[kConfigurationValidAt] = 0U;
    for (std::uint8_t half = 0U; half < kHalves; ++half)
    {
        Marks& marks = x_storage.marks[half];
        x_present[half] = 0U;
        x_levels[half] = ~HalfMask{0U}; // A level that is 1 from the start is no edge.
        marks = Marks{};
        marks.held = kUnmarked;
        marks.acknowledged = kUnmarked;
        marks.automatic = kUnmarked;
        marks.valid = kUnmarked;
        marks.enrolled = kUnmarked;
        marks.released = kUnmarked;
    }
    ClearLookUp();
    for (SlotIndex slot = 0U; slot < x_count; ++slot)
    {
        x_present[slot / kSlotsInHalf] |= BitOf(slot);
        ClearSlot(slot);
        TakeSetup(slot, setups[slot]);
    }
}

void Channel::TakeSetup(SlotIndex slot, const SrdoSetup& setup) noexcept
{
    const std::uint8_t node = x_config->node_id;
    Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
    if (setup.policy == ReleasePolicy::kAutomatic)
    {
        Grant(marks.automatic, bit);
    }
    if (setup.form == ProducerForm::kProviderCalled)
    {
        marks.provider |= bit;
    }
    if (setup.detection == SrvtDetection::kLate)
    {
        marks.late |= bit;
        x_any_late |= bit;
    }
    if ((setup.number == 1U) && (node <= kLastDefaultNode))
    {
        Row& row = x_storage.rows[slot];
        const std::uint32_t normal = kFirstSrdoIdentifier + (2U * (std::uint32_t{node} - 1U)); // 0FFh + 2n
        UnpackFourBytes(normal, &row.image[kCobId1At]);
        UnpackFourBytes(normal + 1U, &row.image[kCobId2At]);
        row.image[kSctAt] = (node > kLastDefaultProducer) ? kDefaultSctMs : kDefaultRefreshMs;
    }
}

ChannelRoom Channel::Room() const noexcept
{
    return ChannelRoom{x_storage.capacity, x_storage.map_entries};
}

void Channel::ClearLookUp() noexcept
{
    for (std::uint8_t offset = 0U; offset < kLookUpBytes; ++offset)
    {
        x_storage.slot_of[offset] = kNoSlot;
    }
}

HeldPair Channel::Held(SlotIndex slot) const noexcept
{
    const Marks& marks = MarksOf(x_storage, slot);
    const HalfMask consumer = marks.consumers & BitOf(slot);
    if ((Granted(marks.held) & consumer) != 0U)
    {
        return HeldPair{DataOf(x_storage.rows[slot]), x_storage.ordinal[slot], 1U};
    }
    return HeldPair{{0U, 0U}, (consumer != 0U) ? x_storage.ordinal[slot] : 0U, 0U};
}

SrdoState Channel::StateOf(SlotIndex slot) const noexcept
{
    const Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
    if ((marks.consumers & bit) == 0U)
    {
        return ((marks.producers & bit) != 0U) ? SrdoState::kProducer : SrdoState::kOff;
    }
    if ((marks.faulted & bit) != 0U)
    {
        return SrdoState::kFaulted;
    }
    return ((Granted(marks.released) & bit) != 0U) ? SrdoState::kReleased : SrdoState::kWaiting;
}

SrdoView Channel::View(SlotIndex slot) const noexcept
{
    const Row& row = x_storage.rows[slot];
    const HeldPair held = Held(slot);
    SrdoView view{held.data,
                  x_storage.ordinal[slot] + row.sent,
                  0U,
                  row.error_count,
                  StateOf(slot),
                  static_cast<SrdoCause>(x_storage.first_cause[slot]),
                  static_cast<std::uint8_t>(held.holds_pair)};
    if (IsInFlight(row.stage))
    {
        view.data = DataOf(row);
    }
    if ((MarksOf(x_storage, slot).signalled & BitOf(slot)) != 0U)
    {
        view.signals = row.signals;
    }
    return view;
}

Permit Channel::Answer(std::uint32_t challenge) const noexcept
{
    const HalfMask low = x_storage.marks[0U].committed & x_running;
    const HalfMask high = x_storage.marks[1U].committed & x_running;
    return Permit{Join(low, high), ((challenge + low) ^ RotateLeft(high, 16U)) * kPermitConstantB};
}

} // namespace counterpoint::channel_b
