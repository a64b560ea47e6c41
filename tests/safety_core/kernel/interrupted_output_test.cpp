// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// An output that was closed by anything else than this kernel's decision: told once, and closed until the restart.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{
namespace
{

class InterruptedOutput : public Rig
{
  public:
    void Release()
    {
        Operate();
        Pair();
        ASSERT_EQ(Open(), 1U);
        ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    }
    void Pair()
    {
        ReceivePair();
        Cycle();
    }
    /// The fault is told in this cycle, and it is the only one; no pair and no acknowledge opens the output.
    void IsToldOnceAndStaysClosed()
    {
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kOutput);
        EXPECT_EQ(kernel.DeviceState().slot, 0xFFU);
        ASSERT_EQ(application.faults.size(), 1U);
        EXPECT_EQ(application.faults[0], DeviceFault::kOutput);
        StaysClosed();
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kOutput);
        EXPECT_EQ(kernel.DeviceState().count, 1U);
        EXPECT_EQ(application.faults.size(), 1U);
    }
    void StaysClosed()
    {
        for (std::uint32_t cycle = 0U; cycle < 60U; ++cycle)
        {
            ReceivePair();
            Cycle((cycle < 30U) ? 0U : 1U);
            ASSERT_EQ(Open(), 0U);
        }
    }
    /// A restart is all that it takes.
    void OpensBehindARestart()
    {
        application.faults.clear();
        Release();
        kernel.Stop();
    }
};

// t ms  0        1              2                3
//       release  A answers      challenge 0:     right again
//                wrong: closed  fault is told    closed
TEST_F(InterruptedOutput, IsToldInTheCycleBehindAWrongAnswerOfAChannel)
{
    Verifies(req::SRS_KRN_300);
    for (Tap* const wrong : {&a, &b})
    {
        Release();
        wrong->permit_flip = 0x100U;
        Pair();
        EXPECT_EQ(Open(), 0U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
        wrong->permit_flip = 0U;
        Pair();
        IsToldOnceAndStaysClosed();
        OpensBehindARestart();
        application.faults.clear();
    }
}

TEST_F(InterruptedOutput, IsToldInTheCycleBehindOneWhoseDriveWasLost)
{
    Verifies(req::SRS_KRN_300);
    Release();
    EXPECT_NE(output.Challenge(), 0U); // What such a cycle leaves.
    Pair();
    EXPECT_EQ(Open(), 0U);
    IsToldOnceAndStaysClosed();
    OpensBehindARestart();
}

TEST_F(InterruptedOutput, IsToldInTheCycleBehindASecondDrive)
{
    Verifies(req::SRS_KRN_300);
    Release();
    output.Drive(hal::PermitSet{output.last});
    EXPECT_EQ(Open(), 0U);
    Pair();
    IsToldOnceAndStaysClosed();
    OpensBehindARestart();
}

// The gate's time is 1.6 ms by its own clock, which the kernel does not see.
TEST_F(InterruptedOutput, IsToldInTheCycleBehindATimeThatWasOver)
{
    Verifies(req::SRS_KRN_300);
    Release();
    EXPECT_EQ(output.gate.Open(Instant{now_us + 1601U}, hal::GateLimit{1600U}), 0U);
    Pair();
    IsToldOnceAndStaysClosed();
    OpensBehindARestart();
}

// A refusal while nothing is open is none: before the first pair the answers may be what they like.
TEST_F(InterruptedOutput, IsNoneThatWasNotOpen)
{
    Verifies(req::SRS_KRN_300);
    Operate();
    b.permit_flip = 0x100U;
    Cycles(10U);
    b.permit_flip = 0U;
    Pair();
    EXPECT_EQ(Open(), 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    // nor is one that SCT closed, 50 ms later
    Cycles(60U);
    EXPECT_EQ(Open(), 0U);
    b.permit_flip = 0x100U;
    Cycles(10U);
    b.permit_flip = 0U;
    Pair();
    EXPECT_EQ(Open(), 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(InterruptedOutput, OfTheSafeStateIsNoSecondFault)
{
    Verifies(req::SRS_KRN_301);
    Release();
    kernel.DemandSafeState();
    StaysClosed();
    EXPECT_EQ(output.Challenge(), 0U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kApplication);
    EXPECT_EQ(kernel.DeviceState().count, 1U);
    ASSERT_EQ(application.faults.size(), 1U);
    EXPECT_EQ(application.faults[0], DeviceFault::kApplication);
    OpensBehindARestart();
}

// Cycle 1 ms with 0.5 ms tolerance, gate 1.6 ms: 1.601 ms later the output has closed, and the cycle is too late.
TEST_F(InterruptedOutput, OfALateCycleIsALateCall)
{
    Verifies(req::SRS_KRN_301);
    Release();
    now_us += 1601U;
    EXPECT_EQ(Open(), 0U);
    kernel.Cycle(CycleCall{InstantPair{{now_us}, {now_us}}, 0U, 0U});
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kLateCall);
    EXPECT_EQ(kernel.DeviceState().count, 1U);
    OpensBehindARestart();
}

TEST_F(InterruptedOutput, EndsByStartAloneWhateverIsOutstanding)
{
    Verifies(req::SRS_KRN_302);
    // Given an open output, and a challenge that nobody answered
    Release();
    EXPECT_NE(output.Challenge(), 0U);
    kernel.SetNmtState(NmtState::kPreOperational);
    // When the kernel starts without Stop, then nothing is open, and nothing is wrong
    Operate();
    EXPECT_EQ(Open(), 0U);
    Pair();
    EXPECT_EQ(Open(), 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    // The same by Stop, which closes at once
    EXPECT_NE(output.Challenge(), 0U);
    kernel.Stop();
    EXPECT_EQ(Open(), 0U);
    EXPECT_NE(output.Challenge(), 0U);
    OpensBehindARestart();
}

} // namespace
} // namespace counterpoint
