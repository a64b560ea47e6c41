// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Several kernels in one process.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <memory>

namespace counterpoint
{
namespace
{

/// A rig that is not the test itself.
class Instance final : public Rig
{
  public:
    void TestBody() override
    {
    }
};

class Instances : public ::testing::Test
{
  public:
    static void Release(Instance& instance)
    {
        instance.Operate();
        instance.ReceivePair();
        instance.Cycle();
        ASSERT_EQ(instance.Open(), 1U);
    }
    static void GoesOn(Instance& instance)
    {
        instance.ReceivePair();
        instance.Cycle();
        EXPECT_EQ(instance.Open(), 1U);
        EXPECT_EQ(instance.kernel.DeviceState().fault, DeviceFault::kNone);
        EXPECT_TRUE(instance.WatchdogAlive());
    }

    Instance first{};
    Instance second{};
};

TEST_F(Instances, FaultOfOneIsNoFaultOfTheOther)
{
    Verifies(req::SRS_KRN_026);
    Release(first);
    Release(second);
    first.kernel.DemandSafeState();
    first.Cycle();
    EXPECT_EQ(first.Open(), 0U);
    GoesOn(second);
    second.a.skip_cycle = true;
    second.Cycle();
    EXPECT_EQ(second.kernel.DeviceState().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(first.kernel.DeviceState().fault, DeviceFault::kApplication);
}

TEST_F(Instances, OneIsStoppedAndStartedAgainWhileTheOtherRuns)
{
    Verifies(req::SRS_KRN_026);
    Verifies(req::SRS_KRN_025);
    Release(first);
    Release(second);
    first.kernel.Stop();
    EXPECT_EQ(first.Open(), 0U);
    GoesOn(second);
    Release(first);
    GoesOn(second);
}

TEST_F(Instances, AddedAndDeletedInstancesLeaveTheOthersAlone)
{
    Verifies(req::SRS_KRN_026);
    Release(first);
    for (std::uint32_t round = 0U; round < 3U; ++round)
    {
        const std::unique_ptr<Instance> added = std::make_unique<Instance>();
        added->config.node_id = 5U;
        Release(*added);
        GoesOn(first);
        added->kernel.Stop();
    }
    GoesOn(first);
    EXPECT_EQ(first.Read(0x1301U, 2U), 50U);
}

TEST_F(Instances, ConfigurationOfOneIsNotThatOfTheOther)
{
    Verifies(req::SRS_KRN_026);
    Release(first);
    second.Configure();
    ASSERT_EQ(second.Write(0x1301U, 2U, 77U, 2U), AbortCode::kNone);
    EXPECT_EQ(second.Read(0x13FEU, 0U), 0U);
    EXPECT_EQ(first.Read(0x1301U, 2U), 50U);
    EXPECT_EQ(first.Read(0x13FEU, 0U), 0xA5U);
    EXPECT_EQ(first.kernel.SetStatus(CommunicationIndex{0x1301U}, StatusByte{0x90U}), Result::kSuccessful);
    EXPECT_EQ(second.kernel.GetStatus(CommunicationIndex{0x1301U}).status.value, 0x30U);
}

} // namespace
} // namespace counterpoint
