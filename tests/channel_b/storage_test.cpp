// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the storage of channel B has room for.
#include "channel_b/channel.hpp"
#include "channel_b/storage.hpp"
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
    const auto storage = std::make_unique<channel_b::StorageFor<kSlots, kEntries>>();
    const channel_b::Channel channel{storage->Handle()};
    return channel.Room();
}

TEST(ChannelBStorage, TellsSlotsAndEntries)
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

TEST(ChannelBStorage, IsForSixteenEntriesUnlessToldOtherwise)
{
    Verifies(req::SRS_KRN_020);
    const auto storage = std::make_unique<channel_b::StorageFor<2U>>();
    const channel_b::Channel channel{storage->Handle()};
    EXPECT_EQ(channel.Room().slots, 2U);
    EXPECT_EQ(channel.Room().map_entries, 16U);
}

TEST(ChannelBStorage, OfADeviceWithoutDynamicEntriesTakesNoneOfItsOwn)
{
    Verifies(req::SRS_CFG_032);
    // Given storage for static mappings alone, then it is smaller by what the entries take
    EXPECT_LT(sizeof(channel_b::StorageFor<8U, 0U>), sizeof(channel_b::StorageFor<8U, 16U>));
    EXPECT_GE(sizeof(channel_b::StorageFor<8U, 16U>) - sizeof(channel_b::StorageFor<8U, 0U>), (8U * 16U * 4U) - 4U);
}

} // namespace
} // namespace counterpoint
