// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What channel B finds otherwise than it wrote it, where its places or a dummy are concerned.
#include "tests/channel_b/rig.hpp"
#include "verification/trace/ids/channel.hpp"
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

} // namespace
} // namespace counterpoint
