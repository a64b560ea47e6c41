// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Each register of a set-up that is compared in turn, changed from outside while the board runs.
#include "tests/hal/tms570/rig.hpp"
#include "verification/trace/ids/tms570.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <string>

namespace counterpoint::tms570
{
namespace
{

/// What changes in a running controller, and what the board tells then.
struct Disturbance
{
    const char* name;
    void (*disturb)(model::Machine& machine);
    BoardFault expected;
};

class SetUpChanges : public ::testing::TestWithParam<Disturbance>
{
  protected:
    void SetUp() override
    {
        ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
        ASSERT_EQ(rig.board.StartWatchdog(), Outcome::kDone);
    }

    Rig rig;
};

/// Region 1 of the MPU: the RAM, 256 KiB, not executed, written by privileged code.
void SetRegion(model::Machine& machine, const ProcessorRegister which, const std::uint32_t value)
{
    machine.processor.Write(ProcessorRegister::kRegionNumber, 1U);
    machine.processor.Write(which, value);
}

TEST_P(SetUpChanges, AreFoundInTurnAndTheDeviceIsSafe)
{
    Verifies(req::SRS_TMS_062);
    // Given a board that found nothing wrong in three rounds
    ASSERT_EQ(rig.CyclesUntilFault(24), BoardFault::kNone);
    // When one register changes, then it is found within a round of each region, as a fault of its driver
    GetParam().disturb(rig.machine);
    EXPECT_EQ(rig.CyclesUntilFault(24), GetParam().expected);
    // and the outputs are cut off, nERROR is low, the controllers are off the bus
    EXPECT_TRUE(rig.IsSafe());
}

INSTANTIATE_TEST_SUITE_P(Watchdog, SetUpChanges,
                         ::testing::Values(Disturbance{"period", [](model::Machine& machine)
                                                       { machine.Write(0xFFFFFC94U, 12U); }, BoardFault::kWatchdog},
                                           Disturbance{"reaction", [](model::Machine& machine)
                                                       { machine.Write(0xFFFFFCA4U, 4U); }, BoardFault::kWatchdog},
                                           Disturbance{"window", [](model::Machine& machine)
                                                       { machine.Write(0xFFFFFCA8U, 5U); }, BoardFault::kWatchdog}),
                         [](const auto& row) { return std::string{row.param.name}; });

INSTANTIATE_TEST_SUITE_P(Clocks, SetUpChanges,
                         ::testing::Values(Disturbance{"counters_on", [](model::Machine& machine)
                                                       { machine.Write(0xFFFFFC00U, 7U); }, BoardFault::kCounters},
                                           Disturbance{"prescale_a", [](model::Machine& machine)
                                                       { machine.Write(0xFFFFFC18U, 78U); }, BoardFault::kCounters},
                                           Disturbance{"prescale_b", [](model::Machine& machine)
                                                       { machine.Write(0xFFFFFC38U, 78U); }, BoardFault::kCounters},
                                           Disturbance{"main_source", [](model::Machine& machine)
                                                       { machine.Write(0xFFFFFF48U, 0U); }, BoardFault::kClocks},
                                           Disturbance{"source_of_counters", [](model::Machine& machine)
                                                       { machine.Write(0xFFFFFF50U, 0x01090108U); },
                                                       BoardFault::kClocks},
                                           Disturbance{"pll_off", [](model::Machine& machine)
                                                       { machine.Write(0xFFFFFF34U, 2U); }, BoardFault::kClocks}),
                         [](const auto& row) { return std::string{row.param.name}; });

// The clear registers of pin, level and interrupt for channels 0 to 31 and 32 to 63; channel 31 and channel 63.
INSTANTIATE_TEST_SUITE_P(Esm, SetUpChanges,
                         ::testing::Values(Disturbance{"pin_low", [](model::Machine& machine)
                                                       { machine.Write(0xFFFFF504U, 0xFFFFFFFFU); }, BoardFault::kEsm},
                                           Disturbance{"pin_high", [](model::Machine& machine)
                                                       { machine.Write(0xFFFFF544U, 0xFFFFFFFFU); }, BoardFault::kEsm},
                                           Disturbance{"level_low", [](model::Machine& machine)
                                                       { machine.Write(0xFFFFF514U, 0xFFFFFFFFU); }, BoardFault::kEsm},
                                           Disturbance{"level_high", [](model::Machine& machine)
                                                       { machine.Write(0xFFFFF554U, 0xFFFFFFFFU); }, BoardFault::kEsm},
                                           Disturbance{"interrupt_low", [](model::Machine& machine)
                                                       { machine.Write(0xFFFFF50CU, 0x80000000U); }, BoardFault::kEsm},
                                           Disturbance{"interrupt_high", [](model::Machine& machine)
                                                       { machine.Write(0xFFFFF54CU, 0x80000000U); }, BoardFault::kEsm}),
                         [](const auto& row) { return std::string{row.param.name}; });

INSTANTIATE_TEST_SUITE_P(
    Rest, SetUpChanges,
    ::testing::Values(
        Disturbance{"fast_interrupts", [](model::Machine& machine) { machine.Write(0xFFFFFE18U, 0x80000000U); },
                    BoardFault::kInterrupts},
        Disturbance{"bit_timing", [](model::Machine& machine) { machine.Write(0xFFF7DC0CU, 0x1U); }, BoardFault::kCan},
        Disturbance{"region_size", [](model::Machine& machine)
                    { SetRegion(machine, ProcessorRegister::kRegionSize, 0x25U); }, BoardFault::kProtection},
        Disturbance{"region_access", [](model::Machine& machine)
                    { SetRegion(machine, ProcessorRegister::kRegionAccess, 0x308U); }, BoardFault::kProtection}),
    [](const auto& row) { return std::string{row.param.name}; });

TEST(SetUpTest, VariantWithoutAComparatorOfClocksIsLookedAtWithoutOne)
{
    Verifies(req::SRS_TMS_062);
    Verifies(req::SRS_TMS_002);
    // Given an LS20x, which has no DCC
    Rig rig{kLs20x};
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    // When it runs for three rounds, then nothing is wrong
    EXPECT_EQ(rig.CyclesUntilFault(24), BoardFault::kNone);
    // and what it has is still looked at
    rig.machine.Write(0xFFFFFC18U, 70U);
    EXPECT_EQ(rig.CyclesUntilFault(8), BoardFault::kCounters);
}

TEST(SetUpTest, StartRefusesATableWithoutClockOfTheCounters)
{
    Verifies(req::SRS_TMS_021);
    // Given a table of constants that says 0 MHz, then the counters refuse; 80 MHz is accepted
    model::Machine machine{kLs12x};
    Rti counters;
    EXPECT_EQ(counters.Start(RtiClock{0U}), Outcome::kFailed);
    EXPECT_EQ(counters.Start(RtiClock{80U}), Outcome::kDone);
    // and a plan of the watchdog that failed does not start it
    WindowedWatchdog watchdog;
    EXPECT_EQ(watchdog.Start(PlanWatchdog(hal::WatchdogWindow{900U, 900U}, RtiClock{80U}, 900U)), Outcome::kFailed);
    EXPECT_EQ(machine.Read(0xFFFFFC90U), 0U);
}

TEST(SetUpTest, CounterWhoseSetUpIsNotKeptRefusesTheStart)
{
    Verifies(req::SRS_TMS_004);
    Verifies(req::SRS_TMS_020);
    // Given a counter whose register reads otherwise than it was written, then the start is refused there
    Rig rig;
    rig.machine.faults.Set(model::Fault::kCounterSetUpChanged);
    EXPECT_EQ(rig.Start().answer, StartAnswer::kRefused);
    EXPECT_TRUE(rig.IsSafe());
}

TEST(SetUpTest, CounterOfAnotherClockRefusesTheStart)
{
    Verifies(req::SRS_TMS_021);
    // Given a counter B that runs twice as fast as A, then the start is refused
    Rig rig;
    rig.machine.faults.Set(model::Fault::kCounterBFast);
    EXPECT_EQ(rig.Start().answer, StartAnswer::kRefused);
    EXPECT_TRUE(rig.IsSafe());
}

TEST(SetUpTest, ProtectionThatWasNeverStartedIsNoSetUp)
{
    Verifies(req::SRS_TMS_062);
    // Given a processor, when nobody has set its MPU up, then a look at it fails
    model::Machine machine{kLs12x};
    Mpu protection;
    EXPECT_EQ(protection.Examine(), Outcome::kFailed);
}

TEST(SetUpTest, FastInterruptThatNothingAskedForIsAFault)
{
    Verifies(req::SRS_TMS_042);
    // Given a board without an error, when the fast interrupt comes all the same
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    rig.board.OnFastInterrupt();
    // Then that is recorded as a fault of the interrupts, and the device is safe
    EXPECT_EQ(rig.board.BeginCycle(), BoardFault::kInterrupts);
    EXPECT_TRUE(rig.IsSafe());
}

TEST(SetUpTest, OpenTellsWhatTheGateHoldsOpen)
{
    Verifies(req::SRS_TMS_024);
    // Given a board, when slot 0 is opened in a cycle, then that is told, and nothing before it
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    EXPECT_EQ(rig.board.Output().Open(), 0U);
    ASSERT_EQ(rig.Cycle(), BoardFault::kNone);
    EXPECT_EQ(rig.board.Output().Open(), 1U);
    EXPECT_EQ(rig.machine.gio.PinsA(), 1U);
}

TEST(SetUpTest, CutOffInAnInterruptOfDriveLeavesNoPinHigh)
{
    Verifies(req::SRS_TMS_024);
    // Given a board with closed outputs, and an interrupt that cuts off right after the pin was driven high
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    int cut_offs = 0;
    rig.machine.SetSurroundings(
        [&rig, &cut_offs]
        {
            if (rig.machine.gio.PinsA() != 0U)
            {
                ++cut_offs;
                rig.board.Output().CutOff();
            }
        });
    // When right permits open it
    rig.board.Output().Drive(Rig::RightPermits(rig.board.Output().Challenge(), 1U));
    rig.machine.SetSurroundings({});
    // Then it is low again, nothing is open, and it stays so
    EXPECT_EQ(cut_offs, 1);
    EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
    EXPECT_EQ(rig.board.Output().Open(), 0U);
    EXPECT_EQ(rig.board.BeginCycle(), BoardFault::kPins);
}

TEST(SetUpTest, ProbedPermitsOpenNothing)
{
    Verifies(req::SRS_TMS_024);
    // Given a board whose outputs are closed, when the gate is asked about permits, then it answers as Drive would
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    EXPECT_EQ(rig.board.Output().Probe(Rig::RightPermits(7U, 1U), 7U), hal::ProbeAnswer::kAccepted);
    EXPECT_EQ(rig.board.Output().Probe(Rig::RightPermits(7U, 1U), 8U), hal::ProbeAnswer::kRefused);
    // and no pin goes high by that
    EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
    EXPECT_EQ(rig.board.Output().Open(), 0U);
}

TEST(SetUpTest, WindowsThatTheWatchdogCannotHaveAreRefused)
{
    Verifies(req::SRS_TMS_022);
    // Given a clock of 80 MHz, and of 8 MHz: 4096 steps of 8192 cycles are 4.19 s there, more than 300 ms may be
    // When it would open when it ends, or later than the cycle allows, then it is refused; just inside it is planned
    EXPECT_EQ(PlanWatchdog(hal::WatchdogWindow{1500U, 1500U}, RtiClock{80U}, 1500U).outcome, Outcome::kFailed);
    EXPECT_EQ(PlanWatchdog(hal::WatchdogWindow{500U, 1500U}, RtiClock{80U}, 499U).outcome, Outcome::kFailed);
    EXPECT_EQ(PlanWatchdog(hal::WatchdogWindow{500U, 1500U}, RtiClock{80U}, 716U).outcome, Outcome::kDone);
    // and a period beyond 4096 steps: 120 MHz for 280 ms are 4101, for 279 ms 4086
    EXPECT_EQ(PlanWatchdog(hal::WatchdogWindow{0U, 280000U}, RtiClock{120U}, 200000U).outcome, Outcome::kFailed);
    EXPECT_EQ(PlanWatchdog(hal::WatchdogWindow{0U, 279000U}, RtiClock{120U}, 200000U).outcome, Outcome::kDone);
}

} // namespace
} // namespace counterpoint::tms570
