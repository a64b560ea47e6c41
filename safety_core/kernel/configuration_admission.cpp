// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/configuration_admission.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kGfcSupported = 1U;

// No other SRDO that is not off has the identifier.
bool IsFree(const ConfigurationCopies& copies, const SlotIndex slot, const std::uint32_t identifier) noexcept
{
    bool is_free = true;
    for (SlotIndex other = 0U; other < copies.Device().srdo_count; ++other)
    {
        const bool has_it = (copies.Value(other, ConfigField::kCobId1) == identifier) ||
                            (copies.Value(other, ConfigField::kCobId2) == identifier);
        if (has_it && (other != slot) && (copies.Value(other, ConfigField::kDirection) != kDirectionOff))
        {
            is_free = false;
        }
    }
    return is_free;
}

bool IsCobIdFit(const ConfigurationCopies& copies, const ConfigItem& item) noexcept
{
    const SlotIndex slot = item.address.slot;
    const bool is_first = item.address.field == ConfigField::kCobId1;
    const std::uint32_t parity = is_first ? 1U : 0U;
    // COB-ID 1 stands for itself; COB-ID 2 must follow it.
    const std::uint32_t wanted = is_first ? item.value : (copies.Value(slot, ConfigField::kCobId1) + 1U);
    const bool is_in_range = (item.value - kFirstSrdoIdentifier) < kSrdoIdentifierCount;
    const bool is_of_kind = ((item.value & 1U) == parity) && (item.value == wanted);
    const bool is_off = copies.Value(slot, ConfigField::kDirection) == kDirectionOff;
    return is_in_range && is_of_kind && (is_off && IsFree(copies, slot, item.value));
}

// An SRDO that is to be switched on needs its COB-IDs. A stored one is 0 or was admitted as 101h to 180h of its parity.
bool IsDirectionFit(const ConfigurationCopies& copies, const ConfigItem& item) noexcept
{
    if (item.value == kDirectionOff)
    {
        return true;
    }
    const SlotIndex slot = item.address.slot;
    const std::uint32_t cob_id_1 = copies.Value(slot, ConfigField::kCobId1);
    const std::uint32_t cob_id_2 = copies.Value(slot, ConfigField::kCobId2);
    const bool is_pair = (cob_id_1 != 0U) && (cob_id_2 == (cob_id_1 + 1U));
    const bool is_direction = item.value <= kDirectionConsumer;
    return is_direction && is_pair && (IsFree(copies, slot, cob_id_1) && IsFree(copies, slot, cob_id_2));
}

std::uint32_t MappedBits(const ConfigurationCopies& copies, const SlotIndex slot, const std::uint8_t first,
                         const std::uint32_t count) noexcept
{
    std::uint32_t bits = 0U;
    for (std::uint32_t sub = first; sub <= count; sub += 2U)
    {
        bits += copies.Value(slot, ConfigField::kMapEntry, static_cast<std::uint8_t>(sub)) & kEntryLengthMask;
    }
    return bits;
}

AbortCode AdmitMapCount(const ConfigurationCopies& copies, const ConfigItem& item) noexcept
{
    const SlotIndex slot = item.address.slot;
    const bool is_on = copies.Value(slot, ConfigField::kDirection) != kDirectionOff;
    const bool is_deleted = (copies.Value(slot, ConfigField::kMapCount) == 0U) || (item.value == 0U);
    if (is_on || (!is_deleted))
    {
        return AbortCode::kUnsupportedAccess;
    }
    const bool is_count = (item.value <= copies.Device().map_entries) && ((item.value & 1U) == 0U);
    const bool fits = is_count && (MappedBits(copies, slot, 1U, item.value) <= kMaxPayloadBits) &&
                      (MappedBits(copies, slot, 2U, item.value) <= kMaxPayloadBits);
    return fits ? AbortCode::kNone : AbortCode::kMapTooLong;
}

AbortCode AdmitMapEntry(const ConfigurationCopies& copies, const ConfigItem& item) noexcept
{
    const SlotIndex slot = item.address.slot;
    if ((copies.Value(slot, ConfigField::kDirection) | copies.Value(slot, ConfigField::kMapCount)) != 0U)
    {
        return AbortCode::kUnsupportedAccess;
    }
    const bool is_dummy = (copies.Device().dummies == DummyMapping::kAllowed) && IsDummy(item.value);
    if (is_dummy || (item.value == 0U))
    {
        return AbortCode::kNone;
    }
    const MappableObject* const object = FindMapped(copies.Device(), item.value);
    if (object == nullptr)
    {
        return AbortCode::kObjectUnknown;
    }
    const bool is_mappable = object->access != MapAccess::kNone;
    const bool has_length = (item.value & kEntryLengthMask) == object->length_bits;
    return (is_mappable && has_length) ? AbortCode::kNone : AbortCode::kNotMappable;
}

} // namespace

AbortCode Admit(const ConfigurationCopies& copies, const ConfigItem& item) noexcept
{
    const ConfigField field = item.address.field;
    if (field == ConfigField::kMapEntry)
    {
        return AdmitMapEntry(copies, item);
    }
    if (field == ConfigField::kMapCount)
    {
        return AdmitMapCount(copies, item);
    }
    // The one transmission type that is admitted is the one that is stored: any change is wrong.
    bool is_fit = field != ConfigField::kTransmissionType;
    if (field == ConfigField::kDirection)
    {
        is_fit = IsDirectionFit(copies, item);
    }
    if ((field == ConfigField::kCobId1) || (field == ConfigField::kCobId2))
    {
        is_fit = IsCobIdFit(copies, item);
    }
    if (field == ConfigField::kGfcParameter)
    {
        is_fit = item.value <= kGfcSupported;
    }
    return is_fit ? AbortCode::kNone : AbortCode::kValueRange;
}

} // namespace counterpoint
