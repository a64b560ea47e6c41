// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Defects that other stacks had, each with a test that it is not here. Those of masters are in the tests of CiA 302.
#include "canopen/cia301/nmt/node_guarding.hpp"
#include "tests/canopen/cia301/service_rig.hpp"
#include "verification/trace/ids/cia301.hpp"

namespace counterpoint::cia301
{
namespace
{

class KnownDefects : public ServiceRig, public HeartbeatListener
{
  public:
    KnownDefects()
    {
        EXPECT_EQ(consumer.Write(1U, 0x00070064U), SdoAbort::kNone); // node 7, 100 ms
    }
    void OnHeartbeat(NodeId, HeartbeatEvent event, std::uint8_t state) noexcept override
    {
        events.push_back(event);
        states.push_back(state);
    }
    void Beat(std::uint8_t state)
    {
        consumer.OnFrame(FrameOf(0x707U, {state}), Instant{now_us});
    }

    std::vector<HeartbeatEvent> events{};
    std::vector<std::uint8_t> states{};
    std::array<SupervisedNode, 1> room{};
    HeartbeatConsumer consumer{SupervisedNodes{room.data(), 1U}, *this};
};

TEST_F(KnownDefects, ASecondNmtCommandBeforeTheNextCycleOverwritesTheFirst)
{
    Verifies(req::SRS_NMT_003);
    // Reset communication and start, both before anybody looks: the start comes during INITIALISATION and is not obeyed
    Command(130U);
    Command(1U);
    EXPECT_EQ(slave.State(), NodeState::kResetCommunication);
    EXPECT_TRUE(slave.Advance().is_present);
    EXPECT_EQ(slave.State(), NodeState::kPreOperational);
}

TEST_F(KnownDefects, TheCommandIsReadBeforeTheLengthIsKnown)
{
    Verifies(req::SRS_NMT_004);
    for (std::uint8_t length = 0U; length <= 8U; ++length)
    {
        CanFrame frame = FrameOf(0U, {2U, 5U});
        frame.length_bytes = length;
        if (length != 2U)
        {
            slave.OnFrame(frame);
        }
    }
    EXPECT_EQ(slave.State(), NodeState::kOperational);
}

TEST_F(KnownDefects, GfcAndTheFlyingMasterAreTakenForNmtCommands)
{
    Verifies(req::SRS_NMT_004);
    // 001h to 07Fh, GFC (001h), 071h to 076h and 07Fh among them, with what would be a stop
    for (std::uint32_t identifier = 0x001U; identifier <= 0x07FU; ++identifier)
    {
        slave.OnFrame(FrameOf(identifier, {2U, 5U}));
        slave.OnFrame(FrameOf(identifier, {2U, 0U}));
    }
    EXPECT_EQ(slave.State(), NodeState::kOperational);
}

TEST_F(KnownDefects, OneEmergencyStandsForAllMonitoredNodes)
{
    Verifies(req::SRS_ERR_003);
    errors.OnHeartbeat(NodeId{7U}, HeartbeatEvent::kLost, 5U);
    errors.OnHeartbeat(NodeId{8U}, HeartbeatEvent::kLost, 5U);
    EXPECT_EQ(emergency.History(0U).value, 2U);
    // One that comes back does not take the other's error away
    errors.OnHeartbeat(NodeId{7U}, HeartbeatEvent::kStarted, 5U);
    EXPECT_EQ(emergency.Register(), 0x11U);
    errors.OnHeartbeat(NodeId{8U}, HeartbeatEvent::kStarted, 5U);
    EXPECT_EQ(emergency.Register(), 0x00U);
}

TEST_F(KnownDefects, AStartUpObjectThatIsNotThereStartsTheNode)
{
    Verifies(req::SRS_NMT_005);
    NmtSlave without{NodeId{5U}, StartUp{false, 0U}};
    for (int step = 0; step < 3; ++step)
    {
        static_cast<void>(without.Advance());
    }
    EXPECT_EQ(without.State(), NodeState::kPreOperational);
}

TEST_F(KnownDefects, ABootUpIsLostIfAHeartbeatFollowsInTheSameCycle)
{
    Verifies(req::SRS_HB_005);
    Beat(5U);
    Beat(0U);
    Beat(127U);
    EXPECT_EQ(events, (std::vector<HeartbeatEvent>{HeartbeatEvent::kStarted, HeartbeatEvent::kBootUp,
                                                   HeartbeatEvent::kStarted}));
}

TEST_F(KnownDefects, ABootUpIsShownAsPreOperational)
{
    Verifies(req::SRS_HB_005);
    Beat(0U);
    EXPECT_EQ(events.back(), HeartbeatEvent::kBootUp);
    EXPECT_EQ(states.back(), 0U);
}

TEST_F(KnownDefects, HeartbeatsAreNotSupervisedInStopped)
{
    Verifies(req::SRS_HB_004);
    Command(2U);
    EXPECT_EQ(slave.State(), NodeState::kStopped);
    Beat(5U);
    now_us += 100001U;
    consumer.Poll(Instant{now_us});
    EXPECT_EQ(events.back(), HeartbeatEvent::kLost);
}

TEST_F(KnownDefects, ALossIsNeverTakenBack)
{
    Verifies(req::SRS_ERR_003);
    errors.OnHeartbeat(NodeId{7U}, HeartbeatEvent::kLost, 5U);
    EXPECT_EQ(emergency.Register(), 0x11U);
    errors.OnHeartbeat(NodeId{7U}, HeartbeatEvent::kStarted, 5U);
    EXPECT_EQ(emergency.Register(), 0x00U);
}

TEST_F(KnownDefects, TheToggleIsMaskedAway)
{
    Verifies(req::SRS_GRD_001);
    Verifies(req::SRS_HB_006);
    NodeGuarding guarding{NodeId{5U}};
    const GuardMoment moment{NodeState::kOperational, 0U, Instant{now_us}};
    EXPECT_EQ(guarding.OnFrame(RemoteOf(0x705U), moment).reply.frame.data[0], 0x05U);
    EXPECT_EQ(guarding.OnFrame(RemoteOf(0x705U), moment).reply.frame.data[0], 0x85U);
    // and a guarding answer of another node is not taken for its heartbeat
    Beat(0x85U);
    EXPECT_TRUE(events.empty());
}

TEST_F(KnownDefects, TheToggleStartsAnewAfterAGuardEvent)
{
    Verifies(req::SRS_GRD_001);
    NodeGuarding guarding{NodeId{5U}};
    guarding.SetLifeTime(100U, 1U);
    EXPECT_EQ(guarding.OnFrame(RemoteOf(0x705U), {NodeState::kOperational, 0U, Instant{now_us}}).reply.frame.data[0],
              0x05U);
    now_us += 100001U;
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{now_us}}), GuardEvent::kLost);
    EXPECT_EQ(guarding.OnFrame(RemoteOf(0x705U), {NodeState::kOperational, 0U, Instant{now_us}}).reply.frame.data[0],
              0x85U); // only a reset starts it anew
}

TEST_F(KnownDefects, GuardTimesAbove4294SecondsOverflow)
{
    Verifies(req::SRS_GRD_002);
    NodeGuarding guarding{NodeId{5U}};
    guarding.SetLifeTime(65535U, 255U); // 16 711 s
    static_cast<void>(guarding.OnFrame(RemoteOf(0x705U), {NodeState::kOperational, 0U, Instant{now_us}}));
    for (int i = 0; i < 16711; ++i)
    {
        now_us += 1000000U;
        EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{now_us}}), GuardEvent::kNone);
    }
    now_us += 1000000U;
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{now_us}}), GuardEvent::kLost);
}

TEST_F(KnownDefects, EnteringPreOperationalResetsTheNode)
{
    Verifies(req::SRS_NMT_003);
    UseTpdo(255U);
    Command(128U);
    EXPECT_EQ(slave.State(), NodeState::kPreOperational);
    EXPECT_FALSE(slave.Advance().is_present);
    EXPECT_EQ(Read(objects, 0x1800U, 1U), 0x400000185U);
}

} // namespace
} // namespace counterpoint::cia301
