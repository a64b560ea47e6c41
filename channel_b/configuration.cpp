// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

/// Place and width of a field in the image; the number of the field is the row.
struct FieldSpan
{
    std::uint8_t at;
    std::uint8_t width;
};

constexpr std::uint8_t kFieldCount = 12U;
constexpr FieldSpan kSpans[kFieldCount] = { // MISRA D-001
    {0U, 0U},           {kDirectionAt, 1U},        {kSctAt, 2U},
    {kSrvtAt, 1U},      {kTransmissionTypeAt, 1U}, {kCobId1At, 4U},
    {kCobId2At, 4U},    {kMapCountAt, 1U},         {0U, 0U},
    {kSignatureAt, 2U}, {kGfcParameterAt, 1U},     {kConfigurationValidAt, 1U}};

[[nodiscard]] bool IsTimingWrong(const Row& row, std::uint32_t cycle_us) noexcept
{
    if (row.image[kDirectionAt] == kDirectionProducer)
    {
        return SctUs(row) < cycle_us;
    }
    const std::uint32_t srvt_ms = ByteAt(row, kSrvtAt);
    return (srvt_ms < 1U) || (srvt_ms >= TwoBytesAt(row, kSctAt));
}

/// The rule of the signature comes last of those of Validate and first of those of Recheck.
[[nodiscard]] ConfigFault CheckSignature(const Row& row, std::uint32_t signature) noexcept
{
    return (signature != TwoBytesAt(row, kSignatureAt)) ? ConfigFault::kSignature : ConfigFault::kNone;
}

/// A slot counts as valid if no rule is broken.
[[nodiscard]] CheckResult Conclude(Row& row, ConfigFault fault, std::uint16_t signature) noexcept
{
    row.valid = (fault == ConfigFault::kNone) ? kGood : kUnset;
    return CheckResult{fault, signature};
}

} // namespace

/// Of everything but the entries of mappings.
Channel::Place Channel::PlaceOf(const ConfigAddress& address) const noexcept
{
    const std::uint32_t field = static_cast<std::uint32_t>(address.field);
    const FieldSpan span = kSpans[(field < kFieldCount) ? field : 0U]; // MISRA D-002
    if (field >= static_cast<std::uint32_t>(ConfigField::kGfcParameter))
    {
        return Place{{&x_storage.device[span.at]}, span.width};
    }
    if (address.slot >= x_count)
    {
        return Place{{nullptr}, 0U};
    }
    return Place{{&x_storage.rows[address.slot].image[span.at]}, span.width}; // MISRA D-002
}

void Channel::SetFields(SlotIndex slot, const StaticFields& fields) noexcept
{
    if (IsStatic(MappingOf(slot)))
    {
        x_storage.fields[slot] = fields;
        x_storage.rows[slot].resolved = kUnset;
    }
}

/// Map count and entries of an existing slot.
bool Channel::IsOfMapping(const ConfigAddress& address) const noexcept
{
    const bool is_of_mapping = (address.field == ConfigField::kMapCount) || (address.field == ConfigField::kMapEntry);
    return is_of_mapping && (address.slot < x_count);
}

/// Count and entries of a static mapping are not to be changed. [SRS_CFG_003]
void Channel::Store(const ConfigItem& item) noexcept
{
    const ConfigAddress& address = item.address;
    if (IsOfMapping(address) && IsStatic(MappingOf(address.slot)))
    {
        return;
    }
    const Place place = PlaceOf(address);
    for (std::uint32_t byte = 0U; byte < place.width; ++byte)
    {
        place.bytes[byte] = static_cast<std::uint8_t>((item.value >> (8U * byte)) & 0xFFU);
    }
    const std::uint32_t index = static_cast<std::uint32_t>(address.sub) - 1U; // Of sub-index 0 a huge number.
    bool is_of_slot = (place.width != 0U) && (address.field <= ConfigField::kMapCount);
    if ((address.field == ConfigField::kMapEntry) && (address.slot < x_count) && (index < x_map_entries))
    {
        x_storage.entries[FirstEntryOf(x_storage, address.slot) + index] = item.value;
        is_of_slot = true;
    }
    if (is_of_slot)
    {
        Row& row = x_storage.rows[address.slot];
        row.resolved = kUnset;
        row.words = kNoWords;
        if (IsInFlight(row))
        {
            row.awaited.identifier = OwnIdentifier(row, (row.stage == Stage::kPrepared) ? 1U : 0U);
        }
    }
}

ConfigItem Channel::Load(const ConfigAddress& address) const noexcept
{
    ConfigItem item{address, 0U};
    if (IsOfMapping(address))
    {
        const Mapping mapping = MappingOf(address.slot);
        const std::uint32_t index = static_cast<std::uint32_t>(address.sub) - 1U;
        const std::uint32_t reach = IsStatic(mapping) ? mapping.count : x_map_entries;
        if (address.field == ConfigField::kMapCount)
        {
            item.value = mapping.declared;
        }
        else if (index < reach)
        {
            item.value = mapping.entries[index];
        }
        else
        {
            // There is none.
        }
        return item;
    }
    const Place place = PlaceOf(address);
    for (std::uint32_t byte = 0U; byte < place.width; ++byte)
    {
        item.value |= static_cast<std::uint32_t>(place.bytes[byte]) << (8U * byte);
    }
    return item;
}

bool Channel::IsIdentifierInUse(SlotIndex slot) const noexcept
{
    const std::uint32_t normal = WordAt(x_storage.rows[slot], kCobId1At);
    bool is_in_use = false;
    for (std::uint32_t other = 0U; other < x_count; ++other)
    {
        // Ours are `normal` and the next one, so that a modular distance of 0 or 1 is one of them.
        const Row& row = x_storage.rows[other];
        const bool is_other = (other != slot) && (row.image[kDirectionAt] != kDirectionOff);
        const bool is_normal_ours = (WordAt(row, kCobId1At) - normal) <= 1U;
        const bool is_inverse_ours = (WordAt(row, kCobId2At) - normal) <= 1U;
        if (is_other && (is_normal_ours || is_inverse_ours))
        {
            is_in_use = true;
        }
    }
    return is_in_use;
}

/// All rules before those of the mapping. [SRS_CFG_021, SRS_CFG_022, SRS_CFG_023, SRS_CFG_024, SRS_CFG_025]
ConfigFault Channel::CheckParameters(SlotIndex slot) const noexcept
{
    const Row& row = x_storage.rows[slot];
    if (row.image[kDirectionAt] > kDirectionConsumer)
    {
        return ConfigFault::kDirection;
    }
    if (row.image[kTransmissionTypeAt] != kTransmissionTypeAsynchronous)
    {
        return ConfigFault::kTransmissionType;
    }
    const std::uint32_t normal = WordAt(row, kCobId1At);
    const std::uint32_t offset = normal - kFirstSrdoIdentifier;
    const bool is_normal_right = (offset < kSrdoIdentifierCount) && ((offset & 1U) == 0U);
    if ((!is_normal_right) || (WordAt(row, kCobId2At) != (normal + 1U)))
    {
        return ConfigFault::kIdentifier;
    }
    if (IsIdentifierInUse(slot))
    {
        return ConfigFault::kIdentifierInUse;
    }
    return IsTimingWrong(row, x_config->cycle_us) ? ConfigFault::kTiming : ConfigFault::kNone;
}

CheckResult Channel::Validate(SlotIndex slot) noexcept
{
    Row& row = x_storage.rows[slot];
    const Mapping mapping = MappingOf(slot);
    const std::uint16_t signature = SignatureOf(row, mapping);
    const std::uint8_t direction = row.image[kDirectionAt];
    ConfigFault fault = ConfigFault::kNone;
    row.resolved = kUnset;
    if (direction != kDirectionOff)
    {
        fault = CheckParameters(slot);
        if (fault == ConfigFault::kNone)
        {
            fault = CheckMapping(slot, mapping);
        }
    }
    if (fault == ConfigFault::kNone)
    {
        fault = CheckSignature(row, signature);
    }
    if ((fault == ConfigFault::kNone) && (direction != kDirectionOff))
    {
        row.resolved = kGood;
        x_committed[slot / kSlotsInHalf] &= ~BitOf(slot); // What was released is overwritten here, or no longer ours.
        if (direction == kDirectionConsumer)
        {
            WriteSafe(slot);
        }
    }
    return Conclude(row, fault, signature);
}

/// What the signature finds need not be looked for in the table.
CheckResult Channel::Recheck(SlotIndex slot) noexcept
{
    Row& row = x_storage.rows[slot];
    const Mapping mapping = MappingOf(slot);
    const std::uint16_t signature = SignatureOf(row, mapping);
    ConfigFault fault = CheckSignature(row, signature);
    if ((fault == ConfigFault::kNone) && (row.image[kDirectionAt] != kDirectionOff))
    {
        const bool is_right = (row.resolved == kGood) && IsTableRight(slot, mapping);
        fault = is_right ? ConfigFault::kNone : ConfigFault::kTable;
    }
    return Conclude(row, fault, signature);
}

} // namespace counterpoint::channel_b
