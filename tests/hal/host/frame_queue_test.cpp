// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/frame_queue.hpp"
#include "tests/hal/host/bus_rig.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace counterpoint::host
{
namespace
{

/// Writes down what comes out: F101, C102, and O for an overflow.
class Writer final : public FrameSink
{
  public:
    void OnFrame(const StampedFrame& frame) override
    {
        text += " F" + std::to_string(frame.frame.identifier) + "@" + std::to_string(frame.stamp.a.us);
    }
    void OnConfirm(const StampedFrame& frame) override
    {
        text += " C" + std::to_string(frame.frame.identifier) + "@" + std::to_string(frame.stamp.a.us);
    }
    void OnOverflow() override
    {
        text += " O";
    }

    std::string text{};
};

StampedFrame At(const std::uint32_t identifier, const std::uint32_t us)
{
    return StampedFrame{MakeFrame(identifier, {}), InstantPair{Instant{us}, Instant{us}}};
}

TEST(FrameQueue, HandsOverFramesAndConfirmationsInBusOrder)
{
    Verifies(req::SRS_HAL_015);
    // Given received and confirmed frames in turn
    FrameQueue queue(4U);
    queue.OnFrame(At(1U, 10U));
    queue.OnConfirm(At(2U, 20U));
    queue.OnFrame(At(3U, 30U));
    EXPECT_EQ(queue.Size(), 3U);
    // When it is drained
    Writer writer;
    queue.Drain(writer);
    // Then they come as they went in, once
    EXPECT_EQ(writer.text, " F1@10 C2@20 F3@30");
    queue.Drain(writer);
    EXPECT_EQ(writer.text, " F1@10 C2@20 F3@30");
}

TEST(FrameQueue, LostFrameIsReportedBeforeTheNextFrame)
{
    Verifies(req::SRS_HAL_015);
    // Given a queue of two that is full
    FrameQueue queue(2U);
    queue.OnFrame(At(1U, 10U));
    queue.OnConfirm(At(2U, 20U));
    // When one more comes
    queue.OnFrame(At(3U, 30U));
    // Then it is lost and that is told first
    Writer writer;
    queue.Drain(writer);
    EXPECT_EQ(writer.text, " O F1@10 C2@20");
    // and told once; the queue works on around its end
    queue.OnConfirm(At(4U, 40U));
    queue.OnFrame(At(5U, 50U));
    queue.Drain(writer);
    EXPECT_EQ(writer.text, " O F1@10 C2@20 C4@40 F5@50");
}

TEST(FrameQueue, OverflowOfASourceIsPassedOn)
{
    Verifies(req::SRS_HAL_015);
    // Given a source that lost frames itself, when drained, then that is told
    FrameQueue queue(2U);
    queue.OnOverflow();
    Writer writer;
    queue.Drain(writer);
    EXPECT_EQ(writer.text, " O");
}

} // namespace
} // namespace counterpoint::host
