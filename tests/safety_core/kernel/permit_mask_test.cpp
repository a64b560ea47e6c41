// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the kernel's own permit says after a fault: not only a wrong answer, but no slot at all.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

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

} // namespace
} // namespace counterpoint
