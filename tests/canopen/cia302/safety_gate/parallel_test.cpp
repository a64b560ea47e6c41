// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Many safety slaves at the same time, each of which answers at once, never, or when it is told to.
#include "canopen/cia302/safety_gate/safety_gate.hpp"
#include "tests/hal/host/allocations.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint8_t kSlaves = 126U;

/// A consumer without entries, off.
constexpr ExpectedObject kObjects[] = {
    {{0x1300U, 0U}, 0U, false},     {{0x1301U, 1U}, 0U, false},   {{0x1301U, 2U}, 25U, false},
    {{0x1301U, 3U}, 20U, false},    {{0x1301U, 4U}, 254U, false}, {{0x1301U, 5U}, 0x101U, false},
    {{0x1301U, 6U}, 0x102U, false}, {{0x1381U, 0U}, 0U, false},   {{0x13FFU, 1U}, 0x1234U, false},
};
constexpr SafetyExpectation kExpectation{&kObjects[0], 9U};

/// Slaves 1 to 126 behind the pool of manager 127; the request of each waits here until it is answered.
class Slaves final : public cia301::FrameSink
{
  public:
    bool Send(const CanFrame& frame) noexcept override
    {
        const std::uint32_t node = frame.identifier - 0x600U;
        most_outstanding = std::max(most_outstanding, outstanding.at(node) + 1);
        ++outstanding.at(node);
        request.at(node) = frame;
        ++requests;
        return true;
    }

    std::array<CanFrame, kNodeRoom> request{};
    std::array<int, kNodeRoom> outstanding{};
    int most_outstanding{0};
    int requests{0};
};

class ParallelGateTest : public ::testing::Test
{
  protected:
    static std::array<SlaveSetup, kNodeRoom> SafetySlaves()
    {
        std::array<SlaveSetup, kNodeRoom> all{};
        for (std::uint8_t node = 1U; node <= kSlaves; ++node)
        {
            all.at(node).assignment = kInNetwork | kBootSlave;
            all.at(node).safety = &kExpectation;
        }
        return all;
    }
    [[nodiscard]] static std::uint64_t ValueOf(const ObjectAddress& object) noexcept
    {
        std::uint64_t value = 0xA5U; // 13FEh
        for (const ExpectedObject& each : kObjects)
        {
            const bool is_it = (each.address.index == object.index) && (each.address.sub == object.sub);
            value = is_it ? each.value : value;
        }
        return value;
    }
    /// The slave gets its answer, as expected.
    void Answer(const std::uint8_t node) noexcept
    {
        const CanFrame& asked = slaves.request.at(node);
        const ObjectAddress object{static_cast<std::uint16_t>(asked.data[1] | (asked.data[2] << 8U)), asked.data[3]};
        const std::uint8_t size = (object.index == 0x13FEU) ? std::uint8_t{1U} : SizeOf(object);
        CanFrame frame = asked;
        frame.identifier = 0x580U + node;
        frame.data[0] = static_cast<std::uint8_t>(0x43U | ((4U - size) << 2U));
        for (std::uint32_t byte = 0U; byte < 4U; ++byte)
        {
            frame.data[4U + byte] = static_cast<std::uint8_t>(ValueOf(object) >> (8U * byte));
        }
        --slaves.outstanding.at(node);
        pool.OnFrame(frame, Instant{now_us});
    }
    /// One millisecond; all slaves but this one answer what was asked before.
    void Pass(const std::uint8_t silent) noexcept
    {
        now_us += 1000U;
        for (std::uint8_t node = 1U; node <= kSlaves; ++node)
        {
            if ((node != silent) && (slaves.outstanding.at(node) > 0))
            {
                Answer(node);
            }
        }
        pool.OnCycle(Instant{now_us});
        gate.OnCycle(Instant{now_us});
    }
    [[nodiscard]] int Open() const noexcept
    {
        int open = 0;
        for (std::uint8_t node = 1U; node <= kSlaves; ++node)
        {
            open += (gate.State(NodeId{node}) == GateState::kOpen) ? 1 : 0;
        }
        return open;
    }
    /// Milliseconds until so many are open; 1000: they never are.
    [[nodiscard]] int Until(const int count, const std::uint8_t silent) noexcept
    {
        int ms = 0;
        while ((ms < 1000) && (Open() < count))
        {
            Pass(silent);
            ++ms;
        }
        return ms;
    }

    std::uint32_t now_us{0xFFFFF000U};
    std::array<SlaveSetup, kNodeRoom> setups{SafetySlaves()};
    NetworkSetup setup{NodeId{127U}, 1U, 0U, 0U, 0U, setups.data()};
    Slaves slaves{};
    SdoLanes<127U> lanes{slaves, SdoTimes{100000U, 3U}};
    SdoPool pool{lanes.All(), SdoTimes{100000U, 3U}};
    std::array<SafetySlot, kSlaves> slots{};
    SafetyGate gate{setup, SafetySlots{slots.data(), kSlaves}, pool};
};

TEST_F(ParallelGateTest, AllAreVerifiedInTheTimeOfOne)
{
    Verifies(req::SRS_SFS_008);
    // Given one slave
    gate.Verify(NodeId{7U}, Instant{now_us});
    const int alone = Until(1, 0U);
    EXPECT_LT(alone, 100);
    // When all are verified, then it takes no longer
    for (std::uint8_t node = 1U; node <= kSlaves; ++node)
    {
        gate.Close(NodeId{node});
        gate.Verify(NodeId{node}, Instant{now_us});
    }
    ASSERT_EQ(Open(), 0);
    EXPECT_EQ(Until(kSlaves, 0U), alone);
    // And each was asked for one thing at a time
    EXPECT_EQ(slaves.most_outstanding, 1);
    EXPECT_EQ(slaves.requests, (kSlaves + 1) * 12);
}

TEST_F(ParallelGateTest, ASilentSlaveHoldsUpNoOther)
{
    Verifies(req::SRS_SFS_008);
    gate.Verify(NodeId{7U}, Instant{now_us});
    const int alone = Until(1, 0U);
    for (std::uint8_t node = 1U; node <= kSlaves; ++node)
    {
        gate.Close(NodeId{node});
        gate.Verify(NodeId{node}, Instant{now_us});
    }
    // Given one that answers nothing, then the others are verified meanwhile
    EXPECT_EQ(Until(kSlaves - 1, 9U), alone);
    EXPECT_EQ(gate.State(NodeId{9U}), GateState::kBusy);
    // And it fails behind three tries of 100 ms
    for (int ms = 0; ms < 310; ++ms)
    {
        Pass(9U);
    }
    EXPECT_EQ(gate.State(NodeId{9U}), GateState::kFailed);
    EXPECT_EQ(Open(), kSlaves - 1);
}

TEST_F(ParallelGateTest, NeitherWaitsNorTakesHeap)
{
    Verifies(req::SRS_SFS_120);
    // Given the counter of allocations, when something is allocated, then it counts: the test below can fail
    const std::uint64_t before = host::Allocations();
    ::operator delete(::operator new(4U));
    ASSERT_EQ(host::Allocations(), before + 1U);
    // Given slaves that answer nothing, then each call ends all the same, and leaves them busy
    for (std::uint8_t node = 1U; node <= kSlaves; ++node)
    {
        gate.Verify(NodeId{node}, Instant{now_us});
    }
    gate.OnCycle(Instant{now_us});
    EXPECT_EQ(gate.State(NodeId{1U}), GateState::kBusy);
    EXPECT_EQ(gate.State(NodeId{kSlaves}), GateState::kBusy);
    // And given all that they are verified with, then nothing was allocated
    for (int ms = 0; ms < 100; ++ms)
    {
        Pass(3U);
    }
    EXPECT_EQ(Open(), kSlaves - 1);
    EXPECT_EQ(host::Allocations(), before + 1U);
}

} // namespace
} // namespace counterpoint::cia302
