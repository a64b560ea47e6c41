// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the storage of channel A has room for.
#include "channel_a/channel.hpp"
#include "channel_a/storage.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace counterpoint
{
namespace
{

template <std::uint8_t kSlots, std::uint8_t kEntries> ChannelRoom RoomOf()
{
    const auto storage = std::make_unique<channel_a::StorageFor<kSlots, kEntries>>();
    const channel_a::Channel channel{storage->Handle()};
    return channel.Room();
}

TEST(ChannelAStorage, TellsSlotsAndEntries)
{
    Verifies(req::SRS_KRN_020);
    // Given storage of several sizes, then Room tells each
    EXPECT_EQ((RoomOf<1U, 16U>().slots), 1U);
    EXPECT_EQ((RoomOf<1U, 16U>().map_entries), 16U);
    EXPECT_EQ((RoomOf<64U, 128U>().slots), 64U);
    EXPECT_EQ((RoomOf<64U, 128U>().map_entries), 128U);
    EXPECT_EQ((RoomOf<2U, 0U>().slots), 2U);
    EXPECT_EQ((RoomOf<2U, 0U>().map_entries), 0U);
    EXPECT_EQ((RoomOf<3U, 2U>().slots), 3U);
    EXPECT_EQ((RoomOf<3U, 2U>().map_entries), 2U);
    EXPECT_EQ((RoomOf<63U, 126U>().slots), 63U);
    EXPECT_EQ((RoomOf<63U, 126U>().map_entries), 126U);
}

TEST(ChannelAStorage, IsForSixteenEntriesUnlessToldOtherwise)
{
    Verifies(req::SRS_KRN_020);
    const auto storage = std::make_unique<channel_a::StorageFor<2U>>();
    const channel_a::Channel channel{storage->Handle()};
    EXPECT_EQ(channel.Room().slots, 2U);
    EXPECT_EQ(channel.Room().map_entries, 16U);
}

TEST(ChannelAStorage, OfADeviceWithoutDynamicEntriesTakesNoneOfItsOwn)
{
    Verifies(req::SRS_CFG_032);
    // Given storage for static mappings alone, then it is smaller by what the entries take
    EXPECT_LT(sizeof(channel_a::StorageFor<8U, 0U>), sizeof(channel_a::StorageFor<8U, 16U>));
    EXPECT_GE(sizeof(channel_a::StorageFor<8U, 16U>) - sizeof(channel_a::StorageFor<8U, 0U>), (8U * 16U * 4U) - 4U);
}

TEST(ChannelAStorage, OfSlotsThatTheDeviceDoesNotHaveIsLeftAlone)
{
    Verifies(req::SRS_CFG_002);
    // Given room for three SRDOs with two entries each, full of anything, and a device with two
    channel_a::StorageFor<3U, 2U> storage{};
    storage.records[2].error_count = 0xC3C3U;
    storage.counts[2] = 0xC3U;
    for (std::uint32_t& entry : storage.entries)
    {
        entry = 0xC3C3C3C3U;
    }
    const SrdoSetup setups[2] = {
        {1U, ReleasePolicy::kInterlock, ProducerForm::kApplicationSends, Payload{}, SrvtDetection::kEarly, StaticMap{}},
        {2U, ReleasePolicy::kInterlock, ProducerForm::kApplicationSends, Payload{}, SrvtDetection::kEarly,
         StaticMap{}}};
    DeviceConfig config{};
    config.srdos = setups;
    config.srdo_count = 2U;
    config.node_id = 1U;
    config.map_entries = 2U;
    channel_a::Channel channel{storage.Handle()};
    // When the channel starts
    channel.Restart(config);
    // Then the entries of both are 0, and nothing of the third is touched
    EXPECT_EQ(storage.entries[0], 0U);
    EXPECT_EQ(storage.entries[3], 0U);
    EXPECT_EQ(storage.entries[4], 0xC3C3C3C3U);
    EXPECT_EQ(storage.entries[5], 0xC3C3C3C3U);
    EXPECT_EQ(storage.records[2].error_count, 0xC3C3U);
    EXPECT_EQ(storage.counts[2], 0xC3U);
}

TEST(ChannelAStorage, HasAsManyEntriesAndStepsAsAreNeeded)
{
    Verifies(req::SRS_KRN_020);
    // Given storage of several sizes, then each pair of entries has a step, and there is one of each at least
    EXPECT_EQ((channel_a::StorageFor<3U, 2U>::kEntryCount), 6U);
    EXPECT_EQ((channel_a::StorageFor<3U, 2U>::kStepCount), 3U);
    EXPECT_EQ((channel_a::StorageFor<64U, 128U>::kEntryCount), 8192U);
    EXPECT_EQ((channel_a::StorageFor<64U, 128U>::kStepCount), 4096U);
    EXPECT_EQ((channel_a::StorageFor<2U, 0U>::kEntryCount), 1U);
    EXPECT_EQ((channel_a::StorageFor<2U, 0U>::kStepCount), 1U);
}

TEST(ChannelAStorage, HandsOverEachPartFromItsBeginning)
{
    Verifies(req::SRS_KRN_020);
    const auto storage = std::make_unique<channel_a::StorageFor<2U>>();
    const channel_a::Storage handle = storage->Handle();
    EXPECT_EQ(handle.records, &storage->records[0]);
    EXPECT_EQ(handle.counts, &storage->counts[0]);
    EXPECT_EQ(handle.entries, &storage->entries[0]);
    EXPECT_EQ(handle.steps, &storage->steps[0]);
    EXPECT_EQ(handle.look_up, &storage->look_up[0]);
}

} // namespace
} // namespace counterpoint
