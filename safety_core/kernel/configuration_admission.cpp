// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/configuration_guard.hpp"

// Which changed values the guard admits, and the abort code of those it does not. [SRS-CFG-044, SRS-CFG-045]
namespace counterpoint
{
namespace
{

constexpr std::uint32_t kLengthMask = 0xFFU;
constexpr std::uint32_t kSubShift = 8U;
constexpr std::uint32_t kIndexShift = 16U;
constexpr std::uint32_t kGfcSupported = 1U;

} // namespace

AbortCode ConfigurationGuard::AdmitItem(const ConfigItem& item) const noexcept
{
    const ConfigField field = item.address.field;
    if (field == ConfigField::kDirection)
    {
        return AdmitDirection(item);
    }
    if ((field == ConfigField::kCobId1) || (field == ConfigField::kCobId2))
    {
        return AdmitCobId(item);
    }
    if (field == ConfigField::kMapCount)
    {
        return AdmitMapCount(item);
    }
    if (field == ConfigField::kMapEntry)
    {
        return AdmitMapEntry(item);
    }
    // The one transmission type that is admitted is the one that is stored: any change is wrong.
    const bool is_wrong_type = field == ConfigField::kTransmissionType;
    const bool is_wrong_gfc = (field == ConfigField::kGfcParameter) && (item.value > kGfcSupported);
    return (is_wrong_type || is_wrong_gfc) ? AbortCode::kValueRange : AbortCode::kNone;
}

bool ConfigurationGuard::IsIdentifierFree(const ConfigItem& item) const noexcept
{
    bool is_free = true;
    for (SlotIndex other = 0U; other < config_->srdo_count; ++other)
    {
        const bool is_on = Value(other, ConfigField::kDirection, 0U) != kDirectionOff;
        if (is_on && (other != item.address.slot))
        {
            const std::uint32_t cob_id_1 = Value(other, ConfigField::kCobId1, 0U);
            const std::uint32_t cob_id_2 = Value(other, ConfigField::kCobId2, 0U);
            if ((cob_id_1 == item.value) || (cob_id_2 == item.value))
            {
                is_free = false;
            }
        }
    }
    return is_free;
}

AbortCode ConfigurationGuard::AdmitCobId(const ConfigItem& item) const noexcept
{
    const SlotIndex slot = item.address.slot;
    const bool is_first = item.address.field == ConfigField::kCobId1;
    const std::uint32_t parity = is_first ? 1U : 0U;
    // COB-ID 1 stands for itself; COB-ID 2 must follow it.
    const std::uint32_t wanted = is_first ? item.value : (Value(slot, ConfigField::kCobId1, 0U) + 1U);
    const bool is_in_range = (item.value >= kFirstSrdoIdentifier) && (item.value <= kLastSrdoIdentifier);
    const bool is_of_kind = ((item.value & 1U) == parity) && (item.value == wanted);
    const bool is_off = Value(slot, ConfigField::kDirection, 0U) == kDirectionOff;
    if (!is_off)
    {
        return AbortCode::kValueRange;
    }
    if (is_in_range && is_of_kind && IsIdentifierFree(item))
    {
        return AbortCode::kNone;
    }
    return AbortCode::kValueRange;
}

// COB-IDs of an SRDO that is to be switched on.
AbortCode ConfigurationGuard::AdmitConnection(const SlotIndex slot) const noexcept
{
    const std::uint32_t cob_id_1 = Value(slot, ConfigField::kCobId1, 0U);
    const std::uint32_t cob_id_2 = Value(slot, ConfigField::kCobId2, 0U);
    const ConfigItem first{ConfigAddress{slot, ConfigField::kCobId1, 0U}, cob_id_1};
    const ConfigItem second{ConfigAddress{slot, ConfigField::kCobId2, 0U}, cob_id_2};
    // A stored identifier is 0 or was admitted as 101h to 180h of its parity.
    const bool is_pair = (cob_id_1 != 0U) && (cob_id_2 == (cob_id_1 + 1U));
    if (is_pair && IsIdentifierFree(first) && IsIdentifierFree(second))
    {
        return AbortCode::kNone;
    }
    return AbortCode::kValueRange;
}

AbortCode ConfigurationGuard::AdmitDirection(const ConfigItem& item) const noexcept
{
    if (item.value > kDirectionConsumer)
    {
        return AbortCode::kValueRange;
    }
    if (item.value == kDirectionOff)
    {
        return AbortCode::kNone;
    }
    return AdmitConnection(item.address.slot);
}

std::uint32_t ConfigurationGuard::MappedBits(const SlotIndex slot, const std::uint8_t first,
                                             const std::uint32_t count) const noexcept
{
    std::uint32_t bits = 0U;
    for (std::uint8_t sub = first; sub <= count; sub = static_cast<std::uint8_t>(sub + 2U))
    {
        bits += Value(slot, ConfigField::kMapEntry, sub) & kLengthMask;
    }
    return bits;
}

AbortCode ConfigurationGuard::AdmitMapCount(const ConfigItem& item) const noexcept
{
    const SlotIndex slot = item.address.slot;
    if (Value(slot, ConfigField::kDirection, 0U) != kDirectionOff)
    {
        return AbortCode::kUnsupportedAccess;
    }
    const bool is_count = (item.value <= kMaxMapEntries) && ((item.value & 1U) == 0U);
    if (!is_count)
    {
        return AbortCode::kMapTooLong;
    }
    const bool fits =
        (MappedBits(slot, 1U, item.value) <= kMaxPayloadBits) && (MappedBits(slot, 2U, item.value) <= kMaxPayloadBits);
    return fits ? AbortCode::kNone : AbortCode::kMapTooLong;
}

AbortCode ConfigurationGuard::AdmitMapEntry(const ConfigItem& item) const noexcept
{
    const SlotIndex slot = item.address.slot;
    const std::uint32_t in_use = Value(slot, ConfigField::kDirection, 0U) | Value(slot, ConfigField::kMapCount, 0U);
    if (in_use != 0U)
    {
        return AbortCode::kUnsupportedAccess;
    }
    if (item.value == 0U)
    {
        return AbortCode::kNone;
    }
    const ObjectAddress address{static_cast<std::uint16_t>(item.value >> kIndexShift),
                                static_cast<std::uint8_t>(item.value >> kSubShift)};
    const MappableObject* const object = FindObject(*config_, address);
    if (object == nullptr)
    {
        return AbortCode::kObjectUnknown;
    }
    const bool is_mappable = object->access != MapAccess::kNone;
    const bool has_length = (item.value & kLengthMask) == object->length_bits;
    return (is_mappable && has_length) ? AbortCode::kNone : AbortCode::kNotMappable;
}

} // namespace counterpoint
