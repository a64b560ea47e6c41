// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a person is told of each slave: letters and codes in words, who was not started and why, devices that are
// faulty.
#include "runtime/manager/report/diagram.hpp"
#include "runtime/manager/report/status.hpp"
#include "runtime/manager/report/texts.hpp"
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{
using cia302::StartUpStep;
using network_plan::StartProfile;

class ManagerResultsTest : public test::ManagerRig
{
  protected:
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
    [[nodiscard]] bool IsTold(const std::string& text) const
    {
        return std::any_of(events.begin(), events.end(), [&text](const runtime::ManagerEvent& event)
                           { return event.text.find(text) != std::string::npos; });
    }
};

TEST_F(ManagerResultsTest, EachLetterAndCodeHasWordsAndHelpListsThem)
{
    Verifies(req::SRS_MGR_026);
    const std::string help = runtime::ManagerOrderHelp();
    for (char letter = 'A'; letter <= 'O'; ++letter)
    {
        cia302::NodeStatus status{};
        status.letter = letter;
        const std::string words = runtime::LetterText(letter);
        EXPECT_FALSE(words.empty()) << letter;
        EXPECT_EQ(runtime::ResultText(StartProfile::kCia302, status), words);
        EXPECT_EQ(runtime::StatusText(StartProfile::kCia302, status), std::string(1U, letter) + ": " + words);
        EXPECT_NE(help.find(std::string("\n  ") + letter + "    " + words + "\n"), std::string::npos) << letter;
    }
    for (const int code : {1, 2, 4, 5, 8, 11, 12, 13, 14, 20, 22, 23, 40})
    {
        const std::string words = runtime::CodeText(StartProfile::kEl6751, code);
        EXPECT_FALSE(words.empty()) << code;
        EXPECT_NE(help.find(" " + words + "\n"), std::string::npos) << code;
    }
    for (const int code : {-1, 1, 2, 3, 4, 97, 98, 99})
    {
        cia302::NodeStatus status{};
        status.code = static_cast<std::int16_t>(code);
        const std::string words = runtime::CodeText(StartProfile::kPlcDesigner, code);
        EXPECT_EQ(runtime::ResultText(StartProfile::kPlcDesigner, status).rfind(words, 0U), 0U) << code;
        EXPECT_NE(help.find(" " + words + "\n"), std::string::npos) << code;
    }
    // A slave that is as it is to be needs no words
    EXPECT_EQ(runtime::ResultText(StartProfile::kCia302, cia302::NodeStatus{}), "");
    EXPECT_EQ(runtime::ResultText(StartProfile::kEl6751, cia302::NodeStatus{}), "");
}

TEST_F(ManagerResultsTest, AnAbortIsToldByItsCodeAndInWords)
{
    Verifies(req::SRS_MGR_026);
    cia302::NodeStatus status{};
    status.letter = 'J';
    status.object = {0x1006U, 0U};
    status.abort = cia301::SdoAbort::kReadOnly;
    EXPECT_EQ(runtime::ResultText(StartProfile::kCia302, status),
              "configuration failed: 0x1006:00: 0x06010002 (read only)");
    status.abort = cia301::SdoAbort::kTimeOut;
    EXPECT_EQ(runtime::StatusText(StartProfile::kCia302, status),
              "J: configuration failed (0x1006:00: 0x05040000 (no answer))");
    // A code that is of the device alone
    status.abort = static_cast<cia301::SdoAbort>(0x08990001U);
    EXPECT_EQ(runtime::ResultText(StartProfile::kCia302, status), "configuration failed: 0x1006:00: 0x08990001");
    status.letter = 'M';
    status.object = {0x1018U, 2U};
    status.abort = cia301::SdoAbort::kNone;
    status.read = 3U;
    status.expected = 7U;
    EXPECT_EQ(runtime::ResultText(StartProfile::kCia302, status),
              "product code differs: 0x1018:02 is 0x3, expected 0x7");
}

TEST_F(ManagerResultsTest, ASlaveThatSaysThatItLeftOperationalIsNotGood)
{
    Verifies(req::SRS_MGR_131);
    for (const char* const profile : {"cia302", "plc_designer"})
    {
        // Given a mandatory slave that was started and is heard as OPERATIONAL
        Make("manager: {node: 127, profile: " + std::string(profile) +
             "}\nslaves: [{node: 6, device_type: 0x191, consumer: 300 ms}]\n");
        Run(1000U);
        Hear(0x706U, {0U});
        for (int beat = 0; beat < 6; ++beat)
        {
            Answer(6U, {0x43U, 0x00U, 0x10U, 0x00U, 0x91U, 0x01U, 0x00U, 0x00U}, 110);
            Hear(0x706U, {(beat < 5) ? std::uint8_t{0x7FU} : std::uint8_t{0x05U}});
            Run(2U);
        }
        EXPECT_TRUE(Row(6U).is_good) << profile;
        EXPECT_TRUE(station->Assembly().HasStarted()) << profile;
        // When somebody stops it, then it is not good, as the exit status says
        for (const std::uint8_t state : {std::uint8_t{0x04U}, std::uint8_t{0x7FU}})
        {
            Hear(0x706U, {state});
            Run(2U);
            EXPECT_FALSE(Row(6U).is_good) << profile;
            EXPECT_FALSE(station->Assembly().HasStarted()) << profile;
        }
        // And again when it is back
        Hear(0x706U, {0x05U});
        Run(2U);
        EXPECT_TRUE(Row(6U).is_good) << profile;
    }
}

TEST_F(ManagerResultsTest, AtAStandbyWhoRunsIsGoodUnderEachProfile)
{
    Verifies(req::SRS_MGR_132);
    Verifies(req::SRS_MGR_135);
    for (const std::string profile : {"cia302", "el6751", "plc_designer"})
    {
        // Given a manager that asks for the active master, which answers
        Make("manager: {node: 127, heartbeat: 100 ms, profile: " + profile +
             ", flying: {priority: 1}}\nslaves: [{node: 6, device_type: 0x191, consumer: 400 ms}, {node: 5, boot: "
             "false, "
             "mandatory: false, consumer: 500 ms}]\n");
        sent.clear();
        for (int ms = 0; ms < 5000 && Count(0x073U) == 0U; ++ms)
        {
            Run(1U);
        }
        Hear(0x071U, {0U, 5U});
        Run(2U);
        ASSERT_FALSE(station->Assembly().Core().IsActive()) << profile;
        EXPECT_FALSE(station->Assembly().HasStarted()) << profile;
        // When the slave says that it is OPERATIONAL, then it is good, as soon as it does not, no more
        Hear(0x706U, {0x05U});
        Run(2U);
        EXPECT_TRUE(Row(6U).is_good) << profile;
        EXPECT_TRUE(station->Assembly().HasStarted()) << profile;
        Hear(0x706U, {0x7FU});
        Run(2U);
        EXPECT_FALSE(Row(6U).is_good) << profile;
        EXPECT_FALSE(station->Assembly().HasStarted()) << profile;
        // And an order is refused with its reason
        const std::string standby = "this manager is not the active master, expected the command at that one";
        EXPECT_EQ(Order("boot 6"), standby) << profile;
        EXPECT_EQ(Order("stop 6"), standby) << profile;
        for (const std::string order : {"boot", "stop"})
        {
            EXPECT_EQ(Order(order + " 99"), "node 99 is not in the network file, expected a slave") << profile;
        }
        EXPECT_EQ(Order("boot 127"), "node 127 is this manager, expected a slave") << profile;
        EXPECT_EQ(Order("control 127 5 0"), "node 127 is this manager, expected a slave") << profile;
    }
}

TEST_F(ManagerResultsTest, AnAbortAndSilenceAt1000hAreToldThoughThereIsNoBootTime)
{
    Verifies(req::SRS_MGR_026);
    Make("manager: {node: 127}\nslaves: [{node: 6, device_type: 0x191}, {node: 7, device_type: 0x191}]\n");
    Run(2U);
    Hear(0x706U, {0U});
    Answer(6U, {0x80U, 0x00U, 0x10U, 0x00U, 0x00U, 0x00U, 0x06U, 0x06U}, 6000);
    EXPECT_EQ(Row(6U).result, "");
    EXPECT_EQ(Row(6U).finding, "asked again each second: 0x1000:00: 0x06060000 (hardware)");
    EXPECT_EQ(Row(7U).finding, "asked again each second: 0x1000:00: 0x05040000 (no answer)");
    EXPECT_FALSE(Row(6U).is_good);
    EXPECT_TRUE(IsTold("asked again each second (0x1000:00: 0x06060000 (hardware))"));
    EXPECT_TRUE(IsTold("asked again each second (0x1000:00: 0x05040000 (no answer))"));
    // Once, not each second
    EXPECT_EQ(std::count_if(events.begin(), events.end(), [](const runtime::ManagerEvent& event)
                            { return event.text.rfind("asked again", 0U) == 0U; }),
              2);
}

TEST_F(ManagerResultsTest, AFlashThatIsBusyIsToldWhileItsUpdateRuns)
{
    Verifies(req::SRS_MGR_230);
    cia302::NodeStatus busy{};
    busy.is_busy = true;
    busy.step = StartUpStep::kSoftwareUpdate;
    busy.object = ObjectAddress{0x1F57U, 1U};
    busy.read = 1U;
    EXPECT_EQ(runtime::ResultText(StartProfile::kCia302, busy), "its flash is busy: 0x1F57:01 is 0x1, expected 0x0");
    EXPECT_EQ(runtime::StatusText(StartProfile::kCia302, busy), "its flash is busy (0x1F57:01 is 0x1, expected 0x0)");
    // A minute later it is letter I
    cia302::NodeStatus failed = busy;
    failed.is_busy = false;
    failed.letter = 'I';
    EXPECT_EQ(runtime::ResultText(StartProfile::kCia302, failed),
              "software update failed: 0x1F57:01 is 0x1, expected 0x0");
    // Ready, with another object, in another step, without an answer, ended: nothing is to be told
    std::array<cia302::NodeStatus, 5> others{busy, busy, busy, busy, busy};
    others[0].read = 2U;
    others[1].object = ObjectAddress{0x1F50U, 1U};
    others[2].step = StartUpStep::kConfigure;
    others[3].abort = cia301::SdoAbort::kTimeOut;
    others[4].is_busy = false;
    for (const cia302::NodeStatus& other : others)
    {
        EXPECT_FALSE(runtime::IsFlashBusy(other));
        EXPECT_EQ(runtime::FindingText(StartProfile::kCia302, other), "");
    }
}

TEST_F(ManagerResultsTest, AnAnswerOfAnotherLengthIsToldAsThatAndNotByNumbers)
{
    Verifies(req::SRS_MGR_026);
    Verifies(req::SRS_ELM_025);
    // Given the right number of 1000h in two bytes, which el6751 refuses
    Make("manager: {node: 127, profile: el6751}\nslaves: [{node: 6, device_type: 0x191}]\n");
    Run(2U);
    Hear(0x706U, {0U});
    Answer(6U, {0x4BU, 0x00U, 0x10U, 0x00U, 0x91U, 0x01U, 0x00U, 0x00U}, 20);
    EXPECT_EQ(Row(6U).result, "4");
    EXPECT_EQ(Row(6U).finding, "SDO aborted or of wrong length: 0x1000:00: 0x06070010 (another length)");
    EXPECT_EQ(Order("start 6"), "taken; started all the same: node 6: 4: SDO aborted or of wrong length (0x1000:00: "
                                "0x06070010 (another length))");
    Run(5U);
    EXPECT_EQ(Row(6U).finding, "started though its start-up failed: 0x1000:00: 0x06070010 (another length)");
}

TEST_F(ManagerResultsTest, AStartOfAllNamesWhoIsLeftOutAndWhy)
{
    Verifies(req::SRS_MGR_026);
    Make("manager: {node: 127, start_up: 9}\nslaves: [{node: 6, device_type: 0x191, mandatory: false}, {node: 7, "
         "mandatory: false}]\n");
    Run(2U);
    Hear(0x706U, {0U});
    Answer(6U, {0x43U, 0x00U, 0x10U, 0x00U, 0x92U, 0x01U, 0x00U, 0x00U}, 20);
    EXPECT_EQ(Row(6U).finding, "device type differs: 0x1000:00 is 0x192, expected 0x191");
    sent.clear();
    EXPECT_EQ(Order("start all"), "taken but for node 6: C: device type differs (0x1000:00 is 0x192, expected 0x191), "
                                  "expected that one, and boot NODE; nothing is heard of, so perhaps not started: "
                                  "node 7: reset");
    Run(5U);
    EXPECT_EQ(Commands(), (std::vector<std::string>{"1 7"}));
    // When it was started all the same, nobody is left out
    sent.clear();
    EXPECT_EQ(Order("start 6").rfind("taken; started all the same: node 6", 0U), 0U);
    Run(5U);
    EXPECT_EQ(Order("start all"), "taken");
    Run(5U);
    EXPECT_EQ(Commands(), (std::vector<std::string>{"1 6", "1 0"}));
    // When it is stopped, it is left out again, and named
    sent.clear();
    EXPECT_EQ(Order("stop 6"), "taken");
    EXPECT_EQ(Order("start all"), "taken but for node 6: C: device type differs (0x1000:00 is 0x192, expected 0x191), "
                                  "expected that one, and boot NODE; nothing is heard of, so perhaps not started: "
                                  "node 7: reset");
    Run(5U);
    EXPECT_EQ(Commands(), (std::vector<std::string>{"2 6", "1 7"}));
}

TEST_F(ManagerResultsTest, AStartOfASlaveThatIsRefusedSaysWhatWasFound)
{
    Verifies(req::SRS_MGR_026);
    const std::vector<std::uint8_t> other{0x43U, 0x00U, 0x10U, 0x00U, 0x92U, 0x01U, 0x00U, 0x00U};
    Make("manager: {node: 127}\nslaves: [{node: 6, device_type: 0x191, mandatory: false}, {node: 7, boot: false}]\n");
    Run(2U);
    Hear(0x706U, {0U});
    Answer(6U, other, 20);
    EXPECT_EQ(Order("start 7"), "taken; nothing is heard of, so perhaps not started: node 7: reset");
    sent.clear();
    EXPECT_EQ(Order("start 6"), "taken; started all the same: node 6: C: device type differs (0x1000:00 is 0x192, "
                                "expected 0x191)");
    EXPECT_EQ(Order("stop 6"), "taken");
    // The text of EL6751 starts it by a start of all as well
    Make("manager: {node: 127, profile: el6751}\nslaves: [{node: 6, device_type: 0x191}]\n");
    Run(2U);
    Hear(0x706U, {0U});
    Answer(6U, other, 20);
    EXPECT_EQ(Row(6U).finding, "SDO value differs: 0x1000:00 is 0x192, expected 0x191");
    EXPECT_EQ(Order("start all"), "taken; started all the same: node 6: 5: SDO value differs (0x1000:00 is 0x192, "
                                  "expected 0x191)");
    EXPECT_EQ(Order("start 6"), "taken");
}

TEST_F(ManagerResultsTest, ASlaveThatRunsWithAFindingIsNotGoodNorExitStatus0)
{
    Verifies(req::SRS_MGR_004);
    Verifies(req::SRS_MGR_131);
    Verifies(req::SRS_MGR_133);
    const std::vector<std::uint8_t> other{0x43U, 0x00U, 0x10U, 0x00U, 0x92U, 0x01U, 0x00U, 0x00U};
    for (const char* const profile : {"cia302", "el6751"})
    {
        // Given another device than the expected one, started by hand
        Make("manager: {node: 127, profile: " + std::string(profile) + "}\nslaves: [{node: 6, device_type: 0x191}]\n");
        Run(2U);
        Hear(0x706U, {0U});
        Answer(6U, other, 20);
        EXPECT_FALSE(station->Assembly().HasStarted()) << profile;
        EXPECT_EQ(Order("start 6").rfind("taken; started all the same", 0U), 0U) << profile;
        Run(5U);
        Hear(0x706U, {0x05U});
        Run(2U);
        EXPECT_EQ(Row(6U).state, "operational") << profile;
        EXPECT_FALSE(Row(6U).is_good) << profile;
        EXPECT_FALSE(station->Assembly().HasStarted()) << profile;
    }
    EXPECT_EQ(Row(6U).result, "0");
    EXPECT_EQ(Row(6U).finding, "started though its start-up failed: 0x1000:00 is 0x192, expected 0x191");
    EXPECT_TRUE(IsTold("0: started though its start-up failed (0x1000:00 is 0x192, expected 0x191)"));
    // When the expected one takes its place
    EXPECT_EQ(Order("boot 6"), "taken");
    Run(5U);
    Hear(0x706U, {0U});
    Answer(6U, {0x43U, 0x00U, 0x10U, 0x00U, 0x91U, 0x01U, 0x00U, 0x00U}, 20);
    EXPECT_EQ(Row(6U).finding, "");
    EXPECT_TRUE(Row(6U).is_good);
    EXPECT_TRUE(station->Assembly().HasStarted());
}

TEST_F(ManagerResultsTest, AKeptAliveSlaveWithALetterIsNotGood)
{
    Verifies(req::SRS_MGR_004);
    Verifies(req::SRS_MGR_131);
    Make("manager: {node: 127}\nslaves: [{node: 6, device_type: 0x191, keep_alive: true, consumer: 300 ms}]\n");
    Run(2U);
    Answer(6U, {0x43U, 0x00U, 0x10U, 0x00U, 0x92U, 0x01U, 0x00U, 0x00U}, 20);
    Hear(0x706U, {0x05U});
    Run(2U);
    EXPECT_EQ(Row(6U).result, "C");
    EXPECT_EQ(Row(6U).state, "operational");
    EXPECT_FALSE(Row(6U).is_good);
    EXPECT_FALSE(station->Assembly().HasStarted());
}

TEST_F(ManagerResultsTest, WhoIsNotInTheNetworkListIsNamed)
{
    Verifies(req::SRS_MGR_130);
    for (const char* const profile : {"cia302", "el6751", "plc_designer"})
    {
        Make("manager: {node: 127, profile: " + std::string(profile) + "}\nslaves: [{node: 6, device_type: 0x191}]\n");
        Run(2U);
        EXPECT_EQ(runtime::UnlistedText(*station, now_us), "") << profile;
        EXPECT_EQ(runtime::StatusTable(*station, now_us).find("network list"), std::string::npos) << profile;
        // When two others are heard, and the slave, and somebody with the node-ID of the manager
        Hear(0x706U, {0x7FU});
        Hear(0x737U, {0x00U});
        Hear(0x701U, {0x05U});
        Hear(0x77FU, {0x05U});
        Run(3U);
        const std::string named = "not in the network list (A): node 1 operational, node 55 pre-operational";
        EXPECT_EQ(runtime::UnlistedText(*station, now_us), named) << profile;
        EXPECT_NE(runtime::StatusTable(*station, now_us).find("\n" + named + "\n"), std::string::npos) << profile;
        EXPECT_NE(
            runtime::StatusJson(*station, now_us).dump().find("\"unlisted\":[{\"node\":1,\"state\":\"operational\","),
            std::string::npos)
            << profile;
    }
}

TEST_F(ManagerResultsTest, AControlThatIsNoneSaysWhatItIsAndWhatThereIs)
{
    Verifies(req::SRS_MGR_026);
    Make("manager: {node: 127, profile: el6751}\nslaves: [{node: 6, device_type: 0x191}]\n");
    Run(5U);
    const std::string answer = Order("control 6 7 1");
    EXPECT_EQ(answer.rfind("control 7/1 is no command for node 6, which is ", 0U), 0U) << answer;
    EXPECT_NE(answer.find(" with NodeState 8: starts up, expected no start-up that runs, and 5/0 or 6/0 while "),
              std::string::npos)
        << answer;
    Make("manager: {node: 127}\nslaves: [{node: 6, device_type: 0x191}]\n");
    EXPECT_EQ(Order("control 6 5 1"), "the profile cia302 has no control, expected el6751");
}

TEST_F(ManagerResultsTest, ASafetySlaveInItsSafeStateIsNotGood)
{
    Verifies(req::SRS_MGR_025);
    // Given a safety slave and another one that run
    Make("manager: {node: 127}\nslaves: [{node: 33, dcf: actuator.dcf, boot: false}, {node: 5, boot: false}]\n");
    Run(2U);
    for (const std::uint32_t node : {33U, 5U})
    {
        Hear(0x80U + node, {0x00U, 0x61U, 0x81U, 0U, 0U, 0U, 0U, 0U});
    }
    EXPECT_EQ(Row(33U).finding, "device fault: emergency 0x6100, expected its end or a restart of the device");
    EXPECT_EQ(Row(5U).finding, "");
    Hear(0xA1U, {0x00U, 0x00U, 0x00U, 0U, 0U, 0U, 0U, 0U});
    EXPECT_EQ(Row(33U).finding, "");
}

TEST_F(ManagerResultsTest, ASafetySlaveThatRunsInItsSafeStateIsNotGoodNorExitStatus0)
{
    Verifies(req::SRS_MGR_025);
    for (const std::string profile : {"cia302", "el6751", "plc_designer"})
    {
        // Given a manager that does not lead, where a slave is good that is heard to be OPERATIONAL
        Make("manager: {node: 127, heartbeat: 100 ms, profile: " + profile +
             ", flying: {priority: 1}}\nslaves: [{node: 33, dcf: actuator.dcf}, {node: 5, boot: false, mandatory: "
             "false, consumer: 500 ms}]\n");
        sent.clear();
        for (int ms = 0; ms < 5000 && Count(0x073U) == 0U; ++ms)
        {
            Run(1U);
        }
        Hear(0x071U, {0U, 5U});
        Run(2U);
        ASSERT_FALSE(station->Assembly().Core().IsActive()) << profile;
        const auto expect_good = [this, &profile](const bool is_good)
        {
            Hear(0x721U, {0x05U});
            Run(2U);
            EXPECT_EQ(Row(33U).state, "operational") << profile;
            EXPECT_EQ(Row(33U).is_good, is_good) << profile;
            EXPECT_EQ(station->Assembly().HasStarted(), is_good) << profile;
        };
        expect_good(true);
        // When it tells its safe state, then it is not good, though it runs, until it tells the end
        Hear(0xA1U, {0x00U, 0x61U, 0x81U, 0U, 0U, 0U, 0U, 0U});
        expect_good(false);
        Hear(0xA1U, {0x00U, 0x00U, 0x00U, 0U, 0U, 0U, 0U, 0U});
        expect_good(true);
    }
}

TEST_F(ManagerResultsTest, ADeviceFaultIsNamedWhateverElseThereIsToTell)
{
    Verifies(req::SRS_MGR_025);
    const std::string fault = "device fault: emergency 0x6100, expected its end or a restart of the device";
    const std::pair<const char*, const char*> runs[] = {
        {"cia302", "device type differs: 0x1000:00 is 0x192, expected 0x191"},
        {"el6751", "SDO value differs: 0x1000:00 is 0x192, expected 0x191"},
        {"plc_designer", "is configured"}};
    for (const auto& [profile, result] : runs)
    {
        // Given a safety slave whose start-up has something to tell
        Make("manager: {node: 127, profile: " + std::string(profile) +
             "}\nslaves: [{node: 33, dcf: actuator.dcf, device_type: 0x191}]\n");
        Run(1000U);
        Hear(0x721U, {0U});
        Answer(33U, {0x43U, 0x00U, 0x10U, 0x00U, 0x92U, 0x01U, 0x00U, 0x00U}, 700);
        EXPECT_EQ(Row(33U).finding, result) << profile;
        // When it tells its device fault, and then another emergency
        Hear(0xA1U, {0x00U, 0x61U, 0x81U, 0U, 0U, 0U, 0U, 0U});
        Hear(0xA1U, {0x30U, 0x81U, 0x91U, 0U, 0U, 0U, 0U, 0U});
        // Then table, page and JSON name the fault, and the rest behind it
        EXPECT_EQ(Row(33U).finding, fault + "; " + result) << profile;
        const std::string page = runtime::DiagramPage(*station);
        EXPECT_NE(page.find("<td data-of=\"finding\">" + fault + "; "), std::string::npos) << profile;
        EXPECT_NE(runtime::StatusTable(*station, now_us).find(fault), std::string::npos) << profile;
        EXPECT_EQ(runtime::StatusJson(*station, now_us)["slaves"][0]["finding"], fault + "; " + result) << profile;
    }
    // And so it is where it may be two devices
    Make("manager: {node: 127}\nslaves: [{node: 33, dcf: actuator.dcf, boot: false}]\n");
    Run(2U);
    Hear(0xA1U, {0x00U, 0x61U, 0x81U, 0U, 0U, 0U, 0U, 0U});
    AnswerTwice(33U);
    EXPECT_EQ(Row(33U).finding, fault + "; two devices with this node-ID?");
}

// A start has no answer: who is not there is named, whatever the profile
TEST_F(ManagerResultsTest, AStartNamesWhoIsNotHeard)
{
    Verifies(req::SRS_MGR_080);
    const std::string not_heard = "; nothing is heard of, so perhaps not started: node 7: ";
    for (const auto& [profile, reason] : std::vector<std::pair<std::string, std::string>>{
             {"cia302", "wait for boot-up"}, {"el6751", "2: not found (0x1000:00: 0x05040000 (no answer))"}})
    {
        Make("manager: {node: 127, profile: " + profile +
             "}\nslaves: [{node: 6, device_type: 0x191}, {node: 7, device_type: 0x191, mandatory: "
             "false}]\n");
        Run(2U);
        Hear(0x706U, {0U});
        Answer(6U, {0x43U, 0x00U, 0x10U, 0x00U, 0x91U, 0x01U, 0x00U, 0x00U}, 5000);
        Hear(0x706U, {5U});
        EXPECT_EQ(Order("start all"), "taken" + not_heard + reason) << profile;
        EXPECT_EQ(Order("start 7").rfind("taken" + not_heard, 0U), 0U) << profile;
        EXPECT_EQ(Order("start 6"), "taken") << profile;
        // When it has come, then nobody is named
        Hear(0x707U, {0U});
        Answer(7U, {0x43U, 0x00U, 0x10U, 0x00U, 0x91U, 0x01U, 0x00U, 0x00U}, 5000);
        Hear(0x707U, {5U});
        EXPECT_EQ(Order("start all"), "taken") << profile;
    }
}

// Nobody notices the silence of a slave without heartbeat and guarding
TEST_F(ManagerResultsTest, AnUnsupervisedSlaveThatIsSilentIsUnknown)
{
    Verifies(req::SRS_MGR_081);
    for (const char* const profile : {"cia302", "el6751", "plc_designer"})
    {
        Make("manager: {node: 127, profile: " + std::string(profile) + "}\nslaves: [{node: 6, device_type: 0x191}]\n");
        Run(2U);
        Hear(0x706U, {0U});
        Answer(6U, {0x43U, 0x00U, 0x10U, 0x00U, 0x91U, 0x01U, 0x00U, 0x00U}, 5000);
        EXPECT_EQ(Row(6U).state, "unknown") << profile;
        EXPECT_EQ(Row(6U).age, "5000 ms") << profile;
        EXPECT_EQ(runtime::StatusJson(*station, now_us)["slaves"][0]["state"], "unknown") << profile;
        const std::string page = runtime::DiagramPage(*station);
        EXPECT_NE(page.find(">unknown</td>"), std::string::npos) << profile;
        EXPECT_NE(page.find("<td data-of=\"heartbeat\">5000 ms</td>"), std::string::npos) << profile;
        // When it is heard, then for a second; one that is not in the network list likewise
        Hear(0x706U, {5U});
        Hear(0x737U, {5U});
        Run(1000U);
        EXPECT_EQ(Row(6U).state, "operational") << profile;
        EXPECT_EQ(runtime::UnlistedText(*station, now_us), "not in the network list (A): node 55 operational");
        Run(1U);
        EXPECT_EQ(Row(6U).state, "unknown") << profile;
        EXPECT_EQ(runtime::UnlistedText(*station, now_us), "not in the network list (A): node 55 unknown");
    }
}

TEST_F(ManagerResultsTest, TheAgeOfAHeartbeatIsNotThatOfACounterThatCameRound)
{
    Verifies(req::SRS_MGR_005);
    // Given a slave, and a node that is none, that were heard 72 minutes ago
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false}, {node: 6, boot: false}]\n");
    Run(2U);
    Hear(0x705U, {0x05U});
    Hear(0x709U, {0x05U});
    for (int minute = 0; minute < 72; ++minute)
    {
        now_us += 60'000'000U;
        station->OnCycle(now_us);
    }
    nlohmann::json status = runtime::StatusJson(*station, now_us);
    EXPECT_EQ(status["slaves"][0]["heartbeat_age_ms"], 4'320'000);
    EXPECT_TRUE(status["slaves"][1]["heartbeat_age_ms"].is_null());
    EXPECT_EQ(status["unlisted"][0]["heartbeat_age_ms"], 4'320'000);
    EXPECT_NE(runtime::StatusTable(*station, now_us).find("  4320000 ms"), std::string::npos);
    EXPECT_NE(runtime::StatusTable(*station, now_us).find("  -\n"), std::string::npos);
    // When the slave is heard again, and then says something else, then the heartbeat counts
    Hear(0x705U, {0x05U});
    Run(3U);
    Hear(0x185U, {0x05U});
    Run(4U);
    status = runtime::StatusJson(*station, now_us);
    EXPECT_EQ(status["slaves"][0]["heartbeat_age_ms"], 7);
    EXPECT_EQ(status["unlisted"][0]["heartbeat_age_ms"], 4'320'007);
}

TEST_F(ManagerResultsTest, ASafetySlaveThatRunsAndIsNotVerifiedIsNotGood)
{
    Verifies(req::SRS_MGR_131);
    // Given a safety slave and another one that somebody else has started, and that answer nothing
    Make("manager: {node: 127}\nslaves: [{node: 33, dcf: actuator.dcf, boot: false}, {node: 5, boot: false}]\n");
    for (const std::uint32_t node : {33U, 5U})
    {
        Run(2U);
        Hear(0x700U + node, {0x05U});
    }
    Run(20U);
    EXPECT_EQ(Row(33U).state, "operational");
    EXPECT_EQ(Row(33U).safety, "closed");
    EXPECT_FALSE(Row(33U).is_good);
    EXPECT_TRUE(Row(5U).is_good);
    EXPECT_FALSE(station->Assembly().HasStarted());
}

TEST_F(ManagerResultsTest, ANodeThatMayBeTwoDevicesIsNotGood)
{
    Verifies(req::SRS_MGR_225);
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false}]\n");
    EndStartUp();
    Hear(0x705U, {0x05U});
    Run(2U);
    EXPECT_TRUE(Row(5U).is_good);
    EXPECT_TRUE(station->Assembly().HasStarted());
    // When each of three requests of somebody is answered twice
    AnswerTwice(5U);
    EXPECT_EQ(Row(5U).finding, "two devices with this node-ID?");
    EXPECT_FALSE(Row(5U).is_good);
    EXPECT_FALSE(station->Assembly().HasStarted());
    EXPECT_EQ(Row(5U).state, "operational");
    EXPECT_EQ(station->Assembly().Core().OwnState(), cia301::NodeState::kOperational);
    // Given one that is heard eighteen times in ten of its producer times of 100 ms, first at the end of its start-up,
    // then it is so, too
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false, heartbeat: 100 ms}]\n");
    EndStartUp();
    for (int beat = 0; beat < 17; ++beat)
    {
        EXPECT_NE(Row(5U).finding, "two devices with this node-ID?") << beat;
        Hear(0x705U, {0x05U});
        Run(50U);
    }
    EXPECT_EQ(Row(5U).finding, "two devices with this node-ID?");
    EXPECT_FALSE(Row(5U).is_good);
    EXPECT_EQ(Row(5U).state, "operational");
    EXPECT_EQ(station->Assembly().Core().OwnState(), cia301::NodeState::kOperational);
}
} // namespace
} // namespace counterpoint::tools
