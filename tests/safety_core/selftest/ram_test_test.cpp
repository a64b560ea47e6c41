// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/selftest/ram_test.hpp"

#include "hal/host/memory.hpp"
#include "tests/safety_core/selftest/support.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace counterpoint::selftest
{
namespace
{

/// Sixteen words at 1000h with content, in slices of five.
class RamTestTest : public ::testing::Test
{
  protected:
    RamTestTest()
    {
        for (std::uint32_t word = 0U; word < 16U; ++word)
        {
            cells.Write(0x1000U + (4U * word), 0xC0DE'0000U + word);
        }
        Restart(5U);
    }
    void Restart(const std::uint8_t slice_words)
    {
        test.Restart(RamSetup{{spans.data(), static_cast<std::uint8_t>(spans.size())}, &workspace, slice_words});
    }
    std::uint32_t Slices()
    {
        return test.SlicesAPass(ports);
    }
    std::uint32_t SlicesOf(const hal::MemorySpan& span, const std::uint8_t slice_words)
    {
        spans = {span};
        Restart(slice_words);
        return Slices();
    }
    bool IsAsItWas() const
    {
        for (std::uint32_t word = 0U; word < 16U; ++word)
        {
            if (cells.Read(0x1000U + (4U * word)) != (0xC0DE'0000U + word))
            {
                return false;
            }
        }
        return true;
    }
    void TestLiveStack();

    std::vector<hal::MemorySpan> spans{{0x1000U, 16U}};
    host::ArrayMemory cells{0x1000U, 16U};
    PlacedMemory memory{cells, 0x8000'0000U};
    WatchedLock lock{};
    RamPorts ports{memory, lock};
    RamWorkspace workspace{};
    RamTest test{};
};

// Windows of five words at word 0, 4, 8 and four at 12; lines 4, 8, 16, 32.
TEST_F(RamTestTest, PassIsWindowsThatShareAWordAndThenTheLines)
{
    Verifies(req::SRS_STS_011);
    EXPECT_EQ(Slices(), 8U);
    for (std::uint32_t pass = 0U; pass < 2U; ++pass)
    {
        for (std::uint32_t slice = 0U; slice < 7U; ++slice)
        {
            EXPECT_EQ(test.Slice(ports), SliceResult::kContinues) << slice;
        }
        EXPECT_EQ(test.Slice(ports), SliceResult::kPassed);
    }
    EXPECT_EQ(test.Done(), 16U);
    EXPECT_EQ(test.LeftOut(), 0U);
    EXPECT_TRUE(IsAsItWas());
}

TEST_F(RamTestTest, RestartBeginsAPassAnew)
{
    Verifies(req::SRS_STS_011);
    // Given a pass that has come to its second line, when it is started again, then it is eight slices again
    for (std::uint32_t slice = 0U; slice < 5U; ++slice)
    {
        EXPECT_EQ(test.Slice(ports), SliceResult::kContinues);
    }
    Restart(5U);
    for (std::uint32_t slice = 0U; slice < 7U; ++slice)
    {
        EXPECT_EQ(test.Slice(ports), SliceResult::kContinues) << slice;
    }
    EXPECT_EQ(test.Slice(ports), SliceResult::kPassed);
    // Given one that has come to its second span, then it begins with the first one
    spans = {{0x1000U, 1U}, {0x1010U, 2U}};
    Restart(2U);
    EXPECT_EQ(test.Slice(ports), SliceResult::kContinues);
    Restart(2U);
    EXPECT_EQ(test.Slice(ports), SliceResult::kContinues);
    EXPECT_EQ(test.Slice(ports), SliceResult::kContinues);
    EXPECT_EQ(test.Slice(ports), SliceResult::kPassed);
}

TEST_F(RamTestTest, NumberOfSlices)
{
    Verifies(req::SRS_STS_011);
    EXPECT_EQ(SlicesOf({0x1000U, 1U}, 5U), 1U); // no line leads anywhere
    EXPECT_EQ(SlicesOf({0x1000U, 2U}, 2U), 2U); // line 4
    EXPECT_EQ(SlicesOf({0x1000U, 3U}, 2U), 4U); // words 01 12; lines 4, 8
    EXPECT_EQ(SlicesOf({0x1004U, 2U}, 5U), 1U); // 4 and 8 differ in two lines
    EXPECT_EQ(SlicesOf({0x1004U, 3U}, 5U), 3U); // 8 12 by line 4, 4 12 by line 8
    EXPECT_EQ(SlicesOf({0x1000U, 5U}, 5U), 4U); // lines 4, 8, 16
    EXPECT_EQ(SlicesOf({0x1000U, 6U}, 5U), 5U); // windows at 0 and 4
    EXPECT_EQ(SlicesOf({0x1000U, 16U}, 16U), 5U);
    // Two spans add up
    spans = {{0x1000U, 1U}, {0x1010U, 2U}};
    Restart(2U);
    EXPECT_EQ(Slices(), 3U);
    EXPECT_EQ(test.Slice(ports), SliceResult::kContinues);
    EXPECT_EQ(test.Slice(ports), SliceResult::kContinues);
    EXPECT_EQ(test.Slice(ports), SliceResult::kPassed);
}

TEST_F(RamTestTest, InterruptsAreLockedOnceASliceAndSeeNoPattern)
{
    Verifies(req::SRS_STS_012);
    // Given somebody who looks at the memory at each moment at which interrupts are possible
    std::uint32_t moments = 0U;
    lock.moment = [this, &moments]
    {
        ++moments;
        EXPECT_TRUE(IsAsItWas());
    };
    memory.lock = &lock;
    // When a pass is done, then interrupts were locked once a slice
    for (std::uint32_t slice = 0U; slice < 8U; ++slice)
    {
        static_cast<void>(test.Slice(ports));
        EXPECT_EQ(lock.locks, slice + 1U);
        EXPECT_FALSE(lock.is_locked);
    }
    EXPECT_EQ(moments, 16U);
    // and from the first word that was saved to the last one that was read back
    EXPECT_GT(memory.accesses, 0U);
    EXPECT_EQ(memory.unlocked, 0U);
}

TEST_F(RamTestTest, EffortDoesNotDependOnWhatIsFound)
{
    Verifies(req::SRS_STS_215);
    // Given sound cells and cells with a stuck bit
    host::DefectiveMemory counted(cells);
    const RamPorts counted_ports{counted, lock};
    static_cast<void>(test.Slice(counted_ports));
    const std::uint64_t sound = counted.Accesses();
    // Then a word takes 13 accesses: 2 save, 8 march, 2 back, 1 read; the four that the next window does not share 38
    // more for the backgrounds
    EXPECT_EQ(sound, (5U * 13U) + (4U * 38U));
    counted.Break({host::CellDefect::kStuckAtOne, {0x1000U, 0U}, {0x1000U, 0U}});
    Restart(5U);
    EXPECT_EQ(test.Slice(counted_ports), SliceResult::kFailed);
    EXPECT_EQ(counted.Accesses() - sound, sound);
    // and the pair of a line no background
    for (std::uint32_t slice = 1U; slice < 4U; ++slice)
    {
        static_cast<void>(test.Slice(counted_ports));
    }
    const std::uint64_t windows = counted.Accesses();
    static_cast<void>(test.Slice(counted_ports));
    EXPECT_EQ(counted.Accesses() - windows, 2U * 13U);
}

TEST_F(RamTestTest, WindowsNearTheStackPositionAreLeftOutAndCounted)
{
    Verifies(req::SRS_STS_013);
    // Given windows of two words; the first one is at 1000h to 1007h
    const auto is_left_out = [this](const hal::Address stack)
    {
        memory.stack_position = stack;
        Restart(2U);
        const std::uint32_t locks = lock.locks;
        EXPECT_EQ(test.Slice(ports), SliceResult::kContinues);
        EXPECT_EQ(lock.locks - locks, 1U - test.LeftOut());
        return test.LeftOut() == 1U;
    };
    // Then it is tested when the stack is more than 2048 bytes above its last or below its first word
    EXPECT_FALSE(is_left_out(0x1805U));
    EXPECT_TRUE(is_left_out(0x1804U));
    EXPECT_TRUE(is_left_out(0x1000U));
    EXPECT_TRUE(is_left_out(0x0801U));
    EXPECT_TRUE(is_left_out(0x0800U));
    EXPECT_FALSE(is_left_out(0x07FFU));
    EXPECT_FALSE(is_left_out(0x07FCU));
}

void RamTestTest::TestLiveStack()
{
    // Given the stack that is running, from 16 KiB below to 4 KiB above
    const auto live_memory = std::make_unique<host::HostMemory>();
    host::HostMemory& live = *live_memory;
    const RamPorts live_ports{live, lock};
    const hal::Address position = live.StackPosition();
    spans = {{(position & ~hal::Address{3U}) - 16384U, 5120U}};
    Restart(5U);
    const std::uint32_t slices = test.SlicesAPass(live_ports);
    EXPECT_GE(slices, 1280U);
    volatile std::uint32_t local[4] = {1U, 2U, 3U, 4U};
    // When a pass goes over it
    std::uint32_t failures = 0U;
    SliceResult result = SliceResult::kInvalid;
    for (std::uint32_t slice = 0U; slice < slices; ++slice)
    {
        result = test.Slice(live_ports);
        failures += (result == SliceResult::kFailed) ? 1U : 0U;
    }
    // Then all is well and as it was, and what was in reach of the running calls was left out
    EXPECT_EQ(failures, 0U);
    EXPECT_EQ(result, SliceResult::kPassed);
    EXPECT_EQ(local[0] + (10U * local[1]) + (100U * local[2]) + (1000U * local[3]), 4321U);
    EXPECT_GE(test.LeftOut(), 256U);
    EXPECT_LE(test.LeftOut(), 270U);
}

/// Calls `then` far below the stack's end, so that what is looked at above it is stack as well.
void CallDeep(const std::uint32_t levels, const std::function<void()>& then)
{
    if (levels == 0U)
    {
        then();
        return;
    }
    volatile std::uint32_t left = levels - 1U;
    CallDeep(left, then);
    left = 0U;
}

/// Uses the stack far beyond what the test looks at, so that the system has given it memory there.
void UseStackBelow()
{
    CallDeep(4096U, [] {});
}

TEST_F(RamTestTest, LiveStackOfThisThreadIsTestedWithoutHarm)
{
    Verifies(req::SRS_STS_010);
    Verifies(req::SRS_STS_013);
    UseStackBelow();
    CallDeep(256U, [this] { TestLiveStack(); });
}

TEST_F(RamTestTest, WhatCannotBeUsedHasNoSlices)
{
    Verifies(req::SRS_STS_210);
    EXPECT_EQ(SlicesOf({0x1000U, 0U}, 5U), 0U);
    EXPECT_EQ(SlicesOf({0x1000U, 0x0100'0001U}, 5U), 0U);
    EXPECT_EQ(SlicesOf({0x1000U, 0x0100'0000U}, 5U), 4194328U); // 4194304 windows, lines 4 to 2^25
    EXPECT_EQ(SlicesOf({0x1002U, 4U}, 5U), 0U);
    EXPECT_EQ(SlicesOf({0x1000U, 4U}, 1U), 0U);
    EXPECT_EQ(SlicesOf({0x1000U, 4U}, 17U), 0U);
    spans.clear();
    Restart(5U);
    EXPECT_EQ(Slices(), 0U);
    spans = {{0x1000U, 4U}};
    test.Restart(RamSetup{{spans.data(), 1U}, nullptr, 5U});
    EXPECT_EQ(Slices(), 0U);
}

TEST_F(RamTestTest, SpanWithItsOwnStateIsRefused)
{
    Verifies(req::SRS_STS_013);
    // Given a test with other words on both sides of it, in the memory of this process
    struct Neighbourhood
    {
        std::array<std::uint64_t, 2> before;
        RamTest own;
        std::array<std::uint64_t, 2> after;
    };
    Neighbourhood hood{};
    host::HostMemory live;
    const RamPorts live_ports{live, lock};
    const auto slices = [&](const hal::Address first, const std::uint32_t words)
    {
        spans = {{first, words}};
        hood.own.Restart(RamSetup{{spans.data(), 1U}, &workspace, 5U});
        return hood.own.SlicesAPass(live_ports);
    };
    const hal::Address own = live.PlaceOf(&hood.own);
    const hal::Address behind = own + sizeof(RamTest);
    // Then a span may end before the test itself and begin after it, and not hold any of it
    EXPECT_EQ(slices(own - 8U, 2U), 2U);
    EXPECT_EQ(slices(own - 8U, 3U), 0U);
    EXPECT_EQ(slices(behind - 4U, 1U), 0U);
    EXPECT_EQ(slices(behind, 1U), 1U);
    EXPECT_EQ(slices(own, 1U), 0U);
    EXPECT_EQ(slices(live.PlaceOf(&workspace), 1U), 0U);
    EXPECT_EQ(slices(live.PlaceOf(&live), 1U), 0U);
    EXPECT_EQ(slices(live.PlaceOf(&lock), 1U), 0U);
    std::array<std::uint32_t, 4> other{};
    EXPECT_NE(slices(live.PlaceOf(other.data()), 4U), 0U);
}

TEST_F(RamTestTest, TwoTestsTestEachOther)
{
    Verifies(req::SRS_STS_013);
    // Given a second test whose span is the first one and its workspace
    host::HostMemory live;
    const RamPorts live_ports{live, lock};
    const std::array<hal::MemorySpan, 2> others{hal::MemorySpan{live.PlaceOf(&test), sizeof(RamTest) / 4U},
                                                hal::MemorySpan{live.PlaceOf(&workspace), sizeof(RamWorkspace) / 4U}};
    RamTest second;
    RamWorkspace second_workspace{};
    second.Restart(RamSetup{{others.data(), 2U}, &second_workspace, 5U});
    const std::uint32_t slices = second.SlicesAPass(live_ports);
    ASSERT_NE(slices, 0U);
    // When they take turns, then both pass
    SliceResult last = SliceResult::kInvalid;
    for (std::uint32_t slice = 0U; slice < slices; ++slice)
    {
        EXPECT_NE(test.Slice(ports), SliceResult::kFailed);
        last = second.Slice(live_ports);
        EXPECT_NE(last, SliceResult::kFailed);
    }
    EXPECT_EQ(last, SliceResult::kPassed);
    EXPECT_EQ(second.Done(), slices);
    EXPECT_EQ(test.Done(), slices);
}

TEST_F(RamTestTest, PositionOutsideOfTheSpansIsNotTouched)
{
    Verifies(req::SRS_STS_010);
    // Given zero-filled memory instead of a started test, then it fails
    RamTest zero;
    EXPECT_EQ(zero.Slice(ports), SliceResult::kFailed);
    // Given a position at word 4
    EXPECT_EQ(test.Slice(ports), SliceResult::kContinues);
    // When the span's length is corrupted to four words, then the test fails and nothing was touched
    spans[0].words = 4U;
    EXPECT_EQ(test.Slice(ports), SliceResult::kFailed);
    EXPECT_EQ(lock.locks, 1U);
}

} // namespace
} // namespace counterpoint::selftest
