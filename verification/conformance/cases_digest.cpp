// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Digest of the device: CRC-32 of the usual kind (that of Ethernet) over the parameters that no signature covers. The
// expected values were computed outside this program.
#include "verification/conformance/gold.hpp"
#include "verification/conformance/stores.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
// Gold as it is switched on, and whatever is stored of what the signature covers: the same digest.
constexpr Step kBase[] = {
    Digest(0U, 0U, 0x1517595FU), Direction(0U, 2U), Sct(0U, 50U), Srvt(0U, 1U), CobId1(0U, 0x111U), CobId2(0U, 0x112U),
    Entry(0U, 1U, 0x60100108U), MapCount(0U, 2U), Signature(0U, 0x1234U), Store(0U, ConfigField::kConfigurationValid, 0xA5U),
    Digest(0U, 0U, 0x1517595FU), Digest(0U, 0U, 0x1517595FU),
};

// What is stored of what it does not cover.
constexpr Step kStored[] = {
    Store(0U, ConfigField::kGfcParameter, 1U), Digest(0U, 0U, 0x8818B829U),
    Store(0U, ConfigField::kGfcParameter, 255U), Digest(0U, 0U, 0x2A9FB10EU),
    Store(0U, ConfigField::kGfcParameter, 0U), Type(0U, 255U), Digest(0U, 0U, 0x026C4D1CU),
    Type(0U, 0U), Digest(0U, 0U, 0x4B234157U), Type(0U, 254U), Digest(0U, 0U, 0x1517595FU),
};

// In every state the same.
constexpr Step kEveryState[] = {
    Configure(), Digest(0U, 0U, 0x8631C437U), Cycle(0U), Digest(0U, 0U, 0x8631C437U),
    Normal(1000U), Inverse(2000U), Cycle(3000U), Commit(1U, 1U), Masks(1U, 0U, 0U, 0U, 1U),
    Digest(0U, 0U, 0x8631C437U), Slot(0U, kReleased, kNoCause, 1U, 0U, 1U),
    Recheck(0U, ConfigFault::kNone, 0x4370U),
};

constexpr Step kIdentity[] = {
    Alter(Parameter::kNodeId, 41U), Digest(0U, 0U, 0x0DBD8B3BU), Alter(Parameter::kNodeId, 40U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kNodeId, 127U), Digest(0U, 0U, 0x939EC027U), Alter(Parameter::kNodeId, 40U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kGranularity, 1U), Digest(0U, 0U, 0xE42AD430U), Alter(Parameter::kGranularity, 8U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kGranularity, 64U), Digest(0U, 0U, 0xF13F2B23U), Alter(Parameter::kGranularity, 8U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kDummyMapping, 0x66U), Digest(0U, 0U, 0xAF9F6DF4U), Alter(Parameter::kDummyMapping, 0U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kNumberGaps, 0U), Digest(0U, 0U, 0xD111FD39U), Alter(Parameter::kNumberGaps, 0x99U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kGfc, 0U), Digest(0U, 0U, 0x4461D4D0U), Alter(Parameter::kGfc, 0x5AU), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kNormalPort, 2U), Digest(0U, 0U, 0xAF425D48U), Alter(Parameter::kNormalPort, 1U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kInversePort, 2U), Digest(0U, 0U, 0x90254BABU), Alter(Parameter::kInversePort, 1U), Digest(0U, 0U, 0x1517595FU),
};

// Values that are none of those defined count as that which grants nothing.
constexpr Step kUndefined[] = {
    Alter(Parameter::kDummyMapping, 0x67U), Digest(0U, 0U, 0x1517595FU), Alter(Parameter::kDummyMapping, 0U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kDummyMapping, 0x99U), Digest(0U, 0U, 0x1517595FU), Alter(Parameter::kDummyMapping, 0U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kNumberGaps, 0x98U), Digest(0U, 0U, 0xD111FD39U), Alter(Parameter::kNumberGaps, 0x99U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kNumberGaps, 0x66U), Digest(0U, 0U, 0xD111FD39U), Alter(Parameter::kNumberGaps, 0x99U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kGfc, 0x5BU), Digest(0U, 0U, 0x4461D4D0U), Alter(Parameter::kGfc, 0x5AU), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kGfc, 0xA5U), Digest(0U, 0U, 0x4461D4D0U), Alter(Parameter::kGfc, 0x5AU), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kPolicy, 0x5BU), Digest(0U, 0U, 0xC35BEB32U), Alter(Parameter::kPolicy, 0x5AU), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kPolicy, 0xFFU), Digest(0U, 0U, 0xC35BEB32U), Alter(Parameter::kPolicy, 0x5AU), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kForm, 2U), Digest(0U, 0U, 0x1517595FU), Alter(Parameter::kForm, 0U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kForm, 0xFFU), Digest(0U, 0U, 0x1517595FU), Alter(Parameter::kForm, 0U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kDetection, 0x3DU), Digest(0U, 0U, 0x1517595FU), Alter(Parameter::kDetection, 0U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kDetection, 0xC3U), Digest(0U, 0U, 0x1517595FU), Alter(Parameter::kDetection, 0U), Digest(0U, 0U, 0x1517595FU),
};

// Every byte of every time, by bits at both ends.
constexpr Step kTimes[] = {
    Alter(Parameter::kCycle, 1001U), Digest(0U, 0U, 0x912640AEU), Alter(Parameter::kCycle, 1000U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kCycle, 0x810003E8U), Digest(0U, 0U, 0xAE321CD3U), Alter(Parameter::kCycle, 1000U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kCycleTolerance, 501U), Digest(0U, 0U, 0x6ADEC2CCU), Alter(Parameter::kCycleTolerance, 500U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kCycleTolerance, 0x01U), Digest(0U, 0U, 0xFCA6FAA5U), Alter(Parameter::kCycleTolerance, 500U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kDiscrepancy, 10001U), Digest(0U, 0U, 0xB42EDDB1U), Alter(Parameter::kDiscrepancy, 10000U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kDiscrepancy, 0x12345678U), Digest(0U, 0U, 0x79F5DDFCU), Alter(Parameter::kDiscrepancy, 10000U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kAcknowledgeWindow, 0U), Digest(0U, 0U, 0x8E717254U), Alter(Parameter::kAcknowledgeWindow, 100000U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kAcknowledgeWindow, 100001U), Digest(0U, 0U, 0x989FA4BDU), Alter(Parameter::kAcknowledgeWindow, 100000U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kDiagnosticInterval, 900001U), Digest(0U, 0U, 0x31950869U), Alter(Parameter::kDiagnosticInterval, 900000U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kDiagnosticInterval, 0x87654321U), Digest(0U, 0U, 0x29FAF970U), Alter(Parameter::kDiagnosticInterval, 900000U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kTestInterval, 900001U), Digest(0U, 0U, 0x2977BA57U), Alter(Parameter::kTestInterval, 900000U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kTestInterval, 1U), Digest(0U, 0U, 0x457F8D6EU), Alter(Parameter::kTestInterval, 900000U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kClockTolerance, 1001U), Digest(0U, 0U, 0xF20AFFC8U), Alter(Parameter::kClockTolerance, 1000U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kClockTolerance, 0U), Digest(0U, 0U, 0x6C19DD25U), Alter(Parameter::kClockTolerance, 1000U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kClockInterval, 1000001U), Digest(0U, 0U, 0x023F3D9FU), Alter(Parameter::kClockInterval, 1000000U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kClockInterval, 0xFFFFFFFFU), Digest(0U, 0U, 0xE435082AU), Alter(Parameter::kClockInterval, 1000000U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kOutputTime, 1001U), Digest(0U, 0U, 0xFA45EFBEU), Alter(Parameter::kOutputTime, 1000U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kOutputTime, 0U), Digest(0U, 0U, 0x187C8206U), Alter(Parameter::kOutputTime, 1000U), Digest(0U, 0U, 0x1517595FU),
};

constexpr Step kSetup[] = {
    Alter(Parameter::kNumber, 2U), Digest(0U, 0U, 0xA8DD3591U), Alter(Parameter::kNumber, 1U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kNumber, 64U), Digest(0U, 0U, 0x750C1171U), Alter(Parameter::kNumber, 1U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kPolicy, 0U), Digest(0U, 0U, 0xC35BEB32U), Alter(Parameter::kPolicy, 0x5AU), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kForm, 1U), Digest(0U, 0U, 0xD499869FU), Alter(Parameter::kForm, 0U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kDetection, 0x3CU), Digest(0U, 0U, 0x67D83BE9U), Alter(Parameter::kDetection, 0U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kSafeLow, 0xC3A4U), Digest(0U, 0U, 0xD9BD59C1U), Alter(Parameter::kSafeLow, 0xC3A5U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kSafeLow, 0x8000C3A5U), Digest(0U, 0U, 0xA4F1E9CDU), Alter(Parameter::kSafeLow, 0xC3A5U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kSafeHigh, 1U), Digest(0U, 0U, 0xADAB3E3AU), Alter(Parameter::kSafeHigh, 0U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kSafeHigh, 0x80000000U), Digest(0U, 0U, 0xF8AFDA7FU), Alter(Parameter::kSafeHigh, 0U), Digest(0U, 0U, 0x1517595FU),
};

// The number of entries and the expected digest itself are no part of it.
constexpr Step kNoPart[] = {
    Alter(Parameter::kMapEntries, 4U), Digest(0U, 0U, 0x1517595FU), Alter(Parameter::kMapEntries, 16U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kMapEntries, 0U), Digest(0U, 0U, 0x1517595FU), Alter(Parameter::kMapEntries, 16U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kDigest, 1U), Digest(0U, 0U, 0x1517595FU), Alter(Parameter::kDigest, 0U), Digest(0U, 0U, 0x1517595FU),
    Alter(Parameter::kDigest, 0xFFFFFFFFU), Digest(0U, 0U, 0x1517595FU), Alter(Parameter::kDigest, 0U), Digest(0U, 0U, 0x1517595FU),
};

// Slot after slot, each continued from the one before; only slot 0 has the device's part.
constexpr Step kChained[] = {
    Digest(0U, 0U, 0x1517595FU), Digest(1U, 0x1517595FU, 0x316A2C6FU),
    Digest(1U, 0U, 0xF8083552U), Digest(1U, 0xFFFFFFFFU, 0x08838C2FU),
    Digest(0U, 0x12345678U, 0xBE1DDB37U),
    Digest(0U, 0x00000001U, 0x0DBD8B3BU),
    Type(1U, 253U), Digest(1U, 0x1517595FU, 0x08E710AAU), Digest(0U, 0U, 0x1517595FU),
    Store(1U, ConfigField::kGfcParameter, 1U), Digest(0U, 0U, 0x8818B829U),
    Digest(1U, 0U, 0xC1850997U), Alter(Parameter::kNumber, 7U, 1U),
    Digest(1U, 0U, 0xE5278641U), Digest(0U, 0U, 0x1517595FU), Alter(Parameter::kSafeHigh, 0x01020304U, 1U),
    Digest(1U, 0U, 0x2D32FD5BU), Alter(Parameter::kDetection, 0x3CU, 1U),
    Digest(1U, 0U, 0x5FFD9FEDU), Alter(Parameter::kForm, 1U, 1U),
    Digest(1U, 0U, 0x9E73402DU), Alter(Parameter::kPolicy, 0U, 1U),
    Digest(1U, 0U, 0x483FF240U), Digest(0U, 0U, 0x1517595FU),
};

// Devices of the cases.
constexpr Step kMixedDevice[] = {
    Digest(0U, 0U, 0x8848C609U), Digest(1U, 0x8848C609U, 0x90492D86U), Digest(2U, 0x90492D86U, 0xCF216388U),
    Configure(), Digest(0U, 0U, 0x8848C609U), Digest(1U, 0x8848C609U, 0x90492D86U), Digest(2U, 0x90492D86U, 0xCF216388U),
};

constexpr Step kProviderDevice[] = {
    Configure(), Digest(0U, 0U, 0x9B04C174U),
};

constexpr Step kDummyDevice[] = {
    Configure(), Digest(0U, 0U, 0xA70D94FFU),
};

constexpr Step kLateDevice[] = {
    Configure(), Digest(0U, 0U, 0x8631C437U), Digest(1U, 0x8631C437U, 0xA4F09597U),
};

constexpr Step kStaticDevice[] = {
    Digest(0U, 0U, 0x8631C437U), Configure(), Digest(0U, 0U, 0x8631C437U),
};

// The first, the second and the last of 64.
constexpr Step kSixtyFourSlots[] = {
    Digest(0U, 0U, 0xC381FF65U), Digest(1U, 0xC381FF65U, 0xBD9A49D5U), Digest(62U, 0x2ACEAE48U, 0x200432FEU),
    Digest(63U, 0x200432FEU, 0x8787A70AU),
};

constexpr Case kCases[] = {
    MakeCase("DigestOfABareDevice", {req::SRS_CFG_034}, kBare, kBase),
    MakeCase("DigestOfWhatIsStored", {req::SRS_CFG_034, req::SRS_CFG_348, req::SRS_CFG_003}, kBare, kStored),
    MakeCase("DigestInEveryState", {req::SRS_CFG_034}, kGold, kEveryState),
    MakeCase("DigestOfIdentityAndUse", {req::SRS_CFG_034}, kBare, kIdentity),
    MakeCase("DigestOfUndefinedValues", {req::SRS_CFG_034, req::SRS_CFG_348}, kBare, kUndefined),
    MakeCase("DigestOfTimes", {req::SRS_CFG_034}, kBare, kTimes),
    MakeCase("DigestOfASetup", {req::SRS_CFG_034, req::SRS_CFG_348}, kBare, kSetup),
    MakeCase("DigestLeavesOut", {req::SRS_CFG_034, req::SRS_CFG_348}, kBare, kNoPart),
    MakeCase("DigestIsContinued", {req::SRS_CFG_034}, kBareTwo, kChained),
    MakeCase("DigestOfAMixedDevice", {req::SRS_CFG_034, req::SRS_CFG_348}, kMixed, kMixedDevice),
    MakeCase("DigestOfAProvider", {req::SRS_CFG_034, req::SRS_CFG_348}, kProviderLast, kProviderDevice),
    MakeCase("DigestWithDummies", {req::SRS_CFG_034, req::SRS_CFG_033}, kDummies, kDummyDevice),
    MakeCase("DigestWithLateDetection", {req::SRS_CFG_034, req::SRS_CFG_348, req::SRS_TIME_009}, kTwoLate, kLateDevice),
    MakeCase("DigestWithAStaticMapping", {req::SRS_CFG_034, req::SRS_CFG_032}, kStatic, kStaticDevice),
    MakeCase("DigestOfSixtyFourSlots", {req::SRS_CFG_034, req::SRS_CFG_348}, kSixtyFour, kSixtyFourSlots),
};
// clang-format on
} // namespace

const CaseTable kDigestCases = MakeTable("digest", kCases);

} // namespace counterpoint::conformance
