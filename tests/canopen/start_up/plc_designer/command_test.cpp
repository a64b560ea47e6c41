// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Commands of the application and of 1F82h under the PLC Designer profile.
#include "canopen/cia302/network/objects.hpp"
#include "tests/canopen/start_up/plc_designer/rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

class PlcCommandTest : public PlcRig
{
};

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
    Verifies(req::SRS_PLC_015);
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
    Verifies(req::SRS_NMM_006);
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
