// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia301/service_rig.hpp"
#include "verification/trace/ids/pdo.hpp"

namespace counterpoint::cia301
{
namespace
{

using Indices = std::vector<std::uint16_t>;
using PdoMappingTest = ServiceRig;

TEST_F(PdoMappingTest, ObjectsOfEachPdoAreThereAndNoOthers)
{
    Verifies(req::SRS_PDO_001);
    EXPECT_EQ(Read(objects, 0x1400U, 0U), 0x100000005U);
    EXPECT_EQ(Read(objects, 0x1400U, 1U), 0x480000000U);
    EXPECT_EQ(Read(objects, 0x1400U, 2U), 0x1000000FEU);
    EXPECT_EQ(Read(objects, 0x1400U, 3U), 0x200000000U);
    EXPECT_EQ(Read(objects, 0x1400U, 5U), 0x200000000U);
    EXPECT_EQ(Read(objects, 0x1600U, 0U), 0x100000000U);
    EXPECT_EQ(Read(objects, 0x1600U, 4U), 0x400000000U);
    EXPECT_EQ(Read(objects, 0x15FFU, 1U), 0x480000000U); // 512
    EXPECT_EQ(Read(objects, 0x17FFU, 1U), 0x400000000U);
    EXPECT_EQ(Read(objects, 0x1800U, 0U), 0x100000006U);
    EXPECT_EQ(Read(objects, 0x19FFU, 1U), 0x4C0000000U); // 512
    EXPECT_EQ(Read(objects, 0x1800U, 2U), 0x1000000FEU);
    EXPECT_EQ(Read(objects, 0x1800U, 3U), 0x200000000U);
    EXPECT_EQ(Read(objects, 0x1800U, 5U), 0x200000000U);
    EXPECT_EQ(Read(objects, 0x1800U, 6U), 0x100000000U);
    EXPECT_EQ(Read(objects, 0x1A00U, 0U), 0x100000000U);
    EXPECT_EQ(Read(objects, 0x1A00U, 64U), 0x400000000U);
    EXPECT_EQ(abort, SdoAbort::kNone);
    const ObjectAddress missing_subs[] = {{0x1400U, 4U},  {0x1400U, 6U}, {0x1600U, 5U}, {0x1800U, 4U}, {0x1800U, 7U},
                                          {0x1A00U, 65U}, {0x1BFFU, 2U}, {0x15FFU, 4U}, {0x17FFU, 2U}};
    for (const ObjectAddress& address : missing_subs)
    {
        static_cast<void>(Read(objects, address.index, address.sub));
        EXPECT_EQ(abort, SdoAbort::kSubUnknown) << address.index;
        EXPECT_EQ(WritePdo(address.index, address.sub, 0U), SdoAbort::kSubUnknown);
    }
    for (const std::uint16_t index : Indices{0x1401U, 0x1601U, 0x1801U, 0x1A01U, 0x13FFU, 0x1C00U})
    {
        static_cast<void>(Read(objects, index, 0U));
        EXPECT_EQ(abort, SdoAbort::kObjectUnknown) << index;
        EXPECT_EQ(WritePdo(index, 1U, 0U), SdoAbort::kObjectUnknown);
    }
    EXPECT_EQ(WritePdo(0x1400U, 0U, 5U), SdoAbort::kReadOnly);
    EXPECT_EQ(WritePdo(0x1800U, 0U, 6U), SdoAbort::kReadOnly);
}

TEST_F(PdoMappingTest, CommunicationParametersAreChecked)
{
    Verifies(req::SRS_PDO_002);
    for (const std::uint16_t index : Indices{0x1400U, 0x1800U})
    {
        EXPECT_EQ(WritePdo(index, 1U, 0xA0000185U), SdoAbort::kValueRange); // 29 bits
        EXPECT_EQ(WritePdo(index, 1U, 0x00000101U), SdoAbort::kValueRange); // SRDO
        EXPECT_EQ(WritePdo(index, 1U, 0x00000000U), SdoAbort::kValueRange);
        EXPECT_EQ(WritePdo(index, 1U, 0x80000000U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(index, 1U, 0x00000185U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(index, 1U, 0x00000185U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(index, 1U, 0x00000186U), SdoAbort::kValueRange);
        EXPECT_EQ(WritePdo(index, 1U, 0x40000185U), SdoAbort::kNone); // RTR is not among the fixed bits
        EXPECT_EQ(WritePdo(index, 1U, 0x80000186U), SdoAbort::kNone);
        for (const std::uint32_t type : {241U, 251U})
        {
            EXPECT_EQ(WritePdo(index, 2U, type), SdoAbort::kValueRange);
        }
        for (const std::uint32_t type : {0U, 1U, 240U, 254U, 255U})
        {
            EXPECT_EQ(WritePdo(index, 2U, type), SdoAbort::kNone);
        }
        for (const std::uint32_t type : {252U, 253U})
        {
            EXPECT_EQ(WritePdo(index, 2U, type), (index == 0x1400U) ? SdoAbort::kValueRange : SdoAbort::kNone);
        }
        EXPECT_EQ(WritePdo(index, 3U, 0x1234U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(index, 5U, 0x4321U), SdoAbort::kNone);
        EXPECT_EQ(Read(objects, index, 3U), 0x200001234U);
        EXPECT_EQ(Read(objects, index, 5U), 0x200004321U);
    }
    EXPECT_EQ(WritePdo(0x1800U, 6U, 241U), SdoAbort::kValueRange);
    EXPECT_EQ(WritePdo(0x1800U, 6U, 240U), SdoAbort::kNone);
    // A valid TPDO keeps inhibit time and start value; the same ones are taken
    EXPECT_EQ(WritePdo(0x1800U, 1U, 0x185U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1800U, 3U, 0x1234U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1800U, 3U, 0x1235U), SdoAbort::kValueRange);
    EXPECT_EQ(WritePdo(0x1800U, 6U, 240U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1800U, 6U, 1U), SdoAbort::kValueRange);
    EXPECT_EQ(WritePdo(0x1800U, 5U, 10U), SdoAbort::kNone);
}

TEST_F(PdoMappingTest, AMappingChangesOnlyWhileItIsDisabledAndThePdoIsOff)
{
    Verifies(req::SRS_PDO_003);
    for (const std::uint16_t index : Indices{0x1600U, 0x1A00U})
    {
        const auto settings = static_cast<std::uint16_t>(index - 0x200U);
        EXPECT_EQ(WritePdo(index, 1U, 0x21000008U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(index, 0U, 1U), SdoAbort::kNone);
        // Enabled
        EXPECT_EQ(WritePdo(index, 1U, 0x21010010U), SdoAbort::kUnsupportedAccess);
        EXPECT_EQ(WritePdo(index, 2U, 0x21010010U), SdoAbort::kUnsupportedAccess);
        EXPECT_EQ(WritePdo(index, 1U, 0x21000008U), SdoAbort::kNone); // the same
        // Valid
        EXPECT_EQ(WritePdo(settings, 1U, 0x185U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(index, 0U, 0U), SdoAbort::kUnsupportedAccess);
        EXPECT_EQ(WritePdo(index, 0U, 1U), SdoAbort::kNone); // the same
        EXPECT_EQ(WritePdo(settings, 1U, 0x80000185U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(index, 0U, 0U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(settings, 1U, 0x185U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(index, 1U, 0x21010010U), SdoAbort::kUnsupportedAccess);
        EXPECT_EQ(Read(objects, index, 1U), 0x421000008U);
    }
}

TEST_F(PdoMappingTest, EightBytesAndTheRoomAreTheLimit)
{
    Verifies(req::SRS_PDO_004);
    EXPECT_EQ(WritePdo(0x1A00U, 0U, 65U), SdoAbort::kValueRange);
    EXPECT_EQ(WritePdo(0x1A00U, 0U, 254U), SdoAbort::kValueRange);
    EXPECT_EQ(WritePdo(0x1600U, 0U, 5U), SdoAbort::kMapTooLong); // room for 4
    EXPECT_EQ(WritePdo(0x1A00U, 0U, 1U), SdoAbort::kObjectUnknown);
    EXPECT_EQ(WritePdo(0x1A00U, 1U, 0x21040040U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1A00U, 2U, 0x21030001U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1A00U, 0U, 2U), SdoAbort::kMapTooLong); // 65 bits
    EXPECT_EQ(WritePdo(0x1A00U, 0U, 1U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1A00U, 0U, 0U), SdoAbort::kNone);
    // 64 single bits
    for (std::uint8_t sub = 1U; sub <= 64U; ++sub)
    {
        EXPECT_EQ(WritePdo(0x1A00U, sub, 0x21030001U), SdoAbort::kNone);
    }
    EXPECT_EQ(WritePdo(0x1A00U, 0U, 64U), SdoAbort::kNone);
}

TEST_F(PdoMappingTest, WhatMayBeMapped)
{
    Verifies(req::SRS_PDO_005);
    const std::uint16_t both[] = {0x1600U, 0x1A00U};
    for (const std::uint16_t index : both)
    {
        EXPECT_EQ(WritePdo(index, 1U, 0x22000008U), SdoAbort::kObjectUnknown);
        EXPECT_EQ(WritePdo(index, 1U, 0x21000108U), SdoAbort::kSubUnknown);
        EXPECT_EQ(WritePdo(index, 1U, 0x21090108U), SdoAbort::kNotMappable);
        EXPECT_EQ(WritePdo(index, 1U, 0x20000120U), SdoAbort::kNotMappable); // the kernel's
        EXPECT_EQ(WritePdo(index, 1U, 0x21000010U), SdoAbort::kNotMappable); // 16 of 8 bits
        EXPECT_EQ(WritePdo(index, 1U, 0x21000001U), SdoAbort::kNotMappable);
        EXPECT_EQ(WritePdo(index, 1U, 0x21030002U), SdoAbort::kNotMappable); // BOOLEAN has 1 bit, or a byte
        EXPECT_EQ(WritePdo(index, 1U, 0x21030010U), SdoAbort::kNotMappable);
        EXPECT_EQ(WritePdo(index, 1U, 0x21030008U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(index, 1U, 0x21050018U), SdoAbort::kNone); // 24 bits
        EXPECT_EQ(WritePdo(index, 1U, 0x00000000U), SdoAbort::kNone);
    }
    EXPECT_EQ(WritePdo(0x1600U, 1U, 0x21070008U), SdoAbort::kNotMappable);
    EXPECT_EQ(WritePdo(0x1A00U, 1U, 0x21080008U), SdoAbort::kNotMappable);
    EXPECT_EQ(WritePdo(0x1600U, 1U, 0x21080008U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1A00U, 1U, 0x21070008U), SdoAbort::kNone);
    const std::uint32_t dummies[] = {0x00010001U, 0x00010008U, 0x00020008U, 0x00030010U,
                                     0x00040020U, 0x00050008U, 0x00060010U, 0x00070020U};
    for (const std::uint32_t dummy : dummies)
    {
        EXPECT_EQ(WritePdo(0x1600U, 1U, dummy), SdoAbort::kNone) << dummy;
        EXPECT_EQ(WritePdo(0x1600U, 2U, dummy + 1U), SdoAbort::kObjectUnknown) << dummy;
        EXPECT_EQ(WritePdo(0x1A00U, 1U, dummy), SdoAbort::kObjectUnknown) << dummy;
    }
    EXPECT_EQ(WritePdo(0x1600U, 2U, 0x00080020U), SdoAbort::kObjectUnknown);
}

TEST_F(PdoMappingTest, FieldsStandSideBySideBitByBit)
{
    Verifies(req::SRS_PDO_006);
    // Given 1 bit, 24 bits, 8 bits, 1 bit: 34 bits
    const std::uint32_t fields[] = {0x21030001U, 0x21050018U, 0x21060008U, 0x21030001U};
    for (const std::uint16_t index : Indices{0x1600U, 0x1A00U})
    {
        for (std::uint8_t sub = 1U; sub <= 4U; ++sub)
        {
            EXPECT_EQ(WritePdo(index, sub, fields[sub - 1U]), SdoAbort::kNone);
        }
        EXPECT_EQ(WritePdo(index, 0U, 4U), SdoAbort::kNone);
    }
    EXPECT_EQ(WritePdo(0x1800U, 1U, 0x185U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1400U, 1U, 0x205U), SdoAbort::kNone);
    Cycle();
    // 1 | CCBBAAh << 1 | 0Fh << 25 | 1 << 33
    EXPECT_EQ(sink.Next(), (Octets{0x55U, 0x77U, 0x99U, 0x1FU, 0x02U}));
    // When other values come: 0, 345678h, 20, 0
    Hear({0xF0U, 0xACU, 0x68U, 0x28U, 0x00U});
    EXPECT_EQ(bit[0], 0U);
    EXPECT_EQ(u24, (std::array<std::uint8_t, 3>{0x78U, 0x56U, 0x34U}));
    EXPECT_EQ(tens[0], 20U);
    // and one that is above its limit: it alone is left out
    Hear({0x03U, 0x00U, 0x00U, 0x2AU, 0x02U});
    EXPECT_EQ(bit[0], 1U);
    EXPECT_EQ(u24, (std::array<std::uint8_t, 3>{0x01U, 0x00U, 0x00U}));
    EXPECT_EQ(tens[0], 20U);
}

TEST_F(PdoMappingTest, ABooleanMayBeAByteOfZeroOrOne)
{
    Verifies(req::SRS_PDO_005);
    Verifies(req::SRS_PDO_006);
    // Given a BOOLEAN of 8 bits in front of a byte, both ways
    for (const std::uint16_t index : Indices{0x1600U, 0x1A00U})
    {
        EXPECT_EQ(WritePdo(index, 1U, 0x21030008U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(index, 2U, 0x21000008U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(index, 0U, 2U), SdoAbort::kNone);
    }
    EXPECT_EQ(WritePdo(0x1800U, 1U, 0x185U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1400U, 1U, 0x205U), SdoAbort::kNone);
    Cycle();
    EXPECT_EQ(sink.Next(), (Octets{0x01U, 0x11U}));
    // When 0 comes it is taken, and so is 1; what no BOOLEAN can be leaves it as it was
    Hear({0x00U, 0x22U});
    EXPECT_EQ(bit[0], 0U);
    Hear({0x02U, 0x33U});
    EXPECT_EQ(bit[0], 0U);
    EXPECT_EQ(u8[0], 0x33U);
    Hear({0x01U, 0x33U});
    EXPECT_EQ(bit[0], 1U);
}

TEST_F(PdoMappingTest, DummiesAreSkipped)
{
    Verifies(req::SRS_PDO_005);
    Verifies(req::SRS_PDO_006);
    EXPECT_EQ(WritePdo(0x1600U, 1U, 0x00060010U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1600U, 2U, 0x21000008U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1600U, 0U, 2U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1400U, 1U, 0x205U), SdoAbort::kNone);
    Hear({1U, 2U, 0x99U});
    EXPECT_EQ(u8[0], 0x99U);
}

TEST_F(PdoMappingTest, DefaultsComeInAnyOrderAndAreCheckedAtTheEnd)
{
    Verifies(req::SRS_PDO_007);
    UseTpdo(1U);
    UseRpdo(254U);
    tpdos.Reset();
    rpdos.Reset();
    EXPECT_EQ(Read(objects, 0x1800U, 1U), 0x4C0000000U);
    EXPECT_EQ(Read(objects, 0x1A00U, 1U), 0x400000000U);
    tpdos.BeginConfiguration();
    rpdos.BeginConfiguration();
    // Dictionary order: valid first, count before its fields
    for (const std::uint16_t index : Indices{0x1400U, 0x1800U})
    {
        const auto mapping = static_cast<std::uint16_t>(index + 0x200U);
        EXPECT_EQ(WritePdo(index, 1U, 0x185U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(index, 2U, 1U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(mapping, 0U, 1U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(mapping, 1U, 0x21000008U), SdoAbort::kNone);
    }
    EXPECT_EQ(WritePdo(0x19FFU, 1U, 0x285U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1BFFU, 0U, 1U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1BFFU, 1U, 0x77770008U), SdoAbort::kNone);
    tpdos.EndConfiguration();
    rpdos.EndConfiguration();
    EXPECT_EQ(Read(objects, 0x1800U, 1U), 0x400000185U);
    EXPECT_EQ(Read(objects, 0x1400U, 1U), 0x400000185U);
    EXPECT_EQ(Read(objects, 0x1A00U, 0U), 0x100000001U);
    EXPECT_EQ(Read(objects, 0x19FFU, 1U), 0x480000285U); // its object is gone
    EXPECT_EQ(Read(objects, 0x1BFFU, 0U), 0x100000000U);
    EXPECT_EQ(Read(objects, 0x1BFFU, 1U), 0x400000000U);
    EXPECT_EQ(WritePdo(0x1BFFU, 0U, 1U), SdoAbort::kObjectUnknown);
    Sync0();
    EXPECT_EQ(sink.Next(), (Octets{0x11U}));
}

} // namespace
} // namespace counterpoint::cia301
