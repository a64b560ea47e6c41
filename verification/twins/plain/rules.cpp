// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Rules of the configuration, in the order of SRS_CFG_020.
#include "verification/twins/plain/point.hpp"
#include "verification/twins/plain/record.hpp"

namespace counterpoint::twins::plain
{

namespace
{
const Decision kOff{"SRS_CFG_020", "direction 0 is checked by its signature alone"};
const Decision kDirection{"SRS_CFG_021", "direction above 2"};
const Number kLastDirection{"SRS_CFG_021", "highest direction"};
const Decision kType{"SRS_CFG_022", "transmission type other than 254"};
const Number kTheType{"SRS_CFG_022", "the transmission type"};
const Decision kIdLow{"SRS_CFG_023", "COB-ID 1 below 101h"};
const Decision kIdHigh{"SRS_CFG_023", "COB-ID 1 above 17Fh"};
const Number kFirstId{"SRS_CFG_023", "lowest COB-ID 1"};
const Number kLastId{"SRS_CFG_023", "highest COB-ID 1"};
const Decision kIdEven{"SRS_CFG_023", "COB-ID 1 even"};
const Decision kIdNext{"SRS_CFG_023", "COB-ID 2 is not COB-ID 1 + 1"};
const Number kIdBoth{"SRS_CFG_023", "COB-ID 1 + 1"};
const Act kIdReserved{"SRS_CFG_023", "reserved bits count"};
const Decision kUse11{"SRS_CFG_024", "COB-ID 1 equal to COB-ID 1 of another"};
const Decision kUse12{"SRS_CFG_024", "COB-ID 1 equal to COB-ID 2 of another"};
const Decision kUse21{"SRS_CFG_024", "COB-ID 2 equal to COB-ID 1 of another"};
const Decision kUse22{"SRS_CFG_024", "COB-ID 2 equal to COB-ID 2 of another"};
const Decision kUseOther{"SRS_CFG_024", "another SRDO"};
const Decision kUseOn{"SRS_CFG_024", "the other's direction is not 0"};
const Decision kUse{"SRS_CFG_024", "identifier in use"};
const Number kUseFirst{"SRS_CFG_024", "first SRDO looked at"};
const Number kUseCount{"SRS_CFG_024", "SRDOs looked at"};
const Decision kTimingConsumer{"SRS_CFG_025", "direction 2"};
const Decision kTimingProducer{"SRS_CFG_025", "direction 1"};
const Decision kSrvtLeast{"SRS_CFG_025", "SRVT below 1"};
const Decision kSrvtMost{"SRS_CFG_025", "SRVT not below SCT"};
const Act kSrvtEqual{"SRS_CFG_025", "SRVT equal to SCT is refused"};
const Number kSrvtOne{"SRS_CFG_025", "least SRVT"};
const Decision kRefresh{"SRS_CFG_025", "refresh time shorter than the cycle"};
const Act kRefreshEqual{"SRS_CFG_025", "a refresh time of one cycle is accepted"};
const Milliseconds kRefreshUs{"SRS_CFG_025", "refresh time, in microseconds"};
const Decision kCountZero{"SRS_CFG_026", "map count 0"};
const Decision kCountOdd{"SRS_CFG_026", "map count odd"};
const Decision kCountAbove{"SRS_CFG_026", "map count above map_entries"};
const Number kCountRoom{"SRS_CFG_026", "map_entries"};
const Decision kObject{"SRS_CFG_027", "an object of the device"};
const Decision kObjectIndex{"SRS_CFG_027", "index of the object"};
const Decision kObjectSub{"SRS_CFG_027", "sub-index of the object"};
const Number kObjectFirst{"SRS_CFG_027", "first object looked at"};
const Number kObjectCount{"SRS_CFG_027", "objects looked at"};
const Decision kAccess{"SRS_CFG_027", "access fits the direction"};
const Decision kLength{"SRS_CFG_027", "exactly its length"};
const Decision kGranularity{"SRS_CFG_027", "length is a multiple of the granularity"};
const Decision kMultiple{"SRS_CFG_027", "length of any entry is a multiple of the granularity"};
const Number kRemainder{"SRS_CFG_027", "what a length is above a multiple of the granularity"};
const Decision kGranularityDummy{"SRS_CFG_027", "length of a dummy is a multiple of the granularity"};
const Number kGranularityBits{"SRS_CFG_027", "granularity"};
const Decision kPairLength{"SRS_CFG_027", "both of a pair have equal length"};
const Decision kNamedTwice{"SRS_CFG_027", "an object is named twice"};
const Decision kTwiceDummy{"SRS_CFG_027", "a dummy may be named twice"};
const Act kTwiceIndex{"SRS_CFG_027", "index of an object named twice"};
const Act kTwiceSub{"SRS_CFG_027", "sub-index of an object named twice"};
const Number kTwiceFirst{"SRS_CFG_027", "first entry of those named twice"};
const Number kEntriesFirst{"SRS_CFG_027", "first entry looked at"};
const Number kEntriesLast{"SRS_CFG_027", "last entry looked at"};
const Decision kTotal{"SRS_CFG_028", "more than 64 bits"};
const Number kTotalBits{"SRS_CFG_028", "most bits"};
const Number kTotalSum{"SRS_CFG_028", "sum of the lengths"};
const Decision kShared{"SRS_CFG_037", "a shared object"};
const Decision kSharedLower{"SRS_CFG_037", "an SRDO of a lower slot"};
const Act kSharedOnlyLower{"SRS_CFG_037", "the SRDO itself is none of a lower slot"};
const Decision kSharedOn{"SRS_CFG_037", "the other's direction is not 0"};
const Decision kSharedConsumer{"SRS_CFG_037", "this one is a consumer"};
const Decision kSharedOther{"SRS_CFG_037", "the other is a consumer"};
const Decision kSharedDummy{"SRS_CFG_037", "a dummy may be shared"};
const Act kSharedIndex{"SRS_CFG_037", "index of a shared object"};
const Act kSharedSub{"SRS_CFG_037", "sub-index of a shared object"};
const Act kSharedCut{"SRS_CFG_037", "only entries that exist count"};
const Number kSharedFirst{"SRS_CFG_037", "first SRDO looked at"};
const Number kSharedFirstEntry{"SRS_CFG_037", "first entry of the other"};
const Number kSharedLastEntry{"SRS_CFG_037", "last entry of the other"};
const Number kSharedFirstOwn{"SRS_CFG_037", "first own entry"};
const Number kSharedLastOwn{"SRS_CFG_037", "last own entry"};
const Decision kSignature{"SRS_CFG_029", "computed signature unequal to the stored one"};
const Number kTold{"SRS_CFG_020", "signature that is told"};
const Decision kFieldsNormal{"SRS_CFG_032", "the normal field is registered"};
const Decision kFieldsInverse{"SRS_CFG_032", "the inverse field is registered"};
const Decision kFieldsBegin{"SRS_CFG_032", "the field begins at the first normal object"};
const Decision kFieldsBeginInverse{"SRS_CFG_032", "the field begins at the first inverse object"};
const Decision kFieldsNext{"SRS_CFG_032", "the normal objects lie one behind the other"};
const Decision kFieldsNextInverse{"SRS_CFG_032", "the inverse objects lie one behind the other"};
const Decision kFieldsBytes{"SRS_CFG_032", "lengths in whole bytes"};
const Decision kFieldsDummy{"SRS_CFG_032", "a static mapping has no dummies"};
const Decision kDummies{"SRS_CFG_033", "dummies are allowed"};
const Decision kDummyConsumer{"SRS_CFG_033", "a dummy of a consumer"};
const Decision kDummyBoth{"SRS_CFG_033", "both of a pair are dummies"};
const Decision kDummySub{"SRS_CFG_033", "sub-index 0 of a dummy"};
const Decision kDummyBits{"SRS_CFG_033", "bits of a dummy"};
const Decision kDummyForm{"SRS_CFG_033", "sub-index 0 and the bits of a dummy"};
const Decision kDummyIs{"SRS_CFG_033", "index of a data type"};
const Number kDummyLast{"SRS_CFG_033", "last index of a data type"};
const Number kDummyFirst{"SRS_CFG_033", "first index of a data type"};
const Act kResolves{"SRS_CFG_003", "Validate resolves the mapping"};
const Act kUnresolves{"SRS_CFG_003", "a Validate with a fault leaves the mapping unresolved"};
const Act kSafe{"SRS_REL_340", "Validate writes the safe value"};
const Decision kSafeConsumer{"SRS_REL_340", "Validate writes the safe value of a consumer only"};
const Act kNotCommitted{"SRS_REL_340", "after a Validate a slot is not committed"};
const Act kSafeMasked{"SRS_CFG_036", "bits of the safe value above the mapped length are 0 in a Validate"};
const Decision kRecheckSignature{"SRS_CFG_030", "computed signature unequal to the stored one"};
const Decision kRecheckOff{"SRS_CFG_030", "direction 0"};
const Decision kRecheckResolved{"SRS_CFG_030", "the mapping is resolved"};
const Act kRecheckTakes{"SRS_CFG_030", "a fault of Recheck makes inactive"};
const Number kRecheckTold{"SRS_CFG_030", "signature that Recheck tells"};
const Act kRecheckSound{"SRS_CONS_002", "a Recheck without fault lets the slot be active"};

const Number kToldDirection{"SRS_CFG_021", "fault that is told for the direction"};
const Number kToldType{"SRS_CFG_022", "fault that is told for the transmission type"};
const Number kToldId{"SRS_CFG_023", "fault that is told for an identifier"};
const Number kToldUse{"SRS_CFG_024", "fault that is told for an identifier in use"};
const Number kToldTiming{"SRS_CFG_025", "fault that is told for timing"};
const Number kToldCount{"SRS_CFG_026", "fault that is told for the map count"};
const Number kToldEntries{"SRS_CFG_027", "fault that is told for an entry"};
const Number kToldTotal{"SRS_CFG_028", "fault that is told for the total length"};
const Number kToldShared{"SRS_CFG_037", "fault that is told for a shared object"};
const Number kToldSignature{"SRS_CFG_029", "fault that is told for the signature"};
const Number kToldRecheck{"SRS_CFG_030", "fault that is told for the signature in a Recheck"};
const Number kToldTable{"SRS_CFG_030", "fault that is told for the mapping in a Recheck"};
const Number kDirectionSays{"SRS_CFG_021", "what the check of the direction says"};
const Number kTypeSays{"SRS_CFG_022", "what the check of the transmission type says"};
const Number kIdSays{"SRS_CFG_023", "what the check of an identifier says"};
const Number kUseSays{"SRS_CFG_024", "what the check of identifiers in use says"};
const Number kTimingSays{"SRS_CFG_025", "what the check of timing says"};
const Number kCountSays{"SRS_CFG_026", "what the check of the map count says"};
const Number kEntriesSay{"SRS_CFG_027", "what the check of the entries says"};
const Number kTotalSays{"SRS_CFG_028", "what the check of the total length says"};
const Number kSharedSays{"SRS_CFG_037", "what the check of shared objects says"};
const Decision kEntryGood{"SRS_CFG_027", "an entry by itself is good"};
const Decision kEntriesCount{"SRS_CFG_026", "the map count is wrong, and no entry without its partner"};
const Each kUseEach{"SRS_CFG_024", "SRDOs that are looked at"};
const Number kUseOwnTwo{"SRS_CFG_024", "COB-ID 2 of the SRDO itself"};
const Number kUseTwo{"SRS_CFG_024", "COB-ID 2 of another"};
const Place kUsePlace{"SRS_CFG_024", "slot of another SRDO"};
const Each kSharedEach{"SRS_CFG_037", "lower slots that are looked at"};
const Place kSharedPlace{"SRS_CFG_037", "lower slot"};
const Place kSharedEntriesOf{"SRS_CFG_037", "lower slot with the entries"};
const Place kSharedOnOf{"SRS_CFG_037", "lower slot with the direction"};
const Either kSharedEither{"SRS_CFG_037", "this one, or the other, is a consumer"};
const Both kSharedRoles{"SRS_CFG_037", "the other is not off, and one of the two is a consumer"};
const Decision kSharedCommon{"SRS_CFG_037", "the two SRDOs name a common object"};
const Decision kSharedNamed{"SRS_CFG_037", "an SRDO of a lower slot names the object"};
const Number kSharedValue{"SRS_CFG_037", "entry that is looked for"};
const Decision kGoodValidate{"SRS_CFG_003", "a Validate without fault of an SRDO that is on"};
const Decision kSoundValidate{"SRS_CFG_003", "a Validate without fault of an SRDO that is on resolves it"};
const Decision kAccessRole{"SRS_CFG_027", "the access of a consumer is wanted"};
const Decision kFieldsGood{"SRS_CFG_032", "the objects are those of the fields"};
const Decision kFieldsStatic{"SRS_CFG_032", "the fields of a static mapping are checked"};
const Decision kDummyAny{"SRS_CFG_033", "an entry is a dummy"};
const Decision kEntriesGood{"SRS_CFG_027", "all entries are good"};
const Decision kPairGood{"SRS_CFG_027", "both of a pair go together"};
const Decision kCountWrong{"SRS_CFG_026", "the map count is wrong"};
const Either kCountOddOrNone{"SRS_CFG_026", "0 or odd"};
const Decision kTimingRole{"SRS_CFG_025", "a consumer's timing"};
const Decision kTimingAny{"SRS_CFG_025", "the timing is wrong"};
const Decision kSharedSame{"SRS_CFG_037", "the objects are the same"};
const Both kSameBoth{"SRS_CFG_027", "index and sub-index are the same"};
const Both kSharedBoth{"SRS_CFG_037", "index and sub-index of a shared object are the same"};
const Number kBitsOf1{"SRS_CFG_033", "bits of 0001h"};
const Number kBitsOf2{"SRS_CFG_033", "bits of 0002h"};
const Number kBitsOf3{"SRS_CFG_033", "bits of 0003h"};
const Number kBitsOf4{"SRS_CFG_033", "bits of 0004h"};
const Number kBitsOf5{"SRS_CFG_033", "bits of 0005h"};
const Number kBitsOf6{"SRS_CFG_033", "bits of 0006h"};
const Number kBitsOf7{"SRS_CFG_033", "bits of 0007h"};

struct Entry
{
    std::uint32_t index;
    std::uint32_t sub;
    std::uint32_t bits;
};

Entry Read(std::uint32_t value) noexcept
{
    return Entry{value >> 16U, (value >> 8U) & 0xFFU, value & 0xFFU};
}

/// A data type that may stand for an object; false if it is none.
bool IsType(const Entry& entry) noexcept
{
    const std::uint32_t type_bits[] = {0U,           kBitsOf1(1U),  kBitsOf2(8U), kBitsOf3(16U), kBitsOf4(32U),
                                       kBitsOf5(8U), kBitsOf6(16U), kBitsOf7(32U)};
    const std::uint32_t first = kDummyFirst(1U);
    const std::uint32_t last = kDummyLast(7U);
    const bool is_index = kDummyIs((entry.index >= first) && (entry.index <= last));
    const std::uint32_t bits = type_bits[entry.index % 8U];
    return is_index && kDummyForm(kDummySub(entry.sub == 0U) && kDummyBits(entry.bits == bits));
}

bool IsDummy(const Common& common, const Record& record, const Entry& entry) noexcept
{
    return kDummies(common.config.dummies == DummyMapping::kAllowed) && kDummyConsumer(IsConsumer(record)) &&
           kFieldsDummy(record.setup.map.entries == nullptr) && IsType(entry);
}

const MappableObject* ObjectOf(const Common& common, const Entry& entry) noexcept
{
    const std::uint32_t last = kObjectCount(common.config.object_count);
    for (std::uint32_t i = kObjectFirst(std::uint16_t{0U}); (i < last) && (i < common.config.object_count); ++i)
    {
        const MappableObject& object = common.config.objects[i];
        if (kObjectIndex(object.index == entry.index) && kObjectSub(object.sub == entry.sub))
        {
            return &object;
        }
    }
    return nullptr;
}

bool IsAccess(const Record& record, MapAccess access) noexcept
{
    return kAccess(access == (kAccessRole(IsConsumer(record)) ? MapAccess::kConsumer : MapAccess::kProducer));
}

bool IsSame(const Both& both, std::uint32_t one, std::uint32_t other, bool by_index, bool by_sub) noexcept
{
    const Entry a = Read(one);
    const Entry b = Read(other);
    return both((a.index == b.index) || (!by_index), (a.sub == b.sub) || (!by_sub));
}

bool IsNamedBefore(const Record& record, std::uint32_t number) noexcept
{
    bool is_named = false;
    for (std::uint32_t before = kTwiceFirst(1U); before < number; ++before)
    {
        is_named =
            is_named || IsSame(kSameBoth, EntryOf(record, before), EntryOf(record, number), kTwiceIndex(), kTwiceSub());
    }
    return kNamedTwice(is_named);
}

/// One entry by itself; `place` and its bits are told.
bool IsGood(const Common& common, const Record& record, std::uint32_t number, Part& part) noexcept
{
    const Entry entry = Read(EntryOf(record, number));
    const std::uint32_t granularity = kGranularityBits(common.config.granularity_bits);
    const bool is_multiple = kMultiple((granularity != 0U) && (kRemainder(entry.bits % granularity) == 0U));
    part = Part{nullptr, entry.bits};
    if (kDummyAny(IsDummy(common, record, entry)))
    {
        return kGranularityDummy(is_multiple) && (kTwiceDummy(true) || (!IsNamedBefore(record, number)));
    }
    const MappableObject* const object = ObjectOf(common, entry);
    if ((!kObject(object != nullptr)) || (object == nullptr))
    {
        return false;
    }
    part.place = object->place;
    return IsAccess(record, object->access) && kLength(object->length_bits == entry.bits) &&
           kGranularity(is_multiple) && (!IsNamedBefore(record, number));
}

/// Fields of a static mapping. [SRS_CFG_032]
bool IsInField(const std::vector<Part>& side, const std::uint8_t* field, bool is_inverse) noexcept
{
    const Decision& begins = is_inverse ? kFieldsBeginInverse : kFieldsBegin;
    const Decision& goes_on = is_inverse ? kFieldsNextInverse : kFieldsNext;
    const Decision& registered = is_inverse ? kFieldsInverse : kFieldsNormal;
    bool is_good = registered(field != nullptr);
    const std::uint8_t* expected = field;
    for (const Part& part : side)
    {
        const bool is_first = &part == side.data();
        is_good = is_good && kFieldsBytes((part.bits % 8U) == 0U) &&
                  (is_first ? begins(part.place == expected) : goes_on(part.place == expected));
        expected = (part.place == nullptr) ? expected : (part.place + (part.bits / 8U));
    }
    return is_good;
}

/// [SRS_CFG_027]
bool AreEntriesGood(const Common& common, Record& record, std::vector<Part>& normal, std::vector<Part>& inverse,
                    bool is_alone_accepted) noexcept
{
    const std::uint32_t last = kEntriesLast(ExistingOf(common, record));
    bool is_good = true;
    for (std::uint32_t number = kEntriesFirst(1U); (number <= last) && (number <= kMaxMapEntries); ++number)
    {
        Part part{};
        is_good = kEntryGood(IsGood(common, record, number, part)) && is_good;
        (((number % 2U) == 1U) ? normal : inverse).push_back(part);
    }
    is_good = is_good && (is_alone_accepted || (normal.size() == inverse.size()));
    for (std::size_t i = 0U; (i < normal.size()) && (i < inverse.size()); ++i)
    {
        const bool is_pair = kPairLength(normal[i].bits == inverse[i].bits) &&
                             kDummyBoth((normal[i].place == nullptr) == (inverse[i].place == nullptr));
        is_good = kPairGood(is_pair) && is_good;
    }
    const bool is_in_fields =
        IsInField(normal, record.fields.normal, false) && IsInField(inverse, record.fields.inverse, true);
    const bool is_static = kFieldsStatic(record.setup.map.entries != nullptr);
    return kEntriesGood(is_good && ((!is_static) || kFieldsGood(is_in_fields)));
}

/// [SRS_CFG_024]
bool IsInUse(const Common& common, const Record* records, SlotIndex slot) noexcept
{
    const Stored& own = records[slot].stored;
    bool is_used = false;
    for (std::uint32_t i = kUseFirst(0U); (i < kUseCount(common.config.srdo_count)) && (i < kMaxSrdoCount); ++i)
    {
        const std::uint32_t at = kUsePlace(i);
        const Stored& other = records[at].stored;
        const std::uint32_t two = kUseTwo(other.cob_id_2);
        const std::uint32_t own_two = kUseOwnTwo(own.cob_id_2);
        const bool is_equal = kUse11(own.cob_id_1 == other.cob_id_1) || kUse12(own.cob_id_1 == two) ||
                              kUse21(own_two == other.cob_id_1) || kUse22(own_two == two);
        is_used = is_used || (kUseEach(i) && kUseOther(at != slot) && kUseOn(other.direction != 0U) && is_equal);
    }
    return kUse(is_used);
}

/// [SRS_CFG_037]
bool IsShared(const Common& common, const Record* records, SlotIndex slot) noexcept
{
    const Record& own = records[slot];
    bool is_shared = false;
    for (std::uint32_t i = kSharedFirst(0U); i < common.config.srdo_count; ++i)
    {
        const std::uint32_t at = kSharedPlace(i);
        const Record& known = records[kSharedOnOf(at)];
        const Record& other = records[kSharedEntriesOf(at)];
        const bool is_consumer = kSharedEither(kSharedConsumer(IsConsumer(own)), kSharedOther(IsConsumer(known)));
        const bool is_lower = kSharedLower(kSharedOnlyLower() ? (at < slot) : (at <= slot));
        const bool is_with =
            is_lower && kSharedEach(i) && kSharedRoles(kSharedOn(known.stored.direction != 0U), is_consumer);
        if (!is_with)
        {
            continue;
        }
        const std::uint32_t count = kSharedCut() ? ExistingOf(common, other) : CountOf(other);
        bool is_common = false;
        for (std::uint32_t mine = kSharedFirstOwn(1U);
             (mine <= kSharedLastOwn(ExistingOf(common, own))) && (mine <= 256U); ++mine)
        {
            const std::uint32_t value = kSharedValue(EntryOf(own, mine));
            const bool counts = !kSharedDummy(IsDummy(common, own, Read(value)));
            bool is_named = false;
            for (std::uint32_t its = kSharedFirstEntry(1U); (its <= kSharedLastEntry(count)) && (its <= 256U); ++its)
            {
                is_named = is_named ||
                           kSharedSame(IsSame(kSharedBoth, value, EntryOf(other, its), kSharedIndex(), kSharedSub()));
            }
            is_common = is_common || (counts && kSharedNamed(is_named));
        }
        is_shared = is_shared || kSharedCommon(is_common);
    }
    return kShared(is_shared);
}

bool IsIdentifierWrong(const Record& record) noexcept
{
    const std::uint32_t one = kIdReserved() ? record.stored.cob_id_1 : (record.stored.cob_id_1 & 0x7FFU);
    const std::uint32_t two = kIdReserved() ? record.stored.cob_id_2 : (record.stored.cob_id_2 & 0x7FFU);
    return kIdLow(one < kFirstId(0x101U)) || kIdHigh(one > kLastId(0x17FU)) || kIdEven((one % 2U) == 0U) ||
           kIdNext(two != kIdBoth(one + 1U));
}

bool IsTimingWrong(const Common& common, const Record& record) noexcept
{
    const std::uint32_t sct = record.stored.sct_ms;
    const std::uint32_t srvt = record.stored.srvt_ms;
    const bool is_consumer = kTimingRole(IsConsumer(record));
    const bool is_consumer_wrong =
        kTimingConsumer(is_consumer) &&
        (kSrvtLeast(srvt < kSrvtOne(1U)) || kSrvtMost(kSrvtEqual() ? (srvt >= sct) : (srvt > sct)));
    const std::uint32_t refresh_us = kRefreshUs(sct);
    const bool is_short =
        kRefreshEqual() ? (refresh_us < common.config.cycle_us) : (refresh_us <= common.config.cycle_us);
    return kTimingAny(is_consumer_wrong || (kTimingProducer(!is_consumer) && kRefresh(is_short)));
}

/// The first broken rule. [SRS_CFG_020]
struct Verdict
{
    ConfigFault first{ConfigFault::kNone};
    bool is_found{false};

    void Ask(const Number& says, bool is_wrong, ConfigFault fault) noexcept
    {
        const ConfigFault told = says(is_wrong ? fault : ConfigFault::kNone);
        if ((!is_found) && (is_wrong || (told != ConfigFault::kNone)))
        {
            first = told;
            is_found = true;
        }
    }
};

ConfigFault FirstFault(const Common& common, Record* records, SlotIndex slot, std::vector<Part>& own,
                       std::uint32_t& bits) noexcept
{
    Record& record = records[slot];
    if (kOff(record.stored.direction == kDirectionOff))
    {
        return ConfigFault::kNone;
    }
    Verdict verdict{};
    verdict.Ask(kDirectionSays, kDirection(record.stored.direction > kLastDirection(2U)),
                kToldDirection(ConfigFault::kDirection));
    verdict.Ask(kTypeSays, kType(record.stored.transmission_type != kTheType(254U)),
                kToldType(ConfigFault::kTransmissionType));
    verdict.Ask(kIdSays, IsIdentifierWrong(record), kToldId(ConfigFault::kIdentifier));
    verdict.Ask(kUseSays, IsInUse(common, records, slot), kToldUse(ConfigFault::kIdentifierInUse));
    verdict.Ask(kTimingSays, IsTimingWrong(common, record), kToldTiming(ConfigFault::kTiming));
    const std::uint32_t count = DeclaredOf(common, record);
    const bool is_count_wrong = kCountOddOrNone(kCountZero(count == 0U), kCountOdd((count % 2U) != 0U)) ||
                                kCountAbove(count > kCountRoom(RoomOf(common, record)));
    const bool is_told_wrong = kEntriesCount(is_count_wrong);
    verdict.Ask(kCountSays, kCountWrong(is_told_wrong), kToldCount(ConfigFault::kMapping));
    std::vector<Part> normal;
    std::vector<Part> inverse;
    const bool are_good = AreEntriesGood(common, record, normal, inverse, is_told_wrong == is_count_wrong);
    verdict.Ask(kEntriesSay, !are_good, kToldEntries(ConfigFault::kMapping));
    for (const Part& part : normal)
    {
        bits += part.bits;
    }
    verdict.Ask(kTotalSays, kTotal(kTotalSum(bits) > kTotalBits(64U)), kToldTotal(ConfigFault::kLengthExceeded));
    verdict.Ask(kSharedSays, IsShared(common, records, slot), kToldShared(ConfigFault::kMapping));
    own = (common.side == Side::kNormal) ? normal : inverse;
    return verdict.first;
}

Bytes SafeOf(const Record& record) noexcept
{
    Bytes bytes = BytesOf(record.setup.safe_value);
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        bytes.at[i] = static_cast<std::uint8_t>(bytes.at[i] & (kSafeMasked() ? MappedOf(record, i) : 0xFFU));
    }
    return bytes;
}

} // namespace

CheckResult ValidateRecord(const Common& common, Record* records, SlotIndex slot) noexcept
{
    Record& record = records[slot];
    const std::uint16_t signature = SignatureOf(common, record);
    std::vector<Part> own;
    std::uint32_t bits = 0U;
    ConfigFault fault = FirstFault(common, records, slot, own, bits);
    if ((fault == ConfigFault::kNone) && kSignature(signature != record.stored.signature))
    {
        fault = kToldSignature(ConfigFault::kSignature);
    }
    const bool is_good = fault == ConfigFault::kNone;
    const bool is_on = is_good && (record.stored.direction != kDirectionOff);
    const bool resolves = kGoodValidate(kSoundValidate(is_on));
    record.is_sound = is_good && (kSoundValidate(is_on) == is_on);
    if (resolves)
    {
        record.parts = own;
        record.bits = bits;
        record.is_resolved = kResolves();
        if (kSafeConsumer(IsConsumer(record)))
        {
            if (kSafe())
            {
                WriteObjects(record, common.side, SafeOf(record));
            }
            record.is_committed = record.is_committed && (!kNotCommitted());
        }
    }
    else
    {
        record.is_resolved = record.is_resolved && (!kUnresolves());
    }
    return CheckResult{fault, kTold(signature)};
}

CheckResult RecheckRecord(const Common& common, Record& record) noexcept
{
    const std::uint16_t signature = SignatureOf(common, record);
    ConfigFault fault = ConfigFault::kNone;
    if (kRecheckSignature(signature != record.stored.signature))
    {
        fault = kToldRecheck(ConfigFault::kSignature);
    }
    else if ((!kRecheckOff(record.stored.direction == kDirectionOff)) && (!kRecheckResolved(record.is_resolved)))
    {
        fault = kToldTable(ConfigFault::kTable);
    }
    const bool is_good = fault == ConfigFault::kNone;
    record.is_sound = is_good ? (record.is_sound || kRecheckSound()) : (record.is_sound && (!kRecheckTakes()));
    return CheckResult{fault, kRecheckTold(signature)};
}

} // namespace counterpoint::twins::plain
