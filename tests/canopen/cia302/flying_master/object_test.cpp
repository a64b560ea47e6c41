// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// 1F90h as the dictionary sees it.
#include "canopen/cia302/flying_master/times.hpp"
#include "verification/trace/ids/flying_master.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::cia302
{
namespace
{

using cia301::SdoAbort;

TEST(FlyingObject, Defaults)
{
    Verifies(req::SRS_FLY_014);
    FlyingMasterTimes times = DefaultTimes(NodeId{5U});
    const FlyingMasterObject object(times);
    const std::uint32_t expected[7] = {6U, 100U, 500U, 2U, 1500U, 10U, 4050U};
    for (std::uint8_t sub = 0U; sub <= 6U; ++sub)
    {
        EXPECT_EQ(object.Read(sub).abort, SdoAbort::kNone);
        EXPECT_EQ(object.Read(sub).value, expected[sub]);
        EXPECT_EQ(object.Read(sub).size_bytes, (sub == 0U) ? 1U : 2U);
    }
    EXPECT_EQ(object.Read(7U).abort, SdoAbort::kSubUnknown);
    EXPECT_EQ(DefaultTimes(NodeId{127U}).detection_cycle, 5270U);
}

TEST(FlyingObject, RangeOfEachSubIndex)
{
    Verifies(req::SRS_FLY_014);
    FlyingMasterTimes times = DefaultTimes(NodeId{5U});
    FlyingMasterObject object(times);
    for (const std::uint8_t sub :
         {std::uint8_t{1U}, std::uint8_t{2U}, std::uint8_t{4U}, std::uint8_t{5U}, std::uint8_t{6U}})
    {
        EXPECT_EQ(object.Write(sub, 0U), SdoAbort::kNone);
        EXPECT_EQ(object.Read(sub).value, 0U);
        EXPECT_EQ(object.Write(sub, 65535U), SdoAbort::kNone);
        EXPECT_EQ(object.Read(sub).value, 65535U);
        EXPECT_EQ(object.Write(sub, 65536U), SdoAbort::kValueRange);
    }
    EXPECT_EQ(object.Write(3U, 0U), SdoAbort::kNone);
    EXPECT_EQ(object.Write(3U, 2U), SdoAbort::kNone);
    EXPECT_EQ(object.Write(3U, 3U), SdoAbort::kValueRange);
    EXPECT_EQ(object.Write(3U, 0x100U), SdoAbort::kValueRange);
    EXPECT_EQ(object.Read(3U).value, 2U);
    EXPECT_EQ(object.Write(0U, 6U), SdoAbort::kReadOnly);
    EXPECT_EQ(object.Write(7U, 1U), SdoAbort::kSubUnknown);
}

TEST(FlyingObject, BytesOfTheDictionaryAreLittleEndian)
{
    Verifies(req::SRS_FLY_014);
    FlyingMasterTimes times = DefaultTimes(NodeId{5U});
    FlyingMasterObject object(times);
    const std::uint8_t value[2] = {0x34U, 0x12U};
    EXPECT_EQ(object.OnWrite(ObjectAddress{0x1F90U, 4U}, cia301::Bytes{value, 2U}), SdoAbort::kNone);
    EXPECT_EQ(times.priority_slot, 0x1234U);
    std::uint8_t room[2] = {0U, 0U};
    EXPECT_EQ(object.OnRead(ObjectAddress{0x1F90U, 4U}, cia301::Room{room, 2U}).size_bytes, 2U);
    EXPECT_EQ(room[0], 0x34U);
    EXPECT_EQ(room[1], 0x12U);
}

TEST(FlyingObject, WaitingAndSlotRelation)
{
    Verifies(req::SRS_FLY_008);
    Verifies(req::SRS_FLY_002);
    FlyingMasterTimes times = DefaultTimes(NodeId{127U});
    EXPECT_EQ(times.WaitingUs(NodeId{127U}), 4'270'000U); // 2 x 1500 + 127 x 10 ms.
    times.priority = 0U;
    EXPECT_EQ(times.WaitingUs(NodeId{1U}), 10'000U);
    EXPECT_TRUE(IsUsable(times));
    times.priority_slot = 1270U;
    EXPECT_FALSE(IsUsable(times));
    times.priority_slot = 1271U;
    EXPECT_TRUE(IsUsable(times));
    // The greatest values that may be: no overflow of the counter of time.
    times = FlyingMasterTimes{65535U, 65535U, 2U, 65535U, 516U, 65535U};
    EXPECT_TRUE(IsUsable(times));
    EXPECT_EQ(times.WaitingUs(NodeId{127U}), 196'602'000U);
}

} // namespace
} // namespace counterpoint::cia302
