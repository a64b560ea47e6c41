// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The gate in front of a slave of the least objects, whose identity, lane and answers the test has in its hands.
#include "canopen/cia302/safety_gate/safety_gate.hpp"
#include "canopen/start_up/el6751/setup.hpp"
#include "tests/canopen/cia301/keeping_sink.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace counterpoint::cia302
{
namespace
{

using cia301::KeepingSink;

constexpr NodeId kSlave{2U};
/// SRDO 1, off, with nothing mapped.
constexpr ExpectedObject kLeast[8] = {{{0x1301U, 1U}, 0U, false},     {{0x1301U, 2U}, 50U, false},
                                      {{0x1301U, 3U}, 20U, false},    {{0x1301U, 4U}, 254U, false},
                                      {{0x1301U, 5U}, 0x101U, false}, {{0x1301U, 6U}, 0x102U, false},
                                      {{0x1381U, 0U}, 0U, false},     {{0x13FFU, 1U}, 0x1234U, false}};
constexpr SafetyExpectation kExpectation{kLeast, 8U};

struct Held
{
    std::uint32_t value;
    std::uint8_t size;
};

/// One lane and one slot; node 2 is a safety slave that answers each request in the next step.
class SafetyCheckTest : public ::testing::Test
{
  public:
    SafetyCheckTest()
    {
        Put(0x13FEU, 0U, 0xA5U, 1U);
        for (const ExpectedObject& object : kLeast)
        {
            Put(object.address.index, object.address.sub, static_cast<std::uint32_t>(object.value),
                SizeOf(object.address));
        }
    }
    void Put(const std::uint32_t index, const std::uint8_t sub, const std::uint32_t value, const std::uint8_t size)
    {
        objects[(index << 8U) | sub] = Held{value, size};
    }
    [[nodiscard]] Instant Now() const
    {
        return Instant{now_us};
    }
    /// What the gate asks for is sent.
    void Ask()
    {
        now_us += 1000U;
        pool.OnCycle(Now());
        gate.OnCycle(Now());
    }
    /// What was sent is answered.
    void Answer()
    {
        for (const CanFrame& request : sink.frames)
        {
            const std::uint32_t index = request.data[1] | (std::uint32_t{request.data[2]} << 8U);
            Held& held = objects[(index << 8U) | request.data[3]];
            CanFrame answer{request.identifier - 0x80U, FrameKind::kData, CanPortId::kFirst, 8U, {}};
            std::copy(request.data, request.data + 4, answer.data);
            if (requests == aborted) // 0800 0022h, not in this state.
            {
                answer.data[0] = 0x80U;
                answer.data[4] = 0x22U;
                answer.data[7] = 0x08U;
            }
            else if (request.data[0] == 0x40U)
            {
                reads.push_back(index);
                answer.data[0] = static_cast<std::uint8_t>(0x43U | ((4U - held.size) << 2U));
                for (std::uint32_t i = 0U; i < 4U; ++i)
                {
                    answer.data[4U + i] = static_cast<std::uint8_t>((held.value >> (8U * i)) & 0xFFU);
                }
            }
            else
            {
                ++writes;
                held.value = 0U;
                for (std::uint32_t i = 0U; i < held.size; ++i)
                {
                    held.value |= std::uint32_t{request.data[4U + i]} << (8U * i);
                }
                written.emplace_back((index << 8U) | request.data[3], held.value);
                answer.data[0] = 0x60U;
            }
            ++requests;
            pool.OnFrame(answer, Now());
        }
        sink.frames.clear();
    }
    void Finish()
    {
        for (int step = 0; (step < 100) && (gate.State(kSlave) == GateState::kBusy); ++step)
        {
            Ask();
            Answer();
        }
    }
    GateState Verified()
    {
        reads.clear();
        gate.Verify(kSlave, Now());
        Finish();
        return gate.State(kSlave);
    }
    static std::array<SlaveSetup, kNodeRoom>& Listed(std::array<SlaveSetup, kNodeRoom>& slaves)
    {
        for (const std::uint8_t node : {std::uint8_t{2U}, std::uint8_t{3U}})
        {
            slaves[node].assignment = kInNetwork | kBootSlave;
            slaves[node].safety = &kExpectation;
        }
        return slaves;
    }

    std::uint32_t now_us{0xFFFF'FF00U};
    std::map<std::uint32_t, Held> objects{};
    std::vector<std::uint32_t> reads{};
    int requests{0};
    int aborted{-1}; ///< The request that is answered by an abort.
    int writes{0};
    std::vector<std::pair<std::uint32_t, std::uint32_t>> written{}; ///< Index and sub-index, value.
    KeepingSink sink{};
    std::array<SlaveSetup, kNodeRoom> slaves{};
    NetworkSetup setup{NodeId{1U}, 1U, 0U, 0U, 0U, Listed(slaves).data()};
    SdoLanes<1U> lanes{sink, SdoTimes{100'000U, 3U}};
    SdoPool pool{lanes.All(), SdoTimes{100'000U, 3U}};
    std::array<SafetySlot, 1U> slots{};
    SafetyGate gate{setup, SafetySlots{slots.data(), 1U}, pool};
};

using Indices = std::vector<std::uint32_t>;

TEST_F(SafetyCheckTest, BeginsWithWhoTheSlaveIs)
{
    Verifies(req::SRS_SFS_010);
    EXPECT_EQ(Verified(), GateState::kOpen);
    EXPECT_EQ(reads.front(), 0x13FEU); // Nothing of it is expected.
    slaves[2].device_type = 0x0002'0191U;
    slaves[2].serial_number = 7U;
    Put(0x1000U, 0U, 0x0002'0191U, 4U);
    Put(0x1018U, 4U, 7U, 4U);
    EXPECT_EQ(Verified(), GateState::kOpen);
    EXPECT_EQ(Indices(reads.begin(), reads.begin() + 3), (Indices{0x1000U, 0x1018U, 0x13FEU}));
    // The number alone counts, whatever its length
    Put(0x1018U, 4U, 7U, 1U);
    EXPECT_EQ(Verified(), GateState::kOpen);
    Put(0x1018U, 4U, 8U, 4U);
    EXPECT_EQ(Verified(), GateState::kDiffers);
    EXPECT_EQ(reads, (Indices{0x1000U, 0x1018U})); // Nothing else is asked.
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x1018U);
    EXPECT_EQ(gate.Finding(kSlave).object.sub, 4U);
    EXPECT_EQ(gate.Finding(kSlave).expected, 7U);
    EXPECT_EQ(gate.Finding(kSlave).read, 8U);
    EXPECT_TRUE(gate.IsOther(kSlave));
    // Nor is anything written to it
    EXPECT_TRUE(gate.Write(kSlave, Now()));
    Finish();
    EXPECT_EQ(gate.State(kSlave), GateState::kDiffers);
    EXPECT_EQ(writes, 0);
}

TEST_F(SafetyCheckTest, UnderPlcDesignerTheProfileNumberAloneSaysIt)
{
    Verifies(req::SRS_SFS_215);
    gate.Use(IdentityRule::kPlcDesigner);
    slaves[2].device_type = 0x0002'0191U;
    slaves[2].vendor_id = 5U;
    Put(0x1000U, 0U, 0x0004'0191U, 4U);
    EXPECT_EQ(Verified(), GateState::kOpen);
    EXPECT_EQ(Indices(reads.begin(), reads.begin() + 2), (Indices{0x1000U, 0x13FEU}));
    Put(0x1000U, 0U, 0x0002'0192U, 4U);
    EXPECT_EQ(Verified(), GateState::kDiffers);
    EXPECT_TRUE(gate.IsOther(kSlave));
}

TEST_F(SafetyCheckTest, WhatEachProfileComparesOfAnIdentity)
{
    Verifies(req::SRS_SFS_215);
    SlaveSetup slave{};
    const std::uint8_t subs[5] = {0U, 1U, 2U, 3U, 4U};
    const auto masks = [&slave, &subs](const IdentityRule rule)
    {
        std::vector<std::uint32_t> all{};
        for (const std::uint8_t row : subs)
        {
            all.push_back(IdentityRowOf(slave, rule, row).mask);
        }
        return all;
    };
    using Masks = std::vector<std::uint32_t>;
    constexpr std::uint32_t kAll = 0xFFFF'FFFFU;
    // 0 is not asked, but a device type under EL6751
    EXPECT_EQ(masks(IdentityRule::kCia302), (Masks{0U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(masks(IdentityRule::kEl6751), (Masks{kAll, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(masks(IdentityRule::kPlcDesigner), (Masks{0U, 0U, 0U, 0U, 0U}));
    slave.device_type = 1U;
    slave.vendor_id = 2U;
    slave.product_code = 3U;
    slave.revision_number = 4U;
    slave.serial_number = 5U;
    EXPECT_EQ(masks(IdentityRule::kCia302), (Masks{kAll, kAll, kAll, kAll, kAll}));
    EXPECT_EQ(masks(IdentityRule::kEl6751), (Masks{kAll, kAll, kAll, kAll, kAll}));
    EXPECT_EQ(masks(IdentityRule::kPlcDesigner), (Masks{0xFFFFU, 0U, 0U, 0U, 0U}));
    El6751Slave box{};
    slave.el6751 = &box;
    EXPECT_EQ(masks(IdentityRule::kEl6751), (Masks{kAll, kAll, kAll, kAll, kAll}));
    box.is_device_type_checked = false;
    EXPECT_EQ(masks(IdentityRule::kEl6751), (Masks{0U, kAll, kAll, kAll, kAll}));
    box.kind = El6751Kind::kBusCoupler;
    EXPECT_EQ(masks(IdentityRule::kEl6751), (Masks{0U, kAll, kAll, 0U, 0U}));
    EXPECT_EQ(IdentityRowOf(slave, IdentityRule::kCia302, 5U).mask, 0U); // No such row.
    EXPECT_EQ(IdentityRowOf(slave, IdentityRule::kCia302, 0U).object.index, 0x1000U);
    EXPECT_EQ(IdentityRowOf(slave, IdentityRule::kCia302, 3U).object.index, 0x1018U);
    EXPECT_EQ(IdentityRowOf(slave, IdentityRule::kCia302, 3U).object.sub, 3U);
    EXPECT_EQ(IdentityRowOf(slave, IdentityRule::kCia302, 3U).expected, 4U);
}

TEST_F(SafetyCheckTest, InDoubtNothingOpensUntilItIsTrustedAgain)
{
    Verifies(req::SRS_SFS_151);
    ASSERT_EQ(Verified(), GateState::kOpen);
    gate.Doubt(kSlave);
    gate.Doubt(NodeId{9U}); // No slot.
    EXPECT_EQ(gate.State(kSlave), GateState::kFailed);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0U);
    EXPECT_EQ(gate.Finding(kSlave).abort, SdoAbort::kGeneral);
    EXPECT_FALSE(gate.MayStart(kSlave));
    EXPECT_EQ(Verified(), GateState::kFailed);
    EXPECT_TRUE(reads.empty());
    EXPECT_FALSE(gate.Write(kSlave, Now()));
    // Trust alone opens nothing
    gate.Trust(kSlave);
    gate.Trust(NodeId{9U});
    EXPECT_EQ(gate.State(kSlave), GateState::kClosed);
    EXPECT_EQ(Verified(), GateState::kOpen);
}

TEST_F(SafetyCheckTest, TheLastDownloadOfEachSlaveIsKept)
{
    Verifies(req::SRS_SFS_011);
    EXPECT_EQ(gate.LastDownload(kSlave).index, 0U);
    gate.NoteDownload(kSlave, ObjectAddress{0x1301U, 2U});
    gate.NoteDownload(NodeId{9U}, ObjectAddress{0x1302U, 3U});
    EXPECT_EQ(gate.LastDownload(kSlave).index, 0x1301U);
    EXPECT_EQ(gate.LastDownload(kSlave).sub, 2U);
    EXPECT_EQ(gate.LastDownload(NodeId{9U}).index, 0U);
}

TEST_F(SafetyCheckTest, WithoutASlotOrSafetyNothingIsDone)
{
    Verifies(req::SRS_SFS_002);
    // The second safety slave finds no room
    EXPECT_EQ(gate.State(NodeId{3U}), GateState::kFailed);
    EXPECT_EQ(gate.Finding(NodeId{3U}).abort, SdoAbort::kOutOfMemory);
    EXPECT_FALSE(gate.MayStart(NodeId{3U}));
    EXPECT_FALSE(gate.Write(NodeId{3U}, Now()));
    gate.Renew(NodeId{3U});
    gate.Close(NodeId{3U});
    // One that is none is not asked
    gate.Verify(NodeId{9U}, Now());
    Ask();
    EXPECT_TRUE(sink.frames.empty());
    EXPECT_EQ(gate.State(NodeId{9U}), GateState::kOpen);
    EXPECT_EQ(gate.Finding(NodeId{9U}).object.index, 0U);
    EXPECT_EQ(gate.Finding(NodeId{9U}).abort, SdoAbort::kNone);
    // What is not being read does not begin anew
    gate.Renew(kSlave);
    EXPECT_EQ(gate.State(kSlave), GateState::kClosed);
}

TEST_F(SafetyCheckTest, ATransferThatHasEndedIsNotTakenFromItsUser)
{
    Verifies(req::SRS_SFS_002);
    gate.Verify(kSlave, Now());
    Ask();
    ASSERT_EQ(pool.State(kSlave), TransferState::kBusy);
    Answer();
    ASSERT_EQ(pool.State(kSlave), TransferState::kDone);
    gate.Close(kSlave);
    EXPECT_EQ(pool.State(kSlave), TransferState::kDone);
    // One that runs is
    gate.Verify(kSlave, Now());
    Ask();
    gate.Close(kSlave);
    EXPECT_EQ(pool.State(kSlave), TransferState::kFailed);
    EXPECT_EQ(pool.Outcome(kSlave).abort, SdoAbort::kGeneral);
}

TEST_F(SafetyCheckTest, AnAnswerThatNobodyTookBeforeItsLaneChangedHandsIsAskedForAgain)
{
    Verifies(req::SRS_SFS_004);
    gate.Verify(kSlave, Now());
    Ask();
    Answer();
    ASSERT_EQ(reads, (Indices{0x13FEU}));
    // Given a gate without a cycle until the only lane belongs to node 9
    std::array<std::uint8_t, 4> other{};
    for (int cycle = 0; cycle < 3; ++cycle)
    {
        pool.OnCycle(Now());
    }
    ASSERT_TRUE(pool.Upload(NodeId{9U}, ObjectAddress{0x1001U, 0U}, Room{other.data(), 4U}, SdoMode::kNormal, Now()));
    Put(0x1001U, 0U, 3U, 1U);
    gate.OnCycle(Now());
    EXPECT_EQ(gate.State(kSlave), GateState::kBusy);
    Answer();
    EXPECT_EQ(other[0], 3U);
    Finish();
    EXPECT_EQ(gate.State(kSlave), GateState::kOpen);
    EXPECT_EQ(Indices(reads.begin(), reads.begin() + 3), (Indices{0x13FEU, 0x1001U, 0x13FEU}));
}

TEST_F(SafetyCheckTest, EachSubIndexOfTheObjectWrittenLastIsForeign)
{
    Verifies(req::SRS_SFS_011);
    Verifies(req::SRS_SFS_121);
    ASSERT_TRUE(gate.Write(kSlave, Now()));
    while (reads.empty() && (writes < 100)) // Then all but 13FEh is written, the signature last.
    {
        Ask();
        Answer();
    }
    ASSERT_EQ(reads, (Indices{0x1301U}));
    for (const std::uint8_t sub : {std::uint8_t{1U}, std::uint8_t{2U}})
    {
        EXPECT_TRUE(gate.OnWritten(kSlave, ObjectAddress{0x13FFU, sub}));
        reads.clear();
        while (reads.empty() && (writes < 300))
        {
            Ask();
            Answer();
        }
    }
    Finish();
    EXPECT_EQ(gate.State(kSlave), GateState::kOpen);
    EXPECT_EQ(objects[0x13FE00U].value, 0xA5U);
}

TEST_F(SafetyCheckTest, WhatIsFixedBesideTheConfigurationIsReadToo)
{
    Verifies(req::SRS_SFS_001);
    // Given a mapping entry above the count, and the signature of an SRDO that is not there, both fixed
    std::vector<ExpectedObject> list(kLeast, kLeast + 8);
    list.insert(list.begin() + 7, ExpectedObject{{0x1381U, 9U}, 0x2000'0108U, true});
    list.push_back(ExpectedObject{{0x13FFU, 7U}, 0x0102U, true});
    const SafetyExpectation more{list.data(), 10U};
    slaves[2].safety = &more;
    Put(0x1381U, 9U, 0x2000'0108U, 4U);
    Put(0x13FFU, 7U, 0x0102U, 2U);
    EXPECT_EQ(Verified(), GateState::kOpen);
    EXPECT_EQ(reads, (Indices{0x13FEU, 0x1301U, 0x1301U, 0x1301U, 0x1301U, 0x1301U, 0x1301U, 0x1381U, 0x1381U, 0x13FFU,
                              0x13FFU, 0x13FEU}));
    // When one of them is another one, then it is named
    Put(0x1381U, 9U, 0x2000'0110U, 4U);
    EXPECT_EQ(Verified(), GateState::kDiffers);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x1381U);
    EXPECT_EQ(gate.Finding(kSlave).object.sub, 9U);
    Put(0x1381U, 9U, 0x2000'0108U, 4U);
    Put(0x13FFU, 7U, 0x0103U, 2U);
    EXPECT_EQ(Verified(), GateState::kDiffers);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x13FFU);
    EXPECT_EQ(gate.Finding(kSlave).object.sub, 7U);
}

/// SRDO 1, which sends two entries, and SRDO 2, which is off and has neither identifiers nor a mapping.
class SafetyWritingTest : public SafetyCheckTest
{
  public:
    SafetyWritingTest()
    {
        slaves[2].safety = &expectation;
        for (const ExpectedObject& object : list)
        {
            Put(object.address.index, object.address.sub, static_cast<std::uint32_t>(object.value),
                SizeOf(object.address));
        }
    }

    const std::vector<ExpectedObject> list{
        {{0x1300U, 0U}, 1U, false},           {{0x1301U, 1U}, 1U, false},   {{0x1301U, 2U}, 50U, false},
        {{0x1301U, 3U}, 20U, false},          {{0x1301U, 4U}, 254U, false}, {{0x1301U, 5U}, 0x101U, false},
        {{0x1301U, 6U}, 0x102U, false},       {{0x1302U, 1U}, 0U, false},   {{0x1302U, 2U}, 25U, false},
        {{0x1302U, 3U}, 10U, false},          {{0x1302U, 4U}, 254U, false}, {{0x1302U, 5U}, 0U, false},
        {{0x1302U, 6U}, 0U, false},           {{0x1381U, 0U}, 2U, false},   {{0x1381U, 1U}, 0x2200'0108U, false},
        {{0x1381U, 2U}, 0x2300'0108U, false}, {{0x1382U, 0U}, 0U, false},   {{0x13FFU, 1U}, 0x1234U, false},
        {{0x13FFU, 2U}, 0x5678U, false}};
    const SafetyExpectation expectation{list.data(), 19U};
};

TEST_F(SafetyWritingTest, EachStepIsDoneForEachSrdoBeforeTheNext)
{
    Verifies(req::SRS_SFS_005);
    Verifies(req::SRS_SFS_620);
    ASSERT_TRUE(gate.Write(kSlave, Now()));
    Finish();
    EXPECT_EQ(gate.State(kSlave), GateState::kOpen);
    using Written = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
    const Written expected{{0x13FE00U, 0U},
                           // Off
                           {0x130101U, 0U},
                           {0x130201U, 0U},
                           // Times, transmission type and, where there are any, identifiers
                           {0x130102U, 50U},
                           {0x130103U, 20U},
                           {0x130104U, 254U},
                           {0x130105U, 0x101U},
                           {0x130106U, 0x102U},
                           {0x130202U, 25U},
                           {0x130203U, 10U},
                           {0x130204U, 254U},
                           // Mappings: none, their entries, their counts
                           {0x138100U, 0U},
                           {0x138200U, 0U},
                           {0x138101U, 0x2200'0108U},
                           {0x138102U, 0x2300'0108U},
                           {0x138100U, 2U},
                           // On, 1300h, signatures
                           {0x130101U, 1U},
                           {0x130000U, 1U},
                           {0x13FF01U, 0x1234U},
                           {0x13FF02U, 0x5678U},
                           {0x13FE00U, 0xA5U}};
    EXPECT_EQ(written, expected);
    // Behind the signatures all 19 objects are read, behind 13FEh := A5h 1300h and 13FEh
    ASSERT_EQ(reads.size(), 21U);
    EXPECT_EQ(Indices(reads.begin() + 18, reads.end()), (Indices{0x13FFU, 0x1300U, 0x13FEU}));
}

TEST_F(SafetyWritingTest, AnIdentifierThatIsToBeNoneIsCompared)
{
    Verifies(req::SRS_SFS_620);
    Put(0x1302U, 5U, 0x103U, 4U);
    ASSERT_TRUE(gate.Write(kSlave, Now()));
    Finish();
    EXPECT_EQ(gate.State(kSlave), GateState::kDiffers);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x1302U);
    EXPECT_EQ(gate.Finding(kSlave).object.sub, 5U);
    EXPECT_EQ(gate.Finding(kSlave).read, 0x103U);
    EXPECT_EQ(objects[0x13FE00U].value, 0U);
}

TEST_F(SafetyWritingTest, AStaticMappingIsComparedWhileTheRestIsWritten)
{
    Verifies(req::SRS_SFS_210);
    std::vector<ExpectedObject> fixed = list;
    for (ExpectedObject& object : fixed)
    {
        object.is_fixed = (object.address.index == 0x1381U);
    }
    const SafetyExpectation of_program{fixed.data(), 19U};
    slaves[2].safety = &of_program;
    Put(0x1381U, 2U, 0x2400'0108U, 4U);
    ASSERT_TRUE(gate.Write(kSlave, Now()));
    Finish();
    EXPECT_EQ(gate.State(kSlave), GateState::kDiffers);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x1381U);
    EXPECT_EQ(gate.Finding(kSlave).object.sub, 2U);
    EXPECT_EQ(gate.Finding(kSlave).expected, 0x2300'0108U);
    EXPECT_EQ(gate.Finding(kSlave).read, 0x2400'0108U);
    EXPECT_EQ(objects[0x13FE00U].value, 0U);
    // Written is all but its three objects: 13FEh, both directions, 5 and 3 settings, a count of 0, a direction, 1300h
    // and two signatures
    EXPECT_EQ(written.size(), 16U);
}

TEST_F(SafetyWritingTest, WhatDiffersBehindTheDeclarationOpensNothing)
{
    Verifies(req::SRS_SFS_211);
    Verifies(req::SRS_SFS_220);
    for (const std::uint32_t object : {0x130000U, 0x13FE00U})
    {
        // Given a slave that has just been declared valid, when 1300h or 13FEh of it is another one
        ASSERT_TRUE(gate.Write(kSlave, Now()));
        objects[0x13FE00U].value = 0U;
        while ((objects[0x13FE00U].value != 0xA5U) && (writes < 100))
        {
            Ask();
            Answer();
        }
        ASSERT_EQ(objects[0x13FE00U].value, 0xA5U);
        objects[object].value = 0U;
        Finish();
        EXPECT_EQ(gate.State(kSlave), GateState::kDiffers) << std::hex << object;
        EXPECT_EQ(gate.Finding(kSlave).object.index, object >> 8U);
        EXPECT_FALSE(gate.MayStart(kSlave));
        objects[object].value = 1U;
    }
}

// 13FEh := 0, 19 further writes, 19 objects read back, 13FEh := A5h, 1300h and 13FEh read again
TEST_F(SafetyWritingTest, AnAbortOfAnyRequestEndsItWithoutPermissionToStart)
{
    Verifies(req::SRS_SFS_211);
    for (aborted = 0; aborted < 42; ++aborted)
    {
        requests = 0;
        written.clear();
        Put(0x13FEU, 0U, 0xA5U, 1U);
        ASSERT_TRUE(gate.Write(kSlave, Now()));
        Finish();
        EXPECT_EQ(gate.State(kSlave), GateState::kFailed) << aborted;
        EXPECT_EQ(gate.Finding(kSlave).abort, SdoAbort::kDeviceState) << aborted;
        EXPECT_FALSE(gate.MayStart(kSlave)) << aborted;
        const bool is_valid = (aborted == 0) || (aborted > 39); // As it was, or declared.
        EXPECT_EQ(objects[0x13FE00U].value, is_valid ? 0xA5U : 0U) << aborted;
        EXPECT_EQ(written.empty(), aborted == 0) << aborted;
        Ask();
        Answer();
        EXPECT_EQ(requests, aborted + 1); // Nothing more is asked.
    }
}

TEST_F(SafetyWritingTest, ADifferenceInAnyObjectEndsItBeforeTheDeclaration)
{
    Verifies(req::SRS_SFS_211);
    for (const ExpectedObject& object : list)
    {
        // Given a slave that has another value than was written when reading back begins
        ASSERT_TRUE(gate.Write(kSlave, Now()));
        writes = 0;
        while (writes < 20)
        {
            Ask();
            Answer();
        }
        Held& held = objects[(std::uint32_t{object.address.index} << 8U) | object.address.sub];
        held.value ^= 1U;
        Finish();
        EXPECT_EQ(gate.State(kSlave), GateState::kDiffers) << std::hex << object.address.index;
        EXPECT_EQ(gate.Finding(kSlave).object.index, object.address.index);
        EXPECT_EQ(gate.Finding(kSlave).object.sub, object.address.sub);
        EXPECT_FALSE(gate.MayStart(kSlave));
        EXPECT_EQ(objects[0x13FE00U].value, 0U);
        EXPECT_EQ(writes, 20);
        held.value ^= 1U; // An identifier of 0 is not written.
    }
}

TEST_F(SafetyCheckTest, ACheckThatWasNotBegunOrHasNoTaskIsNone)
{
    Verifies(req::SRS_SFS_003);
    SafetyCheck check{};
    check.OnCycle(pool, Now());
    EXPECT_EQ(check.State(), CheckState::kClosed);
    EXPECT_FALSE(check.HasTransfer());
    check.Begin(SafetyOrder{slaves[2], IdentityRule::kCia302, SafetyTask::kInvalid}, kSlave);
    EXPECT_EQ(check.State(), CheckState::kFailed);
    EXPECT_EQ(check.Finding().abort, SdoAbort::kLocalControl);
    check.OnCycle(pool, Now());
    EXPECT_TRUE(sink.frames.empty());
}

TEST_F(SafetyCheckTest, LengthOfEachObjectOfAnExpectation)
{
    Verifies(req::SRS_SFS_001);
    Verifies(req::SRS_SFS_007);
    struct Case
    {
        std::uint16_t index;
        std::uint8_t sub;
        std::uint8_t size;
    };
    const Case cases[] = {{0x1300U, 0U, 1U}, {0x1300U, 1U, 0U},   {0x1301U, 0U, 1U},   {0x1301U, 2U, 2U},
                          {0x1340U, 6U, 4U}, {0x1340U, 7U, 0U},   {0x1341U, 0U, 0U},   {0x1380U, 0U, 0U},
                          {0x1381U, 0U, 1U}, {0x1381U, 128U, 4U}, {0x13C0U, 129U, 0U}, {0x13C1U, 0U, 0U},
                          {0x13FEU, 0U, 0U}, {0x13FFU, 0U, 1U},   {0x13FFU, 64U, 2U},  {0x13FFU, 65U, 0U},
                          {0x12FFU, 0U, 0U}, {0x1400U, 0U, 0U}};
    for (const Case& one : cases)
    {
        EXPECT_EQ(SizeOf(ObjectAddress{one.index, one.sub}), one.size) << std::hex << one.index << ':' << int{one.sub};
    }
    // What is no object of it makes the whole expectation none, and so does a mapping of no SRDO
    EXPECT_TRUE(IsUsable(kExpectation));
    std::vector<ExpectedObject> list(kLeast, kLeast + 8);
    list.insert(list.begin(), ExpectedObject{{0x1300U, 1U}, 0U, false});
    EXPECT_FALSE(IsUsable(SafetyExpectation{list.data(), 9U}));
    list.assign(kLeast, kLeast + 8);
    list.insert(list.begin() + 7, ExpectedObject{{0x1382U, 0U}, 0U, false});
    EXPECT_FALSE(IsUsable(SafetyExpectation{list.data(), 9U}));
}

} // namespace
} // namespace counterpoint::cia302
