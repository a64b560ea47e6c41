// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/object_access.hpp"

namespace counterpoint
{

const DeviceConfig kNoDevice{};

namespace
{

constexpr std::uint32_t kSafetyBase = 0x1300U;
constexpr std::uint32_t kLastOfArea = 0xFFU;  ///< 13FFh: signatures.
constexpr std::uint32_t kValidOfArea = 0xFEU; ///< 13FEh.
constexpr std::uint32_t kMappingOfArea = 0x80U;
constexpr std::uint32_t kNumberOfArea = 0x7FU;
constexpr std::uint32_t kBitsPerByte = 8U;

// Sizes of sub-index 1 to 6 of 1301h to 1340h, whose fields are numbered likewise.
constexpr std::uint8_t kCommunicationBytes[kCommunicationSubs] = {1U, 2U, 1U, 1U, 4U, 4U}; // MISRA D-001
static_assert(static_cast<std::uint8_t>(ConfigField::kCobId2) == kCommunicationSubs, "field n is sub-index n");

// Lengths of the dummies 0001h to 0007h.
constexpr std::uint8_t kDummyBits[kLastDummyIndex] = {1U, 8U, 16U, 32U, 8U, 16U, 32U}; // MISRA D-001

constexpr std::uint8_t kEntryBytes = 4U;
constexpr std::uint8_t kSignatureBytes = 2U;

ObjectPlace Missing(const AbortCode refusal) noexcept
{
    ObjectPlace place{};
    place.refusal = refusal;
    return place;
}

ObjectPlace Placed(const ObjectKind kind, const ConfigAddress& address, const std::uint8_t size_bytes) noexcept
{
    ObjectPlace place{};
    place.kind = kind;
    place.config = address;
    place.size_bytes = size_bytes;
    return place;
}

ObjectPlace Constant(const std::uint8_t value) noexcept
{
    ObjectPlace place = Placed(ObjectKind::kConstant, {}, 1U);
    place.constant = value;
    return place;
}

ObjectPlace LocateCommunication(const SlotIndex slot, const std::uint8_t sub) noexcept
{
    if (sub == 0U)
    {
        return Constant(kCommunicationSubs);
    }
    if (sub > kCommunicationSubs)
    {
        return Missing(AbortCode::kSubUnknown);
    }
    return Placed(ObjectKind::kConfiguration, {slot, static_cast<ConfigField>(sub), 0U},
                  kCommunicationBytes[sub - 1U]); // MISRA D-002
}

ObjectPlace LocateMapping(const DeviceConfig& config, const SlotIndex slot, const std::uint8_t sub) noexcept
{
    const StaticMap& map = config.srdos[slot].map; // MISRA D-002
    const bool is_fixed = map.entries != nullptr;
    if (sub > (is_fixed ? map.count : config.map_entries))
    {
        return Missing(AbortCode::kSubUnknown);
    }
    const ObjectKind kind = is_fixed ? ObjectKind::kFixed : ObjectKind::kConfiguration;
    return (sub == 0U) ? Placed(kind, {slot, ConfigField::kMapCount, 0U}, 1U)
                       : Placed(kind, {slot, ConfigField::kMapEntry, sub}, kEntryBytes);
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
        return Missing(AbortCode::kSubUnknown);
    }
    const SlotIndex slot = SlotOf(config, SrdoNumber{sub});
    return (slot == kNoSlot) ? Placed(ObjectKind::kGapSignature, {}, kSignatureBytes)
                             : Placed(ObjectKind::kConfiguration, {slot, ConfigField::kSignature, 0U}, kSignatureBytes);
}

// 1300h and 13FEh have sub-index 0 only.
ObjectPlace LocateSingle(const ObjectKind kind, const ConfigField field, const std::uint8_t sub) noexcept
{
    return (sub == 0U) ? Placed(kind, {0U, field, 0U}, 1U) : Missing(AbortCode::kSubUnknown);
}

ObjectPlace LocateVariable(const DeviceConfig& config, const ObjectAddress& address) noexcept
{
    const MappableObject* const object = FindObject(config, address);
    if (object == nullptr)
    {
        return Missing(AbortCode::kObjectUnknown);
    }
    const std::uint32_t size_bytes = (object->length_bits + (kBitsPerByte - 1U)) / kBitsPerByte;
    ObjectPlace place = Placed(ObjectKind::kVariable, {}, static_cast<std::uint8_t>(size_bytes));
    place.variable = object;
    return place;
}

// Ascending order of the table of objects: index and sub-index as in a mapping entry.
const MappableObject* Find(const DeviceConfig& config, const std::uint32_t wanted) noexcept
{
    std::uint32_t low = 0U;
    std::uint32_t high = config.object_count;
    while (low < high)
    {
        const std::uint32_t middle = (low + high) / 2U;
        const MappableObject& object = config.objects[middle]; // MISRA D-002
        const std::uint32_t order = (static_cast<std::uint32_t>(object.index) << kBitsPerByte) | object.sub;
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

} // namespace

// Numbers ascend from 1: SRDO n is in slot n - 1 where nothing is missing before it, and below where something is.
SlotIndex SlotOf(const DeviceConfig& config, const SrdoNumber number) noexcept
{
    const std::uint32_t place = static_cast<std::uint32_t>(number.value) - 1U;
    if (config.gaps != NumberGaps::kSearched)
    {
        return (place < config.srdo_count) ? static_cast<SlotIndex>(place) : kNoSlot;
    }
    for (SlotIndex slot = 0U; slot < config.srdo_count; ++slot)
    {
        if (config.srdos[slot].number == number.value) // MISRA D-002
        {
            return slot;
        }
    }
    return kNoSlot;
}

const MappableObject* FindObject(const DeviceConfig& config, const ObjectAddress& address) noexcept
{
    return Find(config, (static_cast<std::uint32_t>(address.index) << kBitsPerByte) | address.sub);
}

const MappableObject* FindMapped(const DeviceConfig& config, const std::uint32_t entry) noexcept
{
    return Find(config, entry >> kBitsPerByte);
}

// index 0001h to 0007h, sub-index 0, the length of the data type
bool IsDummy(const std::uint32_t entry) noexcept
{
    const std::uint32_t type = (entry >> 16U) - 1U;
    return (type < kLastDummyIndex) && ((entry & 0xFFFFU) == kDummyBits[type]); // MISRA D-002
}

// 1300h       1301h to 1340h     1381h to 13C0h    13FEh    13FFh
// GFC         communication      mapping           valid    signatures     what else there is are variables
ObjectPlace Locate(const DeviceConfig& config, const ObjectAddress& address) noexcept
{
    const std::uint32_t area = static_cast<std::uint32_t>(address.index) - kSafetyBase;
    if (area > kLastOfArea)
    {
        return LocateVariable(config, address);
    }
    if (area == kLastOfArea)
    {
        return LocateSignature(config, address.sub);
    }
    if (area == kValidOfArea)
    {
        return LocateSingle(ObjectKind::kConfigurationValid, ConfigField::kConfigurationValid, address.sub);
    }
    if ((area == 0U) && (config.gfc == GfcUse::kPresent))
    {
        return LocateSingle(ObjectKind::kConfiguration, ConfigField::kGfcParameter, address.sub);
    }
    // No SRDO has the number 0 or one above 64: what lies between the two areas leads to none.
    const SlotIndex slot = SlotOf(config, SrdoNumber{static_cast<std::uint8_t>(area & kNumberOfArea)});
    if (slot == kNoSlot)
    {
        return Missing(AbortCode::kObjectUnknown);
    }
    return (area < kMappingOfArea) ? LocateCommunication(slot, address.sub) : LocateMapping(config, slot, address.sub);
}

} // namespace counterpoint
