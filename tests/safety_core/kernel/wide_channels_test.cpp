// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Options of the reference that live in the channels, seen through the kernel: on here, off in the tests named.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{
namespace
{

class WideChannels : public Rig
{
  public:
    /// Configures SRDO 1 as consumer of 101h/102h, SCT 50 ms, with what is mapped already, signs and enters
    /// OPERATIONAL.
    void OperateConsumer()
    {
        ASSERT_EQ(Write(0x1301U, 2U, 50U, 2U), AbortCode::kNone);
        ASSERT_EQ(Write(0x1301U, 5U, 0x101U, 4U), AbortCode::kNone);
        ASSERT_EQ(Write(0x1301U, 6U, 0x102U, 4U), AbortCode::kNone);
        ASSERT_EQ(Write(0x1301U, 1U, 2U, 1U), AbortCode::kNone);
        for (const std::uint8_t number : std::initializer_list<std::uint8_t>{1, 3, 4})
        {
            const SignReply reply = kernel.Sign(CommunicationIndex{static_cast<std::uint16_t>(0x1300U + number)});
            ASSERT_EQ(Write(0x13FFU, number, reply.signature, 2U), AbortCode::kNone);
        }
        ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
        kernel.SetNmtState(NmtState::kOperational);
        Cycle();
    }
};

// Off: ReturnCode.SrvtTimeout finds it by the cycle in which SRVT has expired.
TEST_F(WideChannels, LateDetectionFindsAMissingInverseFrameBySct)
{
    Verifies(req::SRS_TIME_009);
    setups[0].detection = SrvtDetection::kLate;
    Operate();
    ReceivePair(); // 6.1 ms, 6.2 ms
    Cycle();
    ASSERT_EQ(Open(), 1U);
    Receive(0x101U, {0x12U, 0x34U}, 100U);
    Cycles(49U); // 56 ms
    EXPECT_TRUE(CausesOf(0x1301U).empty());
    EXPECT_EQ(Open(), 1U);
    Cycle();
    EXPECT_EQ(CausesOf(0x1301U), std::vector<SrdoCause>{SrdoCause::kSct});
    EXPECT_EQ(Open(), 0U);
}

TEST_F(WideChannels, LateDetectionFindsAnInverseFrameThatComesTooLate)
{
    Verifies(req::SRS_TIME_009);
    setups[0].detection = SrvtDetection::kLate;
    Operate();
    Receive(0x101U, {0x12U, 0x34U}, 100U); // 6.1 ms
    Cycles(22U);
    EXPECT_TRUE(CausesOf(0x1301U).empty());
    Receive(0x102U, {0xEDU, 0xCBU}, 100U);
    Cycle();
    ASSERT_FALSE(CausesOf(0x1301U).empty());
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).first_cause, SrdoCause::kSrvt);
}

// Off: SafetyObjects.DummyEntriesAreUnknownWhereRefused.
TEST_F(WideChannels, DummyTakesPartInLengthAndInversionAndIsNotWritten)
{
    Verifies(req::SRS_CFG_033);
    config.dummies = DummyMapping::kAllowed;
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    ASSERT_EQ(Write(0x1381U, 1U, 0x00050008U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1381U, 2U, 0x00050008U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1381U, 3U, 0x22000110U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1381U, 4U, 0x23000110U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1381U, 0U, 4U, 1U), AbortCode::kNone);
    OperateConsumer();
    Receive(0x101U, {0x55U, 0x12U, 0x34U}, 100U);
    Receive(0x102U, {0xAAU, 0xEDU, 0xCBU}, 100U);
    Cycle();
    EXPECT_EQ(Open(), 1U);
    EXPECT_EQ(NormalOut(), 0x3412U);
    Receive(0x101U, {0x55U, 0x12U, 0x34U}, 100U);
    Receive(0x102U, {0xABU, 0xEDU, 0xCBU}, 100U);
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(CausesOf(0x1301U), std::vector<SrdoCause>{SrdoCause::kNotInverse});
}

TEST_F(WideChannels, DummyOfAProducerIsAMappingError)
{
    Verifies(req::SRS_CFG_033);
    config.dummies = DummyMapping::kAllowed;
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    ASSERT_EQ(Write(0x1381U, 1U, 0x00050008U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1381U, 2U, 0x00050008U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1381U, 0U, 2U, 1U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1301U, 1U, 1U, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kIncompatible);
}

// Off: every test of a dynamic mapping, e.g. Cycling.GoodPairIsReleasedOnBothSidesAndOpensTheOutput.
TEST_F(WideChannels, StaticMappingIsReadAndReceivedThroughItsFields)
{
    Verifies(req::SRS_CFG_032);
    Verifies(req::SRS_KRN_024);
    static constexpr std::uint32_t kEntries[] = {0x22000110U, 0x23000110U};
    setups[0].map = StaticMap{kEntries, 2U};
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    EXPECT_EQ(Read(0x1381U, 0U), 2U);
    EXPECT_EQ(Read(0x1381U, 1U), 0x22000110U);
    EXPECT_EQ(Read(0x1381U, 2U), 0x23000110U);
    ASSERT_EQ(kernel.DefineStaticFields(CommunicationIndex{0x1301U}, StaticFields{rx_normal.data(), rx_inverse.data()}),
              Result::kSuccessful);
    OperateConsumer();
    ReceivePair();
    Cycle();
    EXPECT_EQ(Open(), 1U);
    EXPECT_EQ(NormalOut(), 0x3412U);
    EXPECT_EQ(InverseOut(), 0xCBEDU);
}

TEST_F(WideChannels, StaticFieldsElsewhereThanTheObjectsAreAMappingError)
{
    Verifies(req::SRS_CFG_032);
    Verifies(req::SRS_KRN_218);
    static constexpr std::uint32_t kEntries[] = {0x22000110U, 0x23000110U};
    setups[0].map = StaticMap{kEntries, 2U};
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    ASSERT_EQ(Write(0x1301U, 5U, 0x101U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1301U, 6U, 0x102U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1301U, 2U, 50U, 2U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1301U, 1U, 2U, 1U), AbortCode::kNone);
    EXPECT_EQ(kernel.DefineStaticFields(CommunicationIndex{0x1301U}, StaticFields{tx_normal.data(), rx_inverse.data()}),
              Result::kMappingError);
    EXPECT_EQ(kernel.DefineStaticFields(CommunicationIndex{0x1301U}, StaticFields{nullptr, nullptr}),
              Result::kMappingError);
}

// Granularity 1 with objects of 3 and 5 bits; granularity 8 refuses them.
TEST_F(WideChannels, GranularityDecidesAboutObjectsOfBits)
{
    Verifies(req::SRS_CFG_036);
    Verifies(req::SRS_CFG_027);
    for (const std::uint8_t granularity : std::initializer_list<std::uint8_t>{8, 1})
    {
        config.granularity_bits = granularity;
        objects[2].length_bits = 11U;
        objects[3].length_bits = 11U;
        setups[0].safe_value = Payload{0U, 0U};
        ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
        ASSERT_EQ(Write(0x1381U, 1U, 0x2200010BU, 4U), AbortCode::kNone);
        ASSERT_EQ(Write(0x1381U, 2U, 0x2300010BU, 4U), AbortCode::kNone);
        ASSERT_EQ(Write(0x1381U, 0U, 2U, 1U), AbortCode::kNone);
        if (granularity == 8U)
        {
            ASSERT_EQ(Write(0x1301U, 5U, 0x101U, 4U), AbortCode::kNone);
            ASSERT_EQ(Write(0x1301U, 6U, 0x102U, 4U), AbortCode::kNone);
            ASSERT_EQ(Write(0x1301U, 2U, 50U, 2U), AbortCode::kNone);
            ASSERT_EQ(Write(0x1301U, 1U, 2U, 1U), AbortCode::kNone);
            EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kIncompatible);
        }
    }
    OperateConsumer();
    // 11 bits in two bytes: bits above them are 0 in the normal and 1 in the inverse frame
    Receive(0x101U, {0x34U, 0x02U}, 100U);
    Receive(0x102U, {0xCBU, 0xFDU}, 100U);
    Cycle();
    EXPECT_EQ(Open(), 1U);
    EXPECT_EQ(NormalOut(), 0x0234U);
    EXPECT_EQ(InverseOut(), 0x05CBU);
    Receive(0x101U, {0x34U, 0x0AU}, 100U);
    Receive(0x102U, {0xCBU, 0xF5U}, 100U);
    Cycle();
    EXPECT_EQ(CausesOf(0x1301U), std::vector<SrdoCause>{SrdoCause::kNotInverse});
}

// Table 4 of SO-1059: UNSIGNED16, two UNSIGNED8 and a REAL32 fill the frame.
//   byte   0  1    2        3        4  5  6  7
//          2000:03 2001:01  2001:02  2002:06
TEST_F(WideChannels, MappingOfTheReferencesTable)
{
    Verifies(req::SRS_CFG_036);
    Verifies(req::SRS_CFG_010);
    std::array<std::uint8_t, 8> normal{};
    std::array<std::uint8_t, 8> inverse{};
    std::array<MappableObject, 8> own{};
    const auto object = [](std::uint16_t index, std::uint8_t sub, std::uint8_t bits, std::uint8_t* place)
    { return MappableObject{index, sub, bits, MapAccess::kConsumer, place}; };
    own = {object(0x2000U, 3U, 16U, &normal[0]),  object(0x2001U, 1U, 8U, &normal[2]),
           object(0x2001U, 2U, 8U, &normal[3]),   object(0x2002U, 6U, 32U, &normal[4]),
           object(0x2100U, 3U, 16U, &inverse[0]), object(0x2101U, 1U, 8U, &inverse[2]),
           object(0x2101U, 2U, 8U, &inverse[3]),  object(0x2102U, 6U, 32U, &inverse[4])};
    config.objects = own.data();
    config.object_count = 8U;
    setups[0].safe_value = Payload{0U, 0U};
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    constexpr std::array<std::uint32_t, 8> kTable{0x20000310U, 0x21000310U, 0x20010108U, 0x21010108U,
                                                  0x20010208U, 0x21010208U, 0x20020620U, 0x21020620U};
    for (std::uint8_t number = 0U; number < 8U; ++number)
    {
        ASSERT_EQ(Write(0x1381U, static_cast<std::uint8_t>(number + 1U), kTable[number], 4U), AbortCode::kNone);
    }
    ASSERT_EQ(Write(0x1381U, 0U, 8U, 1U), AbortCode::kNone);
    OperateConsumer();
    EXPECT_EQ(Read(0x13FFU, 1U), 0x9335U); // Direction 2, 50 ms, 20 ms, 101h, 102h.
    Receive(0x101U, {0x34U, 0x12U, 0x56U, 0x78U, 0x00U, 0x00U, 0xC0U, 0x3FU}, 100U);
    Receive(0x102U, {0xCBU, 0xEDU, 0xA9U, 0x87U, 0xFFU, 0xFFU, 0x3FU, 0xC0U}, 100U);
    Cycle();
    EXPECT_EQ(Open(), 1U);
    EXPECT_EQ(normal, (std::array<std::uint8_t, 8>{0x34U, 0x12U, 0x56U, 0x78U, 0x00U, 0x00U, 0xC0U, 0x3FU})); // 1.5
    EXPECT_EQ(inverse, (std::array<std::uint8_t, 8>{0xCBU, 0xEDU, 0xA9U, 0x87U, 0xFFU, 0xFFU, 0x3FU, 0xC0U}));
    EXPECT_EQ(kernel.GetParameters(CommunicationIndex{0x1301U}).map_count, 8U);
    EXPECT_EQ(kernel.GetMapped(CommunicationIndex{0x1301U}, MappedEntry{7U}).variable.place, &normal[4]);
    EXPECT_EQ(kernel.GetMapped(CommunicationIndex{0x1301U}, MappedEntry{7U}).variable.length_bits, 32U);
}

TEST_F(WideChannels, DigestOfTheDescriptionIsThatOfBothChannels)
{
    Verifies(req::SRS_CFG_050);
    Verifies(req::SRS_CFG_151);
    Verifies(req::SRS_CFG_034);
    Configure();
    const std::uint32_t digest = real_a.Digest(2U, real_a.Digest(1U, real_a.Digest(0U, DeviceDigest{0U}))).value;
    EXPECT_NE(digest, 0U);
    EXPECT_EQ(real_b.Digest(2U, real_b.Digest(1U, real_b.Digest(0U, DeviceDigest{0U}))).value, digest);
    config.digest = digest;
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    // Another safe value is another device
    setups[0].safe_value = Payload{0x7F02U, 0U};
    config.digest = digest;
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kIncompatible);
}

} // namespace
} // namespace counterpoint
