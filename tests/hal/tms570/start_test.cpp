// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/hal/tms570/rig.hpp"
#include "verification/trace/ids/tms570.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::tms570
{
namespace
{

struct VariantCase
{
    const char* name;
    const Variant* variant;
    std::uint8_t absent_steps;
};

using EveryVariant = ::testing::TestWithParam<VariantCase>;

TEST_P(EveryVariant, StartsInOrderWithAReportOfEveryStep)
{
    Verifies(req::SRS_TMS_002);
    Verifies(req::SRS_TMS_060);
    // Given a controller of this variant without a fault
    Rig rig{*GetParam().variant};
    // When the board starts, tested by its own logic test twice on the way
    const StartReport report = rig.Start();
    // Then every step has passed, or the variant has no such thing
    EXPECT_EQ(report.answer, StartAnswer::kStarted);
    std::uint8_t absent = 0U;
    for (const StepResult step : report.steps)
    {
        EXPECT_TRUE((step == StepResult::kPassed) || (step == StepResult::kAbsent));
        absent = static_cast<std::uint8_t>(absent + ((step == StepResult::kAbsent) ? 1U : 0U));
    }
    EXPECT_EQ(absent, GetParam().absent_steps);
    EXPECT_EQ(report.last, StartStep::kCan);
    // and nothing was accessed that is not there, and no abort was a real one
    EXPECT_TRUE(rig.machine.Strays().empty());
    EXPECT_EQ(rig.machine.real_aborts, 0U);
    EXPECT_EQ(rig.board.Fault(), BoardFault::kNone);
    EXPECT_TRUE(rig.machine.esm.IsPinHigh());
}

INSTANTIATE_TEST_SUITE_P(Family, EveryVariant,
                         ::testing::Values(VariantCase{"ls20x", &kLs20x, 1U}, VariantCase{"ls12x", &kLs12x, 0U},
                                           VariantCase{"ls31x", &kLs31x, 0U}, VariantCase{"lc43x", &kLc43x, 1U}),
                         [](const auto& row) { return std::string{row.param.name}; });

TEST(Start, LogicTestResetsTheProcessorTwice)
{
    Verifies(req::SRS_TMS_047);
    // Given a controller after power-on
    Rig rig;
    // When the board starts, then it is reset for the self-check that must fail
    EXPECT_EQ(rig.board.Start(rig.setup).answer, StartAnswer::kResetComes);
    EXPECT_TRUE(rig.machine.TakeProcessorReset());
    EXPECT_TRUE(rig.IsSafe());
    // and then for the test
    EXPECT_EQ(rig.board.Start(rig.setup).answer, StartAnswer::kResetComes);
    EXPECT_TRUE(rig.machine.TakeProcessorReset());
    // and then it starts
    EXPECT_EQ(rig.board.Start(rig.setup).answer, StartAnswer::kStarted);
    EXPECT_FALSE(rig.machine.TakeProcessorReset());
}

TEST(Start, ErrorPinIsLowWhileTheProcessorSleepsForItsTest)
{
    Verifies(req::SRS_TMS_047);
    // Given a controller after power-on, with nERROR high
    model::Machine machine{kLs12x};
    EXPECT_TRUE(machine.esm.IsPinHigh());
    // When the logic test begins, whether its reset ever comes or not, then nERROR is low
    EXPECT_EQ(ContinueLogicTest(ResetReason{0x8000U}), LogicTest::kResetComes);
    EXPECT_FALSE(machine.esm.IsPinHigh());
}

TEST(Start, ReportHoldsTheReasonOfTheResetBeforeTheLogicTest)
{
    Verifies(req::SRS_TMS_051);
    // Given a controller that the watchdog has reset
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    rig.machine.system.SetReset(0x2000U);
    // When it starts again
    const StartReport report = rig.Start();
    // Then the report says so, through both resets of the logic test, and power-on is not told again
    EXPECT_EQ(report.answer, StartAnswer::kStarted);
    EXPECT_EQ(report.reason.bits & 0x2000U, 0x2000U);
    EXPECT_EQ(report.reason.bits & 0x8000U, 0U);
    // and the flags are cleared
    EXPECT_EQ(ReadResetReason().bits, 0U);
}

TEST(Start, RefusedBoardGivesNothing)
{
    Verifies(req::SRS_TMS_060);
    Verifies(req::SRS_TMS_061);
    // Given a controller whose RAM does not report errors
    Rig rig;
    rig.machine.faults.Set(model::Fault::kRamTwoBitsUnseen);
    // When the start is refused
    const StartReport report = rig.Start();
    ASSERT_EQ(report.answer, StartAnswer::kRefused);
    EXPECT_EQ(report.last, StartStep::kRamEcc);
    EXPECT_EQ(report.steps[static_cast<std::uint8_t>(StartStep::kFlashEcc)], StepResult::kInvalid);
    // Then right permits open nothing, no frame is taken, nothing is guaranteed, nERROR is low
    rig.Arm();
    rig.board.Output().Drive(Rig::RightPermits(rig.board.Output().Challenge(), 1U));
    EXPECT_TRUE(rig.IsSafe());
    EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 1U)), hal::TransmitStatus::kRefused);
    EXPECT_EQ(rig.board.Can().Guarantees().stamps, hal::Guarantee::kAbsent);
    EXPECT_EQ(rig.board.StartWatchdog(), Outcome::kFailed);
    EXPECT_EQ(rig.board.BeginCycle(), BoardFault::kStart);
}

using Level2RamFault = ::testing::TestWithParam<model::Fault>;

TEST_P(Level2RamFault, RefusesTheStartOfAnLc43x)
{
    Verifies(req::SRS_TMS_044);
    // Given a controller with level 2 RAM whose correction does not see one bit, or two, or sees what is not there
    Rig rig{kLc43x};
    rig.machine.faults.Set(GetParam());
    // When the board starts
    const StartReport report = rig.Start();
    // Then it is refused at the test of the RAM's ECC
    EXPECT_EQ(report.answer, StartAnswer::kRefused);
    EXPECT_EQ(report.last, StartStep::kRamEcc);
    EXPECT_TRUE(rig.IsSafe());
}

INSTANTIATE_TEST_SUITE_P(All, Level2RamFault,
                         ::testing::Values(model::Fault::kRamOneBitUnseen, model::Fault::kRamOneBitWrong,
                                           model::Fault::kRamTwoBitsUnseen));

TEST(Lc43x, RegistersOfClocksAndPowerAreItsOwn)
{
    Verifies(req::SRS_TMS_002);
    Verifies(req::SRS_TMS_050);
    // Given an LC43x, whose registers keep fewer bits than those of a Cortex-R4F's controllers and one bit of which is
    // always set
    model::Machine machine{kLc43x};
    // When the clocks are started with its constants, then flash, sources and RTI read as they were written
    EXPECT_EQ(StartClocks(kLc43x.clocks, kLc43x.system), Outcome::kDone);
    EXPECT_EQ(machine.Read(0xFFF87000U), 0x303U);
    EXPECT_EQ(machine.Read(0xFFFFFF30U), 0xCCU);
    EXPECT_EQ(machine.Read(0xFFFFFF50U), 0x109U);
    // and all peripherals have power, by three controllers
    EXPECT_EQ(machine.Read(0xFFFF10A0U), 0xFFFFFFFFU);
    EXPECT_EQ(machine.Read(0xFCFF10ACU), 0xFFFFFFFFU);
    EXPECT_EQ(machine.Read(0xFFF780A0U), 0xFFFFFFFFU);
    EXPECT_TRUE(machine.Strays().empty());
    // With those of an LS31x the start would end here
    EXPECT_EQ(StartClocks(kLc43x.clocks, kLs31x.system), Outcome::kFailed);
}

TEST(Level2Ram, IsQuietAfterItsTest)
{
    Verifies(req::SRS_TMS_044);
    // Given a controller with level 2 RAM
    Rig rig{kLc43x};
    // When it has started
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    // Then the test mode is off, no error is left, and nERROR is high
    EXPECT_EQ(Read(At(level_2_ram::kBase, level_2_ram::kTest)), level_2_ram::kTestOff);
    EXPECT_EQ(Read(At(level_2_ram::kBase, level_2_ram::kErrorStatus)), 0U);
    EXPECT_EQ(ReadEsm().group_2, 0U);
    EXPECT_TRUE(rig.machine.esm.IsPinHigh());
}

} // namespace
} // namespace counterpoint::tms570
