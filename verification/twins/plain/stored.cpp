// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Power-on configuration, Store and Load. [SRS_CFG_002, SRS_CFG_003]
#include "verification/twins/plain/point.hpp"
#include "verification/twins/plain/record.hpp"

namespace counterpoint::twins::plain
{

namespace
{
const Number kDefaultDirection{"SRS_CFG_002", "direction"};
const Number kDefaultType{"SRS_CFG_002", "transmission type"};
const Number kDefaultSrvt{"SRS_CFG_002", "SRVT"};
const Number kDefaultSct{"SRS_CFG_002", "SCT"};
const Number kDefaultSctOfSome{"SRS_CFG_002", "SCT of SRDO 1 of node-ID 33 to 64"};
const Number kDefaultCob1{"SRS_CFG_002", "COB-ID 1"};
const Number kDefaultCob2{"SRS_CFG_002", "COB-ID 2"};
const Decision kIsNumberOne{"SRS_CFG_002", "SRDO 1"};
const Decision kIsLowNode{"SRS_CFG_002", "node-ID 1 to 64"};
const Decision kIsUpperHalf{"SRS_CFG_002", "node-ID 33 to 64"};
const Number kLastNode{"SRS_CFG_002", "last node-ID of the default connection set"};
const Number kFirstUpper{"SRS_CFG_002", "first node-ID with the longer time"};
const Number kDefaultCount{"SRS_CFG_002", "map count"};
const Number kDefaultEntry{"SRS_CFG_002", "map entries"};
const Number kDefaultSignature{"SRS_CFG_002", "signature"};
const Number kRoomOfDynamic{"SRS_CFG_003", "entries of a dynamic mapping"};
const Number kRoomOfStatic{"SRS_CFG_032", "entries of a static mapping"};
const Decision kStatic{"SRS_CFG_032", "the mapping is static"};
const Decision kStaticCount{"SRS_CFG_003", "map count of a static mapping"};
const Decision kStaticEntry{"SRS_CFG_003", "entry of a static mapping"};
const Decision kStaticStore{"SRS_CFG_003", "Store has no effect on a static mapping"};
const Decision kAboveCount{"SRS_CFG_003", "an entry above the count of a static mapping is 0"};
const Decision kSlotExists{"SRS_CFG_003", "the slot exists"};
const Decision kSubFirst{"SRS_CFG_003", "a map entry is not below 1"};
const Decision kSubLast{"SRS_CFG_003", "a map entry is not above map_entries"};
const Number kSub{"SRS_CFG_003", "number of a map entry"};
const Place kUnresolvedSlot{"SRS_CFG_003", "slot that storing makes unresolved"};
const Act kUnresolves{"SRS_CFG_003", "storing makes the mapping unresolved"};
const Decision kSignatureStays{"SRS_CFG_003", "storing the signature leaves the mapping resolved"};
const Decision kNoEntryStays{"SRS_CFG_003", "storing an entry that there is none of leaves the mapping resolved"};
const Decision kStaticStays{"SRS_CFG_003", "storing an entry of a static mapping leaves it resolved"};
const Number kStaticBoth{"SRS_CFG_032", "count of a static mapping"};
const Number kStaticDeclared{"SRS_CFG_032", "count of a static mapping in the rules"};
const Number kStaticExisting{"SRS_CFG_032", "entries of a static mapping that exist"};
const Number kDeclared{"SRS_CFG_026", "map count in the rules"};
const Number kExisting{"SRS_CFG_020", "entries of the map count that exist"};
const Lesser kRoomOfCount{"SRS_CFG_020", "map count, and map_entries"};
const Decision kNotExchanged{"SRS_CFG_020", "the map count and the entries that exist in their places"};
const Decision kStaticCut{"SRS_CFG_020", "the cut count of a static mapping is for the signature alone"};
const Act kSlotLast{"SRS_CFG_003", "srdo_count itself is no slot"};
const Act kSlotLastLoaded{"SRS_CFG_003", "srdo_count itself is no slot of Load"};
const Place kSlot{"SRS_CFG_003", "slot of Store"};
const Place kLoadSlot{"SRS_CFG_003", "slot of Load"};

const Number kFirstStored{"SRS_CFG_003", "first map entry that is stored"};
const Number kFirstLoaded{"SRS_CFG_003", "first map entry that is loaded"};
const Number kLastStored{"SRS_CFG_003", "last map entry that is stored"};
const Number kLastLoaded{"SRS_CFG_003", "last map entry that is loaded"};
const Place kRoomStored{"SRS_CFG_003", "slot whose room for entries counts when one is stored"};
const Place kRoomLoaded{"SRS_CFG_003", "slot whose room for entries counts when one is loaded"};
const Place kStaticOf{"SRS_CFG_003", "slot that is asked for a static mapping when something is stored"};
const Number kFirstSub{"SRS_CFG_003", "first map entry"};
const Number kLastSub{"SRS_CFG_003", "last map entry"};
const Place kEntrySlot{"SRS_CFG_003", "slot of a map entry that is stored"};
const Place kEntryLoadSlot{"SRS_CFG_003", "slot of a map entry that is loaded"};
const Place kCountLoadSlot{"SRS_CFG_003", "slot of a map count that is loaded"};

std::uint8_t LowByte(std::uint32_t value) noexcept
{
    return static_cast<std::uint8_t>(value & 0xFFU);
}

bool IsSlot(const Common& common, SlotIndex slot, bool is_limit_refused) noexcept
{
    const std::uint32_t count = common.config.srdo_count;
    return (slot < count) || ((slot == count) && !(kSlotLast() && is_limit_refused));
}

bool IsStatic(const Record& record) noexcept
{
    return kStatic(record.setup.map.entries != nullptr) && (record.setup.map.entries != nullptr);
}

bool IsEntry(const Common& common, const Record& record, std::uint32_t sub, bool is_stored) noexcept
{
    const std::uint32_t first = kFirstSub(is_stored ? kFirstStored(1U) : kFirstLoaded(1U));
    const std::uint32_t room = RoomOf(common, record);
    const std::uint32_t last = kLastSub(is_stored ? kLastStored(room) : kLastLoaded(room));
    return kSubFirst(sub >= first) && kSubLast(sub <= last) && (sub >= 1U) && (sub <= kMaxMapEntries);
}

/// @return Whether anything was kept.
bool Keep(const Common& common, const Record* records, Record& record, const ConfigItem& item) noexcept
{
    const std::uint32_t value = item.value;
    Stored& stored = record.stored;
    const bool is_static = IsStatic(records[kStaticOf(item.address.slot)]) && kStaticStore(true);
    switch (item.address.field)
    {
    case ConfigField::kDirection:
        stored.direction = LowByte(value);
        break;
    case ConfigField::kSct:
        stored.sct_ms = static_cast<std::uint16_t>(value & 0xFFFFU);
        break;
    case ConfigField::kSrvt:
        stored.srvt_ms = LowByte(value);
        break;
    case ConfigField::kTransmissionType:
        stored.transmission_type = LowByte(value);
        break;
    case ConfigField::kCobId1:
        stored.cob_id_1 = value;
        break;
    case ConfigField::kCobId2:
        stored.cob_id_2 = value;
        break;
    case ConfigField::kMapCount:
        stored.map_count = is_static ? stored.map_count : LowByte(value);
        return (!is_static) || (!kStaticStays(true));
    case ConfigField::kMapEntry:
    {
        const std::uint32_t sub = kSub(item.address.sub);
        const bool is_kept = (!is_static) && IsEntry(common, records[kRoomStored(item.address.slot)], sub, true);
        if (is_kept)
        {
            record.entries[sub - 1U] = value;
        }
        return is_kept || (is_static && (!kStaticStays(true))) || (!kNoEntryStays(true));
    }
    case ConfigField::kSignature:
        stored.signature = static_cast<std::uint16_t>(value & 0xFFFFU);
        return !kSignatureStays(true);
    case ConfigField::kInvalid:
    case ConfigField::kGfcParameter:
    case ConfigField::kConfigurationValid:
    default:
        return false;
    }
    return true;
}

} // namespace

void SetDefaults(const DeviceConfig& config, Record& record) noexcept
{
    record.stored = Stored{};
    Stored& stored = record.stored;
    stored.direction = kDefaultDirection(std::uint8_t{0U});
    stored.transmission_type = kDefaultType(std::uint8_t{254U});
    stored.srvt_ms = kDefaultSrvt(std::uint8_t{20U});
    stored.sct_ms = kDefaultSct(std::uint16_t{25U});
    stored.map_count = kDefaultCount(std::uint8_t{0U});
    stored.signature = kDefaultSignature(std::uint16_t{0U});
    for (std::uint32_t i = 0U; i < kMaxMapEntries; ++i)
    {
        record.entries[i] = kDefaultEntry(0U);
    }
    const std::uint32_t node = config.node_id;
    const bool is_default = kIsNumberOne(record.setup.number == 1U) && kIsLowNode(node <= kLastNode(64U));
    if (is_default)
    {
        stored.cob_id_1 = kDefaultCob1(0xFFU + (2U * node));
        stored.cob_id_2 = kDefaultCob2(0x100U + (2U * node));
        stored.sct_ms = kIsUpperHalf(node >= kFirstUpper(33U)) ? kDefaultSctOfSome(std::uint16_t{50U}) : stored.sct_ms;
    }
}

std::uint32_t RoomOf(const Common& common, const Record& record) noexcept
{
    return IsStatic(record) ? kRoomOfStatic(std::uint32_t{kMaxMapEntries})
                            : kRoomOfDynamic(std::uint32_t{common.config.map_entries});
}

std::uint32_t CountOf(const Record& record) noexcept
{
    return (IsStatic(record) && kStaticCount(true)) ? record.setup.map.count : record.stored.map_count;
}

namespace
{
/// The map count as it is told, and how many entries there are of it.
struct Counts
{
    std::uint32_t declared;
    std::uint32_t existing;
};

Counts CountsOf(const Common& common, const Record& record) noexcept
{
    const std::uint32_t count = CountOf(record);
    const std::uint32_t lesser = kRoomOfCount(count, RoomOf(common, record));
    if (IsStatic(record))
    {
        const bool is_cut_right = kStaticCut(true);
        return Counts{kStaticDeclared(kStaticBoth(is_cut_right ? count : lesser)),
                      kStaticExisting(kStaticBoth(is_cut_right ? lesser : count))};
    }
    const bool is_right = kNotExchanged(true);
    return Counts{kDeclared(is_right ? count : lesser), kExisting(is_right ? lesser : count)};
}
} // namespace

std::uint32_t ExistingOf(const Common& common, const Record& record) noexcept
{
    return CountsOf(common, record).existing;
}

std::uint32_t DeclaredOf(const Common& common, const Record& record) noexcept
{
    return CountsOf(common, record).declared;
}

std::uint32_t EntryOf(const Record& record, std::uint32_t number) noexcept
{
    if (IsStatic(record) && kStaticEntry(true))
    {
        const bool is_above = kAboveCount(number > record.setup.map.count) || (number > record.setup.map.count);
        return is_above ? 0U : record.setup.map.entries[number - 1U];
    }
    return ((number >= 1U) && (number <= kMaxMapEntries)) ? record.entries[number - 1U] : 0U;
}

namespace
{
std::uint32_t LoadedCountOf(const Record& record) noexcept
{
    const std::uint32_t count = CountOf(record);
    const bool is_whole = (!IsStatic(record)) || kStaticCut(true);
    return (is_whole || (count < kMaxMapEntries)) ? count : kMaxMapEntries;
}
} // namespace

void Store(Common& common, Record* records, const ConfigItem& item) noexcept
{
    if (item.address.field == ConfigField::kGfcParameter)
    {
        common.gfc_parameter = LowByte(item.value);
        return;
    }
    if (item.address.field == ConfigField::kConfigurationValid)
    {
        common.configuration_valid = LowByte(item.value);
        return;
    }
    const bool exists = kSlotExists(IsSlot(common, item.address.slot, true));
    if ((!exists) || (item.address.slot >= kMaxSrdoCount))
    {
        return;
    }
    const bool is_entry = item.address.field == ConfigField::kMapEntry;
    Record& record = records[is_entry ? kEntrySlot(item.address.slot) : kSlot(item.address.slot)];
    if (Keep(common, records, record, item) && kUnresolves())
    {
        Record& unresolved = is_entry ? records[kUnresolvedSlot(kEntrySlot(item.address.slot))]
                                      : records[kUnresolvedSlot(kSlot(item.address.slot))];
        unresolved.is_resolved = false;
        unresolved.is_sound = false;
    }
}

std::uint32_t Load(const Common& common, const Record* records, const ConfigAddress& address) noexcept
{
    if (address.field == ConfigField::kGfcParameter)
    {
        return common.gfc_parameter;
    }
    if (address.field == ConfigField::kConfigurationValid)
    {
        return common.configuration_valid;
    }
    const bool exists = kSlotExists(IsSlot(common, address.slot, kSlotLastLoaded()));
    if ((!exists) || (address.slot >= kMaxSrdoCount))
    {
        return 0U;
    }
    const Record& record = records[kLoadSlot(address.slot)];
    switch (address.field)
    {
    case ConfigField::kDirection:
        return record.stored.direction;
    case ConfigField::kSct:
        return record.stored.sct_ms;
    case ConfigField::kSrvt:
        return record.stored.srvt_ms;
    case ConfigField::kTransmissionType:
        return record.stored.transmission_type;
    case ConfigField::kCobId1:
        return record.stored.cob_id_1;
    case ConfigField::kCobId2:
        return record.stored.cob_id_2;
    case ConfigField::kMapCount:
        return LoadedCountOf(records[kCountLoadSlot(address.slot)]);
    case ConfigField::kMapEntry:
    {
        const std::uint32_t sub = kSub(address.sub);
        return IsEntry(common, records[kRoomLoaded(address.slot)], sub, false)
                   ? EntryOf(records[kEntryLoadSlot(address.slot)], sub)
                   : 0U;
    }
    case ConfigField::kSignature:
        return record.stored.signature;
    case ConfigField::kInvalid:
    case ConfigField::kGfcParameter:
    case ConfigField::kConfigurationValid:
    default:
        return 0U;
    }
}

} // namespace counterpoint::twins::plain
