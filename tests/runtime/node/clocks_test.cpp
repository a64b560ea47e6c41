// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/clocks.hpp"

#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <ctime>

// The two counters of a live node, and the order of the stamps that it gives.
namespace counterpoint::runtime
{
namespace
{
std::uint64_t MicrosecondsOf(const clockid_t clock)
{
    timespec time{};
    EXPECT_EQ(::clock_gettime(clock, &time), 0);
    return (static_cast<std::uint64_t>(time.tv_sec) * 1000000U) + (static_cast<std::uint64_t>(time.tv_nsec) / 1000U);
}

TEST(NodeClocksTest, CountersAreThoseOfTheSystem)
{
    Verifies(req::SRS_NODE_002);
    NodeClocks clocks{500U};
    const std::uint64_t before_a = MicrosecondsOf(CLOCK_MONOTONIC);
    const InstantPair now = clocks.Now();
    const std::uint64_t after_a = MicrosecondsOf(CLOCK_MONOTONIC);
    // Given both clocks around the reading, then counter A lies between those of CLOCK_MONOTONIC
    EXPECT_LE(now.a.us - static_cast<std::uint32_t>(before_a), static_cast<std::uint32_t>(after_a - before_a));
    // and counter B between two of CLOCK_MONOTONIC_RAW, give or take what the reading took
    const std::uint64_t before_b = MicrosecondsOf(CLOCK_MONOTONIC_RAW);
    const std::uint32_t b = clocks.Now().b.us;
    const auto span = static_cast<std::uint32_t>(MicrosecondsOf(CLOCK_MONOTONIC_RAW) - before_b) + 1U;
    EXPECT_LE(b - (static_cast<std::uint32_t>(before_b) - span), 3U * span);
}

TEST(NodeClocksTest, AStampThatIsLateByTheToleranceAtMostIsThatOfTheFrameBefore)
{
    Verifies(req::SRS_NODE_002);
    NodeClocks clocks{500U};
    // Given a frame far ahead of now, so that no reading of the clocks is newer
    const std::uint64_t first_ns = clocks.NowNs() + 3600000000000U;
    const InstantPair first = clocks.Stamp(first_ns);
    EXPECT_EQ(first.a.us, static_cast<std::uint32_t>(first_ns / 1000U));
    EXPECT_EQ(clocks.LateCount(), 0U);
    // When one comes with a stamp 500 us before it, then it has the same one, and is counted
    const InstantPair late = clocks.Stamp(first_ns - 500000U);
    EXPECT_EQ(late.a.us, first.a.us);
    EXPECT_EQ(late.b.us, first.b.us);
    EXPECT_EQ(clocks.LateCount(), 1U);
    EXPECT_EQ(clocks.LatestUs(), 500U);
    // A microsecond more, and it keeps its own
    const InstantPair later = clocks.Stamp(first_ns - 501000U);
    EXPECT_EQ(first.a.us - later.a.us, 501U);
    EXPECT_EQ(clocks.LateCount(), 2U);
    EXPECT_EQ(clocks.LatestUs(), 501U);
    // and what follows in order has its own, too
    EXPECT_EQ(clocks.Stamp(first_ns + 1000U).a.us - first.a.us, 1U);
    EXPECT_EQ(clocks.LateCount(), 2U);
}
} // namespace
} // namespace counterpoint::runtime
