// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A told limit is an upper bound: the instant of the fault is swept over a whole interval.
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

namespace counterpoint::simulator
{
namespace
{

/// The longest time to the safe output of the controller, in microseconds, for a flipped bit at twelve places of the
/// diagnostic interval of 1 s; each has to hold. Devices without self tests.
std::int64_t LongestOf(const std::string& flip, const FaultClass expected)
{
    Nanoseconds longest = 0;
    for (int place = 0; place < 12; ++place)
    {
        const std::string at = std::to_string(500 + (83 * place)) + ".4 ms";
        const auto run =
            RunChainWithoutSelfTests("duration: 4 s\nfaults:\n  - {fault: bit_flip, node: controller, at: " + at +
                                     ", " + flip + "}\nexpect:\n  - {that: safe_within, node: controller, srdo: 1}\n");
        EXPECT_EQ(Failures(*run), "") << at;
        const Measurement& measurement = *run->Verdicts().front().measurement;
        EXPECT_EQ(measurement.fault_class, expected);
        longest = std::max(longest, measurement.elapsed);
    }
    return longest / kNanosecondsPerMicrosecond;
}

TEST(LimitOfAFlippedBit, HoldsForACopyOfOneChannelWheneverItFlips)
{
    Verifies(req::SRS_LIM_002);
    Verifies(req::SRS_SIM_031);
    const std::int64_t longest_us =
        LongestOf("part: channel_a, config: {srdo: 1, field: sct}, bit: 4", FaultClass::kConfiguration);
    EXPECT_GT(longest_us, 800000);
}

TEST(LimitOfAFlippedBit, HoldsForWhatBothChannelsReadWheneverItFlips)
{
    Verifies(req::SRS_LIM_002);
    Verifies(req::SRS_SIM_031);
    const std::int64_t longest_us = LongestOf("part: setup, srdo: 1, offset: 0, bit: 6", FaultClass::kSharedSource);
    EXPECT_GT(longest_us, 1400000); // Its two SRDOs share a digest: far more than one interval.
}

// Counters may be apart by 0.5 ms in 100 ms. One that drifts by a tenth more is found in the window that begins after
// the fault: from its begin, within the limit.
TEST(LimitOfACounter, HoldsForASlowDriftWheneverItBegins)
{
    Verifies(req::SRS_LIM_002);
    Verifies(req::SRS_SIM_031);
    for (const char* const ppm : {"5500", "-5500"})
    {
        Nanoseconds longest = 0;
        for (int place = 0; place < 12; ++place)
        {
            const std::string at = std::to_string(500 + (9 * place)) + ".4 ms";
            const auto run = RunChain("duration: 1 s\nfaults:\n  - {fault: clock, node: actuator, counter: b, ppm: " +
                                      std::string(ppm) + ", at: " + at +
                                      "}\nexpect:\n  - {that: safe_within, node: actuator, srdo: 1}\n"
                                      "  - {that: device_fault, node: actuator, is: clock}\n");
            EXPECT_EQ(Failures(*run), "") << ppm << " at " << at;
            longest = std::max(longest, run->Verdicts().front().measurement->elapsed);
        }
        EXPECT_GT(longest, 50 * kNanosecondsPerMillisecond);
    }
}

} // namespace
} // namespace counterpoint::simulator
