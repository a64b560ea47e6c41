// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Several causes of one SRDO in one cycle: which of them the application is told first.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <algorithm>

namespace counterpoint
{
namespace
{

using Causes = std::vector<SrdoCause>;

/// SRDO 1: SCT 50 ms, SRVT 20 ms, as seen by its application.
class TellingOrder : public Rig
{
  protected:
    explicit TellingOrder(const bool has_windows = true) : Rig(nullptr, nullptr, nullptr, has_windows)
    {
    }
    /// What was told so far is forgotten.
    Causes TakeCauses()
    {
        const Causes causes = CausesOf(0x1301U);
        application.errors.clear();
        return causes;
    }
    SrdoCause FirstCause() const
    {
        return kernel.GetState(CommunicationIndex{0x1301U}).first_cause;
    }
    /// A cycle in which a channel signals these causes of SRDO 1 besides.
    void CycleWith(Tap& tap, const std::uint32_t signals)
    {
        tap.on_outcome = [](CycleOutcome& outcome) { outcome.signalled |= 1U; };
        tap.more_signals = signals;
        tap.signals_slot = 0U;
        Cycle();
        tap.on_outcome = nullptr;
        tap.more_signals = 0U;
    }
    /// A pair, and 20 ms + 1 us behind its normal frame, before the next cycle, another inverse frame.
    void ReceiveLateInverse()
    {
        Cycles(2U);
        Receive(0x101U, {0x12U, 0x34U}, 0U);
        for (std::uint32_t cycle = 0U; cycle < 20U; ++cycle)
        {
            Cycle();
        }
        Receive(0x102U, {0xEDU, 0xCBU}, 1U);
    }
};

// t [ms]   8 normal   28.001 inverse   29 cycle
TEST_F(TellingOrder, SrvtComesBeforeTheFrameThatWasTooLate)
{
    Verifies(req::SRS_KRN_570);
    Operate();
    ReceiveLateInverse();
    // SRVT had expired when the inverse frame came, which is first for that reason
    Cycle();
    EXPECT_EQ(TakeCauses(), (Causes{SrdoCause::kSrvt, SrdoCause::kInverseFirst}));
    EXPECT_EQ(FirstCause(), SrdoCause::kSrvt);
}

// t [ms]   6.1 pair   56.101 normal frame of one byte   57 cycle
TEST_F(TellingOrder, SctComesBeforeTheShortFrameBehindIt)
{
    Verifies(req::SRS_KRN_570);
    Operate();
    ReceivePair();
    Cycles(50U);
    ASSERT_EQ(now_us, 56000U);
    ASSERT_EQ(TakeCauses(), Causes{});
    Receive(0x101U, {0x12U}, 200U);
    Cycle();
    EXPECT_EQ(TakeCauses(), (Causes{SrdoCause::kSct, SrdoCause::kLength}));
    EXPECT_EQ(FirstCause(), SrdoCause::kSct);
}

// The first cause is an older one, which nobody signals any more.
TEST_F(TellingOrder, WithoutTheFirstCauseTheNumbersDecide)
{
    Verifies(req::SRS_KRN_570);
    Operate();
    ReceivePair();
    Cycle();
    // Given a second normal frame before the inverse one
    Receive(0x101U, {0x12U, 0x34U}, 100U);
    Receive(0x101U, {0x12U, 0x34U}, 100U);
    Cycle();
    ASSERT_EQ(TakeCauses(), Causes{SrdoCause::kNormalTwice});
    // When SRVT expires before another cycle sees it, and the frame is judged by itself
    ReceiveLateInverse();
    Cycle();
    // Then the mask of signals tells of no order
    EXPECT_EQ(FirstCause(), SrdoCause::kNormalTwice);
    EXPECT_EQ(TakeCauses(), (Causes{SrdoCause::kInverseFirst, SrdoCause::kSrvt}));
}

TEST_F(TellingOrder, WithoutAFirstCauseTheNumbersDecide)
{
    Verifies(req::SRS_KRN_570);
    Operate();
    CycleWith(a, 0x00040062U);
    ASSERT_EQ(FirstCause(), SrdoCause::kNone);
    EXPECT_EQ(TakeCauses(),
              (Causes{SrdoCause::kLength, SrdoCause::kSrvt, SrdoCause::kSct, SrdoCause::kWaitingPastSct}));
}

// The first cause is 5; the lowest and the greatest cause stand beside it, by the other channel.
TEST_F(TellingOrder, OthersFollowByTheirNumbers)
{
    Verifies(req::SRS_KRN_570);
    Operate();
    ReceiveLateInverse();
    CycleWith(b, 0x00040012U);
    EXPECT_EQ(TakeCauses(), (Causes{SrdoCause::kSrvt, SrdoCause::kLength, SrdoCause::kInverseFirst,
                                    SrdoCause::kNotInverse, SrdoCause::kWaitingPastSct}));
}

// Channel A, which hears nothing of it, has no cause of its own.
TEST_F(TellingOrder, FirstCauseIsThatOfTheChannelThatFoundIt)
{
    Verifies(req::SRS_KRN_570);
    Operate();
    a.drop_frames = true;
    ReceiveLateInverse();
    a.drop_frames = false;
    Cycle();
    EXPECT_EQ(FirstCause(), SrdoCause::kSrvt);
    EXPECT_EQ(TakeCauses(), (Causes{SrdoCause::kSrvt, SrdoCause::kInverseFirst}));
}

// 18 is the last cause there is; what a channel has beyond is none.
TEST_F(TellingOrder, FirstCauseMayHaveTheLastNumber)
{
    Verifies(req::SRS_KRN_570);
    Operate();
    a.first_cause = SrdoCause::kWaitingPastSct;
    CycleWith(a, 0x00040020U);
    EXPECT_EQ(TakeCauses(), (Causes{SrdoCause::kWaitingPastSct, SrdoCause::kSrvt}));
}

TEST_F(TellingOrder, FirstCauseThatIsNoneIsNotTold)
{
    Verifies(req::SRS_KRN_570);
    Operate();
    a.first_cause = static_cast<SrdoCause>(19U);
    CycleWith(a, 0x00080020U);
    EXPECT_EQ(TakeCauses(), Causes{SrdoCause::kSrvt});
}

TEST_F(TellingOrder, FirstCauseBeyondEveryMaskIsNone)
{
    Verifies(req::SRS_KRN_570);
    Operate();
    a.first_cause = static_cast<SrdoCause>(33U);
    CycleWith(a, 0x22U);
    EXPECT_EQ(TakeCauses(), (Causes{SrdoCause::kLength, SrdoCause::kSrvt}));
}

TEST_F(TellingOrder, FirstCauseIsThatOfChannelAWhereBothHaveOne)
{
    Verifies(req::SRS_KRN_570);
    Operate();
    a.first_cause = SrdoCause::kSct;
    b.first_cause = SrdoCause::kSrvt;
    CycleWith(a, 0x60U);
    EXPECT_EQ(TakeCauses(), (Causes{SrdoCause::kSct, SrdoCause::kSrvt}));
}

// SCT 50 ms: of a cause that is signalled each millisecond every 51st is told.
TEST_F(TellingOrder, WindowBeginsWhenACauseIsTold)
{
    Verifies(req::SRS_KRN_032);
    Operate();
    // Given that it is the first cause, and that it is another one
    for (const SrdoCause first : {SrdoCause::kLength, SrdoCause::kSct})
    {
        a.first_cause = first;
        Cycles(200U);
        static_cast<void>(TakeCauses());
        for (std::uint32_t cycle = 0U; cycle < 1000U; ++cycle)
        {
            CycleWith(a, 0x02U);
        }
        const Causes causes = TakeCauses();
        EXPECT_EQ(std::count(causes.begin(), causes.end(), SrdoCause::kLength), 20);
    }
}

// t [ms]   0 SRVT, told   within its window: SRVT and Length
TEST_F(TellingOrder, FirstCauseWithinItsWindowIsNotToldAgain)
{
    Verifies(req::SRS_KRN_570);
    Verifies(req::SRS_KRN_032);
    Operate();
    ReceiveLateInverse();
    Cycle();
    ASSERT_EQ(FirstCause(), SrdoCause::kSrvt);
    ASSERT_EQ(TakeCauses().size(), 2U);
    CycleWith(a, 0x22U);
    EXPECT_EQ(TakeCauses(), Causes{SrdoCause::kLength});
}

/// Without windows nothing but the order itself keeps the first cause from being told twice.
class TellingOrderWithoutRoom : public TellingOrder
{
  protected:
    TellingOrderWithoutRoom() : TellingOrder(false)
    {
    }
};

TEST_F(TellingOrderWithoutRoom, FirstCauseIsToldOnce)
{
    Verifies(req::SRS_KRN_570);
    Verifies(req::SRS_KRN_347);
    Operate();
    ReceiveLateInverse();
    application.flow.clear();
    Cycle();
    EXPECT_EQ(TakeCauses(), (Causes{SrdoCause::kSrvt, SrdoCause::kInverseFirst}));
    // And it counts once
    for (const auto& [event, count] : application.flow)
    {
        EXPECT_TRUE((event != FlowEvent::kSrdoError) || (count == 2U)) << count;
    }
}

} // namespace
} // namespace counterpoint
