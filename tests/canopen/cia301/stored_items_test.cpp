// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Items of a set as a part gives and takes them one by one, those among them that no store would hand over.
#include "canopen/cia301/store/stored_parts.hpp"
#include "tests/canopen/cia301/cut_memory.hpp"
#include "tests/canopen/cia301/service_rig.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/store.hpp"

#include <vector>

namespace counterpoint::cia301
{
namespace
{

using StoredEntriesTest = ServiceRig;

TEST_F(StoredEntriesTest, EachEntryIsInTheGroupOfItsIndex)
{
    Verifies(req::SRS_STO_011);
    const std::pair<std::uint16_t, std::uint8_t> groups[] = {
        {std::uint16_t{0x0FFFU}, std::uint8_t{0U}}, {std::uint16_t{0x1000U}, std::uint8_t{1U}},
        {std::uint16_t{0x1FFFU}, std::uint8_t{1U}}, {std::uint16_t{0x2000U}, std::uint8_t{4U}},
        {std::uint16_t{0x5FFFU}, std::uint8_t{4U}}, {std::uint16_t{0x6000U}, std::uint8_t{2U}},
        {std::uint16_t{0x9FFFU}, std::uint8_t{2U}}, {std::uint16_t{0xA000U}, std::uint8_t{0U}}};
    std::array<std::uint8_t, 16> room{};
    for (const auto& [index, group] : groups)
    {
        Entry entry = entries[0];
        entry.index = index;
        entry.uses = kStored;
        StoredEntries stored{EntryTable{&entry, 1U}, dictionary, tpdos, rpdos};
        const StoredItem item = stored.Item(0U, Room{room.data(), 16U});
        EXPECT_EQ(item.abort, SdoAbort::kNone);
        EXPECT_EQ(item.group, group) << std::hex << index;
        EXPECT_EQ(item.size_bytes, 4U);
        EXPECT_EQ(room[3], 0x11U);
    }
}

TEST_F(StoredEntriesTest, AnItemTooShortForAnAddressIsNone)
{
    Verifies(req::SRS_STO_007);
    std::array<Entry, 1> table{entries[0]};
    table[0].uses = kStored;
    const EntryTable own{table.data(), 1U};
    Dictionary own_dictionary{own, foreign};
    StoredEntries stored{own, own_dictionary, tpdos, rpdos};
    const std::uint8_t item[4] = {0x00U, 0x21U, 0U, 0x42U};
    EXPECT_FALSE(stored.LoadItem(Bytes{item, 2U}));
    EXPECT_FALSE(stored.LoadItem(Bytes{item, 3U})); // No value.
    EXPECT_EQ(u8[0], 0x11U);
    EXPECT_TRUE(stored.LoadItem(Bytes{item, 4U}));
    EXPECT_EQ(u8[0], 0x42U);
    // Where its groups are lost it keeps what it has
    stored.Lose(kAllGroups);
    EXPECT_EQ(u8[0], 0x42U);
}

TEST_F(StoredEntriesTest, SettingsOfLssLeaveThePdosAsTheyAre)
{
    Verifies(req::SRS_STO_007);
    UseTpdo(254U);
    Cycle();
    sink.frames.clear();
    StoredEntries stored{EntryTable{entries.data(), 10U}, dictionary, tpdos, rpdos};
    stored.BeginLoad(kLssGroup);
    EXPECT_TRUE(stored.EndLoad(kLssGroup));
    Cycle();
    EXPECT_TRUE(sink.frames.empty()); // Else it would be sent as on becoming valid.
    stored.BeginLoad(kAllGroups);
    EXPECT_TRUE(stored.EndLoad(kAllGroups));
    Cycle();
    EXPECT_EQ(sink.frames.size(), 1U);
}

/// 11h in the first entry is the default of the node-ID.
struct FirstIsOfNode final : public NodeDefaults
{
    [[nodiscard]] bool IsNodeDefault(const std::uint32_t number, const Bytes& value) const noexcept override
    {
        return (number == 0U) && (value.size_bytes == 1U) && (value.data[0] == 0x11U);
    }
};

TEST_F(StoredEntriesTest, ADefaultOfTheNodeIdIsNotKept)
{
    Verifies(req::SRS_STO_240);
    // Given two entries with 11h, of which the first one's is that of the node-ID
    std::array<Entry, 2> table{entries[0], entries[0]};
    table[0].uses = kStored;
    table[1].uses = kStored;
    table[1].index = static_cast<std::uint16_t>(entries[0].index + 1U);
    const FirstIsOfNode defaults{};
    std::array<std::uint8_t, 16> room{};
    const Room out{room.data(), 16U};
    StoredEntries stored{EntryTable{table.data(), 2U}, dictionary, tpdos, rpdos, defaults};
    EXPECT_EQ(stored.Item(0U, out).group, 0U);
    EXPECT_EQ(stored.Item(1U, out).group, kManufacturerGroup);
    // A value that somebody gave it is kept, and without such knowledge every value is
    u8[0] = 0x12U;
    EXPECT_EQ(stored.Item(0U, out).group, kManufacturerGroup);
    u8[0] = 0x11U;
    StoredEntries plain{EntryTable{table.data(), 2U}, dictionary, tpdos, rpdos};
    EXPECT_EQ(plain.Item(0U, out).group, kManufacturerGroup);
    // One that cannot be read is an error, whatever it is the default of
    table[0].size_bytes = 2U;
    const StoredItem unread = stored.Item(0U, Room{room.data(), 4U});
    EXPECT_NE(unread.abort, SdoAbort::kNone);
    EXPECT_EQ(unread.group, kManufacturerGroup);
}

using StoredSafetyItemsTest = Rig;

// Saved with node-ID 5
TEST_F(StoredSafetyItemsTest, TheConfigurationOfAnotherNodeIdIsRefused)
{
    Verifies(req::SRS_STO_241);
    Configure();
    std::array<std::uint8_t, 64> scratch{};
    NodeId node{5U};
    StoredSafety safety{kernel, node};
    std::vector<std::vector<std::uint8_t>> items;
    const std::uint32_t count = safety.ItemCount();
    for (std::uint32_t i = 0U; i < count; ++i)
    {
        const StoredItem item = safety.Item(i, Room{scratch.data(), 64U});
        items.emplace_back(scratch.begin(), scratch.begin() + item.size_bytes);
    }
    ASSERT_EQ(items[0].size(), 11U);
    EXPECT_EQ(items[0][10], 5U);
    const auto load = [&items](StoredPart& part)
    {
        part.BeginLoad(kAllGroups);
        for (const std::vector<std::uint8_t>& item : items)
        {
            EXPECT_TRUE(part.LoadItem({item.data(), static_cast<std::uint32_t>(item.size())}));
        }
        return part.EndLoad(kAllGroups);
    };
    EXPECT_TRUE(load(safety));
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    // When the node-ID is another one
    node.value = 9U;
    EXPECT_FALSE(load(safety));
    // Then the power-on configuration holds: SRDO 1 is off
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
    EXPECT_EQ(Read(0x1301U, 1U), 0U);
    // With the old one it is back
    node.value = 5U;
    EXPECT_TRUE(load(safety));
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    // A part that knows no node-ID takes it, and one that knows its own takes a set that tells none
    StoredSafety plain{kernel};
    EXPECT_TRUE(load(plain));
    items[0].pop_back();
    EXPECT_TRUE(load(safety));
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    // Where nothing was loaded nothing changes
    safety.BeginLoad(kAllGroups);
    EXPECT_TRUE(safety.EndLoad(kAllGroups));
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
}

TEST_F(StoredSafetyItemsTest, TheReportOfALoadTellsOfAnotherNodeId)
{
    Verifies(req::SRS_STO_241);
    Configure();
    std::array<std::uint8_t, 64> scratch{};
    CutMemory memory{8192U};
    NodeId node{5U};
    StoredSafety safety{kernel, node};
    std::array<StoredPart*, 1> parts{&safety};
    ParameterStore store{StoreParts{memory, parts.data(), 1U, Room{scratch.data(), 64U}}};
    const StoreRequest save{StoreAction::kSave, kAllGroups};
    EXPECT_EQ(store.Begin(save), SdoAbort::kPending);
    for (int i = 0; (i < 3000) && store.IsBusy(); ++i)
    {
        store.OnCycle();
    }
    EXPECT_EQ(store.Continue(save), SdoAbort::kNone);
    EXPECT_EQ(store.Load(kCommunicationGroup).finding, StoreFinding::kSound);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    node.value = 9U;
    EXPECT_EQ(store.Load(kCommunicationGroup).finding, StoreFinding::kRefused);
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
}

// Given a kernel that holds what was saved, so that the header fits it whatever was refused of the set.
TEST_F(StoredSafetyItemsTest, ASetOfWhichAnItemIsRefusedIsRefused)
{
    Verifies(req::SRS_STO_450);
    using Item = std::vector<std::uint8_t>;
    std::array<std::uint8_t, 64> scratch{};
    Configure();
    StoredSafety safety{kernel};
    std::vector<Item> items;
    const std::uint32_t count = safety.ItemCount();
    for (std::uint32_t i = 0U; i < count; ++i)
    {
        const StoredItem item = safety.Item(i, Room{scratch.data(), 64U});
        items.emplace_back(scratch.begin(), scratch.begin() + item.size_bytes);
    }
    Item wide = items[1];
    wide[10] = 1U; // The second value is a direction, one byte and three zeros.
    const Item beyond{1U, 0xFFU, 0xFFU, 0xFFU, 0x7FU, 1U, 0U, 0U, 0U};
    const Item unknown{2U, 1U, 0U, 0U, 0U, 9U, 9U, 9U, 9U, 0xA5U, 5U}; // As long as a header.
    for (const Item& bad : {wide, beyond, unknown, Item{}})
    {
        for (const std::size_t place : {std::size_t{0U}, std::size_t{1U}, items.size()})
        {
            // When it comes in front of the rest, behind the header, or last
            safety.BeginLoad(kAllGroups);
            for (std::size_t i = 0U; i <= items.size(); ++i)
            {
                if (i == place)
                {
                    EXPECT_FALSE(safety.LoadItem({bad.data(), static_cast<std::uint32_t>(bad.size())}));
                }
                if (i < items.size())
                {
                    EXPECT_TRUE(safety.LoadItem({items[i].data(), static_cast<std::uint32_t>(items[i].size())}));
                }
            }
            // Then the power-on configuration holds: SRDO 1 is off
            EXPECT_FALSE(safety.EndLoad(kAllGroups)) << bad.size() << ", " << place;
            EXPECT_EQ(Read(0x13FEU, 0U), 0U) << bad.size() << ", " << place;
            EXPECT_EQ(Read(0x1301U, 1U), 0U) << bad.size() << ", " << place;
            // The next load knows nothing of it
            safety.BeginLoad(kAllGroups);
            for (const Item& item : items)
            {
                EXPECT_TRUE(safety.LoadItem({item.data(), static_cast<std::uint32_t>(item.size())}));
            }
            EXPECT_TRUE(safety.EndLoad(kAllGroups));
            EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
        }
    }
}

// Given values that are refused and no header, then nobody knows what was saved.
TEST_F(StoredSafetyItemsTest, ARefusedItemWithoutAHeaderLeavesNoValidConfiguration)
{
    Verifies(req::SRS_STO_450);
    Configure();
    StoredSafety safety{kernel};
    safety.BeginLoad(kAllGroups);
    const std::uint8_t other[11] = {2U, 1U, 0U, 0U, 0U, 9U, 9U, 9U, 9U, 0xA5U, 5U};
    EXPECT_FALSE(safety.LoadItem({other, 11U}));
    EXPECT_FALSE(safety.EndLoad(kAllGroups));
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
}

TEST_F(StoredSafetyItemsTest, WithoutRoomForAnItemNoneIsGiven)
{
    Verifies(req::SRS_STO_012);
    Configure();
    std::array<std::uint8_t, 64> scratch{};
    StoredSafety safety{kernel};
    ASSERT_GT(safety.ItemCount(), 1U);
    EXPECT_EQ(safety.Item(0U, Room{scratch.data(), 52U}).abort, SdoAbort::kOutOfMemory);
    EXPECT_EQ(safety.Item(1U, Room{scratch.data(), 52U}).abort, SdoAbort::kOutOfMemory);
    EXPECT_EQ(safety.Item(0U, Room{scratch.data(), 53U}).abort, SdoAbort::kNone);
    EXPECT_EQ(safety.Item(1U, Room{scratch.data(), 53U}).abort, SdoAbort::kNone);
}

TEST_F(StoredSafetyItemsTest, ItemsThatAreNoneOrBeyondTheEndAreRefused)
{
    Verifies(req::SRS_STO_007);
    Configure();
    StoredSafety safety{kernel};
    safety.BeginLoad(kAllGroups);
    // Neither a header nor a value, of the length of each
    const std::uint8_t other[10] = {2U, 1U, 0U, 0U, 0U, 9U, 9U, 9U, 9U, 0xA5U};
    EXPECT_FALSE(safety.LoadItem({other, 10U}));
    EXPECT_FALSE(safety.LoadItem({other, 9U}));
    // Two values from a place that there is not
    const std::uint8_t beyond[13] = {1U, 0xFFU, 0xFFU, 0xFFU, 0x7FU, 1U, 0U, 0U, 0U, 2U, 0U, 0U, 0U};
    EXPECT_FALSE(safety.LoadItem({beyond, 13U}));
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    // A place that turns over to the first ones is refused, and what came there is not valid
    const std::uint8_t over[13] = {1U, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 1U, 0U, 0U, 0U, 2U, 0U, 0U, 0U};
    EXPECT_FALSE(safety.LoadItem({over, 13U}));
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
}

TEST_F(StoredSafetyItemsTest, AnotherValidityThanThatOfTheFirstItemIsAChange)
{
    Verifies(req::SRS_STO_019);
    Configure();
    std::array<std::uint8_t, 64> scratch{};
    StoredSafety safety{kernel};
    // Before anything was read there is nothing to compare
    EXPECT_EQ(safety.EndSave(kAllGroups), SdoAbort::kNone);
    const std::uint32_t count = safety.ItemCount();
    for (std::uint32_t i = 0U; i < count; ++i)
    {
        EXPECT_EQ(safety.Item(i, Room{scratch.data(), 64U}).abort, SdoAbort::kNone);
    }
    EXPECT_EQ(safety.EndSave(kAllGroups), SdoAbort::kNone);
    // When 13FEh alone is another one, the values being the same
    EXPECT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
    EXPECT_EQ(safety.EndSave(kAllGroups), SdoAbort::kDeviceState);
    EXPECT_EQ(safety.EndSave(kApplicationGroup), SdoAbort::kNone); // It is not in there.
}

} // namespace
} // namespace counterpoint::cia301
