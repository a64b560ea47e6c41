// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Which slot a device fault names, or a call of a channel is for: here never the first one, or none.
#include "safety_core/kernel/configuration_copies.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{
namespace
{

/// SRDO 3 is in slot 1, SRDO 4 in slot 2.
class NamedSlot : public Rig
{
  protected:
    void Is(const DeviceFault fault, const SlotIndex slot)
    {
        EXPECT_EQ(kernel.DeviceState().fault, fault);
        EXPECT_EQ(kernel.DeviceState().slot, slot);
    }
};

TEST_F(NamedSlot, OfAValueThatIsNotKept)
{
    Verifies(req::SRS_CFG_047);
    Verifies(req::SRS_KRN_003);
    Configure();
    // Given 13FEh is 0 already, so that nothing changes there
    ASSERT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
    b.drop_store = true;
    (void)Write(0x1303U, 3U, 10U, 1U);
    Is(DeviceFault::kConfiguration, 1U);
}

TEST_F(NamedSlot, OfAValueThatNeitherChannelKeeps)
{
    Verifies(req::SRS_CFG_047);
    Configure();
    ASSERT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
    a.drop_store = true;
    b.drop_store = true;
    (void)Write(0x1303U, 3U, 10U, 1U);
    Is(DeviceFault::kConfiguration, 1U);
}

TEST_F(NamedSlot, OfAValueThatReadsDifferently)
{
    Verifies(req::SRS_CFG_047);
    Configure();
    b.load_flip = 1U;
    EXPECT_EQ(kernel.ReadObject(ObjectAddress{0x1304U, 2U}).abort, AbortCode::kGeneral);
    Is(DeviceFault::kConfiguration, 2U);
}

// 1300h and 13FEh belong to the device.
TEST_F(NamedSlot, NoneOfAValueOfTheDevice)
{
    Verifies(req::SRS_CFG_047);
    Verifies(req::SRS_KRN_003);
    for (const std::uint16_t index : {std::uint16_t{0x1300U}, std::uint16_t{0x13FEU}})
    {
        b.load_flip = 0U;
        Configure();
        b.load_flip = 1U;
        (void)kernel.ReadObject(ObjectAddress{index, 0U});
        (void)Write(index, 0U, 0U, 1U);
        Is(DeviceFault::kConfiguration, kNoSlot);
    }
}

TEST_F(NamedSlot, OfACheckThatTheChannelsDoNotShare)
{
    Verifies(req::SRS_KRN_151);
    Configure();
    b.signature_flip = 1U;
    const SignReply reply = kernel.Sign(CommunicationIndex{0x1303U});
    EXPECT_EQ(reply.result, Result::kDeviceFault);
    EXPECT_EQ(reply.signature, 0U);
    Is(DeviceFault::kDisagreement, 1U);
}

TEST_F(NamedSlot, OfADigestThatTheChannelsDoNotShareAndChannelAGoesOn)
{
    Verifies(req::SRS_CFG_050);
    Configure();
    SafeStateLatch latch{};
    latch.Arm();
    ConfigurationCopies copies{a, b, latch};
    b.digest_slot = 1U;
    b.digest_flip = 1U;
    const DigestReply reply = copies.ContinueDigest(1U, DeviceDigest{5U});
    EXPECT_EQ(reply.result, Result::kDeviceFault);
    EXPECT_EQ(reply.digest, real_a.Digest(1U, DeviceDigest{5U}).value);
    EXPECT_EQ(latch.Report().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(latch.Report().slot, 1U);
}

TEST_F(NamedSlot, NoneWhereTheChannelsDifferInACount)
{
    Verifies(req::SRS_CMP_002);
    Verifies(req::SRS_KRN_003);
    Operate();
    b.on_outcome = [](CycleOutcome& outcome) { ++outcome.is_tx; };
    Cycle();
    Is(DeviceFault::kDisagreement, kNoSlot);
}

TEST_F(NamedSlot, NoneOfALateCallOrADemand)
{
    Verifies(req::SRS_CLK_002);
    Verifies(req::SRS_KRN_031);
    Operate();
    now_us += 2000U;
    Cycle();
    Is(DeviceFault::kLateCall, kNoSlot);
    Operate();
    kernel.DemandSafeState();
    Is(DeviceFault::kApplication, kNoSlot);
}

TEST_F(NamedSlot, IsDemotedInBothChannels)
{
    Verifies(req::SRS_CMP_340);
    Operate();
    a.on_outcome = [](CycleOutcome& outcome) { outcome.new_fault = 4U; };
    Cycle();
    EXPECT_EQ(a.demoted, 2U);
    EXPECT_EQ(b.demoted, 2U);
}

// Three SRDOs: the comparator is told of slots 0 to 2.
TEST_F(NamedSlot, ThatDoesNotExistIsNotLookedAt)
{
    Verifies(req::SRS_CMP_150);
    Operate();
    const auto all_fresh = [](CycleOutcome& outcome) { outcome.fresh = ~SrdoMask{0U}; };
    a.on_outcome = all_fresh;
    b.on_outcome = all_fresh;
    Cycle();
    EXPECT_EQ(a.last_held, 2U);
    EXPECT_EQ(b.last_held, 2U);
}

TEST_F(NamedSlot, ThatDoesNotExistIsNeitherDemotedNorPreparedNorReported)
{
    Verifies(req::SRS_CMP_150);
    Operate();
    const int demotions = a.demotions;
    const SrdoMask beyond = ~SrdoMask{7U};
    // Given A alone calls slots 3 to 63 newly faulted
    a.on_outcome = [](CycleOutcome& outcome) { outcome.new_fault |= beyond; };
    Cycle();
    EXPECT_EQ(a.demotions, demotions);
    // And both call them due, and signal something
    const auto due_and_signalled = [](CycleOutcome& outcome)
    {
        outcome.due |= beyond;
        outcome.signalled = beyond;
    };
    a.on_outcome = due_and_signalled;
    b.on_outcome = due_and_signalled;
    a.last_viewed = kNoSlot;
    b.last_viewed = kNoSlot;
    Cycle();
    EXPECT_EQ(a.last_viewed, kNoSlot);
    EXPECT_EQ(b.last_viewed, kNoSlot);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(NamedSlot, IsGivenUpWhereItsInverseFrameIsNotTaken)
{
    Verifies(req::SRS_KRN_216);
    Operate();
    Cycle();
    ports.answer = hal::TransmitStatus::kBusOff;
    ConfirmLast();
    EXPECT_EQ(a.given_up, 1U);
    EXPECT_EQ(b.given_up, 1U);
    Cycle();
    EXPECT_EQ(CausesOf(0x1303U), std::vector<SrdoCause>{SrdoCause::kBusOff});
}

TEST_F(NamedSlot, HasTheStaticFieldsThatWereDefined)
{
    Verifies(req::SRS_KRN_024);
    static constexpr std::uint32_t kEntries[] = {0x22000110U, 0x23000110U};
    setups[2].map = StaticMap{kEntries, 2U};
    Configure();
    for (std::uint8_t* const normal : {rx_normal.data(), tx_normal.data()})
    {
        for (Tap* const tap : {&a, &b})
        {
            tap->fields_slot = kNoSlot;
            tap->validated = kNoSlot;
        }
        // Given fields that are right, then such as are refused and set to none
        const StaticFields fields{normal, rx_inverse.data()};
        const bool is_right = normal == rx_normal.data();
        EXPECT_EQ(kernel.DefineStaticFields(CommunicationIndex{0x1304U}, fields),
                  is_right ? Result::kSuccessful : Result::kMappingError);
        // Then all calls were for slot 2, and both channels validated it
        for (const Tap* const tap : {&a, &b})
        {
            EXPECT_EQ(tap->fields_slot, 2U);
            EXPECT_EQ(tap->validated, 2U);
        }
    }
}

TEST_F(NamedSlot, IsThatOfTheIndexInEveryCall)
{
    Verifies(req::SRS_KRN_021);
    Verifies(req::SRS_KRN_023);
    Configure();
    ASSERT_EQ(kernel.SetStatus(CommunicationIndex{0x1303U}, StatusByte{0x70U}), Result::kSuccessful);
    EXPECT_EQ(kernel.GetStatus(CommunicationIndex{0x1301U}).status.value, 0x30U);
    EXPECT_EQ(kernel.GetStatus(CommunicationIndex{0x1303U}).status.value, 0x70U);
    EXPECT_EQ(kernel.GetMapped(CommunicationIndex{0x1303U}, MappedEntry{1U}).variable.place, tx_normal.data());
    EXPECT_EQ(kernel.GetMapped(CommunicationIndex{0x1303U}, MappedEntry{2U}).variable.place, tx_inverse.data());
}

TEST_F(NamedSlot, WhatDoesNotExistHasNoValues)
{
    Verifies(req::SRS_KRN_151);
    Verifies(req::SRS_KRN_152);
    Verifies(req::SRS_KRN_021);
    Verifies(req::SRS_KRN_023);
    Configure();
    constexpr CommunicationIndex kNone{0x1302U};
    EXPECT_EQ(kernel.Sign(kNone).signature, 0U);
    const StateReply state = kernel.GetState(kNone);
    EXPECT_EQ(state.state, SrdoState::kInvalid);
    EXPECT_EQ(state.first_cause, SrdoCause::kInvalid);
    EXPECT_EQ(state.error_count, 0U);
    EXPECT_EQ(kernel.GetStatus(kNone).status.value, 0U);
    const ParametersReply parameters = kernel.GetParameters(kNone);
    EXPECT_EQ(parameters.direction, 0U);
    EXPECT_EQ(parameters.refresh_ms, 0U);
    EXPECT_EQ(parameters.map_count, 0U);
    const MappedReply mapped = kernel.GetMapped(kNone, MappedEntry{1U});
    EXPECT_EQ(mapped.variable.place, nullptr);
    EXPECT_EQ(mapped.variable.length_bits, 0U);
}

} // namespace
} // namespace counterpoint
