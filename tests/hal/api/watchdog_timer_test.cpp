// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/api/watchdog_timer.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

namespace counterpoint::hal
{
namespace
{

constexpr WatchdogWindow kWindow{800U, 1200U};

/// The formula of hal/api/watchdog.hpp, written down once more.
constexpr WatchdogAnswer Right(const WatchdogQuestion& question)
{
    return WatchdogAnswer{(0x5EC0'DE27U + question.value) * 0x0100'0193U};
}
static_assert(Right(WatchdogQuestion{5U}).value == 0x559D'BF44U, "(5EC0 DE27h + 5) * 0100 0193h");

WatchdogTimer StartedAt(const std::uint32_t us)
{
    WatchdogTimer timer;
    timer.Start(kWindow, Instant{us});
    return timer;
}

struct WindowCase
{
    std::uint32_t answered_us;
    bool alive;
};

using WatchdogWindowBoundary = ::testing::TestWithParam<WindowCase>;

// t [us]  10000      10800          11200
// window  Start      opens           ends
TEST_P(WatchdogWindowBoundary, RightAnswerCountsOnlyInsideTheWindow)
{
    Verifies(req::SRS_HAL_005);
    // Given supervision since 10000
    WatchdogTimer timer = StartedAt(10'000U);
    // When the right answer comes then
    timer.Answer(Right(timer.Question()), Instant{GetParam().answered_us});
    // Then the watchdog lives only if that was in the window
    EXPECT_EQ(timer.IsAlive(), GetParam().alive);
}

INSTANTIATE_TEST_SUITE_P(InsideOnOutside, WatchdogWindowBoundary,
                         ::testing::Values(WindowCase{10'000U, false}, WindowCase{10'799U, false},
                                           WindowCase{10'800U, true}, WindowCase{10'801U, true},
                                           WindowCase{11'199U, true}, WindowCase{11'200U, true},
                                           WindowCase{11'201U, false}, WindowCase{9'999U, false}));

TEST(WatchdogTimer, WrongAnswerInTheWindowTrips)
{
    Verifies(req::SRS_HAL_005);
    // Given supervision since 0
    WatchdogTimer timer = StartedAt(0U);
    // When an answer with one wrong bit comes in the window
    WatchdogAnswer answer = Right(timer.Question());
    answer.value ^= 1U;
    timer.Answer(answer, Instant{1000U});
    // Then it has tripped
    EXPECT_FALSE(timer.IsAlive());
}

TEST(WatchdogTimer, TrippedStaysTrippedUntilStart)
{
    Verifies(req::SRS_HAL_005);
    // Given a watchdog tripped by an early answer
    WatchdogTimer timer = StartedAt(0U);
    timer.Answer(Right(timer.Question()), Instant{799U});
    ASSERT_FALSE(timer.IsAlive());
    // When the right answer comes in the window, then it stays tripped
    timer.Answer(Right(timer.Question()), Instant{1000U});
    EXPECT_FALSE(timer.IsAlive());
    timer.Answer(Right(timer.Question()), Instant{2000U});
    EXPECT_FALSE(timer.IsAlive());
    // and when it is started again, it lives
    timer.Start(kWindow, Instant{2500U});
    EXPECT_TRUE(timer.IsAlive());
}

TEST(WatchdogTimer, SilenceTripsAfterTheEndOfTheWindow)
{
    Verifies(req::SRS_HAL_005);
    // Given supervision since 500
    WatchdogTimer timer = StartedAt(500U);
    // When it is examined on the end of the window, then it lives
    timer.Examine(Instant{1700U});
    EXPECT_TRUE(timer.IsAlive());
    // and one microsecond later it has tripped
    timer.Examine(Instant{1701U});
    EXPECT_FALSE(timer.IsAlive());
}

TEST(WatchdogTimer, NextWindowBeginsWithTheAnswerAcrossTheWrap)
{
    Verifies(req::SRS_HAL_005);
    // Given an answer 96 us before the counter wraps
    WatchdogTimer timer = StartedAt(0xFFFF'FBB8U); // 1096 us before the wrap
    timer.Answer(Right(timer.Question()), Instant{0xFFFF'FFA0U});
    ASSERT_TRUE(timer.IsAlive());
    // When the next comes 1200 us later, then it is in time
    timer.Answer(Right(timer.Question()), Instant{1104U});
    EXPECT_TRUE(timer.IsAlive());
    // and 1201 us later it would not be
    timer.Answer(Right(timer.Question()), Instant{2305U});
    EXPECT_FALSE(timer.IsAlive());
}

TEST(WatchdogTimer, NeverStartedOrZeroFilledIsTripped)
{
    Verifies(req::SRS_HAL_009);
    // Given a watchdog that was never started, then it is tripped
    WatchdogTimer timer;
    EXPECT_FALSE(timer.IsAlive());
    // Given one whose memory was zeroed, then it is tripped
    WatchdogTimer zeroed = StartedAt(0U);
    unsigned char zeros[sizeof(WatchdogTimer)] = {};
    std::memcpy(&zeroed, zeros, sizeof(zeroed));
    EXPECT_FALSE(zeroed.IsAlive());
    // and a right answer does not make it live
    zeroed.Answer(Right(zeroed.Question()), Instant{0U});
    EXPECT_FALSE(zeroed.IsAlive());
}

TEST(WatchdogTimer, AcceptedAnswerChangesTheQuestion)
{
    Verifies(req::SRS_HAL_009);
    // Given a watchdog that is answered rightly
    WatchdogTimer timer = StartedAt(0U);
    const WatchdogQuestion first = timer.Question();
    timer.Answer(Right(first), Instant{1000U});
    ASSERT_TRUE(timer.IsAlive());
    // When the answer to the first question comes again
    EXPECT_NE(timer.Question().value, first.value);
    timer.Answer(Right(first), Instant{2000U});
    // Then it trips
    EXPECT_FALSE(timer.IsAlive());
}

TEST(WatchdogTimer, StartCountsAsTheAnswerBefore)
{
    Verifies(req::SRS_HAL_009);
    // Given a watchdog started at 5000, when the first answer comes 800 us later, then it is in the window
    WatchdogTimer timer = StartedAt(5'000U);
    EXPECT_TRUE(timer.IsAlive());
    timer.Answer(Right(timer.Question()), Instant{5'800U});
    EXPECT_TRUE(timer.IsAlive());
}

} // namespace
} // namespace counterpoint::hal
