// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// States 0 to 3 of the master and -1 to 3 of the slaves, as in the PLC Designer text.
#include "tests/canopen/start_up/plc_designer/rig.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

using PlcBootTest = PlcRig;

TEST_F(PlcBootTest, MasterPassesStates0To2InItsFirstCycles)
{
    Verifies(req::SRS_PLC_001);
    AddPlc(5U);
    slaves[5]->is_on = false;
    Begin();
    EXPECT_EQ(plc.MasterState(), 0);
    Run(1U);
    EXPECT_EQ(plc.MasterState(), 1);
    Run(1U);
    EXPECT_EQ(plc.MasterState(), 2);
    EXPECT_TRUE(sent.empty());
    Run(1U);
    EXPECT_EQ(plc.MasterState(), 3);
    Run(60000U);
    EXPECT_EQ(masters, (Log{"0", "1", "2", "3"}));
}

TEST_F(PlcBootTest, ResetNodeGoesToEachSlaveAlone)
{
    Verifies(req::SRS_PLC_002);
    AddPlc(5U);
    AddPlc(9U);
    Add(7U);
    setups[7].assignment = 0U;
    Begin();
    Run(3U);
    EXPECT_EQ(Code(5U), -1);
    EXPECT_EQ(Code(9U), -1);
    EXPECT_TRUE(sent.empty());
    Run(1U);
    EXPECT_EQ(Code(5U), 1);
    EXPECT_EQ(Nmt(), (Log{"4:81 05", "4:81 09"}));
    EXPECT_EQ(Code(7U), 0);
}

TEST_F(PlcBootTest, StateMinusOneLastsUntilTheResetWasHandedOver)
{
    Verifies(req::SRS_PLC_002);
    AddPlc(5U);
    nmt.SetActive(false);
    Begin();
    Run(500U);
    EXPECT_EQ(Code(5U), -1);
    nmt.SetActive(true);
    Run(1U);
    EXPECT_EQ(Code(5U), 1);
    EXPECT_EQ(Nmt(), (Log{"501:81 05"}));
}

// t [ms]   4       2004    2504
// state    1       2       3
TEST_F(PlcBootTest, WithoutABootUpMessageState2ComesAfterTwoSeconds)
{
    Verifies(req::SRS_PLC_003);
    AddPlc(5U);
    slaves[5]->has_boot_up = false;
    Begin();
    Run(2003U);
    EXPECT_EQ(Code(5U), 1);
    Run(1U);
    EXPECT_EQ(Code(5U), 2);
    Run(499U);
    EXPECT_EQ(Code(5U), 2);
    EXPECT_TRUE(slaves[5]->log.size() == 1U);
    Run(1U);
    EXPECT_EQ(Code(5U), 3);
    EXPECT_EQ(slaves[5]->log, (Log{"nmt 81", "r 1000:00"}));
}

// t [ms]   4       6           506
// state    1       2 boot-up   3
TEST_F(PlcBootTest, WithTheBootUpMessageState2ComesAtOnceAndState3HalfASecondLater)
{
    Verifies(req::SRS_PLC_003);
    Verifies(req::SRS_PLC_004);
    AddPlc(5U);
    Begin();
    Run(5U);
    EXPECT_EQ(Code(5U), 1);
    Run(1U);
    EXPECT_EQ(Code(5U), 2);
    const std::size_t before = sent.size();
    Run(499U);
    EXPECT_EQ(Code(5U), 2);
    EXPECT_EQ(sent.size(), before);
    Run(1U);
    EXPECT_EQ(Code(5U), 3);
    EXPECT_EQ(Times(0x605U), (std::vector<std::uint32_t>{506000U}));
    EXPECT_EQ(told[5], (Log{"-1", "1", "2", "3"}));
}

TEST_F(PlcBootTest, DeviceTypeIsAskedForEveryHalfSecondUntilAnyAnswer)
{
    Verifies(req::SRS_PLC_005);
    AddPlc(5U);
    slaves[5]->Behave(0x1000U, 0U, Manner::kSilent);
    Begin();
    Run(2600U);
    EXPECT_EQ(slaves[5]->log, (Log{"nmt 81", "r 1000:00", "r 1000:00", "r 1000:00", "r 1000:00", "r 1000:00"}));
    EXPECT_EQ(Code(5U), 3);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kTimeOut);
    // What answers with something that is no device type is asked as often, and not told to be silent
    slaves[5]->Behave(0x1000U, 0U, Manner::kNoSegment);
    Run(1000U);
    EXPECT_EQ(slaves[5]->log.size(), 8U);
    EXPECT_EQ(Code(5U), 3);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kCommand);
    // With a boot-up message its silence is over
    slaves[5]->Behave(0x1000U, 0U, Manner::kGood);
    slaves[5]->Power(Now().us);
    Run(5U);
    EXPECT_EQ(Code(5U), 2);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kNone);
    Run(510U);
    EXPECT_EQ(Code(5U), 5);
}

TEST_F(PlcBootTest, ADeviceTypeThatIsTooLongIsAnAnswerOfAnotherDevice)
{
    Verifies(req::SRS_PLC_480);
    // Given a mandatory and an optional slave that answer 1000h with 100 bytes
    for (const std::uint8_t node : Octets{5U, 6U})
    {
        AddPlc(node);
        plc_slaves[node].is_optional = (node == 6U);
        setups.at(node).device_type = 0x191U;
        slaves[node]->Behave(0x1000U, 0U, Manner::kLong);
    }
    // And one of which no device type is expected
    AddPlc(9U);
    setups[9].device_type = 0U;
    slaves[9]->Behave(0x1000U, 0U, Manner::kLong);
    // When they are asked
    Begin();
    Run(1600U);
    // Then both are told as another device, by the length, and nobody is waited for or asked again
    for (const std::uint8_t node : Octets{5U, 6U})
    {
        EXPECT_EQ(told[node], (Log{"-1", "1", "2", "3", "98"})) << int{node};
        EXPECT_EQ(Of(node).object.index, 0x1000U);
        EXPECT_EQ(Of(node).abort, SdoAbort::kLengthMismatch);
        EXPECT_EQ(slaves[node]->log, (Log{"nmt 81", "r 1000:00"}));
    }
    EXPECT_EQ(Code(9U), 5);
    EXPECT_EQ(Of(9U).abort, SdoAbort::kNone);
    EXPECT_EQ(plc.MasterState(), 5);
}

TEST_F(PlcBootTest, AllSdosInTheirOrderOneACycleAndTheSlavesAtTheSameTime)
{
    Verifies(req::SRS_PLC_006);
    for (const std::uint8_t node : Octets{5U, 9U})
    {
        AddPlc(node);
        User(node, 0x1017U, 0U, {0U, 0U});
        User(node, 0x2000U, 1U, {1U, 2U, 3U, 4U});
        User(node, 0x2001U, 0U, {7U});
    }
    Begin();
    Run(506U);
    const Log whole{"nmt 81", "r 1000:00", "w 1017:00 00 00", "w 2000:01 01 02 03 04", "w 2001:00 07"};
    for (std::size_t count = 2U; count <= 5U; ++count)
    {
        EXPECT_EQ(slaves[5]->log, Log(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(count)));
        EXPECT_EQ(slaves[9]->log, slaves[5]->log);
        Run((count == 5U) ? 0U : 2U);
    }
    EXPECT_EQ(plc.MasterState(), 3);
    Run(2U);
    EXPECT_EQ(plc.MasterState(), 5);
}

TEST_F(PlcBootTest, AnSdoWithoutAnswerIsRepeatedWithoutEnd)
{
    Verifies(req::SRS_PLC_006);
    Verifies(req::SRS_PLC_010);
    AddPlc(5U);
    User(5U, 0x2000U, 0U, {1U});
    User(5U, 0x2001U, 0U, {2U});
    slaves[5]->Behave(0x2000U, 0U, Manner::kSilent);
    Begin();
    Run(3100U);
    EXPECT_EQ(slaves[5]->log, (Log{"nmt 81", "r 1000:00", "w 2000:00 01", "w 2000:00 01", "w 2000:00 01",
                                   "w 2000:00 01", "w 2000:00 01", "w 2000:00 01"}));
    EXPECT_EQ(plc.MasterState(), 3);
    Run(60000U);
    EXPECT_EQ(plc.MasterState(), 3);
    EXPECT_TRUE(Of(5U).is_busy);
    slaves[5]->Behave(0x2000U, 0U, Manner::kGood);
    Run(510U);
    EXPECT_EQ(plc.MasterState(), 5);
    EXPECT_FALSE(Of(5U).is_busy);
    EXPECT_EQ(slaves[5]->log[slaves[5]->log.size() - 2U], "w 2001:00 02");
}

TEST_F(PlcBootTest, AListThatIsNoConciseDcfKeepsTheSlaveInState3)
{
    Verifies(req::SRS_PLC_006);
    AddPlc(5U);
    User(5U, 0x2000U, 0U, {1U});
    User(5U, 0x2001U, 0U, {2U});
    setups[5].concise_dcf.size_bytes -= 1U;
    Begin();
    Run(5000U);
    EXPECT_EQ(slaves[5]->log, (Log{"nmt 81", "r 1000:00"}));
    EXPECT_EQ(Code(5U), 3);
    EXPECT_EQ(Of(5U).object.index, 0x1F22U);
    EXPECT_EQ(plc.MasterState(), 3);
}

TEST_F(PlcBootTest, AnAbortCountsAsAnAnswerAndTheApplicationIsTold)
{
    Verifies(req::SRS_PLC_007);
    AddPlc(5U);
    User(5U, 0x2000U, 3U, {1U});
    User(5U, 0x2001U, 0U, {2U});
    slaves[5]->Behave(0x2000U, 3U, Manner::kAbort);
    Begin();
    Run(600U);
    EXPECT_EQ(slaves[5]->log, (Log{"nmt 81", "r 1000:00", "w 2000:03 01", "w 2001:00 02", "nmt 01"}));
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(plc.MasterState(), 5);
    int aborts = 0;
    int confirmations = 0;
    for (const NodeStatus& status : answers[5])
    {
        const bool is_it = (status.object.index == 0x2000U) && (status.object.sub == 3U) && (status.code == 3);
        aborts += (is_it && (status.abort == SdoAbort::kObjectUnknown)) ? 1 : 0;
        const bool is_next = (status.object.index == 0x2001U) && (status.code == 3);
        confirmations += (is_next && (status.abort == SdoAbort::kNone)) ? 1 : 0;
    }
    EXPECT_EQ(aborts, 1);
    EXPECT_EQ(confirmations, 1);
}

// t [ms]   4    2004  2504        3004
// state    1    2     3 1000h     97
TEST_F(PlcBootTest, AnOptionalSlaveIsAskedOnceAndThenIgnored)
{
    Verifies(req::SRS_PLC_008);
    Verifies(req::SRS_PLC_009);
    AddPlc(5U);
    AddPlc(9U);
    plc_slaves[9].is_optional = true;
    slaves[9]->is_on = false;
    Begin();
    Run(3003U);
    EXPECT_EQ(Code(9U), 3);
    EXPECT_EQ(plc.MasterState(), 3);
    EXPECT_EQ(Code(5U), 5);
    Run(1U);
    EXPECT_EQ(Code(9U), 97);
    EXPECT_EQ(plc.MasterState(), 5);
    Run(20000U);
    EXPECT_EQ(Code(9U), 97);
    int reads = 0;
    for (const Sent& one : sent)
    {
        reads += ((one.frame.identifier == 0x609U) && (one.frame.data[0] == 0x40U)) ? 1 : 0;
    }
    EXPECT_EQ(reads, 1);
}

TEST_F(PlcBootTest, AnOptionalSlaveThatAnswersIsConfiguredLikeAnyOther)
{
    Verifies(req::SRS_PLC_008);
    AddPlc(9U);
    plc_slaves[9].is_optional = true;
    User(9U, 0x2000U, 0U, {1U});
    slaves[9]->Behave(0x2000U, 0U, Manner::kSilent);
    Begin();
    Run(2000U);
    EXPECT_EQ(Code(9U), 3);
    EXPECT_EQ(plc.MasterState(), 3);
    slaves[9]->Behave(0x2000U, 0U, Manner::kAbort);
    Run(510U);
    EXPECT_EQ(Code(9U), 5);
    EXPECT_EQ(plc.MasterState(), 5);
}

TEST_F(PlcBootTest, MasterStaysInState5WhateverHappens)
{
    Verifies(req::SRS_PLC_009);
    AddPlc(5U);
    Begin();
    Run(600U);
    EXPECT_EQ(plc.MasterState(), 5);
    slaves[5]->Power(Now().us);
    Run(5U);
    slaves[5]->is_on = false;
    Run(20000U);
    EXPECT_EQ(Code(5U), 3);
    EXPECT_EQ(plc.MasterState(), 5);
    EXPECT_EQ(masters, (Log{"0", "1", "2", "3", "5"}));
}

TEST_F(PlcBootTest, AMissingMandatorySlaveKeepsTheMasterInState3WhileOthersRun)
{
    Verifies(req::SRS_PLC_010);
    AddPlc(5U);
    AddPlc(9U);
    setups[9].plc = nullptr; // Nothing said: not optional.
    slaves[9]->is_on = false;
    Begin();
    Run(100000U);
    EXPECT_EQ(plc.MasterState(), 3);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Code(9U), 3);
    // The application may begin it anew before that
    EXPECT_TRUE(Do([this] { return plc.Boot(NodeId{9U}, Now()); }));
    Run(3000U);
    EXPECT_EQ(Code(9U), 3);
    slaves[9]->is_on = true;
    Run(1600U);
    EXPECT_EQ(plc.MasterState(), 5);
    EXPECT_EQ(Code(9U), 5);
}

TEST_F(PlcBootTest, ResetNodesLoadsTheDefaultsOnceAndReadsTheDeviceTypeAgain)
{
    Verifies(req::SRS_PLC_011);
    AddPlc(5U);
    plc_slaves[5].is_reset = true;
    User(5U, 0x2000U, 0U, {1U});
    Begin();
    Run(1100U);
    EXPECT_EQ(slaves[5]->log,
              (Log{"nmt 81", "r 1000:00", "w 1011:01 6C 6F 61 64", "nmt 81", "r 1000:00", "w 2000:00 01", "nmt 01"}));
    EXPECT_EQ(told[5], (Log{"-1", "1", "2", "3", "-1", "1", "2", "3", "4", "5"}));
    // Not a second time, whatever begins anew
    slaves[5]->log.clear();
    EXPECT_TRUE(Do([this] { return plc.Boot(NodeId{5U}, Now()); }));
    Run(600U);
    EXPECT_EQ(slaves[5]->log, (Log{"nmt 81", "r 1000:00", "w 2000:00 01", "nmt 01"}));
}

TEST_F(PlcBootTest, ResetNodesGoesOnAfterAnAbortOf1011hToo)
{
    Verifies(req::SRS_PLC_011);
    AddPlc(5U);
    plc_slaves[5].is_reset = true;
    slaves[5]->Behave(0x1011U, 1U, Manner::kAbort);
    Begin();
    Run(1100U);
    EXPECT_EQ(slaves[5]->log, (Log{"nmt 81", "r 1000:00", "w 1011:01 6C 6F 61 64", "nmt 81", "r 1000:00", "nmt 01"}));
    EXPECT_EQ(Code(5U), 5);
}

TEST_F(PlcBootTest, AnAbortOf1011hIsToldAsLongAsItIsNotWrittenAgain)
{
    Verifies(req::SRS_PLC_470);
    // Given a slave that refuses to restore its defaults, and takes its SDO
    AddPlc(5U);
    plc_slaves[5].is_reset = true;
    User(5U, 0x2000U, 0U, {1U});
    slaves[5]->Behave(0x1011U, 1U, Manner::kAbort);
    Begin();
    Run(1100U);
    ASSERT_EQ(Code(5U), 5);
    EXPECT_EQ(Of(5U).object.index, 0x1011U);
    EXPECT_EQ(Of(5U).object.sub, 1U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kObjectUnknown);
    // Also with its next start-up, which does not write it
    EXPECT_TRUE(Do([this] { return plc.Boot(NodeId{5U}, Now()); }));
    Run(600U);
    ASSERT_EQ(Code(5U), 5);
    EXPECT_EQ(Of(5U).object.index, 0x1011U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kObjectUnknown);
    // Until everything begins anew
    slaves[5]->Behave(0x1011U, 1U, Manner::kGood);
    Begin();
    Run(1100U);
    ASSERT_EQ(Code(5U), 5);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kNone);
}

TEST_F(PlcBootTest, TheFirstAbortIsToldWhateverIsAnsweredBehindIt)
{
    Verifies(req::SRS_PLC_470);
    // Given a slave that refuses the first and the second of three SDOs
    AddPlc(5U);
    User(5U, 0x2000U, 3U, {1U});
    User(5U, 0x2001U, 0U, {2U});
    User(5U, 0x2002U, 0U, {3U});
    slaves[5]->Behave(0x2000U, 3U, Manner::kAbort);
    slaves[5]->Behave(0x2001U, 0U, Manner::kAbort);
    Begin();
    Run(600U);
    ASSERT_EQ(Code(5U), 5);
    EXPECT_EQ(Of(5U).object.index, 0x2000U);
    EXPECT_EQ(Of(5U).object.sub, 3U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kObjectUnknown);
    // When it takes them in its next start-up
    slaves[5]->Behave(0x2000U, 3U, Manner::kGood);
    slaves[5]->Behave(0x2001U, 0U, Manner::kGood);
    slaves[5]->Power(Now().us);
    Run(600U);
    ASSERT_EQ(Code(5U), 5);
    EXPECT_EQ(Of(5U).object.index, 0x2002U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kNone);
}

} // namespace
} // namespace counterpoint::cia302
