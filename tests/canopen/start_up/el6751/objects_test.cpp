// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The rows of the EL6751 text from the heartbeat to the last start-up SDO.
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
    AddBox(5U);
    User(5U, 0x6423U, 0U, {1U});
    User(5U, 0x6424U, 0U, {1U});
    setups[5].concise_dcf.size_bytes -= 1U;
    Begin();
    ExpectSdos({"r 1000:00"});
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).object.index, 0x1F22U);
    EXPECT_EQ(Of(5U).object.sub, 5U);
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

} // namespace
} // namespace counterpoint::cia302
