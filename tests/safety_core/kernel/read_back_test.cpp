// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the kernel makes of objects that are not as their channel wrote them.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <algorithm>

namespace counterpoint
{
namespace
{

/// SRDO 1 is released with 12h 34h.
class ReadBack : public Rig
{
  public:
    void Release()
    {
        Operate();
        ReceivePair();
        Cycle();
        ASSERT_EQ(Open(), 1U);
    }
    /// Cycles from now on until the device is in its safe state, 40 at the most; no pair writes the objects anew.
    std::uint32_t CyclesToFault()
    {
        std::uint32_t cycles = 0U;
        while ((kernel.DeviceState().fault == DeviceFault::kNone) && (cycles < 40U))
        {
            Cycle();
            ++cycles;
        }
        return cycles;
    }
};

// t ms  0        1     2
//       pair     A reads something else than 12h 34h: fault, nothing told, closed
TEST_F(ReadBack, PairThatIsNotAsWrittenByAIsADeviceFaultInThatCycle)
{
    Verifies(req::SRS_KRN_037);
    Operate();
    ReceivePair();
    a.more_found = 1U;
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(kernel.DeviceState().slot, 0U);
    EXPECT_TRUE(application.events.empty());
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(application.faults, std::vector<DeviceFault>{DeviceFault::kDisagreement});
}

TEST_F(ReadBack, PairThatIsNotAsWrittenByBIsADeviceFaultInThatCycle)
{
    Verifies(req::SRS_KRN_037);
    Operate();
    ReceivePair();
    b.more_found = 1U;
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(kernel.DeviceState().slot, 0U);
    EXPECT_TRUE(application.events.empty());
    EXPECT_EQ(Open(), 0U);
}

// The slots of both channels: the lowest is told.
TEST_F(ReadBack, LowestSlotOfBothChannelsIsTold)
{
    Verifies(req::SRS_KRN_037);
    Operate();
    a.more_found = 4U;
    b.more_found = 2U;
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(kernel.DeviceState().slot, 1U);
}

// In the call that leaves OPERATIONAL, not a cycle later.
TEST_F(ReadBack, SlotThatBothChannelsFindIsTold)
{
    Verifies(req::SRS_KRN_037);
    Operate();
    a.more_found = 2U;
    b.more_found = 2U;
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(kernel.DeviceState().slot, 1U);
}

TEST_F(ReadBack, SafeValueThatIsNotAsWrittenIsADeviceFaultInTheCall)
{
    Verifies(req::SRS_KRN_037);
    for (Tap* const channel : {&a, &b})
    {
        ASSERT_EQ(kernel.Start(config, FlowCallback::kOn), StartResult::kStarted);
        Release();
        channel->more_found = 1U;
        kernel.SetNmtState(NmtState::kPreOperational);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
        EXPECT_EQ(kernel.DeviceState().slot, 0U);
        channel->more_found = 0U;
    }
}

// Diagnosis 30 ms, SCT 50 ms, cycle 1 ms: whenever a bit of an object changes, it is found 31 cycles later at the most.
TEST_F(ReadBack, WhatStopAndStartFindIsNotTold)
{
    Verifies(req::SRS_KRN_037);
    for (Tap* const channel : {&a, &b})
    {
        ASSERT_EQ(kernel.Start(config, FlowCallback::kOn), StartResult::kStarted);
        Release();
        channel->more_found = 1U;
        kernel.Stop();
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kInvalid);
        EXPECT_EQ(Open(), 0U);
        channel->more_found = 0U;
        ASSERT_EQ(kernel.Start(config, FlowCallback::kOn), StartResult::kStarted);
        Release();
        channel->more_found = 1U;
        EXPECT_EQ(kernel.Start(config, FlowCallback::kOn), StartResult::kStarted);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
        EXPECT_EQ(Open(), 0U);
        channel->more_found = 0U;
    }
    EXPECT_TRUE(application.faults.empty());
}

TEST_F(ReadBack, ChangedObjectIsFoundWithinTheDiagnosticInterval)
{
    Verifies(req::SRS_KRN_038);
    Verifies(req::SRS_KRN_037);
    for (std::uint32_t phase = 0U; phase < 19U; ++phase)
    {
        for (std::uint8_t* const changed : {&rx_normal[1], &rx_inverse[0]})
        {
            ASSERT_EQ(kernel.Start(config, FlowCallback::kOn), StartResult::kStarted);
            Release();
            Cycles(phase);
            *changed = static_cast<std::uint8_t>(*changed ^ 0x80U);
            EXPECT_LE(CyclesToFault(), 31U) << phase;
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement) << phase;
            EXPECT_EQ(kernel.DeviceState().slot, 0U);
            EXPECT_EQ(Open(), 0U);
            kernel.Stop();
        }
    }
}

// Three SRDOs, a share each 5 ms: signature of slot 0, its digest, signature of slot 1, ...
TEST_F(ReadBack, ASlotIsExaminedWhereItsSignatureIsChecked)
{
    Verifies(req::SRS_KRN_038);
    Operate();
    a.keep_examined = true;
    b.keep_examined = true;
    for (std::uint32_t cycle = 0U; cycle < 60U; ++cycle)
    {
        a.rechecked = kNoSlot;
        Cycle();
        EXPECT_EQ(a.examined.back(), (a.rechecked == kNoSlot) ? SrdoMask{0U} : (SrdoMask{1U} << a.rechecked)) << cycle;
    }
    std::vector<SrdoMask> named = a.examined;
    named.erase(std::remove(named.begin(), named.end(), SrdoMask{0U}), named.end());
    std::sort(named.begin(), named.end());
    EXPECT_EQ(named, (std::vector<SrdoMask>{1U, 1U, 2U, 2U, 4U, 4U}));
    EXPECT_EQ(a.examined, b.examined);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

// A Commit that is left out gives no permit, though the slot was released before, and what was closed by it stays
// closed.
TEST_F(ReadBack, CommitLeftOutOfAClosesTheOutputForGood)
{
    Verifies(req::SRS_REL_010);
    Verifies(req::SRS_KRN_250);
    Release();
    a.skip_commit = true;
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    a.skip_commit = false;
    Cycle();
    EXPECT_EQ(Open(), 0U);
}

TEST_F(ReadBack, CommitLeftOutOfBClosesTheOutputForGood)
{
    Verifies(req::SRS_REL_010);
    Verifies(req::SRS_KRN_250);
    Release();
    b.skip_commit = true;
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    b.skip_commit = false;
    Cycle();
    EXPECT_EQ(Open(), 0U);
}

// An object that no released consumer maps may change.
TEST_F(ReadBack, NothingIsExaminedOfWhatIsNotReleased)
{
    Verifies(req::SRS_KRN_038);
    Operate();
    rx_normal[0] = 0x55U;
    tx_normal[0] = 0x55U;
    tx_inverse[0] = 0xAAU;
    Cycles(49U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(ReadBack, ASlotHasItsTurnWithoutAValidConfigurationToo)
{
    Verifies(req::SRS_KRN_038);
    Configure();
    ASSERT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
    Cycle();
    a.keep_examined = true;
    b.keep_examined = true;
    a.rechecked = kNoSlot;
    b.rechecked = kNoSlot;
    Cycles(60U);
    std::vector<SrdoMask> named = a.examined;
    named.erase(std::remove(named.begin(), named.end(), SrdoMask{0U}), named.end());
    std::sort(named.begin(), named.end());
    EXPECT_EQ(named, (std::vector<SrdoMask>{1U, 1U, 2U, 2U, 4U, 4U}));
    EXPECT_EQ(a.examined, b.examined);
    // and no signature was checked
    EXPECT_EQ(a.rechecked, kNoSlot);
    EXPECT_EQ(b.rechecked, kNoSlot);
}

} // namespace
} // namespace counterpoint
