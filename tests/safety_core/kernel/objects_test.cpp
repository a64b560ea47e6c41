// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{
namespace
{

class SafetyObjects : public Rig
{
  public:
    AbortCode ReadAbort(std::uint16_t index, std::uint8_t sub)
    {
        return kernel.ReadObject(ObjectAddress{index, sub}).abort;
    }
    /// Both channels keep it, whatever the rules say.
    void Corrupt(const ConfigAddress& address, const std::uint32_t value)
    {
        real_a.Store(ConfigItem{address, value});
        real_b.Store(ConfigItem{address, value});
    }
};

TEST_F(SafetyObjects, PowerOnValuesAreTheDefaults)
{
    Verifies(req::SRS_CFG_040);
    Verifies(req::SRS_CFG_002);
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    EXPECT_EQ(Read(0x1300U, 0U), 0U);
    EXPECT_EQ(Read(0x1301U, 1U), 0U);
    EXPECT_EQ(Read(0x1301U, 2U), 25U);
    EXPECT_EQ(Read(0x1301U, 3U), 20U);
    EXPECT_EQ(Read(0x1301U, 4U), 254U);
    EXPECT_EQ(Read(0x1301U, 5U), 0x103U); // 0FFh + 2 * 2
    EXPECT_EQ(Read(0x1301U, 6U), 0x104U);
    EXPECT_EQ(Read(0x1303U, 5U), 0U);
    EXPECT_EQ(Read(0x1383U, 0U), 0U);
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
    EXPECT_EQ(Read(0x13FFU, 1U), 0U);
}

TEST_F(SafetyObjects, ConstantEntriesReadAndRefuseWrites)
{
    Verifies(req::SRS_CFG_041);
    Configure();
    EXPECT_EQ(Read(0x1301U, 0U), 6U);
    EXPECT_EQ(Read(0x13FFU, 0U), 4U);
    EXPECT_EQ(Write(0x1301U, 0U, 6U, 1U), AbortCode::kReadOnly);
    EXPECT_EQ(Write(0x13FFU, 0U, 4U, 1U), AbortCode::kReadOnly);
    EXPECT_EQ(Write(0x2000U, 1U, 4U, 2U), AbortCode::kReadOnly);
    EXPECT_EQ(Write(0x1381U, 17U, 0U, 4U), AbortCode::kSubUnknown);
    EXPECT_EQ(ReadAbort(0x1381U, 17U), AbortCode::kSubUnknown);
}

TEST_F(SafetyObjects, WhatDoesNotExistIsUnknown)
{
    Verifies(req::SRS_CFG_340);
    Verifies(req::SRS_CFG_341);
    Configure();
    for (const std::uint16_t index : std::initializer_list<std::uint16_t>{
             0x12FF, 0x1302, 0x1340, 0x1341, 0x1380, 0x1382, 0x13C0, 0x13C1, 0x13FD, 0x1400, 0x1FFF, 0x2150, 0x2500})
    {
        EXPECT_EQ(ReadAbort(index, 0U), AbortCode::kObjectUnknown) << std::hex << index;
        EXPECT_EQ(Write(index, 0U, 0U, 1U), AbortCode::kObjectUnknown) << std::hex << index;
    }
    EXPECT_EQ(ReadAbort(0x2000U, 2U), AbortCode::kObjectUnknown);
    EXPECT_EQ(ReadAbort(0x1300U, 1U), AbortCode::kSubUnknown);
    EXPECT_EQ(ReadAbort(0x13FEU, 1U), AbortCode::kSubUnknown);
    EXPECT_EQ(ReadAbort(0x1301U, 7U), AbortCode::kSubUnknown);
    EXPECT_EQ(ReadAbort(0x13FFU, 5U), AbortCode::kSubUnknown);
}

TEST_F(SafetyObjects, VariablesAreReadWithTheirLength)
{
    Verifies(req::SRS_CFG_040);
    Configure();
    const ObjectReading reading = kernel.ReadObject(ObjectAddress{0x2000U, 1U});
    EXPECT_EQ(reading.abort, AbortCode::kNone);
    EXPECT_EQ(reading.data.size_bytes, 2U);
    EXPECT_EQ(reading.data.bytes[0], 0x12U);
    EXPECT_EQ(reading.data.bytes[1], 0x34U);
}

TEST_F(SafetyObjects, VariableOfBitsIsReadInWholeBytesWithoutForeignBits)
{
    Verifies(req::SRS_CFG_040);
    objects[0].length_bits = 11U;
    tx_normal = {0x12U, 0xFCU};
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    const ObjectReading reading = kernel.ReadObject(ObjectAddress{0x2000U, 1U});
    EXPECT_EQ(reading.data.size_bytes, 2U);
    EXPECT_EQ(reading.data.bytes[0], 0x12U);
    EXPECT_EQ(reading.data.bytes[1], 0x04U);
    // One bit more than none, and than a byte
    for (const std::uint8_t length_bits : std::initializer_list<std::uint8_t>{1, 9})
    {
        objects[0].length_bits = length_bits;
        ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
        EXPECT_EQ(kernel.ReadObject(ObjectAddress{0x2000U, 1U}).data.size_bytes, (length_bits == 1U) ? 1U : 2U);
    }
}

TEST_F(SafetyObjects, SubIndexZeroIsOneByte)
{
    Verifies(req::SRS_CFG_041);
    Configure();
    for (const std::uint16_t index : std::initializer_list<std::uint16_t>{0x1301U, 0x1381U, 0x13FFU})
    {
        EXPECT_EQ(kernel.ReadObject(ObjectAddress{index, 0U}).data.size_bytes, 1U) << index;
    }
}

// Given a device that ends before the last of the setups.
TEST_F(SafetyObjects, SrdosAreAsManyAsTheDeviceHas)
{
    Verifies(req::SRS_CFG_040);
    Verifies(req::SRS_CFG_340);
    config.srdo_count = 2U;
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    EXPECT_EQ(ReadAbort(0x1303U, 1U), AbortCode::kNone);
    EXPECT_EQ(ReadAbort(0x1304U, 1U), AbortCode::kObjectUnknown);
}

TEST(Dummies, NoLengthMakesOneOfTheIndexBehindThem)
{
    Verifies(req::SRS_CFG_345);
    for (std::uint32_t length_bits = 0U; length_bits <= 0xFFU; ++length_bits)
    {
        EXPECT_FALSE(IsDummy(0x00080000U | length_bits)) << length_bits;
    }
}

TEST_F(SafetyObjects, MapEntriesOfTheDeviceLimitSubIndexAndCount)
{
    Verifies(req::SRS_CFG_041);
    Verifies(req::SRS_CFG_347);
    config.map_entries = 6U;
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    EXPECT_EQ(Write(0x1381U, 6U, 0x20000110U, 4U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1381U, 7U, 0x20000110U, 4U), AbortCode::kSubUnknown);
    EXPECT_EQ(ReadAbort(0x1381U, 7U), AbortCode::kSubUnknown);
    EXPECT_EQ(Write(0x1381U, 0U, 8U, 1U), AbortCode::kMapTooLong);
    EXPECT_EQ(Write(0x1381U, 0U, 6U, 1U), AbortCode::kNone);
}

// Option dummy mapping: allowed here, refused below.
TEST_F(SafetyObjects, DummyEntriesAreAdmittedWhereAllowed)
{
    Verifies(req::SRS_CFG_033);
    Verifies(req::SRS_CFG_345);
    config.dummies = DummyMapping::kAllowed;
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    for (const std::uint32_t entry :
         {0x00010001U, 0x00020008U, 0x00030010U, 0x00040020U, 0x00050008U, 0x00060010U, 0x00070020U})
    {
        EXPECT_EQ(Write(0x1384U, 1U, entry, 4U), AbortCode::kNone) << std::hex << entry;
    }
    // another length, another sub-index, no data type of this list
    for (const std::uint32_t entry : {0x00010008U, 0x00050010U, 0x00050108U, 0x00000008U, 0x00080020U, 0x00010000U})
    {
        EXPECT_EQ(Write(0x1384U, 1U, entry, 4U), AbortCode::kObjectUnknown) << std::hex << entry;
    }
}

TEST_F(SafetyObjects, DummyEntriesAreUnknownWhereRefused)
{
    Verifies(req::SRS_CFG_345);
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    for (const std::uint32_t entry : {0x00010001U, 0x00050008U, 0x00060010U, 0x00070020U})
    {
        EXPECT_EQ(Write(0x1384U, 1U, entry, 4U), AbortCode::kObjectUnknown) << std::hex << entry;
    }
}

// Option static mapping: on here, off in every other test of this file.
TEST_F(SafetyObjects, StaticMappingCannotBeWritten)
{
    Verifies(req::SRS_CFG_041);
    static constexpr std::uint32_t kEntries[] = {0x22000110U, 0x23000110U};
    setups[2].map = StaticMap{kEntries, 2U};
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    EXPECT_EQ(Write(0x1384U, 0U, 2U, 1U), AbortCode::kReadOnly);
    EXPECT_EQ(Write(0x1384U, 0U, 0U, 1U), AbortCode::kReadOnly);
    EXPECT_EQ(Write(0x1384U, 1U, 0x22000110U, 4U), AbortCode::kReadOnly);
    EXPECT_EQ(Write(0x1384U, 2U, 0U, 4U), AbortCode::kReadOnly);
    EXPECT_EQ(Write(0x1384U, 3U, 0U, 4U), AbortCode::kSubUnknown);
    EXPECT_EQ(ReadAbort(0x1384U, 3U), AbortCode::kSubUnknown);
    EXPECT_EQ(ReadAbort(0x1384U, 2U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1381U, 1U, 0x22000110U, 4U), AbortCode::kNone);
}

TEST_F(SafetyObjects, SizeMustBeThatOfTheObject)
{
    Verifies(req::SRS_CFG_342);
    Configure();
    EXPECT_EQ(Write(0x1301U, 2U, 60U, 1U), AbortCode::kLengthMismatch);
    EXPECT_EQ(Write(0x1301U, 2U, 60U, 4U), AbortCode::kLengthMismatch);
    EXPECT_EQ(Write(0x13FEU, 0U, 0U, 2U), AbortCode::kLengthMismatch);
}

// Each object with every size but its own, a gap in the signatures among them.
TEST_F(SafetyObjects, NoObjectTakesAnotherSize)
{
    Verifies(req::SRS_CFG_040);
    Verifies(req::SRS_CFG_342);
    struct Sized
    {
        ObjectAddress address;
        std::uint8_t size_bytes;
    };
    Configure();
    for (const Sized& object :
         {Sized{{0x1300U, 0U}, 1U}, Sized{{0x1304U, 1U}, 1U}, Sized{{0x1304U, 2U}, 2U}, Sized{{0x1304U, 3U}, 1U},
          Sized{{0x1304U, 4U}, 1U}, Sized{{0x1304U, 5U}, 4U}, Sized{{0x1304U, 6U}, 4U}, Sized{{0x1384U, 0U}, 1U},
          Sized{{0x1384U, 1U}, 4U}, Sized{{0x13FEU, 0U}, 1U}, Sized{{0x13FFU, 4U}, 2U}, Sized{{0x13FFU, 2U}, 2U}})
    {
        EXPECT_EQ(kernel.ReadObject(object.address).data.size_bytes, object.size_bytes) << object.address.index;
        for (std::uint8_t size = 0U; size <= 8U; ++size)
        {
            ObjectData data = kernel.ReadObject(object.address).data;
            data.size_bytes = size;
            EXPECT_EQ(kernel.WriteObject(object.address, data),
                      (size == object.size_bytes) ? AbortCode::kNone : AbortCode::kLengthMismatch)
                << std::hex << object.address.index << " " << static_cast<int>(size);
        }
    }
}

TEST_F(SafetyObjects, ValuesAreLittleEndian)
{
    Verifies(req::SRS_CFG_040);
    Configure();
    const ObjectData identifier = kernel.ReadObject(ObjectAddress{0x1301U, 5U}).data;
    EXPECT_EQ(identifier.size_bytes, 4U);
    const std::array<std::uint8_t, 4> identifier_bytes{0x01U, 0x01U, 0x00U, 0x00U};
    EXPECT_TRUE(std::equal(identifier_bytes.begin(), identifier_bytes.end(), std::begin(identifier.bytes)));
    const ObjectData entry = kernel.ReadObject(ObjectAddress{0x1381U, 2U}).data;
    const std::array<std::uint8_t, 4> entry_bytes{0x10U, 0x01U, 0x00U, 0x23U};
    EXPECT_TRUE(std::equal(entry_bytes.begin(), entry_bytes.end(), std::begin(entry.bytes)));
    // 300 ms, low byte first
    ObjectData time{};
    time.size_bytes = 2U;
    time.bytes[0] = 0x2CU;
    time.bytes[1] = 0x01U;
    EXPECT_EQ(kernel.WriteObject(ObjectAddress{0x1304U, 2U}, time), AbortCode::kNone);
    EXPECT_EQ(kernel.GetParameters(CommunicationIndex{0x1304U}).refresh_ms, 300U);
}

TEST_F(SafetyObjects, SubIndicesThatDoNotExistAreNotWrittenEither)
{
    Verifies(req::SRS_CFG_041);
    Verifies(req::SRS_CFG_341);
    Configure();
    for (const ObjectAddress& address :
         {ObjectAddress{0x1300U, 1U}, ObjectAddress{0x1300U, 255U}, ObjectAddress{0x1301U, 7U},
          ObjectAddress{0x1301U, 255U}, ObjectAddress{0x1381U, 17U}, ObjectAddress{0x1381U, 255U},
          ObjectAddress{0x13FEU, 1U}, ObjectAddress{0x13FFU, 5U}, ObjectAddress{0x13FFU, 255U}})
    {
        EXPECT_EQ(ReadAbort(address.index, address.sub), AbortCode::kSubUnknown) << address.index;
        EXPECT_EQ(Write(address.index, address.sub, 0U, 1U), AbortCode::kSubUnknown) << address.index;
    }
}

TEST_F(SafetyObjects, GfcParameterIsWritableInEveryState)
{
    Verifies(req::SRS_CFG_043);
    Configure();
    for (const NmtState state :
         {NmtState::kInitialising, NmtState::kPreOperational, NmtState::kStopped, NmtState::kOperational})
    {
        kernel.SetNmtState(state);
        for (const std::uint32_t value : {0U, 1U})
        {
            EXPECT_EQ(Write(0x1300U, 0U, value, 1U), AbortCode::kNone);
            EXPECT_EQ(Read(0x1300U, 0U), value);
            EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
        }
    }
}

TEST_F(SafetyObjects, GapInTheSignaturesStaysZero)
{
    Verifies(req::SRS_CFG_044);
    Configure();
    EXPECT_EQ(Read(0x13FFU, 2U), 0U);
    EXPECT_EQ(Write(0x13FFU, 2U, 0U, 2U), AbortCode::kNone);
    EXPECT_EQ(Write(0x13FFU, 2U, 1U, 2U), AbortCode::kValueRange);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
}

TEST_F(SafetyObjects, InOperationalOnlyGfcParameterIsWritable)
{
    Verifies(req::SRS_CFG_042);
    Operate();
    EXPECT_EQ(Write(0x1301U, 2U, 50U, 2U), AbortCode::kDeviceState); // identical
    EXPECT_EQ(Write(0x1301U, 2U, 60U, 2U), AbortCode::kDeviceState);
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kDeviceState);
    EXPECT_EQ(Write(0x13FFU, 1U, 0U, 2U), AbortCode::kDeviceState);
    EXPECT_EQ(Write(0x13FFU, 2U, 0U, 2U), AbortCode::kDeviceState);
    EXPECT_EQ(Write(0x1300U, 0U, 0U, 1U), AbortCode::kNone);
    EXPECT_EQ(Read(0x1300U, 0U), 0U);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
}

TEST_F(SafetyObjects, WhatNoStateAcceptsIsToldBeforeOperational)
{
    Verifies(req::SRS_CFG_042);
    Operate();
    EXPECT_EQ(Write(0x1302U, 1U, 0U, 1U), AbortCode::kObjectUnknown);
    EXPECT_EQ(Write(0x1301U, 7U, 0U, 1U), AbortCode::kSubUnknown);
    EXPECT_EQ(Write(0x1301U, 0U, 6U, 1U), AbortCode::kReadOnly);
    EXPECT_EQ(Write(0x2200U, 1U, 0U, 2U), AbortCode::kReadOnly);
    EXPECT_EQ(Write(0x1301U, 2U, 50U, 1U), AbortCode::kLengthMismatch);
    // and it before what a value breaks
    EXPECT_EQ(Write(0x1301U, 1U, 3U, 1U), AbortCode::kDeviceState);
    EXPECT_EQ(Write(0x1301U, 5U, 0x102U, 4U), AbortCode::kDeviceState);
    EXPECT_EQ(Write(0x1381U, 1U, 0x22000110U, 4U), AbortCode::kDeviceState);
    EXPECT_EQ(Write(0x13FFU, 2U, 1U, 2U), AbortCode::kDeviceState);
}

TEST_F(SafetyObjects, VariableIsKnownByItsWholeAddress)
{
    Verifies(req::SRS_CFG_040);
    Verifies(req::SRS_CFG_340);
    Configure();
    EXPECT_EQ(kernel.ReadObject(ObjectAddress{0x2200U, 1U}).abort, AbortCode::kNone);
    EXPECT_EQ(kernel.ReadObject(ObjectAddress{0x2200U, 0U}).abort, AbortCode::kObjectUnknown);
    EXPECT_EQ(kernel.ReadObject(ObjectAddress{0x2200U, 2U}).abort, AbortCode::kObjectUnknown);
    EXPECT_EQ(Write(0x2200U, 2U, 0U, 2U), AbortCode::kObjectUnknown);
}

// 1300h may have changed since: with an expected digest its refusal leaves what was declared.
TEST_F(SafetyObjects, ValidOverValidIsADeclarationAnew)
{
    Verifies(req::SRS_CFG_219);
    Configure();
    const std::uint32_t gfc = Read(0x1300U, 0U);
    config.digest = kernel.Digest().digest;
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1300U, 0U, 1U - gfc, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kIncompatible);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    EXPECT_EQ(Write(0x1300U, 0U, gfc, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
}

TEST_F(SafetyObjects, IdenticalValueIsAcceptedAndClearsNothing)
{
    Verifies(req::SRS_CFG_218);
    Verifies(req::SRS_CFG_043);
    Configure();
    for (const NmtState state : {NmtState::kInitialising, NmtState::kStopped, NmtState::kPreOperational})
    {
        kernel.SetNmtState(state);
        EXPECT_EQ(Write(0x1303U, 2U, 25U, 2U), AbortCode::kNone);
        EXPECT_EQ(Write(0x13FFU, 3U, Read(0x13FFU, 3U), 2U), AbortCode::kNone);
        EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    }
    EXPECT_EQ(Write(0x1301U, 1U, 2U, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1301U, 2U, 50U, 2U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1301U, 5U, 0x101U, 4U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1381U, 0U, 2U, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1381U, 1U, 0x22000110U, 4U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1300U, 0U, 0U, 1U), AbortCode::kNone);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
}

TEST_F(SafetyObjects, ChangedValueClearsConfigurationValid)
{
    Verifies(req::SRS_CFG_043);
    const auto clears = [this](std::uint16_t index, std::uint8_t sub, std::uint32_t value, std::uint8_t size)
    {
        Configure();
        ASSERT_EQ(Read(0x13FEU, 0U), 0xA5U);
        EXPECT_EQ(Write(index, sub, value, size), AbortCode::kNone) << std::hex << index;
        EXPECT_EQ(Read(0x13FEU, 0U), 0U) << std::hex << index;
    };
    clears(0x1301U, 1U, 0U, 1U);
    clears(0x1301U, 2U, 60U, 2U);
    clears(0x1301U, 3U, 10U, 1U);
    clears(0x13FFU, 1U, 0U, 2U);
    clears(0x1384U, 1U, 0x22000110U, 4U);
    clears(0x1384U, 0U, 2U, 1U);
    clears(0x1304U, 5U, 0x105U, 4U);
}

TEST_F(SafetyObjects, ValuesOutsideTheirRangeAreRefused)
{
    Verifies(req::SRS_CFG_043);
    Verifies(req::SRS_CFG_044);
    Verifies(req::SRS_CFG_343);
    Verifies(req::SRS_CFG_344);
    Configure();
    EXPECT_EQ(Write(0x1301U, 1U, 3U, 1U), AbortCode::kValueRange);
    EXPECT_EQ(Write(0x1301U, 4U, 255U, 1U), AbortCode::kValueRange);
    EXPECT_EQ(Write(0x1300U, 0U, 2U, 1U), AbortCode::kValueRange);
    // COB-IDs of an SRDO that is on, then of one that is off
    EXPECT_EQ(Write(0x1301U, 5U, 0x105U, 4U), AbortCode::kValueRange);
    EXPECT_EQ(Write(0x1301U, 6U, 0x106U, 4U), AbortCode::kValueRange);
    for (const std::uint32_t value : {0x100U, 0xFFU, 0x106U, 0x181U, 0x905U, 0x80000105U, 0x103U, 0x101U})
    {
        EXPECT_EQ(Write(0x1304U, 5U, value, 4U), AbortCode::kValueRange) << std::hex << value;
    }
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U); // Nothing was accepted.
    EXPECT_EQ(Write(0x1304U, 5U, 0x17FU, 4U), AbortCode::kNone);
    for (const std::uint32_t value : {0x17FU, 0x17EU, 0x181U, 0x182U, 0x102U, 0x980U, 0x80000180U})
    {
        EXPECT_EQ(Write(0x1304U, 6U, value, 4U), AbortCode::kValueRange) << std::hex << value;
    }
    EXPECT_EQ(Write(0x1304U, 6U, 0x180U, 4U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1304U, 1U, 1U, 1U), AbortCode::kNone);
}

TEST_F(SafetyObjects, SwitchingOnNeedsAFreePairOfIdentifiers)
{
    Verifies(req::SRS_CFG_343);
    Verifies(req::SRS_CFG_344);
    Configure();
    // Given SRDO 4 without identifiers
    EXPECT_EQ(Write(0x1304U, 1U, 1U, 1U), AbortCode::kValueRange);
    EXPECT_EQ(Write(0x1304U, 1U, 2U, 1U), AbortCode::kValueRange);
    // with the first one changed after the second
    ASSERT_EQ(Write(0x1304U, 5U, 0x105U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1304U, 6U, 0x106U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1304U, 5U, 0x107U, 4U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1304U, 1U, 1U, 1U), AbortCode::kValueRange);
    // with identifiers that SRDO 1 took after it was switched off and on
    ASSERT_EQ(Write(0x1304U, 5U, 0x105U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1301U, 1U, 0U, 1U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1301U, 5U, 0x105U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1301U, 6U, 0x106U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1301U, 1U, 2U, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1304U, 1U, 1U, 1U), AbortCode::kValueRange);
    EXPECT_EQ(Write(0x1304U, 1U, 0U, 1U), AbortCode::kNone);
}

TEST_F(SafetyObjects, SecondIdentifierAloneInUseKeepsItOff)
{
    Verifies(req::SRS_CFG_343);
    Verifies(req::SRS_CFG_344);
    Configure();
    // Given that SRDO 4 has 105h, 106h, and channels in which another SRDO's COB-ID 1 is 106h
    ASSERT_EQ(Write(0x1304U, 5U, 0x105U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1304U, 6U, 0x106U, 4U), AbortCode::kNone);
    Corrupt(ConfigAddress{0U, ConfigField::kCobId1, 0U}, 0x106U);
    EXPECT_EQ(Write(0x1304U, 1U, 1U, 1U), AbortCode::kValueRange);
    // and one whose COB-ID 2 is 106h
    Corrupt(ConfigAddress{0U, ConfigField::kCobId1, 0U}, 0x101U);
    Corrupt(ConfigAddress{0U, ConfigField::kCobId2, 0U}, 0x106U);
    EXPECT_EQ(Write(0x1304U, 1U, 1U, 1U), AbortCode::kValueRange);
}

TEST_F(SafetyObjects, FirstIdentifierAloneInUseKeepsItOff)
{
    Verifies(req::SRS_CFG_343);
    Verifies(req::SRS_CFG_344);
    Configure();
    // Given that SRDO 4 has 105h, 106h, and channels in which another SRDO's COB-ID 2 is 105h
    ASSERT_EQ(Write(0x1304U, 5U, 0x105U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1304U, 6U, 0x106U, 4U), AbortCode::kNone);
    Corrupt(ConfigAddress{0U, ConfigField::kCobId2, 0U}, 0x105U);
    EXPECT_EQ(Write(0x1304U, 1U, 1U, 1U), AbortCode::kValueRange);
}

TEST_F(SafetyObjects, IdentifierIsInUseByAnSrdoThatIsOn)
{
    Verifies(req::SRS_CFG_343);
    Configure();
    // Given SRDO 1 is off, then SRDO 3 keeps what it has
    ASSERT_EQ(Write(0x1301U, 1U, 0U, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1304U, 5U, 0x103U, 4U), AbortCode::kValueRange);
    // and once it is off as well, with SRDO 1 on, SRDO 4 may have it
    ASSERT_EQ(Write(0x1301U, 1U, 2U, 1U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1303U, 1U, 0U, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1304U, 5U, 0x103U, 4U), AbortCode::kNone);
}

TEST_F(SafetyObjects, IdentifiersThatAreNoneSwitchNothingOn)
{
    Verifies(req::SRS_CFG_344);
    Configure();
    // Given channels in which SRDO 4 has 0 and 1
    Corrupt(ConfigAddress{2U, ConfigField::kCobId2, 0U}, 1U);
    EXPECT_EQ(Write(0x1304U, 1U, 1U, 1U), AbortCode::kValueRange);
}

TEST_F(SafetyObjects, WhateverItsIdentifiersAreAnSrdoCanBeSwitchedOff)
{
    Verifies(req::SRS_CFG_344);
    Configure();
    Corrupt(ConfigAddress{1U, ConfigField::kCobId2, 0U}, 0x106U);
    EXPECT_EQ(Write(0x1303U, 1U, 0U, 1U), AbortCode::kNone);
    EXPECT_EQ(Read(0x1303U, 1U), 0U);
}

TEST_F(SafetyObjects, DirectionCanTurnRound)
{
    Verifies(req::SRS_CFG_343);
    Configure();
    // Given SRDO 1 as consumer, its own identifiers do not stand in its way as producer
    EXPECT_EQ(Write(0x1301U, 1U, 1U, 1U), AbortCode::kNone);
    EXPECT_EQ(Read(0x1301U, 1U), 1U);
    // nor those of SRDO 3, a producer, as consumer
    EXPECT_EQ(Write(0x1303U, 1U, 2U, 1U), AbortCode::kNone);
    EXPECT_EQ(Read(0x1303U, 1U), 2U);
}

TEST_F(SafetyObjects, MappingIsDeletedFirst)
{
    Verifies(req::SRS_CFG_045);
    Verifies(req::SRS_CFG_345);
    Configure();
    // SRDO 1 is on
    EXPECT_EQ(Write(0x1381U, 0U, 0U, 1U), AbortCode::kUnsupportedAccess);
    EXPECT_EQ(Write(0x1381U, 1U, 0x20000110U, 4U), AbortCode::kUnsupportedAccess);
    // off, but its count is not 0
    ASSERT_EQ(Write(0x1301U, 1U, 0U, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1381U, 1U, 0x20000110U, 4U), AbortCode::kUnsupportedAccess);
    // another count that is not 0, right or not, longer or shorter
    EXPECT_EQ(Write(0x1381U, 0U, 4U, 1U), AbortCode::kUnsupportedAccess);
    EXPECT_EQ(Write(0x1381U, 0U, 3U, 1U), AbortCode::kUnsupportedAccess);
    EXPECT_EQ(Write(0x1381U, 0U, 255U, 1U), AbortCode::kUnsupportedAccess);
    // deleted
    ASSERT_EQ(Write(0x1381U, 0U, 0U, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1381U, 1U, 0x20000110U, 4U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1381U, 1U, 0U, 4U), AbortCode::kNone);
    // on, with nothing mapped
    ASSERT_EQ(Write(0x1301U, 1U, 2U, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1381U, 1U, 0x20000110U, 4U), AbortCode::kUnsupportedAccess);
}

TEST_F(SafetyObjects, MappingEntriesMustNameMappableObjects)
{
    Verifies(req::SRS_CFG_345);
    Verifies(req::SRS_CFG_346);
    Verifies(req::SRS_CFG_347);
    Configure();
    EXPECT_EQ(Write(0x1384U, 1U, 0x20000210U, 4U), AbortCode::kObjectUnknown);
    EXPECT_EQ(Write(0x1384U, 1U, 0x24000110U, 4U), AbortCode::kNotMappable);
    EXPECT_EQ(Write(0x1384U, 1U, 0x20000108U, 4U), AbortCode::kNotMappable);
    EXPECT_EQ(Write(0x1384U, 1U, 0x20000110U, 4U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1384U, 0U, 1U, 1U), AbortCode::kMapTooLong);
    EXPECT_EQ(Write(0x1384U, 0U, 18U, 1U), AbortCode::kMapTooLong);
    EXPECT_EQ(Write(0x1384U, 0U, 16U, 1U), AbortCode::kNone);
}

TEST_F(SafetyObjects, MapCountMayNotReachMoreThanSixtyFourBitsOnEitherSide)
{
    Verifies(req::SRS_CFG_347);
    Configure();
    // Given five normal entries of 16 bits and none inverse
    for (const std::uint8_t sub : std::initializer_list<std::uint8_t>{1, 3, 5, 7, 9})
    {
        ASSERT_EQ(Write(0x1384U, sub, 0x20000110U, 4U), AbortCode::kNone);
    }
    EXPECT_EQ(Write(0x1384U, 0U, 8U, 1U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1384U, 0U, 0U, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1384U, 0U, 10U, 1U), AbortCode::kMapTooLong);
    // and the inverse side alone too long
    ASSERT_EQ(Write(0x1384U, 9U, 0U, 4U), AbortCode::kNone);
    for (const std::uint8_t sub : std::initializer_list<std::uint8_t>{2, 4, 6, 8, 10})
    {
        ASSERT_EQ(Write(0x1384U, sub, 0x21000110U, 4U), AbortCode::kNone);
    }
    EXPECT_EQ(Write(0x1384U, 0U, 10U, 1U), AbortCode::kMapTooLong);
    // as well of another SRDO than the third
    ASSERT_EQ(Write(0x1384U, 2U, 0U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1301U, 1U, 0U, 1U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1381U, 0U, 0U, 1U), AbortCode::kNone);
    for (const std::uint8_t sub : std::initializer_list<std::uint8_t>{2, 4, 6, 8, 10})
    {
        ASSERT_EQ(Write(0x1381U, sub, 0x21000110U, 4U), AbortCode::kNone);
    }
    EXPECT_EQ(Write(0x1381U, 0U, 10U, 1U), AbortCode::kMapTooLong);
}

TEST(DefaultConnection, IdentifiersAndDirectionByNodeId)
{
    Verifies(req::SRS_CFG_049);
    const auto is = [](std::uint8_t node, std::uint16_t cob_id_1, std::uint16_t cob_id_2, std::uint8_t direction)
    {
        const Connection connection = DefaultConnection(NodeId{node});
        EXPECT_EQ(connection.cob_id_1, cob_id_1) << static_cast<int>(node);
        EXPECT_EQ(connection.cob_id_2, cob_id_2) << static_cast<int>(node);
        EXPECT_EQ(connection.direction, direction) << static_cast<int>(node);
    };
    is(0U, 0U, 0U, 0U);
    is(1U, 0x101U, 0x102U, 1U);
    is(32U, 0x13FU, 0x140U, 1U);
    is(33U, 0x141U, 0x142U, 2U);
    is(64U, 0x17FU, 0x180U, 2U);
    is(65U, 0U, 0U, 0U);
}

} // namespace
} // namespace counterpoint
