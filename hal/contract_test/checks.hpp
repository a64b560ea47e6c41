// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_CONTRACT_TEST_CHECKS_HPP
#define HAL_CONTRACT_TEST_CHECKS_HPP

#include "hal/contract_test/bench.hpp"
#include "hal/contract_test/check.hpp"

/// One function a line of the report; contract_test.cpp has their names and their order.
namespace counterpoint::hal::contract
{

using CheckBody = void (*)(const PortUnderTest& port, Check& check) noexcept;

// Clocks.
void BothCountersGoOn(const PortUnderTest& port, Check& check) noexcept;
void CountersNeverGoBack(const PortUnderTest& port, Check& check) noexcept;
void CountersAreIndependent(const PortUnderTest& port, Check& check) noexcept;
void CountersDoNotWrapEarly(const PortUnderTest& port, Check& check) noexcept;

// Reception.
void AllGuaranteesAreGiven(const PortUnderTest& port, Check& check) noexcept;
void ContentIsAsSent(const PortUnderTest& port, Check& check) noexcept;
void OrderIsThatOfTheBus(const PortUnderTest& port, Check& check) noexcept;
void LateInterruptKeepsOrder(const PortUnderTest& port, Check& check) noexcept;
void StampsAreOfBothCounters(const PortUnderTest& port, Check& check) noexcept;
void StampsAreAsFarApartAsFrames(const PortUnderTest& port, Check& check) noexcept;
void ForeignFramesStayAway(const PortUnderTest& port, Check& check) noexcept;
void OtherKindsAreNoData(const PortUnderTest& port, Check& check) noexcept;
void LossIsTold(const PortUnderTest& port, Check& check) noexcept;
void LossInControllerIsTold(const PortUnderTest& port, Check& check) noexcept;

// Transmission.
void ConfirmedOnceAsSent(const PortUnderTest& port, Check& check) noexcept;
void ConfirmationHasBothStamps(const PortUnderTest& port, Check& check) noexcept;
void NotConfirmedBeforeTheBus(const PortUnderTest& port, Check& check) noexcept;
void NormalLeavesBeforeInverse(const PortUnderTest& port, Check& check) noexcept;
void FullIsRefused(const PortUnderTest& port, Check& check) noexcept;
void OnTheBusAsHandedOver(const PortUnderTest& port, Check& check) noexcept;
void WaitingFramesKeepOrder(const PortUnderTest& port, Check& check) noexcept;
void OwnAndForeignInOrder(const PortUnderTest& port, Check& check) noexcept;
void LateInterruptKeepsOwnFrames(const PortUnderTest& port, Check& check) noexcept;
void NothingOldAfterBusOff(const PortUnderTest& port, Check& check) noexcept;
void AbsentControllerIsRefused(const PortUnderTest& port, Check& check) noexcept;
void CallsComeBack(const PortUnderTest& port, Check& check) noexcept;

// Watchdog.
void QuestionChanges(const PortUnderTest& port, Check& check) noexcept;
void EarlyAnswerTrips(const PortUnderTest& port, Check& check) noexcept;
void MissingAnswerTrips(const PortUnderTest& port, Check& check) noexcept;
void WrongAnswerTrips(const PortUnderTest& port, Check& check) noexcept;
void TrippedStaysTripped(const PortUnderTest& port, Check& check) noexcept;

// Memory.
void ImpossibleRegionIsRefused(const PortUnderTest& port, Check& check) noexcept;
void ProgrammedBytesAreRead(const PortUnderTest& port, Check& check) noexcept;
void EraseTouchesOneBank(const PortUnderTest& port, Check& check) noexcept;

// Output, the cut-off last: nothing but a restart leads out of it.
void ChallengesDiffer(const PortUnderTest& port, Check& check) noexcept;
void ClosedAfterStart(const PortUnderTest& port, Check& check) noexcept;
void OpensByThreePermits(const PortUnderTest& port, Check& check) noexcept;
void WrongPermitCloses(const PortUnderTest& port, Check& check) noexcept;
void InterruptedStaysClosed(const PortUnderTest& port, Check& check) noexcept;
void ClosesByItself(const PortUnderTest& port, Check& check) noexcept;
void ClosedOnceTripped(const PortUnderTest& port, Check& check) noexcept;
void PinsAreReadBack(const PortUnderTest& port, Check& check) noexcept;
void CutOffIsFinal(const PortUnderTest& port, Check& check) noexcept;

} // namespace counterpoint::hal::contract

#endif
