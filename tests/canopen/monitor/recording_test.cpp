// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Where a recording ends, what it may not be, and at which place its frames stand.
#include "canopen/monitor/readers.hpp"
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
using test::ByteOrder;
using test::CaptureWriter;
using test::CookedPcapOf;
using test::Frame;
using test::FramesOf;
using test::PcapngBlock;
using test::PcapngOf;
using test::PcapOf;
using test::RefusalOf;
using test::SocketCanPacket;

constexpr ByteOrder kOrder = ByteOrder::kLittle;

class RecordingTest : public ::testing::Test
{
  protected:
    [[nodiscard]] static std::string Refusal(const std::string& file)
    {
        try
        {
            static_cast<void>(ReadRecording(file));
        }
        catch (const cia306::InputError& error)
        {
            return error.what();
        }
        return "";
    }
    const std::string path = test::PathOf("recording_test.log");
};

TEST_F(RecordingTest, IsReadAsItStands)
{
    Verifies(req::SRS_MON_001);
    cia306::WriteTextFile(path, "(1.000000) can0 101#12\n");
    EXPECT_EQ(ReadRecording(path), "(1.000000) can0 101#12\n");
}

TEST_F(RecordingTest, ThatIsNoneIsRefused)
{
    Verifies(req::SRS_MON_001);
    std::filesystem::remove(path);
    EXPECT_EQ(Refusal(path),
              path + ": error: it cannot be opened (No such file or directory), expected a readable recording");
    EXPECT_EQ(Refusal(::testing::TempDir()), ::testing::TempDir() +
                                                 ": error: it is no regular file of up to 2 GB, "
                                                 "expected a recording of candump -l, pcap or pcapng");
    cia306::WriteTextFile(path, "");
    EXPECT_EQ(Refusal(path), path + ": error: it is empty, expected a recording of candump -l, pcap or pcapng");
    std::filesystem::resize_file(path, 2147483649U); // A hole: it takes no room.
    EXPECT_EQ(Refusal(path), path + ": error: it is no regular file of up to 2 GB, "
                                    "expected a recording of candump -l, pcap or pcapng");
}

// Each reader tells the line, packet or block of its last frame, from 1, whatever stands before it.
TEST(PlaceOfAFrame, IsItsLinePacketOrBlock)
{
    Verifies(req::SRS_MON_002);
    Verifies(req::SRS_MON_003);
    const std::vector<LogFrame> frames{Frame(1, 0x101U, {}), Frame(2, 0x102U, {})};
    const auto places = [](const std::string& bytes)
    {
        const auto source = OpenRecording("test.log", bytes, {});
        std::vector<std::size_t> found;
        LogFrame frame;
        while (source->Next(frame))
        {
            found.push_back(source->Place());
        }
        return found;
    };
    EXPECT_EQ(places("\n(1.000000) can0 101#\n\n(1.000000) can0 102#\n"), (std::vector<std::size_t>{2U, 4U}));
    EXPECT_EQ(places(PcapOf(frames, kOrder, false)), (std::vector<std::size_t>{1U, 2U}));
    EXPECT_EQ(places(PcapngOf(frames, kOrder, 6U)), (std::vector<std::size_t>{4U, 5U}));
}

TEST(CandumpLines, ThatAreAlmostRightAreNamed)
{
    Verifies(req::SRS_MON_002);
    const std::string length = "expected a length of 0 to 8 in brackets, or one of CAN FD in two digits";
    EXPECT_EQ(RefusalOf(" (1.000000)  can0  101   x2]  01 02\n"),
              "test.log:1:26: error: line ' (1.000000)  can0  101   x2]  01 02', " + length);
    EXPECT_EQ(RefusalOf(" (1.000000)  can0  101   [2x  01 02\n"),
              "test.log:1:26: error: line ' (1.000000)  can0  101   [2x  01 02', " + length);
    // A name of no letters, and one of 33
    const std::string form = "expected (SECONDS.MICROSECONDS) INTERFACE IDENTIFIER#DATA as candump -l writes it, or a "
                             "line of candump -ta";
    EXPECT_EQ(RefusalOf("(1.000000) " + std::string(33U, 'x') + " 101#\n"),
              "test.log:1:12: error: line '(1.000000) " + std::string(33U, 'x') + " 101#', " + form);
    EXPECT_EQ(FramesOf("(1.000000) " + std::string(32U, 'x') + " 101#\n").size(), 1U);
    // A length code is one of a classical frame alone
    EXPECT_EQ(RefusalOf("(1.000000) can0 101##01122334455667788_B\n"),
              "test.log:1:23: error: line '(1.000000) can0 101##01122334455667788_B', expected data of a length that "
              "CAN FD has");
}

std::string PcapWith(const std::uint32_t link_type, const std::string& packet)
{
    CaptureWriter writer(kOrder);
    for (const auto& [value, bytes] :
         std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0xA1B2C3D4U, 4U}, {2U, 2U}, {4U, 2U}, {0U, 8U}})
    {
        writer.Number(value, bytes);
    }
    writer.Number(262144U, 4U);
    writer.Number(link_type, 4U);
    writer.Number(0U, 8U);
    writer.Number(packet.size(), 4U);
    writer.Number(packet.size(), 4U);
    return writer.text + packet;
}

// A frame of 2 bytes whose packet is cut behind them: only the protocol tells, with and without the flag.
TEST(CapturedPackets, OfTheProtocolOfCanFdAreNoClassicalFrames)
{
    Verifies(req::SRS_MON_530);
    constexpr std::size_t kFlags = 5U;
    for (const bool is_second : {false, true})
    {
        for (const ByteOrder order : {ByteOrder::kLittle, ByteOrder::kBig})
        {
            LogFrame frame = Frame(0, 0x101U, {1U, 2U});
            EXPECT_FALSE(FramesOf(CookedPcapOf({frame}, order, is_second)).at(0).is_fd);
            EXPECT_TRUE(FramesOf(CookedPcapOf({frame}, order, is_second)).at(0).IsPlain());
            frame.is_fd = true;
            std::string text = CookedPcapOf({frame}, order, is_second);
            EXPECT_TRUE(FramesOf(text).at(0).is_fd);
            char& flags = text[text.size() - SocketCanPacket(frame).size() + kFlags];
            ASSERT_EQ(flags, 4);
            flags = 0;
            EXPECT_TRUE(FramesOf(text).at(0).is_fd);
            EXPECT_FALSE(FramesOf(text).at(0).IsPlain());
            EXPECT_EQ(FramesOf(text).at(0).length, 2U);
        }
    }
}

// The packet of a CAN FD frame has 72 bytes, whatever its flags tell; a classical one has 16 at most.
TEST(CapturedPackets, TellTheirKindByTheirLength)
{
    Verifies(req::SRS_MON_003);
    const std::string two = SocketCanPacket(Frame(0, 0x101U, {1U, 2U}));
    ASSERT_EQ(two.size(), 10U);
    EXPECT_FALSE(FramesOf(PcapWith(227U, two)).at(0).is_fd);
    EXPECT_FALSE(FramesOf(PcapWith(227U, two + std::string(6U, '\0'))).at(0).is_fd);
    EXPECT_EQ(
        RefusalOf(PcapWith(227U, two + std::string(7U, '\0'))),
        "test.log:1: error: frame of 2 bytes in a packet of 17 bytes, expected 8 bytes and the data of the frame, 8 "
        "at most");
    EXPECT_TRUE(FramesOf(PcapWith(227U, two + std::string(62U, '\0'))).at(0).is_fd);
    EXPECT_EQ(FramesOf(PcapWith(227U, two + std::string(62U, '\0'))).at(0).length, 2U);
    EXPECT_EQ(
        RefusalOf(PcapWith(227U, two + std::string(63U, '\0'))),
        "test.log:1: error: frame of 2 bytes in a packet of 73 bytes, expected 8 bytes and the data of the frame, 8 "
        "at most");
}

TEST(CapturedPackets, ThatEndInTheirIdentifierAreNamed)
{
    Verifies(req::SRS_MON_003);
    const std::string head = std::string(14U, '\0') + std::string("\x00\x0C", 2U);
    EXPECT_EQ(RefusalOf(PcapWith(113U, head + "abc")), "test.log:1: error: packet of 3 bytes, expected at least 8");
    EXPECT_EQ(RefusalOf(PcapWith(113U, head + "abcd")), "test.log:1: error: packet of 4 bytes, expected at least 8");
}

TEST(CaptureFiles, ThatEndInTheirFirstBytesAreNamed)
{
    Verifies(req::SRS_MON_003);
    const auto refusal = [](const std::string& bytes)
    {
        try
        {
            const PcapReader reader("test.pcap", bytes, {});
        }
        catch (const cia306::InputError& error)
        {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(refusal(""), "test.pcap: error: file of 0 bytes, expected a pcap header of 24");
    EXPECT_EQ(refusal("\xA1\xB2\xC3"), "test.pcap: error: file of 3 bytes, expected a pcap header of 24");
    EXPECT_EQ(refusal("\xA1\xB2\xC3\xD4"), "test.pcap: error: file of 4 bytes, expected a pcap header of 24");
}

std::string Described(const std::string& name, const std::uint32_t link_type)
{
    CaptureWriter body(kOrder);
    body.Number(link_type, 2U);
    body.Number(0U, 6U);
    body.Number(2U, 2U);
    body.Number(name.size(), 2U);
    body.text += name;
    return PcapngBlock(1U, body.text, kOrder);
}

std::string PacketOf(const std::uint32_t interface, const std::uint32_t captured, const std::string& packet)
{
    CaptureWriter body(kOrder);
    body.Number(interface, 4U);
    body.Number(0U, 8U);
    body.Number(captured, 4U);
    body.Number(captured, 4U);
    return PcapngBlock(6U, body.text + packet, kOrder);
}

/// A recording of one frame at so many ticks; `options` of its interface, if_tsresol among them or not.
std::string TickedPcapng(const std::string& options, const std::uint64_t ticks)
{
    CaptureWriter interface(kOrder);
    interface.Number(227U, 2U);
    interface.Number(0U, 6U);
    CaptureWriter packet(kOrder);
    packet.Number(0U, 4U);
    packet.Number(ticks >> 32U, 4U);
    packet.Number(ticks & 0xFFFFFFFFU, 4U);
    const std::string bytes = SocketCanPacket(Frame(0, 0x101U, {}));
    packet.Number(bytes.size(), 4U);
    packet.Number(bytes.size(), 4U);
    const std::string section = PcapngOf({}, kOrder, 6U).substr(0U, 28U);
    return section + PcapngBlock(1U, interface.text + options, kOrder) + PcapngBlock(6U, packet.text + bytes, kOrder);
}

std::string Resolution(const std::uint8_t value)
{
    return std::string("\x09\0\x01\0", 4U) + static_cast<char>(value) + std::string(3U, '\0');
}

// Powers of ten and, with the highest bit, of two; without the option microseconds.
TEST(PcapngTimes, HaveTheResolutionOfTheirInterface)
{
    Verifies(req::SRS_MON_003);
    struct Row
    {
        std::string options;
        std::uint64_t ticks;
        Time time;
    };
    for (const Row& row :
         {Row{"", 1500000U, 1500 * kMillisecond}, Row{Resolution(0U), 7U, 7 * kSecond},
          Row{Resolution(3U), 1500U, 1500 * kMillisecond}, Row{Resolution(6U), 1500000U, 1500 * kMillisecond},
          Row{Resolution(12U), 1500000000000U, 1500 * kMillisecond},
          Row{Resolution(18U), 1500000000000000000U, 1500 * kMillisecond}, Row{Resolution(0x80U), 7U, 7 * kSecond},
          Row{Resolution(0x8AU), 1536U, 1500 * kMillisecond},
          Row{Resolution(0xBEU), std::uint64_t{3U} << 61U, 1500 * kMillisecond}})
    {
        const std::vector<LogFrame> frames = FramesOf(TickedPcapng(row.options, row.ticks));
        ASSERT_EQ(frames.size(), 1U);
        EXPECT_EQ(frames[0].time, row.time) << row.ticks;
    }
    EXPECT_EQ(RefusalOf(TickedPcapng(Resolution(19U), 0U)),
              "test.log:2: error: block 2: a time resolution of 19, expected at most 10^-18 or 2^-62 seconds");
    EXPECT_EQ(RefusalOf(TickedPcapng(Resolution(0xBFU), 0U)),
              "test.log:2: error: block 2: a time resolution of 191, expected at most 10^-18 or 2^-62 seconds");
    // The last time that is one
    EXPECT_EQ(FramesOf(TickedPcapng(Resolution(0U), 4000000000U))[0].time, 4000000000 * kSecond);
    EXPECT_EQ(RefusalOf(TickedPcapng(Resolution(0U), 4000000001U)),
              "test.log:3: error: block 3: a time of 4000000001 seconds, expected at most 4 000 000 000");
}

TEST(PcapngBlocks, ThatAreShorterThanTheyTellAreNamed)
{
    Verifies(req::SRS_MON_003);
    const std::string head = PcapngOf({}, kOrder, 6U);
    EXPECT_EQ(RefusalOf(head + PcapngBlock(1U, "abcd", kOrder)),
              "test.log:4: error: block 4: an interface of 4 bytes, expected at least 8, and at most 1000 interfaces");
    EXPECT_EQ(RefusalOf(head + PacketOf(0U, 17U, SocketCanPacket(Frame(0, 0x101U, std::vector<std::uint8_t>(8U))))),
              "test.log:4: error: block 4: a packet of interface 0 with 17 of 17 bytes, expected a whole packet of an "
              "interface that was described");
}

TEST(PcapngInterfaces, AreAThousandAtMost)
{
    Verifies(req::SRS_MON_003);
    std::string bytes = PcapngOf({}, kOrder, 6U); // Has one.
    for (int count = 1; count < 1000; ++count)
    {
        bytes += Described("can1", 227U);
    }
    EXPECT_EQ(RefusalOf(bytes), "");
    EXPECT_EQ(RefusalOf(bytes + Described("can1", 227U)),
              "test.log:1003: error: block 1003: an interface of 16 bytes, expected at least 8, and at most 1000 "
              "interfaces");
}

// Given a capture of Ethernet and CAN, then the frames of another network are refused where it is asked for.
TEST(PcapngInterfaces, OfAnotherNetworkMayNotBeAskedFor)
{
    Verifies(req::SRS_MON_003);
    Verifies(req::SRS_MON_040);
    const std::string bytes = PcapngOf({Frame(0, 0x101U, {})}, kOrder, 6U) + Described("eth0", 1U) +
                              PacketOf(1U, 60U, std::string(60U, 'x')) + PacketOf(1U, 60U, std::string(60U, 'x'));
    EXPECT_EQ(FramesOf(bytes).size(), 1U);
    EXPECT_EQ(FramesOf(bytes, "can0").size(), 1U);
    try
    {
        static_cast<void>(FramesOf(bytes, "eth0"));
        FAIL() << "frames of eth0 were read";
    }
    catch (const cia306::InputError& error)
    {
        EXPECT_STREQ(
            error.what(),
            "test.log:6: error: block 6: link type 1, expected 227 (CAN_SOCKETCAN), 113 or 276 (Linux cooked)");
    }
}

// Given two frames of a link type that does not tell interfaces apart, then the doubt is told once.
TEST(PcapngInterfaces, OfWhichNothingTellsTheBusAreDoubtedOnce)
{
    Verifies(req::SRS_MON_043);
    const std::string packet =
        std::string(14U, '\0') + std::string("\x00\x0C", 2U) + std::string("\x01\x01\0\0\0\0\0\0", 8U);
    CaptureWriter section(kOrder);
    section.Number(0x1A2B3C4DU, 4U);
    section.Number(1U, 4U);
    section.Number(0xFFFFFFFFFFFFFFFFU, 8U);
    const std::string bytes = PcapngBlock(0x0A0D0D0AU, section.text, kOrder) + Described("any0", 113U) +
                              PacketOf(0U, 24U, packet) + PacketOf(0U, 24U, packet);
    const auto source = OpenRecording("test.log", bytes, {});
    LogFrame frame;
    ASSERT_TRUE(source->Next(frame));
    ASSERT_TRUE(source->Next(frame));
    EXPECT_FALSE(source->Next(frame));
    EXPECT_EQ(source->Seen().doubt,
              "link type 113 (SLL) does not tell interfaces apart: what is judged as one bus may be several");
}

/// What is doubted of a candump file behind its last frame, which has this length and first byte.
std::string DoubtOfLog(const std::string& text, const std::uint8_t length, const std::uint8_t first)
{
    const auto source = OpenRecording("test.log", text, {});
    LogFrame frame;
    LogFrame last;
    while (source->Next(frame))
    {
        last = frame;
    }
    EXPECT_EQ(last.length, length) << text;
    EXPECT_EQ(last.data[0], first) << text;
    return source->Seen().doubt;
}

// Given a recording that ends within the data of its last frame, then that frame is read as it stands and the line is
// named; with a line break, of either kind and also before empty lines, nothing is doubted.
TEST(CandumpEnd, WithoutALineBreakIsDoubted)
{
    Verifies(req::SRS_MON_401);
    const std::string whole = "(1.000000) can0 101#0102\n(1.000200) can0 102#FEFD";
    EXPECT_EQ(DoubtOfLog(whole + "\n", 2U, 0xFEU), "");
    EXPECT_EQ(DoubtOfLog(whole + "\r\n", 2U, 0xFEU), "");
    EXPECT_EQ(DoubtOfLog(whole + "\n\n", 2U, 0xFEU), "");
    const std::string told =
        "line 2 has no end; the recording may have been cut there, and its last frame be longer than told";
    EXPECT_EQ(DoubtOfLog(whole, 2U, 0xFEU), told);
    EXPECT_EQ(DoubtOfLog(whole.substr(0U, whole.size() - 2U), 1U, 0xFEU), told);
}
} // namespace
} // namespace counterpoint::monitor
