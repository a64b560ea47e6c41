// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{
namespace
{

/// SRDO 1 is released with 12h 34h; the safe value is 01h 7Fh.
class Withdrawal : public Rig
{
  public:
    void Release()
    {
        Operate();
        ReceivePair();
        Cycle();
        ASSERT_EQ(NormalOut(), 0x3412U);
        ASSERT_EQ(InverseOut(), 0xCBEDU);
    }
    void ExpectSafe() const
    {
        EXPECT_EQ(NormalOut(), 0x7F01U);
        EXPECT_EQ(InverseOut(), 0x80FEU);
    }
};

TEST_F(Withdrawal, LeavingOperationalWritesTheSafeValueInTheCall)
{
    Verifies(req::SRS_KRN_029);
    Release();
    kernel.SetNmtState(NmtState::kPreOperational);
    ExpectSafe();
}

TEST_F(Withdrawal, StoppedIsLeavingToo)
{
    Verifies(req::SRS_KRN_029);
    Release();
    kernel.SetNmtState(NmtState::kStopped);
    ExpectSafe();
}

// OPERATIONAL, released -> PRE-OPERATIONAL -> another mapping, no cycle in between -> OPERATIONAL
TEST_F(Withdrawal, ObjectsOfAnOldMappingKeepNothing)
{
    Verifies(req::SRS_KRN_029);
    Release();
    kernel.SetNmtState(NmtState::kPreOperational);
    ASSERT_EQ(Write(0x1301U, 1U, 0U, 1U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1381U, 0U, 0U, 1U), AbortCode::kNone);
    ExpectSafe();
    Cycles(3U);
    ExpectSafe();
    EXPECT_EQ(Open(), 0U);
}

TEST_F(Withdrawal, EnteringAgainBeforeTheNextCycleReleasesNothing)
{
    Verifies(req::SRS_KRN_029);
    Release();
    kernel.SetNmtState(NmtState::kPreOperational);
    kernel.SetNmtState(NmtState::kOperational);
    ExpectSafe();
    Cycle();
    ExpectSafe();
    EXPECT_EQ(Open(), 0U);
    // And the next pair is released as ever.
    Cycle();
    ReceivePair();
    Cycle();
    EXPECT_EQ(NormalOut(), 0x3412U);
}

TEST_F(Withdrawal, StopWritesTheSafeValue)
{
    Verifies(req::SRS_KRN_029);
    Release();
    kernel.Stop();
    ExpectSafe();
}

TEST_F(Withdrawal, StartOfAStartedKernelWritesTheSafeValue)
{
    Verifies(req::SRS_KRN_029);
    Release();
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOn), StartResult::kStarted);
    ExpectSafe();
}

TEST_F(Withdrawal, StartThatIsRefusedWritesTheSafeValueToo)
{
    Verifies(req::SRS_KRN_029);
    Release();
    DeviceConfig refused = config;
    refused.node_id = 0U;
    ASSERT_EQ(kernel.Start(refused, FlowCallback::kOn), StartResult::kNodeId);
    ExpectSafe();
}

TEST_F(Withdrawal, AKernelThatWasNotStartedTouchesNothing)
{
    Verifies(req::SRS_KRN_029);
    rx_normal = {0xAAU, 0xBBU};
    kernel.Stop();
    EXPECT_EQ(NormalOut(), 0xBBAAU);
}

} // namespace
} // namespace counterpoint
