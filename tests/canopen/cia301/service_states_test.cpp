// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The table of services by state, held against what the services do. SRDO and GFC are the kernel's, LSS is in the tests
// of CiA 305.
#include "canopen/cia301/emergency/consumer.hpp"
#include "canopen/cia301/nmt/heartbeat_producer.hpp"
#include "canopen/cia301/nmt/node_guarding.hpp"
#include "canopen/cia301/objects/service_table.hpp"
#include "canopen/cia301/sdo/client_port.hpp"
#include "canopen/cia301/sdo/server_port.hpp"
#include "canopen/cia301/time/time_stamp.hpp"
#include "tests/canopen/cia301/service_rig.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/node.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr NodeState kColumns[4] = {NodeState::kResetCommunication, NodeState::kPreOperational, NodeState::kOperational,
                                   NodeState::kStopped};

class Bench : public ServiceRig, public SyncListener, public EmergencyListener, public TimeListener
{
  public:
    void TestBody() override
    {
    }
    void OnSync(const SyncEvent&) noexcept override
    {
        is_heard = true;
    }
    void OnEmergency(const ReceivedEmergency&) noexcept override
    {
        is_heard = true;
    }
    void OnTime(const TimeOfDay&, Instant) noexcept override
    {
        is_heard = true;
    }
    bool SendsPdo(NodeState state)
    {
        UseTpdo(255U);
        tpdos.OnCycle({state, Instant{now_us}});
        return !sink.frames.empty();
    }
    bool AnswersPdo(NodeState state)
    {
        UseTpdo(253U);
        tpdos.OnFrame(RemoteOf(0x185U), {state, Instant{now_us}});
        return !sink.frames.empty();
    }
    bool TakesPdo(NodeState state)
    {
        UseRpdo(254U);
        rpdos.OnFrame(FrameOf(0x205U, {0x42U, 0U, 0U}), {state, Instant{now_us}});
        return u8[0] == 0x42U;
    }
    bool ServesSdo(NodeState state)
    {
        dictionary.SetNmtState(NmtState::kPreOperational);
        SdoServer server{SdoServerParts{dictionary, Room{buffer.data(), 16U}, 5000U, 127U}};
        SdoServerPort port{server, sink, NodeId{5U}};
        port.OnFrame(FrameOf(0x605U, {0x40U, 0x00U, 0x21U, 0U, 0U, 0U, 0U, 0U}), {state, Instant{now_us}});
        return !sink.frames.empty();
    }
    bool ServesFurtherSdo(NodeState state)
    {
        dictionary.SetNmtState(NmtState::kPreOperational);
        SdoServer server{SdoServerParts{dictionary, Room{buffer.data(), 16U}, 5000U, 127U}};
        SdoServerPort port{server, sink, SdoServerNumber{1U}};
        EXPECT_EQ(Write(port, 0x1201U, 1U, 0x680U), SdoAbort::kNone);
        EXPECT_EQ(Write(port, 0x1201U, 2U, 0x6A0U), SdoAbort::kNone);
        port.OnFrame(FrameOf(0x680U, {0x40U, 0x00U, 0x21U, 0U, 0U, 0U, 0U, 0U}), {state, Instant{now_us}});
        return !sink.frames.empty();
    }
    bool AsksBySdo(NodeState state)
    {
        SdoClientPort port{SdoClientPortParts{sink, 0U, 5000U, 127U}};
        EXPECT_EQ(Write(port, 0x1280U, 1U, 0x607U), SdoAbort::kNone);
        EXPECT_EQ(Write(port, 0x1280U, 2U, 0x587U), SdoAbort::kNone);
        EXPECT_TRUE(port.Client().StartUpload({0x1000U, 0U}, {buffer.data(), 16U}, SdoMode::kNormal, Instant{now_us}));
        port.OnFrame(FrameOf(0x587U, {0x4FU, 0x00U, 0x10U, 0U, 1U, 0U, 0U, 0U}), {state, Instant{now_us}});
        return port.Client().State() == SdoClientState::kDone;
    }
    bool HearsSync(NodeState state)
    {
        Sync heard{SyncParts{sink, errors, *this}};
        heard.OnFrame(FrameOf(0x80U, {}), {state, Instant{now_us}});
        return is_heard;
    }
    bool ProducesSync(NodeState state)
    {
        EXPECT_EQ(Write(sync, 0x1006U, 0U, 1000U), SdoAbort::kNone);
        EXPECT_EQ(Write(sync, 0x1005U, 0U, 0x40000080U), SdoAbort::kNone);
        sync.OnCycle({state, Instant{now_us}});
        return !sink.frames.empty();
    }
    bool HearsTime(NodeState state)
    {
        TimeStamp stamp{sink, *this};
        EXPECT_EQ(Write(stamp, 0x1012U, 0U, 0x80000100U), SdoAbort::kNone);
        stamp.OnFrame(FrameOf(0x100U, {0U, 0U, 0U, 0U, 0U, 0U}), {state, Instant{now_us}});
        return is_heard;
    }
    bool SendsTime(NodeState state)
    {
        TimeStamp stamp{sink, *this};
        EXPECT_EQ(Write(stamp, 0x1012U, 0U, 0x40000100U), SdoAbort::kNone);
        return stamp.Send({0U, 0U}, {state, Instant{now_us}});
    }
    bool SendsEmergency(NodeState state)
    {
        errors.Raise(CommunicationError::kOverrun, 0U);
        return emergency.Poll(state, Instant{now_us}).is_present;
    }
    bool HearsEmergency(NodeState state)
    {
        std::uint32_t room[1] = {};
        EmergencyConsumer consumer{EmergencySources{room, 1U}, *this};
        EXPECT_EQ(Write(consumer, 0x1028U, 1U, 0x81U), SdoAbort::kNone);
        consumer.OnFrame(FrameOf(0x81U, {0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}), {state, Instant{now_us}});
        return is_heard;
    }
    static NmtSlave SlaveIn(NodeState state)
    {
        NmtSlave node{NodeId{5U}, StartUp{false, 0U}};
        for (int i = 0; i < ((state == NodeState::kResetCommunication) ? 2 : 3); ++i)
        {
            static_cast<void>(node.Advance());
        }
        const std::uint8_t command = (state == NodeState::kOperational) ? 1U : 2U;
        if ((state == NodeState::kOperational) || (state == NodeState::kStopped))
        {
            node.OnFrame(FrameOf(0U, {command, 5U}));
        }
        EXPECT_EQ(node.State(), state);
        return node;
    }
    bool BootsUp(NodeState state)
    {
        return SlaveIn(state).Advance().is_present;
    }
    bool SendsHeartbeat(NodeState state)
    {
        HeartbeatProducer producer{NodeId{5U}};
        producer.SetPeriod(10U);
        return producer.Poll(state, Instant{now_us}).is_present;
    }
    bool IsGuarded(NodeState state)
    {
        NodeGuarding guarding{NodeId{5U}};
        return guarding.OnFrame(RemoteOf(0x705U), GuardMoment{state, 0U, Instant{now_us}}).reply.is_present;
    }
    bool ObeysNmt(NodeState state)
    {
        NmtSlave node = SlaveIn(state);
        node.OnFrame(FrameOf(0U, {129U, 0U}));
        return node.State() == NodeState::kResetApplication;
    }

    bool is_heard{false};
    std::array<std::uint8_t, 16> buffer{};
};

struct ServiceRow
{
    const char* name;
    Service service;
    bool (Bench::*acts)(NodeState);
    bool allowed[4]; ///< INITIALISATION, PRE-OPERATIONAL, OPERATIONAL, STOPPED.
};

using ServiceStates = ::testing::TestWithParam<ServiceRow>;

TEST_P(ServiceStates, AServiceActsInTheStatesOfItsRow)
{
    Verifies(req::SRS_DEV_010);
    Verifies(req::SRS_NMT_010);
    Verifies(req::SRS_NMT_006);
    const ServiceRow& row = GetParam();
    for (std::size_t column = 0U; column < 4U; ++column)
    {
        Bench bench{};
        EXPECT_EQ((bench.*row.acts)(kColumns[column]), row.allowed[column]) << column;
        EXPECT_EQ(IsAllowed(row.service, kColumns[column]), row.allowed[column]) << column;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Rows, ServiceStates,
    ::testing::Values(
        ServiceRow{"TransmitPdo", Service::kPdo, &Bench::SendsPdo, {false, false, true, false}},
        ServiceRow{"RemotePdo", Service::kPdo, &Bench::AnswersPdo, {false, false, true, false}},
        ServiceRow{"ReceivePdo", Service::kPdo, &Bench::TakesPdo, {false, false, true, false}},
        ServiceRow{"Sdo", Service::kSdo, &Bench::ServesSdo, {false, true, true, false}},
        ServiceRow{"FurtherSdo", Service::kSdo, &Bench::ServesFurtherSdo, {false, true, true, false}},
        ServiceRow{"SdoClient", Service::kSdo, &Bench::AsksBySdo, {false, true, true, false}},
        ServiceRow{"SyncConsumer", Service::kSync, &Bench::HearsSync, {false, true, true, false}},
        ServiceRow{"SyncProducer", Service::kSync, &Bench::ProducesSync, {false, true, true, false}},
        ServiceRow{"TimeConsumer", Service::kTime, &Bench::HearsTime, {false, true, true, false}},
        ServiceRow{"TimeProducer", Service::kTime, &Bench::SendsTime, {false, true, true, false}},
        ServiceRow{"EmergencyProducer", Service::kEmergency, &Bench::SendsEmergency, {false, true, true, false}},
        ServiceRow{"EmergencyConsumer", Service::kEmergency, &Bench::HearsEmergency, {false, true, true, false}},
        ServiceRow{"BootUp", Service::kBootUp, &Bench::BootsUp, {true, false, false, false}},
        ServiceRow{"Heartbeat", Service::kErrorControl, &Bench::SendsHeartbeat, {false, true, true, true}},
        ServiceRow{"Guarding", Service::kErrorControl, &Bench::IsGuarded, {false, true, true, true}},
        ServiceRow{"Nmt", Service::kNmt, &Bench::ObeysNmt, {false, true, true, true}}),
    [](const ::testing::TestParamInfo<ServiceRow>& row) { return std::string(row.param.name); });

} // namespace
} // namespace counterpoint::cia301
