// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Channel B alone: the pair that no SCT runs for. SCT 50 ms, SRVT 20 ms. Times in microseconds since the call that
// enters OPERATIONAL; the counter wraps at 63536.
#include "tests/channel_b/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kEnteredAt = 0xFFFF07D0U;
constexpr std::uint32_t kInverseFirstBit = 1U << static_cast<std::uint32_t>(SrdoCause::kInverseFirst);
constexpr std::uint32_t kLateCallBit = 1U << static_cast<std::uint32_t>(SrdoCause::kLateCall);
constexpr std::uint32_t kSctBit = 1U << static_cast<std::uint32_t>(SrdoCause::kSct);
constexpr std::uint32_t kSrvtBit = 1U << static_cast<std::uint32_t>(SrdoCause::kSrvt);

CycleOutcome At(Rig& rig, std::uint32_t time_us)
{
    return rig.Cycle(kEnteredAt + time_us - rig.Now());
}

void NormalAt(Rig& rig, std::uint32_t time_us)
{
    rig.Voice().OnFrame(Rig::Frame(0x101U, 0x8877665544332211U, 8U), Instant{kEnteredAt + time_us});
}

void InverseAt(Rig& rig, std::uint32_t time_us)
{
    rig.Voice().OnFrame(Rig::Frame(0x102U, 0x778899AABBCCDDEEU, 8U), Instant{kEnteredAt + time_us});
}

void ExpectHeld(Rig& rig, std::uint8_t holds_pair, std::uint32_t ordinal, std::uint16_t error_count)
{
    const SrdoView view = rig.Voice().View(0U);
    EXPECT_EQ(view.holds_pair, holds_pair);
    EXPECT_EQ(view.ordinal, ordinal);
    EXPECT_EQ(view.error_count, error_count);
}

/// The call that tells this of slot 0, and after which it holds nothing.
void ExpectToldAt(Rig& rig, std::uint32_t time_us, std::uint32_t signals, std::uint16_t error_count)
{
    const CycleOutcome outcome = At(rig, time_us);
    EXPECT_EQ(outcome.new_fault & 1U, 1U) << time_us;
    EXPECT_EQ(outcome.signalled & 1U, 1U) << time_us;
    EXPECT_EQ(outcome.faulted & 1U, 1U) << time_us;
    EXPECT_EQ(outcome.released & 1U, 0U) << time_us;
    EXPECT_EQ(rig.Voice().View(0U).signals, signals) << time_us;
    ExpectHeld(rig, 0U, 0U, error_count);
}

void ExpectReleasedAt(Rig& rig, std::uint32_t time_us)
{
    const CycleOutcome outcome = At(rig, time_us);
    EXPECT_EQ(outcome.released & 1U, 1U) << time_us;
    EXPECT_EQ(outcome.signalled & 1U, 0U) << time_us;
}

/// Released by the next pair, in OPERATIONAL, and calls up to 90 ms apart are in time.
std::unique_ptr<Rig> Seldom(SrvtDetection detection = SrvtDetection::kEarly)
{
    auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Config().cycle_us = 50000U;
    rig->Config().cycle_tolerance_us = 40000U;
    rig->Setup(0U).detection = detection;
    rig->Start();
    EXPECT_EQ(rig->Enter().waiting & 1U, 1U);
    EXPECT_EQ(rig->Now(), kEnteredAt);
    return rig;
}

/// 1000 an inverse frame without its normal frame | 2000 normal, 3000 inverse frame: SCT would end at 52000
void CompleteBehindAFault(Rig& rig)
{
    InverseAt(rig, 1000U);
    NormalAt(rig, 2000U);
    InverseAt(rig, 3000U);
    ExpectHeld(rig, 1U, 1U, 1U);
}

TEST(ChannelBSct, DoesNotRunForAPairBehindAFaultThatIsNotTold)
{
    Verifies(req::SRS_CONS_013);
    Verifies(req::SRS_CONS_014);
    // Given a pair behind a fault, when the call that tells the fault comes beyond SCT of the pair
    const auto rig = Seldom();
    CompleteBehindAFault(*rig);
    // then that fault is all there is, and the pair is discarded
    ExpectToldAt(*rig, 52001U, kInverseFirstBit, 1U);
    EXPECT_EQ(At(*rig, 53000U).signalled & 1U, 0U);
    // A pair behind that call has SCT again: 54000 normal, 55000 inverse frame, SCT ends at 104000.
    NormalAt(*rig, 54000U);
    InverseAt(*rig, 55000U);
    ExpectReleasedAt(*rig, 56000U);
    ExpectReleasedAt(*rig, 104000U);
    ExpectToldAt(*rig, 104001U, kSctBit, 2U);
}

TEST(ChannelBSct, OfAPairBehindAFaultIsNotAskedForByAFrame)
{
    Verifies(req::SRS_CONS_013);
    // Given a pair behind a fault, when the next normal frame comes beyond its SCT
    const auto rig = Seldom();
    CompleteBehindAFault(*rig);
    NormalAt(*rig, 52001U);
    // then it is the first half of the next pair, which counts
    ExpectHeld(*rig, 1U, 1U, 1U);
    InverseAt(*rig, 53000U);
    ExpectHeld(*rig, 1U, 2U, 1U);
    ExpectToldAt(*rig, 60000U, kInverseFirstBit, 1U);
    // and a frame that is wrong in itself is that alone
    const auto wrong = Seldom();
    CompleteBehindAFault(*wrong);
    InverseAt(*wrong, 52001U);
    ExpectHeld(*wrong, 0U, 0U, 2U);
    ExpectToldAt(*wrong, 60000U, kInverseFirstBit, 2U);
}

TEST(ChannelBSct, RunsForAPairWithoutAFaultBeforeIt)
{
    Verifies(req::SRS_CONS_003);
    Verifies(req::SRS_CONS_014);
    for (const std::uint32_t next_us : {52000U, 52001U})
    {
        // Given a pair whose SCT ends at 52000, when a normal frame comes with its end or behind it
        const auto rig = Seldom();
        NormalAt(*rig, 2000U);
        InverseAt(*rig, 3000U);
        NormalAt(*rig, next_us);
        // then SCT is over behind it alone
        EXPECT_EQ(rig->Voice().View(0U).error_count, next_us - 52000U);
        EXPECT_EQ(rig->Voice().View(0U).holds_pair, 52001U - next_us);
    }
    // when no frame comes, then the call finds it
    const auto rig = Seldom();
    NormalAt(*rig, 2000U);
    InverseAt(*rig, 3000U);
    ExpectToldAt(*rig, 52001U, kSctBit, 1U);
}

TEST(ChannelBSct, RunsForAPairBehindADemotion)
{
    Verifies(req::SRS_CONS_014);
    // Given a demotion, which is not told, when a pair comes behind it
    const auto rig = Seldom();
    rig->Voice().Demote(0U);
    NormalAt(*rig, 2000U);
    InverseAt(*rig, 3000U);
    // then its SCT is found over
    ExpectToldAt(*rig, 52001U, kSctBit, 2U);
}

TEST(ChannelBSct, RunsForAPairWhileTheFaultOfAnotherSlotIsNotTold)
{
    Verifies(req::SRS_CONS_014);
    // Given a pair in slot 0, and one behind a fault in slot 2
    const auto rig = Seldom();
    NormalAt(*rig, 2000U);
    InverseAt(*rig, 3000U);
    rig->Voice().OnFrame(Rig::Frame(0x106U, 0xA5U, 1U), Instant{kEnteredAt + 4000U});
    rig->Voice().OnFrame(Rig::Frame(0x105U, 0x5AU, 1U), Instant{kEnteredAt + 5000U});
    rig->Voice().OnFrame(Rig::Frame(0x106U, 0xA5U, 1U), Instant{kEnteredAt + 6000U});
    // when a call comes beyond SCT of both, then each has its own cause
    ExpectToldAt(*rig, 60000U, kSctBit, 1U);
    EXPECT_EQ(rig->Voice().View(2U).signals, kInverseFirstBit);
    EXPECT_EQ(rig->Voice().View(2U).error_count, 1U);
}

TEST(ChannelBSct, OfAPairBehindAFaultTakesNoNormalFrameAlong)
{
    Verifies(req::SRS_CONS_013);
    Verifies(req::SRS_TIME_009);
    for (const SrvtDetection detection : {SrvtDetection::kEarly, SrvtDetection::kLate})
    {
        // Given a pair behind a fault, and a normal frame at 51000, when the call at 60000 tells the fault
        const auto rig = Seldom(detection);
        CompleteBehindAFault(*rig);
        NormalAt(*rig, 51000U);
        ExpectToldAt(*rig, 60000U, kInverseFirstBit, 1U);
        // then the normal frame stays, and its pair is released
        InverseAt(*rig, 61000U);
        ExpectHeld(*rig, 1U, 1U, 1U);
        ExpectReleasedAt(*rig, 62000U);
    }
}

TEST(ChannelBSct, OfAPairBehindAFaultIsNoEarlierDeadline)
{
    Verifies(req::SRS_CONS_013);
    Verifies(req::SRS_TIME_340);
    // Given late detection, a pair behind a fault and a normal frame at 51000, whose SRVT ends at 71000
    const auto rig = Seldom(SrvtDetection::kLate);
    CompleteBehindAFault(*rig);
    NormalAt(*rig, 51000U);
    // when its inverse frame comes behind that, then SRVT is over, and not SCT, which would have ended at 52000
    InverseAt(*rig, 71001U);
    ExpectToldAt(*rig, 72000U, kInverseFirstBit | kSrvtBit, 3U);
}

TEST(ChannelBSct, OfAPairBehindAFaultDoesNotExcuseALateCall)
{
    Verifies(req::SRS_CONS_013);
    Verifies(req::SRS_CONS_015);
    // Given calls each 1 ms with 500 us of tolerance, and a pair behind a fault
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Start();
    static_cast<void>(rig->Enter());
    CompleteBehindAFault(*rig);
    // when a call is late and beyond SCT, then it is late, as no limit expires in it
    ExpectToldAt(*rig, 52001U, kInverseFirstBit | kLateCallBit, 2U);
}

} // namespace
} // namespace counterpoint
