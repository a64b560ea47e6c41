// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Refresh: phase, missed refresh, both forms. First transmission at 2 ms, refresh 25 ms. Times in microseconds.
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
constexpr std::uint32_t kMissedBit = Bit(Cause::kRefreshMissed);

// Due at 2000 + k * 25000, whatever the jitter of the calls.
constexpr Step kPhase[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Due(0U), Cycle(1999U), Due(0U), Cycle(2900U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 3000U),
    TakeSecond(0U), ConfirmSecond(0U, 3100U), Cycle(3500U), Due(0U), Cycle(26999U), Due(0U), Cycle(27000U), Due(1U),
    ReadyPair(0U), ConfirmFirst(0U, 27100U),
    TakeSecond(0U), ConfirmSecond(0U, 27200U), Cycle(51999U), Due(0U), Cycle(53300U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 53400U), TakeSecond(0U),
    ConfirmSecond(0U, 53500U), Cycle(76999U), Due(0U), Cycle(77000U), Due(1U),
    Slot(0U, kProducing, kNoCause, 3U, 0U, 0U),
};

// A request between two refreshes is sent and leaves the phase alone.
constexpr Step kRequestKeepsPhase[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 2100U), ConfirmSecond(0U, 2200U),
    Request(0U), Cycle(10000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 10100U), ConfirmSecond(0U, 10200U), Cycle(11000U), Due(0U),
    Cycle(26999U), Due(0U), Cycle(27000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 27100U), ConfirmSecond(0U, 27200U),
    Cycle(51999U), Due(0U), Cycle(52000U), Due(1U), Slot(0U, kProducing, kNoCause, 3U, 0U, 0U),
};

// Prepare uses up both the request and the refresh that fell due.
constexpr Step kBothUsedUp[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Request(0U), Cycle(2000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 2100U), ConfirmSecond(0U, 2200U),
    Cycle(3000U), Due(0U), Cycle(26000U), Due(0U), Cycle(27000U), Due(1U),
    Slot(0U, kProducing, kNoCause, 1U, 0U, 0U),
};

// A request whose mark is still there when the refresh falls due is no missed refresh.
constexpr Step kRequestThenRefresh[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 2100U), ConfirmSecond(0U, 2200U),
    Request(0U), Cycle(26000U), Due(1U), Cycle(27000U), Due(1U), Signals(0U, 0U), ReadyPair(0U),
    Cycle(28000U), Due(0U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U),
};

// t     2000        3000           27999   28000           53000
//       due         stood; prepared         due (25000 after 3000)
constexpr Step kStood[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), Stand(0U), Cycle(3000U), Due(1U),
    ReadyPair(0U), ConfirmFirst(0U, 3100U), ConfirmSecond(0U, 3200U), Cycle(27999U), Due(0U), Cycle(28000U), Due(1U),
    ReadyPair(0U), ConfirmFirst(0U, 28100U), ConfirmSecond(0U, 28200U), Cycle(52999U), Due(0U), Cycle(53000U), Due(1U),
    Slot(0U, kProducing, kNoCause, 2U, 0U, 0U),
};

// The time since the previous OnCycle counts, and that of this call alone.
constexpr Step kStoodOnce[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), Stand(0U), Cycle(2300U), Cycle(3300U),
    ReadyPair(0U), ConfirmFirst(0U, 3400U), ConfirmSecond(0U, 3500U), Cycle(27299U), Due(0U), Cycle(27300U), Due(1U),
};

// The initial delay does not stand: it was not over at the call before.
constexpr Step kStoodTooEarly[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(1000U), Stand(0U), Cycle(1999U), Due(0U), Stand(0U),
    Cycle(2000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 2100U), ConfirmSecond(0U, 2200U), Cycle(26999U), Due(0U), Cycle(27000U), Due(1U),
};

// Neither the call that leaves OPERATIONAL nor the one that enters it moves anything.
constexpr Step kStoodOnEntering[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), Stand(0U), Nmt(NmtState::kPreOperational),
    Cycle(3000U), Due(0U), Nmt(NmtState::kOperational), Stand(0U), Cycle(4000U), Stand(0U), Cycle(5999U), Due(0U),
    Stand(0U), Cycle(6000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 6100U), ConfirmSecond(0U, 6200U), Cycle(30999U), Due(0U),
    Cycle(31000U), Due(1U),
};

// Two that are called, slot 2 a second one of the same objects: the one that did not stand keeps its phase.
// t     2000           3000             27000         28000
//       both due       slot 1 stood     slot 2 due    slot 1 due
constexpr Step kStoodOfTwo[] = {
    Alter(Parameter::kForm, static_cast<std::uint32_t>(ProducerForm::kProviderCalled), 1U),
    Alter(Parameter::kForm, static_cast<std::uint32_t>(ProducerForm::kProviderCalled), 2U), Configure(),
    Sct(2U, 25U), Srvt(2U, 20U), CobId1(2U, 0x103U), CobId2(2U, 0x104U), Entry(2U, 1U, 0x62100108U), Entry(2U, 2U, 0x62110108U),
    Entry(2U, 3U, 0x62100208U), Entry(2U, 4U, 0x62110208U), MapCount(2U, 4U), Direction(2U, 1U), Signature(2U, 0x8EC1U),
    Validate(2U, ConfigFault::kNone, 0x8EC1U), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(6U), Stand(1U), Cycle(3000U), Due(6U),
    ReadyPair(1U), ConfirmFirst(1U, 3100U), ConfirmSecond(1U, 3200U), Ready(2U, CanPortId::kFirst, 0x103U, 2U, 0x3412U),
    ConfirmNormal(2U, 0x103U, 2U, 0x3412U, 0U, 3300U), ConfirmPair(2U, 0x104U, 2U, 0xCBEDU, 0U, 3400U),
    Cycle(26999U), Due(0U), Cycle(27000U), Due(4U), Cycle(27999U), Due(4U), Cycle(28000U), Due(6U),
};

// t     2000         26999   27000                 52000
//       due, unused          missed; still due     missed
constexpr Step kNotPrepared[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), Cycle(26999U), Due(1U), Refresh(1U), Signals(0U, 0U),
    Cycle(27000U), Due(1U), Refresh(1U), Signals(0U, kMissedBit),
    Slot(0U, kProducing, Cause::kRefreshMissed, 0U, 1U, 0U), Cycle(27001U),
    Slot(0U, kProducing, Cause::kRefreshMissed, 0U, 1U, 0U), Cycle(52000U),
    Slot(0U, kProducing, Cause::kRefreshMissed, 0U, 2U, 0U), ReadyPair(0U), ConfirmFirst(0U, 52100U), ConfirmSecond(0U, 52200U),
    Cycle(76999U), Due(0U), Cycle(77000U), Due(1U),
    Slot(0U, kProducing, Cause::kRefreshMissed, 1U, 2U, 0U),
};

// A pair in flight when the refresh falls due: that refresh waits, and is due behind the pair. The phase stays.
// t     2000  20000              27000     28000        52000
//       due   prepared           waits     due          due
constexpr Step kInFlight[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), Cycle(20000U), Due(1U), ReadyPair(0U), Cycle(26999U), Due(0U), Refresh(0U),
    Cycle(27000U), Due(0U), Refresh(1U), Signals(0U, 0U), ConfirmFirst(0U, 27100U), TakeSecond(0U), ConfirmSecond(0U, 27200U), Cycle(28000U),
    Due(1U), Refresh(1U), Signals(0U, 0U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U), ReadyPair(0U), ConfirmFirst(0U, 28100U), ConfirmSecond(0U, 28200U),
    Cycle(51999U), Due(0U), Refresh(0U), Cycle(52000U), Due(1U), Refresh(1U), Slot(0U, kProducing, kNoCause, 2U, 0U, 0U),
};

// Each half of the pair in flight: the refresh that falls due while the inverse frame is awaited waits as well.
constexpr Step kInFlightWithInverse[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(20000U), ReadyPair(0U), ConfirmFirst(0U, 20100U), TakeSecond(0U), Cycle(27000U), Due(0U),
    Refresh(1U), TakeSecond(0U), Cycle(28000U), Due(0U), Refresh(1U), ConfirmSecond(0U, 28100U), Cycle(29000U), Due(1U), Refresh(1U), Signals(0U, 0U),
    Slot(0U, kProducing, kNoCause, 1U, 0U, 0U),
};

// A request that waits beside the refresh is one pair with it.
constexpr Step kInFlightWithRequest[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), Cycle(20000U), ReadyPair(0U), Request(0U), Cycle(21000U), Due(0U), Refresh(0U),
    Cycle(27000U), Due(0U), Refresh(1U), Signals(0U, 0U), ConfirmFirst(0U, 27100U), ConfirmSecond(0U, 27200U),
    Cycle(28000U), Due(1U), Refresh(1U), ReadyPair(0U), ConfirmFirst(0U, 28100U), ConfirmSecond(0U, 28200U), Cycle(29000U), Due(0U), Refresh(0U),
    Cycle(51999U), Due(0U), Cycle(52000U), Due(1U), Slot(0U, kProducing, kNoCause, 2U, 0U, 0U),
};

// From the call in which it falls due until Prepare, with each of them between.
constexpr Step kFromDueToPrepare[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Refresh(0U), Cycle(1999U), Refresh(0U), Cycle(2000U), Due(1U), Refresh(1U), Cycle(2001U), Due(1U),
    Refresh(1U), Cycle(26999U), Due(1U), Refresh(1U), ReadyPair(0U), Cycle(26999U), Due(0U), Refresh(0U), ConfirmFirst(0U, 26999U),
    Cycle(26999U), Refresh(0U), ConfirmSecond(0U, 26999U), Cycle(26999U), Due(0U), Refresh(0U), Cycle(27000U), Due(1U), Refresh(1U), Signals(0U, 0U),
};

// A request is no refresh, neither with a pair in flight nor without; Prepare uses up both.
constexpr Step kRequestIsNone[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Request(0U), Cycle(1999U), Due(0U), Refresh(0U), Cycle(2000U), Due(1U), Refresh(1U), ReadyPair(0U),
    Request(0U), Cycle(3000U), Due(0U), Refresh(0U), ConfirmFirst(0U, 3100U), ConfirmSecond(0U, 3200U), Cycle(4000U), Due(1U), Refresh(0U),
    Cycle(26999U), Due(1U), Refresh(0U), Cycle(27000U), Due(1U), Refresh(1U), ReadyPair(0U), ConfirmFirst(0U, 27100U), ConfirmSecond(0U, 27200U),
    Cycle(28000U), Due(0U), Refresh(0U), Slot(0U, kProducing, kNoCause, 2U, 0U, 0U),
};

// A pair that was asked for uses up no refresh that has not fallen due.
constexpr Step kAskedJustBefore[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), ConfirmFirst(0U, 2100U), ConfirmSecond(0U, 2200U), Request(0U),
    Cycle(26999U), Due(1U), Refresh(0U), ReadyPair(0U), ConfirmFirst(0U, 26999U), ConfirmSecond(0U, 26999U), Cycle(27000U), Due(1U), Refresh(1U),
    Slot(0U, kProducing, kNoCause, 2U, 0U, 0U),
};

// A Prepare that is refused, for a pair in flight, uses up nothing.
constexpr Step kRefusedPrepare[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(20000U), ReadyPair(0U), Cycle(27000U), Due(0U), Refresh(1U), NotProducing(0U), Cycle(27001U),
    Due(0U), Refresh(1U), ConfirmFirst(0U, 27100U), NotProducing(0U), ConfirmSecond(0U, 27200U), Cycle(28000U), Due(1U), Refresh(1U), Signals(0U, 0U),
};

// Behind a pair that was given up, for each cause.
constexpr Step kBehindGivenUp[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(20000U), ReadyPair(0U), Cycle(27000U), Due(0U), Refresh(1U), TransmitFault(0U, Cause::kBusOff),
    Cycle(28000U), Due(1U), Refresh(1U), Signals(0U, Bit(Cause::kBusOff)), Slot(0U, kProducing, Cause::kBusOff, 0U, 1U, 0U),
    ReadyPair(0U), Cycle(52000U), Due(1U), Refresh(1U), Signals(0U, Bit(Cause::kNoConfirmation)), Slot(0U, kProducing, Cause::kBusOff, 0U, 2U, 0U),
    Cycle(70000U), ReadyPair(0U), Cycle(77000U), Due(0U), Refresh(1U), TransmitFault(0U, Cause::kTransmitQueue), Cycle(78000U), Due(1U), Refresh(1U),
    Signals(0U, Bit(Cause::kTransmitQueue)), Slot(0U, kProducing, Cause::kBusOff, 0U, 3U, 0U),
};

// The fault that gives up the pair comes from its echo: another byte, or later than SRVT.
constexpr Step kBehindWrongEcho[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(20000U), ReadyPair(0U), Cycle(27000U), Due(0U), Refresh(1U),
    ConfirmNone(0x101U, 2U, 0x3413U, 0U, 27100U), Cycle(28000U), Due(1U), Refresh(1U), Signals(0U, Bit(Cause::kWrongEcho)),
    Cycle(50000U), ReadyPair(0U), ConfirmFirst(0U, 50100U), Cycle(52000U), Due(0U), Refresh(1U), StrangeSecond(70101U), Cycle(70102U), Due(1U), Refresh(1U),
    Signals(0U, Bit(Cause::kNoConfirmation)), Slot(0U, kProducing, Cause::kWrongEcho, 0U, 2U, 0U),
};

// Sides that are not inverse, told only after the refresh fell due.
constexpr Step kBehindNotInverse[] = {
    Configure(), kP1, kP2, kI1, Put(0x6211U, 2U, 0U), Cycle(0U), Cycle(20000U), UnequalPair(0U, 0x3412U, 0xFF12U), Cycle(27000U), Due(0U), Refresh(1U),
    NotInverse(0U), Cycle(28000U), Due(1U), Refresh(1U), Signals(0U, Bit(Cause::kNotInverse)), UnequalPair(0U, 0x3412U, 0xFF12U), NotInverse(0U),
    Cycle(29000U), Due(0U), Refresh(0U), Cycle(51999U), Due(0U), Refresh(0U), Cycle(52000U), Due(1U), Refresh(1U),
};

// SRVT of the pair in flight is over in a call behind the one in which the refresh fell due.
constexpr Step kBehindSilence[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(20000U), ReadyPair(0U), Cycle(27000U), Due(0U), Refresh(1U), Cycle(40000U), Due(0U), Refresh(1U),
    Signals(0U, 0U), Cycle(40001U), Due(1U), Refresh(1U), Signals(0U, Bit(Cause::kNoConfirmation)), Slot(0U, kProducing, Cause::kNoConfirmation, 0U, 1U, 0U),
};

// The one that falls due behind the one that waits is missed, with a pair in flight as well; the first one waits on.
// t     20000     27000   40000      51999  52000    60000      77000
//       prepared  waits   confirmed         missed   pair; due  due
constexpr Step kSecondInFlight[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(20000U), ReadyPair(0U), Cycle(27000U), Due(0U), Refresh(1U), Cycle(40000U), ConfirmFirst(0U, 40000U),
    Cycle(51999U), Due(0U), Refresh(1U), Signals(0U, 0U), Cycle(52000U), Due(0U), Refresh(1U), Signals(0U, kMissedBit),
    Slot(0U, kProducing, Cause::kRefreshMissed, 0U, 1U, 0U), TakeSecond(0U), ConfirmSecond(0U, 60000U), Cycle(60000U), Due(1U), Refresh(1U), Signals(0U, 0U),
    ReadyPair(0U), ConfirmFirst(0U, 60100U), ConfirmSecond(0U, 60200U), Cycle(76999U), Due(0U), Refresh(0U), Cycle(77000U), Due(1U), Refresh(1U),
    Slot(0U, kProducing, Cause::kRefreshMissed, 2U, 1U, 0U),
};

// One that waited in flight and is not prepared behind the pair: missed is the next one.
constexpr Step kSecondBehindThePair[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(20000U), ReadyPair(0U), Cycle(27000U), ConfirmFirst(0U, 27100U), ConfirmSecond(0U, 27200U),
    Cycle(51999U), Due(1U), Refresh(1U), Signals(0U, 0U), Cycle(52000U), Due(1U), Refresh(1U), Signals(0U, kMissedBit),
    Slot(0U, kProducing, Cause::kRefreshMissed, 1U, 1U, 0U), ReadyPair(0U), ConfirmFirst(0U, 52100U), ConfirmSecond(0U, 52200U),
    Cycle(53000U), Due(0U), Refresh(0U), Cycle(76999U), Due(0U), Cycle(77000U), Due(1U), Refresh(1U), Slot(0U, kProducing, Cause::kRefreshMissed, 2U, 1U, 0U),
};

// Both fall due in late calls with a pair in flight: one is examined in each.
constexpr Step kLateInFlight[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(26000U), ReadyPair(0U), ConfirmFirst(0U, 46000U), Cycle(53000U), Due(0U), Refresh(1U), Signals(0U, 0U),
    Cycle(53001U), Due(0U), Refresh(1U), Signals(0U, kMissedBit), Cycle(53002U), Due(0U), Refresh(1U), Signals(0U, 0U), ConfirmSecond(0U, 53100U),
    Cycle(54000U), Due(1U), Refresh(1U), Slot(0U, kProducing, Cause::kRefreshMissed, 1U, 1U, 0U),
};

// Leaving OPERATIONAL forgets the refresh that waits, with a pair in flight and without.
constexpr Step kWaitingLeft[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(20000U), ReadyPair(0U), Cycle(27000U), Refresh(1U), Nmt(NmtState::kPreOperational), Cycle(28000U),
    Due(0U), Refresh(0U), Nmt(NmtState::kOperational), Cycle(29000U), Due(0U), Refresh(0U), Cycle(30999U), Due(0U), Refresh(0U), Cycle(31000U), Due(1U),
    Refresh(1U), Nmt(NmtState::kStopped), Cycle(32000U), Due(0U), Refresh(0U), Nmt(NmtState::kOperational), Cycle(33000U), Due(0U), Refresh(0U),
    Cycle(35000U), Due(1U), Refresh(1U), Signals(0U, 0U), Store(0U, ConfigField::kConfigurationValid, 0U), Cycle(36000U), Due(0U), Refresh(0U),
};

// Another form has none, whatever is due or silent.
constexpr Step kOfSender[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Refresh(0U), Cycle(2000U), Due(0U), Refresh(0U), Request(0U), Cycle(3000U), Due(1U), Refresh(0U),
    ReadyPair(0U), Request(0U), Cycle(4000U), Due(0U), Refresh(0U), ConfirmFirst(0U, 4100U), ConfirmSecond(0U, 4200U), Cycle(5000U), Due(1U), Refresh(0U),
    ReadyPair(0U), ConfirmFirst(0U, 5100U), ConfirmSecond(0U, 5200U), Cycle(31501U), Due(0U), Refresh(0U), Signals(0U, kMissedBit),
};

// The slot that sends, of three; a consumer and one that is off have none.
constexpr Step kOfOthers[] = {
    Alter(Parameter::kForm, static_cast<std::uint32_t>(ProducerForm::kProviderCalled), 1U), Configure(), kP1, kP2, kI1, kI2, Cycle(0U),
    Cycle(2000U), Due(2U), Refresh(2U), Stand(0U), Stand(2U), Request(0U), Request(2U), Cycle(3000U), Due(2U),
    Refresh(2U), ReadyPair(1U), Cycle(4000U), Due(0U), Refresh(0U),
};

// Standing while it waits moves the next one, with a pair in flight and behind it.
// t     20000     27000  27600             28000  29000             53599  53600 = 52000 + 600 + 1000
//       prepared  waits  stood by 600      due    stood by 1000            due
constexpr Step kStoodWaiting[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(20000U), ReadyPair(0U), Cycle(27000U), Refresh(1U), Stand(0U), Cycle(27600U), Due(0U), Refresh(1U),
    ConfirmFirst(0U, 27700U), ConfirmSecond(0U, 27800U), Cycle(28000U), Due(1U), Refresh(1U), Stand(0U), Cycle(29000U), Due(1U), Refresh(1U), Signals(0U, 0U),
    ReadyPair(0U), ConfirmFirst(0U, 29100U), ConfirmSecond(0U, 29200U), Cycle(53599U), Due(0U), Refresh(0U), Cycle(53600U), Due(1U), Refresh(1U),
};

// No confirmation is examined before the refresh: the pair is given up, so the refresh of the same call takes place.
constexpr Step kGivenUpFirst[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), ReadyPair(0U),
    Cycle(27000U), Due(1U), Refresh(1U), Signals(0U, Bit(Cause::kNoConfirmation)),
    Slot(0U, kProducing, Cause::kNoConfirmation, 0U, 1U, 0U),
};

// A call late by more than one refresh: one refresh a call is examined, the phase stays.
constexpr Step kLateCalls[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 2100U), ConfirmSecond(0U, 2200U),
    Cycle(80000U), Due(1U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U), Cycle(80001U), Due(1U),
    Slot(0U, kProducing, Cause::kRefreshMissed, 1U, 1U, 0U), Cycle(80002U),
    Slot(0U, kProducing, Cause::kRefreshMissed, 1U, 2U, 0U), Cycle(80003U),
    Slot(0U, kProducing, Cause::kRefreshMissed, 1U, 2U, 0U), ReadyPair(0U), ConfirmFirst(0U, 80103U), ConfirmSecond(0U, 80203U),
    Cycle(101999U), Due(0U), Cycle(102000U), Due(1U),
    Slot(0U, kProducing, Cause::kRefreshMissed, 2U, 2U, 0U),
};

// The application: 25000 + cycle 1000 + tolerance 500 after the first possible transmission at 2000.
// t     2000   28500 (on)   28501    55001 (on, from 28501)   55002
constexpr Step kSilent[] = {
    Configure(), Cycle(0U), Cycle(2000U), Cycle(28500U), Signals(0U, 0U), Cycle(28501U), Signals(0U, kMissedBit),
    Slot(0U, kProducing, Cause::kRefreshMissed, 0U, 1U, 0U), Due(0U),
    Cycle(28502U), Slot(0U, kProducing, Cause::kRefreshMissed, 0U, 1U, 0U), Cycle(55001U),
    Slot(0U, kProducing, Cause::kRefreshMissed, 0U, 1U, 0U), Cycle(55002U),
    Slot(0U, kProducing, Cause::kRefreshMissed, 0U, 2U, 0U),
};

// Counted from the instant of the first possible transmission, not from the call that came after it.
constexpr Step kSilentFromTheInstant[] = {
    Configure(), Cycle(0U), Cycle(9000U), Cycle(28500U), Signals(0U, 0U), Cycle(28501U), Signals(0U, kMissedBit),
};

constexpr Step kSilentAtFirstCall[] = {
    Configure(), Cycle(0U), Cycle(28501U), Signals(0U, kMissedBit),
};

// From the last Prepare on: its cycle was at 10000.
constexpr Step kSilentAfterPrepare[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(10000U), ReadyPair(0U),
    ConfirmFirst(0U, 10100U), TakeSecond(0U), ConfirmSecond(0U, 10200U),
    Cycle(36500U), Signals(0U, 0U), Cycle(36501U), Signals(0U, kMissedBit),
    Slot(0U, kProducing, Cause::kRefreshMissed, 1U, 1U, 0U),
};

// Sent before the first transmission is possible: silence counts from that instant, which is the later one.
constexpr Step kPreparedEarly[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(1000U), ReadyPair(0U),
    ConfirmFirst(0U, 1100U), TakeSecond(0U), ConfirmSecond(0U, 1200U),
    Cycle(2000U), Cycle(28500U), Signals(0U, 0U), Cycle(28501U), Signals(0U, kMissedBit),
};

// Sent is not what counts: a pair that was prepared and given up ends the silence, whatever it was given up for.
constexpr Step kSilentAfterGivingUp[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(10000U), ReadyPair(0U), TransmitFault(0U, Cause::kBusOff),
    Cycle(20000U), Put(0x6211U, 2U, 0U), UnequalPair(0U, 0x3412U, 0xFF12U), NotInverse(0U), Cycle(21000U),
    Slot(0U, kProducing, Cause::kBusOff, 0U, 2U, 0U), Cycle(46500U),
    Slot(0U, kProducing, Cause::kBusOff, 0U, 2U, 0U), Cycle(46501U), Slot(0U, kProducing, Cause::kBusOff, 0U, 3U, 0U),
};

// A request that waits is no silence, even if nobody prepares it.
constexpr Step kRequestWaits[] = {
    Configure(), Cycle(0U), Cycle(2000U), Request(0U), Cycle(28500U), Due(1U), Signals(0U, 0U), Cycle(28501U), Due(1U),
    Signals(0U, 0U), Cycle(55002U), Signals(0U, 0U), Slot(0U, kProducing, kNoCause, 0U, 0U, 0U),
};

// One that comes with the call that finds the time over comes too late: sent, and an error. It waits then like any.
// t     2000   28501             28502    55002    60000     60001 prepared   86501 (on)   86502
//       first  request: missed   waits    waits    request
constexpr Step kRequestTooLate[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Request(0U), Cycle(28501U), Due(1U), Signals(0U, kMissedBit),
    Slot(0U, kProducing, Cause::kRefreshMissed, 0U, 1U, 0U), Cycle(28502U), Due(1U), Signals(0U, 0U), Cycle(55002U), Due(1U),
    Signals(0U, 0U), Request(0U), Cycle(60000U), Due(1U), Signals(0U, 0U), Cycle(60001U), ReadyPair(0U), ConfirmFirst(0U, 60100U),
    TakeSecond(0U), ConfirmSecond(0U, 60200U), Cycle(86501U), Due(0U), Signals(0U, 0U), Request(0U), Cycle(86502U), Due(1U),
    Signals(0U, kMissedBit), ReadyPair(0U), Slot(0U, kProducing, Cause::kRefreshMissed, 1U, 2U, 0U),
};

// However long the request waits, a whole round of the counter included: silence counts from the pair prepared then.
constexpr Step kRequestWaitsARound[] = {
    Configure(), Cycle(0U), Cycle(2000U), Request(0U), Cycle(3000U), Cycle(0x40000000U), Cycle(0x80000000U),
    Cycle(0xC0000000U), Cycle(3000U), Signals(0U, 0U), UnequalPair(0U, 0x6666U, 0x9999U),
    NotInverse(0U), Cycle(3001U), Signals(0U, Bit(Cause::kNotInverse)), Cycle(29500U), Signals(0U, 0U),
    Cycle(29501U), Signals(0U, kMissedBit), Slot(0U, kProducing, Cause::kNotInverse, 0U, 2U, 0U),
};

// Both forms at once: the provider is called, the application also asks.
constexpr Step kOtherForm[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), ConfirmFirst(0U, 2100U), ConfirmSecond(0U, 2200U),
    Cycle(26999U), Signals(0U, 0U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U), Cycle(27000U),
    ReadyPair(0U), ConfirmFirst(0U, 27100U), ConfirmSecond(0U, 27200U), Cycle(51999U), Signals(0U, 0U),
    Slot(0U, kProducing, kNoCause, 2U, 0U, 0U),
};

// Standing in two cycles before it is due: the refresh moves by the time of both, and so do all that follow.
// t     2000        20000  20600         26000  26400         28000 = 27000 + 600 + 400     53000
//       due, used          moved by 600         moved by 400  due                           due
constexpr Step kStoodInTwoCycles[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 2100U), ConfirmSecond(0U, 2200U),
    Cycle(20000U), Stand(0U), Cycle(20600U), Cycle(26000U), Stand(0U), Cycle(26400U), Cycle(27999U), Due(0U),
    Cycle(28000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 28100U), ConfirmSecond(0U, 28200U), Cycle(52999U), Due(0U), Cycle(53000U),
    Due(1U),
};

// A pair in flight does not keep the phase from standing.
constexpr Step kStoodInFlight[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), ReadyPair(0U), Stand(0U), Cycle(2600U), Due(0U),
    ConfirmFirst(0U, 2700U), Stand(0U), Cycle(2900U), ConfirmSecond(0U, 3000U), Cycle(27899U), Due(0U),
    Cycle(27900U), Due(1U), Slot(0U, kProducing, kNoCause, 1U, 0U, 0U),
};

// Standing in the call in which it would have fallen due: by the microsecond of that call.
constexpr Step kStoodAtTheLast[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 2100U), ConfirmSecond(0U, 2200U),
    Cycle(26999U), Stand(0U), Cycle(27000U), Due(0U), Cycle(27001U), Due(1U),
};

// The initial delay does not stand, nor does what comes before OPERATIONAL.
constexpr Step kStoodAllAlong[] = {
    Configure(), kP1, kP2, kI1, kI2, Nmt(NmtState::kPreOperational), Stand(0U), Cycle(0U),
    Nmt(NmtState::kOperational), Stand(0U), Cycle(1000U), Stand(0U), Cycle(2500U), Stand(0U), Cycle(2999U), Due(0U),
    Stand(0U), Cycle(3000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 3100U), ConfirmSecond(0U, 3200U), Cycle(27999U), Due(0U),
    Cycle(28000U), Due(1U),
};

// What stood before leaving OPERATIONAL is nothing to what comes after it.
constexpr Step kStoodAndLeft[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), ReadyPair(0U), Stand(0U), Cycle(2500U), Stand(0U),
    Nmt(NmtState::kStopped), Cycle(3000U), Stand(0U), Cycle(3500U), Stand(0U), Nmt(NmtState::kOperational),
    Cycle(4000U), Cycle(5999U), Due(0U), Cycle(6000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 6100U), ConfirmSecond(0U, 6200U),
    Cycle(30999U), Due(0U), Cycle(31000U), Due(1U),
};

// The time of an application stands as well, and is not examined meanwhile.
// t     2000   10000          28501               55000 (on: 2000 + 26501 + 26500 = 55001)   55002
//       first  stood 8000     stood 18501: 28503
constexpr Step kStoodSender[] = {
    Configure(), Cycle(0U), Cycle(2000U), Stand(0U), Cycle(10000U), Stand(0U), Cycle(28501U), Signals(0U, 0U),
    Cycle(55001U), Signals(0U, 0U), Cycle(55002U), Signals(0U, kMissedBit), Slot(0U, kProducing, Cause::kRefreshMissed, 0U, 1U, 0U),
};

// It is not moved on in the call that enters OPERATIONAL, nor before the first possible transmission.
constexpr Step kStoodSenderTooEarly[] = {
    Configure(), Nmt(NmtState::kPreOperational), Cycle(0U), Nmt(NmtState::kOperational), Stand(0U), Cycle(1000U),
    Stand(0U), Cycle(2500U), Stand(0U), Cycle(4000U), Cycle(29500U), Signals(0U, 0U), Cycle(29501U), Signals(0U, kMissedBit),
};

// However far behind the refresh is: the call in which the slot stands examines none, with one that waits and without.
// t     2000       80000 (27000 waits)   80100 stood        80101 (52100)   80201 stood   80202 (77200)   80203
//       due, used                        nothing falls due  due again       not missed    missed
constexpr Step kStoodFarBehind[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 2100U), ConfirmSecond(0U, 2200U),
    Cycle(80000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 80001U), ConfirmSecond(0U, 80002U), Stand(0U), Cycle(80100U), Due(0U), Refresh(0U),
    Cycle(80101U), Due(1U), Refresh(1U), Signals(0U, 0U), Stand(0U), Cycle(80201U), Due(1U), Refresh(1U), Signals(0U, 0U), Cycle(80202U), Due(1U),
    Refresh(1U), Signals(0U, kMissedBit), Cycle(80203U), Signals(0U, 0U), Slot(0U, kProducing, Cause::kRefreshMissed, 2U, 1U, 0U),
};


// A consumer and one that is off have nothing that stands.
constexpr Step kStoodOthers[] = {
    Configure(), Cycle(0U), Normal(1000U), Stand(0U), Stand(2U), Inverse(2000U), Cycle(3000U), Stand(0U),
    Slot(0U, kReleased, kNoCause, 1U, 0U, 1U), Cycle(51000U),
    Masks(1U, 0U, 0U, 0U, 0U), Cycle(51001U), Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U),
    Slot(2U, kOff, kNoCause, 0U, 0U, 0U),
};

// Refresh every millisecond, which is the cycle, and every 65535 ms.
constexpr Step kShortestRefresh[] = {
    StoreAll(), Sct(0U, 1U), Signature(0U, 0xDC02U), Validate(0U, ConfigFault::kNone, 0xDC02U), Store(0U, ConfigField::kConfigurationValid, 0xA5U),
    kP1, kP2, kI1, kI2, Cycle(0U), Cycle(1999U), Due(0U), Cycle(2000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 2100U), ConfirmSecond(0U, 2200U),
    Cycle(2999U), Due(0U), Cycle(3000U), Due(1U), Refresh(1U), ReadyPair(0U), ConfirmFirst(0U, 3100U), ConfirmSecond(0U, 3200U), Cycle(3999U), Due(0U),
    Cycle(4000U), Due(1U), Cycle(4999U), Signals(0U, 0U), Cycle(5000U), Signals(0U, kMissedBit), Slot(0U, kProducing, Cause::kRefreshMissed, 2U, 1U, 0U),
};

constexpr Step kLongestRefresh[] = {
    StoreAll(), Sct(0U, 65535U), Signature(0U, 0x7408U), Validate(0U, ConfigFault::kNone, 0x7408U), Store(0U, ConfigField::kConfigurationValid, 0xA5U),
    kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 2100U), ConfirmSecond(0U, 2200U), Cycle(65536999U), Due(0U),
    Cycle(65537000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 65537100U), ConfirmSecond(0U, 65537200U), Cycle(131071999U), Due(0U), Cycle(131072000U),
    Due(1U), Slot(0U, kProducing, kNoCause, 2U, 0U, 0U),
};

// Refresh time, cycle and tolerance each count: 100000 + 3000 + 700 after 2000, then 100000 + 3000; 65535000 + 1000 + 500.
constexpr Step kSilentByEach[] = {
    Alter(Parameter::kCycle, 3000U), Alter(Parameter::kCycleTolerance, 700U), StoreAll(), Sct(0U, 100U), Signature(0U, 0x4AA1U),
    Validate(0U, ConfigFault::kNone, 0x4AA1U), Store(0U, ConfigField::kConfigurationValid, 0xA5U), Cycle(0U), Cycle(105700U), Signals(0U, 0U),
    Cycle(105701U), Signals(0U, kMissedBit),
    Alter(Parameter::kCycleTolerance, 0U), StoreAll(), Sct(0U, 100U), Signature(0U, 0x4AA1U), Validate(0U, ConfigFault::kNone, 0x4AA1U),
    Store(0U, ConfigField::kConfigurationValid, 0xA5U), Cycle(0U), Cycle(105000U), Signals(0U, 0U), Cycle(105001U), Signals(0U, kMissedBit),
    Restart(), StoreAll(), Sct(0U, 65535U), Signature(0U, 0x7408U), Validate(0U, ConfigFault::kNone, 0x7408U),
    Store(0U, ConfigField::kConfigurationValid, 0xA5U), Cycle(0U), Cycle(65538500U), Signals(0U, 0U), Cycle(65538501U), Signals(0U, kMissedBit),
};

// A form that is neither is that of an application that sends.
constexpr Step kNeitherForm[] = {
    Alter(Parameter::kForm, 2U), Configure(), Cycle(0U), Cycle(2000U), Due(0U), Refresh(0U), Cycle(28500U), Due(0U), Signals(0U, 0U), Cycle(28501U),
    Due(0U), Refresh(0U), Signals(0U, kMissedBit), Alter(Parameter::kForm, 0xFFU), Configure(), Cycle(0U), Cycle(2000U), Due(0U), Refresh(0U),
};

// Both limits over in one call: no confirmation is the first cause. The application sends, then the provider is called.
// t     2000       28501
//       prepared   both
constexpr Step kNoConfirmationAndSilence[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), Cycle(28501U), Due(0U), Signals(0U, Bit(Cause::kNoConfirmation) | kMissedBit),
    Slot(0U, kProducing, Cause::kNoConfirmation, 0U, 2U, 0U), StrangeFirst(28502U), TakeNone(0U),
};

// t     26000      27000   52000
//       prepared   waits   both; due
constexpr Step kNoConfirmationAndMissed[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), Due(1U), Cycle(26000U), ReadyPair(0U), Cycle(27000U), Due(0U), Refresh(1U), Cycle(52000U),
    Due(1U), Refresh(1U), Signals(0U, Bit(Cause::kNoConfirmation) | kMissedBit), Slot(0U, kProducing, Cause::kNoConfirmation, 0U, 2U, 0U),
};

// Silence with a pair in flight: the pair stays. A Prepare that is refused ends no silence.
// t     2000       21000         28500     28501    28600         55001   55002
//       prepared   N confirmed   refused   missed   I confirmed   on      missed
constexpr Step kSilentInFlight[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), ConfirmFirst(0U, 21000U), Cycle(28500U), Signals(0U, 0U), NotProducing(0U),
    Cycle(28501U), Signals(0U, kMissedBit), Data(0U, 0x3412U), TakeSecond(0U), ConfirmSecond(0U, 28600U),
    Slot(0U, kProducing, Cause::kRefreshMissed, 1U, 1U, 0U), Cycle(55001U), Signals(0U, 0U), Cycle(55002U), Signals(0U, kMissedBit),
};

// A request that waits for the pair in flight is no silence; it counts from the pair prepared for it.
// t     2000       21000         22000     28501   30000         31000      57500   57501
//       prepared   N confirmed   request   waits   I confirmed   prepared   on      missed
constexpr Step kRequestInFlight[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), ConfirmFirst(0U, 21000U), Request(0U), Cycle(22000U), Due(0U), Cycle(28501U),
    Due(0U), Signals(0U, 0U), ConfirmSecond(0U, 30000U), Cycle(31000U), Due(1U), Signals(0U, 0U), ReadyPair(0U), ConfirmFirst(0U, 31100U),
    ConfirmSecond(0U, 31200U), Cycle(57500U), Signals(0U, 0U), Cycle(57501U), Signals(0U, kMissedBit), Slot(0U, kProducing, Cause::kRefreshMissed, 2U, 1U, 0U),
};

// Who stands has no refresh examined; a request and the confirmation are.
constexpr Step kStoodAndAsked[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U), ConfirmFirst(0U, 2100U), ConfirmSecond(0U, 2200U), Cycle(26500U), Stand(0U),
    Request(0U), Cycle(27000U), Due(1U), Refresh(0U), ReadyPair(0U), Cycle(27499U), Refresh(0U), Cycle(27500U), Due(0U), Refresh(1U), Stand(0U), Cycle(47000U),
    Due(0U), Signals(0U, 0U), Stand(0U), Cycle(47001U), Due(1U), Refresh(1U), Signals(0U, Bit(Cause::kNoConfirmation)),
};

// A refresh missed in each call: the count ends at 65535.
constexpr Step kCountStays[] = {
    StoreAll(), Sct(0U, 1U), Signature(0U, 0xDC02U), Validate(0U, ConfigFault::kNone, 0xDC02U), Store(0U, ConfigField::kConfigurationValid, 0xA5U),
    Cycle(0U), Cycle(2000U), Cycle(3000U), Slot(0U, kProducing, Cause::kRefreshMissed, 0U, 1U, 0U), Repeat(65532U, 1000U),
    Slot(0U, kProducing, Cause::kRefreshMissed, 0U, 65533U, 0U), Cycle(65536000U), Slot(0U, kProducing, Cause::kRefreshMissed, 0U, 65534U, 0U),
    Cycle(65537000U), Slot(0U, kProducing, Cause::kRefreshMissed, 0U, 65535U, 0U), Cycle(65538000U), Signals(0U, kMissedBit),
    Slot(0U, kProducing, Cause::kRefreshMissed, 0U, 65535U, 0U),
};

constexpr Case kCases[] = {
    MakeCase("RefreshKeepsItsPhase", {req::SRS_PROD_002, req::SRS_TIME_001}, kProvider, kPhase),
    MakeCase("StoodRefreshMovesOn", {req::SRS_PROD_012}, kProvider, kStood),
    MakeCase("StoodInOneCallAlone", {req::SRS_PROD_012}, kProvider, kStoodOnce),
    MakeCase("StoodSlotAlone", {req::SRS_PROD_012}, kMixed, kStoodOfTwo),
    MakeCase("StoodUntilTheFirstTransmission", {req::SRS_PROD_012}, kProvider, kStoodTooEarly),
    MakeCase("StoodInTheEnteringCall", {req::SRS_PROD_012}, kProvider, kStoodOnEntering),
    MakeCase("RequestLeavesThePhase", {req::SRS_PROD_003, req::SRS_PROD_002}, kProvider, kRequestKeepsPhase),
    MakeCase("PrepareUsesUpRequestAndRefresh", {req::SRS_PROD_005, req::SRS_PROD_004}, kProvider, kBothUsedUp),
    MakeCase("RequestIsNoMissedRefresh", {req::SRS_PROD_010, req::SRS_PROD_003}, kProvider, kRequestThenRefresh),
    MakeCase("RefreshThatNobodyPrepares", {req::SRS_PROD_010, req::SRS_PROD_004}, kProvider, kNotPrepared),
    MakeCase("RefreshWhileInFlight", {req::SRS_PROD_013, req::SRS_PROD_004, req::SRS_PROD_010}, kProvider, kInFlight),
    MakeCase("RefreshWhileTheInverseIsAwaited", {req::SRS_PROD_013, req::SRS_PROD_004}, kProvider,
             kInFlightWithInverse),
    MakeCase("RequestAndRefreshBehindThePair", {req::SRS_PROD_013, req::SRS_PROD_003, req::SRS_PROD_005}, kProvider,
             kInFlightWithRequest),
    MakeCase("RefreshWaitsUntilPrepare", {req::SRS_PROD_013, req::SRS_PROD_002}, kProvider, kFromDueToPrepare),
    MakeCase("RequestIsNoRefresh", {req::SRS_PROD_013, req::SRS_PROD_003}, kProvider, kRequestIsNone),
    MakeCase("RequestJustBeforeTheRefresh", {req::SRS_PROD_013, req::SRS_PROD_005}, kProvider, kAskedJustBefore),
    MakeCase("RefusedPrepareUsesUpNoRefresh", {req::SRS_PROD_013, req::SRS_PROD_005}, kProvider, kRefusedPrepare),
    MakeCase("RefreshBehindAPairThatIsGivenUp", {req::SRS_PROD_013, req::SRS_PROD_009}, kProvider, kBehindGivenUp),
    MakeCase("RefreshBehindAWrongOrLateEcho", {req::SRS_PROD_013, req::SRS_PROD_007, req::SRS_PROD_008}, kProvider,
             kBehindWrongEcho),
    MakeCase("RefreshBehindSidesNotInverse", {req::SRS_PROD_013, req::SRS_PROD_009}, kProvider, kBehindNotInverse),
    MakeCase("RefreshBehindNoConfirmation", {req::SRS_PROD_013, req::SRS_PROD_008}, kProvider, kBehindSilence),
    MakeCase("SecondRefreshInFlightIsMissed", {req::SRS_PROD_010, req::SRS_PROD_013}, kProvider, kSecondInFlight),
    MakeCase("SecondRefreshBehindThePairIsMissed", {req::SRS_PROD_010, req::SRS_PROD_013}, kProvider,
             kSecondBehindThePair),
    MakeCase("OneRefreshACallInFlight", {req::SRS_PROD_010, req::SRS_PROD_013}, kProvider, kLateInFlight),
    MakeCase("RefreshThatWaitsIsGivenUp", {req::SRS_PROD_011, req::SRS_PROD_013}, kProvider, kWaitingLeft),
    MakeCase("ApplicationThatSendsHasNoRefresh", {req::SRS_PROD_013}, kSender, kOfSender),
    MakeCase("RefreshOfTheProducerAlone", {req::SRS_PROD_013, req::SRS_PROD_012}, kMixed, kOfOthers),
    MakeCase("StoodWhileTheRefreshWaits", {req::SRS_PROD_012, req::SRS_PROD_013}, kProvider, kStoodWaiting),
    MakeCase("ConfirmationIsExaminedBeforeRefresh", {req::SRS_PROD_008, req::SRS_PROD_010}, kProvider, kGivenUpFirst),
    MakeCase("OneRefreshACall", {req::SRS_PROD_010, req::SRS_PROD_002}, kProvider, kLateCalls),
    MakeCase("SilentApplication", {req::SRS_PROD_010, req::SRS_TIME_004, req::SRS_TIME_001}, kSender, kSilent),
    MakeCase("SilenceCountsFromTheInstant", {req::SRS_PROD_010}, kSender, kSilentFromTheInstant),
    MakeCase("SilenceFoundByTheFirstCall", {req::SRS_PROD_010, req::SRS_PROD_001}, kSender, kSilentAtFirstCall),
    MakeCase("SilenceAfterPrepare", {req::SRS_PROD_010, req::SRS_PROD_007}, kSender, kSilentAfterPrepare),
    MakeCase("RequestThatWaitsARoundOfTheCounter", {req::SRS_PROD_010, req::SRS_TIME_001}, kSender,
             kRequestWaitsARound),
    MakeCase("SilenceAfterAnEarlyPrepare", {req::SRS_PROD_010, req::SRS_PROD_001}, kSender, kPreparedEarly),
    MakeCase("SilenceAfterAPairThatWasGivenUp", {req::SRS_PROD_010, req::SRS_PROD_005}, kSender, kSilentAfterGivingUp),
    MakeCase("RequestThatWaitsIsNoSilence", {req::SRS_PROD_010, req::SRS_PROD_003}, kSender, kRequestWaits),
    MakeCase("RequestBehindTheTimeIsTooLate", {req::SRS_PROD_010, req::SRS_PROD_003}, kSender, kRequestTooLate),
    MakeCase("StoodRefreshMoves", {req::SRS_PROD_012, req::SRS_PROD_002, req::SRS_TIME_001}, kProvider,
             kStoodInTwoCycles),
    MakeCase("StoodWhileInFlight", {req::SRS_PROD_012}, kProvider, kStoodInFlight),
    MakeCase("StoodInTheCallInWhichItIsDue", {req::SRS_PROD_012}, kProvider, kStoodAtTheLast),
    MakeCase("StoodBeforeTheFirstTransmission", {req::SRS_PROD_012, req::SRS_PROD_001}, kProvider, kStoodAllAlong),
    MakeCase("StoodBeforeLeavingOperational", {req::SRS_PROD_012, req::SRS_PROD_011}, kProvider, kStoodAndLeft),
    MakeCase("StoodApplicationHasItsTimeMovedOn", {req::SRS_PROD_012, req::SRS_PROD_010}, kSender, kStoodSender),
    MakeCase("StoodApplicationBeforeItsTimeRuns", {req::SRS_PROD_012, req::SRS_PROD_010}, kSender, kStoodSenderTooEarly),
    MakeCase("StoodSlotIsNotExamined", {req::SRS_PROD_012, req::SRS_PROD_010}, kProvider, kStoodFarBehind),
    MakeCase("StoodConsumerIsNone", {req::SRS_PROD_012}, kMixed, kStoodOthers),
    MakeCase("ProviderIsNeverSilent", {req::SRS_PROD_010, req::SRS_PROD_002}, kProvider, kOtherForm),
    MakeCase("ShortestRefreshTime", {req::SRS_PROD_002, req::SRS_PROD_010}, kProvider, kShortestRefresh),
    MakeCase("LongestRefreshTime", {req::SRS_PROD_002}, kProvider, kLongestRefresh),
    MakeCase("SilenceByEachOfItsTimes", {req::SRS_PROD_010, req::SRS_TIME_004}, kSender, kSilentByEach),
    MakeCase("FormThatIsNeither", {req::SRS_PROD_010, req::SRS_PROD_002, req::SRS_PROD_013}, kSender, kNeitherForm),
    MakeCase("ConfirmationIsExaminedBeforeSilence", {req::SRS_PROD_008, req::SRS_PROD_010, req::SRS_PROD_009}, kSender,
             kNoConfirmationAndSilence),
    MakeCase("NoConfirmationBeforeTheMissedRefresh", {req::SRS_PROD_008, req::SRS_PROD_010, req::SRS_PROD_009}, kProvider,
             kNoConfirmationAndMissed),
    MakeCase("SilenceWithAPairInFlight", {req::SRS_PROD_010, req::SRS_PROD_009, req::SRS_PROD_005}, kSender, kSilentInFlight),
    MakeCase("RequestInFlightIsNoSilence", {req::SRS_PROD_010, req::SRS_PROD_003}, kSender, kRequestInFlight),
    MakeCase("StoodWithARequestAndWithoutConfirmation", {req::SRS_PROD_012, req::SRS_PROD_003, req::SRS_PROD_008}, kProvider,
             kStoodAndAsked),
    MakeCase("ErrorCountOfAProducerStaysAt65535", {req::SRS_PROD_009, req::SRS_CONS_020}, kProvider, kCountStays),
};
// clang-format on
} // namespace

const CaseTable kRefreshCases = MakeTable("refresh", kCases);

} // namespace counterpoint::conformance
