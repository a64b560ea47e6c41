// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Orders that come where they are least expected: before the start-up has begun, behind a stop of all, for nodes that
// are not listed, for slaves that run already; and what the bus does around them.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"

namespace counterpoint::cia302
{
namespace
{

using cia301::NodeState;
using Lines = std::vector<std::string>;

constexpr HeartbeatSetup kWatched{150U, 50U, Arming::kFirstHeartbeat};

class BootCommandsTest : public BootRig
{
  public:
    NmtAnswer Command(const NmtCommand command, const std::uint8_t node)
    {
        const NmtAnswer answer = start_up.Command(command, NodeId{node}, Now());
        Deliver();
        return answer;
    }
    [[nodiscard]] Lines Sent() const
    {
        Lines lines{};
        for (const std::string& line : Commands())
        {
            lines.push_back(line.substr(line.find(':') + 1U));
        }
        return lines;
    }
    FakeSlave& Watched(const std::uint8_t node, const std::uint32_t assignment)
    {
        FakeSlave& slave = Add(node, assignment);
        slave.heartbeat_ms = 50U;
        setups[node].heartbeat = kWatched;
        return slave;
    }
    /// All are stopped because slave 5 was lost; slave 6 is a safety slave.
    void StopAll()
    {
        setup.start_up = kIsMaster | kStopAllOnError;
        Watched(5U, kMust);
        Add(6U, kBoot);
        Protect(6U);
        Begin();
        Run(200U);
        slaves[5]->Unplug();
        Run(300U);
        ASSERT_EQ(Step(), MasterStep::kStopped);
        log.clear();
    }
    /// Somebody else commands the node.
    void Foreign(const NmtCommand command, const std::uint8_t node)
    {
        const CanFrame frame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {static_cast<std::uint8_t>(command), node}};
        ToManager(frame);
        slaves.at(node)->OnFrame(frame, Now());
    }
    /// A slave that is kept alive and runs when the start-up begins.
    FakeSlave& Running(const std::uint8_t node)
    {
        FakeSlave& slave = Watched(node, kBoot | kKeepAlive);
        slave.is_self_starting = true;
        return slave;
    }
    void BeginLate()
    {
        PowerAll();
        Run(200U);
        log.clear();
        begun_ms = ms;
        is_begun = true;
        start_up.Begin(Now());
        Run(200U);
    }
};

TEST_F(BootCommandsTest, BeforeTheStartUpHasBegunOrdersAreSentAndNothingFollows)
{
    Verifies(req::SRS_BOOT_021);
    Add(5U, kMust);
    PowerAll();
    Run(10U);
    log.clear();
    is_begun = true;
    EXPECT_EQ(Command(NmtCommand::kResetNode, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kStart, 127U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kStop, 127U), NmtAnswer::kTaken);
    start_up.OnBusBack(Now());
    Run(50U);
    EXPECT_EQ(Sent(), (Lines{"81 05"}));
    EXPECT_EQ(Step(), MasterStep::kIdle);
    EXPECT_FALSE(Of(5U).is_busy);
}

TEST_F(BootCommandsTest, AStartUpThatIsEndedAtOnceBootsNobody)
{
    Verifies(req::SRS_BOOT_022);
    Add(5U, kMust);
    PowerAll();
    Run(10U);
    is_begun = true;
    log.clear();
    start_up.Begin(Now());
    start_up.End();
    Run(50U);
    EXPECT_EQ(Sent(), (Lines{"82 00"}));
    EXPECT_EQ(Count(0x605U), 0);
    EXPECT_EQ(Step(), MasterStep::kIdle);
}

TEST_F(BootCommandsTest, NodesThatAreNotListedAreCommandedAndNotBooted)
{
    Verifies(req::SRS_BOOT_003);
    Add(5U, kBoot);
    Add(9U, 0U);
    Begin();
    Run(50U);
    EXPECT_EQ(Command(NmtCommand::kStart, 9U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kResetNode, 9U), NmtAnswer::kTaken);
    Run(50U);
    EXPECT_EQ(Count(0x609U), 0);
    EXPECT_EQ(Letter(9U), "A");
    // What is no node, and the master itself, has no letter
    for (const std::uint8_t node : {std::uint8_t{0U}, std::uint8_t{127U}, std::uint8_t{128U}, std::uint8_t{255U}})
    {
        EXPECT_FALSE(start_up.Boot(NodeId{node}, Now()));
    }
    EXPECT_EQ(Letter(127U), "-");
    EXPECT_EQ(Letter(0U), "-");
}

TEST_F(BootCommandsTest, AStartIsRefusedToOneThatIsNotTheActiveMaster)
{
    Verifies(req::SRS_NMM_002);
    Add(5U, kBoot);
    Protect(5U);
    Begin();
    Run(50U);
    nmt.SetActive(false);
    const int verifications = gate.verifications;
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kNotActive);
    EXPECT_EQ(gate.verifications, verifications);
}

TEST_F(BootCommandsTest, ThatTheMasterRunsAlreadyStartsNobodyASecondTime)
{
    Verifies(req::SRS_BOOT_015);
    setup.start_up = kIsMaster | kStartAllAtOnce;
    Add(5U, kMust);
    Begin();
    Run(50U);
    EXPECT_EQ(Sent(), (Lines{"82 00", "01 00"}));
    EXPECT_EQ(Command(NmtCommand::kStart, 127U), NmtAnswer::kTaken);
    EXPECT_EQ(Sent(), (Lines{"82 00", "01 00"}));
    // A stop twice holds it as one does, and a reset of its own is no hold
    EXPECT_EQ(Command(NmtCommand::kStop, 127U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 127U), NmtAnswer::kTaken);
    EXPECT_EQ(Step(), MasterStep::kReady);
    EXPECT_EQ(Command(NmtCommand::kStart, 127U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kResetNode, 127U), NmtAnswer::kTaken);
    EXPECT_EQ(Step(), MasterStep::kReady);
}

TEST_F(BootCommandsTest, EachBootedSlaveIsStartedWhereNotAllAreBooted)
{
    Verifies(req::SRS_BOOT_014);
    Verifies(req::SRS_BOOT_015);
    // Given a start by order, slave 5 that somebody else has stopped, 6 that is silent, 7 that runs since before
    setup.start_up = kIsMaster | kStartAllAtOnce | kApplicationStartsSelf;
    Watched(5U, kMust);
    Add(6U, kBoot).is_sdo_mute = true;
    Running(7U);
    BeginLate();
    ASSERT_EQ(Step(), MasterStep::kReady);
    ASSERT_EQ(Letter(7U), "L");
    Foreign(NmtCommand::kStop, 5U);
    Run(100U);
    log.clear();
    EXPECT_EQ(Command(NmtCommand::kStart, 127U), NmtAnswer::kTaken);
    Run(50U);
    EXPECT_EQ(Sent(), (Lines{"01 05"}));
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    EXPECT_EQ(slaves[7]->State(), NodeState::kOperational);
}

TEST_F(BootCommandsTest, ARunningSafetySlaveThatIsHeldEndsByHandWithL)
{
    Verifies(req::SRS_BOOT_030);
    // Given a safety slave that is kept alive, runs, tells so each 50 ms, and is verified for 200 ms
    Running(5U);
    Protect(5U);
    gate.cycles = 200;
    PowerAll();
    Run(200U);
    log.clear();
    begun_ms = ms;
    is_begun = true;
    start_up.Begin(Now());
    for (int i = 0; (i < 1000) && (gate.verifications == 0); ++i)
    {
        Run(1U);
    }
    ASSERT_TRUE(Of(5U).is_busy);
    ASSERT_EQ(gate.verifications, 1);
    // When it is made PRE-OPERATIONAL meanwhile
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    Run(2000U);
    // Then its start-up ends with L at step "by hand", and nobody starts it
    EXPECT_EQ(Letter(5U), "L");
    EXPECT_EQ(Of(5U).step, StartUpStep::kManual);
    EXPECT_FALSE(Of(5U).is_started);
    EXPECT_EQ(slaves[5]->State(), NodeState::kPreOperational);
    EXPECT_EQ(Sent().back(), "80 05");
}

TEST_F(BootCommandsTest, AStartOfAllKnowsWhoIsRefused)
{
    Verifies(req::SRS_BOOT_023);
    // Given slave 5 that ends with L, a node 9 that is not listed, 6 that was refused and started by order since
    setup.start_up = kIsMaster | kApplicationStartsSlaves;
    Running(5U);
    Add(6U, kBoot);
    Add(9U, 0U);
    setups[6].vendor_id = 0x2BU;
    BeginLate();
    slaves[9]->Power(Now());
    Run(50U);
    ASSERT_EQ(Letter(5U) + Letter(6U) + Letter(9U), "LDA");
    EXPECT_EQ(Command(NmtCommand::kStart, 6U), NmtAnswer::kTaken);
    log.clear();
    // Then nobody is refused, and one start is for all
    EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
    EXPECT_EQ(Sent(), (Lines{"01 00"}));
    // While it is asked anew, it is not refused either
    EXPECT_EQ(Command(NmtCommand::kStop, 0U), NmtAnswer::kTaken);
    slaves[6]->is_sdo_mute = true;
    EXPECT_TRUE(start_up.Boot(NodeId{6U}, Now()));
    Deliver();
    log.clear();
    EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
    EXPECT_EQ(Sent(), (Lines{"01 00"}));
}

TEST_F(BootCommandsTest, AStartOfAllAtOnceLeavesOutWhoIsNotBootedAndRefused)
{
    Verifies(req::SRS_BOOT_470);
    // Given slave 5, which is booted, and 6, which is supervised only and sends no heartbeat: letter K
    setup.start_up = kIsMaster | kStartAllAtOnce | kApplicationStartsSelf;
    Add(5U, kBoot);
    Add(6U, kInNetwork);
    setups[6].heartbeat = HeartbeatSetup{200U, 0U, Arming::kImmediately};
    BeginLate();
    Run(300U);
    ASSERT_EQ(Letter(5U) + Letter(6U), "-K");
    log.clear();
    // When the master is started, and with it all at once
    EXPECT_EQ(Command(NmtCommand::kStart, 127U), NmtAnswer::kTaken);
    Run(10U);
    // Then no start of all goes to that one
    EXPECT_EQ(Sent(), (Lines{"01 05"}));
    EXPECT_EQ(slaves[6]->State(), NodeState::kPreOperational);
}

TEST_F(BootCommandsTest, AStopOfAllBreaksOffWhatWasFoundOfASafetySlave)
{
    Verifies(req::SRS_SFS_009);
    Verifies(req::SRS_BOOT_343);
    // Given a safety slave in the middle of its boot, and one that is verified by order, when all are stopped
    setup.start_up = kIsMaster | kStopAllOnError;
    Watched(5U, kMust);
    for (const std::uint8_t node : {std::uint8_t{6U}, std::uint8_t{7U}})
    {
        Add(node, kBoot);
        Protect(node);
    }
    Begin();
    Run(200U);
    // And one that is booted and no safety slave
    Add(8U, kBoot).is_sdo_mute = true;
    slaves[6]->is_sdo_mute = true;
    gate.cycles = 1000;
    EXPECT_TRUE(start_up.Boot(NodeId{8U}, Now()));
    EXPECT_TRUE(start_up.Boot(NodeId{6U}, Now()));
    EXPECT_EQ(Command(NmtCommand::kStart, 7U), NmtAnswer::kTaken);
    slaves[5]->Unplug();
    Run(300U);
    ASSERT_EQ(Step(), MasterStep::kStopped);
    slaves[6]->is_sdo_mute = false;
    gate.cycles = 0;
    // Then the first counts as another device, and is neither started alone nor with all; the other one is started
    EXPECT_TRUE(Of(6U).is_other);
    EXPECT_FALSE(Of(7U).is_other);
    EXPECT_FALSE(Of(8U).is_other);
    setups[8].assignment = 0U;
    EXPECT_EQ(Command(NmtCommand::kStart, 6U), NmtAnswer::kOtherDevice);
    log.clear();
    EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kOtherDevice);
    Run(50U);
    EXPECT_EQ(slaves[6]->State(), NodeState::kStopped);
    EXPECT_EQ(slaves[7]->State(), NodeState::kOperational);
    // Until a boot has found the expected one
    EXPECT_TRUE(start_up.Boot(NodeId{6U}, Now()));
    Run(100U);
    EXPECT_FALSE(Of(6U).is_other);
}

TEST_F(BootCommandsTest, BehindAStopOfAllABootUpMessageCountsWhereItWasOrdered)
{
    Verifies(req::SRS_BOOT_343);
    StopAll();
    start_up.OnBusBack(Now());
    EXPECT_FALSE(start_up.Resume(NodeId{6U}, Now()));
    EXPECT_EQ(Count(0x606U), 0);
    // Given safety slave 6 that boots up unasked: it may be another device
    slaves[6]->Power(Now());
    Run(50U);
    EXPECT_TRUE(Of(6U).is_other);
    EXPECT_EQ(Count(0x606U), 0);
    // By order of a reset, its boot-up message begins its boot
    EXPECT_EQ(Command(NmtCommand::kResetNode, 6U), NmtAnswer::kTaken);
    Run(100U);
    EXPECT_FALSE(Of(6U).is_other);
    EXPECT_EQ(Letter(6U), "-");
    EXPECT_GT(Count(0x606U), 0);
}

TEST_F(BootCommandsTest, AHeartbeatWhileTheResetsWaitBeginsNothing)
{
    Verifies(req::SRS_BOOT_013);
    // Given a safety slave that tells its state while the reset of all waits for its turn
    Watched(5U, kBoot);
    Protect(5U);
    PowerAll();
    Run(10U);
    setup.inhibit_100us = 10000U;
    static_cast<void>(nmt.Request(NmtCommand::kResetNode, NodeId{99U}, Now()));
    is_begun = true;
    start_up.Begin(Now());
    ASSERT_EQ(Step(), MasterStep::kReset);
    Run(300U);
    EXPECT_EQ(gate.verifications, 0);
    EXPECT_EQ(Count(0x605U), 0);
    setup.inhibit_100us = 0U;
    Run(300U);
    EXPECT_EQ(gate.verifications, 1);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
}

TEST_F(BootCommandsTest, AStartThatWasDroppedIsOwedOnceAndToWhoIsListed)
{
    Verifies(req::SRS_NMM_121);
    Add(5U, kBoot);
    Add(6U, kBoot);
    Protect(5U);
    Protect(6U);
    Begin();
    Run(50U);
    ASSERT_TRUE(Of(5U).is_started && Of(6U).is_started);
    // Given two starts of one slave that are given up in one cycle, and one of a slave that was taken from the list
    setups[6].assignment = 0U;
    OnStartDropped(NodeId{5U}, Now());
    OnStartDropped(NodeId{5U}, Now());
    OnStartDropped(NodeId{6U}, Now());
    const int verifications = gate.verifications;
    log.clear();
    Run(50U);
    EXPECT_EQ(gate.verifications, verifications + 1);
    EXPECT_EQ(Sent(), (Lines{"01 05"}));
}

class BootBusBackTest : public BootCommandsTest
{
  public:
    /// Requests that the manager sends to the node in the next 30 ms, behind the return of the bus.
    int AskedBehind(const std::uint8_t node)
    {
        log.clear();
        start_up.OnBusBack(Now());
        Deliver();
        Run(30U);
        return Count(0x600U + node);
    }
};

TEST_F(BootBusBackTest, WhoRunsOrIsOnlyConfiguredIsLeftAlone)
{
    Verifies(req::SRS_BOOT_018);
    Add(5U, kBoot);
    Add(6U, kBoot);
    Begin();
    Run(50U);
    EXPECT_EQ(AskedBehind(5U), 0);
    // Given a slave whose configuration alone is written, and one whose boot-up message is awaited
    Octets dcf{};
    AddEntry(dcf, 0x2000U, 0U, {1U});
    setups[5].concise_dcf = Bytes{dcf.data(), static_cast<std::uint32_t>(dcf.size())};
    slaves[5]->is_sdo_mute = true;
    EXPECT_TRUE(start_up.Configure(NodeId{5U}, Now()));
    slaves[6]->boot_ms = 500U;
    EXPECT_EQ(Command(NmtCommand::kResetNode, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(AskedBehind(6U), 0);
    EXPECT_EQ(Count(0x605U), 0); // The same writing goes on.
    EXPECT_TRUE(Of(5U).is_busy);
}

TEST_F(BootBusBackTest, WhoRanBeforeAndWasStoppedHasNotFailed)
{
    Verifies(req::SRS_BOOT_018);
    Running(7U);
    BeginLate();
    EXPECT_EQ(Command(NmtCommand::kStop, 7U), NmtAnswer::kTaken);
    ASSERT_EQ(Letter(7U), "L");
    EXPECT_EQ(AskedBehind(7U), 0);
}

TEST_F(BootBusBackTest, WhoWasToBeStartedOrHadFailedBeginsAnew)
{
    Verifies(req::SRS_BOOT_018);
    Add(5U, kBoot);
    Add(6U, kBoot).Put32(0x1018U, 1U, 0x2BU);
    Protect(5U);
    Begin();
    Run(50U);
    ASSERT_EQ(Letter(6U), "D");
    // Given one that had ended with a letter
    EXPECT_GT(AskedBehind(6U), 0);
    // One that was stopped since, which stays so
    EXPECT_EQ(Command(NmtCommand::kStop, 6U), NmtAnswer::kTaken);
    EXPECT_EQ(AskedBehind(6U), 0);
    // One that is verified for a start by order
    gate.cycles = 100;
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    EXPECT_GT(AskedBehind(5U), 0);
    Run(300U);
    ASSERT_TRUE(Of(5U).is_started);
    // One whose start waits in the queue
    gate.cycles = 0;
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    FillQueue(50U);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(3U);
    ASSERT_TRUE(nmt.HasStart(NodeId{5U}) && !Of(5U).is_started);
    EXPECT_GT(AskedBehind(5U), 0);
    // And one whose start was given up
    Run(300U);
    ASSERT_TRUE(Of(5U).is_started);
    OnStartDropped(NodeId{5U}, Now());
    EXPECT_GT(AskedBehind(5U), 0);
    Run(100U);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
}

} // namespace
} // namespace counterpoint::cia302
