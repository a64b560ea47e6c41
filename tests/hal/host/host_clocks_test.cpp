// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/clocks.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace counterpoint::host
{
namespace
{

TEST(HostClock, TrueClockCountsWholeMicrosecondsFromItsStart)
{
    Verifies(req::SRS_HAL_010);
    // Given a clock that reads 500 at 0
    const HostClock clock(500U);
    // Then it counts a microsecond when it is complete
    EXPECT_EQ(clock.At(0).us, 500U);
    EXPECT_EQ(clock.At(999).us, 500U);
    EXPECT_EQ(clock.At(1'000).us, 501U);
    EXPECT_EQ(clock.At(kSecond).us, 1'000'500U);
}

TEST(HostClock, WrapsAfterTwoToTheThirtySecondMicroseconds)
{
    Verifies(req::SRS_HAL_010);
    // Given a clock one microsecond before its wrap
    const HostClock clock(0xFFFF'FFFFU);
    // Then it goes on at 0, and again after 2^32 us
    EXPECT_EQ(clock.At(999).us, 0xFFFF'FFFFU);
    EXPECT_EQ(clock.At(1'000).us, 0U);
    EXPECT_EQ(clock.At(4'294'967'296'000).us, 0xFFFF'FFFFU);
    EXPECT_EQ(clock.At(4'294'967'297'000).us, 0U);
}

// 100 ppm fast: one microsecond more in 10 ms. 30 ppm slow: 30 us less in a second.
TEST(HostClock, RunsFastAndSlowByPartsPerMillion)
{
    Verifies(req::SRS_HAL_010);
    // Given a fast and a slow clock
    HostClock fast(0U);
    fast.SetRate(0, 1'000'100U);
    HostClock slow(0U);
    slow.SetRate(0, 999'970U);
    // Then they gain and lose exactly that
    EXPECT_EQ(fast.At(10 * kMillisecond).us, 10'001U);
    EXPECT_EQ(fast.At((10 * kMillisecond) - 1).us, 10'000U);
    EXPECT_EQ(slow.At(kSecond).us, 999'970U);
    EXPECT_EQ(slow.At(kSecond - 1).us, 999'969U);
}

TEST(HostClock, RateChangesKeepTheReading)
{
    Verifies(req::SRS_HAL_010);
    // Given a clock that runs true for 1 ms, doubled for 1 ms, stands for 1 ms and then runs true
    HostClock clock(0U);
    clock.SetRate(kMillisecond, 2'000'000U);
    EXPECT_EQ(clock.At(kMillisecond).us, 1'000U);
    clock.SetRate(2 * kMillisecond, kStopped);
    EXPECT_EQ(clock.At(2 * kMillisecond).us, 3'000U);
    clock.SetRate(3 * kMillisecond, kTrueRate);
    // Then it reads 3 + 0 + 1 ms at 4 ms
    EXPECT_EQ(clock.At(3 * kMillisecond).us, 3'000U);
    EXPECT_EQ(clock.At(4 * kMillisecond).us, 4'000U);
}

// 1 ppm fast for 1 000 000 pieces of 1001 ns: without loss 1 001 001 001 ns, with each piece rounded 1 001 000 000 ns.
TEST(HostClock, ManyRateChangesRoundNothingAway)
{
    Verifies(req::SRS_HAL_010);
    // Given a clock whose rate is set a million times to the same value
    HostClock clock(0U);
    BusTime at = 0;
    for (int count = 0; count < 1'000'000; ++count)
    {
        clock.SetRate(at, 1'000'001U);
        at += 1'001;
    }
    // Then it reads what one that was set once reads
    EXPECT_EQ(clock.At(at).us, 1'001'001U);
    EXPECT_EQ(clock.At(at - 2).us, 1'001'000U);
}

TEST(HostClock, JumpsForwardAndBackAcrossZero)
{
    Verifies(req::SRS_HAL_010);
    // Given a clock that reads 1000 at 1 ms
    HostClock clock(0U);
    // When it jumps 500 forward, then it reads 1500
    clock.Jump(kMillisecond, 500);
    EXPECT_EQ(clock.At(kMillisecond).us, 1'500U);
    // When it jumps back further than its reading, then it wraps
    clock.Jump(kMillisecond, -1'501);
    EXPECT_EQ(clock.At(kMillisecond).us, 0xFFFF'FFFFU);
    EXPECT_EQ(clock.At(kMillisecond + 1'000).us, 0U);
}

TEST(HostClock, RateIsBounded)
{
    Verifies(req::SRS_HAL_010);
    // Given a rate above the greatest one, then a thousand times the true one is taken
    HostClock clock(0U);
    clock.SetRate(0, 0xFFFF'FFFFU);
    EXPECT_EQ(clock.At(1'000).us, 1'000U);
}

TEST(HostClock, IsExactAfterAMillionSeconds)
{
    Verifies(req::SRS_HAL_010);
    // Given a clock 1 ppm slow, when 10^6 s have passed, then it is one second behind: 999 999 000 000 modulo 2^32 us
    HostClock clock(0U);
    clock.SetRate(0, 999'999U);
    EXPECT_EQ(clock.At(1'000'000 * kSecond).us, 3'566'587'328U);
}

TEST(HostClocks, PairReadsBothAtTheBusesInstant)
{
    Verifies(req::SRS_HAL_010);
    // Given two clocks with different starts, B 10 % fast
    VirtualBus bus(BitRate::k125k);
    HostClocks clocks(bus, InstantPair{Instant{7U}, Instant{100U}});
    clocks.B().SetRate(0, 1'100'000U);
    // When the bus is at 1 ms
    bus.Advance(kMillisecond);
    // Then each reads its own time
    EXPECT_EQ(clocks.Now().a.us, 1'007U);
    EXPECT_EQ(clocks.Now().b.us, 1'200U);
    clocks.A().Jump(kMillisecond, -7);
    EXPECT_EQ(clocks.Now().a.us, 1'000U);
    EXPECT_EQ(clocks.At(2 * kMillisecond).a.us, 2'000U);
}

} // namespace
} // namespace counterpoint::host
