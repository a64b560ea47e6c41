// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// When a GFC may be sent, and the very limit of what has to follow it.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <initializer_list>

namespace counterpoint
{
namespace
{

class GfcTime : public Rig
{
  public:
    void CycleAt(const std::uint32_t instant_us)
    {
        now_us = instant_us;
        kernel.Cycle(CycleCall{InstantPair{{now_us}, {now_us}}, 0U, 0U});
    }
};

TEST_F(GfcTime, LeavesInNoOtherStateThanOperational)
{
    Verifies(req::SRS_KRN_013);
    for (const NmtState state : {NmtState::kInitialising, NmtState::kPreOperational, NmtState::kStopped})
    {
        Operate();
        kernel.SetNmtState(state);
        EXPECT_EQ(kernel.SendGfc(), Result::kNmtError);
        Cycle();
        EXPECT_EQ(kernel.SendGfc(), Result::kNmtError);
    }
    EXPECT_TRUE(ports.sent.empty());
}

TEST_F(GfcTime, OneMicrosecondBehindTheRefreshTimeItWasNotFollowed)
{
    Verifies(req::SRS_KRN_225);
    setups[1].form = ProducerForm::kApplicationSends;
    for (const std::uint32_t last_us : {25000U, 25001U})
    {
        Operate();
        application.gfcs_not_followed = 0;
        const std::uint32_t before_us = now_us;
        // Given a GFC that is sent just before the next cycle, which does not put off when it is late
        now_us += 999U;
        ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
        for (std::uint32_t cycle = 1U; cycle < 25U; ++cycle)
        {
            CycleAt(before_us + (cycle * 1000U));
        }
        CycleAt(before_us + last_us);
        EXPECT_EQ(application.gfcs_not_followed, (last_us == 25001U) ? 1 : 0);
        CycleAt(before_us + 26000U);
        EXPECT_EQ(application.gfcs_not_followed, 1);
        CycleAt(before_us + 27000U);
        EXPECT_EQ(application.gfcs_not_followed, 1);
    }
}

TEST_F(GfcTime, WithoutAProducerItWasNotFollowedInTheNextCycle)
{
    Verifies(req::SRS_KRN_225);
    Configure();
    ASSERT_EQ(Write(0x1303U, 1U, 0U, 1U), AbortCode::kNone);
    const SignReply reply = kernel.Sign(CommunicationIndex{0x1303U});
    ASSERT_EQ(Write(0x13FFU, 3U, reply.signature, 2U), AbortCode::kNone);
    ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    Cycles(2U);
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    EXPECT_EQ(application.gfcs_not_followed, 0);
    Cycle();
    EXPECT_EQ(application.gfcs_not_followed, 1);
    Cycles(30U);
    EXPECT_EQ(application.gfcs_not_followed, 1);
}

TEST_F(GfcTime, InTheDeviceSafeStateItWasNotFollowedEither)
{
    Verifies(req::SRS_KRN_225);
    Operate();
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    kernel.DemandSafeState();
    Cycles(25U);
    EXPECT_EQ(application.gfcs_not_followed, 0);
    Cycle();
    EXPECT_EQ(application.gfcs_not_followed, 1);
    ASSERT_EQ(ports.sent.size(), 1U);
    EXPECT_EQ(ports.sent[0].identifier, 0x001U);
}

} // namespace
} // namespace counterpoint
