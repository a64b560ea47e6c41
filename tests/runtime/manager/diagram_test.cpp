// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Rows of the sequence diagram: which frames and events are one, and what it says.
#include "runtime/manager/report/diagram.hpp"
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

#include <regex>

namespace counterpoint::tools
{
namespace
{
using test::Lines;

/// A diagram of frames and events that the test makes.
class ManagerDiagramTest : public testing::Test
{
  protected:
    static CanFrame FrameOf(const std::uint32_t identifier, const std::vector<std::uint8_t>& data)
    {
        CanFrame frame{};
        frame.identifier = identifier;
        frame.kind = FrameKind::kData;
        frame.length_bytes = static_cast<std::uint8_t>(data.size());
        std::copy(data.begin(), data.end(), &frame.data[0]);
        return frame;
    }
    void Sent(const std::uint32_t identifier, const std::vector<std::uint8_t>& data)
    {
        now_us += 10U;
        diagram.OnFrame(FrameOf(identifier, data), true, now_us);
    }
    void Heard(const std::uint32_t identifier, const std::vector<std::uint8_t>& data)
    {
        now_us += 10U;
        diagram.OnFrame(FrameOf(identifier, data), false, now_us);
    }
    void Told(const std::string& kind, const std::string& text, const std::string& word = "")
    {
        diagram.OnEvent({now_us, 5U, kind, text, {}, word});
    }
    [[nodiscard]] Lines Labels() const
    {
        Lines labels;
        for (const runtime::DiagramRow& row : diagram.Rows())
        {
            labels.push_back(row.label + (row.is_bad ? " !" : ""));
        }
        return labels;
    }

    runtime::ManagerDiagram diagram;
    std::uint64_t now_us{0U};
};

using ManagerPageTest = test::ManagerRig;

TEST_F(ManagerDiagramTest, FramesThatAreNoPartOfABootUpAreNoRows)
{
    Verifies(req::SRS_MGR_008);
    const std::vector<std::uint8_t> read{0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U};
    CanFrame remote = FrameOf(0x705U, {});
    remote.kind = FrameKind::kRemote;
    diagram.OnFrame(remote, true, 1U);
    Heard(0x605U, read); // Somebody else asks,
    Sent(0x585U, read);  // or is answered by this manager.
    Sent(0x605U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U});
    Heard(0x585U, {0x43U, 0x00U, 0x10U, 0U, 0U, 0U, 0U});
    Heard(0x705U, {0x05U});
    Heard(0x705U, {0x00U, 0x00U});
    Sent(0x77FU, {0x00U});
    Heard(0x080U, {0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}); // Of no node.
    Heard(0x085U, {0x10U, 0x81U, 0U, 0U, 0U, 0U, 0U});
    Sent(0x0FFU, {0x10U, 0x81U, 0U, 0U, 0U, 0U, 0U, 0U});
    Heard(0x185U, {0x01U});
    EXPECT_EQ(Labels(), Lines{});
    // As they have to be, they are
    Sent(0x605U, read);
    Heard(0x705U, {0x00U});
    Heard(0x085U, {0x10U, 0x81U, 0U, 0U, 0U, 0U, 0U, 0U});
    EXPECT_EQ(Labels(), (Lines{"read 0x1000:00: given up at boot-up", "boot-up", "emergency 0x8110 !"}));
    EXPECT_FALSE(diagram.Rows()[0].is_request);
}

TEST_F(ManagerDiagramTest, ATransferIsOneRowWithItsValue)
{
    Verifies(req::SRS_MGR_008);
    // Read in four bytes, in one, in four of which the number is not said, in segments
    for (const std::uint8_t command :
         {std::uint8_t{0x43U}, std::uint8_t{0x4FU}, std::uint8_t{0x42U}, std::uint8_t{0x41U}})
    {
        Sent(0x605U, {0x40U, 0x18U, 0x10U, 1U, 0U, 0U, 0U, 0U});
        Heard(0x585U, {command, 0x18U, 0x10U, 1U, 0x78U, 0x56U, 0x34U, 0x12U});
    }
    // Segments belong to the transfer before, and a further answer to nothing
    Sent(0x605U, {0x60U, 0U, 0U, 0U, 0U, 0U, 0U, 0U});
    Heard(0x585U, {0x01U, 0x41U, 0U, 0U, 0U, 0U, 0U, 0U});
    // Written in two bytes, and refused
    Sent(0x605U, {0x2BU, 0x17U, 0x10U, 0U, 0xF4U, 0x01U, 0U, 0U});
    Heard(0x585U, {0x60U, 0x17U, 0x10U, 0U, 0U, 0U, 0U, 0U});
    Sent(0x605U, {0x21U, 0x22U, 0x1FU, 5U, 9U, 0U, 0U, 0U});
    Heard(0x585U, {0x80U, 0x22U, 0x1FU, 5U, 0x00U, 0x00U, 0x02U, 0x06U});
    // Given up by the manager itself: what comes then is no answer
    Sent(0x605U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
    Sent(0x605U, {0x80U, 0x00U, 0x10U, 0U, 0x00U, 0x00U, 0x04U, 0x05U});
    Heard(0x585U, {0x43U, 0x00U, 0x10U, 0U, 1U, 0U, 0U, 0U});
    Heard(0x705U, {0x00U});
    EXPECT_EQ(Labels(), (Lines{"read 0x1018:01: 0x12345678", "read 0x1018:01: 0x78", "read 0x1018:01: 0x12345678",
                               "read 0x1018:01: ...", "write 0x1017:00 = 0x1F4: done",
                               "write 0x1F22:05 = ...: abort 0x06020000 !", "read 0x1000:00",
                               "abort 0x1000:00 0x05040000 (no answer) !", "boot-up"}));
    EXPECT_EQ(diagram.Rows()[0].at_us, 10U);
    EXPECT_EQ(diagram.Rows()[0].until_us, 20U);
    EXPECT_EQ(diagram.Rows()[6].until_us, 0U);
    EXPECT_TRUE(diagram.Rows()[6].is_request);
}

TEST_F(ManagerDiagramTest, BehindThreeThousandRowsTheOthersAreCounted)
{
    Verifies(req::SRS_MGR_008);
    for (int row = 0; row < 3000; ++row)
    {
        Told("nmt", "NMT stop");
    }
    EXPECT_EQ(diagram.LeftOut(), 0U);
    // A request without room has no row for its answer, and none that is given up
    Sent(0x605U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
    Heard(0x585U, {0x43U, 0x00U, 0x10U, 0U, 1U, 0U, 0U, 0U});
    Heard(0x705U, {0x00U});
    EXPECT_EQ(diagram.Rows().size(), 3000U);
    EXPECT_EQ(diagram.LeftOut(), 2U);
    EXPECT_EQ(diagram.Rows().back().label, "NMT stop");
}

TEST_F(ManagerDiagramTest, WhatIsWrongIsMarkedAsThat)
{
    Verifies(req::SRS_MGR_008);
    Told("status", "");
    Told("boot_up", "boot up");
    Told("emergency", "emergency 0x8110");
    Told("pdo", "TxPDO 1: 01");
    EXPECT_EQ(Labels(), Lines{});
    Told("nmt", "NMT start");
    Told("status", "started", "L");
    Told("status", "L: was OPERATIONAL already", "L");
    Told("status", "C: device type differs", "C");
    Told("status", "8: starts up");
    Told("gate", "safety configuration verified", "open");
    Told("gate", "safety configuration refused: 0x1301:02 is 0x19", "differs");
    Told("heartbeat_lost", "heartbeat lost");
    Told("guard_lost", "guard lost");
    Told("duplicate", "suspected: two devices with this node-ID");
    Told("bus", "bus down");
    EXPECT_EQ(Labels(),
              (Lines{"NMT start", "started", "L: was OPERATIONAL already", "C: device type differs !", "8: starts up",
                     "safety configuration verified", "safety configuration refused: 0x1301:02 is 0x19 !",
                     "heartbeat lost !", "guard lost !", "suspected: two devices with this node-ID !", "bus down"}));
    EXPECT_TRUE(diagram.Rows()[0].is_from_manager);
    EXPECT_FALSE(diagram.Rows()[0].is_mark);
    EXPECT_TRUE(diagram.Rows()[1].is_mark);
}

TEST_F(ManagerPageTest, RequestsWithoutAnswerAndRowsThatAreLeftOutAreOnThePage)
{
    Verifies(req::SRS_MGR_008);
    Verifies(req::SRS_MGR_139);
    // Given a network with a name, a slave whose name has two bytes a letter, and seven others that say nothing
    std::string net_text = "name: <Plant>\nmanager: {node: 127}\nslaves:\n  - {node: 6, device_type: 0x191, name: ";
    for (int letter = 0; letter < 20; ++letter)
    {
        net_text += "\xC3\xA4";
    }
    net_text += "}\n";
    net_text += "  - {node: 7, device_type: 0x191}\n";
    for (int node = 8; node < 14; ++node)
    {
        net_text += "  - {node: " + std::to_string(node) + ", boot: false}\n";
    }
    Make(net_text);
    Run(2U);
    Hear(0x706U, {0U});
    Run(4U);
    Hear(0x586U, {0x43U, 0x00U, 0x10U, 0U, 0x91U, 0x01U, 0U, 0U});
    Hear(0x707U, {0U});
    Run(2000U);
    std::string page = runtime::DiagramPage(*station);
    EXPECT_NE(page.find("<title>Boot-up of &lt;Plant&gt;</title>"), std::string::npos);
    // An answer is told with its time, silence as that
    EXPECT_NE(page.find(">read 0x1000:00: 0x191 (4000 us)</text>"), std::string::npos) << page;
    EXPECT_NE(page.find(">read 0x1000:00: no answer</text>"), std::string::npos);
    // What is longer than the way to the lane of node 7 begins at the manager
    const std::regex abort("x=\"182\" y=\"[0-9]+\">abort 0x1000:00 0x05040000 \\(no answer\\)</text>");
    EXPECT_TRUE(std::regex_search(page, abort)) << page;
    EXPECT_EQ(page.find("later rows are left out"), std::string::npos);
    // Of 17 bytes of a narrow lane the name has 16: eight letters, none of them cut
    std::string letters;
    for (int letter = 0; letter < 8; ++letter)
    {
        letters += "\xC3\xA4";
    }
    EXPECT_NE(page.find(">" + letters + "</text>"), std::string::npos);
    // When more is told than there is room for, then the page says so
    for (int row = 0; row < 3100; ++row)
    {
        station->Tell("note", "note", {}, now_us);
    }
    page = runtime::DiagramPage(*station);
    EXPECT_NE(page.find(" later rows are left out."), std::string::npos);
}

// No reader lets such a name through, a plan of a program may have it.
TEST(ManagerPageOfPlanTest, ANameOfNoLettersHasNone)
{
    Verifies(req::SRS_MGR_139);
    network_plan::NetworkPlan plan;
    plan.file = "plan";
    plan.manager.node = std::uint8_t{127U};
    network_plan::SlavePlan slave;
    slave.node = 5U;
    slave.name = std::string(60U, '\x80');
    plan.slaves.push_back(slave);
    network_plan::LoadedNetwork net(plan);
    runtime::ManagerStation station(net, [](const CanFrame&) { return true; }, [](const runtime::ManagerEvent&) {});
    station.Begin(0U);
    const std::string page = runtime::DiagramPage(station);
    EXPECT_NE(page.find(">5</text>"), std::string::npos);
    EXPECT_NE(page.find("class=\"soft\"></text>"), std::string::npos) << page;
}
} // namespace
} // namespace counterpoint::tools
