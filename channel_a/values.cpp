// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/values.hpp"

#include "channel_a/mapping.hpp"

namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint16_t kDefaultSctMs = 25U;
constexpr std::uint16_t kDefaultSctOfConsumerMs = 50U;
constexpr std::uint8_t kDefaultSrvtMs = 20U;
constexpr std::uint8_t kFirstSrdoNumber = 1U;
constexpr std::uint8_t kLastNodeIdOfProducers = 32U;
constexpr std::uint8_t kLastNodeIdWithDefault = 64U;
constexpr std::uint32_t kDefaultIdentifierBase = 0xFFU;
constexpr std::uint32_t kSixteenBits = 0xFFFFU;

std::uint8_t Cut8(const std::uint32_t value) noexcept
{
    return static_cast<std::uint8_t>(value & kByteMask);
}

std::uint16_t Cut16(const std::uint32_t value) noexcept
{
    return static_cast<std::uint16_t>(value & kSixteenBits);
}

// Whether an entry can be stored: only a dynamic mapping has places for them.
bool HasEntry(const Mapping& mapping, const std::uint32_t sub) noexcept
{
    return (mapping.steps != nullptr) && (sub >= 1U) && (sub <= mapping.limit);
}

std::uint32_t& EntryAt(const Voice& voice, const std::size_t slot, const std::uint32_t sub) noexcept
{
    const std::size_t first = slot * voice.storage.map_entries;
    return voice.storage.entries[first + (sub - 1U)]; // MISRA D-002
}

// The fields of the mapping; false: nothing is stored.
bool StoreMapping(const Voice& voice, const ConfigItem& item) noexcept
{
    const std::size_t slot = item.address.slot;
    const Mapping mapping = MappingOf(voice, slot);
    const bool is_count = (item.address.field == ConfigField::kMapCount) && (mapping.steps != nullptr);
    const bool is_entry = (item.address.field == ConfigField::kMapEntry) && HasEntry(mapping, item.address.sub);
    if (is_count)
    {
        voice.storage.counts[slot] = Cut8(item.value); // MISRA D-002
    }
    if (is_entry)
    {
        EntryAt(voice, slot, item.address.sub) = item.value;
    }
    return is_count || is_entry;
}

// Cut to the width of the field; false: nothing is stored.
bool StoreOfSlot(const Voice& voice, const ConfigItem& item) noexcept
{
    Record& record = At(voice, item.address.slot);
    const ConfigField field = item.address.field;
    if (field == ConfigField::kDirection)
    {
        record.grants.Set(Grant::kDirection, Cut8(item.value));
    }
    else if (field == ConfigField::kSct)
    {
        record.values.sct_ms = Cut16(item.value);
    }
    else if (field == ConfigField::kSrvt)
    {
        record.values.srvt_ms = Cut8(item.value);
    }
    else if (field == ConfigField::kTransmissionType)
    {
        record.values.transmission_type = Cut8(item.value);
    }
    else if (field == ConfigField::kCobId1)
    {
        record.values.cob_id[kNormalHalf] = item.value;
    }
    else if (field == ConfigField::kCobId2)
    {
        record.values.cob_id[kInverseHalf] = item.value;
    }
    else if (field == ConfigField::kSignature)
    {
        record.values.signature = Cut16(item.value);
    }
    else
    {
        return StoreMapping(voice, item);
    }
    return true;
}

std::uint32_t LoadMapping(const Voice& voice, const ConfigAddress& address) noexcept
{
    const Mapping mapping = MappingOf(voice, address.slot);
    const std::uint32_t position = address.sub - std::uint32_t{1U};
    // Of a dynamic mapping all entries are there, of a static one as many as it has.
    const std::uint32_t there = (mapping.steps != nullptr) ? mapping.limit : mapping.count;
    if (address.field == ConfigField::kMapCount)
    {
        return mapping.stored_count;
    }
    return ((address.field == ConfigField::kMapEntry) && (position < there)) ? mapping.entries[position] // MISRA D-002
                                                                             : 0U;
}

std::uint32_t LoadOfSlot(const Voice& voice, const ConfigAddress& address) noexcept
{
    const Record& record = At(voice, address.slot);
    const ConfigField field = address.field;
    std::uint32_t value = 0U;
    if (field == ConfigField::kDirection)
    {
        value = record.grants.Of(Grant::kDirection);
    }
    else if (field == ConfigField::kSct)
    {
        value = record.values.sct_ms;
    }
    else if (field == ConfigField::kSrvt)
    {
        value = record.values.srvt_ms;
    }
    else if (field == ConfigField::kTransmissionType)
    {
        value = record.values.transmission_type;
    }
    else if (field == ConfigField::kCobId1)
    {
        value = record.values.cob_id[kNormalHalf];
    }
    else if (field == ConfigField::kCobId2)
    {
        value = record.values.cob_id[kInverseHalf];
    }
    else if (field == ConfigField::kSignature)
    {
        value = record.values.signature;
    }
    else
    {
        value = LoadMapping(voice, address);
    }
    return value;
}

} // namespace

void SetDefaults(Record& record, const std::uint8_t number, const std::uint8_t node_id) noexcept
{
    record.values.sct_ms = kDefaultSctMs;
    record.values.srvt_ms = kDefaultSrvtMs;
    record.values.transmission_type = kTransmissionTypeAsynchronous;
    if ((number == kFirstSrdoNumber) && (node_id <= kLastNodeIdWithDefault))
    {
        const std::uint32_t identifier = kDefaultIdentifierBase + (2U * std::uint32_t{node_id});
        record.values.cob_id[kNormalHalf] = identifier;
        record.values.cob_id[kInverseHalf] = identifier + 1U;
        record.values.sct_ms = (node_id > kLastNodeIdOfProducers) ? kDefaultSctOfConsumerMs : kDefaultSctMs;
    }
}

// Whatever is stored of a slot but its signature makes its mapping unresolved. [SRS_CFG_003]
void StoreValue(Voice& voice, const ConfigItem& item) noexcept
{
    if (item.address.field == ConfigField::kGfcParameter)
    {
        voice.gfc_parameter = Cut8(item.value);
        return;
    }
    if (item.address.field == ConfigField::kConfigurationValid)
    {
        voice.configuration_valid = Cut8(item.value);
        return;
    }
    if ((item.address.slot >= voice.count) || !StoreOfSlot(voice, item))
    {
        return;
    }
    Record& record = At(voice, item.address.slot);
    Demand(record, kLook);
    if (item.address.field != ConfigField::kSignature)
    {
        record.grants.Set(Grant::kResolved, kNo);
    }
}

std::uint32_t LoadValue(const Voice& voice, const ConfigAddress& address) noexcept
{
    if (address.field == ConfigField::kGfcParameter)
    {
        return voice.gfc_parameter;
    }
    if (address.field == ConfigField::kConfigurationValid)
    {
        return voice.configuration_valid;
    }
    return (address.slot < voice.count) ? LoadOfSlot(voice, address) : 0U;
}

void StoreFields(const Voice& voice, const std::size_t slot, const StaticFields& fields) noexcept
{
    if (MappingOf(voice, slot).steps == nullptr)
    {
        At(voice, slot).fields = fields;
        At(voice, slot).grants.Set(Grant::kResolved, kNo);
    }
}

} // namespace counterpoint::channel_a
