// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{
namespace
{

class Facade : public Rig
{
};

// 02h 32 00 14 01 01 00 00 02 01 00 00 02 01 10 01 00 22 02 10 01 00 23
TEST_F(Facade, SignatureIsThatOfBothChannels)
{
    Verifies(req::SRS_KRN_151);
    Verifies(req::SRS_CFG_010);
    Configure();
    const SignReply reply = kernel.Sign(CommunicationIndex{0x1301U});
    EXPECT_EQ(reply.result, Result::kSuccessful);
    EXPECT_EQ(reply.signature, Read(0x13FFU, 1U));
    EXPECT_EQ(kernel.Sign(CommunicationIndex{0x1302U}).result, Result::kNotExist);
}

TEST_F(Facade, SignaturesThatDifferAreADisagreement)
{
    Verifies(req::SRS_KRN_151);
    Configure();
    b.signature_flip = 2U;
    EXPECT_EQ(kernel.Sign(CommunicationIndex{0x1301U}).result, Result::kDeviceFault);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(kernel.DeviceState().slot, 0U);
}

TEST_F(Facade, StateOfEachSrdo)
{
    Verifies(req::SRS_KRN_152);
    Operate();
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1302U}).result, Result::kNotExist);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kWaiting);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1303U}).state, SrdoState::kProducer);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1304U}).state, SrdoState::kOff);
    ReceivePair();
    Cycle();
    const StateReply reply = kernel.GetState(CommunicationIndex{0x1301U});
    EXPECT_EQ(reply.result, Result::kSuccessful);
    EXPECT_EQ(reply.state, SrdoState::kReleased);
    EXPECT_EQ(reply.first_cause, SrdoCause::kNone);
    EXPECT_EQ(reply.error_count, 0U);
}

TEST_F(Facade, StateThatTheChannelsDoNotShareIsFaulted)
{
    Verifies(req::SRS_KRN_152);
    Operate();
    ReceivePair();
    Cycle();
    real_b.Demote(0U);
    const StateReply reply = kernel.GetState(CommunicationIndex{0x1301U});
    EXPECT_EQ(reply.state, SrdoState::kFaulted);
    // Channel A knows of nothing
    EXPECT_EQ(reply.first_cause, SrdoCause::kDemoted);
    EXPECT_EQ(reply.error_count, 1U);
    real_a.Demote(0U);
    real_a.Demote(0U);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).error_count, 2U);
}

TEST_F(Facade, CauseIsThatOfTheChannelThatFoundIt)
{
    Verifies(req::SRS_KRN_152);
    Operate();
    ReceivePair();
    Cycle();
    // Given an inverse frame without a normal one before it, that channel B alone sees
    a.drop_frames = true;
    Receive(0x102U, {0xEDU, 0xCBU}, 100U);
    a.drop_frames = false;
    Cycle();
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).first_cause, SrdoCause::kInverseFirst);
    // When channel A alone sees it, then it tells its own
    Operate();
    b.drop_frames = true;
    Receive(0x102U, {0xEDU, 0xCBU}, 100U);
    b.drop_frames = false;
    Cycle();
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).first_cause, SrdoCause::kInverseFirst);
}

TEST_F(Facade, NothingIsReleasedInTheDeviceSafeState)
{
    Verifies(req::SRS_KRN_152);
    Verifies(req::SRS_KRN_031);
    Verifies(req::SRS_KRN_342);
    Operate();
    ReceivePair();
    Cycle();
    ASSERT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kReleased);
    // When the application demands the device safe state, then it is told at once
    kernel.DemandSafeState();
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kFaulted);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kApplication);
    EXPECT_EQ(kernel.DeviceState().slot, 0xFFU);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kDeviceFault);
    // and outputs and objects are safe with the next cycle, whatever still comes
    for (std::uint32_t cycle = 0U; cycle < 5U; ++cycle)
    {
        ReceivePair();
        Cycle();
        EXPECT_EQ(Open(), 0U);
        EXPECT_EQ(NormalOut(), 0x7F01U);
        EXPECT_EQ(InverseOut(), 0x80FEU);
        EXPECT_NE(kernel.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kReleased);
    }
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1303U}).state, SrdoState::kProducer);
    EXPECT_EQ(application.faults, std::vector<DeviceFault>{DeviceFault::kApplication});
}

TEST_F(Facade, DemandBeforeStartHasNoEffect)
{
    Verifies(req::SRS_KRN_031);
    kernel.DemandSafeState();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kInvalid);
    Operate();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    EXPECT_EQ(kernel.DeviceState().count, 0U);
}

TEST_F(Facade, DigestIsToldAndCheckedAsTheConfigurationIs)
{
    Verifies(req::SRS_KRN_211);
    Verifies(req::SRS_KRN_150);
    EXPECT_EQ(kernel.Digest().result, Result::kDeviceFault);
    Operate();
    const std::uint32_t digest = real_a.Digest(2U, real_a.Digest(1U, real_a.Digest(0U, DeviceDigest{0U}))).value;
    EXPECT_EQ(kernel.Digest().result, Result::kSuccessful);
    EXPECT_EQ(kernel.Digest().digest, digest);
    EXPECT_EQ(kernel.CheckConfiguration().result, Result::kSuccessful);
    // Given another one that is expected, then the computed one is still told
    config.digest = digest ^ 1U;
    EXPECT_EQ(kernel.Digest().result, Result::kInvalidConfiguration);
    EXPECT_EQ(kernel.Digest().digest, digest);
    EXPECT_EQ(kernel.CheckConfiguration().result, Result::kInvalidConfiguration);
    EXPECT_EQ(kernel.CheckConfiguration().index.value, 0U);
    kernel.SetNmtState(NmtState::kPreOperational);
    EXPECT_EQ(kernel.CheckConfiguration().result, Result::kInvalidConfiguration);
    config.digest = digest;
    EXPECT_EQ(kernel.CheckConfiguration().result, Result::kSuccessful);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    // Given channels that differ at the second slot
    b.digest_slot = 1U;
    b.digest_flip = 1U;
    EXPECT_EQ(kernel.Digest().result, Result::kDeviceFault);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(kernel.DeviceState().slot, 1U);
}

// t [cycles]   the digest of the cycles takes ten of them for each slot; it is asked for in every one
TEST_F(Facade, DigestThatIsAskedForDoesNotDisturbTheCyclicOne)
{
    Verifies(req::SRS_KRN_150);
    Verifies(req::SRS_CFG_050);
    Operate();
    Cycles(60U);
    a.digest_flip = 0x80U;
    b.digest_flip = 0x80U;
    for (std::uint32_t cycle = 0U; cycle < 60U; ++cycle)
    {
        ASSERT_EQ(kernel.Digest().result, Result::kSuccessful);
        Cycle();
    }
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kConfiguration);
}

TEST_F(Facade, ParametersOfAnSrdo)
{
    Verifies(req::SRS_KRN_023);
    Configure();
    const ParametersReply consumer = kernel.GetParameters(CommunicationIndex{0x1301U});
    EXPECT_EQ(consumer.result, Result::kSuccessful);
    EXPECT_EQ(consumer.direction, 2U);
    EXPECT_EQ(consumer.refresh_ms, 50U);
    EXPECT_EQ(consumer.map_count, 2U);
    const ParametersReply off = kernel.GetParameters(CommunicationIndex{0x1304U});
    EXPECT_EQ(off.result, Result::kSuccessful);
    EXPECT_EQ(off.direction, 0U);
    EXPECT_EQ(off.refresh_ms, 25U);
    EXPECT_EQ(off.map_count, 0U);
    EXPECT_EQ(kernel.GetParameters(CommunicationIndex{0x1302U}).result, Result::kNotExist);
}

TEST_F(Facade, MappedVariablesByNumber)
{
    Verifies(req::SRS_KRN_023);
    Configure();
    const MappedReply first = kernel.GetMapped(CommunicationIndex{0x1301U}, MappedEntry{1U});
    EXPECT_EQ(first.result, Result::kSuccessful);
    EXPECT_EQ(first.variable.place, rx_normal.data());
    EXPECT_EQ(first.variable.length_bits, 16U);
    EXPECT_EQ(kernel.GetMapped(CommunicationIndex{0x1301U}, MappedEntry{2U}).variable.place, rx_inverse.data());
    EXPECT_EQ(kernel.GetMapped(CommunicationIndex{0x1301U}, MappedEntry{0U}).result, Result::kNotExist);
    EXPECT_EQ(kernel.GetMapped(CommunicationIndex{0x1301U}, MappedEntry{3U}).result, Result::kNotExist);
    EXPECT_EQ(kernel.GetMapped(CommunicationIndex{0x1304U}, MappedEntry{1U}).result, Result::kNotExist);
    EXPECT_EQ(kernel.GetMapped(CommunicationIndex{0x1302U}, MappedEntry{1U}).result, Result::kNotExist);
}

TEST_F(Facade, MappedDummyHasALengthAndNoPlace)
{
    Verifies(req::SRS_KRN_023);
    config.dummies = DummyMapping::kAllowed;
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    ASSERT_EQ(Write(0x1381U, 1U, 0x00060010U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1381U, 2U, 0x00060010U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1381U, 0U, 2U, 1U), AbortCode::kNone);
    const MappedReply reply = kernel.GetMapped(CommunicationIndex{0x1301U}, MappedEntry{1U});
    EXPECT_EQ(reply.result, Result::kSuccessful);
    EXPECT_EQ(reply.variable.place, nullptr);
    EXPECT_EQ(reply.variable.length_bits, 16U);
}

TEST_F(Facade, StaticFieldsNeedAStaticMappingOutsideOperational)
{
    Verifies(req::SRS_KRN_024);
    Verifies(req::SRS_KRN_217);
    Configure();
    const StaticFields fields{rx_normal.data(), rx_inverse.data()};
    EXPECT_EQ(kernel.DefineStaticFields(CommunicationIndex{0x1302U}, fields), Result::kNotExist);
    EXPECT_EQ(kernel.DefineStaticFields(CommunicationIndex{0x1301U}, fields), Result::kMappingError);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    kernel.SetNmtState(NmtState::kOperational);
    EXPECT_EQ(kernel.DefineStaticFields(CommunicationIndex{0x1301U}, fields), Result::kNmtError);
    EXPECT_EQ(a.fields_set, 0);
    EXPECT_EQ(b.fields_set, 0);
}

TEST_F(Facade, StaticFieldsThatAreRefusedAreNotKept)
{
    Verifies(req::SRS_KRN_219);
    static constexpr std::uint32_t kEntries[] = {0x22000110U, 0x23000110U};
    setups[2].map = StaticMap{kEntries, 2U};
    Configure();
    const CommunicationIndex index{0x1304U};
    ASSERT_EQ(kernel.DefineStaticFields(index, StaticFields{rx_normal.data(), rx_inverse.data()}), Result::kSuccessful);
    EXPECT_EQ(a.last_fields.normal, rx_normal.data());
    EXPECT_EQ(b.last_fields.inverse, rx_inverse.data());
    ASSERT_EQ(kernel.DefineStaticFields(index, StaticFields{tx_normal.data(), rx_inverse.data()}),
              Result::kMappingError);
    for (const Tap* const tap : {&a, &b})
    {
        EXPECT_EQ(tap->last_fields.normal, nullptr);
        EXPECT_EQ(tap->last_fields.inverse, nullptr);
    }
}

TEST_F(Facade, StaticFieldsAreCheckedByBothChannels)
{
    Verifies(req::SRS_KRN_024);
    static constexpr std::uint32_t kEntries[] = {0x22000110U, 0x23000110U};
    setups[2].map = StaticMap{kEntries, 2U};
    Configure();
    const CommunicationIndex index{0x1304U};
    const StaticFields fields{rx_normal.data(), rx_inverse.data()};
    const auto gives = [this, index, &fields](ConfigFault rule, Result result)
    {
        a.check_fault = rule;
        b.check_fault = rule;
        EXPECT_EQ(kernel.DefineStaticFields(index, fields), result);
    };
    // Given an SRDO that is off
    EXPECT_EQ(kernel.DefineStaticFields(index, fields), Result::kSuccessful);
    EXPECT_EQ(a.fields_set, 1);
    EXPECT_EQ(b.fields_set, 1);
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
    gives(ConfigFault::kMapping, Result::kMappingError);
    gives(ConfigFault::kLengthExceeded, Result::kLengthExceeded);
    gives(ConfigFault::kSignature, Result::kSuccessful);
    gives(ConfigFault::kTiming, Result::kSuccessful);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    b.check_fault = ConfigFault::kMapping;
    EXPECT_EQ(kernel.DefineStaticFields(index, fields), Result::kDeviceFault);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
}

// The reference defines the fields before it writes the direction: SRDO 4 is off.
TEST_F(Facade, StaticFieldsAreComparedWithTheObjectsWhateverTheDirectionIs)
{
    Verifies(req::SRS_KRN_218);
    static constexpr std::uint32_t kEntries[] = {0x22000110U, 0x23000110U};
    static constexpr std::uint32_t kUnknown[] = {0x22000110U, 0x23000210U};
    static constexpr std::uint32_t kShorter[] = {0x22000108U, 0x23000108U};
    static constexpr std::uint32_t kNoBytes[] = {0x2200010CU, 0x2300010CU};
    const CommunicationIndex index{0x1304U};
    const auto gives = [this, index](std::uint8_t* normal, std::uint8_t* inverse)
    { return kernel.DefineStaticFields(index, StaticFields{normal, inverse}); };
    setups[2].map = StaticMap{kEntries, 2U};
    Configure();
    ASSERT_EQ(Read(0x1304U, 1U), 0U);
    EXPECT_EQ(gives(rx_normal.data(), rx_inverse.data()), Result::kSuccessful);
    EXPECT_EQ(gives(tx_normal.data(), rx_inverse.data()), Result::kMappingError);
    EXPECT_EQ(gives(rx_normal.data(), tx_inverse.data()), Result::kMappingError);
    EXPECT_EQ(gives(rx_inverse.data(), rx_normal.data()), Result::kMappingError);
    EXPECT_EQ(gives(rx_normal.data() + 1U, rx_inverse.data()), Result::kMappingError);
    EXPECT_EQ(gives(nullptr, nullptr), Result::kMappingError);
    for (const std::uint32_t* const entries : {kUnknown, kShorter})
    {
        setups[2].map = StaticMap{entries, 2U};
        Configure();
        EXPECT_EQ(gives(rx_normal.data(), rx_inverse.data()), Result::kMappingError);
    }
    setups[2].map = StaticMap{kEntries, 2U};
    objects[2].length_bits = 12U;
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    EXPECT_EQ(gives(rx_normal.data(), rx_inverse.data()), Result::kMappingError);
    setups[2].map = StaticMap{kNoBytes, 2U};
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    EXPECT_EQ(gives(rx_normal.data(), rx_inverse.data()), Result::kMappingError);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

// Objects of 16 bits one behind the other: four fill a frame, five do not go into one.
TEST_F(Facade, StaticFieldsAreAsLongAsAFrameAtTheMost)
{
    Verifies(req::SRS_KRN_218);
    std::array<std::uint8_t, 10> normal{};
    std::array<std::uint8_t, 10> inverse{};
    std::array<MappableObject, 10> own{};
    std::array<std::uint32_t, 10> entries{};
    for (std::uint8_t number = 0U; number < 5U; ++number)
    {
        own[number] =
            MappableObject{0x3000U, number, 16U, MapAccess::kConsumer, normal.data() + (2U * std::size_t{number})};
        own[5U + number] =
            MappableObject{0x3001U, number, 16U, MapAccess::kConsumer, inverse.data() + (2U * std::size_t{number})};
        entries[2U * std::size_t{number}] = 0x30000010U + (std::uint32_t{number} << 8U);
        entries[(2U * std::size_t{number}) + 1U] = 0x30010010U + (std::uint32_t{number} << 8U);
    }
    config.objects = own.data();
    config.object_count = 10U;
    const auto gives = [this, &normal, &inverse, &entries](std::uint8_t count)
    {
        setups[0].map = StaticMap{entries.data(), count};
        EXPECT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
        return kernel.DefineStaticFields(CommunicationIndex{0x1301U}, StaticFields{normal.data(), inverse.data()});
    };
    EXPECT_EQ(gives(8U), Result::kSuccessful);
    EXPECT_EQ(gives(10U), Result::kLengthExceeded);
    EXPECT_EQ(gives(9U), Result::kLengthExceeded);
}

// Every state that an NMT event leads to; reset node and reset communication lead to kInitialising.
TEST_F(Facade, EveryNmtEventOutOfOperationalIsSafe)
{
    Verifies(req::SRS_KRN_027);
    for (const NmtState state : {NmtState::kInitialising, NmtState::kPreOperational, NmtState::kStopped})
    {
        Operate();
        ReceivePair();
        Cycle();
        ASSERT_EQ(Open(), 1U);
        kernel.SetNmtState(state);
        Cycle();
        EXPECT_EQ(Open(), 0U);
        EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kOff);
        EXPECT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kNmtError);
        EXPECT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
    }
}

// t   released   reset communication, defaults, configuration loaded, OPERATIONAL   pair: no release   acknowledge:
// released
TEST_F(Facade, InterlockSurvivesResetCommunicationAndALoadedConfiguration)
{
    Verifies(req::SRS_KRN_027);
    Verifies(req::SRS_REL_008);
    setups[0].policy = ReleasePolicy::kInterlock;
    Operate();
    ReceivePair();
    Cycle();
    Cycle();
    Cycle(1U);
    Cycle(1U);
    ASSERT_EQ(Open(), 1U);
    const ImageHeader header = kernel.Image().Header().header;
    std::vector<std::uint32_t> items;
    for (std::uint32_t number = 0U; number < header.count; ++number)
    {
        items.push_back(kernel.Image().ReadItem(number).value);
    }
    kernel.SetNmtState(NmtState::kInitialising);
    ASSERT_EQ(kernel.Image().RestoreDefaults(), Result::kSuccessful);
    for (std::uint32_t number = 0U; number < header.count; ++number)
    {
        ASSERT_EQ(kernel.Image().LoadItem(number, items[number]), Result::kSuccessful);
    }
    ASSERT_EQ(kernel.Image().Load(header), Result::kSuccessful);
    kernel.SetNmtState(NmtState::kPreOperational);
    kernel.SetNmtState(NmtState::kOperational);
    Cycle(1U);
    Cycle(1U);
    ReceivePair();
    Cycle(1U);
    EXPECT_EQ(Open(), 0U);
    Cycle();
    Cycle();
    EXPECT_EQ(Open(), 0U);
    Cycle(1U);
    EXPECT_EQ(Open(), 0U);
    Cycle(1U);
    EXPECT_EQ(Open(), 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(Facade, OfTwoCausesThatOfChannelAIsTold)
{
    Verifies(req::SRS_KRN_152);
    Operate();
    const auto told = [this](const SrdoCause of_a, const SrdoCause of_b)
    {
        a.first_cause = of_a;
        b.first_cause = of_b;
        return kernel.GetState(CommunicationIndex{0x1301U}).first_cause;
    };
    EXPECT_EQ(told(SrdoCause::kSct, SrdoCause::kSrvt), SrdoCause::kSct);
    EXPECT_EQ(told(SrdoCause::kSrvt, SrdoCause::kSct), SrdoCause::kSrvt);
    EXPECT_EQ(told(SrdoCause::kNone, SrdoCause::kSct), SrdoCause::kSct);
    EXPECT_EQ(told(SrdoCause::kDemoted, SrdoCause::kSct), SrdoCause::kSct);
    EXPECT_EQ(told(SrdoCause::kSct, SrdoCause::kDemoted), SrdoCause::kSct);
}

TEST_F(Facade, InterlockSurvivesEachNmtState)
{
    Verifies(req::SRS_KRN_027);
    setups[0].policy = ReleasePolicy::kInterlock;
    Operate();
    for (const NmtState state : {NmtState::kPreOperational, NmtState::kStopped, NmtState::kInitialising})
    {
        ReceivePair();
        Cycle();
        Cycle();
        EXPECT_EQ(Open(), 0U);
        Cycle(1U);
        Cycle(1U);
        ASSERT_EQ(Open(), 1U);
        // When OPERATIONAL is left and entered again, then a good pair alone releases nothing
        kernel.SetNmtState(state);
        Cycle(1U);
        kernel.SetNmtState(NmtState::kOperational);
        Cycle(1U);
        ReceivePair();
        for (std::uint32_t cycle = 0U; cycle < 5U; ++cycle)
        {
            Cycle(1U);
            EXPECT_EQ(Open(), 0U);
        }
    }
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

} // namespace
} // namespace counterpoint
