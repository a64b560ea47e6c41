// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A store over a generated table: what it keeps, and what of it follows the node-ID.
#include "canopen/cia301/store/stored_parts.hpp"
#include "canopen/generated/node_values.hpp"
#include "tests/canopen/cia301/service_rig.hpp"
#include "tests/canopen/generate/generated_case.hpp"
#include "verification/trace/ids/generate.hpp"
#include "verification/trace/ids/store.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace counterpoint::generate
{
namespace
{
using cia301::Bytes;
using cia301::Room;
using test::GeneratedCase;
using test::GeneratedCases;
using Octets = std::vector<std::uint8_t>;

const GeneratedCase& CaseOf(const std::string& name)
{
    const auto& cases = GeneratedCases();
    return *std::find_if(cases.begin(), cases.end(), [&name](const GeneratedCase& each) { return each.name == name; });
}

/// The store of a device that is made of generated code, with the sets in a list.
class SavedValues : public cia301::ServiceRig
{
  protected:
    static std::vector<Octets> Save(cia301::StoredPart& part)
    {
        std::vector<Octets> items;
        std::array<std::uint8_t, 1024U> room{};
        const std::uint32_t count = part.ItemCount();
        for (std::uint32_t number = 0U; number < count; ++number)
        {
            const cia301::StoredItem item = part.Item(number, Room{room.data(), 1024U});
            EXPECT_EQ(item.abort, cia301::SdoAbort::kNone) << number;
            if (item.group != 0U)
            {
                items.emplace_back(room.begin(), room.begin() + item.size_bytes);
            }
        }
        return items;
    }
    static void Load(cia301::StoredPart& part, const std::vector<Octets>& items)
    {
        part.BeginLoad(cia301::kAllGroups);
        for (const Octets& item : items)
        {
            EXPECT_TRUE(part.LoadItem(Bytes{item.data(), static_cast<std::uint32_t>(item.size())}));
        }
        EXPECT_TRUE(part.EndLoad(cia301::kAllGroups));
    }
};

TEST_F(SavedValues, WhatCanBeWrittenAndReadIsMarkedForASave)
{
    Verifies(req::SRS_GEN_330);
    std::size_t saved = 0U;
    for (const GeneratedCase& generated : GeneratedCases())
    {
        for (std::uint32_t place = 0U; place < generated.table->count; ++place)
        {
            // Given each entry, when it is rw in the file and a number or string of its own, then it is saved
            const cia301::Entry& entry = generated.table->entries[place];
            const bool is_rw = entry.access == cia301::Access::kReadWrite;
            const bool is_left_out = entry.index == 0x1003U || entry.index == 0x1010U || entry.index == 0x1011U ||
                                     (entry.index >= 0x5F00U && entry.index <= 0x5F05U) || entry.place == nullptr;
            if (entry.access == cia301::Access::kInvalid)
            {
                continue; // The file does not tell.
            }
            EXPECT_EQ((entry.uses & cia301::kStored) != 0U, is_rw && !is_left_out)
                << generated.name << std::hex << " " << entry.index << ":" << int{entry.sub};
            saved += (entry.uses & cia301::kStored) != 0U ? 1U : 0U;
        }
    }
    EXPECT_GE(saved, 100U);
}

TEST_F(SavedValues, TheBusCommandsASaveInPreOperationalAlone)
{
    Verifies(req::SRS_STO_008);
    for (const GeneratedCase& generated : GeneratedCases())
    {
        for (std::uint32_t place = 0U; place < generated.table->count; ++place)
        {
            const cia301::Entry& entry = generated.table->entries[place];
            const bool is_command = entry.index == 0x1010U || entry.index == 0x1011U;
            EXPECT_EQ(entry.writable_in, is_command ? 1U : 3U) << generated.name << std::hex << " " << entry.index;
            EXPECT_EQ(entry.readable_in, 3U) << generated.name << std::hex << " " << entry.index;
        }
    }
    // Given a file with both, when the device is OPERATIONAL
    cia301::Dictionary table{*CaseOf("everything").table, foreign};
    table.SetNmtState(NmtState::kOperational);
    std::array<std::uint8_t, 4U> value{};
    for (const ObjectAddress object : {ObjectAddress{0x1010U, 1U}, ObjectAddress{0x1011U, 1U}})
    {
        EXPECT_EQ(table.MayWrite(object, 4U), cia301::SdoAbort::kDeviceState);
        EXPECT_EQ(table.Write(object, Bytes{value.data(), 4U}), cia301::SdoAbort::kDeviceState);
        EXPECT_EQ(table.Read(object, Room{value.data(), 4U}).abort, cia301::SdoAbort::kNone);
    }
    EXPECT_EQ(table.MayWrite({0x1017U, 0U}, 2U), cia301::SdoAbort::kNone);
    table.SetNmtState(NmtState::kPreOperational);
    EXPECT_EQ(table.MayWrite({0x1010U, 1U}, 4U), cia301::SdoAbort::kNone);
    EXPECT_EQ(table.MayWrite({0x1011U, 1U}, 4U), cia301::SdoAbort::kNone);
}

// Given 1800h:01 = $NODEID+384 and 1801h:01 = 640 + $NODEID.
TEST_F(SavedValues, AValueOfTheNodeIdFollowsItAndAChangedOneStays)
{
    Verifies(req::SRS_GEN_331);
    const GeneratedCase& generated = CaseOf("data_unusual");
    cia301::Dictionary table{*generated.table, foreign};
    table.SetNmtState(NmtState::kPreOperational);
    cia301::StoredEntries part{*generated.table, table, tpdos, rpdos, generated.defaults_of_node()};
    generated.apply_node_id(5U);
    generated.reset();
    EXPECT_EQ(generated.node_now().value, 5U);
    ASSERT_EQ(table.ReadNumber({0x1800U, 1U}).value, 0x185U);
    ASSERT_EQ(table.ReadNumber({0x1801U, 1U}).value, 0x285U);
    // When it is saved as node 5, one of them changed by somebody
    EXPECT_EQ(table.WriteNumber({0x1801U, 1U}, 0x2A5U, 4U), cia301::SdoAbort::kNone);
    const std::vector<Octets> items = Save(part);
    // And the device starts again as node 9
    generated.apply_node_id(9U);
    generated.reset();
    Load(part, items);
    // Then the other one is that of node 9
    EXPECT_EQ(table.ReadNumber({0x1800U, 1U}).value, 0x189U);
    EXPECT_EQ(table.ReadNumber({0x1801U, 1U}).value, 0x2A5U);
    EXPECT_EQ(generated.node_now().value, 9U);
    generated.apply_node_id(generated.node_id);
    generated.reset();
    EXPECT_EQ(generated.node_now().value, generated.node_id);
}

TEST(NodeValues, AreTheAddendAndTheNodeIdOfNow)
{
    Verifies(req::SRS_GEN_331);
    // Given the third entry with 80h + node-ID, and the fifth with a number of 8 bytes
    constexpr generated::NodeValue values[2U] = {{2U, 0x80U}, {4U, 0x1122334455667700U}};
    cia301::NodeId node{5U};
    const generated::NodeValues defaults{generated::NodeValueTable{values, 2U}, node};
    const auto is_default = [&defaults](const std::uint32_t number, const Octets& value)
    { return defaults.IsNodeDefault(number, Bytes{value.data(), static_cast<std::uint32_t>(value.size())}); };
    EXPECT_TRUE(is_default(2U, {0x85U, 0U, 0U, 0U}));
    EXPECT_TRUE(is_default(2U, {0x85U}));
    EXPECT_FALSE(is_default(2U, {0x86U, 0U, 0U, 0U}));
    EXPECT_FALSE(is_default(2U, {0x85U, 0U, 0U, 1U}));
    EXPECT_FALSE(is_default(2U, {}));
    EXPECT_FALSE(is_default(3U, {0x85U, 0U, 0U, 0U}));
    EXPECT_TRUE(is_default(4U, {0x05U, 0x77U, 0x66U, 0x55U, 0x44U, 0x33U, 0x22U, 0x11U}));
    EXPECT_FALSE(is_default(4U, {0x05U, 0x77U, 0x66U, 0x55U, 0x44U, 0x33U, 0x22U, 0x11U, 0U}));
    // When the node-ID is another one
    node.value = 6U;
    EXPECT_FALSE(is_default(2U, {0x85U, 0U, 0U, 0U}));
    EXPECT_TRUE(is_default(2U, {0x86U, 0U, 0U, 0U}));
    // A file without such values
    const generated::NodeValues none{generated::NodeValueTable{nullptr, 0U}, node};
    const std::uint8_t byte = 6U;
    EXPECT_FALSE(none.IsNodeDefault(0U, Bytes{&byte, 1U}));
}
} // namespace
} // namespace counterpoint::generate
