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
    Verifies(req::SRS_TWO_151);
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

// Given both places taken by one slot, then it is armed, and not even the lowest slot fits.
TEST(ArmedFrames, PlacesOfOneSlotAreOneSlot)
{
    Verifies(req::SRS_TWO_011);
    ArmedFrames armed{};
    EXPECT_EQ(armed.Fitting(7U), 3U);
    armed.Arm(ArmingOf(4U, 0U));
    EXPECT_EQ(armed.Fitting(7U), 1U);
    armed.Arm(ArmingOf(4U, 0U));
    EXPECT_EQ(armed.Slots(), 0x10U);
    EXPECT_EQ(armed.Fitting(1U), 0U);
}

// Given a frame armed at 1 ms and on the bus at 5 ms, then a word composed at 4 ms leaves it answered.
TEST(ArmedFrames, AnswerIsAsOldAsTheFrameOnTheBus)
{
    Verifies(req::SRS_TWO_012);
    ArmedFrames armed{};
    armed.Arm(ArmingOf(4U, 1000U));
    armed.Answer(4U, Instant{5000U});
    armed.Clear(Window{Instant{4000U}, Instant{6000U}});
    EXPECT_EQ(armed.Slots(), 0x10U);
    armed.Clear(Window{Instant{5000U}, Instant{7000U}});
    EXPECT_EQ(armed.Slots(), 0U);
}

// Given a frame armed at 1 ms that the leader refuses at 5 ms, then a word composed at 4 ms leaves it answered.
TEST(ArmedFrames, RefusalIsAsOldAsItsMessage)
{
    Verifies(req::SRS_TWO_012);
    Verifies(req::SRS_TWO_215);
    ArmedFrames armed{};
    armed.Arm(ArmingOf(4U, 1000U));
    EXPECT_EQ(armed.Refuse(Refusal{1U, SrdoCause::kNotInverse}, Instant{5000U}), 4U);
    armed.Clear(Window{Instant{4000U}, Instant{6000U}});
    EXPECT_EQ(armed.Slots(), 0x10U);
    armed.Clear(Window{Instant{5000U}, Instant{7000U}});
    EXPECT_EQ(armed.Slots(), 0U);
}

// Given 255 armings, then numbers never become 0.
TEST(ArmedFrames, NumbersAreNeverZero)
{
    Verifies(req::SRS_TWO_214);
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
