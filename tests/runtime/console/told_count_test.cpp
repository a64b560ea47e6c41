// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/console/told_count.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint64_t kSecondNs = 1000000000U;

TEST(ToldCountTest, IsToldAtOnceThenOnceASecond)
{
    Verifies(req::SRS_MGR_581);
    Verifies(req::SRS_NODE_581);
    ToldCount count;
    EXPECT_FALSE(count.Learn(0U));
    EXPECT_EQ(count.Due(5U), 0U);
    EXPECT_TRUE(count.Learn(3U));
    EXPECT_EQ(count.Due(5U), 3U);
    EXPECT_EQ(count.Due(5U + kSecondNs), 0U);
    EXPECT_TRUE(count.Learn(10U));
    EXPECT_FALSE(count.Learn(10U));
    EXPECT_EQ(count.Due(4U + kSecondNs), 0U);
    EXPECT_EQ(count.Due(5U + kSecondNs), 7U);
    EXPECT_EQ(count.Due(5U + 2U * kSecondNs), 0U);
}

TEST(ToldCountTest, TheTextHasWhatWasWrongWhereItIsKnown)
{
    Verifies(req::SRS_MGR_581);
    EXPECT_EQ(MalformedText(1U, ""), "1 malformed element of the bus left out");
    EXPECT_EQ(MalformedText(2U, "frame: time 'zz', expected SECONDS.MICROSECONDS"),
              "2 malformed elements of the bus left out, the last: frame: time 'zz', expected SECONDS.MICROSECONDS");
}
} // namespace
} // namespace counterpoint::runtime
