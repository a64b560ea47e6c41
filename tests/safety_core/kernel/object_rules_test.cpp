// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The rules of the safety objects for all of them, each with both sides of its limit.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <initializer_list>
#include <vector>

namespace counterpoint
{
namespace
{

constexpr std::initializer_list<std::uint16_t> kNumbers{1U, 3U, 4U};

struct Sized
{
    ObjectAddress address;
    std::uint8_t size_bytes;
};

class ObjectRules : public Rig
{
  public:
    /// Both channels keep it, whatever the rules say.
    void Corrupt(const ConfigAddress& address, const std::uint32_t value)
    {
        real_a.Store(ConfigItem{address, value});
        real_b.Store(ConfigItem{address, value});
    }
    void IsUnknown(const std::uint16_t index, const std::uint8_t sub)
    {
        EXPECT_EQ(kernel.ReadObject(ObjectAddress{index, sub}).abort, AbortCode::kObjectUnknown)
            << std::hex << index << " " << static_cast<int>(sub);
        EXPECT_EQ(Write(index, sub, 0U, 1U), AbortCode::kObjectUnknown)
            << std::hex << index << " " << static_cast<int>(sub);
    }
    /// Whatever of the rig's three SRDOs can be written, and 13FEh.
    static std::vector<Sized> Writable()
    {
        std::vector<Sized> objects{Sized{{0x13FEU, 0U}, 1U}, Sized{{0x13FFU, 2U}, 2U}};
        for (const std::uint16_t number : kNumbers)
        {
            const auto communication = static_cast<std::uint16_t>(0x1300U + number);
            const auto mapping = static_cast<std::uint16_t>(0x1380U + number);
            for (const auto& [sub, size_bytes] : std::initializer_list<std::pair<std::uint8_t, std::uint8_t>>{
                     {1U, 1U}, {2U, 2U}, {3U, 1U}, {4U, 1U}, {5U, 4U}, {6U, 4U}})
            {
                objects.push_back(Sized{{communication, sub}, size_bytes});
            }
            for (std::uint8_t sub = 0U; sub <= 16U; ++sub)
            {
                objects.push_back(Sized{{mapping, sub}, (sub == 0U) ? std::uint8_t{1U} : std::uint8_t{4U}});
            }
            objects.push_back(Sized{{0x13FFU, static_cast<std::uint8_t>(number)}, 2U});
        }
        return objects;
    }
};

TEST_F(ObjectRules, SrdoSixtyFourHasTheLastOfBothRanges)
{
    Verifies(req::SRS_CFG_040);
    Verifies(req::SRS_CFG_041);
    setups[2].number = 64U;
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    for (const std::uint16_t index : std::initializer_list<std::uint16_t>{0x1301U, 0x1303U, 0x1340U})
    {
        EXPECT_EQ(Read(index, 0U), 6U) << std::hex << index;
        EXPECT_EQ(Write(index, 0U, 6U, 1U), AbortCode::kReadOnly) << std::hex << index;
    }
    EXPECT_EQ(Read(0x1340U, 2U), 25U);
    EXPECT_EQ(Write(0x1340U, 2U, 300U, 2U), AbortCode::kNone);
    EXPECT_EQ(Read(0x1340U, 2U), 300U);
    EXPECT_EQ(Write(0x13C0U, 16U, 0x20000110U, 4U), AbortCode::kNone);
    EXPECT_EQ(Read(0x13C0U, 16U), 0x20000110U);
    EXPECT_EQ(Write(0x13C0U, 17U, 0U, 4U), AbortCode::kSubUnknown);
    EXPECT_EQ(Write(0x13FFU, 64U, 0x1234U, 2U), AbortCode::kNone);
    EXPECT_EQ(Read(0x13FFU, 64U), 0x1234U);
    // The greatest number is that of the last SRDO
    EXPECT_EQ(Read(0x13FFU, 0U), 64U);
    config.srdo_count = 2U;
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    EXPECT_EQ(Read(0x13FFU, 0U), 3U);
}

TEST_F(ObjectRules, WhatLiesBetweenTheRangesIsUnknownWithEachSubIndex)
{
    Verifies(req::SRS_CFG_340);
    setups[2].number = 64U;
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    for (const std::uint8_t sub : std::initializer_list<std::uint8_t>{0U, 1U, 6U, 17U, 255U})
    {
        for (std::uint32_t index = 0x1341U; index <= 0x1380U; ++index)
        {
            IsUnknown(static_cast<std::uint16_t>(index), sub);
        }
        for (std::uint32_t index = 0x13C1U; index <= 0x13FDU; ++index)
        {
            IsUnknown(static_cast<std::uint16_t>(index), sub);
        }
        // SRDOs that do not exist, and neighbours of both ends
        for (const std::uint16_t index :
             std::initializer_list<std::uint16_t>{0x12FFU, 0x1302U, 0x1304U, 0x133FU, 0x1382U, 0x13BFU, 0x1400U})
        {
            IsUnknown(index, sub);
        }
    }
    // Given a device that has no 1300h
    config.gfc = GfcUse::kRemoved;
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    IsUnknown(0x1300U, 0U);
    IsUnknown(0x1300U, 1U);
}

TEST_F(ObjectRules, InOperationalNothingButGfcParameterIsWritten)
{
    Verifies(req::SRS_CFG_042);
    Operate();
    for (const Sized& object : Writable())
    {
        const ObjectAddress& address = object.address;
        const std::uint32_t value = Read(address.index, address.sub);
        EXPECT_EQ(Write(address.index, address.sub, value, object.size_bytes), AbortCode::kDeviceState)
            << std::hex << address.index << " " << static_cast<int>(address.sub);
        EXPECT_EQ(Write(address.index, address.sub, value ^ 1U, object.size_bytes), AbortCode::kDeviceState)
            << std::hex << address.index << " " << static_cast<int>(address.sub);
        EXPECT_EQ(Read(address.index, address.sub), value);
    }
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
}

TEST_F(ObjectRules, InEveryOtherStateEachTakesWhatItHas)
{
    Verifies(req::SRS_CFG_218);
    Configure();
    for (const NmtState state : {NmtState::kInitialising, NmtState::kStopped, NmtState::kPreOperational})
    {
        kernel.SetNmtState(state);
        for (const Sized& object : Writable())
        {
            const ObjectAddress& address = object.address;
            const std::uint32_t value = Read(address.index, address.sub);
            EXPECT_EQ(Write(address.index, address.sub, value, object.size_bytes), AbortCode::kNone)
                << std::hex << address.index << " " << static_cast<int>(address.sub);
            EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U) << std::hex << address.index << " " << static_cast<int>(address.sub);
        }
    }
}

TEST_F(ObjectRules, ChangeOfEachSrdoClearsConfigurationValid)
{
    Verifies(req::SRS_CFG_043);
    const auto clears = [this](std::uint16_t index, std::uint8_t sub, std::uint32_t value, std::uint8_t size)
    {
        ASSERT_EQ(Read(0x13FEU, 0U), 0xA5U);
        EXPECT_EQ(Write(index, sub, value, size), AbortCode::kNone) << std::hex << index;
        EXPECT_EQ(Read(0x13FEU, 0U), 0U) << std::hex << index << " " << static_cast<int>(sub);
    };
    for (const std::uint16_t number : kNumbers)
    {
        const auto communication = static_cast<std::uint16_t>(0x1300U + number);
        Configure();
        clears(communication, 2U, 60U, 2U);
        Configure();
        clears(communication, 3U, 10U, 1U);
        Configure();
        clears(0x13FFU, static_cast<std::uint8_t>(number), 0x1234U, 2U);
    }
    Configure();
    clears(0x1303U, 1U, 0U, 1U);
    // COB-ID 2 of an SRDO that has the first one
    Configure();
    clears(0x1304U, 5U, 0x105U, 4U);
    const SignReply reply = kernel.Sign(CommunicationIndex{0x1304U});
    ASSERT_EQ(Write(0x13FFU, 4U, reply.signature, 2U), AbortCode::kNone);
    ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    clears(0x1304U, 6U, 0x106U, 4U);
}

TEST_F(ObjectRules, ByteValuesHaveTheirRange)
{
    Verifies(req::SRS_CFG_044);
    Configure();
    for (std::uint32_t value = 0U; value <= 0xFFU; ++value)
    {
        // 2, 254 and 1 are what they are
        EXPECT_EQ(Write(0x1301U, 1U, value, 1U), (value <= 2U) ? AbortCode::kNone : AbortCode::kValueRange) << value;
        EXPECT_EQ(Write(0x1301U, 4U, value, 1U), (value == 254U) ? AbortCode::kNone : AbortCode::kValueRange) << value;
        EXPECT_EQ(Write(0x1300U, 0U, value, 1U), (value <= 1U) ? AbortCode::kNone : AbortCode::kValueRange) << value;
    }
    for (const std::uint32_t value : {1U, 0x100U, 0xFFFFU})
    {
        EXPECT_EQ(Write(0x13FFU, 2U, value, 2U), AbortCode::kValueRange) << value;
    }
}

TEST_F(ObjectRules, FirstCobIdIsOddOfTheRangeAndFree)
{
    Verifies(req::SRS_CFG_044);
    Verifies(req::SRS_CFG_343);
    Configure();
    for (std::uint32_t value = 1U; value <= 0x7FFU; ++value)
    {
        const bool is_of_range = (value >= 0x101U) && (value <= 0x17FU) && ((value & 1U) == 1U);
        const bool is_used = (value == 0x101U) || (value == 0x103U);
        EXPECT_EQ(Write(0x1304U, 5U, value, 4U),
                  (is_of_range && (!is_used)) ? AbortCode::kNone : AbortCode::kValueRange)
            << std::hex << value;
    }
    for (std::uint32_t bit = 9U; bit < 32U; ++bit)
    {
        EXPECT_EQ(Write(0x1304U, 5U, 0x105U | (1U << bit), 4U), AbortCode::kValueRange) << bit;
    }
}

// Given the COB-ID 1 that fits each of them, so that nothing but the rule in question refuses it.
TEST_F(ObjectRules, SecondCobIdIsEvenOfTheRangeAndFree)
{
    Verifies(req::SRS_CFG_044);
    Verifies(req::SRS_CFG_343);
    Configure();
    const auto follows = [this](const std::uint32_t value)
    {
        Corrupt(ConfigAddress{2U, ConfigField::kCobId1, 0U}, value - 1U);
        return Write(0x1304U, 6U, value, 4U);
    };
    for (std::uint32_t value = 1U; value <= 0x7FFU; ++value)
    {
        const bool is_of_range = (value >= 0x102U) && (value <= 0x180U) && ((value & 1U) == 0U);
        const bool is_used = (value == 0x102U) || (value == 0x104U);
        EXPECT_EQ(follows(value), (is_of_range && (!is_used)) ? AbortCode::kNone : AbortCode::kValueRange)
            << std::hex << value;
    }
    for (std::uint32_t bit = 9U; bit < 32U; ++bit)
    {
        EXPECT_EQ(follows(0x106U | (1U << bit)), AbortCode::kValueRange) << bit;
    }
    // and one that is free, but does not follow COB-ID 1
    Corrupt(ConfigAddress{2U, ConfigField::kCobId1, 0U}, 0x107U);
    for (const std::uint32_t value : {0x106U, 0x10AU, 0x17EU, 0x180U})
    {
        EXPECT_EQ(Write(0x1304U, 6U, value, 4U), (value == 0x180U) ? AbortCode::kNone : AbortCode::kValueRange)
            << std::hex << value; // 180h is what it has.
    }
    // and one that SRDO 1 has, until that is off
    Corrupt(ConfigAddress{0U, ConfigField::kCobId2, 0U}, 0x108U);
    EXPECT_EQ(Write(0x1304U, 6U, 0x108U, 4U), AbortCode::kValueRange);
    ASSERT_EQ(Write(0x1301U, 1U, 0U, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1304U, 6U, 0x108U, 4U), AbortCode::kNone);
}

TEST_F(ObjectRules, MapCountOfAnSrdoThatIsOnIsNotChanged)
{
    Verifies(req::SRS_CFG_045);
    Configure();
    for (const std::uint32_t slot : {0U, 1U})
    {
        const auto index = static_cast<std::uint16_t>((slot == 0U) ? 0x1381U : 0x1383U);
        for (const std::uint32_t count : {0U, 4U})
        {
            EXPECT_EQ(Write(index, 0U, count, 1U), AbortCode::kUnsupportedAccess) << slot;
        }
        // Given none mapped, though it is on
        Corrupt(ConfigAddress{static_cast<SlotIndex>(slot), ConfigField::kMapCount, 0U}, 0U);
        EXPECT_EQ(Write(index, 0U, 2U, 1U), AbortCode::kUnsupportedAccess) << slot;
        EXPECT_EQ(Write(index, 1U, 0U, 4U), AbortCode::kUnsupportedAccess) << slot;
    }
}

TEST_F(ObjectRules, MappedLengthIsThatOfTheObject)
{
    Verifies(req::SRS_CFG_346);
    Configure();
    for (std::uint32_t length = 0U; length <= 0xFFU; ++length)
    {
        EXPECT_EQ(Write(0x1384U, 1U, 0x20000100U | length, 4U),
                  (length == 16U) ? AbortCode::kNone : AbortCode::kNotMappable)
            << length;
    }
}

TEST_F(ObjectRules, MapCountIsEvenAndNotAboveTheEntries)
{
    Verifies(req::SRS_CFG_347);
    Configure();
    for (std::uint32_t count = 1U; count <= 0xFFU; ++count)
    {
        const bool is_count = (count <= 16U) && ((count & 1U) == 0U);
        EXPECT_EQ(Write(0x1384U, 0U, count, 1U), is_count ? AbortCode::kNone : AbortCode::kMapTooLong) << count;
        ASSERT_EQ(Write(0x1384U, 0U, 0U, 1U), AbortCode::kNone);
    }
}

TEST_F(ObjectRules, SixtyFourBitsAreMappedOnEitherSideAndNotOneMore)
{
    Verifies(req::SRS_CFG_347);
    config.dummies = DummyMapping::kAllowed;
    for (const std::uint8_t first : std::initializer_list<std::uint8_t>{1U, 2U})
    {
        ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
        // Given four entries of 16 bits on one side, and none on the other
        for (std::uint32_t entry = 0U; entry < 4U; ++entry)
        {
            ASSERT_EQ(Write(0x1384U, static_cast<std::uint8_t>(first + (2U * entry)), 0x20000110U, 4U),
                      AbortCode::kNone);
        }
        EXPECT_EQ(Write(0x1384U, 0U, 10U, 1U), AbortCode::kNone);
        ASSERT_EQ(Write(0x1384U, 0U, 0U, 1U), AbortCode::kNone);
        // when a dummy of one bit follows
        ASSERT_EQ(Write(0x1384U, static_cast<std::uint8_t>(first + 8U), 0x00010001U, 4U), AbortCode::kNone);
        EXPECT_EQ(Write(0x1384U, 0U, 10U, 1U), AbortCode::kMapTooLong);
        // then as many as are before it can be mapped
        EXPECT_EQ(Write(0x1384U, 0U, 8U, 1U), AbortCode::kNone);
    }
}

TEST_F(ObjectRules, EachThatTheChannelsHoldDifferentlyReadsAsAFaultOfItsSlot)
{
    Verifies(req::SRS_CFG_047);
    for (Tap* const tap : {&a, &b})
    {
        for (const Sized& object : Writable())
        {
            const ObjectAddress& address = object.address;
            const std::uint32_t number = (address.index == 0x13FFU) ? address.sub : (address.index & 0x7FU);
            if (number == 2U)
            {
                continue; // The gap is in no channel.
            }
            Configure();
            tap->load_flip = 1U;
            EXPECT_EQ(kernel.ReadObject(address).abort, AbortCode::kGeneral) << std::hex << address.index;
            tap->load_flip = 0U;
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kConfiguration);
            EXPECT_EQ(kernel.DeviceState().slot,
                      (number == 1U) ? 0U : ((number == 3U) ? 1U : ((number == 4U) ? 2U : kNoSlot)))
                << std::hex << address.index;
        }
    }
}

TEST(DefaultConnection, IsThatOfEachNodeId)
{
    Verifies(req::SRS_CFG_049);
    for (std::uint32_t node = 0U; node <= 0xFFU; ++node)
    {
        const Connection connection = DefaultConnection(NodeId{static_cast<std::uint8_t>(node)});
        const bool has_one = (node >= 1U) && (node <= 64U);
        EXPECT_EQ(connection.cob_id_1, has_one ? (0xFFU + (2U * node)) : 0U) << node;
        EXPECT_EQ(connection.cob_id_2, has_one ? (0x100U + (2U * node)) : 0U) << node;
        EXPECT_EQ(connection.direction, has_one ? ((node <= 32U) ? 1U : 2U) : 0U) << node;
    }
}

} // namespace
} // namespace counterpoint
