// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Confirmation of what was sent, and the faults of a producer. SRVT 20 ms, refresh 25 ms. Times in microseconds.
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

constexpr Step kStrangers[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), StrangeFirst(100U), Cycle(2000U),
    ReadyPair(0U), ConfirmNone(0x103U, 2U, 0x3412U, 0U, 2002U), ConfirmNone(0x001U, 0U, 0U, 0U, 2003U),
    StrangeSecond(2004U),
    ConfirmNone(0x80000101U, 2U, 0x3412U, 0U, 2005U), ConfirmNone(0x7FFU, 2U, 0x3412U, 0U, 2006U),
    OfKind(StrangeFirst(2007U), FrameKind::kRemote),
    OfKind(StrangeFirst(2008U), FrameKind::kExtended),
    OfKind(ConfirmNone(0x101U, 2U, 0U, 0U, 2009U), FrameKind::kExtendedRemote),
    OfKind(ConfirmNone(0x101U, 8U, 0U, 0U, 2010U), FrameKind::kFlexibleDataRate),
    OfKind(StrangeFirst(2011U), FrameKind::kInvalid),
    Slot(0U, kProducing, kNoCause, 0U, 0U, 0U), ConfirmFirst(0U, 2100U),
    StrangeFirst(2101U), OfKind(StrangeSecond(2102U), FrameKind::kRemote),
    OfKind(StrangeSecond(2103U), FrameKind::kExtended), OfKind(ConfirmNone(0x102U, 2U, 0U, 0U, 2104U), FrameKind::kExtendedRemote),
    OfKind(ConfirmNone(0x102U, 8U, 0U, 0U, 2105U), FrameKind::kFlexibleDataRate), OfKind(StrangeSecond(2106U), FrameKind::kInvalid),
    Slot(0U, kProducing, kNoCause, 0U, 0U, 0U), TakeSecond(0U), ConfirmSecond(0U, 2200U),
    StrangeSecond(2201U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U),
};

constexpr Step kWrongData[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U),
    ConfirmNone(0x101U, 2U, 0x3413U, 0U, 2100U),
    Slot(0U, kProducing, Cause::kWrongEcho, 0U, 1U, 0U), Data(0U, 0U), TakeNone(0U), StrangeFirst(2101U),
    Cycle(3000U), Signals(0U, Bit(Cause::kWrongEcho)),
    Masks(0U, 0U, 0U, 0U, 0U), Due(0U), Request(0U), Cycle(4000U), Due(1U),
};

constexpr Step kWrongLength[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U),
    ConfirmNone(0x101U, 1U, 0x12U, 0U, 2100U),
    Slot(0U, kProducing, Cause::kWrongEcho, 0U, 1U, 0U), Cycle(3000U), ReadyPair(0U),
    ConfirmNone(0x101U, 3U, 0x3412U, 0U, 3100U),
    Slot(0U, kProducing, Cause::kWrongEcho, 0U, 2U, 0U),
};

constexpr Step kWrongInverse[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U),
    ConfirmFirst(0U, 2100U), TakeSecond(0U),
    ConfirmNone(0x102U, 2U, 0xCAEDU, 0U, 2200U), Slot(0U, kProducing, Cause::kWrongEcho, 0U, 1U, 0U), Cycle(3000U),
    ReadyPair(0U),
    ConfirmFirst(0U, 3100U), TakeSecond(0U), ConfirmNone(0x102U, 8U, 0xCBEDU, 0U, 3200U),
    Slot(0U, kProducing, Cause::kWrongEcho, 0U, 2U, 0U),
};

constexpr Step kBytesBehind[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U),
    ConfirmNormal(0U, 0x101U, 2U, 0xFFFF3412U, 0x12345678U, 2100U),
    TakeSecond(0U), ConfirmPair(0U, 0x102U, 2U, 0xFFFFCBEDU, 0x12345678U, 2200U),
    Slot(0U, kProducing, kNoCause, 1U, 0U, 0U),
};

// t     2000          22000 (on)   22001
//       prepared      cycle        cycle: no confirmation
constexpr Step kNormalMissing[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), Cycle(21999U),
    Cycle(22000U), Signals(0U, 0U), Cycle(22001U),
    Slot(0U, kProducing, Cause::kNoConfirmation, 0U, 1U, 0U), Signals(0U, Bit(Cause::kNoConfirmation)), Due(0U),
    Data(0U, 0U), StrangeFirst(22002U), TakeNone(0U), Cycle(23000U), ReadyPair(0U), ConfirmFirst(0U, 23100U),
    TakeSecond(0U),
};

// Prepare counts from the `now` of the cycle before it, wherever the frame was confirmed.
constexpr Step kNormalLate[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), Cycle(22000U),
    ConfirmFirst(0U, 22000U), TakeSecond(0U),
    ConfirmSecond(0U, 42000U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U),
};

constexpr Step kNormalOver[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), Cycle(22000U), StrangeFirst(22001U),
    Slot(0U, kProducing, Cause::kNoConfirmation, 0U, 1U, 0U), TakeNone(0U), Cycle(23000U),
    Signals(0U, Bit(Cause::kNoConfirmation)),
};

// t     2000      2300         22300 (on)   22301
//       prepared  N confirmed  cycle        cycle: no confirmation
constexpr Step kInverseMissing[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U),
    ConfirmFirst(0U, 2300U), TakeSecond(0U), Cycle(22300U), Signals(0U, 0U),
    Cycle(22301U), Slot(0U, kProducing, Cause::kNoConfirmation, 0U, 1U, 0U), Signals(0U, Bit(Cause::kNoConfirmation)),
};

constexpr Step kInverseOn[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U),
    ConfirmFirst(0U, 2300U), TakeSecond(0U), ConfirmSecond(0U, 22300U),
    Slot(0U, kProducing, kNoCause, 1U, 0U, 0U), Cycle(23000U), Signals(0U, 0U),
};

constexpr Step kInverseOver[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U),
    ConfirmFirst(0U, 2300U), TakeSecond(0U), StrangeSecond(22301U),
    Slot(0U, kProducing, Cause::kNoConfirmation, 0U, 1U, 0U), Cycle(23000U), Signals(0U, Bit(Cause::kNoConfirmation)),
};

// Wrong and late: the echo is what is named.
constexpr Step kWrongAndLate[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U),
    ConfirmFirst(0U, 2300U), TakeSecond(0U),
    ConfirmNone(0x102U, 2U, 0U, 0U, 22301U), Slot(0U, kProducing, Cause::kWrongEcho, 0U, 1U, 0U),
};

constexpr Step kTransmitFaults[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), TransmitFault(0U, Cause::kTransmitQueue),
    Slot(0U, kProducing, kNoCause, 0U, 0U, 0U), ReadyPair(0U),
    TransmitFault(0U, Cause::kRefreshMissed),
    TransmitFault(0U, Cause::kNone), TransmitFault(0U, Cause::kInvalid), TransmitFault(0U, static_cast<Cause>(0xFFU)),
    TransmitFault(0U, Cause::kWrongEcho),
    Slot(0U, kProducing, kNoCause, 0U, 0U, 0U), TransmitFault(0U, Cause::kTransmitQueue),
    Slot(0U, kProducing, Cause::kTransmitQueue, 0U, 1U, 0U), TakeNone(0U),
    TransmitFault(0U, Cause::kTransmitQueue), Slot(0U, kProducing, Cause::kTransmitQueue, 0U, 1U, 0U), Cycle(3000U),
    Signals(0U, Bit(Cause::kTransmitQueue)), ReadyPair(0U), ConfirmFirst(0U, 3100U), TransmitFault(0U, Cause::kBusOff),
    Slot(0U, kProducing, Cause::kTransmitQueue, 0U, 2U, 0U), TakeNone(0U), Cycle(4000U),
    Signals(0U, Bit(Cause::kBusOff)),
};

// The other channel found the confirmation late: the pair is over in this one too, whichever frame is awaited.
constexpr Step kLateInTheOther[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), TransmitFault(0U, Cause::kNoConfirmation),
    Slot(0U, kProducing, kNoCause, 0U, 0U, 0U), ReadyPair(0U), ConfirmFirst(0U, 22000U), TransmitFault(0U, Cause::kNoConfirmation),
    Slot(0U, kProducing, Cause::kNoConfirmation, 0U, 1U, 0U), TakeNone(0U), StrangeSecond(22100U), TransmitFault(0U, Cause::kNoConfirmation),
    Slot(0U, kProducing, Cause::kNoConfirmation, 0U, 1U, 0U), Cycle(23000U), Signals(0U, Bit(Cause::kNoConfirmation)), ReadyPair(0U),
    TransmitFault(0U, Cause::kNoConfirmation), Slot(0U, kProducing, Cause::kNoConfirmation, 0U, 2U, 0U), StrangeFirst(23100U), Cycle(24000U),
    Signals(0U, Bit(Cause::kNoConfirmation)), Cycle(25000U), Signals(0U, 0U),
};

// An acknowledge edge of an active producer clears its first cause.
constexpr Step kAcknowledged[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U),
    TransmitFault(0U, Cause::kBusOff), Cycle(3000U),
    Slot(0U, kProducing, Cause::kBusOff, 0U, 1U, 0U), Acknowledge(1U), Cycle(3900U),
    Slot(0U, kProducing, Cause::kBusOff, 0U, 1U, 0U), Cycle(4000U),
    Slot(0U, kProducing, kNoCause, 0U, 1U, 0U), ReadyPair(0U),
    TransmitFault(0U, Cause::kTransmitQueue), Cycle(5000U), Slot(0U, kProducing, Cause::kTransmitQueue, 0U, 2U, 0U),
    Cycle(6000U),
    Slot(0U, kProducing, Cause::kTransmitQueue, 0U, 2U, 0U),
};

// An edge of one that is not active clears nothing, nor does a level that stays when it becomes active.
constexpr Step kAcknowledgedWhileOff[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U),
    TransmitFault(0U, Cause::kBusOff), Nmt(NmtState::kStopped), Cycle(3000U),
    Slot(0U, kOff, Cause::kBusOff, 0U, 1U, 0U), Acknowledge(1U), Cycle(3900U), Cycle(4000U),
    Slot(0U, kOff, Cause::kBusOff, 0U, 1U, 0U), Nmt(NmtState::kOperational), Cycle(5000U), Cycle(6000U),
    Slot(0U, kProducing, Cause::kBusOff, 0U, 1U, 0U), Acknowledge(0U), Cycle(7000U), Cycle(8000U),
    Acknowledge(1U), Cycle(9000U), Slot(0U, kProducing, Cause::kBusOff, 0U, 1U, 0U), Cycle(10000U),
    Slot(0U, kProducing, kNoCause, 0U, 1U, 0U),
};

// Every fault is signalled, also the same one in the next call.
constexpr Step kEverySignal[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U),
    TransmitFault(0U, Cause::kBusOff), Signals(0U, 0U), Cycle(3000U), Signals(0U, Bit(Cause::kBusOff)), Signalled(1U),
    ReadyPair(0U), TransmitFault(0U, Cause::kBusOff), Cycle(4000U), Signals(0U, Bit(Cause::kBusOff)), Signalled(1U),
    Cycle(5000U), Signals(0U, 0U), Signalled(0U), ReadyPair(0U), TransmitFault(0U, Cause::kTransmitQueue), ReadyPair(0U),
    TransmitFault(0U, Cause::kBusOff), Cycle(6000U), Signals(0U, Bit(Cause::kTransmitQueue) | Bit(Cause::kBusOff)),
    Slot(0U, kProducing, Cause::kBusOff, 0U, 4U, 0U), Cycle(7000U), Signals(0U, 0U), Signalled(0U),
};

// An identifier changed behind the look-up: the frame that still finds its way confirms nothing.
constexpr Step kAstray[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U),
    Store(0U, ConfigField::kCobId1, 0x103U),
    StrangeFirst(2100U), Store(0U, ConfigField::kCobId1, 0x101U), ConfirmFirst(0U, 2200U),
    TakeSecond(0U), Store(0U, ConfigField::kCobId2, 0x104U),
    StrangeSecond(2300U), Store(0U, ConfigField::kCobId2, 0x102U), ConfirmSecond(0U, 2400U),
    Slot(0U, kProducing, kNoCause, 1U, 0U, 0U),
};

// Full frames: one wrong bit in each byte of the normal frame, then of the inverse one.
constexpr Step kLongReady = Ready(0U, CanPortId::kFirst, 0x101U, 8U, 0x44332211U, 0x88776655U);
constexpr Step kLongFirst = ConfirmNormal(0U, 0x101U, 8U, 0x44332211U, 0x88776655U, 2100U);

constexpr Step WrongFirst(std::uint32_t low, std::uint32_t high)
{
    return ConfirmNone(0x101U, 8U, 0x44332211U ^ low, 0x88776655U ^ high, 2100U);
}

constexpr Step WrongSecond(std::uint32_t low, std::uint32_t high)
{
    return ConfirmNone(0x102U, 8U, 0xBBCCDDEEU ^ low, 0x778899AAU ^ high, 2200U);
}

constexpr Step Wrong(std::uint32_t errors)
{
    return Slot(0U, kProducing, Cause::kWrongEcho, 0U, errors, 0U);
}

constexpr Step kEveryByte[] = {
    Configure(), Put(0x6400U, 8U, 0x44332211U, 0x88776655U), Put(0x6401U, 8U, 0xBBCCDDEEU, 0x778899AAU), Cycle(0U), Cycle(2000U),
    kLongReady, WrongFirst(0x00000001U, 0U), Wrong(1U), kLongReady, WrongFirst(0x00008000U, 0U), Wrong(2U),
    kLongReady, WrongFirst(0x00020000U, 0U), Wrong(3U), kLongReady, WrongFirst(0x40000000U, 0U), Wrong(4U),
    kLongReady, WrongFirst(0U, 0x00000004U), Wrong(5U), kLongReady, WrongFirst(0U, 0x00002000U), Wrong(6U),
    kLongReady, WrongFirst(0U, 0x00080000U), Wrong(7U), kLongReady, WrongFirst(0U, 0x80000000U), Wrong(8U),
    kLongReady, kLongFirst, WrongSecond(0x00000080U, 0U), Wrong(9U), kLongReady, kLongFirst, WrongSecond(0x00000100U, 0U), Wrong(10U),
    kLongReady, kLongFirst, WrongSecond(0x00400000U, 0U), Wrong(11U), kLongReady, kLongFirst, WrongSecond(0x02000000U, 0U), Wrong(12U),
    kLongReady, kLongFirst, WrongSecond(0U, 0x00000020U), Wrong(13U), kLongReady, kLongFirst, WrongSecond(0U, 0x00000400U), Wrong(14U),
    kLongReady, kLongFirst, WrongSecond(0U, 0x00100000U), Wrong(15U), kLongReady, kLongFirst, WrongSecond(0U, 0x01000000U), Wrong(16U),
    kLongReady, kLongFirst, ConfirmPair(0U, 0x102U, 8U, 0xBBCCDDEEU, 0x778899AAU, 2200U),
    Slot(0U, kProducing, Cause::kWrongEcho, 1U, 16U, 0U),
};

// Wherever it was on the bus: each half by the other controller than the one that it is sent by.
constexpr Step kEitherController[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), On(ConfirmFirst(0U, 2100U), CanPortId::kSecond),
    TakeInverse(0U, CanPortId::kSecond, 0x102U, 2U, 0xCBEDU), ConfirmSecond(0U, 2200U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U),
    ReadyPair(0U), On(ConfirmNone(0x101U, 2U, 0x3413U, 0U, 2300U), CanPortId::kSecond), Slot(0U, kProducing, Cause::kWrongEcho, 1U, 1U, 0U),
};

// SRVT 0 ms: within the microsecond.
constexpr Step kNoSrvt[] = {
    StoreAll(), Srvt(0U, 0U), Signature(0U, 0x4739U), Validate(0U, ConfigFault::kNone, 0x4739U),
    Store(0U, ConfigField::kConfigurationValid, 0xA5U), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), ConfirmFirst(0U, 2000U),
    TakeSecond(0U), ConfirmSecond(0U, 2000U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U), ReadyPair(0U), StrangeFirst(2001U),
    Slot(0U, kProducing, Cause::kNoConfirmation, 1U, 1U, 0U), ReadyPair(0U), ConfirmFirst(0U, 2000U), StrangeSecond(2001U),
    Slot(0U, kProducing, Cause::kNoConfirmation, 1U, 2U, 0U), Cycle(2002U), ReadyPair(0U), Cycle(2002U), Signals(0U, 0U), Cycle(2003U),
    Signals(0U, Bit(Cause::kNoConfirmation)), Slot(0U, kProducing, Cause::kNoConfirmation, 1U, 3U, 0U),
};

// SRVT 1 ms, on the limit and behind it, by stamps.
constexpr Step kOneMillisecond[] = {
    StoreAll(), Srvt(0U, 1U), Signature(0U, 0x4E26U), Validate(0U, ConfigFault::kNone, 0x4E26U),
    Store(0U, ConfigField::kConfigurationValid, 0xA5U), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), ConfirmFirst(0U, 3000U),
    ConfirmSecond(0U, 4000U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U), ReadyPair(0U), StrangeFirst(3001U),
    Slot(0U, kProducing, Cause::kNoConfirmation, 1U, 1U, 0U), ReadyPair(0U), ConfirmFirst(0U, 2500U), StrangeSecond(3501U),
    Slot(0U, kProducing, Cause::kNoConfirmation, 1U, 2U, 0U),
};

// The longest SRVT, 255 ms, beside a refresh time of one second.
// t     2000      257000 (on)   512000 (on)          767000   767001
//       prepared  N confirmed   I confirmed; again   cycle    cycle: no confirmation
constexpr Step kLongestSrvt[] = {
    StoreAll(), Sct(0U, 1000U), Srvt(0U, 255U), Signature(0U, 0xD9C0U), Validate(0U, ConfigFault::kNone, 0xD9C0U),
    Store(0U, ConfigField::kConfigurationValid, 0xA5U), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), Cycle(257000U),
    Signals(0U, 0U), ConfirmFirst(0U, 257000U), Cycle(512000U), Signals(0U, 0U), TakeSecond(0U), ConfirmSecond(0U, 512000U),
    Slot(0U, kProducing, kNoCause, 1U, 0U, 0U), ReadyPair(0U), Cycle(767000U), Signals(0U, 0U), Cycle(767001U),
    Signals(0U, Bit(Cause::kNoConfirmation)), Slot(0U, kProducing, Cause::kNoConfirmation, 1U, 1U, 0U),
};

// Two pairs at once, their halves interleaved: each slot has its own, and its own fault.
constexpr Step kTwoInFlight[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Ready(3U, CanPortId::kFirst, 0x107U, 2U, 0x3412U),
    Ready(8U, CanPortId::kFirst, 0x111U, 2U, 0x3412U), ConfirmNormal(8U, 0x111U, 2U, 0x3412U, 0U, 2100U), TakeNone(3U),
    TakeInverse(8U, CanPortId::kFirst, 0x112U, 2U, 0xCBEDU), ConfirmNone(0x108U, 2U, 0xCBEDU, 0U, 2150U), TakeNone(3U),
    ConfirmNormal(3U, 0x107U, 2U, 0x3412U, 0U, 2200U), TakeInverse(3U, CanPortId::kFirst, 0x108U, 2U, 0xCBEDU),
    ConfirmPair(8U, 0x112U, 2U, 0xCBEDU, 0U, 2300U), TakeNone(8U), TakeInverse(3U, CanPortId::kFirst, 0x108U, 2U, 0xCBEDU),
    Slot(8U, kProducing, kNoCause, 1U, 0U, 0U), Slot(3U, kProducing, kNoCause, 0U, 0U, 0U),
    ConfirmPair(3U, 0x108U, 2U, 0xCBEDU, 0U, 2400U), Slot(3U, kProducing, kNoCause, 1U, 0U, 0U),
    Ready(3U, CanPortId::kFirst, 0x107U, 2U, 0x3412U), Ready(8U, CanPortId::kFirst, 0x111U, 2U, 0x3412U),
    TransmitFault(3U, Cause::kBusOff), ConfirmNone(0x107U, 2U, 0x3412U, 0U, 2500U), ConfirmNormal(8U, 0x111U, 2U, 0x3412U, 0U, 2600U),
    Cycle(3000U), Signalled(8U), Slot(3U, kProducing, Cause::kBusOff, 1U, 1U, 0U), Slot(8U, kProducing, kNoCause, 1U, 0U, 0U),
};

// An edge in the call that reports a fault is forgotten: one told before the call, and one that the call finds. An edge
// of a producer without a cause does not wait for one. SRVT 1 ms.
// t     4000            9000     14000       15000           18001                     19000
//       edge, bus-off   clears   edge alone  full queue      edge, no confirmation     nothing
constexpr Step kEdgeWithFault[] = {
    StoreAll(), Srvt(0U, 1U), Signature(0U, 0x4E26U), Validate(0U, ConfigFault::kNone, 0x4E26U),
    Store(0U, ConfigField::kConfigurationValid, 0xA5U), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), Acknowledge(1U),
    Cycle(3000U), TransmitFault(0U, Cause::kBusOff), Cycle(4000U),
    Signals(0U, Bit(Cause::kBusOff)), Slot(0U, kProducing, Cause::kBusOff, 0U, 1U, 0U), Cycle(5000U),
    Slot(0U, kProducing, Cause::kBusOff, 0U, 1U, 0U), Acknowledge(0U), Cycle(6000U), Cycle(7000U), Acknowledge(1U), Cycle(8000U),
    Slot(0U, kProducing, Cause::kBusOff, 0U, 1U, 0U), Cycle(9000U), Slot(0U, kProducing, kNoCause, 0U, 1U, 0U),
    Acknowledge(0U), Cycle(11000U), Cycle(12000U), Acknowledge(1U), Cycle(13000U), Cycle(14000U), ReadyPair(0U),
    TransmitFault(0U, Cause::kTransmitQueue), Cycle(15000U), Slot(0U, kProducing, Cause::kTransmitQueue, 0U, 2U, 0U),
    Acknowledge(0U), Cycle(16000U), Cycle(17000U), ReadyPair(0U), Acknowledge(1U), Cycle(18000U), Cycle(18001U),
    Signals(0U, Bit(Cause::kNoConfirmation)), Slot(0U, kProducing, Cause::kTransmitQueue, 0U, 3U, 0U), Cycle(19000U),
    Slot(0U, kProducing, Cause::kTransmitQueue, 0U, 3U, 0U),
};

constexpr Case kCases[] = {
    MakeCase("ConfirmationOfOtherFrames", {req::SRS_PROD_007}, kSender, kStrangers),
    MakeCase("EchoWithOtherData", {req::SRS_PROD_007, req::SRS_PROD_009, req::SRS_PROD_006}, kSender, kWrongData),
    MakeCase("EchoWithOtherLength", {req::SRS_PROD_007}, kSender, kWrongLength),
    MakeCase("EchoOfTheInverseFrame", {req::SRS_PROD_007, req::SRS_PROD_009}, kSender, kWrongInverse),
    MakeCase("BytesBehindTheEchoMeanNothing", {req::SRS_PROD_007}, kSender, kBytesBehind),
    MakeCase("NormalFrameIsNotConfirmed", {req::SRS_PROD_008, req::SRS_TIME_004, req::SRS_PROD_009}, kSender,
             kNormalMissing),
    MakeCase("ConfirmationsOnTheirLimits", {req::SRS_PROD_008, req::SRS_TIME_004}, kSender, kNormalLate),
    MakeCase("NormalFrameConfirmedTooLate", {req::SRS_PROD_008, req::SRS_TIME_004, req::SRS_TIME_001}, kSender,
             kNormalOver),
    MakeCase("InverseFrameIsNotConfirmed", {req::SRS_PROD_008, req::SRS_TIME_004}, kSender, kInverseMissing),
    MakeCase("InverseFrameConfirmedOnTheLimit", {req::SRS_PROD_008, req::SRS_TIME_004, req::SRS_TIME_001}, kSender,
             kInverseOn),
    MakeCase("InverseFrameConfirmedTooLate", {req::SRS_PROD_008, req::SRS_TIME_004, req::SRS_TIME_001}, kSender,
             kInverseOver),
    MakeCase("EchoIsExaminedBeforeItsTime", {req::SRS_PROD_007, req::SRS_PROD_008}, kSender, kWrongAndLate),
    MakeCase("ConfirmationLedToAnotherSrdo", {req::SRS_PROD_007}, kSender, kAstray),
    MakeCase("TransmitFaults", {req::SRS_PROD_009}, kSender, kTransmitFaults),
    MakeCase("ConfirmationLateInTheOtherChannel", {req::SRS_PROD_009}, kSender, kLateInTheOther),
    MakeCase("AcknowledgeOfAProducer", {req::SRS_PROD_009}, kSender, kAcknowledged),
    MakeCase("AcknowledgeOfAProducerThatIsOff", {req::SRS_PROD_009}, kSender, kAcknowledgedWhileOff),
    MakeCase("EveryFaultOfAProducerIsSignalled", {req::SRS_PROD_009, req::SRS_CONS_021}, kSender, kEverySignal),
    MakeCase("EchoWithAnotherBitInEachByte", {req::SRS_PROD_007, req::SRS_PROD_006}, kLongSender, kEveryByte),
    MakeCase("EchoOnEitherController", {req::SRS_PROD_007}, kSenderPorts, kEitherController),
    MakeCase("ConfirmationWithoutSrvt", {req::SRS_PROD_008, req::SRS_TIME_004}, kSender, kNoSrvt),
    MakeCase("ConfirmationWithSrvtOfOneMillisecond", {req::SRS_PROD_008, req::SRS_TIME_004}, kSender, kOneMillisecond),
    MakeCase("ConfirmationWithTheLongestSrvt", {req::SRS_PROD_008, req::SRS_TIME_004}, kSender, kLongestSrvt),
    MakeCase("TwoPairsInFlight", {req::SRS_PROD_007, req::SRS_PROD_006, req::SRS_PROD_009}, kSenders, kTwoInFlight),
    MakeCase("AcknowledgeInTheCallOfAProducersFault", {req::SRS_PROD_009, req::SRS_REL_341}, kSender, kEdgeWithFault),
};
// clang-format on
} // namespace

const CaseTable kConfirmationCases = MakeTable("confirmation", kCases);

} // namespace counterpoint::conformance
