// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/device/device_rig.hpp"
#include "tests/hal/host/allocations.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/lss.hpp"
#include "verification/trace/ids/node.hpp"

namespace counterpoint::device
{
namespace
{

using cia301::NodeState;
using cia305::BitTiming;
using cia305::LssSettings;
using cia305::LssStored;

using DeviceTest = DeviceRig;

TEST_F(DeviceTest, BootsUpAndWaitsForTheStart)
{
    Verifies(req::SRS_DEV_002);
    stored_heartbeat_ms = 10U;
    Start();
    EXPECT_EQ(device.State(), NodeState::kPreOperational);
    EXPECT_EQ(node_resets, 1);
    EXPECT_EQ(communication_resets, 1);
    Cycle();
    // Boot-up first, then the heartbeat
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{0U}, {127U}}));
}

TEST_F(DeviceTest, StartsItselfWhere1F80Says)
{
    Verifies(req::SRS_DEV_002);
    start_up = {0x00U, 0U, 0U, 0U};
    Start();
    EXPECT_EQ(device.State(), NodeState::kOperational);
    EXPECT_EQ(core.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kOff);
    Cycle();
    EXPECT_EQ(core.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kWaiting);
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{0U}}));
}

TEST_F(DeviceTest, StartsItselfOnlyWithBits0And2Of1F80Clear)
{
    Verifies(req::SRS_DEV_002);
    for (std::uint32_t value = 0U; value < 8U; ++value)
    {
        // Given each value of the three lowest bits, when the supply comes, then it waits where bit 0 or bit 2 is set
        start_up[0] = static_cast<std::uint8_t>(value);
        Start();
        const bool is_free = value == 0U || value == 2U;
        EXPECT_EQ(device.State(), is_free ? NodeState::kOperational : NodeState::kPreOperational) << value;
        device.PowerOff();
    }
    // Given no 1F80h, then it waits
    entries[10].index = 0x1F7FU;
    start_up[0] = 0U;
    Start();
    EXPECT_EQ(device.State(), NodeState::kPreOperational);
}

TEST_F(DeviceTest, WithoutAKernelItSaysNothing)
{
    Verifies(req::SRS_DEV_002);
    node_answer = LoadResult::kFailed;
    EXPECT_EQ(device.PowerOn(Instant{now_us}), LoadResult::kFailed);
    EXPECT_EQ(device.State(), cia301::NodeState::kResetApplication);
    Command(1U);
    Cycles(10U);
    EXPECT_EQ(device.State(), cia301::NodeState::kResetApplication);
    EXPECT_TRUE(ports.sent.empty());
    EXPECT_EQ(node_resets, 1);
}

TEST_F(DeviceTest, ATooSmallSafetyQueueIsRefused)
{
    Verifies(req::SRS_DEV_007);
    Device small{DeviceParts{core, watch, dictionary, services, *this, FrameRoom{safety_frames.data(), 7U},
                             FrameRoom{service_frames.data(), 16U}, 3U}};
    EXPECT_EQ(small.PowerOn(Instant{now_us}), LoadResult::kFailed);
    EXPECT_EQ(node_resets, 0);
}

TEST_F(DeviceTest, ResetNodeLeadsOutOfTheSafeStateResetCommunicationDoesNot)
{
    Verifies(req::SRS_DEV_003);
    Verifies(req::SRS_DEV_004);
    Verifies(req::SRS_DEV_015);
    Run();
    core.DemandSafeState();
    Forget();
    Cycles(2U);
    // Then the network is told: 6200h, source 0, fault 10
    ASSERT_EQ(Sent(0x82U).size(), 1U);
    EXPECT_EQ(Sent(0x82U)[0], (Octets{0x00U, 0x62U, 0x81U, 0x00U, 0x0AU, 0x00U, 0x00U, 0x00U}));
    // When communication is reset, the fault and its emergency stay
    Forget();
    Command(130U);
    Cycles(2U);
    EXPECT_EQ(core.DeviceState().fault, DeviceFault::kApplication);
    EXPECT_EQ(Upload(0x1001U, 0U) & 0xFFU, 0x81U);
    EXPECT_EQ(communication_resets, 2);
    EXPECT_EQ(node_resets, 1);
    // When the node is reset, both are gone
    Forget();
    Command(129U);
    Cycles(2U);
    EXPECT_EQ(core.DeviceState().fault, DeviceFault::kNone);
    EXPECT_EQ(Upload(0x1001U, 0U) & 0xFFU, 0U);
    EXPECT_EQ(node_resets, 2);
    EXPECT_EQ(communication_resets, 3);
}

TEST_F(DeviceTest, TheSafeStateIsToldAgainBehindTheBootUpOfAResetOfCommunication)
{
    Verifies(req::SRS_EMCY_008);
    Run();
    core.DemandSafeState();
    Cycles(2U);
    Forget();
    Command(130U);
    Cycles(4U);
    ASSERT_EQ(Sent(0x702U).size(), 1U);
    ASSERT_EQ(Sent(0x82U).size(), 1U);
    EXPECT_EQ(Sent(0x82U)[0], (Octets{0x00U, 0x62U, 0x81U, 0x00U, 0x0AU, 0x00U, 0x00U, 0x00U}));
    EXPECT_EQ(ports.sent[forgotten].identifier, 0x702U);
    // A reset of the node ends it: nothing is told
    Forget();
    Command(129U);
    Cycles(4U);
    EXPECT_EQ(Sent(0x702U).size(), 1U);
    EXPECT_TRUE(Sent(0x82U).empty());
}

// t [cycles]   0 store begins, command      5 store ends, the reset is carried out
TEST_F(DeviceTest, AResetWaitsForTheEndOfAStore)
{
    Verifies(req::SRS_DEV_025);
    for (const std::uint8_t command : {std::uint8_t{129U}, std::uint8_t{130U}})
    {
        SCOPED_TRACE(int{command});
        stored_heartbeat_ms = 1U;
        is_storing = false;
        node_resets = 0;
        communication_resets = 0;
        Start();
        Cycle();
        EXPECT_EQ(Download(0x1016U, 1U, 0x00050064U, 4U), 0U);
        Frame(0x602U, {0x21U, 0x00U, 0x25U, 0x00U, 0x04U, 0U, 0U, 0U}); // Half of a download.
        Cycle();
        is_storing = true;
        Forget();
        Command(command);
        Cycles(5U);
        // Then it is in INITIALISATION at once, its objects are those that are being stored, and it says nothing
        EXPECT_EQ(device.State(), (command == 129U) ? NodeState::kResetApplication : NodeState::kResetCommunication);
        EXPECT_EQ(dictionary.ReadNumber({0x1016U, 1U}).value, 0x00050064U);
        EXPECT_EQ(node_resets, 1);
        EXPECT_EQ(communication_resets, 1);
        Command(1U);
        Command(129U);
        Frame(0x602U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
        Cycle();
        EXPECT_EQ(ports.sent.size(), forgotten);
        // When the store has ended, the reset takes place
        is_storing = false;
        Cycles(2U);
        EXPECT_EQ(device.State(), NodeState::kPreOperational);
        EXPECT_EQ(dictionary.ReadNumber({0x1016U, 1U}).value, 0U);
        EXPECT_EQ(node_resets, (command == 129U) ? 2 : 1);
        EXPECT_EQ(communication_resets, 2);
        ASSERT_FALSE(Sent(0x702U).empty());
        EXPECT_EQ(Sent(0x702U)[0], Octets{0U});
        EXPECT_TRUE(Sent(0x582U).empty());
        EXPECT_EQ(core.DeviceState().fault, DeviceFault::kNone);
        device.PowerOff();
    }
}

TEST_F(DeviceTest, ResetCommunicationBringsBackStoredValues)
{
    Verifies(req::SRS_DEV_004);
    Start();
    EXPECT_EQ(Download(0x1017U, 0U, 777U, 2U), 0U);
    EXPECT_EQ(Download(0x1016U, 1U, 0x00050064U, 4U), 0U);
    EXPECT_EQ(Download(0x100CU, 0U, 100U, 2U), 0U);
    EXPECT_EQ(Download(0x1029U, 1U, 2U, 1U), 0U);
    EXPECT_EQ(Download(0x1014U, 0U, 0x80000082U, 4U), 0U);
    start_up[0] = 0U; // And 1F80h is read again: the device starts itself.
    Command(130U);
    Cycle();
    EXPECT_EQ(device.State(), NodeState::kOperational);
    EXPECT_EQ(Upload(0x1017U, 0U), 0U);
    EXPECT_EQ(Upload(0x1016U, 1U), 0U);
    EXPECT_EQ(Upload(0x100CU, 0U), 0U);
    EXPECT_EQ(Upload(0x1029U, 1U), 0U);
    EXPECT_EQ(Upload(0x1014U, 0U), 0x82U);
}

TEST_F(DeviceTest, AllCommandsOfACycleAreCarriedOutInOrder)
{
    Verifies(req::SRS_DEV_005);
    Start();
    Forget();
    // When traffic fills the queue of services and eight commands come in one cycle
    for (int count = 0; count < 100; ++count)
    {
        Frame(0x080U, {});
    }
    for (const int command : {1, 130, 1, 2, 129, 1, 128, 1})
    {
        Command(static_cast<std::uint8_t>(command));
    }
    Cycle();
    // Then both resets were carried out, and the last command holds
    EXPECT_EQ(Sent(0x702U).size(), 2U);
    EXPECT_EQ(communication_resets, 3);
    EXPECT_EQ(device.State(), NodeState::kOperational);
}

TEST_F(DeviceTest, WhatIsNoCommandIsIgnored)
{
    Verifies(req::SRS_DEV_005);
    Start();
    Frame(0U, {1U});
    Frame(0U, {1U, 2U, 0U});
    Frame(0U, {});
    Frame(0U, {77U, 2U});
    Command(1U, 3U);
    Cycle();
    EXPECT_EQ(device.State(), NodeState::kPreOperational);
    Command(1U, 0U);
    Cycle();
    EXPECT_EQ(device.State(), NodeState::kOperational);
}

TEST_F(DeviceTest, TrafficCannotPushAPairOut)
{
    Verifies(req::SRS_DEV_007);
    Run();
    // When a cycle brings a thousand frames of all kinds around a pair
    for (std::uint32_t count = 0U; count < 1000U; ++count)
    {
        Frame((count * 7U) % 0x800U == 0U ? 0x300U : ((count * 7U) % 0x700U) + 0x181U, {1U, 2U});
        Frame(0x001U, {1U});
        Frame(0x105U, {1U, 2U});
        now_us -= 30U;
    }
    now_us += 50U;
    Pair();
    Cycle();
    // Then the pair is released, and the kernel knows of no loss
    EXPECT_EQ(NormalOut(), 0x3412U);
    EXPECT_TRUE(CausesOf(0x1301U).empty());
}

TEST_F(DeviceTest, ALossIsToldBeforeTheFramesThatWait)
{
    Verifies(req::SRS_DEV_008);
    Run();
    Pair();
    Cycle();
    ASSERT_EQ(core.GetState({0x1301U}).state, SrdoState::kReleased);
    // Given a good pair that waits, when the hardware layer tells a loss behind it, and the queue is handed over
    // between two cycles
    Pair();
    device.OnLoss();
    device.Serve(Instant{now_us});
    Cycle();
    // Then the cycle that gets the pair is safe
    EXPECT_EQ(core.GetState({0x1301U}).state, SrdoState::kFaulted);
    EXPECT_EQ(CausesOf(0x1301U), (std::vector<SrdoCause>{SrdoCause::kQueueOverflow}));
    EXPECT_EQ(NormalOut(), 0x7F01U);
    // and the next pair is released
    Pair();
    Cycle();
    EXPECT_EQ(NormalOut(), 0x3412U);
}

TEST_F(DeviceTest, ALostFrameMakesTheSrdoSafe)
{
    Verifies(req::SRS_DEV_008);
    Verifies(req::SRS_DEV_013);
    Run();
    Pair();
    Cycle();
    EXPECT_EQ(NormalOut(), 0x3412U);
    // When more frames of the SRDO come than its queue has room for
    for (int count = 0; count < 5; ++count)
    {
        Pair();
    }
    Cycle();
    EXPECT_EQ(NormalOut(), 0x7F01U);
    EXPECT_EQ(CausesOf(0x1301U).back(), SrdoCause::kQueueOverflow);
    // And when the hardware layer lost frames
    Pair();
    Cycle();
    EXPECT_EQ(NormalOut(), 0x3412U);
    device.OnLoss();
    Cycle();
    EXPECT_EQ(NormalOut(), 0x7F01U);
}

/// What the application was told when the services saw their first frame.
class Spy final : public cia301::ReadHook
{
  public:
    explicit Spy(const RecordingApplication& application) : application_(application)
    {
    }
    cia301::Reading OnRead(const ObjectAddress& /*address*/, const cia301::Room& room) noexcept override
    {
        events_then = application_.events.size();
        room.data[0] = 1U;
        return {cia301::SdoAbort::kNone, 4U};
    }
    std::size_t events_then{99U};

  private:
    const RecordingApplication& application_;
};

TEST_F(DeviceTest, SafetyComesFirstWhateverCameFirst)
{
    Verifies(req::SRS_DEV_006);
    Run();
    Spy spy{application};
    entries[11].place = nullptr;
    entries[11].read_hook = &spy;
    application.events.clear();
    // Given an SDO request that came before a pair
    Frame(0x602U, {0x40U, 0x00U, 0x25U, 0U, 0U, 0U, 0U, 0U});
    Pair();
    Cycle();
    // Then the pair was released when the request was looked at
    EXPECT_EQ(spy.events_then, 1U);
}

TEST_F(DeviceTest, TheInverseFrameFollowsItsConfirmationBetweenTwoCycles)
{
    Verifies(req::SRS_DEV_006);
    Run();
    Cycles(60U);
    EXPECT_GE(Sent(0x103U).size(), 2U);
    EXPECT_EQ(Sent(0x103U).size(), Sent(0x104U).size());
    EXPECT_EQ(Sent(0x103U)[0], (Octets{0x12U, 0x34U}));
    EXPECT_EQ(Sent(0x104U)[0], (Octets{0xEDU, 0xCBU}));
    EXPECT_TRUE(CausesOf(0x1303U).empty());
}

TEST_F(DeviceTest, FramesOfAnSrdoThatIsOffFindNoPlaceInTheSafetyQueue)
{
    Verifies(req::SRS_DEV_007);
    for (const std::uint8_t direction : {std::uint8_t{0U}, std::uint8_t{1U}})
    {
        // Given a queue of 8 frames, and SRDO 3 off, or a producer
        Start();
        EXPECT_EQ(Store(0x1303U, 1U, direction, 1U), AbortCode::kNone);
        const SignReply reply = core.Sign(CommunicationIndex{0x1303U});
        EXPECT_EQ(Store(0x13FFU, 3U, reply.signature, 2U), AbortCode::kNone);
        EXPECT_EQ(Store(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
        Command(1U);
        Cycles(2U);
        // When somebody sends its identifiers ten times before a pair of SRDO 1
        for (int count = 0; count < 10; ++count)
        {
            Frame(0x103U, {1U, 2U});
            Frame(0x104U, {0xFEU, 0xFDU});
        }
        Pair();
        Cycle();
        // Then they take its place only where SRDO 3 is on
        EXPECT_EQ(NormalOut() == 0x3412U, direction == 0U);
        device.PowerOff();
    }
}

TEST_F(DeviceTest, NothingIsLeftAfterTheSupplyWasOff)
{
    Verifies(req::SRS_DEV_023);
    // Given an operational device with a request, a command and a pair that wait
    Run();
    Frame(0x602U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
    Command(0x02U);
    Pair();
    ASSERT_TRUE(services.outbox.Send(CanFrame{0x5FFU, FrameKind::kData, CanPortId::kFirst, 0U, {}}));
    Forget();
    // When its supply goes and comes
    device.PowerOff();
    EXPECT_EQ(device.State(), cia301::NodeState::kInitialising);
    Start();
    Cycle();
    // Then it has booted again, and what waited is gone
    EXPECT_EQ(device.State(), cia301::NodeState::kPreOperational);
    EXPECT_EQ(node_resets, 2);
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{0x00U}}));
    EXPECT_TRUE(Sent(0x582U).empty());
    EXPECT_TRUE(Sent(0x5FFU).empty());
}

TEST_F(DeviceTest, OneServerReachesOwnObjectsAndTheKernels)
{
    Verifies(req::SRS_DEV_001);
    Start();
    EXPECT_EQ(Upload(0x1000U, 0U), 0x11223344U);
    EXPECT_EQ(Upload(0x1301U, 5U), 0x101U);
    EXPECT_EQ(Upload(0x2000U, 1U), 0x3412U);
    EXPECT_EQ(Upload(0x3000U, 0U), 0x06020000U);
    EXPECT_EQ(Upload(0x1016U, 3U), 0x06090011U);
}

TEST_F(DeviceTest, TheServerWritesOwnObjectsAndTheKernels)
{
    Verifies(req::SRS_DEV_001);
    Verifies(req::SRS_DEV_120);
    Start();
    EXPECT_EQ(Download(0x1017U, 0U, 5U, 2U), 0U);
    EXPECT_EQ(Upload(0x1017U, 0U), 5U);
    // What is written is the kernel's, and what the kernel refuses is refused with its code
    EXPECT_EQ(Download(0x1300U, 0U, 1U, 1U), 0U);
    EXPECT_EQ(core.ReadObject(ObjectAddress{0x1300U, 0U}).data.bytes[0], 1U);
    EXPECT_EQ(Download(0x1300U, 0U, 2U, 1U), 0x06090030U);
    EXPECT_EQ(Download(0x1301U, 7U, 0U, 1U), 0x06090011U);
    EXPECT_EQ(Download(0x2000U, 1U, 0x3412U, 2U), 0x06010002U); // A safety variable is the channels'.
    Command(0x01U);
    Cycle();
    EXPECT_EQ(Download(0x13FEU, 0U, 0xA5U, 1U), 0x08000022U);
    EXPECT_EQ(Download(0x1301U, 2U, 25U, 2U), 0x08000022U);
    // When the kernel is stopped, then nothing of it is reached any more, and what is the device's own is
    core.Stop();
    EXPECT_EQ(Upload(0x1301U, 5U), 0x08000022U);
    EXPECT_EQ(Upload(0x13FFU, 1U), 0x08000022U);
    EXPECT_EQ(Upload(0x2000U, 1U), 0x08000022U);
    EXPECT_EQ(Upload(0x1000U, 0U), 0x11223344U);
}

TEST_F(DeviceTest, IsUsableWithoutHeap)
{
    Verifies(req::SRS_DEV_018);
    // All room is the rig's: the object itself is of a fixed size, and small
    EXPECT_LT(sizeof(Device) + sizeof(Services), 4096U);
    // Nothing throws
    static_assert(noexcept(device.PowerOn(Instant{0U})));
    static_assert(noexcept(device.OnFrame(StampedFrame{})));
    static_assert(noexcept(device.OnConfirm(StampedFrame{})));
    static_assert(noexcept(device.Cycle(CycleCall{})));
    static_assert(noexcept(device.Serve(Instant{0U})));
    // Given a device with a heartbeat of 1 ms, a request and room for what the rig keeps
    stored_heartbeat_ms = 1U;
    Run();
    ports.sent.reserve(1000U);
    application.events.reserve(1000U);
    Cycle();
    const std::uint64_t allocations = host::Allocations();
    // When it works for 20 cycles, then nothing is taken from the heap but the rig's bytes of three frames
    Pair();
    Frame(0x602U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
    Cycles(20U);
    EXPECT_EQ(host::Allocations(), allocations + 3U);
    // and while the time that it is given stands still, so does its heartbeat
    const std::size_t sent = ports.sent.size();
    for (int count = 0; count < 1000; ++count)
    {
        device.Serve(Instant{now_us});
        ConfirmAll();
    }
    EXPECT_EQ(ports.sent.size(), sent);
}

/// The rig's device with LSS, without a node-ID at first.
class DeviceLssTest : public DeviceRig, public cia305::LssDevice
{
  public:
    DeviceLssTest()
    {
        services.lss = &slave;
    }
    bool IsSupported(BitTiming /*timing*/) noexcept override
    {
        return true;
    }
    LssStored Store(const LssSettings& /*settings*/) noexcept override
    {
        return LssStored::kDone;
    }
    void SwitchTo(BitTiming /*timing*/) noexcept override
    {
    }
    void Lss(const Octets& command)
    {
        Octets bytes = command;
        bytes.resize(8U);
        Frame(0x7E5U, bytes);
        Cycle();
    }

    cia305::LssSlave slave{cia305::LssParts{services.outbox, *this, cia305::Identity{1U, 2U, 3U, 4U},
                                            LssSettings{cia305::kNoNodeId, BitTiming{2U}}}};
};

TEST_F(DeviceLssTest, WithoutANodeIdThereIsOnlyLss)
{
    Verifies(req::SRS_DEV_019);
    Verifies(req::SRS_LSS_009);
    Start();
    Command(1U, 0U);
    Remote(0x702U);
    Frame(0x602U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
    Cycles(20U);
    EXPECT_TRUE(ports.sent.empty());
    EXPECT_EQ(node_resets, 1);
    EXPECT_EQ(communication_resets, 0);
    // When somebody looks for devices without a node-ID, it answers
    Lss({0x4CU});
    EXPECT_EQ(Sent(0x7E4U), (std::vector<Octets>{{0x50U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}}));
    EXPECT_EQ(ports.sent.size(), 1U);
    // When it gets one and is let go, it boots with it
    Lss({0x04U, 1U});
    Lss({0x11U, 5U});
    EXPECT_TRUE(Sent(0x705U).empty());
    Lss({0x04U, 0U});
    Cycle();
    EXPECT_EQ(Sent(0x705U), (std::vector<Octets>{{0U}}));
    EXPECT_EQ(device.State(), NodeState::kPreOperational);
    EXPECT_EQ(communication_resets, 1);
    // And is a node like others
    Command(1U, 5U);
    Cycle();
    EXPECT_EQ(device.State(), NodeState::kOperational);
    Forget();
    Frame(0x605U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
    Cycle();
    EXPECT_EQ(Sent(0x585U), (std::vector<Octets>{{0x43U, 0x00U, 0x10U, 0U, 0x44U, 0x33U, 0x22U, 0x11U}}));
    EXPECT_EQ(dictionary.ReadNumber({0x1014U, 0U}).value, 0x85U);
}

TEST_F(DeviceLssTest, AnotherNodeIdHoldsFromTheNextResetOn)
{
    Verifies(req::SRS_DEV_019);
    Start();
    Lss({0x04U, 1U});
    Lss({0x11U, 5U});
    Lss({0x04U, 0U});
    Cycle();
    EXPECT_EQ(dictionary.WriteNumber({0x1017U, 0U}, 5U, 2U), cia301::SdoAbort::kNone);
    Lss({0x04U, 1U});
    Lss({0x11U, 9U});
    Lss({0x04U, 0U});
    Forget();
    Cycles(10U);
    EXPECT_FALSE(Sent(0x705U).empty());
    EXPECT_TRUE(Sent(0x709U).empty());
    Command(130U, 5U);
    stored_heartbeat_ms = 5U;
    Forget();
    Cycles(10U);
    EXPECT_TRUE(Sent(0x705U).empty());
    ASSERT_GE(Sent(0x709U).size(), 2U);
    EXPECT_EQ(Sent(0x709U)[0], (Octets{0U}));
    // When the node-ID is taken away, the device falls silent at the next reset
    Lss({0x04U, 1U});
    Lss({0x11U, 0xFFU});
    Lss({0x04U, 0U});
    Command(130U, 9U);
    Cycle();
    Forget();
    Cycles(30U);
    EXPECT_TRUE(Sent(0x709U).empty());
    EXPECT_EQ(device.State(), NodeState::kResetCommunication);
}

TEST_F(DeviceLssTest, NothingIsSentWhileTheBitRateChanges)
{
    Verifies(req::SRS_DEV_019);
    stored_heartbeat_ms = 1U;
    Start();
    Lss({0x04U, 1U});
    Lss({0x11U, 5U});
    Lss({0x04U, 0U});
    Cycles(3U);
    Lss({0x04U, 1U});
    Lss({0x13U, 0U, 4U});
    Forget();
    Lss({0x15U, 10U, 0U}); // Activate after 10 ms, silent until 10 ms later.
    Forget();
    Cycles(15U);
    EXPECT_TRUE(Sent(0x705U).empty());
    Cycles(10U);
    EXPECT_FALSE(Sent(0x705U).empty());
}

} // namespace
} // namespace counterpoint::device
