// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The rows of the EL6751 text from the heartbeat to the last start-up SDO, those of the PDOs among them.
#include "tests/canopen/start_up/el6751/rig.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

class El6751ObjectsTest : public El6751Rig
{
  public:
    void ExpectSdos(const Log& lines)
    {
        Run(50U);
        EXPECT_EQ(Sdos(5U), lines);
        slaves[5]->log.clear();
    }
    void Again()
    {
        slaves[5]->log.clear();
        slaves[5]->Power(Now().us);
    }
};

class El6751GuardRowsTest : public El6751ObjectsTest
{
  public:
    void SetUp() override
    {
        AddBox(5U);
        boxes[5].guard_time_ms = 100U;
        boxes[5].life_time_factor = 3U;
        User(5U, 0x2000U, 0U, {1U});
    }
};

TEST_F(El6751GuardRowsTest, RowsHeartbeat)
{
    Verifies(req::SRS_ELM_020);
    Verifies(req::SRS_ELM_021);
    Begin();
    // The manager's node-ID is 7Fh; 300 ms
    ExpectSdos({"r 1000:00", "w 1017:00 64 00", "w 1016:01 2C 01 7F 00", "w 2000:00 01"});
    EXPECT_EQ(nodes[5].watch, Watch::kHeartbeat);
    EXPECT_EQ(nodes[5].time_us, 300000U);
    // The literal value of the text
    boxes[5].is_consumer_literal = true;
    Again();
    ExpectSdos({"r 1000:00", "w 1017:00 64 00", "w 1016:01 2C 01 00 00", "w 2000:00 01"});
    // The product does not fit 16 bits
    boxes[5].is_consumer_literal = false;
    boxes[5].guard_time_ms = 1000U;
    boxes[5].life_time_factor = 66U;
    Again();
    ExpectSdos({"r 1000:00", "w 1017:00 E8 03", "w 1016:01 FF FF 7F 00", "w 2000:00 01"});
}

TEST_F(El6751GuardRowsTest, AllRowsComeInTheOrderOfTheText)
{
    Verifies(req::SRS_ELM_151);
    // Given a slave with an identity, a SYNC of 10 ms, a PDO with both times, a guard time and one further SDO
    setup.sync_period_us = 10000U;
    setups[5].vendor_id = 1U;
    setups[5].product_code = 2U;
    setups[5].revision_number = 3U;
    setups[5].serial_number = 4U;
    for (std::uint8_t sub = 1U; sub <= 4U; ++sub)
    {
        slaves[5]->Set(0x1018U, sub, sub);
    }
    Tx(5U, MakePdo(1U, 0x185U, 1U, 2U, 0x32U, 0x64U));
    Begin();
    ExpectSdos({"r 1000:00", "r 1018:01", "r 1018:02", "r 1018:03", "r 1018:04", "w 1006:00 10 27 00 00",
                "w 1800:01 85 01 00 00", "w 1800:02 01", "w 1800:03 32 00", "w 1800:05 64 00", "w 1017:00 64 00",
                "w 1016:01 2C 01 7F 00", "w 2000:00 01"});
    // Where the heartbeat is refused, the rows of guarding follow it; of a refused PDO row the read-back follows that
    slaves[5]->Behave(0x1017U, 0U, Manner::kAbort);
    slaves[5]->Behave(0x1800U, 2U, Manner::kAbortWrite);
    slaves[5]->Set(0x1800U, 2U, 1U, 1U);
    Again();
    ExpectSdos({"r 1000:00", "r 1018:01", "r 1018:02", "r 1018:03", "r 1018:04", "w 1006:00 10 27 00 00",
                "w 1800:01 85 01 00 00", "w 1800:02 01", "r 1800:02", "w 1800:03 32 00", "w 1800:05 64 00",
                "w 1017:00 64 00", "w 100C:00 64 00", "w 100D:00 03", "w 2000:00 01"});
}

TEST_F(El6751GuardRowsTest, RowsOfABusCouplerHave5500hBetweenSyncAndItsPdos)
{
    Verifies(req::SRS_ELM_151);
    setup.sync_period_us = 10000U;
    boxes[5].kind = El6751Kind::kBusCoupler;
    boxes[5].coupler_pdos = 0x00000001U;
    boxes[5].coupler_inhibit_100us = 0x10U;
    Tx(5U, MakePdo(1U, 0x185U, 1U, 2U, 0U, 0U));
    Begin();
    ExpectSdos({"r 1000:00", "r 1018:01", "r 1018:02", "w 1006:00 10 27 00 00", "w 5500:00 01 00 00 00", "w 1800:02 01",
                "w 1800:03 10 00", "w 1017:00 64 00", "w 1016:01 2C 01 7F 00", "w 2000:00 01"});
}

TEST_F(El6751GuardRowsTest, RowsHeartbeatNeedGuardTimeAndFactor)
{
    Verifies(req::SRS_ELM_020);
    boxes[5].guard_time_ms = 0U;
    Begin();
    ExpectSdos({"r 1000:00", "w 2000:00 01"});
    boxes[5].guard_time_ms = 100U;
    boxes[5].life_time_factor = 0U;
    Again();
    ExpectSdos({"r 1000:00", "w 2000:00 01"});
    EXPECT_EQ(nodes[5].watch, Watch::kNone);
}

TEST_F(El6751GuardRowsTest, RowProducerHeartbeatThatIsSilentEndsTheStartUpWithoutGuarding)
{
    Verifies(req::SRS_ELM_020);
    Verifies(req::SRS_ELM_022);
    slaves[5]->Behave(0x1017U, 0U, Manner::kSilent);
    Begin();
    Run(3000U);
    EXPECT_EQ(Sdos(5U), (Log{"r 1000:00", "w 1017:00 64 00"}));
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kTimeOut);
}

TEST_F(El6751GuardRowsTest, RowsGuardingFollowAnAbortOfTheHeartbeat)
{
    Verifies(req::SRS_ELM_021);
    Verifies(req::SRS_ELM_022);
    Verifies(req::SRS_ELM_023);
    slaves[5]->Behave(0x1017U, 0U, Manner::kAbort);
    Begin();
    ExpectSdos({"r 1000:00", "w 1017:00 64 00", "w 100C:00 64 00", "w 100D:00 03", "w 2000:00 01"});
    EXPECT_EQ(nodes[5].watch, Watch::kGuarding);
    EXPECT_EQ(nodes[5].time_us, 100000U);
    EXPECT_EQ(nodes[5].retry_factor, 3U);
}

TEST_F(El6751GuardRowsTest, RowConsumerHeartbeatAborted)
{
    Verifies(req::SRS_ELM_021);
    slaves[5]->Behave(0x1016U, 1U, Manner::kAbort);
    Begin();
    ExpectSdos({"r 1000:00", "w 1017:00 64 00", "w 1016:01 2C 01 7F 00"});
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).step, StartUpStep::kHeartbeat);
}

TEST_F(El6751GuardRowsTest, RowsGuardTimeAndLifeTimeFactorAborted)
{
    Verifies(req::SRS_ELM_022);
    Verifies(req::SRS_ELM_023);
    slaves[5]->Behave(0x1017U, 0U, Manner::kAbort);
    slaves[5]->Behave(0x100CU, 0U, Manner::kAbort);
    Begin();
    ExpectSdos({"r 1000:00", "w 1017:00 64 00", "w 100C:00 64 00"});
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).object.index, 0x100CU);
    slaves[5]->Behave(0x100CU, 0U, Manner::kGood);
    slaves[5]->Behave(0x100DU, 0U, Manner::kAbort);
    Again();
    ExpectSdos({"r 1000:00", "w 1017:00 64 00", "w 100C:00 64 00", "w 100D:00 03"});
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).object.index, 0x100DU);
    EXPECT_EQ(Of(5U).step, StartUpStep::kGuarding);
}

TEST_F(El6751ObjectsTest, RowFurtherSdosInTheirOrder)
{
    Verifies(req::SRS_ELM_024);
    AddBox(5U);
    User(5U, 0x6423U, 0U, {1U});
    User(5U, 0x1F00U, 2U, {1U, 2U, 3U, 4U});
    User(5U, 0x2001U, 0U, {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U});
    User(5U, 0x6000U, 9U, {0x55U, 0xAAU});
    Begin();
    ExpectSdos({"r 1000:00", "w 6423:00 01", "w 1F00:02 01 02 03 04", "w 2001:00 08 00 00 00", "w 6000:09 55 AA"});
    EXPECT_EQ(Code(5U), 0);
    // An abort ends it
    slaves[5]->Behave(0x2001U, 0U, Manner::kAbort);
    Again();
    ExpectSdos({"r 1000:00", "w 6423:00 01", "w 1F00:02 01 02 03 04", "w 2001:00 08 00 00 00"});
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).step, StartUpStep::kUserObjects);
    EXPECT_EQ(Of(5U).object.index, 0x2001U);
}

TEST_F(El6751ObjectsTest, AListThatIsNoConciseDcfIsNotBegun)
{
    Verifies(req::SRS_ELM_024);
    Verifies(req::SRS_ELM_025);
    AddBox(5U);
    User(5U, 0x6423U, 0U, {1U});
    User(5U, 0x6424U, 0U, {1U});
    setups[5].concise_dcf.size_bytes -= 1U;
    Begin();
    ExpectSdos({"r 1000:00"});
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).object.index, 0x1F22U);
    EXPECT_EQ(Of(5U).object.sub, 5U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kNoDictionary);
    EXPECT_EQ(Nmt(), (Log{"0:82 00"}));
    // Neither is one with something behind it
    setups[5].concise_dcf.size_bytes += 1U;
    lists[5][0] = 1U;
    Again();
    ExpectSdos({"r 1000:00"});
    EXPECT_EQ(Code(5U), 4);
}

TEST_F(El6751ObjectsTest, ConciseDcfEntryByEntry)
{
    Verifies(req::SRS_ELM_024);
    EXPECT_TRUE(IsConcise(Bytes{nullptr, 0U}));
    EXPECT_EQ(ReadConcise(Bytes{nullptr, 0U}, ConcisePosition{0U, 0U}).state, ConciseState::kEnd);
    const Octets zero{0U, 0U, 0U, 0U};
    EXPECT_TRUE(IsConcise(Bytes{zero.data(), 4U}));
    for (std::uint32_t size = 1U; size < 4U; ++size)
    {
        EXPECT_FALSE(IsConcise(Bytes{zero.data(), size})) << size;
    }
    const Octets one{1U, 0U, 0U, 0U, 0x17U, 0x10U, 0U, 2U, 0U, 0U, 0U, 0x64U, 0U};
    EXPECT_TRUE(IsConcise(Bytes{one.data(), 13U}));
    for (std::uint32_t size = 1U; size < 13U; ++size)
    {
        EXPECT_FALSE(IsConcise(Bytes{one.data(), size})) << size;
    }
    const ConciseReading reading = ReadConcise(Bytes{one.data(), 13U}, ConcisePosition{0U, 0U});
    EXPECT_EQ(reading.object.index, 0x1017U);
    EXPECT_EQ(reading.value.size_bytes, 2U);
    EXPECT_EQ(reading.value.data[0], 0x64U);
    EXPECT_EQ(ReadConcise(Bytes{one.data(), 13U}, reading.next).state, ConciseState::kEnd);
    Octets huge = one;
    huge[10] = 0xFFU;
    EXPECT_FALSE(IsConcise(Bytes{huge.data(), 13U}));
}

using El6751RowsTest = El6751ObjectsTest;

TEST_F(El6751RowsTest, RowSyncPeriodIsWrittenToEverySlaveIfAnySlaveHasASynchronousPdo)
{
    Verifies(req::SRS_ELM_010);
    setup.sync_period_us = 10000U;
    AddBox(5U);
    AddBox(6U);
    Tx(6U, MakePdo(1U, 0x186U, 1U, 2U, 0U, 0U));
    Begin();
    ExpectSdos({"r 1000:00", "w 1006:00 10 27 00 00"});
    EXPECT_EQ(Sdos(6U), (Log{"r 1000:00", "w 1006:00 10 27 00 00", "w 1800:01 86 01 00 00", "w 1800:02 01"}));
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(El6751RowsTest, RowSyncPeriodIsNotWrittenWithoutSyncAndCanBeSwitchedOff)
{
    Verifies(req::SRS_ELM_010);
    setup.sync_period_us = 10000U;
    AddBox(5U);
    AddBox(6U);
    Tx(6U, MakePdo(1U, 0x186U, 255U, 2U, 0U, 0U));
    Begin();
    ExpectSdos({"r 1000:00"});
    tx[6][0].type = 1U;
    boxes[5].is_sync_period_written = false;
    Begin();
    ExpectSdos({"r 1000:00"});
    EXPECT_EQ(Sdos(6U)[4], "w 1006:00 10 27 00 00");
}

TEST_F(El6751RowsTest, OnlyAnAbortOfTheSlaveLeadsToTheReadBackOrToGuarding)
{
    Verifies(req::SRS_ELM_012);
    Verifies(req::SRS_ELM_022);
    Verifies(req::SRS_ELM_025);
    const El6751Access write{{0x1800U, 1U}, StartUpStep::kPdo, false, false, 4U, 0x185U, Bytes{nullptr, 0U}};
    // Given an answer that this device aborts because it is none (0504 0001h), and the same abort of the slave
    El6751Answer answer{};
    answer.outcome.abort = SdoAbort::kCommand;
    for (const El6751Row row :
         {El6751Row::kCobId, El6751Row::kType, El6751Row::kInhibit, El6751Row::kEvent, El6751Row::kProducerHeartbeat})
    {
        answer.outcome.by_server = false;
        EXPECT_EQ(JudgeAnswer(write, row, answer), El6751Verdict::kSyntax);
        answer.outcome.by_server = true;
        EXPECT_EQ(JudgeAnswer(write, row, answer), El6751Verdict::kNext);
    }
    // A slave that aborts with the code of a time-out has answered
    answer.outcome.abort = SdoAbort::kTimeOut;
    EXPECT_EQ(JudgeAnswer(write, El6751Row::kCobId, answer), El6751Verdict::kNext);
    EXPECT_EQ(JudgeAnswer(write, El6751Row::kConsumerHeartbeat, answer), El6751Verdict::kSyntax);
}

TEST_F(El6751RowsTest, RowSyncPeriodAbortedEndsTheStartUp)
{
    Verifies(req::SRS_ELM_010);
    setup.sync_period_us = 10000U;
    AddBox(5U);
    Tx(5U, MakePdo(1U, 0x185U, 240U, 2U, 0U, 0U));
    slaves[5]->Behave(0x1006U, 0U, Manner::kAbort);
    Begin();
    ExpectSdos({"r 1000:00", "w 1006:00 10 27 00 00"});
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).step, StartUpStep::kSyncPeriod);
    EXPECT_EQ(Nmt(), (Log{"0:82 00"}));
}

TEST_F(El6751RowsTest, EveryPdoWithAllItsRowsRxPdosFirst)
{
    for (const req::RequirementId id : {req::SRS_ELM_011, req::SRS_ELM_013, req::SRS_ELM_015, req::SRS_ELM_017})
    {
        Verifies(id);
    }
    AddBox(5U);
    Tx(5U, MakePdo(1U, 0x185U, 254U, 8U, 0x32U, 0x64U));
    Tx(5U, MakePdo(512U, 0x385U, 255U, 8U, 0U, 1U));
    Rx(5U, MakePdo(1U, 0x205U, 255U, 8U, 0U, 0U));
    Rx(5U, MakePdo(4U, 0x505U, 255U, 8U, 1U, 0U));
    Begin();
    ExpectSdos({"r 1000:00", "w 1400:01 05 02 00 00", "w 1400:02 FF", "w 1403:01 05 05 00 00", "w 1403:02 FF",
                "w 1403:03 01 00", "w 1800:01 85 01 00 00", "w 1800:02 FE", "w 1800:03 32 00", "w 1800:05 64 00",
                "w 19FF:01 85 03 00 00", "w 19FF:02 FF", "w 19FF:05 01 00"});
    EXPECT_EQ(Code(5U), 23);
}

TEST_F(El6751RowsTest, PdoRowsThatCanBeSwitchedOff)
{
    Verifies(req::SRS_ELM_011);
    Verifies(req::SRS_ELM_013);
    AddBox(5U);
    Rx(5U, MakePdo(1U, 0x205U, 255U, 8U, 7U, 0U));
    boxes[5].is_cob_id_written = false;
    Begin();
    ExpectSdos({"r 1000:00", "w 1400:02 FF", "w 1400:03 07 00"});
    boxes[5].is_cob_id_written = true;
    boxes[5].is_type_written = false;
    Again();
    ExpectSdos({"r 1000:00", "w 1400:01 05 02 00 00", "w 1400:03 07 00"});
}

TEST_F(El6751RowsTest, ABusCouplerHas5500hAndTypesOfItsFirstTwoPdosAndOneTimeForAll)
{
    for (const req::RequirementId id :
         {req::SRS_ELM_011, req::SRS_ELM_013, req::SRS_ELM_015, req::SRS_ELM_017, req::SRS_ELM_019})
    {
        Verifies(id);
    }
    AddBox(5U);
    boxes[5].kind = El6751Kind::kBusCoupler;
    boxes[5].coupler_pdos = 0x00030201U;
    Rx(5U, MakePdo(1U, 0x205U, 255U, 8U, 9U, 9U));
    Rx(5U, MakePdo(2U, 0x305U, 255U, 8U, 9U, 9U));
    Rx(5U, MakePdo(3U, 0x405U, 255U, 8U, 9U, 9U));
    Tx(5U, MakePdo(2U, 0x285U, 255U, 8U, 9U, 9U));
    Tx(5U, MakePdo(3U, 0x385U, 255U, 8U, 9U, 9U));
    Begin();
    // The times of the PDOs themselves are not written
    ExpectSdos({"r 1000:00", "r 1018:01", "r 1018:02", "w 5500:00 01 02 03 00", "w 1400:02 FF", "w 1401:02 FF",
                "w 1801:02 FF"});
    boxes[5].coupler_inhibit_100us = 0x10U;
    boxes[5].coupler_event_ms = 0x20U;
    Again();
    ExpectSdos({"r 1000:00", "r 1018:01", "r 1018:02", "w 5500:00 01 02 03 00", "w 1400:02 FF", "w 1400:03 10 00",
                "w 1400:05 20 00", "w 1401:02 FF", "w 1401:03 10 00", "w 1401:05 20 00", "w 1402:03 10 00",
                "w 1402:05 20 00", "w 1801:02 FF", "w 1801:03 10 00", "w 1801:05 20 00", "w 1802:03 10 00",
                "w 1802:05 20 00"});
    // A general slave has no 5500h, and the times of the PDOs themselves
    boxes[5].kind = El6751Kind::kGeneral;
    Again();
    Run(50U);
    ExpectSdos({"r 1000:00",       "w 1400:01 05 02 00 00", "w 1400:02 FF", "w 1400:03 09 00",
                "w 1400:05 09 00", "w 1401:01 05 03 00 00", "w 1401:02 FF", "w 1401:03 09 00",
                "w 1401:05 09 00", "w 1402:01 05 04 00 00", "w 1402:02 FF", "w 1402:03 09 00",
                "w 1402:05 09 00", "w 1801:01 85 02 00 00", "w 1801:02 FF", "w 1801:03 09 00",
                "w 1801:05 09 00", "w 1802:01 85 03 00 00", "w 1802:02 FF", "w 1802:03 09 00",
                "w 1802:05 09 00"});
}

TEST_F(El6751RowsTest, A5500hThatIsAbortedEndsTheStartUp)
{
    Verifies(req::SRS_ELM_019);
    AddBox(5U);
    boxes[5].kind = El6751Kind::kBusCoupler;
    slaves[5]->Behave(0x5500U, 0U, Manner::kAbort);
    Begin();
    Run(50U);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).object.index, 0x5500U);
}

/// The four parameters of a PDO: sub-index, configured value and its length, what is written, who asks for it.
struct PdoRow
{
    std::uint8_t sub;
    std::uint32_t value;
    std::uint8_t size;
    const char* write;
    const char* read;
};
constexpr PdoRow kPdoRows[]{{1U, 0x185U, 4U, "w 1800:01 85 01 00 00", "r 1800:01"},
                            {2U, 0xFFU, 1U, "w 1800:02 FF", "r 1800:02"},
                            {3U, 0x32U, 2U, "w 1800:03 32 00", "r 1800:03"},
                            {5U, 0x64U, 2U, "w 1800:05 64 00", "r 1800:05"}};

class El6751ReadBackTest : public El6751RowsTest, public ::testing::WithParamInterface<PdoRow>
{
  public:
    void SetUp() override
    {
        AddBox(5U);
        Tx(5U, MakePdo(1U, 0x185U, 255U, 8U, 0x32U, 0x64U));
        User(5U, 0x2000U, 0U, {1U});
    }
    void VerifiesRow() const
    {
        const req::RequirementId ids[]{req::SRS_ELM_012, req::SRS_ELM_014, req::SRS_ELM_016, req::SRS_ELM_012,
                                       req::SRS_ELM_018};
        Verifies(ids[GetParam().sub - 1U]);
    }
    /// All rows up to this one, with the reading behind it.
    [[nodiscard]] Log Expected(const bool is_going_on) const
    {
        Log lines{"r 1000:00"};
        for (const PdoRow& row : kPdoRows)
        {
            const bool is_it = (row.sub == GetParam().sub);
            if ((row.sub <= GetParam().sub) || is_going_on)
            {
                lines.emplace_back(row.write);
            }
            if (is_it)
            {
                lines.emplace_back(row.read);
            }
        }
        if (is_going_on)
        {
            lines.emplace_back("w 2000:00 01");
        }
        return lines;
    }
};

INSTANTIATE_TEST_SUITE_P(Rows, El6751ReadBackTest, ::testing::ValuesIn(kPdoRows));

TEST_P(El6751ReadBackTest, AfterAnAbortTheConfiguredValueIsGoodEnough)
{
    VerifiesRow();
    slaves[5]->Behave(0x1800U, GetParam().sub, Manner::kAbortWrite);
    slaves[5]->Set(0x1800U, GetParam().sub, GetParam().value, GetParam().size);
    Begin();
    ExpectSdos(Expected(true));
    EXPECT_EQ(Code(5U), 23);
}

TEST_P(El6751ReadBackTest, AfterAnAbortAnotherValueEndsTheStartUp)
{
    VerifiesRow();
    slaves[5]->Behave(0x1800U, GetParam().sub, Manner::kAbortWrite);
    slaves[5]->Set(0x1800U, GetParam().sub, GetParam().value - 1U, GetParam().size);
    Begin();
    ExpectSdos(Expected(false));
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Of(5U).step, StartUpStep::kPdoReadBack);
    EXPECT_EQ(Of(5U).expected, GetParam().value);
    EXPECT_EQ(Of(5U).read, GetParam().value - 1U);
    EXPECT_EQ(Nmt(), (Log{"0:82 00"}));
}

TEST_P(El6751ReadBackTest, AReadingThatIsAbortedOrOfWrongLengthToo)
{
    VerifiesRow();
    slaves[5]->Behave(0x1800U, GetParam().sub, Manner::kAbort);
    Begin();
    ExpectSdos(Expected(false));
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kObjectUnknown);
    slaves[5]->Behave(0x1800U, GetParam().sub, Manner::kAbortWrite);
    const std::uint8_t other = (GetParam().size == 4U) ? std::uint8_t{2U} : std::uint8_t{4U};
    slaves[5]->Set(0x1800U, GetParam().sub, GetParam().value, other);
    Again();
    ExpectSdos(Expected(false));
    EXPECT_EQ(Code(5U), 4);
}

TEST_P(El6751ReadBackTest, SilenceIsNoAbortAndIsNotReadBack)
{
    VerifiesRow();
    Verifies(req::SRS_ELM_025);
    slaves[5]->Behave(0x1800U, GetParam().sub, Manner::kSilent);
    Begin();
    Run(3000U);
    Log expected = Expected(false);
    expected.pop_back();
    EXPECT_EQ(Sdos(5U), expected);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kTimeOut);
    EXPECT_EQ(Of(5U).object.sub, GetParam().sub);
}

} // namespace
} // namespace counterpoint::cia302
