// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Boots that are disturbed where it is least convenient.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

#include <algorithm>

namespace counterpoint::cia302
{
namespace
{

using cia301::NodeState;

class BootCornersTest : public BootRig
{
  public:
    void Protect(std::uint8_t node)
    {
        setups.at(node).safety =
            reinterpret_cast<const SafetyExpectation*>(&gate); // Only looked at whether it is there.
    }
    /// As many commands in the queue as it takes, each 1 ms after the other.
    void FillQueue()
    {
        setup.inhibit_100us = 10U;
        for (int i = 0; i < 300; ++i)
        {
            static_cast<void>(nmt.Request(NmtCommand::kPreOperational, NodeId{99U}, Now()));
        }
    }
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
    Verifies(req::SRS_NMM_004);
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
    Run(2500U);
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
