// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What table, page and JSON show of each slave, which of them is good, and what an order reaches.
#include "runtime/manager/report/diagram.hpp"
#include "runtime/manager/report/status.hpp"
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

#include <regex>

namespace counterpoint::tools
{
namespace
{
using test::Lines;

/// The answer to a question about 1000h.
std::vector<std::uint8_t> DeviceType(const std::uint16_t type)
{
    return {0x43U, 0x00U, 0x10U, 0x00U, static_cast<std::uint8_t>(type & 0xFFU), static_cast<std::uint8_t>(type >> 8U),
            0x00U, 0x00U};
}

class ManagerShownTest : public test::ManagerRig
{
  protected:
    [[nodiscard]] std::string Page() const
    {
        return runtime::DiagramPage(*station);
    }
    [[nodiscard]] nlohmann::ordered_json Slave(const std::size_t place) const
    {
        return runtime::StatusJson(*station, now_us)["slaves"][place];
    }
    /// The arrows of the page with this text: where each begins and ends, and its line; as "170 450 y".
    [[nodiscard]] static Lines Arrows(const std::string& page, const std::string& label)
    {
        const std::regex arrow("<line class=\"(?:bad)?arrow\" marker-end[^>]* x1=\"([0-9]+)\" y1=\"([0-9]+)\" "
                               "x2=\"([0-9]+)\" y2=\"[0-9]+\"/><text[^>]*>" +
                               label);
        Lines found;
        for (auto each = std::sregex_iterator(page.begin(), page.end(), arrow); each != std::sregex_iterator(); ++each)
        {
            found.push_back((*each)[1].str() + " " + (*each)[3].str() + " " + (*each)[2].str());
        }
        return found;
    }
};

TEST_F(ManagerShownTest, EachSlaveHasItsRowInTableAndJson)
{
    Verifies(req::SRS_MGR_005);
    // Given another device than the expected one that told two emergencies, 3 ms after its last heartbeat
    Make("manager: {node: 127}\nslaves: [{node: 6, name: Pump, device_type: 0x191}, {node: 5, boot: false}]\n");
    Run(2U);
    Hear(0x706U, {0U});
    Answer(6U, DeviceType(0x192U), 20);
    Hear(0x86U, {0x10U, 0x81U, 0x11U, 0U, 0U, 0U, 0U, 0U});
    Hear(0x86U, {0x30U, 0x81U, 0x11U, 0U, 0U, 0U, 0U, 0U});
    Hear(0x706U, {0x7FU});
    Run(3U);
    const std::string table = runtime::StatusTable(*station, now_us);
    EXPECT_NE(table.find("\nnode  name                  state            result  step                heartbeat   "
                         "emergency     safety    finding\n"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("\n6     Pump                  pre-operational  C       device type         3 ms        "
                         "0x8130 (2)              device type differs: 0x1000:00 is 0x192, expected 0x191\n"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("\n5     node 5                unknown                  reset               -\n"),
              std::string::npos)
        << table;
    EXPECT_LT(table.find("\n5   "), table.find("\n6   "));
    const nlohmann::ordered_json pump = Slave(1U);
    EXPECT_EQ(pump["node"], 6);
    EXPECT_EQ(pump["name"], "Pump");
    EXPECT_EQ(pump["state"], "pre-operational");
    EXPECT_EQ(pump["letter"], "C");
    EXPECT_EQ(pump["step"], "device type");
    EXPECT_EQ(pump["heartbeat_age_ms"], 3);
    EXPECT_EQ(pump["emergency_code"], 0x8130);
    EXPECT_EQ(pump["emergency_count"], 2);
    EXPECT_TRUE(Slave(0U)["heartbeat_age_ms"].is_null());
    // Under EL6751 its NodeState
    Make("manager: {node: 127, profile: el6751}\nslaves: [{node: 6, name: Pump, device_type: 0x191}]\n");
    Run(2U);
    Hear(0x706U, {0U});
    Answer(6U, DeviceType(0x192U), 20);
    EXPECT_EQ(Slave(0U)["letter"], "");
    EXPECT_EQ(Slave(0U)["code"], 5);
    const std::string other = runtime::StatusTable(*station, now_us);
    EXPECT_NE(other.find("\n6     Pump                  pre-operational  5       "), std::string::npos) << other;
}

TEST_F(ManagerShownTest, ALongNameIsCutAtACharacterAndTheColumnsStayInLine)
{
    Verifies(req::SRS_MGR_751);
    Make("manager: {node: 127}\nslaves: [{node: 5, name: F\xC3\xB6rderbandantrieb der gro\xC3\x9F"
         "en Halle, device_type: 0x191},\n  {node: 6, name: \xE6\x97\xA5\xE6\x9C\xAC, device_type: 0x191}]\n");
    Run(2U);
    const std::string table = runtime::StatusTable(*station, now_us);
    EXPECT_NE(table.find("\n5     F\xC3\xB6rderbandantrieb de  unknown "), std::string::npos) << table;
    EXPECT_NE(table.find("\n6     \xE6\x97\xA5\xE6\x9C\xAC" + std::string(18U, ' ') + "  unknown "), std::string::npos)
        << table;
}

TEST_F(ManagerShownTest, PageAndJsonTellWhoIsGood)
{
    Verifies(req::SRS_MGR_131);
    Verifies(req::SRS_MGR_142);
    // Given a slave that runs and one that is another device than the expected one
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false}, {node: 6, name: Pump, device_type: 0x191}]\n");
    Run(2U);
    EXPECT_FALSE(Slave(0U)["good"].get<bool>()) << "it was never there";
    Hear(0x705U, {0x05U});
    Hear(0x706U, {0U});
    Answer(6U, DeviceType(0x192U), 20);
    Hear(0x86U, {0x30U, 0x81U, 0x11U, 0U, 0U, 0U, 0U, 0U});
    EXPECT_TRUE(Slave(0U)["good"].get<bool>());
    EXPECT_FALSE(Slave(1U)["good"].get<bool>());
    const std::string page = Page();
    EXPECT_NE(page.find("<td data-of=\"state\" class=\"good\">operational</td>"), std::string::npos);
    EXPECT_NE(page.find("<td data-of=\"state\" class=\"bad\">pre-operational</td>"), std::string::npos);
    // And its result, emergency and finding stand in its row
    const std::size_t row = page.find("<td data-of=\"name\">Pump</td>");
    ASSERT_NE(row, std::string::npos);
    const std::string of_pump = page.substr(row, page.find("</tr>", row) - row);
    EXPECT_NE(of_pump.find("<td data-of=\"result\">C</td>"), std::string::npos) << of_pump;
    EXPECT_NE(of_pump.find("<td data-of=\"emergency\">0x8130 (1)</td>"), std::string::npos) << of_pump;
    EXPECT_NE(of_pump.find("<td data-of=\"finding\">device type differs: 0x1000:00 is 0x192, expected 0x191</td>"),
              std::string::npos)
        << of_pump;
}

TEST_F(ManagerShownTest, LetterLIsNoFinding)
{
    Verifies(req::SRS_MGR_131);
    // Given a slave that is kept alive and runs when its start-up finds it
    Make("manager: {node: 127}\nslaves: [{node: 6, device_type: 0x191, keep_alive: true, consumer: 300 ms}]\n");
    Run(2U);
    Answer(6U, DeviceType(0x191U), 20);
    for (int beat = 0; beat < 5; ++beat)
    {
        Hear(0x706U, {0x05U});
        Answer(6U, DeviceType(0x191U), 50);
    }
    EXPECT_EQ(Slave(0U)["letter"], "L") << runtime::StatusTable(*station, now_us);
    EXPECT_TRUE(Slave(0U)["good"].get<bool>());
    EXPECT_TRUE(station->Assembly().HasStarted());
}

TEST_F(ManagerShownTest, ThePageNamesWhoIsNotListed)
{
    Verifies(req::SRS_MGR_130);
    Make("manager: {node: 127}\nslaves: [{node: 6, boot: false}]\n");
    Run(2U);
    EXPECT_EQ(Page().find("not in the network list"), std::string::npos);
    Hear(0x737U, {0x7FU});
    Run(2U);
    EXPECT_NE(Page().find("</table></div><p>not in the network list (A): node 55 pre-operational</p>"),
              std::string::npos);
}

TEST_F(ManagerShownTest, AStartOfAllWithASafetySlaveIsOneStartForEachOther)
{
    Verifies(req::SRS_MGR_136);
    // Given a safety slave that answers nothing, and two other slaves
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false, mandatory: false}, {node: 6, boot: false, mandatory: "
         "false}, {node: 33, dcf: actuator.dcf, mandatory: false}]\n");
    Run(2U);
    for (const std::uint32_t node : {5U, 6U, 33U})
    {
        Hear(0x700U + node, {0x7FU});
    }
    Run(2U);
    sent.clear();
    EXPECT_EQ(Order("start all"), "taken");
    Run(500U);
    EXPECT_EQ(Commands(), (Lines{"1 5", "1 6"}));
    // Nor does an order for it alone start it
    EXPECT_EQ(Order("start 33"), "taken");
    Run(500U);
    EXPECT_EQ(Commands(), (Lines{"1 5", "1 6"}));
}

TEST_F(ManagerShownTest, WhereASubIndexIsANodeIdTheAnswerNamesTheNode)
{
    Verifies(req::SRS_MGR_141);
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false}, {node: 33, dcf: actuator.dcf}]\n");
    Run(2U);
    Hear(0x705U, {0x7FU});
    EXPECT_EQ(Order("get 0x1F82:05"), "0x1F82:05 (node 5) = 127 (0x7F)");
    EXPECT_EQ(Order("set 0x1F81:21 1"), "0x1F81:21 (node 33) = 1: 0x06010002 (read only), expected an object that may "
                                        "change, and not of a safety slave");
    EXPECT_EQ(Order("set 0x1F82:80 256"), "0x1F82:80 = 256, expected at most 1 bytes");
    Verifies(req::SRS_MGR_026);
    Verifies(req::SRS_MGR_135);
    EXPECT_EQ(Order("set 0x1F82:05 99"), "0x1F82:05 (node 5) = 99: 0x06090030 (value out of range), expected 4, 5, 6 "
                                         "(reset), 7 (reset-comm) or 127 of a node of the network");
    EXPECT_EQ(Order("get 0x1F25:05"),
              "0x1F25:05 (node 5): 0x06010001 (write only), expected an object that can be read now");
    EXPECT_EQ(Order("get 0x1017:00"), "0x1017:00 = 0 (0x0)");
}

TEST_F(ManagerShownTest, EachMessageIsAnArrowInTheOrderOfTime)
{
    Verifies(req::SRS_MGR_008);
    // Given lanes at 170 (manager), 450 (node 5) and 730 (node 6)
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false}, {node: 6, name: Pump, device_type: 0x191}]\n");
    Run(2U);
    Hear(0x706U, {0U});
    Answer(6U, DeviceType(0x192U), 20);
    Hear(0x86U, {0x30U, 0x81U, 0x11U, 0U, 0U, 0U, 0U, 0U});
    Run(2U);
    static_cast<void>(Order("stop 6"));
    Run(2U);
    const std::string page = Page();
    for (const char* const head : {">manager</text>", ">5</text>", ">6</text>", ">Pump</text>"})
    {
        EXPECT_NE(page.find(head), std::string::npos) << head;
    }
    EXPECT_EQ(Arrows(page, "NMT reset"), (Lines{"170 730 93"}));
    EXPECT_EQ(Arrows(page, "boot-up"), (Lines{"730 170 137"}));
    EXPECT_EQ(Arrows(page, "read 0x1000:00: 0x192"), (Lines{"170 730 159"}));
    EXPECT_EQ(Arrows(page, "emergency 0x8130"), (Lines{"730 170 225"}));
    EXPECT_EQ(Arrows(page, "NMT stop"), (Lines{"170 730 247"}));
    // And nothing is loaded from elsewhere
    for (const char* const loads : {"src=", "href=", "@import", "<link", "<script", "<iframe", "<object", "<embed"})
    {
        EXPECT_EQ(page.find(loads), std::string::npos) << loads;
    }
    for (std::size_t place = page.find("url("); place != std::string::npos; place = page.find("url(", place + 1U))
    {
        EXPECT_EQ(page.substr(place, 9U), "url(#tip)");
    }
}

TEST_F(ManagerShownTest, ThePictureIsAsWideAsItsLongestTextAndScrollsAlone)
{
    Verifies(req::SRS_MGR_139);
    const std::string name(60U, 'N');
    Make("manager: {node: 127}\nslaves: [{node: 5, name: " + name + ", boot: false}]\n");
    Run(2U);
    // Given few texts: the lane of node 5 at 450, and 400 for what stands beside it
    EXPECT_NE(Page().find("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"850\" "), std::string::npos);
    // When one has 200 characters, from the manager's lane at 170 on, 7 each, and room for the time of an answer
    station->Tell("note", std::string(200U, 'x'), {}, now_us);
    Run(1U);
    const std::string page = Page();
    EXPECT_NE(page.find("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1738\" "), std::string::npos);
    EXPECT_NE(page.find(std::string(200U, 'x') + "</text>"), std::string::npos);
    // The head has 40 characters of the name, the table all 60
    EXPECT_NE(page.find(">" + std::string(40U, 'N') + "</text>"), std::string::npos);
    EXPECT_NE(page.find("<td data-of=\"name\">" + name + "</td>"), std::string::npos);
    // Only the boxes of the diagram and of the table scroll
    EXPECT_NE(page.find(".sequence figure,.sequence .wide{overflow-x:auto;margin:0}"), std::string::npos);
    EXPECT_EQ(page.find("overflow-x"), page.rfind("overflow-x"));
    EXPECT_NE(page.find("<figure><figcaption>"), std::string::npos);
}

TEST_F(ManagerShownTest, ThePageHasEmergenciesAndFitsAPhone)
{
    Verifies(req::SRS_MGR_139);
    Verifies(req::SRS_MGR_142);
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false}]\n");
    Run(2U);
    Hear(0x85U, {0x30U, 0x81U, 0x11U, 0U, 0U, 0U, 0U, 0U});
    const std::string page = Page();
    EXPECT_NE(page.find("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"), std::string::npos);
    EXPECT_NE(page.find("<th>emergency</th>"), std::string::npos);
    EXPECT_NE(page.find("<td data-of=\"emergency\">0x8130 (1)</td>"), std::string::npos);
    EXPECT_NE(page.find("<div class=\"wide\"><table class=\"results\">"), std::string::npos);
    // Below each other, each with its title.
    const std::size_t narrow = page.find("@media(max-width:600px){");
    ASSERT_NE(narrow, std::string::npos);
    const std::string rules = page.substr(narrow, page.find("}}", narrow) - narrow);
    EXPECT_NE(rules.find(".results tr{display:block;"), std::string::npos) << rules;
    EXPECT_NE(rules.find(".results td{display:block;"), std::string::npos) << rules;
    EXPECT_NE(rules.find(".results tr.titles,.sequence .results td:empty{display:none"), std::string::npos) << rules;
    EXPECT_NE(page.find(".results td::before{content:attr(data-of)"), std::string::npos);
    EXPECT_NE(page.find("<td data-of=\"name\">"), std::string::npos);
    EXPECT_NE(page.find("<td data-of=\"state\" class=\""), std::string::npos);
}
} // namespace
} // namespace counterpoint::tools
