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
constexpr std::uint32_t kAnySub = 0xFFU;

// Sizes of sub-index 0 to 6 of 1301h to 1340h; from 1 on the fields are numbered likewise.
constexpr std::uint8_t kCommunicationBytes[kCommunicationSubs + 1U] = {1U, 1U, 2U, 1U, 1U, 4U, 4U}; // MISRA D-001
static_assert(static_cast<std::uint8_t>(ConfigField::kCobId2) == kCommunicationSubs, "field n is sub-index n");

// Lengths of the dummies 0001h to 0007h.
constexpr std::uint8_t kDummyBits[kLastDummyIndex] = {1U, 8U, 16U, 32U, 8U, 16U, 32U}; // MISRA D-001

constexpr std::uint8_t kEntryBytes = 4U;
constexpr std::uint8_t kSignatureBytes = 2U;

/// A place while it is looked for.
struct Search
{
    ObjectPlace& place;
    std::uint32_t sub;
    std::uint32_t highest; ///< Greatest sub-index that there is.
    bool is_counted;       ///< Sub-index 0 is a constant: the greatest sub-index.
};

void Found(Search& search, const ObjectKind kind, const ConfigField field) noexcept
{
    search.place.kind = kind;
    search.place.item.address.field = field;
}

void FindCommunication(Search& search) noexcept
{
    search.highest = kCommunicationSubs;
    search.is_counted = true;
    if (search.sub <= kCommunicationSubs)
    {
        Found(search, ObjectKind::kConfiguration, static_cast<ConfigField>(search.sub));
        search.place.size_bytes = kCommunicationBytes[search.sub]; // MISRA D-002
    }
}

void FindMapping(Search& search, const DeviceConfig& config) noexcept
{
    const StaticMap& map = config.srdos[search.place.item.address.slot].map; // MISRA D-002
    const bool is_fixed = map.entries != nullptr;
    search.highest = is_fixed ? map.count : config.map_entries;
    Found(search, is_fixed ? ObjectKind::kFixed : ObjectKind::kConfiguration, ConfigField::kMapCount);
    if (search.sub != 0U)
    {
        search.place.item.address.field = ConfigField::kMapEntry;
        search.place.item.address.sub = static_cast<std::uint8_t>(search.sub);
        search.place.size_bytes = kEntryBytes;
    }
}

void FindSignature(Search& search, const DeviceConfig& config) noexcept
{
    search.highest = config.srdos[config.srdo_count - 1U].number; // MISRA D-002
    search.is_counted = true;
    search.place.item.address.slot = SlotOf(config, SrdoNumber{search.sub});
    search.place.size_bytes = kSignatureBytes;
    const bool is_gap = search.place.item.address.slot == kNoSlot;
    Found(search, is_gap ? ObjectKind::kGapSignature : ObjectKind::kConfiguration,
          is_gap ? ConfigField::kInvalid : ConfigField::kSignature);
}

// No SRDO has the number 0 or one above 64: what lies between the two areas leads to none.
void FindSrdo(Search& search, const DeviceConfig& config, const std::uint32_t area) noexcept
{
    search.place.item.address.slot = SlotOf(config, SrdoNumber{area & kNumberOfArea});
    if (search.place.item.address.slot == kNoSlot)
    {
        search.highest = kAnySub;
    }
    else if (area < kMappingOfArea)
    {
        FindCommunication(search);
    }
    else
    {
        FindMapping(search, config);
    }
}

void FindVariable(Search& search, const DeviceConfig& config, const ObjectKey key) noexcept
{
    const MappableObject* const object = FindObject(config, key);
    search.highest = kAnySub;
    if (object != nullptr)
    {
        const std::uint32_t size_bytes = (object->length_bits + (kBitsPerByte - 1U)) / kBitsPerByte;
        search.place.kind = ObjectKind::kVariable;
        search.place.size_bytes = static_cast<std::uint8_t>(size_bytes);
        search.place.variable = object;
    }
}

} // namespace

// Numbers ascend from 1: SRDO n is in slot n - 1 where nothing is missing before it, and below where something is.
SlotIndex SlotOf(const DeviceConfig& config, const SrdoNumber number) noexcept
{
    const std::uint32_t place = number.value - 1U;
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

const MappableObject* FindObject(const DeviceConfig& config, const ObjectKey key) noexcept
{
    std::uint32_t low = 0U;
    std::uint32_t high = config.object_count;
    while (low < high)
    {
        const std::uint32_t middle = (low + high) / 2U;
        const MappableObject& object = config.objects[middle]; // MISRA D-002
        const std::uint32_t order = KeyOf(ObjectAddress{object.index, object.sub}).value;
        if (order == key.value)
        {
            return &object;
        }
        if (order < key.value)
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

// index 0001h to 0007h, sub-index 0, the length of the data type
bool IsDummy(const std::uint32_t entry) noexcept
{
    const std::uint32_t type = (entry >> 16U) - 1U;
    return (type < kLastDummyIndex) && ((entry & 0xFFFFU) == kDummyBits[type]); // MISRA D-002
}

std::uint32_t ToValue(const ObjectData& data) noexcept
{
    std::uint32_t value = 0U;
    for (std::uint32_t byte = data.size_bytes; byte != 0U; --byte)
    {
        value = (value << kBitsPerByte) | data.bytes[byte - 1U]; // MISRA D-002
    }
    return value;
}

// 1300h       1301h to 1340h     1381h to 13C0h    13FEh    13FFh
// GFC         communication      mapping           valid    signatures     what else there is are variables
ObjectPlace Locate(const DeviceConfig& config, const ObjectKey key) noexcept
{
    const std::uint32_t area = (key.value >> kBitsPerByte) - kSafetyBase;
    ObjectPlace found{};
    found.refusal = AbortCode::kObjectUnknown;
    found.size_bytes = 1U;
    Search search{found, key.value & kAnySub, 0U, false};
    if (area > kLastOfArea)
    {
        FindVariable(search, config, key);
    }
    else if (area == kLastOfArea)
    {
        FindSignature(search, config);
    }
    else if (area == kValidOfArea)
    {
        Found(search, ObjectKind::kConfigurationValid, ConfigField::kConfigurationValid);
    }
    else if ((area == 0U) && (config.gfc == GfcUse::kPresent))
    {
        Found(search, ObjectKind::kConfiguration, ConfigField::kGfcParameter);
    }
    else
    {
        FindSrdo(search, config, area);
    }

    if (search.sub > search.highest)
    {
        search.place.kind = ObjectKind::kInvalid;
        search.place.refusal = AbortCode::kSubUnknown;
    }
    if (search.is_counted && (search.sub == 0U))
    {
        Found(search, ObjectKind::kConstant, ConfigField::kInvalid);
        search.place.size_bytes = 1U;
        search.place.constant = static_cast<std::uint8_t>(search.highest);
    }
    return found;
}

} // namespace counterpoint
