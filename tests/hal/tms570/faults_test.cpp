// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Every fault of the register models, set before the start or in operation, and what the unchanged drivers make of it.
// docs/tms570_faults.md is the same table for people; the last test compares the two.
#include "tests/hal/tms570/rig.hpp"
#include "verification/trace/ids/tms570.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace counterpoint::tms570
{
namespace
{

using model::Fault;

[[nodiscard]] std::string NameOf(const Fault fault)
{
    for (const model::FaultName& row : model::kFaultNames)
    {
        if (row.fault == fault)
        {
            return row.name;
        }
    }
    return "unknown";
}

/// The start is refused at a step.
struct StartFault
{
    Fault fault;
    StartStep step;
};

constexpr StartFault kStartFaults[] = {
    {Fault::kEsmGroup2Before, StartStep::kColdErrors},
    {Fault::kEsmGroup3Before, StartStep::kColdErrors},
    {Fault::kPllNeverLocks, StartStep::kClocks},
    {Fault::kOscillatorFails, StartStep::kClocks},
    {Fault::kClockWriteLost, StartStep::kClocks},
    {Fault::kLbistCheckPasses, StartStep::kLogicTest},
    {Fault::kLbistFails, StartStep::kLogicTest},
    {Fault::kLbistTimesOut, StartStep::kLogicTest},
    {Fault::kCcmSelfTestFails, StartStep::kLockstep},
    {Fault::kCcmSelfTestEndless, StartStep::kLockstep},
    {Fault::kCcmForcedErrorUnseen, StartStep::kLockstep},
    {Fault::kCcmSelfTestErrorUnseen, StartStep::kLockstep},
    {Fault::kPbistCheckPasses, StartStep::kMemoryTest},
    {Fault::kPbistFails, StartStep::kMemoryTest},
    {Fault::kPbistEndless, StartStep::kMemoryTest},
    {Fault::kMemoryInitEndless, StartStep::kMemoryInit},
    {Fault::kRamOneBitUnseen, StartStep::kRamEcc},
    {Fault::kRamOneBitWrong, StartStep::kRamEcc},
    {Fault::kRamTwoBitsUnseen, StartStep::kRamEcc},
    {Fault::kFlashOneBitUnseen, StartStep::kFlashEcc},
    {Fault::kFlashTwoBitsUnseen, StartStep::kFlashEcc},
    {Fault::kVimParityUnseen, StartStep::kTableParity},
    {Fault::kEsmPinStuckHigh, StartStep::kErrorPin},
    {Fault::kEsmPinStuckLow, StartStep::kErrorPin},
    {Fault::kEsmLowTimeLost, StartStep::kErrorPin},
    {Fault::kDccEndless, StartStep::kClockComparator},
    {Fault::kDccWrongClock, StartStep::kClockComparator},
    {Fault::kCounterAStoppedAtStart, StartStep::kCounters},
    {Fault::kCounterBStoppedAtStart, StartStep::kCounters},
    {Fault::kPinStuckHighAtStart, StartStep::kPins},
    {Fault::kMpuWithoutRegions, StartStep::kProtection},
    {Fault::kMpuRegionLost, StartStep::kProtection},
    {Fault::kVimTableStuck, StartStep::kInterrupts},
    {Fault::kVimFallbackLost, StartStep::kInterrupts},
    {Fault::kVimEnableLost, StartStep::kInterrupts},
    {Fault::kEsmWriteLost, StartStep::kEsm},
    {Fault::kDcanInitStuck, StartStep::kCan},
    {Fault::kDcanTimingLost, StartStep::kCan},
    {Fault::kDcanObjectLost, StartStep::kCan},
};

using StartFaults = ::testing::TestWithParam<StartFault>;

/// What has to happen beside setting the fault.
void Bring(Rig& rig, const Fault fault)
{
    rig.machine.faults.Set(fault);
    if (fault == Fault::kEsmGroup2Before)
    {
        rig.machine.esm.Raise(2U, 2U);
    }
    if (fault == Fault::kEsmGroup3Before)
    {
        rig.machine.esm.Raise(3U, 7U);
    }
}

TEST_P(StartFaults, RefusesTheStartAtItsStepAndStaysSafe)
{
    Verifies(req::SRS_TMS_011);
    Verifies(req::SRS_TMS_021);
    Verifies(req::SRS_TMS_031);
    Verifies(req::SRS_TMS_033);
    Verifies(req::SRS_TMS_043);
    Verifies(req::SRS_TMS_044);
    Verifies(req::SRS_TMS_045);
    Verifies(req::SRS_TMS_048);
    Verifies(req::SRS_TMS_049);
    Verifies(req::SRS_TMS_050);
    Verifies(req::SRS_TMS_060);
    Verifies(req::SRS_TMS_061);
    Verifies(req::SRS_TMS_070);
    Verifies(req::SRS_TMS_003);
    Verifies(req::SRS_TMS_004);
    Verifies(req::SRS_TMS_047);
    // Given a controller with this fault
    Rig rig;
    Bring(rig, GetParam().fault);
    // When the board starts
    const StartReport report = rig.Start();
    // Then it is refused at the step that looks for it, with everything off
    EXPECT_EQ(report.answer, StartAnswer::kRefused);
    EXPECT_EQ(report.last, GetParam().step);
    EXPECT_EQ(report.steps[static_cast<std::uint8_t>(GetParam().step)], StepResult::kFailed);
    EXPECT_EQ(rig.machine.gio.PinsA(), (GetParam().fault == Fault::kPinStuckHighAtStart) ? 1U : 0U);
    EXPECT_FALSE(rig.machine.esm.IsPinHigh());
    EXPECT_FALSE(rig.machine.dcan1.IsOnBus());
    const hal::CanGuarantees guarantees = rig.board.Can().Guarantees();
    EXPECT_EQ(guarantees.bus_order, hal::Guarantee::kAbsent);
    EXPECT_EQ(guarantees.stamps, hal::Guarantee::kAbsent);
    EXPECT_EQ(guarantees.confirmations, hal::Guarantee::kAbsent);
    // and when the fault is gone, right permits open nothing and no frame is taken all the same
    rig.machine.faults.Clear(GetParam().fault);
    rig.Arm();
    rig.board.Output().Drive(Rig::RightPermits(rig.board.Output().Challenge(), 1U));
    EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
    EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 1U)), hal::TransmitStatus::kRefused);
    EXPECT_EQ(rig.Cycle(), BoardFault::kStart);
    EXPECT_TRUE(rig.IsSafe());
}

INSTANTIATE_TEST_SUITE_P(All, StartFaults, ::testing::ValuesIn(kStartFaults),
                         [](const auto& row) { return NameOf(row.param.fault); });

/// Told and cut off by the interrupt alone, before any cycle.
constexpr int kInInterrupt = 0;

/// In operation the board tells a fault within so many cycles.
struct RunFault
{
    Fault fault;
    BoardFault told;
    int most_cycles;
};

constexpr RunFault kRunFaults[] = {
    {Fault::kDcanBusyForEver, BoardFault::kCan, 1},
    {Fault::kDcanParityError, BoardFault::kEsm, kInInterrupt},
    {Fault::kDcanWrongReadBack, BoardFault::kCan, 1},
    {Fault::kDcanControlChanged, BoardFault::kCan, 1},
    {Fault::kDcanForeignObject, BoardFault::kCan, 1},
    {Fault::kCounterSetUpChanged, BoardFault::kCounters, 8},
    {Fault::kWatchdogOff, BoardFault::kWatchdog, 8},
    {Fault::kPinStuckHigh, BoardFault::kPins, 2}, // the cycle after the one that closes
    {Fault::kPinStuckLow, BoardFault::kPins, 1},
    {Fault::kPinNotOutput, BoardFault::kPins, 1},
    {Fault::kMpuTurnedOff, BoardFault::kProtection, 8},
    {Fault::kEsmReservedChannel, BoardFault::kEsm, kInInterrupt},
    {Fault::kEsmUncorrectable, BoardFault::kEsm, kInInterrupt},
    {Fault::kEsmCorrectedAgain, BoardFault::kEsm, 17},
    {Fault::kCcmCompareError, BoardFault::kEsm, kInInterrupt},
    {Fault::kCcmNotLockstep, BoardFault::kLockstep, 8},
    {Fault::kVimParityError, BoardFault::kEsm, kInInterrupt},
    {Fault::kVimUnknownRequest, BoardFault::kInterrupts, kInInterrupt},
    {Fault::kVimCheckOff, BoardFault::kInterrupts, 8},
    {Fault::kDccClockDrifts, BoardFault::kEsm, 4},
    {Fault::kDccTurnedOff, BoardFault::kClockComparator, 8},
    {Fault::kPllSlips, BoardFault::kClocks, 8},
};

using RunFaults = ::testing::TestWithParam<RunFault>;

/// The event that shows the fault, once a cycle.
struct Event
{
    Fault fault;
    void (*happen)(Rig& rig);
};

constexpr Event kEvents[] = {
    {Fault::kPinStuckHigh, [](Rig& rig) { rig.opened = 0U; }},
    {Fault::kDcanBusyForEver, [](Rig& rig) { rig.machine.dcan1.Receive(Frame(kNormal, 0x12U)); }},
    {Fault::kDcanParityError, [](Rig& rig) { rig.machine.dcan1.Receive(Frame(kNormal, 0x12U)); }},
    {Fault::kDcanWrongReadBack,
     [](Rig& rig)
     {
         static_cast<void>(rig.board.Can().Transmit(Frame(kSentNormal, 0x12U)));
         static_cast<void>(rig.machine.dcan1.Transmit());
     }},
    {Fault::kEsmReservedChannel, [](Rig& rig) { rig.machine.esm.Raise(1U, 20U); }},
    {Fault::kEsmUncorrectable, [](Rig& rig) { rig.machine.esm.Raise(2U, 6U); }},
    {Fault::kEsmCorrectedAgain, [](Rig& rig) { rig.machine.esm.Raise(1U, 26U); }},
    {Fault::kCcmCompareError, [](Rig& rig) { rig.machine.ccm.Differ(); }},
    {Fault::kVimParityError, [](Rig& rig) { rig.machine.vim.Report(1U, 0xFFF82000U); }},
};

void Provoke(Rig& rig, const Fault fault)
{
    for (const Event& event : kEvents)
    {
        if (event.fault == fault)
        {
            event.happen(rig);
        }
    }
}

TEST_P(RunFaults, AreToldInTimeAndCutOff)
{
    Verifies(req::SRS_TMS_016);
    Verifies(req::SRS_TMS_043);
    Verifies(req::SRS_TMS_050);
    Verifies(req::SRS_TMS_062);
    Verifies(req::SRS_TMS_070);
    Verifies(req::SRS_TMS_019);
    // Given a board in operation with an open output
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    ASSERT_EQ(rig.Cycle(), BoardFault::kNone);
    ASSERT_EQ(rig.Cycle(), BoardFault::kNone);
    const bool has_watchdog = GetParam().fault == Fault::kWatchdogOff;
    if (has_watchdog)
    {
        ASSERT_EQ(rig.board.StartWatchdog(), Outcome::kDone);
    }
    ASSERT_EQ(rig.machine.gio.PinsA(), 1U);
    // When the fault comes
    rig.machine.faults.Set(GetParam().fault);
    BoardFault fault = BoardFault::kNone;
    int cycles = 0;
    if (GetParam().most_cycles == kInInterrupt)
    {
        Provoke(rig, GetParam().fault);
        rig.TakeInterrupts();
        fault = rig.board.Fault();
        EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
        EXPECT_FALSE(rig.machine.esm.IsPinHigh());
        EXPECT_EQ(rig.Cycle(), GetParam().told);
    }
    while ((fault == BoardFault::kNone) && (cycles < 20))
    {
        Provoke(rig, GetParam().fault);
        fault = rig.Cycle();
        ++cycles;
    }
    // Then it is told in time, as what it is, and the device is safe
    EXPECT_EQ(fault, GetParam().told);
    EXPECT_LE(cycles, GetParam().most_cycles);
    rig.machine.faults.Clear(Fault::kPinStuckHigh);
    EXPECT_TRUE(rig.IsSafe());
    // and stays so, whatever the permits are
    rig.machine.faults.Clear(GetParam().fault);
    EXPECT_EQ(rig.Cycle(), GetParam().told);
    EXPECT_TRUE(rig.IsSafe());
}

INSTANTIATE_TEST_SUITE_P(All, RunFaults, ::testing::ValuesIn(kRunFaults),
                         [](const auto& row) { return NameOf(row.param.fault); });

/// The faults of a controller, and why it is off the bus then.
struct ControllerFault
{
    Fault fault;
    CanFault why;
};

using ControllerFaults = ::testing::TestWithParam<ControllerFault>;

TEST_P(ControllerFaults, KeepItOffTheBusUntilARestart)
{
    Verifies(req::SRS_TMS_019);
    // Given a board in operation with an open output
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    ASSERT_EQ(rig.Cycle(), BoardFault::kNone);
    ASSERT_EQ(rig.Cycle(), BoardFault::kNone);
    ASSERT_EQ(rig.machine.gio.PinsA(), 1U);
    ASSERT_TRUE(rig.machine.dcan1.IsOnBus());
    // When its controller has the fault, then the device is safe within one cycle, and it is off the bus and refuses
    rig.machine.faults.Set(GetParam().fault);
    Provoke(rig, GetParam().fault);
    EXPECT_NE(rig.Cycle(), BoardFault::kNone);
    EXPECT_EQ(rig.board.Can().Controller(CanPortId::kFirst).Fault(), GetParam().why);
    EXPECT_TRUE(rig.IsSafe());
    EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 1U)), hal::TransmitStatus::kRefused);
    // and that stays so where the fault goes again
    rig.machine.faults.Clear(GetParam().fault);
    for (int cycle = 0; cycle < 20; ++cycle)
    {
        EXPECT_NE(rig.Cycle(), BoardFault::kNone);
        EXPECT_FALSE(rig.machine.dcan1.IsOnBus());
        EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 1U)), hal::TransmitStatus::kRefused);
    }
    EXPECT_EQ(rig.board.Can().Controller(CanPortId::kFirst).Fault(), GetParam().why);
    EXPECT_TRUE(rig.IsSafe());
}

INSTANTIATE_TEST_SUITE_P(All, ControllerFaults,
                         ::testing::Values(ControllerFault{Fault::kDcanParityError, CanFault::kParity},
                                           ControllerFault{Fault::kDcanWrongReadBack, CanFault::kReadBack},
                                           ControllerFault{Fault::kDcanBusyForEver, CanFault::kBusy},
                                           ControllerFault{Fault::kDcanControlChanged, CanFault::kRegisters}),
                         [](const auto& row) { return NameOf(row.param.fault); });

/// Faults whose reaction is not a board's: tests of their own, by these names; DeviceOnModels is in
/// tests/integration/tms570.
constexpr Fault kOwnTests[] = {
    Fault::kDcanLostMessage,    // CanPortsTest.LostMessageIsToldBeforeItsFrame
    Fault::kDcanTwoPending,     // CanPortsTest.TwoPendingFramesAreALoss
    Fault::kDcanBusOff,         // CanPortsTest.BusOffWithdrawsRefusesAndComesBackASetNumberOfTimes
    Fault::kCounterAStops,      // DeviceOnModels.StoppedCounterIsADeviceFault
    Fault::kCounterBFast,       // DeviceOnModels.FastCounterIsADeviceFault
    Fault::kWatchdogNotEnabled, // WatchdogTest.LostWriteRefusesTheStart
    Fault::kWatchdogPeriodLost, Fault::kWatchdogReactionLost,  Fault::kWatchdogWindowLost,
    Fault::kPinStaysOutput,  // SafetyPinsTest.CutOffThatIsNotReadBackIsToldByTheErrorPin
    Fault::kVimOneBitUnseen, // VimEcc, in vim_ecc_test.cpp
    Fault::kVimTwoBitsUnseen,   Fault::kVimTwoBitsTakenForOne, Fault::kVimOneBitError,     Fault::kVimTwoBitError,
};

TEST(FaultTable, HasARowAndATestForEveryFault)
{
    Verifies(req::SRS_TMS_070);
    // Given the faults of the models, of the tests here and of the document
    std::set<std::string> tested;
    for (const StartFault& row : kStartFaults)
    {
        tested.insert(NameOf(row.fault));
    }
    for (const RunFault& row : kRunFaults)
    {
        tested.insert(NameOf(row.fault));
    }
    for (const Fault fault : kOwnTests)
    {
        tested.insert(NameOf(fault));
    }
    std::ifstream document{TMS570_FAULTS_DOCUMENT};
    std::stringstream text;
    text << document.rdbuf();
    // Then each fault is in both, and the tests know no other
    std::size_t known = 0U;
    for (const model::FaultName& row : model::kFaultNames)
    {
        ++known;
        EXPECT_EQ(tested.count(row.name), 1U) << row.name << " has no test";
        const bool has_row = text.str().find("| `" + std::string{row.name} + "` |") != std::string::npos;
        EXPECT_TRUE(has_row) << row.name << " has no row in docs/tms570_faults.md";
    }
    EXPECT_EQ(tested.size(), known);
}

} // namespace
} // namespace counterpoint::tms570
