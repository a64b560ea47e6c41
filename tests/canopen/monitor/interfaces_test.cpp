// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/monitor/recordings.hpp"
#include "verification/trace/ids/monitor.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace counterpoint::monitor
{
namespace
{
using test::ByteOrder;
using test::CaptureWriter;
using test::Frame;
using test::PcapngBlock;
using test::RefusalOf;
using test::SocketCanPacket;

constexpr ByteOrder kOrder = ByteOrder::kLittle;
constexpr std::uint32_t kSocketCan = 227U;
constexpr std::uint32_t kCooked = 113U;
constexpr std::uint32_t kCooked2 = 276U;

std::string Section()
{
    CaptureWriter body(kOrder);
    body.Number(0x1A2B3C4DU, 4U);
    body.Number(1U, 2U);
    body.Number(0U, 2U);
    body.Number(0xFFFFFFFFFFFFFFFFU, 8U);
    return PcapngBlock(0x0A0D0D0AU, body.text, kOrder);
}

/// A description; without the option of the name where that is empty.
std::string Described(const std::string& name, const std::uint8_t resolution = 6U,
                      const std::uint32_t link_type = kSocketCan)
{
    CaptureWriter body(kOrder);
    body.Number(link_type, 2U);
    body.Number(0U, 6U);
    if (!name.empty())
    {
        body.Number(2U, 2U);
        body.Number(name.size(), 2U);
        body.text += name + std::string((4U - name.size() % 4U) % 4U, '\0');
    }
    body.Number(9U, 2U);
    body.Number(1U, 2U);
    body.Number(resolution, 4U);
    body.Number(0U, 4U);
    return PcapngBlock(1U, body.text, kOrder);
}

/// What Linux puts in front in a capture of all interfaces; the identifier is that of the machine.
std::string CookedPacket(const std::uint32_t link_type, const std::uint32_t interface, const std::uint32_t identifier)
{
    CaptureWriter head(ByteOrder::kBig);
    if (link_type == kCooked2)
    {
        head.Number(0x000CU, 2U);
        head.Number(0U, 2U);
        head.Number(interface, 4U);
        head.Number(0U, 8U);
        head.Number(0U, 4U);
    }
    else
    {
        head.Number(0U, 8U);
        head.Number(0U, 6U);
        head.Number(0x000CU, 2U);
    }
    CaptureWriter frame(kOrder);
    frame.Number(identifier, 4U);
    frame.Number(0U, 4U);
    return head.text + frame.text;
}

std::string PacketOf(const std::uint32_t number, const std::uint64_t ticks, const std::string& packet)
{
    CaptureWriter body(kOrder);
    body.Number(number, 4U);
    body.Number(ticks >> 32U, 4U);
    body.Number(ticks & 0xFFFFFFFFU, 4U);
    body.Number(packet.size(), 4U);
    body.Number(packet.size(), 4U);
    return PcapngBlock(6U, body.text + packet, kOrder);
}

std::string Packet(const std::uint32_t number, const std::uint64_t ticks, const std::uint32_t identifier)
{
    return PacketOf(number, ticks, SocketCanPacket(Frame(0, identifier, {})));
}

std::string PcapHead(const std::uint32_t link_word)
{
    CaptureWriter head(kOrder);
    head.Number(0xA1B2C3D4U, 4U);
    head.Number(2U, 2U);
    head.Number(4U, 2U);
    head.Number(0U, 8U);
    head.Number(262144U, 4U);
    head.Number(link_word, 4U);
    return head.text;
}

std::string PcapPacket(const std::uint32_t us, const std::string& packet)
{
    CaptureWriter head(kOrder);
    head.Number(0U, 4U);
    head.Number(us, 4U);
    head.Number(packet.size(), 4U);
    head.Number(packet.size(), 4U);
    return head.text + packet;
}

/// "100:101 102:103 others 1 last 500 of can0": time in microseconds and identifier of each frame, and what was not
/// given.
std::string Read(const std::string& bytes, const std::string& interface = "")
{
    const auto source = OpenRecording("test.log", bytes, {interface});
    std::string text;
    LogFrame frame;
    while (source->Next(frame))
    {
        text += std::to_string(frame.time / kMicrosecond) + ":" + cia306::Hex(frame.identifier, 3).substr(2U) + " ";
    }
    const Origin origin = source->Seen();
    return text + "others " + std::to_string(origin.other_frames) + " last " +
           std::to_string(origin.other_last / kMicrosecond) + " of " + origin.interface +
           (origin.doubt.empty() ? "" : "; " + origin.doubt);
}

// Given that the number of an interface is another one in the second section, then its frames go on by its name.
TEST(Interfaces, OneIsChosenByItsNameOverAllSections)
{
    Verifies(req::SRS_MON_040);
    Verifies(req::SRS_MON_041);
    const std::string moved = Section() + Described("can0") + Packet(0U, 100U, 0x101U) + Section() + Described("can1") +
                              Described("can0") + Packet(0U, 200U, 0x111U) + Packet(1U, 300U, 0x102U);
    EXPECT_EQ(Read(moved), "100:101 300:102 others 1 last 200 of can0");
    EXPECT_EQ(Read(moved, "can0"), "100:101 300:102 others 1 last 200 of can0");
    EXPECT_EQ(Read(moved, "can1"), "200:111 others 2 last 300 of can1");
    // It is not in the second section: those of another one do not take its place
    const std::string gone = Section() + Described("can0") + Packet(0U, 100U, 0x101U) + Section() + Described("can1") +
                             Packet(0U, 200U, 0x111U);
    EXPECT_EQ(Read(gone), "100:101 others 1 last 200 of can0");
    EXPECT_EQ(Read(gone, "can1"), "200:111 others 1 last 100 of can1");
    // Nor is a section of another network, which has no frame of CAN
    const std::string other_network = Section() + Described("can0") + Packet(0U, 100U, 0x101U) + Section() +
                                      Described("eth0", 6U, 1U) + PacketOf(0U, 200U, std::string(60U, 'x'));
    EXPECT_EQ(Read(other_network), "100:101 others 0 last 0 of can0");
}

// Given two descriptions of one name in a section, with another resolution, then the frames of both are of it.
TEST(Interfaces, AllDescriptionsOfANameAreOne)
{
    Verifies(req::SRS_MON_040);
    const std::string twice =
        Section() + Described("can0") + Described("can0", 9U) + Packet(0U, 100U, 0x101U) + Packet(1U, 200000U, 0x102U);
    EXPECT_EQ(Read(twice), "100:101 200:102 others 0 last 0 of can0");
    EXPECT_EQ(Read(twice, "can0"), "100:101 200:102 others 0 last 0 of can0");
    EXPECT_EQ(RefusalOf(Section() + Described("can0") + Described("can0", 9U) + Packet(0U, 300U, 0x101U) +
                        Packet(1U, 200000U, 0x102U)),
              "test.log:5: error: block 5: its time is before the one before it, expected times that do not go back");
}

// Given interfaces without a name, then each is told by its number, and none of another section is taken for it.
TEST(Interfaces, WithoutANameTheyCountByTheirNumberInTheirSection)
{
    Verifies(req::SRS_MON_040);
    const std::string nameless = Section() + Described("") + Described("") + Packet(0U, 100U, 0x101U) +
                                 Packet(1U, 200U, 0x111U) + Section() + Described("") + Packet(0U, 300U, 0x102U);
    EXPECT_EQ(Read(nameless), "100:101 others 2 last 300 of interface 0 of section 1");
    EXPECT_EQ(Read(nameless, "0"), "100:101 others 2 last 300 of interface 0 of section 1");
    EXPECT_EQ(Read(nameless, "1"), "200:111 others 2 last 300 of interface 1 of section 1");
    EXPECT_EQ(Read(nameless, "2"), "others 3 last 300 of ");
}

// The first frame decides, not the first packet: one of IP on an interface of all is none.
TEST(Interfaces, InACookedCaptureEachIndexIsOne)
{
    Verifies(req::SRS_MON_040);
    Verifies(req::SRS_MON_041);
    std::string internet = CookedPacket(kCooked2, 9U, 0x45U);
    internet[0] = 0x08;
    internet[1] = 0x00;
    const std::string pcap =
        PcapHead(kCooked2) + PcapPacket(50U, internet) + PcapPacket(100U, CookedPacket(kCooked2, 3U, 0x101U)) +
        PcapPacket(200U, CookedPacket(kCooked2, 4U, 0x111U)) + PcapPacket(300U, CookedPacket(kCooked2, 3U, 0x102U)) +
        PcapPacket(400U, CookedPacket(kCooked2, 259U, 0x103U));
    EXPECT_EQ(Read(pcap), "100:101 300:102 others 2 last 400 of 3");
    EXPECT_EQ(Read(pcap, "3"), "100:101 300:102 others 2 last 400 of 3");
    EXPECT_EQ(Read(pcap, "4"), "200:111 others 3 last 400 of 4");
    EXPECT_EQ(Read(pcap, "259"), "400:103 others 3 last 300 of 259");
    EXPECT_EQ(Read(pcap, "9"), "others 4 last 400 of ");
    // The same in a description of pcapng, behind its name
    const std::string pcapng = Section() + Described("any", 6U, kCooked2) + Described("can0") +
                               PacketOf(0U, 100U, CookedPacket(kCooked2, 3U, 0x101U)) +
                               PacketOf(0U, 200U, CookedPacket(kCooked2, 4U, 0x111U)) + Packet(1U, 300U, 0x102U);
    EXPECT_EQ(Read(pcapng), "100:101 others 2 last 300 of any/3");
    EXPECT_EQ(Read(pcapng, "any"), "100:101 others 2 last 300 of any/3");
    EXPECT_EQ(Read(pcapng, "any/4"), "200:111 others 2 last 300 of any/4");
    EXPECT_EQ(Read(pcapng, "can0"), "300:102 others 2 last 200 of can0");
}

TEST(Interfaces, FramesOfOthersInACandumpAreCounted)
{
    Verifies(req::SRS_MON_041);
    const std::string two = "(2.000000) a 101#\n(1.000000) b 102#\n(2.000001) a 103#\n";
    EXPECT_EQ(Read(two), "2000000:101 2000001:103 others 1 last 1000000 of a");
    EXPECT_EQ(Read(two, "b"), "1000000:102 others 2 last 2000001 of b");
    EXPECT_EQ(Read("(2.000000) a 101#\n"), "2000000:101 others 0 last 0 of a");
}

TEST(Interfaces, WhereNothingTellsThemApartItIsTold)
{
    Verifies(req::SRS_MON_043);
    const std::string doubt =
        "; link type 113 (SLL) does not tell interfaces apart: what is judged as one bus may be several";
    EXPECT_EQ(Read(PcapHead(kCooked) + PcapPacket(100U, CookedPacket(kCooked, 0U, 0x101U))),
              "100:101 others 0 last 0 of " + doubt);
    const std::string cooked = Section() + Described("any", 6U, kCooked) + Described("can0") +
                               PacketOf(0U, 100U, CookedPacket(kCooked, 0U, 0x101U)) + Packet(1U, 200U, 0x102U);
    EXPECT_EQ(Read(cooked), "100:101 others 1 last 200 of any" + doubt);
    // A doubt of frames that are not judged is none, nor is there one of a capture of one interface
    EXPECT_EQ(Read(cooked, "can0"), "200:102 others 1 last 100 of can0");
    EXPECT_EQ(Read(PcapHead(kSocketCan) + PcapPacket(100U, SocketCanPacket(Frame(0, 0x101U, {})))),
              "100:101 others 0 last 0 of ");
}

TEST(Interfaces, ANameThatWouldBeIgnoredIsRefused)
{
    Verifies(req::SRS_MON_042);
    const auto refusal = [](const std::uint32_t link_type, const std::string& interface)
    {
        try
        {
            static_cast<void>(Read(PcapHead(link_type), interface));
        }
        catch (const cia306::InputError& error)
        {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(
        refusal(kSocketCan, "nosuch"),
        "test.log: error: --interface 'nosuch' with pcap of link type 227, which tells of no frame its interface, "
        "expected no --interface, or a recording of candump, pcapng or link type 276 (SLL2)");
    EXPECT_EQ(refusal(kCooked, "3"),
              "test.log: error: --interface '3' with pcap of link type 113, which tells of no frame its interface, "
              "expected no --interface, or a recording of candump, pcapng or link type 276 (SLL2)");
    EXPECT_EQ(refusal(kCooked2, "can0"),
              "test.log: error: --interface 'can0' with pcap of link type 276 (SLL2), which has no names, expected the "
              "index of an interface, which is a number");
    EXPECT_EQ(refusal(kCooked2, "3"), "");
    EXPECT_EQ(refusal(kSocketCan, ""), "");
}

// Given a file that tells of a check sequence of two bytes behind each packet, then its link type is the one below.
TEST(Interfaces, ACheckSequenceIsNoPartOfThePacket)
{
    Verifies(req::SRS_MON_044);
    const std::string full = SocketCanPacket(Frame(0, 0x101U, {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U}));
    EXPECT_EQ(Read(PcapHead(0x140000E3U) + PcapPacket(100U, full + "cc")), "100:101 others 0 last 0 of ");
    EXPECT_EQ(Read(PcapHead(0x240000E3U) + PcapPacket(100U, full + "cccc")), "100:101 others 0 last 0 of ");
    // A length without the mark that there is one means nothing, nor does the bit that is reserved
    EXPECT_EQ(Read(PcapHead(0x100000E3U) + PcapPacket(100U, full)), "100:101 others 0 last 0 of ");
    EXPECT_EQ(Read(PcapHead(0x080000E3U) + PcapPacket(100U, full)), "100:101 others 0 last 0 of ");
    EXPECT_EQ(
        RefusalOf(PcapHead(0x140000E3U) + PcapPacket(100U, "c")),
        "test.log:1: error: packet 1 of 1 bytes, expected a check sequence of 2 bytes in it, which the file tells "
        "of");
    EXPECT_EQ(RefusalOf(PcapHead(0x14000001U)),
              "test.log: error: link type 1, expected 227 (CAN_SOCKETCAN), 113 or 276 (Linux cooked)");
}
} // namespace
} // namespace counterpoint::monitor
