// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/output.hpp"
#include "hal/host/watchdog.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace counterpoint::host
{
namespace
{

/// A device's output with a gate limit of 2000 us, and a watchdog with a window from 800 to 1500 us.
class HostOutputTest : public ::testing::Test
{
  protected:
    static constexpr hal::WatchdogWindow kWindow{800U, 1500U};

    /// As the start of a kernel leaves it.
    HostOutputTest()
    {
        output.Drive(hal::PermitSet{});
    }
    /// Three right permits for slots 0 and 2; the high word of the mask is 0, so that the formula is one sum and one
    /// product.
    void DriveOpen()
    {
        const std::uint32_t sum = output.Challenge() + 5U;
        output.Drive(hal::PermitSet{{5U, sum * 0x9E37'79B1U}, {5U, sum * 0x85EB'CA77U}, {5U, sum * 0xC2B2'AE3DU}});
    }
    void AnswerRight()
    {
        watchdog.Answer(hal::WatchdogAnswer{(0x5EC0'DE27U + watchdog.Question().value) * 0x0100'0193U});
    }

    VirtualBus bus{BitRate::k250k};
    HostWatchdog watchdog{bus};
    HostOutput output{bus, watchdog, hal::GateLimit{2000U}};
};

TEST_F(HostOutputTest, OpensByThreePermitsWhileTheWatchdogLives)
{
    Verifies(req::SRS_HAL_014);
    // Given a living watchdog
    bus.Advance(10 * kMillisecond);
    watchdog.Start(kWindow);
    EXPECT_EQ(output.Open(), 0U);
    // When three right permits come, then their slots are open
    DriveOpen();
    EXPECT_EQ(output.Open(), 5U);
    // and one wrong permit closes them
    output.Drive(hal::PermitSet{});
    EXPECT_EQ(output.Open(), 0U);
}

TEST_F(HostOutputTest, CutOffStaysClosedWhateverComes)
{
    Verifies(req::SRS_STS_052);
    // Given an open output
    watchdog.Start(kWindow);
    DriveOpen();
    ASSERT_EQ(output.Open(), 5U);
    // When an exception cuts it off, then it is closed, and right permits open nothing
    output.CutOff();
    EXPECT_EQ(output.Open(), 0U);
    DriveOpen();
    EXPECT_EQ(output.Open(), 0U);
    EXPECT_EQ(output.ClosesAt(), kNever);
}

// Before anything else was done: neither the watchdog, that starts then, nor right permits open it.
TEST_F(HostOutputTest, CutOffOfAClosedOutputStaysAsWell)
{
    Verifies(req::SRS_STS_052);
    output.CutOff();
    watchdog.Start(kWindow);
    for (BusTime cycle = 1; cycle <= 5; ++cycle)
    {
        DriveOpen();
        EXPECT_EQ(output.Open(), 0U);
        bus.Advance(cycle * kMillisecond);
        AnswerRight();
    }
    ASSERT_TRUE(watchdog.IsAlive());
    // And once more, while it is cut off
    output.CutOff();
    DriveOpen();
    EXPECT_EQ(output.Open(), 0U);
    // Another output, as a restart makes it, opens
    HostOutput next{bus, watchdog, hal::GateLimit{2000U}};
    next.Drive(hal::PermitSet{});
    const std::uint32_t sum = next.Challenge() + 5U;
    next.Drive(hal::PermitSet{{5U, sum * 0x9E37'79B1U}, {5U, sum * 0x85EB'CA77U}, {5U, sum * 0xC2B2'AE3DU}});
    EXPECT_EQ(next.Open(), 5U);
}

TEST_F(HostOutputTest, ProbingChangesNothing)
{
    Verifies(req::SRS_STS_031);
    // Given an open output
    watchdog.Start(kWindow);
    DriveOpen();
    // When it is shown a right set of no slot and one with a missing permit
    const hal::PermitSet right{{0U, 2U * 0x9E37'79B1U}, {0U, 2U * 0x85EB'CA77U}, {0U, 2U * 0xC2B2'AE3DU}};
    hal::PermitSet missing = right;
    missing.b = Permit{0U, 0U};
    EXPECT_EQ(output.Probe(right, 2U), hal::ProbeAnswer::kAccepted);
    EXPECT_EQ(output.Probe(missing, 2U), hal::ProbeAnswer::kRefused);
    // Then it is as open as before
    EXPECT_EQ(output.Open(), 5U);
}

TEST_F(HostOutputTest, PermitsOpenNothingWithoutTheWatchdog)
{
    Verifies(req::SRS_HAL_013);
    // Given a watchdog that was never started, when three right permits come, then nothing opens
    DriveOpen();
    EXPECT_EQ(output.Open(), 0U);
    EXPECT_EQ(output.ClosesAt(), kNever);
}

// t [us]   10000    11500  11501         watchdog window ends 1500 us after its start
TEST_F(HostOutputTest, TrippedWatchdogClosesTheOutputUntilStartedAgain)
{
    Verifies(req::SRS_HAL_013);
    // Given an open output
    bus.Advance(10 * kMillisecond);
    watchdog.Start(kWindow);
    EXPECT_EQ(watchdog.TripsAt(), 11'501'000);
    bus.Advance(11'400'000);
    DriveOpen();
    ASSERT_EQ(output.Open(), 5U);
    EXPECT_EQ(output.ClosesAt(), 11'501'000);
    // When no answer comes until just after the window
    bus.Advance(11'500'999);
    EXPECT_EQ(output.Open(), 5U);
    bus.Advance(11'501'000);
    // Then it closes and stays so, though permits and answers are right
    EXPECT_EQ(output.Open(), 0U);
    EXPECT_FALSE(watchdog.IsAlive());
    EXPECT_EQ(watchdog.TripsAt(), kNever);
    AnswerRight();
    DriveOpen();
    EXPECT_EQ(output.Open(), 0U);
    // When the watchdog is started again, then new permits open it
    watchdog.Start(kWindow);
    EXPECT_EQ(output.Open(), 0U);
    DriveOpen();
    EXPECT_EQ(output.Open(), 5U);
}

TEST_F(HostOutputTest, RestartedWatchdogDoesNotReopenWhatNobodySawClosed)
{
    Verifies(req::SRS_HAL_013);
    // Given an output open at 1400 us, and a watchdog that trips at 1501 us without anybody looking
    watchdog.Start(kWindow);
    bus.Advance(1'400'000);
    DriveOpen();
    ASSERT_EQ(output.Open(), 5U);
    bus.Advance(1'600'000);
    // When it is started again within the gate's limit
    watchdog.Start(kWindow);
    // Then the output is closed
    EXPECT_EQ(output.Open(), 0U);
    EXPECT_EQ(watchdog.Starts(), 2U);
}

TEST_F(HostOutputTest, RightAnswersKeepItAliveAndAnEarlyOneTripsIt)
{
    Verifies(req::SRS_HAL_013);
    // Given a watchdog answered every millisecond
    watchdog.Start(kWindow);
    for (BusTime cycle = 1; cycle <= 5; ++cycle)
    {
        bus.Advance(cycle * kMillisecond);
        AnswerRight();
        ASSERT_TRUE(watchdog.IsAlive());
    }
    EXPECT_EQ(watchdog.TripsAt(), 6'501'000);
    // When an answer comes after 799 us
    bus.Advance(5'799'000);
    AnswerRight();
    // Then it trips
    EXPECT_FALSE(watchdog.IsAlive());
}

TEST_F(HostOutputTest, ClosesByItselfAtTheGatesLimit)
{
    Verifies(req::SRS_HAL_014);
    // Given an output driven at 1 ms, the watchdog answered at 2500 us
    watchdog.Start(hal::WatchdogWindow{0U, 10'000U});
    bus.Advance(kMillisecond);
    DriveOpen();
    // Then it says that it closes 2001 us later
    EXPECT_EQ(output.ClosesAt(), 3'001'000);
    // and does
    bus.Advance(3'000'999);
    EXPECT_EQ(output.Open(), 5U);
    bus.Advance(3'001'000);
    EXPECT_EQ(output.Open(), 0U);
    EXPECT_EQ(output.ClosesAt(), kNever);
}

// limit 2000 us from the Drive at 1 ms, and nobody looks before the next cycle
TEST_F(HostOutputTest, ClosingThatNobodySawIsAnInterruption)
{
    Verifies(req::SRS_HAL_300);
    Verifies(req::SRS_HAL_301);
    watchdog.Start(hal::WatchdogWindow{0U, 10'000U});
    bus.Advance(kMillisecond);
    DriveOpen();
    bus.Advance(3 * kMillisecond);
    DriveOpen(); // On the limit.
    EXPECT_EQ(output.Open(), 5U);
    bus.Advance(5'001'000);
    EXPECT_EQ(output.Challenge(), 0U);
    DriveOpen();
    EXPECT_EQ(output.Open(), 0U);
    // until it is armed
    output.Drive(hal::PermitSet{});
    DriveOpen();
    EXPECT_EQ(output.Open(), 5U);
}

} // namespace
} // namespace counterpoint::host
