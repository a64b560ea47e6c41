// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/hal/tms570/rig.hpp"
#include "verification/trace/ids/tms570.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace counterpoint::tms570
{
namespace
{

TEST(EsmTest, EveryChannelHasANameAndAReaction)
{
    Verifies(req::SRS_TMS_030);
    // Given the table, then only the corrected errors of RAM and flash are recorded
    std::set<std::uint32_t> recorded;
    for (std::uint32_t channel = 0U; channel < 64U; ++channel)
    {
        EXPECT_FALSE(std::string{kEsmGroup1[channel].name}.empty());
        if (kEsmGroup1[channel].reaction == EsmReaction::kRecord)
        {
            recorded.insert(channel);
        }
        else
        {
            EXPECT_EQ(kEsmGroup1[channel].reaction, EsmReaction::kSafeState);
        }
    }
    EXPECT_EQ(recorded, (std::set<std::uint32_t>{6U, 26U, 28U, 35U}));
    for (std::uint32_t channel = 0U; channel < 32U; ++channel)
    {
        EXPECT_FALSE(std::string{kEsmGroup2[channel].name}.empty());
        EXPECT_FALSE(std::string{kEsmGroup3[channel].name}.empty());
        EXPECT_EQ(kEsmGroup2[channel].reaction, EsmReaction::kSafeState);
        EXPECT_EQ(kEsmGroup3[channel].reaction, EsmReaction::kHardwareState);
    }
    EXPECT_EQ(sizeof(kEsmGroup1) / sizeof(kEsmGroup1[0]), 64U);
    EXPECT_EQ(sizeof(kEsmGroup2) / sizeof(kEsmGroup2[0]), 32U);
    EXPECT_EQ(sizeof(kEsmGroup3) / sizeof(kEsmGroup3[0]), 32U);
    // and none that is reserved is taken lightly
    for (const std::uint32_t channel : recorded)
    {
        EXPECT_STRNE(kEsmGroup1[channel].name, "reserved") << channel;
    }
}

using EsmChannels = ::testing::TestWithParam<std::uint32_t>;

TEST_P(EsmChannels, EveryChannelOfGroup1ReactsAsTheTableSays)
{
    Verifies(req::SRS_TMS_030);
    Verifies(req::SRS_TMS_032);
    Verifies(req::SRS_TMS_033);
    // Given a board in operation with an open output
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    ASSERT_EQ(rig.Cycle(), BoardFault::kNone);
    // When this channel speaks and the interrupt is taken
    rig.machine.esm.Raise(1U, GetParam());
    rig.TakeInterrupts();
    // Then the pins, nERROR and the record are as the table says
    const bool is_recorded = kEsmGroup1[GetParam()].reaction == EsmReaction::kRecord;
    EXPECT_EQ(rig.machine.gio.PinsA(), is_recorded ? 1U : 0U);
    EXPECT_EQ(rig.machine.esm.IsPinHigh(), is_recorded);
    EXPECT_EQ(rig.board.Errors().Corrected(), is_recorded ? 1U : 0U);
    EXPECT_EQ(rig.board.Errors().First().group, is_recorded ? 0U : 1U);
    EXPECT_EQ(rig.board.Errors().First().channel, is_recorded ? 0U : GetParam());
    // and the interrupt does not come for ever
    EXPECT_FALSE(rig.machine.vim.FastLine());
    // and nERROR stays low, however long that is
    rig.machine.Advance(2000U);
    EXPECT_EQ(rig.machine.esm.IsPinHigh(), is_recorded);
}

INSTANTIATE_TEST_SUITE_P(All, EsmChannels, ::testing::Range(0U, 64U));

TEST(EsmTest, SixteenCorrectedErrorsAreRecordedAndOneMoreIsTheSafeState)
{
    Verifies(req::SRS_TMS_032);
    // Given a board with an open output, when RAM is corrected once a cycle, then sixteen times nothing else happens
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    for (std::uint16_t count = 1U; count <= 16U; ++count)
    {
        rig.machine.esm.Raise(1U, 26U);
        EXPECT_EQ(rig.Cycle(), BoardFault::kNone);
        EXPECT_EQ(rig.board.Errors().Corrected(), count);
    }
    EXPECT_EQ(rig.machine.gio.PinsA(), 1U);
    // and the next time the device is safe, with group and channel kept
    rig.machine.esm.Raise(1U, 26U);
    EXPECT_EQ(rig.Cycle(), BoardFault::kEsm);
    EXPECT_TRUE(rig.IsSafe());
    EXPECT_EQ(rig.board.Errors().First().group, 1U);
    EXPECT_EQ(rig.board.Errors().First().channel, 26U);
}

TEST(EsmTest, FirstErrorStays)
{
    Verifies(req::SRS_TMS_032);
    // Given an error of group 2, when another comes later
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    rig.machine.esm.Raise(2U, 16U);
    rig.TakeInterrupts();
    rig.machine.esm.Raise(3U, 7U);
    static_cast<void>(rig.Cycle());
    // Then the record tells the first
    EXPECT_EQ(rig.board.Errors().First().group, 2U);
    EXPECT_EQ(rig.board.Errors().First().channel, 16U);
}

} // namespace
} // namespace counterpoint::tms570
