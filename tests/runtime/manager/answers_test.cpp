// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Answers to orders that are not carried out, or not by all, and what became of a start-up in words.
#include "runtime/manager/report/texts.hpp"
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>

namespace counterpoint::tools
{
namespace
{
using test::Lines;

const std::vector<std::uint8_t> kOther{0x43U, 0x00U, 0x10U, 0x00U, 0x92U, 0x01U, 0x00U, 0x00U};
const std::string kRefused =
    "taken but for node 6: C: device type differs (0x1000:00 is 0x192, expected 0x191), expected that one, and boot "
    "NODE";

class ManagerAnswersTest : public test::ManagerRig
{
  protected:
    /// Slave 6 is another device, which its start-up found; slave 7 is not booted.
    void MakeRefused(const std::string& profile)
    {
        Make("manager: {node: 127, profile: " + profile +
             "}\nslaves: [{node: 6, device_type: 0x191, mandatory: false}, {node: 7, boot: false, mandatory: "
             "false}]\n");
        Run(10U);
        Hear(0x706U, {0U});
        Answer(6U, kOther, 600);
        sent.clear();
    }
    /// Each of three requests of somebody.
    void AnswerTwice(const std::uint8_t node)
    {
        for (const std::uint8_t sub : {std::uint8_t{1U}, std::uint8_t{2U}, std::uint8_t{3U}})
        {
            Hear(0x600U + node, {0x40U, 0x18U, 0x10U, sub, 0U, 0U, 0U, 0U});
            Hear(0x580U + node, {0x43U, 0x18U, 0x10U, sub, 1U, 0U, 0U, 0U});
            Hear(0x580U + node, {0x43U, 0x18U, 0x10U, sub, 2U, 0U, 0U, 0U});
        }
    }
};

TEST_F(ManagerAnswersTest, AStartOfEachBy1F82hLeavesOutWhoWasRefusedAndSaysSo)
{
    Verifies(req::SRS_BOOT_470);
    Verifies(req::SRS_MGR_470);
    MakeRefused("cia302");
    // When each is started by the order, then by a client of the manager
    EXPECT_EQ(Order("set 0x1F82:80 0x85"), kRefused + "; nothing is heard of, so perhaps not started: node 7: reset");
    Run(5U);
    EXPECT_EQ(Commands(), (Lines{"1 7"}));
    EXPECT_EQ(Write(0x1F82U, 0x80U, 0x85U, 1U), 0U);
    EXPECT_EQ(Commands(), (Lines{"1 7"}));
    // Then a start of all leaves the other device out still
    sent.clear();
    EXPECT_EQ(Order("set 0x1F82:80 5"), kRefused);
    EXPECT_EQ(Order("start all"), kRefused);
    Run(5U);
    EXPECT_EQ(Commands(), (Lines{"1 7", "1 7"}));
    // What starts nobody, or one alone, has nobody to leave out
    EXPECT_EQ(Order("set 0x1F82:80 0x84"), "taken");
    EXPECT_EQ(Order("set 0x1F82:06 5"), "taken; started all the same: node 6: C: device type differs (0x1000:00 is "
                                        "0x192, expected 0x191)");
    EXPECT_EQ(Order("set 0x1F80:00 1"), "taken");
}

TEST_F(ManagerAnswersTest, WhoLeftOperationalIsLeftOutAgainByEachStartOfAll)
{
    Verifies(req::SRS_MGR_522);
    Verifies(req::SRS_BOOT_520);
    for (const char* const start : {"start all", "set 0x1F82:80 5", "set 0x1F82:80 0x85"})
    {
        // Given a refused slave that a start of its own has started, and slave 7, which was started, too
        MakeRefused("cia302");
        Hear(0x707U, {0x7FU});
        EXPECT_EQ(Order("start 7"), "taken");
        EXPECT_EQ(Order("start 6"), "taken; started all the same: node 6: C: device type differs (0x1000:00 is 0x192, "
                                    "expected 0x191)");
        Hear(0x706U, {0x05U});
        // When all are started while it runs, then there is nothing to be told
        EXPECT_EQ(Order(start), "taken") << start;
        // When somebody else puts it to PRE-OPERATIONAL, then it is left out, and named
        Hear(0U, {0x80U, 6U});
        Hear(0x706U, {0x7FU});
        sent.clear();
        EXPECT_EQ(Order(start), kRefused) << start;
        Run(5U);
        EXPECT_EQ(Commands(), (Lines{"1 7"})) << start;
    }
}

TEST_F(ManagerAnswersTest, EachStartUnderEl6751SaysWhatItStarts)
{
    Verifies(req::SRS_MGR_522);
    Verifies(req::SRS_ELM_520);
    const std::string differs = "0x1000:00 is 0x192, expected 0x191";
    const std::string despite = "taken; started all the same: node 6: ";
    const std::string silent = "; nothing is heard of, so perhaps not started: node 7: 8: starts up";
    for (const std::string start : {"start 6", "start all", "set 0x1F82:06 5", "set 0x1F82:80 5", "set 0x1F82:80 0x85"})
    {
        const std::string more = (start == "start 6" || start == "set 0x1F82:06 5") ? "" : silent;
        // Given another device, of which a start says so
        MakeRefused("el6751");
        EXPECT_EQ(Order(start), despite + "5: SDO value differs (" + differs + ")" + more) << start;
        // When it is stopped, then the table still says what it is, and so does its start
        MakeRefused("el6751");
        EXPECT_EQ(Order("stop 6"), "taken");
        EXPECT_EQ(Row(6U).finding, "deactivated, its start-up failed: " + differs);
        Run(2U);
        EXPECT_TRUE(std::any_of(
            events.begin(), events.end(), [&differs](const runtime::ManagerEvent& event)
            { return event.text.find("1: deactivated, its start-up failed (" + differs) != std::string::npos; }));
        EXPECT_EQ(Order(start), despite + "1: deactivated, its start-up failed (" + differs + ")" + more) << start;
        Run(2U);
        EXPECT_EQ(Row(6U).finding, "started though its start-up failed: " + differs);
        // When it runs, then there is nothing to be told
        EXPECT_EQ(Order("start 6"), "taken") << start;
        EXPECT_EQ(Order("preop 6"), "taken");
        EXPECT_EQ(Row(6U).finding, "pre-operational, its start-up failed: " + differs);
        EXPECT_EQ(Order("start 6"), despite + "12: pre-operational, its start-up failed (" + differs + ")") << start;
        // When it boots anew, and is asked again before it is started, nothing is known of it
        EXPECT_EQ(Order("reset 6"), "taken");
        EXPECT_EQ(Order("start 6").rfind("taken; nothing is heard of", 0U), 0U) << Order("start 6");
    }
}

TEST_F(ManagerAnswersTest, AStartBy1F82hThatTheStateForbidsNamesTheState)
{
    Verifies(req::SRS_MGR_470);
    Verifies(req::SRS_MGR_474);
    MakeRefused("plc_designer");
    const std::string refused = "0x1F82:06 (node 6) = 5: 0x06090030 (value out of range), node 6 is in ";
    ASSERT_EQ(Row(6U).result, "98");
    EXPECT_EQ(Order("set 0x1F82:06 5"), refused + "98: device type differs (0x1000:00 is 0x192, expected 0x191), "
                                                  "expected a state that allows it");
    EXPECT_EQ(Order("set 0x1F82:80 5"), "0x1F82:80 = 5: 0x06090030 (value out of range), expected slaves in a state "
                                        "that allows it");
    EXPECT_EQ(Order("set 0x1F82:80 0x85").rfind("taken, but not by node 6 (98: device type differs), ", 0U), 0U);
    // What is no command at all is told as before
    const std::string expected =
        ": 0x06090030 (value out of range), expected 4, 5, 6 (reset), 7 (reset-comm) or 127 of a node of the network";
    EXPECT_EQ(Order("set 0x1F82:06 3"), "0x1F82:06 (node 6) = 3" + expected);
    EXPECT_EQ(Order("set 0x1F82:09 5"), "0x1F82:09 (node 9) = 5" + expected);
    EXPECT_EQ(Order("set 0x1F82:80 3"), "0x1F82:80 = 3" + expected);
}

TEST_F(ManagerAnswersTest, AStartOfASafetySlaveThatMayBeTwoDevicesSaysThatItIsNotStarted)
{
    Verifies(req::SRS_MGR_472);
    const std::string doubted = "node 33: two devices seem to have this node-ID, expected one and a reset";
    for (const char* const profile : {"cia302", "el6751", "plc_designer"})
    {
        // Given a safety slave that answers everything twice
        Make("manager: {node: 127, profile: " + std::string(profile) +
             "}\nslaves: [{node: 33, dcf: actuator.dcf, boot: false, mandatory: false}]\n");
        Run(10U);
        Hear(0x721U, {0U});
        Run(10U);
        AnswerTwice(33U);
        ASSERT_EQ(Row(33U).finding, "two devices with this node-ID?") << profile;
        sent.clear();
        // When its start is ordered, then nothing is sent, and the answer says why
        EXPECT_EQ(Order("start 33"), "not taken by " + doubted) << profile;
        EXPECT_EQ(Order("set 0x1F82:21 5"), "not taken by " + doubted) << profile;
        Run(5U);
        EXPECT_EQ(Commands(), (Lines{})) << profile;
        // With all others, or by 1F82h, it is named
        const bool is_taken = std::string(profile) != "plc_designer"; // Its state 2 takes no start.
        const std::string named = is_taken ? "; not started: " + doubted : "not taken by node 33 (2: settles)";
        EXPECT_NE(Order("start all").find(named), std::string::npos) << profile;
        EXPECT_EQ(Order("stop 33"), "taken") << profile;
    }
    Make("manager: {node: 127}\nslaves: [{node: 33, dcf: actuator.dcf, boot: false}, {node: 6, boot: false}]\n");
    Run(10U);
    AnswerTwice(33U);
    AnswerTwice(6U);
    EXPECT_EQ(Order("set 0x1F82:21 5"), "not taken by " + doubted);
    EXPECT_EQ(Order("set 0x1F82:21 0x85").find("taken"), std::string::npos); // Of all alone.
    EXPECT_EQ(Order("set 0x1F82:80 0x85"),
              "taken; nothing is heard of, so perhaps not started: node 6: reset; not started: " + doubted);
    // A slave that is no safety slave is started all the same
    EXPECT_EQ(Order("start 6").rfind("taken", 0U), 0U);
    // And so is it, verified, behind its reset
    EXPECT_EQ(Order("reset 33"), "taken");
    EXPECT_EQ(Order("start 33").rfind("taken", 0U), 0U);
}

TEST_F(ManagerAnswersTest, ABootUpMessageThatDidNotComeIsToldAsThat)
{
    Verifies(req::SRS_BOOT_471);
    cia302::NodeStatus status{};
    status.letter = 'J';
    status.step = cia302::StartUpStep::kRestore;
    status.abort = cia301::SdoAbort::kTimeOut;
    EXPECT_EQ(runtime::StatusText(network_plan::StartProfile::kCia302, status),
              "J: configuration failed (restore: no boot-up message came, expected one)");
    // An SDO without an answer is told as before
    status.object = {0x1011U, 1U};
    EXPECT_EQ(runtime::StatusText(network_plan::StartProfile::kCia302, status),
              "J: configuration failed (0x1011:01: 0x05040000 (no answer))");
}

TEST_F(ManagerAnswersTest, ARefusedRestoreOfThePlcDesignerIsInTheFindingAndTold)
{
    Verifies(req::SRS_PLC_470);
    Make("manager: {node: 127, profile: plc_designer}\n"
         "slaves: [{node: 6, device_type: 0x191, plc_designer: {reset_node: true}}]\n");
    Run(10U);
    Hear(0x706U, {0U});
    const std::vector<std::uint8_t> right{0x43U, 0x00U, 0x10U, 0x00U, 0x91U, 0x01U, 0x00U, 0x00U};
    const std::vector<std::uint8_t> not_stored{0x80U, 0x11U, 0x10U, 0x01U, 0x20U, 0x00U, 0x00U, 0x08U};
    for (int ms = 0; ms < 4000; ++ms)
    {
        const auto asked =
            std::find_if(sent.begin(), sent.end(), [](const CanFrame& frame) { return frame.identifier == 0x606U; });
        const bool is_restore = asked != sent.end() && asked->data[1] == 0x11U;
        Answer(6U, is_restore ? not_stored : right, 1);
    }
    ASSERT_EQ(Row(6U).result, "5");
    const std::string told = "0x1011:01: 0x08000020 (not stored)";
    EXPECT_EQ(Row(6U).finding, told);
    EXPECT_TRUE(std::any_of(events.begin(), events.end(), [&told](const runtime::ManagerEvent& event)
                            { return event.text == "4: pre-operational (" + told + ")"; }));
}
} // namespace
} // namespace counterpoint::tools
