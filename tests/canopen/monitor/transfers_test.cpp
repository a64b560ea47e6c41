// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// SDO transfers, values and mappings in words.
#include "canopen/monitor/decoder.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/monitor/recordings.hpp"
#include "verification/trace/ids/monitor.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::monitor
{
namespace
{
using test::Frame;
using Bytes = std::vector<std::uint8_t>;

std::string Example(const std::string& name)
{
    return cia306::test::SourceFolder() + "/examples/emergency_stop/" + name + ".dcf";
}

std::string ObjectOf(const std::string& section, const std::string& name, const int type)
{
    return "[" + section + "]\nParameterName=" + name + "\nObjectType=7\nDataType=" + std::to_string(type) +
           "\nAccessType=rw\nPDOMapping=1\n\n";
}

/// What stands behind "SDO ", or "PDO ".
class Words
{
  public:
    explicit Words(const Network& network) : analysis_(network, [](const Violation&) {}), decoder_(network, analysis_)
    {
    }
    std::string operator()(const LogFrame& frame)
    {
        const std::string text = decoder_.Decode(frame);
        const std::size_t name = text.find("DO ");
        return name == std::string::npos ? text : text.substr(name + 3U);
    }
    std::string operator()(const std::uint32_t identifier, const Bytes& data)
    {
        return (*this)(Frame(0, identifier, data));
    }

  private:
    Analysis analysis_;
    Decoder decoder_;
};

class TransfersTest : public ::testing::Test
{
  protected:
    Network network{{{Example("sensor"), std::nullopt}}, std::nullopt};
    Words words{network};
};

TEST_F(TransfersTest, AnObjectAndItsSubIndexHaveTheirNames)
{
    Verifies(req::SRS_MON_004);
    EXPECT_EQ(words(0x601U, {0x40U, 0x01U, 0x13U, 2U, 0U, 0U, 0U, 0U}),
              "Sensor <- read 1301h:02 SRDO 1 communication parameter, Refresh time or SCT");
    EXPECT_EQ(words(0x581U, {0x60U, 0x01U, 0x13U, 2U, 0U, 0U, 0U, 0U}),
              "Sensor -> written 1301h:02 SRDO 1 communication parameter, Refresh time or SCT");
    // One that the file does not have has that of its object
    EXPECT_EQ(words(0x601U, {0x40U, 0x01U, 0x13U, 99U, 0U, 0U, 0U, 0U}),
              "Sensor <- read 1301h:63 SRDO 1 communication parameter");
}

// A length that is not stated: four bytes of an expedited transfer, none told of a segmented one.
TEST_F(TransfersTest, AValueWithoutAStatedLengthIsOfFourBytes)
{
    Verifies(req::SRS_MON_004);
    EXPECT_EQ(words(0x581U, {0x42U, 0x17U, 0x10U, 0U, 0x64U, 0U, 1U, 0U}),
              "Sensor -> value 1017h:00 Producer heartbeat time [ms] = 65636");
    EXPECT_EQ(words(0x581U, {0x40U, 0x17U, 0x10U, 0U, 0x64U, 0U, 0U, 0U}),
              "Sensor -> value 1017h:00 Producer heartbeat time [ms]");
    EXPECT_EQ(words(0x581U, {0x41U, 0x17U, 0x10U, 0U, 0x64U, 0U, 0U, 0U}),
              "Sensor -> value 1017h:00 Producer heartbeat time [ms], 100 bytes");
    // Of a node without a file it is hexadecimal
    EXPECT_EQ(words(0x589U, {0x4BU, 0x17U, 0x10U, 0U, 0x64U, 0U, 0U, 0U}), "node 9 -> value 1017h:00 = 0x0064");
}

// Given a block read with a stated size, in two blocks, when each frame is told, then each by what it is.
TEST_F(TransfersTest, ABlockReadIsToldFromBeginToEnd)
{
    Verifies(req::SRS_MON_004);
    Verifies(req::SRS_MON_331);
    EXPECT_EQ(words(0x601U, {0xA4U, 0x50U, 0x1FU, 1U, 2U, 0U, 0U, 0U}), "Sensor <- begin of a block read of 1F50h:01");
    EXPECT_EQ(words(0x581U, {0xC6U, 0x50U, 0x1FU, 1U, 20U, 0U, 0U, 0U}), "Sensor -> begin of a block read of 1F50h:01");
    EXPECT_EQ(words(0x601U, {0xA3U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}), "Sensor <- start of a block read of 1F50h:01");
    EXPECT_EQ(words(0x581U, {0x01U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}), "Sensor -> segment 1 of a block of 1F50h:01");
    EXPECT_EQ(words(0x581U, {0x02U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}), "Sensor -> segment 2 of a block of 1F50h:01");
    EXPECT_EQ(words(0x601U, {0xA2U, 2U, 2U, 0U, 0U, 0U, 0U, 0U}), "Sensor <- acknowledge in a block read of 1F50h:01");
    EXPECT_EQ(words(0x581U, {0x81U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}), "Sensor -> segment 1 of a block of 1F50h:01");
    EXPECT_EQ(words(0x601U, {0xA2U, 1U, 2U, 0U, 0U, 0U, 0U, 0U}), "Sensor <- acknowledge in a block read of 1F50h:01");
    EXPECT_EQ(words(0x581U, {0xC5U, 0x34U, 0x12U, 0U, 0U, 0U, 0U, 0U}), "Sensor -> end of a block read of 1F50h:01");
    EXPECT_EQ(words(0x601U, {0xA1U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}), "Sensor <- end of a block read of 1F50h:01");
    // Without a size it begins as well
    EXPECT_EQ(words(0x581U, {0xC4U, 0x51U, 0x1FU, 1U, 0U, 0U, 0U, 0U}), "Sensor -> begin of a block read of 1F51h:01");
}

// Given a block write, when the server answers among the segments or either ends it, then what follows is no segment.
TEST_F(TransfersTest, ABlockWriteMayBeAnsweredAndAborted)
{
    Verifies(req::SRS_MON_004);
    const auto begin = [this]()
    {
        EXPECT_EQ(words(0x601U, {0xC6U, 0x50U, 0x1FU, 1U, 20U, 0U, 0U, 0U}),
                  "Sensor <- begin of a block write of 1F50h:01");
        EXPECT_EQ(words(0x581U, {0xA4U, 0x50U, 0x1FU, 1U, 2U, 0U, 0U, 0U}),
                  "Sensor -> begin of a block write of 1F50h:01");
        EXPECT_EQ(words(0x601U, {0x01U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}), "Sensor <- segment 1 of a block of 1F50h:01");
    };
    begin();
    EXPECT_EQ(words(0x581U, {0xA2U, 1U, 2U, 0U, 0U, 0U, 0U, 0U}), "Sensor -> acknowledge in a block write of 1F50h:01");
    EXPECT_EQ(words(0x601U, {0x81U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}), "Sensor <- segment 1 of a block of 1F50h:01");
    EXPECT_EQ(words(0x581U, {0xA2U, 1U, 2U, 0U, 0U, 0U, 0U, 0U}), "Sensor -> acknowledge in a block write of 1F50h:01");
    EXPECT_EQ(words(0x601U, {0xD5U, 0x34U, 0x12U, 0U, 0U, 0U, 0U, 0U}), "Sensor <- end of a block write of 1F50h:01");
    EXPECT_EQ(words(0x581U, {0xA1U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}), "Sensor -> end of a block write of 1F50h:01");
    // The client aborts
    begin();
    EXPECT_EQ(words(0x601U, {0x80U, 0x50U, 0x1FU, 1U, 0U, 0U, 4U, 5U}),
              "Sensor <- abort 0504 0000h (time-out), 1F50h:01");
    EXPECT_EQ(words(0x601U, {0x40U, 0x50U, 0x1FU, 1U, 0U, 0U, 0U, 0U}), "Sensor <- read 1F50h:01");
    // The server ends it before the last segment
    begin();
    EXPECT_EQ(words(0x581U, {0xA1U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}), "Sensor -> end of a block write of 1F50h:01");
    EXPECT_EQ(words(0x601U, {0x40U, 0x50U, 0x1FU, 1U, 0U, 0U, 0U, 0U}), "Sensor <- read 1F50h:01");
}

// Given commands that neither side of a transfer has, when they are told, then as such, and the transfer is not lost.
TEST_F(TransfersTest, ACommandThatThereIsNotIsInvalid)
{
    Verifies(req::SRS_MON_330);
    EXPECT_EQ(words(0x581U, {0x41U, 0x08U, 0x10U, 0U, 9U, 0U, 0U, 0U}), "Sensor -> value 1008h:00, 9 bytes");
    EXPECT_EQ(words(0x601U, {0xE0U, 0x17U, 0x10U, 0U, 0U, 0U, 0U, 0U}), "Sensor <- INVALID: command E0h");
    EXPECT_EQ(words(0x601U, {0xFFU, 0x17U, 0x10U, 0U, 0U, 0U, 0U, 0U}), "Sensor <- INVALID: command FFh");
    EXPECT_EQ(words(0x581U, {0xE1U, 0x17U, 0x10U, 0U, 0U, 0U, 0U, 0U}), "Sensor -> INVALID: command E1h");
    EXPECT_EQ(words(0x581U, {0xA3U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}), "Sensor -> INVALID: command A3h");
    EXPECT_EQ(words(0x581U, {0xBFU, 0U, 0U, 0U, 0U, 0U, 0U, 0U}), "Sensor -> INVALID: command BFh");
    EXPECT_EQ(words(0x601U, {0x60U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}), "Sensor <- segment of 1008h:00");
}

// The other bits of an abort have no meaning; among the segments of a block 80h alone is one.
TEST_F(TransfersTest, AnAbortIsOneWhateverItsOtherBitsAre)
{
    Verifies(req::SRS_MON_330);
    EXPECT_EQ(words(0x601U, {0x81U, 0x17U, 0x10U, 0U, 0U, 0U, 4U, 5U}),
              "Sensor <- abort 0504 0000h (time-out), 1017h:00 Producer heartbeat time [ms]");
    EXPECT_EQ(words(0x581U, {0x9FU, 0x17U, 0x10U, 0U, 0x30U, 0U, 9U, 6U}),
              "Sensor -> abort 0609 0030h (value out of range), 1017h:00 Producer heartbeat time [ms]");
    EXPECT_EQ(words(0x581U, {0xA4U, 0x50U, 0x1FU, 1U, 2U, 0U, 0U, 0U}), "Sensor -> begin of a block write of 1F50h:01");
    EXPECT_EQ(words(0x601U, {0x81U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}), "Sensor <- segment 1 of a block of 1F50h:01");
    EXPECT_EQ(words(0x581U, {0xA2U, 1U, 2U, 0U, 0U, 0U, 0U, 0U}), "Sensor -> acknowledge in a block write of 1F50h:01");
}

// Given a recording that begins within transfers, then their object is not told as 0000h:00.
TEST_F(TransfersTest, AnObjectWhoseBeginWasNotSeenIsNotKnown)
{
    Verifies(req::SRS_MON_331);
    EXPECT_EQ(words(0x601U, {0x70U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}), "Sensor <- segment of an object that is not known");
    EXPECT_EQ(words(0x602U, {0xA2U, 2U, 2U, 0U, 0U, 0U, 0U, 0U}),
              "node 2 <- acknowledge in a block read of an object that is not known");
    EXPECT_EQ(words(0x582U, {0x81U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}),
              "node 2 -> segment 1 of a block of an object that is not known");
    EXPECT_EQ(words(0x583U, {0xC5U, 0x34U, 0x12U, 0U, 0U, 0U, 0U, 0U}),
              "node 3 -> end of a block read of an object that is not known");
    // One whose begin is seen is
    EXPECT_EQ(words(0x602U, {0x40U, 0x01U, 0x20U, 3U, 0U, 0U, 0U, 0U}), "node 2 <- read 2001h:03");
    EXPECT_EQ(words(0x602U, {0x60U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}), "node 2 <- segment of 2001h:03");
}

// Given a last block of three segments of which one was lost, when it is acknowledged, then the rest comes once more.
TEST_F(TransfersTest, WhatIsLeftOfALastBlockIsToldAsSegments)
{
    Verifies(req::SRS_MON_331);
    EXPECT_EQ(words(0x601U, {0xC4U, 0x50U, 0x1FU, 1U, 0U, 0U, 0U, 0U}), "Sensor <- begin of a block write of 1F50h:01");
    EXPECT_EQ(words(0x581U, {0xA4U, 0x50U, 0x1FU, 1U, 3U, 0U, 0U, 0U}), "Sensor -> begin of a block write of 1F50h:01");
    EXPECT_EQ(words(0x601U, {0x01U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}), "Sensor <- segment 1 of a block of 1F50h:01");
    EXPECT_EQ(words(0x601U, {0x83U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}), "Sensor <- segment 3 of a block of 1F50h:01");
    EXPECT_EQ(words(0x581U, {0xA2U, 1U, 3U, 0U, 0U, 0U, 0U, 0U}), "Sensor -> acknowledge in a block write of 1F50h:01");
    EXPECT_EQ(words(0x601U, {0x01U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}), "Sensor <- segment 1 of a block of 1F50h:01");
    EXPECT_EQ(words(0x601U, {0x82U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}), "Sensor <- segment 2 of a block of 1F50h:01");
    EXPECT_EQ(words(0x581U, {0xA2U, 2U, 3U, 0U, 0U, 0U, 0U, 0U}), "Sensor -> acknowledge in a block write of 1F50h:01");
    EXPECT_EQ(words(0x601U, {0xC1U, 0x34U, 0x12U, 0U, 0U, 0U, 0U, 0U}), "Sensor <- end of a block write of 1F50h:01");
    // A segment has a number from 1 on
    EXPECT_EQ(words(0x581U, {0xA4U, 0x50U, 0x1FU, 1U, 3U, 0U, 0U, 0U}), "Sensor -> begin of a block write of 1F50h:01");
    EXPECT_EQ(words(0x601U, {0x00U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}),
              "Sensor <- INVALID: segment 0 of a block of 1F50h:01");
}

TEST(Values, AreWrittenByTheirType)
{
    Verifies(req::SRS_MON_004);
    const cia306::Device device = cia306::test::DeviceOf(
        ObjectOf("2001", "bool", 1) + ObjectOf("2002", "int8", 2) + ObjectOf("2005", "unsigned8", 5) +
        ObjectOf("2008", "real32", 8) + ObjectOf("2009", "text", 9) + ObjectOf("2011", "real64", 0x11));
    const auto text = [&device](const std::uint16_t index, const std::uint64_t value, const std::uint32_t bits)
    { return ValueText(device.Find(index, 0U), value, bits); };
    EXPECT_EQ(text(0x2001U, 1U, 1U), "1");
    EXPECT_EQ(text(0x2002U, 0xFEU, 8U), "-2");
    EXPECT_EQ(text(0x2002U, 0x7FU, 8U), "127");
    EXPECT_EQ(text(0x2002U, 0xFFFFFFFFFFFFFFFFU, 64U), "-1");
    EXPECT_EQ(text(0x2005U, 200U, 8U), "200");
    EXPECT_EQ(text(0x2008U, 0x3FC00000U, 32U), "1.500000");
    EXPECT_EQ(text(0x2011U, 0xBFF8000000000000U, 64U), "-1.500000");
    EXPECT_EQ(text(0x2009U, 0x41U, 8U), "0x41");
    // A length that the type does not have, or no object
    EXPECT_EQ(text(0x2008U, 0x12U, 16U), "0x0012");
    EXPECT_EQ(text(0x2002U, 0x12U, 65U), "0x00000000000000012");
    EXPECT_EQ(text(0x2002U, 0U, 0U), "0x0");
    EXPECT_EQ(text(0x2003U, 0x12U, 8U), "0x12");
}

/// Two drives: the first sends 185h and 285h, the second takes both and sends 285h, too.
class MappingsTest : public ::testing::Test
{
  protected:
    static std::string Pdo(const std::string& number, const std::string& cob_id, const std::vector<std::string>& fields)
    {
        const std::string mapping = (number[1] == '8' ? "1A" : "16") + number.substr(2U);
        std::string text = "[" + number + "]\nSubNumber=1\nObjectType=9\n\n" +
                           cia306::test::VariableText(number + "sub1", "7", cob_id) + "[" + mapping +
                           "]\nSubNumber=" + std::to_string(fields.size() + 1U) + "\nObjectType=9\n\n" +
                           cia306::test::VariableText(mapping + "sub0", "5", std::to_string(fields.size()));
        for (std::size_t place = 0U; place < fields.size(); ++place)
        {
            text += cia306::test::VariableText(mapping + "sub" + std::to_string(place + 1U), "7", fields[place]);
        }
        return text;
    }
    static std::string Device(const std::string& name, const std::string& text)
    {
        return test::Written(name, "[DeviceInfo]\nVendorName=test\n\n" + text);
    }
    static std::string First()
    {
        return Device("mappings_first.dcf",
                      Pdo("1800", "0x185", {"0x20010008", "0x30000108", "0x30000208", "0x40000008"}) +
                          Pdo("1801", "0x285", {"0x20010008"}) + ObjectOf("2001", "Speed", 2) +
                          "[3000]\nParameterName=Limits\nSubNumber=2\nObjectType=8\n\n[3000sub0]\nParameterName=n\n"
                          "DataType=5\nAccessType=ro\nDefaultValue=1\n\n[3000sub1]\nParameterName=\nDataType=5\n"
                          "AccessType=rw\nPDOMapping=1\n\n[3001]\nParameterName=\nSubNumber=1\nObjectType=8\n\n"
                          "[3001sub1]\nParameterName=Upper\nDataType=5\nAccessType=rw\n\n");
    }
    static std::string Second()
    {
        return Device("mappings_second.dcf", Pdo("1400", "0x185", {"0x20050008"}) +
                                                 Pdo("1401", "0x285", {"0x20050008"}) +
                                                 Pdo("1402", "0x385", {"0x20050008"}) +
                                                 Pdo("1800", "0x285", {"0x20050008"}) + ObjectOf("2005", "Command", 5));
    }
    Network network{{{Second(), std::uint8_t{6U}}, {First(), std::uint8_t{5U}}}, std::nullopt};
    Words words{network};
};

// The name of an entry, else that of its object, else its address.
TEST_F(MappingsTest, FieldsHaveTheNameThatThereIs)
{
    Verifies(req::SRS_MON_004);
    EXPECT_EQ(words(0x185U, {0xFEU, 2U, 3U, 4U}),
              "mappings_first TPDO 1: Speed = -2, Limits = 2, Limits = 0x03, 4000h:00 = 0x04");
}

TEST_F(MappingsTest, AnObjectWithoutANameHasThatOfTheOther)
{
    Verifies(req::SRS_MON_004);
    EXPECT_EQ(words(0x605U, {0x40U, 0x00U, 0x30U, 1U, 0U, 0U, 0U, 0U}), "mappings_first <- read 3000h:01 Limits");
    EXPECT_EQ(words(0x605U, {0x40U, 0x01U, 0x30U, 1U, 0U, 0U, 0U, 0U}), "mappings_first <- read 3001h:01 Upper");
}

TEST_F(MappingsTest, AFrameThatIsTooShortHasTheFieldsThatFit)
{
    Verifies(req::SRS_MON_004);
    EXPECT_EQ(words(0x185U, {0xFEU}), "mappings_first TPDO 1: Speed = -2, frame too short for the rest");
    EXPECT_EQ(words(0x185U, {}), "mappings_first TPDO 1: frame too short for the rest");
}

// Who sends a PDO knows best; one that nobody here sends is that of its receiver.
TEST_F(MappingsTest, APdoIsThatOfItsSender)
{
    Verifies(req::SRS_MON_004);
    EXPECT_EQ(words(0x285U, {7U}), "mappings_second TPDO 1: Command = 7");
    EXPECT_EQ(words(0x385U, {7U}), "mappings_second RPDO 3: Command = 7");
}

TEST_F(MappingsTest, FramesOfOtherKindsAndIdentifiersAreToldAsSuch)
{
    Verifies(req::SRS_MON_004);
    Verifies(req::SRS_MON_019);
    LogFrame wide = Frame(0, 0x185U, {7U});
    wide.is_fd = true;
    EXPECT_EQ(words(wide), "185h [1] 07  CAN FD ");
    LogFrame error = Frame(0, 0x4U, {0U});
    error.is_error = true;
    EXPECT_EQ(words(error), "00000004h [1] 00  error frame ");
    EXPECT_EQ(words(Frame(0, 0x800U, {})), "800h [0]  ");
    EXPECT_EQ(words(Frame(0, 0x070U, {})), "070h [0]  other ");
    EXPECT_EQ(words(Frame(0, 0x071U, {1U})), "071h [1] 01  other flying master: INVALID: of wrong length");
}
} // namespace
} // namespace counterpoint::monitor
