// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/clock_supervisor.hpp"

#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <cstdint>

namespace counterpoint
{
namespace
{

constexpr InstantPair At(const std::uint32_t a_us, const std::uint32_t b_us)
{
    return InstantPair{{a_us}, {b_us}};
}

// Cycle 1000 us, tolerance 500 us; the counters may differ by 200 us within 10 000 us, that is six late cycles: by 83
// us (200 less a sixth, rounded up, of which the half) within a window of 4250 us.
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
    EXPECT_EQ(clocks_.OnCycle(At(1501U, 1430U)), DeviceFault::kLateCall);
    EXPECT_EQ(clocks_.OnCycle(At(2901U, 2931U)), DeviceFault::kLateCall);
}

TEST_F(ClockSupervision, LateCallAcrossTheWrapOfTheCounters)
{
    Verifies(req::SRS_CLK_002);
    Verifies(req::SRS_TIME_001);
    (void)clocks_.OnCycle(At(0xFFFFFF00U, 0xFFFFFFF0U));
    EXPECT_EQ(clocks_.OnCycle(At(0x000002E8U, 0x000003D8U)), DeviceFault::kNone);
    EXPECT_EQ(clocks_.OnCycle(At(0x00000900U, 0x000009F0U)), DeviceFault::kLateCall);
}

// A    0   1000  2000     progress of A 2083, of B 2000: the limit itself; 2084: too much
TEST_F(ClockSupervision, DifferenceAtTheToleranceIsAcceptedAndOneMicrosecondMoreIsNot)
{
    Verifies(req::SRS_CLK_001);
    (void)clocks_.OnCycle(At(0U, 0U));
    EXPECT_EQ(clocks_.OnCycle(At(1000U, 1000U)), DeviceFault::kNone);
    EXPECT_EQ(clocks_.OnCycle(At(2083U, 2000U)), DeviceFault::kNone);
    EXPECT_EQ(clocks_.OnCycle(At(3083U, 2999U)), DeviceFault::kClock);
}

// Interval, its late cycles of 1501 us, tolerance less its share of one of them, rounded up; the half of it.
//   10000   6   200 - 34   83        9006   6   200 - 34   83        9000   5   200 - 40   80
//   10000   6   204 - 34   85       10000   6   199 - 34   82
TEST_F(ClockSupervision, ShareOfTheToleranceIsThatOfAWindowWithoutTheLateCycle)
{
    Verifies(req::SRS_CLK_211);
    struct Share
    {
        std::uint32_t interval_us;
        std::uint32_t tolerance_us;
        std::uint32_t share_us;
    };
    for (const Share& share : {Share{10000U, 200U, 83U}, Share{9006U, 200U, 83U}, Share{9000U, 200U, 80U},
                               Share{10000U, 204U, 85U}, Share{10000U, 199U, 82U}})
    {
        config_.clock_interval_us = share.interval_us;
        config_.clock_tolerance_us = share.tolerance_us;
        clocks_.Restart(config_);
        EXPECT_EQ(clocks_.OnCycle(At(0U, 0U)), DeviceFault::kNone);
        EXPECT_EQ(clocks_.OnCycle(At(1000U + share.share_us, 1000U)), DeviceFault::kNone) << share.share_us;
        EXPECT_EQ(clocks_.OnCycle(At(2001U + share.share_us, 2000U)), DeviceFault::kClock) << share.share_us;
    }
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

TEST_F(ClockSupervision, SmallDriftStartsAnewWithEachWindow)
{
    Verifies(req::SRS_CLK_001);
    Verifies(req::SRS_CLK_210);
    // Given 1 % drift, 100 us in 10 000 us, for twenty windows
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
        ASSERT_EQ(clocks_.OnCycle(At(cycle * 1000U, cycle * 1010U)), DeviceFault::kNone) << "cycle " << cycle;
    }
}

// t [us]    0    1000    4250 by one counter alone     5250      6250
// apart     0    0       80                            160, of it 80 since the new reference; 164
TEST_F(ClockSupervision, WindowEndsExactlyByEitherCounter)
{
    Verifies(req::SRS_CLK_210);
    config_.cycle_us = 1000U;
    for (const bool is_a_first : {true, false})
    {
        clocks_.Restart(config_);
        const auto at = [this, is_a_first](const std::uint32_t first_us, const std::uint32_t second_us)
        { return clocks_.OnCycle(is_a_first ? At(first_us, second_us) : At(second_us, first_us)); };
        EXPECT_EQ(at(0U, 0U), DeviceFault::kNone);
        EXPECT_EQ(at(1400U, 1400U), DeviceFault::kNone);
        EXPECT_EQ(at(2800U, 2800U), DeviceFault::kNone);
        EXPECT_EQ(at(4250U, 4170U), DeviceFault::kNone);
        EXPECT_EQ(at(5250U, 5090U), DeviceFault::kNone);
        EXPECT_EQ(at(6250U, 6086U), DeviceFault::kClock);
        // And one microsecond less is not its end
        clocks_.Restart(config_);
        EXPECT_EQ(at(0U, 0U), DeviceFault::kNone);
        EXPECT_EQ(at(1400U, 1400U), DeviceFault::kNone);
        EXPECT_EQ(at(2800U, 2800U), DeviceFault::kNone);
        EXPECT_EQ(at(4249U, 4169U), DeviceFault::kNone);
        EXPECT_EQ(at(5249U, 5165U), DeviceFault::kClock);
    }
}

// Both counters by so many parts of ten thousand, each place of an interval, cycles of 1000 and of 1500 us. The least
// is hardly more than 200 us in 10 000.
TEST_F(ClockSupervision, DriftAboveTheToleranceIsFoundWithinTheIntervalAndALateCycleWheneverItBegins)
{
    Verifies(req::SRS_CLK_001);
    Verifies(req::SRS_CLK_212);
    Verifies(req::SRS_LIM_002);
    std::uint32_t longest_us = 0U;
    for (const std::uint32_t parts : {201U, 205U, 250U, 400U, 2000U})
    {
        for (std::uint32_t phase_us = 0U; phase_us < 10000U; phase_us += 37U)
        {
            for (const std::uint32_t cycle_us : {1000U, 1250U, 1500U})
            {
                for (const bool is_a : {true, false})
                {
                    clocks_.Restart(config_);
                    const std::uint32_t begin_us = 20000U + phase_us;
                    std::uint32_t now_us = 0U;
                    DeviceFault fault = DeviceFault::kNone;
                    while ((fault == DeviceFault::kNone) && (now_us < 60000U))
                    {
                        const std::uint32_t since_us = (now_us > begin_us) ? (now_us - begin_us) : 0U;
                        // The other one stays right, so that no call is late by it.
                        const std::uint32_t slow_us = now_us - ((since_us * parts) / 10000U);
                        fault = clocks_.OnCycle(is_a ? At(slow_us, now_us) : At(now_us, slow_us));
                        now_us += (fault == DeviceFault::kNone) ? cycle_us : 0U;
                    }
                    ASSERT_EQ(fault, DeviceFault::kClock) << parts << " at " << begin_us;
                    EXPECT_LE(now_us - begin_us, 11500U) << parts << " at " << begin_us;
                    longest_us = std::max(longest_us, now_us - begin_us);
                }
            }
        }
    }
    EXPECT_GT(longest_us, 8000U);
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

// The cycles are at 1000 and 5000, and at 2000 and 6000; each counter alone is one microsecond out of order.
TEST_F(ClockSupervision, EitherCounterAloneOutOfOrderIsAFault)
{
    Verifies(req::SRS_KRN_008);
    const auto after = [this](const InstantPair& first, const InstantPair& second)
    {
        clocks_.Restart(config_);
        (void)clocks_.OnCycle(At(1000U, 5000U));
        clocks_.OnFrame(first);
        clocks_.OnFrame(second);
        return clocks_.OnCycle(At(2000U, 6000U));
    };
    EXPECT_EQ(after(At(1000U, 5000U), At(2000U, 6000U)), DeviceFault::kNone);
    EXPECT_EQ(after(At(1500U, 5500U), At(1499U, 5500U)), DeviceFault::kFrameOrder);
    EXPECT_EQ(after(At(1500U, 5500U), At(1500U, 5499U)), DeviceFault::kFrameOrder);
    EXPECT_EQ(after(At(999U, 5000U), At(1500U, 5500U)), DeviceFault::kFrameOrder);
    EXPECT_EQ(after(At(1000U, 4999U), At(1500U, 5500U)), DeviceFault::kFrameOrder);
    EXPECT_EQ(after(At(1500U, 5500U), At(2001U, 6000U)), DeviceFault::kFrameOrder);
    EXPECT_EQ(after(At(1500U, 5500U), At(2000U, 6001U)), DeviceFault::kFrameOrder);
}

} // namespace
} // namespace counterpoint
