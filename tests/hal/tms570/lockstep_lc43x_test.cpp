// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The comparators that an LC43x has beside that of its processors: VIMs, bus of the idle processor, power domains.
#include "hal/tms570/diagnosis/lockstep.hpp"
#include "tests/hal/tms570/rig.hpp"
#include "verification/trace/ids/tms570.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::tms570
{
namespace
{

using model::Fault;

struct Comparator
{
    const char* name;
    std::uint32_t number;
    std::uint8_t channel; ///< Of ESM group 2.
};

using EveryComparator = ::testing::TestWithParam<Comparator>;

TEST_P(EveryComparator, WithAFaultRefusesTheStart)
{
    Verifies(req::SRS_TMS_040);
    Verifies(req::SRS_TMS_070);
    // Given an LC43x with one comparator that fails, never ends, or does not tell what is forced
    for (const Fault fault : {Fault::kCcmSelfTestFails, Fault::kCcmSelfTestEndless, Fault::kCcmForcedErrorUnseen,
                              Fault::kCcmSelfTestErrorUnseen})
    {
        Rig rig{kLc43x};
        rig.machine.ccm.faulty = GetParam().number;
        rig.machine.faults.Set(fault);
        // When the board starts, then it is refused at the test of lockstep
        const StartReport report = rig.Start();
        EXPECT_EQ(report.answer, StartAnswer::kRefused);
        EXPECT_EQ(report.last, StartStep::kLockstep);
        EXPECT_TRUE(rig.IsSafe());
    }
}

TEST_P(EveryComparator, ThatFindsADifferenceIsASafeStateInTheInterrupt)
{
    Verifies(req::SRS_TMS_040);
    // Given an LC43x in operation
    Rig rig{kLc43x};
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    ASSERT_EQ(rig.Cycle(), BoardFault::kNone);
    // When what one comparator compares differs
    rig.machine.ccm.Differ(GetParam().number);
    rig.TakeInterrupts();
    // Then the output is closed and the channel told
    EXPECT_EQ(rig.board.Fault(), BoardFault::kEsm);
    EXPECT_EQ(rig.board.Errors().First().group, 2U);
    EXPECT_EQ(rig.board.Errors().First().channel, GetParam().channel);
    EXPECT_EQ(rig.Cycle(), BoardFault::kEsm);
    EXPECT_TRUE(rig.IsSafe());
}

TEST_P(EveryComparator, ThatIsInAnotherModeIsFoundWithinEightCycles)
{
    Verifies(req::SRS_TMS_040);
    Verifies(req::SRS_TMS_062);
    // Given an LC43x in operation, when one comparator no longer compares
    Rig rig{kLc43x};
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    rig.machine.ccm.faulty = GetParam().number;
    rig.machine.faults.Set(Fault::kCcmNotLockstep);
    // Then that is found
    EXPECT_EQ(rig.CyclesUntilFault(8), BoardFault::kLockstep);
    EXPECT_TRUE(rig.IsSafe());
}

INSTANTIATE_TEST_SUITE_P(Lc43x, EveryComparator,
                         ::testing::Values(Comparator{"processors", 0U, 2U}, Comparator{"vims", 1U, 25U},
                                           Comparator{"idle_bus", 2U, 26U}, Comparator{"power_domains", 3U, 28U}),
                         [](const auto& row) { return std::string{row.param.name}; });

TEST(Lockstep, NoComparatorOrTooManyFailTheTest)
{
    Verifies(req::SRS_TMS_040);
    // Given a sound controller, when a table of constants says no comparator, or five, then neither test nor look
    // passes
    model::Machine machine{kLc43x};
    EXPECT_EQ(Lockstep::Test(0U), Outcome::kFailed);
    EXPECT_EQ(Lockstep::Test(5U), Outcome::kFailed);
    EXPECT_EQ(Lockstep::Examine(0U), Outcome::kFailed);
    EXPECT_EQ(Lockstep::Examine(5U), Outcome::kFailed);
    // and with the right number both do, and no flag is left
    EXPECT_EQ(Lockstep::Test(4U), Outcome::kDone);
    EXPECT_EQ(Lockstep::Examine(4U), Outcome::kDone);
    EXPECT_EQ(ReadEsm().group_1_low, 0U);
    EXPECT_EQ(ReadEsm().group_2, 0U);
}

} // namespace
} // namespace counterpoint::tms570
