// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Dummy entries: data that this device does not need. Granularity of one bit unless said otherwise.
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

// Each data type with its length, alone and in a pair of two types of one length.
constexpr Step kTypes[] = {
    StoreAll(),
    Entry(0U, 1U, 0x00010001U), Entry(0U, 2U, 0x00010001U), MapCount(0U, 2U), Signature(0U, 0x8021U),
    Validate(0U, kSound, 0x8021U),
    Entry(0U, 1U, 0x00020008U), Entry(0U, 2U, 0x00020008U), MapCount(0U, 2U), Signature(0U, 0x3C5BU),
    Validate(0U, kSound, 0x3C5BU),
    Entry(0U, 1U, 0x00030010U), Entry(0U, 2U, 0x00030010U), MapCount(0U, 2U), Signature(0U, 0x536EU),
    Validate(0U, kSound, 0x536EU),
    Entry(0U, 1U, 0x00040020U), Entry(0U, 2U, 0x00040020U), MapCount(0U, 2U), Signature(0U, 0x0B56U),
    Validate(0U, kSound, 0x0B56U),
    Entry(0U, 1U, 0x00050008U), Entry(0U, 2U, 0x00050008U), MapCount(0U, 2U), Signature(0U, 0xBC88U),
    Validate(0U, kSound, 0xBC88U),
    Entry(0U, 1U, 0x00060010U), Entry(0U, 2U, 0x00060010U), MapCount(0U, 2U), Signature(0U, 0xD53CU),
    Validate(0U, kSound, 0xD53CU),
    Entry(0U, 1U, 0x00070020U), Entry(0U, 2U, 0x00070020U), MapCount(0U, 2U), Signature(0U, 0x8687U),
    Validate(0U, kSound, 0x8687U),
    Entry(0U, 1U, 0x00020008U), Entry(0U, 2U, 0x00050008U), MapCount(0U, 2U), Signature(0U, 0xA5CCU),
    Validate(0U, kSound, 0xA5CCU),
    Entry(0U, 1U, 0x00060010U), Entry(0U, 2U, 0x00030010U), MapCount(0U, 2U), Signature(0U, 0x2AC9U),
    Validate(0U, kSound, 0x2AC9U),
    Entry(0U, 1U, 0x00040020U), Entry(0U, 2U, 0x00070020U), MapCount(0U, 2U), Signature(0U, 0x5E05U),
    Validate(0U, kSound, 0x5E05U),
};

// Each with a length that is another's.
constexpr Step kTypeLengths[] = {
    StoreAll(),
    Entry(0U, 1U, 0x00010008U), Entry(0U, 2U, 0x00010008U), MapCount(0U, 2U), Signature(0U, 0xB18AU),
    Validate(0U, kBadMap, 0xB18AU),
    Entry(0U, 1U, 0x00010002U), Entry(0U, 2U, 0x00010002U), MapCount(0U, 2U), Signature(0U, 0x36B9U),
    Validate(0U, kBadMap, 0x36B9U),
    Entry(0U, 1U, 0x00010000U), Entry(0U, 2U, 0x00010000U), MapCount(0U, 2U), Signature(0U, 0x1DB6U),
    Validate(0U, kBadMap, 0x1DB6U),
    Entry(0U, 1U, 0x00020001U), Entry(0U, 2U, 0x00020001U), MapCount(0U, 2U), Signature(0U, 0x0DF0U),
    Validate(0U, kBadMap, 0x0DF0U),
    Entry(0U, 1U, 0x00020010U), Entry(0U, 2U, 0x00020010U), MapCount(0U, 2U), Signature(0U, 0xD83EU),
    Validate(0U, kBadMap, 0xD83EU),
    Entry(0U, 1U, 0x00020007U), Entry(0U, 2U, 0x00020007U), MapCount(0U, 2U), Signature(0U, 0x70E1U),
    Validate(0U, kBadMap, 0x70E1U),
    Entry(0U, 1U, 0x00030008U), Entry(0U, 2U, 0x00030008U), MapCount(0U, 2U), Signature(0U, 0xB70BU),
    Validate(0U, kBadMap, 0xB70BU),
    Entry(0U, 1U, 0x00030020U), Entry(0U, 2U, 0x00030020U), MapCount(0U, 2U), Signature(0U, 0x8B85U),
    Validate(0U, kBadMap, 0x8B85U),
    Entry(0U, 1U, 0x00040010U), Entry(0U, 2U, 0x00040010U), MapCount(0U, 2U), Signature(0U, 0xD3BDU),
    Validate(0U, kBadMap, 0xD3BDU),
    Entry(0U, 1U, 0x00040040U), Entry(0U, 2U, 0x00040040U), MapCount(0U, 2U), Signature(0U, 0xAAA1U),
    Validate(0U, kBadMap, 0xAAA1U),
    Entry(0U, 1U, 0x0004001FU), Entry(0U, 2U, 0x0004001FU), MapCount(0U, 2U), Signature(0U, 0x9F07U),
    Validate(0U, kBadMap, 0x9F07U),
    Entry(0U, 1U, 0x00050010U), Entry(0U, 2U, 0x00050010U), MapCount(0U, 2U), Signature(0U, 0x58EDU),
    Validate(0U, kBadMap, 0x58EDU),
    Entry(0U, 1U, 0x00050009U), Entry(0U, 2U, 0x00050009U), MapCount(0U, 2U), Signature(0U, 0x211FU),
    Validate(0U, kBadMap, 0x211FU),
    Entry(0U, 1U, 0x00060020U), Entry(0U, 2U, 0x00060020U), MapCount(0U, 2U), Signature(0U, 0x0DD7U),
    Validate(0U, kBadMap, 0x0DD7U),
    Entry(0U, 1U, 0x00060008U), Entry(0U, 2U, 0x00060008U), MapCount(0U, 2U), Signature(0U, 0x3159U),
    Validate(0U, kBadMap, 0x3159U),
    Entry(0U, 1U, 0x00070040U), Entry(0U, 2U, 0x00070040U), MapCount(0U, 2U), Signature(0U, 0x2770U),
    Validate(0U, kBadMap, 0x2770U),
    Entry(0U, 1U, 0x00070010U), Entry(0U, 2U, 0x00070010U), MapCount(0U, 2U), Signature(0U, 0x5E6CU),
    Validate(0U, kBadMap, 0x5E6CU),
    Entry(0U, 1U, 0x00070020U), Entry(0U, 2U, 0x00070020U), MapCount(0U, 2U), Signature(0U, 0x8687U),
    Validate(0U, kSound, 0x8687U),
};

// Not every index below the objects is a dummy, and none has sub-indices.
constexpr Step kOtherIndices[] = {
    StoreAll(),
    Entry(0U, 1U, 0x00000008U), Entry(0U, 2U, 0x00000008U), MapCount(0U, 2U), Signature(0U, 0x3ADAU),
    Validate(0U, kBadMap, 0x3ADAU),
    Entry(0U, 1U, 0x00080020U), Entry(0U, 2U, 0x00080020U), MapCount(0U, 2U), Signature(0U, 0x1C50U),
    Validate(0U, kBadMap, 0x1C50U),
    Entry(0U, 1U, 0x00080008U), Entry(0U, 2U, 0x00080008U), MapCount(0U, 2U), Signature(0U, 0x20DEU),
    Validate(0U, kBadMap, 0x20DEU),
    Entry(0U, 1U, 0x00090008U), Entry(0U, 2U, 0x00090008U), MapCount(0U, 2U), Signature(0U, 0xAB8EU),
    Validate(0U, kBadMap, 0xAB8EU),
    Entry(0U, 1U, 0x001B0040U), Entry(0U, 2U, 0x001B0040U), MapCount(0U, 2U), Signature(0U, 0x047EU),
    Validate(0U, kBadMap, 0x047EU),
    Entry(0U, 1U, 0x00050108U), Entry(0U, 2U, 0x00050108U), MapCount(0U, 2U), Signature(0U, 0xCC6BU),
    Validate(0U, kBadMap, 0xCC6BU),
    Entry(0U, 1U, 0x0005FF08U), Entry(0U, 2U, 0x00050008U), MapCount(0U, 2U), Signature(0U, 0x28C7U),
    Validate(0U, kBadMap, 0x28C7U),
    Entry(0U, 1U, 0x00050008U), Entry(0U, 2U, 0x00050108U), MapCount(0U, 2U), Signature(0U, 0x8BB8U),
    Validate(0U, kBadMap, 0x8BB8U),
    Entry(0U, 1U, 0x00010101U), Entry(0U, 2U, 0x00010101U), MapCount(0U, 2U), Signature(0U, 0xF0C2U),
    Validate(0U, kBadMap, 0xF0C2U),
    Entry(0U, 1U, 0x01050008U), Entry(0U, 2U, 0x01050008U), MapCount(0U, 2U), Signature(0U, 0xE909U),
    Validate(0U, kBadMap, 0xE909U),
    Entry(0U, 1U, 0x80050008U), Entry(0U, 2U, 0x80050008U), MapCount(0U, 2U), Signature(0U, 0xF920U),
    Validate(0U, kBadMap, 0xF920U),
    Entry(0U, 1U, 0x00050008U), Entry(0U, 2U, 0x00050008U), MapCount(0U, 2U), Signature(0U, 0xBC88U),
    Validate(0U, kSound, 0xBC88U),
};

// Both of a pair, or neither.
constexpr Step kHalf[] = {
    StoreAll(),
    Entry(0U, 1U, 0x00050008U), Entry(0U, 2U, 0x60110108U), MapCount(0U, 2U), Signature(0U, 0x28A9U),
    Validate(0U, kBadMap, 0x28A9U),
    Entry(0U, 1U, 0x60100108U), Entry(0U, 2U, 0x00050008U), MapCount(0U, 2U), Signature(0U, 0xEA9FU),
    Validate(0U, kBadMap, 0xEA9FU),
    Entry(0U, 1U, 0x60100108U), Entry(0U, 2U, 0x60110108U), Entry(0U, 3U, 0x00050008U), Entry(0U, 4U, 0x60110208U),
    MapCount(0U, 4U), Signature(0U, 0xDD12U), Validate(0U, kBadMap, 0xDD12U),
    Entry(0U, 1U, 0x60100108U), Entry(0U, 2U, 0x60110108U), Entry(0U, 3U, 0x60100208U), Entry(0U, 4U, 0x00050008U),
    MapCount(0U, 4U), Signature(0U, 0x8E01U), Validate(0U, kBadMap, 0x8E01U),
    Entry(0U, 1U, 0x00050008U), Entry(0U, 2U, 0x00030010U), MapCount(0U, 2U), Signature(0U, 0x884AU),
    Validate(0U, kBadMap, 0x884AU),
    Entry(0U, 1U, 0x00040020U), Entry(0U, 2U, 0x00060010U), MapCount(0U, 2U), Signature(0U, 0x41DDU),
    Validate(0U, kBadMap, 0x41DDU),
    Entry(0U, 1U, 0x00010001U), Entry(0U, 2U, 0x00020008U), MapCount(0U, 2U), Signature(0U, 0x2605U),
    Validate(0U, kBadMap, 0x2605U),
    Entry(0U, 1U, 0x60100108U), Entry(0U, 2U, 0x60110108U), Entry(0U, 3U, 0x00050008U), Entry(0U, 4U, 0x00050008U),
    MapCount(0U, 4U), Signature(0U, 0x1063U), Validate(0U, kSound, 0x1063U),
};

// A dummy may be named as often as one likes; a real object still may not.
constexpr Step kOften[] = {
    StoreAll(),
    Entry(0U, 1U, 0x00050008U), Entry(0U, 2U, 0x00050008U), Entry(0U, 3U, 0x00050008U), Entry(0U, 4U, 0x00050008U),
    Entry(0U, 5U, 0x00050008U), Entry(0U, 6U, 0x00050008U), Entry(0U, 7U, 0x00050008U), Entry(0U, 8U, 0x00050008U),
    Entry(0U, 9U, 0x00050008U), Entry(0U, 10U, 0x00050008U), Entry(0U, 11U, 0x00050008U),
    Entry(0U, 12U, 0x00050008U), Entry(0U, 13U, 0x00050008U), Entry(0U, 14U, 0x00050008U),
    Entry(0U, 15U, 0x00050008U), Entry(0U, 16U, 0x00050008U), MapCount(0U, 16U), Signature(0U, 0xF0AFU),
    Validate(0U, kSound, 0xF0AFU),
    Entry(0U, 1U, 0x00050008U), Entry(0U, 2U, 0x00050008U), Entry(0U, 3U, 0x00050008U), Entry(0U, 4U, 0x00050008U),
    Entry(0U, 5U, 0x60100108U), Entry(0U, 6U, 0x60110108U), MapCount(0U, 6U), Signature(0U, 0xA23EU),
    Validate(0U, kSound, 0xA23EU),
    Entry(0U, 1U, 0x60100108U), Entry(0U, 2U, 0x60110108U), Entry(0U, 3U, 0x00050008U), Entry(0U, 4U, 0x00050008U),
    Entry(0U, 5U, 0x60100108U), Entry(0U, 6U, 0x60110208U), MapCount(0U, 6U), Signature(0U, 0xF379U),
    Validate(0U, kBadMap, 0xF379U),
};

constexpr Step kTotal[] = {
    StoreAll(),
    Entry(0U, 1U, 0x00070020U), Entry(0U, 2U, 0x00070020U), Entry(0U, 3U, 0x00070020U), Entry(0U, 4U, 0x00070020U),
    MapCount(0U, 4U), Signature(0U, 0x6D4CU), Validate(0U, kSound, 0x6D4CU),
    Entry(0U, 1U, 0x00070020U), Entry(0U, 2U, 0x00070020U), Entry(0U, 3U, 0x00070020U), Entry(0U, 4U, 0x00070020U),
    Entry(0U, 5U, 0x00010001U), Entry(0U, 6U, 0x00010001U), MapCount(0U, 6U), Signature(0U, 0x3CA4U),
    Validate(0U, ConfigFault::kLengthExceeded, 0x3CA4U),
    Entry(0U, 1U, 0x00070020U), Entry(0U, 2U, 0x00070020U), Entry(0U, 3U, 0x00070020U), Entry(0U, 4U, 0x00070020U),
    Entry(0U, 5U, 0x00010001U), Entry(0U, 6U, 0x00020008U), MapCount(0U, 6U), Signature(0U, 0x9A80U),
    Validate(0U, kBadMap, 0x9A80U),
    Entry(0U, 1U, 0x00070020U), Entry(0U, 2U, 0x00070020U), Entry(0U, 3U, 0x00030010U), Entry(0U, 4U, 0x00030010U),
    Entry(0U, 5U, 0x00020008U), Entry(0U, 6U, 0x00020008U), Entry(0U, 7U, 0x00010001U), Entry(0U, 8U, 0x00010001U),
    Entry(0U, 9U, 0x63020707U), Entry(0U, 10U, 0x63030707U), MapCount(0U, 10U), Signature(0U, 0xE15FU),
    Validate(0U, kSound, 0xE15FU),
};

// The granularity holds for dummies, too.
constexpr Step kGranular[] = {
    Alter(Parameter::kGranularity, 8U), StoreAll(),
    Entry(0U, 1U, 0x00010001U), Entry(0U, 2U, 0x00010001U), MapCount(0U, 2U), Signature(0U, 0x8021U),
    Validate(0U, kBadMap, 0x8021U),
    Entry(0U, 1U, 0x00020008U), Entry(0U, 2U, 0x00020008U), MapCount(0U, 2U), Signature(0U, 0x3C5BU),
    Validate(0U, kSound, 0x3C5BU),
    Alter(Parameter::kGranularity, 16U), StoreAll(),
    Entry(0U, 1U, 0x00050008U), Entry(0U, 2U, 0x00050008U), MapCount(0U, 2U), Signature(0U, 0xBC88U),
    Validate(0U, kBadMap, 0xBC88U),
    Entry(0U, 1U, 0x00060010U), Entry(0U, 2U, 0x00060010U), MapCount(0U, 2U), Signature(0U, 0xD53CU),
    Validate(0U, kSound, 0xD53CU),
    Alter(Parameter::kGranularity, 32U), StoreAll(),
    Entry(0U, 1U, 0x00030010U), Entry(0U, 2U, 0x00030010U), MapCount(0U, 2U), Signature(0U, 0x536EU),
    Validate(0U, kBadMap, 0x536EU),
    Entry(0U, 1U, 0x00040020U), Entry(0U, 2U, 0x00040020U), MapCount(0U, 2U), Signature(0U, 0x0B56U),
    Validate(0U, kSound, 0x0B56U),
    Alter(Parameter::kGranularity, 64U), StoreAll(),
    Entry(0U, 1U, 0x00070020U), Entry(0U, 2U, 0x00070020U), MapCount(0U, 2U), Signature(0U, 0x8687U),
    Validate(0U, kBadMap, 0x8687U),
    Entry(0U, 1U, 0x63000840U), Entry(0U, 2U, 0x63010840U), MapCount(0U, 2U), Signature(0U, 0xEED4U),
    Validate(0U, kSound, 0xEED4U),
};

// Only where the device allows them; another value than kAllowed does not.
constexpr Step kRefused[] = {
    Alter(Parameter::kDummyMapping, 0U), StoreAll(),
    Entry(0U, 1U, 0x00050008U), Entry(0U, 2U, 0x00050008U), MapCount(0U, 2U), Signature(0U, 0xBC88U),
    Validate(0U, kBadMap, 0xBC88U),
    Entry(0U, 1U, 0x00010001U), Entry(0U, 2U, 0x00010001U), MapCount(0U, 2U), Signature(0U, 0x8021U),
    Validate(0U, kBadMap, 0x8021U),
    Alter(Parameter::kDummyMapping, 0x67U), StoreAll(),
    Entry(0U, 1U, 0x00050008U), Entry(0U, 2U, 0x00050008U), MapCount(0U, 2U), Signature(0U, 0xBC88U),
    Validate(0U, kBadMap, 0xBC88U),
    Alter(Parameter::kDummyMapping, 0x66U), StoreAll(),
    Entry(0U, 1U, 0x00050008U), Entry(0U, 2U, 0x00050008U), MapCount(0U, 2U), Signature(0U, 0xBC88U),
    Validate(0U, kSound, 0xBC88U),
};

// A producer sends what it has: no dummies.
constexpr Step kNoProducer[] = {
    StoreAll(), Direction(0U, 1U), Sct(0U, 1000U),
    Entry(0U, 1U, 0x00050008U), Entry(0U, 2U, 0x00050008U), MapCount(0U, 2U), Signature(0U, 0x2A34U),
    Validate(0U, kBadMap, 0x2A34U),
    Entry(0U, 1U, 0x62100108U), Entry(0U, 2U, 0x62110108U), Entry(0U, 3U, 0x00050008U), Entry(0U, 4U, 0x00050008U),
    MapCount(0U, 4U), Signature(0U, 0x0D04U), Validate(0U, kBadMap, 0x0D04U),
    Entry(0U, 1U, 0x62100108U), Entry(0U, 2U, 0x62110108U), MapCount(0U, 2U), Signature(0U, 0x4300U),
    Validate(0U, kSound, 0x4300U),
};

// 6010h:01, dummy 8, 6010h:02, dummy 1, dummy 32: 57 bits, seven free. Dummy bits come and go, nothing is written.
constexpr Step kData[] = {
    Configure(), Recheck(0U, kSound, 0x3679U), NormalObject(0x6010U, 1U, 0xA5U), NormalObject(0x6010U, 2U, 0xC3U),
    InverseObject(0x6011U, 1U, 0x5AU), InverseObject(0x6011U, 2U, 0x3CU), Cycle(0U),
    Frame(0x111U, 8U, 0xC7345A12U, 0x01ABCDEFU, 1000U), Frame(0x112U, 8U, 0x38CBA5EDU, 0xFE543210U, 2000U),
    Data(0U, 0xC7345A12U, 0x01ABCDEFU), Cycle(3000U), Masks(1U, 0U, 0U, 0U, 1U), Commit(1U, 1U),
    NormalObject(0x6010U, 1U, 0x12U), NormalObject(0x6010U, 2U, 0x34U), InverseObject(0x6011U, 1U, 0xEDU),
    InverseObject(0x6011U, 2U, 0xCBU), Recheck(0U, kSound, 0x3679U), Commit(0U, 0U),
    NormalObject(0x6010U, 1U, 0xA5U), NormalObject(0x6010U, 2U, 0xC3U), InverseObject(0x6011U, 1U, 0x5AU),
    InverseObject(0x6011U, 2U, 0x3CU),
};

// Bits of each dummy, and those behind the last.
constexpr Step kInverted[] = {
    Configure(), Cycle(0U),
    Frame(0x111U, 8U, 0xC7345A12U, 0x01ABCDEFU, 1000U), Frame(0x112U, 8U, 0x38CBA4EDU, 0xFE543210U, 1001U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 1U, 0U),
    Frame(0x111U, 8U, 0xC7345A12U, 0x01ABCDEFU, 1002U), Frame(0x112U, 8U, 0x38CB25EDU, 0xFE543210U, 1003U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 2U, 0U),
    Frame(0x111U, 8U, 0xC7345A12U, 0x01ABCDEFU, 1004U), Frame(0x112U, 8U, 0x39CBA5EDU, 0xFE543210U, 1005U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 3U, 0U),
    Frame(0x111U, 8U, 0xC7345A12U, 0x01ABCDEFU, 1006U), Frame(0x112U, 8U, 0x3ACBA5EDU, 0xFE543210U, 1007U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 4U, 0U),
    Frame(0x111U, 8U, 0xC7345A12U, 0x01ABCDEFU, 1008U), Frame(0x112U, 8U, 0x38CBA5EDU, 0xFF543210U, 1009U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 5U, 0U),
    Frame(0x111U, 8U, 0xC7345A12U, 0x01ABCDEFU, 1010U), Frame(0x112U, 8U, 0x38CBA5EDU, 0xFC543210U, 1011U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 6U, 0U),
    Frame(0x111U, 8U, 0xC7345A12U, 0x81ABCDEFU, 1012U), Frame(0x112U, 8U, 0x38CBA5EDU, 0x7E543210U, 1013U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 7U, 0U),
    Frame(0x111U, 8U, 0xC7345A12U, 0x01ABCDEFU, 1014U), Frame(0x112U, 8U, 0x38CBA5EDU, 0xFE543210U, 1015U),
    Slot(0U, kFaulted, Cause::kNotInverse, 1U, 7U, 1U),
};

// Nothing but dummies: a pair as any other, of which nothing is written.
constexpr Step kNothingElse[] = {
    StoreAll(),
    Entry(0U, 1U, 0x00020008U), Entry(0U, 2U, 0x00050008U), MapCount(0U, 2U), Signature(0U, 0xA5CCU),
    Validate(0U, kSound, 0xA5CCU),
    Store(0U, ConfigField::kConfigurationValid, 0xA5U), Cycle(0U), Frame(0x111U, 1U, 0x12U, 0U, 1000U),
    Frame(0x112U, 1U, 0xEDU, 0U, 2000U), Data(0U, 0x12U), Cycle(3000U), Masks(1U, 0U, 0U, 0U, 1U), Commit(1U, 1U),
    NormalObject(0x6010U, 1U, 0x66U), InverseObject(0x6011U, 1U, 0x66U), Recheck(0U, kSound, 0xA5CCU),
    Commit(0U, 0U), Frame(0x111U, 1U, 0x12U, 0U, 4000U), Frame(0x112U, 1U, 0xECU, 0U, 5000U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 1U, 0U),
};

constexpr Case kCases[] = {
    MakeCase("DummyTypes", {req::SRS_CFG_033, req::SRS_CFG_027}, kDummies, kTypes),
    MakeCase("DummyTypesOfWrongLength", {req::SRS_CFG_033}, kDummies, kTypeLengths),
    MakeCase("DummyIndicesAndSubIndices", {req::SRS_CFG_033}, kDummies, kOtherIndices),
    MakeCase("DummyPairs", {req::SRS_CFG_033, req::SRS_CFG_027}, kDummies, kHalf),
    MakeCase("DummyNamedTwice", {req::SRS_CFG_027, req::SRS_CFG_033}, kDummies, kOften),
    MakeCase("DummyTotalLength", {req::SRS_CFG_028, req::SRS_CFG_033}, kDummies, kTotal),
    MakeCase("DummyGranularity", {req::SRS_CFG_027, req::SRS_CFG_033}, kDummies, kGranular),
    MakeCase("DummyNotAllowed", {req::SRS_CFG_033}, kDummies, kRefused),
    MakeCase("DummyOfAProducer", {req::SRS_CFG_033}, kDummies, kNoProducer),
    MakeCase("DummyBitsAreNotWritten", {req::SRS_CFG_033, req::SRS_REL_002, req::SRS_CFG_030, req::SRS_CFG_036},
             kDummies, kData),
    MakeCase("DummyBitsAreInverted", {req::SRS_CONS_009, req::SRS_CFG_033}, kDummies, kInverted),
    MakeCase("DummyEntriesOnly", {req::SRS_CFG_033, req::SRS_CFG_030, req::SRS_REL_002}, kDummies, kNothingElse),
};
// clang-format on
} // namespace

const CaseTable kDummyCases = MakeTable("dummy", kCases);

} // namespace counterpoint::conformance
