// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Producer: first transmission, requests, Prepare, frames. Node-ID 4, so that the first transmission is possible 2 ms
// after entering OPERATIONAL. Times in microseconds.
#include "verification/conformance/gold.hpp"
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

// t     0     1000  1999  2000           2300          2400   2600          3000
//       enter             due, prepared  N confirmed   I out  I confirmed
constexpr Step kSend[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Counts(0U, 1U, 0U, 0U), Slot(0U, kProducing, kNoCause, 0U, 0U, 0U),
    Due(0U), Request(0U), Cycle(1000U), Due(0U), Cycle(1999U), Due(0U), Cycle(2000U), Due(1U), Data(0U, 0U),
    ReadyPair(0U), Data(0U, 0x3412U), TakeNone(0U), ConfirmFirst(0U, 2300U), Data(0U, 0x3412U),
    TakeSecond(0U), Slot(0U, kProducing, kNoCause, 0U, 0U, 0U), ConfirmSecond(0U, 2600U), Data(0U, 0U), TakeNone(0U),
    Slot(0U, kProducing, kNoCause, 1U, 0U, 0U), Cycle(3000U), Due(0U),
    Masks(0U, 0U, 0U, 0U, 0U), Signalled(0U), OrdinalSum(0U),
};

constexpr Step kNoRequest[] = {
    Configure(), Cycle(0U), Cycle(2000U), Due(0U), Cycle(3000U), Due(0U), Cycle(28500U), Due(0U), Signals(0U, 0U),
};

// Node-ID 127: 63.5 ms.
constexpr Step kLastNode[] = {
    Configure(), Cycle(0U), Cycle(63499U), Due(0U), Cycle(63500U), Due(1U),
};

// Half a round of the counter after entering, the first transmission is still behind.
constexpr Step kStartedForGood[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(0x7FFFFFFFU), Cycle(0xFFFFFFFEU), Request(0U), Cycle(0x100U),
    Due(1U), ReadyPair(0U),
};

constexpr Step kFirstCallDuesAtOnce[] = {
    Configure(), Cycle(0U), Request(0U), Cycle(5000U), Due(1U),
};

constexpr Step kDueUntilPrepared[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Request(0U), Request(0U), Cycle(2000U), Due(1U), Cycle(3000U), Due(1U),
    Request(0U), Cycle(4000U), Due(1U), ReadyPair(0U),
    // Requests do not add up.
    ConfirmFirst(0U, 4100U), TakeSecond(0U), ConfirmSecond(0U, 4200U), Cycle(5000U), Due(0U),
    Slot(0U, kProducing, kNoCause, 1U, 0U, 0U),
};

constexpr Step kRequestInFlight[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Request(0U), Cycle(2000U), ReadyPair(0U),
    Request(0U), Cycle(3000U), Due(0U),
    ConfirmFirst(0U, 3100U), Cycle(4000U), Due(0U), TakeSecond(0U), ConfirmSecond(0U, 4100U), Cycle(5000U), Due(1U),
};

constexpr Step kRequestAfterGivingUp[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Request(0U), Cycle(2000U), ReadyPair(0U), Request(0U), Cycle(3000U),
    Due(0U), TransmitFault(0U, Cause::kTransmitQueue),
    Cycle(4000U), Due(1U), Signals(0U, Bit(Cause::kTransmitQueue)),
};

// Not in flight any more when the call comes: due in that same call.
constexpr Step kRequestWithGivingUp[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Request(0U), Cycle(2000U), ReadyPair(0U), Request(0U), Cycle(22001U),
    Due(1U), Signals(0U, Bit(Cause::kNoConfirmation)), ReadyPair(0U),
};

// The call that enters OPERATIONAL takes the request with it; the initial delay counts all the same.
constexpr Step kRequestOnEntering[] = {
    Configure(), kP1, kP2, kI1, kI2, Nmt(NmtState::kPreOperational), Cycle(0U), Nmt(NmtState::kOperational),
    Request(0U), Cycle(1000U), Due(0U), Cycle(2999U), Due(0U), Cycle(3000U), Due(1U), ReadyPair(0U),
    ConfirmFirst(0U, 3100U), ConfirmSecond(0U, 3200U), Cycle(4000U), Due(0U),
};

// A request in a call after which the SRDOs are not active is none: left, or not guarded.
constexpr Step kRequestOnLeaving[] = {
    Configure(), Cycle(0U), Cycle(2000U), Nmt(NmtState::kStopped), Request(0U), Cycle(3000U), Due(0U),
    Nmt(NmtState::kOperational), Cycle(4000U), Due(0U), Cycle(6000U), Due(0U), Token(1U), Request(0U), Cycle(7000U),
    Due(0U), Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Cycle(8000U), Due(0U), Cycle(11000U), Due(0U),
};

constexpr Step kNotActive[] = {
    NotProducing(0U), Configure(), kP1, kP2, kI1, kI2, NotProducing(0U), TakeNone(0U), StrangeFirst(1U),
    Nmt(NmtState::kPreOperational), Request(0U), Cycle(0U), Due(0U), NotProducing(0U), TakeNone(0U),
    // Requests made while off are none.
    Nmt(NmtState::kOperational), Cycle(10000U), Due(0U), Cycle(12000U), Due(0U), Request(0U), Cycle(13000U), Due(1U),
};

constexpr Step kNotAProducer[] = {
    Configure(), Cycle(0U), Request(0U), Request(2U), Cycle(3000U), Due(0U), NotProducing(0U), NotProducing(2U),
    TakeNone(0U), TakeNone(2U),
    TransmitFault(0U, Cause::kBusOff), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

constexpr Step kPrepareInFlight[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Request(0U), Cycle(2000U), ReadyPair(0U),
    Put(0x6210U, 1U, 0x77U), NotProducing(0U), ConfirmFirst(0U, 2100U), NotProducing(0U), TakeSecond(0U),
    ConfirmSecond(0U, 2200U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U), kP1,
    // It uses up nothing: a request made meanwhile still waits.
    ReadyPair(0U), Request(0U), Cycle(3000U), NotProducing(0U), ConfirmFirst(0U, 3100U), ConfirmSecond(0U, 3200U),
    Cycle(4000U), Due(1U),
};

constexpr Step kNotInverse[] = {
    Configure(), kP1, kP2, kI1, Put(0x6211U, 2U, 0xCAU), Cycle(0U), Request(0U), Cycle(2000U), Due(1U),
    UnequalPair(0U, 0x3412U, 0x3512U), UnequalData(0U, 0x3412U, 0x3512U), Slot(0U, kProducing, kNoCause, 0U, 0U, 0U),
    NotInverse(0U), Data(0U, 0U), Slot(0U, kProducing, Cause::kNotInverse, 0U, 1U, 0U), Signals(0U, 0U),
    // Nothing is in flight.
    TakeNone(0U), StrangeFirst(2100U), TakeNone(0U), Cycle(3000U),
    Due(0U), Signals(0U, Bit(Cause::kNotInverse)), Signalled(1U), Masks(0U, 0U, 0U, 0U, 0U),
    // The near miss: all bits inverted.
    kI2, Request(0U), Cycle(4000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 4100U),
};

constexpr Step kEveryObject[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Put(0x6210U, 1U, 0x13U),
    UnequalPair(0U, 0x3413U, 0x3412U), NotInverse(0U), Put(0x6210U, 1U, 0x92U),
    UnequalPair(0U, 0x3492U, 0x3412U), NotInverse(0U), kP1, Put(0x6210U, 2U, 0x35U),
    UnequalPair(0U, 0x3512U, 0x3412U), NotInverse(0U), kP2, Put(0x6211U, 1U, 0x6DU),
    UnequalPair(0U, 0x3412U, 0x3492U), NotInverse(0U), kI1, Put(0x6211U, 2U, 0x4BU),
    UnequalPair(0U, 0x3412U, 0xB412U), NotInverse(0U), kI2, ReadyPair(0U),
    Slot(0U, kProducing, Cause::kNotInverse, 0U, 5U, 0U),
};

// What was prepared is sent, whatever the application writes meanwhile; the next pair has the new data.
constexpr Step kPreparedStays[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), Put(0x6210U, 1U, 0x55U),
    Put(0x6211U, 1U, 0xAAU), Put(0x6211U, 2U, 0U), Data(0U, 0x3412U), ConfirmFirst(0U, 2100U), TakeSecond(0U),
    ConfirmSecond(0U, 2200U), Cycle(3000U), UnequalPair(0U, 0x3455U, 0xFF55U), NotInverse(0U), kI2,
    Ready(0U, CanPortId::kFirst, 0x101U, 2U, 0x3455U), Data(0U, 0x3455U),
    ConfirmNormal(0U, 0x101U, 2U, 0x3455U, 0U, 3100U), TakeInverse(0U, CanPortId::kFirst, 0x102U, 2U, 0xCBAAU),
    ConfirmPair(0U, 0x102U, 2U, 0xCBAAU, 0U, 3200U), Slot(0U, kProducing, Cause::kNotInverse, 2U, 1U, 0U),
};

// As often as it is asked for, by both, and only while it is awaited: not before the normal frame was confirmed, nor
// once the pair was sent or given up. Asking confirms nothing and keeps nothing.
constexpr Step kInverseOften[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), TakeNone(0U), Cycle(2000U), TakeNone(0U), ReadyPair(0U), TakeNone(0U),
    ConfirmFirst(0U, 2100U), TakeSecond(0U), TakeSecond(0U), Cycle(3000U), TakeSecond(0U), TakeSecond(0U),
    StrangeFirst(3050U), TakeSecond(0U), Slot(0U, kProducing, kNoCause, 0U, 0U, 0U), ConfirmSecond(0U, 3100U),
    TakeNone(0U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U), ReadyPair(0U), TakeNone(0U), ConfirmFirst(0U, 3200U),
    TakeSecond(0U), TransmitFault(0U, Cause::kBusOff), TakeNone(0U), ReadyPair(0U), TakeNone(0U),
    ConfirmFirst(0U, 3300U), TakeSecond(0U), TakeSecond(0U),
};

// Given up by the wrong echo of the inverse frame, by its silence, and by the end of OPERATIONAL.
// t     2000 prepared   2100 N   22100 (SRVT on)   22101
constexpr Step kInverseOver[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), ConfirmFirst(0U, 2100U), TakeSecond(0U),
    Cycle(22100U), TakeSecond(0U), Cycle(22101U), TakeNone(0U), Slot(0U, kProducing, Cause::kNoConfirmation, 0U, 1U, 0U),
    ReadyPair(0U), ConfirmFirst(0U, 22200U), TakeSecond(0U), ConfirmNone(0x102U, 2U, 0xCAEDU, 0U, 22300U), TakeNone(0U),
    ReadyPair(0U), ConfirmFirst(0U, 22400U), TakeSecond(0U), NotInverse(0U), TakeNone(0U),
    ReadyPair(0U), ConfirmFirst(0U, 22500U), TakeSecond(0U), Nmt(NmtState::kStopped), Cycle(23000U), TakeNone(0U),
    Nmt(NmtState::kOperational), Cycle(24000U), TakeNone(0U),
    ReadyPair(0U), ConfirmFirst(0U, 24100U), TakeSecond(0U), Token(1U), Cycle(25000U), TakeNone(0U), Cycle(26000U),
    TakeNone(0U),
};

// The pair is complete when the inverse frame was on the bus, whoever asked for it.
constexpr Step kInverseNotTaken[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), ConfirmFirst(0U, 2100U),
    ConfirmSecond(0U, 2200U), TakeNone(0U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U), Cycle(3000U), TakeNone(0U),
    ReadyPair(0U), TakeNone(0U), ConfirmFirst(0U, 3100U), TakeSecond(0U),
};

// A consumer with a pair, a producer with a pair in flight and one that is off: only the first one holds anything.
constexpr Step kOneHolds[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Normal(100U), Inverse(200U), Data(0U, 0x3412U), Request(1U),
    Cycle(2000U), Slot(0U, kReleased, kNoCause, 1U, 0U, 1U), Due(2U), ReadyPair(1U), Data(1U, 0x3412U),
    ConfirmFirst(1U, 2100U), TakeSecond(1U), ConfirmSecond(1U, 2200U), Slot(1U, kProducing, kNoCause, 1U, 0U, 0U),
    Slot(2U, kOff, kNoCause, 0U, 0U, 0U), Demote(0U), Data(0U, 0U), OtherNormal(2300U), OtherInverse(2400U),
    Data(0U, 0x7856U), Nmt(NmtState::kStopped), Cycle(3000U), Data(0U, 0U), Slot(1U, kOff, kNoCause, 0U, 0U, 0U),
};

// Neither has one before it has seen the normal frame.
constexpr Step kInverseWaits[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), TakeNone(0U),
    Cycle(3000U), TakeNone(0U),
    StrangeSecond(3100U), TakeNone(0U), ConfirmFirst(0U, 3200U), TakeSecond(0U),
};

constexpr Step kTwoControllers[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U),
    ConfirmFirst(0U, 2100U),
    TakeInverse(0U, CanPortId::kSecond, 0x102U, 2U, 0xCBEDU), On(ConfirmSecond(0U, 2200U), CanPortId::kSecond),
    Slot(0U, kProducing, kNoCause, 1U, 0U, 0U),
};

constexpr Step kControllersSwapped[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U),
    Ready(0U, CanPortId::kSecond, 0x101U, 2U, 0x3412U), On(ConfirmFirst(0U, 2100U), CanPortId::kSecond),
    TakeInverse(0U, CanPortId::kFirst, 0x102U, 2U, 0xCBEDU), ConfirmSecond(0U, 2200U),
    Slot(0U, kProducing, kNoCause, 1U, 0U, 0U),
};

// Leaving OPERATIONAL gives everything up, without a fault.
constexpr Step kLeave[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U),
    ConfirmFirst(0U, 2100U), TakeSecond(0U), ConfirmSecond(0U, 2200U),
    Request(0U), Cycle(3000U), ReadyPair(0U), Request(0U), Nmt(NmtState::kPreOperational), Cycle(4000U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U), TakeNone(0U),
    Due(0U), Signals(0U, 0U), StrangeFirst(4100U), NotProducing(0U),
    Masks(0U, 0U, 0U, 0U, 0U), Nmt(NmtState::kOperational),
    Cycle(5000U), Slot(0U, kProducing, kNoCause, 0U, 0U, 0U), Cycle(8000U), Due(0U), TakeNone(0U), Request(0U),
    Cycle(9000U), Due(1U),
};

constexpr Step kLeaveWithInverse[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U),
    ConfirmFirst(0U, 2100U), Nmt(NmtState::kStopped), Cycle(3000U),
    TakeNone(0U), StrangeSecond(3100U), Nmt(NmtState::kOperational), Cycle(4000U),
    TakeNone(0U), TakeNone(0U),
};

// After entering again the first transmission waits again.
constexpr Step kLeaveAndWait[] = {
    Configure(), Cycle(0U), Cycle(2000U), Nmt(NmtState::kStopped), Cycle(3000U), Nmt(NmtState::kOperational),
    Cycle(4000U), Request(0U), Cycle(5999U), Due(0U), Cycle(6000U),
    Due(1U),
};

constexpr Step kDueGivenUp[] = {
    Configure(), Cycle(0U), Request(0U), Cycle(2000U), Due(1U), Nmt(NmtState::kStopped), Cycle(3000U), Due(0U),
    Nmt(NmtState::kOperational), Cycle(4000U), Cycle(9000U), Due(0U),
};

// Eight objects a side, and objects of every size: first byte first on the bus.
constexpr Step kSixteen[] = {
    Configure(), Put(0x6621U, 1U, 0x00000011U), Put(0x6621U, 2U, 0x00000022U), Put(0x6621U, 3U, 0x00000033U),
    Put(0x6621U, 4U, 0x00000044U), Put(0x6621U, 5U, 0x00000055U), Put(0x6621U, 6U, 0x00000066U),
    Put(0x6621U, 7U, 0x00000077U), Put(0x6621U, 8U, 0x00000088U), Put(0x6623U, 1U, 0x000000EEU),
    Put(0x6623U, 2U, 0x000000DDU), Put(0x6623U, 3U, 0x000000CCU), Put(0x6623U, 4U, 0x000000BBU),
    Put(0x6623U, 5U, 0x000000AAU), Put(0x6623U, 6U, 0x00000099U), Put(0x6623U, 7U, 0x00000088U),
    Put(0x6623U, 8U, 0x00000077U),
    Cycle(0U), Cycle(2000U), Ready(0U, CanPortId::kFirst, 0x17FU, 8U, 0x44332211U, 0x88776655U),
    ConfirmNormal(0U, 0x17FU, 8U, 0x44332211U, 0x88776655U, 2100U),
    TakeInverse(0U, CanPortId::kFirst, 0x180U, 8U, 0xBBCCDDEEU, 0x778899AAU),
    ConfirmPair(0U, 0x180U, 8U, 0xBBCCDDEEU, 0x778899AAU, 2200U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U),
    Put(0x6623U, 8U, 0x76U),
    Unequal(0U, 0x17FU, 8U, Payload{0x44332211U, 0x88776655U}, Payload{0x44332211U, 0x89776655U}), NotInverse(0U),
    Slot(0U, kProducing, Cause::kNotInverse, 1U, 1U, 0U),
};

constexpr Step kWords[] = {
    Configure(), Put(0x6400U, 4U, 0x44332211U), Put(0x6401U, 4U, 0xBBCCDDEEU), Put(0x6400U, 3U, 0x776655U),
    Put(0x6401U, 3U, 0x8899AAU), Put(0x6400U, 1U, 0x88U), Put(0x6401U, 1U, 0x77U), Cycle(0U), Cycle(2000U),
    Put(0x6401U, 4U, 0x3BCCDDEEU),
    Unequal(0U, 0x101U, 8U, Payload{0x44332211U, 0x88776655U}, Payload{0xC4332211U, 0x88776655U}), NotInverse(0U),
    Put(0x6401U, 4U, 0xBBCCDDEFU),
    Unequal(0U, 0x101U, 8U, Payload{0x44332211U, 0x88776655U}, Payload{0x44332210U, 0x88776655U}), NotInverse(0U),
    Put(0x6401U, 4U, 0xBBCCDDEEU), Put(0x6401U, 3U, 0x0899AAU),
    Unequal(0U, 0x101U, 8U, Payload{0x44332211U, 0x88776655U}, Payload{0x44332211U, 0x88F76655U}), NotInverse(0U),
    Put(0x6401U, 3U, 0x8899AAU),
    Ready(0U, CanPortId::kFirst, 0x101U, 8U, 0x44332211U, 0x88776655U),
    ConfirmNormal(0U, 0x101U, 8U, 0x44332211U, 0x88776655U, 2100U),
    TakeInverse(0U, CanPortId::kFirst, 0x102U, 8U, 0xBBCCDDEEU, 0x778899AAU),
};

constexpr Step kLongObject[] = {
    Configure(), Put(0x6400U, 8U, 0x44332211U, 0x88776655U), Put(0x6401U, 8U, 0xBBCCDDEEU, 0xF78899AAU), Cycle(0U),
    Cycle(2000U), Unequal(0U, 0x101U, 8U, Payload{0x44332211U, 0x88776655U}, Payload{0x44332211U, 0x08776655U}),
    NotInverse(0U), Put(0x6401U, 8U, 0xBBCCDDEEU, 0x778899AAU),
    Ready(0U, CanPortId::kFirst, 0x101U, 8U, 0x44332211U, 0x88776655U),
};

constexpr Step kOddObject[] = {
    Configure(), Put(0x6400U, 7U, 0x44332211U, 0x776655U), Put(0x6401U, 7U, 0xBBCCDDEEU, 0x8899AAU), Cycle(0U),
    Cycle(2000U), Ready(0U, CanPortId::kFirst, 0x101U, 7U, 0x44332211U, 0x776655U),
    ConfirmNormal(0U, 0x101U, 7U, 0x44332211U, 0x776655U, 2100U),
    TakeInverse(0U, CanPortId::kFirst, 0x102U, 7U, 0xBBCCDDEEU, 0x8899AAU),
    ConfirmNone(0x102U, 8U, 0xBBCCDDEEU, 0x8899AAU, 2200U), Slot(0U, kProducing, Cause::kWrongEcho, 0U, 1U, 0U),
};

// Requests while a pair is in flight are one, and wait for a wrong echo as well.
constexpr Step kRequestsInFlight[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), Request(0U), Cycle(3000U), Due(0U), Request(0U),
    Cycle(4000U), Due(0U), ConfirmFirst(0U, 4100U), ConfirmSecond(0U, 4200U), Cycle(5000U), Due(1U), ReadyPair(0U),
    ConfirmFirst(0U, 5100U), ConfirmSecond(0U, 5200U), Cycle(6000U), Due(0U), ReadyPair(0U), Request(0U), Cycle(7000U), Due(0U),
    ConfirmNone(0x101U, 2U, 0x3413U, 0U, 7100U), Cycle(8000U), Due(1U), Slot(0U, kProducing, Cause::kWrongEcho, 2U, 1U, 0U),
};

// Slots that are not there neither send nor stand.
constexpr Step kNoSuchSlot[] = {
    Configure(), Cycle(0U), Cycle(2000U), Request(1U), Request(31U), Request(32U), Request(63U), Stand(1U), Stand(31U), Stand(32U),
    Stand(63U), Cycle(3000U), Due(0U), Refresh(0U), Signalled(0U), Cycle(4000U), Due(0U), Cycle(28500U),
    Signals(0U, 0U), Cycle(28501U), Signals(0U, Bit(Cause::kRefreshMissed)), Signalled(1U),
};

// What is asked of a producer leaves a consumer alone: its pair, a pending normal frame, its cause.
constexpr Step kConsumerStays[] = {
    Configure(), Cycle(0U), Normal(100U), Inverse(200U), Cycle(2000U), Masks(1U, 0U, 0U, 0U, 1U), Normal(2100U), NotProducing(0U),
    TakeNone(0U), ConfirmNone(0x111U, 2U, 0x3412U, 0U, 2110U), ConfirmNone(0x112U, 2U, 0xCBEDU, 0U, 2120U),
    ConfirmNone(0x111U, 1U, 0U, 0U, 2130U), TransmitFault(0U, Cause::kTransmitQueue), TransmitFault(0U, Cause::kBusOff),
    NotInverse(0U), TransmitFault(0U, Cause::kNoConfirmation), TransmitFault(0U, Cause::kWrongEcho),
    Slot(0U, kReleased, kNoCause, 1U, 0U, 1U), Data(0U, 0x3412U), Inverse(2200U), Slot(0U, kReleased, kNoCause, 2U, 0U, 1U),
    NotProducing(0U), TakeNone(0U), Data(0U, 0x3412U), Request(0U), Stand(0U), Cycle(3000U), Due(0U), Refresh(0U),
    Masks(1U, 0U, 0U, 0U, 1U), Signalled(0U), Slot(0U, kReleased, kNoCause, 2U, 0U, 1U),
};

// A request that waits is given up with OPERATIONAL: for the first transmission, then for a pair in flight.
constexpr Step kWaitingRequestLeft[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Request(0U), Cycle(1000U), Due(0U), Nmt(NmtState::kPreOperational), Cycle(1500U),
    Nmt(NmtState::kOperational), Cycle(2000U), Cycle(4000U), Due(0U), ReadyPair(0U), Request(0U), Cycle(5000U), Due(0U),
    Nmt(NmtState::kStopped), Cycle(6000U), Due(0U), TransmitFault(0U, Cause::kBusOff), Slot(0U, kOff, kNoCause, 0U, 0U, 0U),
    Nmt(NmtState::kOperational), Cycle(7000U), NotInverse(0U), Cycle(9000U), Due(0U), Signalled(0U),
    Slot(0U, kProducing, kNoCause, 0U, 0U, 0U),
};

constexpr Case kCases[] = {
    MakeCase("PairIsSent", {req::SRS_PROD_005, req::SRS_PROD_006, req::SRS_PROD_007, req::SRS_CONS_025}, kSender,
             kSend),
    MakeCase("NothingIsDueWithoutARequest", {req::SRS_PROD_003, req::SRS_PROD_010}, kSender, kNoRequest),
    MakeCase("FirstTransmissionOfNode127", {req::SRS_PROD_001, req::SRS_TIME_004}, kProviderLast, kLastNode),
    MakeCase("FirstTransmissionAfterARoundOfTheCounter", {req::SRS_PROD_001, req::SRS_TIME_001}, kSender,
             kStartedForGood),
    MakeCase("RequestBeforeTheFirstTransmissionWaits", {req::SRS_PROD_001, req::SRS_PROD_003}, kSender,
             kFirstCallDuesAtOnce),
    MakeCase("DueUntilPrepared", {req::SRS_PROD_004, req::SRS_PROD_003}, kSender, kDueUntilPrepared),
    MakeCase("RequestInFlightWaits", {req::SRS_PROD_003, req::SRS_PROD_004}, kSender, kRequestInFlight),
    MakeCase("RequestWaitsUntilThePairIsGivenUp", {req::SRS_PROD_003, req::SRS_PROD_009}, kSender,
             kRequestAfterGivingUp),
    MakeCase("RequestInTheCallThatGivesUp", {req::SRS_PROD_003, req::SRS_PROD_008}, kSender, kRequestWithGivingUp),
    MakeCase("RequestInTheEnteringCall", {req::SRS_PROD_003, req::SRS_PROD_001}, kSender, kRequestOnEntering),
    MakeCase("RequestInTheLeavingCall", {req::SRS_PROD_003, req::SRS_PROD_011}, kSender, kRequestOnLeaving),
    MakeCase("NoProducerWhileOff", {req::SRS_PROD_005, req::SRS_PROD_003, req::SRS_PROD_011}, kSender, kNotActive),
    MakeCase("ConsumerIsNoProducer", {req::SRS_PROD_005, req::SRS_PROD_003, req::SRS_PROD_009}, kMixed, kNotAProducer),
    MakeCase("NoPrepareInFlight", {req::SRS_PROD_005}, kSender, kPrepareInFlight),
    MakeCase("ObjectsThatAreNotInverse", {req::SRS_PROD_005, req::SRS_PROD_006, req::SRS_PROD_009}, kSender,
             kNotInverse),
    MakeCase("EveryObjectIsCheckedForInversion", {req::SRS_PROD_005}, kSender, kEveryObject),
    MakeCase("WhatWasPreparedIsSent", {req::SRS_PROD_006, req::SRS_PROD_005}, kSender, kPreparedStays),
    MakeCase("InverseFrameAsOftenAsItIsAskedFor", {req::SRS_PROD_006}, kSender, kInverseOften),
    MakeCase("NoInverseFrameOnceThePairIsOver", {req::SRS_PROD_006, req::SRS_PROD_009, req::SRS_PROD_011}, kSender,
             kInverseOver),
    MakeCase("InverseFrameConfirmedButNotHandedOut", {req::SRS_PROD_007, req::SRS_PROD_006}, kSender,
             kInverseNotTaken),
    MakeCase("OnlyConsumersHold", {req::SRS_CONS_025}, kMixed, kOneHolds),
    MakeCase("InverseFrameWaitsForTheNormalFrame", {req::SRS_PROD_006, req::SRS_PROD_007}, kSender, kInverseWaits),
    MakeCase("FramesOnTwoControllers", {req::SRS_PROD_006}, kSenderPorts, kTwoControllers),
    MakeCase("FramesOnSwappedControllers", {req::SRS_PROD_005, req::SRS_PROD_006}, kSenderSwapped,
             kControllersSwapped),
    MakeCase("LeavingGivesEverythingUp", {req::SRS_PROD_011}, kSender, kLeave),
    MakeCase("NoHalfOfAnOldPair", {req::SRS_PROD_011}, kSender, kLeaveWithInverse),
    MakeCase("FirstTransmissionAfterReentering", {req::SRS_PROD_011, req::SRS_PROD_001}, kSender, kLeaveAndWait),
    MakeCase("SixteenEntriesAreSent", {req::SRS_PROD_005, req::SRS_PROD_006}, kWideSender, kSixteen),
    MakeCase("MixedSizesAreSent", {req::SRS_PROD_005, req::SRS_PROD_006}, kWordSender, kWords),
    MakeCase("SixtyFourBitsArePrepared", {req::SRS_PROD_005}, kLongSender, kLongObject),
    MakeCase("SevenBytesAreSent", {req::SRS_PROD_005, req::SRS_PROD_006, req::SRS_PROD_007}, kOddSender, kOddObject),
    MakeCase("DueMarkIsGivenUp", {req::SRS_PROD_011, req::SRS_PROD_004}, kSender, kDueGivenUp),
    MakeCase("RequestsInFlightDoNotAddUp", {req::SRS_PROD_003, req::SRS_PROD_007}, kSender, kRequestsInFlight),
    MakeCase("SlotsThatAreNotThere", {req::SRS_PROD_003, req::SRS_PROD_012, req::SRS_PROD_013}, kSender, kNoSuchSlot),
    MakeCase("ConsumerIsLeftAlone", {req::SRS_PROD_005, req::SRS_PROD_006, req::SRS_PROD_007, req::SRS_PROD_009, req::SRS_PROD_012},
             kMixed, kConsumerStays),
    MakeCase("RequestThatWaitsIsGivenUp", {req::SRS_PROD_011, req::SRS_PROD_003, req::SRS_PROD_009}, kSender, kWaitingRequestLeft),
};
// clang-format on
} // namespace

const CaseTable kProducerCases = MakeTable("producer", kCases);

} // namespace counterpoint::conformance
