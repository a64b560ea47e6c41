// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/device/device_rig.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/node.hpp"

namespace counterpoint::device
{
namespace
{

using cia301::NodeState;
using Codes = std::vector<unsigned>;

using DeviceServicesTest = DeviceRig;

TEST_F(DeviceServicesTest, ServicesWorkInTheStatesOfTheTable)
{
    Verifies(req::SRS_DEV_010);
    stored_heartbeat_ms = 5U;
    Start();
    Cycles(12U);
    EXPECT_GE(Sent(0x702U).size(), 3U);
    EXPECT_EQ(Upload(0x1000U, 0U), 0x11223344U);
    EXPECT_TRUE(Sent(0x103U).empty());
    Command(1U);
    Forget();
    Cycles(40U);
    EXPECT_EQ(Upload(0x1000U, 0U), 0x11223344U);
    // In STOPPED there is the heartbeat, and neither SDO nor SRDO nor emergency
    Command(2U);
    Cycle();
    Forget();
    EXPECT_EQ(Upload(0x1000U, 0U), 0xFFFFFFFFU);
    core.DemandSafeState();
    Cycles(40U);
    EXPECT_GE(Sent(0x702U).size(), 7U);
    EXPECT_EQ(Sent(0x702U)[0], (Octets{4U}));
    EXPECT_TRUE(Sent(0x103U).empty());
    EXPECT_TRUE(Emergencies().empty());
    // What waited comes when it is left
    Command(128U);
    Cycles(2U);
    EXPECT_EQ(Emergencies(), (Codes{0x6200U}));
}

// Rows SRDO and GFC of the table: in OPERATIONAL only, received and sent.
TEST_F(DeviceServicesTest, SrdoAndGfcWorkInOperationalOnly)
{
    Verifies(req::SRS_DEV_010);
    Verifies(req::SRS_NMT_006);
    Start();
    struct Row
    {
        std::uint8_t command; ///< 0: the device stays in PRE-OPERATIONAL.
        SrdoState consumer;
        bool is_working;
    };
    for (const Row& row :
         {Row{0U, SrdoState::kOff, false}, Row{1U, SrdoState::kReleased, true}, Row{2U, SrdoState::kOff, false},
          Row{1U, SrdoState::kReleased, true}, Row{128U, SrdoState::kOff, false}, Row{130U, SrdoState::kOff, false}})
    {
        if (row.command != 0U)
        {
            Command(row.command);
        }
        Cycles(5U);
        Forget();
        Pair();
        Cycle(1U);
        Pair();
        Cycle(0U);
        Pair();
        Cycle(1U); // An acknowledge, where one is needed.
        EXPECT_EQ(core.GetState({0x1301U}).state, row.consumer) << unsigned{row.command};
        const int before = application.gfcs;
        Frame(0x001U, {});
        Cycles(60U);
        EXPECT_EQ(application.gfcs - before, row.is_working ? 1 : 0) << unsigned{row.command};
        EXPECT_EQ(Sent(0x103U).empty(), !row.is_working) << unsigned{row.command};
        EXPECT_EQ(core.SendGfc() == Result::kSuccessful, row.is_working) << unsigned{row.command};
    }
}

TEST_F(DeviceServicesTest, AnOpenTransferIsAbortedByStop)
{
    Verifies(req::SRS_DEV_011);
    Start();
    for (const std::uint8_t command : {std::uint8_t{128U}, std::uint8_t{1U}})
    {
        Command(command);
        Cycle();
        Frame(0x602U, {0x21U, 0x00U, 0x25U, 0U, 4U, 0U, 0U, 0U});
        device.Serve(Instant{now_us});
        ConfirmAll();
        Forget();
        Command(2U);
        Cycle();
        ASSERT_EQ(Sent(0x582U).size(), 1U) << int{command};
        EXPECT_EQ(Sent(0x582U)[0], (Octets{0x80U, 0x00U, 0x25U, 0U, 0x22U, 0x00U, 0x00U, 0x08U}));
    }
}

TEST_F(DeviceServicesTest, AResetEndsATransferWithoutAWord)
{
    Verifies(req::SRS_DEV_004);
    Start();
    Frame(0x602U, {0x21U, 0x00U, 0x25U, 0U, 4U, 0U, 0U, 0U});
    device.Serve(Instant{now_us});
    ConfirmAll();
    Forget();
    Command(130U);
    Cycle();
    EXPECT_TRUE(Sent(0x582U).empty());
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{0U}}));
    EXPECT_EQ(Upload(0x1000U, 0U), 0x11223344U);
}

TEST_F(DeviceServicesTest, EachLostNodeIsAnErrorOfItsOwn)
{
    Verifies(req::SRS_DEV_012);
    Run();
    EXPECT_EQ(Download(0x1016U, 1U, 0x0005000AU, 4U), 0U); // Node 5, 10 ms.
    EXPECT_EQ(Download(0x1016U, 2U, 0x0006000AU, 4U), 0U);
    Frame(0x705U, {5U});
    Frame(0x706U, {5U});
    Cycles(5U);
    Forget();
    Frame(0x706U, {5U});
    Cycles(8U);
    EXPECT_EQ(Emergencies(), (Codes{0x8130U}));
    EXPECT_EQ(device.State(), NodeState::kPreOperational);
    Cycles(8U);
    EXPECT_EQ(Emergencies(), (Codes{0x8130U, 0x8130U}));
    // When one returns, the other is still lost
    Frame(0x705U, {0U});
    Cycles(2U);
    EXPECT_EQ(Upload(0x1001U, 0U) & 0xFFU, 0x11U);
    Frame(0x706U, {127U});
    Cycles(2U);
    EXPECT_EQ(Upload(0x1001U, 0U) & 0xFFU, 0U);
}

TEST_F(DeviceServicesTest, ALostNodeThatNobodySupervisesAnyMoreIsNoError)
{
    Verifies(req::SRS_GRD_012);
    Start();
    EXPECT_EQ(Download(0x1016U, 1U, 0x0005000AU, 4U), 0U); // Node 5, 10 ms.
    EXPECT_EQ(Download(0x1016U, 2U, 0x0006000AU, 4U), 0U);
    Frame(0x705U, {5U});
    Frame(0x706U, {5U});
    Forget();
    Cycles(15U);
    EXPECT_EQ(Emergencies(), (Codes{0x8130U, 0x8130U}));
    // A refused value changes nothing, another node in its place ends it, and that of node 6 goes on
    EXPECT_NE(Download(0x1016U, 1U, 0x0006000AU, 4U), 0U);
    Cycles(2U);
    EXPECT_TRUE(Emergencies().empty());
    EXPECT_EQ(Download(0x1016U, 1U, 0x0007000AU, 4U), 0U);
    Cycles(2U);
    EXPECT_EQ(Emergencies(), (Codes{0U}));
    EXPECT_EQ(Upload(0x1001U, 0U) & 0xFFU, 0x11U);
    EXPECT_EQ(Download(0x1016U, 2U, 0U, 4U), 0U);
    Cycles(2U);
    EXPECT_EQ(Emergencies(), (Codes{0U}));
    EXPECT_EQ(Upload(0x1001U, 0U) & 0xFFU, 0U);
}

// Eight errors take all places but the last one, and their messages wait.
TEST_F(DeviceServicesTest, NothingHidesTheDeviceSafeState)
{
    Verifies(req::SRS_EMCY_010);
    Verifies(req::SRS_DEV_015);
    Run();
    Forget();
    for (std::uint16_t number = 1U; number <= 9U; ++number)
    {
        services.errors.Raise(cia301::CommunicationError::kPdoShort, number);
    }
    core.DemandSafeState();
    Cycles(12U);
    EXPECT_EQ(Emergencies(), (Codes{0x8210U, 0x8210U, 0x8210U, 0x8210U, 0x8210U, 0x8210U, 0x8210U, 0x8210U, 0x6200U}));
    EXPECT_EQ(Upload(0x1001U, 0U) & 0xFFU, 0x91U);
}

/// A manager takes what is from 5000h to 7FFFh for the safe state.
TEST_F(DeviceServicesTest, EachDeviceFaultHasACodeOfTheDeviceNotOfTheBus)
{
    Verifies(req::SRS_DEV_015);
    Run();
    const std::vector<std::pair<DeviceFault, unsigned>> codes{
        {DeviceFault::kSelfTest, 0x5000U},      {DeviceFault::kClock, 0x5000U},
        {DeviceFault::kApplication, 0x6200U},   {DeviceFault::kHandshake, 0x6200U},
        {DeviceFault::kConfiguration, 0x6300U}, {DeviceFault::kCrossLink, 0x7500U},
        {DeviceFault::kFrameOrder, 0x6100U},    {DeviceFault::kLateCall, 0x6100U},
        {DeviceFault::kFlow, 0x6100U},          {DeviceFault::kDisagreement, 0x6100U},
        {DeviceFault::kUnmatched, 0x6100U},     {DeviceFault::kGuard, 0x6100U},
        {DeviceFault::kComparator, 0x6100U},    {DeviceFault::kInvalid, 0x6100U},
        {DeviceFault::kOutput, 0x6100U}};
    for (const auto& [fault, code] : codes)
    {
        Forget();
        watch.OnDeviceFault({fault, 0U, 1U});
        Cycles(2U);
        EXPECT_EQ(Emergencies(), (Codes{code})) << static_cast<unsigned>(fault);
        watch.OnRestart();
        Cycles(2U);
    }
}

TEST_F(DeviceServicesTest, PlacesForEmergenciesFollowFromWhatADeviceHas)
{
    Verifies(req::SRS_EMCY_010);
    ServiceRooms rooms{{nullptr, 127U}, {nullptr, 0U}, {nullptr, 512U}, {nullptr, 0U}};
    EXPECT_EQ(EmergencyPlaces(64U, rooms), 320U + 1536U + 127U + 32U);
    rooms.supervised.count = 2U;
    rooms.rpdos.count = 0U;
    EXPECT_EQ(EmergencyPlaces(3U, rooms), 15U + 2U + 32U);
}

TEST_F(DeviceServicesTest, TheReactionToALostNodeIs1029s)
{
    Verifies(req::SRS_DEV_012);
    Run();
    EXPECT_EQ(Download(0x1029U, 1U, 1U, 1U), 0U);
    EXPECT_EQ(Download(0x1016U, 1U, 0x0005000AU, 4U), 0U);
    Frame(0x705U, {5U});
    Cycles(15U);
    EXPECT_EQ(device.State(), NodeState::kOperational);
    EXPECT_EQ(Download(0x1029U, 1U, 2U, 1U), 0U);
    Frame(0x705U, {5U});
    Cycles(15U);
    EXPECT_EQ(device.State(), NodeState::kStopped);
    // The consumer works in STOPPED, too: nothing more happens, and nothing is forgotten
    Frame(0x705U, {5U});
    Command(128U);
    Forget();
    Cycles(2U);
    EXPECT_EQ(Emergencies(), (Codes{0U}));
}

TEST_F(DeviceServicesTest, ALostMasterIsToldAndItsReturn)
{
    Verifies(req::SRS_DEV_012);
    Start();
    EXPECT_EQ(Download(0x100CU, 0U, 5U, 2U), 0U);
    EXPECT_EQ(Download(0x100DU, 0U, 2U, 1U), 0U);
    Forget();
    Remote(0x702U);
    Cycles(15U);
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{127U}}));
    EXPECT_EQ(Emergencies(), (Codes{0x8130U}));
    Remote(0x702U);
    Cycles(2U);
    EXPECT_EQ(Emergencies(), (Codes{0x8130U, 0U}));
    // In OPERATIONAL the reaction of 1029h:01 follows
    Command(1U);
    Remote(0x702U);
    Cycles(2U);
    EXPECT_EQ(device.State(), NodeState::kOperational);
    Cycles(15U);
    EXPECT_EQ(device.State(), NodeState::kPreOperational);
}

// Life time 10 ms, cycle 1 ms
TEST_F(DeviceServicesTest, AMasterThatTurnsToHeartbeatsIsNotLost)
{
    Verifies(req::SRS_GRD_010);
    Run();
    EXPECT_EQ(Download(0x100CU, 0U, 5U, 2U), 0U);
    EXPECT_EQ(Download(0x100DU, 0U, 2U, 1U), 0U);
    Remote(0x702U);
    Cycles(2U);
    EXPECT_EQ(Download(0x1017U, 0U, 5U, 2U), 0U);
    Forget();
    Cycles(30U);
    EXPECT_EQ(device.State(), NodeState::kOperational);
    EXPECT_TRUE(Emergencies().empty());
    EXPECT_GE(Sent(0x702U).size(), 5U);
    EXPECT_FALSE(Sent(0x103U).empty());
    // Without heartbeats it waits for a remote frame, and then guards again
    EXPECT_EQ(Download(0x1017U, 0U, 0U, 2U), 0U);
    Cycles(30U);
    EXPECT_TRUE(Emergencies().empty());
    Remote(0x702U);
    Cycles(15U);
    EXPECT_EQ(Emergencies(), (Codes{0x8130U}));
    EXPECT_EQ(device.State(), NodeState::kPreOperational);
}

TEST_F(DeviceServicesTest, ALostMasterIsNoErrorWhereNobodyIsGuardedAnyMore)
{
    Verifies(req::SRS_GRD_011);
    Start();
    struct Row
    {
        std::uint16_t index;
        std::uint32_t value;
        std::uint8_t size; ///< 0: the master guards again.
    };
    for (const Row& row : {Row{0U, 0U, 0U}, Row{0x1017U, 5U, 2U}, Row{0x100CU, 0U, 2U}, Row{0x100DU, 3U, 1U}})
    {
        EXPECT_EQ(Download(0x1017U, 0U, 0U, 2U), 0U);
        EXPECT_EQ(Download(0x100CU, 0U, 5U, 2U), 0U);
        EXPECT_EQ(Download(0x100DU, 0U, 2U, 1U), 0U);
        Remote(0x702U);
        Forget();
        Cycles(15U);
        EXPECT_EQ(Emergencies(), (Codes{0x8130U})) << row.index;
        EXPECT_EQ(Upload(0x1001U, 0U) & 0xFFU, 0x11U) << row.index;
        if (row.size == 0U)
        {
            Remote(0x702U);
        }
        EXPECT_TRUE((row.size == 0U) || (Download(row.index, 0U, row.value, row.size) == 0U)) << row.index;
        Cycles(2U);
        EXPECT_EQ(Emergencies(), (Codes{0U})) << row.index;
        EXPECT_EQ(Upload(0x1001U, 0U) & 0xFFU, 0U) << row.index;
    }
}

TEST_F(DeviceServicesTest, SrdoErrorsAreEmergenciesUntilTheNextGoodPair)
{
    Verifies(req::SRS_DEV_013);
    Run();
    Pair();
    Cycle();
    Forget();
    // When a frame is too short
    Frame(0x101U, {0x12U});
    Cycles(2U);
    ASSERT_EQ(Sent(0x82U).size(), 1U);
    EXPECT_EQ(Sent(0x82U)[0], (Octets{0x10U, 0x82U, 0x11U, 1U, 1U, 0U, 0U, 0U}));
    // and then the inverse frame comes first: an error of another kind
    Frame(0x102U, {0xEDU, 0xCBU});
    Cycles(2U);
    ASSERT_EQ(Sent(0x82U).size(), 2U);
    EXPECT_EQ(Sent(0x82U)[1], (Octets{0x50U, 0x82U, 0x11U, 1U, 2U, 0U, 0U, 0U}));
    // Then a good pair ends both
    Pair();
    Cycles(3U);
    EXPECT_EQ(Emergencies(), (Codes{0x8210U, 0x8250U, 0U, 0U}));
    EXPECT_EQ(Upload(0x1001U, 0U) & 0xFFU, 0U);
}

TEST_F(DeviceServicesTest, GfcAndLeavingAreNoErrors)
{
    Verifies(req::SRS_DEV_013);
    Run();
    Pair();
    Cycle();
    Forget();
    Frame(0x001U, {});
    Cycles(2U);
    EXPECT_EQ(application.gfcs, 1);
    Pair();
    Cycle();
    Frame(0x101U, {0x12U});
    Cycles(2U);
    EXPECT_EQ(Emergencies(), (Codes{0x8210U}));
    // OPERATIONAL is left: SRDOs have no errors any more
    Command(128U);
    Cycles(3U);
    EXPECT_EQ(Emergencies(), (Codes{0x8210U, 0U}));
}

TEST_F(DeviceServicesTest, ATransmissionThatFailsIsTold)
{
    Verifies(req::SRS_DEV_013);
    Run();
    Cycles(10U);
    Forget();
    ports.answer = hal::TransmitStatus::kBusOff;
    Cycles(30U);
    ports.answer = hal::TransmitStatus::kAccepted;
    Cycles(40U);
    EXPECT_EQ(Emergencies(), (Codes{0x8100U, 0U}));
}

TEST_F(DeviceServicesTest, EachCauseOfAnSrdoHasItsCode)
{
    Verifies(req::SRS_DEV_013);
    Run();
    const std::vector<std::pair<std::uint8_t, unsigned>> codes{
        {1U, 0x8210U}, {2U, 0x8250U}, {3U, 0x8250U},  {4U, 0x8250U},  {5U, 0x8250U},  {6U, 0x8250U},  {7U, 0x8250U},
        {8U, 0x8110U}, {9U, 0x8250U}, {13U, 0x8100U}, {14U, 0x8100U}, {15U, 0x8100U}, {16U, 0x6200U}, {17U, 0x8100U}};
    for (const auto& [cause, code] : codes)
    {
        SCOPED_TRACE(int{cause});
        Forget();
        watch.OnSrdoError({0x1302U}, static_cast<SrdoCause>(cause));
        Cycles(2U);
        // Then the first two bytes of the details are the SRDO and the cause, and its next pair ends it
        ASSERT_EQ(Emergencies(), (Codes{code}));
        EXPECT_EQ(Sent(0x82U)[0][3], 2U);
        EXPECT_EQ(Sent(0x82U)[0][4], cause);
        watch.OnSrdoEvent({0x1302U});
        Cycles(2U);
        EXPECT_EQ(Emergencies(), (Codes{code, 0U}));
    }
    // Leaving OPERATIONAL, GFC, what only the other channel saw and waiting for the first pair are none
    Forget();
    for (const std::uint8_t cause : {std::uint8_t{10U}, std::uint8_t{11U}, std::uint8_t{12U}, std::uint8_t{18U}})
    {
        watch.OnSrdoError({0x1302U}, static_cast<SrdoCause>(cause));
    }
    Cycles(2U);
    EXPECT_TRUE(Emergencies().empty());
}

TEST_F(DeviceServicesTest, AConfigurationThatDoesNotHoldNamesItsFirstSrdo)
{
    Verifies(req::SRS_DEV_014);
    Run();
    Forget();
    watch.OnConfigurationInvalid({0x1303U});
    Cycles(2U);
    EXPECT_EQ(Sent(0x82U), (std::vector<Octets>{{0x00U, 0x63U, 0x81U, 3U, 0U, 0U, 0U, 0U}}));
    Command(128U);
    Cycles(2U);
    EXPECT_EQ(Emergencies(), (Codes{0x6300U, 0U}));
}

TEST_F(DeviceServicesTest, OperationalWithoutAConfigurationIs6300)
{
    Verifies(req::SRS_DEV_014);
    is_configured = false;
    Run();
    Cycles(40U);
    ASSERT_EQ(Sent(0x82U).size(), 1U);
    EXPECT_EQ(Sent(0x82U)[0], (Octets{0x00U, 0x63U, 0x81U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_TRUE(Sent(0x103U).empty());
    // It ends with OPERATIONAL
    Command(128U);
    Cycles(2U);
    EXPECT_EQ(Emergencies(), (Codes{0x6300U, 0U}));
    // and does not come with a valid configuration
    EXPECT_EQ(Download(0x13FEU, 0U, 0xA5U, 1U), 0U);
    Forget();
    Command(1U);
    Cycles(2U);
    EXPECT_TRUE(Emergencies().empty());
}

TEST_F(DeviceServicesTest, BusOffEmptiesAndReacts)
{
    Verifies(req::SRS_DEV_016);
    Run();
    device.OnBus(BusCondition::kPassive);
    Cycles(2U);
    EXPECT_EQ(Emergencies(), (Codes{0x8120U}));
    device.OnBus(BusCondition::kActive);
    Cycles(2U);
    EXPECT_EQ(Emergencies(), (Codes{0x8120U, 0U}));
    Forget();
    // Given half of a download, an answer that waits, and bus-off
    Frame(0x602U, {0x21U, 0x00U, 0x25U, 0U, 4U, 0U, 0U, 0U});
    Cycle();
    ASSERT_EQ(Sent(0x582U).size(), 1U);
    Forget();
    ports.answer = hal::TransmitStatus::kBusOff;
    Frame(0x705U, {5U});
    static_cast<void>(services.outbox.Send(CanFrame{0x582U, FrameKind::kData, CanPortId::kFirst, 1U, {0x55U}}));
    device.OnBus(BusCondition::kOff);
    Cycles(3U);
    EXPECT_EQ(device.State(), NodeState::kPreOperational);
    device.OnBus(BusCondition::kOff);
    ports.answer = hal::TransmitStatus::kAccepted;
    device.OnBus(BusCondition::kActive);
    Cycles(3U);
    EXPECT_EQ(Emergencies(), (Codes{0x8140U, 0U}));
    // Then what waited is gone, and a segment of the download is answered by nobody's transfer: 0504 0001h
    EXPECT_TRUE(Sent(0x582U).empty());
    Frame(0x602U, {0x07U, 1U, 2U, 3U, 4U, 0U, 0U, 0U});
    Cycles(2U);
    EXPECT_EQ(Sent(0x582U), (std::vector<Octets>{{0x80U, 0x00U, 0x00U, 0U, 0x01U, 0x00U, 0x04U, 0x05U}}));
}

TEST_F(DeviceServicesTest, LostFramesOfServicesAreTold)
{
    Verifies(req::SRS_DEV_016);
    Start();
    Forget();
    for (int count = 0; count < 17; ++count)
    {
        Frame(0x705U, {5U});
    }
    Cycles(3U);
    EXPECT_EQ(Emergencies(), (Codes{0x8110U, 0U}));
}

TEST_F(DeviceServicesTest, TheEmergencyAndSyncHaveIdentifiersOfTheirOwn)
{
    Verifies(req::SRS_EMCY_003);
    Start();
    // Given an emergency that is off, then it is not turned on with SYNC's identifier
    EXPECT_EQ(Download(0x1014U, 0U, 0x80000082U, 4U), 0U);
    EXPECT_EQ(Download(0x1014U, 0U, 0x80U, 4U), 0x06090030U);
    EXPECT_EQ(Download(0x1014U, 0U, 0x80000080U, 4U), 0U); // Off, it has none.
    EXPECT_EQ(Download(0x1014U, 0U, 0x82U, 4U), 0U);
    EXPECT_EQ(Download(0x1014U, 0U, 0x82U, 4U), 0U); // Its own one is no other service's.
    // nor SYNC moved to the emergency's
    EXPECT_EQ(Download(0x1005U, 0U, 0x82U, 4U), 0x06090030U);
    EXPECT_EQ(Download(0x1005U, 0U, 0x83U, 4U), 0U);
    EXPECT_EQ(Download(0x1005U, 0U, 0x83U, 4U), 0U);
}

TEST_F(DeviceServicesTest, AnotherNodeWithOurIdentifierIsTold)
{
    Verifies(req::SRS_DEV_016);
    Start();
    Forget();
    Frame(0x702U, {5U});
    Cycles(2U);
    EXPECT_EQ(Emergencies(), (Codes{0x8150U}));
    Frame(0x582U, {0x60U, 0U, 0U, 0U, 0U, 0U, 0U, 0U});
    Cycles(2U);
    EXPECT_EQ(Emergencies(), (Codes{0x8150U, 0x8150U}));
}

TEST_F(DeviceServicesTest, TheSafetyConfigurationProcedureWorksOverSdo)
{
    Verifies(req::SRS_DEV_017);
    Start();
    const std::uint32_t signature = Upload(0x13FFU, 1U);
    // Given another SCT, the configuration is no longer valid and its signature wrong
    EXPECT_EQ(Download(0x1301U, 2U, 60U, 2U), 0U);
    EXPECT_EQ(Upload(0x13FEU, 0U) & 0xFFU, 0U);
    EXPECT_EQ(Download(0x13FEU, 0U, 0xA5U, 1U), 0x06040043U);
    // The old value and its signature are valid again
    EXPECT_EQ(Download(0x1301U, 2U, 50U, 2U), 0U);
    EXPECT_EQ(Upload(0x13FFU, 1U), signature);
    EXPECT_EQ(Download(0x13FEU, 0U, 0xA5U, 1U), 0U);
    EXPECT_EQ(Upload(0x13FEU, 0U) & 0xFFU, 0xA5U);
    // In OPERATIONAL nothing of it can be written, identical or not
    Command(1U);
    Cycle();
    EXPECT_EQ(Download(0x1301U, 2U, 50U, 2U), 0x08000022U);
    EXPECT_EQ(Download(0x13FEU, 0U, 0xA5U, 1U), 0x08000022U);
    EXPECT_EQ(Download(0x1300U, 0U, 1U, 1U), 0U);
}

TEST_F(DeviceServicesTest, AMappingThatNamesAnOwnObjectIsNotMappable)
{
    Verifies(req::SRS_DEV_017);
    Start();
    EXPECT_EQ(Download(0x1301U, 1U, 0U, 1U), 0U);
    EXPECT_EQ(Download(0x1381U, 0U, 0U, 1U), 0U);
    EXPECT_EQ(Download(0x1381U, 1U, 0x25000020U, 4U), 0x06040041U);
    EXPECT_EQ(Download(0x1381U, 1U, 0x25010020U, 4U), 0x06020000U);
    EXPECT_EQ(Download(0x1381U, 1U, 0x24FF0020U, 4U), 0x06020000U); // The next one below.
    EXPECT_EQ(Download(0x1381U, 1U, 0x22000110U, 4U), 0U);
}

TEST_F(DeviceServicesTest, ABusOfWhichNothingIsKnownIsOff)
{
    Verifies(req::SRS_DEV_016);
    Run();
    // Given a driver that tells no condition at all, then the reaction is that to bus-off
    device.OnBus(BusCondition::kInvalid);
    Cycles(3U);
    EXPECT_EQ(device.State(), NodeState::kPreOperational);
    // and told once it is there again
    device.OnBus(BusCondition::kActive);
    Cycles(3U);
    EXPECT_EQ(Emergencies(), (Codes{0x8140U, 0U}));
}

TEST_F(DeviceServicesTest, WithoutRoomHeartbeatAndEmergencyWait)
{
    Verifies(req::SRS_DEV_009);
    Run();
    EXPECT_EQ(Download(0x1017U, 0U, 1U, 2U), 0U);
    Cycles(3U);
    Forget();
    // Given an outbox that other frames fill, own messages too, a controller that has no place, and an error
    ports.answer = hal::TransmitStatus::kQueueFull;
    for (std::uint8_t count = 0U; count < 16U; ++count)
    {
        static_cast<void>(services.outbox.Send(CanFrame{0x5FFU, FrameKind::kData, CanPortId::kFirst, 1U, {count}}));
    }
    EXPECT_FALSE(services.outbox.Send(CanFrame{}));
    while (services.outbox.HasOwnRoom())
    {
        ASSERT_TRUE(services.outbox.SendOwn(CanFrame{0x5FEU, FrameKind::kData, CanPortId::kFirst, 1U, {0U}}));
    }
    watch.OnSrdoError({0x1302U}, SrdoCause::kSct);
    Cycles(3U);
    EXPECT_TRUE(Emergencies().empty());
    EXPECT_TRUE(Sent(0x702U).empty());
    // When the controller takes frames again, then both are sent, and the error was not forgotten
    ports.answer = hal::TransmitStatus::kAccepted;
    Cycles(12U);
    EXPECT_EQ(Emergencies(), (Codes{0x8250U}));
    EXPECT_FALSE(Sent(0x702U).empty());
}

} // namespace
} // namespace counterpoint::device
