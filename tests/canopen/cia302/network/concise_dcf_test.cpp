// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/network/concise_dcf.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace counterpoint::cia302
{
namespace
{

using cia301::Bytes;
using Octets = std::vector<std::uint8_t>;

Bytes BytesOf(const Octets& octets)
{
    return Bytes{octets.data(), static_cast<std::uint32_t>(octets.size())};
}

/// 1017h:00 := 1000 in two bytes, then 2000h:03 := 7Fh in one.
const Octets kTwo{2U, 0U, 0U, 0U, 0x17U, 0x10U, 0U, 2U, 0U, 0U, 0U, 0xE8U, 3U, 0x00U, 0x20U, 3U, 1U, 0U, 0U, 0U, 0x7FU};

TEST(ConciseDcfTest, EntriesInTheirOrder)
{
    Verifies(req::SRS_BOOT_010);
    const ConciseReading first = ReadConcise(BytesOf(kTwo), ConcisePosition{0U, 0U});
    EXPECT_EQ(first.state, ConciseState::kEntry);
    EXPECT_EQ(first.object.index, 0x1017U);
    EXPECT_EQ(first.object.sub, 0U);
    ASSERT_EQ(first.value.size_bytes, 2U);
    EXPECT_EQ(first.value.data[0], 0xE8U);
    const ConciseReading second = ReadConcise(BytesOf(kTwo), first.next);
    EXPECT_EQ(second.state, ConciseState::kEntry);
    EXPECT_EQ(second.object.index, 0x2000U);
    EXPECT_EQ(second.object.sub, 3U);
    ASSERT_EQ(second.value.size_bytes, 1U);
    EXPECT_EQ(second.value.data[0], 0x7FU);
    EXPECT_EQ(second.next.entry, 2U);
    EXPECT_EQ(second.next.offset, 17U);
    EXPECT_EQ(ReadConcise(BytesOf(kTwo), second.next).state, ConciseState::kEnd);
    EXPECT_TRUE(IsConcise(BytesOf(kTwo)));
}

TEST(ConciseDcfTest, OneThatHoldsNothingIsWhole)
{
    Verifies(req::SRS_BOOT_010);
    const Octets none{0U, 0U, 0U, 0U};
    for (const Bytes& dcf : {Bytes{nullptr, 0U}, Bytes{nullptr, 4U}, Bytes{none.data(), 0U}, BytesOf(none)})
    {
        EXPECT_EQ(ReadConcise(dcf, ConcisePosition{0U, 0U}).state, ConciseState::kEnd);
        EXPECT_TRUE(IsConcise(dcf));
    }
}

TEST(ConciseDcfTest, OneOfMoreOrFewerBytesThanItsEntriesNeedIsMalformed)
{
    Verifies(req::SRS_BOOT_010);
    for (std::uint32_t length = 1U; length < 21U; ++length)
    {
        EXPECT_FALSE(IsConcise(Bytes{kTwo.data(), length})) << length;
    }
    Octets more = kTwo;
    more.push_back(0U);
    EXPECT_FALSE(IsConcise(BytesOf(more)));
    // A length that reaches beyond the end by one byte, or by as much as can be said
    Octets longer = kTwo;
    longer[16] = 2U;
    EXPECT_FALSE(IsConcise(BytesOf(longer)));
    longer[16] = 0xFFU;
    longer[17] = 0xFFU;
    longer[18] = 0xFFU;
    longer[19] = 0xFFU;
    EXPECT_FALSE(IsConcise(BytesOf(longer)));
    // Another count
    Octets one = kTwo;
    one[0] = 1U;
    EXPECT_FALSE(IsConcise(BytesOf(one)));
    one[0] = 3U;
    EXPECT_FALSE(IsConcise(BytesOf(one)));
}

TEST(ConciseDcfTest, APlaceBehindTheEndIsMalformed)
{
    Verifies(req::SRS_BOOT_010);
    EXPECT_EQ(ReadConcise(BytesOf(kTwo), ConcisePosition{1U, 17U}).state, ConciseState::kMalformed);
    EXPECT_EQ(ReadConcise(BytesOf(kTwo), ConcisePosition{1U, 18U}).state, ConciseState::kMalformed);
    EXPECT_EQ(ReadConcise(Bytes{kTwo.data(), 3U}, ConcisePosition{0U, 0U}).state, ConciseState::kMalformed);
}

} // namespace
} // namespace counterpoint::cia302
