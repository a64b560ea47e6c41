// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the kernel makes of what its self tests say.
#include "tests/safety_core/kernel/mark_tap.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/ids/selftest.hpp"

#include <cstdint>
#include <functional>

namespace counterpoint
{
namespace
{

/// Says what a test wants, with the right progress.
class SaidSelfTest final : public SelfTestPart
{
  public:
    SelfTestOutcome OnCycle() noexcept override
    {
        ++outcome.progress;
        if (on_cycle)
        {
            on_cycle();
        }
        return outcome;
    }

    std::function<void()> on_cycle{};

    SelfTestOutcome outcome{0U, DeviceFault::kNone, PartsView::kSound};
};

/// Comes before Rig among the bases of the fixture.
struct SaidSelfTestHolder
{
    SaidSelfTest said{};
};

class SelfTestSaid : protected MarkTapHolder, protected SaidSelfTestHolder, public Rig
{
  protected:
    SelfTestSaid() : Rig{&said, &flow}
    {
    }
};

TEST_F(SelfTestSaid, FaultIsThatOfTheDeviceAndOfNoSlot)
{
    Verifies(req::SRS_STS_063);
    Operate();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    said.outcome.fault = DeviceFault::kClock;
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kClock);
    EXPECT_EQ(kernel.DeviceState().slot, kNoSlot);
}

TEST_F(SelfTestSaid, PartsThatAreNotSoundAreAFaultWhateverElseIsSaid)
{
    Verifies(req::SRS_STS_040);
    for (const DeviceFault fault : {DeviceFault::kNone, DeviceFault::kClock})
    {
        said.outcome = SelfTestOutcome{0U, DeviceFault::kNone, PartsView::kSound};
        Operate();
        said.outcome.fault = fault;
        said.outcome.parts = PartsView::kInvalid;
        Cycle();
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kSelfTest);
        EXPECT_EQ(kernel.DeviceState().slot, kNoSlot);
    }
}

TEST_F(SelfTestSaid, IsCalledBeforeAnyPartButTheBeginningOfTheFlow)
{
    Verifies(req::SRS_STS_063);
    Operate();
    ReceivePair();
    std::uint32_t channels = 0U;
    const auto count = [&channels](CycleOutcome&) { ++channels; };
    a.on_outcome = count;
    b.on_outcome = count;
    std::uint32_t calls = 0U;
    // When its turn comes, then the cycle has begun, and nobody was asked, told or driven
    said.on_cycle = [this, &calls, &channels]()
    {
        ++calls;
        EXPECT_EQ(flow.begun, 2U);
        EXPECT_TRUE(flow.steps.empty());
        EXPECT_EQ(channels, 0U);
        EXPECT_EQ(output.last.kernel.mask, 0U);
        EXPECT_TRUE(application.events.empty());
        EXPECT_TRUE(ports.sent.empty());
    };
    Cycle();
    said.on_cycle = nullptr;
    EXPECT_EQ(calls, 1U);
    EXPECT_EQ(channels, 2U);
    EXPECT_EQ(output.last.kernel.mask, 1U);
    EXPECT_EQ(application.events.size(), 1U);
    EXPECT_EQ(ports.sent.size(), 1U);
}

TEST_F(SelfTestSaid, ProgressIsTheEvidenceOfItsStep)
{
    Verifies(req::SRS_STS_063);
    Verifies(req::SRS_FLOW_001);
    Operate();
    said.outcome.progress = 7U;
    Cycle();
    EXPECT_EQ(flow.steps.front(), FlowStep::kSelfTest);
    EXPECT_EQ(flow.evidences.front().observed, 8U);
    EXPECT_EQ(flow.evidences.front().expected, 2U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kFlow);
}

} // namespace
} // namespace counterpoint
