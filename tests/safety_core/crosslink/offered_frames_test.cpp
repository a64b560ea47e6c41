// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/crosslink/offered_frames.hpp"

#include "verification/trace/ids/crosslink.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace counterpoint
{
namespace
{

struct Guarded
{
    OfferedFrames frames;
    std::array<std::uint8_t, 64> behind;
};

// place    0          1
// slot     5          63     then 9 and none: what stood there before is offered no more
TEST(OfferedFrames, AMessageFillsBothPlacesAndNothingBehindThem)
{
    Verifies(req::SRS_TWO_214);
    Guarded guarded{};
    guarded.behind.fill(0xA5U);
    guarded.frames.Restart();
    LinkMessage message{};
    message.armed[0].slot = 5U;
    message.armed[0].number = 1U;
    message.armed[1].slot = 63U;
    message.armed[1].number = 2U;
    guarded.frames.Take(message);
    EXPECT_EQ(guarded.frames.Due(), 0x8000000000000020U);
    guarded.frames.GiveUp(63U, SrdoCause::kSrvt);

    message.armed[0].slot = 9U;
    message.armed[0].number = 3U;
    message.armed[1].slot = kNoSlot;
    guarded.frames.Take(message);

    EXPECT_EQ(guarded.frames.Due(), 0x200U);
    // What was refused is told until another one is
    EXPECT_EQ(guarded.frames.Refused().number, 2U);
    EXPECT_EQ(guarded.frames.Refused().cause, SrdoCause::kSrvt);
    EXPECT_TRUE(
        std::all_of(guarded.behind.begin(), guarded.behind.end(), [](const auto byte) { return byte == 0xA5U; }));
}

} // namespace
} // namespace counterpoint
