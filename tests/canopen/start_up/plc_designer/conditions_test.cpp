// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Conditions of the PLC Designer text at their edges: nobody to wait for, commands in states that they do not change,
// and SDO connections that try again by themselves.
#include "canopen/cia302/network/objects.hpp"
#include "tests/canopen/start_up/plc_designer/rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

using PlcConditionsTest = PlcRig;

TEST_F(PlcConditionsTest, WithoutASlaveTheMasterRunsAndStartsAllOnce)
{
    Verifies(req::SRS_PLC_009);
    Verifies(req::SRS_PLC_014);
    setup.start_up = kIsMaster | kStartAllAtOnce;
    Begin();
    Run(3000U);
    EXPECT_EQ(masters, (Log{"0", "1", "2", "3", "5"}));
    EXPECT_EQ(Commands(), (Log{"01 00"}));
}

TEST_F(PlcConditionsTest, WithoutASlaveNobodyIsStartedUnless1F80hSaysSo)
{
    Verifies(req::SRS_PLC_014);
    Verifies(req::SRS_PLC_015);
    for (const std::uint32_t bits :
         {std::uint32_t{kIsMaster}, std::uint32_t{kIsMaster | kStartAllAtOnce | kApplicationStartsSlaves}})
    {
        setup.start_up = bits;
        Begin();
        Run(3000U);
        EXPECT_EQ(plc.MasterState(), 5);
        EXPECT_EQ(Commands(), (Log{}));
    }
}

TEST_F(PlcConditionsTest, TheMasterStaysInState3UntilItsOwnStartWasHandedOver)
{
    Verifies(req::SRS_PLC_009);
    nmt.SetActive(false);
    Begin();
    Run(100U);
    EXPECT_EQ(plc.MasterState(), 3);
    nmt.SetActive(true);
    Run(1U);
    EXPECT_EQ(plc.MasterState(), 5);
}

TEST_F(PlcConditionsTest, ASlaveThatHadAllItsSdosAndIsResetByCommandKeepsNobodyInState3)
{
    Verifies(req::SRS_PLC_009);
    // Given a slave that runs, and one that the master waits for
    AddPlc(5U);
    AddPlc(9U);
    slaves[9]->is_on = false;
    Begin();
    Run(2600U);
    ASSERT_EQ(Code(5U), 5);
    ASSERT_EQ(plc.MasterState(), 3);
    // When the first is reset and does not come back, and the other one answers
    EXPECT_EQ(Command(NmtCommand::kResetNode, 5U), NmtAnswer::kTaken);
    slaves[5]->is_on = false;
    slaves[9]->is_on = true;
    Run(600U);
    // Then all SDOs of both were answered once
    EXPECT_EQ(Code(5U), 1);
    EXPECT_EQ(Code(9U), 5);
    EXPECT_EQ(plc.MasterState(), 5);
}

TEST_F(PlcConditionsTest, ASlaveThatIsResetByCommandInTheMiddleOfItsSdosIsWaitedFor)
{
    Verifies(req::SRS_PLC_009);
    Verifies(req::SRS_PLC_010);
    AddPlc(5U);
    User(5U, 0x2000U, 0U, {1U});
    User(5U, 0x2001U, 0U, {2U});
    slaves[5]->Behave(0x2001U, 0U, Manner::kSilent);
    Begin();
    Run(600U);
    ASSERT_EQ(Code(5U), 3);
    slaves[5]->log.clear();
    EXPECT_EQ(Command(NmtCommand::kResetCommunication, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Code(5U), 1);
    Run(600U);
    EXPECT_EQ(plc.MasterState(), 3);
    slaves[5]->Behave(0x2001U, 0U, Manner::kGood);
    Run(510U);
    EXPECT_EQ(plc.MasterState(), 5);
    EXPECT_EQ(slaves[5]->log, (Log{"nmt 82", "r 1000:00", "w 2000:00 01", "w 2001:00 02", "w 2001:00 02", "nmt 01"}));
}

TEST_F(PlcConditionsTest, ABootUpMessageBeforeTheResetWasHandedOverChangesNothing)
{
    Verifies(req::SRS_PLC_002);
    Verifies(req::SRS_PLC_018);
    AddPlc(5U);
    nmt.SetActive(false);
    Begin();
    Run(10U);
    slaves[5]->Power(Now().us);
    Run(50U);
    EXPECT_EQ(Code(5U), -1);
    nmt.SetActive(true);
    Run(1U);
    EXPECT_EQ(Code(5U), 1);
    EXPECT_EQ(Commands(), (Log{"81 05"}));
}

TEST_F(PlcConditionsTest, All16BitsOfTheDeviceTypeCountAndAnAbortIsNoValue)
{
    Verifies(req::SRS_PLC_016);
    // Given a slave that differs in bit 8 alone, and one that refuses to say its type, expected 0 in the low 16 bits
    AddPlc(5U);
    slaves[5]->Set(0x1000U, 0U, 0x291U);
    AddPlc(6U);
    setups[6].device_type = 0x10000U;
    slaves[6]->Behave(0x1000U, 0U, Manner::kAbort);
    Begin();
    Run(600U);
    EXPECT_EQ(Code(5U), 98);
    EXPECT_EQ(Code(6U), 98);
    EXPECT_EQ(Of(6U).abort, SdoAbort::kObjectUnknown);
}

TEST_F(PlcConditionsTest, AnAbortOf1000hIsToldBehindAllSdosWhateverIsExpected)
{
    Verifies(req::SRS_PLC_016);
    // Given slaves that refuse 1000h and take their SDOs, one of any type, one of another profile
    Octets list{};
    BootRig::AddEntry(list, 0x2000U, 0U, {1U});
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}})
    {
        AddPlc(node);
        setups[node].concise_dcf = Bytes{list.data(), static_cast<std::uint32_t>(list.size())};
        slaves[node]->Set(0x2000U, 0U, 0U);
        slaves[node]->Behave(0x1000U, 0U, Manner::kAbort);
    }
    setups[5].device_type = 0U;
    Begin();
    Run(700U);
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}})
    {
        EXPECT_EQ(Code(node), 98) << int{node};
        EXPECT_EQ(slaves[node]->log, (Log{"nmt 81", "r 1000:00", "w 2000:00 01"})) << int{node};
        EXPECT_EQ(Of(node).object.index, 0x1000U) << int{node};
        EXPECT_EQ(Of(node).abort, SdoAbort::kObjectUnknown) << int{node};
        EXPECT_FALSE(Of(node).is_started) << int{node};
    }
}

TEST_F(PlcConditionsTest, AHoldingCommandChangesNoOtherStateThan5)
{
    Verifies(req::SRS_PLC_015);
    Verifies(req::SRS_PLC_150);
    // Given slaves in states 98, 99 and 3
    AddPlc(5U);
    slaves[5]->Set(0x1000U, 0U, 0x192U);
    AddPlc(6U);
    setups[6].heartbeat = HeartbeatSetup{300U, 100U, Arming::kImmediately};
    AddPlc(7U);
    slaves[7]->Behave(0x1000U, 0U, Manner::kSilent);
    Begin();
    Run(1200U);
    ASSERT_EQ(Code(6U), 99);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kWrong);
    EXPECT_EQ(Command(NmtCommand::kStart, 7U), NmtAnswer::kWrong);
    for (const NmtCommand command : {NmtCommand::kStop, NmtCommand::kPreOperational})
    {
        EXPECT_EQ(Command(command, 0U), NmtAnswer::kTaken);
        EXPECT_EQ(Code(5U), 98);
        EXPECT_EQ(Code(6U), 99);
        EXPECT_EQ(Code(7U), 3);
    }
}

TEST_F(PlcConditionsTest, AStartByCommandEndsTheHold)
{
    Verifies(req::SRS_PLC_013);
    Verifies(req::SRS_PLC_015);
    AddPlc(5U);
    Begin();
    Run(600U);
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(5U);
    // When it restarts later, then it is started by itself again
    slaves[5]->Power(Now().us);
    Run(600U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Commands(), (Log{"81 05", "01 05", "80 05", "01 05", "01 05"}));
}

TEST_F(PlcConditionsTest, AStartFromState99BeginsGuardingAnew)
{
    Verifies(req::SRS_PLC_150);
    Verifies(req::SRS_PLC_017);
    AddPlc(5U);
    setups[5].assignment |= (100U << 16U) | (3U << 8U);
    Begin();
    Run(600U);
    slaves[5]->answers_guard = false;
    Run(450U);
    ASSERT_EQ(Code(5U), 99);
    // When it still does not answer, then it is lost again
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(250U);
    EXPECT_EQ(Code(5U), 5);
    Run(200U);
    EXPECT_EQ(Code(5U), 99);
    // When it does, then it is supervised as before
    slaves[5]->answers_guard = true;
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(1000U);
    EXPECT_EQ(Code(5U), 5);
    slaves[5]->answers_guard = false;
    Run(450U);
    EXPECT_EQ(Code(5U), 99);
}

/// As a network file with other `sdo_timeout` and `sdo_tries` than this profile's has it.
class PlcTriesTest : public PlcRig, public ::testing::WithParamInterface<SdoTimes>
{
  public:
    PlcTriesTest() : PlcRig(GetParam())
    {
    }
    /// Times in ms of the manager's requests for 1000h.
    [[nodiscard]] std::vector<std::uint32_t> Reads(const std::uint32_t identifier) const
    {
        std::vector<std::uint32_t> times{};
        for (const Sent& one : sent)
        {
            const bool is_read = (one.frame.identifier == identifier) && (one.frame.data[0] == 0x40U);
            if (is_read)
            {
                times.push_back(one.at_us / 1000U);
            }
        }
        return times;
    }
};

INSTANTIATE_TEST_SUITE_P(Times, PlcTriesTest,
                         ::testing::Values(SdoTimes{100000U, 3U}, SdoTimes{500000U, 2U}, SdoTimes{250000U, 255U},
                                           SdoTimes{2000000U, 3U}));

// t [ms]   2004    2504      3004              3504
// slave 9  2       3 1000h   97
// slave 5  2       3 1000h   1000h             1000h
TEST_P(PlcTriesTest, DeviceTypeIsReadOnceOfAnOptionalSlaveAndEachHalfSecondOfAnother)
{
    Verifies(req::SRS_PLC_005);
    Verifies(req::SRS_PLC_008);
    AddPlc(5U);
    AddPlc(9U);
    plc_slaves[9].is_optional = true;
    slaves[5]->is_on = false;
    slaves[9]->is_on = false;
    Begin();
    Run(3003U);
    EXPECT_EQ(Code(9U), 3);
    Run(1U);
    EXPECT_EQ(Code(9U), 97);
    Run(996U);
    EXPECT_EQ(Reads(0x609U), (std::vector<std::uint32_t>{2504U}));
    EXPECT_EQ(Reads(0x605U), (std::vector<std::uint32_t>{2504U, 3004U, 3504U}));
}

TEST_F(PlcConditionsTest, StoppedBehindItsBootUpMessageItIsWokenToBeAsked)
{
    Verifies(req::SRS_PLC_005);
    AddPlc(5U);
    Begin600();
    ASSERT_EQ(Code(5U), 5);
    sent.clear();
    // When it restarts by itself and takes somebody's stop behind its boot-up message
    slaves[5]->heartbeat_us = 100000U;
    slaves[5]->Turn(4U);
    Put(0x705U, {0U});
    Run(900U);
    EXPECT_EQ(Code(5U), 3);
    EXPECT_EQ(Commands(), (Log{}));
    // Then half a second of silence is followed by a command
    Run(300U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Commands(), (Log{"80 05", "01 05"}));
}

TEST_F(PlcConditionsTest, StoppedByACommandWhileItIsAskedItStaysSo)
{
    Verifies(req::SRS_PLC_005);
    AddPlc(5U);
    slaves[5]->Behave(0x1000U, 0U, Manner::kSilent);
    Begin600();
    slaves[5]->heartbeat_us = 100000U;
    ASSERT_EQ(Code(5U), 3);
    sent.clear();
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    Run(3000U);
    EXPECT_EQ(Code(5U), 3);
    EXPECT_EQ(Commands(), (Log{"02 05"}));
}

using PlcCommandTest = PlcRig;

TEST_F(PlcCommandTest, AHoldLastsBehindTheResetForTheDefaults)
{
    Verifies(req::SRS_PLC_030);
    // Given a slave that takes its defaults, and an order before the reset behind them, in each ms from its boot-up on
    for (std::uint32_t at_ms = 7U; at_ms < 509U; at_ms += 50U)
    {
        AddPlc(5U);
        plc_slaves[5].is_reset = true;
        Begin();
        Run(at_ms);
        EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
        sent.clear();
        Run(1500U);
        EXPECT_EQ(Commands(), (Log{"81 05"})) << at_ms;
        EXPECT_EQ(Code(5U), 4) << at_ms;
        EXPECT_FALSE(Of(5U).is_started) << at_ms;
        plc.End();
    }
}

TEST_F(PlcCommandTest, AHoldLastsUntilTheStartTheBootOrTheResetIsOrdered)
{
    Verifies(req::SRS_PLC_030);
    for (const char* const order : {"start", "boot", "reset"})
    {
        // Given a slave that is made PRE-OPERATIONAL in the middle of its start-up
        AddPlc(5U);
        Begin();
        Run(100U);
        EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
        Run(5000U);
        EXPECT_EQ(Code(5U), 4) << order;
        EXPECT_FALSE(Of(5U).is_started) << order;
        // When it is ordered, then it runs
        if (order[0] == 'b')
        {
            EXPECT_TRUE(Do([this] { return plc.Boot(NodeId{5U}, Now()); }));
        }
        else
        {
            EXPECT_EQ(Command((order[0] == 's') ? NmtCommand::kStart : NmtCommand::kResetNode, 5U), NmtAnswer::kTaken);
        }
        Run(3000U);
        EXPECT_EQ(Code(5U), 5) << order;
        EXPECT_TRUE(Of(5U).is_started) << order;
        plc.End();
    }
}

TEST_F(PlcCommandTest, AnOptionalSlaveThatWasStoppedIsLeftOutOfTheStartOfAll)
{
    Verifies(req::SRS_PLC_030);
    setup.start_up = kIsMaster | kStartAllAtOnce;
    AddPlc(5U);
    AddPlc(6U);
    plc_slaves[5].is_optional = true;
    Begin();
    Run(100U);
    EXPECT_EQ(Command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    sent.clear();
    Run(3000U);
    EXPECT_EQ(Commands(), (Log{"01 06"}));
    EXPECT_EQ(Code(5U), 97);
    EXPECT_EQ(slaves[5]->state, 4U);
    EXPECT_EQ(Code(6U), 5);
}

TEST_F(PlcCommandTest, CommandsHoldASlaveInState4)
{
    Verifies(req::SRS_PLC_015);
    AddPlc(5U);
    Begin600();
    EXPECT_TRUE(Of(5U).is_started);
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    EXPECT_FALSE(Of(5U).is_started);
    EXPECT_EQ(Code(5U), 4);
    Run(1000U);
    EXPECT_EQ(Code(5U), 4);
    slaves[5]->Power(Now().us);
    Run(600U);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Commands(), (Log{"81 05", "01 05", "80 05"}));
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(5U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken); // nothing to do
    EXPECT_EQ(Command(NmtCommand::kResetCommunication, 0U), NmtAnswer::kTaken);
    EXPECT_EQ(Code(5U), 1);
    Run(600U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Commands(), (Log{"81 05", "01 05", "80 05", "01 05", "82 05", "01 05"}));
    EXPECT_EQ(Command(NmtCommand::kStart, 6U), NmtAnswer::kWrong);
    plc.End();
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kNotActive);
    EXPECT_EQ(plc.MasterState(), 0);
}

TEST_F(PlcCommandTest, AStartOfAllSaysWhetherSomebodyWasLeftOut)
{
    Verifies(req::SRS_PLC_151);
    // Given one that waits for its start, one of another type, and an optional one that is absent
    setup.start_up = kIsMaster | kApplicationStartsSlaves;
    AddPlc(5U);
    AddPlc(6U);
    slaves[6]->Set(0x1000U, 0U, 0x192U);
    AddPlc(7U);
    plc_slaves[7].is_optional = true;
    slaves[7]->is_on = false;
    Begin();
    // When nobody is configured yet, then when one is
    Run(400U);
    EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kWrong);
    Run(3000U);
    EXPECT_EQ(Command(NmtCommand::kStart, 0U), NmtAnswer::kPartly);
    Run(10U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Code(6U), 98);
    EXPECT_EQ(Code(7U), 97);
    // Then commands that each of them takes are not in part
    EXPECT_EQ(Command(NmtCommand::kStop, 0U), NmtAnswer::kTaken);
    EXPECT_EQ(Command(NmtCommand::kPreOperational, 127U), NmtAnswer::kTaken); // This device itself.
    EXPECT_EQ(Command(NmtCommand::kStart, 126U), NmtAnswer::kWrong);
}

TEST_F(PlcCommandTest, AStartOfALostSlaveThatIsNotThereIsLostAgain)
{
    Verifies(req::SRS_PLC_017);
    // Given a slave whose supervision begins with its first heartbeat
    AddPlc(5U);
    setups[5].heartbeat = HeartbeatSetup{300U, 100U, Arming::kFirstHeartbeat};
    User(5U, 0x1017U, 0U, {100U, 0U});
    Begin();
    Run(800U);
    slaves[5]->is_on = false;
    Run(400U);
    ASSERT_EQ(Code(5U), 99);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(290U);
    EXPECT_EQ(Code(5U), 5);
    Run(20U);
    EXPECT_EQ(Code(5U), 99);
}

TEST_F(PlcCommandTest, ARequestForAllButTheMasterLeavesOutWhoCannotTakeIt)
{
    Verifies(req::SRS_NMM_211);
    // Given a slave of another type between two that wait for their start
    setup.start_up = kIsMaster | kApplicationStartsSlaves;
    AddPlc(5U);
    AddPlc(6U);
    slaves[6]->Set(0x1000U, 0U, 0x192U);
    AddPlc(7U);
    Begin600();
    NetworkObjects objects{NetworkObjectParts{setup, &setup, setups.data(), table, plc}};
    const std::uint8_t start_each = 0x85U;
    EXPECT_EQ(Do([&] { return objects.OnWrite(ObjectAddress{0x1F82U, 0x80U}, Bytes{&start_each, 1U}); }),
              SdoAbort::kNone);
    Run(10U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Code(6U), 98);
    EXPECT_EQ(Code(7U), 5);
    const std::uint8_t start = 5U;
    EXPECT_EQ(Do([&] { return objects.OnWrite(ObjectAddress{0x1F82U, 6U}, Bytes{&start, 1U}); }),
              SdoAbort::kValueRange);
    EXPECT_EQ(Do([&] { return objects.OnWrite(ObjectAddress{0x1F82U, 127U}, Bytes{&start, 1U}); }), SdoAbort::kNone);
}

} // namespace
} // namespace counterpoint::cia302
