// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the kernel's own permit says after a fault: not only a wrong answer, but no slot at all.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <cstdint>

namespace counterpoint
{
namespace
{

class PermitMask : public Rig
{
  public:
    void Release()
    {
        Operate();
        ReceivePair();
        Cycle();
        ASSERT_EQ(output.last.kernel.mask, 1U);
        ASSERT_EQ(output.last.a.mask, 1U);
        ASSERT_EQ(output.last.b.mask, 1U);
    }
    void NamesNoSlot() const
    {
        EXPECT_EQ(output.last.kernel.mask, 0U);
        EXPECT_EQ(output.last.a.mask, 0U);
        EXPECT_EQ(output.last.b.mask, 0U);
    }
};

TEST_F(PermitMask, IsEmptyInTheCycleOfADeviceFaultAndAfterIt)
{
    Verifies(req::SRS_KRN_004);
    Verifies(req::SRS_KRN_005);
    Release();
    a.skip_cycle = true;
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(output.last.kernel.mask, 0U);
    EXPECT_EQ(output.last.b.mask, 0U);
    a.skip_cycle = false;
    // Good pairs bring no slot back
    for (std::uint32_t cycle = 0U; cycle < 10U; ++cycle)
    {
        ReceivePair();
        Cycle();
        NamesNoSlot();
    }
}

TEST_F(PermitMask, IsEmptyWhenTheApplicationDemandsTheSafeState)
{
    Verifies(req::SRS_KRN_004);
    Verifies(req::SRS_KRN_005);
    Release();
    // The channels agree on everything: the latch alone takes the slot away
    kernel.DemandSafeState();
    ReceivePair();
    Cycle();
    NamesNoSlot();
    // and its words spoil the answer, which is not even that for no slot
    EXPECT_NE(output.last.kernel.response, static_cast<std::uint32_t>(kernel.LastVerdict().echo * 0xC2B2AE3DU));
}

TEST_F(PermitMask, IsEmptyAfterTheClocksDiffer)
{
    Verifies(req::SRS_KRN_004);
    Verifies(req::SRS_KRN_005);
    Release();
    now_us += 1000U;
    kernel.Cycle(CycleCall{InstantPair{{now_us}, {now_us + 201U}}, 0U, 0U});
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kClock);
    NamesNoSlot();
}

TEST_F(PermitMask, IsEmptyAfterAFaultOfTheConsumerAndOfOneChannelAlone)
{
    Verifies(req::SRS_CMP_003);
    Verifies(req::SRS_KRN_005);
    Release();
    Receive(0x102U, {0xEDU, 0xCBU}, 100U); // Inverse first
    Cycle();
    NamesNoSlot();
    ReceivePair();
    Cycle();
    ASSERT_EQ(output.last.kernel.mask, 1U);
    // B alone is faulted: demoted
    b.on_outcome = [](CycleOutcome& outcome) { outcome.new_fault = 1U; };
    Cycle();
    NamesNoSlot();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(PermitMask, IsEmptyAfterOperationalWasLeft)
{
    Verifies(req::SRS_KRN_010);
    Verifies(req::SRS_KRN_005);
    Release();
    kernel.SetNmtState(NmtState::kPreOperational);
    Cycle();
    NamesNoSlot();
}

// t ms  0   1
//           both release: A with its second pair, B with its first
TEST_F(PermitMask, IsEmptyForAnAgreedReleaseOfWhichNoPairWasWritten)
{
    Verifies(req::SRS_KRN_005);
    Operate();
    ReceivePair();
    b.drop_frames = true;
    ReceivePair();
    b.drop_frames = false;
    Cycle();
    EXPECT_EQ(kernel.LastVerdict().agreement.agreed, 1U);
    EXPECT_EQ(kernel.LastVerdict().agreement.matched & 1U, 0U);
    NamesNoSlot();
    EXPECT_EQ(NormalOut(), 0x7F01U);
    EXPECT_TRUE(application.events.empty());
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

// t ms  0        1                  2
//       release  A's or B's permit  right again
//                names no slot
TEST_F(PermitMask, OfOneChannelThatLacksASlotIsADeviceFaultAndNoInterruption)
{
    Verifies(req::SRS_KRN_250);
    for (Tap* const wrong : {&a, &b})
    {
        Release();
        // Given a permit without the slot that all of them committed, for one cycle
        wrong->permit_slots = 1U;
        Cycle();
        // Then the device is in its safe state in that cycle
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
        EXPECT_EQ(kernel.DeviceState().slot, 0U);
        EXPECT_EQ(Open(), 0U);
        // and stays there when the permit is right again
        wrong->permit_slots = 0U;
        ReceivePair();
        Cycle();
        EXPECT_EQ(Open(), 0U);
        kernel.SetNmtState(NmtState::kPreOperational);
        ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    }
}

TEST_F(PermitMask, OfOneChannelThatNamesAnotherSlotIsADeviceFaultOfThatSlot)
{
    Verifies(req::SRS_KRN_250);
    Operate();
    a.permit_slots = 4U;
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(kernel.DeviceState().slot, 2U);
    // Of several, by whichever channel, the lowest one
    a.permit_slots = 0U;
    Operate();
    a.permit_slots = 4U;
    b.permit_slots = 2U;
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(kernel.DeviceState().slot, 1U);
}

TEST_F(PermitMask, OfBothChannelsThatLackTheSameSlotIsADeviceFault)
{
    Verifies(req::SRS_KRN_250);
    Release();
    a.permit_slots = 1U;
    b.permit_slots = 1U;
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(kernel.DeviceState().slot, 0U);
}

TEST_F(PermitMask, OverAnEchoThatChangedBehindTheComparisonIsADeviceFault)
{
    Verifies(req::SRS_KRN_250);
    Verifies(req::SRS_KRN_005);
    Verifies(req::SRS_CMP_001);
    Release();
    // Given one bit of the echo changes when channel B has committed
    b.on_committed = [this]() { const_cast<Verdict&>(kernel.LastVerdict()).echo ^= 0x100U; };
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kComparator);
    EXPECT_EQ(kernel.DeviceState().slot, 0xFFU);
    EXPECT_EQ(Open(), 0U);
    // And the permit is that of the changed echo: what spoils it, FFFFFFFFh, and mask 1 make 0
    const std::uint32_t echo = kernel.LastVerdict().echo;
    EXPECT_EQ(output.last.kernel.mask, 1U);
    EXPECT_EQ(output.last.kernel.response, static_cast<std::uint32_t>(echo * 0xC2B2AE3DU));
    b.on_committed = nullptr;
    ReceivePair();
    Cycle();
    EXPECT_EQ(Open(), 0U);
}

// t ms  0        1              2
//       release  one channel    both release again:
//                does not       no acknowledge came
TEST_F(PermitMask, IsEmptyUntilAnAcknowledgeBehindAReleaseThatOneChannelLost)
{
    Verifies(req::SRS_CMP_250);
    setups[0].policy = ReleasePolicy::kInterlock;
    Operate();
    for (Tap* const wrong : {&a, &b})
    {
        ReceivePair();
        Cycle();
        Cycle(1U);
        Cycle(1U);
        ASSERT_EQ(Open(), 1U);
        // Given one channel that calls SRDO 1 released no more, and reports no fault, for one cycle
        wrong->on_outcome = [](CycleOutcome& outcome) { outcome.released = 0U; };
        Cycle();
        EXPECT_EQ(Open(), 0U);
        wrong->on_outcome = nullptr;
        // Then pairs alone do not open it again
        for (std::uint32_t cycle = 0U; cycle < 10U; ++cycle)
        {
            ReceivePair();
            Cycle();
            NamesNoSlot();
        }
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    }
    EXPECT_EQ(kernel.DemotionCount(), 2U);
}

} // namespace
} // namespace counterpoint
