// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/hardware_clock.hpp"
#include "hal/host/live/stamp.hpp"
#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/verifies.hpp"

#include <cstring>
#include <ctime>

namespace counterpoint::host
{
namespace
{

constexpr std::uint64_t kMs = 1'000'000U;
constexpr std::uint64_t kSecond = 1'000'000'000U;

TEST(HardwareClock, TheLeastDistanceIsThatOfTheClocks)
{
    Verifies(req::SRS_LIVE_057);
    HardwareClock clock;
    // The first frame was read 3 ms late, which nobody knows; the second one at once, the third one 5 ms late
    EXPECT_EQ(clock.Map(7U * kSecond, 100U * kSecond + 3U * kMs), 100U * kSecond + 3U * kMs);
    EXPECT_EQ(clock.Map(7U * kSecond + 1U * kMs, 100U * kSecond + 1U * kMs), 100U * kSecond + 1U * kMs);
    EXPECT_EQ(clock.Map(7U * kSecond + 2U * kMs, 100U * kSecond + 7U * kMs), 100U * kSecond + 2U * kMs + 200U);
    // The order of stamps of the hardware is that of the answers
    EXPECT_EQ(clock.Map(7U * kSecond + 3U * kMs, 100U * kSecond + 7U * kMs), 100U * kSecond + 3U * kMs + 400U);
}

TEST(HardwareClock, TheDistanceGrowsWithTheCrystals)
{
    Verifies(req::SRS_LIVE_057);
    HardwareClock clock;
    // A controller that is 100 ppm slow: its distance grows by 100 us a second, and is followed
    EXPECT_EQ(clock.Map(0U, 10U * kSecond), 10U * kSecond);
    EXPECT_EQ(clock.Map(1U * kSecond, 11U * kSecond + 100'000U), 11U * kSecond + 100'000U);
    // The distance does not grow by more than 200 us a second: 1 ms late is late
    EXPECT_EQ(clock.Map(2U * kSecond, 12U * kSecond + kMs), 12U * kSecond + 300'000U);
    // A fast one: the distance shrinks at once, no answer is after the software stamp
    EXPECT_EQ(clock.Map(3U * kSecond, 13U * kSecond - 50'000U), 13U * kSecond - 50'000U);
}

TEST(HardwareClock, AClockThatWasSetBeginsAnew)
{
    Verifies(req::SRS_LIVE_057);
    HardwareClock clock;
    EXPECT_EQ(clock.Map(50U * kSecond, 10U * kSecond), 10U * kSecond);
    // 100 ms are late, one microsecond more is another clock
    EXPECT_EQ(clock.Map(50U * kSecond, 10U * kSecond + 100U * kMs), 10U * kSecond);
    EXPECT_EQ(clock.Map(50U * kSecond, 10U * kSecond + 100U * kMs + 1000U), 10U * kSecond + 100U * kMs + 1000U);
    // Reset to 0, and set into the future
    EXPECT_EQ(clock.Map(0U, 11U * kSecond), 11U * kSecond);
    EXPECT_EQ(clock.Map(1U * kMs, 11U * kSecond + 2U * kMs), 11U * kSecond + 1U * kMs + 200U);
    EXPECT_EQ(clock.Map(5'000U * kSecond, 12U * kSecond), 12U * kSecond);
}

TEST(LiveStamp, TheHardwareStampOfAMessageIsTaken)
{
    Verifies(req::SRS_LIVE_057);
    // Given what the system says of a frame: software stamp, stamps of the controller
    struct
    {
        timespec system{0, 0};
        timespec legacy{0, 0};
        timespec hardware{12, 345};
    } stamps;
    alignas(cmsghdr) char control[CMSG_SPACE(sizeof stamps)]{};
    msghdr message{};
    message.msg_control = control;
    message.msg_controllen = sizeof control;
    cmsghdr* const item = CMSG_FIRSTHDR(&message);
    item->cmsg_level = SOL_SOCKET;
    item->cmsg_type = SO_TIMESTAMPING;
    item->cmsg_len = CMSG_LEN(sizeof stamps);
    std::memcpy(CMSG_DATA(item), &stamps, sizeof stamps);
    LiveArrival arrival;
    arrival.time_ns = 99U;
    ReadStamps(message, arrival);
    EXPECT_EQ(arrival.hardware_ns, 12U * kSecond + 345U);
    EXPECT_EQ(arrival.time_ns, 99U);
    // A driver without stamps gives zeroes
    stamps.hardware = {0, 0};
    std::memcpy(CMSG_DATA(item), &stamps, sizeof stamps);
    arrival.hardware_ns = 0U;
    ReadStamps(message, arrival);
    EXPECT_EQ(arrival.hardware_ns, 0U);
}

} // namespace
} // namespace counterpoint::host
