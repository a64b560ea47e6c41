// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Channel B alone: objects that SRDOs of lower slots name too, and how many one may name. Slots 0 and 2 are consumers,
// 1 is a producer.
#include "tests/channel_b/rig.hpp"
#include "verification/conformance/static_row.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace counterpoint
{
namespace
{

std::unique_ptr<Rig> Started()
{
    auto rig = std::make_unique<Rig>();
    rig->Start();
    return rig;
}

TEST(ChannelBSharedObject, TwoConsumersNameNoObjectTogether)
{
    Verifies(req::SRS_CFG_037);
    const auto rig = Started();
    // Given slot 0 with 6000h and 6001h, when slot 2 names one of them besides its own, in either place
    EXPECT_EQ(rig->Map(2U, {0x62000108U, 0x62010108U}), ConfigFault::kNone);
    EXPECT_EQ(rig->Map(2U, {0x63000120U, 0x60010220U}), ConfigFault::kMapping);
    EXPECT_EQ(rig->Map(2U, {0x60000120U, 0x63010120U}), ConfigFault::kMapping);
    EXPECT_EQ(rig->Map(2U, {0x62000108U, 0x62010108U, 0x60010120U, 0x63010120U}), ConfigFault::kMapping);
    EXPECT_EQ(rig->Map(2U, {0x63000120U, 0x63010120U}), ConfigFault::kNone);
    // then it is the higher slot that is refused
    EXPECT_EQ(rig->Map(2U, {0x60000120U, 0x63010120U}), ConfigFault::kMapping);
    EXPECT_EQ(rig->Validated(0U), ConfigFault::kNone);
}

TEST(ChannelBSharedObject, WhatIsOffSharesNothing)
{
    Verifies(req::SRS_CFG_037);
    const auto rig = Started();
    rig->Store(0U, ConfigField::kDirection, 0U);
    EXPECT_EQ(rig->Map(2U, {0x60000120U, 0x60010220U}), ConfigFault::kNone);
    // but a direction that is none at all does
    rig->Store(0U, ConfigField::kDirection, 3U);
    EXPECT_EQ(rig->Validated(2U), ConfigFault::kMapping);
}

TEST(ChannelBSharedObject, TwoProducersMaySendOneObject)
{
    Verifies(req::SRS_CFG_037);
    const auto rig = Started();
    rig->Store(2U, ConfigField::kDirection, 1U);
    EXPECT_EQ(rig->Map(2U, {0x61000120U, 0x61010120U}), ConfigFault::kNone);
    // Given a lower slot of each direction, when it names what a producer sends, then a consumer may not
    EXPECT_EQ(rig->Map(0U, {0x61000220U, 0x61010220U}), ConfigFault::kMapping); // The access does not fit.
    EXPECT_EQ(rig->Validated(1U), ConfigFault::kMapping);
    EXPECT_EQ(rig->Validated(2U), ConfigFault::kNone);
    EXPECT_EQ(rig->Map(2U, {0x61000120U, 0x61010220U}), ConfigFault::kMapping);
    rig->Store(0U, ConfigField::kDirection, 1U);
    EXPECT_EQ(rig->Validated(1U), ConfigFault::kNone);
    EXPECT_EQ(rig->Validated(2U), ConfigFault::kNone);
}

TEST(ChannelBSharedObject, OnlyEntriesThatCountAreNamed)
{
    Verifies(req::SRS_CFG_037);
    const auto rig = Started();
    // Given a count of 2 in slot 0, then what stands behind is free
    rig->Store(0U, ConfigField::kMapCount, 2U);
    EXPECT_EQ(rig->Map(2U, {0x60000220U, 0x60010220U}), ConfigFault::kNone);
    rig->Store(0U, ConfigField::kMapCount, 3U);
    EXPECT_EQ(rig->Validated(2U), ConfigFault::kMapping);
    // and of a count above the four that exist those four are named, but not what lies behind them in the storage
    rig->Store(0U, ConfigField::kMapCount, 255U);
    EXPECT_EQ(rig->Validated(2U), ConfigFault::kMapping);
    EXPECT_EQ(rig->Map(2U, {0x62000108U, 0x62010108U}), ConfigFault::kNone);
    // and a length has nothing to do with it
    rig->Store(0U, ConfigField::kMapCount, 2U);
    rig->Store(0U, ConfigField::kMapEntry, 0x62010120U, 2U);
    EXPECT_EQ(rig->Validated(2U), ConfigFault::kMapping);
}

TEST(ChannelBSharedObject, DummiesAreNoObjects)
{
    Verifies(req::SRS_CFG_037);
    Verifies(req::SRS_CFG_033);
    const auto rig = std::make_unique<Rig>();
    rig->Config().dummies = DummyMapping::kAllowed;
    rig->Start();
    EXPECT_EQ(rig->Map(0U, {0x00050008U, 0x00050008U, 0x60000120U, 0x60010120U}), ConfigFault::kNone);
    EXPECT_EQ(rig->Map(2U, {0x00050008U, 0x00050008U, 0x62000108U, 0x62010108U}), ConfigFault::kNone);
}

TEST(ChannelBSharedObject, DummyIsNoObjectWhateverAnotherNames)
{
    Verifies(req::SRS_CFG_037);
    Verifies(req::SRS_CFG_033);
    // Given a lower slot with an entry of a dummy's index that has another length, and is none
    const auto rig = std::make_unique<Rig>();
    rig->Config().dummies = DummyMapping::kAllowed;
    rig->Start();
    rig->Store(0U, ConfigField::kMapEntry, 0x00050010U, 1U);
    // then the dummy of the higher slot is still not an object that both name
    EXPECT_EQ(rig->Map(2U, {0x00050008U, 0x00050008U, 0x62000108U, 0x62010108U}), ConfigFault::kNone);
}

TEST(ChannelBSharedObject, IndicesBehindTheDataTypesAreNoDummies)
{
    Verifies(req::SRS_CFG_033);
    const auto rig = std::make_unique<Rig>();
    rig->Config().dummies = DummyMapping::kAllowed;
    rig->Config().granularity_bits = 1U;
    rig->Start();
    EXPECT_EQ(rig->Map(0U, {0x00070020U, 0x00070020U, 0x60000120U, 0x60010120U}), ConfigFault::kNone);
    // Given entries of every length with an index behind 0007h, then none of them may be mapped
    for (std::uint32_t index = 8U; index < 0x200U; ++index)
    {
        for (std::uint32_t bits = 1U; bits <= 32U; ++bits)
        {
            const std::uint32_t entry = (index << 16U) | bits;
            ASSERT_EQ(rig->Map(0U, {entry, entry, 0x60000120U, 0x60010120U}), ConfigFault::kMapping)
                << index << " " << bits;
        }
    }
}

TEST(ChannelBSharedObject, StaticMappingsCountAsTheOthers)
{
    Verifies(req::SRS_CFG_037);
    Verifies(req::SRS_CFG_032);
    static constexpr std::uint32_t kEntries[] = {0x63000120U, 0x63010120U};
    const auto rig = std::make_unique<Rig>();
    rig->Setup(2U).map = StaticMap{kEntries, 2U};
    rig->Start();
    rig->Voice().SetFields(2U, rig->FreeFields());
    EXPECT_EQ(rig->Validated(2U), ConfigFault::kNone);
    EXPECT_EQ(rig->Map(0U, {0x63000120U, 0x60010120U}), ConfigFault::kNone);
    EXPECT_EQ(rig->Validated(2U), ConfigFault::kMapping);
    rig->Setup(2U).map = StaticMap{nullptr, 0U};
    rig->Setup(0U).map = StaticMap{kEntries, 2U};
    rig->Start();
    rig->Voice().SetFields(0U, rig->FreeFields());
    EXPECT_EQ(rig->Validated(0U), ConfigFault::kNone);
    EXPECT_EQ(rig->Map(2U, {0x60000120U, 0x63010120U}), ConfigFault::kMapping);
}

TEST(ChannelBStaticMapping, OfMoreThan128EntriesIsRefusedByTheirNumber)
{
    Verifies(req::SRS_CFG_026);
    Verifies(req::SRS_CFG_020);
    // Given objects of 8 bits one behind the other, registered, of which eight fill a frame
    conformance::StaticRow row;
    const auto storage = std::make_unique<channel_b::StorageFor<kMaxSrdoCount, kMaxMapEntries>>();
    channel_b::Channel channel{storage->Handle()};
    EXPECT_EQ(row.Validated(channel, 16U).fault, ConfigFault::kNone);
    // When 128 of them are mapped, then the number is none to find fault with, but the length
    const CheckResult most = row.Validated(channel, 128U);
    EXPECT_EQ(most.fault, ConfigFault::kLengthExceeded);
    // and two more are found before the length, and signed as 128
    const CheckResult more = row.Validated(channel, 130U);
    EXPECT_EQ(more.fault, ConfigFault::kMapping);
    EXPECT_EQ(more.signature, most.signature);
}

} // namespace
} // namespace counterpoint
