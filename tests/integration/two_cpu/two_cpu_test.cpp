// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/trace/ids/crosslink.hpp"
#include "verification/trace/verifies.hpp"
#include "verification/two_cpu/campaign.hpp"

#include <gtest/gtest.h>

#include <array>

namespace counterpoint::two_cpu
{
namespace
{

// Given drifting clocks and a link that loses, delays, repeats and flips, when nothing is broken for 1000 s, then every
// pair of the sensor is released on both CPUs (8 a second from 0.6 s on), and no device fault is entered.
TEST(TwoCpus, RunUndisturbed)
{
    Verifies(req::SRS_TWO_016);
    const SoakResult result = RunSoak(1000.0, 3U, 0U);
    EXPECT_EQ(result.faults[0U].fault, DeviceFault::kNone);
    EXPECT_EQ(result.faults[1U].fault, DeviceFault::kNone);
    EXPECT_TRUE(result.is_open);
    EXPECT_GE(result.released[0U], 7980U);
    EXPECT_GE(result.released[1U], 7980U);
    EXPECT_GE(result.sent[0U], 7900U);
    EXPECT_EQ(result.pairs_bad, 0U);
    EXPECT_EQ(result.consumer_errors[0U], 0U);
    EXPECT_GT(result.counts[0U].lost, 0U);
    EXPECT_GT(result.counts[0U].old, 0U);
    EXPECT_GT(result.counts[0U].repeated + result.counts[1U].repeated, 0U);
    EXPECT_GT(result.counts[0U].corrupt + result.counts[1U].corrupt, 0U);
}

// Given a sensor that gets three pairs in ten wrong, when 1000 s pass, then both CPUs count the same errors, and none
// of them becomes a device fault.
TEST(TwoCpus, ErrorsOfTheBusAreNoDeviceFaults)
{
    Verifies(req::SRS_TWO_004);
    Verifies(req::SRS_TWO_006);
    Verifies(req::SRS_TWO_016);
    const SoakResult result = RunSoak(1000.0, 4U, 300'000U);
    EXPECT_EQ(result.faults[0U].fault, DeviceFault::kNone);
    EXPECT_EQ(result.faults[1U].fault, DeviceFault::kNone);
    EXPECT_GT(result.sensor_faults, 1000U);
    EXPECT_EQ(result.consumer_errors[0U], result.consumer_errors[1U]);
    EXPECT_GT(result.released[0U], 2000U);
}

using Broken = ::testing::TestWithParam<Breakage>;

// Given two CPUs whose output is open, when this breaks at a random moment, then the output is safe within its limit
// and stays so.
TEST_P(Broken, IsSafeWithinTheLimit)
{
    if (GetParam() < Breakage::kFlippedData)
    {
        Verifies(req::SRS_TWO_017);
    }
    else
    {
        Verifies(req::SRS_TWO_018);
    }
    Score score{};
    for (std::uint64_t seed = 1U; seed <= 40U; ++seed)
    {
        RunOnce(GetParam(), seed, score);
    }
    EXPECT_EQ(score.runs, 40U);
    EXPECT_EQ(score.not_open, 0U);
    EXPECT_EQ(score.late, 0U);
}

INSTANTIATE_TEST_SUITE_P(TwoCpus, Broken,
                         ::testing::Values(Breakage::kCpuDead, Breakage::kLinkCut, Breakage::kLinkHalfCut,
                                           Breakage::kClockStops, Breakage::kClockStands, Breakage::kFlippedData,
                                           Breakage::kDeaf, Breakage::kFrozenChannel, Breakage::kFrozenComparator));

DeviceSetup QuietSetup()
{
    DeviceSetup setup = UsualSetup(5U);
    setup.wire = host::WireFaults{};
    setup.wire.longest_us = 1000U;
    return setup;
}

// Given a cut link, then the cause of both device faults is the cross link.
TEST(TwoCpus, LostLinkIsTheCauseOfBoth)
{
    Verifies(req::SRS_LNK_006);
    Device device{QuietSetup()};
    device.RunUntil(1'200'000.0);
    ASSERT_TRUE(device.IsOpen());
    device.wire.Faults(host::WireEnd::kFirst).is_cut = true;
    device.RunUntil(1'600'000.0);
    EXPECT_EQ(device.cpus[0U]->kernel.DeviceState().fault, DeviceFault::kCrossLink);
    EXPECT_EQ(device.cpus[1U]->kernel.DeviceState().fault, DeviceFault::kCrossLink);
    EXPECT_EQ(device.cpus[1U]->peer.Link().Finding(), LinkFinding::kTimeout);
}

// Given a link that was never there, then each CPU runs alone without a fault and opens nothing.
TEST(TwoCpus, WithoutContactNothingOpens)
{
    Verifies(req::SRS_LNK_005);
    Device device{QuietSetup()};
    device.wire.Faults(host::WireEnd::kFirst).is_cut = true;
    device.wire.Faults(host::WireEnd::kSecond).is_cut = true;
    device.RunUntil(5'000'000.0);
    EXPECT_FALSE(device.cpus[0U]->IsOpen(device.Now()));
    EXPECT_FALSE(device.cpus[1U]->IsOpen(device.Now()));
    EXPECT_EQ(device.cpus[0U]->kernel.DeviceState().fault, DeviceFault::kNone);
    EXPECT_EQ(device.cpus[1U]->kernel.DeviceState().fault, DeviceFault::kNone);
    EXPECT_EQ(device.cpus[0U]->application.received, 0U);
    // And the peer that comes late is taken up.
    device.wire.Faults(host::WireEnd::kFirst).is_cut = false;
    device.wire.Faults(host::WireEnd::kSecond).is_cut = false;
    device.RunUntil(7'000'000.0);
    EXPECT_TRUE(device.IsOpen());
}

// Given unequal process values on the two CPUs, then no pair leaves, the producer's error is told, and no device fault.
TEST(TwoCpus, UnequalProcessValuesLeaveNothing)
{
    Verifies(req::SRS_TWO_214);
    Verifies(req::SRS_TWO_011);
    Device device{QuietSetup()};
    device.RunUntil(1'200'000.0);
    device.cpus[1U]->application.offset = 1U;
    const std::uint64_t before = device.cpus[0U]->application.sent;
    device.RunUntil(1'500'000.0);
    const std::uint64_t shortly_after = device.cpus[0U]->application.sent;
    device.RunUntil(4'000'000.0);
    EXPECT_LE(shortly_after, before + 1U);
    EXPECT_EQ(device.cpus[0U]->application.sent, shortly_after);
    EXPECT_GT(device.cpus[0U]->application.producer_errors, 0U);
    EXPECT_EQ(device.pairs_bad, 0U);
    EXPECT_EQ(device.cpus[0U]->kernel.DeviceState().fault, DeviceFault::kNone);
    EXPECT_EQ(device.cpus[1U]->kernel.DeviceState().fault, DeviceFault::kNone);
}

// Given a released pair, then the normal objects on CPU A and the inverse ones on CPU B are inverse, bit by bit.
TEST(TwoCpus, EachWritesItsHalf)
{
    Verifies(req::SRS_TWO_001);
    Device device{QuietSetup()};
    device.RunUntil(1'200'000.0);
    device.sensor_is_silent = true;
    device.RunUntil(1'400'000.0);
    ASSERT_TRUE(device.IsOpen());
    const ProcessApplication& a = device.cpus[0U]->application;
    const ProcessApplication& b = device.cpus[1U]->application;
    EXPECT_EQ(a.rx_normal[0U] ^ b.rx_inverse[0U], 0xFF);
    EXPECT_EQ(a.rx_normal[1U] ^ b.rx_inverse[1U], 0xFF);
}

} // namespace
} // namespace counterpoint::two_cpu
