// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/selftest/self_test.hpp"

namespace counterpoint::selftest
{

namespace
{

/// Odd and far apart: parts of a cycle that are left out never cancel out each other.
constexpr std::uint32_t kPartsWeight = 0x00010001U;
constexpr std::uint32_t kStackWeight = 0x01000193U;

[[nodiscard]] constexpr std::uint32_t IndexOf(const TestId test) noexcept
{
    return static_cast<std::uint32_t>(test) - 1U;
}

[[nodiscard]] constexpr TestId Following(const TestId test) noexcept
{
    return (test == TestId::kPermits) ? TestId::kProgram : static_cast<TestId>(static_cast<std::uint8_t>(test) + 1U);
}

[[nodiscard]] constexpr std::uint32_t Greater(const std::uint32_t one, const std::uint32_t other) noexcept
{
    return (one > other) ? one : other;
}

[[nodiscard]] constexpr TestState StateOf(const bool is_usable) noexcept
{
    return is_usable ? TestState::kInvalid : TestState::kUnusable;
}

/// The first of the tests that is not in the state wanted of all.
[[nodiscard]] TestId FirstWithout(const StartReport& report, const TestState wanted) noexcept
{
    TestId first = TestId::kNone;
    for (std::uint8_t number = kTestCount; number != 0U; --number)
    {
        first = (report.states[number - 1U] == wanted) ? first : static_cast<TestId>(number);
    }
    return first;
}

} // namespace

SelfTest::SelfTest(const SelfTestPorts& ports) noexcept : ports_(ports)
{
}

void SelfTest::Restart(const SelfTestSetup& setup) noexcept
{
    current_ = TestId::kProgram;
    round_done_ = 0U;
    parts_.Restart(setup.parts, ports_.memory);
    stack_.Restart(setup.stack, ports_.memory);
    program_.Restart(setup.program);
    constants_.Restart(setup.constants);
    ram_.Restart(setup.ram);
    permits_.Restart();
}

StartReport SelfTest::CheckSetup(const SelfTestSetup& setup) noexcept
{
    const std::uint32_t program = program_.SlicesAPass();
    const std::uint32_t constants = constants_.SlicesAPass();
    const std::uint32_t ram = ram_.SlicesAPass(RamPorts{ports_.memory, ports_.lock});
    round_slices_ = program + constants + ram + PermitTest::kSlicesAPass;
    StartReport report{StartAnswer::kInvalid,
                       TestId::kNone,
                       {StateOf(parts_.IsUsable()), StateOf(stack_.IsUsable()), StateOf(program != 0U),
                        StateOf(constants != 0U), StateOf(ram != 0U), TestState::kInvalid},
                       round_slices_ + Greater(program, constants)};
    report.first_failed = FirstWithout(report, TestState::kInvalid);
    if (report.first_failed != TestId::kNone)
    {
        report.answer = StartAnswer::kUnusable;
    }
    else if (report.cycles > setup.interval_cycles)
    {
        report.answer = StartAnswer::kInterval;
        report.first_failed = TestId::kSchedule;
    }
    else
    {
        report.answer = StartAnswer::kPassed;
    }
    return report;
}

TestState SelfTest::RunOnce(const TestId test, const std::uint32_t slices) noexcept
{
    std::uint32_t sound = 0U;
    SliceResult result = SliceResult::kInvalid;
    for (std::uint32_t slice = 0U; slice < slices; ++slice)
    {
        result = Slice(test);
        sound += (result == SliceResult::kContinues) ? 1U : 0U;
    }
    // All but the last have a slice after them.
    const bool is_passed = (result == SliceResult::kPassed) && ((sound + 1U) == slices);
    return is_passed ? TestState::kPassed : TestState::kFailed;
}

StartReport SelfTest::Start(const SelfTestSetup& setup) noexcept
{
    Restart(setup);
    StartReport report = CheckSetup(setup);
    if (report.answer == StartAnswer::kPassed)
    {
        report.states[IndexOf(TestId::kParts)] = RunOnce(TestId::kParts, 1U);
        report.states[IndexOf(TestId::kStack)] = RunOnce(TestId::kStack, 1U);
        report.states[IndexOf(TestId::kProgram)] = RunOnce(TestId::kProgram, program_.SlicesAPass());
        report.states[IndexOf(TestId::kConstants)] = RunOnce(TestId::kConstants, constants_.SlicesAPass());
        report.states[IndexOf(TestId::kRam)] =
            RunOnce(TestId::kRam, ram_.SlicesAPass(RamPorts{ports_.memory, ports_.lock}));
        report.states[IndexOf(TestId::kPermits)] = RunOnce(TestId::kPermits, PermitTest::kSlicesAPass);
        report.first_failed = FirstWithout(report, TestState::kPassed);
        report.answer = (report.first_failed == TestId::kNone) ? StartAnswer::kPassed : StartAnswer::kFailed;
    }
    first_failed_ = report.first_failed;
    return report;
}

SliceResult SelfTest::Slice(const TestId test) noexcept
{
    if (test == TestId::kParts)
    {
        return parts_.Check(ports_.memory);
    }
    if (test == TestId::kStack)
    {
        return stack_.Check(ports_.memory);
    }
    if (test == TestId::kProgram)
    {
        return program_.Slice(ports_.memory);
    }
    if (test == TestId::kConstants)
    {
        return constants_.Slice(ports_.memory);
    }
    // What names no test ends no round in time.
    return (test == TestId::kRam) ? ram_.Slice(RamPorts{ports_.memory, ports_.lock}) : permits_.Slice(ports_.output);
}

void SelfTest::Note(const TestId test, const SliceResult result) noexcept
{
    const bool is_sound = (result == SliceResult::kContinues) || (result == SliceResult::kPassed);
    if (!is_sound && (first_failed_ == TestId::kNone))
    {
        first_failed_ = test;
    }
}

void SelfTest::DoSlice() noexcept
{
    const SliceResult result = Slice(current_);
    Note(current_, result);
    ++round_done_;
    bool is_round = false;
    if (result == SliceResult::kPassed)
    {
        current_ = Following(current_);
        is_round = current_ == TestId::kProgram;
    }
    const bool is_due = round_done_ >= round_slices_;
    Note(TestId::kSchedule, (is_round == is_due) ? SliceResult::kPassed : SliceResult::kFailed);
    round_done_ = is_round ? 0U : round_done_;
}

// The start-up test did one round and one check of parts and stack.
std::uint32_t SelfTest::Progress() const noexcept
{
    const std::uint32_t slices = (program_.Done() + constants_.Done() + ram_.Done() + permits_.Done()) - round_slices_;
    const std::uint32_t parts = parts_.Done() - 1U;
    const std::uint32_t stack = stack_.Done() - 1U;
    return slices + ((parts - slices) * kPartsWeight) + ((stack - slices) * kStackWeight);
}

SelfTestOutcome SelfTest::OnCycle() noexcept
{
    const SliceResult parts = Slice(TestId::kParts);
    Note(TestId::kParts, parts);
    if (parts != SliceResult::kPassed)
    {
        return SelfTestOutcome{Progress(), DeviceFault::kSelfTest, PartsView::kInvalid};
    }
    Note(TestId::kStack, Slice(TestId::kStack));
    DoSlice();
    const DeviceFault fault = (first_failed_ == TestId::kNone) ? DeviceFault::kNone : DeviceFault::kSelfTest;
    return SelfTestOutcome{Progress(), fault, PartsView::kSound};
}

} // namespace counterpoint::selftest
