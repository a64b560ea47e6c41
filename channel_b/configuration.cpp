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
    {0U, 0U},
    {0U, 1U},
    {kSctAt, 2U},
    {kSrvtAt, 1U},
    {kTransmissionTypeAt, 1U},
    {kCobId1At, 4U},
    {kCobId2At, 4U},
    {kMapCountAt, 1U},
    {0U, 0U},
    {kSignatureAt, 2U},
    {kGfcParameterAt, 1U},
    {kConfigurationValidAt, 1U}};

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
    if (address.field == ConfigField::kDirection)
    {
        return Place{{&x_storage.direction[address.slot]}, span.width};
    }
    return Place{{&x_storage.rows[address.slot].image[span.at]}, span.width}; // MISRA D-002
}

void Channel::SetFields(SlotIndex slot, const StaticFields& fields) noexcept
{
    if (IsStatic(MappingOf(slot)))
    {
        x_storage.rows[slot].fields = fields;
        MarksOf(x_storage, slot).resolved &= ~BitOf(slot);
    }
}

/// Count or entry of a mapping of an existing slot: that of a static one is not to be changed. [SRS-CFG-003]
bool Channel::StoreEntry(const ConfigItem& item) noexcept
{
    const Mapping mapping = MappingOf(item.address.slot);
    const std::uint32_t index = static_cast<std::uint32_t>(item.address.sub) - 1U; // Of sub-index 0 a huge number.
    if (IsStatic(mapping))
    {
        return false;
    }
    if (item.address.field == ConfigField::kMapCount)
    {
        x_storage.rows[item.address.slot].image[kMapCountAt] = static_cast<std::uint8_t>(item.value & 0xFFU);
        return true;
    }
    if (index >= x_map_entries)
    {
        return false;
    }
    x_storage.entries[mapping.first + index] = item.value;
    return true;
}

bool Channel::StoreField(const ConfigItem& item) noexcept
{
    const Place place = PlaceOf(item.address);
    const SlotIndex slot = item.address.slot;
    if ((item.address.field == ConfigField::kSct) && (place.width != 0U))
    {
        // A window of signals that is running ends by the new time.
        const std::uint32_t new_us = (item.value & 0xFFFFU) * kMicrosecondsPerMillisecond;
        x_storage.rows[slot].window_left += new_us - SctUs(x_storage.rows[slot]);
    }
    for (std::uint32_t byte = 0U; byte < place.width; ++byte)
    {
        place.bytes[byte] = static_cast<std::uint8_t>((item.value >> (8U * byte)) & 0xFFU);
    }
    return (place.width != 0U) && (item.address.field < ConfigField::kMapCount);
}

/// Map count and entries of an existing slot.
bool Channel::IsOfMapping(const ConfigAddress& address) const noexcept
{
    const bool is_of_mapping = (address.field == ConfigField::kMapCount) || (address.field == ConfigField::kMapEntry);
    return is_of_mapping && (address.slot < x_count);
}

void Channel::Store(const ConfigItem& item) noexcept
{
    const bool is_unresolved = IsOfMapping(item.address) ? StoreEntry(item) : StoreField(item);
    if (is_unresolved)
    {
        MarksOf(x_storage, item.address.slot).resolved &= ~BitOf(item.address.slot);
    }
}

std::uint32_t Channel::LoadEntry(const ConfigAddress& address) const noexcept
{
    const Mapping mapping = MappingOf(address.slot);
    const std::uint32_t index = static_cast<std::uint32_t>(address.sub) - 1U;
    if (address.field == ConfigField::kMapCount)
    {
        return mapping.declared;
    }
    const std::uint32_t reach = IsStatic(mapping) ? mapping.count : x_map_entries;
    return (index < reach) ? mapping.entries[index] : 0U;
}

ConfigItem Channel::Load(const ConfigAddress& address) const noexcept
{
    if (IsOfMapping(address))
    {
        return ConfigItem{address, LoadEntry(address)};
    }
    const Place place = PlaceOf(address);
    std::uint32_t value = 0U;
    for (std::uint32_t byte = 0U; byte < place.width; ++byte)
    {
        value |= static_cast<std::uint32_t>(place.bytes[byte]) << (8U * byte);
    }
    return ConfigItem{address, value};
}

bool Channel::IsIdentifierInUse(SlotIndex slot) const noexcept
{
    const std::uint32_t normal = NormalIdentifier(x_storage.rows[slot]);
    bool is_in_use = false;
    for (SlotIndex other = 0U; other < x_count; ++other)
    {
        // Ours are `normal` and the next one, so that a modular distance of 0 or 1 is one of them.
        const bool is_other = (other != slot) && (x_storage.direction[other] != kDirectionOff);
        const bool is_normal_ours = (NormalIdentifier(x_storage.rows[other]) - normal) <= 1U;
        const bool is_inverse_ours = (InverseIdentifier(x_storage.rows[other]) - normal) <= 1U;
        if (is_other && (is_normal_ours || is_inverse_ours))
        {
            is_in_use = true;
        }
    }
    return is_in_use;
}

bool Channel::IsTimingWrong(SlotIndex slot) const noexcept
{
    if (x_storage.direction[slot] == kDirectionProducer)
    {
        return SctUs(x_storage.rows[slot]) < x_config->cycle_us;
    }
    const std::uint32_t srvt_ms = ByteAt(x_storage.rows[slot], kSrvtAt);
    return (srvt_ms < 1U) || (srvt_ms >= SctMs(x_storage.rows[slot]));
}

/// All rules before those of the mapping. [SRS-CFG-021 to 025]
ConfigFault Channel::CheckParameters(SlotIndex slot) const noexcept
{
    if (x_storage.direction[slot] > kDirectionConsumer)
    {
        return ConfigFault::kDirection;
    }
    if (ByteAt(x_storage.rows[slot], kTransmissionTypeAt) != kTransmissionTypeAsynchronous)
    {
        return ConfigFault::kTransmissionType;
    }
    const std::uint32_t normal = NormalIdentifier(x_storage.rows[slot]);
    const std::uint32_t offset = normal - kFirstSrdoIdentifier;
    const bool is_normal_right = (offset < kSrdoIdentifierCount) && ((offset & 1U) == 0U);
    if ((!is_normal_right) || (InverseIdentifier(x_storage.rows[slot]) != (normal + 1U)))
    {
        return ConfigFault::kIdentifier;
    }
    if (IsIdentifierInUse(slot))
    {
        return ConfigFault::kIdentifierInUse;
    }
    return IsTimingWrong(slot) ? ConfigFault::kTiming : ConfigFault::kNone;
}

/// The rule of the signature comes last of those of Validate and first of those of Recheck; a slot counts as valid if
/// no rule is broken.
CheckResult Channel::Conclude(SlotIndex slot, ConfigFault fault, std::uint16_t signature) noexcept
{
    TwinMask& valid = MarksOf(x_storage, slot).valid;
    if (fault == ConfigFault::kNone)
    {
        Grant(valid, BitOf(slot));
    }
    else
    {
        Withdraw(valid, BitOf(slot));
    }
    return CheckResult{fault, signature};
}

ConfigFault Channel::CheckSignature(SlotIndex slot, std::uint16_t signature) const noexcept
{
    const Row& row = x_storage.rows[slot];
    const std::uint32_t stored = ByteAt(row, kSignatureAt) | (ByteAt(row, kSignatureAt + 1U) << 8U);
    return (signature != stored) ? ConfigFault::kSignature : ConfigFault::kNone;
}

CheckResult Channel::Validate(SlotIndex slot) noexcept
{
    Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
    const Mapping mapping = MappingOf(slot);
    const std::uint16_t signature = SignatureOf(slot, mapping);
    const std::uint8_t direction = x_storage.direction[slot];
    ConfigFault fault = ConfigFault::kNone;
    marks.resolved &= ~bit;
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
        fault = CheckSignature(slot, signature);
    }
    if ((fault == ConfigFault::kNone) && (direction != kDirectionOff))
    {
        marks.resolved |= bit;
        marks.committed &= ~bit; // Whatever was released is overwritten here, or no longer ours.
        if (direction == kDirectionConsumer)
        {
            WriteInverse(slot, SafeDataOf(slot));
        }
    }
    return Conclude(slot, fault, signature);
}

/// What the signature finds need not be looked for in the table.
CheckResult Channel::Recheck(SlotIndex slot) noexcept
{
    const Mapping mapping = MappingOf(slot);
    const std::uint16_t signature = SignatureOf(slot, mapping);
    ConfigFault fault = CheckSignature(slot, signature);
    if ((fault == ConfigFault::kNone) && (x_storage.direction[slot] != kDirectionOff))
    {
        const bool is_resolved = (MarksOf(x_storage, slot).resolved & BitOf(slot)) != 0U;
        fault = (is_resolved && IsTableRight(slot, mapping)) ? ConfigFault::kNone : ConfigFault::kTable;
    }
    return Conclude(slot, fault, signature);
}

} // namespace counterpoint::channel_b
