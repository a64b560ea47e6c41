// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/virtual/bit_rate.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::host
{
namespace
{

TEST(BitRate, BitIsAWholeNumberOfNanosecondsAtEachRate)
{
    Verifies(req::SRS_BUS_002);
    // Given each rate, then its bit time
    EXPECT_EQ(BitTime(BitRate::k10k), 100'000);
    EXPECT_EQ(BitTime(BitRate::k20k), 50'000);
    EXPECT_EQ(BitTime(BitRate::k50k), 20'000);
    EXPECT_EQ(BitTime(BitRate::k100k), 10'000);
    EXPECT_EQ(BitTime(BitRate::k125k), 8'000);
    EXPECT_EQ(BitTime(BitRate::k250k), 4'000);
    EXPECT_EQ(BitTime(BitRate::k500k), 2'000);
    EXPECT_EQ(BitTime(BitRate::k800k), 1'250);
    EXPECT_EQ(BitTime(BitRate::k1M), 1'000);
}

TEST(BitRate, OtherRatesAreRefused)
{
    Verifies(req::SRS_BUS_002);
    // When numbers are taken for rates, then only those of the list are
    EXPECT_EQ(BitRateFrom(10'000U), BitRate::k10k);
    EXPECT_EQ(BitRateFrom(800'000U), BitRate::k800k);
    EXPECT_EQ(BitRateFrom(1'000'000U), BitRate::k1M);
    EXPECT_FALSE(BitRateFrom(0U).has_value());
    EXPECT_FALSE(BitRateFrom(83'333U).has_value());
    EXPECT_FALSE(BitRateFrom(1'000'001U).has_value());
}

} // namespace
} // namespace counterpoint::host
