// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/virtual/bus.hpp"
#include "tests/hal/host/allocations.hpp"
#include "tests/hal/host/bus_rig.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace counterpoint::host
{
namespace
{

class Counter final : public BusListener
{
  public:
    void OnReceived(const CanFrame& frame, const BusTime at) override
    {
        static_cast<void>(frame);
        static_cast<void>(at);
        ++received;
    }
    void OnConfirmed(const CanFrame& frame, const BusTime at) override
    {
        static_cast<void>(frame);
        static_cast<void>(at);
        ++confirmed;
    }

    std::uint32_t received{0U};
    std::uint32_t confirmed{0U};
};

TEST(BusCost, FramesCostNoMemory)
{
    Verifies(req::SRS_BUS_014);
    // Given three nodes
    VirtualBus bus(BitRate::k250k);
    Counter nodes[3];
    for (Counter& node : nodes)
    {
        static_cast<void>(bus.Attach(node, NodeSetup{CanPortId::kFirst, 8U}));
    }
    // When each sends a thousand frames, several of them waiting at a time
    const std::uint64_t before = Allocations();
    for (std::uint32_t round = 0U; round < 1'000U; ++round)
    {
        for (NodeIndex node = 0U; node < 3U; ++node)
        {
            const CanFrame frame = MakeFrame(static_cast<std::uint32_t>(0x101U + node), {0x12U, 0x34U});
            ASSERT_EQ(bus.Submit(node, frame), hal::TransmitStatus::kAccepted);
        }
        bus.Advance(static_cast<BusTime>(round + 1U) * 2 * kMillisecond);
    }
    const std::uint64_t after = Allocations();
    // Then all came through, and nothing was allocated
    EXPECT_EQ(nodes[0].confirmed, 1'000U);
    EXPECT_EQ(nodes[0].received, 2'000U);
    EXPECT_EQ(after - before, 0U);
}

TEST(BusCost, AllocationsAreCounted)
{
    Verifies(req::SRS_BUS_014);
    // Given the counter of allocations, when something is allocated, then it counts: the test before can fail
    const std::uint64_t before = Allocations();
    VirtualBus bus(BitRate::k250k);
    Counter node;
    static_cast<void>(bus.Attach(node, NodeSetup{CanPortId::kFirst, 8U}));
    EXPECT_GT(Allocations(), before);
}

TEST(BusCost, IdleBusOnlySetsTheTime)
{
    Verifies(req::SRS_BUS_014);
    // Given an idle bus with three nodes and an observer
    BusRig rig;
    // When it is advanced a million times
    for (BusTime step = 1; step <= 1'000'000; ++step)
    {
        rig.RunTo(step * kMillisecond);
    }
    // Then the time is set and nothing else has happened
    EXPECT_EQ(rig.bus.Now(), 1'000'000 * kMillisecond);
    EXPECT_EQ(rig.bus.NextEvent(), kNever);
    EXPECT_TRUE(rig.recorder.records.empty());
    EXPECT_TRUE(rig.listeners[0].received.empty());
}

} // namespace
} // namespace counterpoint::host
