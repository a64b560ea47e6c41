// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/object_access.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint16_t kGfcIndex = 0x1300U;
constexpr std::uint16_t kCommunicationBase = 0x1300U;
constexpr std::uint16_t kMappingBase = 0x1380U;
constexpr std::uint16_t kConfigurationValidIndex = 0x13FEU;
constexpr std::uint16_t kSignatureIndex = 0x13FFU;

constexpr ObjectPlace kUnknown{ObjectKind::kInvalid, {kNoSlot, ConfigField::kInvalid, 0U}, 0U, 0U, nullptr};
constexpr ObjectPlace kNoSuchSub{ObjectKind::kSubUnknown, {kNoSlot, ConfigField::kInvalid, 0U}, 0U, 0U, nullptr};

struct FieldPlace
{
    ConfigField field;
    std::uint8_t size_bytes;
};

// Sub-index 1 to 6 of 1301h to 1340h.
constexpr FieldPlace kCommunication[kCommunicationSubs] = { // MISRA D-001
    {ConfigField::kDirection, 1U},        {ConfigField::kSct, 2U},    {ConfigField::kSrvt, 1U},
    {ConfigField::kTransmissionType, 1U}, {ConfigField::kCobId1, 4U}, {ConfigField::kCobId2, 4U}};

constexpr std::uint8_t kEntryBytes = 4U;
constexpr std::uint8_t kSignatureBytes = 2U;

ObjectPlace Constant(const std::uint8_t value) noexcept
{
    return ObjectPlace{ObjectKind::kConstant, {kNoSlot, ConfigField::kInvalid, 0U}, 1U, value, nullptr};
}

ObjectPlace Stored(const ConfigAddress& address, const std::uint8_t size_bytes) noexcept
{
    return ObjectPlace{ObjectKind::kConfiguration, address, size_bytes, 0U, nullptr};
}

ObjectPlace LocateCommunication(const SlotIndex slot, const std::uint8_t sub) noexcept
{
    if (sub == 0U)
    {
        return Constant(kCommunicationSubs);
    }
    if (sub > kCommunicationSubs)
    {
        return kNoSuchSub;
    }
    const FieldPlace& place = kCommunication[sub - 1U]; // MISRA D-002
    return Stored(ConfigAddress{slot, place.field, 0U}, place.size_bytes);
}

ObjectPlace LocateMapping(const SlotIndex slot, const std::uint8_t sub) noexcept
{
    if (sub == 0U)
    {
        return Stored(ConfigAddress{slot, ConfigField::kMapCount, 0U}, 1U);
    }
    if (sub > kMaxMapEntries)
    {
        return kNoSuchSub;
    }
    return Stored(ConfigAddress{slot, ConfigField::kMapEntry, sub}, kEntryBytes);
}

ObjectPlace LocateSignature(const DeviceConfig& config, const std::uint8_t sub) noexcept
{
    const std::uint8_t highest = config.srdos[config.srdo_count - 1U].number; // MISRA D-002
    if (sub == 0U)
    {
        return Constant(highest);
    }
    if (sub > highest)
    {
        return kNoSuchSub;
    }
    const SlotIndex slot = SlotOf(config, SrdoNumber{sub});
    if (slot == kNoSlot)
    {
        return ObjectPlace{
            ObjectKind::kGapSignature, {kNoSlot, ConfigField::kInvalid, 0U}, kSignatureBytes, 0U, nullptr};
    }
    return Stored(ConfigAddress{slot, ConfigField::kSignature, 0U}, kSignatureBytes);
}

// 1300h and 13FEh have sub-index 0 only.
ObjectPlace LocateSingle(const ConfigField field, const ObjectKind kind, const std::uint8_t sub) noexcept
{
    return (sub == 0U) ? ObjectPlace{kind, {0U, field, 0U}, 1U, 0U, nullptr} : kNoSuchSub;
}

// The SRDO number that an index speaks of when its area starts behind `base`; 0 when it is outside that area.
SrdoNumber NumberIn(const std::uint16_t index, const std::uint16_t base) noexcept
{
    const std::uint32_t distance = static_cast<std::uint32_t>(index) - base;
    return SrdoNumber{(distance <= kMaxSrdoCount) ? static_cast<std::uint8_t>(distance) : std::uint8_t{0U}};
}

ObjectPlace LocateVariable(const DeviceConfig& config, const ObjectAddress& address) noexcept
{
    const MappableObject* const object = FindObject(config, address);
    if (object == nullptr)
    {
        return kUnknown;
    }
    const std::uint8_t size_bytes = static_cast<std::uint8_t>(object->length_bits / 8U);
    return ObjectPlace{ObjectKind::kVariable, {kNoSlot, ConfigField::kInvalid, 0U}, size_bytes, 0U, object};
}

// Ascending order of the table of objects.
std::uint32_t OrderOf(const std::uint16_t index, const std::uint8_t sub) noexcept
{
    return (static_cast<std::uint32_t>(index) << 8U) | sub;
}

} // namespace

// Numbers ascend from 1: SRDO n is in slot n - 1 where nothing is missing before it, and below where something is.
SlotIndex SlotOf(const DeviceConfig& config, const SrdoNumber number) noexcept
{
    std::uint32_t candidate = (number.value < config.srdo_count) ? number.value : config.srdo_count;
    while (candidate != 0U)
    {
        --candidate;
        if (config.srdos[candidate].number == number.value) // MISRA D-002
        {
            return static_cast<SlotIndex>(candidate);
        }
    }
    return kNoSlot;
}

const MappableObject* FindObject(const DeviceConfig& config, const ObjectAddress& address) noexcept
{
    const std::uint32_t wanted = OrderOf(address.index, address.sub);
    std::uint32_t low = 0U;
    std::uint32_t high = config.object_count;
    while (low < high)
    {
        const std::uint32_t middle = (low + high) / 2U;
        const MappableObject& object = config.objects[middle]; // MISRA D-002
        const std::uint32_t order = OrderOf(object.index, object.sub);
        if (order == wanted)
        {
            return &object;
        }
        if (order < wanted)
        {
            low = middle + 1U;
        }
        else
        {
            high = middle;
        }
    }
    return nullptr;
}

ObjectPlace Locate(const DeviceConfig& config, const ObjectAddress& address) noexcept
{
    if (address.index == kGfcIndex)
    {
        return LocateSingle(ConfigField::kGfcParameter, ObjectKind::kConfiguration, address.sub);
    }
    if (address.index == kConfigurationValidIndex)
    {
        return LocateSingle(ConfigField::kConfigurationValid, ObjectKind::kConfigurationValid, address.sub);
    }
    if (address.index == kSignatureIndex)
    {
        return LocateSignature(config, address.sub);
    }
    const SlotIndex communication = SlotOf(config, NumberIn(address.index, kCommunicationBase));
    if (communication != kNoSlot)
    {
        return LocateCommunication(communication, address.sub);
    }
    const SlotIndex mapping = SlotOf(config, NumberIn(address.index, kMappingBase));
    if (mapping != kNoSlot)
    {
        return LocateMapping(mapping, address.sub);
    }
    return LocateVariable(config, address);
}

} // namespace counterpoint
