// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// States of the PLC Designer profile that a command makes, while the command waits for the inhibit time.
#include "tests/canopen/start_up/plc_designer/rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

class PlcSentTest : public PlcRig
{
  public:
    /// What is sent now makes the next command wait for 200 ms.
    void KeepWaiting()
    {
        setup.inhibit_100us = 2000U;
        const auto answer = Do([&] { return nmt.Request(NmtCommand::kPreOperational, NodeId{99U}, Now()); });
        EXPECT_EQ(answer, NmtAnswer::kTaken);
        sent.clear();
    }
    /// Slaves 5 and 6 in the last cycle of their SDOs, and a command that was just sent.
    void BeginWithWaiting()
    {
        AddPlc(5U);
        AddPlc(6U);
        Begin();
        EXPECT_LT(RunUntil([this] { return Code(6U) == 3; }, 1000U), 1000U);
        KeepWaiting();
        Run(5U);
    }
    /// The same two in state 5.
    void BeginRunning()
    {
        AddPlc(5U);
        AddPlc(6U);
        Begin600();
        ASSERT_EQ(Code(5U), 5);
        KeepWaiting();
    }
};

TEST_F(PlcSentTest, State5BeginsWhenTheStartIsSent)
{
    Verifies(req::SRS_PLC_800);
    BeginWithWaiting();
    // While the starts wait, both slaves are in state 4
    EXPECT_EQ(Commands(), (Log{}));
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).step, StartUpStep::kStart);
    EXPECT_TRUE(Of(5U).is_busy);
    EXPECT_FALSE(Of(5U).is_started);
    // Then one after the other is in state 5
    Run(200U);
    EXPECT_EQ(Commands(), (Log{"01 05"}));
    EXPECT_EQ(Code(5U), 5);
    EXPECT_TRUE(Of(5U).is_started);
    EXPECT_FALSE(Of(5U).is_busy);
    EXPECT_EQ(Code(6U), 4);
    EXPECT_FALSE(Of(6U).is_started);
    Run(200U);
    EXPECT_EQ(Code(6U), 5);
    EXPECT_TRUE(Of(6U).is_started);
    EXPECT_EQ(told[6U], (Log{"-1", "1", "2", "3", "4", "5"}));
    EXPECT_EQ(answers[6U].back().step, StartUpStep::kRunning);
}

TEST_F(PlcSentTest, AStartThatIsOrderedWhileItWaitsIsNotAskedForTwice)
{
    Verifies(req::SRS_PLC_800);
    BeginWithWaiting();
    EXPECT_EQ(Command(NmtCommand::kStart, 6U), NmtAnswer::kTaken);
    Run(1000U);
    EXPECT_EQ(Commands(), (Log{"01 05", "01 06"}));
}

TEST_F(PlcSentTest, TheStartOfAllIsToldWhenItIsSent)
{
    Verifies(req::SRS_PLC_800);
    setup.start_up = kIsMaster | kStartAllAtOnce;
    BeginWithWaiting();
    EXPECT_EQ(Commands(), (Log{}));
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Code(6U), 4);
    EXPECT_FALSE(Of(5U).is_started || Of(6U).is_started);
    Run(200U);
    EXPECT_EQ(Commands(), (Log{"01 00"}));
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Code(6U), 5);
    EXPECT_TRUE(Of(5U).is_started && Of(6U).is_started);
}

TEST_F(PlcSentTest, AStartOfAllThatMayNotBeSentAnyMoreBecomesSingleStarts)
{
    Verifies(req::SRS_PLC_800);
    // Given a start of all that waits
    setup.start_up = kIsMaster | kStartAllAtOnce;
    BeginWithWaiting();
    // When a safety slave is assigned meanwhile
    AddSafety(7U);
    Run(199U);
    // Then it is given up, and each slave is started singly
    EXPECT_EQ(nmt.Dropped(), 1U);
    Run(200U);
    EXPECT_EQ(Commands(), (Log{"01 05", "01 06"}));
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Code(6U), 5);
}

TEST_F(PlcSentTest, AStartThatWaitsDoesNotReachASlaveThatBeginsAnew)
{
    Verifies(req::SRS_PLC_820);
    // Given the starts of 5 and 6, which wait 200 and 400 ms
    BeginWithWaiting();
    ASSERT_EQ(nmt.Waiting(), 2U);
    // When 6 comes with a boot-up message
    Put(0x706U, Octets{0x00U});
    Run(449U);
    // Then its old start is never sent
    EXPECT_EQ(Commands(), (Log{"01 05"}));
    EXPECT_EQ(Code(6U), 2);
    EXPECT_EQ(nmt.Dropped(), 1U);
    // But a new one, behind its 500 ms and its SDOs
    Run(400U);
    EXPECT_EQ(Commands(), (Log{"01 05", "01 06"}));
    EXPECT_EQ(Code(6U), 5);
    EXPECT_EQ(told[6U], (Log{"-1", "1", "2", "3", "4", "2", "3", "4", "5"}));
}

TEST_F(PlcSentTest, AStartThatWaitsDoesNotReachASlaveThatIsBootedByOrder)
{
    Verifies(req::SRS_PLC_820);
    BeginWithWaiting();
    static_cast<void>(Do([&] { return plc.Boot(NodeId{6U}, Now()); }));
    Run(450U);
    EXPECT_EQ(Commands(), (Log{"01 05", "81 06"}));
    EXPECT_EQ(Code(6U), 2);
}

TEST_F(PlcSentTest, AStartOfAllThatWaitsBecomesSingleStartsWhenASlaveBeginsAnew)
{
    Verifies(req::SRS_PLC_820);
    // Given a start of all that waits 200 ms
    setup.start_up = kIsMaster | kStartAllAtOnce;
    BeginWithWaiting();
    ASSERT_EQ(nmt.Waiting(), 1U);
    // When 6 comes with a boot-up message
    Put(0x706U, Octets{0x00U});
    Run(300U);
    // Then 5 alone is started
    EXPECT_EQ(Commands(), (Log{"01 05"}));
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Code(6U), 2);
    // And 6 when it is configured
    Run(600U);
    EXPECT_EQ(Commands(), (Log{"01 05", "01 06"}));
    EXPECT_EQ(Code(6U), 5);
}

TEST_F(PlcSentTest, TheManagerRunsWhenItsOwnStartIsObeyed)
{
    Verifies(req::SRS_PLC_821);
    AddPlc(5U);
    Begin();
    EXPECT_LT(RunUntil([this] { return Code(5U) == 3; }, 1000U), 1000U);
    // Given a command that waits 200 ms, behind which the start of this device waits
    KeepWaiting();
    static_cast<void>(Do([&] { return nmt.Request(NmtCommand::kPreOperational, NodeId{98U}, Now()); }));
    Run(100U);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(plc.MasterState(), 3);
    // Then state 5 comes with it
    Run(99U);
    EXPECT_EQ(plc.MasterState(), 3);
    Run(2U);
    EXPECT_EQ(plc.MasterState(), 5);
    EXPECT_EQ(masters.back(), "5");
}

TEST_F(PlcSentTest, State1BeginsWhenTheResetIsSent)
{
    Verifies(req::SRS_PLC_801);
    AddPlc(5U);
    AddPlc(6U);
    slaves[5]->has_boot_up = false;
    slaves[6]->has_boot_up = false;
    setup.inhibit_100us = 30000U; // 3 s
    Begin();
    Run(10U);
    EXPECT_EQ(Commands(), (Log{"81 05"}));
    EXPECT_EQ(Code(5U), 1);
    EXPECT_EQ(Code(6U), -1);
    EXPECT_EQ(Of(6U).step, StartUpStep::kReset);
    // The 2 s of state 1 begin with the reset
    Run(2900U);
    EXPECT_EQ(Code(6U), -1);
    Run(200U);
    EXPECT_EQ(Commands(), (Log{"81 05", "81 06"}));
    EXPECT_EQ(Code(6U), 1);
    EXPECT_EQ(told[6U], (Log{"-1", "1"}));
}

TEST_F(PlcSentTest, AResetByOrderIsToldWhenItIsSent)
{
    Verifies(req::SRS_PLC_801);
    BeginRunning();
    EXPECT_EQ(Command(NmtCommand::kResetCommunication, 5U), NmtAnswer::kTaken);
    Run(100U);
    EXPECT_EQ(Code(5U), -1);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kWrong);
    Run(110U);
    EXPECT_EQ(Commands(), (Log{"82 05"}));
    // And its boot-up message is the one that is waited for
    EXPECT_EQ(Code(5U), 2);
    Run(1000U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Commands(), (Log{"82 05", "01 05"}));
}

TEST_F(PlcSentTest, ABootUpMessageInTheCycleOfTheResetIsTheOneThatIsWaitedFor)
{
    Verifies(req::SRS_PLC_801);
    BeginRunning();
    EXPECT_EQ(Command(NmtCommand::kResetNode, 5U), NmtAnswer::kTaken);
    // One that comes before the reset is sent changes nothing
    Put(0x705U, {0U});
    EXPECT_EQ(Code(5U), -1);
    // When the reset is sent between two cycles, and the boot-up message comes at once
    slaves[5]->is_on = false;
    setup.inhibit_100us = 0U;
    static_cast<void>(Do(
        [this]
        {
            nmt.OnCycle(Now());
            return true;
        }));
    Put(0x705U, {0U});
    EXPECT_EQ(Code(5U), 2);
    EXPECT_EQ(Commands(), (Log{"81 05"}));
}

TEST_F(PlcSentTest, AStopBehindAResetThatWaitsHoldsTheSlave)
{
    Verifies(req::SRS_PLC_801);
    Verifies(req::SRS_PLC_030);
    BeginRunning();
    EXPECT_EQ(Command(NmtCommand::kResetNode, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(300U);
    EXPECT_EQ(Commands(), (Log{"81 05"}));
    EXPECT_EQ(Code(5U), -1);
    Run(150U);
    EXPECT_EQ(Commands(), (Log{"81 05", "02 05"}));
    EXPECT_EQ(Code(5U), 1);
    Run(5000U);
    EXPECT_EQ(Commands(), (Log{"81 05", "02 05"}));
}

TEST_F(PlcSentTest, AStartThatWaitsIsNoneOfASlaveThatIsReset)
{
    Verifies(req::SRS_PLC_801);
    // Given a safety slave whose start waits, then a reset behind it
    AddSafety(5U);
    Begin600();
    ASSERT_EQ(Code(5U), 5);
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    setup.inhibit_100us = 2000U;
    sent.clear();
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(5U);
    ASSERT_TRUE(nmt.HasStart(NodeId{5U}));
    EXPECT_EQ(Command(NmtCommand::kResetNode, 5U), NmtAnswer::kTaken);
    Run(5U);
    // Then the start is given up, and the reset goes on
    EXPECT_EQ(nmt.Dropped(), 1U);
    EXPECT_EQ(Code(5U), -1);
    Run(2000U);
    EXPECT_EQ(Commands(), (Log{"81 05", "01 05"}));
    EXPECT_EQ(Code(5U), 5);
}

TEST_F(PlcSentTest, AHeldSlaveLeavesState5WhenTheCommandIsSent)
{
    Verifies(req::SRS_PLC_802);
    BeginRunning();
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 6U), NmtAnswer::kTaken);
    Run(100U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Code(6U), 5);
    Run(110U);
    EXPECT_EQ(Commands(), (Log{"02 05"}));
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).step, StartUpStep::kManual);
    EXPECT_EQ(Code(6U), 5);
    Run(200U);
    EXPECT_EQ(Code(6U), 4);
    EXPECT_EQ(Commands(), (Log{"02 05", "80 06"}));
}

TEST_F(PlcSentTest, AStartBehindAStopThatWaitsCounts)
{
    Verifies(req::SRS_PLC_802);
    BeginRunning();
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(1000U);
    EXPECT_EQ(Commands(), (Log{"02 05", "01 05"}));
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(slaves[5]->state, 5U);
}

TEST_F(PlcSentTest, AStopBehindAStartThatWaitsCounts)
{
    Verifies(req::SRS_PLC_802);
    BeginWithWaiting();
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(1000U);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_FALSE(Of(5U).is_started);
    EXPECT_EQ(slaves[5]->state, 4U);
    EXPECT_EQ(told[5U], (Log{"-1", "1", "2", "3", "4"}));
}

TEST_F(PlcSentTest, ASlaveThatIsLostWhileItsCommandWaitsIsLost)
{
    Verifies(req::SRS_PLC_800);
    Verifies(req::SRS_PLC_802);
    BeginWithWaiting();
    plc.OnNodeEvent(NodeId{5U}, NodeEvent::kGuardLost, Now());
    Run(1000U);
    EXPECT_EQ(Code(5U), 99);
    EXPECT_FALSE(Of(5U).is_started);
    // And one that runs
    EXPECT_EQ(Code(6U), 5);
    KeepWaiting();
    EXPECT_EQ(Command(NmtCommand::kStop, 6U), NmtAnswer::kTaken);
    plc.OnNodeEvent(NodeId{6U}, NodeEvent::kGuardLost, Now());
    Run(1000U);
    EXPECT_EQ(Code(6U), 99);
    EXPECT_EQ(Of(6U).step, StartUpStep::kErrorControl);
}

} // namespace
} // namespace counterpoint::cia302
