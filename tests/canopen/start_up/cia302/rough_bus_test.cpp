// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a bus does to the start-up when nodes do not behave: two of one node-ID, babble, storms, anything at all.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

#include <random>

namespace counterpoint::cia302
{
namespace
{

using cia301::NodeState;

class RoughBusTest : public BootRig
{
  public:
    /// Slaves 5 and 6, mandatory, one object each.
    void AddTwo()
    {
        AddEntry(dcf, 0x2000U, 0U, {0x77U});
        for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}})
        {
            Add(node, kMust).Put8(0x2000U, 0U, 0U);
            setups[node].concise_dcf = Bytes{dcf.data(), static_cast<std::uint32_t>(dcf.size())};
        }
    }

    Octets dcf{};
};

/// The answer number `GetParam()` of the slaves gets lost, boot-up messages included.
class LostAnswerTest : public RoughBusTest, public ::testing::WithParamInterface<int>
{
};

TEST_P(LostAnswerTest, IsMadeUpFor)
{
    Verifies(req::SRS_NMM_031);
    Verifies(req::SRS_BOOT_002);
    AddTwo();
    lost_answer = GetParam();
    Begin();
    Run(1500U);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    EXPECT_EQ(slaves[6]->State(), NodeState::kOperational);
    EXPECT_EQ(slaves[5]->Get(0x2000U, 0U), (Octets{0x77U}));
    EXPECT_EQ(slaves[6]->Get(0x2000U, 0U), (Octets{0x77U}));
    EXPECT_EQ(Step(), MasterStep::kOperational);
    EXPECT_EQ(lost_answer, -1); // It was lost indeed.
}

INSTANTIATE_TEST_SUITE_P(Each, LostAnswerTest, ::testing::Range(0, 14));

TEST_F(RoughBusTest, TwoSlavesOfOneNodeId)
{
    Verifies(req::SRS_BOOT_005);
    AddTwo();
    // Given a second slave 5 with another serial number: two answers to each request
    auto& other = slaves[105];
    other = std::make_unique<FakeSlave>(std::uint8_t{5U}, *this);
    other->PutIdentity();
    other->Put32(0x1018U, 4U, 0x9999U);
    other->Put8(0x2000U, 0U, 0U);
    Begin();
    Run(500U);
    // Then the start-up ends for node 5, with the answer that came first or its contradiction, and goes on for node 6
    EXPECT_FALSE(Of(5U).is_busy);
    EXPECT_EQ(slaves[6]->State(), NodeState::kOperational);
    // With the first one gone, the other is found out
    slaves[5]->Unplug();
    other->Power(Now());
    Run(100U);
    EXPECT_EQ(Letter(5U), "O");
    EXPECT_EQ(Of(5U).read, 0x9999U);
    EXPECT_EQ(other->State(), NodeState::kPreOperational);
}

TEST_F(RoughBusTest, BabblingBootUpMessages)
{
    Verifies(req::SRS_BOOT_018);
    AddTwo();
    Begin();
    // When node 5 tells every millisecond, ten times, that it booted up
    for (int i = 0; i < 1000; ++i)
    {
        for (int k = 0; k < 10; ++k)
        {
            ToManager(cia301::ErrorControlFrame(NodeId{5U}, 0U));
        }
        Run(1U);
    }
    // Then the other is served
    EXPECT_EQ(slaves[6]->State(), NodeState::kOperational);
    EXPECT_LE(nmt.Waiting(), 256U);
    // and node 5 as soon as it holds its tongue
    Run(400U);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    EXPECT_EQ(Step(), MasterStep::kOperational);
}

TEST_F(RoughBusTest, EmergencyStormAndForeignIdentifiers)
{
    Verifies(req::SRS_BOOT_018);
    AddTwo();
    Begin();
    for (std::uint32_t i = 0U; i < 20000U; ++i)
    {
        CanFrame frame{0x085U, FrameKind::kData, CanPortId::kFirst, 8U, {0x00U, 0x10U, 1U, 0U, 0U, 0U, 0U, 0U}};
        frame.identifier = ((i & 1U) != 0U) ? (i % 0x580U) : 0x085U;
        ToManager(frame);
    }
    Run(50U);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    EXPECT_EQ(slaves[6]->State(), NodeState::kOperational);
}

TEST_F(RoughBusTest, AnyFramesAtAll)
{
    Verifies(req::SRS_BOOT_018);
    Verifies(req::SRS_NMM_032);
    AddTwo();
    Begin();
    std::mt19937 random{20261121U};
    constexpr std::uint32_t kServices[] = {0x580U, 0x700U, 0x600U, 0x080U, 0x000U, 0x180U};
    constexpr std::uint8_t kBytes[] = {0U, 4U, 5U, 127U, 0x80U, 0x43U, 0x60U, 0x41U, 0x20U};
    for (int i = 0; i < 100000; ++i)
    {
        CanFrame frame{};
        frame.identifier = kServices[random() % 6U] + (random() % 128U);
        frame.identifier = ((random() & 1U) != 0U) ? ((frame.identifier & 0x780U) | 5U) : frame.identifier;
        frame.kind = ((random() % 8U) != 0U) ? FrameKind::kData : FrameKind::kRemote;
        frame.port = CanPortId::kFirst;
        frame.length_bytes = static_cast<std::uint8_t>(random() % 9U);
        for (std::uint8_t& byte : frame.data)
        {
            byte = ((random() & 1U) != 0U) ? kBytes[random() % 9U] : static_cast<std::uint8_t>(random() & 0xFFU);
        }
        ToManager(frame);
        if ((i % 16) == 0)
        {
            Run(1U);
        }
    }
    // When it is quiet again, and the slaves are put in anew
    Run(2000U);
    slaves[5]->Power(Now());
    slaves[6]->Power(Now());
    Run(2000U);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    EXPECT_EQ(slaves[6]->State(), NodeState::kOperational);
    EXPECT_EQ(Letter(5U), "-");
}

} // namespace
} // namespace counterpoint::cia302
