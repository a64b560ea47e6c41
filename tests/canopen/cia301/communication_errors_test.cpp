// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/emergency/consumer.hpp"
#include "tests/canopen/cia301/service_rig.hpp"
#include "verification/trace/ids/cia301.hpp"

namespace counterpoint::cia301
{
namespace
{

class CommunicationErrorsTest : public ServiceRig, public EmergencyListener
{
  public:
    void OnEmergency(const ReceivedEmergency& received) noexcept override
    {
        heard.push_back(received);
    }

    std::vector<ReceivedEmergency> heard{};
};

struct CodeCase
{
    CommunicationError error;
    std::uint32_t code;
    bool leaves;
};

TEST_F(CommunicationErrorsTest, CodeAndBehaviourOfEachError)
{
    Verifies(req::SRS_ERR_001);
    Verifies(req::SRS_ERR_002);
    constexpr CodeCase kCases[] = {
        {CommunicationError::kOverrun, 0x8110U, false},    {CommunicationError::kPassive, 0x8120U, false},
        {CommunicationError::kLifeGuard, 0x8130U, true},   {CommunicationError::kHeartbeat, 0x8130U, true},
        {CommunicationError::kCollision, 0x8150U, false},  {CommunicationError::kPdoShort, 0x8210U, false},
        {CommunicationError::kPdoLong, 0x8220U, false},    {CommunicationError::kSyncLength, 0x8240U, false},
        {CommunicationError::kRpdoTimeOut, 0x8250U, false}};
    for (const CodeCase& one : kCases)
    {
        Command(1U);
        errors.Raise(one.error, 0x0142U);
        EXPECT_EQ(emergency.Register(), 0x11U);
        EXPECT_EQ(Emergency(), one.code);
        EXPECT_EQ(source, 0x42U);
        EXPECT_EQ(source_high, 0x01U);
        EXPECT_EQ(error_register, 0x11U);
        EXPECT_EQ(slave.State(), one.leaves ? NodeState::kPreOperational : NodeState::kOperational) << one.code;
        errors.Clear(one.error, 0x0142U);
        EXPECT_EQ(Emergency(), 0x0000U);
        EXPECT_EQ(emergency.Register(), 0U);
    }
    errors.Raise(CommunicationError::kInvalid, 0U);
    errors.Raise(static_cast<CommunicationError>(11U), 0U);
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
}

TEST_F(CommunicationErrorsTest, BusOffIsToldWhenItIsOver)
{
    Verifies(req::SRS_ERR_001);
    Verifies(req::SRS_ERR_002);
    errors.Raise(CommunicationError::kBusOff, 0U);
    EXPECT_EQ(slave.State(), NodeState::kPreOperational);
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    errors.Clear(CommunicationError::kBusOff, 0x0201U);
    EXPECT_EQ(Emergency(), 0x8140U);
    EXPECT_EQ(error_register, 0x11U);
    EXPECT_EQ(source, 0x01U);
    EXPECT_EQ(source_high, 0x02U);
    EXPECT_EQ(Emergency(), 0x0000U);
    EXPECT_EQ(emergency.Register(), 0U);
}

TEST_F(CommunicationErrorsTest, EachBehaviourIsThatOfEachSource)
{
    Verifies(req::SRS_ERR_002);
    constexpr NodeState kAfter[] = {NodeState::kPreOperational, NodeState::kOperational, NodeState::kStopped};
    for (std::uint8_t behaviour = 0U; behaviour <= 2U; ++behaviour)
    {
        // Given 1029h:01, when bus-off, lost guarding or a lost heartbeat comes, then it is left for that state
        EXPECT_EQ(Write(errors, 0x1029U, 1U, behaviour), SdoAbort::kNone);
        for (const CommunicationError error :
             {CommunicationError::kBusOff, CommunicationError::kLifeGuard, CommunicationError::kHeartbeat})
        {
            Command(1U);
            errors.Raise(error, 7U);
            EXPECT_EQ(slave.State(), kAfter[behaviour]) << int{behaviour} << static_cast<int>(error);
            errors.Clear(error, 7U);
        }
        // Given one of 1029h:02 to 06, and all others otherwise, when an error of its class comes, then that one counts
        for (std::uint8_t error_class = 2U; error_class <= 6U; ++error_class)
        {
            for (std::uint8_t sub = 1U; sub <= 6U; ++sub)
            {
                const std::uint32_t next = (behaviour + 1U) % 3U;
                EXPECT_EQ(Write(errors, 0x1029U, sub, (sub == error_class) ? behaviour : next), SdoAbort::kNone);
            }
            Command(1U);
            errors.OnDeviceError(error_class);
            EXPECT_EQ(slave.State(), kAfter[behaviour]) << int{behaviour} << int{error_class};
        }
    }
}

TEST_F(CommunicationErrorsTest, NoOtherBehaviourIsTakenAndNoOtherStateIsLeft)
{
    Verifies(req::SRS_ERR_002);
    for (std::uint8_t sub = 1U; sub <= 6U; ++sub)
    {
        for (const std::uint32_t value : {3U, 4U, 0x80U, 0xFFU})
        {
            EXPECT_EQ(Write(errors, 0x1029U, sub, value), SdoAbort::kValueRange) << int{sub} << " " << value;
        }
        EXPECT_EQ(Read(errors, 0x1029U, sub), 0x100000000U);
    }
    // Given a device in STOPPED, then it is not PRE-OPERATIONAL by an error
    Command(2U);
    errors.Raise(CommunicationError::kHeartbeat, 7U);
    EXPECT_EQ(slave.State(), NodeState::kStopped);
}

TEST_F(CommunicationErrorsTest, TheBehaviourIsChosenByTheClass)
{
    Verifies(req::SRS_ERR_002);
    EXPECT_EQ(Read(errors, 0x1029U, 0U), 0x100000006U);
    EXPECT_EQ(Read(errors, 0x1029U, 1U), 0x100000000U);
    EXPECT_EQ(Write(errors, 0x1029U, 1U, 2U), SdoAbort::kNone);
    EXPECT_EQ(Write(errors, 0x1029U, 2U, 1U), SdoAbort::kNone);
    EXPECT_EQ(Write(errors, 0x1029U, 1U, 3U), SdoAbort::kValueRange);
    EXPECT_EQ(Write(errors, 0x1029U, 0U, 1U), SdoAbort::kReadOnly);
    EXPECT_EQ(Write(errors, 0x1029U, 7U, 1U), SdoAbort::kSubUnknown);
    EXPECT_EQ(Write(errors, 0x102AU, 1U, 1U), SdoAbort::kObjectUnknown);
    errors.OnDeviceError(2U);
    errors.OnDeviceError(0U);
    errors.OnDeviceError(7U);
    EXPECT_EQ(slave.State(), NodeState::kOperational);
    errors.OnDeviceError(6U);
    EXPECT_EQ(slave.State(), NodeState::kPreOperational);
    errors.Raise(CommunicationError::kLifeGuard, 0U);
    EXPECT_EQ(slave.State(), NodeState::kPreOperational); // only OPERATIONAL is left
    Command(1U);
    errors.Raise(CommunicationError::kLifeGuard, 0U);
    EXPECT_EQ(slave.State(), NodeState::kStopped);
    errors.Reset();
    EXPECT_EQ(Read(errors, 0x1029U, 1U), 0x100000000U);
}

// Defect of other stacks: one emergency bit for all supervised nodes, and one that is never reset.
TEST_F(CommunicationErrorsTest, EachLostNodeIsAnErrorOfItsOwn)
{
    Verifies(req::SRS_ERR_003);
    Verifies(req::SRS_EMCY_007);
    SupervisedNode room[2] = {};
    HeartbeatConsumer consumer{SupervisedNodes{room, 2U}, errors};
    EXPECT_EQ(consumer.Write(1U, 0x00070064U), SdoAbort::kNone);
    EXPECT_EQ(consumer.Write(2U, 0x00080064U), SdoAbort::kNone);
    consumer.OnFrame(FrameOf(0x707U, {5U}), Instant{now_us});
    consumer.OnFrame(FrameOf(0x708U, {5U}), Instant{now_us});
    now_us += 100001U;
    consumer.Poll(Instant{now_us});
    EXPECT_EQ(Emergency(), 0x8130U);
    EXPECT_EQ(source, 7U);
    EXPECT_EQ(Emergency(), 0x8130U);
    EXPECT_EQ(source, 8U);
    consumer.OnFrame(FrameOf(0x707U, {5U}), Instant{now_us});
    EXPECT_EQ(Emergency(), 0x0000U);
    EXPECT_EQ(emergency.Register(), 0x11U); // node 8 is still lost
    consumer.OnFrame(FrameOf(0x708U, {0U}), Instant{now_us});
    EXPECT_EQ(Emergency(), 0x0000U);
    EXPECT_EQ(emergency.Register(), 0U);
    // A second loss is told again
    now_us += 100001U;
    consumer.Poll(Instant{now_us});
    EXPECT_EQ(Emergency(), 0x8130U);
    EXPECT_EQ(source, 7U);
}

TEST_F(CommunicationErrorsTest, ResetOfCommunicationKeepsTheErrors)
{
    Verifies(req::SRS_EMCY_008);
    emergency.SetInhibitTime(10U);
    EXPECT_EQ(emergency.WriteCobId(0x80000090U), SdoAbort::kNone);
    errors.Raise(CommunicationError::kOverrun, 0U);
    emergency.ResetCommunication(NodeId{6U});
    EXPECT_EQ(emergency.CobId(), 0x86U);
    EXPECT_EQ(emergency.InhibitTime(), 0U);
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    EXPECT_EQ(emergency.Register(), 0x11U);
    EXPECT_EQ(emergency.History(0U).value, 1U);
}

TEST_F(CommunicationErrorsTest, EmergenciesOfChosenNodesAreHeard)
{
    Verifies(req::SRS_EMCY_006);
    std::uint32_t room[3] = {};
    EmergencyConsumer consumer{EmergencySources{room, 3U}, *this};
    EXPECT_EQ(Read(consumer, 0x1028U, 0U), 0x100000003U);
    EXPECT_EQ(Read(consumer, 0x1028U, 2U), 0x480000000U);
    EXPECT_EQ(Write(consumer, 0x1028U, 2U, 0x82U), SdoAbort::kNone);
    EXPECT_EQ(Write(consumer, 0x1028U, 2U, 0x82U), SdoAbort::kNone);
    EXPECT_EQ(Write(consumer, 0x1028U, 2U, 0x83U), SdoAbort::kValueRange);
    for (std::uint32_t place = 11U; place <= 30U; ++place)
    {
        EXPECT_EQ(Write(consumer, 0x1028U, 3U, 0x83U | (1U << place)), SdoAbort::kValueRange) << place;
    }
    EXPECT_EQ(Write(consumer, 0x1028U, 3U, 0x00000181U), SdoAbort::kNone);
    EXPECT_EQ(Write(consumer, 0x1028U, 3U, 0x80000181U), SdoAbort::kNone);
    for (const std::uint32_t taken : {0x000U, 0x001U, 0x07FU, 0x101U, 0x180U, 0x581U, 0x601U, 0x701U, 0x7FFU})
    {
        EXPECT_EQ(Write(consumer, 0x1028U, 3U, taken), SdoAbort::kValueRange) << taken;
    }
    EXPECT_EQ(Write(consumer, 0x1028U, 3U, 0x80000101U), SdoAbort::kValueRange);
    EXPECT_EQ(Write(consumer, 0x1028U, 0U, 1U), SdoAbort::kReadOnly);
    EXPECT_EQ(Write(consumer, 0x1028U, 4U, 0x84U), SdoAbort::kSubUnknown);
    EXPECT_EQ(Write(consumer, 0x1027U, 1U, 0x84U), SdoAbort::kObjectUnknown);
    consumer.OnFrame(FrameOf(0x82U, {0x30U, 0x81U, 0x11U, 1U, 2U, 3U, 4U, 5U}), Now());
    ASSERT_EQ(heard.size(), 1U);
    EXPECT_EQ(heard[0].node.value, 2U);
    EXPECT_EQ(heard[0].code, 0x8130U);
    EXPECT_EQ(heard[0].error_register, 0x11U);
    EXPECT_EQ(heard[0].details[4], 5U);
    consumer.OnFrame(FrameOf(0x82U, {0x30U, 0x81U, 0x11U, 1U, 2U, 3U, 4U}), Now());
    consumer.OnFrame(FrameOf(0x83U, {0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}), Now());
    consumer.OnFrame(RemoteOf(0x82U), Now());
    EXPECT_EQ(heard.size(), 1U);
    // In OPERATIONAL until now; in PRE-OPERATIONAL as well, in STOPPED not
    const CanFrame error = FrameOf(0x82U, {0x30U, 0x81U, 0x11U, 1U, 2U, 3U, 4U, 5U});
    EXPECT_EQ(slave.State(), NodeState::kOperational);
    Command(128U);
    consumer.OnFrame(error, Now());
    EXPECT_EQ(heard.size(), 2U);
    Command(2U);
    consumer.OnFrame(error, Now());
    EXPECT_EQ(heard.size(), 2U);
    consumer.ResetCommunication(NodeId{5U});
    EXPECT_EQ(Read(consumer, 0x1028U, 2U), 0x480000000U);
}

} // namespace
} // namespace counterpoint::cia301
