// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// 1F8xh written in the middle of a boot, and what a boot finds that is neither right nor wrong at once.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"

namespace counterpoint::cia302
{
namespace
{

using cia301::NodeState;
using Lines = std::vector<std::string>;

constexpr std::uint32_t kGuarded = (3U << 8U) | (100U << 16U);
constexpr HeartbeatSetup kWatched{150U, 50U, Arming::kFirstHeartbeat};

class BootRewrittenTest : public BootRig
{
  public:
    /// Given slave 5, mandatory, with a heartbeat of 50 ms that is supervised, started.
    FakeSlave& Start()
    {
        FakeSlave& slave = Add(5U, kMust);
        slave.heartbeat_ms = 50U;
        setups[5].heartbeat = kWatched;
        Begin();
        Run(300U);
        EXPECT_EQ(slave.State(), NodeState::kOperational);
        return slave;
    }
    [[nodiscard]] Lines Told() const
    {
        Lines told{};
        for (const std::string& command : Commands())
        {
            told.push_back(command.substr(command.find(':') + 1U));
        }
        return told;
    }
    [[nodiscard]] static Bytes BytesOf(const Octets& octets)
    {
        return Bytes{octets.data(), static_cast<std::uint32_t>(octets.size())};
    }
};

TEST_F(BootRewrittenTest, OneThatIsKeptAliveNoMoreIsNotAskedForItsState)
{
    Verifies(req::SRS_BOOT_006);
    // Given one whose heartbeat is waited for, and one that was reset because it did not run
    Add(5U, kBoot | kKeepAlive);
    setups[5].heartbeat = HeartbeatSetup{250U, 100U, Arming::kFirstHeartbeat};
    Add(6U, kBoot | kKeepAlive);
    PowerAll();
    Run(10U);
    slaves[6]->boot_ms = 500U;
    is_begun = true;
    start_up.Begin(Now());
    Run(50U);
    ASSERT_EQ(Of(5U).step, StartUpStep::kStateCheck);
    ASSERT_EQ(Of(6U).step, StartUpStep::kStateCheck);
    // When bit 4 of 1F81h is cleared
    setups[5].assignment = kBoot;
    setups[6].assignment = kBoot;
    setups[5].heartbeat = HeartbeatSetup{};
    Run(50U);
    // Then neither is waited for any more
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_TRUE(Of(5U).is_started);
    EXPECT_NE(Of(6U).step, StartUpStep::kStateCheck);
}

TEST_F(BootRewrittenTest, ARestoringThatIsNotAskedForAnyMoreIsNotWaitedFor)
{
    Verifies(req::SRS_BOOT_009);
    // Given a slave that was told to restore its defaults and needs long to restart
    FakeSlave& slave = Add(5U, kBoot | kRestoreDefaults);
    slave.Put32(0x1011U, 1U, 1U);
    setups[5].restore_sub = 1U;
    Begin();
    Run(1U);
    slave.boot_ms = 600U;
    Run(20U);
    ASSERT_EQ(Of(5U).step, StartUpStep::kRestore);
    // When bit 7 of 1F81h is cleared
    setups[5].assignment = kBoot;
    Run(20U);
    EXPECT_NE(Of(5U).step, StartUpStep::kRestore);
    // And where the reset itself still waits for room
    start_up.End();
    setups[5].assignment = kBoot | kRestoreDefaults;
    slave.boot_ms = 1U;
    slave.Power(Now());
    Begin();
    for (int i = 0; i < 20; ++i)
    {
        FillQueue();
        Run(1U);
    }
    ASSERT_EQ(Of(5U).step, StartUpStep::kRestore);
    const int resets = slave.resets;
    setups[5].assignment = kBoot;
    Run(600U);
    EXPECT_EQ(slave.resets, resets);
    EXPECT_EQ(slave.State(), NodeState::kOperational);
}

TEST_F(BootRewrittenTest, ASupervisionThatIsTakenAwayIsNotWaitedFor)
{
    Verifies(req::SRS_BOOT_011);
    Add(5U, kMust);
    setups[5].heartbeat = HeartbeatSetup{300U, 0U, Arming::kFirstHeartbeat};
    Begin();
    Run(100U);
    ASSERT_EQ(Of(5U).step, StartUpStep::kErrorControl);
    setups[5].heartbeat = HeartbeatSetup{};
    Run(1U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_TRUE(Of(5U).is_started);
}

TEST_F(BootRewrittenTest, AToggleBitThatStandsStillIsNoMatterForAHeartbeat)
{
    Verifies(req::SRS_BOOT_026);
    // Given a slave that was lost twice because its answers do not toggle
    Add(7U, kBoot | kGuarded).is_toggle_stuck = true;
    Begin();
    for (int i = 0; (i < 5000) && (table.Record(NodeId{7U}).untoggled < 3U); ++i)
    {
        Run(1U);
    }
    ASSERT_EQ(table.Record(NodeId{7U}).untoggled, 3U);
    // When its next boot supervises it by heartbeat
    setups[7].heartbeat = kWatched;
    setups[7].assignment = kBoot;
    slaves[7]->heartbeat_ms = 50U;
    slaves[7]->Power(Now());
    Run(500U);
    EXPECT_EQ(Letter(7U), "-");
    EXPECT_EQ(slaves[7]->State(), NodeState::kOperational);
}

TEST_F(BootRewrittenTest, AnAbortWithTheCodeOfATimeOutIsAnAnswer)
{
    Verifies(req::SRS_BOOT_004);
    Add(5U, kMust).refused[0x100000U] = SdoAbort::kTimeOut;
    Begin();
    Run(50U);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 127U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kTimeOut);
}

TEST_F(BootRewrittenTest, ADeviceTypeOfFewerBytesIsCompared)
{
    Verifies(req::SRS_BOOT_005);
    Add(5U, kBoot).Put(0x1000U, 0U, {0x91U, 0x01U});
    Add(6U, kBoot).Put(0x1000U, 0U, {0x92U, 0x01U});
    Begin();
    Run(20U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(Letter(6U), "C");
    EXPECT_EQ(Of(6U).read, 0x192U);
}

TEST_F(BootRewrittenTest, ASafetySlaveThatRunsAndDoesNotAnswerIsStoppedAndAskedOn)
{
    Verifies(req::SRS_SFS_006);
    // Given a safety slave that runs, as its heartbeats say, and answers no SDO any more
    Protect(5U);
    FakeSlave& slave = Start();
    log.clear();
    slave.is_sdo_mute = true;
    EXPECT_TRUE(start_up.Boot(NodeId{5U}, Now()));
    Run(350U);
    EXPECT_EQ(Told(), (Lines{"02 05"}));
    EXPECT_EQ(slave.State(), NodeState::kStopped);
    // Then it is asked on in PRE-OPERATIONAL, and started when it answers as expected
    Run(1400U);
    EXPECT_EQ(Told(), (Lines{"02 05", "80 05"}));
    slave.is_sdo_mute = false;
    Run(1500U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(slave.State(), NodeState::kOperational);
}

TEST_F(BootRewrittenTest, OneThatSomebodyElseWokeMeanwhileIsNotWokenAgain)
{
    Verifies(req::SRS_SFS_006);
    Protect(5U);
    FakeSlave& slave = Start();
    log.clear();
    slave.is_sdo_mute = true;
    EXPECT_TRUE(start_up.Boot(NodeId{5U}, Now()));
    Run(350U);
    ASSERT_EQ(Told(), (Lines{"02 05"}));
    // When somebody else makes it PRE-OPERATIONAL
    const CanFrame frame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {0x80U, 5U}};
    ToManager(frame);
    slave.OnFrame(frame, Now());
    Run(1400U);
    EXPECT_EQ(Told(), (Lines{"02 05"}));
    EXPECT_TRUE(Of(5U).is_busy);
}

struct OtherDevice
{
    ObjectAddress object;
    const char* letter;
};

TEST_F(BootRewrittenTest, AnotherDeviceThatTheGateFindsHasTheLetterOfItsNumber)
{
    Verifies(req::SRS_BOOT_013);
    Verifies(req::SRS_BOOT_342);
    const OtherDevice cases[] = {{{0x1000U, 0U}, "C"}, {{0x1018U, 1U}, "D"}, {{0x1018U, 2U}, "M"},
                                 {{0x1018U, 3U}, "N"}, {{0x1018U, 4U}, "O"}, {{0x1018U, 5U}, "J"}};
    for (const OtherDevice& one : cases)
    {
        gate.verdict = GateState::kDiffers;
        gate.finding = GateFinding{one.object, SdoAbort::kNone, 7U, 8U};
        Add(5U, kBoot);
        Protect(5U);
        Begin();
        Run(30U);
        EXPECT_EQ(Letter(5U), one.letter);
        EXPECT_EQ(Of(5U).step, StartUpStep::kSafety);
        EXPECT_EQ(Of(5U).read, 8U);
        EXPECT_EQ(slaves[5]->State(), NodeState::kStopped); // It never told its state.
        start_up.End();
    }
}

TEST_F(BootRewrittenTest, TwoDevicesBehindOneNodeIdAreStopped)
{
    Verifies(req::SRS_BOOT_013);
    Verifies(req::SRS_BOOT_342);
    // Given a verification that fails and names no object, and a slave that says PRE-OPERATIONAL
    gate.verdict = GateState::kFailed;
    gate.finding = GateFinding{{0U, 0U}, SdoAbort::kNone, 0U, 0U};
    Add(5U, kBoot).heartbeat_ms = 50U;
    setups[5].heartbeat = kWatched;
    Protect(5U);
    Begin();
    Run(200U);
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(Told(), (Lines{"82 00", "02 05"}));
}

TEST_F(BootRewrittenTest, ASafetySlaveThatDidNotHearTheResetIsTakenOver)
{
    Verifies(req::SRS_BOOT_340);
    // Given an optional safety slave that is not heard behind the reset
    Add(5U, kBoot).has_boot_up = false;
    Protect(5U);
    setups[5].heartbeat = kWatched;
    Begin();
    Run(1100U);
    ASSERT_EQ(Of(5U).step, StartUpStep::kWaitBootUp);
    log.clear();
    // When it turns out to run
    for (int i = 0; i < 3; ++i)
    {
        ToManager(cia301::ErrorControlFrame(NodeId{5U}, 5U));
        Run(50U);
    }
    // Then it is supervised and verified, and runs on
    EXPECT_EQ(Letter(5U), "L");
    EXPECT_EQ(gate.verifications, 1);
    EXPECT_EQ(table.Record(NodeId{5U}).watch, Watch::kHeartbeat);
    EXPECT_TRUE(Told().empty());
    EXPECT_TRUE(Of(5U).is_started);
    // One that boots while it says so is verified once
    start_up.End();
    gate.verifications = 0;
    slaves[5]->has_boot_up = true;
    gate.cycles = 60;
    Begin();
    Run(5U);
    for (int i = 0; i < 3; ++i)
    {
        ToManager(cia301::ErrorControlFrame(NodeId{5U}, 5U));
        Run(50U);
    }
    EXPECT_EQ(gate.verifications, 1);
}

TEST_F(BootRewrittenTest, ARunningSafetySlaveIsReadWhileCommandsForOthersWait)
{
    Verifies(req::SRS_BOOT_770);
    // Given an optional safety slave that is not heard behind the reset, and commands that wait
    Add(5U, kBoot).has_boot_up = false;
    Protect(5U);
    setups[5].heartbeat = kWatched;
    Begin();
    Run(1100U);
    FillQueue(250U);
    // When it turns out to run, then it is read before they have left
    for (int i = 0; i < 3; ++i)
    {
        ToManager(cia301::ErrorControlFrame(NodeId{5U}, 5U));
        Run(20U);
    }
    EXPECT_GT(nmt.Waiting(), 100U);
    EXPECT_EQ(gate.verifications, 1);
    EXPECT_EQ(Letter(5U), "L");
    // But not while its own command waits, which takes it out of OPERATIONAL
    EXPECT_EQ(nmt.Request(NmtCommand::kPreOperational, NodeId{5U}, Now()), NmtAnswer::kTaken);
    gate.Close(NodeId{5U});
    Run(20U);
    EXPECT_GT(nmt.Waiting(), 100U);
    EXPECT_EQ(gate.verifications, 1);
}

TEST_F(BootRewrittenTest, ARunningSafetySlaveWhoseBootFailsIsVerified)
{
    Verifies(req::SRS_BOOT_340);
    // Given a safety slave that is kept alive, runs, and is of another vendor
    FakeSlave& slave = Add(5U, kBoot | kKeepAlive);
    slave.Put32(0x1018U, 1U, 0x2BU);
    slave.is_self_starting = true;
    slave.heartbeat_ms = 50U;
    setups[5].heartbeat = kWatched;
    Protect(5U);
    PowerAll();
    Run(200U);
    begun_ms = ms;
    is_begun = true;
    start_up.Begin(Now());
    Run(200U);
    EXPECT_EQ(Letter(5U), "D");
    EXPECT_EQ(gate.verifications, 1);
}

TEST_F(BootRewrittenTest, AFailedSlaveThatIsConfiguredIsNotLookedAtMeanwhile)
{
    Verifies(req::SRS_NMM_009);
    // Given slave 5 of another vendor, whose configuration is written on command, and slave 6 that is booted meanwhile
    Octets dcf{};
    for (std::uint16_t index = 0x2000U; index < 0x2010U; ++index)
    {
        AddEntry(dcf, index, 0U, {1U});
    }
    FakeSlave& slave = Add(5U, kBoot);
    slave.Put32(0x1018U, 1U, 0x2BU);
    setups[5].concise_dcf = BytesOf(dcf);
    Add(6U, kBoot);
    Begin();
    Run(50U);
    ASSERT_EQ(Letter(5U), "D");
    slave.is_sdo_mute = true;
    EXPECT_TRUE(start_up.Configure(NodeId{5U}, Now()));
    EXPECT_TRUE(start_up.Boot(NodeId{6U}, Now()));
    Run(50U);
    EXPECT_TRUE(Of(5U).is_busy);
    EXPECT_TRUE(Of(6U).is_started);
    // Then its letter is that of the writing, and that of its identity again when it could be written
    Run(400U);
    EXPECT_EQ(Letter(5U), "J");
    slave.is_sdo_mute = false;
    setups[5].concise_dcf = Bytes{nullptr, 0U};
    EXPECT_TRUE(start_up.Configure(NodeId{5U}, Now()));
    Run(50U);
    EXPECT_EQ(Letter(5U), "D");
    EXPECT_EQ(Of(5U).object.index, 0U);
}

TEST_F(BootRewrittenTest, AConfigurationThatFailsBehindItsResetIsAFailedBoot)
{
    Verifies(req::SRS_NMM_009);
    Verifies(req::SRS_BOOT_017);
    Octets dcf{};
    AddEntry(dcf, 0x2000U, 0U, {0x77U});
    for (const bool is_lost : {false, true})
    {
        FakeSlave& slave = Add(5U, kMust | kRestoreDefaults);
        slave.Put32(0x1011U, 1U, 1U);
        slave.Put8(0x2000U, 0U, 0U);
        slave.heartbeat_ms = 50U;
        setups[5].heartbeat = HeartbeatSetup{150U, 50U, Arming::kBootUp};
        setups[5].restore_sub = 1U;
        setups[5].concise_dcf = BytesOf(dcf);
        Begin();
        Run(300U);
        ASSERT_EQ(slave.State(), NodeState::kOperational);
        // When it is configured on command, reset by that, and refuses what is written then, or is pulled
        slave.boot_ms = 20U;
        slave.refused[0x200000U] = SdoAbort::kHardware;
        EXPECT_TRUE(start_up.Configure(NodeId{5U}, Now()));
        Run(10U);
        ASSERT_EQ(Of(5U).step, StartUpStep::kRestore);
        slave.is_sdo_mute = is_lost;
        log.clear();
        for (int i = 0; (i < 100) && (Of(5U).step == StartUpStep::kRestore); ++i)
        {
            Run(1U);
        }
        if (is_lost)
        {
            slave.Unplug();
        }
        Run(250U);
        EXPECT_EQ(slave.State() == NodeState::kOperational, false);
        EXPECT_EQ(Letter(5U), is_lost ? "-" : "J");
        EXPECT_EQ(Told(), Lines{}); // It is no booted slave that is lost.
        start_up.End();
    }
}

TEST_F(BootRewrittenTest, AConfigurationThatIsCutWhileItIsWrittenIsRefused)
{
    Verifies(req::SRS_BOOT_010);
    Octets dcf{};
    AddEntry(dcf, 0x2000U, 0U, {1U});
    AddEntry(dcf, 0x2001U, 0U, {2U});
    FakeSlave& slave = Add(5U, kBoot);
    slave.Put8(0x2000U, 0U, 0U);
    slave.Put8(0x2001U, 0U, 0U);
    slave.mute_after_writes = 1U;
    setups[5].concise_dcf = BytesOf(dcf);
    Begin();
    Run(50U);
    ASSERT_TRUE(Of(5U).is_busy);
    // When what is written becomes shorter, before the last entry is asked for again
    setups[5].concise_dcf.size_bytes -= 1U;
    Run(50U);
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(Of(5U).object.index, 0x1F22U);
    EXPECT_EQ(slave.Get(0x2001U, 0U), (Octets{0U}));
}

TEST_F(BootRewrittenTest, AResumedBootRestoresNothing)
{
    Verifies(req::SRS_SFS_214);
    FakeSlave& slave = Add(5U, kBoot | kRestoreDefaults);
    slave.Put32(0x1011U, 1U, 1U);
    setups[5].restore_sub = 1U;
    Begin();
    Run(50U);
    ASSERT_TRUE(Of(5U).is_started);
    const int resets = slave.resets;
    EXPECT_TRUE(start_up.Resume(NodeId{5U}, Now()));
    Run(50U);
    EXPECT_EQ(slave.resets, resets);
    EXPECT_TRUE(Of(5U).is_started);
    // Nobody is resumed who is not listed, nor where the start-up has not begun
    EXPECT_FALSE(start_up.Resume(NodeId{9U}, Now()));
    EXPECT_FALSE(start_up.Configure(NodeId{9U}, Now()));
    start_up.End();
    EXPECT_FALSE(start_up.Resume(NodeId{5U}, Now()));
    EXPECT_FALSE(start_up.Configure(NodeId{5U}, Now()));
}

class BootFlashTest : public BootRewrittenTest
{
  public:
    BootFlashTest()
    {
        slave.Put32(0x1F56U, 1U, 0x54U);
        slave.Put(0x1F50U, 1U, Octets{});
        slave.Put8(0x1F51U, 1U, 1U);
        slave.Put32(0x1F57U, 1U, 0U);
        setups[5].software.identification = 0x55U;
        setups[5].software.program = Bytes{program.data(), 20U};
    }

    bool Send(const CanFrame& frame) noexcept override
    {
        const bool is_written = (slave.writes.size() == 3U);
        slave.Put32(0x1F57U, 1U, (is_slow && is_written) ? 1U : flash);
        return BootRig::Send(frame);
    }

    bool is_slow{false};
    std::uint32_t flash{0U};
    Octets program = Octets(20U, 0x5AU);
    FakeSlave& slave = Add(5U, kBoot | kVerifySoftware | kMayUpdateSoftware);
};

TEST_F(BootFlashTest, IsPolledBehindTheProgramToo)
{
    Verifies(req::SRS_BOOT_007);
    // Given a flash that is busy once the program was written
    is_slow = true;
    slave.after_reset[0x1F5601U] = Octets{0x54U, 0U, 0U, 0U};
    Begin();
    Run(250U);
    EXPECT_TRUE(Of(5U).is_busy);
    EXPECT_EQ(slave.writes.size(), 3U);
    // When it is ready, then the program is started
    is_slow = false;
    slave.Put32(0x1F57U, 1U, 0U);
    slave.after_reset[0x1F5601U] = Octets{0x55U, 0U, 0U, 0U};
    Run(120U);
    ASSERT_EQ(slave.writes.size(), 4U);
    slave.Power(Now());
    Run(100U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_TRUE(Of(5U).is_started);
}

TEST_F(BootFlashTest, AnErrorBehindItsClearingEndsTheUpdate)
{
    Verifies(req::SRS_BOOT_007);
    flash = 0x04U;
    Begin();
    Run(50U);
    EXPECT_EQ(Letter(5U), "I");
    EXPECT_EQ(slave.writes, (std::vector<std::uint32_t>{0x1F5101U, 0x1F5101U}));
}

} // namespace
} // namespace counterpoint::cia302
