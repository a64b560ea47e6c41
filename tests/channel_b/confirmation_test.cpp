// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Channel B alone: when the confirmation of a normal frame comes too late, by its own counter or by that of the other
// channel. SRVT 20 ms. Times in microseconds.
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

// t     FFFFD8F0           0        00002710         00002711
//       cycle, Prepare     wrap     SRVT exactly     over
constexpr std::uint32_t kExactlySrvt = 0x00002710U;
constexpr std::uint32_t kPastSrvt = 0x00002711U;
constexpr std::uint32_t kNoConfirmationBit = 1U << static_cast<std::uint32_t>(SrdoCause::kNoConfirmation);

/// The normal frame of a producer, prepared 10 ms before the counter wraps. It was asked for in time, before the
/// refresh time was over.
CanFrame Prepared(Rig& rig)
{
    rig.Start();
    rig.Request();
    static_cast<void>(rig.Enter());
    EXPECT_EQ(rig.Cycle(0xD120U).due, 2U);
    return rig.Voice().Prepare(1U).normal;
}

void ExpectAccepted(Rig& rig, const CanFrame& normal)
{
    const Confirmation confirmation = rig.Voice().OnConfirm(normal, Instant{kExactlySrvt});
    EXPECT_EQ(confirmation.slot, 1U);
    EXPECT_EQ(confirmation.step, ConfirmStep::kNormal);
    EXPECT_EQ(rig.Voice().InverseFrame(1U).identifier, 0x104U);
    EXPECT_EQ(rig.Voice().View(1U).first_cause, SrdoCause::kNone);
}

void ExpectRefused(Rig& rig, const CanFrame& normal)
{
    const Confirmation confirmation = rig.Voice().OnConfirm(normal, Instant{kPastSrvt});
    EXPECT_EQ(confirmation.slot, kNoSlot);
    EXPECT_EQ(confirmation.step, ConfirmStep::kNone);
    EXPECT_EQ(rig.Voice().InverseFrame(1U).kind, FrameKind::kInvalid);
    EXPECT_EQ(rig.Voice().View(1U).first_cause, SrdoCause::kNoConfirmation);
    EXPECT_EQ(rig.Voice().View(1U).error_count, 1U);
}

TEST(ChannelBConfirmation, NormalFrameExactlyAtSrvtIsAccepted)
{
    Verifies(req::SRS_PROD_008);
    const auto rig = std::make_unique<Rig>();
    ExpectAccepted(*rig, Prepared(*rig));
}

TEST(ChannelBConfirmation, NormalFrameOneMicrosecondPastSrvtIsRefused)
{
    Verifies(req::SRS_PROD_008);
    const auto rig = std::make_unique<Rig>();
    ExpectRefused(*rig, Prepared(*rig));
}

TEST(ChannelBConfirmation, NormalFrameIsJudgedByItsStampAfterFurtherCycles)
{
    Verifies(req::SRS_PROD_008);
    const auto rig = std::make_unique<Rig>();
    // Given calls before the wrap and on the limit
    const CanFrame first = Prepared(*rig);
    static_cast<void>(rig->Cycle(1000U));
    static_cast<void>(rig->Cycle(19000U));
    ExpectAccepted(*rig, first);
    const CanFrame second = Prepared(*rig);
    static_cast<void>(rig->Cycle(1000U));
    static_cast<void>(rig->Cycle(19000U));
    ExpectRefused(*rig, second);
}

TEST(ChannelBConfirmation, InverseFrameHasSrvtOfItsOwn)
{
    Verifies(req::SRS_PROD_008);
    // Given a normal frame confirmed exactly at SRVT, when the inverse frame follows SRVT later, or 1 us more
    const auto rig = std::make_unique<Rig>();
    const CanFrame first = Prepared(*rig);
    ExpectAccepted(*rig, first);
    const CanFrame inverse = Rig::Frame(0x104U, 0x6666666666666666U, 8U);
    EXPECT_EQ(rig->Voice().OnConfirm(inverse, Instant{0x00007530U}).step, ConfirmStep::kPair);
    const CanFrame second = Prepared(*rig);
    ExpectAccepted(*rig, second);
    EXPECT_EQ(rig->Voice().OnConfirm(inverse, Instant{0x00007531U}).step, ConfirmStep::kNone);
    EXPECT_EQ(rig->Voice().View(1U).first_cause, SrdoCause::kNoConfirmation);
}

/// The other channel found the confirmation of this slot late.
void FoundLate(Rig& rig, SlotIndex slot = 1U)
{
    rig.Voice().OnTransmitFault(slot, TransmitFault{SrdoCause::kNoConfirmation});
}

void ExpectRecorded(Rig& rig, std::uint16_t error_count, SrdoCause first_cause)
{
    EXPECT_EQ(rig.Voice().View(1U).error_count, error_count);
    EXPECT_EQ(rig.Voice().View(1U).first_cause, first_cause);
}

/// The next call after a fault tells it, once; the producer goes on with what is asked of it then.
void ExpectToldAndGoingOn(Rig& rig)
{
    rig.Request();
    const CycleOutcome outcome = rig.Cycle();
    EXPECT_EQ(outcome.signalled & 2U, 2U);
    EXPECT_EQ(outcome.due, 2U);
    EXPECT_EQ(rig.Voice().View(1U).signals, kNoConfirmationBit);
    EXPECT_EQ(rig.Voice().View(1U).state, SrdoState::kProducer);
    EXPECT_EQ(rig.Cycle().signalled & 2U, 0U);
    rig.Confirm(rig.Voice().Prepare(1U).normal);
    rig.Confirm(rig.Voice().InverseFrame(1U));
    EXPECT_EQ(rig.Voice().View(1U).ordinal, 1U);
}

TEST(ChannelBConfirmation, FoundLateByTheOtherChannelGivesUpThePairOnTheLimit)
{
    Verifies(req::SRS_PROD_009);
    // Given a normal frame confirmed exactly at SRVT, when the other channel found it late
    const auto rig = std::make_unique<Rig>();
    ExpectAccepted(*rig, Prepared(*rig));
    FoundLate(*rig);
    // then there is no inverse frame, nor does anything confirm one,
    ExpectRecorded(*rig, 1U, SrdoCause::kNoConfirmation);
    EXPECT_EQ(rig->Voice().InverseFrame(1U).kind, FrameKind::kInvalid);
    const CanFrame inverse = Rig::Frame(0x104U, 0x6666666666666666U, 8U);
    EXPECT_EQ(rig->Voice().OnConfirm(inverse, Instant{kPastSrvt}).step, ConfirmStep::kNone);
    EXPECT_EQ(rig->Voice().View(1U).ordinal, 0U);
    // and the next pair is sent
    ExpectToldAndGoingOn(*rig);
    ExpectRecorded(*rig, 1U, SrdoCause::kNoConfirmation);
}

TEST(ChannelBConfirmation, FoundLateByTheOtherChannelGivesUpThePairThatAwaitsIt)
{
    Verifies(req::SRS_PROD_009);
    // Given a pair whose normal frame was not confirmed yet, when the other channel says that it came late
    const auto rig = std::make_unique<Rig>();
    const CanFrame normal = Prepared(*rig);
    FoundLate(*rig);
    // then nothing confirms it any more, and the next pair is sent
    ExpectRecorded(*rig, 1U, SrdoCause::kNoConfirmation);
    EXPECT_EQ(rig->Voice().OnConfirm(normal, Instant{kExactlySrvt}).step, ConfirmStep::kNone);
    EXPECT_EQ(rig->Voice().InverseFrame(1U).kind, FrameKind::kInvalid);
    ExpectToldAndGoingOn(*rig);
}

TEST(ChannelBConfirmation, FoundLateByTheOtherChannelChangesNothingWithoutAPair)
{
    Verifies(req::SRS_PROD_009);
    const auto rig = std::make_unique<Rig>();
    // Given a producer before its first pair
    rig->Start();
    FoundLate(*rig);
    static_cast<void>(rig->Enter());
    FoundLate(*rig);
    ExpectRecorded(*rig, 0U, SrdoCause::kNone);
    // with one in flight, and another slot that is none,
    rig->Request();
    EXPECT_EQ(rig->Cycle().due, 2U);
    const CanFrame normal = rig->Voice().Prepare(1U).normal;
    FoundLate(*rig, 0U);
    EXPECT_EQ(rig->Voice().View(0U).error_count, 0U);
    rig->Confirm(normal);
    rig->Confirm(rig->Voice().InverseFrame(1U));
    // with one that was sent, then nothing is recorded
    FoundLate(*rig);
    ExpectRecorded(*rig, 0U, SrdoCause::kNone);
    EXPECT_EQ(rig->Voice().View(1U).ordinal, 1U);
    // with one that this channel had given up itself, then nothing further
    ExpectRefused(*rig, Prepared(*rig));
    FoundLate(*rig);
    ExpectRecorded(*rig, 1U, SrdoCause::kNoConfirmation);
    // and with one that ended with OPERATIONAL
    static_cast<void>(Prepared(*rig));
    EXPECT_EQ(rig->Leave().not_operational, 1U);
    FoundLate(*rig);
    ExpectRecorded(*rig, 0U, SrdoCause::kNone);
    EXPECT_EQ(rig->Cycle().signalled & 2U, 0U);
}

TEST(ChannelBConfirmation, CauseThatIsNoneOfATransmissionGivesUpNoPair)
{
    Verifies(req::SRS_PROD_009);
    const auto rig = std::make_unique<Rig>();
    std::uint32_t given_up = 0U;
    for (std::uint32_t cause = 0U; cause <= 255U; ++cause)
    {
        // Given a pair in flight, when each value there is comes as the cause
        const CanFrame normal = Prepared(*rig);
        rig->Voice().OnTransmitFault(1U, TransmitFault{static_cast<SrdoCause>(cause)});
        if (rig->Voice().View(1U).error_count == 0U)
        {
            EXPECT_EQ(rig->Voice().OnConfirm(normal, Instant{kExactlySrvt}).step, ConfirmStep::kNormal) << cause;
            EXPECT_EQ(rig->Voice().View(1U).first_cause, SrdoCause::kNone) << cause;
            continue;
        }
        // then the four of a transmission are recorded, and no other
        ++given_up;
        EXPECT_EQ(rig->Voice().OnConfirm(normal, Instant{kExactlySrvt}).step, ConfirmStep::kNone) << cause;
        EXPECT_EQ(static_cast<std::uint32_t>(rig->Voice().View(1U).first_cause), cause);
        EXPECT_TRUE((cause == 4U) || ((cause >= 13U) && (cause <= 15U))) << cause;
    }
    EXPECT_EQ(given_up, 4U);
}

} // namespace
} // namespace counterpoint
