// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Slaves that were started and of which the expected heartbeat does not come.
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

#include <utility>

namespace counterpoint::tools
{
namespace
{
const std::vector<std::uint8_t> kType{0x43U, 0x00U, 0x10U, 0x00U, 0x91U, 0x01U, 0x00U, 0x00U};
const std::string kSilent = "no heartbeat since its start, expected one each 300 ms at least";

class ManagerUnheardTest : public test::ManagerRig
{
  protected:
    /// A mandatory slave 6 that boots up, answers 1000h and is started.
    void Start(const std::string& profile, const std::string& keys)
    {
        Make("manager: {node: 127, profile: " + profile + "}\nslaves: [{node: 6, device_type: 0x191" + keys + "}]\n");
        Run(1000U);
        Hear(0x706U, {0U});
        bool has_started = false;
        for (int ms = 0; ms < 2000 && !has_started; ++ms)
        {
            Answer(6U, kType, 1);
            has_started = has_started || station->Assembly().Core().Status(cia302::NodeId{6U}).is_started;
        }
        ASSERT_TRUE(has_started) << profile;
        Run(2U);
    }
    /// Slave 6 has 1000h alone.
    void AnswerEach(const int ms)
    {
        sent.clear();
        for (int i = 0; i < ms; ++i)
        {
            Run(1U);
            const std::vector<CanFrame> asked = std::exchange(sent, {});
            for (const CanFrame& frame : asked)
            {
                const bool is_type = std::equal(&frame.data[1], &frame.data[4], &kType[1]);
                if (frame.identifier == 0x606U && frame.data[0] == 0x40U)
                {
                    Hear(0x586U, is_type ? kType
                                         : std::vector<std::uint8_t>{0x80U, frame.data[1], frame.data[2], frame.data[3],
                                                                     0U, 0U, 2U, 6U});
                }
            }
        }
    }
    [[nodiscard]] bool IsGood()
    {
        const bool is_good = Row(6U).is_good;
        EXPECT_EQ(station->Assembly().HasStarted(), is_good);
        return is_good;
    }
};

TEST_F(ManagerUnheardTest, OneThatIsSilentSinceItsStartIsNotGoodUntilItsHeartbeatComes)
{
    Verifies(req::SRS_MGR_082);
    for (const char* const profile : {"el6751", "plc_designer"})
    {
        // Given a slave of which a heartbeat is expected, and that sends none: what it was told is not what it is
        Start(profile, ", consumer: 300 ms");
        EXPECT_FALSE(IsGood()) << profile;
        EXPECT_EQ(Row(6U).finding, "") << profile; // It may still come.
        Run(310U);
        EXPECT_FALSE(IsGood()) << profile;
        EXPECT_EQ(Row(6U).finding, kSilent) << profile;
        EXPECT_EQ(Row(6U).state, "pre-operational") << profile; // As last heard.
        Run(60000U);
        EXPECT_FALSE(IsGood()) << profile;
        EXPECT_EQ(Row(6U).finding, kSilent) << profile;
        // When it is heard after all
        Hear(0x706U, {0x05U});
        Run(2U);
        EXPECT_TRUE(IsGood()) << profile;
        EXPECT_EQ(Row(6U).finding, "") << profile;
    }
}

TEST_F(ManagerUnheardTest, OneThatWasHeardBeforeItsStartAloneIsNotGood)
{
    Verifies(req::SRS_MGR_082);
    for (const char* const profile : {"el6751", "plc_designer"})
    {
        // Given heartbeats until the start, and none behind it
        Make("manager: {node: 127, profile: " + std::string(profile) +
             "}\nslaves: [{node: 6, device_type: 0x191, consumer: 300 ms}]\n");
        Run(1000U);
        Hear(0x706U, {0U});
        for (int beat = 0; beat < 7; ++beat)
        {
            Answer(6U, kType, 100);
            if (!station->Assembly().Core().Status(cia302::NodeId{6U}).is_started)
            {
                Hear(0x706U, {0x7FU});
            }
        }
        ASSERT_TRUE(station->Assembly().Core().Status(cia302::NodeId{6U}).is_started) << profile;
        Run(200U);
        EXPECT_FALSE(IsGood()) << profile;
        Run(110U);
        EXPECT_FALSE(IsGood()) << profile;
        EXPECT_EQ(Row(6U).finding, kSilent) << profile;
    }
}

TEST_F(ManagerUnheardTest, OneThatDoesNotFollowItsStartSaysSo)
{
    Verifies(req::SRS_MGR_523);
    for (const char* const profile : {"cia302", "plc_designer"})
    {
        Start(profile, "");
        // One heartbeat may have been under way
        Hear(0x706U, {0x7FU});
        Run(2U);
        EXPECT_EQ(Row(6U).finding, "") << profile;
        Hear(0x706U, {0x7FU});
        Run(2U);
        EXPECT_FALSE(IsGood()) << profile;
        EXPECT_EQ(Row(6U).finding, "started, but says PRE-OPERATIONAL") << profile;
        const auto table = runtime::StatusJson(*station, now_us);
        EXPECT_EQ(table["slaves"][0]["finding"], "started, but says PRE-OPERATIONAL") << profile;
        Hear(0x706U, {0x04U});
        Run(2U);
        EXPECT_EQ(Row(6U).finding, "started, but says STOPPED") << profile;
        // When it runs after all
        Hear(0x706U, {0x05U});
        Run(2U);
        EXPECT_TRUE(IsGood()) << profile;
        EXPECT_EQ(Row(6U).finding, "") << profile;
        // When somebody else puts it elsewhere, then that is told before it speaks, and then what it says
        Hear(0x000U, {0x02U, 0x06U});
        EXPECT_FALSE(IsGood()) << profile;
        EXPECT_EQ(Row(6U).finding, "started, but told by somebody else to be STOPPED") << profile;
        Hear(0x000U, {0x80U, 0x06U});
        EXPECT_EQ(Row(6U).finding, "started, but told by somebody else to be PRE-OPERATIONAL") << profile;
        Hear(0x706U, {0x7FU});
        Run(2U);
        EXPECT_EQ(Row(6U).finding, "started, but says PRE-OPERATIONAL") << profile;
        // What this manager tells it is no finding
        EXPECT_EQ(Order("stop 6"), "taken") << profile;
        Hear(0x706U, {0x04U});
        EXPECT_EQ(Row(6U).finding.find("started"), std::string::npos) << Row(6U).finding;
    }
    // NodeState says it under el6751
    Start("el6751", "");
    Run(1100U);
    Hear(0x706U, {0x7FU});
    Run(2U);
    Hear(0x706U, {0x7FU});
    Run(2U);
    EXPECT_EQ(Row(6U).finding, "pre-operational");
}

TEST_F(ManagerUnheardTest, AStartThatWaitsIsNoFinding)
{
    Verifies(req::SRS_MGR_523);
    // Given a slave that was made PRE-OPERATIONAL, and whose start waits for the inhibit time
    Make("manager: {node: 127, inhibit: 50 ms}\nslaves: [{node: 6, boot: false}]\n");
    Run(200U);
    Hear(0x706U, {0U});
    EXPECT_EQ(Order("preop 6"), "taken");
    EXPECT_EQ(Order("start 6").rfind("taken", 0U), 0U);
    Hear(0x706U, {0x7FU});
    EXPECT_EQ(Row(6U).finding, "");
    Run(60U);
    Hear(0x706U, {0x7FU});
    EXPECT_EQ(Row(6U).finding, "");
    Hear(0x706U, {0x7FU});
    EXPECT_EQ(Row(6U).finding, "started, but says PRE-OPERATIONAL");
}

TEST_F(ManagerUnheardTest, AConsumerTimeIsHowLongItsStateIsKnownWhereItIsLonger)
{
    Verifies(req::SRS_MGR_081);
    // Given a standby, which supervises no slave: one with a consumer time of 3 s, and one of 300 ms
    Make("manager: {node: 127, heartbeat: 100 ms, flying: {priority: 1}}\nslaves: [{node: 6, consumer: 3 s}, {node: "
         "7, consumer: 300 ms}, {node: 5, boot: false, mandatory: false, consumer: 500 ms}]\n");
    sent.clear();
    for (int ms = 0; ms < 5000 && Count(0x073U) == 0U; ++ms)
    {
        Run(1U);
    }
    Hear(0x071U, {0U, 5U});
    Run(2U);
    ASSERT_FALSE(station->Assembly().Core().IsActive());
    Hear(0x706U, {0x05U});
    Hear(0x707U, {0x05U});
    const auto states = [this](const std::uint64_t ms)
    {
        for (std::uint64_t i = 0U; i < ms; ++i)
        {
            Hear(0x705U, {0x05U}); // The master is there.
            Run(1U);
        }
        return Row(6U).state + " " + Row(7U).state;
    };
    EXPECT_EQ(states(1000U), "operational operational");
    EXPECT_EQ(states(1U), "operational unknown");
    EXPECT_EQ(states(1999U), "operational unknown");
    EXPECT_EQ(states(1U), "unknown unknown");
}

TEST_F(ManagerUnheardTest, WhoIsMissingStaysSoAndWhoIsAskedIsWhatItSaid)
{
    Verifies(req::SRS_MGR_081);
    // Given a mandatory slave that was never there, and whose start-up has ended
    Make("manager: {node: 127, boot_time: 1 s}\nslaves: [{node: 6, device_type: 0x191}]\n");
    Run(10000U);
    ASSERT_EQ(Row(6U).result, "B");
    EXPECT_EQ(Row(6U).state, "missing");
    Run(60000U);
    EXPECT_EQ(Row(6U).state, "missing");
    // And one that boots up and is asked for 5 s, which is its start-up
    Make("manager: {node: 127, sdo_timeout: 5 s, sdo_tries: 1}\nslaves: [{node: 6, device_type: 0x191}]\n");
    Run(2U);
    Hear(0x706U, {0U});
    Run(4000U);
    ASSERT_EQ(Row(6U).step, "device type");
    EXPECT_EQ(Row(6U).state, "pre-operational");
}

TEST_F(ManagerUnheardTest, AStartBySomebodyElseIsNoHeartbeat)
{
    Verifies(req::SRS_MGR_082);
    Start("plc_designer", ", consumer: 300 ms");
    Hear(0x000U, {0x01U, 0x06U});
    Run(310U);
    EXPECT_FALSE(IsGood());
    EXPECT_EQ(Row(6U).finding, kSilent);
}

TEST_F(ManagerUnheardTest, OneOfWhichNoHeartbeatIsExpectedIsGoodByItsStart)
{
    Verifies(req::SRS_MGR_082);
    for (const char* const profile : {"cia302", "el6751", "plc_designer"})
    {
        Start(profile, "");
        Run(60000U);
        EXPECT_TRUE(IsGood()) << profile;
        EXPECT_EQ(Row(6U).finding, "") << profile;
    }
}

// Its heartbeat says OPERATIONAL, and it answers no SDO: nobody knows which device it is.
TEST_F(ManagerUnheardTest, OneWhoseStartUpHasNoEndIsNotGood)
{
    Verifies(req::SRS_MGR_131);
    Verifies(req::SRS_MGR_750);
    for (const char* const keys : {"", ", keep_alive: true", ", mandatory: true, arming: immediately"})
    {
        // Given one that is asked again and again, for nothing ends that without a boot time
        Make("manager: {node: 127}\nslaves: [{node: 6, device_type: 0x191, consumer: 300 ms" + std::string(keys) +
             "}]\n");
        for (int beat = 0; beat < 60; ++beat)
        {
            Hear(0x706U, {0x05U});
            Run(200U);
        }
        EXPECT_EQ(Row(6U).state, "operational") << keys;
        EXPECT_EQ(Row(6U).step, "device type") << keys;
        EXPECT_FALSE(IsGood()) << keys;
        // Also when somebody starts it
        EXPECT_EQ(Order("start 6"), "taken") << keys;
        Hear(0x706U, {0x05U});
        Run(2U);
        EXPECT_FALSE(IsGood()) << keys;
        // When it answers, then its start-up ends
        for (int beat = 0; beat < 20; ++beat)
        {
            Hear(0x706U, {0x05U});
            AnswerEach(200);
        }
        Run(2U);
        EXPECT_EQ(Row(6U).step, "done") << keys << Row(6U).finding;
        EXPECT_TRUE(IsGood()) << keys;
    }
}

// A stop of all by error handling gives up what runs; somebody starts the slave behind it.
TEST_F(ManagerUnheardTest, OneWhoseStartUpWasGivenUpIsNotGood)
{
    Verifies(req::SRS_MGR_750);
    Make("manager: {node: 127, start_up: 0x41}\nslaves: [{node: 6, consumer: 300 ms, device_type: 0x191}, {node: 7, "
         "consumer: 300 ms}]\n");
    Run(10U);
    Hear(0x707U, {0U});
    for (int beat = 0; beat < 20; ++beat)
    {
        Answer(7U, kType, 20);
        Hear(0x707U, {0x7FU});
    }
    ASSERT_EQ(Row(7U).step, "done");
    Hear(0x706U, {0U});
    Run(400U);
    ASSERT_EQ(station->Assembly().Core().MasterState(), 6); // All stopped.
    EXPECT_EQ(Order("start 6"), "taken");
    Hear(0x706U, {0x05U});
    Run(5U);
    EXPECT_EQ(Row(6U).state, "operational");
    EXPECT_EQ(Row(6U).result, "");
    EXPECT_FALSE(Row(6U).is_good);
}
} // namespace
} // namespace counterpoint::tools
