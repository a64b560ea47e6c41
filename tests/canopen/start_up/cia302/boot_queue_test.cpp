// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Boots and orders that find no room: in the queue of NMT commands, for a remote frame, or for an SDO.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

namespace counterpoint::cia302
{
namespace
{

using cia301::NodeState;
using Lines = std::vector<std::string>;

class BootQueueTest : public BootRig
{
  public:
    using BootRig::BootRig;
    /// The queue is full in each of these cycles.
    void RunFull(const int cycles)
    {
        for (int i = 0; i < cycles; ++i)
        {
            FillQueue();
            Run(1U);
        }
        FillQueue();
    }
    NmtAnswer Command(const NmtCommand command, const std::uint8_t node)
    {
        const NmtAnswer answer = start_up.Command(command, NodeId{node}, Now());
        Deliver();
        return answer;
    }
    /// How often a command was sent, "82 05".
    [[nodiscard]] int Sum(const std::string& command) const
    {
        int count = 0;
        for (const std::string& line : Commands())
        {
            count += (line.substr(line.find(':') + 1U) == command) ? 1 : 0;
        }
        return count;
    }
    /// Slave 5, mandatory, with a heartbeat that is supervised, started.
    void Start(const std::uint32_t start_up_bits)
    {
        setup.start_up = start_up_bits;
        Watched(5U, kMust);
        Begin();
        Run(300U);
        ASSERT_EQ(Step(), MasterStep::kOperational);
        log.clear();
    }
    void Watched(const std::uint8_t node, const std::uint32_t assignment)
    {
        Add(node, assignment).heartbeat_ms = 50U;
        setups[node].heartbeat = HeartbeatSetup{150U, 50U, Arming::kFirstHeartbeat};
    }
};

TEST_F(BootQueueTest, SingleResetsGoOnWhenThereIsRoom)
{
    Verifies(req::SRS_BOOT_001);
    Verifies(req::SRS_NMM_005);
    // Given a queue with room for 50 of the 125 resets, one each millisecond
    Add(5U, kBoot | kKeepAlive);
    PowerAll();
    Run(10U);
    log.clear();
    FillQueue(206U);
    is_begun = true;
    start_up.Begin(Now());
    EXPECT_EQ(nmt.Waiting(), 256U);
    EXPECT_EQ(Step(), MasterStep::kReset);
    Run(400U);
    EXPECT_EQ(Step(), MasterStep::kOperational);
    EXPECT_EQ(Sum("82 01") + Sum("82 7e"), 2);
    EXPECT_EQ(Sum("82 05"), 1); // Not one of these: it did not run.
}

TEST_F(BootQueueTest, TheResetOfOneThatIsKeptAliveAndDoesNotRunWaits)
{
    Verifies(req::SRS_BOOT_006);
    Watched(7U, kMust | kKeepAlive);
    PowerAll();
    Run(10U);
    begun_ms = ms;
    is_begun = true;
    start_up.Begin(Now());
    Run(1U);
    RunFull(100);
    EXPECT_EQ(Of(7U).step, StartUpStep::kStateCheck);
    EXPECT_EQ(slaves[7]->resets, 1);
    Run(800U);
    EXPECT_EQ(slaves[7]->resets, 2);
    EXPECT_EQ(slaves[7]->State(), NodeState::kOperational);
}

TEST_F(BootQueueTest, TheResetOfALostSlaveWaits)
{
    Verifies(req::SRS_BOOT_017);
    Start(kIsMaster);
    slaves[5]->Unplug();
    RunFull(200);
    EXPECT_EQ(Sum("81 05"), 0);
    EXPECT_EQ(Of(5U).step, StartUpStep::kReset);
    Run(600U);
    EXPECT_EQ(Sum("81 05"), 1);
}

TEST_F(BootQueueTest, TheStopOfAllWaitsWhateverIsWrittenMeanwhile)
{
    Verifies(req::SRS_BOOT_017);
    Verifies(req::SRS_NMM_005);
    setup.start_up = kIsMaster | kStopAllOnError;
    Watched(6U, kMust);
    Start(kIsMaster | kStopAllOnError);
    // Given the loss of slave 5 with a full queue
    slaves[5]->Unplug();
    RunFull(200);
    EXPECT_EQ(Step(), MasterStep::kOperational);
    // When 1F80h asks for a reset of all instead, and 6 is lost as well
    setup.start_up = kIsMaster | kResetAllOnError;
    slaves[6]->Unplug();
    RunFull(200);
    Run(600U);
    // Then the stop is what was decided first
    EXPECT_EQ(Sum("02 00"), 1);
    EXPECT_EQ(Sum("81 00"), 0);
    EXPECT_EQ(Step(), MasterStep::kStopped);
}

TEST_F(BootQueueTest, TheStopOfOneThatDiffersWaits)
{
    Verifies(req::SRS_BOOT_013);
    Verifies(req::SRS_BOOT_342);
    Watched(5U, kMust);
    Protect(5U);
    Begin();
    Run(300U);
    ASSERT_EQ(slaves[5]->State(), NodeState::kOperational);
    // Given a safety slave that runs with another configuration
    gate.Close(NodeId{5U});
    gate.verdict = GateState::kDiffers;
    gate.cycles = 30;
    for (int i = 0; (i < 100) && (gate.State(NodeId{5U}) != GateState::kBusy); ++i)
    {
        Run(1U);
    }
    RunFull(120);
    EXPECT_EQ(Of(5U).step, StartUpStep::kSafety);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    Run(600U);
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(slaves[5]->State(), NodeState::kStopped);
}

TEST_F(BootQueueTest, OrdersForAllThatFindNoRoomChangeNothing)
{
    Verifies(req::SRS_NMM_005);
    Verifies(req::SRS_BOOT_023);
    Start(kIsMaster);
    RunFull(1);
    for (const NmtCommand command : {NmtCommand::kStop, NmtCommand::kResetNode, NmtCommand::kStart})
    {
        EXPECT_EQ(Command(command, 0U), NmtAnswer::kQueueFull);
        EXPECT_TRUE(Of(5U).is_started);
        EXPECT_EQ(Step(), MasterStep::kOperational);
    }
    // One start for each, where a safety slave is listed
    Add(4U, kBoot);
    Protect(6U);
    setups[6].assignment = kBoot;
    EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kQueueFull);
    EXPECT_EQ(Command(NmtCommand::kStart, 127U), NmtAnswer::kQueueFull);
    // With room for the slaves and none for the master itself
    start_up.End();
    setups[4].assignment = 0U;
    setups[5].assignment = 0U;
    Run(600U);
    FillQueue();
    EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kQueueFull);
}

class BootRemoteTest : public BootQueueTest
{
  public:
    bool Send(const CanFrame& frame) noexcept override
    {
        const bool is_refused = (frame.kind == FrameKind::kRemote) && (refused > 0);
        refused -= is_refused ? 1 : 0;
        return !is_refused && BootRig::Send(frame);
    }
    int refused{5};
};

TEST_F(BootRemoteTest, TheQuestionForTheStateWaitsForRoom)
{
    Verifies(req::SRS_BOOT_006);
    Add(7U, kMust | kKeepAlive);
    Begin();
    Run(150U);
    EXPECT_EQ(refused, 0);
    EXPECT_EQ(Letter(7U), "-");
    EXPECT_EQ(slaves[7]->State(), NodeState::kOperational);
}

TEST_F(BootQueueTest, AnSdoWaitsForThatOfTheApplication)
{
    Verifies(req::SRS_NMM_030);
    Octets dcf{};
    AddEntry(dcf, 0x2000U, 0U, {0x77U});
    FakeSlave& slave = Add(5U, kMust);
    slave.Put8(0x2000U, 0U, 0U);
    setups[5].concise_dcf = Bytes{dcf.data(), static_cast<std::uint32_t>(dcf.size())};
    Begin();
    Run(50U);
    ASSERT_TRUE(Of(5U).is_started);
    std::array<std::uint8_t, 4> room{};
    const auto read = [this, &slave, &room](const bool is_boot)
    {
        // Given a transfer of the application to which the slave does not answer
        slave.is_sdo_mute = true;
        slave.Put8(0x2000U, 0U, 0U);
        EXPECT_TRUE(sdo.Upload(NodeId{5U}, ObjectAddress{0x1000U, 0U}, Room{room.data(), 4U}, SdoMode::kNormal, Now()));
        EXPECT_TRUE(is_boot ? start_up.Boot(NodeId{5U}, Now()) : start_up.Configure(NodeId{5U}, Now()));
        Run(150U);
        slave.is_sdo_mute = false;
        EXPECT_TRUE(Of(5U).is_busy);
        EXPECT_EQ(slave.Get(0x2000U, 0U), (Octets{0U}));
        // Then the boot, or the writing, begins behind it
        Run(200U);
        EXPECT_FALSE(Of(5U).is_busy);
        EXPECT_EQ(slave.Get(0x2000U, 0U), (Octets{0x77U}));
    };
    read(true);
    read(false);
}

/// A slave that does not come back behind its reset, and SDOs to another one without a pause; on a slow bus, too.
class BusyBusTest : public BootQueueTest
{
  public:
    explicit BusyBusTest(const SdoTimes& times = SdoTimes{100'000U, 3U}) : BootQueueTest(times)
    {
    }
    void Lose()
    {
        FakeSlave& slave = Add(5U, kBoot | kRestoreDefaults);
        slave.Put32(0x1011U, 1U, 1U);
        setups[5].restore_sub = 1U;
        Begin();
        Run(1U);
        slave.has_boot_up = false;
    }
    void RunBusy(const int cycles)
    {
        for (int i = 0; i < cycles; ++i)
        {
            static_cast<void>(
                sdo.Upload(NodeId{9U}, ObjectAddress{0x1000U, 0U}, Room{room.data(), 4U}, SdoMode::kNormal, Now()));
            Run(1U);
        }
    }

    std::array<std::uint8_t, 4> room{};
};

class SlowBusyBusTest : public BusyBusTest
{
  public:
    SlowBusyBusTest() : BusyBusTest(SdoTimes{1'000'000U, 3U})
    {
    }
};

TEST_F(BusyBusTest, ASlaveIsNotWaitedForWithoutEndWhereTheBusIsBusy)
{
    Verifies(req::SRS_BOOT_009);
    Lose();
    RunBusy(9900);
    EXPECT_EQ(Letter(5U), "-");
    RunBusy(200);
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(Of(5U).step, StartUpStep::kRestore);
}

TEST_F(SlowBusyBusTest, ItIsWaitedForTwentySdoTimeOutsWhereTheseAreLonger)
{
    Verifies(req::SRS_BOOT_009);
    Lose();
    RunBusy(19900);
    EXPECT_EQ(Letter(5U), "-");
    RunBusy(200);
    EXPECT_EQ(Letter(5U), "J");
}

} // namespace
} // namespace counterpoint::cia302
