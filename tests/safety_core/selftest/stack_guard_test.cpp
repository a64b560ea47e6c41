// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/selftest/stack_guard.hpp"

#include "tests/safety_core/selftest/support.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <cstdint>

namespace counterpoint::selftest
{
namespace
{

/// A stack of 1024 words at 10000h, four of them guard words.
class StackGuardTest : public ::testing::Test
{
  protected:
    static constexpr StackSetup kSetup{{0x10000U, 1024U}, 4U};

    host::ArrayMemory cells{0x10000U, 1024U};
    PlacedMemory memory{cells, 0U};
    StackGuard guard{};
};

TEST_F(StackGuardTest, EachChangedGuardBitIsFound)
{
    Verifies(req::SRS_STS_020);
    guard.Restart(kSetup, memory);
    EXPECT_TRUE(guard.IsUsable());
    EXPECT_EQ(guard.Check(memory), SliceResult::kPassed);
    for (std::uint32_t bit = 0U; bit < 128U; ++bit)
    {
        const hal::Address place = 0x10000U + (4U * (bit / 32U));
        const std::uint32_t word = memory.Read(place);
        memory.Write(place, word ^ (std::uint32_t{1U} << (bit % 32U)));
        EXPECT_EQ(guard.Check(memory), SliceResult::kFailed) << "bit " << bit;
        memory.Write(place, word);
    }
    EXPECT_EQ(guard.Check(memory), SliceResult::kPassed);
    EXPECT_EQ(guard.Done(), 130U);
    // The fifth word is no guard word
    memory.Write(0x10010U, 0U);
    EXPECT_EQ(guard.Check(memory), SliceResult::kPassed);
}

TEST_F(StackGuardTest, HighWaterMarkIsTheDeepestWordEverUsed)
{
    Verifies(req::SRS_STS_020);
    guard.Restart(kSetup, memory);
    EXPECT_EQ(guard.HighWaterBytes(memory), 0U);
    // When a frame was 16 words deep, then the mark is there, whatever is above it
    memory.Write(0x11000U - 64U, 1U);
    EXPECT_EQ(guard.HighWaterBytes(memory), 64U);
    memory.Write(0x11000U - 4U, 1U);
    EXPECT_EQ(guard.HighWaterBytes(memory), 64U);
    // When everything but the guard was used
    memory.Write(0x10010U, 1U);
    EXPECT_EQ(guard.HighWaterBytes(memory), 4080U);
}

TEST_F(StackGuardTest, StackInUseIsFilledUpToAReachBelowItsPosition)
{
    Verifies(req::SRS_STS_020);
    // Given a stack that is running 512 bytes below its near end
    memory.stack_position = 0x11000U - 512U;
    guard.Restart(kSetup, memory);
    // Then what is nearer than 2048 bytes to that was not touched
    EXPECT_EQ(guard.HighWaterBytes(memory), 2560U);
    EXPECT_EQ(memory.Read(0x11000U - 2560U), 0U);
    EXPECT_EQ(guard.Check(memory), SliceResult::kPassed);
    // and a byte nearer is a word more
    memory.stack_position = 0x11000U - 511U;
    guard.Restart(kSetup, memory);
    EXPECT_EQ(guard.HighWaterBytes(memory), 2556U);
    // Given that it runs at its first and its last byte
    memory.stack_position = 0x10000U;
    cells.Write(0x10000U, 0U);
    guard.Restart(kSetup, memory);
    EXPECT_EQ(guard.Check(memory), SliceResult::kFailed);
    memory.stack_position = 0x11000U;
    guard.Restart(kSetup, memory);
    EXPECT_EQ(guard.HighWaterBytes(memory), 0U);
}

TEST_F(StackGuardTest, WhatCannotBeUsedFails)
{
    Verifies(req::SRS_STS_020);
    Verifies(req::SRS_STS_210);
    // Given zero-filled memory instead of a started guard
    EXPECT_FALSE(guard.IsUsable());
    EXPECT_EQ(guard.Check(memory), SliceResult::kFailed);
    // Given an unaligned area, no guard word, nothing but guard words
    for (const StackSetup& setup :
         {StackSetup{{0x10002U, 8U}, 4U}, StackSetup{{0x10000U, 8U}, 0U}, StackSetup{{0x10000U, 4U}, 4U}})
    {
        guard.Restart(setup, memory);
        EXPECT_FALSE(guard.IsUsable());
        EXPECT_EQ(guard.Check(memory), SliceResult::kFailed);
    }
    EXPECT_EQ(memory.Read(0x10000U), 0U);
    // Given guard words that an earlier start has left, then they save nothing
    guard.Restart(kSetup, memory);
    EXPECT_EQ(guard.Check(memory), SliceResult::kPassed);
    guard.Restart(StackSetup{{0x10000U, 4U}, 4U}, memory);
    EXPECT_EQ(guard.Check(memory), SliceResult::kFailed);
}

TEST_F(StackGuardTest, SameBitOfTwoGuardWordsIsFound)
{
    Verifies(req::SRS_STS_020);
    guard.Restart(kSetup, memory);
    memory.Write(0x10004U, memory.Read(0x10004U) ^ 1U);
    memory.Write(0x1000CU, memory.Read(0x1000CU) ^ 1U);
    EXPECT_EQ(guard.Check(memory), SliceResult::kFailed);
}

} // namespace
} // namespace counterpoint::selftest
