// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Objects that two SRDOs name. Consumer gold in slot 0 and 6200h, 6201h:01 in slot 1 unless said otherwise.
#include "verification/conformance/gold.hpp"
#include "verification/conformance/stores.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
constexpr ConfigFault kSound = ConfigFault::kNone;
constexpr ConfigFault kBadMap = ConfigFault::kMapping;

// Each of the later entries against each of the earlier ones, on the same side and across. The later slot is named.
constexpr Step kShared[] = {
    StoreAll(),
    Validate(0U, kSound, 0x4370U), Validate(1U, kSound, 0xD999U),
    Entry(1U, 1U, 0x60100108U), Entry(1U, 2U, 0x63010108U), MapCount(1U, 2U), Signature(1U, 0x490DU),
    Validate(1U, kBadMap, 0x490DU),
    Entry(1U, 1U, 0x63000108U), Entry(1U, 2U, 0x60110108U), MapCount(1U, 2U), Signature(1U, 0x8386U),
    Validate(1U, kBadMap, 0x8386U),
    Entry(1U, 1U, 0x63000108U), Entry(1U, 2U, 0x60100208U), MapCount(1U, 2U), Signature(1U, 0xE9E7U),
    Validate(1U, kBadMap, 0xE9E7U),
    Entry(1U, 1U, 0x60110208U), Entry(1U, 2U, 0x63010108U), MapCount(1U, 2U), Signature(1U, 0x3919U),
    Validate(1U, kBadMap, 0x3919U),
    Validate(0U, kSound, 0x4370U),
    Entry(1U, 1U, 0x60100108U), Entry(1U, 2U, 0x60110108U), Entry(1U, 3U, 0x60100208U), Entry(1U, 4U, 0x60110208U),
    MapCount(1U, 4U), Signature(1U, 0xDB4FU), Validate(1U, kBadMap, 0xDB4FU),
    Entry(1U, 1U, 0x63000108U), Entry(1U, 2U, 0x63010108U), Entry(1U, 3U, 0x63000210U), Entry(1U, 4U, 0x63010210U),
    Entry(1U, 5U, 0x66310108U), Entry(1U, 6U, 0x60110208U), MapCount(1U, 6U), Signature(1U, 0x92EEU),
    Validate(1U, kBadMap, 0x92EEU),
    Entry(1U, 1U, 0x63000108U), Entry(1U, 2U, 0x63010108U), Entry(1U, 3U, 0x63000210U), Entry(1U, 4U, 0x63010210U),
    Entry(1U, 5U, 0x66310108U), Entry(1U, 6U, 0x66330108U), MapCount(1U, 6U), Signature(1U, 0xCBFCU),
    Validate(1U, kSound, 0xCBFCU),
    Entry(1U, 1U, 0x63000108U), Entry(1U, 2U, 0x63010108U), MapCount(1U, 2U), Signature(1U, 0xB096U),
    Validate(1U, kSound, 0xB096U),
    Validate(0U, kSound, 0x4370U),
};

// Another sub-index is another object, another length is not. What stands behind the map count is not mapped.
constexpr Step kNearMiss[] = {
    StoreAll(),
    Entry(0U, 1U, 0x60100108U), Entry(0U, 2U, 0x60110108U), MapCount(0U, 2U), Signature(0U, 0x7EBEU),
    Validate(0U, kSound, 0x7EBEU),
    Entry(1U, 1U, 0x60100208U), Entry(1U, 2U, 0x60110208U), MapCount(1U, 2U), Signature(1U, 0xEB38U),
    Validate(1U, kSound, 0xEB38U),
    Entry(1U, 1U, 0x60100108U), Entry(1U, 2U, 0x60110208U), MapCount(1U, 2U), Signature(1U, 0x234DU),
    Validate(1U, kBadMap, 0x234DU),
    // Odd count: three entries count.
    MapCount(0U, 3U),
    Entry(1U, 1U, 0x60100208U), Entry(1U, 2U, 0x63010108U), MapCount(1U, 2U), Signature(1U, 0x8178U),
    Validate(1U, kBadMap, 0x8178U),
    Entry(1U, 1U, 0x63000108U), Entry(1U, 2U, 0x60110208U), MapCount(1U, 2U), Signature(1U, 0xDAD6U),
    Validate(1U, kSound, 0xDAD6U),
    // The lower slot names it with a wrong length.
    Entry(0U, 1U, 0x60100110U), Entry(0U, 2U, 0x60110110U), MapCount(0U, 2U),
    Entry(1U, 1U, 0x60100108U), Entry(1U, 2U, 0x63010108U), MapCount(1U, 2U), Signature(1U, 0x490DU),
    Validate(1U, kBadMap, 0x490DU),
};

// Only a lower slot that is off is in nobody's way; a slot that is off is not looked at.
constexpr Step kDirections[] = {
    StoreAll(),
    Entry(1U, 1U, 0x60100108U), Entry(1U, 2U, 0x60110108U), Entry(1U, 3U, 0x60100208U), Entry(1U, 4U, 0x60110208U),
    MapCount(1U, 4U), Signature(1U, 0xDB4FU), Validate(1U, kBadMap, 0xDB4FU),
    Direction(0U, 0U), Validate(1U, kSound, 0xDB4FU), Direction(0U, 1U), Validate(1U, kBadMap, 0xDB4FU),
    Direction(0U, 3U), Validate(1U, kBadMap, 0xDB4FU), Direction(0U, 2U), Validate(1U, kBadMap, 0xDB4FU),
    Direction(1U, 0U), Validate(1U, ConfigFault::kSignature, 0xD0D6U), Signature(1U, 0xD0D6U),
    Validate(1U, kSound, 0xD0D6U), Validate(0U, kSound, 0x4370U),
};

// A consumer below a producer: it names what the producer sends.
constexpr Step kConsumerFirst[] = {
    StoreAll(),
    Validate(1U, kSound, 0xF2B5U), Entry(0U, 1U, 0x62100108U), Entry(0U, 2U, 0x63010108U), MapCount(0U, 2U),
    Validate(1U, kBadMap, 0xF2B5U), Entry(0U, 1U, 0x63000108U), Entry(0U, 2U, 0x62110208U), MapCount(0U, 2U),
    Validate(1U, kBadMap, 0xF2B5U),
    Entry(0U, 1U, 0x63000108U), Entry(0U, 2U, 0x63010108U), MapCount(0U, 2U), Validate(1U, kSound, 0xF2B5U),
    Direction(0U, 0U), Entry(0U, 1U, 0x62100108U), Entry(0U, 2U, 0x62110108U), Entry(0U, 3U, 0x62100208U),
    Entry(0U, 4U, 0x62110208U), MapCount(0U, 4U), Validate(1U, kSound, 0xF2B5U),
};

// A producer below a consumer.
constexpr Step kProducerFirst[] = {
    StoreAll(),
    Direction(0U, 1U), Entry(0U, 1U, 0x62000120U), Entry(0U, 2U, 0x63010420U), MapCount(0U, 2U),
    Validate(1U, kBadMap, 0xD999U), Entry(0U, 1U, 0x63000420U), Entry(0U, 2U, 0x62010120U), MapCount(0U, 2U),
    Validate(1U, kBadMap, 0xD999U),
    Entry(0U, 1U, 0x62100108U), Entry(0U, 2U, 0x62110108U), MapCount(0U, 2U), Validate(1U, kSound, 0xD999U),
};

// Producers may share; one consumer among them may not, whatever lies between.
constexpr Step kProducers[] = {
    StoreAll(),
    Validate(0U, kSound, 0xF2B5U), Validate(1U, kSound, 0x8EC1U), Validate(2U, kSound, 0x07BFU),
    Validate(15U, kSound, 0x441BU),
    Direction(5U, 2U), Validate(15U, kBadMap, 0x441BU), Validate(6U, kBadMap, 0xFD8AU), Validate(4U, kSound, 0x0880U),
    Validate(0U, kSound, 0xF2B5U),
    Direction(5U, 3U), Validate(15U, kSound, 0x441BU), Direction(5U, 0U), Validate(15U, kSound, 0x441BU),
    Direction(0U, 2U), Validate(1U, kBadMap, 0x8EC1U), Validate(15U, kBadMap, 0x441BU),
    Direction(0U, 1U), Validate(1U, kSound, 0x8EC1U), Validate(15U, kSound, 0x441BU),
};

// Dummy entries are no object; the objects beside them are.
constexpr Step kDummies[] = {
    Alter(Parameter::kDummyMapping, 0x66U), StoreAll(),
    Entry(0U, 1U, 0x60100108U), Entry(0U, 2U, 0x60110108U), Entry(0U, 3U, 0x00050008U), Entry(0U, 4U, 0x00050008U),
    MapCount(0U, 4U), Signature(0U, 0x1063U), Validate(0U, kSound, 0x1063U),
    Entry(1U, 1U, 0x62000120U), Entry(1U, 2U, 0x62010120U), Entry(1U, 3U, 0x00050008U), Entry(1U, 4U, 0x00050008U),
    MapCount(1U, 4U), Signature(1U, 0xC7F7U), Validate(1U, kSound, 0xC7F7U),
    Entry(1U, 1U, 0x00050008U), Entry(1U, 2U, 0x00050008U), Entry(1U, 3U, 0x00050008U), Entry(1U, 4U, 0x00050008U),
    MapCount(1U, 4U), Signature(1U, 0x6E72U), Validate(1U, kSound, 0x6E72U),
    Entry(1U, 1U, 0x00050008U), Entry(1U, 2U, 0x00050008U), Entry(1U, 3U, 0x60100108U), Entry(1U, 4U, 0x63010108U),
    MapCount(1U, 4U), Signature(1U, 0x9F54U), Validate(1U, kBadMap, 0x9F54U),
    Entry(1U, 1U, 0x00050008U), Entry(1U, 2U, 0x00050008U), Entry(1U, 3U, 0x60100208U), Entry(1U, 4U, 0x63010108U),
    MapCount(1U, 4U), Signature(1U, 0x5721U), Validate(1U, kSound, 0x5721U),
    Entry(0U, 1U, 0x00050008U), Entry(0U, 2U, 0x00050008U), Entry(0U, 3U, 0x00050008U), Entry(0U, 4U, 0x00050008U),
    MapCount(0U, 4U),
    Entry(1U, 1U, 0x60100108U), Entry(1U, 2U, 0x60110108U), Entry(1U, 3U, 0x60100208U), Entry(1U, 4U, 0x60110208U),
    MapCount(1U, 4U), Signature(1U, 0xDB4FU), Validate(1U, kSound, 0xDB4FU),
};

// Behind the total length, before the signature.
constexpr Step kOrder[] = {
    StoreAll(),
    Entry(1U, 1U, 0x63000840U), Entry(1U, 2U, 0x63010840U), Entry(1U, 3U, 0x60100108U), Entry(1U, 4U, 0x63010108U),
    MapCount(1U, 4U), Signature(1U, 0x1E65U), Validate(1U, ConfigFault::kLengthExceeded, 0x1E65U),
    Entry(1U, 1U, 0x63000738U), Entry(1U, 2U, 0x63010738U), Entry(1U, 3U, 0x60100108U), Entry(1U, 4U, 0x63010108U),
    MapCount(1U, 4U), Signature(1U, 0x44CCU), Validate(1U, kBadMap, 0x44CCU),
    Signature(1U, 1U), Validate(1U, kBadMap, 0x44CCU),
    Entry(1U, 1U, 0x63000738U), Entry(1U, 2U, 0x63010738U), Entry(1U, 3U, 0x63000108U), Entry(1U, 4U, 0x63010108U),
    MapCount(1U, 4U), Validate(1U, ConfigFault::kSignature, 0xBD57U), Entry(1U, 1U, 0x63000738U),
    Entry(1U, 2U, 0x63010738U), Entry(1U, 3U, 0x63000108U), Entry(1U, 4U, 0x63010108U), MapCount(1U, 4U),
    Signature(1U, 0xBD57U), Validate(1U, kSound, 0xBD57U),
};

// A count of the lower slot above the room for entries: the 16 that exist count, and nothing behind them.
constexpr Step kManyEntries[] = {
    StoreAll(),
    Entry(1U, 1U, 0x63000108U), Entry(1U, 2U, 0x63010108U), MapCount(1U, 2U), Signature(1U, 0xB096U),
    Validate(1U, kSound, 0xB096U),
    Entry(0U, 16U, 0x63000108U), Validate(1U, kSound, 0xB096U), MapCount(0U, 15U), Validate(1U, kSound, 0xB096U),
    MapCount(0U, 16U), Validate(1U, kBadMap, 0xB096U), MapCount(0U, 17U), Validate(1U, kBadMap, 0xB096U),
    MapCount(0U, 18U), Validate(1U, kBadMap, 0xB096U), MapCount(0U, 255U), Validate(1U, kBadMap, 0xB096U),
    Entry(0U, 16U, 0U), Validate(1U, kSound, 0xB096U),
    Entry(1U, 1U, 0x60100108U), Entry(1U, 2U, 0x63010108U), MapCount(1U, 2U), Signature(1U, 0x490DU),
    Validate(1U, kBadMap, 0x490DU),
    Alter(Parameter::kMapEntries, 4U), StoreAll(), MapCount(0U, 255U), Validate(1U, kSound, 0xD999U),
    Entry(1U, 1U, 0x66310108U), Entry(1U, 2U, 0x60110208U), MapCount(1U, 2U), Signature(1U, 0x783BU),
    Validate(1U, kBadMap, 0x783BU),
    Entry(1U, 1U, 0x63000108U), Entry(1U, 2U, 0x63010108U), MapCount(1U, 2U), Signature(1U, 0xB096U),
    Validate(1U, kSound, 0xB096U),
};

// A static mapping below: what is stored of its count changes nothing.
constexpr Step kStaticFirst[] = {
    StoreAll(),
    Validate(1U, kSound, 0xD999U), Entry(1U, 1U, 0x60100208U), Entry(1U, 2U, 0x63010108U), MapCount(1U, 2U),
    Signature(1U, 0x8178U), Validate(1U, kBadMap, 0x8178U),
    MapCount(0U, 0U), Validate(1U, kBadMap, 0x8178U), Entry(1U, 1U, 0x63000108U), Entry(1U, 2U, 0x60110108U),
    MapCount(1U, 2U), Signature(1U, 0x8386U), Validate(1U, kBadMap, 0x8386U),
    Validate(0U, kSound, 0x4370U), Direction(0U, 0U), Validate(1U, kSound, 0x8386U),
};

// A static mapping above.
constexpr Step kStaticLast[] = {
    StoreAll(),
    Validate(0U, kSound, 0xD999U), Validate(1U, kSound, 0x4370U), Entry(0U, 1U, 0x60100208U),
    Entry(0U, 2U, 0x63010108U), MapCount(0U, 2U), Signature(0U, 0x8178U), Validate(0U, kSound, 0x8178U),
    Validate(1U, kBadMap, 0x4370U), Entry(0U, 1U, 0x63000108U), Entry(0U, 2U, 0x60110108U), MapCount(0U, 2U),
    Signature(0U, 0x8386U), Validate(0U, kSound, 0x8386U),
    Validate(1U, kBadMap, 0x4370U), MapCount(0U, 1U), Validate(1U, kSound, 0x4370U), MapCount(0U, 2U),
    Direction(0U, 0U), Validate(1U, kSound, 0x4370U),
};

constexpr Step kStaticBoth[] = {
    StoreAll(),
    Validate(0U, kSound, 0x4370U), Validate(1U, kBadMap, 0xDB4FU), Direction(0U, 0U), Validate(1U, kSound, 0xDB4FU),
};

// The first and the last of 64, and the two last.
constexpr Step kSixtyFourSlots[] = {
    StoreAll(),
    Validate(63U, kSound, 0x536BU), Entry(63U, 1U, 0x703F0120U), Entry(63U, 2U, 0x703F0320U),
    Entry(63U, 3U, 0x703F0220U), Entry(63U, 4U, 0x70000420U), MapCount(63U, 4U), Signature(63U, 0x46C0U),
    Validate(63U, kBadMap, 0x46C0U),
    Entry(63U, 1U, 0x70000120U), Entry(63U, 2U, 0x703F0320U), Entry(63U, 3U, 0x703F0220U),
    Entry(63U, 4U, 0x703F0420U), MapCount(63U, 4U), Signature(63U, 0x84D6U), Validate(63U, kBadMap, 0x84D6U),
    Entry(63U, 1U, 0x703F0120U), Entry(63U, 2U, 0x703F0320U), Entry(63U, 3U, 0x703F0220U),
    Entry(63U, 4U, 0x703E0420U), MapCount(63U, 4U), Signature(63U, 0x605AU), Validate(63U, kBadMap, 0x605AU),
    Entry(63U, 1U, 0x703F0120U), Entry(63U, 2U, 0x703F0320U), Entry(63U, 3U, 0x703F0220U),
    Entry(63U, 4U, 0x703F0420U), MapCount(63U, 4U), Signature(63U, 0x536BU), Validate(63U, kSound, 0x536BU),
    Entry(0U, 1U, 0x70000120U), Entry(0U, 2U, 0x70000320U), Entry(0U, 3U, 0x703F0220U), Entry(0U, 4U, 0x70000420U),
    MapCount(0U, 4U), Signature(0U, 0xA508U), Validate(0U, kSound, 0xA508U),
    Validate(63U, kBadMap, 0x536BU),
};

// Refused like any mapping: nothing resolved, nothing written, the SRDO stays off. The lower one goes on.
constexpr Step kRefused[] = {
    StoreAll(),
    Entry(1U, 1U, 0x60100108U), Entry(1U, 2U, 0x63010108U), MapCount(1U, 2U), Signature(1U, 0x490DU),
    Validate(0U, kSound, 0x4370U), Validate(1U, kBadMap, 0x490DU),
    NormalObject(0x6010U, 1U, 0xA5U), InverseObject(0x6301U, 1U, 0x66U), Recheck(1U, ConfigFault::kTable, 0x490DU),
    Recheck(0U, kSound, 0x4370U), Store(0U, ConfigField::kConfigurationValid, 0xA5U), Cycle(0U),
    Counts(1U, 0U, 1U, 0U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U), Slot(1U, kOff, kNoCause, 0U, 0U, 0U),
};

// Recheck looks at its own SRDO alone.
constexpr Step kOnlyValidate[] = {
    Configure(), Entry(0U, 1U, 0x62000120U), Recheck(1U, kSound, 0xD999U), Validate(1U, kBadMap, 0xD999U),
};

constexpr Case kCases[] = {
    MakeCase("RuleSharedObject", {req::SRS_CFG_037}, kTwo, kShared),
    MakeCase("SharedObjectBySubIndexAndCount", {req::SRS_CFG_037}, kTwo, kNearMiss),
    MakeCase("SharedObjectAndDirections", {req::SRS_CFG_037, req::SRS_CFG_020}, kTwo, kDirections),
    MakeCase("SharedObjectConsumerBelowProducer", {req::SRS_CFG_037}, kMixed, kConsumerFirst),
    MakeCase("SharedObjectProducerBelowConsumer", {req::SRS_CFG_037}, kTwo, kProducerFirst),
    MakeCase("ProducersShareObjects", {req::SRS_CFG_037}, kSenders, kProducers),
    MakeCase("DummiesAreNotShared", {req::SRS_CFG_037, req::SRS_CFG_033}, kTwo, kDummies),
    MakeCase("SharedObjectInTheOrderOfTheRules", {req::SRS_CFG_037, req::SRS_CFG_020, req::SRS_CFG_028}, kTwo, kOrder),
    MakeCase("SharedObjectAboveTheRoomForEntries", {req::SRS_CFG_037, req::SRS_CFG_003}, kTwo, kManyEntries),
    MakeCase("SharedObjectOfAStaticMappingBelow", {req::SRS_CFG_037, req::SRS_CFG_032}, kStaticTwo, kStaticFirst),
    MakeCase("SharedObjectOfAStaticMappingAbove", {req::SRS_CFG_037, req::SRS_CFG_032}, kStaticAbove, kStaticLast),
    MakeCase("SharedObjectOfTwoStaticMappings", {req::SRS_CFG_037, req::SRS_CFG_032}, kStaticTwins, kStaticBoth),
    MakeCase("SharedObjectOfSixtyFour", {req::SRS_CFG_037}, kSixtyFour, kSixtyFourSlots),
    MakeCase("SharedObjectIsRefused", {req::SRS_CFG_037, req::SRS_CFG_030}, kTwo, kRefused),
    MakeCase("SharedObjectIsNoMatterOfRecheck", {req::SRS_CFG_037, req::SRS_CFG_030}, kTwo, kOnlyValidate),
};
// clang-format on
} // namespace

const CaseTable kSharedCases = MakeTable("shared", kCases);

} // namespace counterpoint::conformance
