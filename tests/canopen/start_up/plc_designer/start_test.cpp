// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// States 4, 5, 97, 98 and 99 of the slaves, commands, and safety slaves.
#include "tests/canopen/start_up/plc_designer/rig.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

class PlcStartTest : public PlcRig
{
  public:
    void ExpectRefused()
    {
        Run(100U);
        EXPECT_EQ(Code(5U), 4);
        EXPECT_EQ(Of(5U).step, StartUpStep::kSafety);
        EXPECT_EQ(Of(5U).object.index, 0x13FEU);
        EXPECT_EQ(Of(5U).expected, 0xA5U);
        EXPECT_EQ(Of(5U).read, 0U);
        EXPECT_EQ(slaves[5]->state, 4U);
    }
};

TEST_F(PlcStartTest, State4IsConfiguredAndSupervised)
{
    Verifies(req::SRS_PLC_012);
    setup.start_up = kIsMaster | kApplicationStartsSlaves;
    AddPlc(5U);
    setups[5].heartbeat = HeartbeatSetup{300U, 100U, Arming::kImmediately};
    AddPlc(6U);
    setups[6].assignment |= (100U << 16U) | (3U << 8U);
    User(5U, 0x1017U, 0U, {100U, 0U});
    Begin();
    Run(506U);
    EXPECT_EQ(nodes[5].watch, Watch::kNone);
    Run(94U);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(nodes[5].watch, Watch::kHeartbeat);
    EXPECT_EQ(nodes[6].watch, Watch::kGuarding);
    EXPECT_EQ(slaves[5]->state, 127U);
    Run(2000U);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Code(6U), 4);
}

TEST_F(PlcStartTest, State4AndSupervisionBeginWithTheAnswerToTheLastSdo)
{
    Verifies(req::SRS_PLC_012);
    setup.start_up = kIsMaster | kApplicationStartsSlaves;
    AddPlc(5U);
    setups[5].heartbeat = HeartbeatSetup{300U, 100U, Arming::kImmediately};
    for (std::uint16_t index = 0x2000U; index < 0x2003U; ++index)
    {
        User(5U, index, 0U, {1U});
    }
    Begin();
    // When it gets its SDOs, then it is not supervised as long as one of them has no answer
    for (int i = 0; (i < 1000) && (Code(5U) != 4); ++i)
    {
        EXPECT_EQ(nodes[5].watch, Watch::kNone) << us;
        RunUs(step_us);
    }
    // and with that to the last one it is
    ASSERT_EQ(Code(5U), 4);
    EXPECT_EQ(slaves[5]->log.back(), "w 2002:00 01");
    EXPECT_EQ(nodes[5].watch, Watch::kHeartbeat);
    EXPECT_EQ(slaves[5]->state, 127U);
    const std::size_t all = Times(0x605U).size();
    Run(200U);
    EXPECT_EQ(Times(0x605U).size(), all);
    // From there on its time runs: no heartbeat comes
    Run(99U);
    EXPECT_EQ(Code(5U), 4);
    Run(3U);
    EXPECT_NE(Code(5U), 4);
}

TEST_F(PlcStartTest, AutomaticStartIsState5)
{
    Verifies(req::SRS_PLC_013);
    AddPlc(5U);
    AddPlc(9U);
    slaves[9]->has_boot_up = false;
    Begin();
    Run(3000U);
    EXPECT_EQ(Nmt(), (Log{"4:81 05", "4:81 09", "508:01 05", "2506:01 09"}));
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(slaves[9]->state, 5U);
}

TEST_F(PlcStartTest, StartOfAllWaitsForAllAndIsOneCommand)
{
    Verifies(req::SRS_PLC_014);
    setup.start_up = kIsMaster | kStartAllAtOnce;
    AddPlc(5U);
    AddPlc(9U);
    AddPlc(7U);
    plc_slaves[7].is_optional = true;
    slaves[7]->is_on = false;
    slaves[9]->has_boot_up = false;
    Begin();
    Run(2990U);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Code(9U), 4);
    Run(50U);
    EXPECT_EQ(Commands(), (Log{"81 05", "81 07", "81 09", "01 00"}));
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Code(9U), 5);
    EXPECT_EQ(Code(7U), 97);
    // One that comes later is started alone
    slaves[5]->Power(Now().us);
    Run(600U);
    EXPECT_EQ(Commands().back(), "01 05");
}

TEST_F(PlcStartTest, StartOfAllIsOneByOneWithASafetySlave)
{
    Verifies(req::SRS_PLC_014);
    Verifies(req::SRS_PLC_020);
    setup.start_up = kIsMaster | kStartAllAtOnce;
    AddPlc(4U);
    AddSafety(5U);
    Begin600();
    EXPECT_EQ(Commands(), (Log{"81 04", "81 05", "01 04", "01 05"}));
    EXPECT_EQ(gate.verifications, 1);
}

TEST_F(PlcStartTest, StartOfAllIsOneByOneIfSomebodyMustNotStart)
{
    Verifies(req::SRS_PLC_014);
    setup.start_up = kIsMaster | kStartAllAtOnce;
    AddPlc(4U);
    AddPlc(5U);
    slaves[5]->Set(0x1000U, 0U, 0x192U);
    Begin600();
    EXPECT_EQ(Commands(), (Log{"81 04", "81 05", "01 04"}));
    EXPECT_EQ(Code(5U), 98);
    EXPECT_EQ(slaves[5]->state, 127U);
}

TEST_F(PlcStartTest, WithoutAutomaticStartTheApplicationStarts)
{
    Verifies(req::SRS_PLC_015);
    setup.start_up = kIsMaster | kApplicationStartsSlaves | kStartAllAtOnce;
    AddPlc(5U);
    AddPlc(9U);
    Begin();
    Run(20000U);
    EXPECT_EQ(plc.MasterState(), 5);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Commands(), (Log{"81 05", "81 09"}));
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(5U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Code(9U), 4);
    EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
    Run(5U);
    EXPECT_EQ(Commands(), (Log{"81 05", "81 09", "01 05", "01 09"}));
}

TEST_F(PlcStartTest, AnotherDeviceTypeIsState98AfterAllSdos)
{
    Verifies(req::SRS_PLC_016);
    AddPlc(5U);
    User(5U, 0x2000U, 0U, {1U});
    slaves[5]->Set(0x1000U, 0U, 0x192U);
    Begin600();
    EXPECT_EQ(slaves[5]->log, (Log{"nmt 81", "r 1000:00", "w 2000:00 01"}));
    EXPECT_EQ(Code(5U), 98);
    EXPECT_EQ(Of(5U).object.index, 0x1000U);
    EXPECT_EQ(Of(5U).expected, 0x191U);
    EXPECT_EQ(Of(5U).read, 0x192U);
    EXPECT_EQ(plc.MasterState(), 5);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kWrong);
}

TEST_F(PlcStartTest, OnlyTheLow16BitsOfTheDeviceTypeCountAndOnlyIfExpected)
{
    Verifies(req::SRS_PLC_016);
    AddPlc(5U);
    slaves[5]->Set(0x1000U, 0U, 0xFFFF0191U);
    AddPlc(6U);
    setups[6].device_type = 0U;
    AddPlc(7U);
    slaves[7]->Behave(0x1000U, 0U, Manner::kAbort);
    Begin600();
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Code(6U), 5);
    EXPECT_EQ(Code(7U), 98);
}

TEST_F(PlcStartTest, LossIsState99AndTheApplicationRestarts)
{
    Verifies(req::SRS_PLC_017);
    AddPlc(5U);
    setups[5].heartbeat = HeartbeatSetup{300U, 100U, Arming::kImmediately};
    User(5U, 0x1017U, 0U, {100U, 0U});
    Begin600();
    EXPECT_EQ(Code(5U), 5);
    slaves[5]->heartbeat_us = 0U;
    Run(350U);
    EXPECT_EQ(Code(5U), 99);
    EXPECT_FALSE(Of(5U).is_started);
    Run(5000U);
    EXPECT_EQ(Code(5U), 99);
    EXPECT_EQ(plc.MasterState(), 5);
    slaves[5]->heartbeat_us = 100000U;
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Code(5U), 4);
    Run(5U);
    EXPECT_EQ(Code(5U), 5);
    // and its supervision runs again
    slaves[5]->heartbeat_us = 0U;
    Run(350U);
    EXPECT_EQ(Code(5U), 99);
    EXPECT_EQ(told[5], (Log{"-1", "1", "2", "3", "4", "5", "99", "4", "5", "99"}));
}

TEST_F(PlcStartTest, LossOfGuardingIsState99Too)
{
    Verifies(req::SRS_PLC_017);
    setup.start_up = kIsMaster | kApplicationStartsSlaves;
    AddPlc(5U);
    setups[5].assignment |= (100U << 16U) | (3U << 8U);
    Begin600();
    EXPECT_EQ(Code(5U), 4);
    slaves[5]->answers_guard = false;
    Run(450U);
    EXPECT_EQ(Code(5U), 99);
}

TEST_F(PlcStartTest, ALateBootUpMessageConfiguresAnew)
{
    Verifies(req::SRS_PLC_018);
    AddPlc(5U);
    User(5U, 0x2000U, 0U, {1U});
    Begin600();
    ASSERT_EQ(Code(5U), 5);
    told.clear();
    slaves[5]->log.clear();
    slaves[5]->Power(Now().us);
    Run(10U);
    EXPECT_EQ(Code(5U), 2);
    // once more while it settles, and in the middle of its SDOs
    slaves[5]->Power(Now().us);
    Run(501U);
    EXPECT_EQ(Code(5U), 2);
    Run(1U);
    EXPECT_EQ(Code(5U), 3);
    slaves[5]->Power(Now().us);
    Run(600U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(slaves[5]->log, (Log{"r 1000:00", "r 1000:00", "w 2000:00 01", "nmt 01"}));
    EXPECT_EQ(told[5], (Log{"2", "3", "2", "3", "4", "5"}));
}

TEST_F(PlcStartTest, ALateBootUpMessageLeadsOutOfEachStateBehindTheFirstOnes)
{
    Verifies(req::SRS_PLC_018);
    // Given slaves in states 4 (held), 98 and 99
    AddPlc(5U);
    AddPlc(6U);
    slaves[6]->Set(0x1000U, 0U, 0x192U);
    AddPlc(7U);
    setups[7].heartbeat = HeartbeatSetup{300U, 100U, Arming::kImmediately};
    Begin();
    Run(1200U);
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    ASSERT_EQ(Code(5U), 4);
    ASSERT_EQ(Code(6U), 98);
    ASSERT_EQ(Code(7U), 99);
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}, std::uint8_t{7U}})
    {
        told[node].clear();
        slaves[node]->log.clear();
        slaves[node]->Power(Now().us);
    }
    Run(600U);
    // Then each settles, is asked and configured anew
    EXPECT_EQ(told[5], (Log{"2", "3", "4"}));
    EXPECT_EQ(told[6], (Log{"2", "3", "98"}));
    EXPECT_EQ(Log(told[7].begin(), told[7].begin() + 4), (Log{"2", "3", "4", "5"}));
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}, std::uint8_t{7U}})
    {
        EXPECT_EQ(slaves[node]->log.front(), "r 1000:00");
    }
}

TEST_F(PlcStartTest, AnAbsentOptionalSlaveIsConfiguredOnlyIfTheApplicationAsks)
{
    Verifies(req::SRS_PLC_018);
    Verifies(req::SRS_PLC_019);
    AddPlc(5U);
    plc_slaves[5].is_optional = true;
    slaves[5]->is_on = false;
    Begin();
    Run(4000U);
    ASSERT_EQ(Code(5U), 97);
    slaves[5]->Power(Now().us);
    Run(5000U);
    EXPECT_EQ(Code(5U), 97);
    EXPECT_EQ(slaves[5]->log, (Log{}));
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kWrong);
    EXPECT_TRUE(Do([this] { return plc.Boot(NodeId{5U}, Now()); }));
    EXPECT_EQ(Code(5U), -1);
    Run(600U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(slaves[5]->log, (Log{"nmt 81", "r 1000:00", "nmt 01"}));
    EXPECT_FALSE(plc.Boot(NodeId{6U}, Now()));
}

TEST_F(PlcStartTest, ASafetySlaveIsVerifiedBeforeItsStart)
{
    Verifies(req::SRS_PLC_020);
    AddSafety(5U);
    gate.cycles = 50;
    Begin();
    Run(530U);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).step, StartUpStep::kSafety);
    Run(100U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(gate.verifications, 1);
}

TEST_F(PlcStartTest, ASafetySlaveThatDiffersIsStoppedAndTheObjectIsTold)
{
    Verifies(req::SRS_PLC_020);
    AddSafety(5U);
    gate.verdict = GateState::kDiffers;
    Begin600();
    ExpectRefused();
    EXPECT_EQ(Commands(), (Log{"81 05", "02 05"}));
    EXPECT_EQ(plc.MasterState(), 5);
    // By a command likewise; a stopped one is made PRE-OPERATIONAL for it
    EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kTaken);
    ExpectRefused();
    EXPECT_EQ(Commands(), (Log{"81 05", "02 05", "80 05", "02 05"}));
    // After a boot-up message likewise, and when it cannot be read
    gate.verdict = GateState::kFailed;
    slaves[5]->Power(Now().us);
    Run(600U);
    EXPECT_EQ(Commands(), (Log{"81 05", "02 05", "80 05", "02 05", "02 05"}));
    EXPECT_EQ(Code(5U), 4);
}

TEST_F(PlcStartTest, ASafetySlaveIsVerifiedAfterALossToo)
{
    Verifies(req::SRS_PLC_020);
    AddSafety(5U);
    setups[5].heartbeat = HeartbeatSetup{300U, 100U, Arming::kImmediately};
    User(5U, 0x1017U, 0U, {100U, 0U});
    Begin600();
    EXPECT_EQ(Code(5U), 5);
    slaves[5]->heartbeat_us = 0U;
    Run(350U);
    EXPECT_EQ(Code(5U), 99);
    gate.verdict = GateState::kDiffers;
    slaves[5]->heartbeat_us = 100000U;
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    ExpectRefused();
    EXPECT_EQ(gate.verifications, 2);
}

TEST_F(PlcStartTest, ASafetySlaveFoundOperationalIsVerifiedAndStoppedIfItDiffers)
{
    Verifies(req::SRS_PLC_020);
    setup.start_up = kIsMaster | kApplicationStartsSlaves;
    AddSafety(5U);
    Begin600();
    EXPECT_EQ(Code(5U), 4);
    slaves[5]->Turn(5U);
    slaves[5]->Beat();
    Run(20U);
    EXPECT_EQ(gate.verifications, 1);
    EXPECT_EQ(Commands(), (Log{"81 05"}));
    slaves[5]->Turn(127U);
    slaves[5]->Beat();
    Run(20U);
    gate.verdict = GateState::kDiffers;
    slaves[5]->Turn(5U);
    slaves[5]->Beat();
    ExpectRefused();
    EXPECT_EQ(Commands(), (Log{"81 05", "02 05"}));
}

TEST_F(PlcStartTest, OneThatLeftState5IsVerifiedWhenItRunsAgainAndTheApplicationMayStartIt)
{
    Verifies(req::SRS_PLC_020);
    Verifies(req::SRS_PLC_013);
    AddSafety(5U);
    setups[5].heartbeat = HeartbeatSetup{1000U, 500U, Arming::kFirstHeartbeat};
    Begin600();
    slaves[5]->Beat();
    Run(20U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(gate.verifications, 1);
    // When somebody else makes it PRE-OPERATIONAL, the application starts it again
    slaves[5]->Turn(127U);
    slaves[5]->Beat();
    Run(20U);
    EXPECT_EQ(gate.State(NodeId{5U}), GateState::kClosed);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(20U);
    EXPECT_EQ(gate.verifications, 2);
    EXPECT_EQ(slaves[5]->state, 5U);
    // When it is changed meanwhile and somebody else starts it, it is stopped
    slaves[5]->Beat();
    slaves[5]->Turn(127U);
    slaves[5]->Beat();
    Run(20U);
    gate.verdict = GateState::kDiffers;
    slaves[5]->Turn(5U);
    slaves[5]->Beat();
    Run(20U);
    EXPECT_EQ(gate.verifications, 3);
    EXPECT_EQ(slaves[5]->state, 4U);
}

} // namespace
} // namespace counterpoint::cia302
