// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"

#include "channel_b/checksum.hpp"
#include "channel_b/slots.hpp"
#include "channel_b/words.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

[[nodiscard]] std::uint32_t RotatedLeft(std::uint32_t value, std::uint32_t count) noexcept
{
    return (value << count) | (value >> (32U - count));
}

/// Times a byte it is that byte in each of four.
constexpr std::uint32_t kEachByte = 0x01010101U;

/// [SRS_CFG_031]
[[nodiscard]] GuardView ViewGuard(const CycleInput& input, std::uint32_t declared) noexcept
{
    if (input.guard_token != (RotatedLeft(input.challenge, 8U) ^ (declared * kEachByte)))
    {
        return GuardView::kStale;
    }
    return (declared == kConfigurationValidValue) ? GuardView::kConfigured : GuardView::kUnconfigured;
}

/// The only value that counts, or 0.
template <typename T> [[nodiscard]] constexpr std::uint32_t OnlyIf(T value, T expected) noexcept
{
    return (value == expected) ? static_cast<std::uint32_t>(expected) : 0U;
}

/// [SRS_CFG_034]
void AddDevice(Crc32& crc, const DeviceConfig& config, std::uint32_t gfc) noexcept
{
    crc.AddByte(config.node_id);
    crc.AddByte(config.granularity_bits);
    crc.AddByte(OnlyIf(config.dummies, DummyMapping::kAllowed));
    crc.AddByte(OnlyIf(config.gaps, NumberGaps::kSearched));
    crc.AddByte(OnlyIf(config.gfc, GfcUse::kPresent));
    crc.AddByte(static_cast<std::uint32_t>(config.normal_port));
    crc.AddByte(static_cast<std::uint32_t>(config.inverse_port));
    crc.AddWord(config.cycle_us);
    crc.AddWord(config.cycle_tolerance_us);
    crc.AddWord(config.discrepancy_us);
    crc.AddWord(config.acknowledge_window_us);
    crc.AddWord(config.diagnostic_interval_us);
    crc.AddWord(config.test_interval_us);
    crc.AddWord(config.clock_tolerance_us);
    crc.AddWord(config.clock_interval_us);
    crc.AddWord(config.output_time_us);
    crc.AddByte(gfc);
}

/// The rule of the signature comes last of those of Validate and first of those of Recheck. [SRS_CFG_029]
[[nodiscard]] ConfigFault CompareSignatures(std::uint32_t computed, std::uint32_t stored) noexcept
{
    return (computed == stored) ? ConfigFault::kNone : ConfigFault::kSignature;
}

} // namespace

Channel::Channel(const Storage& storage) noexcept
    : x_admission(storage.admission), x_room(storage.room), x_settings(storage.settings),
      x_mappings(storage.mappings, x_settings, storage.room.map_entries), x_faults(storage.faults),
      x_limits(storage.pairs, x_settings), x_consumers(storage.pairs, Parts{x_settings, x_mappings, x_faults}),
      x_producers(storage.pairs, Parts{x_settings, x_mappings, x_faults})
{
}

void Channel::Restart(const DeviceConfig& config) noexcept
{
    x_settings.Restart(config, (config.srdo_count < x_room.slots) ? config.srdo_count : x_room.slots);
    x_mappings.Restart(config);
    x_faults.Restart(x_settings.Count());
    x_consumers.Restart();
    x_producers.Clear();
    x_acknowledge = Acknowledge{};
    x_last_us = 0U;
    x_total_us = 0U;
    x_cycle = 0U;
    x_activity = Mark::kUnset;
    x_was_called = false;
    x_has_gfc = false;
    for (SlotIndex slot = 0U; slot < x_settings.Count(); ++slot)
    {
        x_admission.valid[slot] = Mark::kUnset;
        x_admission.resolved[slot] = Mark::kUnset;
    }
}

ChannelRoom Channel::Room() const noexcept
{
    return x_room;
}

// ---- configuration

/// Count and entries of a static mapping are not to be changed. [SRS_CFG_003]
void Channel::Store(const ConfigItem& item) noexcept
{
    const ConfigAddress& address = item.address;
    const bool is_slot = address.slot < x_settings.Count();
    bool is_changed = false;
    if (address.field == ConfigField::kMapEntry)
    {
        is_changed = is_slot && x_mappings.StoreEntry(address.slot, address.sub, item.value);
    }
    else if ((address.field == ConfigField::kMapCount) && is_slot && x_mappings.IsStatic(address.slot))
    {
        // It stays.
    }
    else
    {
        is_changed = x_settings.Store(item);
    }
    if (is_changed)
    {
        x_admission.resolved[address.slot] = Mark::kUnset;
    }
}

/// [SRS_CFG_003]
ConfigItem Channel::Load(const ConfigAddress& address) const noexcept
{
    ConfigItem item{address, 0U};
    const bool is_slot = address.slot < x_settings.Count();
    if (address.field == ConfigField::kMapEntry)
    {
        item.value = is_slot ? x_mappings.LoadEntry(address.slot, address.sub) : 0U;
    }
    else if ((address.field == ConfigField::kMapCount) && is_slot)
    {
        item.value = x_mappings.Of(address.slot).declared;
    }
    else
    {
        item.value = x_settings.Load(address);
    }
    return item;
}

/// [SRS_CFG_032]
void Channel::SetFields(SlotIndex slot, const StaticFields& fields) noexcept
{
    if (x_mappings.IsStatic(slot))
    {
        x_mappings.SetFields(slot, fields);
        x_admission.resolved[slot] = Mark::kUnset;
    }
}

/// The image as it is, but for the entries that do not count. [SRS_CFG_010, SRS_CFG_020]
std::uint16_t Channel::SignatureOf(SlotIndex slot) const noexcept
{
    const Mapping mapping = x_mappings.Of(slot);
    Crc16 crc;
    for (std::uint8_t at = 0U; at < kMapCount.at; ++at)
    {
        crc.AddByte(x_settings.ImageByte(slot, at));
    }
    crc.AddByte(mapping.count);
    for (std::uint32_t index = 0U; index < mapping.count; ++index)
    {
        crc.AddByte(index + 1U);
        crc.AddWord(mapping.entries[index]);
    }
    return crc.Value();
}

/// [SRS_CFG_034]
DeviceDigest Channel::Digest(SlotIndex slot, DeviceDigest before) const noexcept
{
    const SrdoSetup& setup = x_settings.Setup(slot);
    Crc32 crc{before.value};
    if (slot == 0U)
    {
        AddDevice(crc, x_settings.Config(), x_settings.GfcParameter());
    }
    crc.AddByte(setup.number);
    crc.AddByte(static_cast<std::uint32_t>(x_settings.Policy(slot)));
    crc.AddByte(static_cast<std::uint32_t>(x_settings.Form(slot)));
    crc.AddByte(static_cast<std::uint32_t>(x_settings.Detection(slot)));
    crc.AddByte(x_settings.TransmissionType(slot));
    crc.AddWord(setup.safe_value.low);
    crc.AddWord(setup.safe_value.high);
    return DeviceDigest{crc.Value()};
}

/// [SRS_CFG_020]
CheckResult Channel::Validate(SlotIndex slot) noexcept
{
    const std::uint16_t signature = SignatureOf(slot);
    const std::uint8_t direction = x_settings.Direction(slot);
    ConfigFault fault = ConfigFault::kNone;
    x_admission.resolved[slot] = Mark::kUnset;
    if (direction != kDirectionOff)
    {
        fault = x_settings.CheckParameters(slot);
        if (fault == ConfigFault::kNone)
        {
            fault = x_mappings.Resolve(slot);
        }
    }
    if (fault == ConfigFault::kNone)
    {
        fault = CompareSignatures(signature, x_settings.Signature(slot));
    }
    if ((fault == ConfigFault::kNone) && (direction != kDirectionOff))
    {
        x_admission.resolved[slot] = Mark::kGood;
        x_limits.Forget(slot);
        x_consumers.SetUp(slot);
    }
    return Conclude(slot, fault, signature);
}

/// What the signature finds need not be looked for elsewhere. [SRS_CFG_030, SRS_CHB_191, SRS_CHB_192]
CheckResult Channel::Recheck(SlotIndex slot) noexcept
{
    const std::uint16_t signature = SignatureOf(slot);
    ConfigFault fault = CompareSignatures(signature, x_settings.Signature(slot));
    if ((fault == ConfigFault::kNone) && (x_settings.Direction(slot) != kDirectionOff))
    {
        const bool is_mapped = (x_admission.resolved[slot] == Mark::kGood) && x_mappings.IsRight(slot);
        const bool is_right = is_mapped && x_mappings.IsMeasured(slot) && x_limits.AreRight(slot);
        fault = is_right ? ConfigFault::kNone : ConfigFault::kTable;
    }
    return Conclude(slot, fault, signature);
}

// ---- OPERATIONAL

/// Whether the slot becomes active, and as what. A direction that is neither stays off. [SRS_CONS_002, SRS_CONS_024]
void Channel::Admit(SlotIndex slot) noexcept
{
    const std::uint8_t direction = x_settings.Direction(slot);
    if ((x_admission.valid[slot] != Mark::kGood) || (x_admission.resolved[slot] != Mark::kGood))
    {
        return;
    }
    if (direction == kDirectionProducer)
    {
        x_producers.Admit(slot);
    }
    else if (direction == kDirectionConsumer)
    {
        x_consumers.Admit(slot);
    }
    else
    {
        return;
    }
    x_limits.Take(slot);
    // Identifiers were checked by Validate; the remainder keeps a corrupted one within the look-up.
    const std::uint32_t offset = x_settings.NormalIdentifier(slot) - kFirstSrdoIdentifier;
    x_admission.slot_of[offset % kSrdoIdentifierCount] = slot;
    x_admission.slot_of[(offset + 1U) % kSrdoIdentifierCount] = slot;
}

void Channel::Enter() noexcept
{
    x_consumers.Enter();
    x_producers.Clear();
    for (std::uint8_t offset = 0U; offset < kLookUpBytes; ++offset)
    {
        x_admission.slot_of[offset] = kNoSlot;
    }
    for (SlotIndex slot = 0U; slot < x_settings.Count(); ++slot)
    {
        Admit(slot);
    }
}

/// A frame before OPERATIONAL finds no active consumer. A global fail-safe command is accepted only by 1300h = 1 and in
/// OPERATIONAL. [SRS_CONS_001, SRS_CONS_002, SRS_CONS_017]
void Channel::OnFrame(const CanFrame& frame, Instant stamp) noexcept
{
    if (frame.kind != FrameKind::kData)
    {
        return;
    }
    const SlotIndex slot = LookUp(frame.identifier);
    if (slot < x_settings.Count())
    {
        x_consumers.OnFrame(slot, frame, stamp.us - x_last_us);
        return;
    }
    const bool is_command = (frame.identifier == kGfcIdentifier) && (frame.length_bytes == 0U);
    const bool is_accepted = IsRunning() && (x_settings.GfcParameter() == 1U);
    if (is_command && is_accepted)
    {
        x_has_gfc = true;
    }
}

/// Time, NMT state and guard come first; then the time that went by is taken from all that runs. What was taken so far
/// adds up to the instant of the last call; a flipped bit of either parts them until Restart. [SRS_CHB_190,
/// SRS_CONS_002, SRS_CONS_015, SRS_CONS_023, SRS_REL_005]
CycleOutcome Channel::OnCycle(const CycleInput& input) noexcept
{
    CycleOutcome outcome{};
    const bool was_running = IsRunning();
    const bool is_time_sound = x_total_us == x_last_us;
    const std::uint32_t elapsed_us = input.now.us - x_last_us;
    Tick tick{elapsed_us, x_acknowledge.Follow(input.acknowledge), input.request, input.stand, false, false, false};
    tick.is_late = x_was_called && (elapsed_us > x_settings.LongestCallUs()); // The first call is never late.
    tick.is_overflowed = input.queue != QueueState::kIntact;
    tick.is_gfc = x_has_gfc;
    outcome.guard = ViewGuard(input, x_settings.ConfigurationValid());
    const bool is_wanted = (outcome.guard == GuardView::kConfigured) && (input.nmt == NmtState::kOperational);
    const bool is_running = is_wanted && is_time_sound;
    x_activity = is_running ? Mark::kRunning : Mark::kUnset;
    x_last_us = input.now.us;
    x_total_us += elapsed_us;
    x_was_called = true;
    x_has_gfc = false;
    ++x_cycle;
    if (was_running && (!is_running))
    {
        outcome.new_fault = x_consumers.Leave();
        x_producers.Clear();
    }
    if (is_running && (!was_running))
    {
        Enter();
        tick.elapsed_us = 0U; // All budgets begin now.
    }
    x_consumers.Serve(tick, outcome);
    x_producers.Serve(tick, outcome);
    outcome.signalled = x_faults.Report();
    outcome.cycle = x_cycle;
    if (is_running)
    {
        const std::uint32_t served = std::uint32_t{outcome.sct_checked} + outcome.is_tx;
        outcome.is_invalid = static_cast<std::uint8_t>(x_settings.Count() - served);
    }
    outcome.not_operational = is_running ? std::uint8_t{0U} : std::uint8_t{1U};
    return outcome;
}

// ---- what is asked

HeldPair Channel::Held(SlotIndex slot) const noexcept
{
    return x_consumers.Held(slot);
}

/// [SRS_CONS_025]
SrdoView Channel::View(SlotIndex slot) const noexcept
{
    const HeldPair held = x_consumers.Held(slot);
    SrdoView view{held.data,
                  held.ordinal,
                  x_faults.Signals(slot),
                  x_faults.ErrorCount(slot),
                  x_consumers.StateOf(slot),
                  x_faults.FirstCause(slot),
                  static_cast<std::uint8_t>(held.holds_pair)};
    if (x_producers.IsActive(slot))
    {
        view.data = x_producers.InFlight(slot);
        view.ordinal = x_producers.Ordinal(slot);
        view.state = SrdoState::kProducer;
    }
    return view;
}

void Channel::Demote(SlotIndex slot) noexcept
{
    x_consumers.Demote(slot);
}

SrdoMask Channel::Commit(const Agreement& agreement, SrdoMask examine) noexcept
{
    return x_consumers.Commit(agreement, examine);
}

/// [SRS_REL_010]
Permit Channel::Answer(std::uint32_t challenge) const noexcept
{
    const SrdoMask mask = IsRunning() ? x_consumers.Permitted() : 0U;
    const Payload halves = PayloadOf(mask);
    return Permit{mask, ((challenge + halves.low) ^ RotatedLeft(halves.high, 16U)) * kPermitConstantB};
}

PreparedPair Channel::Prepare(SlotIndex slot) noexcept
{
    return x_producers.Prepare(slot);
}

CanFrame Channel::InverseFrame(SlotIndex slot) const noexcept
{
    return x_producers.InverseFrame(slot);
}

/// [SRS_PROD_007]
Confirmation Channel::OnConfirm(const CanFrame& frame, Instant stamp) noexcept
{
    const SlotIndex slot = LookUp(frame.identifier);
    if ((frame.kind == FrameKind::kData) && (slot < x_settings.Count()))
    {
        return x_producers.OnConfirm(slot, frame, stamp.us - x_last_us);
    }
    return Confirmation{kNoSlot, ConfirmStep::kNone};
}

void Channel::OnTransmitFault(SlotIndex slot, const TransmitFault& fault) noexcept
{
    x_producers.OnTransmitFault(slot, fault.cause);
}

} // namespace counterpoint::channel_b
