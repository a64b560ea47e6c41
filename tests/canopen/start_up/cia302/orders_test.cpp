// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A stop, or an enter pre-operational, in the middle of a start-up: the later order counts.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

namespace counterpoint::cia302
{
namespace
{

using cia301::NodeState;
using Lines = std::vector<std::string>;

class BootOrdersTest : public BootRig
{
  public:
    NmtAnswer Command(const NmtCommand command, const std::uint8_t node)
    {
        const NmtAnswer answer = start_up.Command(command, NodeId{node}, Now());
        Deliver();
        return answer;
    }
    [[nodiscard]] NodeState StateOf(const std::uint8_t node)
    {
        return slaves.at(node)->State();
    }
    /// Commands without their times.
    [[nodiscard]] Lines Sent() const
    {
        Lines lines{};
        for (const std::string& line : Commands())
        {
            lines.push_back(line.substr(line.find(':') + 1U));
        }
        return lines;
    }
    /// "letter step started".
    [[nodiscard]] std::string Status(const std::uint8_t node) const
    {
        const NodeStatus status = Of(node);
        const char letter = (status.letter == '\0') ? '-' : status.letter;
        return std::string(1U, letter) + " " + std::to_string(static_cast<int>(status.step)) + " " +
               (status.is_started ? "started" : "not started") + (status.is_busy ? " busy" : "");
    }
};

const std::string kHeld = "- 26 not started"; // Step "by hand".

TEST_F(BootOrdersTest, AStopWhileItsStartWaitsForTheQueueHolds)
{
    Verifies(req::SRS_BOOT_030);
    for (const NmtCommand command : {NmtCommand::kStop, NmtCommand::kPreOperational})
    {
        Add(5U, kMust);
        Protect(5U);
        gate.cycles = 5;
        Begin();
        Run(2U);
        for (int i = 0; i < 20; ++i)
        {
            FillQueue();
            Run(1U);
        }
        ASSERT_EQ(Status(5U), "- 16 not started busy");
        gate.Close(NodeId{5U});
        EXPECT_EQ(Command(command, 5U), NmtAnswer::kTaken);
        Run(1000U);
        const bool is_stop = (command == NmtCommand::kStop);
        EXPECT_EQ(StateOf(5U), is_stop ? NodeState::kStopped : NodeState::kPreOperational);
        EXPECT_EQ(Status(5U), kHeld);
        EXPECT_EQ(Step(), MasterStep::kOperational); // It was booted.
        // Until somebody orders its start
        EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
        Run(100U);
        EXPECT_EQ(StateOf(5U), NodeState::kOperational);
        EXPECT_EQ(Status(5U), "- 17 started");
        start_up.End();
    }
}

TEST_F(BootOrdersTest, APreOperationalInAnyStepHolds)
{
    Verifies(req::SRS_BOOT_030);
    // Given a safety slave whose start-up takes from 0 ms to 33 ms, and an order in each of them
    for (std::uint32_t at_ms = 0U; at_ms < 30U; ++at_ms)
    {
        Add(5U, kMust).boot_ms = 10U;
        Protect(5U);
        gate.cycles = 20;
        Begin();
        Run(at_ms);
        ASSERT_TRUE(Of(5U).is_busy) << at_ms;
        EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
        Run(2000U);
        EXPECT_EQ(Sent(), (Lines{"82 00", "80 05"})) << at_ms;
        EXPECT_EQ(Status(5U), kHeld) << at_ms;
        start_up.End();
    }
}

TEST_F(BootOrdersTest, AStopWhileItIsAskedWhoItIsIsNotUndone)
{
    Verifies(req::SRS_BOOT_030);
    Verifies(req::SRS_BOOT_004);
    // Given one that is told to stop before it is asked at all: its boot-up message is not heard
    Add(5U, kMust).has_boot_up = false;
    Begin();
    Run(500U);
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(5000U);
    EXPECT_EQ(Sent(), (Lines{"82 00", "02 05"}));
    EXPECT_EQ(Status(5U), "- 3 not started busy");
    // Then it is asked, and made PRE-OPERATIONAL for that, when its boot is ordered
    EXPECT_TRUE(start_up.Boot(NodeId{5U}, Now()));
    Run(10U);
    EXPECT_EQ(Sent(), (Lines{"82 00", "02 05", "80 05", "01 05"}));
    EXPECT_EQ(Status(5U), "- 17 started");
}

TEST_F(BootOrdersTest, AStopDuringAStartByOrderHolds)
{
    Verifies(req::SRS_BOOT_030);
    Add(5U, kMust);
    Protect(5U);
    gate.cycles = 20;
    Begin();
    Run(50U);
    ASSERT_EQ(Status(5U), "- 17 started");
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(10U);
    ASSERT_TRUE(Of(5U).is_busy);
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    Run(500U);
    EXPECT_EQ(StateOf(5U), NodeState::kPreOperational);
    EXPECT_FALSE(Of(5U).is_started);
}

TEST_F(BootOrdersTest, OneThatIsHeldIsLeftOutOfTheStartOfAll)
{
    Verifies(req::SRS_BOOT_030);
    // Given a start of all by 1F80h bit 1 that waits for slave 6, and an order to slave 5, booted before
    setup.start_up = kIsMaster | kStartAllAtOnce;
    Add(5U, kMust);
    Add(6U, kMust).boot_ms = 50U;
    Begin();
    Run(20U);
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(500U);
    EXPECT_EQ(Sent(), (Lines{"82 00", "02 05", "01 06"}));
    EXPECT_EQ(Step(), MasterStep::kOperational);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    // Also where it is listed and not to be booted
    start_up.End();
    Add(5U, kInNetwork);
    Add(6U, kMust).boot_ms = 50U;
    Begin();
    Run(20U);
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(500U);
    EXPECT_EQ(Sent(), (Lines{"82 00", "02 05", "01 06"}));
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
}

TEST_F(BootOrdersTest, AStopOfAllHoldsTheMasterToo)
{
    Verifies(req::SRS_BOOT_030);
    Verifies(req::SRS_BOOT_031);
    // Given a start-up that waits for a slave
    for (const bool is_at_once : {false, true})
    {
        setup.start_up = is_at_once ? (kIsMaster | kStartAllAtOnce) : kIsMaster;
        Add(5U, kMust).boot_ms = 50U;
        Begin();
        own.clear();
        Run(20U);
        EXPECT_EQ(Command(NmtCommand::kPreOperational, 0U), NmtAnswer::kTaken);
        Run(500U);
        // Then it ends, and neither slave nor master was started
        EXPECT_EQ(Sent(), (Lines{"82 00", "80 00"}));
        EXPECT_EQ(Status(5U), kHeld);
        EXPECT_EQ(Step(), MasterStep::kReady);
        // Until a start of all
        EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
        EXPECT_EQ(Sent(), (Lines{"82 00", "80 00", "01 00"}));
        EXPECT_EQ(Status(5U), "- 17 started");
        EXPECT_EQ(Step(), MasterStep::kOperational);
        start_up.End();
    }
}

TEST_F(BootOrdersTest, AStopOfTheOwnNodeHoldsTheMasterAlone)
{
    Verifies(req::SRS_BOOT_031);
    Add(5U, kMust).boot_ms = 50U;
    Begin();
    Run(20U);
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 127U), NmtAnswer::kTaken);
    Run(500U);
    EXPECT_EQ(Status(5U), "- 17 started");
    EXPECT_EQ(Step(), MasterStep::kReady);
    EXPECT_EQ(Command(NmtCommand::kStart, 127U), NmtAnswer::kTaken);
    EXPECT_EQ(Step(), MasterStep::kOperational);
    // And not the next start-up of all
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 127U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kResetNode, 0U), NmtAnswer::kTaken);
    Run(500U);
    EXPECT_EQ(Step(), MasterStep::kOperational);
}

TEST_F(BootOrdersTest, WhoBecomesTheActiveMasterIsHeldByNoOrderOfBefore)
{
    Verifies(req::SRS_BOOT_031);
    // Given a master that an order holds
    Add(5U, kMust).boot_ms = 50U;
    Begin();
    Run(20U);
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 127U), NmtAnswer::kTaken);
    Run(500U);
    ASSERT_EQ(Step(), MasterStep::kReady);
    // When it leads no more, and leads again
    start_up.End();
    Begin();
    Run(500U);
    // Then it starts itself
    EXPECT_EQ(Step(), MasterStep::kOperational);
}

TEST_F(BootOrdersTest, TheStartOfTheMasterWaitsForTheQueue)
{
    Verifies(req::SRS_BOOT_015);
    Verifies(req::SRS_BOOT_031);
    for (const bool is_held : {false, true})
    {
        // Given a queue that is full while the last mandatory slave is booted
        Add(5U, kMust);
        Protect(5U);
        gate.cycles = 5;
        setup.start_up = kIsMaster | kApplicationStartsSlaves;
        Begin();
        Run(2U);
        for (int i = 0; i < 20; ++i)
        {
            FillQueue();
            Run(1U);
        }
        FillQueue();
        ASSERT_EQ(Status(5U), "- 17 not started");
        ASSERT_EQ(Step(), MasterStep::kReady);
        // When there is room, it is started then, unless an order comes before
        nmt.OnCycle(Instant{Now().us + 1000U});
        EXPECT_EQ(is_held ? Command(NmtCommand::kPreOperational, 127U) : NmtAnswer::kTaken, NmtAnswer::kTaken);
        Run(1000U);
        EXPECT_EQ(Step(), is_held ? MasterStep::kReady : MasterStep::kOperational);
        start_up.End();
    }
}

TEST_F(BootOrdersTest, AnOrderWhileTheResetsWaitHolds)
{
    Verifies(req::SRS_BOOT_033);
    Add(5U, kMust);
    PowerAll();
    Run(10U);
    FillQueue(100U);
    is_begun = true;
    start_up.Begin(Now());
    Run(5U);
    ASSERT_EQ(Step(), MasterStep::kReset);
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    // Its stop leaves 1 ms behind the reset, before it has booted up
    Run(2000U);
    EXPECT_FALSE(Of(5U).is_started);
    EXPECT_NE(StateOf(5U), NodeState::kOperational);
}

TEST_F(BootOrdersTest, TheHoldEndsWithABootOrAResetByOrder)
{
    Verifies(req::SRS_BOOT_032);
    Add(5U, kMust);
    Protect(5U);
    gate.cycles = 20;
    const auto hold = [this]
    {
        EXPECT_TRUE(start_up.Boot(NodeId{5U}, Now()));
        Run(10U);
        EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
        Run(100U);
        EXPECT_EQ(Status(5U), kHeld);
    };
    Begin();
    Run(100U);
    hold();
    EXPECT_TRUE(start_up.Boot(NodeId{5U}, Now()));
    Run(100U);
    EXPECT_EQ(Status(5U), "- 17 started");
    // A reset of either kind, alone or with all
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{0U}})
    {
        for (const NmtCommand reset : {NmtCommand::kResetNode, NmtCommand::kResetCommunication})
        {
            hold();
            EXPECT_EQ(Command(reset, node), NmtAnswer::kTaken);
            Run(100U);
            EXPECT_EQ(Status(5U), "- 17 started") << int{node} << " " << static_cast<int>(reset);
        }
    }
    hold();
    start_up.Begin(Now()); // The manager is the active master anew.
    Run(100U);
    EXPECT_EQ(Status(5U), "- 17 started");
}

TEST_F(BootOrdersTest, TheHoldEndsWithAStartThatIsTaken)
{
    Verifies(req::SRS_BOOT_032);
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{0U}})
    {
        // Given a slave that an order holds, and a start of it, alone or with all, for which the queue has no room
        Add(5U, kMust).boot_ms = 50U;
        Begin();
        Run(20U);
        EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
        Run(500U);
        ASSERT_EQ(Status(5U), kHeld);
        FillQueue();
        EXPECT_EQ(Command(NmtCommand::kStart, node), NmtAnswer::kQueueFull);
        Run(1000U);
        // Then it is held on
        EXPECT_EQ(Status(5U), kHeld) << int{node};
        EXPECT_EQ(StateOf(5U), NodeState::kPreOperational);
        // When it is taken, then it runs
        EXPECT_EQ(Command(NmtCommand::kStart, node), NmtAnswer::kTaken);
        Run(50U);
        EXPECT_EQ(Status(5U), "- 17 started") << int{node};
        EXPECT_EQ(StateOf(5U), NodeState::kOperational);
        start_up.End();
    }
}

TEST_F(BootOrdersTest, ABootUpMessageEndsNoHoldHoweverLateItIs)
{
    Verifies(req::SRS_BOOT_033);
    for (const std::uint32_t assignment : {kMust, kBoot})
    {
        for (const std::uint32_t boot_ms : {300U, 999U, 1000U, 1001U, 1200U, 3000U})
        {
            for (const NmtCommand command : {NmtCommand::kStop, NmtCommand::kPreOperational})
            {
                // Given a slave that needs so long from its reset on, and hears no command before
                Add(5U, assignment).boot_ms = boot_ms;
                Protect(5U);
                Begin();
                Run(200U);
                EXPECT_EQ(Command(command, 5U), NmtAnswer::kTaken);
                Run(6000U);
                EXPECT_EQ(Status(5U), kHeld) << boot_ms;
                EXPECT_EQ(StateOf(5U), NodeState::kPreOperational) << boot_ms;
                start_up.End();
            }
        }
    }
}

TEST_F(BootOrdersTest, ABootUpMessageInFrontOfTheQueuedResetEndsNoHold)
{
    Verifies(req::SRS_BOOT_033);
    // Given a slave that was just switched on, and whose reset by order, or by the loss of another one, waits
    Add(5U, kMust);
    Begin();
    Run(100U);
    ASSERT_EQ(Status(5U), "- 17 started");
    FillQueue(100U);
    EXPECT_EQ(Command(NmtCommand::kResetCommunication, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(1U);
    ToManager(CanFrame{0x705U, FrameKind::kData, CanPortId::kFirst, 1U, {0U}});
    Run(3000U);
    EXPECT_EQ(Status(5U), kHeld);
    EXPECT_NE(StateOf(5U), NodeState::kOperational);
}

TEST_F(BootOrdersTest, AStopThatOvertookTheBootUpMessageIsNotUndone)
{
    Verifies(req::SRS_BOOT_030);
    Verifies(req::SRS_BOOT_033);
    Add(5U, kMust);
    Begin();
    Run(100U);
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(10U);
    // When the boot-up message is heard behind the stop that the slave obeyed, as its heartbeat says
    ToManager(CanFrame{0x705U, FrameKind::kData, CanPortId::kFirst, 1U, {0U}});
    Run(10U);
    ToManager(CanFrame{0x705U, FrameKind::kData, CanPortId::kFirst, 1U, {4U}});
    Run(5000U);
    // Then it is asked, and not made PRE-OPERATIONAL for that
    EXPECT_EQ(Sent(), (Lines{"82 00", "01 05", "02 05"}));
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(Status(5U), "- 3 not started busy");
}

TEST_F(BootOrdersTest, ARestartOrALossOfTheSlaveEndsNoHold)
{
    Verifies(req::SRS_BOOT_033);
    for (const bool is_lost : {false, true})
    {
        Add(5U, kMust).heartbeat_ms = 50U;
        setups[5].heartbeat = HeartbeatSetup{150U, 50U, Arming::kFirstHeartbeat};
        Begin();
        Run(200U);
        EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
        Run(100U);
        slaves[5]->Unplug();
        Run(is_lost ? 300U : 10U);
        slaves[5]->Power(Now());
        Run(500U);
        EXPECT_EQ(StateOf(5U), NodeState::kPreOperational);
        EXPECT_EQ(Status(5U), kHeld);
        start_up.End();
    }
}

TEST_F(BootOrdersTest, AResetOfAllBecauseOfAnotherSlaveEndsNoHold)
{
    Verifies(req::SRS_BOOT_031);
    Verifies(req::SRS_BOOT_033);
    // Given two slaves, and that the loss of 6 resets all (1F80h bit 4)
    for (const bool is_all : {false, true})
    {
        setup.start_up = kIsMaster | kResetAllOnError;
        Add(5U, kMust);
        Add(6U, kMust).heartbeat_ms = 50U;
        setups[6].heartbeat = HeartbeatSetup{150U, 50U, Arming::kFirstHeartbeat};
        Begin();
        Run(200U);
        ASSERT_EQ(Step(), MasterStep::kOperational);
        // When 5 alone, or all, was told to stop, and 6 disappears and comes back
        EXPECT_EQ(Command(NmtCommand::kStop, is_all ? std::uint8_t{0U} : std::uint8_t{5U}), NmtAnswer::kTaken);
        Run(100U);
        slaves[6]->Unplug();
        Run(300U);
        slaves[6]->Power(Now());
        Run(2000U);
        // Then all were reset, and who was told to stop is not started
        EXPECT_EQ(StateOf(5U), NodeState::kPreOperational);
        EXPECT_EQ(Status(5U), kHeld);
        EXPECT_EQ(StateOf(6U), is_all ? NodeState::kPreOperational : NodeState::kOperational);
        EXPECT_EQ(Step(), is_all ? MasterStep::kReady : MasterStep::kOperational);
        start_up.End();
    }
}

TEST_F(BootOrdersTest, TheBusThatIsBackAndAWritingLeaveItHeld)
{
    Verifies(req::SRS_BOOT_033);
    Add(5U, kMust);
    Protect(5U);
    gate.cycles = 20;
    Begin();
    Run(10U);
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    start_up.OnBusBack(Now());
    Deliver();
    EXPECT_EQ(Status(5U), "- 15 not started busy");
    EXPECT_EQ(gate.verifications, 2); // It begins anew, and goes on.
    Run(100U);
    EXPECT_EQ(Status(5U), kHeld);
    EXPECT_TRUE(start_up.Resume(NodeId{5U}, Now()));
    Run(100U);
    EXPECT_EQ(Status(5U), kHeld);
    // A STOPPED one is not made PRE-OPERATIONAL for it either
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    EXPECT_TRUE(start_up.Resume(NodeId{5U}, Now()));
    start_up.OnBusBack(Now());
    Run(2000U);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(Sent(), (Lines{"82 00", "80 05", "02 05"}));
}

TEST_F(BootOrdersTest, AnOrderThatIsNotTakenHoldsNobody)
{
    Verifies(req::SRS_BOOT_030);
    Add(5U, kMust);
    Protect(5U);
    gate.cycles = 5;
    Begin();
    Run(2U);
    FillQueue();
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kQueueFull);
    Run(500U);
    EXPECT_EQ(Status(5U), "- 17 started");
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
}

TEST_F(BootOrdersTest, AStartThatIsOwedAndACommandToStop)
{
    Verifies(req::SRS_BOOT_030);
    // Given a safety slave whose start was dropped, and which is verified anew for it
    Add(5U, kMust);
    Protect(5U);
    gate.cycles = 5;
    Begin();
    Run(2U);
    FillQueue(100U);
    Run(20U);
    ASSERT_TRUE(nmt.HasStart(NodeId{5U}) && !Of(5U).is_started);
    gate.cycles = 50;
    for (int i = 0; (i < 200) && !Of(5U).is_busy; ++i)
    {
        Run(1U);
    }
    ASSERT_EQ(nmt.Dropped(), 1U);
    ASSERT_TRUE(Of(5U).is_busy);
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    Run(500U);
    EXPECT_EQ(StateOf(5U), NodeState::kPreOperational);
    EXPECT_FALSE(Of(5U).is_started);
}

} // namespace
} // namespace counterpoint::cia302
