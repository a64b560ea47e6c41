// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Values of a file or a store come to the services in any order and over each other, those of clients do not.
#include "canopen/cia301/dictionary/object_kinds.hpp"
#include "canopen/cia301/emergency/consumer.hpp"
#include "canopen/cia301/nmt/heartbeat_consumer.hpp"
#include "canopen/cia301/nmt/heartbeat_producer.hpp"
#include "canopen/cia301/nmt/node_guarding.hpp"
#include "canopen/cia301/objects/service_objects.hpp"
#include "canopen/cia301/objects/service_table.hpp"
#include "canopen/cia301/sdo/client_port.hpp"
#include "canopen/cia301/sdo/server_port.hpp"
#include "canopen/cia301/time/time_stamp.hpp"
#include "tests/canopen/cia301/service_rig.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/pdo.hpp"

namespace counterpoint::cia301
{
namespace
{

class ServiceLoadingTest : public ServiceRig, public TimeListener, public EmergencyListener, public HeartbeatListener
{
  public:
    void OnTime(const TimeOfDay&, Instant) noexcept override
    {
    }
    void OnEmergency(const ReceivedEmergency&) noexcept override
    {
    }
    void OnHeartbeat(NodeId node, HeartbeatEvent event, std::uint8_t) noexcept override
    {
        told.emplace_back(node.value, event);
    }
    static CanFrame Beat(std::uint8_t node, std::uint8_t state)
    {
        return FrameOf(0x700U + node, {state});
    }

    std::vector<std::pair<std::uint8_t, HeartbeatEvent>> told{};
    std::array<SupervisedNode, 3> supervised{};
    std::array<std::uint32_t, 127> cob_ids{};
    HeartbeatConsumer consumer{SupervisedNodes{supervised.data(), 3U}, *this};
    HeartbeatProducer producer{NodeId{5U}};
    NodeGuarding guarding{NodeId{5U}};
    ServiceObjects services{ServiceParts{emergency, consumer, producer, guarding, 3U}};
    TimeStamp stamp{sink, *this};
    EmergencyConsumer heard{EmergencySources{cob_ids.data(), 127U}, *this};
};

TEST_F(ServiceLoadingTest, IdentifiersThatAreOnAreLoadedOverEachOther)
{
    Verifies(req::SRS_OBD_016);
    struct Case
    {
        NumberHook& hook;
        std::uint16_t index;
        std::uint8_t sub;
        std::uint32_t first;
        std::uint32_t second;
    };
    const Case cases[] = {{sync, 0x1005U, 0U, 0x40000080U, 0x40000085U},
                          {stamp, 0x1012U, 0U, 0x80000200U, 0x80000201U},
                          {services, 0x1014U, 0U, 0x000000C1U, 0x000000C2U},
                          {heard, 0x1028U, 7U, 0x00000087U, 0x00000097U}};
    for (const Case& one : cases)
    {
        one.hook.BeginConfiguration();
        EXPECT_EQ(Write(one.hook, one.index, one.sub, one.first), SdoAbort::kNone) << one.index;
        EXPECT_EQ(Write(one.hook, one.index, one.sub, one.second), SdoAbort::kNone) << one.index;
        EXPECT_EQ(Read(one.hook, one.index, one.sub), 0x400000000U + one.second) << one.index;
        // What the object cannot have at all is refused then, too
        EXPECT_EQ(Write(one.hook, one.index, one.sub, one.second | 0x20000000U), SdoAbort::kValueRange) << one.index;
        one.hook.EndConfiguration(nullptr);
        EXPECT_EQ(Write(one.hook, one.index, one.sub, one.first), SdoAbort::kValueRange) << one.index;
        EXPECT_EQ(Read(one.hook, one.index, one.sub), 0x400000000U + one.second) << one.index;
    }
    // 1019h while 1006h is not 0
    sync.BeginConfiguration();
    EXPECT_EQ(Write(sync, 0x1006U, 0U, 1000U), SdoAbort::kNone);
    EXPECT_EQ(Write(sync, 0x1019U, 0U, 10U), SdoAbort::kNone);
    sync.EndConfiguration(nullptr);
    EXPECT_EQ(Write(sync, 0x1019U, 0U, 11U), SdoAbort::kDeviceState);
}

TEST_F(ServiceLoadingTest, AnEmergencySourceMayBeOffWithoutAnIdentifier)
{
    Verifies(req::SRS_EMCY_006);
    EXPECT_EQ(Write(heard, 0x1028U, 7U, 0x87U), SdoAbort::kNone);
    EXPECT_EQ(Write(heard, 0x1028U, 7U, 0x80000000U), SdoAbort::kNone);
    EXPECT_EQ(Read(heard, 0x1028U, 7U), 0x480000000U);
    EXPECT_EQ(Write(heard, 0x1028U, 7U, 0x0U), SdoAbort::kValueRange);
}

TEST_F(ServiceLoadingTest, ANodeThatIsLoadedTwiceKeepsItsFirstPlace)
{
    Verifies(req::SRS_OBD_016);
    Verifies(req::SRS_HB_003);
    EXPECT_EQ(Write(services, 0x1016U, 1U, 0x00070064U), SdoAbort::kNone);
    EXPECT_EQ(Write(services, 0x1016U, 2U, 0x00070032U), SdoAbort::kIncompatible);
    services.BeginConfiguration();
    EXPECT_EQ(Write(services, 0x1016U, 2U, 0x00080032U), SdoAbort::kNone);
    EXPECT_EQ(Write(services, 0x1016U, 3U, 0x00070032U), SdoAbort::kNone);
    services.EndConfiguration(nullptr);
    consumer.EndLoad();
    EXPECT_EQ(consumer.Value(1U), 0x00070064U);
    EXPECT_EQ(consumer.Value(2U), 0x00080032U);
    EXPECT_EQ(consumer.Value(3U), 0U);
}

TEST_F(ServiceLoadingTest, TheNodeThatIsLostFirstIsToldFirstWhateverItsPlace)
{
    Verifies(req::SRS_HB_004);
    EXPECT_EQ(consumer.Write(1U, 0x00070064U), SdoAbort::kNone); // 100 ms
    EXPECT_EQ(consumer.Write(2U, 0x000800C8U), SdoAbort::kNone); // 200 ms
    consumer.OnFrame(Beat(7U, 5U), Instant{now_us});
    consumer.OnFrame(Beat(8U, 5U), Instant{now_us});
    told.clear();
    consumer.Poll(Instant{now_us + 100'000U});
    EXPECT_TRUE(told.empty());
    consumer.Poll(Instant{now_us + 100'001U});
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].first, 7U);
    consumer.Poll(Instant{now_us + 200'001U});
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(told[1].first, 8U);
}

TEST_F(ServiceLoadingTest, OnlyAHeartbeatOrABootUpMessageClearsALostNode)
{
    Verifies(req::SRS_ERR_003);
    errors.OnHeartbeat(NodeId{7U}, HeartbeatEvent::kLost, 5U);
    EXPECT_EQ(Emergency(), 0x8130U);
    errors.OnHeartbeat(NodeId{7U}, HeartbeatEvent::kChanged, 4U);
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    errors.OnHeartbeat(NodeId{7U}, HeartbeatEvent::kBootUp, 0U);
    EXPECT_EQ(Emergency(), 0x0000U);
}

TEST_F(ServiceLoadingTest, AValueThatIsAskedForAgainIsTakenAsTheFirstTime)
{
    Verifies(req::SRS_OBD_015);
    const std::uint8_t period[2] = {0x34U, 0x12U};
    EXPECT_EQ(services.OnWriteAgain(ObjectAddress{0x1017U, 0U}, Bytes{period, 2U}), SdoAbort::kNone);
    EXPECT_EQ(producer.PeriodMs(), 0x1234U);
}

TEST_F(ServiceLoadingTest, WithoutAPeriodNoSyncIsSent)
{
    Verifies(req::SRS_SYNC_003);
    EXPECT_EQ(Write(sync, 0x1005U, 0U, 0x40000080U), SdoAbort::kNone);
    Cycle();
    EXPECT_TRUE(sink.frames.empty());
    EXPECT_EQ(Write(sync, 0x1006U, 0U, 1000U), SdoAbort::kNone);
    Cycle();
    EXPECT_EQ(sink.frames.size(), 1U);
}

TEST_F(ServiceLoadingTest, ATimeThatIsNeitherHeardNorSentUsesNoIdentifier)
{
    Verifies(req::SRS_PDO_009);
    EXPECT_FALSE(stamp.Uses(0x100U));
    EXPECT_EQ(Write(stamp, 0x1012U, 0U, 0x40000100U), SdoAbort::kNone);
    EXPECT_TRUE(stamp.Uses(0x100U));
    EXPECT_FALSE(stamp.Uses(0x101U));
    EXPECT_EQ(Write(stamp, 0x1012U, 0U, 0x100U), SdoAbort::kNone);
    EXPECT_FALSE(stamp.Uses(0x100U));
}

TEST_F(ServiceLoadingTest, AStateOrServiceThatIsNoneAllowsNothing)
{
    Verifies(req::SRS_NMT_006);
    EXPECT_FALSE(IsAllowed(Service::kPdo, static_cast<NodeState>(31U)));
    EXPECT_FALSE(IsAllowed(Service::kPdo, static_cast<NodeState>(32U)));
    EXPECT_FALSE(IsAllowed(Service::kPdo, static_cast<NodeState>(37U))); // 32 above OPERATIONAL.
    EXPECT_FALSE(IsAllowed(static_cast<Service>(12U), NodeState::kOperational));
    EXPECT_TRUE(IsAllowed(Service::kPdo, NodeState::kOperational));
}

TEST_F(ServiceLoadingTest, FurtherServersAndClientsTakeOtherIdentifiersWhileTheyAreOn)
{
    Verifies(req::SRS_OBD_016);
    std::array<std::uint8_t, 16> buffer{};
    SdoServer server{SdoServerParts{dictionary, Room{buffer.data(), 16U}, 1000U, 4U}};
    SdoServerPort serves{server, sink, SdoServerNumber{1U}};
    SdoClientPort asks{SdoClientPortParts{sink, 1U, 1000U, 5U}};
    const std::pair<NumberHook*, std::uint16_t> ports[] = {{&serves, std::uint16_t{0x1201U}},
                                                           {&asks, std::uint16_t{0x1281U}}};
    for (const auto& [hook, index] : ports)
    {
        hook->BeginConfiguration();
        EXPECT_EQ(Write(*hook, index, 1U, 0x680U), SdoAbort::kNone);
        EXPECT_EQ(Write(*hook, index, 1U, 0x681U), SdoAbort::kNone);
        hook->EndConfiguration(nullptr);
        EXPECT_EQ(Write(*hook, index, 1U, 0x682U), SdoAbort::kValueRange);
        EXPECT_EQ(Read(*hook, index, 1U), 0x400000681U);
    }
}

TEST_F(ServiceLoadingTest, OnlyABootUpMessageOfItsServerEndsATransferOfAClient)
{
    Verifies(req::SRS_SDC_012);
    SdoClientPort asks{SdoClientPortParts{sink, 1U, 1000U, 5U}};
    std::array<std::uint8_t, 4> room{};
    EXPECT_FALSE(asks.Wants(0x6A0U));
    EXPECT_EQ(Write(asks, 0x1281U, 1U, 0x680U), SdoAbort::kNone);
    EXPECT_EQ(Write(asks, 0x1281U, 2U, 0x6A0U), SdoAbort::kNone);
    EXPECT_EQ(Write(asks, 0x1281U, 3U, 9U), SdoAbort::kNone);
    EXPECT_TRUE(asks.Wants(0x6A0U));
    EXPECT_TRUE(asks.Client().StartUpload({0x1000U, 0U}, {room.data(), 4U}, SdoMode::kNormal, Instant{now_us}));
    asks.OnFrame(RemoteOf(0x709U), Now());
    asks.OnFrame(FrameOf(0x709U, {0U, 0U}), Now());
    asks.OnFrame(FrameOf(0x709U, {5U}), Now());
    asks.OnFrame(FrameOf(0x708U, {0U}), Now());
    EXPECT_EQ(asks.Client().State(), SdoClientState::kBusy);
    asks.OnFrame(FrameOf(0x709U, {0U}), Now());
    EXPECT_EQ(asks.Client().State(), SdoClientState::kAborted);
    EXPECT_EQ(asks.Client().Outcome().abort, SdoAbort::kNoConnection);
}

TEST_F(ServiceLoadingTest, AClientSendsNothingWhereTheStateHasNoSdo)
{
    Verifies(req::SRS_SDC_210);
    SdoClientPort asks{SdoClientPortParts{sink, 1U, 1000U, 5U}};
    std::array<std::uint8_t, 4> room{};
    const auto ask = [&asks, &room, this]
    { return asks.Client().StartUpload({0x1000U, 0U}, {room.data(), 4U}, SdoMode::kNormal, Instant{now_us}); };
    const Moment stopped{NodeState::kStopped, Instant{now_us}};
    EXPECT_EQ(Write(asks, 0x1281U, 1U, 0x680U), SdoAbort::kNone);
    EXPECT_EQ(Write(asks, 0x1281U, 2U, 0x6A0U), SdoAbort::kNone);
    // Given a device that is STOPPED, when a transfer is started, then it ends without a frame
    asks.OnCycle(stopped);
    EXPECT_TRUE(ask());
    asks.OnCycle(stopped);
    EXPECT_EQ(asks.Client().State(), SdoClientState::kAborted);
    EXPECT_EQ(asks.Client().Outcome().abort, SdoAbort::kDeviceState);
    EXPECT_TRUE(sink.frames.empty());
    // One that is started just before the state has SDO again begins with the cycle that sees it
    EXPECT_TRUE(ask());
    EXPECT_TRUE(sink.frames.empty());
    asks.OnCycle(Now());
    ASSERT_EQ(sink.frames.size(), 1U);
    EXPECT_EQ(sink.frames[0].identifier, 0x680U);
    EXPECT_EQ(sink.frames[0].data[0], 0x40U);
    asks.Client().Cancel(SdoAbort::kGeneral);
    // And from then on at once
    sink.frames.clear();
    EXPECT_TRUE(ask());
    EXPECT_EQ(sink.frames.size(), 1U);
}

TEST(ObjectKindsTest, ObjectsThatADictionaryTreatsInAnotherWay)
{
    Verifies(req::SRS_OBD_013);
    struct Case
    {
        std::uint16_t index;
        bool is_store;
        bool is_own;
        bool is_mapping;
        bool is_count;
    };
    const Case cases[] = {{0x1000U, false, false, false, false}, {0x1001U, false, true, false, false},
                          {0x1003U, false, true, false, false},  {0x100FU, false, false, false, false},
                          {0x1010U, true, true, false, true},    {0x1011U, true, true, false, true},
                          {0x1012U, false, false, false, false}, {0x1016U, false, false, false, true},
                          {0x1028U, false, false, false, true},  {0x1029U, false, false, false, true},
                          {0x11FFU, false, false, false, false}, {0x1200U, false, true, false, true},
                          {0x1201U, false, false, false, true},  {0x12FFU, false, false, false, true},
                          {0x1300U, false, false, false, false}, {0x13FFU, false, false, false, false},
                          {0x1400U, false, false, false, true},  {0x15FFU, false, false, false, true},
                          {0x1600U, false, false, true, false},  {0x17FFU, false, false, true, false},
                          {0x1800U, false, false, false, true},  {0x19FFU, false, false, false, true},
                          {0x1A00U, false, false, true, false},  {0x1BFFU, false, false, true, false},
                          {0x1C00U, false, false, false, false}};
    for (const Case& one : cases)
    {
        EXPECT_EQ(IsStoreObject(one.index), one.is_store) << std::hex << one.index;
        EXPECT_EQ(IsOwnObject(one.index), one.is_own) << std::hex << one.index;
        EXPECT_EQ(IsPdoMapping(one.index), one.is_mapping) << std::hex << one.index;
        EXPECT_EQ(IsSubCount(ObjectAddress{one.index, 0U}), one.is_count) << std::hex << one.index;
        EXPECT_FALSE(IsSubCount(ObjectAddress{one.index, 1U})) << std::hex << one.index;
    }
}

} // namespace
} // namespace counterpoint::cia301
