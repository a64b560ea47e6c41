// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Prepare: A reads the normal objects, B the inverse ones; objects of any length. What becomes of sides that are not
// inverse. Node-ID 4: first transmission 2 ms after entering OPERATIONAL.
#include "verification/conformance/gold.hpp"
#include "verification/conformance/stores.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
constexpr Step kP1 = Put(0x6210U, 1U, 0x12U);
constexpr Step kP2 = Put(0x6210U, 2U, 0x34U);
constexpr Step kI1 = Put(0x6211U, 1U, 0xEDU);
constexpr Step kI2 = Put(0x6211U, 2U, 0xCBU);

// Each side alone decides on the frame of its channel; nothing is recorded before it is said.
constexpr Step kOwnSide[] = {
    Configure(), kP1, kP2, Put(0x6211U, 1U, 0x00U), Put(0x6211U, 2U, 0x0FU), Cycle(0U), Request(0U), Cycle(2000U), Due(1U),
    UnequalPair(0U, 0x3412U, 0xF0FFU), UnequalData(0U, 0x3412U, 0xF0FFU), Slot(0U, kProducing, kNoCause, 0U, 0U, 0U),
    Signals(0U, 0U), NotInverse(0U), Slot(0U, kProducing, Cause::kNotInverse, 0U, 1U, 0U), Data(0U, 0U), Signals(0U, 0U),
    Cycle(3000U), Due(0U), Signals(0U, Bit(Cause::kNotInverse)), Signalled(1U), Cycle(4000U), Signals(0U, 0U),
};

// Nor does either look at the other side for its inverse frame.
constexpr Step kOwnInverse[] = {
    Configure(), kP1, kP2, Put(0x6211U, 1U, 0x00U), Put(0x6211U, 2U, 0x0FU), Cycle(0U), Cycle(2000U),
    UnequalPair(0U, 0x3412U, 0xF0FFU), TakeNone(0U), ConfirmOwn(0U, 2100U),
    TakeUnequal(0U, 0x102U, 2U, Payload{0xCBEDU, 0U}, Payload{0x0F00U, 0U}), UnequalData(0U, 0x3412U, 0xF0FFU),
    NotInverse(0U), TakeNone(0U), Slot(0U, kProducing, Cause::kNotInverse, 0U, 1U, 0U),
};

constexpr Step kOwnInverseBits[] = {
    Configure(), Put(0x6402U, 63U, 0x89ABCDEFU, 0xC1234567U), Put(0x6403U, 63U, 0x00000000U, 0x0EDCBA98U), Cycle(0U),
    Cycle(2000U), Unequal(0U, 0x101U, 8U, Payload{0x89ABCDEFU, 0x41234567U}, Payload{0xFFFFFFFFU, 0x71234567U}),
    ConfirmOwn(0U, 2100U),
    TakeUnequal(0U, 0x102U, 8U, Payload{0x76543210U, 0xBEDCBA98U}, Payload{0x00000000U, 0x8EDCBA98U}),
};

// It is in flight like any pair until it is given up: no second Prepare, no due mark, then the silence of the line.
constexpr Step kInFlight[] = {
    Configure(), kP1, kP2, kI1, Put(0x6211U, 2U, 0x4BU), Cycle(0U), Cycle(2000U), UnequalPair(0U, 0x3412U, 0xB412U),
    NotProducing(0U), TakeNone(0U), Request(0U), Cycle(3000U), Due(0U), Cycle(22000U), Due(0U), Signals(0U, 0U),
    Cycle(22001U), Due(1U), Signals(0U, Bit(Cause::kNoConfirmation)), NotInverse(0U),
    Slot(0U, kProducing, Cause::kNoConfirmation, 0U, 1U, 0U),
};

// Given up: a confirmation finds nothing, and no inverse frame is left.
constexpr Step kGivenUp[] = {
    Configure(), kP1, kP2, kI1, Put(0x6211U, 2U, 0U), Cycle(0U), Cycle(2000U), UnequalPair(0U, 0x3412U, 0xFF12U),
    NotInverse(0U), StrangeFirst(2100U), ConfirmNone(0x101U, 2U, 0xFF12U, 0U, 2200U), TakeNone(0U),
    StrangeSecond(2300U), Slot(0U, kProducing, Cause::kNotInverse, 0U, 1U, 0U), kI2, ReadyPair(0U),
    ConfirmFirst(0U, 2400U), TakeSecond(0U), ConfirmSecond(0U, 2500U), Slot(0U, kProducing, Cause::kNotInverse, 1U, 1U, 0U),
};

// Also said of a pair that is on its way; of none in flight it means nothing.
constexpr Step kSaidLater[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), NotInverse(0U), Slot(0U, kProducing, kNoCause, 0U, 0U, 0U),
    ReadyPair(0U), ConfirmFirst(0U, 2100U), NotInverse(0U), Slot(0U, kProducing, Cause::kNotInverse, 0U, 1U, 0U),
    TakeNone(0U), StrangeSecond(2200U), NotInverse(0U), Slot(0U, kProducing, Cause::kNotInverse, 0U, 1U, 0U),
};

constexpr Step kNoConsumer[] = {
    Configure(), Cycle(0U), Cycle(3000U), NotInverse(0U), NotInverse(2U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
    Slot(2U, kOff, kNoCause, 0U, 0U, 0U), Cycle(4000U), Masks(0U, 0U, 1U, 0U, 0U), Signalled(0U),
};

// The first cause is kept, each fault is counted and signalled; an acknowledge clears the cause.
constexpr Step kCounted[] = {
    Configure(), kP1, kP2, kI1, Put(0x6211U, 2U, 0U), Cycle(0U), Cycle(2000U), UnequalPair(0U, 0x3412U, 0xFF12U),
    NotInverse(0U), Cycle(3000U), Signals(0U, Bit(Cause::kNotInverse)), UnequalPair(0U, 0x3412U, 0xFF12U), NotInverse(0U),
    Cycle(4000U), Signals(0U, Bit(Cause::kNotInverse)), Slot(0U, kProducing, Cause::kNotInverse, 0U, 2U, 0U),
    UnequalPair(0U, 0x3412U, 0xFF12U), NotInverse(0U), Cycle(5000U), Signals(0U, Bit(Cause::kNotInverse)),
    Slot(0U, kProducing, Cause::kNotInverse, 0U, 3U, 0U), Acknowledge(1U), Cycle(6000U), Signals(0U, 0U),
    Slot(0U, kProducing, Cause::kNotInverse, 0U, 3U, 0U), Cycle(7000U), Slot(0U, kProducing, kNoCause, 0U, 3U, 0U),
};

// The refresh is used up by a pair that is given up; the phase stays.
constexpr Step kPhaseStays[] = {
    Configure(), kP1, kP2, kI1, Put(0x6211U, 2U, 0U), Cycle(0U), Cycle(2000U), Due(1U), UnequalPair(0U, 0x3412U, 0xFF12U),
    NotInverse(0U), Cycle(26999U), Due(0U), Cycle(27000U), Due(1U), UnequalPair(0U, 0x3412U, 0xFF12U), NotInverse(0U),
    kI2, Cycle(51999U), Due(0U), Cycle(52000U), Due(1U), ReadyPair(0U), Slot(0U, kProducing, Cause::kNotInverse, 0U, 2U, 0U),
};

// ---- objects of any length

// 3, 12, 1 and 7 bits with other bits above them: 5h, ABCh, 1, 55h.
constexpr Step kRow[] = {
    Configure(), Put(0x6402U, 3U, 0xFDU), Put(0x6402U, 12U, 0xFABCU), Put(0x6402U, 1U, 0xFFU), Put(0x6402U, 7U, 0xD5U),
    Put(0x6403U, 3U, 0x0AU), Put(0x6403U, 12U, 0xA543U), Put(0x6403U, 1U, 0xFEU), Put(0x6403U, 7U, 0xAAU),
    Cycle(0U), Cycle(2000U), Ready(0U, CanPortId::kFirst, 0x101U, 3U, 0x55D5E5U), Data(0U, 0x55D5E5U),
    ConfirmNormal(0U, 0x101U, 3U, 0x55D5E5U, 0U, 2100U), TakeInverse(0U, CanPortId::kFirst, 0x102U, 3U, 0xAA2A1AU),
    ConfirmPair(0U, 0x102U, 3U, 0xAA2A1AU, 0U, 2200U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U),
    // The same with those bits the other way round.
    Put(0x6402U, 3U, 0x05U), Put(0x6402U, 12U, 0x0ABCU), Put(0x6402U, 1U, 0x01U), Put(0x6402U, 7U, 0x55U),
    Put(0x6403U, 3U, 0xF2U), Put(0x6403U, 12U, 0x5543U), Put(0x6403U, 1U, 0x00U), Put(0x6403U, 7U, 0x2AU),
    Ready(0U, CanPortId::kFirst, 0x101U, 3U, 0x55D5E5U),
    ConfirmNormal(0U, 0x101U, 3U, 0x55D5E5U, 0U, 2300U), TakeInverse(0U, CanPortId::kFirst, 0x102U, 3U, 0xAA2A1AU),
    // The bit above 23 is expected to be 1 on the bus.
    ConfirmNone(0x102U, 3U, 0x2A2A1AU, 0U, 2400U), Slot(0U, kProducing, Cause::kWrongEcho, 1U, 1U, 0U),
    Ready(0U, CanPortId::kFirst, 0x101U, 3U, 0x55D5E5U), ConfirmNone(0x101U, 3U, 0xD5D5E5U, 0U, 2500U),
    Slot(0U, kProducing, Cause::kWrongEcho, 1U, 2U, 0U),
};

// A bit of each object alone.
constexpr Step kRowNotInverse[] = {
    Configure(), Put(0x6402U, 3U, 0x01U), Put(0x6402U, 12U, 0x0ABCU), Put(0x6402U, 1U, 0x01U), Put(0x6402U, 7U, 0x55U),
    Put(0x6403U, 3U, 0x02U), Put(0x6403U, 12U, 0x0543U), Put(0x6403U, 1U, 0x00U), Put(0x6403U, 7U, 0x2AU), Cycle(0U),
    Cycle(2000U), Unequal(0U, 0x101U, 3U, Payload{0x55D5E1U, 0U}, Payload{0x55D5E5U, 0U}), NotInverse(0U),
    Put(0x6402U, 3U, 0x05U), Put(0x6403U, 12U, 0x0D43U),
    Unequal(0U, 0x101U, 3U, Payload{0x55D5E5U, 0U}, Payload{0x5595E5U, 0U}), NotInverse(0U),
    Put(0x6403U, 12U, 0x0543U), Put(0x6403U, 1U, 0x01U),
    Unequal(0U, 0x101U, 3U, Payload{0x55D5E5U, 0U}, Payload{0x5555E5U, 0U}), NotInverse(0U),
    Put(0x6403U, 1U, 0x00U), Put(0x6402U, 7U, 0x15U),
    Unequal(0U, 0x101U, 3U, Payload{0x15D5E5U, 0U}, Payload{0x55D5E5U, 0U}), NotInverse(0U),
    Put(0x6402U, 7U, 0x55U), Ready(0U, CanPortId::kFirst, 0x101U, 3U, 0x55D5E5U),
    Slot(0U, kProducing, Cause::kNotInverse, 0U, 4U, 0U),
};

// 64 + 64 objects of one bit. Before they are written: nothing set on either side.
constexpr Step kSixtyFour[] = {
    Configure(), Cycle(0U), Cycle(2000U),
    Unequal(0U, 0x101U, 8U, Payload{0U, 0U}, Payload{0xFFFFFFFFU, 0xFFFFFFFFU}), NotInverse(0U),
    Put(0x6404U, 1U, 0x67U), Put(0x6404U, 33U, 0xFFU), Put(0x6405U, 32U, 0x67U), Put(0x6405U, 64U, 0x01U),
    Unequal(0U, 0x101U, 8U, Payload{0x00000001U, 0x00000001U}, Payload{0x7FFFFFFFU, 0x7FFFFFFFU}), NotInverse(0U),
    Put(0x6404U, 1U, 1U), Put(0x6404U, 2U, 0U), Put(0x6404U, 3U, 0U), Put(0x6404U, 4U, 0U), Put(0x6404U, 5U, 0U),
    Put(0x6404U, 6U, 0U), Put(0x6404U, 7U, 0U), Put(0x6404U, 8U, 0U), Put(0x6404U, 9U, 1U), Put(0x6404U, 10U, 1U),
    Put(0x6404U, 11U, 1U), Put(0x6404U, 12U, 1U), Put(0x6404U, 13U, 1U), Put(0x6404U, 14U, 0U),
    Put(0x6404U, 15U, 1U), Put(0x6404U, 16U, 0U), Put(0x6404U, 17U, 0U), Put(0x6404U, 18U, 0U),
    Put(0x6404U, 19U, 1U), Put(0x6404U, 20U, 1U), Put(0x6404U, 21U, 1U), Put(0x6404U, 22U, 1U),
    Put(0x6404U, 23U, 0U), Put(0x6404U, 24U, 0U), Put(0x6404U, 25U, 0U), Put(0x6404U, 26U, 1U),
    Put(0x6404U, 27U, 0U), Put(0x6404U, 28U, 1U), Put(0x6404U, 29U, 1U), Put(0x6404U, 30U, 0U),
    Put(0x6404U, 31U, 0U), Put(0x6404U, 32U, 1U), Put(0x6404U, 33U, 0U), Put(0x6404U, 34U, 1U),
    Put(0x6404U, 35U, 0U), Put(0x6404U, 36U, 1U), Put(0x6404U, 37U, 0U), Put(0x6404U, 38U, 0U),
    Put(0x6404U, 39U, 0U), Put(0x6404U, 40U, 0U), Put(0x6404U, 41U, 0U), Put(0x6404U, 42U, 0U),
    Put(0x6404U, 43U, 0U), Put(0x6404U, 44U, 0U), Put(0x6404U, 45U, 0U), Put(0x6404U, 46U, 0U),
    Put(0x6404U, 47U, 1U), Put(0x6404U, 48U, 1U), Put(0x6404U, 49U, 0U), Put(0x6404U, 50U, 0U),
    Put(0x6404U, 51U, 0U), Put(0x6404U, 52U, 0U), Put(0x6404U, 53U, 0U), Put(0x6404U, 54U, 0U),
    Put(0x6404U, 55U, 0U), Put(0x6404U, 56U, 0U), Put(0x6404U, 57U, 0U), Put(0x6404U, 58U, 0U),
    Put(0x6404U, 59U, 0U), Put(0x6404U, 60U, 0U), Put(0x6404U, 61U, 0U), Put(0x6404U, 62U, 0U),
    Put(0x6404U, 63U, 0U), Put(0x6404U, 64U, 1U),
    Put(0x6405U, 1U, 0U), Put(0x6405U, 2U, 1U), Put(0x6405U, 3U, 1U), Put(0x6405U, 4U, 1U), Put(0x6405U, 5U, 1U),
    Put(0x6405U, 6U, 1U), Put(0x6405U, 7U, 1U), Put(0x6405U, 8U, 1U), Put(0x6405U, 9U, 0U), Put(0x6405U, 10U, 0U),
    Put(0x6405U, 11U, 0U), Put(0x6405U, 12U, 0U), Put(0x6405U, 13U, 0U), Put(0x6405U, 14U, 1U),
    Put(0x6405U, 15U, 0U), Put(0x6405U, 16U, 1U), Put(0x6405U, 17U, 1U), Put(0x6405U, 18U, 1U),
    Put(0x6405U, 19U, 0U), Put(0x6405U, 20U, 0U), Put(0x6405U, 21U, 0U), Put(0x6405U, 22U, 0U),
    Put(0x6405U, 23U, 1U), Put(0x6405U, 24U, 1U), Put(0x6405U, 25U, 1U), Put(0x6405U, 26U, 0U),
    Put(0x6405U, 27U, 1U), Put(0x6405U, 28U, 0U), Put(0x6405U, 29U, 0U), Put(0x6405U, 30U, 1U),
    Put(0x6405U, 31U, 1U), Put(0x6405U, 32U, 0U), Put(0x6405U, 33U, 1U), Put(0x6405U, 34U, 0U),
    Put(0x6405U, 35U, 1U), Put(0x6405U, 36U, 0U), Put(0x6405U, 37U, 1U), Put(0x6405U, 38U, 1U),
    Put(0x6405U, 39U, 1U), Put(0x6405U, 40U, 1U), Put(0x6405U, 41U, 1U), Put(0x6405U, 42U, 1U),
    Put(0x6405U, 43U, 1U), Put(0x6405U, 44U, 1U), Put(0x6405U, 45U, 1U), Put(0x6405U, 46U, 1U),
    Put(0x6405U, 47U, 0U), Put(0x6405U, 48U, 0U), Put(0x6405U, 49U, 1U), Put(0x6405U, 50U, 1U),
    Put(0x6405U, 51U, 1U), Put(0x6405U, 52U, 1U), Put(0x6405U, 53U, 1U), Put(0x6405U, 54U, 1U),
    Put(0x6405U, 55U, 1U), Put(0x6405U, 56U, 1U), Put(0x6405U, 57U, 1U), Put(0x6405U, 58U, 1U),
    Put(0x6405U, 59U, 1U), Put(0x6405U, 60U, 1U), Put(0x6405U, 61U, 1U), Put(0x6405U, 62U, 1U),
    Put(0x6405U, 63U, 1U), Put(0x6405U, 64U, 0U),
    Ready(0U, CanPortId::kFirst, 0x101U, 8U, 0x9A3C5F01U, 0x8000C00AU),
    ConfirmNormal(0U, 0x101U, 8U, 0x9A3C5F01U, 0x8000C00AU, 2100U),
    TakeInverse(0U, CanPortId::kFirst, 0x102U, 8U, 0x65C3A0FEU, 0x7FFF3FF5U),
    ConfirmPair(0U, 0x102U, 8U, 0x65C3A0FEU, 0x7FFF3FF5U, 2200U), Slot(0U, kProducing, Cause::kNotInverse, 1U, 2U, 0U),
    Recheck(0U, ConfigFault::kNone, 0x7284U),
};

// 63 bits: bit 63 is 0 in the normal and 1 in the inverse frame, whatever is above the objects.
constexpr Step kSixtyThree[] = {
    Configure(), Put(0x6402U, 63U, 0x89ABCDEFU, 0xC1234567U), Put(0x6403U, 63U, 0x76543210U, 0x3EDCBA98U), Cycle(0U),
    Cycle(2000U), Ready(0U, CanPortId::kFirst, 0x101U, 8U, 0x89ABCDEFU, 0x41234567U),
    ConfirmNormal(0U, 0x101U, 8U, 0x89ABCDEFU, 0x41234567U, 2100U),
    TakeInverse(0U, CanPortId::kFirst, 0x102U, 8U, 0x76543210U, 0xBEDCBA98U),
    ConfirmPair(0U, 0x102U, 8U, 0x76543210U, 0xBEDCBA98U, 2200U), Put(0x6403U, 63U, 0x76543210U, 0xFEDCBA98U),
    Unequal(0U, 0x101U, 8U, Payload{0x89ABCDEFU, 0x41234567U}, Payload{0x89ABCDEFU, 0x01234567U}), NotInverse(0U),
    Slot(0U, kProducing, Cause::kNotInverse, 1U, 1U, 0U),
};

constexpr Step kSplit[] = {
    Configure(), Put(0x6402U, 33U, 0x89ABCDEFU, 0xFEU), Put(0x6402U, 31U, 0xE091A2B3U),
    Put(0x6403U, 33U, 0x76543210U, 0x01U), Put(0x6403U, 31U, 0x1F6E5D4CU), Cycle(0U), Cycle(2000U),
    Ready(0U, CanPortId::kFirst, 0x101U, 8U, 0x89ABCDEFU, 0xC1234566U),
    ConfirmNormal(0U, 0x101U, 8U, 0x89ABCDEFU, 0xC1234566U, 2100U),
    TakeInverse(0U, CanPortId::kFirst, 0x102U, 8U, 0x76543210U, 0x3EDCBA99U),
};

// Two words a side; then one bit of each word of each side.
constexpr Step kTwoWords[] = {
    StoreAll(), Entry(0U, 1U, 0x64000420U), Entry(0U, 2U, 0x64010420U), Entry(0U, 3U, 0x64022020U),
    Entry(0U, 4U, 0x64032020U), MapCount(0U, 4U), Signature(0U, 0xD39BU), Validate(0U, ConfigFault::kNone, 0xD39BU),
    Store(0U, ConfigField::kConfigurationValid, 0xA5U), Put(0x6400U, 4U, 0x44332211U), Put(0x6401U, 4U, 0xBBCCDDEEU),
    Put(0x6402U, 32U, 0x88776655U), Put(0x6403U, 32U, 0x778899AAU), Cycle(0U), Cycle(2000U),
    Ready(0U, CanPortId::kFirst, 0x101U, 8U, 0x44332211U, 0x88776655U),
    ConfirmNormal(0U, 0x101U, 8U, 0x44332211U, 0x88776655U, 2100U),
    TakeInverse(0U, CanPortId::kFirst, 0x102U, 8U, 0xBBCCDDEEU, 0x778899AAU),
    ConfirmPair(0U, 0x102U, 8U, 0xBBCCDDEEU, 0x778899AAU, 2200U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U),
    Put(0x6402U, 32U, 0x08776655U), Put(0x6401U, 4U, 0xBBCCDDEFU),
    Unequal(0U, 0x101U, 8U, Payload{0x44332211U, 0x08776655U}, Payload{0x44332210U, 0x88776655U}), NotInverse(0U),
    Slot(0U, kProducing, Cause::kNotInverse, 1U, 1U, 0U),
};

constexpr Case kCases[] = {
    MakeCase("EachSideIsReadByItsOwner", {req::SRS_PROD_005, req::SRS_PROD_009, req::SRS_CONS_025}, kSender, kOwnSide),
    MakeCase("EachInverseFrameIsOfItsOwnSide", {req::SRS_PROD_006, req::SRS_PROD_007}, kSender, kOwnInverse),
    MakeCase("BitsOfEachInverseFrame", {req::SRS_PROD_006, req::SRS_CFG_036}, kBits63Sender, kOwnInverseBits),
    MakeCase("UnequalSidesAreInFlight", {req::SRS_PROD_005, req::SRS_PROD_008, req::SRS_PROD_004}, kSender, kInFlight),
    MakeCase("UnequalSidesAreGivenUp", {req::SRS_PROD_009, req::SRS_PROD_006, req::SRS_PROD_007}, kSender, kGivenUp),
    MakeCase("NotInverseSaidOfAPairOnItsWay", {req::SRS_PROD_009}, kSender, kSaidLater),
    MakeCase("NotInverseSaidOfAConsumer", {req::SRS_PROD_009}, kMixed, kNoConsumer),
    MakeCase("NotInverseIsCountedAndSignalled", {req::SRS_PROD_009, req::SRS_CONS_021}, kSender, kCounted),
    MakeCase("NotInverseUsesUpTheRefresh", {req::SRS_PROD_005, req::SRS_PROD_010, req::SRS_PROD_002}, kProvider,
             kPhaseStays),
    MakeCase("TwoWordsAreSent", {req::SRS_PROD_005, req::SRS_PROD_006}, kSender, kTwoWords),
    MakeCase("BitsAcrossBordersAreSent", {req::SRS_PROD_005, req::SRS_CFG_036, req::SRS_PROD_007}, kBitRowSender, kRow),
    MakeCase("BitsThatAreNotInverse", {req::SRS_PROD_005, req::SRS_CFG_036}, kBitRowSender, kRowNotInverse),
    MakeCase("SixtyFourBitsAreSent", {req::SRS_PROD_005, req::SRS_PROD_006, req::SRS_CFG_036}, kBits64Sender,
             kSixtyFour),
    MakeCase("SixtyThreeBitsAreSent", {req::SRS_PROD_005, req::SRS_PROD_006, req::SRS_CFG_036}, kBits63Sender,
             kSixtyThree),
    MakeCase("BitsAcrossTheWordsAreSent", {req::SRS_PROD_005, req::SRS_CFG_036}, kSplitSender, kSplit),
};
// clang-format on
} // namespace

const CaseTable kSideCases = MakeTable("sides", kCases);

} // namespace counterpoint::conformance
