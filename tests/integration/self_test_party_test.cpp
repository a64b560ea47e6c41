// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The self test as a party: not called, frozen, always good. Both shipped channels, the shipped kernel, the rule of the
// output gate.
#include "safety_core/kernel/limits.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/ids/selftest.hpp"

#include <memory>

namespace counterpoint
{
namespace
{
/// A self test that does its work, and fails in each of the three ways.
class FailingSelfTest final : public SelfTestPart
{
  public:
    enum class Way
    {
        kHealthy,
        kNotCalled,
        kFrozen,
        kAlwaysGood,
    };

    SelfTestOutcome OnCycle() noexcept override
    {
        if (way == Way::kNotCalled)
        {
            return SelfTestOutcome{};
        }
        if (way == Way::kFrozen)
        {
            return said_;
        }
        ++cycles_;
        // Of all that a self test looks at, this one knows the setups.
        const bool is_sound = way == Way::kAlwaysGood || watched == nullptr || *watched == expected;
        said_ = {cycles_, is_sound ? DeviceFault::kNone : DeviceFault::kSelfTest, PartsView::kSound};
        return said_;
    }

    Way way{Way::kHealthy};
    const std::uint32_t* watched{nullptr};
    std::uint32_t expected{0U};

  private:
    SelfTestOutcome said_{};
    std::uint32_t cycles_{0U};
};

struct PartBeforeRig
{
    FailingSelfTest part{};
};

class DeviceWithSelfTest : public PartBeforeRig, public Rig
{
  public:
    DeviceWithSelfTest() : Rig(&part)
    {
    }
    void TestBody() override
    {
    }
    void Run()
    {
        Operate();
        ReceivePair();
        Cycle();
        ASSERT_EQ(Open(), 1U);
    }
    /// Cycles with a pair each 10 ms until the output is closed; 0: it is not within so many.
    std::uint32_t CyclesToClosed(const std::uint32_t most)
    {
        for (std::uint32_t cycle = 1U; cycle <= most; ++cycle)
        {
            if ((cycle % 10U) == 0U)
            {
                ReceivePair();
            }
            Cycle();
            if (Open() == 0U)
            {
                return cycle;
            }
        }
        return 0U;
    }
};

using SelfTestParty = ::testing::TestWithParam<FailingSelfTest::Way>;

TEST_P(SelfTestParty, NotCalledOrFrozenClosesTheOutputWithinTheNextCycle)
{
    Verifies(req::SRS_STS_213);
    Verifies(req::SRS_STS_063);
    const auto device = std::make_unique<DeviceWithSelfTest>();
    device->Run();
    device->part.way = GetParam();
    const std::uint32_t cycles = device->CyclesToClosed(5U);
    EXPECT_GE(cycles, 1U);
    EXPECT_LE(cycles, 2U);
    EXPECT_LE(cycles * device->config.cycle_us, ComputeLimit(device->config, {50U, 20U}, FaultClass::kSupervisor).us);
    // And it stays closed, though the self test is there again
    device->part.way = FailingSelfTest::Way::kHealthy;
    for (int cycle = 0; cycle < 100; ++cycle)
    {
        device->Cycle();
        EXPECT_EQ(device->Open(), 0U);
    }
}
INSTANTIATE_TEST_SUITE_P(EachWay, SelfTestParty,
                         ::testing::Values(FailingSelfTest::Way::kNotCalled, FailingSelfTest::Way::kFrozen));

TEST(SelfTestAlwaysGood, LeavesAChangedSafeValueToTheDigest)
{
    Verifies(req::SRS_STS_063);
    Verifies(req::SRS_CFG_050);
    // Given a safe value that a self test watches; when it changes
    for (const FailingSelfTest::Way way : {FailingSelfTest::Way::kHealthy, FailingSelfTest::Way::kAlwaysGood})
    {
        const auto device = std::make_unique<DeviceWithSelfTest>();
        device->part.watched = &device->setups[0].safe_value.low;
        device->part.expected = device->setups[0].safe_value.low;
        device->Run();
        device->part.way = way;
        device->setups[0].safe_value.low ^= 1U;
        const bool is_blind = way == FailingSelfTest::Way::kAlwaysGood;
        // Then the self test finds it at once, and where it always says good the channels' digests do in time:
        // one has a copy of the safe value, one reads the table
        const std::uint32_t limit_us = ComputeLimit(device->config, {50U, 20U}, FaultClass::kConfiguration).us;
        const std::uint32_t most = is_blind ? limit_us / device->config.cycle_us : 2U;
        EXPECT_NE(device->CyclesToClosed(most), 0U);
        EXPECT_EQ(device->kernel.DeviceState().fault, is_blind ? DeviceFault::kDisagreement : DeviceFault::kSelfTest);
    }
}
} // namespace
} // namespace counterpoint
