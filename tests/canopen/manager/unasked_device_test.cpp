// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Safety slaves of which nobody knows whether they are the expected device, or that run while nobody can ask them.
#include "tests/canopen/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

CanFrame BootUp()
{
    return CanFrame{0x705U, FrameKind::kData, CanPortId::kFirst, 1U, {}};
}

/// Given a safety slave 5 with a heartbeat.
class UnaskedDeviceTest : public ManagerRig
{
  public:
    UnaskedDeviceTest()
    {
        Add(5U).heartbeat_ms = 100U;
        MakeSafe(5U);
        setups[5].plc = &plc;
        setups[5].el6751 = &el6751;
    }
    void Change()
    {
        devices[0]->Put(0x1301U, 2U, {26U, 0U});
    }
    /// Boot-up messages of somebody with the node-ID of the slave, and from the second one a start of somebody else.
    void Disturb(const std::uint32_t every_ms, const std::uint32_t count)
    {
        for (std::uint32_t i = 0U; i < count; ++i)
        {
            Put(BootUp());
            if (i == 0U)
            {
                Run(every_ms / 2U);
                Put(Nmt(NmtCommand::kStart, 5U));
                Run(every_ms / 2U);
            }
            else
            {
                Run(every_ms);
            }
        }
    }
    [[nodiscard]] int Code() const
    {
        return manager->Status(NodeId{5U}).code;
    }
    [[nodiscard]] bool Write()
    {
        return manager->WriteSafety(NodeId{5U}, Now());
    }

    PlcSlave plc{};
    El6751Slave el6751{};
};

TEST_F(UnaskedDeviceTest, OfAPlcSlaveThatWasAbsentIsNotWritten)
{
    Verifies(req::SRS_SFS_009);
    // Given an optional one that came too late to be asked, and is another device
    plc.is_optional = true;
    devices[0]->Put32(0x1000U, 0U, 0x192U);
    devices[0]->is_sdo_mute = true;
    Begin(Profile::kPlcDesigner);
    Run(2000U);
    EXPECT_EQ(Code(), 97);
    devices[0]->is_sdo_mute = false;
    Change();
    EXPECT_TRUE(manager->Status(NodeId{5U}).is_other);
    EXPECT_FALSE(Write());
    // When somebody else starts it, it is read, stopped, and still not written
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(1000U);
    EXPECT_EQ(Gate(), GateState::kDiffers);
    EXPECT_FALSE(Write());
    Run(1000U);
    EXPECT_EQ(devices[0]->writes, (std::vector<std::uint32_t>{}));
    // When it is the expected device and is asked
    devices[0]->PutIdentity();
    EXPECT_EQ(Order(NmtCommand::kResetNode, 5U), NmtAnswer::kTaken);
    Run(2000U);
    EXPECT_EQ(Code(), 4);
    EXPECT_FALSE(manager->Status(NodeId{5U}).is_other);
    EXPECT_TRUE(Write());
}

TEST_F(UnaskedDeviceTest, ThatReplacedADeactivatedEl6751SlaveIsNotWritten)
{
    Verifies(req::SRS_SFS_009);
    // Given one that is deactivated, and in its place another device
    el6751.restart = El6751Restart::kByHand;
    setups[5].heartbeat.consumer_ms = 300U;
    Begin(Profile::kEl6751);
    Run(1000U);
    EXPECT_EQ(Running(5U), 1);
    devices[0]->Unplug();
    Run(1000U);
    EXPECT_EQ(Code(), 1);
    EXPECT_FALSE(manager->Status(NodeId{5U}).is_other); // So far it is the one that is gone.
    devices[0]->Put32(0x1018U, 4U, 0x4321U);
    Change();
    devices[0]->Power(Now());
    Run(500U);
    EXPECT_TRUE(manager->Status(NodeId{5U}).is_other);
    EXPECT_FALSE(Write());
    Run(1000U);
    EXPECT_EQ(devices[0]->writes, (std::vector<std::uint32_t>{}));
    // A hand starts it by asking it all, and it is refused
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(1000U);
    EXPECT_EQ(Code(), 5);
    EXPECT_EQ(Running(5U), 0);
    EXPECT_FALSE(Write());
}

/// Another device with the very configuration that is expected takes the place of one that runs, and boots.
class ReplacedByHandTest : public UnaskedDeviceTest, public ::testing::WithParamInterface<El6751NodeReaction>
{
};

TEST_P(ReplacedByHandTest, IsNeitherStartedNorWrittenBeforeItWasAsked)
{
    Verifies(req::SRS_SFS_009);
    Verifies(req::SRS_ELM_002);
    el6751.restart = El6751Restart::kByHand;
    el6751.node_reaction = GetParam();
    Begin(Profile::kEl6751);
    Run(1000U);
    EXPECT_EQ(Running(5U), 1);
    starts.clear();
    devices[0]->Put32(0x1018U, 4U, 0x4321U);
    devices[0]->Power(Now());
    Run(500U);
    EXPECT_TRUE(manager->Status(NodeId{5U}).is_other);
    EXPECT_FALSE(Write());
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(1000U);
    EXPECT_EQ(Code(), 5);
    EXPECT_EQ(starts, (std::vector<std::string>{}));
    EXPECT_EQ(devices[0]->writes, (std::vector<std::uint32_t>{}));
    // When the expected one is there, a hand starts it
    devices[0]->PutIdentity();
    devices[0]->Power(Now());
    Run(500U);
    EXPECT_EQ(Running(5U), 1);
    EXPECT_FALSE(manager->Status(NodeId{5U}).is_other);
}

INSTANTIATE_TEST_SUITE_P(El6751, ReplacedByHandTest,
                         ::testing::Values(El6751NodeReaction::kStop, El6751NodeReaction::kNone));

TEST_F(UnaskedDeviceTest, OfAnEl6751SlaveThatWasHeldBeforeItsIdentityIsNotWritten)
{
    Verifies(req::SRS_SFS_009);
    // Given another device that is held while its start-up waits for its first answer
    devices[0]->Put32(0x1018U, 4U, 0x4321U);
    devices[0]->is_sdo_mute = true;
    Begin(Profile::kEl6751);
    Run(1000U);
    EXPECT_EQ(Order(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    devices[0]->is_sdo_mute = false;
    Run(100U);
    EXPECT_TRUE(manager->Status(NodeId{5U}).is_other);
    EXPECT_FALSE(Write());
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(1000U);
    EXPECT_EQ(Code(), 5);
    EXPECT_EQ(Running(5U), 0);
}

class UnaskedPlcTest : public UnaskedDeviceTest, public ::testing::WithParamInterface<std::uint32_t>
{
};

TEST_P(UnaskedPlcTest, RunsWhileBootUpMessagesKeepItFromBeingReadIsStopped)
{
    Verifies(req::SRS_SFS_006);
    // Given one that is held and was changed
    Begin(Profile::kPlcDesigner);
    Run(2000U);
    EXPECT_EQ(Order(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    Change();
    Run(10U);
    Disturb(GetParam(), 2000U / GetParam());
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kStopped);
    // When they end, it is woken and configured, and read before the start that it waits for
    Run(3000U);
    EXPECT_EQ(Code(), 4);
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kPreOperational);
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(1000U);
    EXPECT_EQ(Running(5U), 0);
    EXPECT_EQ(Gate(), GateState::kDiffers);
}

TEST_P(UnaskedPlcTest, WithoutHeartbeatAndOptionalIsStoppedLikewise)
{
    Verifies(req::SRS_SFS_006);
    // Given one that tells no state and is as it is expected
    plc.is_optional = true;
    devices[0]->heartbeat_ms = 0U;
    Begin(Profile::kPlcDesigner);
    Run(2000U);
    EXPECT_EQ(Running(5U), 1);
    Disturb(GetParam(), 2000U / GetParam());
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kStopped);
    Run(3000U);
    EXPECT_EQ(Code(), 5);
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(Gate(), GateState::kOpen);
}

TEST_F(UnaskedDeviceTest, ThatStartsItselfAndBootsOnceIsReadAsItRuns)
{
    Verifies(req::SRS_SFS_006);
    devices[0]->is_self_starting = true;
    Begin(Profile::kPlcDesigner);
    Run(2000U);
    EXPECT_EQ(Code(), 5);
    EXPECT_EQ(stops, 0);
    devices[0]->Power(Now());
    Run(2000U);
    EXPECT_EQ(Code(), 5);
    EXPECT_EQ(stops, 0);
    EXPECT_EQ(Gate(), GateState::kOpen);
}

INSTANTIATE_TEST_SUITE_P(Each, UnaskedPlcTest, ::testing::Values(16U, 100U, 450U));

/// Given 1F80h bit 1 and a mandatory slave that is not there, so that slave 5 waits for the start of all.
class WaitingForAllTest : public UnaskedDeviceTest, public ::testing::WithParamInterface<Profile>
{
  public:
    void BeginWaiting()
    {
        setup.start_up = kIsMaster | kStartAllAtOnce;
        Add(6U);
        setups[6].assignment |= kMandatory;
        Begin(GetParam());
        devices[1]->Unplug();
        Run(4000U);
    }
    void ExpectStopped()
    {
        Change();
        Put(Nmt(NmtCommand::kStart, 5U));
        EXPECT_EQ(Running(5U), 1);
        Run(1000U);
        EXPECT_EQ(Gate(), GateState::kDiffers);
        EXPECT_EQ(Running(5U), 0);
    }
};

TEST_P(WaitingForAllTest, StartedBySomebodyElseAndChangedIsStopped)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    Verifies(req::SRS_PLC_020);
    BeginWaiting();
    ASSERT_EQ(Running(5U), 0);
    ExpectStopped();
}

TEST_P(WaitingForAllTest, WithoutHeartbeatStartedBySomebodyElseAndChangedIsStopped)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    Verifies(req::SRS_PLC_020);
    devices[0]->heartbeat_ms = 0U;
    BeginWaiting();
    ExpectStopped();
}

TEST_P(WaitingForAllTest, StartedBySomebodyElseAsItIsToBeRunsOn)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    Verifies(req::SRS_PLC_020);
    BeginWaiting();
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(1000U);
    EXPECT_EQ(Gate(), GateState::kOpen);
    EXPECT_EQ(stops, 0);
    // When the one comes for whom all wait
    devices[1]->Power(Now());
    Run(6000U);
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(Running(6U), 1);
    EXPECT_EQ(stops, 0);
}

// With EL6751 nobody waits for another slave.
INSTANTIATE_TEST_SUITE_P(Profiles, WaitingForAllTest, ::testing::Values(Profile::kCia302, Profile::kPlcDesigner));

} // namespace
} // namespace counterpoint::cia302
