// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/dictionary/no_objects.hpp"
#include "canopen/cia301/emergency/consumer.hpp"
#include "canopen/cia301/sdo/client_port.hpp"
#include "canopen/cia301/time/time_stamp.hpp"
#include "canopen/device/app_device.hpp"
#include "names/safety_core/kernel/start_check.hpp"
#include "tests/canopen/device/device_rig.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/comfort.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/ids/pdo.hpp"

#include <algorithm>

namespace counterpoint::device
{
namespace
{

using cia301::NodeState;
using cia301::SdoClientState;

/// The kernel of the rig in a device without services.
class DeviceBareTest : public DeviceRig
{
  protected:
    BareParts Parts(ServiceSet& set) noexcept
    {
        return BareParts{core, set, *this, FrameRoom{safety_frames.data(), 8U}, 3U};
    }
    void Tell(Device& to, const std::uint32_t identifier, const Octets& bytes)
    {
        StampedFrame frame{};
        frame.frame =
            CanFrame{identifier, FrameKind::kData, CanPortId::kFirst, static_cast<std::uint8_t>(bytes.size()), {}};
        std::copy(bytes.begin(), bytes.end(), frame.frame.data);
        frame.stamp = {Instant{now_us}, Instant{now_us}};
        to.OnFrame(frame);
        to.Serve(Instant{now_us});
    }

    NoServices none{cia301::NodeId{2U}, &ports};
    Device bare{Parts(none)};
};

TEST_F(DeviceBareTest, FollowsNmtAndSendsNothingButItsBootUp)
{
    Verifies(req::SRS_DEV_022);
    // Given power, then a boot-up message and PRE-OPERATIONAL
    EXPECT_EQ(bare.PowerOn(Instant{now_us}), LoadResult::kLoaded);
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{0U}}));
    EXPECT_EQ(bare.State(), NodeState::kPreOperational);
    // When each command comes, then it is followed
    Tell(bare, 0U, {1U, 0U});
    EXPECT_EQ(bare.State(), NodeState::kOperational);
    EXPECT_EQ(core.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kOff);
    bare.Cycle(CycleCall{{Instant{now_us}, Instant{now_us}}, 0U, 0U});
    EXPECT_EQ(core.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kWaiting);
    Tell(bare, 0U, {2U, 2U});
    EXPECT_EQ(bare.State(), NodeState::kStopped);
    Tell(bare, 0U, {128U, 2U});
    Tell(bare, 0U, {1U, 3U}); // Another node's.
    EXPECT_EQ(bare.State(), NodeState::kPreOperational);
    // When SDO, heartbeat and lost frames come, then nothing is sent
    Tell(bare, 0x602U, {0x40U, 0U, 0x10U, 0U, 0U, 0U, 0U, 0U});
    Tell(bare, 0x705U, {5U});
    bare.OnLoss();
    bare.OnBus(BusCondition::kOff);
    bare.OnBus(BusCondition::kActive);
    bare.Serve(Instant{now_us});
    bare.OnConfirm(StampedFrame{ports.sent[0], {Instant{now_us}, Instant{now_us}}});
    // nor where a frame is given to the set itself
    none.OnFrame(ports.sent[0], cia301::Moment{bare.State(), Instant{now_us}});
    EXPECT_EQ(ports.sent.size(), 1U);
}

TEST_F(DeviceBareTest, ResetsStartTheKernelAnewAndBootUpAgain)
{
    Verifies(req::SRS_DEV_022);
    Verifies(req::SRS_DEV_003);
    Verifies(req::SRS_DEV_004);
    // Given a device in its safe state
    ASSERT_EQ(bare.PowerOn(Instant{now_us}), LoadResult::kLoaded);
    core.DemandSafeState();
    // When communication is reset, then the fault stays
    Tell(bare, 0U, {130U, 2U});
    EXPECT_EQ(core.DeviceState().fault, DeviceFault::kApplication);
    EXPECT_EQ(node_resets, 1);
    // When the node is reset, then the kernel is a new one, and the message is sent for the third time
    Tell(bare, 0U, {129U, 2U});
    EXPECT_EQ(core.DeviceState().fault, DeviceFault::kNone);
    EXPECT_EQ(node_resets, 2);
    EXPECT_EQ(communication_resets, 3);
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{0U}, {0U}, {0U}}));
}

TEST_F(DeviceBareTest, BootUpWaitsForTheController)
{
    Verifies(req::SRS_DEV_022);
    // Given a controller that takes nothing
    ports.answer = hal::TransmitStatus::kBusOff;
    ASSERT_EQ(bare.PowerOn(Instant{now_us}), LoadResult::kLoaded);
    bare.Serve(Instant{now_us});
    EXPECT_TRUE(ports.sent.empty());
    // When it takes frames again, then the message goes out, once
    ports.answer = hal::TransmitStatus::kAccepted;
    bare.Serve(Instant{now_us});
    bare.Serve(Instant{now_us});
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{0U}}));
}

TEST_F(DeviceBareTest, WhatTheControllerNeverTakesIsDropped)
{
    Verifies(req::SRS_DEV_022);
    // Given a controller that has no place for the message
    ports.answer = hal::TransmitStatus::kRefused;
    ASSERT_EQ(bare.PowerOn(Instant{now_us}), LoadResult::kLoaded);
    // Then it is not tried again
    ports.answer = hal::TransmitStatus::kAccepted;
    bare.Serve(Instant{now_us});
    EXPECT_TRUE(ports.sent.empty());
}

TEST_F(DeviceBareTest, TheOtherCpuSendsForBoth)
{
    Verifies(req::SRS_DEV_022);
    // Given a set without a sender, then the device is up and says nothing
    NoServices silent{cia301::NodeId{2U}, nullptr};
    Device second{Parts(silent)};
    EXPECT_EQ(second.PowerOn(Instant{now_us}), LoadResult::kLoaded);
    second.Serve(Instant{now_us});
    EXPECT_EQ(second.State(), NodeState::kPreOperational);
    EXPECT_TRUE(ports.sent.empty());
}

TEST_F(DeviceBareTest, WithoutANodeIdItStaysInInitialisation)
{
    Verifies(req::SRS_DEV_022);
    // Given no node-ID, nobody gives one: no boot-up message, no state
    for (const std::uint8_t nobody : {std::uint8_t{0U}, std::uint8_t{128U}})
    {
        NoServices unknown{cia301::NodeId{nobody}, &ports};
        Device lost{Parts(unknown)};
        EXPECT_EQ(lost.PowerOn(Instant{now_us}), LoadResult::kLoaded);
        lost.Serve(Instant{now_us});
        EXPECT_EQ(lost.State(), NodeState::kResetCommunication);
    }
    EXPECT_TRUE(ports.sent.empty());
}

/// An application that may be refused.
struct TestedApplication
{
    [[nodiscard]] const DeviceConfig& Describe() const noexcept
    {
        return config;
    }
    [[nodiscard]] static AbortCode Configure(Kernel& /*kernel*/) noexcept
    {
        ++configured;
        return (is_refused || (rig->OnResetCommunication() != LoadResult::kLoaded)) ? AbortCode::kGeneral
                                                                                    : AbortCode::kNone;
    }

    DeviceConfig config;
    static int configured;
    static bool is_refused;
    static DeviceRig* rig; ///< Knows the values.
};
int TestedApplication::configured = 0;
bool TestedApplication::is_refused = false;
DeviceRig* TestedApplication::rig = nullptr;

TEST_F(DeviceBareTest, AnApplicationIsADevice)
{
    Verifies(req::SRS_DEV_022);
    // Given an application that knows its configuration
    TestedApplication tested{config};
    TestedApplication::configured = 0;
    TestedApplication::rig = this;
    tested.config.node_id = 2U;
    AppDevice<TestedApplication, 3U> device_of{core, &ports, tested};
    // When power comes, then it is configured, once, and up
    ASSERT_EQ(device_of.Whole().PowerOn(Instant{now_us}), LoadResult::kLoaded);
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{0U}}));
    Tell(device_of.Whole(), 0U, {130U, 0U});
    EXPECT_EQ(TestedApplication::configured, 1);
    Tell(device_of.Whole(), 0U, {129U, 0U});
    EXPECT_EQ(TestedApplication::configured, 2);
    EXPECT_EQ(device_of.Whole().State(), NodeState::kPreOperational);
}

TEST_F(DeviceBareTest, AnApplicationLeavesItsSafeStateByPowerAlone)
{
    Verifies(req::SRS_DEV_022);
    // Given a device in its safe state
    TestedApplication tested{config};
    TestedApplication::rig = this;
    tested.config.node_id = 2U;
    AppDevice<TestedApplication, 3U> device_of{core, &ports, tested};
    ASSERT_EQ(device_of.Whole().PowerOn(Instant{now_us}), LoadResult::kLoaded);
    core.DemandSafeState();
    // When the node is reset, then the fault stays, no boot-up message is sent, and no command leads out
    Tell(device_of.Whole(), 0U, {129U, 0U});
    Tell(device_of.Whole(), 0U, {129U, 0U});
    Tell(device_of.Whole(), 0U, {1U, 0U});
    EXPECT_EQ(core.DeviceState().fault, DeviceFault::kApplication);
    EXPECT_EQ(device_of.Whole().State(), NodeState::kResetApplication);
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{0U}}));
}

TEST_F(DeviceBareTest, AnApplicationThatIsRefusedIsNoDevice)
{
    Verifies(req::SRS_DEV_022);
    Verifies(req::SRS_EASE_007);
    // Given an application whose description the kernel refuses, or whose configuration
    TestedApplication tested{config};
    tested.config.node_id = 2U;
    TestedApplication::is_refused = true;
    AppDevice<TestedApplication, 3U> unconfigured{core, &ports, tested};
    EXPECT_EQ(unconfigured.Started(), StartResult::kInvalid); // Not asked.
    EXPECT_EQ(unconfigured.Whole().PowerOn(Instant{now_us}), LoadResult::kFailed);
    EXPECT_EQ(unconfigured.Started(), StartResult::kStarted);
    TestedApplication::is_refused = false;
    tested.config.srdo_count = 0U;
    AppDevice<TestedApplication, 3U> refused{core, &ports, tested};
    EXPECT_EQ(refused.Whole().PowerOn(Instant{now_us}), LoadResult::kFailed);
    // Then the reason is kept, with its words, and nothing is sent
    EXPECT_EQ(refused.Started(), StartResult::kSrdoCount);
    EXPECT_STREQ(NameOf(refused.Started()), "srdo_count");
    EXPECT_STREQ(MeaningOf(refused.Started()), "Not 1 to 64, or no setups.");
    EXPECT_TRUE(ports.sent.empty());
}

/// The rig's device with TIME, an emergency consumer for two nodes, an SDO client of node 5 and a second server.
class DeviceFurtherTest : public DeviceRig, public cia301::TimeListener, public cia301::EmergencyListener
{
  public:
    DeviceFurtherTest()
    {
        services.further = {list.data(), 4U};
    }
    void OnTime(const cia301::TimeOfDay& told, Instant) noexcept override
    {
        days = told.days;
    }
    void OnEmergency(const cia301::ReceivedEmergency& told) noexcept override
    {
        code = told.code;
    }
    static void Put(cia301::NumberHook& hook, std::uint16_t index, std::uint8_t sub, std::uint32_t value)
    {
        const auto byte = [value](unsigned place) { return static_cast<std::uint8_t>(value >> (8U * place)); };
        const std::array<std::uint8_t, 4> bytes{byte(0U), byte(1U), byte(2U), byte(3U)};
        EXPECT_EQ(hook.OnWrite({index, sub}, {bytes.data(), 4U}), cia301::SdoAbort::kNone);
    }
    void Configure()
    {
        Put(time, 0x1012U, 0U, 0xC0000100U);
        Put(listener, 0x1028U, 2U, 0x82U);
        Put(listener, 0x1028U, 1U, 0x83U);
        Put(client, 0x1280U, 1U, 0x605U);
        Put(client, 0x1280U, 2U, 0x585U);
        Put(client, 0x1280U, 3U, 5U);
        Put(second, 0x1201U, 1U, 0x680U);
        Put(second, 0x1201U, 2U, 0x6A0U);
    }
    void Ask()
    {
        EXPECT_TRUE(
            client.Client().StartUpload({0x1000U, 0U}, {room.data(), 8U}, cia301::SdoMode::kNormal, Instant{now_us}));
        Cycle();
    }

    std::uint16_t days{0U};
    std::uint16_t code{0U};
    std::array<std::uint32_t, 2> sources{};
    std::array<std::uint8_t, 8> room{};
    std::array<std::uint8_t, 8> second_buffer{};
    cia301::SdoServer second_server{{dictionary, {second_buffer.data(), 8U}, 1000000U, 64U}};
    cia301::TimeStamp time{services.outbox, *this};
    cia301::EmergencyConsumer listener{{sources.data(), 2U}, *this};
    cia301::SdoClientPort client{{services.outbox, 0U, 50000U, 64U}};
    cia301::SdoServerPort second{second_server, services.outbox, cia301::SdoServerNumber{1U}};
    std::array<cia301::BusService*, 4> list{&time, &listener, &client, &second};
};

TEST_F(DeviceFurtherTest, TimeAndEmergenciesOfOthersAreHeard)
{
    Verifies(req::SRS_DEV_020);
    Start();
    Frame(0x100U, {1U, 0U, 0U, 0U, 0x34U, 0x12U});
    Frame(0x82U, {0x10U, 0x42U, 9U, 0U, 0U, 0U, 0U, 0U});
    Cycle();
    EXPECT_EQ(days, 0U); // off at first
    EXPECT_EQ(code, 0U);
    Configure();
    Frame(0x100U, {1U, 0U, 0U, 0U, 0x34U, 0x12U});
    Frame(0x82U, {0x10U, 0x42U, 9U, 0U, 0U, 0U, 0U, 0U});
    Cycle();
    EXPECT_EQ(days, 0x1234U);
    EXPECT_EQ(code, 0x4210U);
    EXPECT_TRUE(time.Send({7U, 8U}, {device.State(), Instant{now_us}}));
    Cycle();
    EXPECT_EQ(Sent(0x100U), (std::vector<Octets>{{7U, 0U, 0U, 0U, 8U, 0U}}));
    // Reset communication: off again
    Command(130U);
    Cycle();
    Frame(0x100U, {1U, 0U, 0U, 0U, 0U, 0U});
    Cycle();
    EXPECT_EQ(days, 0x1234U);
}

TEST_F(DeviceFurtherTest, NoServiceGetsTheIdentifierOfAnother)
{
    Verifies(req::SRS_EMCY_003);
    Start();
    Configure();
    // Given an emergency that is off, then it gets none of TIME, a consumed emergency or a further SDO, request or
    // answer
    EXPECT_EQ(Download(0x1014U, 0U, 0x80000082U, 4U), 0U);
    for (const std::uint32_t used : {0x100U, 0x83U, 0x680U, 0x6A0U})
    {
        EXPECT_EQ(Download(0x1014U, 0U, used, 4U), 0x06090030U) << used;
    }
    EXPECT_EQ(Download(0x1014U, 0U, 0x101U, 4U), 0x06090030U); // An SRDO's.
    EXPECT_EQ(Download(0x1014U, 0U, 0x84U, 4U), 0U);
    // nor does SYNC
    for (const std::uint32_t used : {0x100U, 0x83U, 0x680U, 0x6A0U, 0x84U})
    {
        EXPECT_EQ(Download(0x1005U, 0U, used, 4U), 0x06090030U) << used;
    }
    // The other way round: SYNC's identifier, and the own emergency's but in 1028h, are none for the others
    for (const std::uint32_t used : {0x80U, 0x84U})
    {
        EXPECT_FALSE(services.Allows({0x1012U, 0U}, 0x80000000U | used)) << used;
        EXPECT_FALSE(services.Allows({0x1201U, 1U}, used)) << used;
        EXPECT_FALSE(services.Allows({0x1280U, 2U}, used)) << used;
        EXPECT_EQ(services.Allows({0x1028U, 1U}, used), used == 0x84U) << used;
    }
    EXPECT_TRUE(services.Allows({0x1012U, 0U}, 0x80000085U));
    EXPECT_TRUE(services.Allows({0x1201U, 1U}, 0x85U));
}

TEST_F(DeviceFurtherTest, WhatGivesNoIdentifierIsAllowed)
{
    Verifies(req::SRS_EMCY_003);
    Start();
    Configure();
    // Given SYNC on 80h, then the count of 1028h, TIME without a role and a client that is off may say 80h
    EXPECT_TRUE(services.Allows({0x1028U, 0U}, 0x80U));
    EXPECT_FALSE(services.Allows({0x1028U, 1U}, 0x80U));
    EXPECT_TRUE(services.Allows({0x1012U, 0U}, 0x80U));
    EXPECT_TRUE(services.Allows({0x1280U, 1U}, 0x80000080U));
}

/// The services of the rig with one TPDO and one RPDO, on 182h and 202h.
class DevicePdoTest : public DeviceFurtherTest
{
  public:
    DevicePdoTest()
    {
        with_pdos.further = {list.data(), 4U};
        Put(with_pdos.sync, 0x1005U, 0U, 0x80U);
        Put(with_pdos.pdos, 0x1800U, 1U, 0x40000182U);
        Put(with_pdos.pdos, 0x1400U, 1U, 0x202U);
    }

    std::array<cia301::PdoField, 1> sent_fields{};
    std::array<cia301::PdoField, 1> received_fields{};
    cia301::Tpdo tpdo{1U, cia301::PdoTrigger::kRequest, {sent_fields.data(), 1U}};
    cia301::Rpdo rpdo{1U, {received_fields.data(), 1U}};
    Services with_pdos{cia301::NodeId{2U}, ServiceParts{emergency, ports, dictionary,
                                                        ServiceRooms{{nullptr, 0U}, {&tpdo, 1U}, {&rpdo, 1U}, {}}}};
};

TEST_F(DevicePdoTest, NoPdoGetsTheIdentifierOfAServiceNorTheOtherWayRound)
{
    Verifies(req::SRS_PDO_009);
    Configure();
    // Given SYNC, the emergency, TIME, a consumed emergency and a further SDO, then no PDO gets their identifiers
    for (const std::uint32_t used : {0x80U, 0x82U, 0x100U, 0x83U, 0x680U, 0x6A0U})
    {
        EXPECT_FALSE(with_pdos.Allows({0x1800U, 1U}, used)) << used;
        EXPECT_FALSE(with_pdos.Allows({0x1400U, 1U}, used)) << used;
    }
    // nor a PDO that is sent that of one that is received; its own, and that of the received one for it, are free
    EXPECT_FALSE(with_pdos.Allows({0x1800U, 1U}, 0x202U));
    EXPECT_FALSE(with_pdos.Allows({0x1400U, 1U}, 0x182U));
    EXPECT_TRUE(with_pdos.Allows({0x1800U, 1U}, 0x182U));
    EXPECT_TRUE(with_pdos.Allows({0x1400U, 1U}, 0x202U));
    EXPECT_TRUE(with_pdos.Allows({0x1800U, 1U}, 0x183U));
    // and what is off, or no COB-ID, is free
    EXPECT_TRUE(with_pdos.Allows({0x1800U, 1U}, 0x80000080U));
    EXPECT_TRUE(with_pdos.Allows({0x1800U, 2U}, 0x80U));
    // The other way round
    EXPECT_FALSE(with_pdos.Allows({0x1014U, 0U}, 0x182U));
    EXPECT_FALSE(with_pdos.Allows({0x1014U, 0U}, 0x202U));
    EXPECT_FALSE(with_pdos.Allows({0x1005U, 0U}, 0x202U));
    EXPECT_TRUE(with_pdos.Allows({0x1014U, 0U}, 0x183U));
}

TEST_F(DeviceFurtherTest, AClientAndASecondServerShareTheBusWithTheFirst)
{
    Verifies(req::SRS_DEV_020);
    Start();
    Frame(0x680U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
    Cycle();
    EXPECT_TRUE(Sent(0x6A0U).empty());
    Configure();
    Forget();
    Frame(0x680U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
    Cycle();
    EXPECT_EQ(Sent(0x6A0U), (std::vector<Octets>{{0x43U, 0x00U, 0x10U, 0U, 0x44U, 0x33U, 0x22U, 0x11U}}));
    Ask();
    EXPECT_EQ(Sent(0x605U), (std::vector<Octets>{{0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U}}));
    EXPECT_EQ(Upload(0x1000U, 0U), 0x11223344U);
    Frame(0x586U, {0x43U, 0x00U, 0x10U, 0U, 9U, 9U, 9U, 9U}); // another server's
    Frame(0x585U, {0x43U, 0x00U, 0x10U, 0U, 1U, 2U, 3U, 4U});
    Cycle();
    EXPECT_EQ(client.Client().State(), SdoClientState::kDone);
    EXPECT_EQ(room[0], 1U);
    // In STOPPED a transfer ends
    Ask();
    Command(2U);
    Cycle();
    EXPECT_EQ(client.Client().Outcome().abort, cia301::SdoAbort::kDeviceState);
}

TEST_F(DeviceFurtherTest, WorkInPreOperationalAndOperationalAlone)
{
    Verifies(req::SRS_DEV_210);
    Verifies(req::SRS_SDC_210);
    Start();
    Configure();
    std::uint8_t day = 1U;
    for (const std::uint8_t command : {std::uint8_t{128U}, std::uint8_t{1U}, std::uint8_t{2U}})
    {
        const bool works = command != 2U;
        Command(command);
        Cycle();
        Forget();
        code = 0U;
        // When a TIME, an emergency, a request and an order to ask come
        Frame(0x100U, {1U, 0U, 0U, 0U, day, 0U});
        Frame(0x82U, {0x10U, 0x42U, 9U, 0U, 0U, 0U, 0U, 0U});
        Frame(0x680U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
        static_cast<void>(
            client.Client().StartUpload({0x1000U, 0U}, {room.data(), 8U}, cia301::SdoMode::kNormal, Instant{now_us}));
        Cycle();
        // Then they are taken, answered and sent, but not in STOPPED
        EXPECT_EQ(days == day, works) << int{command};
        EXPECT_EQ(code, works ? 0x4210U : 0U) << int{command};
        EXPECT_EQ(Sent(0x6A0U).size(), works ? 1U : 0U) << int{command};
        EXPECT_EQ(Sent(0x605U).size(), works ? 1U : 0U) << int{command};
        if (!works)
        {
            EXPECT_EQ(client.Client().Outcome().abort, cia301::SdoAbort::kDeviceState);
        }
        Frame(0x585U, {0x43U, 0x00U, 0x10U, 0U, 1U, 2U, 3U, 4U});
        Cycle();
        ++day;
    }
}

TEST_F(DeviceFurtherTest, AreAsAtPowerOnAfterAResetOfCommunication)
{
    Verifies(req::SRS_DEV_211);
    Start();
    Configure();
    Ask();
    ASSERT_EQ(Sent(0x605U).size(), 1U);
    // When the device resets its communication
    Command(130U);
    Cycle();
    Forget();
    Frame(0x100U, {1U, 0U, 0U, 0U, 0x34U, 0x12U});
    Frame(0x82U, {0x10U, 0x42U, 9U, 0U, 0U, 0U, 0U, 0U});
    Frame(0x680U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
    Frame(0x585U, {0x43U, 0x00U, 0x10U, 0U, 1U, 2U, 3U, 4U});
    Cycle();
    // Then all four are off, and the transfer that was open is none any more
    EXPECT_EQ(days, 0U);
    EXPECT_EQ(code, 0U);
    EXPECT_TRUE(Sent(0x6A0U).empty());
    EXPECT_NE(client.Client().State(), SdoClientState::kDone);
    EXPECT_EQ(room[0], 0U);
}

TEST_F(DeviceFurtherTest, SendInTheOrderInWhichTheyAreAsked)
{
    Verifies(req::SRS_DEV_212);
    Start();
    Configure();
    for (const bool is_second_first : {true, false})
    {
        const std::size_t before = ports.sent.size();
        // When both servers are asked in one cycle
        Frame(is_second_first ? 0x680U : 0x602U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
        Frame(is_second_first ? 0x602U : 0x680U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
        Cycle();
        // Then their answers leave in this order
        ASSERT_EQ(ports.sent.size(), before + 2U);
        EXPECT_EQ(ports.sent[before].identifier, is_second_first ? 0x6A0U : 0x582U);
        EXPECT_EQ(ports.sent[before + 1U].identifier, is_second_first ? 0x582U : 0x6A0U);
    }
}

TEST_F(DeviceFurtherTest, APlainDeviceMissesNoSafetyConfiguration)
{
    Verifies(req::SRS_DEV_021);
    is_configured = false;
    cia301::NoObjects none{};
    cia301::Dictionary plain{cia301::EntryTable{entries.data(), 12U}, none};
    Device other{DeviceParts{core, watch, plain, services, *this, FrameRoom{safety_frames.data(), 8U},
                             FrameRoom{service_frames.data(), 16U}, 3U}};
    ASSERT_EQ(other.PowerOn(Instant{now_us}), LoadResult::kLoaded);
    StampedFrame start{};
    start.frame = CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 2U}};
    other.OnFrame(start);
    other.Serve(Instant{now_us});
    EXPECT_EQ(other.State(), cia301::NodeState::kOperational);
    EXPECT_EQ(emergency.Register(), 0U);
    // Given one with 13FEh, it does
    services.dictionary = &dictionary;
    Run();
    EXPECT_EQ(emergency.Register(), 0x81U);
}

} // namespace
} // namespace counterpoint::device
