// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The interrupt manager of an LC43x, which checks its table by ECC: its test at the start, and errors in operation.
#include "tests/hal/tms570/rig.hpp"
#include "verification/trace/ids/tms570.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::tms570
{
namespace
{

using model::Fault;

constexpr std::uint32_t kStatus = 0xFFFFFDECU;
constexpr std::uint32_t kControl = 0xFFFFFDF0U;
constexpr std::uint32_t kVector = 0xFFFFFE70U;
constexpr std::uint32_t kFastVector = 0xFFFFFE74U;
constexpr std::uint32_t kEsmHighest = 0xFFFFF598U;
constexpr std::uint32_t kSomeWord = 0xFFF82040U;

struct EccFault
{
    Fault fault;
    StartStep step;
};

using VimEccFault = ::testing::TestWithParam<EccFault>;

TEST_P(VimEccFault, RefusesTheStartOfAnLc43x)
{
    Verifies(req::SRS_TMS_041);
    Verifies(req::SRS_TMS_070);
    // Given an LC43x whose interrupt manager does not report an error, takes two wrong bits for one, or loses a write
    Rig rig{kLc43x};
    rig.machine.faults.Set(GetParam().fault);
    // When the board starts
    const StartReport report = rig.Start();
    // Then it is refused at the step that looks for it
    EXPECT_EQ(report.answer, StartAnswer::kRefused);
    EXPECT_EQ(report.last, GetParam().step);
    EXPECT_TRUE(rig.IsSafe());
}

INSTANTIATE_TEST_SUITE_P(All, VimEccFault,
                         ::testing::Values(EccFault{Fault::kVimOneBitUnseen, StartStep::kTableParity},
                                           EccFault{Fault::kVimTwoBitsUnseen, StartStep::kTableParity},
                                           EccFault{Fault::kVimTwoBitsTakenForOne, StartStep::kTableParity},
                                           EccFault{Fault::kVimTableStuck, StartStep::kInterrupts},
                                           EccFault{Fault::kVimFallbackLost, StartStep::kInterrupts},
                                           EccFault{Fault::kVimEnableLost, StartStep::kInterrupts}));

TEST(VimEcc, TestFindsBothErrorsAndLeavesTheTableAsItWas)
{
    Verifies(req::SRS_TMS_041);
    // Given a sound interrupt manager with ECC, as after a reset
    model::Machine machine{kLc43x};
    ASSERT_EQ(machine.Read(kControl), 0x050A0A05U);
    // When its table is tested
    EXPECT_EQ(Interrupts::TestTable(TableCheck::kEcc), Outcome::kDone);
    // Then ECC is on without correction, one wrong bit would be reported to the ESM, check bits cannot be written
    EXPECT_EQ(machine.Read(kControl), 0x0A050A0AU);
    machine.Write(0xFFF82400U, 1U);
    EXPECT_EQ(machine.Read(0xFFF82400U), 0U);
    // and nothing is left of the errors but the place of the last: word 85
    EXPECT_EQ(machine.Read(kStatus), 0U);
    EXPECT_EQ(machine.Read(0xFFFFFDF4U), 0xFFF82154U);
    EXPECT_EQ(machine.Read(0xFFF82554U), 0U);
    EXPECT_EQ(machine.Read(0xFFF82154U), 0xFFFFFFFCU);
    EXPECT_EQ(ReadEsm().group_1_low, 0U);
    EXPECT_EQ(machine.Read(kEsmHighest), 0U);
}

TEST(VimEcc, WholeTableIsFilledBeforeItsTest)
{
    Verifies(req::SRS_TMS_041);
    // Given a table of which a word does not fit, as after power-on; the manager reads a word for a request by itself
    model::Machine machine{kLc43x};
    machine.Write(0xFFF821F8U, 0x12345678U);
    // When the table is tested
    EXPECT_EQ(Interrupts::TestTable(TableCheck::kEcc), Outcome::kDone);
    // Then every word has been written with ECC on
    EXPECT_EQ(machine.Read(0xFFF82000U), 0xFFFFFFFCU);
    EXPECT_EQ(machine.Read(0xFFF821F8U), 0xFFFFFFFCU);
    EXPECT_EQ(machine.Read(0xFFF821FCU), 0xFFFFFFFCU);
}

TEST(VimEcc, IsNotTakenForParityNorParityForEcc)
{
    Verifies(req::SRS_TMS_002);
    Verifies(req::SRS_TMS_041);
    // Given the table of another variant, when the interrupt manager is tested, then that fails
    {
        model::Machine machine{kLc43x};
        EXPECT_EQ(Interrupts::TestTable(TableCheck::kParity), Outcome::kFailed);
    }
    {
        model::Machine machine{kLs31x};
        EXPECT_EQ(Interrupts::TestTable(TableCheck::kEcc), Outcome::kFailed);
    }
    // and so it does for no variant at all
    model::Machine machine{kLs31x};
    EXPECT_EQ(Interrupts::TestTable(TableCheck::kInvalid), Outcome::kFailed);
}

class VimEccRuns : public ::testing::Test
{
  protected:
    void SetUp() override
    {
        ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
        ASSERT_EQ(rig.Cycle(), BoardFault::kNone);
        ASSERT_EQ(rig.Cycle(), BoardFault::kNone);
        ASSERT_EQ(rig.machine.gio.PinsA(), 1U);
        ASSERT_EQ(rig.machine.Read(kVector), 0U);
    }

    /// @brief What a request would run: the vector that was set for this, and no word of the table.
    void ExpectFallback()
    {
        EXPECT_EQ(rig.machine.Read(kVector), 0xFFFFFFFCU);
        EXPECT_EQ(rig.machine.Read(kFastVector), 0xFFFFFFFCU);
    }

    Rig rig{kLc43x};
};

TEST_F(VimEccRuns, TwoWrongBitsAreASafeStateInTheInterruptAndBypassTheTable)
{
    Verifies(req::SRS_TMS_041);
    // Given an LC43x in operation, when two bits of a word of its table are wrong
    rig.machine.vim.Report(2U, kSomeWord);
    // Then the fallback vector is what it would give
    ExpectFallback();
    // and in the interrupt the output is closed, nERROR low, and the channel told
    rig.TakeInterrupts();
    EXPECT_EQ(rig.board.Fault(), BoardFault::kEsm);
    EXPECT_EQ(rig.board.Errors().First().group, 1U);
    EXPECT_EQ(rig.board.Errors().First().channel, 15U);
    EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
    EXPECT_EQ(rig.Cycle(), BoardFault::kEsm);
    EXPECT_TRUE(rig.IsSafe());
}

TEST_F(VimEccRuns, OneWrongBitIsASafeStateWithinEightCyclesAndBypassesTheTable)
{
    Verifies(req::SRS_TMS_041);
    Verifies(req::SRS_TMS_062);
    // Given an LC43x in operation, when one bit is wrong, which the ESM is told on a channel that no driver serves
    rig.machine.vim.Report(1U, kSomeWord);
    EXPECT_EQ(rig.machine.Read(kEsmHighest), 0x80000U);
    // Then it is not corrected: the fallback vector is what a request would give
    ExpectFallback();
    // and the board finds it where it looks at the interrupt manager
    EXPECT_EQ(rig.CyclesUntilFault(8), BoardFault::kInterrupts);
    EXPECT_TRUE(rig.IsSafe());
}

TEST_F(VimEccRuns, EccTurnedOffIsASafeStateWithinEightCycles)
{
    Verifies(req::SRS_TMS_041);
    Verifies(req::SRS_TMS_062);
    // Given an LC43x in operation, when its ECC is off
    rig.machine.faults.Set(Fault::kVimCheckOff);
    // Then that is found
    EXPECT_EQ(rig.CyclesUntilFault(8), BoardFault::kInterrupts);
    EXPECT_TRUE(rig.IsSafe());
}

} // namespace
} // namespace counterpoint::tms570
