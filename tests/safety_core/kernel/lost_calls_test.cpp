// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What a lost call or a changed address leaves undone, or does elsewhere.
#include "tests/safety_core/kernel/mark_tap.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace counterpoint
{
namespace
{

class LostCalls : public Rig
{
};

TEST_F(LostCalls, FrameThatIsNotHandedOverIsAWrongFlow)
{
    Verifies(req::SRS_KRN_034);
    Operate();
    ReceivePair();
    Cycle();
    ASSERT_EQ(Open(), 1U);
    ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    // When a cycle comes while a frame is not yet with both channels
    b.on_frame = [this]() { Cycle(); };
    Receive(0x700U, {1U});
    b.on_frame = nullptr;
    // Then that cycle's flow is wrong, and nothing stays open
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kFlow);
    EXPECT_EQ(kernel.DeviceState().slot, kNoSlot);
    Cycle();
    EXPECT_EQ(Open(), 0U);
}

// Both channels are handed one frame: what is wrong in it on the way is wrong in both.
TEST_F(LostCalls, FrameThatBecomesAnotherOneOnTheWayIsAWrongFlow)
{
    Verifies(req::SRS_KRN_034);
    Operate();
    ReceivePair();
    Cycle();
    ASSERT_EQ(Open(), 1U);
    // When a GFC comes, and what the channels were handed is frame 101h
    StampedFrame frame{};
    frame.frame.identifier = 0x001U;
    frame.frame.kind = FrameKind::kData;
    frame.stamp = {Instant{now_us}, Instant{now_us}};
    b.on_frame = [&frame]() { frame.frame.identifier = 0x101U; };
    kernel.OnFrame(frame);
    b.on_frame = nullptr;
    Cycle();
    // Then the flow of the next cycle is wrong, and nothing stays open
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kFlow);
    Cycle();
    EXPECT_EQ(Open(), 0U);
}

TEST_F(LostCalls, FramesBeforeStartAreForgotten)
{
    Verifies(req::SRS_KRN_034);
    for (std::uint32_t frame = 0U; frame < 3U; ++frame)
    {
        Receive(0x001U, {});
    }
    Operate();
    ReceivePair();
    Cycles(2U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    EXPECT_EQ(Open(), 1U);
}

/// Where the kernel keeps the addresses of its parts.
class PartsOfTheKernel : public Rig
{
  protected:
    explicit PartsOfTheKernel(FlowWatch* const flow = nullptr) : Rig{nullptr, flow}
    {
    }

    static constexpr std::size_t kParts = 9U;
    /// Of each address: on the target all of them, and on the host the same number of runs.
    static constexpr std::size_t kBytes = 4U;

    /// The first place where both channels stand one behind the other.
    std::size_t FirstByte() const
    {
        const Channel* const channels[] = {&a, &b};
        const std::uint8_t* const bytes = reinterpret_cast<const std::uint8_t*>(&kernel);
        std::size_t place = 0U;
        while ((place < (sizeof(Kernel) - sizeof channels)) &&
               (std::memcmp(&bytes[place], &channels[0], sizeof channels) != 0))
        {
            place += sizeof(void*);
        }
        return place;
    }
    void Flip(const std::size_t place, const std::uint32_t bit)
    {
        std::uint8_t* const bytes = reinterpret_cast<std::uint8_t*>(&kernel);
        bytes[place] = static_cast<std::uint8_t>(bytes[place] ^ (1U << bit));
    }
    /// A released pair, then one changed bit.
    void FlipAndRun(std::size_t byte, std::uint32_t bit);
};

void PartsOfTheKernel::FlipAndRun(const std::size_t byte, const std::uint32_t bit)
{
    now_us += 2000U;
    watchdog.timer.Start(hal::WatchdogWindow{500U, 1600U}, Instant{now_us});
    Operate();
    ReceivePair();
    Cycle();
    ASSERT_EQ(Open(), 1U);
    ASSERT_TRUE(WatchdogAlive());
    std::uint32_t calls = 0U;
    a.on_outcome = [&calls](CycleOutcome&) { ++calls; };
    const std::uint32_t given = output.last.kernel.response;
    // When one bit changes
    Flip(byte, bit);
    Cycles(2U);
    // Then nothing is called, given or answered
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kSelfTest) << "byte " << byte << ", bit " << bit;
    EXPECT_EQ(kernel.DeviceState().slot, kNoSlot);
    EXPECT_EQ(calls, 0U);
    EXPECT_EQ(output.last.kernel.response, given);
    EXPECT_EQ(Open(), 0U);
    EXPECT_FALSE(WatchdogAlive());
    Flip(byte, bit);
    a.on_outcome = nullptr;
}

TEST_F(PartsOfTheKernel, AnyBitOfAnyAddressIsFoundBeforeAPartIsCalled)
{
    Verifies(req::SRS_KRN_035);
    const std::size_t first = FirstByte();
    ASSERT_TRUE(first < (sizeof(Kernel) - (kParts * sizeof(void*))));
    for (std::size_t part = 0U; part < kParts; ++part)
    {
        for (std::uint32_t bit = 0U; bit < (8U * kBytes); ++bit)
        {
            FlipAndRun(first + (part * sizeof(void*)) + (bit / 8U), bit % 8U);
        }
    }
}

// The address of the device description stands in two places: behind the seal of the parts, and in the guard.
TEST_F(PartsOfTheKernel, AnyBitOfTheAddressOfTheDescriptionIsFoundBeforeItIsUsed)
{
    Verifies(req::SRS_KRN_800);
    Operate();
    const DeviceConfig* const description = &config;
    std::uint8_t place[sizeof description];
    std::memcpy(place, &description, sizeof description);
    const std::uint8_t* const bytes = reinterpret_cast<const std::uint8_t*>(&kernel);
    const std::size_t first = FirstByte() + ((kParts + 1U) * sizeof description);
    ASSERT_EQ(std::memcmp(&bytes[first], place, sizeof description), 0);
    for (std::uint32_t bit = 0U; bit < (8U * kBytes); ++bit)
    {
        FlipAndRun(first + (bit / 8U), bit % 8U);
    }
}

/// The same with a part that is called before all others.
class PartsWithAFlowWatch : protected MarkTapHolder, public PartsOfTheKernel
{
  protected:
    PartsWithAFlowWatch() : PartsOfTheKernel{&flow}
    {
    }
};

TEST_F(PartsWithAFlowWatch, AreNotCalledBeforeTheAddressesWereExamined)
{
    Verifies(req::SRS_KRN_035);
    Verifies(req::SRS_KRN_039);
    const std::size_t first = FirstByte();
    ASSERT_TRUE(first < (sizeof(Kernel) - (kParts * sizeof(void*))));
    for (std::size_t part = 0U; part < kParts; ++part)
    {
        flow.begun = 0U;
        flow.ended = 0U;
        FlipAndRun(first + (part * sizeof(void*)), 3U);
        // Then the two cycles before the change were the last ones that the watch heard of
        EXPECT_EQ(flow.begun, 2U);
        EXPECT_EQ(flow.ended, 2U);
    }
}

} // namespace
} // namespace counterpoint
