// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Safety slaves in the CiA 302-2 start-up: none runs that was not verified.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

namespace counterpoint::cia302
{
namespace
{

using Lines = std::vector<std::string>;
using cia301::NodeState;

class StartUpSafetyTest : public BootRig
{
  public:
    [[nodiscard]] NodeState StateOf(std::uint8_t node) const
    {
        return slaves.at(node)->State();
    }
    void Protect(std::uint8_t node)
    {
        setups.at(node).safety =
            reinterpret_cast<const SafetyExpectation*>(&gate); // Only looked at whether it is there.
    }
    NmtAnswer Command(NmtCommand command, std::uint8_t node)
    {
        const NmtAnswer answer = start_up.Command(command, NodeId{node}, Now());
        Deliver();
        return answer;
    }
};

TEST_F(StartUpSafetyTest, SafetySlaveWithAnotherConfigurationIsNotStarted)
{
    Verifies(req::SRS_BOOT_013);
    Add(5U, kMust);
    Protect(5U);
    gate.verdict = GateState::kDiffers;
    gate.finding = GateFinding{{0x1301U, 2U}, SdoAbort::kNone, 25U, 26U};
    Begin();
    Run(20U);
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(Of(5U).step, StartUpStep::kSafety);
    EXPECT_EQ(Of(5U).object.index, 0x1301U);
    EXPECT_EQ(Of(5U).expected, 25U);
    EXPECT_EQ(Of(5U).read, 26U);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped); // It tells no state: it might run.
    EXPECT_EQ(Step(), MasterStep::kHalted);
    // Not by command either: it is verified again, and refused again
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(20U);
    EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
    Run(20U);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(gate.verifications, 3);
    EXPECT_EQ(Commands(), (Lines{"0:82 00", "1:02 05", "20:80 05", "21:02 05", "40:80 05", "41:02 05"}));
    // When it is put right
    gate.verdict = GateState::kOpen;
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(20U);
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
    // A start of a slave that runs verifies it too, and stops it if it has changed
    gate.verdict = GateState::kDiffers;
    Run(10U);
    table.WatchHeartbeat(NodeId{5U}, 100U, Arming::kFirstHeartbeat, Now());
    ToManager(cia301::ErrorControlFrame(NodeId{5U}, 5U));
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(20U);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
}

TEST_F(StartUpSafetyTest, UnfitMandatorySafetySlaveStopsAllWithBit6)
{
    Verifies(req::SRS_BOOT_013);
    Verifies(req::SRS_BOOT_017);
    setup.start_up = kIsMaster | kStopAllOnError;
    Add(5U, kMust);
    Protect(5U);
    gate.verdict = GateState::kFailed;
    Begin();
    Run(20U);
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(Step(), MasterStep::kStopped);
    EXPECT_EQ(Commands().back().substr(1U), ":02 00");
    // Somebody else starts it: one sign may be of before the stop, with the second it is verified, and stopped, too
    const CanFrame start{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 5U}};
    slaves[5]->OnFrame(start, Now());
    ToManager(cia301::ErrorControlFrame(NodeId{5U}, 5U));
    Run(5U);
    EXPECT_EQ(gate.verifications, 1);
    ToManager(cia301::ErrorControlFrame(NodeId{5U}, 5U));
    Run(5U);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(gate.verifications, 2);
}

TEST_F(StartUpSafetyTest, SafetySlaveFoundOperationalIsVerifiedAndStopped)
{
    Verifies(req::SRS_BOOT_013);
    // Given a safety slave that starts by itself, kept alive or not booted at all
    Add(5U, kInNetwork).is_self_starting = true;
    slaves[5]->heartbeat_ms = 20U;
    setups[5].heartbeat = HeartbeatSetup{100U, 20U, Arming::kFirstHeartbeat};
    Protect(5U);
    Begin();
    Run(50U);
    EXPECT_EQ(gate.verifications, 1);
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
    EXPECT_EQ(Commands(), (Lines{"0:82 00"}));
    // When somebody else stops and starts it, verification stands; after a restart it does not
    gate.verdict = GateState::kDiffers;
    slaves[5]->Power(Now());
    Run(100U);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(Letter(5U), "J");
    // When somebody else starts it again, it is stopped again
    const CanFrame start{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 5U}};
    slaves[5]->OnFrame(start, Now());
    Run(100U);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(gate.verifications, 3);
}

TEST_F(StartUpSafetyTest, KeptAliveSafetySlaveIsVerifiedToo)
{
    Verifies(req::SRS_BOOT_013);
    Add(5U, kMust | kKeepAlive);
    Protect(5U);
    PowerAll();
    Run(10U);
    const CanFrame start{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 5U}};
    slaves[5]->OnFrame(start, Now());
    gate.verdict = GateState::kDiffers;
    is_begun = true;
    start_up.Begin(Now());
    Run(100U);
    EXPECT_EQ(slaves[5]->resets, 1);
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(Step(), MasterStep::kHalted);
}

TEST_F(StartUpSafetyTest, ThatLeftOperationalIsVerifiedWhenSomebodyElseStartsIt)
{
    Verifies(req::SRS_BOOT_013);
    Add(5U, kMust);
    slaves[5]->heartbeat_ms = 20U;
    setups[5].heartbeat = HeartbeatSetup{100U, 20U, Arming::kFirstHeartbeat};
    Protect(5U);
    Begin();
    Run(100U);
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
    EXPECT_EQ(gate.verifications, 1);
    // When somebody makes it PRE-OPERATIONAL, changes it and starts it
    const CanFrame leave{0U, FrameKind::kData, CanPortId::kFirst, 2U, {128U, 5U}};
    const CanFrame start{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 5U}};
    slaves[5]->OnFrame(leave, Now());
    Run(50U);
    gate.verdict = GateState::kDiffers;
    slaves[5]->OnFrame(start, Now());
    Run(100U);
    EXPECT_EQ(gate.verifications, 2);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(Letter(5U), "J");
}

/// Given a safety slave that is kept alive and was started by somebody before the master came.
class KeptAliveSafetyTest : public StartUpSafetyTest
{
  public:
    void Meet()
    {
        setups[5].heartbeat = HeartbeatSetup{100U, 20U, Arming::kFirstHeartbeat};
        slaves[5]->heartbeat_ms = 20U;
        Protect(5U);
        PowerAll();
        Run(10U);
        const CanFrame start{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 5U}};
        slaves[5]->OnFrame(start, Now());
        is_begun = true;
        start_up.Begin(Now());
        Run(200U);
    }
};

TEST_F(KeptAliveSafetyTest, OfAnotherVendorIsVerifiedThoughItsBootFailed)
{
    Verifies(req::SRS_BOOT_013);
    Verifies(req::SRS_BOOT_016);
    Add(5U, kMust | kKeepAlive).Put32(0x1018U, 1U, 0x99U);
    Meet();
    // With the configuration that is expected it is left running, and is of another vendor all the same
    EXPECT_EQ(gate.verifications, 1);
    EXPECT_EQ(Letter(5U), "D");
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
    EXPECT_EQ(Step(), MasterStep::kHalted);
}

TEST_F(KeptAliveSafetyTest, OfAnotherVendorWithAnotherConfigurationIsStopped)
{
    Verifies(req::SRS_BOOT_013);
    gate.verdict = GateState::kDiffers;
    Add(5U, kMust | kKeepAlive).Put32(0x1018U, 1U, 0x99U);
    Meet();
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(Step(), MasterStep::kHalted);
}

TEST_F(KeptAliveSafetyTest, ThatWasFoundRunningIsStartedAgainAfterAStop)
{
    Verifies(req::SRS_BOOT_014);
    Verifies(req::SRS_BOOT_023);
    Add(5U, kMust | kKeepAlive);
    Meet();
    EXPECT_EQ(Letter(5U), "L");
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(50U);
    EXPECT_EQ(StateOf(5U), NodeState::kStopped);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(50U);
    EXPECT_EQ(StateOf(5U), NodeState::kOperational);
    EXPECT_EQ(Letter(5U), "-");
}

} // namespace
} // namespace counterpoint::cia302
