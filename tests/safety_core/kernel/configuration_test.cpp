// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{
namespace
{

class Configuring : public Rig
{
};

TEST_F(Configuring, WrongSignatureRefusesTheDeclaration)
{
    Verifies(req::SRS_CFG_046);
    Configure();
    ASSERT_EQ(Write(0x13FFU, 1U, 0x1234U, 2U), AbortCode::kNone);
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kIncompatible);
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    const CheckReply reply = kernel.CheckConfiguration();
    EXPECT_EQ(reply.result, Result::kSignatureError);
    EXPECT_EQ(reply.index.value, 0x1301U);
}

TEST_F(Configuring, AnyOtherValueIsStoredAsZero)
{
    Verifies(req::SRS_CFG_046);
    Configure();
    EXPECT_EQ(Write(0x13FEU, 0U, 0x5AU, 1U), AbortCode::kNone);
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
}

TEST_F(Configuring, ChannelsThatDifferRefuseTheDeclarationAndTheDevice)
{
    Verifies(req::SRS_CFG_046);
    Configure();
    b.signature_flip = 1U;
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kIncompatible);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
}

TEST_F(Configuring, ChannelsThatNameDifferentRulesDisagree)
{
    Verifies(req::SRS_KRN_212);
    Verifies(req::SRS_CFG_046);
    Configure();
    a.check_fault = ConfigFault::kTiming;
    EXPECT_EQ(kernel.CheckConfiguration().result, Result::kDeviceFault);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
}

TEST_F(Configuring, StoreThatOneChannelDoesNotKeepIsFound)
{
    Verifies(req::SRS_CFG_047);
    Configure();
    a.drop_store = true;
    (void)Write(0x1301U, 2U, 60U, 2U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kConfiguration);
}

TEST_F(Configuring, StoreThatTheOtherChannelDoesNotKeepIsFound)
{
    Verifies(req::SRS_CFG_047);
    Configure();
    b.drop_store = true;
    (void)Write(0x1301U, 2U, 60U, 2U);
    (void)Write(0x1301U, 3U, 10U, 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kConfiguration);
}

TEST_F(Configuring, ReadingUnequalCopiesIsFound)
{
    Verifies(req::SRS_CFG_047);
    Configure();
    b.load_flip = 1U;
    EXPECT_EQ(kernel.ReadObject(ObjectAddress{0x1301U, 2U}).abort, AbortCode::kGeneral);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kConfiguration);
}

// Diagnostic interval 30 ms, three SRDOs, cycle 1 ms: one SRDO every 10 cycles.
TEST_F(Configuring, ChangedCopyIsFoundWithinTheDiagnosticInterval)
{
    Verifies(req::SRS_CFG_048);
    Operate();
    // Given that a byte of SRDO 4 (direction off, so that nothing but its signature shows it) changes in both channels
    const ConfigItem changed{ConfigAddress{2U, ConfigField::kSrvt, 0U}, 21U};
    real_a.Store(changed);
    real_b.Store(changed);
    std::uint32_t cycles = 0U;
    while ((kernel.DeviceState().fault == DeviceFault::kNone) && (cycles < 100U))
    {
        Cycle();
        ++cycles;
    }
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kConfiguration);
    EXPECT_EQ(kernel.DeviceState().slot, 2U);
    EXPECT_LE(cycles, 30U);
}

TEST_F(Configuring, CyclicCheckFindsChannelsThatDiffer)
{
    Verifies(req::SRS_CFG_048);
    Operate();
    a.signature_flip = 0x8000U;
    Cycles(30U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
}

TEST_F(Configuring, InvalidConfigurationIsNotRecheckedAndIsNoFault)
{
    Verifies(req::SRS_CFG_048);
    Configure();
    ASSERT_EQ(Write(0x1304U, 3U, 21U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    Cycles(100U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    EXPECT_TRUE(application.invalid.empty());
}

TEST_F(Configuring, EnteringOperationalWithABrokenSignatureLeavesSrdosOff)
{
    Verifies(req::SRS_KRN_223);
    Configure();
    const ConfigItem changed{ConfigAddress{1U, ConfigField::kSrvt, 0U}, 21U};
    real_a.Store(changed);
    real_b.Store(changed);
    kernel.SetNmtState(NmtState::kOperational);
    ASSERT_EQ(application.invalid.size(), 1U);
    EXPECT_EQ(application.invalid[0], 0x1303U);
    Cycles(50U);
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    ReceivePair();
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_TRUE(ports.sent.empty());
}

// t [cycles]   1 released     (PRE-OPERATIONAL, written, OPERATIONAL)     2 off     3 waiting
TEST_F(Configuring, LeavingAndEnteringOperationalBetweenTwoCyclesIsSeenAsLeft)
{
    Verifies(req::SRS_KRN_222);
    Operate();
    ReceivePair();
    Cycle();
    ASSERT_EQ(Open(), 1U);
    // Given a configuration that is changed, signed and declared between two cycles
    kernel.SetNmtState(NmtState::kPreOperational);
    ASSERT_EQ(Write(0x1301U, 2U, 60U, 2U), AbortCode::kNone);
    const SignReply reply = kernel.Sign(CommunicationIndex{0x1301U});
    ASSERT_EQ(Write(0x13FFU, 1U, reply.signature, 2U), AbortCode::kNone);
    ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    // Then the released pair does not survive it
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kOff);
    EXPECT_EQ(CausesOf(0x1301U), std::vector<SrdoCause>{SrdoCause::kNotOperational});
    Cycle();
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kWaiting);
    ReceivePair();
    Cycle();
    EXPECT_EQ(Open(), 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(Configuring, OperationalAgainIsNotEnteringIt)
{
    Verifies(req::SRS_KRN_223);
    Operate();
    real_a.Store(ConfigItem{ConfigAddress{1U, ConfigField::kSrvt, 0U}, 21U});
    kernel.SetNmtState(NmtState::kOperational);
    EXPECT_TRUE(application.invalid.empty());
}

TEST_F(Configuring, EachRuleHasItsReturnCode)
{
    Verifies(req::SRS_KRN_015);
    Configure();
    const auto gives = [this](ConfigFault rule, Result result)
    {
        a.check_fault = rule;
        b.check_fault = rule;
        EXPECT_EQ(kernel.CheckConfiguration().result, result);
    };
    EXPECT_EQ(kernel.CheckConfiguration().result, Result::kSuccessful);
    EXPECT_EQ(kernel.CheckConfiguration().index.value, 0U);
    gives(ConfigFault::kIdentifier, Result::kIdError);
    gives(ConfigFault::kIdentifierInUse, Result::kIdInUse);
    gives(ConfigFault::kTiming, Result::kTimingError);
    gives(ConfigFault::kMapping, Result::kMappingError);
    gives(ConfigFault::kTable, Result::kMappingError);
    gives(ConfigFault::kLengthExceeded, Result::kLengthExceeded);
    gives(ConfigFault::kDirection, Result::kInvalidConfiguration);
    gives(ConfigFault::kTransmissionType, Result::kInvalidConfiguration);
}

// What the reference's call tells, by configurations that break the rules, not by altered channels.
TEST_F(Configuring, CheckNamesTheFirstBrokenRuleAndItsSrdo)
{
    Verifies(req::SRS_KRN_015);
    Verifies(req::SRS_KRN_028);
    Configure();
    const auto gives = [this](Result result, std::uint16_t index)
    {
        const CheckReply reply = kernel.CheckConfiguration();
        EXPECT_EQ(reply.result, result);
        EXPECT_EQ(reply.index.value, index);
    };
    gives(Result::kSuccessful, 0U);
    // SRVT 50 ms is not below SCT 50 ms
    ASSERT_EQ(Write(0x1301U, 3U, 50U, 1U), AbortCode::kNone);
    gives(Result::kTimingError, 0x1301U);
    ASSERT_EQ(Write(0x1301U, 3U, 20U, 1U), AbortCode::kNone);
    gives(Result::kSuccessful, 0U);
    // Objects of a consumer in a producer
    ASSERT_EQ(Write(0x1301U, 1U, 1U, 1U), AbortCode::kNone);
    gives(Result::kMappingError, 0x1301U);
    ASSERT_EQ(Write(0x1301U, 1U, 2U, 1U), AbortCode::kNone);
    // Signatures, of an SRDO that is off too
    ASSERT_EQ(Write(0x13FFU, 4U, 0x1234U, 2U), AbortCode::kNone);
    gives(Result::kSignatureError, 0x1304U);
    ASSERT_EQ(Write(0x13FFU, 3U, 0x1234U, 2U), AbortCode::kNone);
    gives(Result::kSignatureError, 0x1303U);
    // COB-IDs that no write admits: loaded. Items of SRDO 3 begin at 24.
    ASSERT_EQ(kernel.Image().LoadItem(24U + 5U, 0x201U), Result::kSuccessful);
    ASSERT_EQ(kernel.Image().LoadItem(24U + 6U, 0x202U), Result::kSuccessful);
    gives(Result::kIdError, 0x1303U);
    ASSERT_EQ(kernel.Image().LoadItem(24U + 5U, 0x101U), Result::kSuccessful);
    ASSERT_EQ(kernel.Image().LoadItem(24U + 6U, 0x102U), Result::kSuccessful);
    gives(Result::kIdInUse, 0x1301U);
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

// In OPERATIONAL nothing is resolved anew: the signature covers what the rules would find.
TEST_F(Configuring, CheckInOperationalIsThatOfSignatureAndResolvedMapping)
{
    Verifies(req::SRS_KRN_210);
    Operate();
    ReceivePair();
    Cycle();
    ASSERT_EQ(NormalOut(), 0x3412U);
    EXPECT_EQ(kernel.CheckConfiguration().result, Result::kSuccessful);
    EXPECT_EQ(NormalOut(), 0x3412U);
    const ConfigItem changed{ConfigAddress{0U, ConfigField::kSrvt, 0U}, 50U};
    real_a.Store(changed);
    real_b.Store(changed);
    EXPECT_EQ(kernel.CheckConfiguration().result, Result::kSignatureError);
    EXPECT_EQ(kernel.CheckConfiguration().index.value, 0x1301U);
}

TEST_F(Configuring, CheckInOperationalLooksAtTheResolvedMappingAndResolvesNothing)
{
    Verifies(req::SRS_KRN_210);
    Operate();
    a.validated = kNoSlot;
    b.validated = kNoSlot;
    // Given a resolved mapping that both channels find changed
    a.check_fault = ConfigFault::kTable;
    b.check_fault = ConfigFault::kTable;
    // When the configuration is checked, then that is told of the first SRDO, and no mapping was resolved anew
    EXPECT_EQ(kernel.CheckConfiguration().result, Result::kMappingError);
    EXPECT_EQ(kernel.CheckConfiguration().index.value, 0x1301U);
    EXPECT_EQ(a.validated, kNoSlot);
    EXPECT_EQ(b.validated, kNoSlot);
    // And outside of OPERATIONAL it is
    kernel.SetNmtState(NmtState::kPreOperational);
    (void)kernel.CheckConfiguration();
    EXPECT_EQ(a.validated, 0U);
    EXPECT_EQ(b.validated, 0U);
}

TEST_F(Configuring, ChannelsThatNameDifferentRulesInOperationalDisagree)
{
    Verifies(req::SRS_KRN_212);
    Operate();
    b.check_fault = ConfigFault::kTable;
    EXPECT_EQ(kernel.CheckConfiguration().result, Result::kDeviceFault);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
}

TEST_F(Configuring, ABrokenRuleIsToldBeforeADigestThatIsNotExpected)
{
    Verifies(req::SRS_KRN_211);
    Configure();
    config.digest = 0x12345678U;
    ASSERT_EQ(kernel.CheckConfiguration().result, Result::kInvalidConfiguration);
    ASSERT_EQ(kernel.CheckConfiguration().index.value, 0U);
    // When SRVT 50 ms is not below SCT 50 ms, too
    ASSERT_EQ(Write(0x1301U, 3U, 50U, 1U), AbortCode::kNone);
    // Then the rule and its SRDO are told
    EXPECT_EQ(kernel.CheckConfiguration().result, Result::kTimingError);
    EXPECT_EQ(kernel.CheckConfiguration().index.value, 0x1301U);
}

// Diagnostic interval 30 ms, three SRDOs: six steps, one every 5 cycles, the digest of slot n in step 2n + 1.
TEST_F(Configuring, DigestsThatDifferAreFoundAtTheirSlot)
{
    Verifies(req::SRS_CFG_050);
    Operate();
    Cycles(60U);
    ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    b.digest_slot = 1U;
    b.digest_flip = 1U;
    Cycles(30U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(kernel.DeviceState().slot, 1U);
}

TEST_F(Configuring, DigestThatChangesInBothChannelsIsFoundByTheNextCompleteOne)
{
    Verifies(req::SRS_CFG_050);
    Operate();
    Cycles(60U);
    ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    for (Tap* const tap : std::initializer_list<Tap*>{&a, &b})
    {
        tap->digest_slot = 2U;
        tap->digest_flip = 0x80U;
    }
    Cycles(60U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kConfiguration);
    EXPECT_EQ(kernel.DeviceState().slot, 0xFFU);
}

// Two diagnostic intervals are 60 cycles. The kernel asks the provider by the form in the description.
TEST_F(Configuring, AFlippedBitOfTheFormOfAProducerIsFoundWithinTwoDiagnosticIntervals)
{
    Verifies(req::SRS_CFG_800);
    for (std::uint32_t bit = 0U; bit < 8U; ++bit)
    {
        for (std::uint32_t phase = 0U; phase < 30U; ++phase)
        {
            // Given a producer whose provider is called, when a bit of its form flips in any phase of the diagnosis
            Operate();
            Cycles(30U + phase);
            ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
            setups[1].form =
                static_cast<ProducerForm>(static_cast<std::uint32_t>(ProducerForm::kProviderCalled) ^ (1U << bit));
            Cycles(60U);
            // Then the device is in its safe state, and nothing is sent any more
            EXPECT_NE(kernel.DeviceState().fault, DeviceFault::kNone) << "bit " << bit << " phase " << phase;
            EXPECT_EQ(kernel.DeviceState().slot, 1U) << "bit " << bit << " phase " << phase;
            ports.sent.clear();
            Cycles(60U);
            EXPECT_TRUE(ports.sent.empty());
            setups[1].form = ProducerForm::kProviderCalled;
        }
    }
}

TEST_F(Configuring, DigestOfAnUndeclaredConfigurationIsNotCompared)
{
    Verifies(req::SRS_CFG_050);
    Configure();
    ASSERT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
    a.digest_flip = 0x80U;
    b.digest_flip = 0x80U;
    Cycles(100U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(Configuring, WriteToGfcParameterHasBothChannelsComputeAtOnce)
{
    Verifies(req::SRS_CFG_150);
    Operate();
    b.digest_slot = 2U;
    b.digest_flip = 1U;
    ASSERT_EQ(Write(0x1300U, 0U, 0U, 1U), AbortCode::kNone);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(kernel.DeviceState().slot, 2U);
}

TEST_F(Configuring, WriteOfAnotherObjectComputesNoDigest)
{
    Verifies(req::SRS_CFG_150);
    Configure();
    a.digests = 0;
    b.digests = 0;
    ASSERT_EQ(Write(0x1303U, 2U, 30U, 2U), AbortCode::kNone);
    EXPECT_EQ(a.digests, 0);
    EXPECT_EQ(b.digests, 0);
    ASSERT_EQ(Write(0x1300U, 0U, 0U, 1U), AbortCode::kNone);
    EXPECT_EQ(a.digests, 3);
    EXPECT_EQ(b.digests, 3);
}

TEST_F(Configuring, ValidityIsStoredWithoutASubIndex)
{
    Verifies(req::SRS_CFG_046);
    Configure();
    EXPECT_EQ(a.last_stored.address.field, ConfigField::kConfigurationValid);
    EXPECT_EQ(a.last_stored.address.sub, 0U);
    EXPECT_EQ(a.last_stored.value, 0xA5U);
}

// t [cycles]   12 digest of slot 0 done     1300h written     30 digest of slot 2 done: not compared
TEST_F(Configuring, WriteToGfcParameterTakesTheDigestAnew)
{
    Verifies(req::SRS_CFG_150);
    Operate();
    Cycles(12U);
    // Given channels whose digest changes because of the write
    a.digest_flip = 0x80U;
    b.digest_flip = 0x80U;
    ASSERT_EQ(Write(0x1300U, 0U, 0U, 1U), AbortCode::kNone);
    Cycles(100U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    // An identical value takes nothing anew
    a.digest_flip = 0x40U;
    b.digest_flip = 0x40U;
    ASSERT_EQ(Write(0x1300U, 0U, 0U, 1U), AbortCode::kNone);
    Cycles(60U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kConfiguration);
}

TEST_F(Configuring, DeclarationNeedsEqualAndExpectedDigests)
{
    Verifies(req::SRS_CFG_151);
    Configure();
    ASSERT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
    // Given channels with the digest that the device's description does not name
    a.digest_slot = 2U;
    b.digest_slot = 2U;
    const std::uint32_t found = real_a.Digest(2U, real_a.Digest(1U, real_a.Digest(0U, DeviceDigest{0U}))).value;
    config.digest = found ^ 0x12345678U;
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kIncompatible);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    // then with the one that it names
    a.digest_flip = 0x12345678U;
    b.digest_flip = 0x12345678U;
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    // and with two that differ, at the first slot alone
    a.digest_slot = 0U;
    a.digest_flip = 0x12345678U;
    b.digest_flip = 0U;
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kIncompatible);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
}

TEST_F(Configuring, FirstOfSeveralBrokenSignaturesIsToldOnEnteringOperational)
{
    Verifies(req::SRS_KRN_223);
    Configure();
    for (const SlotIndex slot : std::initializer_list<SlotIndex>{2U, 1U})
    {
        const ConfigItem changed{ConfigAddress{slot, ConfigField::kSrvt, 0U}, 21U};
        real_a.Store(changed);
        real_b.Store(changed);
    }
    kernel.SetNmtState(NmtState::kOperational);
    EXPECT_EQ(application.invalid, std::vector<std::uint16_t>{0x1303U});
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
}

// Whichever channel finds it: the other one was asked as well, and they differ.
TEST_F(Configuring, EitherChannelAloneKeepsSrdosOffOnEnteringOperational)
{
    Verifies(req::SRS_KRN_223);
    for (Tap* const tap : {&a, &b})
    {
        application.invalid.clear();
        Configure();
        tap->signature_flip = 1U;
        kernel.SetNmtState(NmtState::kOperational);
        tap->signature_flip = 0U;
        EXPECT_EQ(application.invalid, std::vector<std::uint16_t>{0x1301U});
        EXPECT_EQ(Read(0x13FEU, 0U), 0U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
        EXPECT_EQ(kernel.DeviceState().slot, 0U);
    }
}

// t        OPERATIONAL   pair      cycle     PRE-OPERATIONAL   cycle
// writes   refused                           accepted
// SRDOs    off           ignored   waiting   waiting           off
TEST_F(Configuring, NmtStateIsThatOfWritesAtOnceAndOfSrdosWithTheCycle)
{
    Verifies(req::SRS_KRN_010);
    Configure();
    Cycle();
    kernel.SetNmtState(NmtState::kOperational);
    EXPECT_EQ(Write(0x1304U, 2U, 60U, 2U), AbortCode::kDeviceState);
    EXPECT_EQ(a.last_input.nmt, NmtState::kPreOperational);
    ReceivePair();
    Cycle();
    for (const Tap* const tap : {&a, &b})
    {
        EXPECT_EQ(tap->last_input.nmt, NmtState::kOperational);
    }
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kWaiting);
    EXPECT_EQ(Open(), 0U);
    kernel.SetNmtState(NmtState::kPreOperational);
    EXPECT_EQ(Write(0x1304U, 2U, 60U, 2U), AbortCode::kNone);
    EXPECT_EQ(a.last_input.nmt, NmtState::kOperational);
    Cycle();
    for (const Tap* const tap : {&a, &b})
    {
        EXPECT_EQ(tap->last_input.nmt, NmtState::kPreOperational);
    }
}

TEST_F(Configuring, ChangedCopyOf13FEhIsFoundInTheNextCycle)
{
    Verifies(req::SRS_CFG_048);
    Verifies(req::SRS_CMP_002);
    const std::vector<std::vector<Channel*>> changed{{&real_a}, {&real_b}, {&real_a, &real_b}};
    for (const std::vector<Channel*>& channels : changed)
    {
        for (const std::uint32_t value : {0x00U, 0xA4U, 0x5AU})
        {
            Operate();
            ReceivePair();
            Cycle();
            ASSERT_EQ(Open(), 1U);
            for (Channel* const channel : channels)
            {
                channel->Store(ConfigItem{ConfigAddress{0U, ConfigField::kConfigurationValid, 0U}, value});
            }
            Cycle();
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kGuard) << channels.size() << " " << value;
            EXPECT_EQ(kernel.DeviceState().slot, kNoSlot);
            EXPECT_EQ(Open(), 0U);
        }
    }
}

TEST_F(Configuring, DeclarationIsOfEverySrdoInBothChannels)
{
    Verifies(req::SRS_CFG_046);
    Configure();
    EXPECT_EQ(a.validated, 2U);
    EXPECT_EQ(b.validated, 2U);
    for (const std::uint8_t number : std::initializer_list<std::uint8_t>{1, 3, 4})
    {
        Configure();
        ASSERT_EQ(Write(0x13FFU, number, Read(0x13FFU, number) ^ 1U, 2U), AbortCode::kNone);
        EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kIncompatible) << static_cast<int>(number);
        EXPECT_EQ(Read(0x13FEU, 0U), 0U);
    }
}

} // namespace
} // namespace counterpoint
