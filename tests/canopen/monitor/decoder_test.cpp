// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/decoder.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/monitor/recordings.hpp"
#include "verification/trace/ids/monitor.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace counterpoint::monitor
{
namespace
{
using test::Frame;

std::string Example(const std::string& name)
{
    return cia306::test::SourceFolder() + "/examples/emergency_stop/" + name + ".dcf";
}

class DecoderTest : public ::testing::Test
{
  protected:
    std::string Words(const LogFrame& frame)
    {
        return decoder.Decode(frame);
    }
    std::string Words(const std::uint32_t identifier, const std::vector<std::uint8_t>& data)
    {
        return decoder.Decode(Frame(0, identifier, data));
    }
    Network network{{{Example("sensor"), std::nullopt}, {Example("controller"), std::nullopt}}, std::nullopt};
    Analysis analysis{network, [](const Violation&) {}};
    Decoder decoder{network, analysis};
};

TEST_F(DecoderTest, NetworkManagement)
{
    Verifies(req::SRS_MON_004);
    EXPECT_EQ(Words(0x000U, {1U, 0U}), "000h [2] 01 00  NMT start, all nodes");
    EXPECT_EQ(Words(0x000U, {130U, 1U}), "000h [2] 82 01  NMT reset communication, Sensor");
    EXPECT_EQ(Words(0x000U, {2U, 77U}), "000h [2] 02 4D  NMT stop, node 77");
    EXPECT_EQ(Words(0x701U, {0U}), "701h [1] 00  error control Sensor boot-up");
    EXPECT_EQ(Words(0x702U, {5U}), "702h [1] 05  error control Controller is OPERATIONAL");
    EXPECT_EQ(Words(0x702U, {0xFFU}), "702h [1] FF  error control Controller is PRE-OPERATIONAL, toggle 1");
    LogFrame guarding = Frame(0, 0x701U, {});
    guarding.is_remote = true;
    EXPECT_EQ(Words(guarding), "701h [0]  error control remote guarding request, Sensor");
    EXPECT_EQ(Words(0x001U, {}), "001h [0]  GFC global fail-safe command");
    EXPECT_EQ(Words(0x080U, {}), "080h [0]  SYNC ");
    EXPECT_EQ(Words(0x100U, {1U, 0U, 0U, 0U, 2U, 0U}), "100h [6] 01 00 00 00 02 00  TIME ");
    EXPECT_EQ(Words(0x7E5U, {4U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}), "7E5h [8] 04 00 00 00 00 00 00 00  LSS ");
}

TEST_F(DecoderTest, CommandsThatNobodyObeysAreMarked)
{
    Verifies(req::SRS_MON_019);
    EXPECT_EQ(Words(0x000U, {5U, 1U}), "000h [2] 05 01  NMT INVALID: command 5, Sensor");
    EXPECT_EQ(Words(0x000U, {1U, 128U}), "000h [2] 01 80  NMT INVALID: start, node 128");
    EXPECT_EQ(Words(0x000U, {1U}), "000h [1] 01  NMT INVALID: of wrong length");
    EXPECT_EQ(Words(0x000U, {1U, 1U, 0U}), "000h [3] 01 01 00  NMT INVALID: of wrong length");
    EXPECT_EQ(Words(0x000U, {1U, 127U}), "000h [2] 01 7F  NMT start, node 127");
}

TEST_F(DecoderTest, ARemoteFrameHasNoValue)
{
    Verifies(req::SRS_MON_019);
    const auto remote = [this](const std::uint32_t identifier, const std::uint8_t length)
    {
        LogFrame frame = Frame(0, identifier, {});
        frame.is_remote = true;
        frame.length = length;
        return Words(frame);
    };
    EXPECT_EQ(remote(0x081U, 8U), "081h [8]  EMCY remote INVALID: no data frame");
    EXPECT_EQ(remote(0x101U, 2U), "101h [2]  SRDO remote INVALID: no data frame");
    EXPECT_EQ(remote(0x171U, 2U), "171h [2]  SRDO remote INVALID: no data frame");
    EXPECT_EQ(remote(0x001U, 0U), "001h [0]  GFC remote INVALID: no data frame");
    EXPECT_EQ(remote(0x000U, 2U), "000h [2]  NMT remote INVALID: no data frame");
    EXPECT_EQ(remote(0x080U, 0U), "080h [0]  SYNC remote INVALID: no data frame");
    EXPECT_EQ(remote(0x100U, 6U), "100h [6]  TIME remote INVALID: no data frame");
    EXPECT_EQ(remote(0x601U, 8U), "601h [8]  SDO remote INVALID: no data frame");
    EXPECT_EQ(remote(0x7E5U, 8U), "7E5h [8]  LSS remote INVALID: no data frame");
    EXPECT_EQ(remote(0x071U, 2U), "071h [2]  other remote INVALID: no data frame");
    // Those of PDOs and guarding ask for something; an identifier without a service says nothing
    EXPECT_EQ(remote(0x182U, 8U), "182h [8]  other remote request of TPDO 1 of Controller, by its identifier");
    EXPECT_EQ(remote(0x702U, 1U), "702h [1]  error control remote guarding request, Controller");
    EXPECT_EQ(remote(0x6E0U, 1U), "6E0h [1]  other remote ");
}

TEST_F(DecoderTest, LengthsThatNobodyObeysAreMarked)
{
    Verifies(req::SRS_MON_019);
    EXPECT_EQ(Words(0x080U, {7U}), "080h [1] 07  SYNC ");
    EXPECT_EQ(Words(0x080U, {7U, 0U}), "080h [2] 07 00  SYNC INVALID: of wrong length");
    EXPECT_EQ(Words(0x100U, {1U, 2U, 3U, 4U, 5U, 6U}), "100h [6] 01 02 03 04 05 06  TIME ");
    EXPECT_EQ(Words(0x100U, {1U, 2U, 3U, 4U, 5U}), "100h [5] 01 02 03 04 05  TIME INVALID: of wrong length");
    EXPECT_EQ(Words(0x081U, {0x10U, 0x81U, 1U}), "081h [3] 10 81 01  EMCY Sensor INVALID: of wrong length");
    EXPECT_EQ(Words(0x601U, {0x40U, 0x17U, 0x10U, 0U}), "601h [4] 40 17 10 00  SDO Sensor <- INVALID: of wrong length");
    EXPECT_EQ(Words(0x701U, {5U, 5U}), "701h [2] 05 05  error control Sensor INVALID: of wrong length");
    EXPECT_EQ(Words(0x001U, {0U}), "001h [1] 00  GFC INVALID: with data");
    EXPECT_EQ(Words(0x709U, {6U}), "709h [1] 06  error control node 9 is INVALID: state 6");
    EXPECT_EQ(Words(0x709U, {0x86U}), "709h [1] 86  error control node 9 is INVALID: state 6, toggle 1");
    // A boot-up has no toggle bit
    EXPECT_EQ(Words(0x709U, {0x80U}), "709h [1] 80  error control node 9 is INVALID: state 0, toggle 1");
}

TEST_F(DecoderTest, GuardingHasItsToggleBit)
{
    Verifies(req::SRS_MON_019);
    LogFrame request = Frame(0, 0x705U, {});
    request.is_remote = true;
    const auto answer = [this, &request](const std::uint8_t byte)
    {
        static_cast<void>(Words(request));
        return Words(0x705U, {byte});
    };
    EXPECT_EQ(answer(0x05U), "705h [1] 05  error control guarding answer, node 5 is OPERATIONAL, toggle 0");
    EXPECT_EQ(answer(0x85U), "705h [1] 85  error control guarding answer, node 5 is OPERATIONAL, toggle 1");
    EXPECT_EQ(answer(0x85U),
              "705h [1] 85  error control guarding answer, node 5 is OPERATIONAL, toggle 1, INVALID: not alternated");
    // A boot-up message is no answer, and the toggle bit begins anew
    EXPECT_EQ(answer(0x00U), "705h [1] 00  error control node 5 boot-up");
    EXPECT_EQ(answer(0x7FU), "705h [1] 7F  error control guarding answer, node 5 is PRE-OPERATIONAL, toggle 0");
    // Without a request it is a heartbeat
    EXPECT_EQ(Words(0x705U, {4U}), "705h [1] 04  error control node 5 is STOPPED");
}

TEST(DecoderWithoutFiles, NamesWhatIdentifiersSayByThemselves)
{
    Verifies(req::SRS_MON_019);
    const Network network{{}, std::nullopt};
    const Analysis analysis{network, [](const Violation&) {}};
    Decoder decoder{network, analysis};
    const auto words = [&decoder](const std::uint32_t identifier, const std::vector<std::uint8_t>& data)
    { return decoder.Decode(Frame(0, identifier, data)); };
    EXPECT_EQ(words(0x071U, {1U, 127U}),
              "071h [2] 01 7F  other flying master: active NMT master is node 127, priority 1");
    EXPECT_EQ(words(0x072U, {}), "072h [0]  other flying master: begins the negotiation");
    EXPECT_EQ(words(0x073U, {}), "073h [0]  other flying master: asks for the active NMT master");
    EXPECT_EQ(words(0x074U, {}), "074h [0]  other flying master: could be the NMT master");
    EXPECT_EQ(words(0x075U, {}), "075h [0]  other flying master: asks who could be");
    EXPECT_EQ(words(0x076U, {}), "076h [0]  other flying master: forces a new negotiation");
    EXPECT_EQ(words(0x077U, {}), "077h [0]  other ");
    EXPECT_EQ(words(0x185U, {1U}), "185h [1] 01  other TPDO 1 of node 5, by its identifier");
    EXPECT_EQ(words(0x57FU, {1U}), "57Fh [1] 01  other RPDO 4 of node 127, by its identifier");
    EXPECT_EQ(words(0x000U, {1U, 5U}), "000h [2] 01 05  NMT start, node 5");
    EXPECT_EQ(words(0x102U, {1U}), "102h [1] 01  SRDO inverse, of no file");
}

TEST(DecoderWithoutFiles, MarksWhatNoFlyingMasterObeys)
{
    Verifies(req::SRS_MON_531);
    const Network network{{}, std::nullopt};
    const Analysis analysis{network, [](const Violation&) {}};
    Decoder decoder{network, analysis};
    const auto words = [&decoder](const std::uint32_t identifier, const std::vector<std::uint8_t>& data)
    {
        const std::string text = decoder.Decode(Frame(0, identifier, data));
        return text.substr(text.find("master: ") + 8U);
    };
    const std::string wrong = "INVALID: of wrong length";
    EXPECT_EQ(words(0x071U, {}), wrong);
    EXPECT_EQ(words(0x071U, {1U}), wrong);
    EXPECT_EQ(words(0x071U, {1U, 2U, 3U}), wrong);
    EXPECT_EQ(words(0x071U, {1U, 0U}), "INVALID: active NMT master is node 0, priority 1");
    EXPECT_EQ(words(0x071U, {1U, 1U}), "active NMT master is node 1, priority 1");
    EXPECT_EQ(words(0x071U, {255U, 127U}), "active NMT master is node 127, priority 255");
    EXPECT_EQ(words(0x071U, {1U, 128U}), "INVALID: active NMT master is node 128, priority 1");
    EXPECT_EQ(words(0x071U, {1U, 255U}), "INVALID: active NMT master is node 255, priority 1");
    for (std::uint32_t identifier = 0x072U; identifier <= 0x076U; ++identifier)
    {
        EXPECT_EQ(words(identifier, {0U}), wrong) << identifier;
        EXPECT_EQ(words(identifier, {1U, 2U}), wrong) << identifier;
        EXPECT_EQ(words(identifier, {}).find("INVALID"), std::string::npos) << identifier;
    }
}

TEST_F(DecoderTest, LssFramesHaveEightBytes)
{
    Verifies(req::SRS_MON_019);
    EXPECT_EQ(Words(0x7E4U, {4U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}), "7E4h [8] 04 00 00 00 00 00 00 00  LSS ");
    EXPECT_EQ(Words(0x7E5U, {4U, 0U, 0U, 0U, 0U, 0U, 0U}),
              "7E5h [7] 04 00 00 00 00 00 00  LSS INVALID: of wrong length");
    EXPECT_EQ(Words(0x7E4U, {}), "7E4h [0]  LSS INVALID: of wrong length");
}

TEST_F(DecoderTest, Emergencies)
{
    Verifies(req::SRS_MON_004);
    EXPECT_EQ(Words(0x081U, {0x00U, 0x63U, 0x81U, 0U, 0U, 0U, 0U, 0U}),
              "081h [8] 00 63 81 00 00 00 00 00  EMCY Sensor error 6300h, register 81h");
    EXPECT_EQ(Words(0x082U, {0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}),
              "082h [8] 00 00 00 00 00 00 00 00  EMCY Controller no error, register 00h");
}

TEST_F(DecoderTest, ServiceDataObjects)
{
    Verifies(req::SRS_MON_004);
    EXPECT_EQ(Words(0x601U, {0x40U, 0x17U, 0x10U, 0U, 0U, 0U, 0U, 0U}),
              "601h [8] 40 17 10 00 00 00 00 00  SDO Sensor <- read 1017h:00 Producer heartbeat time [ms]");
    EXPECT_EQ(Words(0x581U, {0x4BU, 0x17U, 0x10U, 0U, 100U, 0U, 0U, 0U}),
              "581h [8] 4B 17 10 00 64 00 00 00  SDO Sensor -> value 1017h:00 Producer heartbeat time [ms] = 100");
    EXPECT_EQ(Words(0x601U, {0x2BU, 0x17U, 0x10U, 0U, 0xE8U, 3U, 0U, 0U}),
              "601h [8] 2B 17 10 00 E8 03 00 00  SDO Sensor <- write 1017h:00 Producer heartbeat time [ms] = 1000");
    EXPECT_EQ(
        Words(0x581U, {0x80U, 0x17U, 0x10U, 0U, 0x30U, 0U, 9U, 6U}),
        "581h [8] 80 17 10 00 30 00 09 06  SDO Sensor -> abort 0609 0030h (value out of range), 1017h:00 Producer "
        "heartbeat time [ms]");
    EXPECT_EQ(Words(0x609U, {0x40U, 0x00U, 0x20U, 1U, 0U, 0U, 0U, 0U}),
              "609h [8] 40 00 20 01 00 00 00 00  SDO node 9 <- read 2000h:01");
}

TEST_F(DecoderTest, SegmentsAndBlocks)
{
    Verifies(req::SRS_MON_004);
    EXPECT_NE(Words(0x581U, {0x41U, 0x08U, 0x10U, 0U, 9U, 0U, 0U, 0U}).find("value 1008h:00, 9 bytes"),
              std::string::npos);
    EXPECT_NE(Words(0x601U, {0x60U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}).find("segment of 1008h:00"), std::string::npos);
    // A block write: begin, two segments, the last one, acknowledge, end
    EXPECT_NE(Words(0x601U, {0xC6U, 0x50U, 0x1FU, 1U, 20U, 0U, 0U, 0U}).find("begin of a block write of 1F50h:01"),
              std::string::npos);
    EXPECT_NE(Words(0x581U, {0xA4U, 0x50U, 0x1FU, 1U, 127U, 0U, 0U, 0U}).find("a block write of 1F50h:01"),
              std::string::npos);
    EXPECT_NE(Words(0x601U, {0x01U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}).find("segment 1 of a block of 1F50h:01"),
              std::string::npos);
    EXPECT_NE(Words(0x601U, {0x40U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}).find("segment 64 of a block"), std::string::npos);
    EXPECT_NE(Words(0x601U, {0xC1U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}).find("segment 65 of a block"), std::string::npos);
    EXPECT_NE(Words(0x581U, {0xA2U, 65U, 127U, 0U, 0U, 0U, 0U, 0U}).find("acknowledge in a block write"),
              std::string::npos);
    EXPECT_NE(Words(0x601U, {0xC5U, 0x34U, 0x12U, 0U, 0U, 0U, 0U, 0U}).find("end of a block write"), std::string::npos);
}

TEST_F(DecoderTest, SafetyData)
{
    Verifies(req::SRS_MON_004);
    EXPECT_EQ(Words(0x101U, {1U, 0U}),
              "101h [2] 01 00  SRDO Sensor SRDO 1 -> Controller SRDO 1 normal: Button 1 = 1, Button 2 = 0");
    EXPECT_EQ(Words(0x102U, {0xFEU, 0xFFU}), "102h [2] FE FF  SRDO Sensor SRDO 1 -> Controller SRDO 1 inverse");
    EXPECT_EQ(Words(0x103U, {1U, 0U}).find("103h [2] 01 00  SRDO Controller SRDO 2 -> nobody here normal: "), 0U);
    EXPECT_EQ(Words(0x17FU, {1U}), "17Fh [1] 01  SRDO normal, of no file");
    LogFrame foreign = Frame(0, 0x101U, {1U});
    foreign.is_extended = true;
    EXPECT_EQ(Words(foreign), "00000101h [1] 01  29 bits ");
}

TEST_F(DecoderTest, ProcessData)
{
    Verifies(req::SRS_MON_004);
    // Given a device with a TPDO of a signed number and a bit
    const std::string path = (std::filesystem::temp_directory_path() / "decoder_test.dcf").string();
    cia306::WriteTextFile(
        path,
        "[DeviceComissioning]\nNodeID=5\nNodeName=Drive\n\n[1800]\nSubNumber=1\nObjectType=9\n\n"
        "[1800sub1]\nDataType=7\nAccessType=rw\nDefaultValue=$NODEID+0x180\n\n[1A00]\nSubNumber=3\nObjectType=9\n\n"
        "[1A00sub0]\nDataType=5\nAccessType=rw\nDefaultValue=2\n\n[1A00sub1]\nDataType=7\nAccessType=rw\n"
        "DefaultValue=0x60000010\n\n[1A00sub2]\nDataType=7\nAccessType=rw\nDefaultValue=0x60010001\n\n"
        "[6000]\nParameterName=Speed\nDataType=3\nAccessType=ro\nPDOMapping=1\n\n[6001]\nParameterName=Moving\n"
        "DataType=1\nAccessType=ro\nPDOMapping=1\n");
    const Network drive({{path, std::nullopt}}, std::nullopt);
    std::filesystem::remove(path);
    const Analysis of_drive(drive, [](const Violation&) {});
    Decoder words(drive, of_drive);
    EXPECT_EQ(words.Decode(Frame(0, 0x185U, {0xFEU, 0xFFU, 1U})),
              "185h [3] FE FF 01  PDO Drive TPDO 1: Speed = -2, Moving = 1");
    // A remote frame asks for it, whatever length it states
    LogFrame request = Frame(0, 0x185U, {});
    request.is_remote = true;
    request.length = 3U;
    EXPECT_EQ(words.Decode(request), "185h [3]  PDO remote request of Drive TPDO 1");
}
} // namespace
} // namespace counterpoint::monitor
