// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Safety slaves: no way to a start that does not lead through the gate.
#include "tests/canopen/start_up/el6751/rig.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

class El6751SafetyTest : public El6751Rig
{
  public:
    /// Runs, verified once.
    void Ready()
    {
        AddSafety(5U);
        Begin();
        Run(100U);
        EXPECT_EQ(Code(5U), 0);
        EXPECT_EQ(gate.verifications, 1);
        sent.clear();
        told.clear();
    }
    void ExpectRefused(const std::uint16_t index)
    {
        Run(100U);
        EXPECT_EQ(Code(5U), 5);
        EXPECT_EQ(Of(5U).step, StartUpStep::kSafety);
        EXPECT_EQ(Of(5U).object.index, index);
        EXPECT_EQ(Of(5U).expected, 0xA5U);
        EXPECT_EQ(Of(5U).read, 0U);
        EXPECT_EQ(slaves[5]->state, 4U);
        EXPECT_FALSE(Of(5U).is_started);
    }
};

TEST_F(El6751SafetyTest, StartsAfterVerificationAndOnlySingly)
{
    Verifies(req::SRS_ELM_048);
    AddSafety(5U);
    gate.cycles = 20;
    Begin();
    Run(15U);
    EXPECT_EQ(Of(5U).step, StartUpStep::kSafety);
    EXPECT_EQ(Code(5U), 8);
    EXPECT_EQ(Commands(), (Log{"82 00"}));
    Run(30U);
    EXPECT_EQ(Commands(), (Log{"82 00", "01 05"}));
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(nodes[127].asked, SlaveState::kOperational); // This device itself is started, too.
}

TEST_F(El6751SafetyTest, ADifferenceStopsItAndNamesTheObject)
{
    Verifies(req::SRS_ELM_048);
    AddSafety(5U);
    gate.verdict = GateState::kDiffers;
    Begin();
    ExpectRefused(0x13FEU);
    EXPECT_EQ(Commands(), (Log{"82 00", "02 05"}));
    EXPECT_EQ(el.Cause(NodeId{5U}), 5);
}

TEST_F(El6751SafetyTest, AnObjectThatCannotBeReadIsNodeState4)
{
    Verifies(req::SRS_ELM_048);
    AddSafety(5U);
    gate.verdict = GateState::kFailed;
    gate.finding = GateFinding{{0x13FFU, 2U}, SdoAbort::kSubUnknown, 0U, 0U};
    Begin();
    Run(100U);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).object.sub, 2U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kSubUnknown);
    EXPECT_EQ(Commands(), (Log{"82 00", "02 05"}));
}

TEST_F(El6751SafetyTest, ARestartAfterAnErrorIsVerifiedAgain)
{
    Verifies(req::SRS_ELM_048);
    boxes[5].guard_time_ms = 100U;
    boxes[5].life_time_factor = 3U;
    Ready();
    gate.verdict = GateState::kDiffers;
    slaves[5]->heartbeat_us = 0U;
    Run(400U);
    ExpectRefused(0x13FEU);
    EXPECT_EQ(gate.verifications, 2);
    EXPECT_EQ(Commands(), (Log{"02 05", "82 05", "02 05"}));
    EXPECT_EQ(told[5], (Log{"1", "8", "5"}));
}

TEST_F(El6751SafetyTest, ABootUpMessageIsVerifiedAgain)
{
    Verifies(req::SRS_ELM_048);
    Ready();
    gate.verdict = GateState::kDiffers;
    slaves[5]->Power(Now().us);
    ExpectRefused(0x13FEU);
    EXPECT_EQ(Commands(), (Log{"02 05"}));
}

TEST_F(El6751SafetyTest, AStartByHandFromPreOperationalIsVerified)
{
    Verifies(req::SRS_ELM_048);
    Ready();
    EXPECT_EQ(Control(5U, 5U, 0U), NmtAnswer::kTaken);
    Run(10U);
    gate.verdict = GateState::kDiffers;
    EXPECT_EQ(Control(5U, 5U, 1U), NmtAnswer::kTaken);
    ExpectRefused(0x13FEU);
    EXPECT_EQ(Commands(), (Log{"80 05", "02 05"}));
}

TEST_F(El6751SafetyTest, AStartByHandFromStoppedIsMadePreOperationalAndVerified)
{
    Verifies(req::SRS_ELM_048);
    Ready();
    EXPECT_EQ(Control(5U, 6U, 0U), NmtAnswer::kTaken);
    Run(10U);
    EXPECT_EQ(Control(5U, 5U, 3U), NmtAnswer::kTaken);
    Run(20U);
    EXPECT_EQ(Commands(), (Log{"02 05", "80 05", "01 05"}));
    EXPECT_EQ(gate.verifications, 2);
    EXPECT_EQ(Code(5U), 0);
    // And refused
    EXPECT_EQ(Control(5U, 6U, 0U), NmtAnswer::kTaken);
    Run(10U);
    gate.verdict = GateState::kDiffers;
    EXPECT_EQ(Control(5U, 5U, 3U), NmtAnswer::kTaken);
    ExpectRefused(0x13FEU);
    // With reset communication likewise
    EXPECT_EQ(Control(5U, 5U, 1U), NmtAnswer::kTaken);
    ExpectRefused(0x13FEU);
    EXPECT_EQ(Commands(), (Log{"02 05", "80 05", "01 05", "02 05", "80 05", "02 05", "82 05", "02 05"}));
}

TEST_F(El6751SafetyTest, ACommandIsVerifiedToo)
{
    Verifies(req::SRS_ELM_048);
    Ready();
    gate.verdict = GateState::kDiffers;
    const auto command = [this](const NmtCommand what, const std::uint8_t node)
    { return Do([&] { return el.Command(what, NodeId{node}, Now()); }); };
    EXPECT_EQ(command(NmtCommand::kPreOperational, 0U), NmtAnswer::kTaken);
    EXPECT_EQ(command(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
    ExpectRefused(0x13FEU);
    EXPECT_EQ(Commands(), (Log{"80 05", "02 05"}));
}

TEST_F(El6751SafetyTest, FoundOperationalThoughNobodyStartedItIsVerified)
{
    Verifies(req::SRS_ELM_049);
    AddSafety(5U);
    boxes[5].is_started = false;
    Begin();
    Run(50U);
    EXPECT_EQ(Code(5U), 12);
    EXPECT_EQ(gate.verifications, 0);
    // Given that it starts by itself with the right configuration: it is left alone
    slaves[5]->Turn(5U);
    slaves[5]->heartbeat_us = 100000U;
    Run(500U);
    EXPECT_EQ(gate.verifications, 1);
    EXPECT_EQ(slaves[5]->state, 5U);
    EXPECT_EQ(Commands(), (Log{"82 00"}));
    // and stopped with a wrong one
    slaves[5]->Turn(127U);
    Run(150U);
    gate.verdict = GateState::kDiffers;
    slaves[5]->Turn(5U);
    Run(150U);
    EXPECT_EQ(gate.verifications, 2);
    EXPECT_EQ(slaves[5]->state, 4U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Commands(), (Log{"82 00", "02 05"}));
}

TEST_F(El6751SafetyTest, FoundOperationalAfterARefusalIsStoppedAgain)
{
    Verifies(req::SRS_ELM_049);
    AddSafety(5U);
    gate.verdict = GateState::kDiffers;
    Begin();
    ExpectRefused(0x13FEU);
    slaves[5]->Turn(5U);
    slaves[5]->Beat();
    Run(20U);
    EXPECT_EQ(Commands(), (Log{"82 00", "02 05"})); // That sign may be of before the stop.
    slaves[5]->Beat();
    Run(20U);
    EXPECT_EQ(slaves[5]->state, 4U);
    EXPECT_EQ(Commands(), (Log{"82 00", "02 05", "02 05"}));
}

TEST_F(El6751SafetyTest, TheSilenceOfAStoppedSlaveKeepsWhatWasFound)
{
    Verifies(req::SRS_ELM_049);
    AddSafety(5U);
    gate.verdict = GateState::kDiffers;
    Begin();
    ExpectRefused(0x13FEU);
    // When somebody's start is heard behind the stop, though it was before it on the bus
    const GateFinding silence{{0x13FFU, 1U}, SdoAbort::kTimeOut, 0U, 0U};
    gate.verdict = GateState::kFailed;
    gate.finding = silence;
    Put(0U, {1U, 5U});
    table.Presume(NodeId{5U}, Now());
    ExpectRefused(0x13FEU);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kNone);
    EXPECT_EQ(el.Cause(NodeId{5U}), 5);
    EXPECT_EQ(gate.verifications, 2);
    EXPECT_EQ(Commands(), (Log{"82 00", "02 05", "02 05"}));
    // When it says itself that it runs, it should have answered
    slaves[5]->Turn(5U);
    slaves[5]->Beat();
    slaves[5]->Beat();
    Run(100U);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).object.index, 0x13FFU);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kTimeOut);
    EXPECT_EQ(Commands(), (Log{"82 00", "02 05", "02 05", "02 05"}));
}

TEST_F(El6751SafetyTest, StoppedBehindItsBootUpMessageItIsWokenToBeAsked)
{
    Verifies(req::SRS_ELM_003);
    AddSafety(5U);
    gate.verdict = GateState::kDiffers;
    Begin();
    ExpectRefused(0x13FEU);
    // When it had restarted by itself, and takes the stop behind its boot-up message
    gate.verdict = GateState::kOpen;
    slaves[5]->heartbeat_us = 100000U;
    Put(0x705U, {0U});
    Run(1900U);
    EXPECT_EQ(Code(5U), 8);
    EXPECT_EQ(Commands(), (Log{"82 00", "02 05"}));
    // Then silence is not the end
    Run(2200U);
    EXPECT_EQ(told[5], (Log{"8", "5", "8", "2", "8", "0"}));
    EXPECT_EQ(Commands(), (Log{"82 00", "02 05", "80 05", "01 05"}));
}

} // namespace
} // namespace counterpoint::cia302
