// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Static mappings: entries that are a part of the program, and two fields of the application that hold their objects.
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

constexpr Step kGoldFields = Fields(0U, Place(0x6010U, 1U), Place(0x6011U, 1U));

// Gold as a part of the program: signature, data and safe value are those of gold.
constexpr Step kStaticGold[] = {
    Configure(), Recheck(0U, kSound, 0x4370U), NormalObject(0x6010U, 1U, 0xA5U), NormalObject(0x6010U, 2U, 0xC3U),
    InverseObject(0x6011U, 1U, 0x5AU), InverseObject(0x6011U, 2U, 0x3CU), Cycle(0U), Normal(1000U), Inverse(2000U),
    Cycle(3000U), Masks(1U, 0U, 0U, 0U, 1U), Commit(1U, 1U), Data(0U, 0x3412U), NormalObject(0x6010U, 1U, 0x12U),
    NormalObject(0x6010U, 2U, 0x34U), InverseObject(0x6011U, 1U, 0xEDU), InverseObject(0x6011U, 2U, 0xCBU),
    Recheck(0U, kSound, 0x4370U), Cycle(51001U), Commit(0U, 0U), NormalObject(0x6010U, 1U, 0xA5U),
    NormalObject(0x6010U, 2U, 0xC3U), InverseObject(0x6011U, 1U, 0x5AU), InverseObject(0x6011U, 2U, 0x3CU),
};

// Count and entries read as they are, from power-on on; storing them changes nothing and unresolves nothing.
constexpr Step kLoaded[] = {
    Load(0U, ConfigField::kMapCount, 4U), Load(0U, ConfigField::kMapEntry, 0x60100108U, 1U), Configure(),
    Load(0U, ConfigField::kMapCount, 4U), Load(0U, ConfigField::kMapEntry, 0x60100108U, 1U),
    Load(0U, ConfigField::kMapEntry, 0x60110108U, 2U), Load(0U, ConfigField::kMapEntry, 0x60100208U, 3U),
    Load(0U, ConfigField::kMapEntry, 0x60110208U, 4U), Load(0U, ConfigField::kMapEntry, 0U, 5U),
    Load(0U, ConfigField::kMapEntry, 0U, 128U), Load(0U, ConfigField::kMapEntry, 0U, 0U), MapCount(0U, 2U),
    MapCount(0U, 0U), Entry(0U, 1U, 0x63000108U), Entry(0U, 4U, 0U), Entry(0U, 5U, 1U), Entry(0U, 0U, 1U),
    Load(0U, ConfigField::kMapCount, 4U), Load(0U, ConfigField::kMapEntry, 0x60100108U, 1U),
    Load(0U, ConfigField::kMapEntry, 0x60110208U, 4U), Load(0U, ConfigField::kMapEntry, 0U, 5U),
    Recheck(0U, kSound, 0x4370U), Cycle(0U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U), Validate(0U, kSound, 0x4370U),
};

// What is stored besides unresolves as ever.
constexpr Step kUnresolved[] = {
    Configure(), Signature(0U, 0x4370U), Recheck(0U, kSound, 0x4370U), Sct(0U, 50U),
    Recheck(0U, ConfigFault::kTable, 0x4370U), Cycle(0U), Slot(0U, kOff, kNoCause, 0U, 0U, 0U),
};

constexpr Step kValues[] = {
    Direction(0U, 2U), Sct(0U, 50U), CobId1(0U, 0x111U), CobId2(0U, 0x112U), Signature(0U, 0x4370U),
    // No field registered, then one alone.
    Validate(0U, kBadMap, 0x4370U), Fields(0U, Place(0x6010U, 1U), 0U), Validate(0U, kBadMap, 0x4370U),
    Fields(0U, 0U, Place(0x6011U, 1U)), Validate(0U, kBadMap, 0x4370U), kGoldFields,
    Recheck(0U, ConfigFault::kTable, 0x4370U), Validate(0U, kSound, 0x4370U), Recheck(0U, kSound, 0x4370U),
    Fields(0U, 0U, 0U), Validate(0U, kBadMap, 0x4370U),
};

// Each field must be where its first object is.
constexpr Step kWrongFields[] = {
    StoreAll(), Fields(0U, Place(0x6010U, 2U), Place(0x6011U, 1U)), Validate(0U, kBadMap, 0x4370U),
    Fields(0U, Place(0x6010U, 1U), Place(0x6011U, 2U)), Validate(0U, kBadMap, 0x4370U),
    Fields(0U, Place(0x6011U, 1U), Place(0x6010U, 1U)), Validate(0U, kBadMap, 0x4370U),
    Fields(0U, Place(0x6010U, 1U), Place(0x6010U, 1U)), Validate(0U, kBadMap, 0x4370U),
    Fields(0U, Place(0x2001U, 0U), Place(0x6011U, 1U)), Validate(0U, kBadMap, 0x4370U),
    kGoldFields, Validate(0U, kSound, 0x4370U),
};

// Registered anew, the same or others: unresolved until the next Validate.
constexpr Step kAnew[] = {
    Configure(), kGoldFields, Recheck(0U, ConfigFault::kTable, 0x4370U), Cycle(0U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Nmt(NmtState::kPreOperational), Cycle(1000U), Validate(0U, kSound, 0x4370U),
    Recheck(0U, kSound, 0x4370U), Nmt(NmtState::kOperational), Cycle(2000U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
    Fields(0U, Place(0x6010U, 2U), Place(0x6011U, 1U)), Recheck(0U, ConfigFault::kTable, 0x4370U),
};

// Power-on forgets the fields.
constexpr Step kAfterRestart[] = {
    Configure(), Restart(), Direction(0U, 2U), Sct(0U, 50U), CobId1(0U, 0x111U), CobId2(0U, 0x112U),
    Signature(0U, 0x4370U), Validate(0U, kBadMap, 0x4370U), kGoldFields, Validate(0U, kSound, 0x4370U),
};

// The rules before it come first; an SRDO that is off is not looked at.
constexpr Step kOrder[] = {
    StoreAll(), Fields(0U, 0U, 0U), CobId2(0U, 0x114U), Validate(0U, ConfigFault::kIdentifier, 0xCEE9U),
    CobId2(0U, 0x112U), Srvt(0U, 50U), Validate(0U, ConfigFault::kTiming, 0x46F3U), Srvt(0U, 20U),
    Signature(0U, 1U), Validate(0U, kBadMap, 0x4370U), Direction(0U, 0U), Validate(0U, ConfigFault::kSignature, 0x48E9U),
    Signature(0U, 0x48E9U), Validate(0U, kSound, 0x48E9U), Direction(0U, 1U), Sct(0U, 1000U), kGoldFields,
    Signature(0U, 0xBECDU), Validate(0U, kBadMap, 0xBECDU),
};

// 8, 16 and 24 bits one behind the other.
constexpr Step kSizes[] = {
    Configure(), Recheck(0U, kSound, 0xA563U), NormalObject(0x6300U, 1U, 0x01U), NormalObject(0x6300U, 2U, 0x0302U),
    NormalObject(0x6300U, 3U, 0x060504U), InverseObject(0x6301U, 1U, 0xFEU), InverseObject(0x6301U, 2U, 0xFCFDU),
    InverseObject(0x6301U, 3U, 0xF9FAFBU), Cycle(0U), Frame(0x111U, 6U, 0x44332211U, 0x6655U, 1000U),
    Frame(0x112U, 6U, 0xBBCCDDEEU, 0x99AAU, 2000U), Cycle(3000U), Masks(1U, 0U, 0U, 0U, 1U), Commit(1U, 1U),
    NormalObject(0x6300U, 1U, 0x11U), NormalObject(0x6300U, 2U, 0x3322U), NormalObject(0x6300U, 3U, 0x665544U),
    InverseObject(0x6301U, 1U, 0xEEU), InverseObject(0x6301U, 2U, 0xCCDDU), InverseObject(0x6301U, 3U, 0x99AABBU),
    NormalObject(0x6300U, 4U, 0x66666666U), InverseObject(0x6301U, 4U, 0x66666666U),
};

constexpr Step kGap[] = {
    StoreAll(), Validate(0U, kBadMap, 0x08A7U), Fields(0U, Place(0x6300U, 3U), Place(0x6301U, 3U)),
    Validate(0U, kBadMap, 0x08A7U),
};

constexpr Step kGapOfInverse[] = {
    StoreAll(), Validate(0U, kBadMap, 0x5A91U),
};

constexpr Step kTurned[] = {
    StoreAll(), Validate(0U, kBadMap, 0x3353U), Fields(0U, Place(0x6631U, 1U), Place(0x6633U, 1U)),
    Validate(0U, kBadMap, 0x3353U),
};

constexpr Step kFourBits[] = {
    StoreAll(), Validate(0U, kBadMap, 0xEBD8U),
};

constexpr Step kDummyEntry[] = {
    StoreAll(), Validate(0U, kBadMap, 0x1063U),
};

constexpr Step kEmpty[] = {
    StoreAll(), Load(0U, ConfigField::kMapCount, 0U), Load(0U, ConfigField::kMapEntry, 0U, 1U),
    Validate(0U, kBadMap, 0x251CU),
};

constexpr Step kOdd[] = {
    StoreAll(), Load(0U, ConfigField::kMapCount, 3U), Load(0U, ConfigField::kMapEntry, 0x60100208U, 3U),
    Load(0U, ConfigField::kMapEntry, 0U, 4U), Validate(0U, kBadMap, 0x4325U),
};

// 130 entries are signed as 128; there are no addresses for the last two.
constexpr Step kLarge[] = {
    StoreAll(), Validate(0U, kBadMap, 0xA6CFU), Load(0U, ConfigField::kMapEntry, 0x63054001U, 128U),
    Load(0U, ConfigField::kMapEntry, 0U, 129U), Load(0U, ConfigField::kMapEntry, 0U, 130U),
    Load(0U, ConfigField::kMapEntry, 0U, 255U),
    Direction(0U, 0U), Signature(0U, 0xED6DU), Validate(0U, kSound, 0xED6DU),
};

constexpr Step kLong[] = {
    StoreAll(), Validate(0U, ConfigFault::kLengthExceeded, 0x5C6AU), Fields(0U, Place(0x6300U, 1U), Place(0x6301U, 2U)),
    Validate(0U, kBadMap, 0x5C6AU), Fields(0U, Place(0x6300U, 1U), Place(0x6301U, 1U)),
    Validate(0U, ConfigFault::kLengthExceeded, 0x5C6AU),
};

// Beside it a dynamic one, to which fields mean nothing.
constexpr Step kBeside[] = {
    Configure(), Recheck(0U, kSound, 0x4370U), Recheck(1U, kSound, 0xD999U),
    Fields(1U, Place(0x6200U, 1U), Place(0x6201U, 1U)), Fields(1U, 0U, 0U), Recheck(1U, kSound, 0xD999U),
    Load(1U, ConfigField::kMapEntry, 0x62000120U, 1U), Entry(0U, 1U, 1U), Recheck(1U, kSound, 0xD999U),
    Recheck(0U, kSound, 0x4370U), Cycle(0U), Normal(1000U), Frame(0x103U, 4U, 0x11223344U, 0U, 1000U), Inverse(2000U),
    Frame(0x104U, 4U, 0xEEDDCCBBU, 0U, 2000U), Cycle(3000U), Masks(3U, 0U, 0U, 0U, 3U), Commit(3U, 3U),
    NormalObject(0x6010U, 1U, 0x12U), NormalObject(0x6200U, 1U, 0x11223344U), InverseObject(0x6201U, 1U, 0xEEDDCCBBU),
    InverseObject(0x6011U, 2U, 0xCBU),
};

// A producer reads its fields.
constexpr Step kSends[] = {
    Configure(), Put(0x6210U, 1U, 0x12U), Put(0x6210U, 2U, 0x34U), Put(0x6211U, 1U, 0xEDU), Put(0x6211U, 2U, 0xCBU),
    Cycle(0U), Request(0U), Cycle(2000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 2100U), TakeSecond(0U),
    ConfirmSecond(0U, 2200U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U), Put(0x6211U, 2U, 0xCAU),
    UnequalPair(0U, 0x3412U, 0x3512U), NotInverse(0U), Slot(0U, kProducing, Cause::kNotInverse, 1U, 1U, 0U),
    Recheck(0U, kSound, 0xF2B5U), Load(0U, ConfigField::kMapEntry, 0x62100108U, 1U),
};

// Rules that only the entries break: one pair of 8 and 16 bits, one object on both sides, a coarser granularity.
constexpr Step kUnequalPair[] = {
    StoreAll(), Validate(0U, kBadMap, 0x7301U),
};

constexpr Step kSameObject[] = {
    StoreAll(), Validate(0U, kBadMap, 0x4D8FU),
};

constexpr Step kCoarse[] = {
    Alter(Parameter::kGranularity, 16U), StoreAll(), Validate(0U, kBadMap, 0x4370U), Alter(Parameter::kGranularity, 8U), StoreAll(),
    Validate(0U, kSound, 0x4370U), Alter(Parameter::kGranularity, 1U), StoreAll(), Validate(0U, kSound, 0x4370U),
};

constexpr Case kCases[] = {
    MakeCase("StaticMapping", {req::SRS_CFG_032, req::SRS_CFG_010, req::SRS_REL_002, req::SRS_CFG_030}, kStatic,
             kStaticGold),
    MakeCase("StaticEntriesAreReadOnly", {req::SRS_CFG_003, req::SRS_CFG_032}, kStatic, kLoaded),
    MakeCase("StoreUnresolvesAStaticMapping", {req::SRS_CFG_003, req::SRS_CFG_030}, kStatic, kUnresolved),
    MakeCase("StaticFieldsMustBeRegistered", {req::SRS_CFG_032, req::SRS_CFG_030}, kStatic, kValues),
    MakeCase("StaticFieldsMustBeRight", {req::SRS_CFG_032}, kStatic, kWrongFields),
    MakeCase("StaticFieldsRegisteredAnew", {req::SRS_CFG_032, req::SRS_CFG_030}, kStatic, kAnew),
    MakeCase("StaticFieldsAfterPowerOn", {req::SRS_CFG_032, req::SRS_CFG_002}, kStatic, kAfterRestart),
    MakeCase("StaticMappingInTheOrderOfTheRules", {req::SRS_CFG_020, req::SRS_CFG_032}, kStatic, kOrder),
    MakeCase("StaticMappingOfSeveralSizes", {req::SRS_CFG_032, req::SRS_CFG_036}, kStaticSizes, kSizes),
    MakeCase("StaticMappingWithAGap", {req::SRS_CFG_032}, kStaticGap, kGap),
    MakeCase("StaticMappingWithAGapInTheInverseField", {req::SRS_CFG_032}, kStaticFirst, kGapOfInverse),
    MakeCase("StaticMappingOutOfOrder", {req::SRS_CFG_032}, kStaticTurned, kTurned),
    MakeCase("StaticMappingOfFourBits", {req::SRS_CFG_032}, kStaticBits, kFourBits),
    MakeCase("StaticMappingWithADummy", {req::SRS_CFG_032, req::SRS_CFG_033}, kStaticDummy, kDummyEntry),
    MakeCase("StaticMappingWithoutEntries", {req::SRS_CFG_026, req::SRS_CFG_032}, kStaticEmpty, kEmpty),
    MakeCase("StaticMappingOfThreeEntries", {req::SRS_CFG_026, req::SRS_CFG_032}, kStaticOdd, kOdd),
    MakeCase("StaticMappingOf130Entries", {req::SRS_CFG_026, req::SRS_CFG_020, req::SRS_CFG_003}, kStaticLarge, kLarge),
    MakeCase("StaticMappingTooLong", {req::SRS_CFG_028, req::SRS_CFG_032}, kStaticLong, kLong),
    MakeCase("StaticBesideADynamicMapping", {req::SRS_CFG_032, req::SRS_CFG_003}, kStaticTwo, kBeside),
    MakeCase("StaticMappingOfAProducer", {req::SRS_CFG_032, req::SRS_PROD_005}, kStaticSender, kSends),
    MakeCase("StaticMappingOfUnequalPairs", {req::SRS_CFG_032, req::SRS_CFG_027}, kStaticUneven, kUnequalPair),
    MakeCase("StaticMappingOfOneObjectTwice", {req::SRS_CFG_032, req::SRS_CFG_027}, kStaticSame, kSameObject),
    MakeCase("StaticMappingAndGranularity", {req::SRS_CFG_032, req::SRS_CFG_027}, kStatic, kCoarse),
};
// clang-format on
} // namespace

const CaseTable kStaticCases = MakeTable("static", kCases);

} // namespace counterpoint::conformance
