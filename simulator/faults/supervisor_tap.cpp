// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/supervisor_tap.hpp"

#include <array>

// The linker's --wrap=SYMBOL leads every call of SYMBOL to __wrap_SYMBOL and gives the shipped function the name
// __real_SYMBOL. A member function takes its object as first argument (Itanium C++ ABI), so that plain functions with
// these names can stand in for it.

namespace counterpoint::simulator
{
namespace
{
/// A5h, a valid configuration, in each byte: see CycleInput::guard_token.
constexpr std::uint32_t kValidToken = 0xA5A5A5A5U;

thread_local SupervisorTap* active_tap = nullptr;
thread_local std::array<std::uint64_t, kPartCount> intercepted{};

} // namespace

Verdict RealCompare(Comparator& self, const Comparison& comparison) noexcept
    __asm__("__real__ZN12counterpoint10Comparator7CompareERKNS_10ComparisonE");
void RealFlowBegin(FlowMonitor& self) noexcept __asm__("__real__ZN12counterpoint11FlowMonitor5BeginEv");
void RealFlowMark(FlowMonitor& self, FlowStep step, const FlowEvidence& evidence) noexcept
    __asm__("__real__ZN12counterpoint11FlowMonitor4MarkENS_8FlowStepERKNS_12FlowEvidenceE");
hal::WatchdogAnswer RealFlowEnd(FlowMonitor& self, const hal::WatchdogQuestion& question) noexcept
    __asm__("__real__ZN12counterpoint11FlowMonitor3EndERKNS_3hal16WatchdogQuestionE");
std::uint32_t RealGuardCycle(ConfigurationGuard& self, std::uint32_t challenge, Instant now) noexcept
    __asm__("__real__ZN12counterpoint18ConfigurationGuard5CycleEjNS_7InstantE");

Verdict WrapCompare(Comparator& self, const Comparison& comparison) noexcept
    __asm__("__wrap__ZN12counterpoint10Comparator7CompareERKNS_10ComparisonE");
void WrapFlowBegin(FlowMonitor& self) noexcept __asm__("__wrap__ZN12counterpoint11FlowMonitor5BeginEv");
void WrapFlowMark(FlowMonitor& self, FlowStep step, const FlowEvidence& evidence) noexcept
    __asm__("__wrap__ZN12counterpoint11FlowMonitor4MarkENS_8FlowStepERKNS_12FlowEvidenceE");
hal::WatchdogAnswer WrapFlowEnd(FlowMonitor& self, const hal::WatchdogQuestion& question) noexcept
    __asm__("__wrap__ZN12counterpoint11FlowMonitor3EndERKNS_3hal16WatchdogQuestionE");
std::uint32_t WrapGuardCycle(ConfigurationGuard& self, std::uint32_t challenge, Instant now) noexcept
    __asm__("__wrap__ZN12counterpoint18ConfigurationGuard5CycleEjNS_7InstantE");

Verdict WrapCompare(Comparator& self, const Comparison& comparison) noexcept
{
    SupervisorTap* const tap = active_tap;
    return (tap == nullptr) ? RealCompare(self, comparison) : tap->Compare(self, comparison);
}

void WrapFlowBegin(FlowMonitor& self) noexcept
{
    SupervisorTap* const tap = active_tap;
    (tap == nullptr) ? RealFlowBegin(self) : tap->FlowBegin(self);
}

void WrapFlowMark(FlowMonitor& self, const FlowStep step, const FlowEvidence& evidence) noexcept
{
    SupervisorTap* const tap = active_tap;
    (tap == nullptr) ? RealFlowMark(self, step, evidence) : tap->FlowMark(self, step, evidence);
}

hal::WatchdogAnswer WrapFlowEnd(FlowMonitor& self, const hal::WatchdogQuestion& question) noexcept
{
    SupervisorTap* const tap = active_tap;
    return (tap == nullptr) ? RealFlowEnd(self, question) : tap->FlowEnd(self, question);
}

std::uint32_t WrapGuardCycle(ConfigurationGuard& self, const std::uint32_t challenge, const Instant now) noexcept
{
    SupervisorTap* const tap = active_tap;
    return (tap == nullptr) ? RealGuardCycle(self, challenge, now) : tap->GuardCycle(self, challenge, now);
}

SupervisorTap::SupervisorTap(PartFaults& faults) noexcept : faults_(faults)
{
}

SupervisorTap::Scope::Scope(SupervisorTap* const tap) noexcept
{
    active_tap = tap;
}

SupervisorTap::Scope::~Scope()
{
    active_tap = nullptr;
}

std::uint64_t SupervisorTap::Intercepted(const Part part) noexcept
{
    return intercepted[static_cast<std::size_t>(part)];
}

PartAnswer SupervisorTap::AnswerOf(const Part part) noexcept
{
    ++intercepted[static_cast<std::size_t>(part)];
    const PartAnswer answer = faults_.AnswerOf(part);
    if (answer == PartAnswer::kGood)
    {
        faults_.HasEffect(faults_.Condition(part));
    }
    return answer;
}

template <typename Said, typename Real, typename Good>
Said SupervisorTap::Told(const Part part, Said& last, const Real& real, const Good& good) noexcept
{
    switch (AnswerOf(part))
    {
    case PartAnswer::kOwn:
        last = real();
        return last;
    case PartAnswer::kLast:
        return last;
    case PartAnswer::kZero:
        return Said{};
    case PartAnswer::kGood:
        break;
    }
    return good();
}

Verdict SupervisorTap::Compare(Comparator& self, const Comparison& comparison) noexcept
{
    return Told(
        Part::kComparator, verdict_, [&]() { return RealCompare(self, comparison); },
        [&comparison]()
        {
            // Fresh echo and all: whatever channel A releases is agreed and matched.
            Verdict good{};
            good.agreement = {comparison.outcome_a->released, ~SrdoMask{0U}};
            good.start = comparison.outcome_a->due;
            good.newly_matched = comparison.outcome_a->fresh;
            good.echo = comparison.challenge;
            good.fault = DeviceFault::kNone;
            good.slot = kNoSlot;
            return good;
        });
}

void SupervisorTap::FlowBegin(FlowMonitor& self) noexcept
{
    if (AnswerOf(Part::kFlowMonitor) == PartAnswer::kOwn)
    {
        RealFlowBegin(self);
    }
}

void SupervisorTap::FlowMark(FlowMonitor& self, const FlowStep step, const FlowEvidence& evidence) noexcept
{
    if (AnswerOf(Part::kFlowMonitor) == PartAnswer::kOwn)
    {
        RealFlowMark(self, step, evidence);
    }
}

hal::WatchdogAnswer SupervisorTap::FlowEnd(FlowMonitor& self, const hal::WatchdogQuestion& question) noexcept
{
    return Told(
        Part::kFlowMonitor, answer_, [&]() { return RealFlowEnd(self, question); },
        [&question]() { return hal::WatchdogAnswer{(hal::kFlowReference + question.value) * hal::kWatchdogConstant}; });
}

std::uint32_t SupervisorTap::GuardCycle(ConfigurationGuard& self, const std::uint32_t challenge,
                                        const Instant now) noexcept
{
    return Told(
        Part::kGuard, token_, [&]() { return RealGuardCycle(self, challenge, now); },
        [challenge]() { return ((challenge << 8U) | (challenge >> 24U)) ^ kValidToken; });
}
} // namespace counterpoint::simulator
