// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the answer to a start says of slaves that are lost, busy, kept alive, doubted or other devices.
#include "runtime/manager/report/texts.hpp"
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{
const std::string kOtherFound = "0x1000:00 is 0x192, expected 0x191";

class ManagerStartAnswerTest : public test::ManagerRig
{
  protected:
    static std::vector<std::uint8_t> DeviceType(const std::uint8_t low)
    {
        return {0x43U, 0x00U, 0x10U, 0x00U, low, 0x01U, 0x00U, 0x00U};
    }
    /// Each of three requests of somebody is answered by two devices.
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

TEST_F(ManagerStartAnswerTest, EachOfSeveralThatAreStartedAllTheSameIsNamed)
{
    Verifies(req::SRS_MGR_522);
    Make("manager: {node: 127, profile: el6751}\n"
         "slaves: [{node: 6, device_type: 0x191}, {node: 7, device_type: 0x191}]\n");
    Run(10U);
    Hear(0x706U, {0U});
    Answer(6U, DeviceType(0x92U), 600);
    Hear(0x707U, {0U});
    Answer(7U, DeviceType(0x92U), 600);
    EXPECT_EQ(Order("start all"), "taken; started all the same: node 6: 5: SDO value differs (" + kOtherFound +
                                      "), node 7: 5: SDO value differs (" + kOtherFound + ")");
}

TEST_F(ManagerStartAnswerTest, EachOfSeveralThatAreLeftOutOrNotHeardIsNamed)
{
    Verifies(req::SRS_MGR_522);
    Verifies(req::SRS_MGR_080);
    Make("manager: {node: 127}\nslaves: [{node: 6, device_type: 0x191}, {node: 7, device_type: 0x191}, "
         "{node: 8, boot: false}, {node: 9, boot: false}]\n");
    Run(10U);
    for (const std::uint8_t node : {std::uint8_t{6U}, std::uint8_t{7U}})
    {
        Hear(0x700U + node, {0U});
        Answer(node, DeviceType(0x92U), 600);
    }
    EXPECT_EQ(Order("start all"), "taken but for node 6: C: device type differs (" + kOtherFound +
                                      "), node 7: C: device type differs (" + kOtherFound +
                                      "), expected that one, and boot NODE; nothing is heard of, so perhaps not "
                                      "started: node 8: done, node 9: done");
}

TEST_F(ManagerStartAnswerTest, ASlaveThatWasOperationalAlreadyHasNothingWrongWithIt)
{
    Verifies(req::SRS_MGR_522);
    // Given letter L of a slave that is kept alive, and that somebody else has put to PRE-OPERATIONAL since
    Make("manager: {node: 127}\nslaves: [{node: 6, device_type: 0x191, keep_alive: true, consumer: 300 ms}]\n");
    Run(2U);
    for (int beat = 0; beat < 6; ++beat)
    {
        Hear(0x706U, {0x05U});
        Answer(6U, DeviceType(0x91U), 50);
    }
    ASSERT_EQ(Row(6U).result, "L");
    Hear(0U, {0x80U, 6U});
    Hear(0x706U, {0x7FU});
    EXPECT_EQ(Order("start 6"), "taken");
}

TEST_F(ManagerStartAnswerTest, ASlaveThatIsBeingStartedUpIsNotNamed)
{
    Verifies(req::SRS_MGR_522);
    // Given another device that is started up anew by an order
    Make("manager: {node: 127}\nslaves: [{node: 6, device_type: 0x191, mandatory: false}]\n");
    Run(10U);
    Hear(0x706U, {0U});
    Answer(6U, DeviceType(0x92U), 600);
    ASSERT_EQ(Row(6U).result, "C");
    EXPECT_EQ(Order("boot 6"), "taken");
    Run(2U);
    EXPECT_EQ(Order("start 6").rfind("taken", 0U), 0U) << Order("start 6");
    EXPECT_EQ(Order("start 6").find("device type differs"), std::string::npos) << Order("start 6");
}

TEST_F(ManagerStartAnswerTest, UnderPlcDesignerALostSlaveIsStartedAndAnAbsentOneIsNot)
{
    Verifies(req::SRS_MGR_080);
    Verifies(req::SRS_MGR_522);
    Make("manager: {node: 127, profile: plc_designer}\n"
         "slaves: [{node: 6, device_type: 0x191, consumer: 300 ms}]\n");
    Run(1000U);
    Hear(0x706U, {0U});
    for (int beat = 0; beat < 7; ++beat)
    {
        Answer(6U, DeviceType(0x91U), 100);
        Hear(0x706U, {0x7FU});
    }
    Hear(0x706U, {0x05U});
    Run(2U);
    ASSERT_EQ(Row(6U).result, "5");
    EXPECT_EQ(Order("start all"), "taken");
    // When it is not heard any more
    Run(400U);
    ASSERT_EQ(Row(6U).result, "99");
    EXPECT_EQ(Order("start all"), "taken; nothing is heard of, so perhaps not started: node 6: 99: lost");
    EXPECT_EQ(Order("start 6").find("but"), std::string::npos) << Order("start 6");
    // When it boots anew, and is configured, then its state does not allow it
    Hear(0x706U, {0U});
    Run(2U);
    EXPECT_EQ(Order("start 6").rfind("not taken by node 6 (", 0U), 0U) << Order("start 6");
}

TEST_F(ManagerStartAnswerTest, ASafetySlaveThatIsAnotherDeviceIsNamedByEachStart)
{
    Verifies(req::SRS_MGR_136);
    Verifies(req::SRS_MGR_470);
    Verifies(req::SRS_MGR_522);
    Verifies(req::SRS_MGR_544);
    const std::string alone =
        "the start-up did not find the expected device at this node-ID, expected that one, and boot NODE";
    const std::pair<const char*, const char*> runs[] = {
        {"cia302", " (C: device type differs (0x1000:00 is 0x192, expected 0x191))"},
        {"el6751", " (5: SDO value differs (0x1000:00 is 0x192, expected 0x191))"},
        {"plc_designer", " (98: device type differs (0x1000:00 is 0x192, expected 0x191))"}};
    for (const auto& [profile, found] : runs)
    {
        // Given a safety slave that is another device, and another one that runs
        Make("manager: {node: 127, profile: " + std::string(profile) +
             "}\nslaves: [{node: 33, dcf: actuator.dcf, configure: false, device_type: 0x191}, {node: 6, device_type: "
             "0x191}]\n");
        Run(1000U);
        for (const std::uint8_t node : {std::uint8_t{33U}, std::uint8_t{6U}})
        {
            Hear(0x700U + node, {0U});
            Answer(node, DeviceType((node == 6U) ? 0x91U : 0x92U), 2000);
        }
        Hear(0x706U, {0x05U});
        Run(2U);
        const std::string all = "taken but for node 33: not known to be the expected device" + std::string(found) +
                                ", expected that one, and boot NODE";
        sent.clear();
        EXPECT_EQ(Order("start all"), all) << profile;
        EXPECT_EQ(Order("set 0x1F82:80 5"), all) << profile;
        EXPECT_EQ(Order("set 0x1F82:80 0x85"), all) << profile;
        EXPECT_EQ(Order("start 33"), alone) << profile;
        EXPECT_EQ(Order("set 0x1F82:21 5"), alone) << profile;
        Run(20U);
        const test::Lines commands = Commands();
        EXPECT_EQ(std::count(commands.begin(), commands.end(), "1 33"), 0) << profile;
    }
}

TEST_F(ManagerStartAnswerTest, ASafetySlaveOfWhichNothingIsKnownIsLeftOutWithoutAResult)
{
    Verifies(req::SRS_BOOT_343);
    Verifies(req::SRS_MGR_522);
    // Given a stop of all because of slave 6, which is lost, in the middle of the boot of a safety slave
    Make(
        "manager: {node: 127, start_up: 0x41}\n"
        "slaves: [{node: 33, dcf: actuator.dcf, mandatory: false}, {node: 6, device_type: 0x191, consumer: 300 ms}]\n");
    Run(10U);
    Hear(0x721U, {0U});
    Hear(0x706U, {0U});
    Answer(6U, DeviceType(0x91U), 20);
    Hear(0x706U, {0x7FU});
    Run(400U);
    ASSERT_EQ(station->Assembly().Core().MasterState(), 6);
    ASSERT_EQ(Row(33U).result, "");
    const std::string named =
        "taken but for node 33: not known to be the expected device, expected that one, and boot NODE";
    EXPECT_EQ(Order("start all").rfind(named, 0U), 0U) << Order("start all");
}

TEST_F(ManagerStartAnswerTest, ASlaveThatIsAskedAgainFirstIsNotStartedAllTheSame)
{
    Verifies(req::SRS_MGR_522);
    // Given another device that was started all the same
    Make("manager: {node: 127, profile: el6751}\n"
         "slaves: [{node: 6, device_type: 0x191, el6751: {restart: by_hand}}]\n");
    Run(10U);
    Hear(0x706U, {0U});
    Answer(6U, DeviceType(0x92U), 600);
    ASSERT_EQ(Row(6U).result, "5");
    EXPECT_EQ(Order("start 6").rfind("taken; started all the same: node 6: 5: SDO value differs", 0U), 0U);
    Run(2U);
    Hear(0x706U, {0x05U});
    Run(2U);
    // When it boots up unasked and waits for a hand, then its start asks who it is once more, behind a reset
    Hear(0x706U, {0U});
    Run(50U);
    Hear(0x706U, {0x7FU});
    sent.clear();
    EXPECT_EQ(Order("start 6"), "taken");
    Run(2U);
    EXPECT_EQ(Commands(), (test::Lines{"130 6"}));
}

TEST_F(ManagerStartAnswerTest, WhoDoesNotLeadDoubtsNobody)
{
    Verifies(req::SRS_MGR_472);
    Verifies(req::SRS_MGR_135);
    // Given a manager that waits for its negotiation, and two devices with the node-ID of a safety slave
    Make("manager: {node: 127, heartbeat: 200 ms, flying: {start: by_order}}\nslaves: [{node: 33, dcf: "
         "actuator.dcf}]\n");
    Run(2U);
    AnswerTwice(33U);
    EXPECT_EQ(Order("start 33"), "this manager is not the active master, expected the command at that one");
}

TEST_F(ManagerStartAnswerTest, ASlaveThatIsMissingIsNotHeard)
{
    Verifies(req::SRS_MGR_080);
    // Given a slave that is guarded from the beginning and answers nothing
    Make("manager: {node: 127}\nslaves: [{node: 7, boot: false, consumer: 300 ms, arming: immediately}]\n");
    Run(1000U);
    ASSERT_EQ(Row(7U).state, "missing");
    EXPECT_EQ(Order("start 7"), "taken; nothing is heard of, so perhaps not started: node 7: reset");
    EXPECT_EQ(Order("stop 7"), "taken");
}

TEST_F(ManagerStartAnswerTest, UnderPlcDesignerWhoIsNotHeardIsNamedByItsState)
{
    Verifies(req::SRS_MGR_080);
    // Given a slave that runs, and an optional one of which nothing is heard
    Make("manager: {node: 127, profile: plc_designer}\n"
         "slaves: [{node: 6, device_type: 0x191}, {node: 7, device_type: 0x191, mandatory: false}]\n");
    Run(2U);
    Hear(0x706U, {0U});
    Answer(6U, DeviceType(0x91U), 5000);
    Hear(0x706U, {0x05U});
    const std::string absent = "by node 7 (97: optional, absent), expected each in state 4, 5 or 99";
    EXPECT_EQ(Order("start all"), "taken, but not " + absent);
    EXPECT_EQ(Order("start 7"), "not taken " + absent);
    EXPECT_EQ(Order("start 6"), "taken");
}

TEST_F(ManagerStartAnswerTest, WhoWasStartedBeforeIsNotNamedAgain)
{
    Verifies(req::SRS_MGR_080);
    // Given two slaves of which nothing is heard
    Make("manager: {node: 127}\nslaves: [{node: 7, boot: false}, {node: 8, boot: false}]\n");
    Run(2000U);
    const std::string not_heard = "taken; nothing is heard of, so perhaps not started: node ";
    EXPECT_EQ(Order("start 7"), not_heard + "7: done");
    Run(10U);
    // When one was started, then a start names the other one alone, also one by 1F82h
    EXPECT_EQ(Order("start 7"), "taken");
    EXPECT_EQ(Order("start all"), not_heard + "8: done");
    Make("manager: {node: 127}\nslaves: [{node: 7, boot: false}, {node: 8, boot: false}]\n");
    Run(2000U);
    EXPECT_EQ(Order("set 0x1F82:07 5"), not_heard + "7: done");
    Run(10U);
    EXPECT_EQ(Order("set 0x1F82:80 5"), not_heard + "8: done");
}
} // namespace
} // namespace counterpoint::tools
