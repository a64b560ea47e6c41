// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/crosslink/link_supervisor.hpp"

#include "safety_core/crosslink/flow_tap.hpp"
#include "tests/safety_core/crosslink/peer_rig.hpp"
#include "verification/trace/ids/crosslink.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace counterpoint
{
namespace
{

// Windows of 160 ms; the share of the tolerance is half of 20 ms less two ninths, rounded up: 7777 us.
constexpr LinkConfig kLink{PeerRole::kA, 40000U, 20000U, 400000U, 100U};

LinkMessage Message(const std::uint32_t sequence, const std::uint32_t stamp_us, const LinkEcho& echo)
{
    LinkMessage message{};
    message.sequence = sequence;
    message.stamp = Instant{stamp_us};
    message.echo = echo;
    return message;
}

LinkEcho EchoOf(const std::uint32_t stamp_us, const std::uint32_t hold_us = 0U)
{
    return LinkEcho{7U, Instant{stamp_us}, hold_us, kHeard};
}

LinkEcho EchoOfMessage(const std::uint32_t sequence)
{
    return LinkEcho{sequence, Instant{8000U}, 0U, kHeard};
}

class Supervision : public ::testing::Test
{
  protected:
    void SetUp() override
    {
        link.Restart(kLink);
        link.Examine(Instant{0U});
        link.OnCompose(7U);
    }
    /// Contact at 10 ms by a message 50 that echoes 8 ms.
    void Contact()
    {
        ASSERT_EQ(link.Take(Message(50U, 510000U, EchoOf(8000U)), Instant{10000U}), TakeResult::kTaken);
        ASSERT_TRUE(link.IsAlive());
    }
    LinkSupervisor link{};
};

// Given cycles of 10 ms that are each 5 ms late, when the last message that is taken answers what was said at any
// instant between two cycles, then the link is lost within 40 + 15 ms, which is the computed limit.
TEST_F(Supervision, LossIsFoundWithinTheLimitWheneverItBegins)
{
    Verifies(req::SRS_LNK_009);
    std::uint32_t longest_us = 0U;
    for (std::uint32_t place_us = 0U; place_us <= 15000U; place_us += 500U)
    {
        SetUp();
        ASSERT_EQ(link.Take(Message(50U, 510000U, EchoOf(place_us)), Instant{15000U}), TakeResult::kTaken);
        std::uint32_t now_us = 15000U;
        while (link.IsAlive() && (now_us < 1000000U))
        {
            now_us += 15000U;
            link.Examine(Instant{now_us});
        }
        longest_us = std::max(longest_us, now_us - place_us);
    }
    EXPECT_EQ(longest_us, 55000U);
}

// Given instants less than half the circle of the counter apart, then the earlier one is not after the later one.
TEST(Instants, AreModular)
{
    Verifies(req::SRS_TWO_004);
    EXPECT_TRUE(IsNotAfter(Instant{5U}, Instant{5U}));
    EXPECT_TRUE(IsNotAfter(Instant{0U}, Instant{0x7FFFFFFFU}));
    EXPECT_FALSE(IsNotAfter(Instant{0U}, Instant{0x80000000U}));
    EXPECT_TRUE(IsNotAfter(Instant{0xFFFFFFF0U}, Instant{0x40000000U}));
    EXPECT_FALSE(IsNotAfter(Instant{1U}, Instant{0U}));
}

// Given no contact, when messages without echo come, in any order, then nothing is taken, lost or a fault, and the
// newest is echoed.
TEST_F(Supervision, BeforeContactNothingIsAFault)
{
    Verifies(req::SRS_LNK_005);
    Verifies(req::SRS_LNK_210);
    EXPECT_EQ(link.Echo(Instant{5U}).heard, 0U);
    EXPECT_EQ(link.Take(Message(90U, 500U, LinkEcho{}), Instant{10U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.Take(Message(20U, 700U, LinkEcho{}), Instant{30U}), TakeResult::kDiscarded);
    link.Examine(Instant{90000000U});
    EXPECT_EQ(link.State(), LinkState::kWaiting);
    EXPECT_EQ(link.Finding(), LinkFinding::kNone);
    EXPECT_NE(link.Spoiler(), 0U);
    const LinkEcho echo = link.Echo(Instant{100U});
    EXPECT_EQ(echo.heard, 0x96U);
    EXPECT_EQ(echo.sequence, 20U);
    EXPECT_EQ(echo.stamp.us, 700U);
    EXPECT_EQ(echo.hold_us, 70U);
    EXPECT_EQ(link.Counts().late, 2U);
}

// Given no contact, when a message with a fresh echo comes, then there is contact, whatever its sequence number.
TEST_F(Supervision, FreshEchoMakesContact)
{
    Verifies(req::SRS_LNK_005);
    EXPECT_EQ(link.Take(Message(90U, 500U, LinkEcho{}), Instant{10U}), TakeResult::kDiscarded);
    Contact();
    EXPECT_EQ(link.Spoiler(), 0U);
    EXPECT_EQ(link.Acknowledged(), 7U);
    EXPECT_EQ(link.Counts().taken, 1U);
    EXPECT_EQ(link.Composed().first.us, 8000U);
    EXPECT_EQ(link.Composed().last.us, 10000U);
}

// Given a CPU that composed 7 and 8 after a restart, when messages answer 6 or 9, then they are late; 7 and 8 are
// taken.
TEST_F(Supervision, EchoOfBeforeTheRestartIsLate)
{
    Verifies(req::SRS_LNK_011);
    link.OnCompose(8U);
    EXPECT_EQ(link.Take(Message(50U, 510000U, EchoOfMessage(6U)), Instant{10000U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.Take(Message(51U, 510000U, EchoOfMessage(9U)), Instant{10000U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.State(), LinkState::kWaiting);
    EXPECT_EQ(link.Counts().late, 2U);
    EXPECT_EQ(link.Take(Message(52U, 510000U, EchoOfMessage(7U)), Instant{10000U}), TakeResult::kTaken);
    EXPECT_EQ(link.Take(Message(53U, 510000U, EchoOfMessage(6U)), Instant{10000U}), TakeResult::kTaken);
    link.Restart(kLink);
    EXPECT_EQ(link.Take(Message(54U, 510000U, EchoOfMessage(8U)), Instant{10000U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.State(), LinkState::kWaiting);
    EXPECT_EQ(link.Counts().late, 1U);
    // Nor does an answer to what was composed at the end of the cycle in which it was started again
    link.OnCompose(9U);
    EXPECT_EQ(link.Take(Message(55U, 510000U, EchoOfMessage(9U)), Instant{10000U}), TakeResult::kDiscarded);
    link.Examine(Instant{10000U});
    link.OnCompose(10U);
    EXPECT_EQ(link.Take(Message(56U, 510000U, EchoOfMessage(9U)), Instant{10000U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.Take(Message(57U, 510000U, EchoOfMessage(10U)), Instant{10000U}), TakeResult::kTaken);
}

// Given contact at 50, when 50 comes again, then 49, then 53, then they are a repeated, an old and a new one with two
// lost.
TEST_F(Supervision, SequenceTellsRepeatedOldAndLost)
{
    Verifies(req::SRS_LNK_003);
    Contact();
    EXPECT_EQ(link.Take(Message(50U, 511000U, EchoOf(9000U)), Instant{11000U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.Take(Message(49U, 511000U, EchoOf(9000U)), Instant{11000U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.Take(Message(53U, 511000U, EchoOf(9000U)), Instant{11000U}), TakeResult::kTaken);
    EXPECT_EQ(link.Counts().repeated, 1U);
    EXPECT_EQ(link.Counts().old, 1U);
    EXPECT_EQ(link.Counts().lost, 2U);
    EXPECT_EQ(link.Counts().taken, 2U);
    EXPECT_EQ(link.Echo(Instant{11000U}).sequence, 53U);
}

// t (numbers)   FFFFFFFEh   1   FFFFFFFFh   80000001h (2^31 ahead)   80000000h
// Given no contact, when a number comes again, or one before it, then that is neither a repeated nor an old one.
TEST_F(Supervision, SequenceSaysNothingBeforeContact)
{
    Verifies(req::SRS_LNK_003);
    EXPECT_EQ(link.Take(Message(90U, 500U, LinkEcho{}), Instant{10U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.Take(Message(90U, 600U, LinkEcho{}), Instant{20U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.Take(Message(40U, 700U, LinkEcho{}), Instant{30U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.Echo(Instant{30U}).sequence, 40U);
    Contact();
    EXPECT_EQ(link.Counts().repeated, 0U);
    EXPECT_EQ(link.Counts().old, 0U);
    EXPECT_EQ(link.Counts().lost, 0U);
    EXPECT_EQ(link.Counts().late, 3U);
    // With contact the number left out is counted, and what was taken comes again as a repeated one
    EXPECT_EQ(link.Take(Message(52U, 511000U, EchoOf(9000U)), Instant{11000U}), TakeResult::kTaken);
    EXPECT_EQ(link.Take(Message(52U, 511000U, EchoOf(9000U)), Instant{11000U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.Counts().lost, 1U);
    EXPECT_EQ(link.Counts().repeated, 1U);
    EXPECT_EQ(link.Counts().late, 3U);
}

TEST_F(Supervision, SequenceIsModular)
{
    Verifies(req::SRS_LNK_003);
    ASSERT_EQ(link.Take(Message(0xFFFFFFFEU, 510000U, EchoOf(8000U)), Instant{10000U}), TakeResult::kTaken);
    EXPECT_EQ(link.Take(Message(1U, 511000U, EchoOf(9000U)), Instant{11000U}), TakeResult::kTaken);
    EXPECT_EQ(link.Counts().lost, 2U);
    EXPECT_EQ(link.Take(Message(0xFFFFFFFFU, 511000U, EchoOf(9000U)), Instant{11000U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.Counts().old, 1U);
    EXPECT_EQ(link.Take(Message(0x80000002U, 511000U, EchoOf(9000U)), Instant{11000U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.Counts().old, 2U);
    EXPECT_EQ(link.Take(Message(0x80000001U, 511000U, EchoOf(9000U)), Instant{11000U}), TakeResult::kTaken);
    EXPECT_EQ(link.Counts().lost, 0x80000001U);
}

// Given contact, when an echo is exactly as old as the time-out, then it is taken; a microsecond more is late.
TEST_F(Supervision, EchoAtTheTimeoutIsTakenOneMoreIsLate)
{
    Verifies(req::SRS_LNK_210);
    Verifies(req::SRS_LNK_003);
    Contact();
    EXPECT_EQ(link.Take(Message(51U, 511000U, EchoOf(9000U)), Instant{49000U}), TakeResult::kTaken);
    EXPECT_EQ(link.Take(Message(52U, 511000U, EchoOf(9000U)), Instant{49001U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.Counts().late, 1U);
    EXPECT_EQ(link.Echo(Instant{49001U}).sequence, 52U);
    // What was late was heard: the same number again is a repeated one, however fresh
    EXPECT_EQ(link.Take(Message(52U, 511000U, EchoOf(49000U)), Instant{49500U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.Counts().repeated, 1U);
    EXPECT_EQ(link.Counts().late, 1U);
}

// Given contact, when an echo lies in the future, or was held for longer than there was time, then it is late; what the
// drift of the clocks explains is not.
TEST_F(Supervision, ImpossibleEchoIsLate)
{
    Verifies(req::SRS_LNK_210);
    Contact();
    EXPECT_EQ(link.Take(Message(51U, 511000U, EchoOf(12000U)), Instant{11000U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.Take(Message(52U, 511000U, EchoOf(9000U, 2101U)), Instant{11000U}), TakeResult::kDiscarded);
    EXPECT_EQ(link.Counts().late, 2U);
    EXPECT_EQ(link.Take(Message(53U, 511000U, EchoOf(9000U, 2100U)), Instant{11000U}), TakeResult::kTaken);
    EXPECT_EQ(link.Composed().first.us, 11000U);
    EXPECT_EQ(link.Take(Message(54U, 512000U, EchoOf(9000U, 500U)), Instant{12000U}), TakeResult::kTaken);
    EXPECT_EQ(link.Composed().first.us, 9500U);
}

// Given contact with an echo of 8 ms, when nothing more comes, then the link is lost just beyond 48 ms and stays so.
TEST_F(Supervision, SilenceBeyondTheTimeoutLosesTheLink)
{
    Verifies(req::SRS_LNK_006);
    Contact();
    link.Examine(Instant{48000U});
    EXPECT_TRUE(link.IsAlive());
    link.Examine(Instant{48001U});
    EXPECT_EQ(link.State(), LinkState::kLost);
    EXPECT_EQ(link.Finding(), LinkFinding::kTimeout);
    EXPECT_NE(link.Spoiler(), 0U);
    link.Examine(Instant{49000U});
    EXPECT_EQ(link.Take(Message(51U, 550000U, EchoOf(49000U)), Instant{50000U}), TakeResult::kTaken);
    EXPECT_EQ(link.State(), LinkState::kLost);
    link.Lose(LinkFinding::kFlow);
    EXPECT_EQ(link.Finding(), LinkFinding::kTimeout);
}

// Given contact, when the peer's clock falls behind or runs ahead by a window's share of the tolerance, then nothing;
// by one more, lost.
TEST_F(Supervision, ClockThatStandsIsFound)
{
    Verifies(req::SRS_LNK_007);
    Contact();
    EXPECT_EQ(link.Take(Message(51U, 510000U, EchoOf(17000U)), Instant{17777U}), TakeResult::kTaken);
    EXPECT_TRUE(link.IsAlive());
    EXPECT_EQ(link.Take(Message(52U, 510000U, EchoOf(17000U)), Instant{17778U}), TakeResult::kTaken);
    EXPECT_EQ(link.State(), LinkState::kLost);
    EXPECT_EQ(link.Finding(), LinkFinding::kClock);
}

TEST_F(Supervision, ClockThatRunsAwayIsFound)
{
    Verifies(req::SRS_LNK_007);
    Contact();
    EXPECT_EQ(link.Take(Message(51U, 517777U, EchoOf(9000U)), Instant{10000U}), TakeResult::kTaken);
    EXPECT_TRUE(link.IsAlive());
    EXPECT_EQ(link.Take(Message(52U, 517778U, EchoOf(9000U)), Instant{10000U}), TakeResult::kTaken);
    EXPECT_EQ(link.Finding(), LinkFinding::kClock);
}

/// A tolerance, and what of it belongs to a window.
struct Share
{
    std::uint32_t timeout_us;
    std::uint32_t tolerance_us;
    std::uint32_t interval_us;
    std::uint32_t share_us;
};

// Given a tolerance of 4000 us in 4 times 10 ms: two quarters are left out, and half of the rest is 1000 us. Of 4003 us
// in 5 times 10 ms two fifths are 1602 us, rounded up, and half of the rest 1200 us.
TEST(ToleranceOfAWindow, IsHalfOfWhatTwoTimeoutsLeaveRoundedDown)
{
    Verifies(req::SRS_LNK_212);
    for (const Share& share : {Share{9999U, 4000U, 40000U, 1000U}, Share{9999U, 4003U, 50000U, 1200U},
                               Share{10000U, 4000U, 40000U, 666U}, Share{9999U, 1U, 40000U, 0U}})
    {
        LinkSupervisor link{};
        link.Restart(LinkConfig{PeerRole::kA, share.timeout_us, share.tolerance_us, share.interval_us, 100U});
        link.Examine(Instant{0U});
        link.OnCompose(7U);
        EXPECT_EQ(link.Take(Message(50U, 510000U, EchoOf(8000U)), Instant{10000U}), TakeResult::kTaken);
        const std::uint32_t still_us = 10000U + share.share_us;
        EXPECT_EQ(link.Take(Message(51U, 510000U, EchoOf(10000U)), Instant{still_us}), TakeResult::kTaken);
        EXPECT_TRUE(link.IsAlive()) << share.tolerance_us;
        EXPECT_EQ(link.Take(Message(52U, 510000U, EchoOf(10000U)), Instant{still_us + 1U}), TakeResult::kTaken);
        EXPECT_EQ(link.Finding(), LinkFinding::kClock) << share.tolerance_us;
    }
}

// Given a drift of 7 ms a window, when the window is over by the own clock, then the comparison begins anew; before, it
// goes on.
TEST_F(Supervision, ReferenceMovesOnWithTheOwnClock)
{
    Verifies(req::SRS_LNK_211);
    Contact();
    EXPECT_EQ(link.Take(Message(51U, 663000U, EchoOf(170000U)), Instant{170000U}),
              TakeResult::kTaken); // own 160, peer 153
    EXPECT_EQ(link.Take(Message(52U, 816000U, EchoOf(330000U)), Instant{330000U}), TakeResult::kTaken);
    EXPECT_TRUE(link.IsAlive());
    EXPECT_EQ(link.Take(Message(53U, 982999U, EchoOf(489999U)), Instant{489999U}),
              TakeResult::kTaken); // own 159.999, peer 166.999
    EXPECT_TRUE(link.IsAlive());
    EXPECT_EQ(link.Take(Message(54U, 984778U, EchoOf(491000U)), Instant{491000U}),
              TakeResult::kTaken); // own 161, peer 168.778
    EXPECT_EQ(link.Finding(), LinkFinding::kClock);
}

/// A peer whose clock gains `gain` parts in a million from `begin_us` on; messages each `pace_us`. Whole milliseconds.
struct Drift
{
    std::uint32_t interval_us;
    std::uint32_t pace_us;
    std::uint32_t gain_ppm;
    std::uint32_t longest_us; ///< From its begin, whenever in two windows that is, to the message that finds it.
};

/// When the drift that begins at `begin_us` was found, by the own clock; 0: not within four intervals.
std::uint32_t FoundAt(const Drift& drift, const std::uint32_t begin_us)
{
    LinkSupervisor link{};
    link.Restart(LinkConfig{PeerRole::kA, 40000U, 20000U, drift.interval_us, 100U});
    link.Examine(Instant{0U});
    link.OnCompose(7U);
    std::uint32_t sequence = 50U;
    for (std::uint32_t now_us = 0U; now_us < (4U * drift.interval_us); now_us += drift.pace_us)
    {
        const std::uint32_t drifting_ms = ((now_us > begin_us) ? (now_us - begin_us) : 0U) / 1000U;
        const std::uint32_t gained_us = (drifting_ms * drift.gain_ppm) / 1000U;
        const LinkMessage message = Message(sequence++, 500000U + now_us + gained_us, EchoOf(now_us));
        EXPECT_EQ(link.Take(message, Instant{now_us}), TakeResult::kTaken);
        if (!link.IsAlive())
        {
            EXPECT_EQ(link.Finding(), LinkFinding::kClock);
            return now_us;
        }
    }
    return 0U;
}

// Given a time-out of 40 ms and a tolerance of 20 ms in an interval, when the peer's clock drifts from any instant on
// by hardly more than that, with messages each 5 ms or as far apart as the time-out and a cycle allow, then it is found
// within the interval, the time-out and a cycle of 10 ms.
TEST(DriftOfThePeer, HardlyAboveTheToleranceIsFoundWithinTheIntervalWheneverItBegins)
{
    Verifies(req::SRS_LNK_012);
    for (const Drift& drift : {Drift{400000U, 5000U, 50003U, 315000U}, Drift{400000U, 50000U, 50003U, 355000U},
                               Drift{160000U, 5000U, 125007U, 56000U}, Drift{160000U, 50000U, 125007U, 76000U},
                               Drift{1000000U, 50000U, 20002U, 958000U}})
    {
        std::uint32_t longest_us = 0U;
        for (std::uint32_t begin_us = 0U; begin_us <= (2U * drift.interval_us); begin_us += 1000U)
        {
            const std::uint32_t found_us = FoundAt(drift, begin_us);
            ASSERT_NE(found_us, 0U) << drift.interval_us << ' ' << drift.pace_us << ' ' << begin_us;
            longest_us = std::max(longest_us, found_us - begin_us);
        }
        EXPECT_EQ(longest_us, drift.longest_us) << drift.interval_us << ' ' << drift.pace_us;
        EXPECT_LE(longest_us, drift.interval_us + 40000U + 10000U);
    }
}

// Given the same link, when the peer's clock gains a window's share of the tolerance in a window and a message's
// distance, then it is never lost.
TEST(DriftOfThePeer, BelowTheShareOfAWindowIsNoFault)
{
    Verifies(req::SRS_LNK_012);
    EXPECT_EQ(FoundAt(Drift{400000U, 5000U, 47000U, 0U}, 3000U), 0U);
    EXPECT_EQ(FoundAt(Drift{400000U, 50000U, 37000U, 0U}, 3000U), 0U);
}

// Given all members of a configuration that fits, when one is out of its range, then that one is named.
TEST(LinkConfiguration, FirstReasonIsNamed)
{
    Verifies(req::SRS_LNK_008);
    DeviceConfig device{};
    device.cycle_us = 10000U;
    device.discrepancy_us = 20000U;
    const auto check = [&device](PeerRole role, std::uint32_t timeout, std::uint32_t tolerance, std::uint32_t interval,
                                 std::uint32_t stamps)
    { return CheckLinkConfig(device, LinkConfig{role, timeout, tolerance, interval, stamps}); };
    EXPECT_EQ(check(PeerRole::kA, 30000U, 15000U, 120000U, 29999U), LinkConfigFault::kNone);
    EXPECT_EQ(check(PeerRole::kB, 30000U, 1U, 0x20000000U, 0U), LinkConfigFault::kNone);
    EXPECT_EQ(check(PeerRole::kInvalid, 30000U, 15000U, 120000U, 0U), LinkConfigFault::kRole);
    EXPECT_EQ(check(PeerRole::kA, 29999U, 14999U, 120000U, 0U), LinkConfigFault::kTimeout);
    EXPECT_EQ(check(PeerRole::kA, 30000U, 0U, 120000U, 0U), LinkConfigFault::kClock);
    EXPECT_EQ(check(PeerRole::kA, 30000U, 15001U, 120000U, 0U), LinkConfigFault::kClock);
    EXPECT_EQ(check(PeerRole::kA, 30000U, 15000U, 119999U, 0U), LinkConfigFault::kClock);
    EXPECT_EQ(check(PeerRole::kA, 0xFFFFFFFFU, 15000U, 0x20000000U, 0U), LinkConfigFault::kClock);
    EXPECT_EQ(check(PeerRole::kA, 30000U, 15000U, 0x20000001U, 0U), LinkConfigFault::kClock);
    EXPECT_EQ(check(PeerRole::kA, 30000U, 15000U, 120000U, 30000U), LinkConfigFault::kStampTolerance);
    device.discrepancy_us = 19999U;
    EXPECT_EQ(check(PeerRole::kA, 30000U, 15000U, 120000U, 0U), LinkConfigFault::kDiscrepancy);
}

// Given an answer for signature and question, when it passes the tap, then the signature comes out, once, and the
// watchdog has its answer.
TEST(FlowTap, TakesTheSignatureBack)
{
    Verifies(req::SRS_LNK_010);
    FakeWatchdog watchdog{};
    FlowTap tap{watchdog};
    EXPECT_EQ(tap.TakeSignature(), 0U);
    EXPECT_EQ(tap.Question().value, 0x11U);
    tap.Answer(hal::WatchdogAnswer{(0x5EC0DE27U + 0x11U) * 0x01000193U});
    EXPECT_EQ(watchdog.answered, (0x5EC0DE27U + 0x11U) * 0x01000193U);
    EXPECT_EQ(tap.TakeSignature(), 0x5EC0DE27U);
    EXPECT_EQ(tap.TakeSignature(), 0U);
}

} // namespace
} // namespace counterpoint
