// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/zynqmp/link/shared_link.hpp"

#include "verification/trace/ids/zynqmp.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

namespace counterpoint::zynqmp
{
namespace
{

constexpr std::uint16_t kBytes = hal::kLinkFrameBytes;

/// Each byte tells the number of the frame and its own place, so that no two frames have a byte in common.
std::uint8_t ByteOf(const std::uint32_t number, const std::uint32_t place)
{
    return static_cast<std::uint8_t>((number * 7U) + place);
}

hal::LinkFrame Frame(const std::uint32_t number)
{
    hal::LinkFrame frame{};
    frame.length = kBytes;
    for (std::uint32_t place = 0U; place < kBytes; ++place)
    {
        frame.bytes[place] = ByteOf(number, place);
    }
    return frame;
}

bool IsWhole(const hal::LinkFrame& frame)
{
    bool is_whole = frame.length == kBytes;
    for (std::uint32_t place = 0U; place < kBytes; ++place)
    {
        is_whole = is_whole && (frame.bytes[place] == static_cast<std::uint8_t>(frame.bytes[0] + place));
    }
    return is_whole;
}

class SharedLinkTest : public ::testing::Test
{
  protected:
    /// First byte of the next frame, -1 if there is none.
    static int Received(SharedLink& link)
    {
        hal::LinkFrame frame{};
        return (link.Receive(frame) == hal::LinkStatus::kDone) ? frame.bytes[0] : -1;
    }
    static void Send(SharedLink& link, const std::uint32_t number)
    {
        EXPECT_EQ(link.Send(Frame(number)), hal::LinkStatus::kDone);
    }

    LinkMailbox to_b{};
    LinkMailbox to_a{};
    SharedLink a{to_b, to_a};
    SharedLink b{to_a, to_b};
};

// Given a link, when each side sends, then the other one receives it once, with all of its bytes.
TEST_F(SharedLinkTest, CarriesAFrameInEachDirection)
{
    Verifies(req::SRS_ZYN_010);
    EXPECT_EQ(Received(b), -1);
    Send(a, 1U);
    hal::LinkFrame frame{};
    ASSERT_EQ(b.Receive(frame), hal::LinkStatus::kDone);
    EXPECT_EQ(frame.length, 188U);
    EXPECT_EQ(frame.bytes[0], 7U);
    EXPECT_EQ(frame.bytes[1], 8U);
    EXPECT_EQ(frame.bytes[187], 194U);
    EXPECT_EQ(Received(b), -1);
    EXPECT_EQ(Received(a), -1);
    Send(b, 2U);
    EXPECT_EQ(Received(a), 14);
    EXPECT_EQ(Received(a), -1);
}

// Given a frame of one byte, of none and of too many, then only the first one is sent.
TEST_F(SharedLinkTest, SendsPossibleLengthsAlone)
{
    Verifies(req::SRS_ZYN_010);
    hal::LinkFrame frame = Frame(3U);
    frame.length = 1U;
    EXPECT_EQ(a.Send(frame), hal::LinkStatus::kDone);
    frame.length = 0U;
    EXPECT_EQ(a.Send(frame), hal::LinkStatus::kNothing);
    frame.length = 189U;
    EXPECT_EQ(a.Send(frame), hal::LinkStatus::kNothing);
    ASSERT_EQ(b.Receive(frame), hal::LinkStatus::kDone);
    EXPECT_EQ(frame.length, 1U);
    EXPECT_EQ(frame.bytes[0], 21U);
    EXPECT_EQ(Received(b), -1);
}

// Given a reader that does not read, when six frames are sent, then all six are sent, it finds the newest four in
// their order, and two are counted as lost.
TEST_F(SharedLinkTest, OverwritesTheOldest)
{
    Verifies(req::SRS_ZYN_010);
    Verifies(req::SRS_ZYN_012);
    for (std::uint32_t number = 1U; number <= 6U; ++number)
    {
        Send(a, number);
    }
    EXPECT_EQ(Received(b), 21);
    EXPECT_EQ(Received(b), 28);
    EXPECT_EQ(Received(b), 35);
    EXPECT_EQ(Received(b), 42);
    EXPECT_EQ(Received(b), -1);
    EXPECT_EQ(b.Losses().overwritten, 2U);
    EXPECT_EQ(b.Losses().torn, 0U);
}

// Given a frame that the writer has begun anew, not ended, or given an impossible length, then it is not received but
// counted, and the next one is.
TEST_F(SharedLinkTest, RefusesTornFrames)
{
    Verifies(req::SRS_ZYN_011);
    Send(a, 1U);
    to_b.slots[1].begun.Store(5U);
    EXPECT_EQ(Received(b), -1);
    EXPECT_EQ(b.Losses().torn, 1U);
    Send(a, 2U);
    to_b.slots[2].ended.Store(0xFFFFFFFEU);
    Send(a, 3U);
    EXPECT_EQ(Received(b), 21);
    EXPECT_EQ(b.Losses().torn, 2U);
    Send(a, 4U);
    to_b.slots[0].length.Store(0U);
    Send(a, 5U);
    to_b.slots[1].length.Store(0x000100BCU);
    EXPECT_EQ(Received(b), -1);
    EXPECT_EQ(b.Losses().torn, 4U);
    EXPECT_EQ(b.Losses().overwritten, 0U);
}

// Given frames from before a reset of the reader, then a new link does not receive them; after a reset of the writer
// what it sends is received.
TEST_F(SharedLinkTest, BeginsWithWhatComesNext)
{
    Verifies(req::SRS_ZYN_012);
    Send(a, 1U);
    Send(a, 2U);
    SharedLink anew{to_a, to_b};
    EXPECT_EQ(Received(anew), -1);
    SharedLink writer{to_b, to_a};
    Send(writer, 3U);
    EXPECT_EQ(Received(anew), 21);
    EXPECT_EQ(Received(anew), -1);
    EXPECT_EQ(anew.Losses().overwritten, 0U);
}

// Given memory full of ones, as nobody wrote it, then nothing is received from it, and the first frame is.
TEST_F(SharedLinkTest, BeginsOnMemoryThatNobodyWrote)
{
    Verifies(req::SRS_ZYN_012);
    LinkMailbox wild{};
    wild.newest.Store(0xFFFFFFFFU);
    for (LinkSlot& slot : wild.slots)
    {
        slot.begun.Store(0xFFFFFFFFU);
        slot.ended.Store(0xFFFFFFFFU);
        slot.length.Store(0xFFFFFFFFU);
    }
    SharedLink writer{wild, to_a};
    SharedLink reader{to_a, wild};
    EXPECT_EQ(Received(reader), -1);
    Send(writer, 1U); // Number 0, after the greatest one.
    EXPECT_EQ(Received(reader), 7);
    EXPECT_EQ(Received(reader), -1);
}

// Given a number of the newest frame that a fault changed, then no frame comes from it, and those that are sent after
// it do.
TEST_F(SharedLinkTest, GoesOnBehindAChangedNumber)
{
    Verifies(req::SRS_ZYN_010); // Four of two thousand million are looked at.
    Verifies(req::SRS_ZYN_012);
    Send(a, 1U);
    EXPECT_EQ(Received(b), 7);
    to_b.newest.Store(0x80000001U);
    EXPECT_EQ(Received(b), -1);
    EXPECT_EQ(b.Losses().torn, 4U);
    EXPECT_EQ(b.Losses().overwritten, 0x7FFFFFFCU);
    Send(a, 2U);
    EXPECT_EQ(Received(b), 7); // Again: an old one is for the message's sequence to refuse.
    EXPECT_EQ(Received(b), 14);
    EXPECT_EQ(Received(b), -1);
    EXPECT_EQ(b.Losses().overwritten, 0xFFFFFFF9U);
}

// Given a writer and a reader at the same time, then whatever is received is whole, and the last frame comes at last.
TEST_F(SharedLinkTest, GivesWholeFramesWhileTheOtherSideWrites)
{
    Verifies(req::SRS_ZYN_011);
    constexpr std::uint32_t kFrames = 50000U;
    std::atomic<bool> is_over{false};
    std::thread writer{[this, &is_over]
                       {
                           for (std::uint32_t number = 1U; number <= kFrames; ++number)
                           {
                               static_cast<void>(a.Send(Frame(number)));
                           }
                           is_over = true;
                       }};
    std::uint32_t broken = 0U;
    std::uint32_t received = 0U;
    std::uint8_t last = 0U;
    bool is_last_look = false;
    while (!is_last_look)
    {
        is_last_look = is_over;
        hal::LinkFrame frame{};
        while (b.Receive(frame) == hal::LinkStatus::kDone)
        {
            broken += IsWhole(frame) ? 0U : 1U;
            last = frame.bytes[0];
            ++received;
        }
    }
    writer.join();
    EXPECT_EQ(broken, 0U);
    EXPECT_EQ(last, ByteOf(kFrames, 0U));
    const LinkLosses losses = b.Losses();
    EXPECT_EQ(received + losses.torn + losses.overwritten, kFrames);
}

} // namespace
} // namespace counterpoint::zynqmp
