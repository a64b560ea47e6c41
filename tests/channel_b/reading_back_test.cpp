// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What channel B finds otherwise than it wrote it, where its places or a dummy are concerned.
#include "tests/channel_b/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace counterpoint
{
namespace
{

using RigStorage = channel_b::StorageFor<kRigSlots, kRigEntries>;

/// Place of the inverse entry of the second pair of slot 0.
constexpr std::size_t kPlaceAt = offsetof(RigStorage, places) + (3U * sizeof(std::uint16_t));

TEST(ChannelBReadingBack, AnEntryThatLeadsNowhereHoldsNothing)
{
    Verifies(req::SRS_REL_011);
    Verifies(req::SRS_REL_010);
    // Given a released pair whose inverse data are 0, as what no object has would read
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Start();
    static_cast<void>(rig->Enter());
    rig->Pair(0U, 0xFFFFFFFFFFFFFFFFU);
    ASSERT_EQ(rig->Cycle().released & 1U, 1U);
    // when the place of an object is lost before it is written
    rig->Bytes()[kPlaceAt] = 0xFFU;
    rig->Bytes()[kPlaceAt + 1U] = 0xFFU;
    // then that is found, and there is no permit
    EXPECT_EQ(rig->Voice().Commit(Agreement{1U, 1U}, 0U), 1U);
    EXPECT_EQ(rig->Value(3U), 0xFFFFFFFFU); // Still the safe value.
    EXPECT_EQ(rig->Voice().Answer(1U).mask, 0U);
}

/// One object of 32 bits with 55667788h in the normal frame, beside a dummy of 32 bits.
void ExpectTheObjectAloneIsLookedAt(const std::vector<std::uint32_t>& entries, std::uint64_t data)
{
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Config().dummies = DummyMapping::kAllowed;
    rig->Start();
    ASSERT_EQ(rig->Map(0U, entries), ConfigFault::kNone);
    static_cast<void>(rig->Enter());
    rig->Pair(0U, data);
    ASSERT_EQ(rig->Cycle().released & 1U, 1U);
    EXPECT_EQ(rig->Voice().Commit(Agreement{1U, 1U}, 0U), 0U);
    EXPECT_EQ(rig->Value(2U), 0xAA998877U);
    // When a bit of the object changes, then it is found
    for (const std::uint32_t changed : {0xAA998876U, 0x2A998877U, 0xAA988877U})
    {
        rig->Put(2U, changed);
        static_cast<void>(rig->Cycle());
        EXPECT_EQ(rig->Voice().Commit(Agreement{1U, 1U}, 1U), 1U) << changed;
        EXPECT_EQ(rig->Voice().Answer(1U).mask, 0U) << changed;
    }
    // and the dummy is never
    rig->Put(2U, 0xAA998877U);
    static_cast<void>(rig->Cycle());
    EXPECT_EQ(rig->Voice().Commit(Agreement{1U, 1U}, 1U), 0U);
    EXPECT_EQ(rig->Voice().Answer(1U).mask, 1U);
}

TEST(ChannelBReadingBack, DummyBelowAnObjectIsNotLookedFor)
{
    Verifies(req::SRS_REL_011);
    Verifies(req::SRS_CFG_033);
    ExpectTheObjectAloneIsLookedAt({0x00040020U, 0x00040020U, 0x60000120U, 0x60010120U}, 0x5566778811223344U);
}

TEST(ChannelBReadingBack, DummyAboveAnObjectIsNotLookedFor)
{
    Verifies(req::SRS_REL_011);
    Verifies(req::SRS_CFG_033);
    ExpectTheObjectAloneIsLookedAt({0x60000120U, 0x60010120U, 0x00040020U, 0x00040020U}, 0x1122334455667788U);
}

constexpr Payload kTwoHalves{0x44332211U, 0x88776655U};

TEST(ChannelBReadingBack, SafeValueThatIsNotThereAfterSetUpIsToldByTheNextCommit)
{
    Verifies(req::SRS_REL_012);
    // Given two inverse objects in one place, so that the second half of the safe value overwrites the first one
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Setup(0U).safe_value = kTwoHalves;
    rig->Share(2U, 3U);
    // when the SRDOs are set up, and long before a pair is released
    rig->Start();
    ASSERT_EQ(rig->Value(3U), 0x778899AAU);
    // then the next Commit tells that slot, even if it has nothing to write or to examine,
    EXPECT_EQ(rig->Voice().Commit(Agreement{0U, 0U}, 0U), 1U);
    // and once
    static_cast<void>(rig->Cycle());
    EXPECT_EQ(rig->Voice().Commit(Agreement{0U, 0U}, 0U), 0U);
    // but again when it is set up again
    ASSERT_EQ(rig->Voice().Validate(0U).fault, ConfigFault::kNone);
    static_cast<void>(rig->Cycle());
    EXPECT_EQ(rig->Voice().Commit(Agreement{0U, 0U}, 0U), 1U);
}

TEST(ChannelBReadingBack, SafeValueThatIsThereAfterSetUpIsNotTold)
{
    Verifies(req::SRS_REL_012);
    // Given every object in a place of its own
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Setup(0U).safe_value = kTwoHalves;
    rig->Start();
    ASSERT_EQ(rig->Value(2U), 0xBBCCDDEEU);
    ASSERT_EQ(rig->Value(3U), 0x778899AAU);
    EXPECT_EQ(rig->Voice().Commit(Agreement{0U, 0U}, 0U), 0U);
    // when the application changes an object behind the set-up, then that is not what was written wrongly
    ASSERT_EQ(rig->Voice().Validate(0U).fault, ConfigFault::kNone);
    rig->Put(2U, 0U);
    EXPECT_EQ(rig->Voice().Commit(Agreement{0U, 0U}, 0U), 0U);
}

TEST(ChannelBReadingBack, WhatWasNotThereAfterSetUpIsForgottenByRestart)
{
    Verifies(req::SRS_REL_012);
    // Given a safe value that is not there, which no Commit has told yet
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Setup(0U).safe_value = kTwoHalves;
    rig->Share(2U, 3U);
    rig->Start();
    // when the device starts anew with its objects apart
    rig->Share(2U, 2U);
    rig->Start();
    // then nothing is told
    EXPECT_EQ(rig->Voice().Commit(Agreement{0U, 0U}, 0U), 0U);
}

TEST(ChannelBReadingBack, NoPermitInACommitThatTellsOfASetUp)
{
    Verifies(req::SRS_REL_012);
    Verifies(req::SRS_REL_010);
    // Given a safe value that is not there, and a pair that is, both halves of its inverse being equal
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Setup(0U).safe_value = kTwoHalves;
    rig->Share(2U, 3U);
    rig->Start();
    static_cast<void>(rig->Enter());
    rig->Pair(0U, 0x1122334411223344U);
    ASSERT_EQ(rig->Cycle().released & 1U, 1U);
    // when the first Commit comes with that pair, then it tells the set-up and permits nothing
    EXPECT_EQ(rig->Voice().Commit(Agreement{1U, 1U}, 0U), 1U);
    EXPECT_EQ(rig->Value(3U), 0xEEDDCCBBU);
    EXPECT_EQ(rig->Voice().Answer(1U).mask, 0U);
    // and the next one permits it
    static_cast<void>(rig->Cycle());
    EXPECT_EQ(rig->Voice().Commit(Agreement{1U, 1U}, 0U), 0U);
    EXPECT_EQ(rig->Voice().Answer(1U).mask, 1U);
}

} // namespace
} // namespace counterpoint
