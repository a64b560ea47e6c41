// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the judge takes for a pair, where limits expire while frames are lost, and where many pairs come at once.
#include "verification/campaign/bus_view.hpp"
#include "verification/campaign/campaign_rig.hpp"

#include <cstdint>
#include <vector>

namespace counterpoint::campaign::test
{
namespace
{
constexpr Nanoseconds kMs = runtime::kNanosecondsPerMillisecond;

/// A normal frame, or the inverse one of the same data.
RecordedFrame FrameAt(const Nanoseconds at, const bool is_inverse, const std::uint8_t data)
{
    RecordedFrame frame;
    frame.at = at;
    frame.stamped.frame = {is_inverse ? 0x102U : 0x101U,
                           FrameKind::kData,
                           CanPortId::kFirst,
                           1U,
                           {static_cast<std::uint8_t>(is_inverse ? ~data : data)}};
    return frame;
}

/// SCT of 50 ms, SRVT of 20 ms.
BusView ViewOf(const std::vector<RecordedFrame>& sent, const SrvtDetection detection)
{
    Recording recording;
    recording.frames = sent;
    runtime::SrdoModel srdo;
    srdo.cob_id_1 = 0x101U;
    srdo.cob_id_2 = 0x102U;
    srdo.times = {50U, 20U, detection};
    return BusView(recording, srdo, 8U);
}

/// Whether the pair of these data counts, at 1 ms behind the last of these frames.
bool Counts(const std::vector<RecordedFrame>& frames, const SrvtDetection detection, const std::uint8_t data)
{
    const BusView bus = ViewOf(frames, detection);
    Received received;
    for (const RecordedFrame& frame : frames)
    {
        bus.Take(received, frame);
    }
    return bus.Allows(received, frames.back().at + kMs, data, 0xFFU, 0) == Leave::kGiven;
}

TEST(BusView, NormalFrameWhoseLimitExpiredIsNoFirstOne)
{
    Verifies(req::SRS_CMG_813);
    // Given a pair, and a second one whose inverse frame is lost; when the third one comes so long behind
    const auto counts = [](const SrvtDetection detection, const Nanoseconds distance)
    {
        const Nanoseconds third = (26 * kMs) + distance;
        return Counts({FrameAt(kMs, false, 0x10U), FrameAt(2 * kMs, true, 0x10U), FrameAt(26 * kMs, false, 0x11U),
                       FrameAt(third, false, 0x12U), FrameAt(third + kMs, true, 0x12U)},
                      detection, 0x12U);
    };
    // then with early detection it counts when SRVT has expired,
    EXPECT_FALSE(counts(SrvtDetection::kEarly, 20 * kMs));
    EXPECT_TRUE(counts(SrvtDetection::kEarly, (20 * kMs) + 1));
    // with late detection when SCT has, from the first pair.
    EXPECT_FALSE(counts(SrvtDetection::kLate, 25 * kMs));
    EXPECT_TRUE(counts(SrvtDetection::kLate, (25 * kMs) + 1));
}

TEST(BusView, SctDoesNotRunBehindAnErrorAndForeignKindsAreNoFrames)
{
    Verifies(req::SRS_CMG_813);
    // Given two normal frames in a row behind a pair, which end SCT; when SCT would have expired with a third that
    // waits
    std::vector<RecordedFrame> frames{FrameAt(kMs, false, 0x10U),      FrameAt(2 * kMs, true, 0x10U),
                                      FrameAt(26 * kMs, false, 0x11U), FrameAt(27 * kMs, false, 0x11U),
                                      FrameAt(40 * kMs, false, 0x12U), FrameAt(60 * kMs, false, 0x13U),
                                      FrameAt(61 * kMs, true, 0x13U)};
    // then the fourth is the second one of the third
    EXPECT_FALSE(Counts(frames, SrvtDetection::kLate, 0x13U));
    // When a remote frame of its identifier stands between both frames of a pair, it is not there.
    frames = {FrameAt(kMs, false, 0x10U), FrameAt(2 * kMs, false, 0x10U), FrameAt(3 * kMs, true, 0x10U)};
    EXPECT_FALSE(Counts(frames, SrvtDetection::kEarly, 0x10U));
    frames[1U].stamped.frame.kind = FrameKind::kRemote;
    EXPECT_TRUE(Counts(frames, SrvtDetection::kEarly, 0x10U));
}

TEST(BusView, EachPairOfTheDiscrepancyTimeMayStillBeInPlace)
{
    Verifies(req::SRS_CMG_815);
    // Given nine pairs, 1 ms apart
    std::vector<RecordedFrame> frames;
    for (std::uint8_t pair = 0U; pair < 9U; ++pair)
    {
        frames.push_back(FrameAt((pair + 1) * kMs, false, pair));
        frames.push_back(FrameAt(((pair + 1) * kMs) + 1000, true, pair));
    }
    const BusView bus = ViewOf(frames, SrvtDetection::kEarly);
    Received received;
    for (const RecordedFrame& frame : frames)
    {
        bus.Take(received, frame);
    }
    // Then within 3 ms the newest one counts, and each that was followed by another one meanwhile
    const Nanoseconds now = frames.back().at;
    for (std::uint8_t pair = 0U; pair < 9U; ++pair)
    {
        EXPECT_EQ(bus.Allows(received, now, pair, 0xFFU, 3 * kMs) == Leave::kGiven, pair >= 4U) << int{pair};
        EXPECT_EQ(bus.Allows(received, now, pair, 0xFFU, 8 * kMs), Leave::kGiven) << int{pair};
    }
}
} // namespace
} // namespace counterpoint::campaign::test
