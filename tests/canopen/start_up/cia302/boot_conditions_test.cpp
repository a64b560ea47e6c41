// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What lies directly beside the letters: times, and entries of 1F80h and 1F81h that are there by half.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

#include <algorithm>

namespace counterpoint::cia302
{
namespace
{

using cia301::NodeState;

class BootConditionsTest : public BootRig
{
  public:
    /// Times in ms of the manager's requests to read `index` of this node.
    [[nodiscard]] std::vector<std::uint32_t> Reads(const std::uint8_t node, const std::uint16_t index) const
    {
        std::vector<std::uint32_t> times{};
        for (const Sent& one : log)
        {
            const bool is_read = (one.frame.identifier == (0x600U + node)) && (one.frame.data[0] == 0x40U);
            const bool is_it = (one.frame.data[1] == (index & 0xFFU)) && (one.frame.data[2] == (index >> 8U));
            if (is_read && is_it)
            {
                times.push_back(one.at_ms);
            }
        }
        return times;
    }
    [[nodiscard]] int Sum(const std::string& command) const
    {
        const std::vector<std::string> commands = Commands();
        return static_cast<int>(std::count_if(commands.begin(), commands.end(), [&command](const std::string& line)
                                              { return line.substr(line.find(':') + 1U) == command; }));
    }
};

// Three tries of 100 ms, then 1 s.
TEST_F(BootConditionsTest, WhyTheDeviceTypeIsAskedForAgainIsToldWithoutAnyLetter)
{
    Verifies(req::SRS_BOOT_004);
    // Given a slave that refuses 1000h and one that is silent, and no boot time
    Add(5U, kMust).refused[0x1000U << 8U] = SdoAbort::kHardware;
    Add(6U, kMust).is_sdo_mute = true;
    Begin();
    int told = 0;
    for (std::uint32_t i = 0U; i < 5000U; ++i)
    {
        Run(1U);
        told += (i > 400U) && (Of(5U).abort == SdoAbort::kHardware) && (Of(6U).abort == SdoAbort::kTimeOut) ? 1 : 0;
    }
    // Then both are told from the first try on, while they are asked as well
    EXPECT_EQ(told, 4599);
    EXPECT_EQ(Of(5U).object.index, 0x1000U);
    EXPECT_TRUE(Of(5U).is_busy);
    EXPECT_EQ(Letter(5U) + Letter(6U), "--");
    // And no more when they answer
    slaves.at(5U)->refused.clear();
    slaves.at(6U)->is_sdo_mute = false;
    Run(3000U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kNone);
    EXPECT_TRUE(Of(5U).is_started);
    EXPECT_TRUE(Of(6U).is_started);
}

TEST_F(BootConditionsTest, B_AskedAgainOneSecondAfterEachSilence)
{
    Verifies(req::SRS_BOOT_004);
    Add(5U, kMust).is_sdo_mute = true;
    Begin();
    Run(2800U);
    EXPECT_EQ(Reads(5U, 0x1000U), (std::vector<std::uint32_t>{1U, 101U, 201U, 1301U, 1401U, 1501U, 2601U, 2701U}));
}

TEST_F(BootConditionsTest, EF_OneThatIsKeptAliveAndDoesNotRunIsResetInItsCommunicationAlone)
{
    Verifies(req::SRS_BOOT_006);
    Add(7U, kMust | kKeepAlive);
    Begin();
    Run(150U);
    EXPECT_EQ(Sum("82 07"), 1);
    EXPECT_EQ(Sum("81 07"), 0);
    EXPECT_EQ(Letter(7U), "-");
}

TEST_F(BootConditionsTest, G_TheTimeOfTheSoftwareAloneIsEnoughToCompare)
{
    Verifies(req::SRS_BOOT_007);
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}})
    {
        Add(node, kBoot | kVerifySoftware).Put32(0x1F52U, 2U, (node == 5U) ? 200U : 201U);
        setups[node].software.time = 200U;
    }
    // Or its date
    for (const std::uint8_t node : {std::uint8_t{7U}, std::uint8_t{8U}})
    {
        Add(node, kBoot | kVerifySoftware).Put32(0x1F52U, 1U, (node == 7U) ? 100U : 101U);
        setups[node].software.date = 100U;
    }
    Begin();
    Run(20U);
    EXPECT_EQ(Letter(5U) + Letter(7U), "--");
    EXPECT_EQ(Letter(6U) + Letter(8U), "HH");
    EXPECT_EQ(Of(8U).object.sub, 1U);
}

TEST_F(BootConditionsTest, I_NoValidProgramIsRightAfterClearingAndPollingEndsAfterOneMinute)
{
    Verifies(req::SRS_BOOT_007);
    const Octets program(20U, 0x5AU);
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}})
    {
        FakeSlave& slave = Add(node, kBoot | kVerifySoftware | kMayUpdateSoftware);
        slave.Put32(0x1F56U, 1U, 0x54U);
        slave.Put(0x1F50U, 1U, Octets{});
        slave.Put8(0x1F51U, 1U, 1U);
        slave.Put32(0x1F57U, 1U, (node == 5U) ? 0x02U : 0x01U); // No valid program; busy.
        setups[node].software.identification = 0x55U;
        setups[node].software.program = Bytes{program.data(), 20U};
    }
    Begin();
    Run(20U);
    EXPECT_EQ(Letter(5U), "I"); // Only after the program was written.
    EXPECT_EQ(slaves[5]->writes, (std::vector<std::uint32_t>{0x1F5101U, 0x1F5101U, 0x1F5001U}));
    Run(60980U);
    EXPECT_EQ(Letter(6U), "I");
    EXPECT_EQ(slaves[6]->writes, (std::vector<std::uint32_t>{0x1F5101U, 0x1F5101U}));
    EXPECT_EQ(Reads(6U, 0x1F57U).size(), 601U);
}

TEST_F(BootConditionsTest, J_ADateWithoutATimeOrTheReverseSparesNoConfiguration)
{
    Verifies(req::SRS_BOOT_008);
    Octets dcf{};
    AddEntry(dcf, 0x2000U, 0U, {0x77U});
    for (std::uint8_t node = 5U; node <= 7U; ++node)
    {
        // Given date and time of slave 7, the date of 5, the time of 6, and slaves that have just these
        FakeSlave& slave = Add(node, kBoot);
        setups[node].configuration_date = (node == 6U) ? 0U : 100U;
        setups[node].configuration_time = (node == 5U) ? 0U : 200U;
        slave.Put32(0x1020U, 1U, setups[node].configuration_date);
        slave.Put32(0x1020U, 2U, setups[node].configuration_time);
        slave.Put8(0x2000U, 0U, 0U);
        setups[node].concise_dcf = Bytes{dcf.data(), static_cast<std::uint32_t>(dcf.size())};
    }
    Begin();
    Run(20U);
    EXPECT_EQ(slaves[5]->Get(0x2000U, 0U), (Octets{0x77U}));
    EXPECT_EQ(slaves[6]->Get(0x2000U, 0U), (Octets{0x77U}));
    EXPECT_EQ(slaves[7]->Get(0x2000U, 0U), (Octets{0U}));
}

TEST_F(BootConditionsTest, J_RestoringNeedsBit7AndASubIndex)
{
    Verifies(req::SRS_BOOT_009);
    Add(5U, kBoot | kRestoreDefaults).Put32(0x1011U, 1U, 1U); // 1F8Ah says 0.
    Add(6U, kBoot).Put32(0x1011U, 1U, 1U);
    setups[6].restore_sub = 1U;
    Begin();
    Run(20U);
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}})
    {
        EXPECT_EQ(Letter(node), "-");
        EXPECT_TRUE(slaves[node]->writes.empty());
        EXPECT_EQ(slaves[node]->resets, 2); // Power-on and network.
    }
}

TEST_F(BootConditionsTest, WithBit3Of1F80hTheSlaveIsBootedAndNotStarted)
{
    Verifies(req::SRS_BOOT_014);
    setup.start_up = kIsMaster | kApplicationStartsSlaves;
    Add(5U, kMust);
    Begin();
    Run(1000U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(Of(5U).step, StartUpStep::kDone);
    EXPECT_EQ(Sum("01 05"), 0);
    EXPECT_EQ(slaves[5]->State(), cia301::NodeState::kPreOperational);
}

TEST_F(BootConditionsTest, A_NodeThatIsNotListedAndShowsOnlyAHeartbeatAndNeverThisDeviceItself)
{
    Verifies(req::SRS_BOOT_003);
    Add(5U, kBoot);
    Begin();
    Run(20U);
    EXPECT_EQ(Letter(6U), "-");
    ToManager(CanFrame{0x706U, FrameKind::kData, CanPortId::kFirst, 1U, {0x7FU}});
    EXPECT_EQ(Letter(6U), "A");
    ToManager(CanFrame{0x77FU, FrameKind::kData, CanPortId::kFirst, 1U, {0U}});
    Run(5U);
    EXPECT_EQ(Letter(127U), "-");
}

TEST_F(BootConditionsTest, OneThatIsNotToBeBootedIsAskedNothing)
{
    Verifies(req::SRS_BOOT_002);
    // Given one that comes by itself, and one that is kept alive
    Add(5U, kInNetwork).Put32(0x1000U, 0U, 0xBADU);
    Add(6U, kInNetwork | kKeepAlive).Put32(0x1000U, 0U, 0xBADU);
    Begin();
    slaves[5]->Power(Now());
    Run(100U);
    EXPECT_EQ(Count(0x605U) + Count(0x606U), 0);
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}})
    {
        EXPECT_EQ(Letter(node), "-");
        EXPECT_EQ(Of(node).step, StartUpStep::kDone);
    }
}

TEST_F(BootConditionsTest, J_AnOptionalSafetySlaveThatDiffersStopsNobodyElse)
{
    Verifies(req::SRS_BOOT_016);
    setup.start_up = kIsMaster | kStopAllOnError;
    gate.verdict = GateState::kDiffers;
    Add(5U, kBoot);
    setups[5].safety = reinterpret_cast<const SafetyExpectation*>(&gate); // Only looked at whether it is there.
    Add(6U, kMust);
    Begin();
    Run(200U);
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(Of(5U).object.index, 0x13FEU);
    EXPECT_EQ(Sum("02 00"), 0);
    EXPECT_EQ(slaves[6]->State(), cia301::NodeState::kOperational);
}

TEST_F(BootConditionsTest, TheResetOfAllNodesSparesNobodyWhoIsKeptAlive)
{
    Verifies(req::SRS_BOOT_017);
    setup.start_up = kIsMaster | kResetAllOnError;
    Add(5U, kMust).heartbeat_ms = 50U;
    setups[5].heartbeat = HeartbeatSetup{150U, 50U, Arming::kFirstHeartbeat};
    Add(6U, kBoot | kKeepAlive);
    Begin();
    Run(400U);
    ASSERT_EQ(Step(), MasterStep::kOperational);
    slaves[5]->Unplug();
    Run(200U);
    EXPECT_EQ(Sum("81 00"), 1);
    EXPECT_EQ(Sum("81 06"), 0);
}

TEST_F(BootConditionsTest, AfterAPauseOfTheManagerGuardingMakesUpForNothing)
{
    Verifies(req::SRS_NMM_023);
    Add(5U, kMust | (3U << 8U) | (100U << 16U));
    Begin();
    Run(200U);
    const int before = Count(0x705U);
    // When no cycle comes for 350 ms, then one remote frame goes out, and the next one a guard time later
    ms += 350U;
    Run(50U);
    EXPECT_EQ(Count(0x705U), before + 2); // And its answer.
    Run(100U);
    EXPECT_EQ(Count(0x705U), before + 4);
    EXPECT_EQ(Letter(5U), "-");
}

TEST_F(BootConditionsTest, WhoWasStoppedAndHasNotSaidSoYetIsWoken)
{
    Verifies(req::SRS_BOOT_004);
    Add(5U, kBoot).heartbeat_ms = 100U;
    Begin();
    Run(1000U);
    ASSERT_EQ(slaves.at(5U)->State(), cia301::NodeState::kOperational);
    // When it is booted right behind a stop, so that OPERATIONAL is the last that was heard
    EXPECT_EQ(start_up.Command(NmtCommand::kStop, NodeId{5U}, Now()), NmtAnswer::kTaken);
    Run(1U);
    EXPECT_TRUE(start_up.Boot(NodeId{5U}, Now()));
    Run(3000U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(slaves.at(5U)->State(), cia301::NodeState::kOperational);
}

TEST_F(BootConditionsTest, ALongBootTimeIsNoShortOneForWhoIsNeverSeen)
{
    Verifies(req::SRS_NMM_025);
    // Given 4294968 ms, which are 704 us behind the turn of a counter of 32 bits, and a slave that is not there
    Add(5U, kBoot);
    setup.boot_time_ms = 4'294'968U;
    Begin();
    slaves.at(5U)->Unplug();
    events.clear();
    // Then it is told after 1000 s
    Run(1'000U);
    ms += 998'000U;
    Run(1'000U);
    EXPECT_EQ(events, (std::vector<std::string>{}));
    Run(1U);
    EXPECT_EQ(events, (std::vector<std::string>{"1000001:5 8"}));
}

/// A slave that answers no SDO any more once a block download has begun.
class BootSilentBlockTest : public BootConditionsTest
{
  public:
    bool Send(const CanFrame& frame) noexcept override
    {
        const bool is_block = (frame.identifier == 0x605U) && ((frame.data[0] & 0xE1U) == 0xC0U);
        slaves.at(5U)->is_sdo_mute = slaves.at(5U)->is_sdo_mute || is_block;
        return BootRig::Send(frame);
    }
};

TEST_F(BootSilentBlockTest, I_SilenceInABlockDownloadIsNotTriedBySegments)
{
    Verifies(req::SRS_BOOT_007);
    const Octets program(20U, 0x5AU);
    FakeSlave& slave = Add(5U, kBoot | kVerifySoftware | kMayUpdateSoftware);
    slave.Put32(0x1F56U, 1U, 0x54U);
    slave.Put(0x1F50U, 1U, Octets{});
    slave.Put8(0x1F51U, 1U, 1U);
    slave.Put32(0x1F57U, 1U, 0U);
    setups[5].software.identification = 0x55U;
    setups[5].software.program = Bytes{program.data(), 20U};
    // When three tries of 100 ms are over
    Begin();
    Run(320U);
    EXPECT_EQ(Letter(5U), "I");
    EXPECT_EQ(Of(5U).object.index, 0x1F50U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kTimeOut);
}

/// Boots that are disturbed where it is least convenient.
class BootCornersTest : public BootRig
{
};

TEST_F(BootCornersTest, BootAnewDuringVerificationVerifiesAnew)
{
    Verifies(req::SRS_BOOT_013);
    Add(5U, kMust);
    Protect(5U);
    gate.cycles = 20;
    Begin();
    Run(10U);
    EXPECT_EQ(gate.State(NodeId{5U}), GateState::kBusy);
    EXPECT_TRUE(start_up.Boot(NodeId{5U}, Now()));
    EXPECT_EQ(gate.State(NodeId{5U}), GateState::kClosed);
    Run(40U);
    EXPECT_EQ(gate.verifications, 2);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
}

TEST_F(BootCornersTest, GateThatIsClosedDuringVerificationIsAskedAgain)
{
    Verifies(req::SRS_BOOT_013);
    Add(5U, kMust);
    Protect(5U);
    gate.cycles = 20;
    Begin();
    Run(10U);
    gate.Close(NodeId{5U});
    Run(40U);
    EXPECT_EQ(gate.verifications, 2);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
}

TEST_F(BootCornersTest, StartThatWaitsForTheQueueIsVerifiedAgainIfTheGateCloses)
{
    Verifies(req::SRS_NMM_120);
    Verifies(req::SRS_NMM_121);
    Add(5U, kMust);
    Protect(5U);
    gate.cycles = 5;
    Begin();
    Run(2U);
    FillQueue();
    EXPECT_EQ(nmt.Waiting(), 256U);
    // Verified while the queue is full, and kept so for a while
    for (int i = 0; i < 20; ++i)
    {
        Run(1U);
        FillQueue();
    }
    EXPECT_EQ(Of(5U).step, StartUpStep::kStart);
    gate.Close(NodeId{5U});
    Run(320U);
    // And once more when its turn comes: it waited for more than 10 ms
    EXPECT_EQ(gate.verifications, 3);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    EXPECT_EQ(nmt.Dropped(), 1U);
}

TEST_F(BootCornersTest, AStartThatWasDroppedIsNotMadeUpForWhoWasToldToStop)
{
    Verifies(req::SRS_NMM_121);
    // Given a safety slave whose start waits behind other commands, for longer than its verification is good
    Add(5U, kMust);
    Protect(5U);
    gate.cycles = 5;
    Begin();
    Run(2U);
    FillQueue(100U);
    Run(20U);
    ASSERT_TRUE(nmt.HasStart(NodeId{5U}) && !Of(5U).is_started);
    EXPECT_EQ(slaves[5]->State(), NodeState::kPreOperational);
    // When the slave is told to stop
    EXPECT_EQ(start_up.Command(NmtCommand::kStop, NodeId{5U}, Now()), NmtAnswer::kTaken);
    const int verified = gate.verifications;
    Run(320U);
    // Then the start is dropped, and nobody makes up for it
    EXPECT_EQ(nmt.Dropped(), 1U);
    EXPECT_EQ(slaves[5]->State(), NodeState::kStopped);
    EXPECT_EQ(gate.verifications, verified);
    EXPECT_FALSE(Of(5U).is_started);
}

TEST_F(BootCornersTest, AStartThatWaitsIsNoneOfASlaveThatBootsAnew)
{
    Verifies(req::SRS_NMM_122);
    // Given a safety slave whose start waits behind other commands
    Add(5U, kMust);
    Protect(5U);
    gate.cycles = 5;
    Begin();
    Run(2U);
    FillQueue(28U);
    Run(20U);
    ASSERT_TRUE(nmt.HasStart(NodeId{5U}) && !Of(5U).is_started);
    ASSERT_EQ(gate.verifications, 1);
    const int reads = Count(0x605U);
    // When it boots anew
    slaves[5]->Power(Now());
    Run(500U);
    // Then that start is dropped, it is asked who it is and verified from the beginning, and started once
    EXPECT_EQ(nmt.Dropped(), 1U);
    EXPECT_EQ(Count(0x605U), 2 * reads);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    const std::vector<std::string> commands = Commands();
    EXPECT_EQ(std::count_if(commands.begin(), commands.end(),
                            [](const std::string& command) { return command.find(":01 05") != std::string::npos; }),
              1);
}

TEST_F(BootCornersTest, ADroppedStartIsNotMadeUpForWhoBootsAnewMeanwhile)
{
    Verifies(req::SRS_NMM_122);
    // Given a safety slave whose start was dropped, and which is verified for it
    Add(5U, kMust);
    Protect(5U);
    gate.cycles = 40;
    Begin();
    Run(2U);
    FillQueue(100U);
    for (int i = 0; (i < 300) && (nmt.Dropped() == 0U); ++i)
    {
        Run(1U);
    }
    ASSERT_EQ(nmt.Dropped(), 1U);
    Run(5U);
    ASSERT_EQ(gate.State(NodeId{5U}), GateState::kBusy);
    ASSERT_EQ(gate.verifications, 2);
    const int reads = Count(0x605U);
    // When it boots anew
    slaves[5]->Power(Now());
    Run(500U);
    // Then it is asked who it is, verified and started once, from the beginning
    EXPECT_EQ(Count(0x605U), 2 * reads);
    EXPECT_EQ(gate.verifications, 3);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    const std::vector<std::string> commands = Commands();
    EXPECT_EQ(std::count_if(commands.begin(), commands.end(),
                            [](const std::string& command) { return command.find(":01 05") != std::string::npos; }),
              1);
}

TEST_F(BootCornersTest, StartOfAllWaitsForTheQueue)
{
    Verifies(req::SRS_BOOT_015);
    setup.start_up = kIsMaster | kStartAllAtOnce | kApplicationStartsSelf;
    Add(5U, kMust);
    Begin();
    Run(10U);
    EXPECT_EQ(Step(), MasterStep::kReady);
    FillQueue();
    Run(1U); // Room for the own start, and for nothing else.
    EXPECT_EQ(start_up.Command(NmtCommand::kStart, NodeId{127U}, Now()), NmtAnswer::kTaken);
    EXPECT_EQ(nmt.Waiting(), 256U);
    Run(400U);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    EXPECT_TRUE(Of(5U).is_started);
    const std::vector<std::string> commands = Commands();
    EXPECT_EQ(std::count_if(commands.begin(), commands.end(),
                            [](const std::string& line) { return line.substr(line.find(':')) == ":01 00"; }),
              1);
}

TEST_F(BootCornersTest, KeptAliveSlaveThatComesBackWithoutBootUpMessageIsNotResetAgain)
{
    Verifies(req::SRS_BOOT_006);
    Add(5U, kMust | kKeepAlive).has_boot_up = false;
    Begin();
    // It tells its state at once; then 1 s for its boot-up message
    Run(1000U);
    EXPECT_EQ(slaves[5]->State(), NodeState::kPreOperational);
    Run(100U);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    Run(1400U);
    EXPECT_EQ(slaves[5]->resets, 2); // Power-on, and once because it did not run.
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    EXPECT_EQ(Letter(5U), "-");
}

TEST_F(BootCornersTest, FlashStatusThatCannotBeRead)
{
    Verifies(req::SRS_BOOT_007);
    const Octets program(10U, 1U);
    FakeSlave& slave = Add(5U, kBoot | kVerifySoftware | kMayUpdateSoftware);
    slave.Put32(0x1F56U, 1U, 0x54U);
    slave.Put8(0x1F51U, 1U, 1U);
    setups[5].software.identification = 0x55U;
    setups[5].software.program = Bytes{program.data(), 10U};
    Begin();
    Run(20U);
    EXPECT_EQ(Letter(5U), "I");
    EXPECT_EQ(Of(5U).object.index, 0x1F57U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kObjectUnknown);
}

TEST_F(BootCornersTest, LossWhileTheSlaveIsConfiguredOnCommand)
{
    Verifies(req::SRS_BOOT_017);
    Octets dcf{};
    AddEntry(dcf, 0x2000U, 0U, {1U});
    FakeSlave& slave = Add(5U, kMust);
    slave.Put8(0x2000U, 0U, 0U);
    slave.heartbeat_ms = 50U;
    setups[5].heartbeat = HeartbeatSetup{150U, 50U, Arming::kFirstHeartbeat};
    setups[5].concise_dcf = Bytes{dcf.data(), static_cast<std::uint32_t>(dcf.size())};
    Begin();
    Run(100U);
    slave.Unplug();
    EXPECT_TRUE(start_up.Configure(NodeId{5U}, Now()));
    Run(200U);
    EXPECT_EQ(Commands().back().substr(Commands().back().find(':')), ":81 05");
    EXPECT_EQ(Of(5U).step, StartUpStep::kReset);
    slave.Power(Now());
    Run(100U);
    EXPECT_EQ(slave.State(), NodeState::kOperational);
}

TEST_F(BootCornersTest, OneBootAfterTheOtherGoesOnForHoursAcrossTheWrapOfTheCounter)
{
    Verifies(req::SRS_BOOT_004);
    // Given a boot time that is longer than the counter of time reaches: 80 minutes
    setup.boot_time_ms = 4'800'000U;
    Add(5U, kMust).is_sdo_mute = true;
    PowerAll();
    is_begun = true;
    start_up.Begin(Now());
    Run(1000U);
    // When time goes on in steps of 10 s
    std::uint32_t minutes = 0U;
    while ((Letter(5U) == "-") && (minutes < 200U))
    {
        ++minutes;
        for (int i = 0; i < 6; ++i)
        {
            ms += 9'999U;
            Run(1U);
        }
    }
    EXPECT_EQ(Letter(5U), "B");
    EXPECT_GE(minutes, 80U);
    EXPECT_LE(minutes, 81U); // Tries that were running went on.
}

} // namespace
} // namespace counterpoint::cia302
