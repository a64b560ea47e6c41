// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// One watch by itself: 101h and 102h, SCT 50 ms, SRVT 20 ms.
#include "canopen/monitor/srdo_watch.hpp"
#include "tests/canopen/monitor/recordings.hpp"
#include "verification/trace/ids/monitor.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::monitor
{
namespace
{
using test::Frame;
using Texts = std::vector<std::string>;

class Told final : public BreachSink
{
  public:
    void OnBreach(std::size_t /*watch*/, const Breach& breach) override
    {
        texts.push_back(std::to_string(breach.time / kMicrosecond) + " " + CauseName(breach.cause) + ": " +
                        breach.details);
    }
    Texts texts;
};

Texts After(const std::uint32_t bits, const bool is_late, const std::vector<LogFrame>& frames)
{
    Told told;
    SrdoWatch watch(0U, {0x101U, 0x102U, bits, 50 * kMillisecond, 20 * kMillisecond, is_late}, told);
    for (const LogFrame& frame : frames)
    {
        watch.OnFrame(frame);
    }
    return told.texts;
}

// Bits above those that are mapped are 0 in the normal frame and 1 in the inverse one.
TEST(BitsThatAreNotMapped, AreFixed)
{
    Verifies(req::SRS_MON_005);
    const auto pair = [](const std::uint8_t normal, const std::uint8_t inverse)
    { return std::vector<LogFrame>{Frame(0, 0x101U, {normal}), Frame(100, 0x102U, {inverse})}; };
    EXPECT_EQ(After(4U, false, pair(0x0FU, 0xF0U)), Texts{});
    EXPECT_EQ(After(4U, false, pair(0x05U, 0xFAU)), Texts{});
    EXPECT_EQ(After(4U, false, pair(0x15U, 0xEAU)), Texts{"100 not inverse: bit 4: normal 15, inverse EA"});
    EXPECT_EQ(After(4U, false, pair(0x05U, 0xEAU)), Texts{"100 not inverse: bit 4: normal 05, inverse EA"});
    EXPECT_EQ(After(5U, false, pair(0x15U, 0xEAU)), Texts{});
}

// Late detection: where SCT is over before the inverse frame comes, it is SCT that is told, at its time.
TEST(LateDetection, TellsTheLimitThatIsOverFirst)
{
    Verifies(req::SRS_MON_007);
    const auto frames = [](const Time normal_us, const Time inverse_us)
    {
        return std::vector<LogFrame>{Frame(0, 0x101U, {1U}), Frame(100, 0x102U, {0xFEU}),
                                     Frame(normal_us, 0x101U, {1U}), Frame(inverse_us, 0x102U, {0xFEU})};
    };
    EXPECT_EQ(After(8U, true, frames(25000, 45000)), Texts{});
    EXPECT_EQ(After(8U, true, frames(25000, 45001)),
              Texts{"45001 SRVT expired: inverse frame 20.001 ms after the normal frame, limit 20 ms"});
    EXPECT_EQ(After(8U, true, frames(29000, 50000)),
              Texts{"50000 SRVT expired: inverse frame 21 ms after the normal frame, limit 20 ms"});
    EXPECT_EQ(After(8U, true, frames(29000, 50001)),
              Texts{"50000 SCT expired: no pair within 50 ms after the normal frame at 0.000000"});
}

// Given an inverse frame that comes first, when a normal frame of another length follows, then it is wrong by itself.
TEST(FramesThatChangedPlaces, AreOfOneLength)
{
    Verifies(req::SRS_MON_340);
    EXPECT_EQ(After(8U, false, {Frame(0, 0x102U, {0xFEU}), Frame(100, 0x101U, {1U})}),
              Texts{"0 inverse first: no normal frame before it"});
    EXPECT_EQ(
        After(8U, false, {Frame(0, 0x102U, {0xFEU}), Frame(100, 0x101U, {1U, 0U})}),
        (Texts{"0 inverse first: no normal frame before it", "100 wrong length: normal frame of 2 bytes, expected 1 "
                                                             "byte"}));
}
} // namespace
} // namespace counterpoint::monitor
