// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Channel B alone: when the confirmation of a normal frame comes too late. SRVT 20 ms. Times in microseconds.
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

/// The normal frame of a producer, prepared 10 ms before the counter wraps.
CanFrame Prepared(Rig& rig)
{
    rig.Start();
    static_cast<void>(rig.Enter());
    rig.Request();
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

} // namespace
} // namespace counterpoint
