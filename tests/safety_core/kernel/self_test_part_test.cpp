// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the kernel makes of what its self tests say.
#include "tests/safety_core/kernel/mark_tap.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/ids/selftest.hpp"

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
        return outcome;
    }

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
