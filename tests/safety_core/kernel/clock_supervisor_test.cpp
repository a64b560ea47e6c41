// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/clock_supervisor.hpp"

#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

#include <cstdint>

namespace counterpoint
{
namespace
{

constexpr InstantPair At(const std::uint32_t a_us, const std::uint32_t b_us)
{
    return InstantPair{{a_us}, {b_us}};
}

// Cycle 1000 us, tolerance 500 us; the counters may differ by 200 us within 10 000 us.
class ClockSupervision : public ::testing::Test
{
  protected:
    ClockSupervision()
    {
        config_.cycle_us = 1000U;
        config_.cycle_tolerance_us = 500U;
        config_.clock_tolerance_us = 200U;
        config_.clock_interval_us = 10000U;
        clocks_.Restart(config_);
    }

    DeviceConfig config_{};
    ClockSupervisor clocks_{};
};

TEST_F(ClockSupervision, FirstCycleOnlySetsTheReferences)
{
    Verifies(req::SRS_CLK_001);
    EXPECT_EQ(clocks_.OnCycle(At(123456U, 99U)), DeviceFault::kNone);
    EXPECT_EQ(clocks_.OnCycle(At(124456U, 1099U)), DeviceFault::kNone);
}

// t [us]   0      1000    1500 (limit)   1501
TEST_F(ClockSupervision, CallAtTheToleranceIsInTimeAndOneMicrosecondMoreIsLate)
{
    Verifies(req::SRS_CLK_002);
    Verifies(req::SRS_TIME_004);
    (void)clocks_.OnCycle(At(0U, 0U));
    EXPECT_EQ(clocks_.OnCycle(At(1500U, 1500U)), DeviceFault::kNone);
    EXPECT_EQ(clocks_.OnCycle(At(3001U, 3001U)), DeviceFault::kLateCall);
}

TEST_F(ClockSupervision, LateByEitherCounterAloneIsLate)
{
    Verifies(req::SRS_CLK_002);
    (void)clocks_.OnCycle(At(0U, 0U));
    EXPECT_EQ(clocks_.OnCycle(At(1501U, 1400U)), DeviceFault::kLateCall);
    EXPECT_EQ(clocks_.OnCycle(At(2901U, 2901U)), DeviceFault::kLateCall);
}

TEST_F(ClockSupervision, LateCallAcrossTheWrapOfTheCounters)
{
    Verifies(req::SRS_CLK_002);
    Verifies(req::SRS_TIME_001);
    (void)clocks_.OnCycle(At(0xFFFFFF00U, 0xFFFFFFF0U));
    EXPECT_EQ(clocks_.OnCycle(At(0x000002E8U, 0x000003D8U)), DeviceFault::kNone);
    EXPECT_EQ(clocks_.OnCycle(At(0x00000900U, 0x000009F0U)), DeviceFault::kLateCall);
}

// A    0   1000  2000     progress of A 2200, of B 2000: the limit itself; 2201: too much
TEST_F(ClockSupervision, DifferenceAtTheToleranceIsAcceptedAndOneMicrosecondMoreIsNot)
{
    Verifies(req::SRS_CLK_001);
    (void)clocks_.OnCycle(At(0U, 0U));
    EXPECT_EQ(clocks_.OnCycle(At(1000U, 1000U)), DeviceFault::kNone);
    EXPECT_EQ(clocks_.OnCycle(At(2200U, 2000U)), DeviceFault::kNone);
    EXPECT_EQ(clocks_.OnCycle(At(3200U, 2999U)), DeviceFault::kClock);
}

TEST_F(ClockSupervision, StoppedCounterIsFoundOnEitherSide)
{
    Verifies(req::SRS_CLK_001);
    (void)clocks_.OnCycle(At(0U, 0U));
    EXPECT_EQ(clocks_.OnCycle(At(1000U, 0U)), DeviceFault::kClock);
    clocks_.Restart(config_);
    (void)clocks_.OnCycle(At(0U, 0U));
    EXPECT_EQ(clocks_.OnCycle(At(0U, 1000U)), DeviceFault::kClock);
}

TEST_F(ClockSupervision, SmallDriftStartsAnewWithEachInterval)
{
    Verifies(req::SRS_CLK_001);
    // Given 1 % drift, 100 us in 10 000 us, for ten intervals
    DeviceFault fault = clocks_.OnCycle(At(0U, 0U));
    for (std::uint32_t cycle = 1U; cycle <= 100U; ++cycle)
    {
        fault = clocks_.OnCycle(At(cycle * 1010U, cycle * 1000U));
        // Then it is never a fault
        ASSERT_EQ(fault, DeviceFault::kNone) << "cycle " << cycle;
    }
    // And the same when counter B is the faster one
    clocks_.Restart(config_);
    for (std::uint32_t cycle = 0U; cycle <= 100U; ++cycle)
    {
        ASSERT_EQ(clocks_.OnCycle(At(cycle * 990U, cycle * 1010U)), DeviceFault::kNone) << "cycle " << cycle;
    }
}

// t [us]    0          1000       at the interval, by one counter alone     1000 later
// apart     0          0          150                                       300, of it 150 since the new reference
TEST_F(ClockSupervision, ReferenceMovesOnExactlyWithTheIntervalOfEitherCounter)
{
    Verifies(req::SRS_CLK_001);
    config_.cycle_us = 10000U;
    for (const bool is_a_first : {true, false})
    {
        clocks_.Restart(config_);
        const auto at = [this, is_a_first](const std::uint32_t first_us, const std::uint32_t second_us)
        { return clocks_.OnCycle(is_a_first ? At(first_us, second_us) : At(second_us, first_us)); };
        EXPECT_EQ(at(0U, 0U), DeviceFault::kNone);
        EXPECT_EQ(at(1000U, 1000U), DeviceFault::kNone);
        EXPECT_EQ(at(10000U, 9850U), DeviceFault::kNone);
        EXPECT_EQ(at(11000U, 10700U), DeviceFault::kNone);
        EXPECT_EQ(at(12000U, 11649U), DeviceFault::kClock);
    }
}

TEST_F(ClockSupervision, StampsBetweenTwoCyclesAreInOrder)
{
    Verifies(req::SRS_KRN_008);
    (void)clocks_.OnCycle(At(1000U, 5000U));
    clocks_.OnFrame(At(1000U, 5000U));
    clocks_.OnFrame(At(1500U, 5500U));
    clocks_.OnFrame(At(1500U, 5500U));
    EXPECT_EQ(clocks_.OnCycle(At(2000U, 6000U)), DeviceFault::kNone);
}

TEST_F(ClockSupervision, StampBeforeThePreviousOneIsAFault)
{
    Verifies(req::SRS_KRN_008);
    (void)clocks_.OnCycle(At(1000U, 5000U));
    clocks_.OnFrame(At(1500U, 5500U));
    clocks_.OnFrame(At(1499U, 5600U));
    EXPECT_EQ(clocks_.OnCycle(At(2000U, 6000U)), DeviceFault::kFrameOrder);
    // and it is told once
    EXPECT_EQ(clocks_.OnCycle(At(3000U, 7000U)), DeviceFault::kNone);
}

TEST_F(ClockSupervision, TwoStepsBackwardsAreAFaultLikeOne)
{
    Verifies(req::SRS_KRN_008);
    (void)clocks_.OnCycle(At(1000U, 5000U));
    clocks_.OnFrame(At(999U, 4999U));
    clocks_.OnFrame(At(998U, 4998U));
    EXPECT_EQ(clocks_.OnCycle(At(2000U, 6000U)), DeviceFault::kFrameOrder);
}

TEST_F(ClockSupervision, StampBeforeThePreviousCycleOrAfterThisOneIsAFault)
{
    Verifies(req::SRS_KRN_008);
    (void)clocks_.OnCycle(At(1000U, 5000U));
    clocks_.OnFrame(At(1200U, 4999U));
    EXPECT_EQ(clocks_.OnCycle(At(2000U, 6000U)), DeviceFault::kFrameOrder);
    clocks_.OnFrame(At(3001U, 6900U));
    EXPECT_EQ(clocks_.OnCycle(At(3000U, 7000U)), DeviceFault::kFrameOrder);
}

TEST_F(ClockSupervision, FramesBeforeTheFirstCycleAreNotJudged)
{
    Verifies(req::SRS_KRN_008);
    clocks_.OnFrame(At(900U, 4900U));
    clocks_.OnFrame(At(800U, 4800U));
    EXPECT_EQ(clocks_.OnCycle(At(1000U, 5000U)), DeviceFault::kNone);
}

} // namespace
} // namespace counterpoint
