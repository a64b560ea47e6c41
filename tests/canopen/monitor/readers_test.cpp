// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/monitor/recordings.hpp"
#include "verification/trace/ids/monitor.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <string>

namespace counterpoint::monitor
{
namespace
{
using test::ByteOrder;
using test::CandumpLine;
using test::CaptureWriter;
using test::CookedPcapOf;
using test::Frame;
using test::FramesOf;
using test::PcapngBlock;
using test::PcapngOf;
using test::PcapOf;
using test::RefusalOf;

/// One of each kind.
std::vector<LogFrame> AllKinds()
{
    std::vector<LogFrame> frames{Frame(1000000, 0x101U, {0x12U, 0xFEU}), Frame(1000001, 0x080U, {}),
                                 Frame(1000002, 0x7FFU, {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U})};
    LogFrame remote = Frame(1000003, 0x701U, {});
    remote.is_remote = true;
    remote.length = 1U;
    LogFrame extended = Frame(1000004, 0x1FFFFFFFU, {9U});
    extended.is_extended = true;
    LogFrame error = Frame(1000005, 0x4U, {0U, 4U, 0U, 0U, 0U, 0U, 0U, 0U});
    error.is_error = true;
    LogFrame wide = Frame(1000006, 0x123U, std::vector<std::uint8_t>(12U, 0xA5U));
    wide.is_fd = true;
    frames.insert(frames.end(), {remote, extended, error, wide});
    return frames;
}

void ExpectSame(const std::vector<LogFrame>& read, const std::vector<LogFrame>& written)
{
    ASSERT_EQ(read.size(), written.size());
    for (std::size_t place = 0U; place < read.size(); ++place)
    {
        const LogFrame& left = read[place];
        const LogFrame& right = written[place];
        EXPECT_EQ(left.time, right.time) << place;
        EXPECT_EQ(left.identifier, right.identifier) << place;
        EXPECT_EQ(left.length, right.length) << place;
        EXPECT_EQ(left.is_extended, right.is_extended) << place;
        EXPECT_EQ(left.is_remote, right.is_remote) << place;
        EXPECT_EQ(left.is_fd, right.is_fd) << place;
        EXPECT_EQ(left.is_error, right.is_error) << place;
        EXPECT_EQ(left.data, right.data) << place;
    }
}

TEST(Readers, EveryKindOfFrameIsReadFromEveryFormat)
{
    Verifies(req::SRS_MON_001);
    Verifies(req::SRS_MON_002);
    Verifies(req::SRS_MON_003);
    const std::vector<LogFrame> frames = AllKinds();
    std::string candump;
    for (const LogFrame& frame : frames)
    {
        candump += CandumpLine(frame);
    }
    ExpectSame(FramesOf(candump), frames);
    for (const ByteOrder order : {ByteOrder::kLittle, ByteOrder::kBig})
    {
        ExpectSame(FramesOf(PcapOf(frames, order, false)), frames);
        ExpectSame(FramesOf(PcapOf(frames, order, true)), frames);
        ExpectSame(FramesOf(PcapngOf(frames, order, 6U)), frames);
        ExpectSame(FramesOf(PcapngOf(frames, order, 9U)), frames);
    }
}

// Seconds that are added to each time: 64 bits with sign, in the byte order of the section.
TEST(Readers, TheOffsetOfAnInterfaceIsAddedToItsTimes)
{
    Verifies(req::SRS_MON_003);
    const std::vector<LogFrame> frames = AllKinds(); // From 1 s on.
    for (const ByteOrder order : {ByteOrder::kLittle, ByteOrder::kBig})
    {
        EXPECT_EQ(FramesOf(PcapngOf(frames, order, 6U, 1000))[0U].time, 1001 * kSecond);
        EXPECT_EQ(FramesOf(PcapngOf(frames, order, 9U, -1))[0U].time, 0);
        EXPECT_EQ(FramesOf(PcapngOf(frames, order, 6U, 4000000000))[0U].time, 4000000001 * kSecond);
        // What no time can be is refused
        EXPECT_EQ(RefusalOf(PcapngOf(frames, order, 6U, -2)),
                  "test.log:4: error: block 4: a time of -1 seconds, expected none before 0, with the offset of its "
                  "interface");
        EXPECT_EQ(RefusalOf(PcapngOf(frames, order, 6U, 4000000001)),
                  "test.log:2: error: block 2: a time offset of 4000000001 seconds, expected -4 000 000 000 to "
                  "4 000 000 000");
        EXPECT_NE(RefusalOf(PcapngOf(frames, order, 6U, -4000000001)), "");
    }
}

TEST(Readers, CookedCapturesAreRead)
{
    Verifies(req::SRS_MON_003);
    const std::vector<LogFrame> frames = AllKinds();
    // Identifiers as the machine has them; a packet of IP stands among them
    for (const ByteOrder order : {ByteOrder::kLittle, ByteOrder::kBig})
    {
        ExpectSame(FramesOf(CookedPcapOf(frames, order, false)), frames);
        ExpectSame(FramesOf(CookedPcapOf(frames, order, true)), frames);
    }
    // What is cut is named
    for (const bool is_second : {false, true})
    {
        const std::string whole = CookedPcapOf(frames, ByteOrder::kLittle, is_second);
        for (std::size_t length = 4U; length < whole.size(); ++length)
        {
            const std::string refusal = RefusalOf(whole.substr(0U, length));
            EXPECT_TRUE(refusal.empty() || refusal.find(", expected ") != std::string::npos) << refusal;
        }
    }
    std::string short_head = CookedPcapOf({}, ByteOrder::kLittle, true).substr(0U, 24U);
    short_head += std::string(8U, '\0') + std::string("\x0C\0\0\0\x0C\0\0\0", 8U) + std::string(12U, '\0');
    EXPECT_EQ(RefusalOf(short_head), "test.log:1: error: cooked packet of 12 bytes, expected at least 20");
}

TEST(Readers, FormsOfCandump)
{
    Verifies(req::SRS_MON_002);
    EXPECT_EQ(FramesOf("(1.000002) vcan0 101#12 R\n")[0].time, kSecond + 2 * kMicrosecond);
    EXPECT_EQ(FramesOf("(1.000000002) vcan0 101#12 T\r\n")[0].time, kSecond + 2);
    for (const char code : {'9', 'B', 'F'})
    {
        EXPECT_EQ(FramesOf(std::string("(0.000000) can0 7FF#1122334455667788_") + code + "\n")[0].length, 8U);
    }
    EXPECT_EQ(FramesOf("(0.000000) can0 123#R\n\n(0.000000) can0 123#r8")[1].length, 8U);
    EXPECT_EQ(FramesOf("(0.000000) can0 123##0\n")[0].is_fd, true);
    EXPECT_EQ(FramesOf("").size(), 0U);
    // Frames of another interface are left out
    const std::string two = "(2.000000) a 101#\n(1.000000) b 102#\n(2.000001) a 103#\n";
    EXPECT_EQ(FramesOf(two).size(), 2U);
    EXPECT_EQ(FramesOf(two, "b")[0].identifier, 0x102U);
    EXPECT_EQ(FramesOf(two, "c").size(), 0U);
}

TEST(Readers, AByteOrderMarkIsNoPartOfTheFirstLine)
{
    Verifies(req::SRS_MON_025);
    EXPECT_EQ(FramesOf("\xEF\xBB\xBF(1.000002) can0 101#12\r\n(1.000003) can0 102#ED\n").size(), 2U);
    EXPECT_EQ(RefusalOf("\xEF\xBB\xBF(1.000002) can0 101#1\n"), RefusalOf("(1.000002) can0 101#1\n"));
    EXPECT_NE(RefusalOf("(1.000002) can0 101#1\n"), "");
    // Elsewhere it is none, and half of one neither
    EXPECT_NE(RefusalOf("(1.000002) can0 101#12\n\xEF\xBB\xBF(1.000003) can0 102#ED\n"), "");
    EXPECT_NE(RefusalOf("\xEF\xBB(1.000002) can0 101#12\n"), "");
}

TEST(Readers, WhatCandumpPrintsWithTimesIsRead)
{
    Verifies(req::SRS_MON_002);
    const std::vector<LogFrame> frames = AllKinds();
    const std::string printed = " (0000000001.000000)  can0  101   [2]  12 FE\n"
                                " (0000000001.000001)  can0  080   [0] \n"
                                " (0000000001.000002)  can0  RX - -  7FF   [8]  01 02 03 04 05 06 07 08   '........'\n"
                                " (0000000001.000003)  can0  TX - -  701   [1]  remote request\n"
                                " (0000000001.000004)  can0  1FFFFFFF   [1]  09\n"
                                " (0000000001.000005)  can0  20000004   [8]  00 04 00 00 00 00 00 00   ERRORFRAME\n"
                                " (0000000001.000006)  can0  123  [12]  A5 A5 A5 A5 A5 A5 A5 A5 A5 A5 A5 A5\n";
    ExpectSame(FramesOf(printed), frames);
    for (const char* line :
         {"  can0  101   [2]  01 02", " (1.000000)  can0  101   [3]  01 02", " (1.000000)  can0  101   [1]  01 02",
          " (1.000000)  can0  101   [9]  01 02", " (1.000000)  can0  101  [13]  01 02",
          " (1.000000)  can0  101   [x]  01", " (1.000000)  can0  101", " (1.000000)  can0", " (1.000000) ",
          " (1.000000)  ", " ", " (1.000000)  can0  10   [0]", " (1.000000)  can0  101   [1]  1G",
          " (1.000000)  can0  101   [1]  1", " (1.000000)  can0  101   [1]  01 remote request",
          " (2023-07-19 10:07:14.123456)  can0  101   [1]  01"})
    {
        const std::string refusal = RefusalOf(std::string(line) + "\n");
        EXPECT_EQ(refusal.rfind("test.log:1:", 0U), 0U) << line << ": " << refusal;
        EXPECT_NE(refusal.find(": error: line '"), std::string::npos) << line << ": " << refusal;
    }
    // Times between frames (-td) go back
    EXPECT_NE(RefusalOf(" (000.025000)  can0  101   [1]  01\n (000.000200)  can0  102   [1]  FE\n"), "");
}

TEST(Readers, AMalformedLineIsNamed)
{
    Verifies(req::SRS_MON_002);
    const std::string good = "(1.000000) can0 101#12\n";
    EXPECT_EQ(RefusalOf(good + "(1.000000) can0 101#1\n"),
              "test.log:2:21: error: line '(1.000000) can0 101#1', expected 0 to 8 bytes of two hexadecimal digits");
    EXPECT_EQ(
        RefusalOf(good + good + "(0.999999) can0 101#12\n"),
        "test.log:3:1: error: line '(0.999999) can0 101#12', expected a time that is not before that of the frame "
        "before");
    for (const char* line : {"x",
                             "(",
                             "()",
                             "(1)",
                             "(1.)",
                             "(1.00000) can0 101#",
                             "(1.0000000) can0 101#",
                             "(.000000) can0 101#",
                             "(99999999999.000000) can0 101#",
                             "(9999999999.000000) can0 101#",
                             "1.000000 can0 101#",
                             "(1.000000)can0 101#",
                             "(1.000000) can0",
                             "(1.000000)  101#",
                             "(1.000000) can0  101#",
                             "(1.000000) can0 10#",
                             "(1.000000) can0 0101#",
                             "(1.000000) can0 80000101#",
                             "(1.000000) can0 801#",
                             "(1.000000) can0 10G#",
                             "(1.000000) can0 101",
                             "(1.000000) can0 101#G0",
                             "(1.000000) can0 101#112233445566778899",
                             "(1.000000) can0 101#R9",
                             "(1.000000) can0 101#R11",
                             "(1.000000) can0 101##",
                             "(1.000000) can0 101##X",
                             "(1.000000) can0 101##1112233445566778899",
                             "(1.000000) can0 101#11 X",
                             "(1.000000) can0 101#11 R ",
                             "(1.000000) can0 101#1122334455667788_8",
                             "(1.000000) can0 101#1122334455667788_G",
                             "(1.000000) can0 101#11223344556677_9",
                             "(-1.000000) can0 101#",
                             "(1.00000a) can0 101#"})
    {
        const std::string refusal = RefusalOf(good + line + "\n" + good);
        EXPECT_EQ(refusal.rfind("test.log:2:", 0U), 0U) << line << ": " << refusal;
        EXPECT_NE(refusal.find(": error: line '"), std::string::npos) << line << ": " << refusal;
        EXPECT_NE(refusal.find("', expected "), std::string::npos) << line;
    }
}

TEST(Readers, ACaptureThatIsCutIsNamed)
{
    Verifies(req::SRS_MON_003);
    const std::vector<LogFrame> frames = AllKinds();
    for (const std::string& whole : {PcapOf(frames, ByteOrder::kLittle, false), PcapngOf(frames, ByteOrder::kBig, 6U)})
    {
        std::size_t accepted = 0U;
        for (std::size_t length = 4U; length < whole.size(); ++length)
        {
            const std::string refusal = RefusalOf(whole.substr(0U, length));
            accepted += refusal.empty() ? 1U : 0U;
            EXPECT_TRUE(refusal.empty() || refusal.find(", expected ") != std::string::npos) << refusal;
        }
        EXPECT_LE(accepted, 10U); // Between two packets nothing is missing.
    }
}

TEST(Readers, ACaptureThatContradictsItselfIsNamed)
{
    Verifies(req::SRS_MON_003);
    const std::vector<LogFrame> frames = AllKinds();
    std::string other_link = PcapOf(frames, ByteOrder::kLittle, false);
    other_link[20] = 1;
    EXPECT_EQ(RefusalOf(other_link),
              "test.log: error: link type 1, expected 227 (CAN_SOCKETCAN), 113 or 276 (Linux cooked)");
    std::string version = PcapOf(frames, ByteOrder::kLittle, false);
    version[4] = 3;
    EXPECT_EQ(RefusalOf(version), "test.log: error: pcap version 3, expected 2");
    std::string long_frame = PcapOf({frames[0]}, ByteOrder::kLittle, false);
    long_frame[44] = 8; // Length of the frame, of which two bytes are there.
    EXPECT_EQ(RefusalOf(long_frame),
              "test.log:1: error: frame of 8 bytes in a packet of 10 bytes, expected 8 bytes and the "
              "data of the frame, 8 at most");
    EXPECT_EQ(RefusalOf(PcapOf({frames[1], frames[0]}, ByteOrder::kBig, false)),
              "test.log:2: error: packet 2 is before the one before it, expected times that do not go back");
    const std::string head = PcapngOf({}, ByteOrder::kLittle, 6U);
    for (const std::uint32_t type : {2U, 3U}) // Obsolete and simple
    {
        EXPECT_EQ(RefusalOf(head + PcapngBlock(type, std::string(20U, 'x'), ByteOrder::kLittle)),
                  "test.log:4: error: block 4: a packet of type " + std::to_string(type) +
                      ", expected enhanced packets, which have a time");
    }
    EXPECT_NE(
        RefusalOf(head + PcapngBlock(6U, std::string(16U, '\0'), ByteOrder::kLittle)).find("a packet of 16 bytes"),
        std::string::npos);
    std::string interface(20U, '\0');
    interface[0] = 1;
    EXPECT_NE(RefusalOf(head + PcapngBlock(6U, interface, ByteOrder::kLittle)).find("a packet of interface 1 with"),
              std::string::npos);
    EXPECT_NE(RefusalOf("\x0A\x0D\x0D\x0A" + std::string(40U, 'x')).find("a section without byte order"),
              std::string::npos);
}
// Given a capture of an Ethernet interface and one of CAN, the packet of Ethernet first, then the frames of CAN are
// read.
TEST(Readers, ACaptureOfOtherNetworksBesidesGivesItsCanFrames)
{
    Verifies(req::SRS_MON_003);
    const std::vector<LogFrame> frames = AllKinds();
    for (const ByteOrder order : {ByteOrder::kLittle, ByteOrder::kBig})
    {
        const std::string head = PcapngOf({}, order, 9U);
        test::CaptureWriter ethernet(order);
        ethernet.Number(1U, 2U);
        ethernet.Number(0U, 6U);
        test::CaptureWriter packet(order);
        packet.Number(1U, 4U);
        packet.Number(0U, 8U);
        packet.Number(60U, 4U);
        packet.Number(60U, 4U);
        const std::string other =
            PcapngBlock(1U, ethernet.text, order) + PcapngBlock(6U, packet.text + std::string(60U, 'x'), order);
        ExpectSame(FramesOf(head + other + PcapngOf(frames, order, 9U).substr(head.size())), frames);
    }
}

TEST(Readers, WhatIsCompressedIsNamed)
{
    Verifies(req::SRS_MON_001);
    EXPECT_EQ(RefusalOf("\x1F\x8B\x08"),
              "test.log: error: it is compressed (gzip), expected the recording itself, unpacked");
    EXPECT_EQ(RefusalOf("\xFD\x37zXZ"),
              "test.log: error: it is compressed (xz), expected the recording itself, unpacked");
    EXPECT_EQ(RefusalOf("\x28\xB5\x2F\xFD"),
              "test.log: error: it is compressed (zstd), expected the recording itself, unpacked");
}

TEST(Readers, AlteredRecordingsGiveFramesOrOneError)
{
    Verifies(req::SRS_MON_014);
    // Given recordings of each format, with up to four bytes changed by chance, always the same
    std::string candump;
    for (const LogFrame& frame : AllKinds())
    {
        candump += CandumpLine(frame);
    }
    const std::vector<std::string> wholes{candump, PcapOf(AllKinds(), ByteOrder::kBig, true),
                                          PcapngOf(AllKinds(), ByteOrder::kLittle, 9U)};
    std::uint64_t state = 1U;
    const auto below = [&state](const std::size_t count)
    {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return static_cast<std::size_t>((state >> 33U) % count);
    };
    std::size_t refused = 0U;
    for (int round = 0; round < 30000; ++round)
    {
        std::string bytes = wholes[below(wholes.size())];
        for (std::size_t changes = 1U + below(4U); changes != 0U; --changes)
        {
            bytes[below(bytes.size())] = static_cast<char>(below(256U));
        }
        // When they are read, then there are frames of lengths that exist, or an error in one line
        const std::string refusal = RefusalOf(bytes);
        EXPECT_EQ(refusal.find('\n'), std::string::npos) << refusal;
        refused += refusal.empty() ? 0U : 1U;
    }
    EXPECT_GT(refused, 10000U);
    EXPECT_LT(refused, 29000U);
}
} // namespace
} // namespace counterpoint::monitor
