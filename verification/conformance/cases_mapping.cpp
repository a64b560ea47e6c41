// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Rules of the mapping. Each refusal beside the nearest mapping that is accepted. Consumer gold unless said otherwise.
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

constexpr Step kCount[] = {
    StoreAll(), MapCount(0U, 0U), Signature(0U, 0x251CU), Validate(0U, kBadMap, 0x251CU), MapCount(0U, 1U),
    Signature(0U, 0x4DA1U),
    Validate(0U, kBadMap, 0x4DA1U), MapCount(0U, 2U), Signature(0U, 0x7EBEU), Validate(0U, kSound, 0x7EBEU),
    MapCount(0U, 3U),
    Signature(0U, 0x4325U), Validate(0U, kBadMap, 0x4325U), MapCount(0U, 4U), Signature(0U, 0x4370U),
    Validate(0U, kSound, 0x4370U),
    // One pair more than there are entries: the next two are empty.
    MapCount(0U, 6U), Signature(0U, 0x6B88U), Validate(0U, kBadMap, 0x6B88U),
};

constexpr Step kCountAtSixteen[] = {
    StoreAll(), Validate(0U, kSound, 0x72C4U), MapCount(0U, 15U), Signature(0U, 0xD96FU),
    Validate(0U, kBadMap, 0xD96FU), MapCount(0U, 14U),
    Signature(0U, 0xB7B9U), Validate(0U, kSound, 0xB7B9U), MapCount(0U, 17U), Signature(0U, 0x72C4U),
    Validate(0U, kBadMap, 0x72C4U),
    MapCount(0U, 18U), Validate(0U, kBadMap, 0x72C4U), MapCount(0U, 32U), Validate(0U, kBadMap, 0x72C4U),
    MapCount(0U, 254U), Validate(0U, kBadMap, 0x72C4U),
};

constexpr Step kUnknown[] = {
    StoreAll(),
    Entry(0U, 1U, 0x60120108U), MapCount(0U, 2U), Signature(0U, 0x1E5DU), Validate(0U, kBadMap, 0x1E5DU),
    Entry(0U, 1U, 0x60100108U), Entry(0U, 2U, 0x60120108U), Signature(0U, 0x2BEDU), Validate(0U, kBadMap, 0x2BEDU),
    Entry(0U, 1U, 0x60100308U), Entry(0U, 2U, 0x60110108U), Signature(0U, 0xF118U), Validate(0U, kBadMap, 0xF118U),
    Entry(0U, 1U, 0x60100008U), Signature(0U, 0x396DU), Validate(0U, kBadMap, 0x396DU),
    Entry(0U, 1U, 0x60110308U), Entry(0U, 2U, 0x60100108U), Signature(0U, 0x7A48U), Validate(0U, kBadMap, 0x7A48U),
    Entry(0U, 1U, 0x00000000U), Entry(0U, 2U, 0x00000000U), Signature(0U, 0x96E6U), Validate(0U, kBadMap, 0x96E6U),
    Entry(0U, 1U, 0xFFFFFFFFU), Entry(0U, 2U, 0xFFFFFFFFU), Signature(0U, 0xE695U), Validate(0U, kBadMap, 0xE695U),
    Entry(0U, 1U, 0x1FFF0008U), Entry(0U, 2U, 0x60110108U), Signature(0U, 0x2BF8U), Validate(0U, kBadMap, 0x2BF8U),
    Entry(0U, 1U, 0x703F0520U), Entry(0U, 2U, 0x703F0320U), Signature(0U, 0xEA7EU), Validate(0U, kBadMap, 0xEA7EU),
    Entry(0U, 1U, 0x70400120U), Signature(0U, 0xEB9BU), Validate(0U, kBadMap, 0xEB9BU),
    Entry(0U, 1U, 0x60100108U), Entry(0U, 2U, 0x60110108U), Signature(0U, 0x7EBEU), Validate(0U, kSound, 0x7EBEU),
};

constexpr Step kAccess[] = {
    StoreAll(),
    Entry(0U, 1U, 0x62100108U), Entry(0U, 2U, 0x62110108U), MapCount(0U, 2U), Signature(0U, 0xD5BCU),
    Validate(0U, kBadMap, 0xD5BCU),
    Entry(0U, 1U, 0x60100108U), Signature(0U, 0x5EFCU), Validate(0U, kBadMap, 0x5EFCU),
    Entry(0U, 1U, 0x62100108U), Entry(0U, 2U, 0x60110108U), Signature(0U, 0xF5FEU), Validate(0U, kBadMap, 0xF5FEU),
    Entry(0U, 1U, 0x67000008U), Signature(0U, 0xC657U), Validate(0U, kBadMap, 0xC657U),
    Entry(0U, 1U, 0x60100108U), Entry(0U, 2U, 0x67000008U), Signature(0U, 0x092BU), Validate(0U, kBadMap, 0x092BU),
    Entry(0U, 2U, 0x60110108U), Signature(0U, 0x7EBEU), Validate(0U, kSound, 0x7EBEU),
};

constexpr Step kLength[] = {
    StoreAll(),
    Entry(0U, 1U, 0x60100107U), Entry(0U, 2U, 0x60110107U), MapCount(0U, 2U), Signature(0U, 0x3204U),
    Validate(0U, kBadMap, 0x3204U),
    Entry(0U, 1U, 0x60100109U), Entry(0U, 2U, 0x60110109U), Signature(0U, 0xE329U), Validate(0U, kBadMap, 0xE329U),
    Entry(0U, 1U, 0x60100100U), Entry(0U, 2U, 0x60110100U), Signature(0U, 0xD282U), Validate(0U, kBadMap, 0xD282U),
    Entry(0U, 1U, 0x60100110U), Entry(0U, 2U, 0x60110110U), Signature(0U, 0x9ADBU), Validate(0U, kBadMap, 0x9ADBU),
    Entry(0U, 1U, 0x601001FFU), Entry(0U, 2U, 0x601101FFU), Signature(0U, 0x151CU), Validate(0U, kBadMap, 0x151CU),
    Entry(0U, 1U, 0x60100108U), Entry(0U, 2U, 0x60110110U), Signature(0U, 0xE0DAU), Validate(0U, kBadMap, 0xE0DAU),
    Entry(0U, 1U, 0x63000818U), Entry(0U, 2U, 0x63010818U), Signature(0U, 0x3BF4U), Validate(0U, kBadMap, 0x3BF4U),
    Entry(0U, 1U, 0x60100108U), Entry(0U, 2U, 0x60110108U), Signature(0U, 0x7EBEU), Validate(0U, kSound, 0x7EBEU),
};

constexpr Step kUnequal[] = {
    StoreAll(),
    Entry(0U, 1U, 0x63000210U), Entry(0U, 2U, 0x63010108U), MapCount(0U, 2U), Signature(0U, 0x0641U),
    Validate(0U, kBadMap, 0x0641U),
    Entry(0U, 1U, 0x63000108U), Entry(0U, 2U, 0x63010210U), Signature(0U, 0x7301U), Validate(0U, kBadMap, 0x7301U),
    Entry(0U, 1U, 0x63000210U), Entry(0U, 2U, 0x63010108U), Entry(0U, 3U, 0x63000108U), Entry(0U, 4U, 0x63010210U),
    MapCount(0U, 4U), Signature(0U, 0xC61DU), Validate(0U, kBadMap, 0xC61DU),
    Entry(0U, 2U, 0x63010210U), Entry(0U, 4U, 0x63010108U), Signature(0U, 0xE310U), Validate(0U, kSound, 0xE310U),
};

constexpr Step kTwice[] = {
    StoreAll(),
    Entry(0U, 2U, 0x60100108U), MapCount(0U, 2U), Signature(0U, 0x4D8FU), Validate(0U, kBadMap, 0x4D8FU),
    Entry(0U, 2U, 0x60110108U), Entry(0U, 3U, 0x60100108U), MapCount(0U, 4U), Signature(0U, 0x8B05U),
    Validate(0U, kBadMap, 0x8B05U),
    Entry(0U, 3U, 0x60100208U), Entry(0U, 4U, 0x60110108U), Signature(0U, 0x1A20U), Validate(0U, kBadMap, 0x1A20U),
    Entry(0U, 3U, 0x60110108U), Entry(0U, 4U, 0x60100108U), Signature(0U, 0x5905U), Validate(0U, kBadMap, 0x5905U),
    Entry(0U, 3U, 0x60100208U), Signature(0U, 0x2911U), Validate(0U, kBadMap, 0x2911U),
    Entry(0U, 1U, 0x60110108U), Entry(0U, 2U, 0x60100108U), MapCount(0U, 2U), Signature(0U, 0xF5EEU),
    Validate(0U, kSound, 0xF5EEU),
    Entry(0U, 1U, 0x60100108U), Entry(0U, 2U, 0x60110108U), Entry(0U, 3U, 0x60110208U), Entry(0U, 4U, 0x60100208U),
    MapCount(0U, 4U), Signature(0U, 0xC820U), Validate(0U, kSound, 0xC820U),
};

constexpr Step kTotal[] = {
    StoreAll(),
    Entry(0U, 1U, 0x63000738U), Entry(0U, 2U, 0x63010738U), Entry(0U, 3U, 0x63000108U), Entry(0U, 4U, 0x63010108U),
    Signature(0U, 0x2568U), Validate(0U, kSound, 0x2568U),
    Entry(0U, 3U, 0x63000210U), Entry(0U, 4U, 0x63010210U), Signature(0U, 0x5028U),
    Validate(0U, ConfigFault::kLengthExceeded, 0x5028U),
    Entry(0U, 1U, 0x63000840U), Entry(0U, 2U, 0x63010840U), MapCount(0U, 2U), Signature(0U, 0xEED4U),
    Validate(0U, kSound, 0xEED4U),
    Entry(0U, 3U, 0x63000108U), Entry(0U, 4U, 0x63010108U), MapCount(0U, 4U), Signature(0U, 0x7FC1U),
    Validate(0U, ConfigFault::kLengthExceeded, 0x7FC1U),
    Entry(0U, 3U, 0x63000738U), Entry(0U, 4U, 0x63010738U), Signature(0U, 0x9541U),
    Validate(0U, ConfigFault::kLengthExceeded, 0x9541U),
    Entry(0U, 3U, 0x63000108U), Entry(0U, 4U, 0x63010210U), Signature(0U, 0xB8F5U), Validate(0U, kBadMap, 0xB8F5U),
    Entry(0U, 4U, 0x63010108U), Entry(0U, 5U, 0x63000108U), Entry(0U, 6U, 0x63010318U), MapCount(0U, 6U),
    Signature(0U, 0xD6EAU), Validate(0U, kBadMap, 0xD6EAU),
    Entry(0U, 3U, 0x63000738U), Entry(0U, 4U, 0x63010738U), Entry(0U, 5U, 0x63000630U), Entry(0U, 6U, 0x63010630U),
    Entry(0U, 7U, 0x63000528U), Entry(0U, 8U, 0x63010528U), Entry(0U, 9U, 0x63000420U), Entry(0U, 10U, 0x63010420U),
    Entry(0U, 11U, 0x63000318U), Entry(0U, 12U, 0x63010318U), Entry(0U, 13U, 0x63000210U), Entry(0U, 14U, 0x63010210U),
    Entry(0U, 15U, 0x63000108U), Entry(0U, 16U, 0x63010108U), MapCount(0U, 16U), Signature(0U, 0xC54EU),
    Validate(0U, ConfigFault::kLengthExceeded, 0xC54EU),
};

constexpr Step kEnds[] = {
    StoreAll(),
    Entry(0U, 1U, 0x703F0320U), Entry(0U, 2U, 0x703F0420U), MapCount(0U, 2U), Signature(0U, 0xEF25U),
    Validate(0U, kSound, 0xEF25U),
    Entry(0U, 1U, 0x703F0420U), Entry(0U, 2U, 0x70000120U), Signature(0U, 0xD666U), Validate(0U, kSound, 0xD666U),
    Entry(0U, 1U, 0x60100108U), Signature(0U, 0xEE40U), Validate(0U, kBadMap, 0xEE40U),
};

constexpr Step kCoarseSixteen[] = {
    Direction(0U, 2U), Sct(0U, 50U), Srvt(0U, 20U), CobId1(0U, 0x111U), CobId2(0U, 0x112U), Entry(0U, 1U, 0x60100108U),
    Entry(0U, 2U, 0x60110108U),
    Entry(0U, 3U, 0x60100208U), Entry(0U, 4U, 0x60110208U), MapCount(0U, 4U),
    MapCount(0U, 2U), Signature(0U, 0x7EBEU), Validate(0U, kBadMap, 0x7EBEU),
    Entry(0U, 1U, 0x63000108U), Entry(0U, 2U, 0x63010108U), Signature(0U, 0xB435U), Validate(0U, kBadMap, 0xB435U),
    Entry(0U, 1U, 0x63000210U), Entry(0U, 2U, 0x63010210U), Signature(0U, 0xC175U), Validate(0U, kSound, 0xC175U),
    Entry(0U, 1U, 0x63000318U), Entry(0U, 2U, 0x63010318U), Signature(0U, 0x1DAAU), Validate(0U, kBadMap, 0x1DAAU),
    Entry(0U, 1U, 0x63000420U), Entry(0U, 2U, 0x63010420U), Signature(0U, 0x2BF5U), Validate(0U, kSound, 0x2BF5U),
    Entry(0U, 1U, 0x63000528U), Entry(0U, 2U, 0x63010528U), Signature(0U, 0xF72AU), Validate(0U, kBadMap, 0xF72AU),
    Entry(0U, 1U, 0x63000630U), Entry(0U, 2U, 0x63010630U), Signature(0U, 0x826AU), Validate(0U, kSound, 0x826AU),
    Entry(0U, 1U, 0x63000840U), Entry(0U, 2U, 0x63010840U), Signature(0U, 0xEED4U), Validate(0U, kSound, 0xEED4U),
};

constexpr Step kCoarseThirtyTwo[] = {
    Direction(0U, 2U), Sct(0U, 50U), Srvt(0U, 20U), CobId1(0U, 0x111U), CobId2(0U, 0x112U), Entry(0U, 1U, 0x60100108U),
    Entry(0U, 2U, 0x60110108U),
    Entry(0U, 3U, 0x60100208U), Entry(0U, 4U, 0x60110208U), MapCount(0U, 4U),
    Entry(0U, 1U, 0x63000210U), Entry(0U, 2U, 0x63010210U), MapCount(0U, 2U), Signature(0U, 0xC175U),
    Validate(0U, kBadMap, 0xC175U),
    Entry(0U, 1U, 0x63000420U), Entry(0U, 2U, 0x63010420U), Signature(0U, 0x2BF5U), Validate(0U, kSound, 0x2BF5U),
    Entry(0U, 1U, 0x63000630U), Entry(0U, 2U, 0x63010630U), Signature(0U, 0x826AU), Validate(0U, kBadMap, 0x826AU),
    Entry(0U, 1U, 0x63000840U), Entry(0U, 2U, 0x63010840U), Signature(0U, 0xEED4U), Validate(0U, kSound, 0xEED4U),
};

constexpr Step kCoarseSixtyFour[] = {
    Direction(0U, 2U), Sct(0U, 50U), Srvt(0U, 20U), CobId1(0U, 0x111U), CobId2(0U, 0x112U), Entry(0U, 1U, 0x60100108U),
    Entry(0U, 2U, 0x60110108U),
    Entry(0U, 3U, 0x60100208U), Entry(0U, 4U, 0x60110208U), MapCount(0U, 4U),
    Entry(0U, 1U, 0x63000420U), Entry(0U, 2U, 0x63010420U), MapCount(0U, 2U), Signature(0U, 0x2BF5U),
    Validate(0U, kBadMap, 0x2BF5U),
    Entry(0U, 1U, 0x63000738U), Entry(0U, 2U, 0x63010738U), Signature(0U, 0x5EB5U), Validate(0U, kBadMap, 0x5EB5U),
    Entry(0U, 1U, 0x63000840U), Entry(0U, 2U, 0x63010840U), Signature(0U, 0xEED4U), Validate(0U, kSound, 0xEED4U),
};

constexpr Step kDummy[] = {
    StoreAll(),
    Entry(0U, 1U, 0x00050008U), MapCount(0U, 2U), Signature(0U, 0x28A9U), Validate(0U, kBadMap, 0x28A9U),
    Entry(0U, 1U, 0x60100108U), Entry(0U, 2U, 0x00050008U), Signature(0U, 0xEA9FU), Validate(0U, kBadMap, 0xEA9FU),
    Entry(0U, 2U, 0x60110108U), Entry(0U, 3U, 0x00050008U), Entry(0U, 4U, 0x00050008U), MapCount(0U, 4U),
    Signature(0U, 0x1063U), Validate(0U, kBadMap, 0x1063U),
};

// A producer may not map what the channels write.
constexpr Step kProducerAccess[] = {
    StoreAll(), Entry(0U, 1U, 0x60100108U), Entry(0U, 2U, 0x60110108U), MapCount(0U, 2U), Signature(0U, 0x2D12U),
    Validate(0U, kBadMap, 0x2D12U), Entry(0U, 1U, 0x62100108U), Signature(0U, 0xA652U),
    Validate(0U, kBadMap, 0xA652U), Entry(0U, 2U, 0x62110108U), Signature(0U, 0x8610U),
    Validate(0U, kSound, 0x8610U), Entry(0U, 1U, 0x20000008U), Entry(0U, 2U, 0x20010008U), Signature(0U, 0x4B2DU),
    Validate(0U, kSound, 0x4B2DU),
};

// Entries behind the map count are nobody's business.
constexpr Step kBehindCount[] = {
    StoreAll(), Entry(0U, 5U, 0x60100108U), Entry(0U, 6U, 0xFFFFFFFFU), Entry(0U, 16U, 0x67000008U),
    Validate(0U, kSound, 0x4370U),
};

constexpr Step kNoDictionary[] = {
    Direction(0U, 2U), Sct(0U, 50U), CobId1(0U, 0x111U), CobId2(0U, 0x112U), Entry(0U, 1U, 0x60100108U),
    Entry(0U, 2U, 0x60110108U), MapCount(0U, 2U),
    Signature(0U, 0x7EBEU), Validate(0U, kBadMap, 0x7EBEU),
};

constexpr Step kOneEntryDictionary[] = {
    Direction(0U, 1U), CobId1(0U, 0x111U), CobId2(0U, 0x112U), Entry(0U, 1U, 0x20000008U), Entry(0U, 2U, 0x20010008U),
    MapCount(0U, 2U), Sct(0U, 1000U),
    Signature(0U, 0x8E3DU), Validate(0U, kBadMap, 0x8E3DU),
    Entry(0U, 2U, 0x20000008U), Signature(0U, 0xBD0CU),
    Validate(0U, kBadMap, 0xBD0CU),
};

constexpr Case kCases[] = {
    MakeCase("RuleMapCount", {req::SRS_CFG_026, req::SRS_CFG_020}, kGold, kCount),
    MakeCase("RuleMapCountAtSixteen", {req::SRS_CFG_026, req::SRS_CFG_020}, kWide, kCountAtSixteen),
    MakeCase("RuleEntryUnknownObject", {req::SRS_CFG_027}, kGold, kUnknown),
    MakeCase("RuleEntryAccess", {req::SRS_CFG_027}, kGold, kAccess),
    MakeCase("RuleEntryAccessOfAProducer", {req::SRS_CFG_027}, kSender, kProducerAccess),
    MakeCase("RuleEntryLength", {req::SRS_CFG_027}, kGold, kLength),
    MakeCase("RuleEntryPairOfUnequalLength", {req::SRS_CFG_027}, kGold, kUnequal),
    MakeCase("RuleEntrySameObjectTwice", {req::SRS_CFG_027}, kGold, kTwice),
    MakeCase("RuleTotalLength", {req::SRS_CFG_028, req::SRS_CFG_027, req::SRS_CFG_020}, kGold, kTotal),
    MakeCase("EndsOfTheDictionary", {req::SRS_CFG_027}, kGold, kEnds),
    MakeCase("GranularityOfSixteenBits", {req::SRS_CFG_027}, kCoarse16, kCoarseSixteen),
    MakeCase("GranularityOfThirtyTwoBits", {req::SRS_CFG_027}, kCoarse32, kCoarseThirtyTwo),
    MakeCase("GranularityOfSixtyFourBits", {req::SRS_CFG_027}, kCoarse64, kCoarseSixtyFour),
    MakeCase("DummyEntryIsNoObject", {req::SRS_CFG_027}, kGold, kDummy),
    MakeCase("EntriesBehindTheCount", {req::SRS_CFG_027, req::SRS_CFG_010}, kGold, kBehindCount),
    MakeCase("NoMappableObject", {req::SRS_CFG_027}, kNoObjects, kNoDictionary),
    MakeCase("OneMappableObject", {req::SRS_CFG_027}, kOneObject, kOneEntryDictionary),
};
// clang-format on
} // namespace

const CaseTable kMappingCases = MakeTable("mapping", kCases);

} // namespace counterpoint::conformance
