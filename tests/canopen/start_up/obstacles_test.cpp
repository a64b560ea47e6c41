// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Both profiles where commands wait, where the gate closes again, and with other SDO times than their own.
#include "tests/canopen/start_up/el6751/rig.hpp"
#include "tests/canopen/start_up/plc_designer/rig.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

using El6751ObstaclesTest = El6751Rig;
using PlcObstaclesTest = PlcRig;

/// Pool that gives up after 2 s.
class PlcSlowPoolTest : public PlcRig
{
  public:
    PlcSlowPoolTest() : PlcRig(SdoTimes{2000000U, 1U})
    {
    }
};

/// Pool that gives up after 3 x 0.1 s.
class PlcFastPoolTest : public PlcRig
{
  public:
    PlcFastPoolTest() : PlcRig(SdoTimes{100000U, 3U})
    {
    }
};

// t [ms]   0       10      20          30
// frame    82 00   01 05   01 06       01 00     102Ah = 10 ms
TEST_F(El6751ObstaclesTest, AStartCountsFromWhenItLeaves)
{
    Verifies(req::SRS_ELM_026);
    Verifies(req::SRS_ELM_030);
    setup.inhibit_100us = 100U;
    AddBox(5U);
    AddBox(6U);
    Rx(6U, MakePdo(1U, 0x206U, 255U, 1U, 0U, 0U));
    Begin();
    Run(19U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(Code(6U), 8);
    EXPECT_EQ(Of(6U).step, StartUpStep::kStart);
    Run(1100U);
    EXPECT_EQ(Nmt(), (Log{"0:82 00", "10:01 05", "20:01 06", "30:01 00"}));
    // 1 s after the cycle that saw it leave, and one cycle
    EXPECT_EQ(Times(0x206U), (std::vector<std::uint32_t>{1022000U}));
}

TEST_F(El6751ObstaclesTest, AStopThatCannotBeHandedOverIsNotForgotten)
{
    Verifies(req::SRS_ELM_042);
    AddBox(5U);
    boxes[5].guard_time_ms = 100U;
    boxes[5].life_time_factor = 3U;
    Begin();
    Run(500U);
    nmt.SetActive(false);
    slaves[5]->heartbeat_us = 0U;
    Run(1000U);
    EXPECT_EQ(Code(5U), 1);
    EXPECT_TRUE(Of(5U).is_busy);
    EXPECT_EQ(Control(5U, 5U, 1U), NmtAnswer::kWrong);
    nmt.SetActive(true);
    Run(50U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(Nmt().size(), 6U);
    EXPECT_EQ(Nmt()[3], "1501:02 05");
    EXPECT_EQ(Nmt()[4], "1501:82 05");
}

TEST_F(El6751ObstaclesTest, ACommandThatCannotBeHandedOverChangesNothing)
{
    Verifies(req::SRS_ELM_047);
    AddBox(5U);
    Begin();
    Run(50U);
    nmt.SetActive(false);
    EXPECT_EQ(Control(5U, 5U, 0U), NmtAnswer::kNotActive);
    EXPECT_EQ(Control(5U, 6U, 0U), NmtAnswer::kNotActive);
    EXPECT_EQ(Do([this] { return el.Command(NmtCommand::kResetNode, NodeId{5U}, Now()); }), NmtAnswer::kNotActive);
    EXPECT_EQ(Do([this] { return el.Command(NmtCommand::kStop, kAllNodes, Now()); }), NmtAnswer::kNotActive);
    Run(50U);
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(El6751ObstaclesTest, AGateThatClosesBeforeTheStartLeavesIsAskedAgain)
{
    Verifies(req::SRS_ELM_048);
    AddSafety(5U);
    gate.cycles = 5;
    Begin();
    nmt.OnCycle(Now());
    Run(6U);
    ASSERT_EQ(gate.verifications, 1);
    // While it reads
    gate.Close(NodeId{5U});
    Run(3U);
    EXPECT_EQ(gate.verifications, 2);
    // and after it opened, while the start cannot be handed over
    nmt.SetActive(false);
    Run(20U);
    EXPECT_EQ(Of(5U).step, StartUpStep::kStart);
    EXPECT_EQ(Code(5U), 8);
    gate.Close(NodeId{5U});
    nmt.SetActive(true);
    Run(3U);
    EXPECT_EQ(gate.verifications, 3);
    EXPECT_EQ(Nmt(), (Log{"0:82 00"}));
    Run(20U);
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(El6751ObstaclesTest, HundredTwentySixSlavesAreServedAtTheSameTime)
{
    Verifies(req::SRS_ELM_150);
    for (std::uint8_t node = 1U; node < 127U; ++node)
    {
        AddBox(node);
        User(node, 0x2000U, 0U, {node});
    }
    Begin();
    Run(200U);
    int running = 0;
    for (std::uint8_t node = 1U; node < 127U; ++node)
    {
        running += (Code(node) == 0) ? 1 : 0;
    }
    EXPECT_EQ(running, 126);
    EXPECT_EQ(Nmt().back().substr(Nmt().back().find(':')), ":01 00");
}

TEST_F(El6751ObstaclesTest, BootUpMessagesWithoutEndNeitherBlockNorStart)
{
    Verifies(req::SRS_ELM_002);
    AddBox(5U);
    AddBox(6U);
    User(5U, 0x2000U, 0U, {1U});
    User(5U, 0x2001U, 0U, {1U});
    Begin();
    for (int i = 0; i < 2000; ++i)
    {
        Put(0x705U, {0U});
        Run(1U);
    }
    EXPECT_EQ(Code(6U), 0);
    EXPECT_EQ(Code(5U), 8);
    EXPECT_EQ(Nmt(), (Log{"0:82 00", "3:01 06"}));
    Run(20U);
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(PlcObstaclesTest, AStopThatCannotBeHandedOverIsNotForgotten)
{
    Verifies(req::SRS_PLC_020);
    AddSafety(5U);
    gate.verdict = GateState::kDiffers;
    gate.cycles = 50;
    Begin();
    Run(520U);
    EXPECT_EQ(Of(5U).step, StartUpStep::kSafety);
    nmt.SetActive(false);
    Run(200U);
    EXPECT_EQ(slaves[5]->state, 127U);
    nmt.SetActive(true);
    Run(5U);
    EXPECT_EQ(slaves[5]->state, 4U);
    EXPECT_EQ(Commands(), (Log{"81 05", "02 05"}));
}

TEST_F(PlcObstaclesTest, AGateThatClosesIsAskedAgain)
{
    Verifies(req::SRS_PLC_020);
    AddSafety(5U);
    gate.cycles = 5;
    Begin();
    Run(511U);
    ASSERT_EQ(gate.verifications, 1);
    gate.Close(NodeId{5U});
    Run(3U);
    EXPECT_EQ(gate.verifications, 2);
    nmt.SetActive(false);
    Run(20U);
    gate.Close(NodeId{5U});
    nmt.SetActive(true);
    Run(3U);
    EXPECT_EQ(gate.verifications, 3);
    EXPECT_EQ(Commands(), (Log{"81 05"}));
    Run(20U);
    EXPECT_EQ(Code(5U), 5);
}

TEST_F(PlcSlowPoolTest, HalfASecondIsThisProfilesOwn)
{
    Verifies(req::SRS_PLC_005);
    Verifies(req::SRS_PLC_008);
    AddPlc(5U);
    AddPlc(9U);
    plc_slaves[9].is_optional = true;
    slaves[5]->Behave(0x1000U, 0U, Manner::kSilent);
    slaves[9]->Behave(0x1000U, 0U, Manner::kSilent);
    Begin();
    Run(1005U);
    EXPECT_EQ(Code(9U), 3);
    Run(2U);
    EXPECT_EQ(Code(9U), 97);
    Run(1000U);
    EXPECT_EQ(slaves[5]->log, (Log{"nmt 81", "r 1000:00", "r 1000:00", "r 1000:00", "r 1000:00"}));
}

TEST_F(PlcFastPoolTest, HalfASecondIsThisProfilesOwn)
{
    Verifies(req::SRS_PLC_005);
    Verifies(req::SRS_PLC_008);
    AddPlc(9U);
    plc_slaves[9].is_optional = true;
    slaves[9]->is_on = false;
    Begin();
    Run(3003U);
    EXPECT_EQ(Code(9U), 3);
    Run(1U);
    EXPECT_EQ(Code(9U), 97);
}

} // namespace
} // namespace counterpoint::cia302
