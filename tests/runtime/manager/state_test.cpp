// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// States of slaves and of the manager as they are shown: guarding, elections, commands that wait, counters that come
// round.
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{
using test::Lines;

const std::vector<std::uint8_t> kRightType{0x43U, 0x00U, 0x10U, 0x00U, 0x91U, 0x01U, 0x00U, 0x00U};

class ManagerStateTest : public test::ManagerRig
{
  protected:
    /// Texts of the events of this kind.
    [[nodiscard]] Lines Told(const std::string& kind) const
    {
        Lines told;
        for (const runtime::ManagerEvent& event : events)
        {
            if (event.kind == kind)
            {
                told.push_back(event.text);
            }
        }
        return told;
    }
    /// The manager asks for the active master, and this one answers.
    void AnswerElection(const std::uint8_t level)
    {
        sent.clear();
        for (int ms = 0; ms < 5000 && Count(0x073U) == 0U; ++ms)
        {
            Run(1U);
        }
        Hear(0x071U, {level, 5U});
        Run(2U);
    }
};

TEST_F(ManagerStateTest, AMissedGuardingAnswerIsForProgramsAndALostOneForPeople)
{
    Verifies(req::SRS_MGR_007);
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false, mandatory: false, guard_time: 100 ms, retry_factor: "
         "3}]\n");
    EndStartUp();
    EXPECT_EQ(Write(0x1F83U, 5U, 1U, 1U), 0U);
    events.clear();
    Run(1000U);
    const Lines missed = Told("guard_missed");
    ASSERT_FALSE(missed.empty());
    EXPECT_EQ(missed, Lines(missed.size(), ""));
    EXPECT_EQ(Told("guard_lost"), (Lines{"guard lost"}));
}

TEST_F(ManagerStateTest, AStandbyNamesItsMasterAndAMasterItself)
{
    Verifies(req::SRS_MGR_005);
    Make("manager: {node: 127, heartbeat: 100 ms, flying: {priority: 1}}\nslaves: [{node: 5, boot: false}]\n");
    Run(2U);
    EXPECT_EQ(runtime::ManagerLine(station->Assembly()),
              "manager, node 127: initialising, not the active master, profile cia302, idle");
    AnswerElection(0U);
    EXPECT_EQ(runtime::ManagerLine(station->Assembly()),
              "manager, node 127: pre-operational, not the active master (that is node 5), profile cia302, idle");
    EXPECT_EQ(Told("flying_master"), (Lines{"flying master: slave mode (priority 0, node 5)"}));
    Make("manager: {node: 127, heartbeat: 100 ms, flying: {priority: 1}}\nslaves: [{node: 5, boot: false}]\n");
    Run(30000U);
    const std::string line = runtime::ManagerLine(station->Assembly());
    EXPECT_NE(line.find(", active master, profile cia302, "), std::string::npos) << line;
}

TEST_F(ManagerStateTest, AWorseMasterIsForcedIntoANegotiation)
{
    Verifies(req::SRS_MGR_007);
    Make("manager: {node: 127, heartbeat: 100 ms, flying: {priority: 0}}\nslaves: [{node: 5, boot: false}]\n");
    AnswerElection(2U);
    const Lines told = Told("flying_master");
    ASSERT_FALSE(told.empty());
    EXPECT_EQ(told.front(), "flying master: force negotiation");
    events.clear();
    Make("manager: {node: 127, heartbeat: 100 ms, flying: {priority: 0}}\nslaves: [{node: 5, boot: false}]\n");
    Run(30000U);
    EXPECT_EQ(Told("flying_master"),
              (Lines{"flying master: power on reset", "flying master: master mode (priority 0, node 127)"}));
}

TEST_F(ManagerStateTest, ByOrderOnlyTheFirstNegotiationWaits)
{
    Verifies(req::SRS_MGR_023);
    Make("manager: {node: 127, heartbeat: 100 ms, flying: {priority: 1, start: by_order}}\nslaves: [{node: 5, boot: "
         "false}]\n");
    Run(3000U);
    EXPECT_EQ(sent.size(), 0U);
    EXPECT_EQ(Order("negotiate"), "taken");
    Run(30000U);
    ASSERT_TRUE(station->Assembly().Core().IsActive());
    // When it begins anew, then by itself
    EXPECT_EQ(Order("reset 127"), "taken");
    Run(30000U);
    EXPECT_TRUE(station->Assembly().Core().IsActive());
    EXPECT_EQ(Order("negotiate"), "no negotiation waits for an order, expected flying: {start: by_order}");
}

TEST_F(ManagerStateTest, AStartOfAllThatWaitsIsNoFinding)
{
    Verifies(req::SRS_MGR_523);
    // Given a slave that was started and says PRE-OPERATIONAL, and a start of all that waits for the inhibit time
    Make("manager: {node: 127, inhibit: 50 ms, start_up: 9}\nslaves: [{node: 6, boot: false, mandatory: false}]\n");
    Run(200U);
    Hear(0x706U, {0U});
    Run(100U);
    EXPECT_EQ(Order("start 6").rfind("taken", 0U), 0U);
    Run(100U);
    for (int beat = 0; beat < 3; ++beat)
    {
        Hear(0x706U, {0x7FU});
        Run(100U);
    }
    ASSERT_EQ(Row(6U).finding, "started, but says PRE-OPERATIONAL");
    sent.clear();
    EXPECT_EQ(Order("preop 6"), "taken");
    EXPECT_EQ(Order("start all").rfind("taken", 0U), 0U);
    ASSERT_EQ(Commands(), (Lines{"128 6"}));
    EXPECT_EQ(Row(6U).finding, "");
    Run(100U);
    EXPECT_EQ(Commands(), (Lines{"128 6", "1 0"}));
}

TEST_F(ManagerStateTest, SilenceIsToldWhateverTheCounterOfTheSupervisionSays)
{
    Verifies(req::SRS_MGR_082);
    Make("manager: {node: 127, profile: el6751}\nslaves: [{node: 6, device_type: 0x191, consumer: 300 ms}]\n");
    Run(1000U);
    Hear(0x706U, {0U});
    Answer(6U, kRightType, 2000);
    ASSERT_TRUE(station->Assembly().Core().Status(cia302::NodeId{6U}).is_started);
    const std::uint64_t since_us = station->Assembly().Core().Table().Record(cia302::NodeId{6U}).since.us;
    // Given 2^32 us and 100 ms since its supervision began, of which the counter says 100 ms
    const std::uint64_t end_us = since_us + 0x100000000U + 100000U;
    while (now_us + 60'000'000U < end_us)
    {
        now_us += 60'000'000U;
        station->OnCycle(now_us);
    }
    now_us = end_us;
    station->OnCycle(now_us);
    EXPECT_EQ(Row(6U).finding, "no heartbeat since its start, expected one each 300 ms at least");
}

TEST_F(ManagerStateTest, WhatIsWithdrawnDoesNotWaitToBeSent)
{
    Verifies(req::SRS_MGR_520);
    // Given a start that waits for the inhibit time, and a boot of the same slave
    Make("manager: {node: 127, inhibit: 6 s}\nslaves: [{node: 5, boot: false, mandatory: false}]\n");
    EndStartUp();
    EXPECT_EQ(Order("preop 5"), "taken");
    EXPECT_EQ(Order("start 5").rfind("taken", 0U), 0U);
    ASSERT_EQ(station->Unsent(), (Lines{"preop node 5", "start node 5"}));
    EXPECT_EQ(Order("boot 5"), "taken");
    const Lines unsent = station->Unsent();
    EXPECT_EQ(std::count(unsent.begin(), unsent.end(), "start node 5"), 0);
    EXPECT_EQ(std::count(unsent.begin(), unsent.end(), "preop node 5"), 1);
}

TEST_F(ManagerStateTest, AConsumerTimeCountsAtOnceForASlaveThatWasStarted)
{
    Verifies(req::SRS_MGR_222);
    // Given a slave without a consumer time that was started by an order
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false, mandatory: false}]\n");
    EndStartUp();
    EXPECT_EQ(Order("start 5"), "taken");
    Run(2U);
    Hear(0x705U, {0x05U});
    Run(1000U);
    EXPECT_EQ(Told("heartbeat_lost"), Lines{});
    // A time without a node, and a node without a time, are nothing to be watched by
    EXPECT_EQ(Write(0x1016U, 1U, 300U, 4U), 0U);
    EXPECT_EQ(Write(0x1016U, 1U, 5U << 16U, 4U), 0U);
    EXPECT_EQ(Write(0x1016U, 1U, (5U << 16U) | 300U, 4U), 0U);
    EXPECT_EQ(Write(0x1016U, 1U, (5U << 16U) | 300U, 4U), 0U); // As it is.
    Hear(0x705U, {0x05U});
    Run(290U);
    EXPECT_EQ(Told("heartbeat_lost"), Lines{});
    Run(20U);
    EXPECT_EQ(Told("heartbeat_lost"), (Lines{"heartbeat lost"}));
}

TEST_F(ManagerStateTest, AConsumerTimeOfASlaveThatWasNotStartedCountsFromItsStartUpOn)
{
    Verifies(req::SRS_MGR_222);
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false, mandatory: false}]\n");
    EndStartUp();
    EXPECT_EQ(Write(0x1016U, 1U, (5U << 16U) | 300U, 4U), 0U);
    Hear(0x705U, {0x7FU});
    Run(1000U);
    EXPECT_EQ(Told("heartbeat_lost"), Lines{});
    EXPECT_EQ(Order("boot 5"), "taken");
    Run(2U);
    Hear(0x705U, {0x7FU});
    Run(290U);
    EXPECT_EQ(Told("heartbeat_lost"), Lines{});
    Run(20U);
    EXPECT_EQ(Told("heartbeat_lost"), (Lines{"heartbeat lost"}));
}

TEST_F(ManagerStateTest, AConsumerTimeCountsAtOnceForASlaveThatIsWatchedAndWasNeverStarted)
{
    Verifies(req::SRS_MGR_222);
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false, mandatory: false, consumer: 300 ms}]\n");
    EndStartUp();
    ASSERT_FALSE(station->Assembly().Core().Status(cia302::NodeId{5U}).is_started);
    EXPECT_EQ(Write(0x1016U, 1U, (5U << 16U) | 600U, 4U), 0U);
    Hear(0x705U, {0x7FU});
    Run(590U);
    EXPECT_EQ(Told("heartbeat_lost"), Lines{});
    Run(20U);
    EXPECT_EQ(Told("heartbeat_lost"), (Lines{"heartbeat lost"}));
}

TEST_F(ManagerStateTest, AConsumerTimeOfASlaveThatWasHeldSinceItsStartCountsFromItsStartUpOn)
{
    Verifies(req::SRS_MGR_222);
    // Given a slave without a consumer time that was started, and is not any more
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false, mandatory: false}]\n");
    EndStartUp();
    EXPECT_EQ(Order("start 5"), "taken");
    Run(100U);
    EXPECT_EQ(Order("preop 5"), "taken");
    Run(100U);
    EXPECT_EQ(Write(0x1016U, 1U, (5U << 16U) | 300U, 4U), 0U);
    Hear(0x705U, {0x7FU});
    Run(1000U);
    EXPECT_EQ(Told("heartbeat_lost"), Lines{});
    // When it is started up
    EXPECT_EQ(Order("boot 5"), "taken");
    Run(2U);
    Hear(0x705U, {0x7FU});
    Run(310U);
    EXPECT_EQ(Told("heartbeat_lost"), (Lines{"heartbeat lost"}));
}

TEST_F(ManagerStateTest, AnEntryThatGoesToAnotherNodeLeavesTheOneBefore)
{
    Verifies(req::SRS_MGR_222);
    // Given a slave that was not started yet, and whose entry goes to a node that is none
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false, mandatory: false, consumer: 300 ms}]\n");
    EndStartUp();
    EXPECT_EQ(Write(0x1016U, 1U, (9U << 16U) | 300U, 4U), 0U);
    EXPECT_EQ(Read(0x1016U, 1U), (9U << 16U) | 300U);
    EXPECT_EQ(net->Setup().Slave(cia302::NodeId{5U}).heartbeat.consumer_ms, 0U);
    events.clear();
    // When neither sends another heartbeat, then the one is lost, and nobody waits for the other one
    Hear(0x705U, {0x7FU});
    Hear(0x709U, {0x7FU});
    Run(400U);
    std::vector<int> lost;
    for (const runtime::ManagerEvent& event : events)
    {
        if (event.kind == "heartbeat_lost")
        {
            lost.push_back(event.node);
        }
    }
    EXPECT_EQ(lost, (std::vector<int>{9}));
}

TEST_F(ManagerStateTest, WhoIsAwaitedMayBeChangedAndWhoIsAskedMayNot)
{
    Verifies(req::SRS_MGR_215);
    // Given a slave whose boot-up message is awaited
    Make("manager: {node: 127}\nslaves: [{node: 6, device_type: 0x191, mandatory: false}]\n");
    Run(6000U);
    ASSERT_EQ(Row(6U).step, "wait for boot-up");
    EXPECT_EQ(Write(0x1F88U, 6U, 7U, 4U), 0U);
    // And one that is asked who it is under another profile
    Make("manager: {node: 127, profile: el6751}\nslaves: [{node: 6, device_type: 0x191, mandatory: false}]\n");
    Run(10U);
    Hear(0x706U, {0U});
    Run(5U);
    ASSERT_EQ(Row(6U).step, "device type");
    EXPECT_EQ(Write(0x1F88U, 6U, 7U, 4U), 0x08000022U);
}

TEST_F(ManagerStateTest, AMasterThatIsLostIsMissingThoughNobodySupervisesIt)
{
    Verifies(req::SRS_MGR_473);
    Make("manager: {node: 127, heartbeat: 100 ms, flying: {priority: 1}}\nslaves: [{node: 5, boot: false}]\n");
    AnswerElection(0U);
    Hear(0x705U, {0x05U});
    EXPECT_EQ(Row(5U).state, "operational");
    for (int ms = 0; ms < 5000 && Told("heartbeat_lost").empty(); ++ms)
    {
        Run(1U);
    }
    EXPECT_EQ(Told("heartbeat_lost").size(), 1U);
    EXPECT_EQ(Row(5U).state, "missing");
}

TEST_F(ManagerStateTest, TimesOfItsSdosAreThoseOfTheNetworkFile)
{
    Verifies(req::SRS_NET_002);
    // Given two tries of 100 ms
    Make("manager: {node: 127, sdo_timeout: 100 ms, sdo_tries: 2}\nslaves: [{node: 6, device_type: 0x191}]\n");
    Run(10U);
    sent.clear();
    Hear(0x706U, {0U});
    Run(2U);
    ASSERT_EQ(Count(0x606U), 1U);
    Run(95U);
    EXPECT_EQ(Count(0x606U), 1U);
    Run(10U);
    const auto asked =
        static_cast<std::size_t>(std::count_if(sent.begin(), sent.end(), [](const CanFrame& frame)
                                               { return frame.identifier == 0x606U && frame.data[0] == 0x40U; }));
    EXPECT_EQ(asked, 2U);
    Run(90U);
    EXPECT_EQ(Row(6U).finding, "");
    Run(15U);
    EXPECT_EQ(Row(6U).finding, "asked again each second: 0x1000:00: 0x05040000 (no answer)");
}

TEST_F(ManagerStateTest, OtherGuardingTimesCountAtOnceForASlaveThatWasStarted)
{
    Verifies(req::SRS_MGR_220);
    // Given a slave that was started by an order and that nobody watches
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false, mandatory: false}]\n");
    EndStartUp();
    // Before its start they do not
    EXPECT_EQ(Write(0x1F81U, 5U, 0x00630301U, 4U), 0U);
    EXPECT_EQ(Read(0x1F83U, 5U), 0U);
    EXPECT_EQ(Write(0x1F81U, 5U, 0x01U, 4U), 0U);
    EXPECT_EQ(Order("start 5"), "taken");
    Run(2U);
    EXPECT_EQ(Read(0x1F83U, 5U), 0U);
    // Bits below the times change nothing of its supervision
    EXPECT_EQ(Write(0x1F81U, 5U, 0x09U, 4U), 0U);
    EXPECT_EQ(Read(0x1F83U, 5U), 0U);
    EXPECT_EQ(Write(0x1F81U, 5U, 0x00640301U, 4U), 0U);
    EXPECT_EQ(Read(0x1F83U, 5U), 1U);
    EXPECT_EQ(Write(0x1F81U, 5U, 0x00640401U, 4U), 0U);
    EXPECT_EQ(Read(0x1F83U, 5U), 1U);
    EXPECT_EQ(Write(0x1F81U, 5U, 0x00000401U, 4U), 0x06090030U);
}

TEST_F(ManagerStateTest, ACommandByAnObjectThatFindsNoRoomSaysSo)
{
    Verifies(req::SRS_MGR_135);
    Verifies(req::SRS_MGR_141);
    Make("manager: {node: 127, inhibit: 6 s}\nslaves: [{node: 5, boot: false, mandatory: false}]\n");
    EndStartUp();
    std::string answer = "taken";
    for (int order = 0; order < 400 && answer == "taken"; ++order)
    {
        answer = Order((order % 2 == 0) ? "set 0x1F82:05 127" : "set 0x1F82:05 6");
    }
    EXPECT_NE(answer.find(", expected it later: too many commands wait"), std::string::npos) << answer;
    EXPECT_EQ(Order("get 0x1F82:00"), "0x1F82:00 = 128 (0x80)");
    EXPECT_EQ(Order("set 0x1F80:00 0x81"),
              "0x1F80:00 = 129: 0x06090030 (value out of range), expected another value, or another node");
    EXPECT_EQ(Order("set 0x1F88:09 1"),
              "0x1F88:09 (node 9) = 1: 0x08000022 (not in this state), expected it in another state: "
              "docs/manager.md has the rules");
    EXPECT_EQ(Order("output 5 1 01"), "RxPDO 1 of node 5, expected a slave of a network with the profile el6751");
}

TEST_F(ManagerStateTest, AnObjectOfItsDcfWithoutAValueIsNone)
{
    Verifies(req::SRS_MGR_150);
    // Given a DCF of the manager whose name of the device has no value
    static_cast<void>(File("manager.dcf", cia306::test::Changed(cia306::test::ExampleText("controller"),
                                                                {{"NodeID=2\n", "NodeID=127\n"}}) +
                                              "\n[1008]\nParameterName=A name\nObjectType=0x7\nDataType=0x0009\n"
                                              "AccessType=const\nPDOMapping=0\n"));
    Make("manager: {node: 127, dcf: manager.dcf}\nslaves: [{node: 5}]\n");
    Run(2U);
    EXPECT_EQ(Read(0x1008U, 0U), 0x06020000U);
    EXPECT_EQ(Read(0x1018U, 2U), 2U);
}
} // namespace
} // namespace counterpoint::tools
