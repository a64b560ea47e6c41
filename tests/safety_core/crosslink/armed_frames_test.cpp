// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/crosslink/peer_rig.hpp"
#include "verification/trace/ids/crosslink.hpp"

#include <gtest/gtest.h>

namespace counterpoint
{
namespace
{

Arming ArmingOf(const SlotIndex slot, const std::uint32_t at_us)
{
    return Arming{slot, PeerRig::Frame(0x101U), Instant{at_us}, 20000U};
}

// Given room for two frames, when two are armed, then no third fits, and arming one changes nothing.
TEST(ArmedFrames, HasRoomForTwo)
{
    Verifies(req::SRS_TWO_011);
    ArmedFrames armed{};
    EXPECT_EQ(armed.Fitting(0x70U), 0x30U);
    armed.Arm(ArmingOf(4U, 0U));
    EXPECT_EQ(armed.Fitting(0x60U), 0x20U);
    EXPECT_EQ(armed.Fitting(0U), 0U);
    armed.Arm(ArmingOf(5U, 0U));
    EXPECT_EQ(armed.Fitting(0x40U), 0U);
    armed.Arm(ArmingOf(6U, 0U));
    EXPECT_EQ(armed.Slots(), 0x30U);
    EXPECT_EQ(armed.At(0U).slot, 4U);
    EXPECT_EQ(armed.At(0U).number, 1U);
    EXPECT_EQ(armed.At(1U).number, 2U);
    armed.Restart();
    EXPECT_EQ(armed.Slots(), 0U);
}

// Given an armed frame with 20 ms, when they are over, then it is given up; what was answered before a word is done.
TEST(ArmedFrames, GivesUpAfterItsLimit)
{
    Verifies(req::SRS_TWO_011);
    Verifies(req::SRS_TWO_012);
    ArmedFrames armed{};
    armed.Arm(ArmingOf(4U, 1000U));
    armed.Examine(Instant{21000U});
    EXPECT_EQ(armed.At(0U).slot, 4U);
    armed.Clear(Window{Instant{30000U}, Instant{31000U}});
    EXPECT_EQ(armed.Slots(), 0x10U);
    armed.Examine(Instant{21001U});
    EXPECT_EQ(armed.At(0U).slot, kNoSlot);
    EXPECT_EQ(armed.Slots(), 0x10U);
    armed.Examine(Instant{50000U});
    armed.Answer(5U, Instant{60000U});
    armed.Answer(4U, Instant{60000U});
    armed.Clear(Window{Instant{21000U}, Instant{40000U}});
    EXPECT_EQ(armed.Slots(), 0x10U);
    armed.Clear(Window{Instant{21001U}, Instant{40000U}});
    EXPECT_EQ(armed.Slots(), 0U);
    armed.Arm(ArmingOf(3U, 50000U));
    armed.Answer(2U, Instant{50001U});
    EXPECT_EQ(armed.At(0U).slot, 3U);
}

// Given a frame that was answered at 5 ms, then it is done with a word composed at 5 ms, not before.
TEST(ArmedFrames, AnswerCountsFromItsOwnMoment)
{
    Verifies(req::SRS_TWO_012);
    ArmedFrames armed{};
    armed.Arm(ArmingOf(4U, 1000U));
    armed.Answer(4U, Instant{5000U});
    armed.Clear(Window{Instant{4999U}, Instant{6000U}});
    EXPECT_EQ(armed.Slots(), 0x10U);
    armed.Clear(Window{Instant{5000U}, Instant{6000U}});
    EXPECT_EQ(armed.Slots(), 0U);
}

// Given every choice of the lowest four slots, then the two lowest of it fit, one behind one armed frame, and none
// behind two.
TEST(ArmedFrames, LowestOfTheWantedFit)
{
    Verifies(req::SRS_TWO_011);
    constexpr std::uint8_t kTwoLowest[16] = {0U, 1U, 2U, 3U, 4U, 5U, 6U, 3U, 8U, 9U, 10U, 3U, 12U, 5U, 6U, 3U};
    constexpr std::uint8_t kLowest[16] = {0U, 1U, 2U, 1U, 4U, 1U, 2U, 1U, 8U, 1U, 2U, 1U, 4U, 1U, 2U, 1U};
    ArmedFrames none{};
    ArmedFrames one{};
    one.Arm(ArmingOf(4U, 0U));
    ArmedFrames two{};
    two.Arm(ArmingOf(4U, 0U));
    two.Arm(ArmingOf(4U, 0U));
    EXPECT_EQ(two.Slots(), 0x10U); // One slot in both places is armed.
    for (std::uint32_t wanted = 0U; wanted < 16U; ++wanted)
    {
        EXPECT_EQ(none.Fitting(wanted), kTwoLowest[wanted]) << wanted;
        EXPECT_EQ(one.Fitting(wanted), kLowest[wanted]) << wanted;
        EXPECT_EQ(two.Fitting(wanted), 0U) << wanted;
    }
}

// Given 255 armings, then numbers never become 0.
TEST(ArmedFrames, NumbersAreNeverZero)
{
    Verifies(req::SRS_TWO_010);
    ArmedFrames armed{};
    for (std::uint32_t count = 0U; count < 255U; ++count)
    {
        armed.Restart();
        armed.Arm(ArmingOf(1U, 0U));
        EXPECT_EQ(armed.At(0U).number, count + 1U);
    }
    armed.Restart();
    armed.Arm(ArmingOf(1U, 0U));
    EXPECT_EQ(armed.At(0U).number, 1U);
}

} // namespace
} // namespace counterpoint
