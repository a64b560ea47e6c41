// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The two counters against each other over the interval of the setup: the counters are numbers of the test, 2 and 4 for
// a microsecond, half a microsecond ahead so that whole ones come out.
#include "hal/zynqmp/time/counters.hpp"

#include "hal/zynqmp/chip/cycle_counter.hpp"
#include "hal/zynqmp/time/ttc_registers.hpp"
#include "verification/trace/ids/zynqmp_hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>

namespace counterpoint::zynqmp
{
namespace
{

struct Machine
{
    std::map<std::uint32_t, std::uint32_t> words;
    CycleSetup cycles;
    std::uint32_t timer_us;
    std::uint32_t processor_us;
    std::uint32_t timer_step; ///< us a reading: what the start waits for.
    std::uint32_t processor_step;
};
Machine machine;

constexpr CountersSetup kSetup{ttc::kTtc0, 7U, CounterRate{2000000U, 32U}, 0U, CounterRate{4000000U, 32U}, 50U, 20000U};

class CountersTest : public testing::Test
{
  protected:
    CountersTest()
    {
        EXPECT_EQ(StartWith(1U, 1U), Outcome::kDone);
        machine.timer_step = 0U;
        machine.processor_step = 0U;
        EXPECT_EQ(counters_.Examine(), Outcome::kDone);
    }
    /// A start while the counters pass so much a reading.
    Outcome StartWith(const std::uint32_t timer_step, const std::uint32_t processor_step)
    {
        machine = Machine{{}, {}, 70U, 5000U, timer_step, processor_step};
        return counters_.Start(kSetup);
    }
    /// A cycle of 1 ms, in which the processor's counter gains so much.
    Outcome CycleWith(const std::uint32_t gained_us)
    {
        machine.timer_us += 1000U;
        machine.processor_us += 1000U + gained_us;
        return counters_.Examine();
    }

    Counters counters_{};
};

TEST_F(CountersTest, BothCountFromTheStart)
{
    Verifies(req::SRS_ZYN_054);
    // Given counters that stood at 70 and 5000 us, behind the 20 us that the start watches
    const InstantPair begun = counters_.Now();
    EXPECT_EQ(begun.a.us, 20U);
    EXPECT_EQ(begun.b.us, 20U);
    // Each is a counter of its own
    machine.timer_us += 300U;
    machine.processor_us += 200U;
    EXPECT_EQ(counters_.Now().a.us, 320U);
    EXPECT_EQ(counters_.Now().b.us, 220U);
}

TEST_F(CountersTest, ACounterThatDoesNotRunRefusesTheStart)
{
    Verifies(req::SRS_ZYN_054);
    EXPECT_EQ(StartWith(0U, 1U), Outcome::kFailed);
    EXPECT_EQ(StartWith(1U, 0U), Outcome::kFailed);
    EXPECT_EQ(StartWith(0U, 0U), Outcome::kFailed);
    EXPECT_EQ(counters_.Examine(), Outcome::kFailed);
}

TEST_F(CountersTest, ACounterThatIsNotAsFastAsItWasSaidRefusesTheStart)
{
    Verifies(req::SRS_ZYN_054);
    EXPECT_EQ(StartWith(1U, 2U), Outcome::kFailed);
    EXPECT_EQ(StartWith(2U, 1U), Outcome::kFailed);
    EXPECT_EQ(StartWith(2U, 2U), Outcome::kDone);
}

// 30 us a cycle are within the tolerance of a cycle, and 60 us behind the second one are not within that of the
// interval.
TEST_F(CountersTest, ADriftAddsUpOverTheInterval)
{
    Verifies(req::SRS_ZYN_056);
    EXPECT_EQ(CycleWith(30U), Outcome::kDone);
    EXPECT_EQ(CycleWith(30U), Outcome::kFailed);
    EXPECT_EQ(CycleWith(0U), Outcome::kFailed);
}

TEST_F(CountersTest, TheGreatestDriftOfAnIntervalIsNone)
{
    Verifies(req::SRS_ZYN_056);
    EXPECT_EQ(CycleWith(50U), Outcome::kDone);
    for (std::uint32_t cycle = 0U; cycle < 18U; ++cycle)
    {
        EXPECT_EQ(CycleWith(0U), Outcome::kDone) << cycle;
    }
    // The last cycle of the interval, and one microsecond more.
    EXPECT_EQ(CycleWith(1U), Outcome::kFailed);
}

// 2 us a cycle are 40 us in each interval, in the second one as in the first.
TEST_F(CountersTest, EachIntervalIsComparedFromItsBeginning)
{
    Verifies(req::SRS_ZYN_056);
    for (std::uint32_t cycle = 0U; cycle < 100U; ++cycle)
    {
        EXPECT_EQ(CycleWith(2U), Outcome::kDone) << cycle;
    }
    EXPECT_EQ(CycleWith(51U), Outcome::kFailed);
}

} // namespace

void SetUpCycles(const CycleSetup& setup) noexcept
{
    machine.cycles = setup;
}

CycleSetup ReadCycleSetup() noexcept
{
    return CycleSetup{machine.cycles.control & ~kCyclesReset, machine.cycles.enabled, machine.cycles.user};
}

std::uint32_t ReadCycleCounter() noexcept
{
    return (4U * machine.processor_us) + 2U;
}

} // namespace counterpoint::zynqmp

namespace counterpoint::tms570
{

std::uint32_t Read(const Register place) noexcept
{
    auto& machine = zynqmp::machine;
    if (place.address != (zynqmp::ttc::kTtc0.address + zynqmp::ttc::kCounterValue))
    {
        return machine.words[place.address];
    }
    machine.timer_us += machine.timer_step;
    machine.processor_us += machine.processor_step;
    return (2U * machine.timer_us) + 1U;
}

void Write(const Register place, const std::uint32_t value) noexcept
{
    zynqmp::machine.words[place.address] = value;
}

} // namespace counterpoint::tms570
