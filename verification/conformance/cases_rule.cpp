// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Rules of the configuration of one SRDO, first broken rule first. Gold unless said otherwise.
#include "verification/conformance/gold.hpp"
#include "verification/conformance/stores.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
constexpr ConfigFault kSound = ConfigFault::kNone;

constexpr Step kDirection[] = {
    StoreAll(), Direction(0U, 3U), Signature(0U, 0xCEACU), Validate(0U, ConfigFault::kDirection, 0xCEACU),
    Direction(0U, 255U), Signature(0U, 0xB7A1U),
    Validate(0U, ConfigFault::kDirection, 0xB7A1U), Direction(0U, 2U), Signature(0U, 0x4370U),
    Validate(0U, kSound, 0x4370U),
};

constexpr Step kType[] = {
    StoreAll(), Type(0U, 253U), Validate(0U, ConfigFault::kTransmissionType, 0x4370U), Type(0U, 255U),
    Validate(0U, ConfigFault::kTransmissionType, 0x4370U), Type(0U, 0U),
    Validate(0U, ConfigFault::kTransmissionType, 0x4370U), Type(0U, 254U), Validate(0U, kSound, 0x4370U),
};

constexpr Step kIdentifierRange[] = {
    StoreAll(), CobId1(0U, 0xFFU), CobId2(0U, 0x100U), Signature(0U, 0xAF76U),
    Validate(0U, ConfigFault::kIdentifier, 0xAF76U),
    CobId1(0U, 0x101U), CobId2(0U, 0x102U), Signature(0U, 0xA73BU), Validate(0U, kSound, 0xA73BU),
    CobId1(0U, 0x17FU), CobId2(0U, 0x180U), Signature(0U, 0xD95DU), Validate(0U, kSound, 0xD95DU),
    CobId1(0U, 0x181U), CobId2(0U, 0x182U), Signature(0U, 0xF584U), Validate(0U, ConfigFault::kIdentifier, 0xF584U),
    CobId1(0U, 0U), CobId2(0U, 1U), Validate(0U, ConfigFault::kIdentifier, 0x8A96U), CobId1(0U, 0xFFFFFFFFU),
    CobId2(0U, 0U),
    Validate(0U, ConfigFault::kIdentifier, 0x5C17U),
};

constexpr Step kIdentifierPair[] = {
    StoreAll(), CobId1(0U, 0x112U), CobId2(0U, 0x113U), Signature(0U, 0x07CFU),
    Validate(0U, ConfigFault::kIdentifier, 0x07CFU),
    CobId1(0U, 0x100U), CobId2(0U, 0x101U), Signature(0U, 0x9901U), Validate(0U, ConfigFault::kIdentifier, 0x9901U),
    CobId1(0U, 0x111U), CobId2(0U, 0x111U), Signature(0U, 0x8DACU), Validate(0U, ConfigFault::kIdentifier, 0x8DACU),
    CobId2(0U, 0x114U),
    Signature(0U, 0xCEE9U), Validate(0U, ConfigFault::kIdentifier, 0xCEE9U), CobId2(0U, 0x110U), Signature(0U, 0xC818U),
    Validate(0U, ConfigFault::kIdentifier, 0xC818U), CobId2(0U, 0x112U), Signature(0U, 0x4370U),
    Validate(0U, kSound, 0x4370U),
};

constexpr Step kReservedBits[] = {
    StoreAll(), CobId1(0U, 0x80000111U), CobId2(0U, 0x80000112U), Signature(0U, 0xF356U),
    Validate(0U, ConfigFault::kIdentifier, 0xF356U), CobId1(0U, 0x20000111U), CobId2(0U, 0x20000112U),
    Signature(0U, 0xE769U), Validate(0U, ConfigFault::kIdentifier, 0xE769U), CobId1(0U, 0x911U), CobId2(0U, 0x912U),
    Signature(0U, 0xDFC8U), Validate(0U, ConfigFault::kIdentifier, 0xDFC8U), CobId1(0U, 0x111U),
    CobId2(0U, 0x80000112U),
    Signature(0U, 0xF9E5U), Validate(0U, ConfigFault::kIdentifier, 0xF9E5U),
};

constexpr Step kInUse[] = {
    StoreAll(), CobId1(1U, 0x111U), CobId2(1U, 0x112U), Signature(1U, 0xDD3AU),
    Validate(1U, ConfigFault::kIdentifierInUse, 0xDD3AU),
    Validate(0U, ConfigFault::kIdentifierInUse, 0x4370U),
    // Off, the other is in nobody's way.
    Direction(0U, 0U), Validate(1U, kSound, 0xDD3AU), Direction(0U, 1U),
    Validate(1U, ConfigFault::kIdentifierInUse, 0xDD3AU),
    Direction(0U, 3U), Validate(1U, ConfigFault::kIdentifierInUse, 0xDD3AU), Direction(0U, 2U), CobId1(1U, 0x113U),
    CobId2(1U, 0x114U),
    Signature(1U, 0xA74EU), Validate(1U, kSound, 0xA74EU), Validate(0U, kSound, 0x4370U),
};

// Each of the two identifiers against each of the two of the other, one at a time.
constexpr Step kInUseCrossed[] = {
    StoreAll(), CobId1(1U, 0x111U), CobId2(1U, 0x7FFU), Validate(0U, ConfigFault::kIdentifierInUse, 0x4370U),
    CobId1(1U, 0x7FFU), CobId2(1U, 0x111U),
    Validate(0U, ConfigFault::kIdentifierInUse, 0x4370U), CobId1(1U, 0x112U), CobId2(1U, 0x7FFU),
    Validate(0U, ConfigFault::kIdentifierInUse, 0x4370U), CobId1(1U, 0x7FFU),
    CobId2(1U, 0x112U), Validate(0U, ConfigFault::kIdentifierInUse, 0x4370U), CobId1(1U, 0x110U), CobId2(1U, 0x113U),
    Validate(0U, kSound, 0x4370U),
};

constexpr Step kConsumerTiming[] = {
    StoreAll(), Srvt(0U, 0U), Signature(0U, 0xF6FCU), Validate(0U, ConfigFault::kTiming, 0xF6FCU), Srvt(0U, 1U),
    Signature(0U, 0xFFE3U),
    Validate(0U, kSound, 0xFFE3U), Srvt(0U, 49U), Signature(0U, 0x5DD2U), Validate(0U, kSound, 0x5DD2U), Srvt(0U, 50U),
    Signature(0U, 0x46F3U),
    Validate(0U, ConfigFault::kTiming, 0x46F3U), Srvt(0U, 51U), Signature(0U, 0x4FECU),
    Validate(0U, ConfigFault::kTiming, 0x4FECU), Srvt(0U, 255U),
    Sct(0U, 255U), Signature(0U, 0x287AU), Validate(0U, ConfigFault::kTiming, 0x287AU), Sct(0U, 256U),
    Signature(0U, 0xEA25U),
    Validate(0U, kSound, 0xEA25U), Srvt(0U, 1U), Sct(0U, 1U), Signature(0U, 0x4947U),
    Validate(0U, ConfigFault::kTiming, 0x4947U),
    Sct(0U, 2U), Signature(0U, 0xA28DU), Validate(0U, kSound, 0xA28DU), Sct(0U, 0U), Signature(0U, 0x1001U),
    Validate(0U, ConfigFault::kTiming, 0x1001U), Srvt(0U, 0U), Signature(0U, 0x191EU),
    Validate(0U, ConfigFault::kTiming, 0x191EU),
    Srvt(0U, 255U), Sct(0U, 65535U), Signature(0U, 0x9540U), Validate(0U, kSound, 0x9540U),
};

// Cycle 1 ms: a refresh of 1 ms is on the limit. SRVT has no rule.
constexpr Step kProducerTiming[] = {
    StoreAll(), Sct(0U, 0U), Signature(0U, 0x8544U), Validate(0U, ConfigFault::kTiming, 0x8544U), Sct(0U, 1U),
    Signature(0U, 0xDC02U),
    Validate(0U, kSound, 0xDC02U), Srvt(0U, 0U), Signature(0U, 0x698EU), Validate(0U, kSound, 0x698EU), Srvt(0U, 255U),
    Signature(0U, 0x149CU), Validate(0U, kSound, 0x149CU), Sct(0U, 65535U), Signature(0U, 0xBC96U),
    Validate(0U, kSound, 0xBC96U),
};

// Cycle 2.5 ms: 2 ms are too short, 3 ms are not.
constexpr Step kProducerSlowCycle[] = {
    StoreAll(), Sct(0U, 2U), Signature(0U, 0x37C8U), Validate(0U, ConfigFault::kTiming, 0x37C8U), Sct(0U, 3U),
    Signature(0U, 0x6E8EU),
    Validate(0U, kSound, 0x6E8EU),
};

// Cycle 1 s: no rule relates a consumer's SCT to it.
constexpr Step kConsumerCycle[] = {
    StoreAll(), Validate(0U, kSound, 0x4370U),
};

// Direction 0: nothing is checked but the signature.
constexpr Step kOffOnlySignature[] = {
    StoreAll(), Direction(0U, 0U), Type(0U, 1U), CobId1(0U, 0x111U), CobId2(0U, 0x555U), Srvt(0U, 0U), Sct(0U, 0U),
    MapCount(0U, 3U), Entry(0U, 1U, 0xFFFFFFFFU),
    Validate(0U, ConfigFault::kSignature, 0xD038U), Signature(0U, 0xD038U),
    Validate(0U, kSound, 0xD038U), Recheck(0U, kSound, 0xD038U),
};

// Every rule broken, then mended one after the other: the first that is left is named.
constexpr Step kOrder[] = {
    StoreAll(), Direction(0U, 3U), Type(0U, 0U), CobId1(0U, 0x7FFU), CobId2(0U, 0x111U), Sct(0U, 5U), MapCount(0U, 3U),
    Direction(1U, 2U), CobId1(1U, 0x112U), Signature(0U, 0U),
    Validate(0U, ConfigFault::kDirection, 0x7EACU), Direction(0U, 2U),
    Validate(0U, ConfigFault::kTransmissionType, 0x5A38U), Type(0U, 254U),
    Validate(0U, ConfigFault::kIdentifier, 0x5A38U),
    CobId1(0U, 0x111U), CobId2(0U, 0x112U), Validate(0U, ConfigFault::kIdentifierInUse, 0xE3D4U), CobId1(1U, 0x103U),
    Validate(0U, ConfigFault::kTiming, 0xE3D4U), Sct(0U, 50U), Validate(0U, ConfigFault::kMapping, 0x4325U),
    MapCount(0U, 4U),
    Entry(0U, 3U, 0x63000840U), Entry(0U, 4U, 0x63010840U), Validate(0U, ConfigFault::kLengthExceeded, 0x423FU),
    Entry(0U, 3U, 0x60100208U), Entry(0U, 4U, 0x60110208U), Validate(0U, ConfigFault::kSignature, 0x4370U),
    Signature(0U, 0x4370U), Validate(0U, kSound, 0x4370U),
};

// Equal in all 32 bits: with a reserved bit it is another value, which has its own fault.
constexpr Step kInUseReserved[] = {
    StoreAll(), CobId1(1U, 0x80000111U), CobId2(1U, 0x7FFU), Validate(0U, kSound, 0x4370U), CobId1(1U, 0x7FFU),
    CobId2(1U, 0x20000112U), Validate(0U, kSound, 0x4370U), CobId2(1U, 0x00000912U), Validate(0U, kSound, 0x4370U),
    CobId2(1U, 0x112U), Validate(0U, ConfigFault::kIdentifierInUse, 0x4370U),
};

constexpr Case kCases[] = {
    MakeCase("RuleDirection", {req::SRS_CFG_021, req::SRS_CFG_020}, kGold, kDirection),
    MakeCase("RuleTransmissionType", {req::SRS_CFG_022, req::SRS_CFG_020}, kGold, kType),
    MakeCase("RuleIdentifierRange", {req::SRS_CFG_023, req::SRS_CFG_020}, kGold, kIdentifierRange),
    MakeCase("RuleIdentifierPair", {req::SRS_CFG_023}, kGold, kIdentifierPair),
    MakeCase("RuleIdentifierReservedBits", {req::SRS_CFG_023}, kGold, kReservedBits),
    MakeCase("RuleIdentifierInUse", {req::SRS_CFG_024, req::SRS_CFG_020}, kTwo, kInUse),
    MakeCase("RuleIdentifierInUseCrossed", {req::SRS_CFG_024}, kTwo, kInUseCrossed),
    MakeCase("RuleTimingOfAConsumer", {req::SRS_CFG_025, req::SRS_CFG_020}, kGold, kConsumerTiming),
    MakeCase("RuleTimingOfAProducer", {req::SRS_CFG_025}, kSender, kProducerTiming),
    MakeCase("RuleTimingOfAProducerInASlowCycle", {req::SRS_CFG_025}, kSenderSlow, kProducerSlowCycle),
    MakeCase("NoRuleForSctAndCycle", {req::SRS_CFG_025}, kGold, kConsumerCycle),
    MakeCase("DirectionOffIsCheckedBySignatureAlone", {req::SRS_CFG_020, req::SRS_CFG_029, req::SRS_CFG_030}, kGold,
             kOffOnlySignature),
    MakeCase("OrderOfTheRules", {req::SRS_CFG_020}, kTwo, kOrder),
    MakeCase("RuleIdentifierInUseReservedBits", {req::SRS_CFG_024}, kTwo, kInUseReserved),
};
// clang-format on
} // namespace

const CaseTable kRuleCases = MakeTable("rule", kCases);

} // namespace counterpoint::conformance
