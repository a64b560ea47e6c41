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

/// Place of the only inverse entry of slot 2, and map count of slot 2.
constexpr std::size_t kPlaceOfSlot2At = offsetof(RigStorage, places) + (9U * sizeof(std::uint16_t));
constexpr std::size_t kMapCountOfSlot2At = offsetof(RigStorage, image) + (2U * 16U) + 12U;

TEST(ChannelBReadingBack, WhatIsWrongIsToldOfItsOwnSlot)
{
    Verifies(req::SRS_REL_011);
    Verifies(req::SRS_REL_010);
    // Given two released consumers, when the place of the second one's object is lost
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Start();
    static_cast<void>(rig->Enter());
    rig->Pair(0U, 0x1122334455667788U);
    rig->Pair(2U, 0xFFU);
    ASSERT_EQ(rig->Cycle().released, 5U);
    rig->Bytes()[kPlaceOfSlot2At] = 0xFFU;
    rig->Bytes()[kPlaceOfSlot2At + 1U] = 0xFFU;
    // then that one is told, and the other one permitted
    EXPECT_EQ(rig->Voice().Commit(Agreement{5U, 5U}, 0U), 4U);
    EXPECT_EQ(rig->Voice().Answer(1U).mask, 1U);
}

TEST(ChannelBReadingBack, EntriesBehindTheCountLeadNowhere)
{
    Verifies(req::SRS_REL_011);
    Verifies(req::SRS_CONS_024);
    // Given a released consumer of one object, when a bit of its map count flips, which then is above the four entries
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Start();
    static_cast<void>(rig->Enter());
    rig->Pair(2U, 0x5AU);
    ASSERT_EQ(rig->Cycle().released, 4U);
    ASSERT_EQ(rig->Bytes()[kMapCountOfSlot2At], 2U);
    rig->Bytes()[kMapCountOfSlot2At] = 6U;
    // then that is found, nothing is permitted, and no object of others is written
    EXPECT_EQ(rig->Voice().Commit(Agreement{4U, 4U}, 0U), 4U);
    EXPECT_EQ(rig->Voice().Answer(1U).mask, 0U);
    EXPECT_EQ(rig->Value(9U), 0x666666A5U);
    for (const std::size_t other : {0U, 1U, 4U, 5U, 6U, 7U, 8U, 10U, 11U})
    {
        EXPECT_EQ(rig->Value(other), 0x66666666U) << other;
    }
}

TEST(ChannelBReadingBack, WhatIsWrittenAndExaminedInOneCallIsReadBack)
{
    Verifies(req::SRS_REL_011);
    // Given a released pair of two halves, whose objects have come to lie in one place
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Start();
    static_cast<void>(rig->Enter());
    rig->Pair(0U, 0x1122334455667788U);
    ASSERT_EQ(rig->Cycle().released, 1U);
    rig->Share(2U, 3U);
    // when the call that writes it is the one in which its turn to be examined comes, then it is found
    EXPECT_EQ(rig->Voice().Commit(Agreement{1U, 1U}, 1U), 1U);
    EXPECT_EQ(rig->Voice().Answer(1U).mask, 0U);
}

TEST(ChannelBReadingBack, ObjectThatIsNotThereIsReadAsZero)
{
    Verifies(req::SRS_PROD_005);
    // Given a producer, when the place of its first inverse object is lost
    const auto rig = std::make_unique<Rig>();
    rig->Start();
    static_cast<void>(rig->Enter());
    rig->Request();
    ASSERT_EQ(rig->Cycle().due, 2U);
    rig->Put(7U, 0x44332211U);
    constexpr std::size_t kAt = offsetof(RigStorage, places) + (5U * sizeof(std::uint16_t));
    rig->Bytes()[kAt] = 0xFFU;
    rig->Bytes()[kAt + 1U] = 0xFFU;
    // then its bits are inverse to 0, and those of the other object are what they were
    const PreparedPair pair = rig->Voice().Prepare(1U);
    static constexpr std::uint8_t kData[8U] = {0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xEEU, 0xDDU, 0xCCU, 0xBBU};
    for (std::size_t at = 0U; at < 8U; ++at)
    {
        EXPECT_EQ(pair.normal.data[at], kData[at]) << at;
    }
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

TEST(ChannelBReadingBack, SafeValueThatIsNotThereIsToldHoweverOftenItWasSetUp)
{
    Verifies(req::SRS_REL_012);
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Setup(0U).safe_value = kTwoHalves;
    rig->Share(2U, 3U);
    rig->Start();
    // When it is set up again before a Commit, then that tells
    ASSERT_EQ(rig->Voice().Validate(0U).fault, ConfigFault::kNone);
    EXPECT_EQ(rig->Voice().Commit(Agreement{0U, 0U}, 0U), 1U);
}

TEST(ChannelBReadingBack, SafeValueThatIsNotThereIsToldOfItsOwnSlot)
{
    Verifies(req::SRS_REL_012);
    // Given a second consumer whose inverse objects of 8 and 32 bits lie in one place
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Setup(2U).safe_value = kTwoHalves;
    rig->Share(9U, 11U);
    rig->Start();
    EXPECT_EQ(rig->Voice().Commit(Agreement{0U, 0U}, 0U), 0U);
    // when it is set up, then it is the one that is told
    ASSERT_EQ(rig->Map(2U, {0x62000108U, 0x62010108U, 0x63000120U, 0x63010120U}), ConfigFault::kNone);
    EXPECT_EQ(rig->Voice().Commit(Agreement{0U, 0U}, 0U), 4U);
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
