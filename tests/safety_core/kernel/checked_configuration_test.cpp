// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The check of the whole configuration: in each state, for each SRDO and each rule.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <initializer_list>

namespace counterpoint
{
namespace
{

constexpr std::uint16_t kIndices[] = {0x1301U, 0x1303U, 0x1304U};
constexpr ConfigFault kRules[] = {
    ConfigFault::kDirection,       ConfigFault::kTransmissionType, ConfigFault::kIdentifier,
    ConfigFault::kIdentifierInUse, ConfigFault::kTiming,           ConfigFault::kMapping,
    ConfigFault::kLengthExceeded,  ConfigFault::kSignature,        ConfigFault::kTable};

class CheckedConfiguration : public Rig
{
  public:
    void Gives(const Result result, const std::uint16_t index)
    {
        const CheckReply reply = kernel.CheckConfiguration();
        EXPECT_EQ(reply.result, result);
        EXPECT_EQ(reply.index.value, index);
    }
    /// Both channels find this rule broken, in one SRDO alone.
    void Break(const ConfigFault rule, const SlotIndex slot)
    {
        for (Tap* const tap : {&a, &b})
        {
            tap->check_fault = rule;
            tap->check_slot = slot;
        }
    }
};

TEST_F(CheckedConfiguration, InEachStateOutsideOfOperationalTheFirstBrokenRuleIsTold)
{
    Verifies(req::SRS_KRN_015);
    for (const NmtState state : {NmtState::kInitialising, NmtState::kStopped, NmtState::kPreOperational})
    {
        Configure();
        kernel.SetNmtState(state);
        Gives(Result::kSuccessful, 0U);
        // Given a wrong signature of the last SRDO, then an SRVT of the first one that is not below its SCT
        ASSERT_EQ(Write(0x13FFU, 4U, 0x1234U, 2U), AbortCode::kNone);
        Gives(Result::kSignatureError, 0x1304U);
        ASSERT_EQ(Write(0x1301U, 3U, 50U, 1U), AbortCode::kNone);
        Gives(Result::kTimingError, 0x1301U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    }
}

TEST_F(CheckedConfiguration, InOperationalItIsSignatureAndMappingOfEachSrdo)
{
    Verifies(req::SRS_KRN_210);
    for (SlotIndex slot = 0U; slot < 3U; ++slot)
    {
        // Given a value that changed in both channels, of the consumer, the producer, or the SRDO that is off
        Operate();
        const ConfigItem changed{ConfigAddress{slot, ConfigField::kSrvt, 0U}, 15U};
        real_a.Store(changed);
        real_b.Store(changed);
        Gives(Result::kSignatureError, kIndices[slot]);
        // and a resolved mapping that both find changed
        Operate();
        Break(ConfigFault::kTable, slot);
        Gives(Result::kMappingError, kIndices[slot]);
        Break(ConfigFault::kNone, kNoSlot);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    }
}

TEST_F(CheckedConfiguration, ChannelsThatNameTwoRulesDisagree)
{
    Verifies(req::SRS_KRN_212);
    for (const NmtState state : {NmtState::kPreOperational, NmtState::kOperational})
    {
        for (const ConfigFault first : kRules)
        {
            for (const ConfigFault second : kRules)
            {
                Configure();
                kernel.SetNmtState(state);
                a.check_fault = first;
                b.check_fault = second;
                const Result result = kernel.CheckConfiguration().result;
                EXPECT_EQ(result == Result::kDeviceFault, first != second);
                EXPECT_EQ(kernel.DeviceState().fault,
                          (first == second) ? DeviceFault::kNone : DeviceFault::kDisagreement);
                Break(ConfigFault::kNone, kNoSlot);
            }
        }
    }
}

TEST_F(CheckedConfiguration, DigestThatIsAskedForLeavesOneUnderWayAlone)
{
    Verifies(req::SRS_KRN_150);
    Operate();
    for (std::uint32_t cycle = 0U; cycle < 120U; ++cycle)
    {
        ASSERT_EQ(kernel.Digest().result, Result::kSuccessful);
        Cycle();
        ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone) << cycle;
    }
}

TEST_F(CheckedConfiguration, EachRuleOfEachSrdoRefusesTheDeclaration)
{
    Verifies(req::SRS_CFG_046);
    Configure();
    for (const ConfigFault rule : kRules)
    {
        for (SlotIndex slot = 0U; slot < 3U; ++slot)
        {
            ASSERT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
            Break(rule, slot);
            EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kIncompatible);
            EXPECT_EQ(Read(0x13FEU, 0U), 0U);
            Break(ConfigFault::kNone, kNoSlot);
            EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
            EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
        }
    }
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(CheckedConfiguration, EveryOtherValueThanA5hIsStoredAsZero)
{
    Verifies(req::SRS_CFG_046);
    Configure();
    for (std::uint32_t value = 0U; value <= 0xFFU; ++value)
    {
        ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
        EXPECT_EQ(Write(0x13FEU, 0U, value, 1U), AbortCode::kNone) << value;
        EXPECT_EQ(Read(0x13FEU, 0U), (value == 0xA5U) ? 0xA5U : 0U) << value;
    }
}

TEST_F(CheckedConfiguration, AFlippedBitOfTheControllerIsFoundWithinTwoDiagnosticIntervals)
{
    Verifies(req::SRS_CFG_800);
    for (std::uint32_t bit = 0U; bit < 8U; ++bit)
    {
        for (std::uint32_t phase = 0U; phase < 30U; ++phase)
        {
            Operate();
            Cycles(30U + phase);
            ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
            // When a bit of the controller of the normal frames flips in the description
            config.normal_port = static_cast<CanPortId>(static_cast<std::uint32_t>(CanPortId::kFirst) ^ (1U << bit));
            Cycles(60U);
            // Then the channels' digests differ, and no GFC is sent any more
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement) << bit << " phase " << phase;
            ports.sent.clear();
            EXPECT_EQ(kernel.SendGfc(), Result::kDeviceFault);
            EXPECT_TRUE(ports.sent.empty());
            config.normal_port = CanPortId::kFirst;
        }
    }
}

TEST_F(CheckedConfiguration, DigestOrSignatureThatOneChannelAloneHasIsADisagreementAtItsSlot)
{
    Verifies(req::SRS_KRN_150);
    Verifies(req::SRS_KRN_151);
    for (Tap* const tap : {&a, &b})
    {
        for (SlotIndex slot = 0U; slot < 3U; ++slot)
        {
            Configure();
            tap->digest_slot = slot;
            tap->digest_flip = 1U;
            EXPECT_EQ(kernel.Digest().result, Result::kDeviceFault);
            tap->digest_flip = 0U;
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
            EXPECT_EQ(kernel.DeviceState().slot, slot);
            Configure();
            tap->signature_flip = 0x8000U;
            const SignReply reply = kernel.Sign(CommunicationIndex{kIndices[slot]});
            tap->signature_flip = 0U;
            EXPECT_EQ(reply.result, Result::kDeviceFault);
            EXPECT_EQ(reply.signature, 0U);
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
            EXPECT_EQ(kernel.DeviceState().slot, slot);
        }
    }
}

TEST_F(CheckedConfiguration, EachRuleOfEachSrdoIsFoundByTheCyclicCheckInEachState)
{
    Verifies(req::SRS_CFG_048);
    for (const NmtState state :
         {NmtState::kInitialising, NmtState::kPreOperational, NmtState::kOperational, NmtState::kStopped})
    {
        for (const ConfigFault rule : kRules)
        {
            for (SlotIndex slot = 0U; slot < 3U; ++slot)
            {
                Configure();
                kernel.SetNmtState(state);
                Cycle();
                Break(rule, slot);
                Cycles(30U);
                EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kConfiguration);
                EXPECT_EQ(kernel.DeviceState().slot, slot);
                Break(ConfigFault::kNone, kNoSlot);
            }
        }
    }
}

TEST_F(CheckedConfiguration, DigestThatChangesInBothChannelsIsFoundInEachState)
{
    Verifies(req::SRS_CFG_050);
    for (const NmtState state :
         {NmtState::kInitialising, NmtState::kPreOperational, NmtState::kOperational, NmtState::kStopped})
    {
        for (SlotIndex slot = 0U; slot < 3U; ++slot)
        {
            Configure();
            kernel.SetNmtState(state);
            Cycles(31U);
            for (Tap* const tap : {&a, &b})
            {
                tap->digest_slot = slot;
                tap->digest_flip = 0x80U;
            }
            Cycles(60U);
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kConfiguration);
            EXPECT_EQ(kernel.DeviceState().slot, kNoSlot);
            a.digest_flip = 0U;
            b.digest_flip = 0U;
        }
    }
}

} // namespace
} // namespace counterpoint
