// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Numbers of entries from none to 128, and objects of any length against each granularity.
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
constexpr ConfigFault kTooLong = ConfigFault::kLengthExceeded;

// Room for four: more are refused and signed as four; entry 5 does not exist.
constexpr Step kFour[] = {
    Alter(Parameter::kMapEntries, 4U), StoreAll(), Entry(0U, 5U, 0x63000108U), Load(0U, ConfigField::kMapEntry, 0U, 5U),
    Load(0U, ConfigField::kMapEntry, 0x60110208U, 4U), Validate(0U, kSound, 0x4370U), Entry(0U, 5U, 1U),
    Recheck(0U, kSound, 0x4370U), MapCount(0U, 6U), Validate(0U, kBadMap, 0x4370U),
    Load(0U, ConfigField::kMapCount, 6U), MapCount(0U, 5U), Validate(0U, kBadMap, 0x4370U), MapCount(0U, 4U),
    Validate(0U, kSound, 0x4370U),
};

// Room for two, as the only number that is not a power of two times two: six.
constexpr Step kTwoAndSix[] = {
    Alter(Parameter::kMapEntries, 2U), StoreAll(), MapCount(0U, 2U), Signature(0U, 0x7EBEU),
    Validate(0U, kSound, 0x7EBEU), MapCount(0U, 4U), Validate(0U, kBadMap, 0x7EBEU),
    Load(0U, ConfigField::kMapEntry, 0U, 3U), Alter(Parameter::kMapEntries, 6U), StoreAll(),
    Validate(0U, kSound, 0x4370U), Entry(0U, 6U, 0x12345678U), Load(0U, ConfigField::kMapEntry, 0x12345678U, 6U),
    Entry(0U, 7U, 0x12345678U), Load(0U, ConfigField::kMapEntry, 0U, 7U), MapCount(0U, 8U),
    Signature(0U, 0xBB72U), Validate(0U, kBadMap, 0xBB72U),
};

// No dynamic entries at all.
constexpr Step kNone[] = {
    Alter(Parameter::kMapEntries, 0U), StoreAll(), Load(0U, ConfigField::kMapEntry, 0U, 1U),
    Load(0U, ConfigField::kMapEntry, 0U, 2U), Load(0U, ConfigField::kMapCount, 4U), Validate(0U, kBadMap, 0x251CU),
    Signature(0U, 0x251CU), Validate(0U, kBadMap, 0x251CU), MapCount(0U, 0U), Validate(0U, kBadMap, 0x251CU),
    Direction(0U, 0U), Signature(0U, 0xAFDAU), Validate(0U, kSound, 0xAFDAU),
};

// 64 + 64 entries.
constexpr Step kAll[] = {
    Configure(), Recheck(0U, kSound, 0xA6CFU), Load(0U, ConfigField::kMapCount, 128U),
    Load(0U, ConfigField::kMapEntry, 0x63040101U, 1U), Load(0U, ConfigField::kMapEntry, 0x63050801U, 16U),
    Load(0U, ConfigField::kMapEntry, 0x63040901U, 17U), Load(0U, ConfigField::kMapEntry, 0x63052001U, 64U),
    Load(0U, ConfigField::kMapEntry, 0x63042101U, 65U), Load(0U, ConfigField::kMapEntry, 0x63044001U, 127U),
    Load(0U, ConfigField::kMapEntry, 0x63054001U, 128U), Load(0U, ConfigField::kMapEntry, 0U, 129U),
    Load(0U, ConfigField::kMapEntry, 0U, 255U), Load(0U, ConfigField::kMapEntry, 0U, 0U),
    Entry(0U, 129U, 1U), Entry(0U, 0U, 1U), Entry(0U, 255U, 1U), Recheck(0U, kSound, 0xA6CFU),
    Load(0U, ConfigField::kMapEntry, 0x63040101U, 1U), Load(0U, ConfigField::kMapEntry, 0x63054001U, 128U),
};

constexpr Step kCountOfAll[] = {
    Configure(), MapCount(0U, 130U), Validate(0U, kBadMap, 0xA6CFU), MapCount(0U, 129U),
    Validate(0U, kBadMap, 0xA6CFU), MapCount(0U, 255U), Validate(0U, kBadMap, 0xA6CFU), MapCount(0U, 127U),
    Signature(0U, 0xFF34U), Validate(0U, kBadMap, 0xFF34U), MapCount(0U, 126U),
    Signature(0U, 0x6DDAU), Validate(0U, kSound, 0x6DDAU), MapCount(0U, 18U),
    Signature(0U, 0xC0AFU), Validate(0U, kSound, 0xC0AFU), MapCount(0U, 128U),
    Signature(0U, 0xA6CFU), Validate(0U, kSound, 0xA6CFU),
};

// The last entries wrong: unknown, a repetition of the first, too long by one bit, unequal.
constexpr Step kLastEntries[] = {
    StoreAll(),
    Entry(0U, 128U, 0x63054101U), Signature(0U, 0x91FFU),
    Validate(0U, kBadMap, 0x91FFU),
    Entry(0U, 128U, 0x63050101U), Signature(0U, 0x8C52U),
    Validate(0U, kBadMap, 0x8C52U),
    Entry(0U, 128U, 0x63040101U), Signature(0U, 0xBF63U),
    Validate(0U, kBadMap, 0xBF63U),
    Entry(0U, 128U, 0x63053F01U), Signature(0U, 0x52F6U),
    Validate(0U, kBadMap, 0x52F6U),
    Entry(0U, 127U, 0x63020202U), Entry(0U, 128U, 0x63030202U), Signature(0U, 0x116FU),
    Validate(0U, kTooLong, 0x116FU),
    Entry(0U, 128U, 0x63054001U), Signature(0U, 0x53D8U),
    Validate(0U, kBadMap, 0x53D8U),
    Entry(0U, 127U, 0x63020101U), Entry(0U, 128U, 0x63030101U), Signature(0U, 0x36D2U),
    Validate(0U, kSound, 0x36D2U),
};

// Any entry changed is found by Recheck: first by the signature, then by the table.
constexpr Step kRechecked[] = {
    Configure(), Entry(0U, 100U, 0x63053301U), Recheck(0U, ConfigFault::kSignature, 0xE6C3U),
    Signature(0U, 0xE6C3U), Recheck(0U, ConfigFault::kTable, 0xE6C3U),
    Entry(0U, 100U, 0x63053201U), Signature(0U, 0xA6CFU), Recheck(0U, ConfigFault::kTable, 0xA6CFU),
    Validate(0U, kSound, 0xA6CFU), Recheck(0U, kSound, 0xA6CFU),
};

// ---- granularity: lengths that fit, and that do not

constexpr Step kByOne[] = {
    StoreAll(),
    Entry(0U, 1U, 0x63020101U), Entry(0U, 2U, 0x63030101U), MapCount(0U, 2U), Signature(0U, 0x831FU),
    Validate(0U, kSound, 0x831FU),
    Entry(0U, 1U, 0x63020303U), Entry(0U, 2U, 0x63030303U), MapCount(0U, 2U), Signature(0U, 0x49D6U),
    Validate(0U, kSound, 0x49D6U),
    Entry(0U, 1U, 0x63020707U), Entry(0U, 2U, 0x63030707U), MapCount(0U, 2U), Signature(0U, 0xCC65U),
    Validate(0U, kSound, 0xCC65U),
    Entry(0U, 1U, 0x63020909U), Entry(0U, 2U, 0x63030909U), MapCount(0U, 2U), Signature(0U, 0x9858U),
    Validate(0U, kSound, 0x9858U),
    Entry(0U, 1U, 0x63020C0CU), Entry(0U, 2U, 0x63030C0CU), MapCount(0U, 2U), Signature(0U, 0xF09FU),
    Validate(0U, kSound, 0xF09FU),
    Entry(0U, 1U, 0x63022121U), Entry(0U, 2U, 0x63032121U), MapCount(0U, 2U), Signature(0U, 0xEE03U),
    Validate(0U, kSound, 0xEE03U),
    Entry(0U, 1U, 0x63023F3FU), Entry(0U, 2U, 0x63033F3FU), MapCount(0U, 2U), Signature(0U, 0x8CB0U),
    Validate(0U, kSound, 0x8CB0U),
    Entry(0U, 1U, 0x63024040U), Entry(0U, 2U, 0x63034040U), MapCount(0U, 2U), Signature(0U, 0xB453U),
    Validate(0U, kSound, 0xB453U),
    Entry(0U, 1U, 0x63020304U), Entry(0U, 2U, 0x63030304U), MapCount(0U, 2U), Signature(0U, 0xA950U),
    Validate(0U, kBadMap, 0xA950U),
    Entry(0U, 1U, 0x63020302U), Entry(0U, 2U, 0x63030302U), MapCount(0U, 2U), Signature(0U, 0xD441U),
    Validate(0U, kBadMap, 0xD441U),
    Entry(0U, 1U, 0x63020C0DU), Entry(0U, 2U, 0x63030C0DU), MapCount(0U, 2U), Signature(0U, 0x6D08U),
    Validate(0U, kBadMap, 0x6D08U),
    Entry(0U, 1U, 0x63023F3FU), Entry(0U, 2U, 0x63033F3FU), Entry(0U, 3U, 0x63020101U), Entry(0U, 4U, 0x63030101U),
    MapCount(0U, 4U), Signature(0U, 0xB9BCU), Validate(0U, kSound, 0xB9BCU),
    Entry(0U, 1U, 0x63023F3FU), Entry(0U, 2U, 0x63033F3FU), Entry(0U, 3U, 0x63020202U), Entry(0U, 4U, 0x63030202U),
    MapCount(0U, 4U), Signature(0U, 0x9E01U), Validate(0U, kTooLong, 0x9E01U),
    Entry(0U, 1U, 0x63023C3CU), Entry(0U, 2U, 0x63033C3CU), Entry(0U, 3U, 0x63020404U), Entry(0U, 4U, 0x63030404U),
    MapCount(0U, 4U), Signature(0U, 0xE10FU), Validate(0U, kSound, 0xE10FU),
    Entry(0U, 1U, 0x63023C3CU), Entry(0U, 2U, 0x63033C3CU), Entry(0U, 3U, 0x63020505U), Entry(0U, 4U, 0x63030505U),
    MapCount(0U, 4U), Signature(0U, 0x0C7BU), Validate(0U, kTooLong, 0x0C7BU),
    Entry(0U, 1U, 0x63024040U), Entry(0U, 2U, 0x63034040U), Entry(0U, 3U, 0x63020101U), Entry(0U, 4U, 0x63030101U),
    MapCount(0U, 4U), Signature(0U, 0x34BFU), Validate(0U, kTooLong, 0x34BFU),
    Entry(0U, 1U, 0x63020303U), Entry(0U, 2U, 0x63030404U), MapCount(0U, 2U), Signature(0U, 0x9D6BU),
    Validate(0U, kBadMap, 0x9D6BU),
};

constexpr Step kByEight[] = {
    Alter(Parameter::kGranularity, 8U), StoreAll(),
    Entry(0U, 1U, 0x63020101U), Entry(0U, 2U, 0x63030101U), MapCount(0U, 2U), Signature(0U, 0x831FU),
    Validate(0U, kBadMap, 0x831FU),
    Entry(0U, 1U, 0x63020404U), Entry(0U, 2U, 0x63030404U), MapCount(0U, 2U), Signature(0U, 0xEBD8U),
    Validate(0U, kBadMap, 0xEBD8U),
    Entry(0U, 1U, 0x63020707U), Entry(0U, 2U, 0x63030707U), MapCount(0U, 2U), Signature(0U, 0xCC65U),
    Validate(0U, kBadMap, 0xCC65U),
    Entry(0U, 1U, 0x63020909U), Entry(0U, 2U, 0x63030909U), MapCount(0U, 2U), Signature(0U, 0x9858U),
    Validate(0U, kBadMap, 0x9858U),
    Entry(0U, 1U, 0x63020C0CU), Entry(0U, 2U, 0x63030C0CU), MapCount(0U, 2U), Signature(0U, 0xF09FU),
    Validate(0U, kBadMap, 0xF09FU),
    Entry(0U, 1U, 0x63021414U), Entry(0U, 2U, 0x63031414U), MapCount(0U, 2U), Signature(0U, 0xDD56U),
    Validate(0U, kBadMap, 0xDD56U),
    Entry(0U, 1U, 0x63023C3CU), Entry(0U, 2U, 0x63033C3CU), MapCount(0U, 2U), Signature(0U, 0xAB0DU),
    Validate(0U, kBadMap, 0xAB0DU),
    Entry(0U, 1U, 0x63023F3FU), Entry(0U, 2U, 0x63033F3FU), MapCount(0U, 2U), Signature(0U, 0x8CB0U),
    Validate(0U, kBadMap, 0x8CB0U),
    Entry(0U, 1U, 0x63021010U), Entry(0U, 2U, 0x63031010U), MapCount(0U, 2U), Signature(0U, 0x58E5U),
    Validate(0U, kSound, 0x58E5U),
    Entry(0U, 1U, 0x63024040U), Entry(0U, 2U, 0x63034040U), MapCount(0U, 2U), Signature(0U, 0xB453U),
    Validate(0U, kSound, 0xB453U),
    Entry(0U, 1U, 0x63020404U), Entry(0U, 2U, 0x63030404U), Entry(0U, 3U, 0x63020C0CU), Entry(0U, 4U, 0x63030C0CU),
    MapCount(0U, 4U), Signature(0U, 0x4C0BU), Validate(0U, kBadMap, 0x4C0BU),
};

constexpr Step kByMore[] = {
    Alter(Parameter::kGranularity, 16U), StoreAll(),
    Entry(0U, 1U, 0x63020101U), Entry(0U, 2U, 0x63030101U), MapCount(0U, 2U), Signature(0U, 0x831FU),
    Validate(0U, kBadMap, 0x831FU),
    Entry(0U, 1U, 0x63020909U), Entry(0U, 2U, 0x63030909U), MapCount(0U, 2U), Signature(0U, 0x9858U),
    Validate(0U, kBadMap, 0x9858U),
    Entry(0U, 1U, 0x63020C0CU), Entry(0U, 2U, 0x63030C0CU), MapCount(0U, 2U), Signature(0U, 0xF09FU),
    Validate(0U, kBadMap, 0xF09FU),
    Entry(0U, 1U, 0x63021414U), Entry(0U, 2U, 0x63031414U), MapCount(0U, 2U), Signature(0U, 0xDD56U),
    Validate(0U, kBadMap, 0xDD56U),
    Entry(0U, 1U, 0x63022121U), Entry(0U, 2U, 0x63032121U), MapCount(0U, 2U), Signature(0U, 0xEE03U),
    Validate(0U, kBadMap, 0xEE03U),
    Entry(0U, 1U, 0x63021010U), Entry(0U, 2U, 0x63031010U), MapCount(0U, 2U), Signature(0U, 0x58E5U),
    Validate(0U, kSound, 0x58E5U),
    Entry(0U, 1U, 0x63024040U), Entry(0U, 2U, 0x63034040U), MapCount(0U, 2U), Signature(0U, 0xB453U),
    Validate(0U, kSound, 0xB453U),
    Alter(Parameter::kGranularity, 32U), StoreAll(),
    Entry(0U, 1U, 0x63021010U), Entry(0U, 2U, 0x63031010U), MapCount(0U, 2U), Signature(0U, 0x58E5U),
    Validate(0U, kBadMap, 0x58E5U),
    Entry(0U, 1U, 0x63021F1FU), Entry(0U, 2U, 0x63031F1FU), MapCount(0U, 2U), Signature(0U, 0xE1ACU),
    Validate(0U, kBadMap, 0xE1ACU),
    Entry(0U, 1U, 0x63022121U), Entry(0U, 2U, 0x63032121U), MapCount(0U, 2U), Signature(0U, 0xEE03U),
    Validate(0U, kBadMap, 0xEE03U),
    Entry(0U, 1U, 0x63023C3CU), Entry(0U, 2U, 0x63033C3CU), MapCount(0U, 2U), Signature(0U, 0xAB0DU),
    Validate(0U, kBadMap, 0xAB0DU),
    Entry(0U, 1U, 0x63000420U), Entry(0U, 2U, 0x63010420U), MapCount(0U, 2U), Signature(0U, 0x2BF5U),
    Validate(0U, kSound, 0x2BF5U),
    Entry(0U, 1U, 0x63024040U), Entry(0U, 2U, 0x63034040U), MapCount(0U, 2U), Signature(0U, 0xB453U),
    Validate(0U, kSound, 0xB453U),
    Alter(Parameter::kGranularity, 64U), StoreAll(),
    Entry(0U, 1U, 0x63000420U), Entry(0U, 2U, 0x63010420U), MapCount(0U, 2U), Signature(0U, 0x2BF5U),
    Validate(0U, kBadMap, 0x2BF5U),
    Entry(0U, 1U, 0x63022121U), Entry(0U, 2U, 0x63032121U), MapCount(0U, 2U), Signature(0U, 0xEE03U),
    Validate(0U, kBadMap, 0xEE03U),
    Entry(0U, 1U, 0x63023E3EU), Entry(0U, 2U, 0x63033E3EU), MapCount(0U, 2U), Signature(0U, 0x61C4U),
    Validate(0U, kBadMap, 0x61C4U),
    Entry(0U, 1U, 0x63023F3FU), Entry(0U, 2U, 0x63033F3FU), MapCount(0U, 2U), Signature(0U, 0x8CB0U),
    Validate(0U, kBadMap, 0x8CB0U),
    Entry(0U, 1U, 0x63024040U), Entry(0U, 2U, 0x63034040U), MapCount(0U, 2U), Signature(0U, 0xB453U),
    Validate(0U, kSound, 0xB453U),
};

constexpr Case kCases[] = {
    MakeCase("RoomForFourEntries", {req::SRS_CFG_003, req::SRS_CFG_020, req::SRS_CFG_026}, kGold, kFour),
    MakeCase("RoomForTwoAndForSixEntries", {req::SRS_CFG_003, req::SRS_CFG_020, req::SRS_CFG_026}, kGold, kTwoAndSix),
    MakeCase("RoomForNoEntry", {req::SRS_CFG_003, req::SRS_CFG_020, req::SRS_CFG_026}, kGold, kNone),
    MakeCase("Entries1To128", {req::SRS_CFG_003, req::SRS_CFG_010, req::SRS_CFG_027, req::SRS_CFG_030}, kBits64, kAll),
    MakeCase("MapCountAt128", {req::SRS_CFG_026, req::SRS_CFG_020, req::SRS_CFG_010}, kBits64, kCountOfAll),
    MakeCase("LastOf128Entries", {req::SRS_CFG_027, req::SRS_CFG_028, req::SRS_CFG_010}, kBits64, kLastEntries),
    MakeCase("RecheckOf128Entries", {req::SRS_CFG_030, req::SRS_CFG_010}, kBits64, kRechecked),
    MakeCase("GranularityOfOneBit", {req::SRS_CFG_027, req::SRS_CFG_028}, kBits3, kByOne),
    MakeCase("GranularityOfEightBitsAndOddLengths", {req::SRS_CFG_027}, kBits3, kByEight),
    MakeCase("CoarseGranularityAndOddLengths", {req::SRS_CFG_027}, kBits3, kByMore),
};
// clang-format on
} // namespace

const CaseTable kEntryCases = MakeTable("entries", kCases);

} // namespace counterpoint::conformance
