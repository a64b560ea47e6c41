// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/limits.hpp"

#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/crosslink.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <initializer_list>
#include <iterator>

namespace counterpoint
{
namespace
{

// Cycle 1 ms and 0.5 ms of tolerance, output 2 ms, discrepancy 5 ms, diagnostic interval 1 s, test interval 0.5 s,
// counters apart by 0.2 ms in 0.1 s; SRDO with SCT 50 ms and SRVT 20 ms.
//   own part    cycle    drift                output
//   50 ms       1.5 ms   1 x 0.2 ms           2 ms
TEST(ComputedLimit, EachClassOfFaultHasTheLimitOfTheTable)
{
    Verifies(req::SRS_LIM_001);
    Verifies(req::SRS_LIM_210);
    Verifies(req::SRS_LIM_211);
    DeviceConfig config{};
    config.cycle_us = 1000U;
    config.cycle_tolerance_us = 500U;
    config.output_time_us = 2000U;
    config.discrepancy_us = 5000U;
    config.diagnostic_interval_us = 1000000U;
    config.test_interval_us = 500000U;
    config.clock_tolerance_us = 200U;
    config.clock_interval_us = 100000U;
    const SrdoTimes times{50U, 20U};
    const auto us = [&config](const SrdoTimes& of, const FaultClass fault)
    {
        const Limit limit = ComputeLimit(config, of, fault);
        EXPECT_EQ(limit.result, Result::kSuccessful);
        return limit.us;
    };
    EXPECT_EQ(us(times, FaultClass::kBus), 53700U);
    EXPECT_EQ(us(times, FaultClass::kBusNextNormal), 73700U);
    EXPECT_EQ(us(SrdoTimes{50U, 20U, SrvtDetection::kLate}, FaultClass::kBusNextNormal), 53700U);
    EXPECT_EQ(us(SrdoTimes{50U, 20U, SrvtDetection::kLate}, FaultClass::kBus), 53700U);
    EXPECT_EQ(us(SrdoTimes{98U, 20U}, FaultClass::kBus), 101700U);
    EXPECT_EQ(us(SrdoTimes{99U, 20U}, FaultClass::kBus), 102900U); // With the cycle it is more than an interval.
    EXPECT_EQ(us(times, FaultClass::kWrongFrame), 3700U);
    EXPECT_EQ(us(times, FaultClass::kChannel), 8700U);
    EXPECT_EQ(us(times, FaultClass::kConfiguration), 1005700U);
    EXPECT_EQ(us(times, FaultClass::kSharedSource), 2007700U);
    EXPECT_EQ(us(times, FaultClass::kSupervisor), 504700U);
    EXPECT_EQ(us(times, FaultClass::kClock), 103900U);
    // A counter at half speed: 99.5 ms of its own begin two intervals of the other one, 100.5 ms begin three
    config.clock_tolerance_us = 50000U;
    EXPECT_EQ(us(SrdoTimes{98U, 20U}, FaultClass::kBus), 201500U);
    EXPECT_EQ(us(SrdoTimes{99U, 20U}, FaultClass::kBus), 252500U);
    config.clock_tolerance_us = 200U;
    // Without an interval the tolerance counts once
    config.clock_interval_us = 0U;
    EXPECT_EQ(us(times, FaultClass::kConfiguration), 1003700U);
}

TEST(ComputedLimit, UnknownClassHasNoLimitAndIsRefused)
{
    Verifies(req::SRS_LIM_212);
    Verifies(req::SRS_LNK_009);
    DeviceConfig config{};
    config.cycle_us = 1000U;
    config.clock_interval_us = 100000U;
    for (const FaultClass fault : {FaultClass::kInvalid, FaultClass::kCrossLink, static_cast<FaultClass>(0xEEU)})
    {
        const Limit limit = ComputeLimit(config, SrdoTimes{50U, 20U}, fault);
        EXPECT_EQ(limit.result, Result::kNotExist);
        EXPECT_EQ(limit.us, 0xFFFFFFFFU);
    }
    // and so has a sum that 32 bits do not hold
    EXPECT_EQ(ComputeLimit(config, LinkTime{0xFFFFFC16U}).us, 0xFFFFFFFEU);
    EXPECT_EQ(ComputeLimit(config, LinkTime{0xFFFFFC16U}).result, Result::kSuccessful);
    EXPECT_EQ(ComputeLimit(config, LinkTime{0xFFFFFC17U}).us, 0xFFFFFFFFU);
    EXPECT_EQ(ComputeLimit(config, LinkTime{0xFFFFFC17U}).result, Result::kNotExist);
}

/// Late cycles, and a fault at each place among them. The output of the rig closes at once, so that its time is left
/// over: it is added. Both counters may be slow by their tolerance of 200 us in 100 ms: what they count as 500 us lasts
/// for 501.
class SweptLimit : public Rig
{
  public:
    void LateCycle(const std::uint32_t after_us = 1500U)
    {
        now_us = cycle_at_us_ + after_us;
        cycle_at_us_ = now_us;
        kernel.Cycle(CycleCall{InstantPair{{now_us}, {now_us + ahead_us_}}, 0U, 0U});
    }
    void LateCycleWithPair(const std::uint32_t after_us = 1500U)
    {
        now_us = cycle_at_us_ + (after_us / 2U);
        Hear(0x101U, {0x12U, 0x34U});
        Hear(0x102U, {0xEDU, 0xCBU});
        LateCycle(after_us);
    }
    void Hear(const std::uint32_t identifier, const std::initializer_list<std::uint8_t> bytes)
    {
        StampedFrame frame{CanFrame{identifier, FrameKind::kData, CanPortId::kFirst, 2U, {}}, {}};
        std::copy(bytes.begin(), bytes.end(), std::begin(frame.frame.data));
        frame.stamp = InstantPair{{now_us}, {now_us + ahead_us_}};
        kernel.OnFrame(frame);
    }
    /// Operates anew, with `cycles` late cycles: with one or more the output is open.
    void Release(const std::uint32_t cycles = 1U)
    {
        Forget();
        ahead_us_ = 0U;
        Operate();
        cycle_at_us_ = now_us;
        for (std::uint32_t cycle = 0U; cycle < cycles; ++cycle)
        {
            LateCycleWithPair();
        }
        ASSERT_EQ(Open(), (cycles == 0U) ? 0U : 1U);
    }
    /// How long it takes from an instant to the cycle that closes the output, with the output time.
    template <typename Step> std::uint32_t TimeToSafe(const std::uint32_t from_us, const Step& step)
    {
        while ((Open() != 0U) && ((now_us - from_us) < 1000000U))
        {
            step();
        }
        Forget();
        const std::uint32_t counted_us = now_us - from_us;
        return counted_us + (counted_us / 500U) + config.output_time_us;
    }
    [[nodiscard]] std::uint32_t LimitOf(const FaultClass fault) const
    {
        return ComputeLimit(config, SrdoTimes{50U, 20U, setups[0].detection}, fault).us;
    }
    /// The last good normal frame after a cycle; then silence, or one normal frame more at the very limit.
    std::uint32_t Silence(const std::uint32_t place_us, const bool has_next)
    {
        Release();
        now_us = cycle_at_us_ + place_us;
        const std::uint32_t normal_us = now_us;
        Hear(0x101U, {0x12U, 0x34U});
        Hear(0x102U, {0xEDU, 0xCBU});
        while (has_next && ((cycle_at_us_ + 1500U) <= (normal_us + 50000U)))
        {
            LateCycle();
        }
        if (has_next)
        {
            now_us = normal_us + 50000U;
            Hear(0x101U, {0x12U, 0x34U});
        }
        return TimeToSafe(normal_us, [this]() { LateCycle(); });
    }
    /// A slot's digest changes right behind a cycle, in one channel or in both.
    std::uint32_t Change(const SlotIndex slot, const std::uint32_t phase, const bool is_shared)
    {
        a.digest_flip = 0U;
        b.digest_flip = 0U;
        Release(phase);
        a.digest_slot = slot;
        b.digest_slot = slot;
        a.digest_flip = is_shared ? 1U : 0U;
        b.digest_flip = 1U;
        // Cycles of both kinds, so that they fall on every place of a share
        std::uint32_t cycle = 0U;
        return TimeToSafe(now_us,
                          [this, &cycle]()
                          {
                              LateCycleWithPair(((cycle % 4U) == 3U) ? 1500U : 1166U);
                              ++cycle;
                          });
    }
    void Forget()
    {
        application.events.clear(); // Memory is given back behind a test alone.
        application.errors.clear();
        application.flow.clear();
        application.refreshed.clear();
        application.faults.clear();
        a.transmit_faults.clear();
        b.transmit_faults.clear();
        ports.sent.clear();
    }

    std::uint32_t ahead_us_{0U}; ///< Of counter B.
    std::uint32_t cycle_at_us_{0U};
};

// The last good normal frame at each place between two cycles. At the longest a cycle falls on the very limit, and the
// next one is 1.5 ms later; with the cycle time alone 52 ms were told.
TEST_F(SweptLimit, SilenceOnTheBus)
{
    Verifies(req::SRS_LIM_002);
    std::uint32_t longest_us = 0U;
    for (const SrvtDetection detection : {SrvtDetection::kEarly, SrvtDetection::kLate})
    {
        setups[0].detection = detection;
        for (std::uint32_t place_us = 0U; place_us <= 1500U; place_us += 50U)
        {
            const std::uint32_t silent_us = Silence(place_us, false);
            EXPECT_LE(silent_us, LimitOf(FaultClass::kBus)) << place_us;
            longest_us = std::max(longest_us, silent_us);
            EXPECT_LE(Silence(place_us, true), LimitOf(FaultClass::kBusNextNormal)) << place_us;
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
        }
    }
    EXPECT_EQ(longest_us, 52603U);
}

TEST_F(SweptLimit, WrongFrame)
{
    Verifies(req::SRS_LIM_002);
    for (std::uint32_t place_us = 0U; place_us <= 1500U; place_us += 50U)
    {
        Release();
        now_us = cycle_at_us_ + place_us;
        const std::uint32_t wrong_us = now_us;
        Hear(0x102U, {0xEDU, 0xCBU});
        EXPECT_LE(TimeToSafe(wrong_us, [this]() { LateCycle(); }), LimitOf(FaultClass::kWrongFrame)) << place_us;
    }
}

// A pair that one channel does not get, and a channel that is not called.
TEST_F(SweptLimit, SilentChannel)
{
    Verifies(req::SRS_LIM_002);
    std::uint32_t longest_us = 0U;
    for (std::uint32_t place_us = 0U; place_us <= 1500U; place_us += 50U)
    {
        Release();
        b.drop_frames = true;
        now_us = cycle_at_us_ + place_us;
        const std::uint32_t lost_us = now_us;
        Hear(0x101U, {0x12U, 0x34U});
        Hear(0x102U, {0xEDU, 0xCBU});
        const std::uint32_t taken_us = TimeToSafe(lost_us, [this]() { LateCycle(); });
        EXPECT_LE(taken_us, LimitOf(FaultClass::kChannel)) << place_us;
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kUnmatched);
        b.drop_frames = false;
        longest_us = std::max(longest_us, taken_us);

        Release();
        b.skip_cycle = true;
        now_us = cycle_at_us_ + place_us;
        EXPECT_LE(TimeToSafe(now_us, [this]() { LateCycle(); }), LimitOf(FaultClass::kChannel)) << place_us;
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
        b.skip_cycle = false;
    }
    EXPECT_GT(longest_us, 6000U); // More than discrepancy time and output time.
}

// From each cycle of a walk of 30 ms on, for each slot. What both channels read shows at the end of the walk after the
// one that is under way.
TEST_F(SweptLimit, CopyOfOneChannelAndWhatBothRead)
{
    Verifies(req::SRS_LIM_002);
    Verifies(req::SRS_CFG_048);
    Verifies(req::SRS_CFG_050);
    std::uint32_t longest_us = 0U;
    std::uint32_t longest_shared_us = 0U;
    for (std::uint32_t phase = 20U; phase < 41U; ++phase)
    {
        for (const SlotIndex slot : std::initializer_list<SlotIndex>{0U, 1U, 2U})
        {
            const std::uint32_t copy_us = Change(slot, phase, false);
            EXPECT_LE(copy_us, LimitOf(FaultClass::kConfiguration)) << phase;
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
            const std::uint32_t shared_us = Change(slot, phase, true);
            EXPECT_LE(shared_us, LimitOf(FaultClass::kSharedSource)) << phase;
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kConfiguration);
            longest_us = std::max(longest_us, copy_us);
            longest_shared_us = std::max(longest_shared_us, shared_us);
        }
    }
    EXPECT_GT(longest_us, 30000U);
    EXPECT_GT(longest_shared_us, 50000U); // Far beyond one interval.
}

// The walk begins with the first cycle, in shares of 5 ms, two for each slot; cycles are 1.5 ms apart. Late cycles do
// not add up: the end of the walk is in the cycle at 30 ms.
//   share begins  5  10    15  20    25    30 ms
//   done at       6  10.5  15  21    25.5  30 ms     each second one is the digest of a slot
TEST_F(SweptLimit, LateCyclesDoNotStretchTheWalk)
{
    Verifies(req::SRS_LIM_002);
    Verifies(req::SRS_LIM_213);
    constexpr std::uint32_t kDoneUs[] = {10500U, 21000U, 30000U};
    for (const SlotIndex slot : std::initializer_list<SlotIndex>{0U, 1U, 2U})
    {
        b.digest_flip = 0U;
        Release(0U);
        const std::uint32_t first_us = now_us;
        b.digest_slot = slot;
        b.digest_flip = 1U;
        while ((kernel.DeviceState().fault == DeviceFault::kNone) && ((now_us - first_us) < 100000U))
        {
            LateCycleWithPair();
        }
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
        EXPECT_EQ(now_us - first_us, kDoneUs[slot]);
    }
}

// Counter A, by which the walk goes, counts 760 us while counter B counts 1500 us: 49.6 ms less in 100.5 ms, where 50
// ms are allowed. Counter B is right.
TEST_F(SweptLimit, CopyOfOneChannelByASlowCounter)
{
    Verifies(req::SRS_LIM_002);
    config.clock_tolerance_us = 50000U;
    config.diagnostic_interval_us = 90000U;
    config.discrepancy_us = 60000U; // The producer is due for both channels by their own counters.
    std::uint32_t longest_us = 0U;
    for (std::uint32_t phase = 20U; phase < 41U; ++phase)
    {
        b.digest_flip = 0U;
        Release(phase);
        b.digest_slot = 1U;
        b.digest_flip = 1U;
        const std::uint32_t from_us = now_us + ahead_us_;
        const auto slow = [this]()
        {
            ahead_us_ += 740U;
            LateCycleWithPair(760U);
        };
        static_cast<void>(TimeToSafe(now_us, slow));
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
        const std::uint32_t taken_us = ((now_us + ahead_us_) - from_us) + config.output_time_us;
        EXPECT_LE(taken_us, LimitOf(FaultClass::kConfiguration)) << phase;
        longest_us = std::max(longest_us, taken_us);
    }
    EXPECT_GT(longest_us, 170000U); // Nearly twice the interval.
}

// Counter B gains so many us in each cycle, from each place of the clock interval on: 3 us in 1497 are hardly more than
// the tolerance. The limit counts from the cycle before the first gain.
TEST_F(SweptLimit, CounterThatDrifts)
{
    Verifies(req::SRS_LIM_002);
    Verifies(req::SRS_CLK_001);
    Verifies(req::SRS_CLK_212);
    std::uint32_t longest_us = 0U;
    for (const std::uint32_t gain_us : {3U, 4U, 6U, 30U, 201U})
    {
        for (std::uint32_t phase = 1U; phase < 70U; phase += 4U)
        {
            Release(phase);
            const std::uint32_t from_us = now_us;
            const auto drift = [&]()
            {
                ahead_us_ += gain_us;
                LateCycleWithPair(1500U - gain_us); // Counter B is not late.
            };
            static_cast<void>(TimeToSafe(from_us, drift));
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kClock) << gain_us << phase;
            const std::uint32_t taken_us = (now_us - from_us) + config.output_time_us;
            EXPECT_LE(taken_us, LimitOf(FaultClass::kClock)) << gain_us << phase;
            longest_us = std::max(longest_us, taken_us);
        }
    }
    EXPECT_GT(longest_us, 90000U); // Nearly an interval.
}

// Shares of 5 ms, late cycles of 1.5 ms: signatures at 5, 15 and 25 ms, each in the first cycle behind.
TEST_F(SweptLimit, LateCyclesDoNotStretchTheChecksOfTheSignatures)
{
    Verifies(req::SRS_LIM_213);
    Release(0U);
    const std::uint32_t first_us = now_us;
    std::vector<std::pair<SlotIndex, std::uint32_t>> checked;
    while ((now_us - first_us) < 60000U)
    {
        a.rechecked = kNoSlot;
        LateCycleWithPair();
        if (a.rechecked != kNoSlot)
        {
            checked.emplace_back(a.rechecked, now_us - first_us);
        }
    }
    const std::vector<std::pair<SlotIndex, std::uint32_t>> expected{{0U, 6000U},  {1U, 15000U}, {2U, 25500U},
                                                                    {0U, 36000U}, {1U, 45000U}, {2U, 55500U}};
    EXPECT_EQ(checked, expected);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(SweptLimit, SignatureOfOneChannel)
{
    Verifies(req::SRS_LIM_002);
    Verifies(req::SRS_CFG_048);
    std::uint32_t longest_us = 0U;
    for (std::uint32_t phase = 20U; phase < 41U; ++phase)
    {
        for (const SlotIndex slot : std::initializer_list<SlotIndex>{0U, 1U, 2U})
        {
            b.signature_flip = 0U;
            Release(phase);
            b.check_slot = slot;
            b.signature_flip = 1U;
            const std::uint32_t taken_us = TimeToSafe(now_us, [this]() { LateCycleWithPair(); });
            EXPECT_LE(taken_us, LimitOf(FaultClass::kConfiguration)) << phase;
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
            EXPECT_EQ(kernel.DeviceState().slot, slot);
            longest_us = std::max(longest_us, taken_us);
        }
    }
    EXPECT_GT(longest_us, 30000U);
}

} // namespace
} // namespace counterpoint
