// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Every return code of the reference (SO-1059 2.13) has its counterpart here, provoked once each.
#include "tests/safety_core/kernel/image.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{
namespace
{

class ReturnCode : public Rig
{
  public:
    /// Causes that follow from what was received, told to the application by the next cycle.
    std::vector<SrdoCause> CausesAfterCycle()
    {
        Cycle();
        return CausesOf(0x1301U);
    }
    using Causes = std::vector<SrdoCause>;
    /// The header of what is there now, with 13FEh A5h.
    ImageHeader ValidHeader()
    {
        std::vector<std::uint32_t> items;
        const std::uint32_t count = kernel.Image().Header().header.count;
        for (std::uint32_t number = 0U; number < count; ++number)
        {
            items.push_back(kernel.Image().ReadItem(number).value);
        }
        return ImageHeader{count, image::CrcOf(image::WordsOf(items, 0xA5U)), 0xA5U};
    }

    std::array<MappableObject, 10> many{};
};

TEST_F(ReturnCode, NotExist)
{
    Verifies(req::SRS_KRN_028);
    Configure();
    EXPECT_EQ(kernel.Sign(CommunicationIndex{0x1302U}).result, Result::kNotExist);
}

TEST_F(ReturnCode, GranularityMismatch)
{
    Verifies(req::SRS_KRN_028);
    config.granularity_bits = 2U;
    EXPECT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kGranularity);
}

// SRVT 50 ms is not below SCT 50 ms
TEST_F(ReturnCode, CfgTimingError)
{
    Verifies(req::SRS_KRN_028);
    Configure();
    ASSERT_EQ(Write(0x1301U, 3U, 50U, 1U), AbortCode::kNone);
    EXPECT_EQ(kernel.Image().Load(ValidHeader()), Result::kTimingError);
}

// COB-IDs 0, which no write admits for an SRDO that is on: loaded
TEST_F(ReturnCode, CfgIdError)
{
    Verifies(req::SRS_KRN_028);
    Configure();
    ASSERT_EQ(kernel.Image().LoadItem(5U, 0U), Result::kSuccessful);
    EXPECT_EQ(kernel.Image().Load(ValidHeader()), Result::kIdError);
}

// SRDO 3 gets the COB-IDs of SRDO 1: loaded
TEST_F(ReturnCode, CanIdAlreadyInUse)
{
    Verifies(req::SRS_KRN_028);
    Configure();
    EXPECT_EQ(Write(0x1304U, 5U, 0x101U, 4U), AbortCode::kValueRange);
    ASSERT_EQ(kernel.Image().LoadItem(24U + 5U, 0x101U), Result::kSuccessful);
    ASSERT_EQ(kernel.Image().LoadItem(24U + 6U, 0x102U), Result::kSuccessful);
    EXPECT_EQ(kernel.Image().Load(ValidHeader()), Result::kIdInUse);
}

TEST_F(ReturnCode, CfgCrcError)
{
    Verifies(req::SRS_KRN_028);
    Configure();
    ASSERT_EQ(Write(0x13FFU, 1U, 0x1234U, 2U), AbortCode::kNone);
    EXPECT_EQ(kernel.CheckConfiguration().result, Result::kSignatureError);
    EXPECT_EQ(kernel.CheckConfiguration().index.value, 0x1301U);
}

TEST_F(ReturnCode, NmtError)
{
    Verifies(req::SRS_KRN_028);
    Configure();
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kNmtError);
}

TEST_F(ReturnCode, InvalidCfg)
{
    Verifies(req::SRS_KRN_028);
    Configure();
    ASSERT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kInvalidConfiguration);
}

TEST_F(ReturnCode, Invalid)
{
    Verifies(req::SRS_KRN_028);
    Operate();
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1304U}), Result::kInvalid);
}

TEST_F(ReturnCode, RxTxConflict)
{
    Verifies(req::SRS_KRN_028);
    Operate();
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1301U}), Result::kRxTxConflict);
}

TEST_F(ReturnCode, IllegalCanId)
{
    Verifies(req::SRS_KRN_028);
    Configure();
    EXPECT_EQ(Write(0x1304U, 5U, 0x181U, 4U), AbortCode::kValueRange);
    EXPECT_EQ(static_cast<std::uint32_t>(AbortCode::kValueRange), 0x06090030U);
}

TEST_F(ReturnCode, NotInOrder)
{
    Verifies(req::SRS_KRN_348);
    Operate();
    Receive(0x102U, {0xEDU, 0xCBU}, 100U);
    EXPECT_EQ(CausesAfterCycle(), Causes{SrdoCause::kInverseFirst});
    application.errors.clear();
    Cycles(60U);
    Receive(0x101U, {0x12U, 0x34U}, 100U);
    Receive(0x101U, {0x12U, 0x34U}, 100U);
    Cycle();
    EXPECT_EQ(CausesOf(0x1301U).back(), SrdoCause::kNormalTwice);
}

TEST_F(ReturnCode, SctTimeout)
{
    Verifies(req::SRS_KRN_348);
    Operate();
    ReceivePair();
    Cycles(51U);
    EXPECT_EQ(CausesOf(0x1301U), Causes{SrdoCause::kSct});
}

// Option SRVT before the first reception: early here, late in the tests of late detection.
TEST_F(ReturnCode, SrvtTimeout)
{
    Verifies(req::SRS_KRN_348);
    Operate();
    Receive(0x101U, {0x12U, 0x34U}, 100U);
    Cycles(20U);
    EXPECT_TRUE(CausesOf(0x1301U).empty());
    EXPECT_EQ(CausesAfterCycle(), Causes{SrdoCause::kSrvt});
}

TEST_F(ReturnCode, CanIdNotValid)
{
    Verifies(req::SRS_KRN_348);
    Operate();
    now_us += 100U;
    kernel.OnFrame(StampedFrame{CanFrame{0x101U, FrameKind::kData, CanPortId::kSecond, 2U, {0x12U, 0x34U}},
                                InstantPair{{now_us}, {now_us}}});
    EXPECT_EQ(CausesAfterCycle(), Causes{SrdoCause::kIdentifier});
}

TEST_F(ReturnCode, DlcNotValid)
{
    Verifies(req::SRS_KRN_348);
    Operate();
    Receive(0x101U, {0x12U}, 100U);
    EXPECT_EQ(CausesAfterCycle(), Causes{SrdoCause::kLength});
}

// An object of a producer mapped by a consumer
TEST_F(ReturnCode, ErrorMapp)
{
    Verifies(req::SRS_KRN_028);
    Configure();
    ASSERT_EQ(Write(0x1301U, 1U, 1U, 1U), AbortCode::kNone);
    EXPECT_EQ(kernel.Image().Load(ValidHeader()), Result::kMappingError);
}

// Five entries of 16 bits a side: loaded
TEST_F(ReturnCode, LengtExceeded)
{
    Verifies(req::SRS_KRN_028);
    for (std::size_t number = 0U; number < many.size(); ++number)
    {
        many[number] = MappableObject{static_cast<std::uint16_t>(0x3000U + number), 0U, 16U, MapAccess::kConsumer,
                                      rx_normal.data()};
    }
    config.objects = many.data();
    config.object_count = 10U;
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    for (std::uint32_t entry = 0U; entry < 10U; ++entry)
    {
        ASSERT_EQ(kernel.Image().LoadItem(8U + entry, 0x30000010U + (entry << 16U)), Result::kSuccessful);
    }
    EXPECT_EQ(Write(0x1381U, 0U, 10U, 1U), AbortCode::kMapTooLong);
    ASSERT_EQ(kernel.Image().LoadItem(7U, 10U), Result::kSuccessful);
    ASSERT_EQ(kernel.Image().LoadItem(1U, 2U), Result::kSuccessful);
    ASSERT_EQ(kernel.Image().LoadItem(2U, 50U), Result::kSuccessful);
    EXPECT_EQ(kernel.Image().Load(ValidHeader()), Result::kLengthExceeded);
}

TEST_F(ReturnCode, DataError)
{
    Verifies(req::SRS_KRN_348);
    Operate();
    Receive(0x101U, {0x12U, 0x34U}, 100U);
    Receive(0x102U, {0xEDU, 0xCAU}, 100U);
    EXPECT_EQ(CausesAfterCycle(), Causes{SrdoCause::kNotInverse});
}

TEST_F(ReturnCode, NotHandledInApp)
{
    Verifies(req::SRS_KRN_028);
    handshake = StatusHandshake::kRequired;
    Operate();
    Receive(0x102U, {0xEDU, 0xCBU}, 100U);
    Cycles(2U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kHandshake);
}

TEST(ResultOfARule, EachRuleHasItsOwnAndNoUnknownOneIsASuccess)
{
    Verifies(req::SRS_KRN_015);
    Verifies(req::SRS_KRN_028);
    EXPECT_EQ(ToResult(ConfigFault::kNone), Result::kSuccessful);
    EXPECT_EQ(ToResult(ConfigFault::kInvalid), Result::kDeviceFault);
    EXPECT_EQ(ToResult(ConfigFault::kDirection), Result::kInvalidConfiguration);
    EXPECT_EQ(ToResult(ConfigFault::kTransmissionType), Result::kInvalidConfiguration);
    EXPECT_EQ(ToResult(ConfigFault::kIdentifier), Result::kIdError);
    EXPECT_EQ(ToResult(ConfigFault::kIdentifierInUse), Result::kIdInUse);
    EXPECT_EQ(ToResult(ConfigFault::kTiming), Result::kTimingError);
    EXPECT_EQ(ToResult(ConfigFault::kMapping), Result::kMappingError);
    EXPECT_EQ(ToResult(ConfigFault::kLengthExceeded), Result::kLengthExceeded);
    EXPECT_EQ(ToResult(ConfigFault::kSignature), Result::kSignatureError);
    EXPECT_EQ(ToResult(ConfigFault::kTable), Result::kMappingError);
    EXPECT_EQ(ToResult(static_cast<ConfigFault>(10U)), Result::kInvalidConfiguration);
    EXPECT_EQ(ToResult(static_cast<ConfigFault>(0xFFU)), Result::kInvalidConfiguration);
}

// As an SDO server sends them.
TEST(SafetyObjectAborts, CodesAreThoseOfTheRequirement)
{
    Verifies(req::SRS_CFG_040);
    Verifies(req::SRS_CFG_041);
    Verifies(req::SRS_CFG_042);
    Verifies(req::SRS_CFG_044);
    Verifies(req::SRS_CFG_045);
    Verifies(req::SRS_CFG_046);
    Verifies(req::SRS_CFG_047);
    Verifies(req::SRS_KRN_030);
    Verifies(req::SRS_CFG_340);
    Verifies(req::SRS_CFG_341);
    Verifies(req::SRS_CFG_342);
    Verifies(req::SRS_CFG_343);
    Verifies(req::SRS_CFG_344);
    Verifies(req::SRS_CFG_345);
    Verifies(req::SRS_CFG_346);
    Verifies(req::SRS_CFG_347);
    const auto is = [](const AbortCode code, const std::uint32_t value)
    { EXPECT_EQ(static_cast<std::uint32_t>(code), value); };
    is(AbortCode::kUnsupportedAccess, 0x06010000U);
    is(AbortCode::kReadOnly, 0x06010002U);
    is(AbortCode::kObjectUnknown, 0x06020000U);
    is(AbortCode::kNotMappable, 0x06040041U);
    is(AbortCode::kMapTooLong, 0x06040042U);
    is(AbortCode::kIncompatible, 0x06040043U);
    is(AbortCode::kLengthMismatch, 0x06070010U);
    is(AbortCode::kSubUnknown, 0x06090011U);
    is(AbortCode::kValueRange, 0x06090030U);
    is(AbortCode::kGeneral, 0x08000000U);
    is(AbortCode::kDeviceState, 0x08000022U);
}

} // namespace
} // namespace counterpoint
