// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/zynqmp/time/scaled_counter.hpp"

#include "verification/trace/ids/zynqmp_hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace counterpoint::zynqmp
{
namespace
{

struct Case
{
    CounterRate rate;
    std::uint32_t expected_us; ///< After 100 times 2^31 counts, modulo 2^32.
};

// 100 times 2^31 by the rate, by hand: 1 ppb of the longest is 2.1 us.
TEST(ScaledCounterTest, DoesNotDrift)
{
    Verifies(req::SRS_ZYN_055);
    const Case cases[]{
        {{500000000U, 32U}, 429496729U},  // 429 496 729.6 us
        {{2000000000U, 32U}, 107374182U}, // 107 374 182.4 us
        {{100000000U, 32U}, 2147483648U}, // 2 147 483 648.0 us, less what is cut off
        {{533333333U, 32U}, 402653184U},  // 402 653 184.25 us
    };
    for (const Case& each : cases)
    {
        ScaledCounter counter{};
        counter.Start(each.rate, 0U);
        std::uint32_t raw = 0U;
        Instant now{0U};
        for (std::uint32_t step = 0U; step < 100U; ++step)
        {
            raw += 0x80000000U;
            now = counter.Take(raw);
        }
        EXPECT_LE(each.expected_us - now.us, 1U) << each.rate.hertz << " Hz: " << now.us;
    }
}

TEST(ScaledCounterTest, OneOfFewerBitsRollsOverWithoutADrift)
{
    Verifies(req::SRS_ZYN_055);
    const Case cases[]{
        {{1000001U, 16U}, 2258626150U},  // 200 000 times 2^15 counts: 6 553 593 446.4 us
        {{33333333U, 24U}, 3087008247U}, // 200 000 times 2^23 counts: 50 331 648 503.3 us, of which 1 ppb is 50 us
    };
    for (const Case& each : cases)
    {
        const std::uint32_t half = 1U << (each.rate.bits - 1U);
        ScaledCounter counter{};
        counter.Start(each.rate, 0U);
        Instant now{0U};
        for (std::uint32_t step = 1U; step <= 200000U; ++step)
        {
            now = counter.Take(((step % 2U) == 0U) ? 0U : half);
        }
        EXPECT_LE(each.expected_us - now.us, 1U) << each.rate.hertz << " Hz: " << now.us;
    }
}

} // namespace
} // namespace counterpoint::zynqmp
