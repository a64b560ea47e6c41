// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/selftest/self_test.hpp"

#include "tests/safety_core/selftest/device.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace counterpoint::selftest
{
namespace
{

constexpr std::uint32_t kRound = 36U;
constexpr std::uint32_t kNever = 0xFFFF'FFFFU;

class SelfTestTest : public ::testing::Test
{
  protected:
    /// Cycles until a fault is reported; kNever if none is within the interval.
    std::uint32_t CyclesToFault() const
    {
        for (std::uint32_t cycle = 1U; cycle <= device->setup.interval_cycles; ++cycle)
        {
            if (device->self_test.OnCycle().fault == DeviceFault::kSelfTest)
            {
                return cycle;
            }
        }
        return kNever;
    }
    void Flip(std::uint32_t& word) const
    {
        word ^= 0x0000'0400U;
    }
    static host::Defect StuckAt(const hal::Address place)
    {
        return {host::CellDefect::kStuckAtOne, {place, 10U}, {place, 10U}};
    }

    std::unique_ptr<Device> device{NewDevice()};
};

TEST_F(SelfTestTest, StartDoesEveryTestOnce)
{
    Verifies(req::SRS_STS_060);
    // Given a sound device
    const StartReport report = device->Start();
    // Then each test passed, and the interval needed is a round of 36 cycles and 3 of the longest signature
    EXPECT_EQ(report.answer, StartAnswer::kPassed);
    EXPECT_EQ(report.first_failed, TestId::kNone);
    EXPECT_EQ(report.cycles, 39U);
    for (const TestState state : report.states)
    {
        EXPECT_EQ(state, TestState::kPassed);
    }
    EXPECT_EQ(device->self_test.FirstFailed(), TestId::kNone);
    EXPECT_EQ(device->lock.locks, 22U);
}

TEST_F(SelfTestTest, NeverStartedReportsAFaultAndNoSoundParts)
{
    Verifies(req::SRS_STS_212);
    for (std::uint32_t cycle = 0U; cycle < (3U * kRound); ++cycle)
    {
        const SelfTestOutcome outcome = device->self_test.OnCycle();
        EXPECT_EQ(outcome.fault, DeviceFault::kSelfTest) << cycle;
        EXPECT_EQ(outcome.parts, PartsView::kInvalid) << cycle;
        EXPECT_EQ(device->self_test.FirstFailed(), TestId::kInvalid) << cycle;
    }
}

TEST_F(SelfTestTest, SetupThatCannotBeUsedIsRefusedByName)
{
    Verifies(req::SRS_STS_210);
    struct Case
    {
        TestId test;
        std::function<void(SelfTestSetup&)> spoil;
    };
    const Case cases[] = {
        {TestId::kParts, [](SelfTestSetup& setup) { setup.parts.count = 0U; }},
        {TestId::kStack, [](SelfTestSetup& setup) { setup.stack.guard_words = 0U; }},
        {TestId::kProgram, [](SelfTestSetup& setup) { setup.program.slice_words = 0U; }},
        {TestId::kConstants, [](SelfTestSetup& setup) { setup.constants.memory.count = 0U; }},
        {TestId::kRam, [](SelfTestSetup& setup) { setup.ram.workspace = nullptr; }},
    };
    const SelfTestSetup good = device->setup;
    for (const Case& one : cases)
    {
        device->setup = good;
        one.spoil(device->setup);
        const StartReport report = device->Start();
        EXPECT_EQ(report.answer, StartAnswer::kUnusable);
        EXPECT_EQ(report.first_failed, one.test);
        EXPECT_EQ(report.states[static_cast<std::size_t>(one.test) - 1U], TestState::kUnusable);
        EXPECT_EQ(device->self_test.OnCycle().fault, DeviceFault::kSelfTest);
    }
    EXPECT_EQ(device->lock.locks, 0U);
}

TEST_F(SelfTestTest, SlicesThatDoNotFitIntoTheIntervalAreRefused)
{
    Verifies(req::SRS_STS_211);
    device->setup.interval_cycles = 38U;
    const StartReport report = device->Start();
    EXPECT_EQ(report.answer, StartAnswer::kInterval);
    EXPECT_EQ(report.first_failed, TestId::kSchedule);
    EXPECT_EQ(report.cycles, 39U);
    EXPECT_EQ(device->self_test.OnCycle().fault, DeviceFault::kSelfTest);
    // Given that the constants take longer than the program: 8 slices, then 43 + 8 are needed
    device->setup.constants.slice_words = 1U;
    EXPECT_EQ(device->Start().cycles, 51U);
}

TEST_F(SelfTestTest, DefectAtTheStartIsRefusedByName)
{
    Verifies(req::SRS_STS_210);
    const auto start = [this](const TestId test)
    {
        const StartReport report = device->Start();
        EXPECT_EQ(report.answer, StartAnswer::kFailed);
        EXPECT_EQ(report.first_failed, test);
        EXPECT_EQ(report.states[static_cast<std::size_t>(test) - 1U], TestState::kFailed);
        EXPECT_EQ(device->self_test.FirstFailed(), test);
        EXPECT_EQ(device->self_test.OnCycle().fault, DeviceFault::kSelfTest);
    };
    device->output.defective = true;
    start(TestId::kPermits);
    device->memory.Break(StuckAt(device->Place(&device->ram[40])));
    start(TestId::kRam);
    // The gate is as defective as before: that was found too
    EXPECT_EQ(device->Start().states[5], TestState::kFailed);
    device->memory.Break(host::Defect{});
    device->setup.constants.source = SignatureSource::kInvalid;
    start(TestId::kConstants);
    device->setup.program.source = SignatureSource::kGiven;
    start(TestId::kProgram);
    device->memory.Break(StuckAt(device->Place(&device->stack[3])));
    device->memory.Break({host::CellDefect::kStuckAtZero,
                          {device->Place(&device->stack[3]), 0U},
                          {device->Place(&device->stack[3]), 0U}});
    start(TestId::kStack);
}

TEST_F(SelfTestTest, PartThatCannotBeReadTwiceAlikeFailsAtTheStart)
{
    Verifies(req::SRS_STS_210);
    // Given a part whose first word lies in the stack area, which the start fills
    device->parts[1] = device->Place(&device->stack[0]);
    const StartReport report = device->Start();
    EXPECT_EQ(report.first_failed, TestId::kParts);
    EXPECT_EQ(report.states[0], TestState::kFailed);
}

TEST_F(SelfTestTest, OneSliceACycleForEver)
{
    Verifies(req::SRS_STS_061);
    Verifies(req::SRS_STS_062);
    ASSERT_EQ(device->Start().answer, StartAnswer::kPassed);
    for (std::uint32_t cycle = 1U; cycle <= (5U * kRound); ++cycle)
    {
        const std::uint32_t locks = device->lock.locks;
        const SelfTestOutcome outcome = device->self_test.OnCycle();
        // Then all is well, progress is the number of the cycle, and slices 5 to 26 of a round are those of the RAM
        EXPECT_EQ(outcome.fault, DeviceFault::kNone) << cycle;
        EXPECT_EQ(outcome.parts, PartsView::kSound);
        EXPECT_EQ(outcome.progress, cycle);
        const std::uint32_t slice = (cycle - 1U) % kRound;
        EXPECT_EQ(device->lock.locks - locks, ((slice >= 4U) && (slice < 26U)) ? 1U : 0U) << cycle;
    }
}

TEST_F(SelfTestTest, EachFaultIsFoundWithinTheIntervalWheneverItComes)
{
    Verifies(req::SRS_STS_060);
    Verifies(req::SRS_STS_061);
    struct Case
    {
        TestId test;
        std::function<void(Device&)> harm;
    };
    const Case cases[] = {
        {TestId::kProgram, [](Device& victim) { victim.program[0] ^= 0x0000'0400U; }},
        {TestId::kProgram, [](Device& victim) { victim.program[39] ^= 0x8000'0000U; }},
        {TestId::kConstants, [](Device& victim) { victim.constants[7] ^= 1U; }},
        {TestId::kRam, [](Device& victim) { victim.memory.Break(StuckAt(victim.Place(&victim.ram[0]))); }},
        {TestId::kRam, [](Device& victim) { victim.memory.Break(StuckAt(victim.Place(&victim.ram[63]))); }},
        {TestId::kPermits, [](Device& victim) { victim.output.defective = true; }},
    };
    for (const Case& one : cases)
    {
        for (std::uint32_t before = 0U; before < kRound; ++before)
        {
            // Given a device that has run for some cycles of a round
            device = NewDevice();
            ASSERT_EQ(device->Start().answer, StartAnswer::kPassed);
            for (std::uint32_t cycle = 0U; cycle < before; ++cycle)
            {
                ASSERT_EQ(device->self_test.OnCycle().fault, DeviceFault::kNone);
            }
            // When the fault comes, then it is found within the interval, by the right test, for good
            one.harm(*device);
            EXPECT_LE(CyclesToFault(), 39U) << static_cast<int>(one.test) << " " << before;
            EXPECT_EQ(device->self_test.FirstFailed(), one.test);
            EXPECT_EQ(device->self_test.OnCycle().fault, DeviceFault::kSelfTest);
        }
    }
}

TEST_F(SelfTestTest, ChangedStackGuardIsFoundInTheSameCycle)
{
    Verifies(req::SRS_STS_020);
    Verifies(req::SRS_STS_061);
    ASSERT_EQ(device->Start().answer, StartAnswer::kPassed);
    EXPECT_EQ(device->self_test.StackHighWaterBytes(), 0U);
    Flip(device->stack[10]); // Six words from the near end.
    EXPECT_EQ(device->self_test.StackHighWaterBytes(), 24U);
    Flip(device->stack[2]);
    const SelfTestOutcome outcome = device->self_test.OnCycle();
    EXPECT_EQ(outcome.fault, DeviceFault::kSelfTest);
    EXPECT_EQ(outcome.parts, PartsView::kSound);
    EXPECT_EQ(device->self_test.FirstFailed(), TestId::kStack);
    // It stays the first when more fails, and after it is whole again
    device->output.defective = true;
    Flip(device->stack[2]);
    EXPECT_EQ(CyclesToFault(), 1U);
    for (std::uint32_t cycle = 0U; cycle < kRound; ++cycle)
    {
        EXPECT_EQ(device->self_test.OnCycle().fault, DeviceFault::kSelfTest);
    }
    EXPECT_EQ(device->self_test.FirstFailed(), TestId::kStack);
    // Only a start-up test leads out
    device->output.defective = false;
    EXPECT_EQ(device->Start().answer, StartAnswer::kPassed);
    EXPECT_EQ(device->self_test.OnCycle().fault, DeviceFault::kNone);
}

TEST_F(SelfTestTest, ChangedPartEndsTheCycleBeforeAnySlice)
{
    Verifies(req::SRS_STS_040);
    ASSERT_EQ(device->Start().answer, StartAnswer::kPassed);
    const hal::Address part = device->parts[1];
    const std::uint32_t word = device->cells.Read(part);
    device->cells.Write(part, word ^ 8U);
    for (std::uint32_t cycle = 0U; cycle < kRound; ++cycle)
    {
        const SelfTestOutcome outcome = device->self_test.OnCycle();
        EXPECT_EQ(outcome.fault, DeviceFault::kSelfTest);
        EXPECT_EQ(outcome.parts, PartsView::kInvalid);
    }
    EXPECT_EQ(device->lock.locks, 22U);
    EXPECT_EQ(device->self_test.FirstFailed(), TestId::kParts);
    // Then the progress is that of 37 checks of the parts alone, each of which weighs 10001h
    EXPECT_EQ(device->self_test.OnCycle().progress, (kRound + 1U) * 0x10001U);
    device->cells.Write(part, word);
    // When it is back, the progress still tells what was left out
    EXPECT_NE(device->self_test.OnCycle().progress, kRound + 2U);
}

TEST_F(SelfTestTest, RoundThatIsTooLongOrTooShortFails)
{
    Verifies(req::SRS_STS_061);
    // Given a running round
    ASSERT_EQ(device->Start().answer, StartAnswer::kPassed);
    // When the RAM's span shrinks behind the test's back, then the round ends too early
    device->ram_span.words = 40U;
    EXPECT_LE(CyclesToFault(), kRound - 1U);
    EXPECT_EQ(device->self_test.FirstFailed(), TestId::kSchedule);
    // When it grows, then the round is overdue
    ASSERT_EQ(device->Start().answer, StartAnswer::kPassed);
    device->ram_span.words = 64U;
    EXPECT_LE(CyclesToFault(), kRound - 1U);
    EXPECT_EQ(device->self_test.FirstFailed(), TestId::kSchedule);
    // When a span of the constants is gone, then their signature has no position
    ASSERT_EQ(device->Start().answer, StartAnswer::kPassed);
    device->constants_span.words = 0U;
    EXPECT_LE(CyclesToFault(), 39U);
    EXPECT_EQ(device->self_test.FirstFailed(), TestId::kConstants);
}

TEST_F(SelfTestTest, FlippedByteOfItsOwnStateNeverHidesForLongerThanARound)
{
    Verifies(req::SRS_STS_061);
    Verifies(req::SRS_STS_062);
    // Given the number of the test whose turn it is, at the end of the object
    ASSERT_EQ(device->Start().answer, StartAnswer::kPassed);
    std::uint32_t progress = device->self_test.OnCycle().progress;
    EXPECT_EQ(progress, 1U);
    auto* const bytes = reinterpret_cast<std::uint8_t*>(&device->self_test);
    std::uint32_t found = 0U;
    // The round counters, the test at turn and the first failed one stand behind the permits' state
    constexpr std::size_t kTail = 12U;
    for (std::size_t byte = sizeof(SelfTest) - kTail; byte < sizeof(SelfTest); ++byte)
    {
        for (std::uint32_t bit = 0U; bit < 8U; ++bit)
        {
            ASSERT_EQ(device->Start().answer, StartAnswer::kPassed);
            static_cast<void>(device->self_test.OnCycle());
            const std::uint8_t flip = static_cast<std::uint8_t>(1U << bit);
            const std::uint8_t before = bytes[byte];
            bytes[byte] = static_cast<std::uint8_t>(before ^ flip);
            // Then it is found, by a fault or by the progress, or it was padding
            bool is_found = false;
            for (std::uint32_t cycle = 2U; cycle <= 80U; ++cycle)
            {
                const SelfTestOutcome outcome = device->self_test.OnCycle();
                is_found = is_found || (outcome.fault != DeviceFault::kNone) || (outcome.progress != cycle);
            }
            found += is_found ? 1U : 0U;
        }
    }
    EXPECT_EQ(found, 80U);
}

TEST_F(SelfTestTest, FlippedBitOfEachCounterIsFoundByTheProgress)
{
    Verifies(req::SRS_STS_062);
    // Given the words of the object that count one further in a cycle: parts, stack, program, round
    ASSERT_EQ(device->Start().answer, StartAnswer::kPassed);
    static_cast<void>(device->self_test.OnCycle());
    const hal::Address first = device->Place(&device->self_test);
    std::array<std::uint32_t, sizeof(SelfTest) / 4U> before{};
    for (std::size_t word = 0U; word < before.size(); ++word)
    {
        before[word] = device->cells.Read(first + (4U * word));
    }
    static_cast<void>(device->self_test.OnCycle());
    std::vector<hal::Address> places;
    for (std::size_t word = 0U; word < before.size(); ++word)
    {
        const hal::Address place = first + (4U * word);
        if (device->cells.Read(place) == (before[word] + 1U))
        {
            places.push_back(place);
        }
    }
    EXPECT_EQ(places.size(), 4U);
    for (const hal::Address place : places)
    {
        for (std::uint32_t bit = 0U; bit < 32U; ++bit)
        {
            ASSERT_EQ(device->Start().answer, StartAnswer::kPassed);
            device->cells.Write(place, device->cells.Read(place) ^ (std::uint32_t{1U} << bit));
            bool is_found = false;
            for (std::uint32_t cycle = 1U; cycle <= 39U; ++cycle)
            {
                const SelfTestOutcome outcome = device->self_test.OnCycle();
                is_found = is_found || (outcome.fault != DeviceFault::kNone) || (outcome.progress != cycle);
            }
            EXPECT_TRUE(is_found) << "place " << (place - first) << " bit " << bit;
        }
    }
}

// Each of two that fail in one cycle: parts come before the stack guard, and that before the slice.
TEST_F(SelfTestTest, PartsThenStackGuardThenOneSlice)
{
    Verifies(req::SRS_STS_061);
    ASSERT_EQ(device->Start().answer, StartAnswer::kPassed);
    const hal::Address part = device->parts[1];
    const std::uint32_t word = device->cells.Read(part);
    device->cells.Write(part, word ^ 8U);
    Flip(device->stack[2]);
    static_cast<void>(device->self_test.OnCycle());
    EXPECT_EQ(device->self_test.FirstFailed(), TestId::kParts);
    // Given that the next slice is the first one of the RAM
    device->cells.Write(part, word);
    ASSERT_EQ(device->Start().answer, StartAnswer::kPassed);
    for (std::uint32_t cycle = 0U; cycle < 4U; ++cycle)
    {
        ASSERT_EQ(device->self_test.OnCycle().fault, DeviceFault::kNone);
    }
    Flip(device->stack[2]);
    device->memory.Break(StuckAt(device->Place(&device->ram[0])));
    static_cast<void>(device->self_test.OnCycle());
    EXPECT_EQ(device->self_test.FirstFailed(), TestId::kStack);
}

} // namespace
} // namespace counterpoint::selftest
